"""A sweep: its axes, keys of the spec, and the answers over their grid in one array expression of the engines.

Loads NumPy when asked.
"""

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple, TypeVar

from ...engines.evaluate import BLOCK, Output, evaluate
from ...equations.arrays import Floats
from ...errors import AfmcalcError
from ...findings import Finding, finding
from ...result import Series
from ...spec import Spec, edit
from ...spec.fields import Key

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
    block: int = BLOCK,
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
