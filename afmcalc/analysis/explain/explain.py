"""Steps of a calculation as an engineer writes them: formula, formula with numbers, value, source, misprints.

``explain`` lists the laws that were applied; a report shows each formula once, then a row of numbers for each case
(``derivations``).
"""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from typing import NamedTuple

from ...engines import Clutch, build
from ...engines.quantities import NotedStep
from ...engines.selection import quantities_of
from ...equations.arrays import is_array
from ...equations.catalogue import Equation, equation_of
from ...equations.terms import CASES, Term, quantity_of, term_of
from ...errors import AfmcalcError
from ...findings import FINDINGS, Finding
from ...formula_tree import Tree, text
from ...messages import did_you_mean, native, say, translate
from ...papers.handbook_text import sections
from ...papers.register import register
from ...result import Answer, Result, described
from ...spec import Spec
from ...spec.models import Method
from ..registry import ANALYSES, EXPLAINED, StressRule
from .formula import FormulaText

_LARGEST = ("contact_force_at_ball", "contact_pressure_at_ball")
_SETTINGS: dict[str, Method] = {"by_min": "min-friction", "by_mean": "mean-friction"}
_FEW = 4
"""Number of cases above which the formulas with numbers are set in one line, without fractions."""


class Step(Result):
    """One quantity: what it is, its formula, the formula with numbers, its value."""

    symbol: str = described("symbol")
    name: str = described("what it is")
    at: str | None = described("friction it is for", optional=True)
    setting: Method | None = described("how the spring is set", optional=True)
    side: str | None = described("side of the clutch that the load is on", optional=True)
    formula: str = described("formula")
    substituted: str = described("formula with numbers and units")
    value: float = described("value, SI")
    unit: str = described("SI unit")
    source: str = described("source")
    print_differs: str | None = described("what the paper prints instead", optional=True)
    function: str = described("equation function that ran")


class ExplainResult(Answer):
    """The steps of a calculation, each quantity before it is used."""

    explained: str = described("command explained", code=True)
    steps: list[Step] = described("steps of the calculation", steps=True)


def explain(command: str, spec: Spec, model: StressRule | None = None) -> tuple[ExplainResult, list[Finding]]:
    """Run a calculation and explain every law it applied; the findings are those of the calculation.

    Raises AfmcalcError if there is no such calculation.
    """
    if command not in EXPLAINED:
        hint = did_you_mean(command, [*EXPLAINED, *sections("en")])
        if command in {code.partition("/")[0] for code in FINDINGS}:
            hint = say(" (a note: it says what is, and there is nothing to mend)")
        raise AfmcalcError(
            "explain: no calculation {command!r}{hint}; explained are {analyses}; errors and warnings by their codes",
            command=command, hint=hint, analyses=", ".join(EXPLAINED),
        )  # fmt: skip
    clutch = noting(spec)
    _, findings = ANALYSES[command].function(clutch, **({"model": model} if model else {}))
    told = [_step(step) for part in by_law(steps_of(clutch)) for step in part]
    return ExplainResult(explained=command, steps=told), findings


def noting(spec: Spec) -> Clutch:
    """Return a clutch that notes the laws it applies."""
    build(spec)  # raises SpecError if the spec is no clutch
    return quantities_of(spec, noted=True)


def steps_of(clutch: Clutch) -> list[NotedStep]:
    """Return the steps that a clutch has noted."""
    return clutch.steps or []


def _where_largest(steps: Sequence[NotedStep]) -> Iterator[NotedStep]:
    """Yield steps with one value each; along a wall the value at the largest pressure, or largest contact force."""
    largest = {
        step.name: int(step.value.argmax()) for step in steps if step.case == "along_wall" and step.name in _LARGEST
    }
    for step in steps:
        if step.name.endswith("_at_ball") and step.case == "along_wall":
            place = largest.get(step.name, largest.get("contact_pressure_at_ball", 0))
            at = {name: one.flat[place] if is_array(one) else one for name, one in step.values.items()}
            yield step._replace(values=at, value=step.value.flat[place])
        else:
            yield step


