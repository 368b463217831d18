"""Every printed figure and claim of the papers recomputed: what follows from the formulas, and what does not."""

from collections.abc import Callable
from importlib import import_module
from typing import Literal

from ...errors import AfmcalcError
from ...findings import Finding
from ...result import Result, quantity
from ...spec.suggest import did_you_mean
from ..figures import FIGURES, PaperFigure, paper_figure
from ..register import PAPERS

Verdict = Literal["reproduced", "reproduced with correction", "not reproduced"]


class Row(Result):
    """One printed figure or claim."""

    id: str = quantity("", None, "id")
    source: str = quantity("", None, "source")
    inputs: str = quantity("", None, "inputs", detail=True)
    printed: str = quantity("", None, "printed")
    computed: str = quantity("", None, "computed")
    deviation: float | None = quantity("1", "dev.", "computed over printed, less 1")
    verdict: Verdict = quantity("", None, "verdict")
    correction: str | None = quantity("", None, "correction")
    why: str = quantity("", None, "why")


class CurveRow(Result):
    """One curve of a figure, recomputed."""

    figure: str = quantity("", None, "figure")
    curve: str = quantity("", None, "curve")
    label: str = quantity("", None, "what it shows")
    axes: str = quantity("", None, "axes")
    first: float = quantity("1", None, "y first")
    least: float = quantity("1", None, "y least")
    largest: float = quantity("1", None, "y largest")
    last: float = quantity("1", None, "y last")
    corrections: str = quantity("", None, "corrections", detail=True)


class CurvePoint(Result):
    """One point of a curve."""

    figure: str = quantity("", None, "figure")
    curve: str = quantity("", None, "curve")
    x: float = quantity("", None, "abscissa, SI")
    y: float = quantity("", None, "ordinate, SI")


class ReproduceResult(Result):
    """The rows asked for, and whether every verdict is the one on record."""

    rows: list[Row] = quantity("", None, "printed figures and claims")
    reproduced: int = quantity("", None, "reproduced as printed")
    corrected: int = quantity("", None, "reproduced with a correction")
    not_reproduced: int = quantity("", None, "not reproduced")
    as_expected: bool = quantity("", None, "every verdict is the one on record")
    curves: list[CurveRow] | None = quantity("", None, "curves of the figures, recomputed", optional=True)
    points: list[CurvePoint] | None = quantity("", None, "points of the curves", optional=True, data=True)


EXPECTED: dict[str, Verdict] = {
    **dict.fromkeys(("P2", "P7", "P9", "P11", "P12", "P22"), "reproduced"),
    **dict.fromkeys(("P1", "P3", "P5", "P6", "P8", "P10", "P13", "P19"), "reproduced with correction"),
    **dict.fromkeys(("P4", "P14", "P15", "P16", "P17", "P18", "P20", "P21"), "not reproduced"),
}
"""The verdict on record for every row; a different one means the formulas have changed."""

_MODULES = {"F11": "fokin2011", "S19": "shishkarev2019", "S21": "shishkarev2021", "S22": "shishkarev2022"}


def reproduce(papers: list[str], figures: list[str] | None = None) -> tuple[ReproduceResult, list[Finding]]:
    """Recompute what the papers print, in the order of its numbers, and the curves of their figures.

    Args:
        papers: keys of the papers wanted; empty for all.
        figures: figures such as ``S22-3`` whose curves are wanted with their points; None for the curves of all
            figures of those papers without points.

    Raises:
        AfmcalcError: no such paper or figure.
    """
    for paper in papers:
        if paper not in PAPERS:
            raise AfmcalcError(
                f"--paper {paper}: no such paper{did_you_mean(paper, PAPERS)}; papers: {', '.join(PAPERS)}"
            )
    rows: list[Row] = []
    for paper in papers or PAPERS:
        module = import_module(f".{_MODULES[paper]}", __name__)
        rows += [check() for check in module.CHECKS]
    rows.sort(key=lambda row: int(row.id[1:]))
    verdicts = [row.verdict for row in rows]
    unexpected = [row for row in rows if row.verdict != EXPECTED[row.id]]
    shown = [paper_figure(name) for name in figures or FIGURES if figures or not papers or name.split("-")[0] in papers]
    result = ReproduceResult(
        rows=rows,
        reproduced=verdicts.count("reproduced"),
        corrected=verdicts.count("reproduced with correction"),
        not_reproduced=verdicts.count("not reproduced"),
        as_expected=not unexpected,
        curves=[row for figure in shown for row in _curves(figure)],
        points=[point for figure in shown for point in _points(figure)] if figures else None,
    )
    findings = [
        Finding("error", "unexpected-verdict", f"{row.id}: {row.verdict}; on record is: {EXPECTED[row.id]}")
        for row in unexpected
    ]
    return result, findings


def _curves(figure: PaperFigure) -> list[CurveRow]:
    """Sum up the curves of a figure."""
    return [
        CurveRow(
            figure=figure.name,
            curve=curve.number or curve.label,
            label=curve.label,
            axes=f"{axis.symbol or axis.name} over {figure.x.symbol or figure.x.name}",
            first=curve.y[0],
            least=min(curve.y),
            largest=max(curve.y),
            last=curve.y[-1],
            corrections="; ".join(figure.corrections),
        )
        for axis, panel in zip(figure.y, figure.panels, strict=True)
        for curve in panel
    ]


def _points(figure: PaperFigure) -> list[CurvePoint]:
    return [
        CurvePoint(figure=figure.name, curve=curve.number or curve.label, x=x, y=y)
        for panel in figure.panels
        for curve in panel
        for x, y in zip(curve.x, curve.y, strict=True)
    ]


Check = Callable[[], Row]


def verdict(as_printed: bool, corrected: bool = False) -> Verdict:
    """Judge a row: it follows from the inputs as printed, or with the correction, or not at all."""
    if as_printed:
        return "reproduced"
    return "reproduced with correction" if corrected else "not reproduced"


def near(computed: float, printed: float, digits: float) -> bool:
    """Whether a computed number rounds to the printed one: ``digits`` is a unit in its last place."""
    return abs(computed - printed) <= digits


def figures(values: list[float], digits: int = 3) -> str:
    """List numbers for a cell."""
    return ", ".join(f"{value:.{digits}f}" for value in values)
