"""Charts drawn in the terminal, as text."""

import math
import textwrap
from collections.abc import Sequence
from typing import Any

from ...messages import localized, named, printable, told
from ..canvas import Ends, Trace, bounds, drawn, place, ticks
from ..document import Table
from ..layout import TextTable
from ..units import factor, significant
from .chart import Chart, ChartAxis, Line, Sheet, power

WIDTH, HEIGHT = 78, 20
_NARROWEST = 40
"""Columns below which a curve says nothing."""
_LETTERS = "ABCDEFGHJKLMNPQRSTUVWYZabcdefghijklmnpqrstuvwyz"
_MARKS = "•xo+#%@*=&" + _LETTERS
_PLAIN = "*xo+#%@.=&" + _LETTERS
_FILLED = "◆$"


def draw(chart: Chart, *, unicode: bool, wide: int = WIDTH) -> list[str]:
    """Draw a chart as lines of text, each curve with a mark of its own.

    Args:
        chart: what to draw.
        unicode: False for a stream that takes ASCII only.
        wide: columns of characters.

    Returns:
        The lines, without line ends.
    """
    across, high = factor(chart.x.unit), factor(chart.y.unit)
    scale = math.log10 if chart.y.log else float
    marks = _MARKS if unicode else _PLAIN
    traces: dict[int, Trace] = {}
    # what stands out goes last: the rest would hide it
    for number, line in sorted(enumerate(chart.lines), key=lambda item: item[1].filled):
        pairs = zip(line.x, line.y, strict=True)
        points = [(x * across, scale(y * high)) for x, y in pairs if x is not None and y is not None]
        if points:
            mark = _FILLED[not unicode] if line.filled else marks[number % len(marks)]
            traces[number] = Trace(mark, points, joined=not line.points)
    if not traces:
        return [told("{title}: no values to draw", title=chart.y.label)]
    x, y = bounds(list(traces.values()))
    heights = {value: power(10**value) for value in _decades(*y)} if chart.y.log else _named(y, HEIGHT // 3)
    beside = {HEIGHT - 1 - place(value, y, HEIGHT): text for value, text in heights.items()}
    width = wide - 2 - max(map(len, beside.values()))
    below = {place(value, x, width): text for value, text in _named(x, width // 10).items()}
    frame = drawn(list(traces.values()), (width, HEIGHT), beside, below, unicode=unicode, notch=True)
    keys = [f"  {traces[number].mark} {chart.lines[number].label}" for number in sorted(traces)]
    named = [part for key in keys for part in _folded(key, wide, "    ")] if len(keys) > 1 else []
    return [*_folded(chart.y.label, wide), *frame, *(line.rjust(wide) for line in _folded(chart.x.label, wide)), *named]


def _named(ends: Ends, most: int) -> dict[float, str]:
    return {value: significant(value) for value in ticks(ends, most)}


def _decades(low: float, high: float) -> list[float]:
    """Whole powers of ten within a range of exponents, or its ends where there are too few."""
    whole = list(range(math.ceil(low), math.floor(high) + 1))
    step = max(1, len(whole) // 6)
    return [float(power) for power in whole[::step]] if len(whole) > 1 else [low, high]


def draw_sheet(sheet: Sheet, *, unicode: bool, width: int | None = None) -> str:
    """Draw the panels of a sheet that are charts, with title and caption, within the width there is."""
    wide = _within(width)
    title = sheet.title + (f" – {named(sheet.name)}" if sheet.name else "")
    charts = [panel for panel in sheet.panels if isinstance(panel, Chart)]
    blocks = [_folded(title, wide)]
    blocks += ([*_folded(chart.title, wide), *draw(chart, unicode=unicode, wide=wide)] for chart in charts)
    if sheet.caption:
        blocks.append([line for part in sheet.caption.splitlines() for line in textwrap.wrap(part, wide)])
    return "\n\n".join("\n".join(map(printable, lines)) for lines in blocks) + "\n"


def _within(width: int | None) -> int:
    return WIDTH if width is None else max(_NARROWEST, min(width, WIDTH))


def _folded(text: str, wide: int, indent: str = "") -> list[str]:
    """Fold a line that does not fit; nothing of it is cut."""
    if len(text) <= wide:
        return [text] if text else []
    return textwrap.wrap(text, wide, subsequent_indent=indent, break_on_hyphens=False)


def swept_lines(block: TextTable, unicode: bool, width: int | None = None) -> list[str]:
    """Draw the first answer of a sweep, a curve for each value of the outer key of a grid; nothing for other tables."""
    chart = _chart(block.source) if block.source is not None and block.source.axes in (1, 2) else None
    return ["", *draw(chart, unicode=unicode, wide=_within(width))] if chart else []


def _chart(table: Table) -> Chart | None:
    *outer, inner, answer = table.columns[: table.axes + 1]
    if not any(value is not None for value in answer.values):
        return None
    x, y = (ChartAxis(column.name, column.symbol, column.unit) for column in (inner, answer))
    x = x._replace(quantity="") if inner.symbol else x
    if not outer:
        return Chart(x, y, [Line(y.symbol, inner.values, answer.values)])
    lines = [
        Line(
            f"{outer[0].symbol} = {localized(f'{value:g}')}",
            *_part(value, outer[0].values, inner.values, answer.values),
        )
        for value in dict.fromkeys(outer[0].values)
    ]
    return Chart(x, y, lines)


def _part(value: float, of: Sequence[Any], x: Sequence[Any], y: Sequence[Any]) -> tuple[list[Any], list[Any]]:
    """Return the points of a grid at one value of its outer key."""
    chosen = [number for number, own in enumerate(of) if own == value]
    return [x[number] for number in chosen], [y[number] for number in chosen]
