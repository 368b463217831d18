"""Every analysis there is, as one record: what commands, schemas, explanations, plots and reports are read off.

Nothing is imported until it is asked for, so that a start-up may read the list.
"""

from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

if TYPE_CHECKING:
    from ..engines import Clutch

StressRule = Literal["mean-stress", "amplitude", "goodman"]
"""Rules for the damaging stress of a life: the paper's, Серенсен–Кинасошвили's, Goodman's."""

SpringOrder = Literal["length", "wear", "mass"]
"""Quantity that is least in the springs listed first."""
SpringKind = Literal["any", "disc", "coil"]

Takes = Literal["clutch", "clutches", "names", "search"]


class Plot(NamedTuple):
    """Plot of an analysis: ``figures.NAME`` gathers it, ``render.plot`` lays it out."""

    name: str
    about: str
    """Description for the help."""
    takes: Takes = "clutches"
    """Input: one clutch, one or more, words (the papers' figures), or a spec with [search]."""
    options: tuple[str, ...] = ()
    """Options it heeds; any other that is given is refused."""
    applies: Callable[["Clutch"], bool] = lambda clutch: True


Told = str | Callable[[Any], str]
"""A template over the fields of a result, or a function of the result that chooses one."""


class Section(NamedTuple):
    """Section of a report on an analysis, in whole sentences."""

    title: str
    about: Told
    """Subject of the calculation."""
    conclusion: Told
    """Conclusion from the result."""
    sources: tuple[str, ...] = ()
    """Keys of the references it rests on."""
    sources_indirect: tuple[str, ...] = ()
    """The same for an indirect clutch, where its law is another."""
    applies: Callable[["Clutch"], bool] = lambda clutch: True
    """True if a report speaks of it, of what can be asked."""


class Analysis(NamedTuple):
    """One thing to ask; ``home`` is the module, from the package, that holds the function of that name."""

    name: str
    home: str
    result: str
    """Class of its result, in ``home``."""
    group: str
    """Commands that belong together: what a command takes."""
    applies: Callable[[Any], bool] = lambda clutch: True
    """True if a clutch can be asked."""
    options: tuple[str, ...] = ()
    """Its arguments beside the clutch, of those that ``Answers`` has."""
    explained: bool = False
    """True if its steps can be shown."""
    judged: bool = False
    """True if ``check`` takes in its findings."""
    section: Section | None = None
    plot: Plot | None = None
    example: str | None = None
    """Example that is calculated where no SPEC is given, for what the built-in base clutch does not have."""

    @property
    def function(self) -> Callable[..., Any]:
        """The function that gives result and findings."""
        return getattr(import_module(f"..{self.home}", __package__), self.name)

    @property
    def result_class(self) -> Any:
        """The class of its result."""
        return getattr(import_module(f"..{self.home}", __package__), self.result)


def _can_be_simulated(clutch: "Clutch") -> bool:
    return clutch.spec.drive.event is not None


def _can_be_synthesized(clutch: "Clutch") -> bool:
    unit = clutch.spec.control_unit
    return unit is not None and unit.ball_circle_radius is not None and bool(clutch["gain"] > 0)


def _heat_is_known(clutch: "Clutch") -> bool:
    from ..spec.models import missing_of

    return _can_be_simulated(clutch) or not missing_of(clutch.spec.drive)


def _slips(found: Any) -> str:
    if found.onset_torque is None:
        return (
            "Set for a nominal torque of the clutch of {nominal_torque:.5g N·m}, it slips at {torque.min:.5g N·m} at "
            "the smallest and at {torque.max:.5g N·m} at the largest friction."
        )
    return (
        "Set for a nominal torque of the clutch of {nominal_torque:.5g N·m}, it slips at {torque.min:.5g N·m} at the "
        "smallest and at {torque.max:.5g N·m} at the largest friction. It is loaded in two stages: the bypass pairs "
        "alone carry up to {onset_torque.min:.5g N·m} at the smallest and {onset_torque.max:.5g N·m} at the largest "
        "friction, then the balls take their share and the release force arises."
    )


