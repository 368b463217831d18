"""A calculation as an engineer writes it: formula, numbers put in, value, source, and where the print differs."""

from collections.abc import Callable
from typing import Any

from ...engines import build
from ...errors import AfmcalcError
from ...extras import need
from ...findings import Finding
from ...papers.register import register
from ...result import Result, quantity
from ...spec import Spec
from ...spec.suggest import did_you_mean
from .trace import Call, distinct, recording, with_roles


class Step(Result):
    """One quantity: what it is, its formula, the formula with numbers, its value."""

    symbol: str = quantity("", None, "symbol")
    symbol_latex: str = quantity("", None, "symbol, LaTeX")
    name: str = quantity("", None, "what it is")
    at: str | None = quantity("", None, "friction it is for", optional=True)
    formula: str = quantity("", None, "formula")
    substituted: str = quantity("", None, "formula with numbers and units")
    value: float = quantity("", None, "value, SI")
    unit: str = quantity("", None, "SI unit")
    source: str = quantity("", None, "source")
    print_differs: str | None = quantity("", None, "what the paper prints instead", optional=True)
    note: str | None = quantity("", None, "note", optional=True)
    function: str = quantity("", None, "equation function that ran")
    formula_latex: str = quantity("", None, "formula, LaTeX")
    substituted_latex: str = quantity("", None, "formula with numbers, LaTeX")


class ExplainResult(Result):
    """The steps of a calculation, in the order they ran."""

    explained: str = quantity("", None, "command explained")
    steps: list[Step] = quantity("", None, "steps of the calculation", steps=True)


def _analyses() -> dict[str, Callable[..., Any]]:
    from ..accuracy import accuracy
    from ..adjust import adjust
    from ..checks.check import check
    from ..life import life
    from ..overload import overload
    from ..synthesize import synthesize
    from ..torque import torque

    return {
        "torque": torque,
        "accuracy": accuracy,
        "adjust": adjust,
        "overload": overload,
        "synthesize": synthesize,
        "life": life,
        "check": check,
    }


def explain(command: str, spec: Spec, **options: Any) -> tuple[ExplainResult, list[Finding]]:
    """Run a calculation and explain every equation it ran.

    Args:
        command: torque, accuracy, adjust, overload, synthesize, life or check.
        spec: the clutch.
        options: options of the calculation, such as the ``model`` of life.

    Returns:
        The steps and the findings of the calculation itself.

    Raises:
        AfmcalcError: no such calculation, or the extra ``explain`` is missing.
    """
    analyses = _analyses()
    if command not in analyses:
        hint = did_you_mean(command, analyses)
        raise AfmcalcError(f"explain: no calculation {command!r}{hint}; explained are {', '.join(analyses)}")
    need("explain")
    with recording() as calls:
        _, findings = analyses[command](build(with_roles(spec)), **options)
    return ExplainResult(explained=command, steps=[_step(call) for call in distinct(calls)]), findings


def _note(call: Call) -> str | None:
    """Say what is done with a value before it is shown as a result."""
    if call.equation.name == "accuracy.accuracy_factor" and call.value < 1:
        return f"the torque falls along the path: largest over smallest is the inverse, {1 / call.value:.5g}"
    return None


def _step(call: Call) -> Step:
    from .formula import Formula, symbol_latex

    terms = call.equation.arguments
    symbols = {name: call.symbol(name) for name in call.arguments}
    units = {name: terms[name].unit for name in call.arguments}
    formula = Formula(call.equation.function, symbols, call.arguments, units)
    result = call.equation.result
    mended = [entry for entry in register() if entry.function == call.equation.name and entry.status == "mended"]
    return Step(
        symbol=result.symbol,
        symbol_latex=symbol_latex(result.symbol),
        name=call.equation.summary.partition(",")[0].rstrip("."),
        at=call.at,
        formula=formula.text(),
        substituted=formula.text_with_numbers(),
        value=float(call.value),
        unit=result.unit,
        source=call.equation.source,
        note=_note(call),
        print_differs="; ".join(f"{e.id} prints {e.printed} ({e.misprint})" for e in mended if e.printed) or None,
        function=call.equation.name,
        formula_latex=formula.latex(),
        substituted_latex=formula.latex_with_numbers(),
    )
