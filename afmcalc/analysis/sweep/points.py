"""The points of a sweep: one array expression of the engines for all of them."""

from collections.abc import Callable, Mapping, Sequence
from itertools import product

import numpy as np

from ...arrays import Floats, Values
from ...engines import build
from ...engines.protocol import Clutch
from ...errors import AfmcalcError, SpecError
from ...spec import Spec
from ...spec.edit import respecified, with_value
from ...spec.paths import is_whole
from .grid import MOST_POINTS, Axis

Output = Callable[[Clutch], Values]
"""What is asked of the clutch at every point."""


def clutch_over(spec: Spec, values: Mapping[str, Floats]) -> Clutch:
    """Build the clutch of ``spec`` with arrays in place of the numbers at some paths.

    Every constraint of the spec bounds one value or orders two, so that the extremes of the arrays stand
    for all their elements: those are validated, then the arrays go through the same engine as numbers do.

    Args:
        spec: the spec.
        values: path → array, SI; shapes broadcast.

    Returns:
        A clutch whose answers are arrays.

    Raises:
        SpecError: a value no spec may have.
    """
    arrays = {path: np.asarray(array, float) for path, array in values.items()}
    for path, array in arrays.items():
        if array.size == 0:
            raise AfmcalcError(f"{path}: no values to sweep")
        if is_whole(path) and bool(np.any(array != np.floor(array))):
            wrong = float(array[array != np.floor(array)].ravel()[0])
            raise AfmcalcError(f"--sweep {path}: {wrong:g} is not a whole number")
    ends = [dict.fromkeys((float(array.min()), float(array.max()))) for array in arrays.values()]
    for corner in product(*ends):
        valid = _validated(spec, dict(zip(arrays, corner, strict=True)))
    for path, array in arrays.items():
        valid = with_value(valid, path.split("."), array)
    return build(valid)


def _validated(spec: Spec, corner: dict[str, float]) -> Spec:
    try:
        valid = respecified(spec, corner, "sweep")
        build(valid)
    except SpecError as error:
        where = ", ".join(f"{path} = {value:g}" for path, value in corner.items())
        raise SpecError(f"sweep at {where}", error.problems) from None
    return valid


def grid(axes: Sequence[Axis]) -> list[Floats]:
    """Coordinates of every point of the grid by axis, flat, the first axis slowest."""
    count = 1
    for axis in axes:
        count *= axis.values.size
    if count > MOST_POINTS:
        raise AfmcalcError(f"the sweep asks for {count} points; at most {MOST_POINTS} are swept")
    if len({axis.key.path for axis in axes}) < len(axes):
        raise AfmcalcError("the same key is swept twice")
    if any(axis.name == "zC" for axis in axes) and any(axis.key.path.endswith("pairs") for axis in axes):
        raise AfmcalcError("zC and a number of pairs cannot be swept together: sweep C with it")
    if len(axes) == 1:
        return [axes[0].values]
    return [coordinates.ravel() for coordinates in np.meshgrid(*(axis.values for axis in axes), indexing="ij")]


def evaluate(spec: Spec, values: Mapping[str, Floats], outputs: Mapping[str, Output]) -> dict[str, Floats]:
    """Evaluate ``outputs`` of the clutch over arrays of spec values.

    Args:
        spec: the spec.
        values: path → array, SI.
        outputs: name → function of the clutch.

    Returns:
        name → array in the broadcast shape of ``values``.
    """
    clutch = clutch_over(spec, values)
    shape = np.broadcast_shapes(*(np.shape(array) for array in values.values()))
    with np.errstate(all="ignore"):
        return {name: np.broadcast_to(function(clutch), shape) for name, function in outputs.items()}
