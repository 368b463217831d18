"""Markdown: the tables of the terminal as pipe tables."""

import re
from collections.abc import Sequence

from ...messages import printable, told, translate
from ...result import Output
from ..document import Document, document
from ..layout import blocks, findings_lines, step_value, title, told_apart, unfolded
from ..symbols import latex_in_numbers, value_latex
from ..units import in_numbers


def render(output: Output, terminal: bool) -> str:
    """Write tables in the engineer's units and the findings as a list."""
    lines = [f"## {_escape(title(output))}", ""]
    for block in unfolded(blocks(document(output.result))):
        if block.title:
            lines += [f"### {_escape(block.title)}", ""]
        if block.legend:
            lines += [_escape(block.legend), ""]
        lines += _table(block.header, block.rows, block.numeric)
        lines.append("")
    lines += _steps(document(output.result))
    remarks = findings_lines(output.findings)
    if remarks:
        lines += [f"### {translate('Findings')}", "", *(f"- {_escape(line)}" for line in remarks), ""]
    return "\n".join(lines)


def _steps(laid_out: Document) -> list[str]:
    """Steps of an explanation with their formulas in LaTeX."""
    if not laid_out.steps:
        return []
    lines = []
    for step in laid_out.steps:
        places = [*([in_numbers(translate(step.at))] if step.at else []), *told_apart(step, laid_out.steps)]
        at = f" ({_escape(', '.join(places))})" if places else ""
        equals = " = ".join(dict.fromkeys(map(latex_in_numbers, (step.formula_latex, step.substituted_latex))))
        lines += [f"### {_escape(step.symbol)}{at}: {_escape(translate(step.name))}", ""]
        lines += [
            f"$${step.symbol_latex} = {equals} = {value_latex(step_value(step))}$$",
            "",
            told("Source: {source}", source=_escape(translate(step.source))),
            "",
        ]
        if step.print_differs:
            lines += [told("*Print differs:* {what}", what=_escape(translate(step.print_differs))), ""]
    return lines


def _table(header: Sequence[str], rows: Sequence[Sequence[str]], numeric: Sequence[bool]) -> list[str]:
    rule = ["---:" if right else "---" for right in numeric]
    return ["| " + " | ".join(map(_escape, line)) + " |" for line in (header, rule, *rows)]


def _escape(text: str) -> str:
    """Keep what a spec may carry (its name) from being read as markup."""
    return " ".join(_MARKUP.sub(r"\\\g<0>", printable(text)).split())


_MARKUP = re.compile(r"[\\|<>*`\[\]]|(?<!\w)_|_(?!\w)")
"""Signs Markdown reads as markup; an underscore only at the edge of a word."""
