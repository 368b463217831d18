"""Chart as data for the page's script, which draws it: numbers in the units shown, texts for the legend."""

import json
import math
from collections.abc import Iterable, Sequence
from typing import Any

from ..render.plot.chart import Chart, ChartAxis, Line
from ..render.plot.paint import COLOURS, DASHES, GUIDES

_COLOURS = *(f"var(--line-{number})" for number in range(4)), "var(--ink)", *COLOURS[5:]


def curve(chart: Chart, pinned: Sequence[Line] = ()) -> dict[str, Any]:
    """Axes and legend of a chart, and its lines, areas and guides as JSON; the lines of a pinned state are paler."""
    x, y = chart.x, chart.y
    marks = [
        _line(chart, line, number if line.style is None else line.style, paler)
        for lines, paler in ((chart.lines, False), (pinned, True))
        for number, line in enumerate(lines)
    ]
    areas = [{"x": x.shown(area.x), "low": y.shown(area.low), "high": y.shown(area.high)} for area in chart.areas]
    plain = {"points": False, "filled": False, "paler": False, "colour": "var(--ink)"}
    guides = [
        {"across": guide.across, "at": (y if guide.across else x).shown([guide.value])[0], "label": guide.label}
        | {"dash": _dash(GUIDES[(number if guide.style is None else guide.style) % len(GUIDES)]), **plain}
        for number, guide in enumerate(chart.guides)
    ]
    drawn: dict[str, Any] = {"lines": marks, "areas": areas, "guides": guides}
    for axis, name, place, upright in ((x, "x", 0, False), (y, "y", 2, True)):
        values = [value for line in marks for value in line[name] if value is not None]
        values += [guide["at"] for guide in guides if guide["across"] == upright]
        values += [0.0] if upright and chart.from_zero else []
        values += [value for area in areas if upright for value in (*area["low"], *area["high"])]
        ends = axis.shown(chart.bounds[place : place + 2]) if chart.bounds else [min(values), max(values)]
        drawn[name] = {"ends": ends, "log": chart.log and upright}
    return {
        "title": chart.title, "x": x.label, "y": y.label, "data": json.dumps(drawn),
        "legend": [entry for entry in (*marks, *guides) if entry["label"]],
    }  # fmt: skip


def _line(chart: Chart, line: Line, style: int, paler: bool) -> dict[str, Any]:
    return {
        "x": _numbers(chart.x, line.x), "y": _numbers(chart.y, line.y), "label": line.label, "paler": paler,
        "colour": _COLOURS[style % len(_COLOURS)], "dash": _dash(DASHES[style % len(DASHES)]),
        "points": line.points, "filled": line.filled, "names": [*line.names],
    }  # fmt: skip


def _numbers(axis: ChartAxis, values: Iterable[float | None]) -> list[float | None]:
    return [None if math.isnan(value) else value for value in axis.shown(values)]


def _dash(style: Any) -> str:
    return "" if style == "solid" else " ".join(map(str, style[1]))
