"""Claims and figures of the papers, recomputed from their formulas.

Figures are recalculated with the misprints mended.
"""

from collections.abc import Mapping
from functools import cache
from importlib import import_module
from typing import Literal, NamedTuple

from ..errors import AfmcalcError
from ..findings import Finding, finding
from ..messages import did_you_mean, filled, say, translate
from ..result import Answer, Result, described, quantity
from . import FIGURES, PAPERS
from .register import check_papers, data

Verdict = Literal["reproduced", "reproduced with correction", "not reproduced", "undecided"]


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
    points: bool


class PaperFigure(NamedTuple):
    """One figure: axes, curves, corrected misprints and inputs that the paper leaves open."""

    name: str
    title: str
    panels: list[list[PaperCurve]]
    """Curves, one list per pair of axes."""
    x: PaperAxis
    """Common to all panels."""
    y: list[PaperAxis]
    """The ordinate of each panel."""
    inputs: str
    """Inputs as printed."""
    corrections: list[str]
    """Misprints mended, with their numbers."""
    assumed: str = ""
    """Inputs that the paper does not print, as chosen here."""


class Recomputed(NamedTuple):
    """One claim recomputed."""

    values: Mapping[str, object]
    """Numbers of its sentence in ``claims.toml``."""
    as_printed: bool
    """True if it follows from the inputs as printed."""
    corrected: bool = False
    """True if it follows with the correction."""
    deviation: float | None = None
    """Computed over printed, less 1."""
    undecided: bool = False
    """True if the paper leaves open the inputs that decide it."""

    @property
    def verdict(self) -> Verdict:
        """Verdict on the claim."""
        if self.as_printed:
            return "reproduced"
        return "reproduced with correction" if self.corrected else "undecided" if self.undecided else "not reproduced"


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
            name=name, hint=did_you_mean(wanted, FIGURES), figures=", ".join(FIGURES),
        )  # fmt: skip
    import numpy as np

    entry = data("figures.toml")[wanted]
    paper, _, number = wanted.partition("-")
    curves = iter(getattr(import_module(f".{PAPERS[paper]}", __package__), f"figure_{number}")())

    def curve(number: str, label: str, *points: str) -> PaperCurve:
        x, y = np.broadcast_arrays(*(np.asarray(values, float) for values in next(curves)))
        return PaperCurve(number, label, x.tolist(), y.tolist(), bool(points))

    axes = {"x": PaperAxis(**entry["x"]), "y": [PaperAxis(**axis) for axis in entry["y"]]}
    panels = [[curve(*about) for about in panel] for panel in entry["panels"]]
    return PaperFigure(wanted.replace("-", " fig. "), **entry | axes | {"panels": panels})


def near(computed: float, printed: float, digits: float) -> bool:
    """True if a computed number rounds to the printed one: ``digits`` is a unit in its last place."""
    return abs(computed - printed) <= digits


class Row(Result):
    """One printed figure or claim."""

    id: str = described("id")
    source: str = described("source")
    inputs: str = described("inputs")
    printed: str = described("printed")
    computed: str = described("computed")
    deviation: float | None = quantity("1", "dev.", "relative deviation: computed/printed − 1")
    verdict: Verdict = described("verdict")
    correction: str | None = described("correction")
    why: str = described("why")


class CurveRow(Result):
    """One curve of a figure, recomputed."""

    figure: str = described("figure")
    curve: str = described("curve")
    label: str = described("what it shows")
    axes: str = described("axes")
    first: float = quantity("1", None, "y first")
    least: float = quantity("1", None, "y least")
    largest: float = quantity("1", None, "y largest")
    last: float = quantity("1", None, "y last")
    corrections: str = described("corrections", detail=True)


class CurvePoint(Result):
    """One point of a curve."""

    figure: str = described("figure")
    curve: str = described("curve")
    x: float = described("abscissa, SI")
    y: float = described("ordinate, SI")


class ReproduceResult(Answer):
    """The rows asked for, and whether every verdict is the one on record."""

    rows: list[Row] = described("printed figures and claims")
    reproduced: int = described("reproduced as printed")
    corrected: int = described("reproduced with a correction")
    not_reproduced: int = described("not reproduced")
    undecided: int = described("left open by the paper")
    as_expected: bool = described("all verdicts agree with those on record")
    curves: list[CurveRow] | None = described("curves of the figures, recomputed", optional=True)
    points: list[CurvePoint] | None = described("points of the curves", optional=True, data=True)


@cache
def recorded_claims() -> list[dict[str, str]]:
    """Claims of the papers, with the verdict on record; a different one means the formulas have changed."""
    return data("claims.toml")["claim"]


def claims(papers: list[str], figures: list[str] | None = None) -> tuple[ReproduceResult, list[Finding]]:
    """Recompute what the papers print, in the order of its numbers, and the curves of their figures.

    Args:
        papers: keys of the papers wanted; empty for all.
        figures: figures such as ``S22-3`` whose curves are wanted with their points; None for the curves of all
            figures of those papers without points.

    Raises:
        AfmcalcError: no such paper or figure.
    """
    check_papers(papers)
    modules = [import_module(f".{PAPERS[paper]}", __package__) for paper in papers or PAPERS]
    rows, findings = list[Row](), list[Finding]()
    for entry in recorded_claims():
        for module in modules:
            if recompute := getattr(
                module, entry["id"].lower(), None
            ):  # p1 of a paper's module recomputes its claim P1
                found = recompute()
                text = filled(entry["computed"], found.values)
                own = {"computed": text, "deviation": found.deviation, "verdict": found.verdict}
                rows.append(Row(**{"correction": None, **entry, **own}))
                if found.verdict != entry["verdict"]:
                    record = entry["verdict"]
                    findings.append(
                        finding("unexpected-verdict", "error", row=entry["id"], verdict=found.verdict, record=record)
                    )
    verdicts = [row.verdict for row in rows]
    shown = [paper_figure(name) for name in figures or FIGURES if figures or not papers or name.split("-")[0] in papers]
    result = ReproduceResult(
        rows=rows, reproduced=verdicts.count("reproduced"), corrected=verdicts.count("reproduced with correction"),
        not_reproduced=verdicts.count("not reproduced"), undecided=verdicts.count("undecided"),
        as_expected=not findings, curves=[row for figure in shown for row in _curves(figure)],
        points=[point for figure in shown for point in _points(figure)] if figures else None,
    )  # fmt: skip
    return result, findings


def _curves(figure: PaperFigure) -> list[CurveRow]:
    """Sum up the curves of a figure."""
    x = figure.x.symbol or translate(figure.x.name)
    return [
        CurveRow(
            figure=figure.name, curve=curve.number or curve.label, label=curve.label,
            axes=say("{y} over {x}", y=y, x=x), first=curve.y[0], least=min(curve.y), largest=max(curve.y),
            last=curve.y[-1], corrections="; ".join(map(translate, figure.corrections)),
        )
        for axis, panel in zip(figure.y, figure.panels, strict=True)
        for y in [axis.symbol or translate(axis.name)]
        for curve in panel
    ]  # fmt: skip


def _points(figure: PaperFigure) -> list[CurvePoint]:
    return [
        CurvePoint(figure=figure.name, curve=curve.number or curve.label, x=x, y=y)
        for panel in figure.panels
        for curve in panel
        for x, y in zip(curve.x, curve.y, strict=True)
    ]
