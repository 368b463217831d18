"""Data of each kind of plot: curves over friction or over a swept key, or the result of an analysis."""

from collections.abc import Sequence
from itertools import groupby
from typing import Any, NamedTuple

import numpy as np
from pydantic import field_validator

from ..engines import Clutch
from ..equations.arrays import Floats
from ..errors import AfmcalcError, CalculationError, given
from ..messages import did_you_mean
from ..papers.claims import paper_figure
from ..result import quantity
from ..spec.keys import is_whole
from ..spec.models import Method
from .accuracy_factor import AccuracySweep
from .adjust import METHODS, AdjustResult
from .asking import Answers, Asking, answer, asked, asked_by
from .assembly import section
from .design import DesignResult, design
from .drive_result import SimulateResult
from .fatigue import LifeResult, LifeSweep, band_axis, life_sweep
from .pocket_contours import shop_drawing
from .registry import PLOTS, Plot, StressRule
from .simulate import MomentRow, history
from .sweep import Axis, S, current_value, find_key, parse_axis, series
from .tolerance_study import ToleranceResult
from .trip import OverloadSweep, refuse

POINTS = 201
"""Number of points of a curve, so that it looks smooth on paper."""
_SINGLE = {"clutch": "SPEC", "names": "NAME", "search": "SPEC"}
"""Input of plots that take exactly one argument → name of the argument in the help."""


class Request(NamedTuple):
    """Request for a plot."""

    subjects: Sequence[Any]
    """``Answers`` of clutches, names of the papers' figures, or specs with [search]."""
    sweep: str | None = None
    model: StressRule | None = None


class ClutchCurve(Asking):
    """Base class of curves, with name and variant of the clutch to which the curve belongs."""

    name: str | None
    variant: str

    @field_validator("*", mode="before")
    @classmethod
    def _listed(cls, value: Any) -> Any:
        return value.tolist() if isinstance(value, np.ndarray) else value


class TorqueCurve(ClutchCurve):
    """Slip torque as f_1 and f_2 rise together, each from its minimum to its maximum."""

    friction: list[float] = asked()
    friction_driving: list[float] | None = asked(optional=True)
    torque: list[float] = asked(description="slip torque, spring as set")
    torque_min_friction: list[float] = quantity("N*m", "T_1", "slip torque, set at f_min")
    torque_mean_friction: list[float] = quantity("N*m", "T_2", "slip torque, set at mean f with margin")
    breakaway_torque: list[float] | None = asked(
        description="breakaway torque, upper bound (gain above its limit)", optional=True
    )
    torque_returning: list[float] | None = asked(
        description="slip torque, friction falling again under load", optional=True
    )
    nominal_torque: float = asked()
    margin: float = asked()
    method: Method


class AccuracyCurve(ClutchCurve):
    """Accuracy over one key, with the clutch's own value of the key and its gain limit, if it has them."""

    series: AccuracySweep
    about: str
    symbol: str
    unit: str
    own: float | None
    accuracy_factor: float = asked()
    limit: float | None


class SettingLife(NamedTuple):
    """Scatter band, N·m, and cycles of the protected side with the spring set by one method."""

    method: Method
    scatter: float
    cycles: float | None


class LifeCurve(ClutchCurve):
    """Life over the scatter band, and the band and life of the clutch as each method sets it."""

    model: StressRule
    series: LifeSweep
    base_cycles: float = asked()
    settings: list[SettingLife]


class OverloadCurve(ClutchCurve):
    """Torques of the trip over friction (S22), spring set at f_min, and the accuracy over the reduced gain."""

    friction: list[float] = asked()
    expected_torque: list[float] = asked(description="expected slip torque")
    actuation_torque_published: list[float] = asked()
    actuation_torque_equilibrium: list[float] = asked()
    potential_torque: list[float] = asked()
    machine_torque: float = asked("machine_torque_at_overload")
    margin: float = asked()
    accuracy: OverloadSweep
    bypass_pairs: int = asked()
    reduced_gain: float = asked()
    optimal_reduced_gain: float = asked()


