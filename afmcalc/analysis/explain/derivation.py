"""A calculation as a report shows it: each formula once, its symbols explained, then a row of numbers for each case."""

import re
from collections.abc import Iterable, Mapping
from functools import cache
from typing import NamedTuple

from ...messages import joined, say, term
from ...papers.register import register
from ...spec.keys import keys
from .formula import FormulaText, symbol_latex
from .trace import Call, Circumstance, distinct, identity, in_order


class Meaning(NamedTuple):
    """What a symbol of a formula stands for."""

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
    """One case: what it is for, the numbers put in (LaTeX), and what comes out (SI)."""

    case: Circumstance
    numbers: str
    value: float


class Derivation(NamedTuple):
    """One quantity of a calculation."""

    number: int
    """Number of its formula; the formula is shown where the number first stands."""
    symbol: str
    name: str
    unit: str
    symbol_latex: str
    formula: str
    """What it equals, LaTeX; empty where an earlier derivation has shown it."""
    where: list[Meaning]
    """Symbols that no formula before has explained so."""
    rows: list[CaseRow]
    source: str
    differs: str
    """What the paper prints instead."""


class _Report:
    """What a report has shown so far."""

    def __init__(self) -> None:
        self.numbers: dict[str, int] = {}
        """Equation → number of its formula."""
        self.results: dict[str, tuple[int, set[str]]] = {}
        """Symbol of a result → number of its formula, and its values."""
        self.calls: set[tuple[object, ...]] = set()
        self.meanings: set[Meaning] = set()
        self.texts: set[tuple[str, str]] = set()


def derivations(sections: Mapping[str, list[Call]]) -> dict[str, list[Derivation]]:
    """Return the derivations of each section; what an earlier one has shown is not shown again.

    Args:
        sections: name of a section → the calls of equations that were noted for it.
    """
    report = _Report()
    return {name: list(_section(calls, report)) for name, calls in sections.items()}


def _section(calls: list[Call], report: _Report) -> Iterable[Derivation]:
    untold = []
    for call in distinct(calls):
        if (own := identity(call)) not in report.calls and not call.equation.result.symbol.startswith(_SLOPE):
            report.calls.add(own)
            untold.append(call)
    for part in in_order(untold):
        yield _derivation(part, report)


_SLOPE = "∂"
"""Slopes are no quantities of the clutch: they rank what it depends on (``explain`` has their steps)."""


def _derivation(calls: list[Call], report: _Report) -> Derivation:
    equation = calls[0].equation
    result, shown = equation.result, equation.name in report.numbers
    number = report.numbers.setdefault(equation.name, len(report.numbers) + 1)
    report.results.setdefault(result.symbol, (number, set()))[1].update(f"{call.value:.12g}" for call in calls)
    return Derivation(
        number=number,
        symbol=result.symbol,
        name=re.split("[,:;]", equation.summary)[0].rstrip("."),
        unit=result.unit,
        symbol_latex=symbol_latex(result.symbol),
        formula="" if shown else _text(calls[0]).latex(),
        where=list(_meanings(calls, report)),
        rows=[_row(call, line=len(calls) > _FEW) for call in calls],
        source="" if shown else equation.source,
        differs="" if shown else _misprints().get(equation.name, ""),
    )


_FEW = 4
"""Cases above which the numbers are put into one line, not into fractions."""


def _row(call: Call, *, line: bool) -> CaseRow:
    return CaseRow(call.case, _text(call).latex_with_numbers(line=line), float(call.value))


@cache
def _misprints() -> dict[str, str]:
    """Equation → what the papers print in its place."""
    found: dict[str, list[str]] = {}
    for entry in register():
        if entry.status == "mended" and entry.printed and entry.function:
            printed = say(
                "{id}: {printed} ({misprint})", id=term(entry.id), printed=term(entry.printed), misprint=entry.misprint
            )
            found.setdefault(entry.function, []).append(printed)
    return {name: joined(printed, "; ") for name, printed in found.items()}


def _text(call: Call) -> FormulaText:
    terms = call.equation.arguments
    # which frictions the extremes are at differs from clutch to clutch
    own = call.equation.name == "accuracy.accuracy_factor"
    symbols = {name: call.symbol(name) if own else terms[name].symbol for name in call.arguments}
    units = {name: terms[name].unit for name in call.arguments}
    return FormulaText(call.equation.function, symbols, call.arguments, units)


def _meanings(calls: list[Call], report: _Report) -> Iterable[Meaning]:
    """Say what the symbols of a formula stand for, each meaning once in a report."""
    for call in calls:
        for name in call.arguments:
            if call.equation.arguments[name].symbol == "π":
                continue
            meaning = _meaning(call, name, report)
            # what a spec gives is one thing, whatever words a formula has for it
            given = meaning.number is None and meaning.symbol in _keys()
            own = meaning._replace(text="") if given else meaning
            if own in report.meanings:
                continue
            report.meanings.add(own)
            if meaning.source and (meaning.symbol, meaning.text) in report.texts:
                meaning = meaning._replace(text="")  # κ, and for the way back κ₊ in its place
            report.texts.add((meaning.symbol, meaning.text))
            yield meaning


def _meaning(call: Call, name: str, report: _Report) -> Meaning:
    term = call.equation.arguments[name]
    number = _number(call, name, report)
    own = next((each for each, (count, _) in report.results.items() if count == number), term.symbol)
    if term.symbol in _OF_TANGENT:
        return Meaning(term.symbol, _OF_TANGENT[term.symbol], "1", number=report.results["tan α"][0])
    text = term.meaning or ("" if number else _keys().get(term.symbol, ""))
    return Meaning(term.symbol, text, term.unit, own if own != term.symbol else "", number)


_OF_TANGENT = {
    "sin α": "sine of the wall angle, from its tangent",
    "cos α": "cosine of the wall angle, from its tangent",
}


def _number(call: Call, name: str, report: _Report) -> int | None:
    """Number of the formula that an argument comes from; None of one that is given."""
    if name in call.marks:
        return report.numbers.get(call.marks[name].origin)
    number, values = report.results.get(call.equation.arguments[name].symbol, (None, set[str]()))
    return number if f"{call.arguments[name]:.12g}" in values else None


@cache
def _keys() -> dict[str, str]:
    """Symbol of a spec's key → what it is."""
    return {key.symbol: key.description.partition(";")[0] for key in keys().values() if key.symbol}
