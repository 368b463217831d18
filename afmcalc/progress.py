"""Progress of a calculation, which loops report and a bar on standard error shows.

The bar appears after one second; Ctrl-C ends the calculation.
"""

import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from types import TracebackType
from typing import Any, TypeVar

T = TypeVar("T")

PATIENCE = 1.0
"""Seconds before the bar appears."""
WATCHER: "ContextVar[Bar | None]" = ContextVar("watcher", default=None)
"""Bar that shows the running calculation; None: progress is not shown."""


def tell(work: str, done: int, total: int) -> None:
    """Report ``done`` of ``total`` steps of ``work`` to the watcher, if there is one."""
    if watcher := WATCHER.get():
        watcher.advance(work, done, total)


@contextmanager
def unwatched() -> Iterator[None]:
    """Report no progress inside the ``with`` block, which is one step of a larger calculation."""
    token = WATCHER.set(None)
    try:
        yield
    finally:
        WATCHER.reset(token)


def counted(work: str, parts: Sequence[T]) -> Iterator[T]:
    """Yield ``parts``; before each part report how many parts are done."""
    for done, part in enumerate(parts):
        tell(work, done, len(parts))
        yield part
    if parts:
        tell(work, len(parts), len(parts))


class Bar:
    """Progress bar with the time left, on standard error after ``PATIENCE`` seconds; removed at the end."""

    def __init__(self) -> None:
        """Start the clock."""
        self._begun = time.monotonic()
        self._shown: Any = None
        self._tasks: dict[str, Any] = {}

    def advance(self, work: str, done: int, total: int) -> None:
        """Show ``done`` of ``total`` steps of ``work``."""
        if time.monotonic() - self._begun < PATIENCE:
            return
        if self._shown is None:
            from rich.console import Console
            from rich.progress import Progress

            self._shown = Progress(console=Console(stderr=True), transient=True)
            self._shown.start()
        if work not in self._tasks:
            self._tasks[work] = self._shown.add_task(work)
        self._shown.update(self._tasks[work], completed=done, total=total)

    def __enter__(self) -> "Bar":
        """Become the watcher."""
        self._token = WATCHER.set(self)
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        """Remove the bar, even after an error."""
        WATCHER.reset(self._token)
        if self._shown is not None:
            self._shown.stop()
