"""The calculations of a report: derivations as blocks of MathML."""

import re
from collections.abc import Sequence
from functools import cache
from typing import NamedTuple

from latex2mathml.converter import convert

from ...analysis.explain.derivation import CaseRow, Derivation, Meaning
from ...messages import localized, spoken, term, translate, with_unit
from ..symbols import value_latex
from ..units import display, display_unit, in_numbers
from .words import told


class Explained(NamedTuple):
    """What a symbol stands for, as a reader is told."""

    symbol: str
    text: str
    """In words, with its unit."""
    by: str
    """Where it comes from; empty where it is given."""
    number: int | None


class CaseLine(NamedTuple):
    """One case of a quantity."""

    labels: Sequence[str]
    numbers: str
    """MathML."""
    value: str


class Derived(NamedTuple):
    """One quantity as an engineer writes it."""

    number: int
    first: bool
    """Whether the formula is shown here; links lead here."""
    symbol: str
    name: str
    source: str
    formula: str
    """MathML, with the numbers where there is but one short line of them; empty where an earlier block has it."""
    where: Sequence[Explained]
    header: Sequence[str]
    """Of the labels, where a line has several."""
    lines: Sequence[CaseLine]
    notes: Sequence[str]


_SHORT = 64
"""Signs that formula and numbers may have together to stand in one line."""


def blocks_of(derivations: Sequence[Derivation], method: str) -> list[Derived]:
    """Lay out derivations.

    Args:
        derivations: what was calculated.
        method: how the spec sets its spring: what need not be said of each line.
    """
    return [_block(each, method) for each in derivations]


def _block(own: Derivation, method: str) -> Derived:
    columns = [_labels(own.rows, name, method) for name in ("friction", "branch", "setting", "side")]
    named = [(name, labels) for name, labels in columns if any(labels)]
    symbol, numbers = own.symbol_latex, own.rows[0].numbers
    joined = not named and len(own.rows) == 1 and _size(own.formula) + _size(numbers) <= _SHORT
    # a formula may say no more than its symbol, and a number be its own value
    parts = [symbol, *([own.formula] if own.formula not in ("", symbol) else [])]
    if joined:
        parts += dict.fromkeys((numbers, value_latex(_value(own.rows[0], own.unit))))
    lines = [
        CaseLine(
            [labels[index] for _, labels in named], _math(f"{symbol} = {_broken(row.numbers)}"), _value(row, own.unit)
        )
        for index, row in enumerate([] if joined else own.rows)
    ]
    notes = [told("differs", printed=term(own.differs))] if own.differs else []
    return Derived(
        number=own.number,
        first=bool(own.formula),
        symbol=own.symbol,
        name=translate(own.name),
        source=translate(own.source).rstrip("."),
        formula=_math(" = ".join(parts)) if len(parts) > 1 else "",
        where=[_explained(each) for each in own.where],
        header=[told(name) for name, _ in named] if len(named) > 1 else [],
        lines=lines,
        notes=notes,
    )


def _labels(rows: Sequence[CaseRow], name: str, method: str) -> tuple[str, list[str]]:
    """One column of labels; empty where it would say of each line what goes without saying."""
    found = {
        "friction": [in_numbers(row.case.friction or "") for row in rows],
        "branch": [told(f"branch/{row.case.branch}", **_after(row)) for row in rows],
        "setting": [told(f"setting/{row.case.setting or method}") for row in rows],
        "side": [told(f"side/{row.case.side}") if row.case.side else "" for row in rows],
    }[name]
    usual = {"branch": told("branch/"), "setting": told(f"setting/{method}")}.get(name)
    return name, [""] * len(rows) if set(found) == {usual} else found


def _after(row: CaseRow) -> dict[str, object]:
    return {"after": row.case.after} if row.case.branch == "held" else {}


def _explained(own: Meaning) -> Explained:
    unit = "" if own.unit == "1" else translate(own.unit.replace("*", "·").replace("^3", "³"), "unit")
    text = ", ".join(part for part in (translate(own.text) if own.text else "", unit if own.text else "") if part)
    if own.number is None:
        return Explained(own.symbol, text, "", None)
    by = told("is", source=own.source, number=own.number) if own.source else told("by", number=own.number)
    return Explained(own.symbol, text, by, own.number)


def _value(row: CaseRow, unit: str) -> str:
    return with_unit(display(row.value, unit), display_unit(unit))


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


def _math(latex: str) -> str:
    """Set LaTeX in the numbers and units of the user's language."""
    text = _mathml(latex.replace("{,}", "."))
    if spoken() == "en":
        return text
    text = _NUMERAL.sub(lambda found: f"<mn>{localized(found[1])}</mn>", text)
    return _UNIT.sub(lambda found: f"{found[1]}<mtext>{translate(found[2], 'unit')}</mtext>", text)


_NUMERAL, _UNIT = re.compile("<mn>([^<]*)</mn>"), re.compile("(<mspace [^>]*>)<mtext>([^<]*)</mtext>")


@cache
def _mathml(latex: str) -> str:
    # a prime is raised already, and MathML leaves no room round the name of a function
    latex = _PRIME.sub(r"\\text{′}", _FUNCTION.sub(r"\\,\\\1\\,", latex))
    return str(convert(latex, display="block"))


_FUNCTION = re.compile(r"\\(sin|cos|tan|ln) ")
_PRIME = re.compile(r"\^\{\\prime\}(?!_)")
