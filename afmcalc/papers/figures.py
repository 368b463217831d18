"""The figures of the papers, recalculated from their formulas with the misprints mended."""

from importlib import import_module

from ..errors import AfmcalcError
from ..letters import did_you_mean
from ..result import Result, described

FIGURES = {
    "F11-2": "fokin2011",
    "S19-2": "shishkarev2019",
    "S21-2": "shishkarev2021",
    "S21-4": "shishkarev2021",
    "S22-1": "shishkarev2022",
    "S22-2": "shishkarev2022",
    "S22-3": "shishkarev2022",
    "S22-4": "shishkarev2022",
}
"""Figure → module of this package that has a function of its name (``figure_2``)."""


class PaperAxis(Result):
    """An axis of a figure."""

    name: str = described("quantity")
    symbol: str = described("symbol")
    unit: str = described("SI unit")
    log: bool = described("whether its scale is logarithmic")


class PaperCurve(Result):
    """One curve, or a row of points."""

    number: str = described("number of the curve in the paper")
    label: str = described("what it shows")
    x: list[float] = described("abscissae, SI")
    y: list[float] = described("ordinates, SI")
    points: bool = described("whether it is single points")


class PaperFigure(Result):
    """One figure: axes, curves, what was mended and what the paper leaves open."""

    name: str = described("paper and number of the figure")
    title: str = described("what it shows")
    panels: list[list[PaperCurve]] = described("curves, one list per pair of axes")
    x: PaperAxis = described("abscissa, common to all panels")
    y: list[PaperAxis] = described("ordinate of each panel")
    inputs: str = described("inputs as printed")
    corrections: list[str] = described("misprints mended, with their numbers")
    assumed: str = described("inputs the paper does not print, as chosen here")


def axis(name: str, symbol: str, unit: str = "1", *, log: bool = False) -> PaperAxis:
    """Describe an axis."""
    return PaperAxis(name=name, symbol=symbol, unit=unit, log=log)


def curve(number: str, label: str, x: object, y: object, *, points: bool = False) -> PaperCurve:
    """Take arrays as a curve; an ordinate that does not depend on x is a level line."""
    import numpy as np

    xs, ys = np.broadcast_arrays(np.asarray(x, float), np.asarray(y, float))
    return PaperCurve(number=number, label=label, x=xs.tolist(), y=ys.tolist(), points=points)


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
    module = import_module(f".{FIGURES[wanted]}", __package__)
    return getattr(module, f"figure_{wanted.partition('-')[2]}")()
