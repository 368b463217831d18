"""Note the calls of equations, so that ``explain`` can print them.

A value is known again by its identity: the object that one equation returned and another is given is one number.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import cached_property, wraps
from typing import Any, NamedTuple, ParamSpec, TypeVar

P = ParamSpec("P")
R = TypeVar("R")


class Note(NamedTuple):
    """One number: the equation that gave it, or None, what it was given, and the number."""

    function: Callable[..., Any] | None
    args: tuple[Any, ...]
    kwargs: dict[str, Any]
    value: Any
    role: str = ""


_NOTES: ContextVar[list[Note] | None] = ContextVar("notes", default=None)
_UNNOTED: list[Note] = []
"""In place of the notes within ``unnoted``; stays empty."""


def equation(function: Callable[P, R]) -> Callable[P, R]:
    """Mark a function as an equation; within ``noted`` its calls are noted, but not those it makes of others."""

    @wraps(function)
    def call(*args: P.args, **kwargs: P.kwargs) -> R:
        notes = _NOTES.get()
        if notes is None or notes is _UNNOTED:
            return function(*args, **kwargs)
        with unnoted():
            value = function(*args, **kwargs)
        notes.append(Note(call, args, kwargs, value))
        return value

    return call


def derived(value: Any, *of: object, role: str = "", steps: Callable[[Any], object] | None = None) -> Any:
    """Return a number that no equation gives; where calls are noted, say what it is for.

    Args:
        value: a number, or an array, of which nothing is noted.
        of: numbers that it was calculated from: it is for the same friction, setting and side.
        role: what it stands for: an end of a range of friction (``f_1min``), how a spring is set (``min-friction``),
            or the parameter that it is proportional to (``∂ln C``).
        steps: runs the equations that hold of it, the number put in; called only where calls are noted.
    """
    notes = _NOTES.get()
    if notes is None or notes is _UNNOTED or getattr(value, "ndim", False):
        return value
    own = float(value) * 1.0  # an object of its own: a number may stand for two things
    notes.append(Note(None, of, {}, own, role))
    if steps is not None:
        steps(own)
    return own


@contextmanager
def noted() -> Iterator[list[Note]]:
    """Note every call of an equation within the block; other threads do not meet it."""
    notes: list[Note] = []
    token = _NOTES.set(notes)
    try:
        yield notes
    finally:
        _NOTES.reset(token)


@contextmanager
def unnoted() -> Iterator[None]:
    """Note nothing within the block: what a search tries is no step of a calculation."""
    token = _NOTES.set(None if _NOTES.get() is None else _UNNOTED)
    try:
        yield
    finally:
        _NOTES.reset(token)


class once(cached_property[R]):  # noqa: N801
    """A property that is calculated once; not kept within ``unnoted``, as an explanation would miss its equations."""

    def __get__(self, instance: object, owner: Any = None) -> Any:
        """Return the value kept, or calculate it."""
        return self.func(instance) if _NOTES.get() is _UNNOTED else super().__get__(instance, owner)
