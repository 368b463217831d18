"""A sheet set as PNG, SVG or PDF: the same sheet gives the same bytes."""

import io
import os
import sys
import warnings
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING, Any, Literal

from ...messages import named
from ..drawing import Drawing
from ..symbols import literal, mathtext
from .chart import Chart, Sheet
from .paint import PARAMETERS, SIZE, WIDTH, Measure, Notes, beside, folded, paint

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Ending = Literal["png", "svg", "pdf"]

_CREATOR = "afmcalc plot"
_HIGH, _LOW = 2.6, 2.05
"""Inches that axes have in a picture of its own, and in a page among others."""
_EDGE, _GAP = 5.0, 7.0
"""Points left free round all that is drawn, and between what stands one below the other."""
_LINE = 1.2
"""Height of a line of text over its size."""
_TITLE, _HEAD = 11.0, 9.5
"""Sizes of the title, and of those of panels."""


def save(sheet: Sheet, ending: Ending, dpi: int = 150) -> bytes:
    """Return a file of a sheet with its title and caption, on white; ``dpi`` is that of a PNG.

    Without date or version: the file depends on the sheet only.
    """
    first = sheet.panels[0]
    if ending == "svg" and isinstance(first, Drawing):
        return first.captioned(sheet.title, named(sheet.name), sheet.below).svg(sheet.title).encode("utf-8")
    metadata: dict[str, dict[str, Any]] = {
        "png": {"Software": _CREATOR},
        "svg": {"Date": None, "Creator": _CREATOR},
        "pdf": {"CreationDate": None, "ModDate": None, "Creator": _CREATOR, "Producer": None},
    }
    content = io.BytesIO()
    with _settings({"savefig.dpi": dpi}):
        _figure(sheet).savefig(content, format=ending, metadata=metadata[ending])
    return content.getvalue()


def inline_svg(sheet: Sheet) -> str:
    """Set a sheet for a page: without title and caption, see-through, its texts as text."""
    if isinstance(sheet.panels[0], Drawing):
        return sheet.panels[0].svg()
    with _settings({"svg.fonttype": "none", "savefig.facecolor": "none"}):
        from .inline import svg_of

        figure = _figure(Sheet("", sheet.panels), _LOW)
        figure.patch.set_alpha(0)
        for axes in figure.axes:
            axes.patch.set_alpha(0)
        return svg_of(figure)


@contextmanager
def _settings(more: dict[str, Any] | None = None) -> Iterator[None]:
    """Our parameters over matplotlib's defaults, for a while."""
    mpl = _matplotlib()
    # a copy: the defaults carry the backend, which is not ours to set
    defaults: Any = {
        key: value for key, value in mpl.rcParamsDefault.items() if not key.startswith(("backend", "toolbar"))
    }
    with warnings.catch_warnings(), mpl.rc_context(defaults | PARAMETERS | (more or {})):
        # what the font lacks is drawn as a box: that is seen
        warnings.filterwarnings("ignore", "Glyph")
        yield


def _matplotlib() -> Any:
    """Import matplotlib, also where MPLBACKEND names no backend: it is for others who import it too, we use none."""
    named = None if "matplotlib" in sys.modules else os.environ.pop("MPLBACKEND", None)
    import matplotlib as mpl

    if named:
        os.environ["MPLBACKEND"] = named
        with suppress(ValueError):
            mpl.rcParams["backend"] = named
    return mpl


def _figure(sheet: Sheet, axes_height: float = _HIGH) -> "Figure":
    """Lay a sheet out: axes of one width and a given height; what stands round them is measured and has its room."""
    from matplotlib.figure import Figure

    from .inline import measuring

    figure = Figure(figsize=(WIDTH, 1), dpi=72)
    measure, wide = measuring(figure), 72 * WIDTH
    rooms = []
    for panel in sheet.panels:
        # as wide as the figure at first: what is placed by a share of the width then stands no further out
        chart = isinstance(panel, Chart)
        axes = figure.add_axes((0, 0, 1, axes_height if chart else panel.height))
        rooms.append(_chart(axes, panel, measure) if chart else _drawing(axes, panel))
    left, right = (_EDGE + max(each) for each in list(zip(*rooms, strict=True))[:2])
    highs = [axes.bbox.height for axes in figure.axes]
    # from the top down: how the upper end of what stands there is set, and where it is, in points
    tops: list[tuple[Callable[[float], None], float]] = []
    ends: list[float] = []

    def write(texts: Iterable[str], end: float, **font: Any) -> float:
        lines = [line for text in texts for line in folded(text, wide - 2 * _EDGE, measure, **font)]
        written = figure.text(_EDGE / wide, 0, "\n".join(lines), va="top", **font)
        tops.append((written.set_y, end))
        return end + written.get_window_extent().height

    title = " – ".join(filter(None, (mathtext(sheet.title), literal(named(sheet.name)))))
    end = write([title], _EDGE, size=_TITLE, weight="bold")
    for axes, high, panel, (_, _, below) in zip(figure.axes, highs, sheet.panels, rooms, strict=True):
        axes.set_position((left / wide, 0, 1 - (left + right) / wide, high / 72))
        end += _GAP * (2 if ends else end > _EDGE) + _above(axes, panel, measure) + high
        ends.append(end)
        end += below
        if isinstance(panel, Chart) and panel.labels:
            set_top, legend_height = _legend(axes, wide - left - _EDGE, measure)
            tops.append((set_top, end + _GAP))
            end += _GAP + legend_height
    if sheet.below:
        end = write(map(mathtext, sheet.below.splitlines()), end + _GAP)
    total = end + _EDGE
    figure.set_size_inches(WIDTH, total / 72)
    for set_top, top in tops:
        set_top(1 - top / total)
    for axes, high, end in zip(figure.axes, highs, ends, strict=True):
        axes.set_position((left / wide, 1 - end / total, 1 - (left + right) / wide, high / total))
    return figure


