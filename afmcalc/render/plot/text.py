"""Charts as text: where a plot is asked for without a file, and under a sweep in the terminal."""

import math
import textwrap
from collections.abc import Mapping, Sequence
from itertools import compress
from typing import NamedTuple

from ...messages import localized, named, printable, told
from ..drawing import DimensionLine, Drawing
from ..layout import TextTable
from ..symbols import native
from ..units import significant
from .chart import Chart, ChartAxis, Line, Sheet, power

WIDTH, HEIGHT = 80, 20
"""Columns of a chart where nothing bounds them, and rows of its frame."""
_NARROWEST = 40
"""Columns below which a curve says nothing."""
_SMALL = 8
"""Rows of the curve that stands under every sweep."""
_LETTERS = "ABCDEFGHJKLMNPQRSTUVWYZabcdefghijklmnpqrstuvwyz"
_MARKS = "•xo+#%@*=&" + _LETTERS
_PLAIN = "*xo+#%@.=&" + _LETTERS
_FILLED = "◆$"

Ends = tuple[float, float]


class Trace(NamedTuple):
    """The points of one curve, its mark, and whether they are joined."""

    mark: str
    points: Sequence[tuple[float, float]]
    joined: bool = False


def draw_sheet(sheet: Sheet, *, unicode: bool, width: int | None = None) -> str:
    """Draw the panels of a sheet that are charts, with title and caption, within the width there is."""
    wide = _within(width)
    title = sheet.title + (f" – {named(sheet.name)}" if sheet.name else "")
    charts = [panel for panel in sheet.panels if isinstance(panel, Chart)]
    blocks = [_folded(title, wide)]
    blocks += ([*_folded(native(chart.title), wide), *draw(chart, unicode=unicode, wide=wide)] for chart in charts)
    blocks += (_sketch(panel, unicode=unicode, wide=wide) for panel in sheet.panels if isinstance(panel, Drawing))
    if sheet.below:
        blocks.append([line for part in native(sheet.below).splitlines() for line in textwrap.wrap(part, wide)])
    return "\n\n".join("\n".join(map(printable, lines)) for lines in blocks) + "\n"


