"""Quantities by name: a quantity is given, or calculated by the law of its name from the quantities in its arguments.

    clutch = quantities_of(spec)                          # engines.selection
    clutch["gain"], clutch.accuracy_factor                # no case needed
    clutch.at("f_max").torque, clutch["torque_at_f_max"]  # a case: friction has the value of friction_max
    clutch.at(friction=numpy.linspace(0.1, 0.8, 1001)).torque

A value is calculated on first use and cached. A case shares with its clutch all values that it does not change.
"""

from collections.abc import Callable, Iterable, Mapping
from types import ModuleType
from typing import TYPE_CHECKING, Any, NamedTuple

from ..equations.arrays import chosen, is_array
from ..equations.wiring import Either, Same
from ..messages import did_you_mean, say
from .named import Named

Law = Callable[..., Any] | Either | Same | float | None
"""Law of a quantity; a number or None is the default value of the quantity."""
Case = Mapping[str, str]
"""Case, such as f_max: name of a quantity → name of the quantity whose value the first takes in this case."""
Names = frozenset[str]


class MissingError(LookupError):
    """Error: there is no such quantity, or quantities on which it depends are not given."""


class NotedStep(NamedTuple):
    """Record of a law that was applied."""

    name: str
    case: str
    """Names of the cases in effect, separated by spaces; empty if none."""
    law: Callable[..., Any]
    arguments: dict[str, str]
    """Argument → quantity used for it (friction_max for friction in the case f_max); empty for a step of ``apply``."""
    values: dict[str, Any]
    value: Any


class Laws:
    """Laws of a clutch, by the name of the quantity that each law returns, and its cases such as f_max."""

    def __init__(self, *parts: ModuleType | Mapping[str, Any], cases: Mapping[str, Case] | None = None) -> None:
        """Join the laws and ``CASES`` of several modules; a later law or case replaces an earlier one of its name."""
        self.laws: dict[str, Law] = {}
        self.cases: dict[str, Case] = {}
        for part in parts:
            self.laws |= part if isinstance(part, Mapping) else laws_in(part)
            self.cases |= getattr(part, "CASES", {})
        self.cases |= cases or {}
        self.arguments = {name: _arguments(law) for name, law in self.laws.items()}
        self.names = frozenset(self.laws).union(*self.arguments.values(), *self.cases.values())
        self.choice: Any = None
        """Arguments of ``engines.selection.laws_for`` that made these laws."""
        self._needs: dict[tuple[Names, str], Names] = {}

    def case_of(self, name: str) -> tuple[str, str] | None:
        """Quantity and case of a name such as ``torque_at_f_max``; None if it has no case."""
        quantity, at, case = name.partition("_at_")
        while at and case not in self.cases:
            more, at, case = case.partition("_at_")
            quantity += f"_at_{more}"
        return (quantity, case) if at else None

    def needs(self, name: str, given: Names, within: tuple[str, ...] = ()) -> Names:
        """Names of a quantity and of all quantities on which it depends; a given quantity depends on no other."""
        if (known := self._needs.get((given, name))) is not None:
            return known
        if name in within:
            raise RecursionError(" → ".join([*within[within.index(name) :], name]))
        found, within = {name}, (*within, name)
        if name in given:
            pass
        elif name in self.laws:
            found = found.union(*(self.needs(argument, given, within) for argument in self.arguments[name]))
        elif (split := self.case_of(name)) is not None:
            quantity, case = split[0], self.cases[split[1]]
            inner = self.needs(quantity, given.union(case), within)
            found |= inner - case.keys()
            found = found.union(*(self.needs(case[bound], given, within) for bound in inner & case.keys()))
        self._needs[given, name] = frozenset(found)
        return self._needs[given, name]

    def missing(self, name: str, given: Names) -> list[str]:
        """Names of the quantities that must be given before the quantity ``name`` can be calculated."""
        needs = self.needs(name, given) - given
        return sorted(need for need in needs if need not in self.laws and self.case_of(need) is None)


def laws_in(module: ModuleType) -> dict[str, Law]:
    """Laws and default values of quantities that a module defines, by name."""
    return {
        name: law
        for name, law in vars(module).items()
        if not name.startswith("_")
        and (isinstance(law, Either | Same | int | float) or getattr(law, "__module__", None) == module.__name__)
    }


