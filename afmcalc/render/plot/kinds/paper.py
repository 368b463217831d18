"""The papers' figures, redrawn from the formulas, their corrections named in the caption."""

from ....messages import joined, term, told, translate
from ....papers.figures.interface import PaperAxis, PaperCurve, PaperFigure
from ..chart import Chart, ChartAxis, Line, Sheet


def sheet(found: PaperFigure) -> Sheet:
    """Draw one figure of the papers."""
    x = _axis(found.x)
    panels = [
        Chart(x, _axis(y), [_line(curve) for curve in curves]) for y, curves in zip(found.y, found.panels, strict=True)
    ]
    return Sheet(f"{translate(found.name)}: {translate(found.title)}", panels, _caption(found))


def _axis(axis: PaperAxis) -> ChartAxis:
    return ChartAxis(translate(axis.name), axis.symbol, axis.unit, axis.log)


def _line(curve: PaperCurve) -> Line:
    shown = translate(curve.label)
    label = f"{curve.number}: {shown}" if curve.number else shown
    return Line(label, curve.x, curve.y, tag=curve.number, points=curve.points)


def _caption(found: PaperFigure) -> str:
    mended = told("Mended: {mended}.", mended=joined(map(term, found.corrections), "; "))
    lines = [translate(found.inputs), mended]
    if found.assumed:
        lines.append(told("Not printed, assumed here: {assumed}", assumed=term(found.assumed)))
    return "\n".join(lines)
