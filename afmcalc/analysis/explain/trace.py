"""Recording which equations a calculation ran, with what arguments: an explanation cannot drift from the code."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import wraps
from importlib import import_module
from inspect import signature
from typing import Any, NamedTuple

from ...equations.catalogue import Equation, equations


class Call(NamedTuple):
    """One call of an equation function."""

    equation: Equation
    arguments: dict[str, Any]
    value: Any


@contextmanager
def recording() -> Iterator[list[Call]]:
    """Record every outermost call of an equation function made within the block.

    The functions of the equation modules are wrapped while the block runs; calls that one equation makes of
    another belong to it and are not listed.
    """
    calls: list[Call] = []
    depth = [0]
    wrapped = []
    for equation in equations().values():
        module_name, _, name = equation.name.partition(".")
        module = import_module(f"...equations.{module_name}", __package__)
        wrapped.append((module, name, equation.function))
        setattr(module, name, _recorder(equation, calls, depth))
    try:
        yield calls
    finally:
        for module, name, function in wrapped:
            setattr(module, name, function)


def _recorder(equation: Equation, calls: list[Call], depth: list[int]) -> Callable[..., Any]:
    bound = signature(equation.function)

    @wraps(equation.function)
    def record(*args: Any, **kwargs: Any) -> Any:
        depth[0] += 1
        try:
            value = equation.function(*args, **kwargs)
        finally:
            depth[0] -= 1
        if depth[0] == 0:
            calls.append(Call(equation, dict(bound.bind(*args, **kwargs).arguments), value))
        return value

    return record


def distinct(calls: list[Call]) -> list[Call]:
    """Return the calls of plain numbers, each once, in the order they first ran; calls of one equation together."""
    order: dict[str, dict[tuple[str, ...], Call]] = {}
    for call in calls:
        values = tuple(call.arguments.values())
        if all(isinstance(value, int | float) for value in (*values, call.value)):
            # the same number by two ways may differ in its last digits
            same = tuple(f"{value:.12g}" for value in values)
            order.setdefault(call.equation.name, {}).setdefault(same, call)
    return [call for group in order.values() for call in group.values()]
