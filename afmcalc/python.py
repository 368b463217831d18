"""The calculator from Python: a clutch with a method for each calculation, and answers for notebooks."""

import typing
from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from . import __version__, engines
from .analysis.registry import ANALYSES, SpringKind, SpringOrder, StressRule
from .engines import Clutch as Engine
from .engines.quantities import Quantities
from .equations.arrays import Floats
from .errors import BEYOND_NUMBERS, AfmcalcError, CalculationError, need
from .findings import Finding
from .messages import localized, named, native, say, translate
from .result import Answer, Output
from .spec import Spec, read_spec, resolved
from .spec.edit import respecified, saved
from .spec.read import Overrides, apply_overrides

if TYPE_CHECKING:
    from .analysis.accuracy_factor import AccuracyResult
    from .analysis.adjust import AdjustResult
    from .analysis.check import CheckResult
    from .analysis.compare import CompareResult
    from .analysis.design import DesignResult
    from .analysis.drive_result import HeatResult, SimulateResult
    from .analysis.explain.explain import ExplainResult
    from .analysis.explain.mend import MendResult
    from .analysis.fatigue import LifeResult
    from .analysis.half_section import LayoutResult
    from .analysis.neglected import EffectsResult
    from .analysis.solve import SolveResult
    from .analysis.spring_search import SpringsResult
    from .analysis.sweep import Axis
    from .analysis.synthesize import SynthesisResult
    from .analysis.tolerance_study import ToleranceResult
    from .analysis.torque import Pair, TorqueResult
    from .analysis.trip import OverloadResult

Sweep = str | Sequence[str]
"""Sweep of a spec key as on the command line, ``"C"`` or ``"C=0:1.25:6"``; several sweeps make a grid."""
Friction = float | tuple[float, float] | Sequence[float | tuple[float, float]]
"""A coefficient of friction, a pair (f_1, f_2) for unlike materials, or a sequence of coefficients or pairs."""
A = TypeVar("A", bound=Answer)


class Picture(str):
    """A plot as SVG."""

    def _repr_svg_(self) -> str:
        return str(self)