def torque_curve(clutch: Clutch) -> TorqueCurve:
    """Calculate the torque from f_min to f_max three times: spring as set, set at f_min, and set at mean friction."""
    path = _path(clutch)
    there, (first, *_) = clutch.at(**path), path.values()
    by_min, by_mean = (clutch.at(case).at(**path)["torque"] for case in METHODS.values())
    beyond = (there["breakaway_torque"] > there["torque"] * (1 + 1e-9)).any()
    return answer(
        TorqueCurve, there, **_of(clutch), friction=first, torque_min_friction=by_min, torque_mean_friction=by_mean,
        friction_driving=path.get("friction_driving"), method=clutch.spec.adjustment.method,
        **({} if beyond else {"breakaway_torque": None}),
    )  # fmt: skip


def accuracy_curve(clutch: Clutch, sweep: str | None) -> AccuracyCurve:
    """Calculate the accuracy factor over the gain, or over the key named in ``sweep``.

    A range in ``sweep`` is kept; a default range is refined, and extended to the clutch's present value of the key.
    """
    text = sweep or "C"
    axis = parse_axis(text, clutch.spec)
    key = axis.key
    # present value of the key, even if the clutch calculates it from other keys
    follows = {"control_unit.gain": clutch["gain"], "closing_spring.force": clutch["closing_force"]}
    value = follows.get(key.path, current_value(clutch.spec, key.path))
    current = None if value is None else float(value) / axis.scale
    if "=" not in text and not is_whole(key.path):
        ends = [float(axis.values.min()), float(axis.values.max()), *([] if current is None else [current])]
        axis = axis._replace(values=np.linspace(min(ends), max(ends), POINTS))
    limit = clutch.get("gain_limit") if key.path == "control_unit.gain" else None
    of_zc = axis.name == "zC"
    return answer(
        AccuracyCurve, clutch, **_of(clutch), series=_over(axis, AccuracySweep, clutch),
        about="reduced gain" if of_zc else key.description, symbol="zC" if of_zc else key.symbol or "",
        unit=key.unit or "1", own=current, limit=None if limit is None else limit / axis.scale,
    )  # fmt: skip


def overload_curve(clutch: Clutch) -> OverloadCurve:
    """Calculate the trip from f_min to f_max, and the accuracy over the reduced gain.

    The reduced gain goes from 0 to its recommended limit 5, or to 1.2 times the clutch's reduced gain, if greater.
    Raises CalculationError if S22 does not treat the variant, or unlike materials.
    """
    refuse(clutch)
    gains = np.linspace(0.0, max(5.0, 1.2 * clutch["reduced_gain"]), 401)
    axis = Axis("zC", find_key("C", clutch.spec), gains, 1 / clutch["controlled_pairs"])
    trip = clutch.at(**_path(clutch))
    return answer(OverloadCurve, trip, **_of(clutch), accuracy=_over(axis, OverloadSweep, clutch))


def life_curve(answers: Answers, sweep: str | None) -> LifeCurve:
    """Calculate the life over the scatter band: from half to twice the clutch's band, or over the range in ``sweep``.

    Raises AfmcalcError if ``sweep`` names another axis than dT, or if the torque is constant.
    """
    clutch, text = answers.clutch, sweep or "dT"
    if (name := text.partition("=")[0].strip()) != "dT":
        raise AfmcalcError(
            "plot life: its axis is the scatter band dT, not {name!r} (dT=RANGE sets its range)", name=name
        )
    axis = band_axis(text, clutch)
    if "=" not in text:
        low, high = float(axis.values.min()), float(axis.values.max())
        if not high > low:
            raise CalculationError("plot life: the friction does not wander, there is no band: give --sweep dT=RANGE")
        axis = axis._replace(values=np.linspace(low, high, POINTS))
    life, both = answers.of(LifeResult), answers.of(AdjustResult)
    (over,) = life_sweep(clutch, life.model, [axis], life.dynamic_factor)
    settings = [
        SettingLife("min-friction", both.min_friction.scatter, life.protected.min_friction),
        SettingLife("mean-friction", both.mean_friction.scatter, life.protected.mean_friction),
    ]
    return answer(LifeCurve, clutch, **_of(clutch), model=life.model, series=over, settings=settings)


