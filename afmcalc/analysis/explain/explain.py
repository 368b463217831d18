"""A calculation as an engineer writes it: formula, numbers put in, value, source, and where the print differs."""

from ...engines import build
from ...equations.calls import noted
from ...errors import AfmcalcError
from ...findings import Finding
from ...messages import did_you_mean, joined, say, term
from ...papers.register import Formula, register
from ...result import Answer, Result, Sentence, described
from ...spec import Spec
from ...spec.models import Method
from ..registry import ANALYSES, EXPLAINED, StressRule
from .formula import FormulaText, symbol_latex
from .trace import Call, CallReader, distinct, in_order


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

    explained: str = described("command explained")
    steps: list[Step] = described("steps of the calculation", steps=True)


def explain(command: str, spec: Spec, model: StressRule | None = None) -> tuple[ExplainResult, list[Finding]]:
    """Run a calculation and explain every equation it ran.

    Args:
        command: torque, accuracy, adjust, overload, synthesize, life or check.
        spec: the clutch.
        model: rule for the damaging stress, of life.

    Returns:
        The steps and the findings of the calculation itself.

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
    return ExplainResult(explained=command, steps=steps_of(CallReader().calls(notes))), findings


def steps_of(calls: list[Call]) -> list[Step]:
    """Return the steps of what was noted, each quantity before it is used."""
    return [_step(call) for part in in_order(distinct(calls)) for call in part]


def _printed(mended: list[Formula]) -> str | None:
    differing = [
        say("{id} prints {printed} ({misprint})", id=term(each.id), printed=term(each.printed), misprint=each.misprint)
        for each in mended
        if each.printed
    ]
    return joined(differing, "; ") if differing else None


def _step(call: Call) -> Step:
    terms = call.equation.arguments
    symbols = {name: call.symbol(name) for name in call.arguments}
    units = {name: terms[name].unit for name in call.arguments}
    formula = FormulaText(call.equation.function, symbols, call.arguments, units)
    result = call.equation.result
    mended = [entry for entry in register() if entry.function == call.equation.name and entry.status == "mended"]
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
        unit=result.unit,
        source=call.equation.source,
        print_differs=_printed(mended),
        function=call.equation.name,
        formula_latex=formula.latex(),
        substituted_latex=formula.latex_with_numbers(),
    )
