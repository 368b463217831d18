"""Markdown: the tables of the terminal in markup."""

import re

from ...messages import printable, translate
from ...result import Output
from ..document import document
from ..text_tables import findings_lines, lead, step_lines, title, unfolded

_MARKUP = re.compile(r"[\\|<>*`\[\]]|(?<!\w)_|_(?!\w)")
"""Pattern of characters that are markup in Markdown; an underscore is markup only at the edge of a word."""


def render(output: Output, terminal: bool) -> str:
    """Write tables in the engineer's units and the findings as a list."""
    laid_out = document(output.result)
    lines = [f"## {_escape(title(output))}", ""]
    lines += [_escape(judged), ""] if (judged := lead(output)) else []
    for block in unfolded(laid_out):
        lines += [f"### {_escape(block.title)}", ""] if block.title else []
        for line in block.notes:
            lines += [_escape(line), ""]
        rule = ["---:" if right else "---" for right in block.numeric]
        lines += ["| " + " | ".join(map(_escape, row)) + " |" for row in (block.header, rule, *block.rows)]
        lines.append("")
    lines += ["```", *map(printable, step_lines(laid_out)[1:]), "```", ""] if laid_out.steps else []
    if remarks := findings_lines(output.findings):
        lines += [f"### {translate('Findings')}", "", *(f"- {_escape(line)}" for line in remarks), ""]
    return "\n".join(lines)


def _escape(text: str) -> str:
    """Text on one line, its markup characters escaped."""
    return " ".join(_MARKUP.sub(r"\\\g<0>", printable(text)).split())
