"""The calculations of a report: derivations as blocks of MathML."""

import re
from collections.abc import Sequence
from functools import cache
from typing import NamedTuple
from xml.etree import ElementTree

from latex2mathml.converter import convert
from markupsafe import Markup

from ...analysis.explain.derivation import CaseRow, Derivation, Meaning
from ...messages import localized, spoken, translate
from ...units import typeset
from ..symbols import value_latex
from ..units import in_numbers, measured
from .words import told


class Derived(NamedTuple):
    """One quantity as an engineer writes it."""

    step: Derivation
    """Whose symbols are explained in the language of the user."""
    formula: str
    """MathML, with the numbers where there is but one short line of them; empty where an earlier block has it."""
    header: Sequence[str]
    """Of the labels, where a line has several."""
    lines: Sequence[tuple[Sequence[str], str, str]]
    """Of each case: its labels, the numbers put in as MathML, the value."""


_SHORT = 64
"""Signs that formula and numbers may have together to stand in one line."""


def block_of(step: Derivation, method: str) -> Derived:
    """Lay out a derivation; what ``method`` says, how the spec sets its spring, need not be said of each line."""
    columns = [(name, _labels(step.rows, name, method)) for name in ("friction", "branch", "setting", "side")]
    columns = [(name, labels) for name, labels in columns if any(labels)]
    symbol, first = step.symbol_latex, step.rows[0]
    joined = not columns and len(step.rows) == 1 and _size(step.formula) + _size(first.numbers) <= _SHORT
    # a formula may say no more than its symbol, and a number be its own value
    parts = [symbol, *([step.formula] if step.formula not in ("", symbol) else [])]
    if joined:
        parts += dict.fromkeys((first.numbers, value_latex(measured(first.value, step.unit))))
    lines = [
        (labels, _math(f"{symbol} = {_broken(row.numbers)}"), measured(row.value, step.unit))
        for row, *labels in zip(step.rows, *(labels for _, labels in columns), strict=True)
    ]
    return Derived(
        step=step._replace(where=[meaning._replace(text=_explained(meaning)) for meaning in step.where]),
        formula=_math(" = ".join(parts)) if len(parts) > 1 else "",
        header=[told(name) for name, _ in columns] if len(columns) > 1 else [],
        lines=[] if joined else lines,
    )


def _labels(rows: Sequence[CaseRow], name: str, method: str) -> list[str]:
    """One column of labels; empty where it would say of each line what goes without saying."""
    cases = [row.case for row in rows]
    if name == "friction":
        return [in_numbers(case.friction or "") for case in cases]
    if name == "side":
        return [told(f"side/{case.side}") if case.side else "" for case in cases]
    if name == "branch":
        usual = told("branch/")
        labels = [told(f"branch/{case.branch}", after=case.after) for case in cases]
    else:
        usual = told(f"setting/{method}")
        labels = [told(f"setting/{case.setting or method}") for case in cases]
    return [""] * len(rows) if set(labels) == {usual} else labels


def _explained(meaning: Meaning) -> str:
    unit = translate(typeset(meaning.unit), "unit")
    return ", ".join(filter(None, (translate(meaning.text), unit))) if meaning.text else ""


def _size(latex: str) -> int:
    """How many signs a formula sets, about."""
    return len(re.sub(r"\\(?:text|left|right|frac|cdot)|[{}\\_^ ]", "", latex))


def _broken(latex: str) -> str:
    """Set a sum or product that is too long in several lines: MathML breaks none, and paper does not scroll."""
    if _size(latex) <= _SHORT:
        return latex
    depth, summands = 0, [""]
    for part in _PARTS.split(latex):
        depth += (part in _OPENING) - (part in _CLOSING)
        long = part == _TIMES and _size(summands[-1]) > _SHORT / 3
        if depth == 0 and (part in _SIGNS or long) and summands[-1].strip():
            summands.append("")
        summands[-1] += part
    return r"\begin{array}{l} " + r" \\ ".join(summands) + r" \end{array}" if len(summands) > 1 else latex


_OPENING, _CLOSING, _SIGNS = ("{", "(", "["), ("}", ")", "]"), (" + ", " - ")
_TIMES = r" \cdot "
_PARTS = re.compile(r"([{}()\[\]]| [+-] | \\cdot )")


@cache
def _mathml(latex: str) -> str:
    # a prime is raised already, and MathML leaves no room round the name of a function
    latex = _PRIME.sub(r"\\text{′}", _FUNCTION.sub(r"\\,\\\1\\,", latex))
    # read and written anew, for the converter writes entities and leaves < as it is
    return ElementTree.tostring(ElementTree.fromstring(convert(latex, xmlns="", display="block")), encoding="unicode")


_FUNCTION = re.compile(r"\\(sin|cos|tan|ln) ")
_PRIME = re.compile(r"\^\{\\prime\}(?!_)")


def _math(latex: str) -> Markup:
    """Set LaTeX in the numbers and units of the user's language."""
    text = _mathml(latex.replace("{,}", "."))
    if spoken() != "en":
        text = _NUMERAL.sub(lambda match: f"<mn>{localized(match[1])}</mn>", text)
        text = _UNIT.sub(lambda match: f"{match[1]}<mtext>{translate(match[2], 'unit')}</mtext>", text)
    return Markup(text)  # noqa: S704 formulas of ours with numbers put in


_NUMERAL, _UNIT = re.compile("<mn>([^<]*)</mn>"), re.compile("(<mspace [^>]*>)<mtext>([^<]*)</mtext>")