def shown(steps: Iterable[NotedStep], known: set[object] | None = None) -> list[NotedStep]:
    """Return each step once whose law is a formula and whose numbers are finite, except steps that are ``known``."""
    known, found = set() if known is None else known, list[NotedStep]()
    for step in steps:
        numbers = (*step.values.values(), step.value)
        finite = all(isinstance(one, int | float) and math.isfinite(one) for one in numbers)
        if finite and _equation(step).result.unit and (own := (step.name, step.case, *numbers)) not in known:
            with suppress(TypeError):  # a law that compares numbers, as in a search for a maximum, is no formula
                _formula(step)
                known.add(own)
                found.append(step)
    return found


def by_law(noted: Sequence[NotedStep], known: set[object] | None = None) -> list[list[NotedStep]]:
    """Group the steps that are ``shown`` by law, each group after the steps that it uses.

    A group is split if the order requires it: a spring setting follows from a torque, other torques from the setting.
    """
    steps = [*_where_largest(noted)]
    left, parts, before = dict[tuple[str, str], list[NotedStep]](), list[list[NotedStep]](), dict[int, set[int]]()
    of_quantity, kept = dict[str, set[int]](), {*map(id, shown(steps, known))}
    for step in steps:
        uses = set().union(*(of_quantity.get(quantity_of(one), ()) for one in step.arguments.values()))
        if id(step) in kept:
            left.setdefault((_equation(step).name, _result(step).symbol), []).append(step)
            before[id(step)], uses = uses, {id(step)}
        of_quantity.setdefault(step.name, set()).update(uses)
    missing = {*before}
    while left:
        ready = {name: [one for one in own if not before[id(one)] & missing] for name, own in left.items()}
        name = max(left, key=lambda name: (len(ready[name]) == len(left[name]), bool(ready[name])))  # a whole one first
        parts.append(ready[name])
        missing -= {*map(id, ready[name])}
        left[name] = [one for one in left[name] if id(one) in missing]
        left = {name: own for name, own in left.items() if own}
    return parts


def _equation(step: NotedStep) -> Equation:
    return equation_of(step.name, step.law)


def _result(step: NotedStep) -> Term:
    """Term for the result of a step; some cases have their own term, such as K_т,w in the worst case."""
    own = next((case for case in step.case.split() if not CASES[case]), None)
    return Term(*term_of(f"{step.name}_at_{own}")) if own else _equation(step).result


def _circumstance(cases: str) -> tuple[str | None, Method | None, str | None]:
    """Friction or condition, method by which the spring is set, and side, as in ``CaseRow``."""
    words = [case for case, word in CASES.items() if word and case in cases.split()]
    at = [translate(CASES[case]) for case in words if case not in (*_SETTINGS, "unprotected")]
    setting = next((_SETTINGS[case] for case in words if case in _SETTINGS), None)
    return ", ".join(at) or None, setting, "unprotected" if "unprotected" in words else None


def _formula(step: NotedStep, *, special: bool = True) -> FormulaText:
    """Formula of a step with the symbols of its law's arguments or, if ``special``, of the quantities put in."""
    terms = {name: (translate(own.symbol), own.unit) for name, own in _equation(step).arguments.items()}
    if special:
        terms |= {name: (translate(term_of(one).symbol), terms[name][1]) for name, one in step.arguments.items()}
    return FormulaText(step.law, terms, step.values)


def _print_differs(function: str) -> str:
    """Text of the misprints of an equation in the papers; empty if there are none."""
    said = []
    for one in register():
        if function in (one.function or "").split() and one.status == "mended" and one.printed:
            what = {"id": translate(one.id), "printed": translate(one.printed)}
            said.append(say("{id} prints {printed} ({misprint})", **what, misprint=one.misprint))
    return "; ".join(said)


