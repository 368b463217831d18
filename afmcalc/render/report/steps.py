"""The calculations of a report, explained: the steps of ``explain`` as MathML."""

from collections.abc import Sequence

from latex2mathml.converter import convert

from ...analysis.explain.explain import Step
from ..layout import step_value
from ..symbols import value_latex
from .interface import ExplainedStep


def explained(steps: Sequence[Step]) -> list[ExplainedStep]:
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
