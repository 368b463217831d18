"""How plots look, and from a chart to matplotlib's axes."""

import math
import re
from collections.abc import Callable, Iterable, Iterator
from typing import Any

from ...messages import localized, spoken
from ..symbols import literal, mathtext
from .chart import Chart, Dimension, Line

INK, GRID, SHADE = "#111111", "#d4d4d4", "#9a9a9a"
"""Colours a page may replace by its own (dark mode): text and axes, grid, shaded regions."""
WRONG, PAPER = "#a40e26", "#ffffff"
"""Colours of what is in the way, and of what hides other things, which a page may replace too."""

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#aa4499", "#111111", "#e69f00", "#56b4e9")
"""The colours of Okabe and Ito, with a darker reddish purple, to stand out on white, and the ink for black."""
DASHES: tuple[Any, ...] = (
    "solid",
    (0, (6, 2)),
    (0, (6, 2, 1.2, 2)),
    (0, (1.2, 1.4)),
    (0, (10, 3)),
    (0, (6, 2, 1.2, 2, 1.2, 2)),
    (0, (3, 1.5)),
)
MARKERS = ("o", "s", "^", "D", "v", "P", "X")
GUIDES: tuple[Any, ...] = ((0, (1, 2)), (0, (4, 3)), (0, (8, 3, 1, 3)), "solid")

WIDTH = 6.9
"""Inches: a little less than the text of an A4 page is wide, where a figure is as wide as the text."""
SIZE = 9.0
"""Points: the smallest size of a text."""

Measure = Callable[..., float]
"""``measure(text, size=SIZE, weight="normal")`` → its width in points, as typeset."""

PARAMETERS = {
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "font.size": SIZE,
    "text.color": INK,
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "axes.titlesize": 9.5,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.xmargin": 0.0,
    "axes.formatter.useoffset": False,
    "axes.unicode_minus": True,
    "grid.color": GRID,
    "grid.linewidth": 0.6,
    "xtick.color": INK,
    "ytick.color": INK,
    "lines.linewidth": 1.7,
    "lines.markersize": 5.5,
    "legend.frameon": False,
    "legend.fontsize": SIZE,
    "legend.handlelength": 3.6,
    "hatch.linewidth": 0.5,
    "text.hinting": "no_hinting",  # a text is as wide at any size of the picture
    "svg.hashsalt": "afmcalc",
    "pdf.compression": 9,
    "savefig.dpi": 150,
    "figure.dpi": 150,
}
"""Settings that replace matplotlib's defaults, so that a user's matplotlibrc changes nothing."""


def paint(axes: Any, chart: Chart) -> None:
    """Draw a chart into matplotlib's axes, all but what has a place beside something else."""
    x, y = chart.x, chart.y
    for area in chart.areas:
        edges = x.shown(area.x), y.shown(area.low), y.shown(area.high)
        axes.fill_between(*edges, color=SHADE, alpha=0.28, linewidth=0, label=mathtext(area.label))
    for number, line in enumerate(chart.lines):
        _line(axes, chart, line, number if line.style is None else line.style)
    for number, guide in enumerate(chart.guides):
        style = GUIDES[(number if guide.style is None else guide.style) % len(GUIDES)]
        draw, axis = (axes.axhline, y) if guide.across else (axes.axvline, x)
        how = {"color": INK, "linewidth": 1.0, "linestyle": style, "zorder": 1.5, "clip_on": False}
        draw(*axis.shown([guide.value]), label=mathtext(guide.label), **how)
    _limits(axes, chart)
    _ticks(axes)


_WORDS = re.compile(" ?[^ ]+| ")
_SIGNS = re.compile(r"\$[^$]*\$|\\?.", re.DOTALL)
"""Of a typeset text; a subscript is one sign."""


def folded(text: str, width: float, measure: Measure, parts: re.Pattern[str] = _WORDS, **font: Any) -> list[str]:
    """Fold a typeset text to a width; a word that is wider by itself is parted, nothing is cut."""
    if measure(text, **font) <= width:
        return [text]
    lines: list[str] = []
    for part in parts.findall(text):
        if lines and measure(lines[-1] + part, **font) <= width:
            lines[-1] += part
        elif parts is _WORDS and measure(part, **font) > width:
            lines += folded(part, width, measure, _SIGNS, **font)
        else:
            lines.append(part.lstrip() if lines else part)
    return lines


