"""Energy bounds of a drive after its event: can a stuck clutch still slip, can any torque still exceed the peak?

The swings of a stuck drive about its rest, or about the speed at which the motor balances the load, keep or lose energy
unless the motor feeds them (Lyapunov). Numbers or arrays.
"""

from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..equations import drive as law
from ..equations.arrays import Floats, Values
from .motion import Motion
from .train import Train

Flags: TypeAlias = NDArray[np.bool_]

_LOOKS = np.linspace(-1.0, 1.0, 17)
"""Places in a swing at which it is seen whether the motor feeds it."""
CLOSE = 3e-4
"""Share by which a torque may yet exceed the peak: steps miss as much of it."""
_AT_LIMIT = 1e-6
"""Share by which a limit may be exceeded: as a slip ends the torque swings back to what slipped."""
_STANDING = 1e-9
"""Speed, relative to that before the event, below which the tool counts as standing."""


def settled(motion: Motion, powered: Any, pending: Any, peak: Values) -> Flags:
    """Where a clutch that sticks does so for ever, and no shaft torque exceeds the peak any more.

    ``powered``: the motor is on; ``pending``: it will be switched off.
    """
    train, pack = motion.train, motion.pack
    standing = np.abs(motion.tool) <= _STANDING * train.speed
    with np.errstate(all="ignore"):
        still, moving = _standing(motion, powered), _moving(motion, powered, pending)
        motor, shaft = (np.where(standing, first, last) for first, last in zip(still, moving, strict=True))
        behind = train.hub_inertia + train.driven_inertia
        passed = np.where(motion.rate == 0, shaft, np.maximum(shaft, pack.lift)) if pack.travels else shaft
        clutch = law.sticking_torque(motor, train.motor_inertia, passed, behind)
        limit = pack.sticks_up_to(motion.turn, motion.normal)
        found: Flags = (clutch <= limit * (1 + _AT_LIMIT)) & (shaft <= peak * (1 + CLOSE))
    found &= np.asarray((motion.slip == 0) & (motion.time > train.time))
    return found


def slips_below(motion: Motion, powered: Any, peak: Values) -> Flags:
    """Where no torque of the shaft exceeds the peak while the clutch slips on forwards, nor after it."""
    train, pack = motion.train, motion.pack
    sliding, breakaway = pack.sliding, pack.breakaway
    behind, front = train.hub_inertia + train.driven_inertia, train.front
    impedance = (train.stiffness * behind) ** 0.5
    swing = np.hypot(motion.elastic - motion.clutch, motion.driven * impedance)
    top = np.maximum(np.abs(motion.clutch) + _top(train, behind, swing), breakaway)
    # as the slip ends the stalled motor may swing the shaft up, until it slips again
    rest = np.where(powered, train.engine.at(0.0 * motion.motor), 0.0)
    beyond = np.where(rest < sliding, np.maximum(breakaway - rest, 0.0), 0.0)
    grows = np.asarray(powered) & _fed(train, beyond / (train.stiffness * front) ** 0.5)
    again = np.where(grows, breakaway + beyond * (behind / front) ** 0.5, 0.0)
    if pack.travels:
        # in the end the springs give back their energy
        again = np.maximum(again, np.hypot(motion.clutch, (2 * train.stiffness * pack.work(motion.travel)) ** 0.5))
    # friction that falls with the slip feeds the swing of a slow slip: up to one as fast as that slip is
    slow = pack.juddering_slip(train.damping)
    fed = np.hypot(breakaway - sliding, np.where(slow > 0, slow * impedance + swing, 0.0))
    again = np.maximum(again, sliding + _top(train, behind, fed))
    standing = np.abs(motion.tool) <= _STANDING * train.speed
    goes_on = (motion.slip > slow + swing / impedance * (slow > 0)) & (motion.rate == 0) & (motion.time > train.time)
    found: Flags = standing & goes_on & (np.maximum(top, again) <= peak * (1 + CLOSE))
    return found


