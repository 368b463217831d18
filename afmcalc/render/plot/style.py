"""How plots look: colours that colour-blind people tell apart, lines that tell them apart in grey."""

from typing import Any

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
