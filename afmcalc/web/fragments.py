"""Fragments of the page: Jinja templates that typeset blocks of a report, and charts as data for the script."""

import json
import math
from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined, Template
from markupsafe import Markup

from ..messages import printable, say, translate
from ..render.plot.chart import Chart, ChartAxis, Line
from ..render.plot.paint import COLOURS, DASHES, GUIDES
from ..render.report.blocks import Block
from ..render.report.html import fragment, inline
from ..render.report.page import findings_of, judged, quantities
from ..render.report.pieces import cell, said
from ..render.report.words import titled


@cache
def template(name: str) -> Template:
    """Template by its file name; its texts are translated only when rendered, so one template serves all languages."""
    environment = Environment(
        loader=FileSystemLoader(Path(__file__).parent),
        optimized=False,
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        finalize=lambda value: printable(value, lines=True) if type(value) is str else value,
    )
    environment.filters |= {
        "symbol": lambda words: Markup(inline(said(words))),
        "cell": lambda words: Markup(inline(cell(words))),
        "translate": translate,
    }
    environment.globals.update(
        _=say, set=_set, titled=titled, judged=judged, quantities=quantities, findings_of=findings_of
    )
    return environment.get_template(name)


def _set(*blocks: Block) -> Markup:
    return Markup(fragment(blocks))


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