def _heated(found: Any) -> str:
    if None in (found.energy.min, found.energy.mean, found.energy.max):
        return (
            "At some friction the slip has not ended: the motor carries the clutch, or the time that is simulated is "
            "too short."
        )
    if found.temperature is None:
        return "A trip gives {energy.min:.4g kJ} at the smallest and {energy.max:.4g kJ} at the largest friction."
    return (
        "A trip gives {energy.min:.4g kJ} at the smallest and {energy.max:.4g kJ} at the largest friction, and warms "
        "the discs by {temperature_rise.min:.4g} and {temperature_rise.max:.4g} K."
    )


def _any_effect(clutch: "Clutch") -> bool:
    from .effects import SOURCES

    return any(not source.missing(clutch) for source in SOURCES.values())


def _narrower(found: Any) -> str:
    if found.narrower == "equal":
        return "Both settings of the spring give the same band."
    if found.narrower == "min-friction":
        return "The spring set at f_min gives the narrower band."
    if found.mean_friction.holds_nominal:
        return "The spring set at the mean friction gives the narrower band."
    return (
        "The spring set at the mean friction gives the narrower band, but with it the clutch slips below its nominal "
        "torque in service: where that torque must be carried, set the spring at f_min."
    )


def _ball(found: Any) -> str:
    if found.ball_diameter_standard is None:
        return "The wall angle is {wall_angle:.4g deg}; no ball of the list is large enough."
    return "The wall angle is {wall_angle:.4g deg}, the diameter of the ball {ball_diameter_standard:.5g mm}."


def _lasting(found: Any) -> str:
    stresses = found.stress_protected, found.stress_unprotected
    if None in stresses:
        return "The largest load reaches the strength of the shaft: it breaks at once."
    if max(stresses) <= found.endurance_limit:
        return (
            "With the dynamic factor {dynamic_factor:.4g} behind the clutch the damaging stress is "
            "{stress_protected:.4g MPa} on the protected and {stress_unprotected:.4g MPa} on the unprotected side, "
            "below the endurance limit {endurance_limit:.4g MPa}: fatigue does not limit the life of the shaft."
        )
    return (
        "With the dynamic factor {dynamic_factor:.4g} behind the clutch the damaging stress is "
        "{stress_protected:.4g MPa} on the protected and {stress_unprotected:.4g MPa} on the unprotected side, the "
        "endurance limit {endurance_limit:.4g MPa}: fatigue limits the life of the shaft."
    )


