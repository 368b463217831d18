"""How far a calculation is, told to whoever waits for it: any loop may tell, and nobody need be there."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from threading import Lock
from typing import Protocol, TypeVar

T = TypeVar("T")


class Watcher(Protocol):
    """Whoever waits; ends the calculation by raising an error."""

    def advance(self, work: str, done: int, total: int) -> None:
        """Take note of what is under way, how much of it is behind, and how much there is."""

    def pulse(self) -> None:
        """Take note that it goes on, inside a part that cannot tell how long it takes."""


_watcher: ContextVar[Watcher | None] = ContextVar("watcher", default=None)


@contextmanager
def watched_by(watcher: Watcher) -> Iterator[None]:
    """Tell ``watcher`` what is calculated in the block."""
    before = _watcher.set(watcher)
    try:
        yield
    finally:
        _watcher.reset(before)


def tell(work: str, done: int, total: int) -> None:
    """Tell how much of a piece of work is behind, of how much."""
    if watcher := _watcher.get():
        watcher.advance(work, done, total)


def pulse() -> None:
    """Tell that the part under way goes on."""
    if watcher := _watcher.get():
        watcher.pulse()


def counted(work: str, parts: Sequence[T]) -> Iterator[T]:
    """Go through the parts of a piece of work, and tell how many are behind."""
    for done, part in enumerate(parts):
        tell(work, done, len(parts))
        yield part
    if parts:
        tell(work, len(parts), len(parts))


class Count:
    """Counts what several threads have done of one piece of work."""

    def __init__(self, work: str, total: int) -> None:
        """Begin to count up to ``total``; whoever waits for this thread is told by the others too."""
        self._watcher, self._work, self._total = _watcher.get(), work, total
        self._done = 0
        self._lock = Lock()

    def add(self, more: int) -> None:
        """Count more, and tell."""
        with self._lock:
            self._done += more
            if self._watcher:
                self._watcher.advance(self._work, self._done, self._total)
