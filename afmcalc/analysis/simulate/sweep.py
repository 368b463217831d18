"""Peaks of many drives at once: swept keys, samples of tolerances."""

from collections.abc import Callable, Sequence
from dataclasses import fields, is_dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...arrays import Floats, Values
from ...engines.protocol import Clutch
from ...errors import CalculationError
from ...findings import Finding, finding
from ...messages import say
from ...spec.models import Range
from ..sweep.grid import Axis, series
from .bypass import bypass_alone
from .cases import swings_time, whole_time
from .direct import DirectPack
from .packs import pack_of, without_hub
from .result import SimulateSweep
from .sleeve import Sleeve
from .stepping import march
from .train import Train, train_of

STEPS_A_SWING = 200
"""Steps in a swing of the driven half on its shaft: they miss a peak by 0.01 % of the swing, and 0.06 % at most in
2000 random drives, of which 5 miss 0.2 % of the heat."""
_BALLS = 40
"""Steps in a swing of the balls on their springs."""
_FINEST = 4
"""Times that their swing may shorten a step: springs that the key all but locks are stiff, and still."""
_YIELDING = 1e-3
"""Stiffness of a control unit, of the shaft's, below which it is no spring: its wall holds the torque."""
_MOST_STEPS = 100_000


class Peaks(NamedTuple):
    """What an event does to many clutches, until its peak has passed."""

    sliding: Floats
    shaft: Floats
    clutch: Floats
    passed: NDArray[np.bool_]
    """Whether it was seen that no torque passes the peak any more, or has come to the duration given."""


def peaks_of(clutch: Clutch, driving: Values, driven: Values) -> Peaks:
    """Return the peaks of an event.

    Args:
        clutch: a clutch whose parameters are numbers or arrays.
        driving: f of all pairs or f_1; shapes broadcast.
        driven: f_2, likewise.

    Raises:
        SpecError: no event.
        CalculationError: drives so unlike that one needs too many steps.
    """
    train, pack = train_of(clutch), pack_of(clutch, driving, driven)
    if isinstance(pack, DirectPack) and np.any(train.hub_inertia):
        train = without_hub(train)
    sliding = pack.torque(1.0)
    duration = None if clutch.spec.drive.event is None else clutch.spec.drive.event.duration
    shape = np.broadcast_shapes((1,), *_shapes(train), *_shapes(pack), np.shape(0.0 if duration is None else duration))
    longest = np.broadcast_to(step_of(train, pack), shape).astype(float)
    steps = int(np.ceil(np.max((swings_time(train) if duration is None else duration) / longest)))
    if steps > _MOST_STEPS:
        raise CalculationError(
            say(
                "simulate: {steps} time steps are needed, at most {most} are made: the drive's parts swing too unlike "
                "(control unit and hub against the shaft)",
                steps=steps,
                most=_MOST_STEPS,
            )
        )
    if duration is None:
        most = min(int(np.ceil(np.max(whole_time(train, sliding) / longest))), _MOST_STEPS)
        found = march(train, pack, longest, most, steps)
    else:
        found = march(train, pack, np.broadcast_to(duration / steps, shape), steps)
    passed = found.passed if duration is None else np.ones(shape, bool)
    return Peaks(np.broadcast_to(sliding, shape), found.peak, found.peak_clutch, passed)


def step_of(train: Train, pack: DirectPack | Sleeve, steps_a_swing: int = STEPS_A_SWING) -> Values:
    """Return the longest time step that keeps peak and heat to 0.2 %, s.

    Args:
        train: drives, numbers or arrays.
        pack: clutches, likewise.
        steps_a_swing: time steps in a free swing of the driven half.
    """
    fastest = (train.stiffness / train.driven_inertia) ** 0.5
    step: Values = 2 * np.pi / (fastest * steps_a_swing)
    if isinstance(pack, Sleeve):
        stiffness = pack.torsional(0.0, pack.net_gain, pack.lift)
        straight = np.maximum(stiffness, _YIELDING * train.stiffness)
        swinging = (straight * (1 / train.hub_inertia + 1 / train.driven_inertia)) ** 0.5
        step = np.clip(2 * np.pi / (swinging * _BALLS), step / _FINEST, step)
        # discs that stick and break loose while the balls swing: the peak comes closer by the first order alone
        step = np.where(np.asarray(pack.static_ratio) > 1, step / 2, step)
    return step


