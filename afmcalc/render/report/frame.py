"""Frame and title block of a sheet of a text document, forms 2 and 2а, on the model of ГОСТ 2.104-2006.

Its clause 5.1 was read: text documents take these forms. The sizes are those in use; its figures were not at hand.
"""

import textwrap
from html import escape
from typing import NamedTuple
from urllib.parse import quote

from markupsafe import Markup

from ...messages import translate
from ...spec.models import TitleBlock

_CAPITAL, _LETTER, _LINE = 0.75, 0.6, 1.2
"""Width of a letter, at most about, and distance of lines, over the size of the text."""
_READ = 1.5
"""Smallest size of text that can be read, mm."""
_BOTTOM = 292


class _Cell(NamedTuple):
    """A box and what it says, mm from the upper left corner of the sheet."""

    left: float
    top: float
    wide: float
    high: float
    text: str | None = None
    size: float = 2.8

    def svg(self) -> str:
        """Draw it: its text turned where it is high."""
        drawn = f'<path fill="none" d="M{self.left} {self.top}h{self.wide}v{self.high}h-{self.wide}z"/>'
        upright = self.high > 2 * self.wide
        along, across = (self.high, self.wide) if upright else (self.wide, self.high)
        size, lines = _fitted(self.text or " ", along, across, self.size)
        at = f"translate({self.left + self.wide / 2} {self.top + self.high / 2}){' rotate(-90)' if upright else ''}"
        for row, line in enumerate(lines):
            y = size * (_LINE * (row - len(lines) / 2) + 0.95)
            drawn += f'<text transform="{at}" y="{y:.2f}" font-size="{size:.2f}" stroke="none">{escape(line)}</text>'
        return drawn


def _fitted(text: str, long: float, across: float, size: float) -> tuple[float, list[str]]:
    """Break a text into lines, smaller where they would not fit; words only where they would be too small to read."""
    letter = sum(_CAPITAL if sign.isupper() else _LETTER for sign in text) / len(text)
    while True:
        most = int((long - 1) / letter / size)
        lines = textwrap.wrap(text, max(1, most), break_long_words=size < _READ)
        if len(lines) * _LINE * size <= across and max(map(len, lines), default=0) <= most:
            return size, lines
        size *= 0.9


def frame(block: TitleBlock, name: str, *, first: bool) -> Markup:
    """Draw the frame of a first or later sheet A4 as the address of an SVG picture, without numbers that change."""
    high = 40 if first else 15
    top, columns = _BOTTOM - high, ((20, 7), (27, 10), (37, 23), (60, 15), (75, 10))
    heads = map(translate, ("Chg.", "Sheet", "Document no.", "Sign.", "Date"))
    main = [_Cell(20, 5, 185, 287), _Cell(20, top, 185, high), *(_Cell(x, top, wide, 15) for x, wide in columns)]
    main += [_Cell(x, top + 10, wide, 5, head) for (x, wide), head in zip(columns, heads, strict=True)]
    thin = [_Cell(20, top, 65, 5)]
    if first:
        roles = map(translate, ("Drawn", "Checked", "", "Standards", "Approved"))
        names = block.author, block.checked, "", block.norm_control, block.approved
        for y, role, who in zip(range(267, _BOTTOM, 5), roles, names, strict=True):
            thin += [_Cell(20, y, 17, 5, role), _Cell(37, y, 23, 5, who), _Cell(60, y, 25, 5)]
        main += [_Cell(x, 267, wide, 25) for x, wide in ((20, 17), *columns[2:])]
        main += [_Cell(85, top, 120, 15, block.drawing, 6), _Cell(85, 267, 70, 25, name, 5)]
        heads = map(translate, ("Stage", "Sheet", "Sheets"))
        main += [_Cell(x, 267, wide, 5, next(heads)) for x, wide in ((155, 15), (170, 15), (185, 20))]
        main += [_Cell(x, 272, 5, 5) for x in (155, 160, 165)]
        main += [_Cell(170, 272, 15, 5, "1", 3.9), _Cell(155, 277, 50, 15, block.organisation, 4)]
    else:
        main += [_Cell(85, top, 110, 15, block.drawing, 6), _Cell(195, top, 10, 7, translate("Sheet"))]
    # of the original that is kept: down the margin
    heads = map(
        translate, ("Signature and date", "No. of copy", "Instead of no.", "Signature and date", "No. of original")
    )
    for y, long in ((147, 35), (182, 25), (207, 25), (232, 35), (267, 25)):
        main += [_Cell(8, y, 5, long, next(heads)), _Cell(13, y, 7, long)]
    drawn = "".join(
        f'<g stroke-width="{pen}">{"".join(cell.svg() for cell in cells)}</g>'
        for pen, cells in ((0.25, thin), (0.7, main))
    )
    svg = (
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 210 297" text-anchor="middle" '
        f'font-family="Arial, Liberation Sans, sans-serif" stroke="#000">{drawn}</svg>'
    )
    return Markup("data:image/svg+xml,{}").format(quote(svg))
