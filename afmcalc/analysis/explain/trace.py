"""Recording which equations a calculation ran, with what arguments: an explanation cannot drift from the code."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import wraps
from importlib import import_module
from inspect import signature
from typing import Any, Literal, NamedTuple, get_args

from ...engines.sensitivity import Part
from ...equations.catalogue import Equation, equations
from ...messages import say
from ...recorders import Recorders, Wrapped, recorded_by
from ...spec import Spec
from ...spec.edit import with_values
from ...spec.models import Friction, Method, Range
from ...variants import Law

_LAWS = (*get_args(Law), "drive", "heat")
"""Modules of equations whose results are for the friction that their arguments are for."""
_RETURNING = "indirect.net_gain_returning"
_UNPROTECTED = "life.torque_unprotected"
_AT_LIMIT = "C_max"
"""Symbol of the gain limit, for equations that are evaluated at it instead of at the gain of the clutch."""
_FRICTION = ("friction", "friction_driven", "friction_driving")
"""Arguments that say for which friction an equation is evaluated."""
_OF_THE_CLUTCH = (
    *("adjustment.nominal_torque", "adjustment.closing_force"),
    *("overload.machine_torque", "overload.interval_low", "accuracy.scatter_band"),
)
"""Equations whose results are for no friction, though their arguments are."""
_SETTINGS: dict[str, Method] = {"min": "min-friction", "cp": "mean-friction"}
"""End of the range that the friction at the setting is → the method."""

Branch = Literal["", "returning", "held"]
"""Friction rises; it falls and the sleeve moves back; it falls and the key still holds the sleeve."""
Side = Literal["", "protected", "unprotected"]


class Circumstance(NamedTuple):
    """What a value is for, as far as it is known."""

    friction: str | None = None
    """Friction it is for, such as ``f_max``; a range where it is for one: ``f_min … f_max``."""
    branch: Branch = ""
    after: str | None = None
    """Friction from which it fell while the key holds the sleeve."""
    setting: Method | None = None
    """How the spring is set."""
    side: Side = ""
    """Side of the clutch that the load is on."""

    @property
    def at(self) -> str | None:
        """Friction and branch in one."""
        if self.branch == "returning":
            return say("{friction}, returning", friction=self.friction)
        if self.branch == "held":
            return say("{friction} after {after}", friction=self.friction, after=self.after)
        return self.friction


class Marked(float):
    """A number that knows what it is; arithmetic on it gives a plain number, which says nothing it does not know."""

    case: Circumstance
    """What it is, or is for."""
    end: str
    """End of the range that a coefficient of friction is: min, cp, max."""
    origin: str
    """Equation it came from."""

    def __new__(cls, value: float, case: Circumstance, *, end: str = "", origin: str = "") -> "Marked":
        """Mark ``value``."""
        marked = super().__new__(cls, value)
        marked.case, marked.end, marked.origin = case, end, origin
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
    return Range(*(Marked(value, Circumstance(f"f_{group}{end}"), end=end) for value, end in ends))


def with_roles(spec: Spec) -> Spec:
    """Return the spec with coefficients of friction, and a spring, that know what they are; engines pass them on."""
    given = {name: getattr(spec.friction, name) for name in Friction.model_fields}
    marked = spec.model_copy(update={"friction": _MarkedFriction.model_construct(**given)})
    force = spec.closing_spring.force
    if force is None:
        return marked
    set_so = Marked(force, Circumstance(setting=spec.adjustment.method))
    return with_values(marked, {"closing_spring.force": set_so})


class Call(NamedTuple):
    """One call of an equation function."""

    equation: Equation
    arguments: dict[str, Any]
    value: Any

    def symbol(self, name: str) -> str:
        """Symbol of an argument: of a friction the end of its range, of a special T, C, κ … that of T', C(x), κ₊ …"""
        symbol, value = self.equation.arguments[name].symbol, self.arguments[name]
        if not isinstance(value, Marked):
            return symbol
        if value.origin and (special := equations()[value.origin].result.symbol).startswith(symbol):
            return special
        if value.end and symbol[:3] in ("f_1", "f_2"):
            return symbol[:3] + value.end
        return str(value.case.friction) if value.end and symbol in ("f", "f_i") else symbol

    @property
    def result(self) -> str:
        """Symbol of the result; an elasticity in a parameter p names it."""
        symbol = self.equation.result.symbol
        of = next((value.of for value in self.arguments.values() if isinstance(value, Part)), "p")
        return f"{symbol.removesuffix('p')}{of}" if symbol.endswith("∂ln p") else symbol

    @property
    def case(self) -> Circumstance:
        """What the value is for: what its arguments are for, as far as they agree."""
        return self._at._replace(setting=self._setting, side=self._side)

    @property
    def _marked(self) -> list[Marked]:
        return [value for value in self.arguments.values() if isinstance(value, Marked)]

    @property
    def _results(self) -> list[Marked]:
        """Arguments that are results of other equations."""
        return [value for value in self._marked if not value.end]

    @property
    def _at(self) -> Circumstance:
        """For which friction, and on which branch."""
        own, module = self._own, self.equation.name.partition(".")[0]
        if self.equation.name in _OF_THE_CLUTCH or ".accuracy_factor" in self.equation.name:
            return Circumstance()
        if "gain" in self.arguments and self.symbol("gain") == _AT_LIMIT:
            return Circumstance(_AT_LIMIT)
        if module not in _LAWS:
            return Circumstance(own) if own else self._shared(over_range=module == "life")
        if own and any(value.origin == _RETURNING for value in self._results):
            return Circumstance(own, "returning")
        shared = self._shared()
        if shared.friction is None or "friction_set" in self.arguments:
            return Circumstance(own)
        if own in (None, shared.friction):
            return shared
        return Circumstance(own, "held", shared.friction)

    def _shared(self, *, over_range: bool = False) -> Circumstance:
        """What the results among the arguments are for; the range between them where a cycle goes over one."""
        cases = {value.case._replace(setting=None, side=""): None for value in self._results if value.case.friction}
        # what is the same on both branches is on the one that another of them is on
        branches = [case for case in cases if case.branch] or list(cases)
        if len(branches) == 1 and len({case.friction for case in cases}) == 1:
            return branches[0]
        ends = [case.at or "" for case in cases]
        return Circumstance(" … ".join(ends)) if over_range and cases else Circumstance()

    @property
    def _setting(self) -> Method | None:
        """How the spring is set: by the friction at the setting, or as what it is calculated from."""
        at_setting = self.arguments.get("friction_set")
        if self.equation.name == "direct.torque_per_force":
            at_setting = self.arguments["friction_driven"]
        if isinstance(at_setting, Marked) and at_setting.end:
            return _SETTINGS.get(at_setting.end)
        settings = {value.case.setting for value in self._results if value.case.setting}
        return settings.pop() if len(settings) == 1 else None

    @property
    def _side(self) -> Side:
        if self.equation.name == _UNPROTECTED or any(value.case.side == "unprotected" for value in self._results):
            return "unprotected"
        return "protected" if self.equation.name.startswith("life.") else ""

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
            return value.case.friction
        return f"{self.equation.arguments[own[0]].symbol} = {value:g}"