def _fed(train: Train, speed: Values) -> Flags:
    """Where a motor about its standstill gives a swing of that speed more than the shaft takes from it."""
    if train.engine.slip is None:
        return np.zeros(np.shape(speed), bool)
    at = np.multiply.outer(_LOOKS, speed)
    gain = (train.engine.at(at) - train.engine.at(0.0 * at)) * at
    feeds: Flags = np.any(gain > train.damping * at * at * (1 + 1e-9), axis=0)
    return feeds


def _top(train: Train, inertia: Values, swing: Values) -> Floats:
    """Largest torque of a shaft that swings by ``swing``, its damping with it."""
    return swing * (1 + train.damping / (train.stiffness * inertia) ** 0.5)


def _standing(motion: Motion, powered: Any) -> tuple[Values, Values]:
    """Torques of motor and shaft at most, on a standing tool; a motor that is switched off leaves no more."""
    train, pack, front, hub = motion.train, motion.pack, motion.train.front, motion.driven + motion.rate
    rest = np.where(powered, train.engine.at(0.0 * motion.motor), 0.0)
    energy = (
        train.motor_inertia * motion.motor**2 + train.hub_inertia * hub**2 + train.driven_inertia * motion.driven**2
    )
    swing = np.hypot(motion.elastic - rest, (train.stiffness * energy) ** 0.5)
    if pack.travels:
        # the springs give their energy, too, unless the key holds the sleeve in every swing
        holds = (motion.rate == 0) & ((motion.turn == 0) | (rest - swing >= pack.key_limits(motion.travel)[0]))
        swing = np.where(holds, swing, np.hypot(swing, (2 * train.stiffness * pack.work(motion.travel)) ** 0.5))
    speed = swing / (train.stiffness * front) ** 0.5
    top = np.abs(rest) + _top(train, front, swing)
    torn = np.asarray(powered) & _fed(train, speed)
    if train.kind == "load":
        torn = torn | (top > train.overload)
    return np.abs(rest) + train.damping * speed, np.where(torn, np.inf, top)


def _moving(motion: Motion, powered: Any, pending: Any) -> tuple[Values, Values]:
    """Torques of motor and shaft at most, of a tool that keeps turning against its load."""
    train = motion.train
    if train.kind == "stop":
        return np.inf, np.inf
    front, tool, load, stiffness = train.front, train.tool_inertia, train.overload, train.stiffness
    inertia = front * tool / (front + tool)
    if train.engine.slip is None:
        motor = np.where(powered, train.engine.torque, 0.0)
        rest = law.sticking_torque(motor, front, load, tool)
        swing = np.hypot(motion.elastic - rest, (motion.motor - motion.tool) * (stiffness * inertia) ** 0.5)
        mean = (front * motion.motor + tool * motion.tool) / (front + tool)
        slowest, goes_on = mean - swing / (stiffness * tool) ** 0.5, np.asarray(motor >= load)
    else:
        # about the speed at which the motor balances the load, between that and standstill it must not break down
        motor = rest = np.asarray(load, float)
        # a load beyond the breakdown torque has none: NaN
        slip = law.kloss_slip(np.asarray(train.engine.torque, float), train.engine.slip, load)
        speed = train.engine.synchronous * (1 - slip)
        broken = train.engine.synchronous * (1 - train.engine.slip**2 / slip)
        energy = front * (motion.motor - speed) ** 2 + tool * (motion.tool - speed) ** 2
        swing = np.hypot(motion.elastic - load, (stiffness * energy) ** 0.5)
        slowest = speed - swing / (stiffness * tool) ** 0.5
        goes_on = np.asarray(powered) & (speed - swing / (stiffness * front) ** 0.5 > broken)
    lasts = goes_on & (slowest > 0) & ~np.asarray(pending) & (np.asarray(motion.rate) == 0)
    return motor, np.where(lasts, np.abs(rest) + _top(train, inertia, swing), np.inf)
