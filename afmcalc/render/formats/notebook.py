"""HTML for a notebook: a fragment of a page, of the same blocks as a report."""

from ...messages import printable
from ...result import Output
from ..document import document
from ..report.blocks import Block, Code, Heading, Paragraph, text
from ..report.html import fragment
from ..report.page import findings_of, quantities
from ..report.pieces import said
from ..text_tables import lead, ranked, step_lines, title, unfolded


def render(output: Output, terminal: bool) -> str:
    """Write tables in the engineer's units and the findings as a list."""
    laid_out = document(output.result)
    parts: list[Block] = [Heading(4, text(title(output)))]
    parts += [Paragraph(said(line)) for line in lead(output).splitlines()]
    for block in unfolded(laid_out):
        parts += [Paragraph(said(line), "note") for line in block.notes]
        parts.append(quantities(block))
    parts += [Code(printable("\n".join(step_lines(laid_out)), lines=True))] if laid_out.steps else []
    return fragment([*parts, findings_of(ranked(output.findings), keys=True)]) + "\n"