def _of(clutch: Clutch) -> dict[str, Any]:
    """Name and variant of a clutch."""
    return {"name": clutch.spec.name, "variant": clutch.spec.variant}


def _over(axis: Axis, kind: type[S], clutch: Clutch) -> S:
    """Sweep over one axis, of class ``kind``: values of the quantities that its fields name."""
    return given(series(kind, clutch.spec, [axis], asked_by(kind, clutch)))[0]


def _path(clutch: Clutch) -> dict[str, Floats]:
    """Name → frictions from smallest to largest value (CalculationError if constant); f_1 and f_2 rise together."""
    if not any(group.max > group.min for group in clutch.spec.friction.groups):
        raise CalculationError("the friction does not wander (min = max): there is no curve over it")
    first, second = clutch.path(np.linspace(0.0, 1.0, POINTS))
    if not clutch.spec.friction.unlike:
        return {"friction": first}
    return {"friction_driving": first, "friction_driven": second}


class ToleranceFigure(NamedTuple):
    """Data of the histogram of a clutch's torque under its tolerances."""

    name: str | None
    nominal_torque: float
    seed: int
    result: ToleranceResult


class SimulateFigure(NamedTuple):
    """Data of the plot of an event of the drive, until the peak has passed."""

    name: str | None
    kind: str
    """Kind of the event."""
    result: SimulateResult
    courses: list[list[MomentRow]]
    """Moments of the event, in order of time, at each of f_min, mean friction and f_max."""


class ParetoFigure(NamedTuple):
    """Data of the plot of a Pareto front, with two objectives or more."""

    name: str | None
    result: DesignResult


def plot_of(name: str) -> Plot:
    """Return the plot called ``name``; raises AfmcalcError if there is no such plot."""
    if name not in PLOTS:
        hint, kinds = did_you_mean(name, PLOTS), ", ".join(PLOTS)
        raise AfmcalcError("no plot {name!r}{hint}; there are: {kinds}", name=name, hint=hint, kinds=kinds)
    return PLOTS[name]


def check_request(name: str, request: Request) -> None:
    """Raise AfmcalcError if there is no such plot, or if it does not take several subjects or an option."""
    plot, count = plot_of(name), len(request.subjects)
    if plot.takes in _SINGLE and count != 1:
        what = _SINGLE[plot.takes]
        raise AfmcalcError("plot {name} takes one {what}, not {count}", name=name, what=what, count=count)
    for option in ("sweep", "model"):
        if getattr(request, option) is not None and option not in plot.options:
            raise AfmcalcError("plot {name} has no use for --{option}", name=name, option=option)


def gathered(name: str, request: Request) -> Any:
    """Return the data of a plot; raises AfmcalcError if the request does not fit, or its analysis does not apply."""
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
            return shop_drawing(subject.clutch, subject.ask("pocket")[0])  # raises an error without balls
        case "tolerance":
            spec, study = subject.clutch.spec, subject.of(ToleranceResult)
            if not study.histogram:
                raise CalculationError("plot tolerance: the torque does not scatter, there is no histogram")
            return ToleranceFigure(spec.name, float(subject.clutch.nominal_torque), spec.tolerance.seed, study)
        case "simulate":
            spec, event = subject.clutch.spec, subject.of(SimulateResult)
            rows = history(subject.clutch, short=True).moments
            courses = [list(course) for _, course in groupby(rows, lambda row: (row.friction, row.friction_driving))]
            return SimulateFigure(spec.name, spec.drive.event.kind, event, courses)
        case "pareto":
            result, findings = design(subject)
            if len(set(result.objectives)) < 2:
                raise CalculationError("plot pareto: one objective has one best clutch and no front; give two or more")
            if not result.front:
                raise CalculationError(findings[0].message)
            return ParetoFigure(subject.name, result)
        case _:  # "paper", the only name left in PLOTS
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
