"""Note the calls of equations, so that ``explain`` can print them."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import wraps
from types import ModuleType, SimpleNamespace
from typing import Any, NamedTuple, ParamSpec, TypeVar

P = ParamSpec("P")
R = TypeVar("R")


class Call(NamedTuple):
    """One call of an equation: the function, what it was given, and what it returned."""

    function: Callable[..., Any]
    args: tuple[Any, ...]
    kwargs: dict[str, Any]
    value: Any


_CALLS: ContextVar[list[Call] | None] = ContextVar("calls", default=None)


def equation(function: Callable[P, R]) -> Callable[P, R]:
    """Mark a function as an equation; within ``noted`` its calls are noted, but not those it makes of others."""

    @wraps(function)
    def call(*args: P.args, **kwargs: P.kwargs) -> R:
        calls = _CALLS.get()
        if calls is None:
            return function(*args, **kwargs)
        with unnoted():
            value = function(*args, **kwargs)
        calls.append(Call(function, args, kwargs, value))
        return value

    return call


def plain(module: ModuleType) -> Any:
    """The equations of a module without a note of their calls, for the millions of calls of one integration."""
    functions = ((name, getattr(value, "__wrapped__", None)) for name, value in vars(module).items())
    return SimpleNamespace(**{name: function for name, function in functions if function is not None})


@contextmanager
def noted() -> Iterator[list[Call]]:
    """Note every call of an equation within the block."""
    calls: list[Call] = []
    token = _CALLS.set(calls)
    try:
        yield calls
    finally:
        _CALLS.reset(token)


@contextmanager
def unnoted() -> Iterator[None]:
    """Note no calls within the block."""
    token = _CALLS.set(None)
    try:
        yield
    finally:
        _CALLS.reset(token)
