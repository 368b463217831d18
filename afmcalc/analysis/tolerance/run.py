"""The sampling run: the torque of a clutch over a sample of what scatters, cell by cell, in threads."""

from dataclasses import dataclass

import numpy as np

from ...arrays import Values
from ...engines import Clutch
from ...equations import life as law
from .model import Model
from .streams import CELL, REPLICATES, Stream, cells, in_threads, sizes
from .tally import Grid, Tally


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
    """
    each = sizes(plan.samples, plan.quasi)
    pilot = [np.empty(min(CELL, each[0])) for _ in model.inputs]
    Stream(model.inputs, plan.seed, 0, quasi=plan.quasi, model=model).fill(pilot)
    grid = Grid.of(np.broadcast_to(model.torque(pilot), pilot[0].shape))

    def replicate(number: int) -> Tally:
        stream = Stream(model.inputs, plan.seed, number, quasi=plan.quasi, model=model)
        tally = Tally(grid)
        room = min(CELL, each[number])
        columns = [np.empty(room) for _ in model.inputs]
        work, index = np.empty(room), np.empty(room, np.intp)
        for width in cells(each[number]):
            values = [column[:width] for column in columns]
            stream.fill(values)
            clutch = model.clutch(values)
            torque = np.broadcast_to(model.torque(values, clutch), width)
            tally.add(torque, work[:width], index[:width])
            tally.above += 0 if upper is None else int(np.count_nonzero(torque > upper))
            tally.below += int(np.count_nonzero(torque < lower))
            if model.spec.fatigue is not None:
                rates = (np.broadcast_to(rate, width).sum() for rate in damage_rates(clutch, torque))
                protected, unprotected = (float(rate) for rate in rates)
                tally.damage += protected
                tally.damage_unprotected += unprotected
        return tally

    return in_threads(replicate, REPLICATES, plan.threads)


def damage_rates(clutch: Clutch, torque: Values) -> tuple[Values, Values]:
    """Damage 1/N of one slip on the protected and the unprotected side (Miner), by the paper's S–N line."""
    part = clutch.spec.fatigue
    assert part is not None

    def rate(load: Values) -> Values:
        stress = law.shear_stress(load, part.polar_section_modulus)
        damage: Values = 1 / law.cycles(part.endurance_limit, stress, part.exponent, part.base_cycles)
        return damage

    return rate(torque), rate(clutch.spec.drive.dynamic_factor * torque)