class Clutch:
    """A clutch with a method for each command: ``clutch.accuracy()``, ``clutch.life(sweep="dT")``.

    A method returns the result of its command, with ``findings``, ``spec``, ``to_dict()``, ``to_dataframe()``.
    Quantities in SI are read by name, ``clutch["accuracy_factor"]``; a quantity that depends on friction is read in a
    case, ``clutch.at("f_max").torque``, or at a friction, ``clutch.at(friction=0.3).torque``.
    """

    def __init__(self, spec: Spec | Mapping[str, object]) -> None:
        """Build the clutch of a spec."""
        self._engine: Engine = engines.build(spec)

    @property
    def spec(self) -> Spec:
        """Spec from which the clutch was built."""
        return self._engine.spec

    def with_(self, keys: Mapping[str, object] | None = None, /, **named: object) -> "Clutch":
        """Clutch with other values of some keys, given by name, symbol or path; None removes a key.

        A new key replaces the keys that it excludes (the gain replaces a wall angle).
        """
        return Clutch(respecified(self.spec, apply_overrides({}, {**(keys or {}), **named})))

    def accuracy(self, sweep: Sweep = (), columns: Sequence[str] = ()) -> "AccuracyResult":
        """Accuracy factor, its limits and sensitivities, and sweeps, which may have ``columns`` of other quantities."""
        return self._ask("accuracy", self._axes(sweep), columns)

    def adjust(self) -> "AdjustResult":
        """Both settings of the spring, at f_min and at mean friction."""
        return self._ask("adjust")

    def check(self, *, strict: bool = False) -> "CheckResult":
        """Requirements, limits and findings, with a verdict; with ``strict`` the clutch also fails by a warning."""
        return self._ask("check", strict=strict)

    def effects(self) -> "EffectsResult":
        """Effects that the torque law neglects, in numbers."""
        return self._ask("effects")

    def explain(self, command: str, *, model: StressRule | None = None) -> "ExplainResult":
        """Calculation of a command step by step: formula, numbers, value, source."""
        return _answered("explain", self.spec, *_asked("explain", command, self.spec, model))

    def heat(self) -> "HeatResult":
        """Work, temperature and wear of a trip, and how often the clutch may trip."""
        return self._ask("heat")

    def history(self, friction: Friction = ()) -> dict[str, Floats]:
        """Name (time, torque_shaft, …) → values during the event, SI, at ``friction``, else f_min, mean f and f_max."""
        from .analysis.simulate import history

        moments = [moment.to_dict() for moment in history(self._engine, _pairs(friction)).moments]
        names = [name for name, value in moments[0].items() if value is not None]
        return {name: np.array([moment[name] for moment in moments]) for name in names}

    def layout(self) -> "LayoutResult":
        """Parts in half section, collisions, mass and inertia; needs the block [envelope]."""
        return self._ask("layout")

    def life(self, model: StressRule = "mean-stress", sweep: Sweep = ()) -> "LifeResult":
        """Cycles to failure on both sides of the clutch; ``sweep`` also takes dT, the scatter band."""
        return self._ask("life", model, self._axes(sweep, band=True))

    def mend(self, code: str) -> "MendResult":
        """Meaning of an error or a warning, and the keys of this clutch whose change clears it."""
        return self._ask("mend", code)

    def overload(self, sweep: Sweep = ()) -> "OverloadResult":
        """Potential and actuation torque with a torque margin (S22)."""
        return self._ask("overload", self._axes(sweep))

    def simulate(self, friction: Friction = (), sweep: Sweep = ()) -> "SimulateResult":
        """Simulation of the drive as the clutch trips, also at ``friction``; without a sweep also the heat."""
        return self._ask("simulate", _pairs(friction), self._axes(sweep), heated=not sweep)

    def solve(self, target: str, value: float | str, *, for_: str = "C", beyond_limit: bool = False) -> "SolveResult":
        """Value of one key that gives a wanted quantity; ``Clutch(answer.spec)`` is the clutch with this value.

        ``value``: a number in SI or a text with a unit; ``for_``: key to solve for, by symbol or path; with
        ``beyond_limit`` also beyond the gain limit of the variant. Raises CalculationError if no value of the key gives
        the wanted value; the message names the nearest.
        """
        from .analysis.solve import parse_target

        target, wanted, questions = parse_target(f"{target}={value}")
        result, solved, findings = _asked("solve", self._engine, for_, target, wanted, beyond_limit=beyond_limit)
        if not result.roots:
            raise CalculationError(findings[-1].message)
        return _answered("solve", solved.spec, result, [*questions, *findings])

    def springs(
        self, sort: SpringOrder | None = None, top: int = 10, kind: SpringKind = "any", tolerance: float = 0.1
    ) -> "SpringsResult":
        """Disc stacks and coil springs that give the forces and stiffnesses of the clutch."""
        return self._ask("springs", sort, top, kind, tolerance)

    def pocket(self) -> "SynthesisResult":
        """Wall angle, balls and pockets of the control unit."""
        return self._ask("pocket")

    def tolerance(self) -> "ToleranceResult":
        """Scatter of the torque under tolerances: quantiles, risks, life, and which input causes most of it."""
        return self._ask("tolerance")

    @typing.overload
    def torque(self) -> "TorqueResult": ...
    @typing.overload
    def torque(self, friction: float, friction_driven: float | None = None) -> float: ...
    @typing.overload
    def torque(self, friction: Floats, friction_driven: Floats | float | None = None) -> Floats: ...
    def torque(self, friction: Any = None, friction_driven: Any = None) -> object:
        """Slip torque, N·m, at a friction or an array of frictions; without arguments the result of the command."""
        if friction is None and friction_driven is None:
            return self._ask("torque")
        driving, driven = _checked(friction), _checked(friction if friction_driven is None else friction_driven)
        if self.spec.kind.travels and not np.all(driving == driven):
            raise ValueError(say("an indirect clutch has one friction for all pairs"))
        return self._engine.at_friction(driving, driven)["torque"]

    def at(self, case: str = "", /, **values: Any) -> Quantities:
        """Quantities in a case (``f_max``), or with some quantities (``friction``) set to numbers or arrays.

        Raises LookupError if there is no such case or quantity; the message names the nearest name.
        """
        return self._engine.at(case, **values)

    def __getitem__(self, name: str) -> Any:
        """Quantity by its name; if it depends on friction, the name ends in a case: ``clutch["torque_at_f_max"]``.

        Raises LookupError if there is no such quantity, or it needs a case; the message has the nearest, or the cases.
        """
        return self._engine[name]

    def __contains__(self, name: str) -> bool:
        """True if the quantity has a value without a case."""
        return name in self._engine

    def names(self) -> list[str]:
        """Names of all quantities, including those that need a case or a friction."""
        return self.at("f_max").names()

    def __reduce__(self) -> tuple[type["Clutch"], tuple[Spec]]:
        """Pickle only the spec; unpickling builds the clutch from the spec."""
        return Clutch, (self.spec,)

    def save(self, path: str | PathLike[str]) -> None:
        """Write the spec, replacing an existing file; comments, order and units of its source text are kept."""
        Path(path).write_text(saved(self.spec, {}, self.spec, path), encoding="utf-8")

    def plot(self, name: str, path: str | PathLike[str] | None = None, *, sweep: str | None = None) -> "Picture":
        """Plot as SVG, which a notebook shows; with ``path`` the plot is also written, as .svg, .png or .pdf.

        Raises AfmcalcError if the plot is unknown, or the file has another extension.
        """
        from .analysis.asking import Answers
        from .analysis.plot_data import Request, gathered
        from .render.plot import sheet_of
        from .render.plot.figure import save

        need("plot")
        sheet = sheet_of(name, gathered(name, Request([Answers(self._engine)], sweep)))
        if path is not None:
            ending = Path(path).suffix.removeprefix(".")
            if ending not in ("svg", "png", "pdf"):
                raise AfmcalcError("{path}: end it in .svg, .png or .pdf", path=str(path))
            Path(path).write_bytes(save(sheet, ending))
        return Picture(save(sheet, "svg").decode())

    def report(self, path: str | PathLike[str], *, short: bool = False) -> None:
        """Write the calculation report to an HTML file."""
        from .analysis.dossier import dossier
        from .render.report import Subject, render

        need("report")
        told = dossier(self.spec, explained=not short)
        Path(path).write_text(render(Subject(told, short=short)), encoding="utf-8")

    def _summary(self) -> dict[str, str]:
        """Name → text of a summary: torques, accuracy, and the verdict of the quick checks."""
        from .analysis.asking import Answers
        from .analysis.check import check_at_once
        from .render.amounts import measured

        torque, (check, _) = self.torque(), check_at_once(Answers(self._engine))
        low, high = (measured(end, "N*m") for end in (torque.torque_range.low, torque.torque_range.high))
        return {
            translate("clutch"): ", ".join(
                filter(None, [named(self.spec.name), translate(self.spec.variant, "value")])
            ),
            "T": f"{low} … {high}",
            native("K_т"): localized(f"{torque.accuracy_factor:.4g}"),
            translate("verdict"): check.verdict.sentence,
        }

    def __repr__(self) -> str:
        """Summary, one line each: clutch, torques, accuracy, verdict."""
        return "\n".join(f"{name}: {text}" for name, text in self._summary().items())

    def _repr_html_(self) -> str:
        from html import escape

        rows = (f"<tr><th>{escape(name)}</th><td>{escape(text)}</td></tr>" for name, text in self._summary().items())
        return f"<table>{''.join(rows)}</table>"

    def _ask(self, command: str, *arguments: object, **options: object) -> Any:
        return _answered(command, self.spec, *_asked(command, self._engine, *arguments, **options))

    def _axes(self, sweep: Sweep, *, band: bool = False) -> "list[Axis]":
        if not sweep:
            return []
        from .analysis.fatigue import parse_axes

        return parse_axes([sweep] if isinstance(sweep, str) else sweep, self._engine, band=band)


