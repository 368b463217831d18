"""Charts drawn in the terminal, as text, by plotext."""

import math
import textwrap
from collections.abc import Sequence
from typing import Any

from ..document import Table
from ..layout import Block
from ..units import factor
from .chart import Chart, ChartAxis, Line, Sheet, power

WIDTH, HEIGHT = 78, 20
_MARKS = ("•", "x", "o", "+", "#", "%", "@", "*", "=", "&")
_PLAIN = str.maketrans("┌┐└┘├┤┬┴┼│─•…·−", "+++++++++|-*.*-")


def draw(chart: Chart, *, unicode: bool) -> list[str]:
    """Draw a chart as lines of text, each curve with a mark of its own.

    Args:
        chart: what to draw.
        unicode: False for a stream that takes ASCII only.

    Returns:
        The lines, without line ends.
    """
    import plotext

    wide, high = factor(chart.x.unit), factor(chart.y.unit)
    plotext.clear_figure()
    plotext.theme("clear")
    plotext.plotsize(WIDTH, HEIGHT)
    keys: dict[int, str] = {}
    heights: list[float] = []
    # what is drawn small goes first: here it would hide the rest
    for number, line in sorted(enumerate(chart.lines), key=lambda item: not item[1].filled):
        points = [(x, y) for x, y in zip(line.x, line.y, strict=True) if x is not None and y is not None]
        if not points:
            continue
        mark = "·" if line.filled else _MARKS[number % len(_MARKS)]
        put = plotext.scatter if line.points else plotext.plot
        ys = [math.log10(y * high) if chart.y.log else y * high for _, y in points]
        put([x * wide for x, _ in points], ys, marker=mark)
        heights += ys
        keys[number] = f"  {mark} {line.label}"
    if chart.y.log and heights:
        ticks = _decades(min(heights), max(heights))
        plotext.yticks(ticks, [power(10**tick) for tick in ticks])
    built = plotext.uncolorize(plotext.build())
    plotext.clear_figure()
    lines = [chart.y.label, *(line.rstrip() for line in built.splitlines()), chart.x.label.rjust(WIDTH)]
    lines += [keys[number] for number in sorted(keys)] if len(keys) > 1 else []
    return lines if unicode else [_ascii(line) for line in lines]


def _decades(low: float, high: float) -> list[float]:
    """Whole powers of ten within a range of exponents, or its ends where there are too few."""
    whole = list(range(math.ceil(low), math.floor(high) + 1))
    step = max(1, len(whole) // 6)
    return [float(power) for power in whole[::step]] if len(whole) > 1 else [low, high]


def _ascii(line: str) -> str:
    return line.translate(_PLAIN)


def draw_sheet(sheet: Sheet, *, unicode: bool) -> str:
    """Draw the panels of a sheet that are charts, with title and caption."""
    title = sheet.title + (f" – {sheet.name}" if sheet.name else "")
    charts = [panel for panel in sheet.panels if isinstance(panel, Chart)]
    blocks = [[title], *([*filter(None, [chart.title]), *draw(chart, unicode=unicode)] for chart in charts)]
    if sheet.caption:
        blocks.append([line for part in sheet.caption.splitlines() for line in textwrap.wrap(part, WIDTH)])
    return "\n\n".join("\n".join(lines) for lines in blocks) + "\n"


def swept_lines(block: Block, unicode: bool) -> list[str]:
    """Draw the first answer of a sweep, a curve for each value of the outer key of a grid; nothing for other tables."""
    chart = _chart(block.source) if block.source is not None and block.source.axes in (1, 2) else None
    return ["", *draw(chart, unicode=unicode)] if chart else []


def _chart(table: Table) -> Chart | None:
    *outer, inner, answer = table.columns[: table.axes + 1]
    if not any(value is not None for value in answer.values):
        return None
    x, y = (ChartAxis(column.name, column.symbol, column.unit) for column in (inner, answer))
    x = x._replace(quantity="") if inner.symbol else x
    if not outer:
        return Chart(x, y, [Line(y.symbol, inner.values, answer.values)])
    lines = [
        Line(f"{outer[0].symbol} = {value:g}", *_part(value, outer[0].values, inner.values, answer.values))
        for value in dict.fromkeys(outer[0].values)
    ]
    return Chart(x, y, lines)


def _part(value: float, of: Sequence[Any], x: Sequence[Any], y: Sequence[Any]) -> tuple[list[Any], list[Any]]:
    """Return the points of a grid at one value of its outer key."""
    chosen = [number for number, own in enumerate(of) if own == value]
    return [x[number] for number in chosen], [y[number] for number in chosen]
