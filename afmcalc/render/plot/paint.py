"""How plots look, and from a chart to matplotlib's axes."""

import math
import textwrap
from typing import Any

from ...messages import localized, spoken
from ..symbols import literal, mathtext
from ..units import factor
from .chart import Chart, Line

INK, GRID, SHADE = "#111111", "#d4d4d4", "#9a9a9a"
"""Colours a page may replace by its own (dark mode): text and axes, grid, shaded regions."""

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#aa4499", "#111111", "#e69f00", "#56b4e9")
"""Okabe and Ito's, the reddish purple darkened to stand out on white; black among them is the ink."""
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
"""Set over matplotlib's own defaults, so that a user's matplotlibrc changes nothing."""


def paint(axes: Any, chart: Chart) -> None:
    """Draw a chart into matplotlib's axes."""
    wide, high = factor(chart.x.unit), factor(chart.y.unit)
    if chart.title:
        axes.set_title(mathtext(chart.title))
    for area in chart.areas:
        axes.fill_between(
            _scaled(area.x, wide), _scaled(area.low, high), _scaled(area.high, high),
            color=SHADE, alpha=0.28, linewidth=0, label=mathtext(area.label),
        )  # fmt: skip
    for number, line in enumerate(chart.lines):
        _line(axes, line, number if line.style is None else line.style, wide, high, chart.named)
    for number, guide in enumerate(chart.guides):
        draw = axes.axhline if guide.across else axes.axvline
        draw(
            guide.value * (high if guide.across else wide), color=INK, linewidth=1.0,
            linestyle=GUIDES[(number if guide.style is None else guide.style) % len(GUIDES)],
            label=mathtext(guide.label), zorder=1.5, clip_on=False,
        )  # fmt: skip
    _limits(axes, chart, wide, high)
    _tags(axes, chart, wide, high)
    _names(axes, chart, wide, high)
    _guide_tags(axes, chart, wide)
    for number, span in enumerate(chart.spans):
        _span(axes, number, span, high)
    axes.set_xlabel(mathtext(chart.x.label))
    axes.set_ylabel("\n".join(map(mathtext, textwrap.wrap(chart.y.label, _HIGHEST))))
    _ticks(axes)


_HIGHEST = 40
"""Letters of a label beside the axes that are as high as these."""


def _ticks(axes: Any) -> None:
    """Write the numbers on the axes as people of the user's language do."""
    if spoken() == "en":
        return
    from matplotlib.ticker import ScalarFormatter

    class Ticks(ScalarFormatter):
        def __call__(self, value: float, place: int | None = None) -> str:
            return localized(str(super().__call__(value, place)))

    for axis in (axes.xaxis, axes.yaxis):
        if isinstance(axis.get_major_formatter(), ScalarFormatter):
            axis.set_major_formatter(Ticks())


def _line(axes: Any, line: Line, style: int, wide: float, high: float, named: bool) -> None:
    colour = COLOURS[style % len(COLOURS)]
    x, y = _scaled(line.x, wide), _scaled(line.y, high)
    label = (literal if named else mathtext)(line.label)
    if line.points:
        axes.plot(
            x, y, linestyle="none", color=colour, label=label, clip_on=False,
            marker=MARKERS[(style if line.marker is None else line.marker) % len(MARKERS)],
            **({"markersize": 5.0, "zorder": 4} if line.filled else _OPEN),
        )  # fmt: skip
    else:
        axes.plot(x, y, color=colour, linestyle=DASHES[style % len(DASHES)], label=label)


_OPEN: dict[str, Any] = {"markerfacecolor": "none", "markeredgewidth": 1.4, "zorder": 3}


def _scaled(values: Any, scale: float) -> list[float]:
    return [float("nan") if value is None else value * scale for value in values]


def _limits(axes: Any, chart: Chart, wide: float, high: float) -> None:
    """Scales and limits; a whole-number axis gets whole ticks."""
    from matplotlib.ticker import MaxNLocator

    if chart.y.log:
        axes.set_yscale("log")
    if chart.x.log:
        axes.set_xscale("log")
    if chart.from_zero and axes.get_ylim()[0] > 0:
        axes.set_ylim(bottom=0)
    if any(line.points for line in chart.lines) and _whole(chart):
        axes.xaxis.set_major_locator(MaxNLocator(integer=True, min_n_ticks=2))
        low, top = axes.get_xlim()
        axes.set_xlim(low - 0.03 * (top - low), top + 0.03 * (top - low))
    if chart.bounds:
        axes.set_xlim(*(end * wide for end in chart.bounds[:2]))
        axes.set_ylim(*(end * high for end in chart.bounds[2:]))


