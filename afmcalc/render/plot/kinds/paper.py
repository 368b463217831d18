"""The papers' figures, redrawn from the formulas, their corrections named in the caption."""

from ....papers.figures.interface import PaperAxis, PaperCurve, PaperFigure
from ..chart import Chart, ChartAxis, Line, Sheet


def sheet(found: PaperFigure) -> Sheet:
    """Draw one figure of the papers."""
    x = _axis(found.x)
    panels = [
        Chart(x, _axis(y), [_line(curve) for curve in curves]) for y, curves in zip(found.y, found.panels, strict=True)
    ]
    return Sheet(f"{found.name}: {found.title}", panels, _caption(found))


def _axis(axis: PaperAxis) -> ChartAxis:
    return ChartAxis(axis.name, axis.symbol, axis.unit, axis.log)


def _line(curve: PaperCurve) -> Line:
    label = f"{curve.number}: {curve.label}" if curve.number else curve.label
    return Line(label, curve.x, curve.y, tag=curve.number, points=curve.points)


def _caption(found: PaperFigure) -> str:
    mended = "; ".join(found.corrections)
    assumed = f"\nNot printed, assumed here: {found.assumed}" if found.assumed else ""
    return f"{found.inputs}\nMended: {mended}.{assumed}"