ANALYSES: dict[str, Analysis] = {
    each.name: each
    for each in (
        Analysis(
            "torque", "analysis.torque", "TorqueResult", "clutch", explained=True,
            section=Section(
                "Torque and forces",
                "The slipping clutch at the smallest, the mean and the largest friction, spring as set.",
                _slips,
                ("F11",), ("S21",),
            ),
            plot=Plot("torque", "torque against friction, scatter band, both adjustment methods"),
        ),
        Analysis(
            "accuracy", "analysis.accuracy", "AccuracyResult", "clutch", explained=True,
            section=Section(
                "Accuracy",
                "K_т is the largest over the smallest torque in service; 1 would be perfect.",
                "The accuracy factor is K_т = {accuracy_factor:.4g}; an ordinary clutch in its place would have "
                "K_т,0 = {conventional_accuracy_factor:.4g}.",
                ("F11", "S22"), ("S21",),
            ),
            plot=Plot(
                "accuracy", "accuracy factor against any key, --sweep NAME[=RANGE]", options=("sweep",),
                applies=lambda clutch: clutch.spec.kind.controlled,
            ),
        ),
        Analysis(
            "adjust", "analysis.adjust", "AdjustResult", "clutch", explained=True,
            section=Section(
                "Both settings of the spring",
                "The same nominal torque, reached at the smallest friction or, with the margin, at the mean friction.",
                _narrower, ("S19",),
            ),
        ),
        Analysis(
            "overload", "analysis.overload", "OverloadResult", "clutch",
            lambda clutch: clutch.spec.kind.overload and not clutch.spec.friction.unlike, explained=True,
            section=Section(
                "Overload",
                "What the drive sees when the clutch, set with a margin over the machine's torque, begins to slip.",
                "With the margin β_н = {margin:g} the nominal torque of the machine may be {machine_torque:.5g N·m}; "
                "the clutch trips at {actuation_torque_equilibrium.min:.5g N·m} to "
                "{actuation_torque_equilibrium.max:.5g N·m}, and at a higher torque where the release force lags the "
                "load.",
                ("S22",),
            ),
            plot=Plot("overload", "trip over friction, and accuracy over the reduced gain (S22 fig. 3)", "clutch"),
        ),
        Analysis(
            "pocket", "analysis.synthesize", "SynthesisResult", "clutch", _can_be_synthesized, explained=True,
            judged=True,
            section=Section(
                "Control unit", "Wall angle, ball and pocket for the gain; the contact held against what it may carry.",
                _ball, ("S21",),
            ),
            plot=Plot(
                "pocket", "section through ball and pockets, to scale; .dxf and .svg for the shop", "clutch",
            ),
        ),
        Analysis(
            "life", "analysis.life", "LifeResult", "clutch", lambda clutch: clutch.spec.fatigue is not None,
            ("model", "answers"), explained=True, judged=True,
            section=Section(
                "Life", "Cycles to failure on both sides of the clutch, by the rule {model}.", _lasting, ("S19",),
            ),
            plot=Plot("life", "cycles against the scatter band", options=("sweep", "model")),
        ),
        Analysis(
            "simulate", "analysis.simulate", "SimulateResult", "drive", _can_be_simulated,
            section=Section(
                "Drive",
                "The given event of the drive in time: peaks, slip, heat; against an ordinary clutch of equal T_н.",
                "At the largest friction the torque in the shaft reaches {peak_torque.max:.5g N·m}, with an ordinary "
                "clutch {peak_torque_conventional.max:.5g N·m}.",
            ),
            judged=True,
            plot=Plot("simulate", "torques, speeds and travel over time when the clutch trips", "clutch"),
            example="drive",
        ),
        Analysis(
            "heat", "analysis.heat", "HeatResult", "drive", _heat_is_known, ("answers",), explained=True,
            judged=True,
            section=Section(
                "Heat and wear", "What one trip turns into heat, what it warms the discs by, and how often it may be.",
                _heated, ("CJ",),
            ),
            example="drive",
        ),
        Analysis(
            "effects", "analysis.effects", "EffectsResult", "drive", _any_effect, judged=True,
            section=Section(
                "What the law neglects",
                "Each effect as what the torque and K_т lie between, springs as set; the bypass pairs are farthest "
                "from the spring, an inner disc is behind the first pair.",
                "By the law alone K_т is {accuracy_factor:.4g}; the table says what each effect may make of it.",
                ("Fi68", "F11"), ("Fi68", "S21"),
            ),
            plot=Plot("effects", "torque with each effect that the law neglects", "clutch", applies=_any_effect),
            example="drive",
        ),
        Analysis(
            "springs", "analysis.spring_search", "SpringsResult", "drive",
            section=Section(
                "Springs",
                "The springs named, as set and in service; η is the largest share used of range or stress allowed.",
                "In service, without an event, the springs use {utilisation:.3g} at most of the deflection and stress "
                "allowed.",
                ("Di17", "En13", "Sh11"),
                applies=lambda clutch: bool(clutch.spec.spring_parts),
            ),
            plot=Plot("springs", "force of the springs over their deflection, with what service takes", "clutch"),
        ),
        Analysis(
            "layout", "analysis.layout", "LayoutResult", "drive", lambda clutch: clutch.spec.envelope is not None,
            judged=True,
            section=Section(
                "Layout",
                "The parts in half section, as the papers arrange them, along the axis from the web of the housing on.",
                "The clutch is {length:.4g mm} long and its housing {outer_diameter:.4g mm} wide, clearances, "
                "bearings, keys and bolts not counted; its mass is {mass:.3g kg}.",
                ("F11", "S19"), ("S21",),
            ),
        ),
        Analysis("compare", "analysis.compare", "CompareResult", "clutch"),
        Analysis("solve", "analysis.solve", "SolveResult", "design"),
        Analysis(
            "tolerance", "analysis.tolerance_study", "ToleranceResult", "design",
            lambda clutch: clutch.spec.tolerance is not None,
            section=Section(
                "Tolerances and scatter",
                "The slip torque as making and service scatter as given; ± is the standard error.",
                "As making and service scatter, the mean torque is {mean:.5g N·m}, its standard deviation "
                "{standard_deviation:.4g N·m}.",
            ),
            plot=Plot("tolerance", "histogram of the torque with quantiles, by the block tolerance", "clutch"),
            example="tolerance",
        ),
        Analysis(
            "design", "analysis.design", "DesignResult", "design",
            plot=Plot("pareto", "Pareto front of a design, every clutch with its number", "search"),
        ),
        Analysis("explain", "analysis.explain.explain", "ExplainResult", "papers"),
        Analysis("papers", "papers.register", "EquationsResult", "papers"),
        Analysis(
            "claims", "papers.claims", "ReproduceResult", "papers",
            plot=Plot("paper", "a figure of the papers from the formulas: F11-2, S19-2, S21-2, …", "names"),
        ),
        Analysis("examples", "analysis.shipped", "ExamplesResult", "specs"),
        Analysis("materials", "analysis.shipped", "MaterialsResult", "specs"),
        Analysis("discs", "analysis.shipped", "DiscsResult", "specs"),
        Analysis("balls", "analysis.shipped", "BallsResult", "specs"),
        Analysis("check", "analysis.check", "CheckResult", "specs", options=("answers",), explained=True),
    )
}  # fmt: skip
"""Name → analysis, in the order of the help and of a report. A new one is its file and a row here."""

