"""Claims and figures of the papers, recomputed from their formulas.

Figures are recomputed with corrected formulas where the paper has misprints.
"""

from collections.abc import Mapping
from functools import cache
from importlib import import_module
from typing import Any, Literal, NamedTuple

import numpy as np

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
    """One curve, or a set of points, in SI units."""

    number: str
    """Number of the curve in the paper; empty if the paper does not number it."""
    label: str
    x: list[float]
    y: list[float]
    points: bool


class PaperFigure(NamedTuple):
    """One figure: axes, curves, corrected misprints and inputs that the paper leaves open."""

    name: str
    title: str
    panels: list[list[PaperCurve]]
    """Curves of each panel; a panel is one pair of axes."""
    x: PaperAxis
    """Abscissa, common to all panels."""
    y: list[PaperAxis]
    """The ordinate of each panel."""
    inputs: str
    """Inputs as printed in the paper."""
    corrections: list[str]
    """Misprints that are corrected here, with their numbers."""
    assumed: str = ""
    """Inputs that the paper does not print, with the values chosen here."""


class Recomputed(NamedTuple):
    """Result of recomputing one claim."""

    verdict: Verdict
    deviation: Any
    """Relative deviation, computed/printed − 1; None without a printed number."""
    values: Mapping[str, Any]
    """Values for the fields in the text ``computed`` of the claim in ``claims.toml``."""


def judged(
    as_printed: Any, corrected: Any = False, /, *, deviation: Any = None, undecided: Any = False, **values: Any
) -> Recomputed:
    """Verdict on a claim, and ``values`` for its text.

    Args:
        as_printed: True if the claim follows from the formulas and inputs as printed.
        corrected: True if the claim follows once a misprint is corrected.
        deviation: relative deviation, computed/printed − 1.
        undecided: True if the paper leaves open the inputs that decide whether the claim is true.
        values: numbers, arrays and texts by name.
    """
    verdict: Verdict = "undecided" if undecided else "not reproduced"
    if as_printed or corrected:
        verdict = "reproduced" if as_printed else "reproduced with correction"
    return Recomputed(verdict, deviation, {name: np.asarray(each).tolist() for name, each in values.items()})


def paper_figure(name: str) -> PaperFigure:
    """Figure of a paper, recomputed.

    Args:
        name: paper and number, such as ``"S22-3"``.

    Raises:
        AfmcalcError: there is no such figure, or the figure is a scheme without formula.
    """
    wanted = name.upper().replace(" ", "-")
    if wanted not in FIGURES:
        raise AfmcalcError(
            "no figure {name!r}{hint}; there are: {figures}",
            name=name, hint=did_you_mean(wanted, FIGURES), figures=", ".join(FIGURES),
        )  # fmt: skip
    entry = data("figures.toml")[wanted]
    paper, _, number = wanted.partition("-")
    curves = iter(getattr(import_module(f".{PAPERS[paper]}", __package__), f"figure_{number}")())

    def curve(number: str, label: str, *points: str) -> PaperCurve:
        x, y = np.broadcast_arrays(*(np.asarray(values, float) for values in next(curves)))
        return PaperCurve(number, label, x.tolist(), y.tolist(), bool(points))

    axes = {"x": PaperAxis(**entry["x"]), "y": [PaperAxis(**axis) for axis in entry["y"]]}
    panels = [[curve(*about) for about in panel] for panel in entry["panels"]]
    return PaperFigure(wanted.replace("-", " fig. "), **entry | axes | {"panels": panels})


def near(computed: Any, printed: float, digits: float) -> Any:
    """True if a computed number differs from the printed number by at most ``digits``."""
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
    """Claims of the papers with their recorded verdicts; if a verdict differs now, the formulas have changed."""
    return data("claims.toml")["claim"]


def claims(papers: list[str], figures: list[str] | None = None) -> tuple[ReproduceResult, list[Finding]]:
    """Recompute the claims of the papers, in the order of their numbers, and the curves of their figures.

    Args:
        papers: keys of the papers; empty for all papers.
        figures: figures, such as ``S22-3``, whose curves are returned with points; None for the curves of all figures
            of ``papers``, without points.

    Raises:
        AfmcalcError: there is no such paper or figure.
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
        points=[
            CurvePoint(figure=figure.name, curve=curve.number or curve.label, x=x, y=y)
            for figure in shown
            for panel in figure.panels
            for curve in panel
            for x, y in zip(curve.x, curve.y, strict=True)
        ] if figures else None,
    )  # fmt: skip
    return result, findings


def _curves(figure: PaperFigure) -> list[CurveRow]:
    """Rows that summarise the curves of a figure: first, smallest, largest and last value of each curve."""
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
