"""Many clutches at once: a spec with arrays in place of some numbers."""

from collections.abc import Callable, Mapping
from itertools import product

import numpy as np

from ..equations.arrays import Floats, Values
from ..errors import AfmcalcError, SpecError
from ..messages import say
from ..spec import Spec, edit
from ..spec.keys import is_whole
from . import Clutch, build

SLOPE = "control_unit.gain_slope"
"""Key whose value 0 means a straight wall, which has other laws."""
BLOCK = 8_000
"""Number of points calculated at a time: their arrays stay in the processor's cache and go back to the allocator."""
Output = str | Callable[[Clutch], Values]
"""Output calculated at every point: the name of a quantity, or a function of the clutch."""


def evaluate(spec: Spec, values: Mapping[str, Floats], outputs: Mapping[str, Output]) -> dict[str, Floats]:
    """Evaluate outputs of a clutch with arrays of one size, SI, in place of numbers at some paths of its spec.

    Every constraint of a spec bounds one value or orders two values, so it suffices to validate the extremes of the
    arrays; then the arrays go through the same engine as numbers. Raises SpecError if a spec with extremes is invalid.
    """
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
            where = ", ".join(say("{path} = {value:g}", path=path, value=value) for path, value in corner.items())
            problems = [problem._replace(origin="", place=None) for problem in error.problems]
            raise SpecError(say("sweep at {where}", where=where), problems) from None
    size = max(array.size for array in arrays.values())
    slopes = np.broadcast_to(arrays.get(SLOPE, 1.0), size)
    answers = {name: np.empty(size) for name in outputs}
    with np.errstate(all="ignore"):
        # in blocks, so that intermediate arrays stay in the processor's cache; straight and curved walls separately
        walls = (np.flatnonzero(kind) for kind in (slopes != 0, slopes == 0))
        for part in (wall[start : start + BLOCK] for wall in walls for start in range(0, wall.size, BLOCK)):
            swept = edit.with_values(valid, {path: array[part] for path, array in arrays.items()})
            clutch = build(swept)
            for name, output in outputs.items():
                answers[name][part] = clutch[output] if isinstance(output, str) else output(clutch)
    return answers