_SECTION = Plot("section", "the whole clutch in section and from its end, to scale, with its part list", "clutch")

PLOTS: dict[str, Plot] = {
    each.name: each for each in (_SECTION, *(each.plot for each in ANALYSES.values() if each.plot))
}

EXPLAINED = tuple(each.name for each in ANALYSES.values() if each.explained)


def schema(command: str | None = None) -> dict[str, Any]:
    """Return the JSON Schema of a spec (None), of requirements, or of the output of a command.

    Raises AfmcalcError: no such command.
    """
    from dataclasses import fields

    from pydantic import create_model

    from ..errors import AfmcalcError
    from ..messages import did_you_mean
    from ..result import Output
    from ..spec import Spec

    head = {"$schema": "https://json-schema.org/draft/2020-12/schema"}
    if command is None or command == "spec":
        return {**head, **Spec.model_json_schema()}
    if command not in ANALYSES:
        hint, results = did_you_mean(command, ANALYSES), ", ".join(ANALYSES)
        raise AfmcalcError(
            "no JSON of a command {command!r}{hint}; described are: spec, {results}",
            command=command, hint=hint, results=results,
        )  # fmt: skip
    result = ANALYSES[command].result_class
    parts: dict[str, Any] = {field.name: (field.type, ...) for field in fields(Output)}
    parts["result"] = (result, ...)
    model = create_model(f"{result.__name__.removesuffix('Result')}Output", __doc__=Output.__doc__, **parts)
    return {**head, **model.model_json_schema(mode="serialization")}
