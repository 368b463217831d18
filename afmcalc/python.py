"""The calculator from Python: a clutch with a method for each calculation, and answers for notebooks."""

import os
import typing
from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar

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

Sweep: TypeAlias = str | Sequence[str]
"""``"C"``, ``"C=0:1.25:6"``, or several as on the command line; they make a grid."""
Friction: TypeAlias = float | tuple[float, float] | Sequence[float | tuple[float, float]]
"""A friction, a pair f_1, f_2 of unlike materials, or several of them."""
A = TypeVar("A", bound=Answer)


class Picture(str):
    """A plot as SVG."""

    def _repr_svg_(self) -> str:
        return str(self)


class Clutch:
    """A clutch that is asked by a method for each command: ``clutch.accuracy()``, ``clutch.life(sweep="dT")``.

    An answer is the result of the command, with ``findings``, ``spec``, ``to_dict()``, ``to_dataframe()``. Quantities
    are asked by name, in SI: ``clutch["accuracy_factor"]``; what depends on friction in a case, ``clutch.at("f_max")``,
    or at a friction, ``clutch.at(friction=0.3).torque``.
    """

    def __init__(self, spec: Spec | Mapping[str, object]) -> None:
        """Build the clutch of a spec."""
        self._engine: Engine = engines.build(spec)

    @property
    def spec(self) -> Spec:
        """The spec it was built from."""
        return self._engine.spec

    def with_(self, keys: Mapping[str, object] | None = None, /, **named: object) -> "Clutch":
        """Return the clutch with other values of some keys, by name, symbol or path; None removes a key.

        A key takes the place of those that exclude it (the gain that of a wall angle).
        """
        return Clutch(respecified(self.spec, apply_overrides({}, {**(keys or {}), **named})))

    def accuracy(self, sweep: Sweep = (), columns: Sequence[str] = ()) -> "AccuracyResult":
        """Accuracy factor, its limits and sensitivities, and sweeps of it, with ``columns`` of more quantities."""
        return self._ask("accuracy", self._axes(sweep), columns)

    def adjust(self) -> "AdjustResult":
        """Both ways of setting the spring, at f_min and at mean friction."""
        return self._ask("adjust")

    def check(self, *, strict: bool = False) -> "CheckResult":
        """Requirements, limits and findings, with a verdict; ``strict``: a warning fails too."""
        return self._ask("check", strict=strict)

    def effects(self) -> "EffectsResult":
        """Effects that the torque law neglects, in numbers."""
        return self._ask("effects")

    def explain(self, command: str, *, model: StressRule | None = None) -> "ExplainResult":
        """The calculation of a command step by step: formula, numbers, value, source."""
        return _answered("explain", self.spec, *_asked("explain", command, self.spec, model))

    def heat(self) -> "HeatResult":
        """Work, temperature and wear of a trip, and how often the clutch may trip."""
        return self._ask("heat")

    def history(self, friction: Friction = ()) -> dict[str, Floats]:
        """The event over time as arrays, SI, by name: time, torque_shaft, travel, …; without friction all three."""
        from .analysis.simulate import history

        moments = [moment.to_dict() for moment in history(self._engine, _pairs(friction)).moments]
        names = [name for name, value in moments[0].items() if value is not None]
        return {name: np.array([moment[name] for moment in moments]) for name in names}

    def layout(self) -> "LayoutResult":
        """Parts in half section, what collides, mass and inertia; needs the block [envelope]."""
        return self._ask("layout")

    def life(self, model: StressRule = "mean-stress", sweep: Sweep = ()) -> "LifeResult":
        """Cycles to failure on both sides of the clutch; ``sweep`` also takes dT, the scatter band."""
        return self._ask("life", model, self._axes(sweep, band=True))

    def overload(self, sweep: Sweep = (), friction: Friction = ()) -> "OverloadResult":
        """Potential and actuation torque with a torque margin (S22), also at the friction asked for."""
        return self._ask("overload", self._axes(sweep), _pairs(friction))

    def simulate(self, friction: Friction = (), sweep: Sweep = ()) -> "SimulateResult":
        """The drive in time when the clutch trips, with the heat of it, also at the friction asked for."""
        return self._ask("simulate", _pairs(friction), self._axes(sweep), heated=not sweep)

    def solve(self, target: str, value: float | str, *, for_: str = "C", beyond_limit: bool = False) -> "SolveResult":
        """One key from one wanted quantity; ``Clutch(answer.spec)`` is the clutch that has it.

        Args:
            target: quantity that is wanted.
            value: its value, in SI or a text with a unit.
            for_: key to solve for, by symbol or path.
            beyond_limit: whether to go past the gain limit of the variant.

        Raises:
            CalculationError: no value of the key gives it; says which comes nearest.
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
        """Torque over tolerances and scatter: quantiles, risks, life, what scatters most."""
        return self._ask("tolerance")

    @typing.overload
    def torque(self) -> "TorqueResult": ...
    @typing.overload
    def torque(self, friction: float, friction_driven: float | None = None) -> float: ...
    @typing.overload
    def torque(self, friction: Floats, friction_driven: Floats | float | None = None) -> Floats: ...
    def torque(self, friction: Any = None, friction_driven: Any = None) -> object:
        """Slip torque, N·m, at a friction or an array of them; without one what the command gives."""
        if friction is None and friction_driven is None:
            return self._ask("torque")
        driving, driven = _checked(friction), _checked(friction if friction_driven is None else friction_driven)
        if self.spec.kind.travels and not np.all(driving == driven):
            raise ValueError(say("an indirect clutch has one friction for all pairs"))
        return self._engine.at_friction(driving, driven)["torque"]

    def at(self, case: str = "", /, **values: Any) -> Quantities:
        """Quantities in a case (``f_max``), or with other values of some (``friction``): numbers, or arrays of them.

        Raises:
            LookupError: no such case or quantity; says what is near.
        """
        return self._engine.at(case, **values)

    def __getitem__(self, name: str) -> Any:
        """Return a quantity that depends on no case, or in one: ``clutch["torque_at_f_max"]``.

        Raises:
            LookupError: no such quantity, or one that needs a case; says what is near, or which cases there are.
        """
        return self._engine[name]

    def names(self) -> list[str]:
        """Quantities that can be asked, some of them only in a case or at a friction."""
        return self.at("f_max").names()

    def __reduce__(self) -> tuple[type["Clutch"], tuple[Spec]]:
        """Copy and pickle the spec; the clutch is built from it."""
        return Clutch, (self.spec,)

    def save(self, path: str | PathLike[str]) -> None:
        """Write the spec, over a file that exists; comments, order and units of the text it was read from stay."""
        target = Path(path)
        target.write_text(saved(self.spec, {}, self.spec, str(target.absolute().parent)), encoding="utf-8")

    def plot(self, name: str, path: str | PathLike[str] | None = None, *, sweep: str | None = None) -> "Picture":
        """Return a plot as SVG, which a notebook shows; with ``path`` also write it, as .svg, .png or .pdf.

        Raises:
            AfmcalcError: no plot of that name or file of that ending.
        """
        from .analysis.asking import Answers
        from .analysis.plot_data import Request, gathered
        from .render.plot import sheet_of
        from .render.plot.figure import save

        need("plot")
        sheet = sheet_of(name, gathered(name, Request([Answers(self._engine)], sweep)))
        if path is not None:
            ending = os.path.splitext(path)[1].removeprefix(".")
            if ending not in ("svg", "png", "pdf"):
                raise AfmcalcError("{path}: end it in .svg, .png or .pdf", path=str(path))
            with open(path, "wb") as file:
                file.write(save(sheet, ending))
        return Picture(save(sheet, "svg").decode())

    def report(self, path: str | PathLike[str], *, short: bool = False) -> None:
        """Write the calculation report to an HTML file."""
        from hashlib import sha256

        from .analysis.dossier import dossier
        from .render.report import Subject, render
        from .render.report.title import text_as_given, title_block

        need("report")
        source = self.spec.label
        told, digest = dossier(self.spec, explained=not short), sha256(source.text.encode()).hexdigest()
        given, title = text_as_given(source), title_block(self.spec, {})
        subject = Subject(told, given, title, digest, source, [], __version__, False, short)
        with open(path, "w", encoding="utf-8") as file:
            file.write(render(subject))

    def _summary(self) -> list[tuple[str, str]]:
        """Return what a clutch is in a few lines: torques, accuracy, verdict but for what takes long."""
        from .analysis.asking import Answers
        from .analysis.check import check_at_once
        from .render.amounts import measured

        torque, (check, _) = self.torque(), check_at_once(Answers(self._engine))
        low, high = (measured(end, "N*m") for end in (torque.torque_range.low, torque.torque_range.high))
        title = ", ".join(filter(None, [named(self.spec.name), translate(self.spec.variant, "value")]))
        return [
            (translate("clutch"), title),
            ("T", f"{low} … {high}"),
            (native("K_т"), localized(f"{torque.accuracy_factor:.4g}")),
            (translate("verdict"), check.verdict.sentence),
        ]

    def __repr__(self) -> str:
        """Return torques, accuracy and verdict."""
        return "\n".join(f"{name}: {text}" for name, text in self._summary())

    def _repr_html_(self) -> str:
        from html import escape

        rows = (f"<tr><th>{escape(name)}</th><td>{escape(text)}</td></tr>" for name, text in self._summary())
        return f"<table>{''.join(rows)}</table>"

    def _ask(self, command: str, *arguments: object, **options: object) -> Any:
        return _answered(command, self.spec, *_asked(command, self._engine, *arguments, **options))

    def _axes(self, sweep: Sweep, *, band: bool = False) -> "list[Axis]":
        if not sweep:
            return []
        from .analysis.fatigue import parse_axes

        return parse_axes([sweep] if isinstance(sweep, str) else sweep, self._engine, band=band)


def _asked(command: str, *arguments: object, **options: object) -> Any:
    """Ask the function of a command; a number that leaves the range of numbers is an error as at the command line."""
    try:
        return ANALYSES[command].function(*arguments, **options)
    except ArithmeticError:
        raise CalculationError(BEYOND_NUMBERS) from None


def _answered(command: str, spec: Spec | None, result: A, findings: list[Finding]) -> A:
    """Return a result with all that its command prints."""
    data = None if spec is None else resolved(spec)
    return result.printed_as(Output(command, __version__, data, result, findings), _rendered)


def _rendered(output: Output, name: str) -> str:
    from .render import renderer

    return renderer(name)(output, False)


def _checked(friction: Any) -> Any:
    """Check a friction, or an array of them."""
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
    """Build the clutch of a spec given as TOML or JSON text.

    Raises:
        SpecError: the spec is invalid.
    """
    from .spec.parse import Source
    from .spec.read import spec_of

    return Clutch(spec_of(Source("text", text), set))


def load(source: str | PathLike[str] | Mapping[str, object] | None = None, set: Overrides = ()) -> Clutch:
    """Read a spec and build its clutch.

    Args:
        source: a path, ``"-"`` for standard input, ``"example:NAME"``, plain data; None for ``example:default``.
        set: other values of its keys, by name, symbol or path; None removes a key.

    Raises:
        SpecError: the spec is invalid.
        FileError: the file cannot be read.
    """
    return Clutch(read_spec(source, set))


build = Clutch


def compare(
    clutches: Sequence[Clutch | str | PathLike[str]] | Clutch | str | PathLike[str], *, variants: bool = False
) -> "CompareResult":
    """Clutches, or files of specs, side by side; with ``variants`` one as every variant it can be built as."""
    several = [clutches] if isinstance(clutches, Clutch | str | PathLike) else clutches
    compared = [each if isinstance(each, Clutch) else load(each) for each in several]
    answer = _asked("compare", [clutch._engine for clutch in compared], variants=variants)
    return _answered("compare", compared[0].spec, *answer)


def design(
    source: str | PathLike[str] | Mapping[str, object], *, pick: int | str | None = None, set: Overrides = ()
) -> "DesignResult":
    """All that nothing else beats of the clutches that the [search] of a spec allows and that hold every check.

    With ``pick`` only that number of the front, or its ``"compromise"``: ``Clutch(answer.spec)``.

    Raises:
        SpecError: the spec is invalid, or searches too many candidates.
        AfmcalcError: no such number, or no compromise.
    """
    from .analysis.design import picked

    spec = read_spec(source, set)
    result, findings = _asked("design", spec)
    chosen = None
    if pick is not None:
        row, chosen = picked(spec, result, pick)
        result = result.model_copy(update={"front": [row]})
    return _answered("design", chosen, result, findings)
