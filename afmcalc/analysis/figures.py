"""What there is to draw: each kind of plot as data, gathered from what was asked of a clutch."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from ..errors import AfmcalcError, CalculationError
from ..messages import did_you_mean
from .registry import ANALYSES, PLOTS, Plot, StressRule

if TYPE_CHECKING:
    from ..drive.result import SimulateResult
    from ..papers.figures import PaperFigure
    from .curves import AccuracyCurve, LifeCurve, OverloadCurve, TorqueCurve
    from .design.rows import DesignResult
    from .effects import EffectsCurve
    from .shop import ShopDrawing
    from .simulate import MomentRow
    from .springs.springs import SpringsCurve
    from .synthesize import SynthesisResult
    from .tolerance.result import Study

_SINGLE = {"clutch": "SPEC", "names": "NAME", "requirements": "REQUIREMENTS"}
"""What stands alone, as the help calls it."""


class Request(NamedTuple):
    """What to draw."""

    subjects: Sequence[Any]
    """``Answers`` of clutches, names of the papers' figures, or requirements."""
    sweep: str | None = None
    model: StressRule | None = None
    profile: str | None = None
    """File for the wall of a pocket, as CSV."""
    cutter: float | None = None
    """Diameter of the cutter that cuts it, m."""
    chord: float | None = None
    """How far a chord may lie off it, m."""


class PocketSection(NamedTuple):
    """The section through one ball and its pockets."""

    name: str | None
    balls: int | None
    synthesis: "SynthesisResult"


class ToleranceFigure(NamedTuple):
    """The torque of one clutch over its tolerances."""

    name: str | None
    nominal_torque: float
    seed: int
    share: float
    """Share of the distribution that the bars of the histogram hold."""
    study: "Study"


class SimulateFigure(NamedTuple):
    """An event of the drive, until its peak has passed."""

    name: str | None
    kind: str
    """Of event."""
    load: float
    """Before it, N·m."""
    result: "SimulateResult"
    courses: "list[list[MomentRow]]"
    """At f_min, mean friction and f_max."""


class ParetoFigure(NamedTuple):
    """The front of a design with two objectives or more."""

    name: str | None
    result: "DesignResult"


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
    for option in ("sweep", "model", "profile", "cutter", "chord"):
        if getattr(request, option) is not None and option not in plot.options:
            raise AfmcalcError("plot {name} has no use for --{option}", name=name, option=option)


def gathered(name: str, request: Request) -> Any:
    """Calculate what a plot shows.

    Raises:
        AfmcalcError: no such plot, subjects or options that are not for it, or an analysis that does not apply.
    """
    check_request(name, request)
    gather: Callable[[Request], Any] = globals()[f"_{name}"]
    return gather(request)


def _torque(request: Request) -> "list[TorqueCurve]":
    from .curves import torque_curve

    return [torque_curve(answers.clutch) for answers in request.subjects]


def _accuracy(request: Request) -> "list[AccuracyCurve]":
    from .curves import accuracy_curve

    return [accuracy_curve(answers.clutch, request.sweep) for answers in request.subjects]


def _overload(request: Request) -> "OverloadCurve":
    from .curves import overload_curve

    return overload_curve(request.subjects[0].clutch)


def _life(request: Request) -> "list[LifeCurve]":
    from .curves import life_curve

    curves = [life_curve(answers, request.sweep) for answers in request.subjects]
    drawn = [cycles for curve in curves for cycles in curve.series.protected]
    if len(curves) == 1:
        (only,) = curves
        drawn += [
            *only.series.unprotected,
            *only.series.protected_forecast,
            *(setting.cycles for setting in only.settings),
        ]
    if not any(drawn):
        raise CalculationError(
            "plot life: by the model {model!r} fatigue sets no limit anywhere in the range", model=curves[0].model
        )
    return curves


def _pocket(request: Request) -> PocketSection:
    (answers,) = request.subjects
    spec = answers.clutch.spec
    synthesis, _ = answers.ask("synthesize")
    return PocketSection(spec.name, spec.control_unit.balls, synthesis)


def _effects(request: Request) -> "EffectsCurve":
    from .effects import effects_curve

    return effects_curve(request.subjects[0].clutch)


def _springs(request: Request) -> "SpringsCurve":
    from .springs.springs import springs_curve

    return springs_curve(request.subjects[0].clutch)


def shop_drawing_of(name: str, request: Request) -> "ShopDrawing":
    """Lay out the pockets of a clutch for the shop; ``name``: the plot that was asked.

    Raises:
        AfmcalcError: no one clutch with a control unit, or a pocket that cannot be cut.
    """
    from .shop import shop_drawing
    from .wall import CHORD

    check_request(name, request)
    (answers,) = request.subjects
    synthesis, _ = answers.ask("synthesize")
    return shop_drawing(answers.clutch, synthesis, request.cutter, CHORD if request.chord is None else request.chord)


def _tolerance(request: Request) -> ToleranceFigure:
    from .tolerance.statistics import CENTRAL

    (answers,) = request.subjects
    study, spec = answers.study, answers.clutch.spec
    if not study.histogram.densities:
        raise CalculationError("plot tolerance: the torque does not scatter, there is no histogram")
    return ToleranceFigure(
        spec.name, float(answers.clutch.nominal_torque), spec.tolerance.seed, CENTRAL[1] - CENTRAL[0], study
    )


def _simulate(request: Request) -> SimulateFigure:
    from itertools import groupby

    from ..drive.result import SimulateResult
    from .simulate import history

    (answers,) = request.subjects
    clutch, result = answers.clutch, answers.of(SimulateResult)
    rows = history(clutch, short=True).moments
    courses = [list(course) for _, course in groupby(rows, lambda row: (row.friction, row.friction_driving))]
    return SimulateFigure(clutch.spec.name, clutch.spec.drive.event.kind, result.load_torque, result, courses)


def _pareto(request: Request) -> ParetoFigure:
    from .design.design import design

    (need,) = request.subjects
    if len(set(need.objectives)) < 2:
        raise CalculationError("plot pareto: one objective has one best clutch and no front; give two or more")
    result, findings = design(need)
    if not result.front:
        raise CalculationError(findings[0].message)
    return ParetoFigure(need.name, result)


def _paper(request: Request) -> "PaperFigure":
    from ..papers.figures import paper_figure

    return paper_figure(request.subjects[0])
