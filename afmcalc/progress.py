"""Progress of a calculation, which loops report and a bar on standard error shows.

The bar appears after one second; Ctrl-C ends the calculation.
"""

import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from functools import partial
from typing import Any, TypeVar

from .messages import within

T = TypeVar("T")
Watcher = Callable[[str, int, int], None]
"""Function that is told of progress: work, steps done, steps in all."""

PATIENCE = 1.0
"""Seconds before the bar appears."""
_WATCHER: ContextVar[Watcher | None] = ContextVar("watcher", default=None)


def tell(work: str, done: int, total: int) -> None:
    """Report ``done`` of ``total`` steps of ``work`` to the watcher, if there is one."""
    if watcher := _WATCHER.get():
        watcher(work, done, total)


watched = partial(within, _WATCHER)
"""Context in which progress is reported to a watcher."""
unwatched = partial(within, _WATCHER, None)
"""Context in which no progress is reported, as for one step of a larger calculation."""


def counted(work: str, parts: Sequence[T]) -> Iterator[T]:
    """Yield ``parts``; before each part report how many parts are done."""
    for done, part in enumerate(parts):
        tell(work, done, len(parts))
        yield part
    if parts:
        tell(work, len(parts), len(parts))


@contextmanager
def bar() -> Iterator[None]:
    """Show a progress bar with the time left, on standard error after ``PATIENCE`` seconds; remove it at the end."""
    begun, tasks, shown = time.monotonic(), dict[str, Any](), list[Any]()

    def show(work: str, done: int, total: int) -> None:
        if time.monotonic() - begun < PATIENCE:
            return
        if not shown:
            from rich.console import Console
            from rich.progress import Progress

            shown.append(Progress(console=Console(stderr=True), transient=True))
            shown[0].start()
        if work not in tasks:
            tasks[work] = shown[0].add_task(work)
        shown[0].update(tasks[work], completed=done, total=total)

    try:
        with watched(show):
            yield
    finally:
        for one in shown:
            one.stop()
