"""Claims and figures of the papers, recomputed from their formulas.

Figures are recomputed with corrected formulas where the paper has misprints.
"""

from collections.abc import Iterator, Mapping
from importlib import import_module
from typing import Any, Literal, NamedTuple, TypeAlias

import numpy as np

from ..equations.arrays import Values
from ..errors import AfmcalcError
from ..findings import Finding, finding
from ..messages import did_you_mean, filled, say, translate
from ..result import Answer, Result, described, quantity
from . import FIGURES, PAPERS
from .register import check_papers, data

Curves: TypeAlias = Iterator[tuple[Values, Values]]
"""Abscissas and ordinates of each curve of a figure."""
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

    It follows from the formulas and inputs as printed, or once a misprint is corrected, or the paper leaves open the
    inputs that decide. ``deviation``: relative deviation, computed/printed − 1.
    """
    verdict: Verdict = "undecided" if undecided else "not reproduced"
    if as_printed or corrected:
        verdict = "reproduced" if as_printed else "reproduced with correction"
    return Recomputed(verdict, deviation, {name: np.asarray(each).tolist() for name, each in values.items()})


def paper_figure(name: str) -> PaperFigure:
    """Figure of a paper by paper and number such as ``S22-3``, recomputed.

    Raises AfmcalcError if there is no such figure, or if the figure is a scheme without formula.
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


def claims(papers: list[str], figures: list[str] | None = None) -> tuple[ReproduceResult, list[Finding]]:
    """Recompute the claims of ``papers`` (keys; empty: all), in the order of their numbers, and the curves of figures.

    The curves are those of ``figures``, with points, or None: of all figures of ``papers``, without points. Raises
    AfmcalcError if there is no such paper or figure.
    """
    check_papers(papers)
    modules = (import_module(f".{PAPERS[paper]}", __package__) for paper in papers or PAPERS)
    recomputing = {name: each for module in modules for name, each in vars(module).items()}
    rows, findings = list[Row](), list[Finding]()
    for entry in data("claims.toml")["claim"]:  # if a verdict differs from the record, the formulas have changed
        if recompute := recomputing.get(entry["id"].lower()):  # p1 recomputes the claim P1
            verdict, deviation, values = recompute()
            own = {"computed": filled(entry["computed"], values), "deviation": deviation, "verdict": verdict}
            rows.append(Row(**{"correction": None, **entry, **own}))
            if verdict != entry["verdict"]:
                told = {"row": entry["id"], "verdict": verdict, "record": entry["verdict"]}
                findings.append(finding("unexpected-verdict", "error", **told))
    verdicts = [row.verdict for row in rows]
    shown = [paper_figure(name) for name in figures or FIGURES if figures or not papers or name.split("-")[0] in papers]
    curves, points = list[CurveRow](), list[CurvePoint]()
    for figure in shown:
        mended = "; ".join(map(translate, figure.corrections))
        for axis, panel in zip(figure.y, figure.panels, strict=True):
            y, x = (each.symbol or translate(each.name) for each in (axis, figure.x))
            for number, label, xs, ys, _ in panel:
                name, ends = {"figure": figure.name, "curve": number or label}, {"first": ys[0], "last": ys[-1]}
                ends |= {"least": min(ys), "largest": max(ys)}
                axes = say("{y} over {x}", y=y, x=x)
                curves.append(CurveRow(**name, **ends, label=label, axes=axes, corrections=mended))
                points += [CurvePoint(**name, x=x, y=y) for x, y in zip(xs, ys, strict=True)] if figures else []
    result = ReproduceResult(
        rows=rows, reproduced=verdicts.count("reproduced"), corrected=verdicts.count("reproduced with correction"),
        not_reproduced=verdicts.count("not reproduced"), undecided=verdicts.count("undecided"),
        as_expected=not findings, curves=curves, points=points if figures else None,
    )  # fmt: skip
    return result, findings
