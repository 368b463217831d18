"""Content of the handbook: its chapters, the texts of every formula, and the numbers of examples.

A chapter is a Markdown file of ``afmcalc/papers/handbook``, in Russian the file of the same name in its folder ``ru``.
A paragraph in braces is replaced by the program: ``{equation direct.torque}``, ``{misprint M1}``, ``{figure F11-1}``,
``{list notation}``. In a sentence ``{see direct.torque}`` is the number of a formula, a chapter, a paper or a misprint
with a link to it, and ``{value default accuracy.accuracy_factor}`` a number that a command gives for an example. Fenced
lines are steps of a derivation, with ``sh`` command lines; ``{plot torque default}`` is a plot of an example.
"""

import re
import tomllib
from functools import cache
from typing import Any, NamedTuple

from ..engines import build
from ..engines.quantities import NotedStep
from ..equations.catalogue import Equation, equation_of, equations
from ..formula_tree import Tree
from ..papers.claims import Row, claims
from ..papers.handbook_text import HANDBOOK, chapter_texts
from ..papers.register import Formula, register
from ..result import shown_as
from ..spec import read_spec
from .asking import Answers
from .explain.explain import noting, shown, steps_of
from .explain.formula import FormulaText
from .plot_data import Request, gathered
from .registry import ANALYSES, EXPLAINED

_EXAMPLES = ("default", "unlike-materials", "indirect", "drive", "constant-torque", "machine-clutch")
"""Examples whose numbers are put into formulas: for each formula the first example that calculates it."""


class Entry(NamedTuple):
    """A formula with its numbers, places, proofs and commands."""

    equation: Equation
    formula: Tree
    example: str
    """Example whose numbers are put into the formula; empty if no explained command calculates the formula."""
    worked: Tree
    """Formula with the numbers of the example; empty without an example."""
    value: float
    printed: list[Formula]
    """Places in the papers where the formula is printed."""
    proofs: list[str]
    """Tests that prove the formula, if it is one of the papers."""
    commands: list[str]
    """Commands that calculate the formula."""


class Handbook(NamedTuple):
    """Everything that the handbook shows."""

    chapters: dict[int, str]
    """Markdown of every chapter by its number."""
    formulas: dict[str, Entry]
    """Name of an equation function → its entry."""
    values: dict[str, tuple[Any, str]]
    """Text in ``{value …}`` → the number, SI, and its unit."""
    plots: dict[str, Any]
    """Text in ``{plot …}`` → data of the plot."""
    claims: list[Row]


def handbook(language: str) -> Handbook:
    """Gather the handbook in a language: every formula, and every number that its chapters ask for."""
    chapters = chapter_texts(language)
    names, values, plots = (
        re.findall(rf"\{{{kind} ([^{{}}]+)\}}", "".join(chapters.values())) for kind in ("equation", "value", "plot")
    )
    return Handbook(
        chapters, {name: _entry(equations()[name]) for name in names}, {path: _value(*path.split()) for path in values},
        {each: gathered(each.split()[0], Request([_answers(each.split()[1])])) for each in plots}, claims([])[0].rows,
    )  # fmt: skip


@cache
def _answers(example: str) -> Answers:
    return Answers(build(read_spec(f"example:{example}")))


def _value(example: str, path: str) -> tuple[Any, str]:
    """Return a number that a command gives for an example, and its unit: ``_value("default", "torque.scatter")``."""
    command, *names = path.split(".")
    value, unit = _answers(example).ask(command)[0], ""
    for name in names:
        unit = shown_as(type(value).model_fields[name]).unit or unit
        value = getattr(value, name)
    return value, unit


@cache
def _steps() -> dict[str, list[tuple[str, str, NotedStep]]]:
    """Name of an equation → example and explained command that calculate it, and the first such step, for each pair."""
    found: dict[str, dict[tuple[str, str], NotedStep]] = {}
    for example in _EXAMPLES:
        quiet = _answers(example)
        for command in EXPLAINED:
            if ANALYSES[command].applies(quiet.clutch):
                clutch = noting(quiet.clutch.spec)
                Answers(clutch, quiet=quiet).ask(command)
                for step in shown(steps_of(clutch)):
                    found.setdefault(equation_of(step.name, step.law).name, {}).setdefault((example, command), step)
    return {name: [(*where, step) for where, step in steps.items()] for name, steps in found.items()}


def _entry(equation: Equation) -> Entry:
    steps = _steps().get(equation.name, [])
    example, _, step = steps[0] if steps else ("", "", None)
    terms = {key: (term.symbol, term.unit) for key, term in equation.arguments.items()}
    text = FormulaText(equation.function, terms, step.values if step else dict.fromkeys(terms, 1.0))
    printed = [entry for entry in register() if entry.function == equation.name]
    return Entry(
        equation=equation, formula=text.tree, example=example,
        worked=text.with_numbers() if step else (), value=float(step.value) if step else 0.0,
        printed=printed, proofs=list(dict.fromkeys(entry.proof for entry in printed if entry.proof)),
        commands=commands_of(equation.name),
    )  # fmt: skip


def commands_of(name: str) -> list[str]:
    """Commands that calculate an equation: they note it as a step in an example, or are listed in ``uses.toml``."""
    further: dict[str, list[str]] = tomllib.loads(HANDBOOK.joinpath("uses.toml").read_text(encoding="utf-8"))
    return sorted({command for _, command, _ in _steps().get(name, [])}.union(further.get(name, ())))
