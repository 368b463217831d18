"""How far a calculation is: any loop may tell, and a bar on standard error shows it to whoever waits.

The bar appears where something takes longer than a second; what takes longer than a minute is refused.
"""

import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from types import TracebackType
from typing import Any, TypeVar

from .errors import AfmcalcError
from .messages import say, say_many

T = TypeVar("T")

PATIENCE = 1.0
"""Seconds before the bar appears, and before it is known how long the whole takes."""
LONG = 60.0
"""Seconds beyond which somebody has to agree."""
_EACH = 0.1
"""Seconds between two looks of the bar."""


WATCHER: "ContextVar[Bar | None]" = ContextVar("watcher", default=None)
"""Watcher of the calculation under way; it ends the calculation by raising an error."""


def tell(work: str, done: int, total: int) -> None:
    """Tell how much of a piece of work is behind, of how much."""
    if watcher := WATCHER.get():
        watcher.advance(work, done, total)


def pulse() -> None:
    """Tell that the part under way goes on."""
    if watcher := WATCHER.get():
        watcher.pulse()


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
    """Shows nothing in a pipe, when quiet, or within the first second; leaves the line clean when it ends."""

    def __init__(self, *, quiet: bool = False, agreed: bool = False) -> None:
        """Begin to wait; ``agreed`` to whatever time it takes."""
        self.started = self._shown = time.monotonic()
        self._agreed = agreed
        self._wanted = not quiet and sys.stderr.isatty()
        self._bar: Any = None
        self._tasks: dict[str, Any] = {}
        self._work, self._begun, self._before, self._last = "", 0.0, 0, (0, 0)

    def advance(self, work: str, done: int, total: int) -> None:
        """Note how much of a piece of work is behind.

        Raises AfmcalcError: the whole takes longer than somebody agreed to.
        """
        now = time.monotonic()
        if work != self._work or done < self._last[0]:
            # the pace is taken from here on: what came first also had to be imported and laid out
            self._work, self._begun, self._before = work, now, done
        self._last = done, total
        self._note(now, done)

    def pulse(self) -> None:
        """Note that the part under way goes on; the others are taken to last as long as it does at least.

        Raises AfmcalcError: the whole takes longer than somebody agreed to.
        """
        done, total = self._last
        if done < total:
            self._note(time.monotonic(), done + 1)

    def _note(self, now: float, paced: int) -> None:
        """Refuse by the pace so far, or show; ``paced`` is how much the time until now was for."""
        done, total = self._last
        spent, behind, gone = now - self._begun, paced - self._before, now - self.started
        if gone < PATIENCE:
            return
        if not self._agreed and behind and spent >= PATIENCE / 2:
            left = spent * (total - paced) / behind
            if gone + left > LONG and left > gone:  # else it is too late to refuse
                raise AfmcalcError(
                    "this takes about {time}: --yes goes on with it, or ask for less", time=_in_words(left)
                )
        if not self._wanted or (now - self._shown <= _EACH and done < total):
            return
        self._shown = now
        if self._bar is None:
            from rich.console import Console
            from rich.progress import Progress

            self._bar = Progress(console=Console(stderr=True), transient=True, auto_refresh=False)
            self._bar.start()
        if self._work not in self._tasks:
            self._tasks[self._work] = self._bar.add_task(self._work)
        self._bar.update(self._tasks[self._work], completed=done, total=total)
        self._bar.refresh()

    def __enter__(self) -> "Bar":
        """Start."""
        self._token = WATCHER.set(self)
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        """Take the bar away, whatever ended the work."""
        WATCHER.reset(self._token)
        if self._bar is not None:
            self._bar.stop()


def _in_words(seconds: float) -> str:
    """A time as people say it.

    >>> _in_words(90), _in_words(10_000), _in_words(1e6)
    ('2 min', '3 h', '12 days')
    """
    if seconds < 5400:
        return say("{count:.0f} min", count=seconds / 60)
    if seconds < 172800:
        return say("{count:.0f} h", count=seconds / 3600)
    return say_many("{count} day", "{count} days", count=round(seconds / 86400))
