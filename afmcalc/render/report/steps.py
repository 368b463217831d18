"""The calculations of a report, explained: the steps of ``explain`` as MathML."""

from collections.abc import Mapping, Sequence

from latex2mathml.converter import convert

from ...analysis.explain.explain import Step, explain
from ...analysis.explain.formula import value_latex
from ...spec import Spec
from ..layout import step_value
from .interface import ExplainedStep


def explained(spec: Spec, calculations: Mapping[str, Mapping[str, str]]) -> dict[str, list[ExplainedStep]]:
    """Explain several calculations of one clutch, each step where it first occurs.

    Args:
        spec: the clutch.
        calculations: name of a calculation → its options.

    Returns:
        Calculation → its steps.
    """
    seen: set[tuple[str, str | None, float]] = set()
    found = {}
    for name, options in calculations.items():
        result, _ = explain(name, spec, **options)
        fresh = [step for step in result.steps if (step.function, step.at, step.value) not in seen]
        seen |= {(step.function, step.at, step.value) for step in fresh}
        found[name] = _steps(fresh)
    return found


def _steps(steps: Sequence[Step]) -> list[ExplainedStep]:
    """Show a formula where it first stands, then only its numbers for the other frictions."""
    found = []
    before = ""
    for step in steps:
        again, before = step.function == before, step.function
        title = (
            (f"at {step.at}" if step.at else "again") if again else step.name + (f" at {step.at}" if step.at else "")
        )
        numbers = f"= {step.substituted_latex}" if step.substituted != step.formula else ""
        found.append(
            ExplainedStep(
                title=title,
                symbol=step.symbol,
                formula="" if again else _math(f"{step.symbol_latex} = {step.formula_latex}"),
                numbers=_math(f"{step.symbol_latex} {numbers} = {value_latex(step_value(step))}"),
                source="" if again else step.source.rstrip("."),
                note="; ".join(part for part in (step.note, None if again else step.print_differs) if part),
            )
        )
    return found


def _math(latex: str) -> str:
    return str(convert(latex, display="block"))
