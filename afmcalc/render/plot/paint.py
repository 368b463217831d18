"""How plots look, and from a chart to matplotlib's axes."""

import textwrap
from collections.abc import Callable, Sequence
from typing import Any

from ...messages import localized, spoken
from ..symbols import literal, mathtext
from .chart import Chart, Dimension, Line, power

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
    "figure.titlesize": 11.0,
    "figure.titleweight": "bold",
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
    "mathtext.default": "regular",
    "text.hinting": "no_hinting",  # a text is as wide at any size of the picture
    "svg.hashsalt": "afmcalc",
    "svg.fonttype": "none",  # text as text
    "pdf.compression": 9,
    "savefig.dpi": 150,
    "figure.dpi": 150,
}
"""Settings that replace matplotlib's defaults, so that a user's matplotlibrc changes nothing."""


def paint(axes: Any, chart: Chart) -> None:
    """Draw a chart into matplotlib's axes."""
    x, y = chart.x, chart.y
    for area in chart.areas:
        edges = x.shown(area.x), y.shown(area.low), y.shown(area.high)
        axes.fill_between(*edges, color=SHADE, alpha=0.28, linewidth=0, label=_folded(area.label))
    for number, line in enumerate(chart.lines):
        _line(axes, chart, line, number if line.style is None else line.style)
    for number, guide in enumerate(chart.guides):
        style = GUIDES[(number if guide.style is None else guide.style) % len(GUIDES)]
        draw, axis = (axes.axhline, y) if guide.across else (axes.axvline, x)
        (value,) = axis.shown([guide.value])
        draw(value, label=_folded(guide.label), color=INK, linewidth=1.0, linestyle=style, zorder=1.5, clip_on=False)
        if guide.tag:
            over, tag = axes.get_xaxis_transform(), mathtext(guide.tag)
            axes.annotate(tag, (value, 1), xycoords=over, ha="center", va="bottom", rotation=90)
    for number, span in enumerate(chart.spans):
        _span(axes, span, y.shown((span.low, span.high)), number)
    _limits(axes, chart)
    _ticks(axes)
    axes.set_xlabel(_folded(x.label))
    axes.set_ylabel(_folded(y.label, _UP))
    axes.set_title(_folded(chart.title, _TITLE))


LETTERS, _TITLE, _UP = 90, 72, 34
"""Letters of a line of text, of a chart's title, and of the label of an upright axis."""


def _folded(text: str, letters: int = LETTERS, typeset: Callable[[str], str] = mathtext) -> str:
    return "\n".join(map(typeset, textwrap.wrap(text, letters)))


def _span(axes: Any, span: Dimension, ends: Sequence[float], number: int) -> None:
    """Draw a dimension line beside the axes, its text along it."""
    over, x, colour = axes.get_yaxis_transform(), 1.03 + 0.06 * number, COLOURS[span.style]
    how = {"xycoords": over, "textcoords": over, "annotation_clip": False, "color": colour}
    arrow = {"arrowstyle": "<|-|>", "color": colour, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", (x, ends[1]), (x, ends[0]), arrowprops=arrow, **how)
    axes.annotate(mathtext(span.label), (x + 0.01, sum(ends) / 2), ha="left", va="center", rotation=90, **how)


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
    label = _folded(line.label, typeset=literal if chart.named else mathtext)
    points = chart.x.shown(line.x), chart.y.shown(line.y)
    axes.plot(*points, color=COLOURS[style % len(COLOURS)], label=label, **how)
    named = [*zip(line.names, *points, strict=False)]
    tagged = [(line.tag, points[0][-1], points[1][-1])] if line.tag else []
    for text, *place in dict.fromkeys([*named[:1], *named[-1:], *tagged]):
        axes.annotate(text, place, (4, 4), textcoords="offset points", annotation_clip=False)


_OPEN: dict[str, Any] = {"markerfacecolor": "none", "markeredgewidth": 1.4, "zorder": 3}


def _limits(axes: Any, chart: Chart) -> None:
    """Scales and limits; a whole-number axis gets whole ticks."""
    from matplotlib.ticker import MaxNLocator

    if chart.y.log:
        axes.set_yscale("log")
        axes.yaxis.set_major_formatter(lambda value, _: power(value))
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
