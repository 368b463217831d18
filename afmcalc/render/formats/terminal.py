"""The table format where there is a width to fit: rich tables, folded rather than cut."""

import io

from rich import box
from rich.console import Console, Group
from rich.table import Table
from rich.text import Text

from ...messages import translate
from ...result import Output
from ..layout import SweepDrawing, TextTable, findings_lines, is_across, may_turn, padded, title, turned

_SHORT = 12
"""Columns up to this width are kept whole."""
_GAP = 3
"""Characters between columns, with rules."""
_STYLES = {"error": "bold red", "warning": "yellow", "info": "cyan"}


def render_rich(
    output: Output,
    found: list[TextTable],
    steps: list[str],
    curve: SweepDrawing,
    *,
    width: int | None,
    terminal: bool,
    unicode: bool,
) -> str:
    """Lay out within ``width`` (None: the terminal's); rules and colours only in a terminal."""
    buffer = io.StringIO()
    if terminal:
        import shutil

        width = width or shutil.get_terminal_size().columns
    width = width or 80
    console = Console(
        file=buffer, force_terminal=terminal, no_color=None if terminal else True, width=width, highlight=False
    )
    console.print(Text(title(output), style="bold"))
    for block in [part for each in found for part in _fitted(each, width)]:
        console.print()
        if block.title:
            console.print(Text(block.title, style="italic"))
        if block.legend:
            console.print(Text(block.legend, style="dim"))
        fits = _least_width(block) <= width
        console.print(_table(padded(block), ruled=terminal and unicode) if fits else _stacked(block))
        for line in curve(block, unicode, width):
            console.print(Text(line), no_wrap=True, crop=True)
    for line in steps:
        console.print(Text(line, style="" if line.startswith(" ") else "bold"))
    if output.findings:
        console.print()
        styles = {translate(level, "value"): style for level, style in _STYLES.items()}
        for line in findings_lines(output.findings):
            console.print(Text(line, style=styles[line.partition(":")[0]]))
    return buffer.getvalue()


def _fitted(block: TextTable, width: int) -> list[TextTable]:
    """Quantities as rows where columns do not fit."""
    across = is_across(block) or (_least_width(block) > width and may_turn(block))
    return (turned(block, width, _GAP) if across else []) or [block]


def _least_width(block: TextTable) -> int:
    """Width below which a table would have to cut."""
    widest = [max(map(len, cells)) for cells in zip(block.header, *block.rows, strict=True)]
    kept = [w if right else min(w, _SHORT) for w, right in zip(widest, block.numeric, strict=True)]
    return sum(kept) + _GAP * (len(kept) - 1)


def _stacked(block: TextTable) -> Group:
    """Set every row as a list of its own: a table that is too wide is still whole."""
    lists: list[Table | Text] = []
    for row in block.rows:
        table = Table(box=None, show_header=False, show_edge=False, pad_edge=False)
        table.add_column(no_wrap=True, style="bold")
        table.add_column(overflow="fold")
        for heading, cell in zip(block.header, row, strict=True):
            table.add_row(Text(heading), Text(cell))
        lists += [table, Text("")]
    return Group(*lists[:-1])


def _table(block: TextTable, *, ruled: bool) -> Table:
    """Numbers, symbols and units are never folded, only text is; numbers come padded."""
    table = Table(box=box.SIMPLE_HEAD if ruled else None, show_edge=False, pad_edge=False, header_style="bold")
    widest = [max(map(len, cells)) for cells in zip(block.header, *block.rows, strict=True)]
    for heading, right, width in zip(block.header, block.numeric, widest, strict=True):
        whole = right or width <= _SHORT
        table.add_column(
            Text(heading),
            overflow="fold",
            no_wrap=whole,
            min_width=width if whole else _SHORT,
        )
    for row in block.rows:
        table.add_row(*(Text(cell) for cell in row))
    return table
