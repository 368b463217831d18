"""How plots look, and from a chart to matplotlib's axes."""

import math
import textwrap
from typing import Any

from ...messages import localized, spoken
from ..symbols import literal, mathtext
from .chart import Chart, Dimension, Line

INK, GRID, SHADE = "#111111", "#d4d4d4", "#9a9a9a"
"""Colours a page may replace by its own (dark mode): text and axes, grid, shaded regions."""

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

WIDTH = 7.0
"""Inches: the text width of an A4 page."""

PARAMETERS = {
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "font.size": 9.0,
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
    "legend.handlelength": 3.6,
    "hatch.linewidth": 0.5,
    "svg.hashsalt": "afmcalc",
    "pdf.compression": 9,
    "savefig.dpi": 150,
    "figure.dpi": 150,
}
"""Settings that replace matplotlib's defaults, so that a user's matplotlibrc changes nothing."""


def paint(axes: Any, chart: Chart) -> None:
    """Draw a chart into matplotlib's axes."""
    x, y = chart.x, chart.y
    if chart.title:
        axes.set_title(mathtext(chart.title))
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
    _tags(axes, chart)
    _names(axes, chart)
    _guide_tags(axes, chart)
    for number, span in enumerate(chart.spans):
        _span(axes, 1.035 + 0.085 * number, span, *y.shown((span.low, span.high)))
    axes.set_xlabel(mathtext(x.label))
    axes.set_ylabel("\n".join(map(mathtext, textwrap.wrap(y.label, _HIGHEST))))
    _ticks(axes)


_HIGHEST = 40
"""Largest number of letters in a line of the y-axis label; so many are as long as the axis."""


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


_AXES_WIDTH, _AXES_HEIGHT = 440, 190
"""Approximate size of the axes, points; texts are placed by it before the real size is known."""
_NAME = (19, 10)
"""Width and height that the name of a point takes, points."""


def _note(axes: Any, text: str, at: tuple[float, float], offset: tuple[float, float], **how: Any) -> None:
    """Set a text some points beside a place."""
    axes.annotate(text, at, xytext=offset, textcoords="offset points", color=INK, annotation_clip=False, **how)


def _tags(axes: Any, chart: Chart) -> None:
    """Number the curves at their ends, moved apart where they would cover each other."""
    ends = [
        (y, x, line.tag)
        for line in chart.lines
        for x, y in zip(chart.x.shown(line.x[-1:]), chart.y.shown(line.y[-1:]), strict=True)
        if line.tag and not math.isnan(x + y)
    ]
    scale = axes.yaxis.get_transform().transform
    low, top = (float(scale(limit)) for limit in axes.get_ylim())
    free = -math.inf
    for y, x, tag in sorted(ends, key=lambda end: end[0]):
        place = (float(scale(y)) - low) / (top - low) * _AXES_HEIGHT
        lifted = max(place, free)
        free = lifted + 9
        _note(axes, tag, (x, y), (5, lifted - place), va="center", fontsize=8)


def _names(axes: Any, chart: Chart) -> None:
    """Name points where there is room: first filled points, then the ends of every line, then the points between."""
    (left, right), (low, top) = axes.get_xlim(), axes.get_ylim()
    ranked = [
        (not line.filled, 0 < place < len(line.names) - 1, x, y, name)
        for line in chart.lines
        for place, (x, y, name) in enumerate(
            zip(chart.x.shown(line.x), chart.y.shown(line.y), line.names, strict=False)
        )
    ]
    taken: list[tuple[float, float]] = []
    for _, _, x, y, name in sorted(ranked, key=lambda point: point[:2]):
        spot = (x - left) / (right - left) * _AXES_WIDTH, (y - low) / (top - low) * _AXES_HEIGHT
        if all(abs(spot[0] - one) > _NAME[0] or abs(spot[1] - other) > _NAME[1] for one, other in taken):
            taken.append(spot)
            _note(axes, name, (x, y), (2, 5), fontsize=7, zorder=5)


def _guide_tags(axes: Any, chart: Chart) -> None:
    """Name upright guides above the axes, in as many rows as keep the names apart."""
    low, top = axes.get_xlim()
    ends: list[float] = []
    for guide in sorted((guide for guide in chart.guides if guide.tag), key=lambda guide: guide.value):
        (x,) = chart.x.shown([guide.value])
        place = (x - low) / (top - low) * _AXES_WIDTH
        half = 2.7 * len(guide.tag) + 3
        row = next((number for number, end in enumerate(ends) if place - half >= end), len(ends))
        ends[row : row + 1] = [place + half]
        how = {"xycoords": axes.get_xaxis_transform(), "ha": "center", "va": "bottom", "fontsize": 8}
        _note(axes, mathtext(guide.tag), (x, 1), (0, 4 + 11 * row), **how)


def _span(axes: Any, x: float, span: Dimension, low: float, high: float) -> None:
    """Draw a dimension line beside the axes, with its text, and thin lines to both ends of the curve."""
    colour, over = COLOURS[span.style], axes.get_yaxis_transform()
    arrow = {"arrowstyle": "<|-|>", "color": colour, "shrinkA": 0, "shrinkB": 0, "linewidth": 1.0, "mutation_scale": 8}
    axes.annotate("", (x, high), (x, low), xycoords=over, textcoords=over, arrowprops=arrow, annotation_clip=False)
    hairline: dict[str, Any] = {"color": colour, "linewidth": 0.6, "linestyle": (0, (1, 2)), "zorder": 1.2}
    for value in (low, high):
        axes.plot([0, x + 0.012], [value, value], transform=over, clip_on=False, **hairline)
    text = {"rotation": 90, "va": "center", "ha": "left", "fontsize": 8, "color": INK}
    axes.text(x + 0.012, (low + high) / 2, mathtext(span.label), transform=over, **text)
