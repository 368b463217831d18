"""Many clutches at once: quantities of a spec with arrays in place of some of its numbers. Loads NumPy when asked."""

from collections.abc import Callable, Mapping
from itertools import product

from ..equations.arrays import Floats, Values
from ..errors import AfmcalcError, SpecError
from ..messages import say
from ..spec import Spec, edit
from ..spec.keys import is_whole
from . import Clutch, build

SLOPE = "control_unit.gain_slope"
"""Key of which 0 makes a straight wall, by other laws."""
BLOCK = 16_000
"""Points calculated at a time: as many as an array may have that the allocator keeps (128 KiB); a larger one it gives
back to the system each time, and fetching its pages anew takes longer than all the arithmetic."""
Output = str | Callable[[Clutch], Values]
"""Output at every point: a quantity, or a function of the clutch."""


def evaluate(
    spec: Spec, values: Mapping[str, Floats], outputs: Mapping[str, Output], block: int = BLOCK
) -> dict[str, Floats]:
    """Evaluate what is asked of the clutch with arrays of one size, SI, in place of numbers at some paths of its spec.

    Every constraint of the spec bounds one value or orders two, so that the extremes of the arrays stand for all their
    elements: those are validated, then the arrays go through the same engine as numbers do. Raises SpecError: a value
    no spec may have.
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
            where = ", ".join(say("{path} = {value:g}", path=path, value=value) for path, value in corner.items())
            problems = [problem._replace(place=None) for problem in error.problems]
            raise SpecError(say("sweep at {where}", where=where), problems) from None
    size = max(array.size for array in arrays.values())
    slopes = np.broadcast_to(arrays.get(SLOPE, 1.0), size)
    answers = {name: np.empty(size) for name in outputs}
    with np.errstate(all="ignore"):
        # in blocks, so that intermediate arrays stay in the processor's cache; straight walls apart from curved ones
        walls = (np.flatnonzero(kind) for kind in (slopes != 0, slopes == 0))
        for part in (wall[start : start + block] for wall in walls for start in range(0, wall.size, block)):
            swept = edit.with_values(valid, {path: array[part] for path, array in arrays.items()})
            clutch = build(swept)
            for name, output in outputs.items():
                answers[name][part] = clutch[output] if isinstance(output, str) else output(clutch)
    return answers
