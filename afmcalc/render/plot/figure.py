"""A sheet set as PNG, SVG or PDF: the same sheet gives the same bytes."""

import io
import os
import sys
import textwrap
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING, Any, Literal

from ...messages import named, spoken
from ..drawing import Drawing
from ..symbols import literal, mathtext
from .chart import Chart, Sheet
from .paint import PARAMETERS, WIDTH, paint

if TYPE_CHECKING:
    from matplotlib.figure import Figure

ENDINGS = ("png", "svg", "pdf")
Ending = Literal["png", "svg", "pdf"]

_CREATOR = "afmcalc plot"
_HIGH, _LOW = 3.3, 2.5
"""Inches that axes with their labels have in a picture of its own, and in a page among others."""
_LINE = 0.165
"""Inches between lines of the caption."""
_TITLE_LINE = 0.19
"""Inches between lines of the title."""
_TITLE: dict[str, Any] = {"fontsize": 11, "fontweight": "bold"}
_MOST = 120
"""Letters of a line of the title that is all thin ones."""
_LEFT = 0.015
"""Share of the width that title and caption are set in by."""


def save(sheet: Sheet, ending: Ending, dpi: int = 150) -> bytes:
    """Return a file of a sheet with its title and caption, on white; ``dpi`` is that of a PNG.

    Without date or version: the file depends on the sheet only.
    """
    first = sheet.panels[0]
    if ending == "svg" and isinstance(first, Drawing):
        return first.captioned(sheet.title, named(sheet.name), sheet.caption).svg(sheet.title).encode("utf-8")
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
        return svg_of(figure, [_height(panel, _LOW) for panel in sheet.panels])


@contextmanager
def _settings(more: dict[str, Any] | None = None) -> Iterator[None]:
    """Our parameters over matplotlib's defaults, for a while."""
    mpl = _matplotlib()
    # a copy: the defaults carry the backend, which is not ours to set
    defaults: Any = {
        key: value for key, value in mpl.rcParamsDefault.items() if not key.startswith(("backend", "toolbar"))
    }
    with warnings.catch_warnings(), mpl.rc_context(defaults | PARAMETERS | (more or {})):
        # what the font lacks is drawn as a box, what has no room (a torque of 1e-18 N·m) beside it: that is seen
        warnings.filterwarnings("ignore", "Glyph|constrained_layout not applied")
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
    from matplotlib.figure import Figure
    from matplotlib.layout_engine import ConstrainedLayoutEngine

    heights = [_height(panel, axes_height) for panel in sheet.panels]
    drawn = isinstance(sheet.panels[0], Drawing)
    letters = 118 if spoken() == "en" and not drawn else 100  # Cyrillic letters are wider, and so are keys
    caption = [line for part in sheet.caption.splitlines() for line in textwrap.wrap(part, letters)]
    title = _title(sheet) if sheet.title else []
    more = _TITLE_LINE * (len(title) - 1)
    above = 0.34 + more if title else 0.02
    below = len(caption) * _LINE + (0.14 if caption else 0.02)
    total = sum(heights) + below + above
    figure = Figure(figsize=(WIDTH, total))
    if title:  # else it is for a page, and laid out there
        rect = 0.005, below / total, 0.99, 1 - (below + above) / total
        figure.set_layout_engine(ConstrainedLayoutEngine(rect=rect, h_pad=0.1, w_pad=0.06))
    # one grid, so that the axes of all panels stand one below the other
    grid = figure.subplots(len(heights), 1, height_ratios=heights, squeeze=False)[:, 0]
    for axes, panel in zip(grid, sheet.panels, strict=True):
        if isinstance(panel, Chart):
            paint(axes, panel)
            _legend(axes, _columns(panel.labels))
        else:
            panel.paint(axes)
    figure.text(_LEFT, 1 - (0.2 + more / 2) / total, "\n".join(title), va="center", **_TITLE)
    figure.text(_LEFT, 0.08 / total, "\n".join(map(mathtext, caption)), fontsize=8, va="bottom", linespacing=1.35)
    return figure


def _title(sheet: Sheet) -> list[str]:
    """Title and name of a sheet in a line, or each folded to the width that there is: nothing of them is cut."""
    from matplotlib.figure import Figure

    measured = Figure(figsize=(WIDTH, 1)).text(_LEFT, 0, "", **_TITLE)

    def fits(line: str) -> bool:
        measured.set_text(line)
        return bool(measured.get_window_extent().width <= (1 - 2 * _LEFT) * WIDTH * measured.figure.dpi)

    def folded(text: str, typeset: Callable[[str], str]) -> list[str]:
        every = ([*map(typeset, textwrap.wrap(text, columns))] for columns in range(_MOST, 0, -1))
        return next((lines for lines in every if all(map(fits, lines))), [])

    name = named(sheet.name)
    whole = " – ".join(filter(None, (mathtext(sheet.title), literal(name))))
    return [whole] if fits(whole) else folded(sheet.title, mathtext) + folded(name, literal)


def _height(panel: Any, axes: float) -> float:
    """Inches: what the axes have, and a line of legend for each entry or two."""
    if not isinstance(panel, Chart):
        return panel.height
    rows = -(-len(panel.labels) // _columns(panel.labels))
    return axes + 0.19 * rows + (0.2 if panel.title else 0)


def _columns(labels: list[str]) -> int:
    longest = max(map(len, labels), default=0)
    return 1 if longest > 36 or len(labels) < 3 else 2 if longest > 22 or len(labels) < 6 else 3


def _legend(axes: Any, columns: int) -> None:
    """Below the axes, where it covers nothing."""
    from matplotlib.transforms import ScaledTranslation

    handles, labels = axes.get_legend_handles_labels()
    below = axes.transAxes + ScaledTranslation(0, -37 / 72, axes.figure.dpi_scale_trans)
    axes.legend(
        handles, labels, loc="upper left", bbox_to_anchor=(0, 0), bbox_transform=below, ncols=columns, fontsize=8.5,
        borderaxespad=0, borderpad=0,
    )  # fmt: skip