def _shapes(record: object) -> list[tuple[int, ...]]:
    """Shapes of the arrays in a record."""
    own = [getattr(record, each.name) for each in fields(record)] if is_dataclass(record) else []
    return [np.shape(value) for value in own if isinstance(value, np.ndarray)] + [
        shape for value in own for shape in _shapes(value)
    ]


def swept(clutch: Clutch, sweeps: Sequence[Axis]) -> tuple[list[SimulateSweep] | None, list[Finding]]:
    """Peaks over swept keys, None without any; and a remark where some may yet rise."""
    found = _Found()
    outputs: dict[str, Callable[[Clutch], Values]] = {
        "peak_torque_max": lambda own: found.of(own).shaft[2],
        "peak_torque_mean": lambda own: found.of(own).shaft[1],
        "peak_torque_min": lambda own: found.of(own).shaft[0],
        "peak_torque_clutch": lambda own: found.of(own).clutch[2],
        "dynamic_factor": lambda own: found.of(own).shaft[2] / found.of(own).sliding[2],
        "inertia_torque": lambda own: train_of(own).inertia_torque,
    }
    if clutch.bypass_pairs and clutch.spec.kind.controlled:
        outputs["peak_torque_bypass"] = bypass_peaks
    told = series(SimulateSweep, clutch, sweeps, outputs, open_at=("peak_torque_bypass",))
    path, count = "drive.cut_off", found.rising
    return told, [finding("sweep-not-settled", "warning", value=count, path=path)] if count else []


def dynamic_factors(clutch: Clutch) -> Floats:
    """Largest T_peak/T over f_min, mean friction and f_max, of every clutch of a sweep."""
    first, second = map(_rows, clutch.friction)
    found = peaks_of(clutch, first, second)
    slipping = np.max(found.shaft / found.sliding, axis=0)
    largest: Floats = np.fmax(slipping, bypass_peaks(clutch) / found.sliding[2])
    return largest


def bypass_peaks(clutch: Clutch) -> Floats:
    """Peaks in the shaft if the bypass pairs alone carry, as of ``bypass_peak``; NaN where they carry less, N·m."""
    first, second = (own.max for own in clutch.friction)
    sliding, breakaway = clutch.torque(first, second), clutch.breakaway_torque(first, second)
    more = np.atleast_1d(breakaway > sliding * (1 + 1e-9))
    if not more.any():
        return np.full(more.shape, np.nan)
    return np.where(more, peaks_of(bypass_alone(clutch), first, second).shaft, np.nan)


class _Found:
    """The peaks of the clutch that was asked last, each clutch calculated once."""

    def __init__(self) -> None:
        self._clutch: Clutch | None = None
        self._peaks: Peaks | None = None
        self.rising = 0
        """Drives whose peak may yet rise."""

    def of(self, clutch: Clutch) -> Peaks:
        """Peaks at f_min, mean friction and f_max, a row each."""
        if clutch is not self._clutch or self._peaks is None:
            first, second = (_rows(friction) for friction in clutch.friction)
            self._clutch, self._peaks = clutch, peaks_of(clutch, first, second)
            self.rising += int(np.count_nonzero(~self._peaks.passed))
        return self._peaks


def _rows(friction: Range) -> Floats:
    """The three frictions as rows, (3, 1) or (3, n)."""
    stacked: Floats = np.stack(np.broadcast_arrays(*friction))
    return stacked if stacked.ndim > 1 else stacked[:, np.newaxis]