def _tags(axes: Any, chart: Chart, wide: float, high: float) -> None:
    """Number the curves at their ends, moved apart where they would cover each other."""
    ends = [
        (line.x[-1] * wide, line.y[-1] * high, line.tag)
        for line in chart.lines
        if line.tag and line.x[-1] is not None and line.y[-1] is not None
    ]
    scale, limits = axes.yaxis.get_transform().transform, axes.get_ylim()
    low, top = (float(scale(limit)) for limit in limits)
    free = -math.inf
    for x, y, tag in sorted(ends, key=lambda end: end[1]):
        place = (float(scale(y)) - low) / (top - low) * _AXES_POINTS
        lifted = max(place, free)
        free = lifted + 9
        axes.annotate(
            tag, (x, y), xytext=(5, lifted - place), textcoords="offset points", va="center", color=INK, fontsize=8,
            annotation_clip=False,
        )  # fmt: skip


def _names(axes: Any, chart: Chart, wide: float, high: float) -> None:
    """Name points where there is room: those that stand out, then the ends of every line, then what lies between."""
    (left, right), (low, top) = axes.get_xlim(), axes.get_ylim()
    taken: list[tuple[float, float]] = []
    named = [line for line in chart.lines if line.names]
    ranked = [
        (not line.filled, min(place, len(line.names) - 1 - place) > 0, x * wide, y * high, name)
        for line in named
        for place, (x, y, name) in enumerate(zip(line.x, line.y, line.names, strict=True))
        if x is not None and y is not None
    ]
    for _, _, x, y, name in sorted(ranked, key=lambda each: each[:2]):
        spot = (x - left) / (right - left) * _AXES_WIDTH, (y - low) / (top - low) * _AXES_POINTS
        if all(abs(spot[0] - one) > _NAME[0] or abs(spot[1] - other) > _NAME[1] for one, other in taken):
            taken.append(spot)
            axes.annotate(name, (x, y), xytext=(2, 5), textcoords="offset points", color=INK, fontsize=7,
                          annotation_clip=False, zorder=5)  # fmt: skip


_NAME = (19, 10)
"""Room of a name, points."""

_AXES_POINTS = 190
"""Height of the axes of a chart, about, for what must be known before they are laid out."""


_AXES_WIDTH = 440


def _guide_tags(axes: Any, chart: Chart, wide: float) -> None:
    """Name upright guides above the axes, in as many rows as keep the names apart."""
    low, top = axes.get_xlim()
    ends: list[float] = []
    for guide in sorted((guide for guide in chart.guides if guide.tag), key=lambda guide: guide.value):
        place = (guide.value * wide - low) / (top - low) * _AXES_WIDTH
        half = 2.7 * len(guide.tag) + 3
        row = next((number for number, end in enumerate(ends) if place - half >= end), len(ends))
        ends[row : row + 1] = [place + half]
        axes.annotate(
            mathtext(guide.tag), (guide.value * wide, 1), xycoords=axes.get_xaxis_transform(), xytext=(0, 4 + 11 * row),
            textcoords="offset points", ha="center", va="bottom", color=INK, fontsize=8, annotation_clip=False,
        )  # fmt: skip


def _whole(chart: Chart) -> bool:
    values = [value for line in chart.lines for value in line.x if value is not None]
    return all(value == int(value) for value in values) and max(values) - min(values) <= 40


def _span(axes: Any, number: int, span: Any, high: float) -> None:
    """Set a dimension line beside the axes, its text along it, with hairlines to the curve's ends."""
    x = 1.035 + 0.085 * number
    colour = COLOURS[span.style]
    low, top = span.low * high, span.high * high
    over = axes.get_yaxis_transform()
    arrow = {"arrowstyle": "<|-|>", "color": colour, "shrinkA": 0, "shrinkB": 0, "linewidth": 1.0, "mutation_scale": 8}
    axes.annotate("", (x, top), (x, low), xycoords=over, textcoords=over, arrowprops=arrow, annotation_clip=False)
    for value in (low, top):
        axes.plot([0, x + 0.012], [value, value], transform=over, color=colour, linewidth=0.6, linestyle=(0, (1, 2)),
                  clip_on=False, zorder=1.2)  # fmt: skip
    axes.text(
        x + 0.012, (low + top) / 2, mathtext(span.label), transform=over, rotation=90, va="center", ha="left",
        fontsize=8, color=INK,
    )  # fmt: skip
