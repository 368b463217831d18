"""First-order and total Sobol indices of the torque (Saltelli 2010, Jansen 1999), with standard errors."""

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from ...errors import CalculationError
from ...messages import say
from ...progress import Count
from .distributions import Array
from .model import Model
from .result import Estimate
from .run import Plan
from .streams import CELL, REPLICATES, Stream, cells, in_threads, sizes


class Index(NamedTuple):
    """Indices of one input, or of the pair of correlated frictions."""

    name: str
    first_order: Estimate
    total: Estimate


class Group(NamedTuple):
    """Inputs that vary together, by their places."""

    name: str
    members: tuple[int, ...]


def groups_of(model: Model) -> list[Group]:
    """Inputs that vary apart: each alone, the correlated frictions together (indices need independence)."""
    pair: tuple[int, ...] = model.pair or ()
    alone = [Group(each.path, (number,)) for number, each in enumerate(model.inputs) if number not in pair]
    if not pair:
        return alone
    before = sum(group.members[0] < pair[0] for group in alone)
    return [*alone[:before], Group("friction.driving + friction.driven", pair), *alone[before:]]


def sobol_indices(model: Model, plan: Plan) -> list[Index]:
    """Sobol indices of the torque with ``plan.samples`` as the base sample.

    Raises:
        CalculationError: no row of the base sample is a clutch throughout.
    """
    groups = groups_of(model)
    count = len(model.inputs)
    each = sizes(plan.samples, plan.quasi)
    center = model.torque([one.center for one in model.inputs])

    def torque(values: Sequence[Array]) -> Array:
        return np.broadcast_to(model.torque(values) - center, values[0].shape)

    behind = Count(say("indices"), sum(each))

    def replicate(number: int) -> Array:
        # streams of their own, apart from those of the sample
        inputs = [*model.inputs, *model.inputs]
        stream = Stream(inputs, plan.seed, REPLICATES + number, quasi=plan.quasi, model=model)
        sums = np.zeros(3 + 2 * len(groups))
        columns = [np.empty(min(CELL, each[number])) for _ in inputs]
        for width in cells(each[number]):
            behind.add(width)
            cut = [column[:width] for column in columns]
            stream.fill(cut)
            one, other, mixed = _mixed(model, cut[:count], cut[count:], groups)
            if one[0].size:
                sums += _cell(torque, one, other, mixed)
        return sums

    rows = np.array(in_threads(replicate, REPLICATES, plan.threads))
    if not rows[:, 0].any():
        raise CalculationError(say("tolerance.sobol_base: too few of the samples are a clutch; give a larger one"))
    return _indices(rows, [group.name for group in groups])


def _mixed(
    model: Model, one: list[Array], other: list[Array], groups: Sequence[Group]
) -> tuple[list[Array], list[Array], list[list[Array]]]:
    """Two samples and, per group, the first with that group from the second; without rows that are no clutch."""
    mixed = [[other[k] if k in group.members else one[k] for k in range(len(one))] for group in groups]
    if not model.may_fail:
        return one, other, mixed
    kept = np.logical_and.reduce([model.possible(values) for values in (one, other, *mixed)])
    first, second, *rest = ([column[kept] for column in values] for values in (one, other, *mixed))
    return first, second, rest


def _cell(
    torque: Callable[[Sequence[Array]], Array], one: list[Array], other: list[Array], mixed: list[list[Array]]
) -> Array:
    """Sums of one cell: size, values, squares, then both numerators of each group."""
    at_one, at_other = torque(one), torque(other)
    sums = [float(at_one.size), float(at_one.sum() + at_other.sum()), float((at_one**2).sum() + (at_other**2).sum())]
    for values in mixed:
        difference = torque(values) - at_one
        sums.append(float((at_other * difference).sum()))
        sums.append(float((difference**2).sum()) / 2)
    return np.array(sums)


def _indices(rows: Array, names: Sequence[str]) -> list[Index]:
    """Indices as ratios of sums; their errors from the spread of the replicates about the ratio."""
    whole = rows.sum(axis=0)
    mean = whole[1] / (2 * whole[0])
    variance = whole[2] / (2 * whole[0]) - mean**2
    # each replicate's variance about the common mean, so that the ratio's numerator and denominator match
    parts = rows[:, 2] / 2 - mean * rows[:, 1] + mean**2 * rows[:, 0]

    def ratio_of(column: int) -> Estimate:
        if not variance > 0:
            return Estimate(0.0)
        ratio = whole[column] / whole[0] / variance
        residual = rows[:, column] - ratio * parts
        error = math.sqrt(float(np.sum(residual**2)) * len(rows) / (len(rows) - 1)) / whole[0]
        return Estimate(float(ratio), float(error / variance))

    return [Index(name, ratio_of(3 + 2 * k), ratio_of(4 + 2 * k)) for k, name in enumerate(names)]