def _asked(command: str, *arguments: object, **options: object) -> Any:
    """Result and findings of the function of a command; raises CalculationError if a number overflows."""
    try:
        return ANALYSES[command].function(*arguments, **options)
    except ArithmeticError:
        raise CalculationError(BEYOND_NUMBERS) from None


def _answered(command: str, spec: Spec | None, result: A, findings: list[Finding]) -> A:
    """Result with the spec and the findings that its command prints."""
    data = None if spec is None else resolved(spec)
    return result.printed_as(Output(command, __version__, data, result, findings), _rendered)


def _rendered(output: Output, name: str) -> str:
    from .render import renderer

    return renderer(name)(output, False)


def _checked(friction: Any) -> Any:
    """Friction or array of frictions; raises ValueError unless all are finite and at least 0."""
    given = np.asarray(friction)
    if given.dtype.kind not in "fiu" or not np.all((given >= 0) & (given < np.inf)):
        raise ValueError(
            say("friction must be a finite number, at least 0, or an array of such; got {value!r:.80}", value=friction)
        )
    return given if given.ndim else friction


def _pairs(friction: Friction) -> "list[Pair]":
    given = [friction] if isinstance(friction, float | int | tuple) and friction != () else friction
    return [point if isinstance(point, tuple) else (float(point), None) for point in given]


