"""The sampling run: the torque of a clutch over a sample of what scatters, cell by cell, in threads."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...errors import CalculationError
from ...messages import say
from ...progress import Count
from .bins import Grid
from .distributions import Array
from .model import Model
from .service import life_of, service_of, unprotected
from .streams import CELL, REPLICATES, Stream, cells, in_threads, sizes
from .tally import Tally

POPULATION = 200_000
"""Clutches whose life is calculated, at most: each is asked at every node of its service."""
_LEAST_CLUTCHES = 2
"""In each replicate: one has no spread."""


@dataclass(frozen=True)
class Plan:
    """How to sample; threads change the time, never a digit."""

    samples: int
    seed: int
    quasi: bool = False
    threads: int = 1


def simulate(model: Model, plan: Plan, upper: float | None, lower: float) -> list[Tally]:
    """Sample the torque.

    Args:
        model: torque as a function of what scatters.
        plan: size, seed, method, threads.
        upper: torque whose exceedance is counted, N·m; None for none.
        lower: torque below which samples are counted, N·m.

    Returns:
        A tally per replicate.

    Raises:
        CalculationError: hardly any sample is a clutch.
    """
    each = sizes(plan.samples, plan.quasi)
    pilot = _possible(model, _pilot(model, plan, each[0]))
    _refuse_few(pilot[0].size)
    torques = np.broadcast_to(model.torque(pilot), pilot[0].shape)
    grid, shift = Grid.of(torques), float(np.median(torques))
    slips = None if model.spec.fatigue is None else service_of(model)

    behind = Count(say("sampling"), sum(each))

    def replicate(number: int) -> Tally:
        stream = Stream(model.inputs, plan.seed, number, quasi=plan.quasi, model=model)
        tally = Tally(grid, shift)
        room = min(CELL, each[number])
        columns = [np.empty(room) for _ in model.inputs]
        work, index = np.empty(room), np.empty(room, np.uint64)
        for width in cells(each[number]):
            behind.add(width)
            drawn = [column[:width] for column in columns]
            stream.fill(drawn)
            values = _possible(model, drawn)
            size = values[0].size
            tally.impossible += width - size
            if not size:
                continue
            clutch = model.clutch(values)
            torque = np.broadcast_to(model.torque(values, clutch), size)
            tally.add(torque, work[:size], index[:size])
            tally.above += 0 if upper is None else int(np.count_nonzero(torque > upper))
            tally.below += int(np.count_nonzero(torque < lower))
            if slips is not None and tally.clutches < POPULATION // REPLICATES:
                few = min(size, POPULATION // REPLICATES - tally.clutches)
                clutch = model.clutch([column[:few] for column in values])
                life = life_of(model, clutch, slips)
                both = (life, unprotected(clutch, life))
                tally.lives.append(np.stack([np.broadcast_to(side, few) for side in both]))
        return tally

    tallies = in_threads(replicate, REPLICATES, plan.threads)
    _refuse_few(min(tally.count for tally in tallies))
    return tallies


def _refuse_few(clutches: int) -> None:
    if clutches < _LEAST_CLUTCHES:
        raise CalculationError(
            say(
                "tolerance: hardly a sample is a clutch (feedback must overcome the key's friction, faces have a width)"
            )
        )


def _pilot(model: Model, plan: Plan, size: int) -> list[Array]:
    """Return the first cell of the first replicate."""
    columns = [np.empty(min(CELL, size)) for _ in model.inputs]
    Stream(model.inputs, plan.seed, 0, quasi=plan.quasi, model=model).fill(columns)
    return columns


def _possible(model: Model, values: Sequence[Array]) -> Sequence[Array]:
    """Leave out what is no clutch."""
    if not model.may_fail:
        return values
    possible = model.possible(values)
    return values if possible.all() else [column[possible] for column in values]
