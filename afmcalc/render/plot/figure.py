"""File of a sheet as SVG, PNG or PDF; the same sheet gives the same bytes."""

import io
import re
import textwrap
from typing import TYPE_CHECKING

from ...messages import named, printable
from ..drawing import Drawing
from ..svg import picture, svg
from ..symbols import lowered
from .chart import Chart, Sheet
from .paint import LETTERS, PARAMETERS, SIZE, TITLE, UP, WIDTH, folded, paint

if TYPE_CHECKING:
    from matplotlib.figure import Figure

CREATOR = "afmcalc plot"
_HIGH, _RIGHT, _EDGE, _LINE = 2.5, 0.35, 0.07, 1.5 * SIZE / 72
"""Height of the axes, space to the right of the axes, margin of texts, height of a line of text, inches."""
_TITLE, _COLUMN = 62, 36
"""Largest number of letters in a line of the title, and in an entry of a legend in two columns."""
_TEXT = re.compile("(?<=>)[^<]+(?=</text>)")


def save(sheet: Sheet, ending: str) -> bytes:
    """Return a file of a sheet with its title and caption, on white; the same sheet gives the same bytes."""
    (first, *_) = sheet.panels
    if isinstance(first, Drawing):
        text = svg(first.captioned(sheet.title, named(sheet.name), sheet.below), sheet.title)
    else:
        text = _drawn(sheet)
    return picture(text, ending)


def inline_svg(panel: Drawing | Chart) -> str:
    """Return a drawing or a chart as SVG for a page: without title and caption, on a transparent ground."""
    return svg(panel) if isinstance(panel, Drawing) else _drawn(Sheet("", [panel]), transparent=True)


def _drawn(sheet: Sheet, *, transparent: bool = False) -> str:
    """Draw charts by matplotlib; a user's settings of matplotlib have no effect."""
    from matplotlib import style

    content = io.StringIO()
    with style.context([PARAMETERS], after_reset=True):
        metadata = {"Date": None, "Creator": CREATOR}
        figure_of(sheet).savefig(content, format="svg", transparent=transparent, metadata=metadata)
    return _TEXT.sub(lambda found: lowered(found[0]), content.getvalue())


def figure_of(sheet: Sheet) -> "Figure":
    """Lay charts out one below the other, each with its legend, between title and caption."""
    from matplotlib.figure import Figure

    title = f"{folded(sheet.title, _TITLE)}\n{folded(named(sheet.name), _TITLE, printable)}".strip()
    caption = "\n".join(map(folded, sheet.below.splitlines()))
    rooms = [*map(_Room, sheet.panels)]
    top, bottom = 1.4 * _LINE * len(title.splitlines()), _LINE * len(caption.splitlines())
    high = top + sum(room.high for room in rooms) + bottom
    figure = Figure((WIDTH, high))
    figure.suptitle(title, x=_EDGE / WIDTH, y=1 - _EDGE / high, ha="left")
    figure.text(_EDGE / WIDTH, _EDGE / high, caption, va="bottom")
    level = high - top
    for room, chart in zip(rooms, sheet.panels, strict=True):
        level -= room.above + _HIGH
        wide = WIDTH - room.left - _RIGHT
        axes = figure.add_axes((room.left / WIDTH, level / high, wide / WIDTH, _HIGH / high))
        paint(axes, chart)
        level -= room.below
        if chart.labels:
            entries, place = axes.get_legend_handles_labels(), (_EDGE / WIDTH, level / high)
            figure.legend(*entries, loc="upper left", bbox_to_anchor=place, borderaxespad=0, ncols=room.columns)
        level -= room.legend
    return figure


class _Room:
    """Space around the axes of a chart for numbers, labels, title and legend, inches."""

    def __init__(self, chart: Chart) -> None:
        labels = chart.labels
        self.columns = 2 if all(len(label) <= _COLUMN for label in labels) else 1
        self.left = 0.6 + _high(chart.y.label, UP)
        self.above = 0.12 + _high(chart.title, TITLE) + 3 * _LINE * any(guide.tag for guide in chart.guides)
        self.below = 0.26 + _high(chart.x.label)
        self.legend = 0.1 + sum(map(_high, [*labels, *labels[: len(labels) % self.columns]])) / self.columns
        self.high = self.above + _HIGH + self.below + self.legend


def _high(text: str, letters: int = LETTERS) -> float:
    """Height, in inches, of a text wrapped at ``letters``."""
    return _LINE * len(textwrap.wrap(text, letters))
