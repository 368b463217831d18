"""The table format where there is a width to fit: rich tables, folded rather than cut."""

import io

from rich import box
from rich.console import Console
from rich.table import Table
from rich.text import Text

from ..analysis.result import Output
from .layout import Block, findings_lines, title
from .table import curve_lines

_STYLES = {"error": "bold red", "warning": "yellow", "info": "cyan"}


def render_rich(output: Output, found: list[Block], *, width: int | None, terminal: bool, unicode: bool) -> str:
    """Lay out within ``width`` (None: the terminal's); rules and colours only in a terminal."""
    buffer = io.StringIO()
    if terminal:
        import shutil

        width = width or shutil.get_terminal_size().columns
    console = Console(
        file=buffer, force_terminal=terminal, no_color=None if terminal else True, width=width, highlight=False
    )
    console.print(Text(title(output), style="bold"))
    for block in found:
        console.print()
        if block.title:
            console.print(Text(block.title, style="italic"))
        console.print(_table(block, ruled=terminal and unicode))
        for line in curve_lines(block, unicode):
            console.print(Text(line), no_wrap=True, crop=True)
    if output.findings:
        console.print()
        for line in findings_lines(output.findings):
            console.print(Text(line, style=_STYLES[line.partition(":")[0]]))
    return buffer.getvalue()


def _table(block: Block, *, ruled: bool) -> Table:
    table = Table(box=box.SIMPLE_HEAD if ruled else None, pad_edge=False, header_style="bold", padding=(0, 2, 0, 0))
    for heading, right in zip(block.header, block.numeric, strict=True):
        table.add_column(Text(heading), justify="right" if right else "left", overflow="fold")
    for row in block.rows:
        table.add_row(*(Text(cell) for cell in row))
    return table
