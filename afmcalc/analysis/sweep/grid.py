"""A sweep: its axes, keys or F11's ratios, and the answers over their grid in one array expression of the engines.

Loads NumPy when asked.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from itertools import product
from typing import Any, NamedTuple, TypeVar

from ...engines import build
from ...engines.protocol import Clutch
from ...equations.arrays import Floats, Values
from ...errors import AfmcalcError, SpecError
from ...findings import Finding, finding
from ...messages import joined, say
from ...result import Series
from ...spec import Spec, edit
from ...spec.edit import value_at
from ...spec.fields import Key
from ...spec.keys import is_whole, keys


class Ratio(NamedTuple):
    """One ratio of two coefficients of friction."""

    path: str
    """Coefficient that moves with the ratio."""
    over: str
    """Coefficient that the ratio is taken over."""
    description: str

    @property
    def quotient(self) -> str:
        """What it is of the keys of the spec."""
        return f"{self.path}/{self.over}"

    def key(self, name: str) -> Key:
        """Return the coefficient that moves, called as the ratio."""
        return keys()[self.path]._replace(symbol=name, description=self.description)


_F1_MIN, _F1_MAX = "friction.driving.min", "friction.driving.max"
_F2_MIN, _F2_MAX = "friction.driven.min", "friction.driven.max"
RATIOS = {
    "n": Ratio(_F2_MAX, _F1_MAX, "ratio f_2max/f_1max; f_2max moves (unlike materials)"),
    "p": Ratio(_F2_MIN, _F1_MIN, "ratio f_2min/f_1min; f_2min moves (unlike materials)"),
    "m": Ratio(_F1_MAX, _F1_MIN, "ratio f_1max/f_1min; f_1max moves, f_2max = n f_1max with it (unlike materials)"),
}
"""F11 (15), (16) and the width of the interval of f_1."""


def paths_moved(name: str) -> tuple[str, ...]:
    """Return the keys that move with a ratio."""
    return (_F1_MAX, _F2_MAX) if name == "m" else (RATIOS[name].path,)


def no_ratio(name: str) -> str:
    """Return the hint for a ratio where the materials are not unlike; nothing for other names."""
    if name not in RATIOS:
        return ""
    about = say("; {name} is a ratio of unlike materials (friction.driving, friction.driven)", name=name)
    return about + say("; did you mean {paths}?", paths="control_unit.balls") if name == "n" else about


def coefficient(spec: Spec, path: str) -> float:
    """Return a coefficient of friction of one group, looked up in the catalogue where it names a material."""
    group, _, end = path.rpartition(".")
    return float(getattr(value_at(spec, group).range, end))


def current_ratio(spec: Spec, name: str) -> float:
    """Return what the ratio is in the spec."""
    return coefficient(spec, RATIOS[name].path) / coefficient(spec, RATIOS[name].over)


def moved(spec: Spec, ratios: Mapping[str, Values]) -> dict[str, Any]:
    """Return the coefficients of friction that given ratios stand for, by path; a ratio not given stays as it is."""
    values = {RATIOS[name].path: value * coefficient(spec, RATIOS[name].over) for name, value in ratios.items()}
    if "m" in ratios:
        values[_F2_MAX] = ratios.get("n", current_ratio(spec, "n")) * values[_F1_MAX]
    return values


def ends_of_ratio(spec: Spec, name: str) -> tuple[float, float]:
    """Return the ends of what a ratio may be: min ≤ mean ≤ max of either group, a mean as far as it is given."""

    def inner(group: str, end: str) -> float:
        return value_at(spec, f"{group}.mean") or coefficient(spec, f"{group}.{end}")

    over = coefficient(spec, RATIOS[name].over)
    if name == "p":
        return 0.0, inner("friction.driven", "max") / over
    low = inner("friction.driven", "min") / over
    if name == "m":
        return max(inner("friction.driving", "min") / over, low / current_ratio(spec, "n")), float("inf")
    return low, float("inf")


MOST_POINTS = 200_000
"""Points of a sweep: its answers take 0.3 GB then."""
_BLOCK = 16_000
"""Points calculated at a time: as many as an array may have that the allocator keeps (128 KiB); a larger one it gives
back to the system each time, and fetching its pages anew takes longer than all the arithmetic."""
Output = Callable[[Clutch], Values]
"""What is asked of the clutch at every point."""


class Axis(NamedTuple):
    """One swept key with its values, SI."""

    name: str
    """As the user called it: a symbol or a path."""
    key: Key
    values: Floats
    """Values of the parameter as called."""
    scale: float = 1.0
    """What a value is multiplied by to give the spec key (zC → C)."""
    question: Finding | None = None
    """The first value without a unit that may be meant in another than SI."""

    @property
    def called_path(self) -> str:
        """What its values are: a spec path; of a ratio the quotient of two; of zC, no key, its name in results."""
        if self.name == "zC":
            return "reduced_gain"
        return RATIOS[self.name].quotient if self.name in RATIOS else self.key.path

    @property
    def paths(self) -> tuple[str, ...]:
        """Spec keys that it moves."""
        return paths_moved(self.name) if self.name in RATIOS else (self.key.path,)


def replaced(spec: Spec, axes: Sequence[Axis]) -> list[Finding]:
    """Say which keys of the spec a sweep has taken the place of, and ask after its numbers without a unit."""
    gone = edit.replaced(spec, [path for axis in axes for path in axis.paths])
    asked = [axis.question for axis in axes if axis.question]
    return [*asked, *(finding("sweep-replaces", "info", path=path, by=by) for path, by in gone.items())]


def grid(axes: Sequence[Axis]) -> list[Floats]:
    """Coordinates of every point of the grid by axis, flat, the first axis slowest."""
    import numpy as np

    count = math.prod(axis.values.size for axis in axes)
    if count > MOST_POINTS:
        raise AfmcalcError(
            "the sweep asks for {count:,} points; at most {most:,} are swept", count=count, most=MOST_POINTS
        )
    if len({axis.key.path for axis in axes}) < len(axes):
        raise AfmcalcError("the same key is swept twice")
    if any(axis.name == "zC" for axis in axes) and any(axis.key.path.endswith("pairs") for axis in axes):
        raise AfmcalcError("zC and a number of pairs cannot be swept together: sweep C with it")
    if len({axis.name in RATIOS for axis in axes if axis.key.path.startswith("friction.driv")}) > 1:
        raise AfmcalcError("n, p or m and a coefficient of friction cannot be swept together: sweep ratios only")
    return [coordinates.ravel() for coordinates in np.meshgrid(*(axis.values for axis in axes), indexing="ij")]


S = TypeVar("S", bound=Series)


def series(
    kind: type[S],
    clutch: Clutch,
    axes: Sequence[Axis],
    outputs: Mapping[str, Output],
    open_at: Sequence[str] = (),
) -> list[S] | None:
    """Sweep ``outputs`` over the grid of ``axes``, one series per axis, NaN in ``open_at`` None; None without axes."""
    if not axes:
        return None
    points = grid(axes)
    called = {axis.name: given for axis, given in zip(axes, points, strict=True)}
    values = {axis.key.path: called[axis.name] * axis.scale for axis in axes}
    values |= moved(clutch.spec, {name: given for name, given in called.items() if name in RATIOS})
    answers = {name: array.tolist() for name, array in evaluate(clutch.spec, values, outputs).items()}
    answers |= {
        name: [None if value != value else value for value in answers[name]] for name in open_at if name in answers
    }
    return [
        kind(parameter=axis.name, path=axis.called_path, unit=axis.key.unit or "1", values=given.tolist(), **answers)
        for axis, given in zip(axes, points, strict=True)
    ]


def evaluate(spec: Spec, values: Mapping[str, Floats], outputs: Mapping[str, Output]) -> dict[str, Floats]:
    """Evaluate functions of the clutch with arrays, SI, in place of the numbers at some paths of its spec.

    Every constraint of the spec bounds one value or orders two, so that the extremes of the arrays stand
    for all their elements: those are validated, then the arrays go through the same engine as numbers do.

    Raises:
        SpecError: a value no spec may have.
    """
    import numpy as np

    arrays = {path: np.asarray(array, float) for path, array in values.items()}
    for path, array in arrays.items():
        if array.size == 0:
            raise AfmcalcError("{path}: no values to sweep", path=path)
        if is_whole(path) and (wrong := array[array != np.floor(array)]).size:
            raise AfmcalcError("--sweep {path}: {wrong:g} is not a whole number", path=path, wrong=float(wrong[0]))
    ends = (dict.fromkeys((float(array.min()), float(array.max()))) for array in arrays.values())
    for values_at_corner in product(*ends):
        corner = dict(zip(arrays, values_at_corner, strict=True))
        try:
            valid = edit.respecified(spec, corner)
            build(valid)
        except SpecError as error:
            where = joined(say("{path} = {value:g}", path=path, value=value) for path, value in corner.items())
            problems = [problem._replace(place=None) for problem in error.problems]
            raise SpecError(say("sweep at {where}", where=where), problems) from None
    shape = np.broadcast_shapes(*(array.shape for array in arrays.values()))
    answers = {name: np.empty(shape) for name in outputs}
    # stretches of a flat sweep whose intermediate arrays stay in the processor's cache; else the whole
    flat = len(shape) == 1 and all(array.shape == shape for array in arrays.values())
    with np.errstate(all="ignore"):
        for block in [slice(start, start + _BLOCK) for start in range(0, shape[0], _BLOCK)] if flat else [...]:
            swept = edit.with_values(valid, {path: array[block] for path, array in arrays.items()})
            clutch = build(swept)
            for name, function in outputs.items():
                answers[name][block] = function(clutch)
    return answers
