"""A progress bar on standard error, for what takes longer than a second in front of a person."""

import sys
import time
from types import TracebackType
from typing import Any

PATIENCE = 1.0
"""Seconds before the bar appears."""


class Progress:
    """Shows nothing in a pipe, when quiet, or within the first second; leaves the line clean when it ends."""

    def __init__(self, total: int, *, quiet: bool = False) -> None:
        """Prepare for ``total`` steps."""
        self.total, self.started = total, time.monotonic()
        self.wanted = not quiet and sys.stderr.isatty()
        self._bar: Any = None
        self._task: Any = None

    def advance(self, done: int) -> None:
        """Note how many steps are behind."""
        if not self.wanted or (self._bar is None and time.monotonic() - self.started < PATIENCE):
            return
        if self._bar is None:
            from rich.console import Console
            from rich.progress import Progress as Bar

            self._bar = Bar(console=Console(stderr=True), transient=True)
            self._bar.start()
            self._task = self._bar.add_task("searching", total=self.total)
        self._bar.update(self._task, completed=done)

    def __enter__(self) -> "Progress":
        """Start."""
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        """Take the bar away, whatever ended the work."""
        if self._bar is not None:
            self._bar.stop()
