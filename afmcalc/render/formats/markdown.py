"""Markdown: the tables of the terminal in markup."""

import re

from ...formula_tree import latex, value_tree
from ...messages import native, printable, say, translate
from ...result import Output
from ..amounts import measured
from ..document import Document, document
from ..text_tables import blocks, findings_lines, lead, title, told_apart, unfolded


def render(output: Output, terminal: bool) -> str:
    """Write tables in the engineer's units and the findings as a list."""
    laid_out = document(output.result)
    lines = [f"## {_escape(title(output))}", ""]
    lines += [_escape(judged), ""] if (judged := lead(output)) else []
    for block in unfolded(blocks(laid_out)):
        lines += [f"### {_escape(block.title)}", ""] if block.title else []
        for line in filter(None, (block.legend, block.meanings)):
            lines += [_escape(line), ""]
        rule = ["---:" if right else "---" for right in block.numeric]
        lines += ["| " + " | ".join(map(_escape, row)) + " |" for row in (block.header, rule, *block.rows)]
        lines.append("")
    lines += _steps(laid_out)
    if remarks := findings_lines(output.findings):
        lines += [f"### {translate('Findings')}", "", *(f"- {_escape(line)}" for line in remarks), ""]
    return "\n".join(lines)


def _steps(laid_out: Document) -> list[str]:
    """Steps of an explanation with their formulas in LaTeX."""
    lines = []
    for step in laid_out.steps:
        places = [*([step.at] if step.at else []), *told_apart(step, laid_out.steps)]
        at = f" ({_escape(', '.join(places))})" if places else ""
        equals = " = ".join(dict.fromkeys((step.formula_latex, step.substituted_latex)))
        lines += [f"### {_escape(native(step.symbol))}{at}: {_escape(translate(step.name))}", ""]
        value = latex(value_tree(measured(step.value, step.unit)))
        lines += [f"$${step.symbol_latex} = {equals} = {value}$$", ""]
        lines += [say("Source: {source}", source=_escape(translate(step.source))), ""]
        if step.print_differs:
            lines += [say("*Print differs:* {what}", what=_escape(translate(step.print_differs))), ""]
    return lines


def _escape(text: str) -> str:
    """Keep what a spec may carry (its name) from being read as Markdown."""
    return " ".join(_MARKUP.sub(r"\\\g<0>", printable(text)).split())


_MARKUP = re.compile(r"[\\|<>*`\[\]]|(?<!\w)_|_(?!\w)")
"""Signs Markdown reads as markup; an underscore only at the edge of a word."""
