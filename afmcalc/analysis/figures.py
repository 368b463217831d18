"""Data of each kind of plot, gathered from the answers of a clutch."""

from collections.abc import Sequence
from itertools import groupby
from typing import Any, NamedTuple

from ..errors import AfmcalcError, CalculationError
from ..messages import did_you_mean
from ..papers.claims import paper_figure
from ..spec import Spec
from .answers import Answers
from .curves import LifeCurve, accuracy_curve, life_curve, overload_curve, torque_curve
from .design import DesignResult, design
from .drive_result import SimulateResult
from .effects import effects_curve
from .registry import ANALYSES, PLOTS, Plot, StressRule
from .section import section
from .shop import shop_drawing
from .simulate import MomentRow, history
from .springs import springs_curve
from .tolerance_result import ToleranceResult

_SINGLE = {"clutch": "SPEC", "names": "NAME", "search": "SPEC"}
"""Name of the one argument of a plot, as the help calls it."""


class Request(NamedTuple):
    """Request for a drawing."""

    subjects: Sequence[Any]
    """``Answers`` of clutches, names of the papers' figures, or specs with [search]."""
    sweep: str | None = None
    model: StressRule | None = None


class ToleranceFigure(NamedTuple):
    """The torque of one clutch over its tolerances."""

    name: str | None
    nominal_torque: float
    seed: int
    result: ToleranceResult


class SimulateFigure(NamedTuple):
    """An event of the drive, until its peak has passed."""

    name: str | None
    kind: str
    """Of event."""
    load: float
    """Before it, N·m."""
    result: SimulateResult
    courses: list[list[MomentRow]]
    """At f_min, mean friction and f_max."""


class ParetoFigure(NamedTuple):
    """The front of a design with two objectives or more."""

    name: str | None
    result: DesignResult


def plot_of(name: str) -> Plot:
    """Return the plot of a name: its own, that of the command whose result it draws, or "front".

    Raises:
        AfmcalcError: there is none.
    """
    of_commands = {each.name: each.plot for each in ANALYSES.values() if each.plot}
    plots = of_commands | {"front": PLOTS["pareto"]} | PLOTS
    if name not in plots:
        raise AfmcalcError(
            "no plot {name!r}{hint}; there are: {kinds}",
            name=name,
            hint=did_you_mean(name, plots),
            kinds=", ".join(PLOTS),
        )
    return plots[name]


def check_request(name: str, request: Request) -> None:
    """Refuse subjects or options that are not for a plot.

    Raises:
        AfmcalcError: no such plot, or what is refused.
    """
    plot = plot_of(name)
    if plot.takes in _SINGLE and len(request.subjects) != 1:
        raise AfmcalcError(
            "plot {name} takes one {what}, not {count}",
            name=name,
            what=_SINGLE[plot.takes],
            count=len(request.subjects),
        )
    for option in ("sweep", "model"):
        if getattr(request, option) is not None and option not in plot.options:
            raise AfmcalcError("plot {name} has no use for --{option}", name=name, option=option)


def gathered(name: str, request: Request) -> Any:
    """Calculate what a plot shows.

    Raises:
        AfmcalcError: no such plot, subjects or options that are not for it, or an analysis that does not apply.
    """
    check_request(name, request)
    subject = request.subjects[0]
    match name:
        case "section":
            return section(subject)
        case "torque":
            return [torque_curve(answers.clutch) for answers in request.subjects]
        case "accuracy":
            return [accuracy_curve(answers.clutch, request.sweep) for answers in request.subjects]
        case "overload":
            return overload_curve(subject.clutch)
        case "life":
            return _life(request)
        case "pocket":
            return shop_drawing(subject.clutch, subject.ask("pocket")[0])  # which refuses a clutch without balls
        case "effects":
            return effects_curve(subject.clutch)
        case "springs":
            return springs_curve(subject.clutch)
        case "tolerance":
            return _tolerance(subject)
        case "simulate":
            return _simulate(subject)
        case "pareto":
            return _pareto(subject)
        case _:  # the last of PLOTS, "paper"
            return paper_figure(subject)


def _life(request: Request) -> list[LifeCurve]:
    curves = [life_curve(answers, request.sweep) for answers in request.subjects]
    drawn = [cycles for curve in curves for cycles in curve.series.protected]
    if len(curves) == 1:
        (only,) = curves
        drawn += [*only.series.unprotected, *only.series.protected_forecast, *(each.cycles for each in only.settings)]
    if not any(drawn):
        raise CalculationError(
            "plot life: by the model {model!r} fatigue sets no limit anywhere in the range", model=curves[0].model
        )
    return curves


def _tolerance(answers: Answers) -> ToleranceFigure:
    result, spec = answers.of(ToleranceResult), answers.clutch.spec
    if not result.histogram:
        raise CalculationError("plot tolerance: the torque does not scatter, there is no histogram")
    assert spec.tolerance is not None
    return ToleranceFigure(spec.name, float(answers.clutch.nominal_torque), spec.tolerance.seed, result)


def _simulate(answers: Answers) -> SimulateFigure:

    spec, result = answers.clutch.spec, answers.of(SimulateResult)
    rows = history(answers.clutch, short=True).moments
    courses = [list(course) for _, course in groupby(rows, lambda row: (row.friction, row.friction_driving))]
    assert spec.drive.event is not None
    return SimulateFigure(spec.name, spec.drive.event.kind, result.load_torque, result, courses)


def _pareto(spec: Spec) -> ParetoFigure:
    result, findings = design(spec)
    if len(set(result.objectives)) < 2:
        raise CalculationError("plot pareto: one objective has one best clutch and no front; give two or more")
    if not result.front:
        raise CalculationError(findings[0].message)
    return ParetoFigure(spec.name, result)