@contextmanager
def recording() -> Iterator[list[Call]]:
    """Record every outermost call of an equation function made within the block.

    The functions of the equation modules are wrapped while the block runs; calls that one equation makes of
    another belong to it and are not listed.
    """
    calls: list[Call] = []
    depth = [0]
    places = tuple(_wrapped(each, _recorder(each, calls, depth)) for each in equations().values())
    with recorded_by(Recorders(places, _marked_like)):
        yield calls


def _wrapped(equation: Equation, recorder: Callable[..., Any]) -> Wrapped:
    module, _, name = equation.name.partition(".")
    return Wrapped(import_module(f"...equations.{module}", __package__), name, equation.function, recorder)


def _marked_like(value: Any, *like: Any) -> Any:
    """A number that no equation gives, marked with what others are for: a range of friction where theirs differ."""
    if isinstance(value, Marked):
        return value
    marks = [each.case for each in like if isinstance(each, Marked)]
    frictions = {case.at: case for case in marks if case.friction}
    case = Circumstance(" … ".join(str(at) for at in frictions)) if len(frictions) > 1 else Circumstance()
    case = case if len(frictions) != 1 else next(iter(frictions.values()))
    if any(getattr(each, "origin", "") == _RETURNING for each in like):
        case = case._replace(branch="returning")
    settings = {each.setting for each in marks if each.setting}
    side: Side = next((each.side for each in marks if each.side), "")
    case = case._replace(setting=settings.pop() if len(settings) == 1 else None, side=side)
    origins = {getattr(each, "origin", "") for each in like}
    return Marked(float(value), case, origin=origins.pop() if len(origins) == 1 else "")


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
        return Marked(value, call.case, origin=equation.name) if type(value) is float else value

    return record


def distinct(calls: list[Call]) -> list[Call]:
    """Return the calls of plain numbers, each once, in the order they first ran; calls of one equation together.

    Equal numbers that are for different frictions, or stand under different symbols, are different calls.
    """
    order: dict[str, dict[tuple[object, ...], Call]] = {}
    for call in calls:
        values = tuple(call.arguments.values())
        if all(isinstance(value, int | float) for value in (*values, call.value)):
            order.setdefault(call.equation.name, {}).setdefault(identity(call), call)
    return [call for group in order.values() for call in group.values()]


def identity(call: Call) -> tuple[object, ...]:
    """Return what two calls of plain numbers have in common where they are one."""
    # the same number by two ways may differ in its last digits
    numbers = (f"{value:.12g}" for value in call.arguments.values())
    return (call.equation.name, call.case, call.result, *map(call.symbol, call.arguments), *numbers)
