"""Tables for people by rich: ruled and coloured in a terminal, without both in a pipe or a file."""

import io
import os
import shutil
import sys
from collections.abc import Iterator

from rich import box
from rich.console import Console
from rich.table import Table
from rich.text import Text

from ...messages import is_unicode, translate
from ...result import Output
from ..document import document
from ..text_tables import TextTable, blocks, findings_lines, lead, padded, step_lines, title, unfolded

_NARROWEST, _UNBOUND = 20, 100_000
"""Columns below which nothing can be read, and where nothing bounds them."""
_SHORT, _GAP = 12, 2
"""Columns of a table up to this width are kept whole, others as wide as their longest word; characters between them."""
_SENTENCE = 36
"""Width beyond which a column of values holds sentences, and is folded as text is."""
_STYLES = {"error": "bold red", "warning": "yellow", "info": "cyan"}


def render(output: Output, terminal: bool) -> str:
    """Lay out tables and findings: what is wider than there is room for is folded or goes into a table of its own."""
    laid_out, width = document(output.result), columns(terminal)
    text = io.StringIO()
    plain = None if terminal else True
    console = Console(file=text, force_terminal=terminal, no_color=plain, width=width, height=1, highlight=False)
    lines = [(title(output), "bold"), *((line, "") for line in lead(output).splitlines())]
    _print(console, *lines)
    for block in unfolded(blocks(laid_out)):
        _print(console, ("", ""))
        _print(console, (block.title, "italic"), (block.legend, "dim"), (block.meanings, "dim"), filled=True)
        for number, part in enumerate(_parts(_aligned(block), width)):
            _print(console, *[("", "")] * bool(number))
            console.print(_table(part, width, ruled=terminal and is_unicode(sys.stdout)))
    _print(console, *((line, "" if line.startswith(" ") else "bold") for line in step_lines(laid_out)))
    styles = {translate(level, "value"): style for level, style in _STYLES.items()}
    for number, line in enumerate(findings_lines(output.findings)):
        _print(console, *[("", "")] * (not number), (line, styles[line.partition(":")[0]]))
    return "\n".join(line.rstrip() for line in text.getvalue().splitlines()) + "\n"


def _print(console: Console, *lines: tuple[str, str], filled: bool = False) -> None:
    """Print lines in their styles; ``filled``: but for those that are empty."""
    for line, style in lines:
        if line or not filled:
            console.print(Text(line, style=style))


def columns(terminal: bool) -> int:
    """Return the columns that the user asked for by ``COLUMNS``, else those of a terminal; a pipe has no bound."""
    asked = os.environ.get("COLUMNS", "")
    if asked.isdecimal() and (wanted := int(asked[:9])):  # so many digits are beyond any bound
        return min(max(wanted, _NARROWEST), _UNBOUND)
    return shutil.get_terminal_size().columns if terminal else _UNBOUND


def _aligned(block: TextTable) -> TextTable:
    """Set numbers with their points below each other."""
    numeric = [right and width <= _SENTENCE for right, width in zip(block.numeric, _widths(block), strict=True)]
    return padded(block._replace(numeric=numeric))


def _widths(block: TextTable) -> list[int]:
    return [max(map(len, column)) for column in zip(block.header, *block.rows, strict=True)]


def _kept(block: TextTable) -> list[int]:
    """Widths that columns keep: of numbers, and of text that is short, all; of other text that of its longest word."""
    cells = zip(block.header, *block.rows, strict=True)
    words = [max(map(len, " ".join(column).split()), default=0) for column in cells]
    kept = zip(_widths(block), words, block.numeric, strict=True)
    return [width if right else min(width, max(word, _SHORT)) for width, word, right in kept]


def _parts(block: TextTable, width: int) -> Iterator[TextTable]:
    """Yield tables of as many columns as there is room for, each with the first one that tells every row."""
    kept, groups = _kept(block), list[list[int]]([[]])
    key = next((at for at in range(len(kept)) if all(row[at] for row in block.rows)), 0)
    for at in range(len(kept)):
        if len(groups[-1]) > 1 and at > key and sum(kept[each] + _GAP for each in groups[-1]) + kept[at] > width:
            groups.append([key])
        groups[-1].append(at)
    for group in groups:
        rows = [[row[at] for at in group] for row in block.rows]
        yield TextTable("", [block.header[at] for at in group], rows, [block.numeric[at] for at in group])


def _table(block: TextTable, width: int, *, ruled: bool) -> Table:
    """Set cells in columns: where there is room numbers, symbols and units are whole, and only text is folded."""
    kept = _kept(block)
    fits = sum(kept) + _GAP * (len(kept) - 1) <= width
    table = Table(box=box.SIMPLE_HEAD if ruled else None, show_edge=False, header_style="bold")
    table.padding = (0, _GAP - ruled, 0, 0)  # a rule takes a column between two
    for heading, most, least in zip(block.header, _widths(block), kept, strict=True):
        table.add_column(Text(heading), overflow="fold", no_wrap=fits and most == least, min_width=least * fits)
    for row in block.rows:
        table.add_row(*map(Text, row))
    return table
