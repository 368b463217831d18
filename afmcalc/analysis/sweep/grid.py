"""A sweep: its axes, and the series of answers over their grid. Loads no NumPy where nothing is swept."""

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple, TypeVar

from ...arrays import Floats, Values
from ...engines.protocol import Clutch
from ...errors import AfmcalcError
from ...findings import Finding, doubts, finding
from ...messages import say
from ...result import Series
from ...source import Unlikely
from ...spec import Spec, edit
from ...spec.walk import Key

MOST_POINTS = 200_000
"""Points of a sweep: its answers take 0.3 GB then."""


class Axis(NamedTuple):
    """One swept key with its values, SI."""

    name: str
    """As the user called it: a symbol or a path."""
    key: Key
    values: Floats
    """Values of the parameter as called."""
    scale: float = 1.0
    """What a value is multiplied by to give the spec key (zC → C)."""
    doubt: Unlikely | None = None
    """The first value without a unit that may be meant in another than SI."""


def replaced(spec: Spec, axes: Sequence[Axis]) -> list[Finding]:
    """Say which keys of the spec a sweep has taken the place of, and ask after its numbers without a unit."""
    gone = edit.replaced(spec, [axis.key.path for axis in axes])
    asked = doubts(axis.doubt for axis in axes if axis.doubt)
    return [*asked, *(finding("sweep-replaces", "info", path=path, by=by) for path, by in gone.items())]


def grid(axes: Sequence[Axis]) -> list[Floats]:
    """Coordinates of every point of the grid by axis, flat, the first axis slowest."""
    count = 1
    for axis in axes:
        count *= axis.values.size
    if count > MOST_POINTS:
        raise AfmcalcError(
            say(
                "the sweep asks for {count:,} points; at most {most:,} are swept",
                count=count,
                most=MOST_POINTS,
            )
        )
    if len({axis.key.path for axis in axes}) < len(axes):
        raise AfmcalcError(say("the same key is swept twice"))
    if any(axis.name == "zC" for axis in axes) and any(axis.key.path.endswith("pairs") for axis in axes):
        raise AfmcalcError(say("zC and a number of pairs cannot be swept together: sweep C with it"))
    if len(axes) == 1:
        return [axes[0].values]
    import numpy as np

    return [coordinates.ravel() for coordinates in np.meshgrid(*(axis.values for axis in axes), indexing="ij")]


S = TypeVar("S", bound=Series)


def series(
    kind: type[S],
    clutch: Clutch,
    axes: Sequence[Axis],
    outputs: Mapping[str, Callable[[Clutch], Values]],
    open_at: Sequence[str] = (),
) -> list[S] | None:
    """Sweep ``outputs`` over the grid of ``axes``, one series per axis, NaN in ``open_at`` None; None without axes."""
    if not axes:
        return None
    from .points import evaluate

    points = grid(axes)
    values = {axis.key.path: given * axis.scale for axis, given in zip(axes, points, strict=True)}
    answers = {name: array.tolist() for name, array in evaluate(clutch.spec, values, outputs).items()}
    answers |= {name: [None if each != each else each for each in answers[name]] for name in open_at if name in answers}
    return [
        kind(parameter=axis.name, path=axis.key.path, unit=axis.key.unit or "1", values=given.tolist(), **answers)
        for axis, given in zip(axes, points, strict=True)
    ]
