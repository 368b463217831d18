"""Peaks of many drives at once: swept keys, samples of tolerances."""

from dataclasses import is_dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..engines import Clutch
from ..equations.arrays import Floats, Values
from ..errors import CalculationError
from .cases import swings_time, whole_time
from .lanes import Marched, march
from .pack import DirectPack, Sleeve, pack_of
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
    """Return the peaks of an event at f_1 and f_2 (twice f with one material); shapes broadcast.

    Raises:
        SpecError: no event.
        CalculationError: drives so unlike that one needs too many steps.
    """
    train, pack, sliding, duration, longest = _drives(clutch, driving, driven)
    steps = _steps_to(swings_time(train) if duration is None else duration, longest)
    if duration is None:
        most = min(int(np.ceil(np.max(whole_time(train, sliding) / longest))), _MOST_STEPS)
        found = march(train, pack, longest, most, steps)
    else:
        found = march(train, pack, np.broadcast_to(duration / steps, longest.shape), steps)
    passed = found.passed if duration is None else np.ones(longest.shape, bool)
    return Peaks(np.broadcast_to(sliding, longest.shape), found.peak, found.peak_clutch, passed)


def slips_of(clutch: Clutch, driving: Values, driven: Values, *, whole: bool) -> Marched:
    """Return peaks and heat as far as the first swings, or ``whole`` slips, have them: they only grow from there.

    In steps three times as coarse as those of ``peaks_of``, whose arguments and errors these are.
    """
    train, pack, sliding, duration, longest = _drives(clutch, driving, driven, STEPS_A_SWING // 3)
    first = swings_time(train)
    steps = most = _steps_to(first if duration is None else np.minimum(first, duration), longest)
    if whole:
        end = whole_time(train, sliding) if duration is None else duration
        most = min(max(int(np.max(end / longest)), steps), _MOST_STEPS)
    return march(train, pack, longest, most, steps, whole=True)


def _drives(
    clutch: Clutch, driving: Values, driven: Values, steps_a_swing: int = STEPS_A_SWING
) -> tuple[Train, DirectPack | Sleeve, Values, Values | None, Floats]:
    """Drives, packs, their sliding torque, the duration given, and the longest time step of each."""
    train, pack = train_of(clutch), pack_of(clutch, driving, driven)
    if isinstance(pack, DirectPack) and np.any(train.hub_inertia):
        train = train.without_hub
    duration = None if clutch.spec.drive.event is None else clutch.spec.drive.event.duration
    shape = np.broadcast_shapes((1,), *_shapes(train), *_shapes(pack), np.shape(0.0 if duration is None else duration))
    longest = np.broadcast_to(step_of(train, pack, steps_a_swing), shape).astype(float)
    return train, pack, pack.torque(1.0), duration, longest


def _steps_to(end: Values, longest: Floats) -> int:
    """How many steps the longest of some events take."""
    steps = int(np.ceil(np.max(end / longest)))
    if steps > _MOST_STEPS:
        raise CalculationError(
            "simulate: {steps} time steps are needed, at most {most} are made: the drive's parts swing too unlike "
            "(control unit and hub against the shaft)",
            steps=steps,
            most=_MOST_STEPS,
        )
    return steps


def step_of(train: Train, pack: DirectPack | Sleeve, steps_a_swing: int = STEPS_A_SWING) -> Values:
    """Return the longest time step that keeps peak and heat to 0.2 %, s, with so many in a swing of the driven half."""
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
    own = vars(record).values() if is_dataclass(record) else ()  # beside fields what was calculated from them
    return [np.shape(value) for value in own if isinstance(value, np.ndarray)] + [
        shape for value in own for shape in _shapes(value)
    ]
