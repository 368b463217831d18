"""Recording which equations a calculation ran, with what arguments: an explanation cannot drift from the code."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import wraps
from importlib import import_module
from inspect import signature
from typing import Any, NamedTuple, get_args

from ...equations.catalogue import Equation, equations
from ...spec import Spec
from ...spec.models import Friction, Range
from ...variants import Law

_LAWS = (*get_args(Law), "drive", "heat")
"""Modules of equations whose results are for the friction that their arguments are for."""
_RETURNING = "indirect.net_gain_returning"
_FRICTION = ("friction", "friction_driven", "friction_driving")
"""Arguments that say for which friction an equation is evaluated."""


class Marked(float):
    """A number that knows what it is; arithmetic on it gives a plain number, which says nothing it does not know."""

    at: str | None
    """Friction it is, or is for, such as ``f_max``."""
    end: str
    """End of the range that a coefficient of friction is: min, cp, max."""
    origin: str
    """Equation it came from."""

    def __new__(cls, value: float, at: str | None, *, end: str = "", origin: str = "") -> "Marked":
        """Mark ``value``."""
        marked = super().__new__(cls, value)
        marked.at, marked.end, marked.origin = at, end, origin
        return marked


class _MarkedFriction(Friction):
    """Friction whose coefficients know which end of which range they are."""

    @property
    def range(self) -> Range:
        return _marked(super().range)

    @property
    def groups(self) -> tuple[Range, Range]:
        first, second = super().groups
        return (_marked(first, "1"), _marked(second, "2")) if self.unlike else (first, second)


def _marked(own: Range, group: str = "") -> Range:
    ends = zip(own, ("min", "cp", "max"), strict=True)
    return Range(*(Marked(value, f"f_{group}{end}", end=end) for value, end in ends))


def with_roles(spec: Spec) -> Spec:
    """Return the spec with coefficients of friction that know what they are: engines pass them on as they are."""
    given = {name: getattr(spec.friction, name) for name in Friction.model_fields}
    return spec.model_copy(update={"friction": _MarkedFriction.model_construct(**given)})


class Call(NamedTuple):
    """One call of an equation function."""

    equation: Equation
    arguments: dict[str, Any]
    value: Any

    def symbol(self, name: str) -> str:
        """Symbol of an argument; a coefficient of friction gets the end of the range it is."""
        symbol, value = self.equation.arguments[name].symbol, self.arguments[name]
        if not isinstance(value, Marked):
            return symbol
        if symbol == "κ" and value.origin == _RETURNING:
            return "κ₊"
        if value.end and symbol in ("f_1", "f_2"):
            return symbol + value.end
        return str(value.at) if value.end and symbol in ("f", "f_i") else symbol

    @property
    def at(self) -> str | None:
        """Which friction the value is for; on the returning branch also that, or from which friction it returns."""
        own = self._own
        if self.equation.name.partition(".")[0] not in _LAWS:
            return own
        marked = [value for value in self.arguments.values() if isinstance(value, Marked) and not value.end]
        if own and any(value.origin == _RETURNING for value in marked):
            return f"{own}, returning"
        others = {value.at for value in marked if value.at}
        if len(others) != 1 or "friction_set" in self.arguments:
            return own
        (other,) = others
        return other if own in (None, other.removesuffix(", returning")) else f"{own} after {other}"

    @property
    def _own(self) -> str | None:
        """What the friction among the arguments says."""
        own = [name for name in _FRICTION if name in self.arguments]
        if not own:
            return None
        if len({getattr(self.arguments[name], "end", "") for name in own}) > 1:
            return ", ".join(self.symbol(name) for name in reversed(own))
        value = self.arguments[own[0]]
        if isinstance(value, Marked) and value.end:
            return value.at
        return f"{self.equation.arguments[own[0]].symbol} = {value:g}"


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
        if depth[0] > 0:
            return value
        call = Call(equation, dict(bound.bind(*args, **kwargs).arguments), value)
        calls.append(call)
        return Marked(value, call.at, origin=equation.name) if type(value) is float else value

    return record


def distinct(calls: list[Call]) -> list[Call]:
    """Return the calls of plain numbers, each once, in the order they first ran; calls of one equation together.

    Equal numbers that are for different frictions, or stand under different symbols, are different calls.
    """
    order: dict[str, dict[tuple[str | None, ...], Call]] = {}
    for call in calls:
        values = tuple(call.arguments.values())
        if all(isinstance(value, int | float) for value in (*values, call.value)):
            # the same number by two ways may differ in its last digits
            same = (call.at, *map(call.symbol, call.arguments), *(f"{value:.12g}" for value in values))
            order.setdefault(call.equation.name, {}).setdefault(same, call)
    return [call for group in order.values() for call in group.values()]
