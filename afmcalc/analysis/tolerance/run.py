"""The torque of a clutch over a sample of what scatters, block by block, in threads."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from ...engines.protocol import Clutch
from ...equations import life as law
from .sampling import CELL, REPLICATES, Model, Stream, cells, in_threads, sizes
from .tally import Grid, Tally


@dataclass(frozen=True)
class Plan:
    """How to sample; threads and block change the time, never a digit."""

    samples: int
    seed: int
    quasi: bool = False
    threads: int = 1
    block: int = CELL


def simulate(model: Model, plan: Plan, upper: float | None, lower: float) -> list[Tally]:
    """Sample the torque.

    Args:
        model: torque as a function of what scatters.
        plan: size, seed, method, threads, block.
        upper: torque whose exceedance is counted, N·m; None for none.
        lower: torque below which samples are counted, N·m.

    Returns:
        A tally per replicate.
    """
    import numpy as np

    each = sizes(plan.samples, plan.quasi)
    pilot_width = min(CELL, each[0])
    pilot = [np.empty(pilot_width) for _ in model.inputs]
    Stream(model.inputs, plan.seed, 0, quasi=plan.quasi, model=model).fill(pilot)
    grid = Grid.of(np.broadcast_to(model.torque(pilot), pilot_width))

    def replicate(number: int) -> Tally:
        stream = Stream(model.inputs, plan.seed, number, quasi=plan.quasi, model=model)
        tally = Tally(grid)
        room = min(max(CELL, plan.block), max(each[number], 1))
        columns = [np.empty(room) for _ in model.inputs]
        torque, work, index = np.empty(room), np.empty(CELL), np.empty(CELL, np.intp)
        damages = (np.empty(room), np.empty(room))
        for widths in cells(each[number], plan.block):
            end = 0
            for width in widths:
                stream.fill([column[end : end + width] for column in columns])
                end += width
            for start in range(0, end, plan.block):
                piece = slice(start, min(start + plan.block, end))
                values = [column[piece] for column in columns]
                clutch = model.clutch(values)
                torque[piece] = model.torque(values, clutch)
                if model.spec.fatigue is not None:
                    for damage, share in zip(damages, damage_rates(clutch, torque[piece]), strict=True):
                        damage[piece] = share
            start = 0
            for width in widths:
                cell = slice(start, start + width)
                tally.add(torque[cell], work[:width], index[:width])
                tally.above += 0 if upper is None else int(np.count_nonzero(torque[cell] > upper))
                tally.below += int(np.count_nonzero(torque[cell] < lower))
                if model.spec.fatigue is not None:
                    tally.damage += float(damages[0][cell].sum())
                    tally.damage_unprotected += float(damages[1][cell].sum())
                start += width
        return tally

    return in_threads(replicate, REPLICATES, plan.threads)


def damage_rates(clutch: Clutch, torque: Any) -> tuple[Any, Any]:
    """Damage 1/N of one slip on the protected and the unprotected side (Miner), by the paper's S–N line."""
    part = clutch.spec.fatigue
    assert part is not None

    def rate(load: Any) -> Any:
        stress = law.shear_stress(load, part.polar_section_modulus)
        return 1 / law.cycles(part.endurance_limit, stress, part.exponent, part.base_cycles)

    return rate(torque), rate(clutch.spec.drive.dynamic_factor * torque)


def spread_of(figure: Callable[[Tally], float], tallies: Sequence[Tally]) -> float:
    """Standard error of a figure of the whole sample, from its spread between the replicates."""
    from statistics import stdev

    return float(stdev([figure(each) for each in tallies]) / len(tallies) ** 0.5)
