"""Sweeps: any numeric key of the spec over a range of values, one array expression for all points."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

from ...engines import build
from ...engines.protocol import Clutch
from ...errors import AfmcalcError, SpecError
from ...findings import Finding
from ...messages import say
from ...result import Series
from ...spec import Spec, make_spec
from ...spec.edit import ALTERNATIVES, put, value_at, with_value
from ...spec.paths import is_whole
from ...spec.walk import Key

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


MOST_POINTS = 2_000_000


class Axis(NamedTuple):
    """One swept key with its values, SI."""

    name: str
    """As the user called it: a symbol or a path."""
    key: Key
    values: "NDArray[np.float64]"
    """Values of the parameter as called."""
    scale: float = 1.0
    """What a value is multiplied by to give the spec key (zC → C)."""


def clutch_over(spec: Spec, values: Mapping[str, Any]) -> Clutch:
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
    import numpy as np

    arrays = {path: np.asarray(array, float) for path, array in values.items()}
    for path, array in arrays.items():
        if array.size == 0:
            raise AfmcalcError(say("{path}: no values to sweep", path=path))
        if is_whole(path) and bool(np.any(array != np.floor(array))):
            wrong = float(array[array != np.floor(array)].ravel()[0])
            raise AfmcalcError(say("--sweep {path}: {wrong:g} is not a whole number", path=path, wrong=wrong))
    data = spec.model_dump(exclude_none=True)
    for path in arrays:
        for other in ALTERNATIVES.get(path, ()):
            if other not in arrays:
                if other == "friction.material" and spec.friction.material is not None:
                    low, _, high = spec.friction.range
                    data["friction"] = {"min": low, "max": high}
                put(data, other, None)
    valid = None
    for extreme in _corners(arrays):
        valid = _validated(data, extreme, spec.label)
    assert valid is not None
    for path, array in arrays.items():
        valid = with_value(valid, path.split("."), array)
    return build(valid)


def replaced(spec: Spec, axes: Sequence[Axis]) -> list[Finding]:
    """Say which keys of the spec a sweep has taken the place of."""
    swept = {axis.key.path for axis in axes}
    found = []
    for path in sorted(swept):
        for other in ALTERNATIVES.get(path, ()):
            if other not in swept and value_at(spec, other) is not None:
                message = f"{other} of the spec gives way to the swept {path}"
                found.append(Finding(level="info", code="sweep-replaces", message=message, path=other))
    return found


def _corners(arrays: Mapping[str, Any]) -> list[dict[str, float]]:
    """Every combination of smallest and largest values (one swept key: two of them)."""
    corners: list[dict[str, float]] = [{}]
    for path, array in arrays.items():
        ends = dict.fromkeys((float(array.min()), float(array.max())))
        corners = [{**corner, path: end} for corner in corners for end in ends]
    return corners


def _validated(data: Mapping[str, Any], extreme: Mapping[str, float], label: str) -> Spec:
    import copy

    trial = copy.deepcopy(dict(data))
    for path, value in extreme.items():
        put(trial, path, int(value) if is_whole(path) else value)
    try:
        valid = make_spec(trial, label)
        build(valid)
    except SpecError as error:
        where = ", ".join(f"{path} = {value:g}" for path, value in extreme.items())
        raise SpecError(say("sweep at {where}", where=where), error.problems) from None
    return valid


def grid(axes: Sequence[Axis]) -> list[Any]:
    """Coordinates of every point of the grid by axis, flat, the first axis slowest."""
    import numpy as np

    count = 1
    for axis in axes:
        count *= axis.values.size
    if count > MOST_POINTS:
        raise AfmcalcError(
            say(
                "the sweep asks for {count} points; at most {most_points} are swept",
                count=count,
                most_points=MOST_POINTS,
            )
        )
    if len({axis.key.path for axis in axes}) < len(axes):
        raise AfmcalcError(say("the same key is swept twice"))
    if any(axis.name == "zC" for axis in axes) and any(axis.key.path.endswith("pairs") for axis in axes):
        raise AfmcalcError(say("zC and a number of pairs cannot be swept together: sweep C with it"))
    if len(axes) == 1:
        return [axes[0].values]
    return [coordinates.ravel() for coordinates in np.meshgrid(*(axis.values for axis in axes), indexing="ij")]


def evaluate(spec: Spec, values: Mapping[str, Any], outputs: Mapping[str, Callable[[Clutch], Any]]) -> dict[str, Any]:
    """Evaluate ``outputs`` of the clutch over arrays of spec values.

    Args:
        spec: the spec.
        values: path → array, SI.
        outputs: name → function of the clutch.

    Returns:
        name → array in the broadcast shape of ``values``.
    """
    import numpy as np

    clutch = clutch_over(spec, values)
    shape = np.broadcast_shapes(*(np.shape(array) for array in values.values()))
    with np.errstate(all="ignore"):
        return {name: np.broadcast_to(function(clutch), shape) for name, function in outputs.items()}


S = TypeVar("S", bound=Series)


def series(
    kind: type[S], clutch: Clutch, axes: Sequence[Axis], outputs: Mapping[str, Callable[[Clutch], Any]]
) -> list[S] | None:
    """Sweep ``outputs`` over the grid of ``axes``, one series per axis; None without axes."""
    if not axes:
        return None
    points = grid(axes)
    values = {axis.key.path: given * axis.scale for axis, given in zip(axes, points, strict=True)}
    answers = {name: array.tolist() for name, array in evaluate(clutch.spec, values, outputs).items()}
    return [
        kind(parameter=axis.name, path=axis.key.path, unit=axis.key.unit or "1", values=given.tolist(), **answers)
        for axis, given in zip(axes, points, strict=True)
    ]
