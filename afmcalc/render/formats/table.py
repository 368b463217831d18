"""Tables for people: ruled and coloured in a terminal, plain aligned text in a pipe or a file."""

import io
import os
import shutil
import sys
from typing import TYPE_CHECKING

from ...messages import fitting, is_unicode, translate
from ...result import Output
from ..document import document
from ..layout import (
    TextTable,
    blocks,
    findings_lines,
    is_across,
    lead,
    may_turn,
    padded,
    step_lines,
    title,
    turned,
    unfolded,
)

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

_NARROWEST = 20
"""Columns below which nothing can be read."""
_DIGITS = 4
"""Of a width that there is."""
_SHORT = 12
"""Columns of a table up to this width are kept whole, others as wide as their longest word."""
_SENTENCE = 36
"""Width beyond which a column of values holds sentences, and is folded as text is."""
_GAP = 2
"""Characters between columns."""
_STYLES = {"error": "bold red", "warning": "yellow", "info": "cyan"}


def render(output: Output, terminal: bool) -> str:
    """Lay out tables and findings; a terminal has a width, rules and colours, a pipe has none of them."""
    laid_out = document(output.result)
    tables, steps = blocks(laid_out), step_lines(laid_out)
    if not is_unicode(sys.stdout):
        tables = [_spelled(block) for block in tables]
    text = _rich(output, tables, steps, terminal=terminal) if terminal or _width() else _plain(output, tables, steps)
    return "\n".join(line.rstrip() for line in text.splitlines()) + "\n"


def _spelled(block: TextTable) -> TextTable:
    """Spell what standard output lacks before anything is aligned."""
    encoding = sys.stdout.encoding or "ascii"
    header, *rows = ([fitting(cell, encoding) for cell in cells] for cells in (block.header, *block.rows))
    return block._replace(header=header, rows=rows)


def _width() -> int | None:
    """Return the width the user asked for by ``COLUMNS``, if any."""
    columns = os.environ.get("COLUMNS", "")
    if not columns.isdecimal() or len(columns) > _DIGITS or not int(columns):
        return None
    return max(int(columns), _NARROWEST)


def columns() -> int | None:
    """Columns that standard output has: those the user asked for, else the terminal's; None where nothing bounds it."""
    asked = _width()
    return shutil.get_terminal_size().columns if asked is None and sys.stdout.isatty() else asked


def _plain(output: Output, tables: list[TextTable], steps: list[str]) -> str:
    """Align columns by spaces, as wide as they are: nothing is cut or folded."""
    lines = [title(output), *filter(None, [lead(output)])]
    for block in map(padded, unfolded(tables)):
        columns = [*zip(_widths(block), block.numeric, strict=True)]
        lines += ["", *filter(None, (block.title, block.legend, block.meanings))]
        for row in (block.header, *block.rows):
            cells = zip(row, columns, strict=True)
            lines.append("  ".join(cell.rjust(width) if right else cell.ljust(width) for cell, (width, right) in cells))
    lines += steps
    if output.findings:
        lines += ["", *findings_lines(output.findings)]
    return "\n".join(lines)


def _widths(block: TextTable) -> list[int]:
    return [max(map(len, column)) for column in zip(block.header, *block.rows, strict=True)]


def _rich(output: Output, tables: list[TextTable], steps: list[str], *, terminal: bool) -> str:
    """Lay out within the width there is: folded rather than cut; rules and colours only in a terminal."""
    from rich.console import Console
    from rich.text import Text

    width = _width() or (shutil.get_terminal_size().columns if terminal else 80)
    text = io.StringIO()
    console = Console(
        file=text, force_terminal=terminal, no_color=None if terminal else True, width=width, highlight=False
    )
    console.print(Text(title(output), style="bold"))
    if judged := lead(output):
        console.print(Text(judged))
    for block in [part for whole in tables for part in _within(whole, width)]:
        console.print()
        if block.title:
            console.print(Text(block.title, style="italic"))
        for line in filter(None, (block.legend, block.meanings)):
            console.print(Text(line, style="dim"))
        wide = [each > _SENTENCE for each in _widths(block)]
        whole = padded(block._replace(numeric=[r and not w for r, w in zip(block.numeric, wide, strict=True)]))
        if _least_width(whole) <= width:
            console.print(_rich_table(whole, ruled=terminal and is_unicode(sys.stdout)))
        elif above := _texts_above(whole, width):
            _print_in_two(console, whole, above)
        else:
            _print_stacked(console, block)
    for line in steps:
        console.print(Text(line, style="" if line.startswith(" ") else "bold"))
    if output.findings:
        console.print()
        styles = {translate(level, "value"): style for level, style in _STYLES.items()}
        for line in findings_lines(output.findings):
            console.print(Text(line, style=styles[line.partition(":")[0]]))
    return text.getvalue()