def _arguments(law: Law) -> tuple[str, ...]:
    if isinstance(law, Either | Same):
        return tuple(law)
    return law.__code__.co_varnames[: law.__code__.co_argcount] if callable(law) else ()


Apply = Callable[..., Any]


def call(law: Callable[..., Any], *values: Any) -> Any:
    """Apply a law without recording the step; ``Quantities.apply`` records it."""
    return law(*values)


class Quantities(Named):
    """The quantities of a clutch, SI: numbers, or arrays of one axis with a value for each of many clutches."""

    def __init__(self, laws: Laws, given: Mapping[str, Any], *, noted: bool = False) -> None:
        """Start from the given quantities; ``noted``: record every law applied in ``steps``."""
        self.laws, self.given = laws, dict(given)
        self.case = ""
        self.steps: list[NotedStep] | None = [] if noted else None
        self._root, self._names = self, frozenset(self.given)
        self._kept = dict(self.given)
        self._own: dict[str, Any] = {}  # values set by a case or by ``at``
        self._bound: dict[str, tuple[str, str]] = {}  # name in _own → quantity whose value it takes, and the cases
        self._family: dict[Any, Quantities] = {}  # cached scopes, by values set; ``at`` with values starts a new cache

    def __getitem__(self, name: str) -> Any:
        """Return the value of a quantity, such as ``gain``, or of a quantity in a case, such as ``torque_at_f_max``.

        Raises MissingError if there is no such quantity, or if the quantities named in the message must be given first.
        """
        if name not in self._kept:
            scope = self._scope_of(name)
            self._kept[name] = scope._calculated(name) if scope is self else scope[name]
        return self._kept[name]

    if not TYPE_CHECKING:  # type checkers know the names from named.pyi

        def __getattr__(self, name: str) -> Any:
            """Return the value of a quantity."""
            if name.startswith("_"):
                raise AttributeError(name)
            try:
                return self[name]
            except MissingError as error:
                raise AttributeError(str(error)) from None

    def __contains__(self, name: object) -> bool:
        """True if a quantity is given or can be calculated."""
        return name in self._kept or not self.missing(str(name))

    def __dir__(self) -> Iterable[str]:
        """List the attributes, and all quantities that are given or can be calculated."""
        return [*super().__dir__(), *self.names()]

    def names(self) -> list[str]:
        """Names of all quantities that are given or can be calculated here, that is, with the friction that is set."""
        return sorted(name for name in {*self.laws.laws, *self._names} if name in self)

    def get(self, name: str, default: Any = None) -> Any:
        """Return a quantity, or ``default`` if the quantity is neither given nor can be calculated."""
        return self[name] if name in self else default  # noqa: SIM401

    def known(self, names: Iterable[str]) -> dict[str, Any]:
        """Name → value, for the quantities in ``names`` that are given or can be calculated."""
        return {name: self[name] for name in names if name in self}

    def missing(self, name: str) -> list[str]:
        """Names of the quantities that must be given before ``name`` can be calculated; empty if nothing is missing."""
        return self.laws.missing(name, self._names)

    def at(self, case: str = "", /, **values: Any) -> "Quantities":
        """Quantities in a case, or with other values of some quantities.

        A value set later removes values set earlier for quantities that depend on it. A case sets all of its quantities
        or none. Raises MissingError if there is no such case or quantity.
        """
        targets: Case = {}
        if case:
            if case not in self.laws.cases:
                cases, hint = ", ".join(self.laws.cases), did_you_mean(case, self.laws.cases)
                raise MissingError(say("no case {case!r}{hint}; there are {cases}", case=case, hint=hint, cases=cases))
            targets = self.laws.cases[case]
        for name in values:
            if name not in self.laws.names and name not in self._names:
                raise MissingError(self._unknown(name))
        fresh = {name: self[target] for name, target in targets.items()} | values
        own = {
            name: value
            for name, value in self._own.items()
            if name not in fresh and self.laws.needs(name, self._root._names).isdisjoint(fresh)
        }
        within = {target: " ".join([*self._bound.get(target, ())[1:], case]) for target in targets.values()}
        bound = self._bound | {name: (target, within[target]) for name, target in targets.items()}
        bound = {name: each for name, each in bound.items() if name not in values}
        return self._scope(own | fresh, bound, {} if values else self._family)

    def _scope(self, own: dict[str, Any], bound: dict[str, tuple[str, str]], family: dict[Any, Any]) -> "Quantities":
        bound = {name: bound[name] for name in own if name in bound}
        root = self._root
        key = frozenset((name, id(value) if is_array(value) else value) for name, value in own.items())
        if self.steps is not None:  # recorded steps name the quantity, so equal values of two quantities differ
            key |= frozenset(bound.items())
        if key not in family:
            scope = object.__new__(Quantities)
            scope.laws, scope.steps, scope._root, scope._own, scope._bound = self.laws, self.steps, root, own, bound
            scope.case = " ".join(dict.fromkeys(case for _, cases in bound.values() for case in cases.split()))
            scope.given, scope._names, scope._kept = root.given | own, root._names.union(own), dict(own)
            scope._family = family
            family[key] = scope
        return family[key]

    def _scope_of(self, name: str) -> "Quantities":
        """Scope with only the set values on which a quantity depends, so that other cases can share its value."""
        own = self._own
        if not own:
            return self
        needs = self.laws.needs(name, self._root._names)
        if own.keys() <= needs:
            return self
        if needs.isdisjoint(own):
            return self._root
        return self._scope({one: own[one] for one in own if one in needs}, self._bound, self._family)

    def _calculated(self, name: str) -> Any:
        if name not in self.laws.laws:
            if (split := self.laws.case_of(name)) is None or split[0] not in self.laws.names:
                raise MissingError(self._unknown(name))
            return self.at(split[1])[split[0]]
        law = self.laws.laws[name]
        if isinstance(law, Same):
            return self[law.quantity]
        if isinstance(law, Either):
            condition = self[law.condition]
            if type(condition) is bool:
                return self[law.yes if condition else law.no]
            return chosen(condition, lambda: self[law.yes], lambda: self[law.no])
        if not callable(law):
            return law
        kept = self._kept
        try:
            values = {one: kept[one] if one in kept else self[one] for one in self.laws.arguments[name]}
        except MissingError:
            raise MissingError(self._unknown(name)) from None
        value = law(**values)
        if self.steps is not None:
            self.steps.append(
                NotedStep(name, self.case, law, {one: self.stands_for(one) for one in values}, values, value)
            )
        return value

    def apply(self, law: Callable[..., Any], *values: Any) -> Any:
        """Apply a function that is not among the laws, and record it as a step in this case."""
        value = law(*values)
        if self.steps is not None:
            given = dict(zip(_arguments(law), values, strict=True))
            self.steps.append(NotedStep(law.__name__, self.case, law, {}, given, value))
        return value

    def stands_for(self, name: str) -> str:
        """Name of the quantity whose value ``name`` has here: ``friction_max`` for ``friction`` in the case f_max."""
        if name in self._bound:
            return self._bound[name][0]
        law = None if name in self._names else self.laws.laws.get(name)
        if law is None and name not in self._names and (split := self.laws.case_of(name)) is not None:
            there = self.at(split[1])
            return there.stands_for(split[0]) + ("" if split[0] in there._bound else f"_at_{split[1]}")
        if isinstance(law, Either) and not is_array(self[law.condition]):
            return self.stands_for(law.yes if self[law.condition] else law.no)
        return self.stands_for(law.quantity) if isinstance(law, Same) else name

    def _unknown(self, name: str) -> str:
        known = self.laws.names | self._names
        split = self.laws.case_of(name)
        if name not in known and (split is None or split[0] not in known):
            return say("no quantity {name!r}{hint}", name=name, hint=did_you_mean(name, known))
        missing = self.missing(name)
        cases = [case for case, targets in self.laws.cases.items() if targets.keys() & {*missing}]
        if cases:
            return say(
                "{name} needs {needs}: ask it at a value of that, or in a case: {cases}",
                name=name, needs=", ".join(missing), cases=", ".join(cases),
            )  # fmt: skip
        return say("{name} needs {needs}", name=name, needs=", ".join(missing))
