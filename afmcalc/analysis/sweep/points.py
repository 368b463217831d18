"""The points of a sweep: one array expression of the engines for all of them."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import product
from types import EllipsisType

import numpy as np

from ...arrays import Floats, Values
from ...engines import build
from ...engines.protocol import Clutch
from ...errors import AfmcalcError, SpecError
from ...messages import joined, say
from ...spec import Spec
from ...spec.edit import respecified, with_values
from ...spec.paths import is_whole

_BLOCK = 16_000
"""Points calculated at a time: as many as an array may have that the allocator keeps (128 KiB); a larger one it gives
back to the system each time, and fetching its pages anew takes longer than all the arithmetic."""
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
    arrays = _arrays(values)
    return _over(_checked(spec, arrays), arrays)


def _arrays(values: Mapping[str, Floats]) -> dict[str, Floats]:
    return {path: np.asarray(array, float) for path, array in values.items()}


def _over(spec: Spec, arrays: Mapping[str, Floats]) -> Clutch:
    return build(with_values(spec, ((path.split("."), array) for path, array in arrays.items())))


def _checked(spec: Spec, arrays: Mapping[str, Floats]) -> Spec:
    """Return the spec ready to take the arrays, every corner of their extremes validated."""
    for path, array in arrays.items():
        if array.size == 0:
            raise AfmcalcError(say("{path}: no values to sweep", path=path))
        if is_whole(path) and bool(np.any(array != np.floor(array))):
            wrong = float(array[array != np.floor(array)].ravel()[0])
            raise AfmcalcError(say("--sweep {path}: {wrong:g} is not a whole number", path=path, wrong=wrong))
    for corner in product(*map(_ends, arrays.values())):
        valid = _validated(spec, dict(zip(arrays, corner, strict=True)))
    return valid


def _ends(array: Floats) -> Iterable[float]:
    """Smallest and largest element, one where they are equal."""
    flat = array.ravel()
    # stretch by stretch: the second look finds it in the cache
    ends = [(part.min(), part.max()) for part in np.array_split(flat, -(-flat.size // _BLOCK))]
    return dict.fromkeys((float(min(low for low, _ in ends)), float(max(high for _, high in ends))))


def _validated(spec: Spec, corner: dict[str, float]) -> Spec:
    try:
        valid = respecified(spec, corner)
        build(valid)
    except SpecError as error:
        where = joined(say("{path} = {value:g}", path=path, value=value) for path, value in corner.items())
        raise SpecError(say("sweep at {where}", where=where), error.problems) from None
    return valid


def evaluate(spec: Spec, values: Mapping[str, Floats], outputs: Mapping[str, Output]) -> dict[str, Floats]:
    """Evaluate ``outputs`` of the clutch over arrays of spec values.

    Args:
        spec: the spec.
        values: path → array, SI.
        outputs: name → function of the clutch.

    Returns:
        name → array in the broadcast shape of ``values``.
    """
    arrays = _arrays(values)
    valid = _checked(spec, arrays)
    shape = np.broadcast_shapes(*(array.shape for array in arrays.values()))
    answers = {name: np.empty(shape) for name in outputs}
    with np.errstate(all="ignore"):
        for block in _blocks(shape, arrays):
            clutch = _over(valid, {path: array[block] for path, array in arrays.items()})
            for name, function in outputs.items():
                answers[name][block] = function(clutch)
    return answers


def _blocks(shape: tuple[int, ...], arrays: Mapping[str, Floats]) -> Sequence[slice | EllipsisType]:
    """Stretches of a flat sweep whose intermediate arrays stay in the processor's cache; else the whole."""
    if len(shape) != 1 or any(array.shape != shape for array in arrays.values()):
        return [...]
    return [slice(start, start + _BLOCK) for start in range(0, shape[0], _BLOCK)]
