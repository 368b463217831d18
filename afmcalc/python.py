"""The calculator from Python: a clutch that answers by one call each, answers that show themselves in a notebook."""

from collections.abc import Iterator, Mapping, Sequence
from os import PathLike
from typing import TYPE_CHECKING, Any

from . import __version__, engines
from .analysis.registry import ANALYSES
from .engines.protocol import Clutch
from .result import Output
from .spec import Spec, resolved

if TYPE_CHECKING:
    from .findings import Finding

_OF_ONE_CLUTCH = ("clutch", "design", "drive", "specs")
"""Groups whose analyses are asked of a clutch."""
_OTHERWISE = ("compare", "design", "examples", "materials")
"""Those of them that take something else."""
_NONE = object()


class Answer(Output):
    """What a command prints, as a value: the fields of its result are its own, a notebook shows its tables."""

    def __getattr__(self, name: str) -> Any:
        """Return a field of the result."""
        if name.startswith("__") or name == "result":
            raise AttributeError(name)
        return getattr(self.result, name)

    def __dir__(self) -> Iterator[str]:
        """List the fields of the result too."""
        yield from super().__dir__()
        yield from type(self.result).model_fields

    def __repr__(self) -> str:
        """Return the tables of the terminal."""
        return self._as("table")

    def _repr_html_(self) -> str:
        return self._as("html")

    def _repr_markdown_(self) -> str:
        return self._as("markdown")

    def _as(self, name: str) -> str:
        from .render import renderer

        return renderer(name)(self, False)


class AskedClutch:
    """A clutch that can be asked everything the commands are asked: ``clutch.accuracy()``, ``clutch.life()`` and so on.

    What the engine offers (``clutch.accuracy_factor``, ``clutch.torque(0.3)``, arrays of any shape) is its own too;
    ``clutch.torque()`` without a friction is the answer of the command.
    """

    def __init__(self, engine: Clutch) -> None:
        """Take the engine that calculates."""
        self.engine = engine

    def __getattr__(self, name: str) -> Any:
        """Return an analysis of the registry, ready to be called, or what the engine offers."""
        if name in _asked():
            return lambda *arguments, **options: _answer(name, self.engine, arguments, options)
        return getattr(self.engine, name)

    def __dir__(self) -> Iterator[str]:
        """List the analyses and what the engine offers."""
        yield from {*super().__dir__(), *dir(self.engine), *_asked()}

    def __repr__(self) -> str:
        """Return what it is of."""
        return f"<{self.engine.spec.variant} clutch of {self.engine.spec.label}>"

    def explain(self, command: str, **options: object) -> Answer:
        """Steps of an answer: formula, numbers, value, source."""
        result, findings = ANALYSES["explain"].function(command, self.engine.spec, **options)
        return _told("explain", result, findings, self.engine.spec)

    def torque(self, friction: Any = _NONE, friction_driven: Any = None) -> Any:
        """Slip torque, N·m, at a friction or an array of them; without one the answer of the command."""
        if friction is _NONE:
            return _answer("torque", self.engine, (), {})
        return self.engine.torque(friction, friction_driven)


def _asked() -> list[str]:
    return [each.name for each in ANALYSES.values() if each.group in _OF_ONE_CLUTCH and each.name not in _OTHERWISE]


def _answer(name: str, engine: Clutch, arguments: Sequence[object], options: Mapping[str, object]) -> Answer:
    """Ask; ``sweep`` is written as on the command line, one text or several."""
    given = dict(options)
    if sweep := given.pop("sweep", None):
        from .analysis.sweep.axes import parse_axis

        texts = [sweep] if isinstance(sweep, str) else sweep
        given["sweeps"] = [parse_axis(text, engine.spec) for text in texts]  # type: ignore[attr-defined]
    found = ANALYSES[name].function(engine, *arguments, **given)
    # a solution comes with the clutch that it is
    spec = found[1].spec if len(found) > 2 else engine.spec
    return _told(name, found[0], found[-1], spec)


def _told(name: str, result: object, findings: "list[Finding]", spec: Spec | None = None) -> Answer:
    return Answer(name, __version__, None if spec is None else resolved(spec), result, findings)


def load(source: str | PathLike[str] | None = None) -> AskedClutch:
    """Read a spec (a path, ``"-"`` for standard input, None for the built-in base clutch) and build its clutch.

    Raises:
        SpecError: the spec is invalid.
        FileError: the file cannot be read.
    """
    return AskedClutch(engines.load(source))


def build(spec: Spec | Mapping[str, object]) -> AskedClutch:
    """Build the clutch of a spec, a validated one or plain data of the same structure.

    Raises:
        SpecError: no valid spec; an indirect clutch whose gain does not overcome the friction at the key.
    """
    return AskedClutch(engines.build(spec))


def compare(*clutches: AskedClutch | str | PathLike[str]) -> Answer:
    """Several clutches, or files of specs, side by side."""
    asked = [each if isinstance(each, AskedClutch) else load(each) for each in clutches]
    result, findings = ANALYSES["compare"].function([each.engine for each in asked])
    return _told("compare", result, findings, asked[0].engine.spec)


def design(requirements: str | PathLike[str] | Mapping[str, object]) -> Answer:
    """All that nothing else beats, of what meets the requirements: a file's, or plain data of the same structure.

    Raises:
        SpecError: the requirements are invalid.
        AfmcalcError: nothing meets them.
    """
    from .spec.requirements import make_requirements, read_requirements

    need = make_requirements(requirements) if isinstance(requirements, Mapping) else read_requirements(requirements)
    result, findings = ANALYSES["design"].function(need)
    return _told("design", result, findings)
