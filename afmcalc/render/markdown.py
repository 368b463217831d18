"""Markdown: the tables of the terminal as pipe tables."""

import re
from collections.abc import Sequence

from ..analysis.result import Output
from .document import document
from .layout import blocks, findings_lines, title


def render(output: Output, terminal: bool) -> str:
    """Write tables in the engineer's units and the findings as a list."""
    lines = [f"## {_escape(title(output))}", ""]
    for block in blocks(document(output.result)):
        if block.title:
            lines += [f"### {_escape(block.title)}", ""]
        lines += _table(block.header, block.rows, block.numeric)
        lines.append("")
    remarks = findings_lines(output.findings)
    if remarks:
        lines += ["### Findings", "", *(f"- {_escape(line)}" for line in remarks), ""]
    return "\n".join(lines)


def _table(header: Sequence[str], rows: Sequence[Sequence[str]], numeric: Sequence[bool]) -> list[str]:
    rule = ["---:" if right else "---" for right in numeric]
    return ["| " + " | ".join(map(_escape, line)) + " |" for line in (header, rule, *rows)]


def _escape(text: str) -> str:
    """Keep what a spec may carry (its name) from being read as markup."""
    return " ".join(_MARKUP.sub(r"\\\g<0>", text).split())


_MARKUP = re.compile(r"[\\|<>*`\[\]]|(?<!\w)_|_(?!\w)")
"""Signs Markdown reads as markup; an underscore only at the edge of a word."""
