"""The peak torque in the shaft over making and service: the event of the [drive] block, once for every clutch drawn."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from ...engines import Clutch
from ...errors import CalculationError
from ...messages import say
from ...spec.edit import with_value
from ...spec.tolerance import Tolerance
from ..registry import ANALYSES
from ..simulate.sweep import peaks_of
from .distributions import Array
from .model import Model
from .ranked import spread
from .result import Estimate
from .streams import REPLICATES, Stream
from .tally import ranked_values

SAMPLES = 4096
"""Drives that are simulated: each takes thousands of steps."""


class PeakFigures(NamedTuple):
    """What is told of the peak torque."""

    samples: int
    mean: Estimate
    deviation: Estimate
    quantiles: list[Estimate]
    above: Estimate | None
    """Probability of more than the requirement allows."""


def peak_figures(model: Model, given: Tolerance, clutch: Clutch) -> PeakFigures | None:
    """Simulate the drives of a sample of its own; None where the clutch cannot be simulated, or has no event.

    Args:
        model: the clutch and what of it scatters.
        given: its [tolerance] block.
        clutch: the nominal clutch, whose machine's torque is the load of all unless the spec gives one.

    Raises:
        CalculationError: hardly any sample is a clutch.
    """
    drive = clutch.spec.drive
    if not ANALYSES["simulate"].applies(clutch):
        return None
    load = float(clutch.machine_torque) if drive.load_torque is None else drive.load_torque
    own = replace(model, spec=with_value(model.spec, ("drive", "load_torque"), load))
    parts = [_drawn(own, given.seed, number) for number in range(REPLICATES)]
    sizes = [part[0].size for part in parts]
    if min(sizes) < 2:
        raise CalculationError(say("tolerance: hardly a sample is a clutch: there is no peak torque to tell"))
    peaks = _peaks(own, [np.concatenate(each) for each in zip(*parts, strict=True)])
    pieces = np.split(peaks, np.cumsum(sizes)[:-1])
    ranked = ranked_values(peaks)
    return PeakFigures(
        samples=peaks.size,
        mean=Estimate(float(peaks.mean()), spread([float(each.mean()) for each in pieces])),
        deviation=Estimate(float(peaks.std(ddof=1)), spread([float(each.std(ddof=1)) for each in pieces])),
        quantiles=[ranked.estimate(p) for p in given.quantiles],
        above=_above(own, peaks),
    )


def _drawn(model: Model, seed: int, number: int) -> list[Array]:
    """One replicate, from a stream apart from those of the torque and of its indices."""
    columns = [np.empty(SAMPLES // REPLICATES) for _ in model.inputs]
    Stream(model.inputs, seed, 2 * REPLICATES + number, quasi=False, model=model).fill(columns)
    if not model.may_fail:
        return columns
    possible = model.possible(columns)
    return [column[possible] for column in columns]


def _peaks(model: Model, values: list[Array]) -> Array:
    named = {each.path: value for each, value in zip(model.inputs, values, strict=True)}
    first, second = model.frictions(named)
    peaks: Array = np.broadcast_to(peaks_of(model.clutch(values), first, second).shaft, values[0].shape)
    return peaks


def _above(model: Model, peaks: Array) -> Estimate | None:
    required = model.spec.requirements
    limit = None if required is None else required.peak_torque
    if limit is None:
        return None
    share = float(np.mean(peaks > limit))
    return Estimate(share, max(1 / peaks.size, (share * (1 - share) / peaks.size) ** 0.5))