def _step(step: NotedStep) -> Step:
    equation, formula, result = _equation(step), _formula(step), _result(step)
    at, setting, side = _circumstance(step.case)
    return Step(
        symbol=native(result.symbol),
        name=translate(result.meaning or equation.about), at=at, setting=setting, side=side,
        formula=text(formula.tree), substituted=text(formula.with_numbers()), value=float(step.value),
        unit=result.unit, source=translate(equation.source),
        print_differs=_print_differs(equation.name) or None, function=equation.name,
    )  # fmt: skip


class Meaning(NamedTuple):
    """Meaning of a symbol of a formula."""

    symbol: str
    text: str
    """Meaning in words."""
    unit: str
    """SI unit."""
    source: str = ""
    """Symbol of the quantity that takes its place, if the two differ; else empty."""
    number: int | None = None
    """Number of the formula that gives the value of the symbol; None for an input."""


class CaseRow(NamedTuple):
    """One case of a formula: its circumstance, the formula with numbers, and the value (SI)."""

    at: str | None
    """Friction, or another condition, in words, such as ``f_max``; None if there is none."""
    setting: Method | None
    """Method by which the spring is set; None: as in the spec."""
    side: str | None
    """``unprotected`` if the load is on that side of the clutch, else None."""
    numbers: Tree
    value: float


class Derivation(NamedTuple):
    """Formula of one quantity, and its values in each case."""

    number: int
    """Number of the formula; only the first derivation with this number shows the formula."""
    symbol: str
    name: str
    unit: str
    formula: Tree
    """Formula; empty if an earlier derivation has shown it."""
    where: list[Meaning]
    """Meanings of symbols that no earlier formula has explained."""
    rows: list[CaseRow]
    source: str = ""
    differs: str = ""
    """Text of the misprints in the papers; empty if there are none."""


def derivations(sections: Mapping[str, Sequence[NotedStep]]) -> dict[str, list[Derivation]]:
    """Return the derivations of each section, from the steps noted in it; each formula is shown once."""
    report, known = _Report(), set[object]()
    return {name: [report.derivation(part) for part in by_law(steps, known)] for name, steps in sections.items()}


class _Report:
    """Formulas and meanings that a report has shown so far."""

    def __init__(self) -> None:
        self.numbers: dict[str, int] = {}
        """Equation → number of its formula."""
        self.quantities: dict[str, int] = {}
        """Quantity → number of the formula that gives it."""
        self.terms: dict[Term, int] = {}
        """Term → number of the formula that gives it, for arguments that no noted quantity fills."""
        self.meanings: set[Meaning] = set()

    def derivation(self, steps: list[NotedStep]) -> Derivation:
        equation = _equation(steps[0])
        result, is_new = _result(steps[0]), equation.name not in self.numbers
        number = self.numbers.setdefault(equation.name, len(self.numbers) + 1)
        self.quantities[steps[0].name] = self.terms[result] = number
        formulas = [_formula(step, special=False) for step in steps]
        where, line = [*self.meanings_of(steps)], len(steps) > _FEW
        rows = [
            CaseRow(*_circumstance(step.case), formula.with_numbers(units=False, line=line), float(step.value))
            for step, formula in zip(steps, formulas, strict=True)
        ]
        own = Derivation(number, result.symbol, result.meaning or equation.about, result.unit, (), where, rows)
        if not is_new:
            return own
        differs = _print_differs(equation.name)
        return own._replace(formula=formulas[0].tree, source=equation.source, differs=differs)

    def meanings_of(self, steps: list[NotedStep]) -> Iterator[Meaning]:
        """Yield the meanings of the symbols of a formula, each once in a report."""
        for step in steps:
            for name, own in _equation(step).arguments.items():
                (symbol, unit, words), number, source = own, self.terms.get(own), ""
                if name in step.arguments:
                    quantity = quantity_of(step.arguments[name])
                    number, source = self.quantities.get(quantity), term_of(quantity).symbol
                meaning = Meaning(symbol, words, unit, source if number and source != symbol else "", number)
                if meaning in self.meanings:
                    continue
                self.meanings.add(meaning)
                yield meaning
