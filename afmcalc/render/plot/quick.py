"""A chart as SVG, written at once: for a page that draws it anew after each change, where matplotlib takes too long."""

import math
from collections.abc import Iterable

from ..drawing import spans
from ..units import significant
from .chart import Chart
from .paint import COLOURS, GRID, INK, WIDTH
from .text import ticks

_WIDE, _HIGH, _SIZE = WIDTH * 72, 200.0, 9.0
"""Width of the drawing, height of the axes and size of the texts, points."""
_LETTER = 0.62
"""Width of a letter over the size of the text."""
_ROW = 1.5 * _SIZE
_DASHES = ("", "6 2", "6 2 1.2 2", "1.2 1.4", "10 3")
_GUIDES = ("1 2", "4 3", "8 3 1 3", "")
_KEY = 36.0
"""Width of the piece of a line in the legend, with what is beside it."""


def is_plain(chart: Chart) -> bool:
    """Whether a chart has nothing but curves, guides across and dimensions, and values to draw them by."""
    whole = all(len(line.x) > 1 and None not in (*line.x, *line.y) and not line.points for line in chart.lines)
    more = chart.areas or chart.bounds or chart.named or chart.x.log or chart.y.log
    return whole and bool(chart.lines) and not more and all(guide.across for guide in chart.guides)


def svg_of(chart: Chart) -> str:
    """Write a plain chart."""
    curves = [[*zip(chart.x.shown(line.x), chart.y.shown(line.y), strict=True)] for line in chart.lines]
    guides = chart.y.shown([guide.value for guide in chart.guides])
    least, most = (end(x for curve in curves for x, _ in curve) for end in (min, max))
    heights = [*(y for curve in curves for _, y in curve), *guides]
    margin = 0.05 * (max(heights) - min(heights)) or abs(max(heights)) or 1.0
    low, high = min(heights) - margin, max(heights) + margin
    low = 0.0 if chart.from_zero and min(heights) >= 0 else low
    beside, below = (
        [(value, significant(value)) for value in ticks(*each)] for each in (((low, high), 6), ((least, most), 9))
    )
    left = 2 * _ROW + _LETTER * _SIZE * max(len(text) for _, text in beside)
    right, top, floor = _WIDE - _SIZE - 2 * _ROW * len(chart.spans), _SIZE, _SIZE + _HIGH

    def across(value: float) -> float:
        return left + (value - least) / (most - least or 1.0) * (right - left)

    def up(value: float) -> float:
        return floor - (value - low) / (high - low) * _HIGH

    parts = [_line([(left, up(value)), (right, up(value))], GRID, 0.6) for value, _ in beside]
    parts += [_line([(across(value), top), (across(value), floor)], GRID, 0.6) for value, _ in below]
    parts.append(_line([(left, top), (left, floor), (right, floor)], INK, 0.8))
    parts += [_text(text, left - 5, up(value) + _SIZE / 3, "end") for value, text in beside]
    parts += [_text(text, across(value), floor + _ROW, "middle") for value, text in below]
    parts.append(_text(chart.x.label, (left + right) / 2, floor + 2 * _ROW, "middle"))
    parts.append(_text(chart.y.label, _SIZE, (top + floor) / 2, "middle", upright=True))
    looks = [_look(line.style, place, COLOURS, _DASHES, 1.7) for place, line in enumerate(chart.lines)]
    looks += [_look(guide.style, place, (INK,), _GUIDES, 1.0) for place, guide in enumerate(chart.guides)]
    labels = [*(line.label for line in chart.lines), *(guide.label for guide in chart.guides)]
    drawn = [*curves, *([(least, value), (most, value)] for value in guides)]
    for place, (points, look, label) in enumerate(zip(drawn, looks, labels, strict=True)):
        level = floor + (3.2 + place) * _ROW
        parts.append(_line(((across(x), up(y)) for x, y in points), *look))
        parts.append(_line([(left, level - _SIZE / 3), (left + _KEY - 6, level - _SIZE / 3)], *look))
        parts.append(_text(label, left + _KEY, level))
    for place, span in enumerate(chart.spans):
        at, colour = right + _SIZE + 2 * _ROW * place, COLOURS[span.style % len(COLOURS)]
        ends = [*map(up, chart.y.shown((span.low, span.high)))]
        parts += [_line([(left, end), (at + 3, end)], colour, 0.6, "1 2") for end in ends]
        parts.append(_line([(at, end) for end in ends], colour, 1.0))
        parts += [_head(at, end, math.copysign(1.0, end - other), colour) for end, other in (ends, ends[::-1])]
        parts.append(_text(" ".join(span.label), at + _ROW, sum(ends) / 2, "middle", upright=True))
    whole = floor + (3.2 + len(drawn)) * _ROW - _SIZE
    head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDE:g} {whole:g}" font-size="{_SIZE:g}"'
    return "\n".join([f'{head} font-family="DejaVu Sans, sans-serif">', *parts, "</svg>", ""])


Look = tuple[str, float, str]
"""Colour, width and dashes of a line."""


def _look(style: int | None, place: int, colours: tuple[str, ...], dashes: tuple[str, ...], width: float) -> Look:
    style = place if style is None else style
    return colours[style % len(colours)], width, dashes[style % len(dashes)]


def _line(points: Iterable[tuple[float, float]], colour: str, width: float, dashes: str = "") -> str:
    path = "L".join(f"{x:.2f} {y:.2f}" for x, y in points)
    dashed = f' stroke-dasharray="{dashes}"' if dashes else ""
    return f'<path d="M{path}" fill="none" stroke="{colour}" stroke-width="{width:g}"{dashed}/>'


def _head(x: float, y: float, way: float, colour: str) -> str:
    """Draw the head of an arrow that points up or down to a place."""
    return f'<path d="M{x:.2f} {y:.2f}l-2.4 {-6 * way:g}h4.8z" fill="{colour}"/>'


def _text(text: str, x: float, y: float, anchor: str = "start", *, upright: bool = False) -> str:
    """Set a text with its subscripts."""
    turned = f' transform="rotate(-90 {x:.2f} {y:.2f})"' if upright else ""
    return f'<text x="{x:.2f}" y="{y:.2f}" fill="{INK}" text-anchor="{anchor}"{turned}>{spans(text)}</text>'
