"""A calculation as an engineer writes it: formula, numbers put in, value, source, and where the print differs.

``explain`` lists every call; a report shows each formula once, then a row of numbers for each case (``derivations``).
"""

from collections.abc import Iterable, Mapping
from functools import cache
from typing import NamedTuple

from ...engines import build
from ...equations.calls import noted
from ...errors import AfmcalcError
from ...findings import Finding
from ...messages import did_you_mean, joined, say
from ...result import Answer, Result, Sentence, described
from ...spec import Spec
from ...spec.keys import keys
from ...spec.models import Method
from ..registry import ANALYSES, EXPLAINED, StressRule
from .formula import symbol_latex
from .trace import Call, CallReader, Circumstance, distinct, formula_text, identity, in_order, misprints


class Step(Result):
    """One quantity: what it is, its formula, the formula with numbers, its value."""

    symbol: str = described("symbol")
    symbol_latex: str = described("symbol, LaTeX")
    name: str = described("what it is")
    at: Sentence | None = described("friction it is for", optional=True)
    setting: Method | None = described("how the spring is set", optional=True)
    side: str | None = described("side of the clutch that the load is on", optional=True)
    formula: str = described("formula")
    substituted: str = described("formula with numbers and units")
    value: float = described("value, SI")
    unit: str = described("SI unit")
    source: str = described("source")
    print_differs: Sentence | None = described("what the paper prints instead", optional=True)
    note: str | None = described("note", optional=True)
    function: str = described("equation function that ran")
    formula_latex: str = described("formula, LaTeX")
    substituted_latex: str = described("formula with numbers, LaTeX")


class ExplainResult(Answer):
    """The steps of a calculation, each quantity before it is used."""

    explained: str = described("command explained", code=True)
    steps: list[Step] = described("steps of the calculation", steps=True)


def explain(command: str, spec: Spec, model: StressRule | None = None) -> tuple[ExplainResult, list[Finding]]:
    """Run a calculation and explain every equation it ran; the findings are those of the calculation.

    Raises:
        AfmcalcError: no such calculation.
    """
    if command not in EXPLAINED:
        hint = did_you_mean(command, EXPLAINED)
        raise AfmcalcError(
            "explain: no calculation {command!r}{hint}; explained are {analyses}",
            command=command,
            hint=hint,
            analyses=", ".join(EXPLAINED),
        )
    calculation = ANALYSES[command].function
    with noted() as notes:
        _, findings = calculation(build(spec), **({"model": model} if model else {}))
    calls = in_order(distinct(CallReader().calls(notes)))
    return ExplainResult(explained=command, steps=[_step(call) for part in calls for call in part]), findings


def _step(call: Call) -> Step:
    formula = formula_text(call)
    differing = [say("{id} prints {printed} ({misprint})", **printed) for printed in misprints(call.equation.name)]
    return Step(
        symbol=call.result,
        symbol_latex=symbol_latex(call.result),
        name=call.equation.summary.partition(",")[0].rstrip("."),
        at=call.case.at,
        setting=call.case.setting,
        side=call.case.side or None,
        formula=formula.text(),
        substituted=formula.text_with_numbers(),
        value=float(call.value),
        unit=call.equation.result.unit,
        source=call.equation.source,
        print_differs=joined(differing, "; ") if differing else None,
        function=call.equation.name,
        formula_latex=formula.latex(),
        substituted_latex=formula.latex_with_numbers(),
    )


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


_SLOPE = "∂"
"""Slopes are no quantities of the clutch: they rank what it depends on (``explain`` has their steps)."""
_FEW = 4
"""Cases above which the numbers are put into one line, not into fractions."""
_OF_TANGENT = {
    "sin α": "sine of the wall angle, from its tangent",
    "cos α": "cosine of the wall angle, from its tangent",
}


def derivations(sections: Mapping[str, list[Call]]) -> dict[str, list[Derivation]]:
    """Return the derivations of each section, of the calls noted for it; what was shown is not shown again."""
    report = _Report()
    return {name: report.section(calls) for name, calls in sections.items()}


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

    def section(self, calls: list[Call]) -> list[Derivation]:
        new = {identity(call): call for call in distinct(calls) if not call.equation.result.symbol.startswith(_SLOPE)}
        shown = [call for key, call in new.items() if key not in self.calls]
        self.calls |= new.keys()
        return [self.derivation(part) for part in in_order(shown)]

    def derivation(self, calls: list[Call]) -> Derivation:
        equation = calls[0].equation
        result, is_new = equation.result, equation.name not in self.numbers
        number = self.numbers.setdefault(equation.name, len(self.numbers) + 1)
        self.results.setdefault(result.symbol, (number, set()))[1].update(f"{call.value:.12g}" for call in calls)
        # which frictions the extremes are at differs from clutch to clutch
        texts = [formula_text(call, special=equation.name == "accuracy.accuracy_factor") for call in calls]
        differing = [say("{id}: {printed} ({misprint})", **printed) for printed in misprints(equation.name)]
        return Derivation(
            number=number,
            symbol=result.symbol,
            name=equation.about,
            unit=result.unit,
            symbol_latex=symbol_latex(result.symbol),
            formula=texts[0].latex() if is_new else "",
            where=list(self.meanings_of(calls)),
            rows=[
                CaseRow(call.case, text.latex_with_numbers(line=len(calls) > _FEW), float(call.value))
                for call, text in zip(calls, texts, strict=True)
            ],
            source=equation.source if is_new else "",
            differs=joined(differing if is_new else (), "; "),
        )

    def meanings_of(self, calls: list[Call]) -> Iterable[Meaning]:
        """Say what the symbols of a formula stand for, each meaning once in a report."""
        for call in calls:
            for name in call.arguments:
                if call.equation.arguments[name].symbol == "π":
                    continue
                meaning = self.meaning(call, name)
                # what a spec gives is one thing, whatever words a formula has for it
                given = meaning.number is None and meaning.symbol in _keys()
                key = meaning._replace(text="") if given else meaning
                if key in self.meanings:
                    continue
                self.meanings.add(key)
                if meaning.source and (meaning.symbol, meaning.text) in self.texts:
                    meaning = meaning._replace(text="")  # κ, and for the way back κ₊ in its place
                self.texts.add((meaning.symbol, meaning.text))
                yield meaning

    def meaning(self, call: Call, name: str) -> Meaning:
        term = call.equation.arguments[name]
        if term.symbol in _OF_TANGENT:
            return Meaning(term.symbol, _OF_TANGENT[term.symbol], "1", number=self.results["tan α"][0])
        if name in call.marks:
            number = self.numbers.get(call.marks[name].origin)
        else:
            number, values = self.results.get(term.symbol, (None, set[str]()))
            number = number if f"{call.arguments[name]:.12g}" in values else None
        source = next((symbol for symbol, (count, _) in self.results.items() if count == number), term.symbol)
        text = term.meaning or ("" if number else _keys().get(term.symbol, ""))
        return Meaning(term.symbol, text, term.unit, source if source != term.symbol else "", number)


@cache
def _keys() -> dict[str, str]:
    """Symbol of a spec's key → what it is."""
    return {key.symbol: key.description.partition(";")[0] for key in keys().values() if key.symbol}
