"""A calculation as an engineer writes it: formula, numbers put in, value, source, and where the print differs."""

from typing import Any

from ...engines import build
from ...engines.protocol import Clutch
from ...errors import AfmcalcError
from ...extras import need
from ...findings import Finding
from ...papers.register import register
from ...result import Result, quantity
from ...spec import Spec
from ...spec.suggest import did_you_mean
from ..registry import ANALYSES, EXPLAINED
from .trace import Call, distinct, recording


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
    if command not in EXPLAINED:
        hint = did_you_mean(command, EXPLAINED)
        raise AfmcalcError(f"explain: no calculation {command!r}{hint}; explained are {', '.join(EXPLAINED)}")
    need("explain")
    calculation = ANALYSES[command].function
    with recording() as calls:
        clutch = build(spec)
        _, findings = calculation(clutch, **options)
    return ExplainResult(explained=command, steps=steps(clutch, calls)), findings


def steps(clutch: Clutch, calls: list[Call]) -> list[Step]:
    """Return the steps of what was recorded of a clutch."""
    names = _Names(clutch, calls)
    return [_step(call, names) for call in distinct(calls) if _is_new(call)]


def _is_new(call: Call) -> bool:
    """Leave out the trial calls that engines make with unit spring force while the spring is being set."""
    return 1.0 not in (call.arguments.get("closing_force"), call.arguments.get("normal_force"))


class _Names:
    """Symbols for values: which of the frictions a number is, which result (κ or κ₊) it came from."""

    def __init__(self, clutch: Clutch, calls: list[Call]) -> None:
        first, second = clutch.friction
        self.unlike = clutch.spec.friction.unlike
        self.returning = {call.value for call in calls if call.equation.name == "indirect.net_gain_returning"}
        self.frictions: dict[str, dict[float, str]] = {"": {}, "1": {}, "2": {}}
        for group, own in (("", first), ("1", first), ("2", second)):
            for end, suffix in (("max", "max"), ("mean", "cp"), ("min", "min")):
                self.frictions[group][float(getattr(own, end))] = suffix

    def symbol(self, symbol: str, value: Any) -> str:
        """Symbol of an argument; a coefficient of friction gets the end of the range it is."""
        if symbol == "κ" and value in self.returning:
            return "κ₊"
        if symbol in ("f", "f_1", "f_2", "f_i"):
            group = symbol[2:] if symbol in ("f_1", "f_2") else ""
            suffix = self.frictions[group].get(float(value))
            if suffix:
                return f"f_{group}{suffix}"
        return symbol

    def at(self, call: Call) -> str | None:
        """Which friction a call is for."""
        pair = [
            self.symbol(call.equation.arguments[name].symbol, call.arguments[name])
            for name in ("friction_driving", "friction_driven")
            if name in call.arguments
        ]
        if len(pair) == 2 and pair[0][3:] != pair[1][3:]:
            return ", ".join(pair)
        for name in ("friction", "friction_driven", "friction_driving"):
            if name in call.arguments:
                term = call.equation.arguments[name]
                named = self.symbol(term.symbol, call.arguments[name])
                if named == term.symbol:
                    return f"{term.symbol} = {call.arguments[name]:g}"
                return named if self.unlike else "f_" + named.lstrip("f_12")
        return None


def _note(call: Call) -> str | None:
    """Say what is done with a value before it is shown as a result."""
    if call.equation.name == "accuracy.accuracy_factor" and call.value < 1:
        return f"the torque falls along the path: largest over smallest is the inverse, {1 / call.value:.5g}"
    return None


def _step(call: Call, names: _Names) -> Step:
    from .formula import Formula, symbol_latex

    terms = call.equation.arguments
    symbols = {name: names.symbol(terms[name].symbol, value) for name, value in call.arguments.items()}
    units = {name: terms[name].unit for name in call.arguments}
    formula = Formula(call.equation.function, symbols, call.arguments, units)
    result = call.equation.result
    mended = [entry for entry in register() if entry.function == call.equation.name and entry.status == "mended"]
    return Step(
        symbol=result.symbol,
        symbol_latex=symbol_latex(result.symbol),
        name=call.equation.summary.partition(",")[0].rstrip("."),
        at=names.at(call),
        formula=formula.text(),
        substituted=formula.text_with_numbers(),
        value=call.value,
        unit=result.unit,
        source=call.equation.source,
        note=_note(call),
        print_differs="; ".join(f"{e.id} prints {e.printed} ({e.misprint})" for e in mended if e.printed) or None,
        function=call.equation.name,
        formula_latex=formula.latex(),
        substituted_latex=formula.latex_with_numbers(),
    )