def _within(block: TextTable, width: int) -> list[TextTable]:
    """Quantities as rows where columns do not fit."""
    across = is_across(block) or (_least_width(block) > width and may_turn(block))
    return (turned(block, width, _GAP) if across else []) or [block]


def _least_width(block: TextTable) -> int:
    """Width below which a table would have to cut."""
    kept = _kept_widths(block)
    return sum(kept) + _GAP * (len(kept) - 1)


def _kept_widths(block: TextTable) -> list[int]:
    """Widths that columns keep: of numbers, and of text that is short, all; of other text that of its longest word."""
    columns = zip(block.header, *block.rows, strict=True)
    words = [max(map(len, " ".join(column).split())) for column in columns]
    kept = zip(_widths(block), words, block.numeric, strict=True)
    return [width if right else min(width, max(word, _SHORT)) for width, word, right in kept]


def _texts_above(block: TextTable, width: int) -> list[int]:
    """Columns of text that have to stand above the rest of their row for it to fit, the widest first; none: no way."""
    widths = _widths(block)
    texts = sorted((at for at, right in enumerate(block.numeric) if not right), key=lambda at: -widths[at])
    for count in range(1, min(len(texts), len(widths) - 1) + 1):
        rest = [w for at, w in enumerate(widths) if at not in texts[:count]]
        if sum(rest) + _GAP * len(rest) <= width:
            return sorted(texts[:count])
    return []


def _print_in_two(console: "Console", block: TextTable, above: list[int]) -> None:
    """Print long texts of every row on a line of their own, the rest below them in columns: still one table."""
    from rich.text import Text

    columns = [(at, w, block.numeric[at]) for at, w in enumerate(_widths(block)) if at not in above]
    for row in (block.header, *block.rows):
        style = "bold" if row is block.header else ""
        console.print(Text(" · ".join(filter(None, (row[at] for at in above))), style=style))
        cells = (row[at].rjust(width) if right else row[at].ljust(width) for at, width, right in columns)
        console.print(Text("".join(" " * _GAP + cell for cell in cells), style=style), no_wrap=True)


def _print_stacked(console: "Console", block: TextTable) -> None:
    """Print every row as a list of its own: a table that is too wide is still whole."""
    from rich.table import Table
    from rich.text import Text

    for number, row in enumerate(block.rows):
        if number:
            console.print()
        table = Table(box=None, show_header=False, show_edge=False, pad_edge=False)
        table.add_column(no_wrap=True, style="bold")
        table.add_column(overflow="fold")
        for heading, cell in zip(block.header, row, strict=True):
            table.add_row(Text(heading), Text(cell))
        console.print(table)


def _rich_table(block: TextTable, *, ruled: bool) -> "Table":
    """Numbers, symbols and units are never folded, only text is; numbers come padded."""
    from rich import box
    from rich.table import Table
    from rich.text import Text

    table = Table(box=box.SIMPLE_HEAD if ruled else None, show_edge=False, header_style="bold")
    table.padding = (0, _GAP - ruled, 0, 0)  # a rule takes a column between two
    for heading, width, kept in zip(block.header, _widths(block), _kept_widths(block), strict=True):
        table.add_column(Text(heading), overflow="fold", no_wrap=width == kept, min_width=kept)
    for row in block.rows:
        table.add_row(*map(Text, row))
    return table
