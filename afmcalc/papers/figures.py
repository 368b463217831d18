"""The figures of the papers, recalculated from their formulas with the misprints mended."""

from importlib import import_module
from typing import NamedTuple

from ..errors import AfmcalcError
from ..messages import did_you_mean
from . import PAPERS

FIGURES = ("F11-2", "S19-2", "S21-2", "S21-4", "S22-1", "S22-2", "S22-3", "S22-4")
"""Paper and number of each; its module (``PAPERS``) has a function of its number, ``figure_2``."""


class PaperAxis(NamedTuple):
    """An axis of a figure."""

    name: str
    symbol: str
    unit: str = "1"
    log: bool = False


class PaperCurve(NamedTuple):
    """One curve, or a row of points, in SI units."""

    number: str
    """Its number in the paper."""
    label: str
    x: list[float]
    y: list[float]
    points: bool = False


class PaperFigure(NamedTuple):
    """One figure: axes, curves, what was mended and what the paper leaves open."""

    name: str
    title: str
    panels: list[list[PaperCurve]]
    """Curves, one list per pair of axes."""
    x: PaperAxis
    """Common to all panels."""
    y: list[PaperAxis]
    """The ordinate of each panel."""
    inputs: str
    """As printed."""
    corrections: list[str]
    """Misprints mended, with their numbers."""
    assumed: str = ""
    """Inputs that the paper does not print, as chosen here."""


def curve(number: str, label: str, x: object, y: object, *, points: bool = False) -> PaperCurve:
    """Take arrays as a curve; an ordinate that does not depend on x is a level line."""
    import numpy as np

    xs, ys = np.broadcast_arrays(np.asarray(x, float), np.asarray(y, float))
    return PaperCurve(number, label, xs.tolist(), ys.tolist(), points)


def paper_figure(name: str) -> PaperFigure:
    """Calculate a figure of the papers.

    Args:
        name: paper and number, such as ``"S22-3"``.

    Raises:
        AfmcalcError: no such figure, or one that shows a scheme and no formula.
    """
    wanted = name.upper().replace(" ", "-")
    if wanted not in FIGURES:
        raise AfmcalcError(
            "no figure {name!r}{hint}; there are: {figures}",
            name=name,
            hint=did_you_mean(wanted, FIGURES),
            figures=", ".join(FIGURES),
        )
    paper, _, number = wanted.partition("-")
    return getattr(import_module(f".{PAPERS[paper]}", __package__), f"figure_{number}")()
