"""Style of plots, and the drawing of a chart into matplotlib's axes."""

import textwrap
from collections.abc import Callable
from typing import Any

from ...messages import localized, printable
from ..symbols import marked
from .chart import Chart, Line, power

INK, GRID, SHADE = "#111111", "#d4d4d4", "#9a9a9a"
"""Colours that a page may replace (dark mode): text and axes, grid, shaded regions."""
WRONG, PAPER = "#a40e26", "#ffffff"
"""Colours of overlapping parts, and of areas that hide what is behind them; a page may replace these colours, too."""

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#aa4499", "#111111", "#e69f00", "#56b4e9")
"""Colours of Okabe and Ito; the reddish purple is darker, to stand out on white, and black is the colour of the ink."""
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
"""Width of a figure, inches: a little less than the text width of an A4 page, which the figure is to fill."""
SIZE = 9.0
"""Smallest size of a text, points."""

PARAMETERS = {
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
    "grid.color": GRID,
    "grid.linewidth": 0.6,
    "xtick.color": INK,
    "ytick.color": INK,
    "lines.linewidth": 1.7,
    "lines.markersize": 5.5,
    "legend.frameon": False,
    "legend.handlelength": 3.6,
    "legend.labelspacing": 0.3,
    "text.parse_math": False,
    "svg.hashsalt": "afmcalc",
    "svg.fonttype": "none",  # texts stay texts, not outlines
    "figure.dpi": 72,
}
"""Settings that replace matplotlib's defaults, so that a user's matplotlibrc changes nothing."""
LETTERS, TITLE, UP = 86, 72, 34
"""Largest number of letters in a line of text, of a chart's title, and of the label of an upright axis."""


def paint(axes: Any, chart: Chart) -> None:
    """Draw a chart into matplotlib's axes."""
    x, y = chart.x, chart.y
    for area in chart.areas:
        edges = x.shown(area.x), y.shown(area.low), y.shown(area.high)
        axes.fill_between(*edges, color=SHADE, alpha=0.28, linewidth=0, label=folded(area.label))
    for number, line in enumerate(chart.lines):
        _line(axes, chart, line, number if line.style is None else line.style)
    for number, guide in enumerate(chart.guides):
        style = GUIDES[(number if guide.style is None else guide.style) % len(GUIDES)]
        draw, axis = (axes.axhline, y) if guide.across else (axes.axvline, x)
        (value,) = axis.shown([guide.value])
        look: dict[str, Any] = {"color": INK, "linewidth": 1.0, "linestyle": style}
        draw(value, label=folded(guide.label), zorder=1.5, clip_on=False, **look)
        if guide.tag:
            over, tag = axes.get_xaxis_transform(), marked(guide.tag)
            axes.annotate(tag, (value, 1), xycoords=over, ha="center", va="bottom", rotation=90)
    _limits(axes, chart)
    _ticks(axes)
    axes.set_xlabel(folded(x.label))
    axes.set_ylabel(folded(y.label, UP))
    axes.set_title(folded(chart.title, TITLE))


def folded(text: str, letters: int = LETTERS, typeset: Callable[[str], str] = marked) -> str:
    """Return a text folded into lines and typeset for matplotlib."""
    return "\n".join(map(typeset, textwrap.wrap(text, letters)))


def _of_user(text: str) -> str:
    """Name given by the user, as a label; matplotlib hides a label that begins with ``_``."""
    shown = printable(text)
    return f" {shown}" if shown.startswith("_") else shown


def _ticks(axes: Any) -> None:
    """Write the numbers on the axes in the user's language."""
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
        how = {"linestyle": "none", "marker": MARKERS[style % len(MARKERS)], "clip_on": False}
        hollow = {"markerfacecolor": "none", "markeredgewidth": 1.4, "zorder": 3}
        how |= {"markersize": 5.0, "zorder": 4} if line.filled else hollow
    label = folded(line.label, typeset=_of_user if chart.named else marked)
    points = chart.x.shown(line.x), chart.y.shown(line.y)
    axes.plot(*points, color=COLOURS[style % len(COLOURS)], label=label, **how)
    named = [*zip(line.names, *points, strict=False)]
    for text, *place in dict.fromkeys([*named[:1], *named[-1:]]):
        axes.annotate(text, place, (4, 4), textcoords="offset points", annotation_clip=False)


def _limits(axes: Any, chart: Chart) -> None:
    """Set scales and limits of the axes; an axis of whole numbers gets ticks at whole numbers."""
    from matplotlib.ticker import MaxNLocator

    if chart.log:
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
