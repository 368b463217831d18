"""A progress bar on standard error, for what takes longer than a second in front of a person."""

import sys
import time
from types import TracebackType
from typing import Any

PATIENCE = 1.0
"""Seconds before the bar appears."""


class Progress:
    """Shows nothing in a pipe, when quiet, or within the first second; leaves the line clean when it ends."""

    def __init__(self, *, quiet: bool = False) -> None:
        """Begin to wait."""
        self.started = time.monotonic()
        self.wanted = not quiet and sys.stderr.isatty()
        self._bar: Any = None
        self._tasks: dict[str, Any] = {}

    def advance(self, work: str, done: int, total: int) -> None:
        """Note how much of a piece of work is behind."""
        if not self.wanted or (self._bar is None and time.monotonic() - self.started < PATIENCE):
            return
        if self._bar is None:
            from rich.console import Console
            from rich.progress import Progress as Bar

            self._bar = Bar(console=Console(stderr=True), transient=True)
            self._bar.start()
        if work not in self._tasks:
            self._tasks[work] = self._bar.add_task(work)
        self._bar.update(self._tasks[work], completed=done, total=total)

    def __enter__(self) -> "Progress":
        """Start."""
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        """Take the bar away, whatever ended the work."""
        if self._bar is not None:
            self._bar.stop()