def _ticks(axes: Any) -> None:
    """Write the numbers on the axes in the user's language."""
    if spoken() == "en":
        return
    from matplotlib.ticker import ScalarFormatter

    class Ticks(ScalarFormatter):
        def __call__(self, value: float, place: int | None = None) -> str:
            return localized(str(super().__call__(value, place)))

    for axis in (axes.xaxis, axes.yaxis):
        if isinstance(axis.get_major_formatter(), ScalarFormatter):
            axis.set_major_formatter(Ticks())


def _line(axes: Any, chart: Chart, line: Line, style: int) -> None:
    how: dict[str, Any] = {"linestyle": DASHES[style % len(DASHES)]}
    if line.points:
        how = {"markersize": 5.0, "zorder": 4} if line.filled else _OPEN
        marker = MARKERS[(style if line.marker is None else line.marker) % len(MARKERS)]
        how = how | {"linestyle": "none", "marker": marker, "clip_on": False}
    label = (literal if chart.named else mathtext)(line.label)
    points = chart.x.shown(line.x), chart.y.shown(line.y)
    axes.plot(*points, color=COLOURS[style % len(COLOURS)], label=label, **how)


_OPEN: dict[str, Any] = {"markerfacecolor": "none", "markeredgewidth": 1.4, "zorder": 3}


def _limits(axes: Any, chart: Chart) -> None:
    """Scales and limits; a whole-number axis gets whole ticks."""
    from matplotlib.ticker import MaxNLocator

    if chart.y.log:
        axes.set_yscale("log")
    if chart.x.log:
        axes.set_xscale("log")
    if chart.from_zero and axes.get_ylim()[0] > 0:
        axes.set_ylim(bottom=0)
    values = [value for line in chart.lines for value in line.x if value is not None]
    whole = all(value == int(value) for value in values) and max(values) - min(values) <= 40
    if whole and any(line.points for line in chart.lines):
        axes.xaxis.set_major_locator(MaxNLocator(integer=True, min_n_ticks=2))
        low, top = axes.get_xlim()
        axes.set_xlim(low - 0.03 * (top - low), top + 0.03 * (top - low))
    if chart.bounds:
        axes.set_xlim(*chart.x.shown(chart.bounds[:2]))
        axes.set_ylim(*chart.y.shown(chart.bounds[2:]))


Place = tuple[float, float]


