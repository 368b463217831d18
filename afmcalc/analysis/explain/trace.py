"""Which equations a calculation ran, with what arguments, and what each value is for."""

from collections.abc import Iterable, Mapping
from inspect import signature
from typing import Any, Literal, NamedTuple, cast, get_args

from ...equations.calls import Note
from ...equations.catalogue import Equation, equations
from ...messages import say, term
from ...papers.register import register
from ...spec.models import Method
from ...variants import Law
from .formula import FormulaText

_LAWS = (*get_args(Law), "drive", "heat")
"""Modules of equations whose results are for the friction that their arguments are for."""
_RETURNING = "indirect.net_gain_returning"
_UNPROTECTED = "life.torque_unprotected"
_FRICTION = ("friction", "friction_driven", "friction_driving")
"""Arguments that say for which friction an equation is evaluated."""
_OF_THE_CLUTCH = (
    *("adjustment.nominal_torque", "adjustment.closing_force"),
    *("overload.machine_torque", "overload.interval_low", "accuracy.scatter_band"),
)
"""Equations whose results are for no friction, though their arguments are."""
_SET_BY = {"direct.torque_per_force": "friction_driven", "adjustment.closing_force": "torque_per_force"}
"""Equation → the argument that says how the spring is set; of others ``friction_set``."""
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


class Mark(NamedTuple):
    """What is known of a number."""

    case: Circumstance
    """What it is, or is for."""
    end: str = ""
    """End of the range that a coefficient of friction is: min, cp, max."""
    origin: str = ""
    """Equation it came from."""
    parameter: str = ""
    """Elasticity that it is the part of a parameter in: ``∂ln C``."""


class Call(NamedTuple):
    """One call of an equation function."""

    equation: Equation
    arguments: dict[str, Any]
    value: Any
    marks: dict[str, Mark]
    """What is known of its arguments, by name."""

    def symbol(self, name: str) -> str:
        """Symbol of an argument: of a friction the end of its range, of a special T, C, κ … that of T', C(x), κ₊ …"""
        symbol, mark = self.equation.arguments[name].symbol, self.marks.get(name)
        if mark is None:
            return symbol
        if mark.origin and (special := equations()[mark.origin].result.symbol).startswith(symbol):
            return special
        if mark.end and symbol[:3] in ("f_1", "f_2"):
            return symbol[:3] + mark.end
        return str(mark.case.friction) if mark.end and symbol in ("f", "f_i") else symbol

    @property
    def result(self) -> str:
        """Symbol of the result; an elasticity in a parameter p names it."""
        symbol = self.equation.result.symbol
        parameter = next((mark.parameter for mark in self.marks.values() if mark.parameter), "∂ln p")
        return f"{symbol.removesuffix('∂ln p')}{parameter}" if symbol.endswith("∂ln p") else symbol

    @property
    def case(self) -> Circumstance:
        """What the value is for: what its arguments are for, as far as they agree."""
        name, results = self.equation.name, [mark for mark in self.marks.values() if not mark.end]
        at_setting = self.marks.get(_SET_BY.get(name, "friction_set"))
        if at_setting is not None and (at_setting.end or at_setting.case.setting):
            setting = _SETTINGS.get(at_setting.end, at_setting.case.setting)
        else:
            setting = _agreed(mark.case.setting for mark in results)
        side: Side = "protected" if name.startswith("life.") else ""
        if name == _UNPROTECTED or any(mark.case.side == "unprotected" for mark in results):
            side = "unprotected"
        return self._at(results)._replace(setting=setting, side=side)

    def _at(self, results: list[Mark]) -> Circumstance:
        """For which friction, and on which branch; ``results``: arguments that are no coefficients of friction."""
        friction, module = self._friction, self.equation.name.partition(".")[0]
        if self.equation.name in _OF_THE_CLUTCH or ".accuracy_factor" in self.equation.name:
            return Circumstance()
        if module in _LAWS and friction and any(mark.origin == _RETURNING for mark in results):
            return Circumstance(friction, "returning")
        if module not in _LAWS and friction:
            return Circumstance(friction)
        cases = {mark.case._replace(setting=None, side=""): None for mark in results if mark.case.friction}
        # what is the same on both branches is on the one that another of them is on
        branches = [case for case in cases if case.branch] or list(cases)
        shared = Circumstance()
        if len(branches) == 1 and len({case.friction for case in cases}) == 1:
            shared = branches[0]
        elif module == "life" and cases:  # a cycle goes over a range
            shared = Circumstance(" … ".join(case.at or "" for case in cases))
        if module not in _LAWS:
            return shared
        if shared.friction is None or "friction_set" in self.arguments:
            return Circumstance(friction)
        if friction in (None, shared.friction):
            return shared
        # f_1 and f_2 of a direct clutch are two frictions of one case
        return Circumstance(friction, "held", shared.friction) if module == "indirect" else Circumstance(friction)

    @property
    def _friction(self) -> str | None:
        """What the friction among the arguments says."""
        names = [name for name in _FRICTION if name in self.arguments]
        ends = {self.marks[name].end if name in self.marks else "" for name in names}
        if len(ends) > 1:
            return ", ".join(self.symbol(name) for name in reversed(names))
        if not names or ends != {""}:
            return self.marks[names[0]].case.friction if names else None
        return f"{self.equation.arguments[names[0]].symbol} = {self.arguments[names[0]]:g}"


