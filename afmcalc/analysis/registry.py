"""List of analyses, one record each, from which commands, schemas, explanations, plots and reports are built.

The module of an analysis is imported at its first use, so that reading the list is fast.
"""

from collections.abc import Callable, Sequence
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

if TYPE_CHECKING:
    from ..engines import Clutch

StressRule = Literal["mean-stress", "amplitude", "goodman"]
"""Rules for the damaging stress in a life: of the paper, of Серенсен and Кинасошвили, of Goodman."""

SpringOrder = Literal["length", "wear", "mass"]
"""Quantity by which springs are sorted, the smallest first."""
SpringKind = Literal["any", "disc", "coil"]

Takes = Literal["clutch", "clutches", "names", "search"]


class Plot(NamedTuple):
    """Plot of an analysis: ``plot_data.gathered`` returns its data, ``render.plot`` lays it out."""

    name: str
    about: str
    """Description for the help."""
    takes: Takes = "clutches"
    """Input: one clutch, one or more clutches, names (of the papers' figures), or a spec with [search]."""
    options: tuple[str, ...] = ()
    """Options that the plot takes; any other option is an error."""
    applies: Callable[["Clutch"], bool] = lambda clutch: True


class Section(NamedTuple):
    """Section of a report on an analysis, in whole sentences: templates that the fields of the result fill."""

    title: str
    about: str
    """Subject of the calculation."""
    conclusion: dict[str, str]
    """Conclusions by the name that ``Analysis.conclusion`` chooses."""
    sources: Sequence[str] = ()
    """Keys of the references on which the calculation rests."""
    sources_indirect: Sequence[str] = ()
    """Keys of the references for an indirect clutch, if its law differs; if empty, ``sources`` holds for it too."""


@cache
def _sections() -> dict[str, Section]:
    """Analysis → its section, from sections.toml."""
    import tomllib
    from importlib.resources import files

    text = files(__package__).joinpath("sections.toml").read_text(encoding="utf-8")
    return {name: Section(**entry) for name, entry in tomllib.loads(text).items()}


class Analysis(NamedTuple):
    """One analysis; its function has the name of the analysis, in the module ``home`` of the package."""

    name: str
    home: str
    result: str
    """Name of the class of its result, in the module ``home``."""
    applies: Callable[[Any], bool] = lambda clutch: True
    """True if the analysis applies to a clutch."""
    options: tuple[str, ...] = ()
    """Further arguments of the function, which ``Answers`` supplies."""
    explained: bool = False
    """True if ``explain`` can show its steps."""
    judged: bool = False
    """True if ``check`` includes its findings."""
    reported: Callable[["Clutch"], bool] = lambda clutch: True
    """True if the report on a clutch to which the analysis applies includes its section."""
    conclusion: Callable[[Any], str] = lambda result: "always"
    """Function of the result that names the conclusion of its section."""
    plot: Plot | None = None
    example: str | None = None
    """Example calculated if no SPEC is given; None: the built-in base clutch."""

    @property
    def section(self) -> Section | None:
        """Section of a report on the analysis; None if reports have no such section."""
        return _sections().get(self.name)

    @property
    def function(self) -> Callable[..., Any]:
        """Function of the analysis, which returns result and findings."""
        return getattr(import_module(f"..{self.home}", __package__), self.name)

    @property
    def result_class(self) -> Any:
        """Class of its result, with the fields of its detail quantities (``Asking.detailed``)."""
        return getattr(import_module(f"..{self.home}", __package__), self.result).detailed()


def _can_be_simulated(clutch: "Clutch") -> bool:
    return clutch.spec.drive.event is not None


def _any_effect(clutch: "Clutch") -> bool:
    from .neglected import SOURCES

    return any(not source.missing(clutch) for source in SOURCES.values())


def _heated(result: Any) -> str:
    if None in vars(result.energy).values():
        return "does-not-end"
    return "energy" if result.temperature is None else "temperature"


def _narrower(result: Any) -> str:
    falls = result.narrower == "mean-friction" and not result.mean_friction.holds_nominal
    return "mean-friction-below-nominal" if falls else result.narrower


def _lasting(result: Any) -> str:
    stresses = result.stress_protected, result.stress_unprotected
    if None in stresses:
        return "broken"
    return "unlimited" if max(stresses) <= result.endurance_limit else "limited"