def draw(chart: Chart, *, unicode: bool, wide: int = WIDTH, high: int = HEIGHT) -> list[str]:
    """Draw a chart as lines of text, each curve with a mark of its own; ``unicode`` is False for an ASCII stream."""
    scale = math.log10 if chart.y.log else float
    marks = _MARKS if unicode else _PLAIN
    traces: dict[int, Trace] = {}
    # what stands out goes last: the rest would hide it
    for number, line in sorted(enumerate(chart.lines), key=lambda item: item[1].filled):
        pairs = zip(chart.x.shown(line.x), chart.y.shown(line.y), strict=True)
        points = [(x, scale(y)) for x, y in pairs if not math.isnan(x + y)]
        if points:
            mark = _FILLED[not unicode] if line.filled else marks[number % len(marks)]
            traces[number] = Trace(mark, points, joined=not line.points)
    if not traces:
        return [told("{title}: no values to draw", title=chart.y.label)]
    x, y = _bounds(list(traces.values()))
    heights = {value: power(10**value) for value in _decades(*y)} if chart.y.log else _labels(y, max(4, high // 3))
    beside = {high - 1 - _place(value, y, high): text for value, text in heights.items()}
    width = wide - 2 - max(map(len, beside.values()))
    below = {_place(value, x, width): text for value, text in _labels(x, width // 10).items()}
    frame = _frame(list(traces.values()), (width, high), beside, below, unicode=unicode)
    keys = [f"  {traces[number].mark} {native(chart.lines[number].label)}" for number in sorted(traces)]
    legend = [part for key in keys for part in _folded(key, wide, "    ")] if len(keys) > 1 else []
    label = [line.rjust(wide) for line in _folded(native(chart.x.label), wide)]
    return [*_folded(native(chart.y.label), wide), *frame, *label, *legend]


def _sketch(drawing: Drawing, *, unicode: bool, wide: int) -> list[str]:
    """Sketch what is above the axis of a drawing to scale, each part by its number; list dimensions and parts."""
    long, high = (max(box[side] for _, box in drawing.solids) for side in (1, 3))
    columns = min(wide - 7, round(2 * HEIGHT * long / high))  # a letter is twice as high as wide
    across, up = (columns - 1) / long, (columns - 1) / long / 2
    rows = round(high * up)
    traces = [Trace("─" if unicode else "-", [(0, 0), (columns - 1, 0)], joined=True)]
    for mark, (left, right, low, top) in drawing.solids:
        along, above = (
            range(round(start * scale), max(round(end * scale), round(start * scale) + 1))
            for start, end, scale in ((left, right, across), (low, top, up))
        )
        traces.append(Trace(mark, [(column, row) for column in along for row in above]))
    beside = {rows - 1 - round(value * up): text for value, text in _labels((0, high), 5).items()}
    below = {round(value * across): text for value, text in _labels((0, long), columns // 10).items()}
    frame = _frame(traces, (columns, rows), beside, below, unicode=unicode)
    sizes = [f"{shape.label}  {shape.about}" for shape in drawing.shapes if isinstance(shape, DimensionLine)]
    widths = [max(map(len, column)) for column in zip(*drawing.table, strict=True)]
    table = ["  ".join(map(str.ljust, row, widths)).rstrip() for row in drawing.table]
    return [*frame, "", *(part for line in [*sizes, "", *table] for part in _folded(line, wide, "    ") or [""])]


def swept_lines(block: TextTable, unicode: bool, width: int | None = None, high: int = HEIGHT) -> list[str]:
    """Draw the first answer of a sweep, a curve for each value of the outer key of a grid; nothing for other tables."""
    table = block.source
    if table is None or table.axes not in (1, 2):
        return []
    *outer, inner, answer = table.columns[: table.axes + 1]
    if not any(value is not None for value in answer.values):
        return []
    x = ChartAxis("" if inner.symbol else inner.name, inner.symbol, inner.unit)
    y = ChartAxis(answer.name, answer.symbol, answer.unit)
    lines = [] if outer else [Line(y.symbol, inner.values, answer.values)]
    for value in dict.fromkeys(outer[0].values if outer else ()):
        chosen = [other == value for other in outer[0].values]
        label = f"{outer[0].symbol} = {localized(f'{value:g}')}"
        lines.append(Line(label, [*compress(inner.values, chosen)], [*compress(answer.values, chosen)]))
    return ["", *draw(Chart(x, y, lines), unicode=unicode, wide=_within(width), high=high)]


def small_curve(block: TextTable, unicode: bool, width: int | None) -> list[str]:
    """Draw a sweep in the few rows that stand under every table of one."""
    return swept_lines(block, unicode, width, _SMALL)


def _within(width: int | None) -> int:
    return WIDTH if width is None else max(_NARROWEST, width)


def _folded(text: str, wide: int, indent: str = "") -> list[str]:
    """Fold a line that does not fit; nothing of it is cut."""
    if len(text) <= wide:
        return [text] if text else []
    return textwrap.wrap(text, wide, subsequent_indent=indent, break_on_hyphens=False)


def _bounds(traces: Sequence[Trace]) -> tuple[Ends, Ends]:
    """Return the smallest and largest abscissa, and ordinate, of all points."""
    x, y = ([point[axis] for trace in traces for point in trace.points] for axis in (0, 1))
    return (min(x), max(x)), (min(y), max(y))


def _place(value: float, ends: Ends, cells: int) -> int:
    """Return the cell of a value on an axis of that many cells."""
    low, high = ends
    if high == low:
        return cells // 2
    # halved before the difference, so that ends of opposite sign near the largest float do not overflow
    share = (value / 2 - low / 2) / (high / 2 - low / 2)
    return min(cells - 1, round(share * (cells - 1)))


def ticks(ends: Ends, most: int) -> list[float]:
    """Return round values within an axis, as many as fit: steps of 1, 2 or 5 times a power of ten.

    >>> ticks((0.1, 0.8), 4), ticks((3.0, 3.0), 4)
    ([0.2, 0.4, 0.6, 0.8], [3.0])
    """
    low, high = ends
    if not 0 < high - low < math.inf:
        return [low]
    power = 10.0 ** math.floor(math.log10((high - low) / most))
    step = next(step for step in (power, 2 * power, 5 * power, 10 * power) if (high - low) / step <= most)
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [float(f"{count * step:.12g}") for count in range(first, last + 1)]


def _labels(ends: Ends, most: int) -> dict[float, str]:
    return {value: significant(value) for value in ticks(ends, most)}


def _decades(low: float, high: float) -> list[float]:
    """Whole powers of ten within a range of exponents, or its ends where there are too few."""
    whole = list(range(math.ceil(low), math.floor(high) + 1))
    step = max(1, len(whole) // 6)
    return [float(power) for power in whole[::step]] if len(whole) > 1 else [low, high]


def _frame(
    traces: Sequence[Trace],
    size: tuple[int, int],
    beside: Mapping[int, str],
    below: Mapping[int, str],
    *,
    unicode: bool,
) -> list[str]:
    """Draw traces in a frame of columns and rows, a later one over an earlier.

    ``beside`` are texts by row, from the top; ``below`` texts by column.
    """
    width, height = size
    x, y = _bounds(traces)
    cells = [[" "] * width for _ in range(height)]
    for trace in traces:
        spots = [(_place(a, x, width), height - 1 - _place(b, y, height)) for a, b in trace.points]
        for (a, b), (c, d) in zip(spots, [*spots[1:], spots[-1]], strict=True):
            steps = max(abs(c - a), abs(d - b)) if trace.joined else 0
            for n in range(steps + 1):
                cells[b + round((d - b) * n / max(steps, 1))][a + round((c - a) * n / max(steps, 1))] = trace.mark
    side, corner, floor, left, foot = "│└─┤┬" if unicode else "|+-++"
    margin = max(map(len, beside.values()))
    lines = [
        f"{beside.get(number, ''):>{margin}} {left if number in beside else side}{''.join(row)}".rstrip()
        for number, row in enumerate(cells)
    ]
    base = "".join(foot if column in below else floor for column in range(width))
    return [*lines, f"{'':{margin}} {corner}{base}", f"{'':{margin}}  {_spread(below, width)}"]


def _spread(texts: Mapping[int, str], width: int) -> str:
    """Set texts in one line, each about its column; one without room is left out."""
    line = ""
    for column, text in texts.items():
        start = max(0, min(column - len(text) // 2, width - len(text)))
        if not line or start > len(line):
            line = line.ljust(start) + text
    return line
