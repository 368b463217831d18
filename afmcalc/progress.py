"""Progress of a calculation: any loop may tell it, and a bar on standard error shows it to whoever waits.

The bar appears where something takes longer than a second; Ctrl-C ends it.
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
"""Watcher of the calculation under way."""


def tell(work: str, done: int, total: int) -> None:
    """Tell how much of a piece of work is behind, of how much."""
    if watcher := WATCHER.get():
        watcher.advance(work, done, total)


@contextmanager
def unwatched() -> Iterator[None]:
    """Tell nothing in the block: it is a part of a work that is counted as a whole."""
    token = WATCHER.set(None)
    try:
        yield
    finally:
        WATCHER.reset(token)


def counted(work: str, parts: Sequence[T]) -> Iterator[T]:
    """Go through the parts of a piece of work, and tell how many are behind."""
    for done, part in enumerate(parts):
        tell(work, done, len(parts))
        yield part
    if parts:
        tell(work, len(parts), len(parts))


class Bar:
    """Progress with the time left, on a terminal, after the first second; leaves the line clean when it ends."""

    def __init__(self) -> None:
        """Begin to wait."""
        self._begun = time.monotonic()
        self._shown: Any = None
        self._tasks: dict[str, Any] = {}

    def advance(self, work: str, done: int, total: int) -> None:
        """Show how much of a piece of work is done."""
        if time.monotonic() - self._begun < PATIENCE:
            return
        if self._shown is None:
            from rich.console import Console
            from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeRemainingColumn

            columns = TextColumn("{task.description}"), BarColumn(), TaskProgressColumn(), TimeRemainingColumn()
            self._shown = Progress(*columns, console=Console(stderr=True), transient=True)
            self._shown.start()
        if work not in self._tasks:
            self._tasks[work] = self._shown.add_task(work)
        self._shown.update(self._tasks[work], completed=done, total=total)

    def __enter__(self) -> "Bar":
        """Start."""
        self._token = WATCHER.set(self)
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        """Take the bar away, whatever ended the work."""
        WATCHER.reset(self._token)
        if self._shown is not None:
            self._shown.stop()