def loads(text: str, set: Overrides = ()) -> Clutch:
    """Build the clutch of a spec given as TOML or JSON text; raises SpecError if the spec is invalid."""
    from .spec.parse import Source
    from .spec.read import spec_of

    return Clutch(spec_of(Source("text", text), set))


def load(source: str | PathLike[str] | Mapping[str, object] | None = None, set: Overrides = ()) -> Clutch:
    """Read a spec and build its clutch; raises SpecError if the spec is invalid, FileError if it cannot be read.

    Args:
        source: a path, ``"-"`` for standard input, ``"example:NAME"``, a mapping of keys; None for ``example:default``.
        set: other values of spec keys, by name, symbol or path; None removes a key.
    """
    return Clutch(read_spec(source, set))


build = Clutch


def compare(
    clutches: Sequence[Clutch | str | PathLike[str]] | Clutch | str | PathLike[str], *, variants: bool = False
) -> "CompareResult":
    """Comparison of clutches or spec files or, with ``variants``, of one clutch built as each possible variant."""
    several = [clutches] if isinstance(clutches, Clutch | str | PathLike) else clutches
    compared = [each if isinstance(each, Clutch) else load(each) for each in several]
    answer = _asked("compare", [clutch._engine for clutch in compared], variants=variants)
    return _answered("compare", compared[0].spec, *answer)


def design(
    source: str | PathLike[str] | Mapping[str, object], *, pick: int | str | None = None, set: Overrides = ()
) -> "DesignResult":
    """Pareto front of the clutches that the [search] of a spec allows and that pass every check.

    ``pick``: number of the only clutch wanted, or ``"compromise"``; ``Clutch(answer.spec)`` builds this clutch. Raises
    SpecError if the spec is invalid or searches too many candidates, AfmcalcError if there is no clutch of that number.
    """
    from .analysis.design import picked

    spec = read_spec(source, set)
    result, findings = _asked("design", spec)
    chosen = None
    if pick is not None:
        row, chosen = picked(spec, result, pick)
        result = result.model_copy(update={"front": [row]})
    return _answered("design", chosen, result, findings)
