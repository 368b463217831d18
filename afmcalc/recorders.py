"""Recorders in the place of equations, and what is not for them: what a search tries is no step of a calculation."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import ModuleType
from typing import Any, NamedTuple

from .arrays import Values, is_array, larger


class Wrapped(NamedTuple):
    """An equation function in its module, and what records it."""

    module: ModuleType
    name: str
    function: Callable[..., Any]
    recorder: Callable[..., Any]


class Recorders(NamedTuple):
    """What records, and how it marks a number that no equation gives."""

    places: tuple[Wrapped, ...]
    mark: Callable[..., Any]
    """A number, and numbers that it is for the same friction, setting and side as → the number, marked."""


_RUNNING: list[Recorders | None] = []
"""Recorders that are in place, the innermost last; None while they are taken out."""


@contextmanager
def recorded_by(recorders: Recorders) -> Iterator[None]:
    """Put recorders in the place of the equations within the block."""
    with _switched(recorders, record=True):
        yield


@contextmanager
def unrecorded() -> Iterator[None]:
    """Take the recorders out within the block: equations that run there explain nothing."""
    if (running := _running()) is None:
        yield
        return
    with _switched(running, record=False):
        yield


@contextmanager
def _switched(recorders: Recorders, *, record: bool) -> Iterator[None]:
    _RUNNING.append(recorders if record else None)
    _put(recorders, record=record)
    try:
        yield
    finally:
        _RUNNING.pop()
        _put(recorders, record=not record)


def _running() -> Recorders | None:
    return _RUNNING[-1] if _RUNNING else None


def _put(recorders: Recorders, *, record: bool) -> None:
    for place in recorders.places:
        setattr(place.module, place.name, place.recorder if record else place.function)


def solved(search: Callable[[], Values], steps: Callable[[], Values]) -> Values:
    """Return what a search finds.

    Args:
        search: what finds it; what it tries is not recorded.
        steps: the equations that hold of it, the number put in: run where they are recorded; the last says what it is.
    """
    with unrecorded():
        value = search()
    running = _running()
    return value if running is None or _several(value) else running.mark(value, steps())


def _several(value: Values) -> bool:
    """Whether it is an array of numbers; an array may also be of one."""
    return is_array(value) and value.ndim > 0


def larger_of(first: Values, other: Callable[[], Values]) -> Values:
    """Elementwise maximum; where equations are recorded, those of ``other`` only if it is the larger."""
    if _running() is None:
        return larger(first, other())
    with unrecorded():
        tried = other()
    if is_array(first) or is_array(tried):
        return larger(first, tried)
    return other() if tried > first else first


def marked(value: Values, *like: Any) -> Values:
    """Say of a number that no equation gives what it is for, where equations are recorded: as numbers ``like`` it."""
    running = _running()
    return value if running is None or _several(value) else running.mark(value, *like)
