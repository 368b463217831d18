"""Tables for people: ruled and coloured in a terminal, plain aligned text in a pipe or a file."""

import os
import sys

from ...result import Output
from ..document import document
from ..layout import SweepDrawing, TextTable, blocks, findings_lines, padded, step_lines, title, unfolded
from .curve import curve_lines

_NARROWEST = 20
"""Columns below which nothing can be read."""
_DIGITS = 4
"""Of a width that there is."""


def render(output: Output, terminal: bool, curve: SweepDrawing | None = None) -> str:
    """Lay out tables, curves and findings; a terminal has a width, rules and colours, a pipe has none of them.

    ``curve`` draws under a sweep instead of the small curve of characters.
    """
    draw = curve or curve_lines
    laid_out = document(output.result)
    found, steps = blocks(laid_out), step_lines(laid_out)
    if not is_unicode():
        found = [_fitting(block) for block in found]
    if terminal or _width():
        from .terminal import render_rich

        look = {"terminal": terminal, "unicode": is_unicode()}
        text = render_rich(output, found, steps, draw, width=_width(), **look)
    else:
        text = _plain(output, found, steps, draw)
    return "\n".join(line.rstrip() for line in text.splitlines()) + "\n"


def _fitting(block: TextTable) -> TextTable:
    """Spell what standard output lacks before anything is aligned."""
    from ...spelling import fitting

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
    if (asked := _width()) is not None or not sys.stdout.isatty():
        return asked
    import shutil

    return shutil.get_terminal_size().columns


def is_unicode() -> bool:
    """Whether standard output shows more than ASCII."""
    return (getattr(sys.stdout, "encoding", "") or "").lower().replace("-", "").startswith("utf")


def _plain(output: Output, found: list[TextTable], steps: list[str], curve: SweepDrawing) -> str:
    """Align columns by spaces, as wide as they are: nothing is cut or folded."""
    lines = [title(output)]
    for block in unfolded(found):
        heading = [text for text in (block.title, block.legend) if text]
        lines += ["", *heading, *_aligned(block), *curve(block, is_unicode(), None)]
    lines += steps
    if output.findings:
        lines += ["", *findings_lines(output.findings)]
    return "\n".join(lines)


def _aligned(block: TextTable) -> list[str]:
    block = padded(block)
    lines = [block.header, *block.rows]
    widths = [max(map(len, cells)) for cells in zip(*lines, strict=True)]
    return [
        "  ".join(
            cell.rjust(width) if right else cell.ljust(width)
            for cell, width, right in zip(line, widths, block.numeric, strict=True)
        )
        for line in lines
    ]