ANALYSES: dict[str, Analysis] = {
    each.name: each
    for each in (
        Analysis(
            "torque", "analysis.torque", "TorqueResult", explained=True,
            conclusion=lambda result: "in-two-stages" if result.onset_torque else "at-once",
            plot=Plot("torque", "torque against friction, scatter band, both adjustment methods"),
        ),
        Analysis(
            "accuracy", "analysis.accuracy_factor", "AccuracyResult", explained=True,
            plot=Plot(
                "accuracy", "accuracy factor against any key, --sweep NAME[=RANGE]", options=("sweep",),
                applies=lambda clutch: clutch.spec.kind.controlled,
            ),
        ),
        Analysis("adjust", "analysis.adjust", "AdjustResult", explained=True, conclusion=_narrower),
        Analysis(
            "overload", "analysis.trip", "OverloadResult",
            lambda clutch: clutch.spec.kind.overload and not clutch.spec.friction.unlike, explained=True,
            plot=Plot("overload", "trip over friction, and accuracy over the reduced gain (S22 fig. 3)", "clutch"),
        ),
        Analysis(
            "pocket", "analysis.synthesize", "SynthesisResult",
            lambda clutch: "ball_circle_radius" in clutch and bool(clutch["gain"] > 0), explained=True, judged=True,
            conclusion=lambda result: "ball" if result.ball_diameter_standard else "no-ball",
            plot=Plot("pocket", "section through ball and pockets, to scale; .dxf and .svg for the shop", "clutch"),
        ),
        Analysis(
            "life", "analysis.fatigue", "LifeResult", lambda clutch: clutch.spec.fatigue is not None,
            ("model", "answers"), explained=True, judged=True,
            conclusion=_lasting,
            plot=Plot("life", "cycles against the scatter band", options=("sweep", "model")),
        ),
        Analysis(
            "simulate", "analysis.simulate", "SimulateResult", _can_be_simulated, judged=True,
            plot=Plot("simulate", "torques, speeds and travel over time when the clutch trips", "clutch"),
            example="drive",
        ),
        Analysis(
            "heat", "analysis.trip_heat", "HeatResult",
            lambda clutch: _can_be_simulated(clutch) or clutch.spec.runs_down, ("answers",),
            explained=True, judged=True, conclusion=_heated, example="drive",
        ),
        Analysis(
            "effects", "analysis.neglected", "EffectsResult", _any_effect, judged=True, example="drive",
        ),
        Analysis(
            "springs", "analysis.spring_search", "SpringsResult",
            reported=lambda clutch: bool(clutch.spec.spring_parts),
        ),
        Analysis(
            "layout", "analysis.half_section", "LayoutResult", lambda clutch: clutch.spec.envelope is not None,
            judged=True,
        ),
        Analysis("compare", "analysis.compare", "CompareResult"),
        Analysis("solve", "analysis.solve", "SolveResult"),
        Analysis(
            "tolerance", "analysis.tolerance_study", "ToleranceResult",
            lambda clutch: clutch.spec.tolerance is not None,
            plot=Plot("tolerance", "histogram of the torque with quantiles, by the block tolerance", "clutch"),
            example="tolerance",
        ),
        Analysis(
            "design", "analysis.design", "DesignResult",
            plot=Plot("pareto", "Pareto front of a design, every clutch with its number", "search"),
        ),
        Analysis("explain", "analysis.explain.explain", "ExplainResult"),
        Analysis("mend", "analysis.explain.mend", "MendResult"),
        Analysis("papers", "papers.register", "EquationsResult"),
        Analysis(
            "claims", "papers.claims", "ReproduceResult",
            plot=Plot("paper", "a figure of the papers from the formulas: F11-2, S19-2, S21-2, …", "names"),
        ),
        Analysis("examples", "analysis.shipped", "ExamplesResult"),
        Analysis("materials", "analysis.shipped", "MaterialsResult"),
        Analysis("discs", "analysis.shipped", "DiscsResult"),
        Analysis("balls", "analysis.shipped", "BallsResult"),
        Analysis("check", "analysis.check", "CheckResult", options=("answers",), explained=True),
    )
}  # fmt: skip
"""Name → analysis, in the order of the help and of a report. A new analysis takes a module and a row here."""

_SECTION = Plot("section", "the whole clutch in section and from its end, to scale, with its part list", "clutch")

PLOTS: dict[str, Plot] = {
    each.name: each for each in (_SECTION, *(each.plot for each in ANALYSES.values() if each.plot))
}

EXPLAINED = tuple(each.name for each in ANALYSES.values() if each.explained)


def schema(command: str | None = None) -> dict[str, Any]:
    """Return the JSON Schema of the output of a command, or of a spec if ``command`` is None.

    Raises AfmcalcError if there is no such command.
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
