"""A calculation as an engineer writes it: formula, numbers put in, value, source, and where the print differs."""

from ...engines import build
from ...equations.calls import noted
from ...errors import AfmcalcError
from ...findings import Finding
from ...messages import did_you_mean, joined, say
from ...result import Answer, Result, Sentence, described
from ...spec import Spec
from ...spec.models import Method
from ..registry import ANALYSES, EXPLAINED, StressRule
from .formula import symbol_latex
from .trace import Call, CallReader, distinct, formula_text, in_order, misprints


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