def _drawing(axes: Any, panel: Any) -> tuple[float, float, float]:
    """Draw a panel that is no chart; return the points that its texts reach out left, right and below."""
    panel.paint(axes)
    wide, high = axes.figure.bbox.width, axes.get_position().height
    left = right = 0.0
    for _ in range(_TRIES):  # what stands beside it moves with it, but keeps its size
        around = axes.get_tightbbox()
        beyond = max(0.0, -around.x0), max(0.0, around.x1 - wide)
        if not any(beyond):
            break
        left, right = left + beyond[0], right + beyond[1]
        axes.set_position((left / wide, 0, 1 - (left + right) / wide, high))
    return left, right, max(0.0, -around.y0)


_TRIES = 4


def _chart(axes: Any, chart: Chart, measure: Measure) -> tuple[float, float, float]:
    """Draw a chart with its axes' labels; return the points that it takes left, right and below."""
    from matplotlib.transforms import ScaledTranslation

    paint(axes, chart)
    wide, high = axes.bbox.size
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_label_coords(0, 0)  # else matplotlib measures all ticks again for each
    across, up = (axis.get_tightbbox() for axis in (axes.xaxis, axes.yaxis))
    left, right, below = _GAP / 2 - up.x0, max(across.x1 - wide, beside(chart, measure)), _GAP / 2 - across.y0
    for axis, label, width, at, moved in (
        (axes.xaxis, chart.x.label, wide - left - right, (0.5, 0), (0, -below)),
        (axes.yaxis, chart.y.label, high, (0, 0.5), (-left, 0)),
    ):
        move = ScaledTranslation(moved[0] / 72, moved[1] / 72, axes.figure.dpi_scale_trans)
        axis.set_label_coords(*at, axes.transAxes + move)
        axis.set_label_text("\n".join(folded(mathtext(label), width, measure)))
    tall, flat = (_LINE * SIZE * (1 + axis.label.get_text().count("\n")) for axis in (axes.yaxis, axes.xaxis))
    return left + tall, right, below + flat


def _above(axes: Any, panel: Any, measure: Measure) -> float:
    """Set what stands above axes whose width is known, or beside a place in them; return the points it takes above."""
    if not isinstance(panel, Chart):
        return max(0.0, axes.get_tightbbox().y1 - axes.bbox.y1)
    above = max(SIZE / 2, Notes(axes, panel, measure).above)
    if not panel.title:
        return above
    title = folded(mathtext(panel.title), axes.bbox.width, measure, size=_HEAD, weight="bold")
    axes.set_title("\n".join(title), y=1, pad=above + 2)
    return above + 2 + len(title) * _LINE * _HEAD


def _legend(axes: Any, width: float, measure: Measure) -> tuple[Callable[[float], None], float]:
    """Set a legend in as many columns as there is room for; return how to set its top, and its height."""
    handles, labels = axes.get_legend_handles_labels()
    sample, between = 4.4 * SIZE, 2 * SIZE  # of the line with the gap after it, and of the gap between columns
    columns = int((width + between) // (max(map(measure, labels)) + sample + between))
    legend = axes.figure.legend(
        handles, ["\n".join(folded(label, width - sample, measure)) for label in labels], loc="upper left",
        bbox_to_anchor=(0, 0), ncols=min(max(1, columns), 3), borderaxespad=0, borderpad=0,
    )  # fmt: skip
    left = axes.get_position().x0
    return lambda top: legend.set_bbox_to_anchor((left, top)), float(legend.get_window_extent().height)
