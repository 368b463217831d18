"""A calculation as an engineer writes it: formula, numbers put in, value, source, and where the print differs.

``explain`` lists the laws that were applied; a report shows each formula once, then a row of numbers for each case
(``derivations``).
"""

import math
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from typing import NamedTuple

from ...engines import Clutch, build
from ...engines.quantities import NotedStep
from ...engines.selection import quantities_of
from ...equations.arrays import is_array
from ...equations.catalogue import Equation, equation_of
from ...equations.terms import CASES, Term, quantity_of, term_of
from ...errors import AfmcalcError
from ...findings import Finding
from ...formula_tree import Tree, latex, symbol_tree
from ...messages import did_you_mean, native, say, translate
from ...papers.register import register
from ...result import Answer, Result, described
from ...spec import Spec
from ...spec.models import Method
from ..registry import ANALYSES, EXPLAINED, StressRule
from .formula import FormulaText


class Step(Result):
    """One quantity: what it is, its formula, the formula with numbers, its value."""

    symbol: str = described("symbol")
    symbol_latex: str = described("symbol, LaTeX")
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
    formula_latex: str = described("formula, LaTeX")
    substituted_latex: str = described("formula with numbers, LaTeX")


class ExplainResult(Answer):
    """The steps of a calculation, each quantity before it is used."""

    explained: str = described("command explained", code=True)
    steps: list[Step] = described("steps of the calculation", steps=True)


def explain(command: str, spec: Spec, model: StressRule | None = None) -> tuple[ExplainResult, list[Finding]]:
    """Run a calculation and explain every law it applied; the findings are those of the calculation.

    Raises AfmcalcError: no such calculation.
    """
    if command not in EXPLAINED:
        hint = did_you_mean(command, EXPLAINED)
        raise AfmcalcError(
            "explain: no calculation {command!r}{hint}; explained are {analyses}",
            command=command, hint=hint, analyses=", ".join(EXPLAINED),
        )  # fmt: skip
    clutch = noting(spec)
    _, findings = ANALYSES[command].function(clutch, **({"model": model} if model else {}))
    steps = [*where_largest(steps_of(clutch))]
    told = [_step(step) for part in by_law(steps, shown(steps)) for step in part]
    return ExplainResult(explained=command, steps=told), findings


def noting(spec: Spec) -> Clutch:
    """Return a clutch that notes the laws it applies."""
    build(spec)  # refuses what is no clutch
    return quantities_of(spec, noted=True)


def steps_of(clutch: Clutch) -> list[NotedStep]:
    """Return the steps that a clutch has noted."""
    return clutch.steps or []


def where_largest(steps: Iterable[NotedStep]) -> Iterator[NotedStep]:
    """Return the steps with one number each: along a wall that of the largest contact force, or else pressure."""
    steps = list(steps)
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


_LARGEST = ("contact_force_at_ball", "contact_pressure_at_ball")


def shown(steps: Iterable[NotedStep]) -> list[NotedStep]:
    """Return the steps that are a formula with finite numbers, each once."""
    found: dict[tuple[object, ...], NotedStep] = {}
    for step in steps:
        numbers = (*step.values.values(), step.value)
        if all(isinstance(one, int | float) and math.isfinite(one) for one in numbers) and _equation(step).result.unit:
            found.setdefault((step.name, step.case, *numbers), step)
    return [step for step in found.values() if _has_formula(step)]


def _has_formula(step: NotedStep) -> bool:
    """True if a law is a formula; one that compares numbers, as for the friction of the largest torque, is none."""
    with suppress(TypeError):
        return bool(_formula(step))
    return False


def by_law(steps: Iterable[NotedStep], shown: Iterable[NotedStep]) -> list[list[NotedStep]]:
    """Group the steps shown by law, each group after the steps that it uses.

    A group is split where that needs it: a setting follows from a torque, and gives torques of its own.
    """
    left, parts, before = dict[tuple[str, str], list[NotedStep]](), list[list[NotedStep]](), dict[int, set[int]]()
    of_quantity, kept = dict[str, set[int]](), {*map(id, shown)}
    for step in steps:
        uses = set().union(*(of_quantity.get(quantity_of(one), ()) for one in step.arguments.values()))
        if id(step) in kept:
            left.setdefault((_equation(step).name, _result(step).symbol), []).append(step)
            before[id(step)], uses = uses, {id(step)}
        of_quantity.setdefault(step.name, set()).update(uses)
    missing = {*before}
    while left:
        ready = {name: [one for one in own if not before[id(one)] & missing] for name, own in left.items()}
        whole = (name for name in left if len(ready[name]) == len(left[name]))
        name = next(whole, None) or next(name for name in left if ready[name])
        parts.append(ready[name])
        missing -= {*map(id, ready[name])}
        left[name] = [one for one in left[name] if id(one) in missing]
        left = {name: own for name, own in left.items() if own}
    return parts


def _equation(step: NotedStep) -> Equation:
    return equation_of(step.name, step.law)


def _result(step: NotedStep) -> Term:
    """Term of the result of a step; in some cases it has a name of its own, as K_т,w."""
    own = next((case for case in step.case.split() if not CASES[case]), None)
    return Term(*term_of(f"{step.name}_at_{own}")) if own else _equation(step).result


class Circumstance(NamedTuple):
    """Circumstance that a value is for."""

    at: str | None = None
    """Friction it is for, such as ``f_max``, whether it falls, and the like."""
    setting: Method | None = None
    """Setting of the spring; None: as it is."""
    side: str | None = None
    """Side of the clutch that the load is on, where that is the unprotected one."""


