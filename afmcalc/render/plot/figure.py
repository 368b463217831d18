"""A sheet as PNG, SVG or PDF: the same sheet gives the same bytes."""

import io
import textwrap
from typing import TYPE_CHECKING, Any

from ...messages import named
from ..drawing import Drawing
from ..svg import picture, svg
from ..symbols import literal, mathtext
from .chart import Chart, Sheet
from .paint import LETTERS, PARAMETERS, SIZE, WIDTH, paint

if TYPE_CHECKING:
    from matplotlib.figure import Figure

CREATOR = "afmcalc plot"
_HIGH, _LINE = 3.0, 1.5 * SIZE / 72
"""Inches of a chart without its legend, and of a line of text."""
_TITLE, _COLUMN = 62, 36
"""Letters of a line of the title, and of an entry of a legend in two columns."""


def save(sheet: Sheet, ending: str) -> bytes:
    """Return a file of a sheet with its title and caption, on white.

    Without date or version: the file depends on the sheet only.
    """
    if isinstance(sheet.panels[0], Drawing):
        return picture(sheet.panels[0].captioned(sheet.title, named(sheet.name), sheet.below), ending, sheet.title)
    return _drawn(sheet, ending, {})


def inline_svg(panel: Drawing | Chart) -> str:
    """Return a drawing or a chart as SVG for a page: without title and caption, see-through."""
    if isinstance(panel, Drawing):
        return svg(panel)
    return _drawn(Sheet("", [panel]), "svg", {"savefig.transparent": True}).decode()


def _drawn(sheet: Sheet, ending: str, settings: dict[str, Any]) -> bytes:
    """Draw charts by matplotlib; its own settings, and those of a user, are put aside."""
    from matplotlib import style

    metadata: dict[str, dict[str, Any]] = {
        "png": {"Software": CREATOR},
        "svg": {"Date": None, "Creator": CREATOR},
        "pdf": {"CreationDate": None, "ModDate": None, "Creator": CREATOR, "Producer": None},
    }
    content = io.BytesIO()
    with style.context([PARAMETERS | settings], after_reset=True):
        figure_of(sheet, ending).savefig(content, format=ending, metadata=metadata[ending])
    return content.getvalue()


def figure_of(sheet: Sheet, ending: str = "png") -> "Figure":
    """Lay charts out one below the other, each with its legend, between title and caption."""
    from matplotlib.backends.backend_svg import FigureCanvasSVG
    from matplotlib.figure import Figure
    from matplotlib.layout_engine import ConstrainedLayoutEngine

    title = [
        *map(mathtext, textwrap.wrap(sheet.title, _TITLE)),
        *map(literal, textwrap.wrap(named(sheet.name), _TITLE)),
    ]
    caption = [mathtext(line) for part in sheet.below.splitlines() for line in textwrap.wrap(part, LETTERS)]
    columns = [2 if all(len(label) <= _COLUMN for label in chart.labels) else 1 for chart in sheet.panels]
    heights = [
        _HIGH + _LINE * sum(-(-len(label) // LETTERS) for label in chart.labels) / count
        for chart, count in zip(sheet.panels, columns, strict=True)
    ]
    figure = Figure(figsize=(WIDTH, sum(heights) + _LINE * (1.5 * len(title) + len(caption))))
    parts = figure.subfigures(len(sheet.panels), height_ratios=heights, squeeze=False)[:, 0]
    for part, chart, count in zip(parts, sheet.panels, columns, strict=True):
        axes = part.subplots()
        paint(axes, chart)
        if chart.labels:
            part.legend(*axes.get_legend_handles_labels(), loc="outside lower left", ncols=count)
    if title:
        figure.suptitle("\n".join(title), x=0.01, ha="left")
    if caption:
        figure.supxlabel("\n".join(caption), x=0.01, ha="left", size=SIZE)
    if ending == "svg":  # laid out here: a figure that keeps its layout engine is drawn twice
        FigureCanvasSVG(figure)
        ConstrainedLayoutEngine().execute(figure)
    else:
        figure.set_layout_engine("constrained")
    return figure
