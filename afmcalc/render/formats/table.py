"""Tables for people by the library rich: with rules and colours in a terminal, without them in a pipe or a file."""

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
from ..text_tables import TextTable, findings_lines, lead, padded, step_lines, title, unfolded

_NARROWEST, _UNBOUND = 20, 100_000
"""Smallest width of an output, and width without a limit, characters."""
_SHORT, _GAP = 12, 2
"""Width up to which a column of text is never folded; gap between columns; both in characters."""
_SENTENCE = 36
"""Width beyond which a column of values holds sentences and is therefore folded as text."""
_STYLES = {"error": "bold red", "warning": "yellow", "info": "cyan"}


def render(output: Output, terminal: bool) -> str:
    """Tables and findings as text; a table wider than the terminal is folded or split."""
    laid_out, width = document(output.result), columns(terminal)
    text = io.StringIO()
    plain = None if terminal else True
    console = Console(file=text, force_terminal=terminal, no_color=plain, width=width, height=1, highlight=False)

    def show(*lines: str, style: str = "") -> None:
        for line in lines:
            console.print(Text(line, style=style))

    verdict = lead(output).splitlines()
    last = output.command == "check"  # the verdict of a check is printed last, where it stays on the screen
    show(title(output), style="bold")
    show(*([] if last else verdict))
    for block in unfolded(laid_out):
        show("")
        show(*filter(None, (block.title,)), style="italic")
        show(*block.notes, style="dim")
        numeric = [right and most <= _SENTENCE for right, most in zip(block.numeric, _widths(block), strict=True)]
        for number, part in enumerate(_parts(padded(block._replace(numeric=numeric)), width)):
            show(*[""] * bool(number))
            console.print(_table(part, width, ruled=terminal and is_unicode(sys.stdout)))
    for line in step_lines(laid_out):
        show(line, style="" if line.startswith(" ") else "bold")
    styles = {translate(level, "value"): style for level, style in _STYLES.items()}
    remarks = findings_lines(output.findings)
    show(*[""] * bool(remarks))
    for line in remarks:
        show(line, style=styles[line.partition(":")[0]])
    show(*(["", *verdict] if last else []))
    return "\n".join(line.rstrip() for line in text.getvalue().splitlines()) + "\n"


def columns(terminal: bool) -> int:
    """Width in characters: value of the variable COLUMNS, else width of the terminal; a pipe has no limit."""
    asked = os.environ.get("COLUMNS", "")
    if asked.isdecimal() and (wanted := int(asked[:9])):  # nine digits exceed any real width
        return min(max(wanted, _NARROWEST), _UNBOUND)
    return shutil.get_terminal_size().columns if terminal else _UNBOUND


def _widths(block: TextTable) -> list[int]:
    return [max(map(len, column)) for column in zip(block.header, *block.rows, strict=True)]


def _kept(block: TextTable) -> list[int]:
    """Smallest widths of columns: full width for numbers and short text, the longest word for other text."""
    cells = zip(block.header, *block.rows, strict=True)
    words = [max(map(len, " ".join(column).split()), default=0) for column in cells]
    kept = zip(_widths(block), words, block.numeric, strict=True)
    return [width if right else min(width, max(word, _SHORT)) for width, word, right in kept]


def _parts(block: TextTable, width: int) -> Iterator[TextTable]:
    """Yield parts of a table that fit the width; each part repeats the first column that is filled in every row."""
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
    """Table as an object of the library rich; if the smallest widths fit, only long text is folded."""
    kept = _kept(block)
    fits = sum(kept) + _GAP * (len(kept) - 1) <= width
    table = Table(box=box.SIMPLE_HEAD if ruled else None, show_edge=False, header_style="bold")
    table.padding = (0, _GAP - ruled, 0, 0)  # a rule between two columns takes one character
    for heading, most, least in zip(block.header, _widths(block), kept, strict=True):
        table.add_column(Text(heading), overflow="fold", no_wrap=fits and most == least, min_width=least * fits)
    for row in block.rows:
        table.add_row(*map(Text, row))
    return table