class Notes:
    """Texts set beside places of axes whose size is known: inside the figure, none over another."""

    def __init__(self, axes: Any, chart: Chart, measure: Measure) -> None:
        """Set the names of curves, guides, spans and points; the last as far as there is room."""
        self.axes, self.chart, self.measure = axes, chart, measure
        self.taken: list[tuple[float, float, float, float]] = []
        if power := axes.yaxis.offsetText.get_text():  # that the numbers on the axis are to be multiplied by
            left, top = axes.bbox.x0, axes.bbox.y1
            self.taken.append((left, top, left + measure(power), top + SIZE + 5))
        for number, span in enumerate(chart.spans):
            self._span(number, span)
        self._tags()
        self._guide_tags()
        self._names()

    @property
    def above(self) -> float:
        """Points that they reach above the axes."""
        return max(0.0, *(top - self.axes.bbox.y1 for *_, top in self.taken)) if self.taken else 0.0

    def _put(self, text: str, at: Place, offsets: Iterable[Place], lowest: float = -5.0, **how: Any) -> None:
        """Set a text, its left end by the first offset from a place at which it covers no other, or not at all."""
        transform = how.setdefault("xycoords", self.axes.transData)
        x, y = transform.transform(at)
        lines = text.splitlines()
        wide, half = max(map(self.measure, lines)), SIZE * (1.2 * len(lines) + 0.1) / 2
        for right, up in offsets:
            left = max(1.0, min(x + right, self.axes.figure.bbox.x1 - 1 - wide))
            box = left, y + up - half, left + wide, y + up + half
            free = y + up - half > self.axes.bbox.y0 + lowest
            if free and all(box[2] < a or c < box[0] or box[3] < b or d < box[1] for a, b, c, d in self.taken):
                self.taken.append(box)
                how |= {"xytext": (left - x, up), "textcoords": "offset points", "va": "center"}
                self.axes.annotate(text, at, color=INK, annotation_clip=False, **how)
                return

    def _tags(self) -> None:
        """Number the curves at their ends."""
        for line in self.chart.lines:
            ((x, y),) = zip(self.chart.x.shown(line.x[-1:]), self.chart.y.shown(line.y[-1:]), strict=True)
            if line.tag and not math.isnan(x + y):
                self._put(line.tag, (x, y), ((5, up) for up in _outwards(3)))

    def _names(self) -> None:
        """Name points: first filled points, then the ends of every line, then the points between."""
        points: dict[str, tuple[bool, bool, float, float]] = {}  # one that stands out is drawn twice, and named once
        for line in self.chart.lines:
            named = zip(line.names, self.chart.x.shown(line.x), self.chart.y.shown(line.y), strict=False)
            for place, (name, x, y) in enumerate(named):
                points[name] = not line.filled, 0 < place < len(line.names) - 1, x, y
        spots = [self.axes.transData.transform(point[2:]) for point in points.values()]
        self.taken += [(x - 2, y - 2, x + 2, y + 2) for x, y in spots]
        for name, (*_, x, y) in sorted(points.items(), key=lambda item: item[1][:2]):
            self._put(name, (x, y), [(2, 8), (-2 - self.measure(name), -8)], 0.0, zorder=5)

    def _guide_tags(self) -> None:
        """Name upright guides above the axes, in as many rows as keep the names apart."""
        for guide in sorted((guide for guide in self.chart.guides if guide.tag), key=lambda guide: guide.value):
            (x,), tag = self.chart.x.shown([guide.value]), mathtext(guide.tag)
            rows = ((-self.measure(tag) / 2, 8 + up) for up in _outwards(SIZE + 2) if up >= 0)
            self._put(tag, (x, 1), rows, xycoords=self.axes.get_xaxis_transform())

    def _span(self, number: int, span: Dimension) -> None:
        """Draw a dimension line beside the axes, with thin lines to both ends of the curve; its text right of all."""
        axes, colour, over = self.axes, COLOURS[span.style], self.axes.get_yaxis_transform()
        low, high = self.chart.y.shown((span.low, span.high))
        x = 1 + (_BESIDE + _APART * number) / axes.bbox.width
        arrow = {"arrowstyle": "<|-|>", "color": colour, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 8}
        axes.annotate("", (x, high), (x, low), xycoords=over, textcoords=over, arrowprops=arrow, annotation_clip=False)
        hairline: dict[str, Any] = {"color": colour, "linewidth": 0.6, "linestyle": (0, (1, 2)), "zorder": 1.2}
        for value in (low, high):
            axes.plot([0, x + 4 / axes.bbox.width], [value, value], transform=over, clip_on=False, **hairline)
        offsets = ((_BESIDE + _APART * len(self.chart.spans) - 4, up) for up in _outwards(2))
        self._put("\n".join(map(mathtext, span.label)), (1, (low + high) / 2), offsets, xycoords=over)


_BESIDE, _APART = 12.0, 14.0
"""Points between the axes and the first dimension line beside them, and from one to the next."""


def _outwards(step: float) -> Iterator[float]:
    """Offsets up and down from 0."""
    return (step * way * number for number in range(200) for way in ((-1, 1) if number else (1,)))


def beside(chart: Chart, measure: Measure) -> float:
    """Points that tags and spans take right of the axes."""
    tags = [5 + measure(line.tag) for line in chart.lines if line.tag]
    lines = [line for span in chart.spans for line in map(mathtext, span.label)]
    return max([0.0, *tags, *(_BESIDE + _APART * len(chart.spans) - 4 + measure(line) for line in lines)])
