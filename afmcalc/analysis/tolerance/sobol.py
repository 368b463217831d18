"""First-order and total Sobol indices of the torque (Saltelli 2010, Jansen 1999), with standard errors."""

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

from .run import Plan
from .sampling import CELL, REPLICATES, Model, Stream, in_threads, sizes


class Index(NamedTuple):
    """Indices of one input, or of the pair of correlated frictions."""

    name: str
    first_order: float
    first_order_error: float
    total: float
    total_error: float


def groups_of(model: Model) -> list[tuple[str, tuple[int, ...]]]:
    """Inputs that vary apart: each alone, the correlated frictions together (indices need independence)."""
    pair: tuple[int, ...] = model.pair or ()
    found: list[tuple[str, tuple[int, ...]]] = []
    for number, each in enumerate(model.inputs):
        if number not in pair:
            found.append((each.path, (number,)))
        elif number == pair[0]:
            found.append(("friction.driving + friction.driven", pair))
    return found


def sobol_indices(model: Model, plan: Plan) -> list[Index]:
    """Sobol indices of the torque with ``plan.samples`` as the base sample."""
    import numpy as np

    groups = groups_of(model)
    count = len(model.inputs)
    each = sizes(plan.samples, plan.quasi)
    center = model.torque([one.center for one in model.inputs])

    def replicate(number: int) -> Any:
        # streams of their own, apart from those of the sample
        inputs = [*model.inputs, *model.inputs]
        stream = Stream(inputs, plan.seed, REPLICATES + number, quasi=plan.quasi, model=model)
        sums = np.zeros(3 + 2 * len(groups))
        columns = [np.empty(min(CELL, each[number])) for _ in inputs]
        left = each[number]
        while left > 0:
            width = min(CELL, left)
            cut = [column[:width] for column in columns]
            stream.fill(cut)
            sums += _cell(model, cut[:count], cut[count:], groups, center)
            left -= width
        return sums

    rows = np.array(in_threads(replicate, REPLICATES, plan.threads))
    return _indices(rows, [name for name, _ in groups])


def _cell(model: Model, one: list[Any], other: list[Any], groups: Sequence[tuple[str, tuple[int, ...]]], c: Any) -> Any:
    """Sums of one cell: size, values, squares, then both numerators of each group."""
    import numpy as np

    width = one[0].size
    at_one = np.broadcast_to(model.torque(one) - c, width)
    at_other = np.broadcast_to(model.torque(other) - c, width)
    sums = [float(width), float(at_one.sum() + at_other.sum()), float((at_one**2).sum() + (at_other**2).sum())]
    for _, members in groups:
        mixed = model.torque([other[k] if k in members else one[k] for k in range(len(one))]) - c
        difference = mixed - at_one
        sums.append(float((at_other * difference).sum()))
        sums.append(float((difference**2).sum()) / 2)
    return np.array(sums)


def _indices(rows: Any, names: list[str]) -> list[Index]:
    """Indices as ratios of sums; their errors from the spread of the replicates about the ratio."""
    import numpy as np

    whole = rows.sum(axis=0)
    mean = whole[1] / (2 * whole[0])
    variance = whole[2] / (2 * whole[0]) - mean**2
    # each replicate's variance about the common mean, so that the ratio's numerator and denominator match
    parts = rows[:, 2] / 2 - mean * rows[:, 1] + mean**2 * rows[:, 0]
    found = []
    for number, name in enumerate(names):
        pair = []
        for column in (3 + 2 * number, 4 + 2 * number):
            ratio = whole[column] / whole[0] / variance if variance > 0 else 0.0
            residual = rows[:, column] - ratio * parts
            error = math.sqrt(float(np.sum(residual**2)) * len(rows) / (len(rows) - 1)) / whole[0]
            pair += [float(ratio), error / variance if variance > 0 else 0.0]
        found.append(Index(name, *pair))
    return found
