"""How far a calculation is, told to whoever waits for it."""

from collections.abc import Callable
from threading import Lock
from typing import TypeAlias

Progress: TypeAlias = Callable[[str, int, int], None]
"""Is told what is under way, how much of it is behind, and how much there is; ends it by raising an error."""


def unwatched(work: str, done: int, total: int) -> None:
    """Nobody is told."""


class Count:
    """Counts what several threads have done of one piece of work."""

    def __init__(self, progress: Progress, work: str, total: int) -> None:
        """Begin to count up to ``total``."""
        self._progress, self._work, self._total = progress, work, total
        self._done = 0
        self._lock = Lock()

    def add(self, more: int) -> None:
        """Count more, and tell."""
        with self._lock:
            self._done += more
            self._progress(self._work, self._done, self._total)
