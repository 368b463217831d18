"""HTML: the tables of the terminal as a fragment, for a notebook."""

from collections.abc import Iterable, Sequence
from html import escape

from ...result import Output
from ..document import document
from ..layout import blocks, findings_lines, step_lines, title, unfolded


def render(output: Output, terminal: bool) -> str:
    """Write tables in the engineer's units and the findings as a list."""
    laid_out = document(output.result)
    parts = [f"<h4>{escape(title(output))}</h4>"]
    for block in unfolded(blocks(laid_out)):
        parts += [f"<h5>{escape(block.title)}</h5>"] if block.title else []
        parts += [f"<p>{escape(block.legend)}</p>"] if block.legend else []
        parts.append(_table(block.header, block.rows, block.numeric))
    if laid_out.steps:
        parts.append(f"<pre>{escape(chr(10).join(step_lines(laid_out)))}</pre>")
    if remarks := findings_lines(output.findings):
        parts.append("<ul>" + "".join(f"<li>{escape(line)}</li>" for line in remarks) + "</ul>")
    return "\n".join(parts) + "\n"


def _table(header: Sequence[str], rows: Sequence[Sequence[str]], numeric: Sequence[bool]) -> str:
    def row(tag: str, cells: Iterable[str]) -> str:
        each = zip(cells, numeric, strict=True)
        return "".join(
            f'<{tag} style="text-align:{"right" if right else "left"}">{escape(cell)}</{tag}>' for cell, right in each
        )

    body = "".join(f"<tr>{row('td', cells)}</tr>" for cells in rows)
    return f"<table><thead><tr>{row('th', header)}</tr></thead><tbody>{body}</tbody></table>"