_SETTINGS: dict[str, Method] = {"by_min": "min-friction", "by_mean": "mean-friction"}


def _circumstance(cases: str) -> Circumstance:
    words = [case for case, word in CASES.items() if word and case in cases.split()]
    at = [translate(CASES[case]) for case in words if case not in (*_SETTINGS, "unprotected")]
    setting = next((_SETTINGS[case] for case in words if case in _SETTINGS), None)
    return Circumstance(", ".join(at) if at else None, setting, "unprotected" if "unprotected" in words else None)


def _formula(step: NotedStep, *, special: bool = True) -> FormulaText:
    """Return the formula of a step with its numbers; ``special``: with the symbols of what its arguments stand for."""
    terms = {name: (translate(own.symbol), own.unit) for name, own in _equation(step).arguments.items()}
    if special:
        terms |= {name: (translate(term_of(one).symbol), terms[name][1]) for name, one in step.arguments.items()}
    return FormulaText(step.law, terms, step.values)


def _print_differs(function: str) -> str:
    """Text that the papers print in the place of an equation."""
    said = [
        say(
            "{id} prints {printed} ({misprint})",
            id=translate(one.id),
            printed=translate(one.printed),
            misprint=one.misprint,
        )
        for one in register()
        if function in (one.function or "").split() and one.status == "mended" and one.printed
    ]
    return "; ".join(said)


def _step(step: NotedStep) -> Step:
    equation, formula, case, result = _equation(step), _formula(step), _circumstance(step.case), _result(step)
    return Step(
        symbol=native(result.symbol), symbol_latex=latex(symbol_tree(translate(result.symbol))),
        name=translate(result.meaning or equation.about), at=case.at, setting=case.setting, side=case.side,
        formula=formula.text(), substituted=formula.text_with_numbers(), value=float(step.value),
        unit=result.unit, source=translate(equation.source),
        print_differs=_print_differs(equation.name) or None, function=equation.name,
        formula_latex=latex(formula.tree()), substituted_latex=latex(formula.tree_with_numbers()),
    )  # fmt: skip


class Meaning(NamedTuple):
    """Meaning of a symbol of a formula."""

    symbol: str
    text: str
    """In words; empty where the formula it comes from says it."""
    unit: str
    """SI unit."""
    source: str = ""
    """Symbol of the quantity it is, where that has another."""
    number: int | None = None
    """Formula that it comes from; None of what is given."""


class CaseRow(NamedTuple):
    """One case: what it is for, the numbers put in, and what comes out (SI)."""

    case: Circumstance
    numbers: Tree
    value: float


class Derivation(NamedTuple):
    """One quantity of a calculation."""

    number: int
    """Number of its formula; the formula is shown where the number first stands."""
    symbol: str
    name: str
    unit: str
    formula: Tree
    """Empty where an earlier derivation has shown it."""
    where: list[Meaning]
    """Symbols that no formula before has explained so."""
    rows: list[CaseRow]
    source: str
    differs: str
    """Text that the paper prints instead."""


_FEW = 4
"""Cases above which the numbers are put into one line, not into fractions."""


def derivations(sections: Mapping[str, Iterable[NotedStep]]) -> dict[str, list[Derivation]]:
    """Return the derivations of each section, of the steps noted for it; what was shown is not shown again."""
    report, known = _Report(), dict[int, str]()
    sections = {name: [*where_largest(steps)] for name, steps in sections.items()}
    for name, steps in sections.items():
        known |= {id(step): name for step in steps}
    new: dict[str, list[NotedStep]] = {name: [] for name in sections}
    for step in shown(step for steps in sections.values() for step in steps):
        new[known[id(step)]].append(step)
    return {name: [report.derivation(part) for part in by_law(sections[name], own)] for name, own in new.items()}


class _Report:
    """Formulas and meanings that a report has shown so far."""

    def __init__(self) -> None:
        self.numbers: dict[str, int] = {}
        """Equation → number of its formula."""
        self.quantities: dict[str, int] = {}
        """Quantity → number of the formula that gives it."""
        self.terms: dict[Term, int] = {}
        """Term → number of the formula that gives it, of equations that are not wired."""
        self.meanings: set[Meaning] = set()

    def derivation(self, steps: list[NotedStep]) -> Derivation:
        equation = _equation(steps[0])
        result, is_new = _result(steps[0]), equation.name not in self.numbers
        number = self.numbers.setdefault(equation.name, len(self.numbers) + 1)
        self.quantities[steps[0].name] = self.terms[result] = number
        formulas = [_formula(step, special=False) for step in steps]
        return Derivation(
            number=number,
            symbol=result.symbol,
            name=result.meaning or equation.about,
            unit=result.unit,
            formula=formulas[0].tree() if is_new else (),
            where=list(self.meanings_of(steps)),
            rows=[
                CaseRow(
                    _circumstance(step.case),
                    text.tree_with_numbers(units=False, line=len(steps) > _FEW),
                    float(step.value),
                )
                for step, text in zip(steps, formulas, strict=True)
            ],
            source=equation.source if is_new else "",
            differs=_print_differs(equation.name) if is_new else "",
        )

    def meanings_of(self, steps: list[NotedStep]) -> Iterator[Meaning]:
        """Say what the symbols of a formula stand for, each meaning once in a report."""
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