def _agreed(settings: Iterable[Method | None]) -> Method | None:
    """The one setting among several; None where they differ."""
    known = {setting for setting in settings if setting}
    return known.pop() if len(known) == 1 else None


def formula_text(call: Call, *, special: bool = True) -> FormulaText:
    """Return the formula of a call and its numbers; ``special``: with the symbols that this call's arguments have."""
    terms = call.equation.arguments
    symbols = {name: call.symbol(name) if special else terms[name].symbol for name in call.arguments}
    return FormulaText(
        call.equation.function, symbols, call.arguments, {name: terms[name].unit for name in call.arguments}
    )


def misprints(function: str) -> list[dict[str, object]]:
    """What the papers print in the place of an equation: id, printed and misprint of each place."""
    return [
        {"id": term(entry.id), "printed": term(entry.printed), "misprint": entry.misprint}
        for entry in register()
        if entry.function == function and entry.status == "mended" and entry.printed
    ]


class CallReader:
    """Makes calls of notes: a number that one equation gave and another was given is known by its identity."""

    def __init__(self) -> None:
        """Know nothing yet."""
        self._marks: dict[int, Mark] = {}

    def calls(self, notes: Iterable[Note]) -> list[Call]:
        """The calls among notes, which follow those told before and are kept as long as this is asked."""
        return [call for note in notes if (call := self._read(note)) is not None]

    def _read(self, note: Note) -> Call | None:
        if note.function is None:
            self._marks[id(note.value)] = self._derived(note)
            return None
        equation = equations()[f"{note.function.__module__.rpartition('.')[2]}.{note.function.__name__}"]
        arguments = signature(note.function).bind(*note.args, **note.kwargs).arguments
        marks = {name: self._marks[id(value)] for name, value in arguments.items() if id(value) in self._marks}
        call = Call(equation, dict(arguments), note.value, marks)
        if type(note.value) is float:
            self._marks[id(note.value)] = Mark(call.case, origin=equation.name)
        return call

    def _derived(self, note: Note) -> Mark:
        """What a number is for that no equation gives: a range of friction where what it is from differs."""
        if note.role in get_args(Method):
            return Mark(Circumstance(setting=cast(Method, note.role)))
        if note.role.startswith("∂"):
            return Mark(Circumstance(), parameter=note.role)
        if note.role:
            return Mark(Circumstance(note.role), end=note.role[2:].lstrip("12"))
        marks = [self._marks[id(value)] for value in note.args if id(value) in self._marks]
        frictions = {mark.case.at: mark.case for mark in marks if mark.case.friction}
        case = Circumstance(" … ".join(map(str, frictions)) or None)
        if len(frictions) == 1:
            (case,) = frictions.values()
        if any(mark.origin == _RETURNING for mark in marks):
            case = case._replace(branch="returning")
        side: Side = next((mark.case.side for mark in marks if mark.case.side), "")
        origins = {mark.origin for mark in marks} if len(marks) == len(note.args) else set()
        return Mark(
            case._replace(setting=_agreed(mark.case.setting for mark in marks), side=side),
            origin=origins.pop() if len(origins) == 1 else "",
        )


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


def in_order(calls: Iterable[Call]) -> list[list[Call]]:
    """Return calls by equation: what a call uses before it, and else in the order in which the equations ran.

    A group is parted where it must: κ leads to the sleeve's place, and is taken anew there.
    """
    left, parts = dict[str, list[Call]](), list[list[Call]]()
    for call in calls:
        left.setdefault(call.equation.name, []).append(call)
    known = _values(left)
    while left:
        missing = _values(left)
        ready = {name: [call for call in calls if not _uses(call, known) & missing] for name, calls in left.items()}
        whole = (name for name in left if len(ready[name]) == len(left[name]))
        name = next(whole, next((name for name in left if ready[name]), next(iter(left))))
        parts.append(part := ready[name] or left[name])
        left[name] = [call for call in left[name] if not any(call is other for other in part)]
        left = {name: calls for name, calls in left.items() if calls}
    return parts


def _values(groups: Mapping[str, list[Call]]) -> set[tuple[str, str]]:
    """Equations with their values, and without."""
    return {(name, value) for name, calls in groups.items() for call in calls for value in ("", f"{call.value:.12g}")}


def _uses(call: Call, known: set[tuple[str, str]]) -> set[tuple[str, str]]:
    """Results of other equations that a call uses; of one that a search found, all of its equation."""
    used = {(mark.origin, f"{call.arguments[name]:.12g}") for name, mark in call.marks.items()}
    return {result if result in known else (result[0], "") for result in used if result[0] != call.equation.name}
