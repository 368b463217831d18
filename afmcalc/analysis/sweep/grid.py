"""A sweep: its axes, keys of the spec, and the answers over their grid in one array expression of the engines.

Loads NumPy when asked.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from itertools import product
from typing import NamedTuple, TypeVar

from ...engines import build
from ...engines.protocol import Clutch
from ...equations.arrays import Floats, Values
from ...errors import AfmcalcError, SpecError
from ...findings import Finding, finding
from ...messages import joined, say
from ...result import Series
from ...spec import Spec, edit
from ...spec.fields import Key
from ...spec.keys import is_whole

MOST_POINTS = 200_000
"""Points of a sweep: its answers take 0.3 GB then."""
_BLOCK = 16_000
"""Points calculated at a time: as many as an array may have that the allocator keeps (128 KiB); a larger one it gives
back to the system each time, and fetching its pages anew takes longer than all the arithmetic."""
Output = str | Callable[[Clutch], Values]
"""What is asked of the clutch at every point: a quantity, or a function of it."""


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
        """What its values are: a spec path; of zC, no key, its name in results."""
        return "reduced_gain" if self.name == "zC" else self.key.path


def replaced(spec: Spec, axes: Sequence[Axis]) -> list[Finding]:
    """Say which keys of the spec a sweep has taken the place of, and ask after its numbers without a unit."""
    gone = edit.replaced(spec, [axis.key.path for axis in axes])
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
    return [coordinates.ravel() for coordinates in np.meshgrid(*(axis.values for axis in axes), indexing="ij")]


S = TypeVar("S", bound=Series)


def series(
    kind: type[S],
    spec: Spec,
    axes: Sequence[Axis],
    outputs: Mapping[str, Output],
    open_at: Sequence[str] = (),
    block: int = _BLOCK,
) -> list[S] | None:
    """Sweep ``outputs`` over the grid of ``axes``, one series per axis, NaN in ``open_at`` None; None without axes."""
    if not axes:
        return None
    points = grid(axes)
    values = {axis.key.path: given * axis.scale for axis, given in zip(axes, points, strict=True)}
    answers = {name: array.tolist() for name, array in evaluate(spec, values, outputs, block).items()}
    answers |= {
        name: [None if value != value else value for value in answers[name]] for name in open_at if name in answers
    }
    return [
        kind(parameter=axis.name, path=axis.called_path, unit=axis.key.unit or "1", values=given.tolist(), **answers)
        for axis, given in zip(axes, points, strict=True)
    ]


def evaluate(
    spec: Spec, values: Mapping[str, Floats], outputs: Mapping[str, Output], block: int = _BLOCK
) -> dict[str, Floats]:
    """Evaluate what is asked of the clutch with arrays, SI, in place of the numbers at some paths of its spec.

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
        for part in [slice(start, start + block) for start in range(0, shape[0], block)] if flat else [...]:
            swept = edit.with_values(valid, {path: array[part] for path, array in arrays.items()})
            clutch = build(swept)
            for name, output in outputs.items():
                answers[name][part] = clutch.quantities[output] if isinstance(output, str) else output(clutch)
    return answers
