"""Energy bounds of a drive after its event: can a stuck clutch still slip, can any torque still exceed the peak?

A stuck drive swings about its rest, or about the speed at which the motor balances the load; these swings keep or lose
energy unless the motor feeds them (Lyapunov). The functions take numbers or arrays.
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
"""Speeds in a swing, relative to its amplitude, at which the power of the motor is compared with the damping."""
CLOSE = 3e-4
"""Relative excess over the peak that a later torque may have: the time steps miss as much of the peak."""
_AT_LIMIT = 1e-6
"""Relative excess over the sticking limit that is allowed: after a slip the torque swings back up to this limit."""
_STANDING = 1e-9
"""Speed, relative to the speed before the event, below which the tool counts as standing."""


def settled(motion: Motion, powered: Any, pending: Any, peak: Values) -> Flags:
    """Flags: the clutch sticks for ever, and the shaft torque never exceeds the peak again.

    ``powered``: the motor is on; ``pending``: the motor will be switched off.
    """
    train, pack = motion.train, motion.pack
    standing = np.abs(motion.tool) <= _STANDING * train.speed
    with np.errstate(all="ignore"):
        limit = pack.sticks_up_to(motion.turn, motion.normal)
        still, moving = _standing(motion, powered), _moving(motion, powered, pending)
        motor, shaft = (np.where(standing, first, last) for first, last in zip(still, moving, strict=True))
        behind = train.hub_inertia + train.driven_inertia
        passed = np.where(motion.rate == 0, shaft, np.maximum(shaft, pack.lift)) if pack.travels else shaft
        clutch = law.sticking_torque(motor, train.motor_inertia, passed, behind)
        below = (clutch <= limit * (1 + _AT_LIMIT)) & (shaft <= peak * (1 + CLOSE))
    return np.asarray(below & (motion.slip == 0) & (motion.time > train.time))


def slips_below(motion: Motion, powered: Any, peak: Values) -> Flags:
    """Flags: the shaft torque never exceeds the peak again, neither in the present forward slip nor after it."""
    train, pack = motion.train, motion.pack
    sliding, breakaway = pack.sliding, pack.breakaway
    behind, front = train.hub_inertia + train.driven_inertia, train.front
    impedance = (train.stiffness * behind) ** 0.5
    swing = np.hypot(motion.elastic - motion.clutch, motion.driven * impedance)
    top = np.maximum(np.abs(motion.clutch) + _top(train, behind, swing), breakaway)
    # after the slip the stalled motor may make the shaft swing more and more, until the clutch slips again
    rest = np.where(powered, train.engine.at(0.0 * motion.motor), 0.0)
    beyond = np.where(rest < sliding, np.maximum(breakaway - rest, 0.0), 0.0)
    grows = np.asarray(powered) & _fed(train, beyond / (train.stiffness * front) ** 0.5)
    again = np.where(grows, breakaway + beyond * (behind / front) ** 0.5, 0.0)
    if pack.travels:
        # after the slip the springs return their energy, and the shaft has up to κ₊/κ times the torque of the balls
        given = np.hypot(motion.clutch, (2 * train.stiffness * pack.work(pack.travel(motion.turn))) ** 0.5)
        passed = np.maximum(np.abs(motion.clutch), breakaway) * (pack.net_gain_returning / pack.net_gain)
        again = np.maximum(again, np.minimum(given, passed))
    # friction that falls with the slip speed feeds the swing in a slow slip, until the swing is as fast as the slip
    slow = pack.juddering_slip(train.damping)
    fed = np.hypot(breakaway - sliding, np.where(slow > 0, slow * impedance + swing, 0.0))
    again = np.maximum(again, sliding + _top(train, behind, fed))
    standing = np.abs(motion.tool) <= _STANDING * train.speed
    goes_on = (motion.slip > slow + swing / impedance * (slow > 0)) & (motion.rate == 0) & (motion.time > train.time)
    return np.asarray(standing & goes_on & (np.maximum(top, again) <= peak * (1 + CLOSE)))


def _fed(train: Train, speed: Values) -> Flags:
    """Flags: near standstill a swing of amplitude ``speed`` gets more energy from the motor than damping takes."""
    if train.engine.slip is None:
        return np.zeros(np.shape(speed), bool)
    at = np.multiply.outer(_LOOKS, speed)
    gain = (train.engine.at(at) - train.engine.at(0.0 * at)) * at
    return np.asarray(np.any(gain > train.damping * at * at * (1 + 1e-9), axis=0))


def _top(train: Train, inertia: Values, swing: Values) -> Floats:
    """Largest excess over the rest torque of a shaft that swings by the torque ``swing``, damping included, N·m."""
    return swing * (1 + train.damping / (train.stiffness * inertia) ** 0.5)


def _standing(motion: Motion, powered: Any) -> tuple[Values, Values]:
    """Upper bounds of motor and shaft torque while the tool stands, even after the motor is off; inf: no bound."""
    train, pack, front = motion.train, motion.pack, motion.train.front
    rest = np.where(powered, train.engine.at(0.0 * motion.motor), 0.0)
    energy = (train.motor_inertia + train.hub_inertia) * motion.motor**2 + train.driven_inertia * motion.driven**2
    swing = np.hypot(motion.elastic - rest, (train.stiffness * energy) ** 0.5)
    if pack.travels:
        # the springs give their energy, too, unless the feather key holds the sleeve throughout every swing
        travel = pack.travel(motion.turn)
        returning = pack.moment(travel) / pack.steeper(pack.net_gain_returning, travel)
        holds = (motion.rate == 0) & ((motion.turn == 0) | (rest - swing >= returning))
        swing = np.where(holds, swing, np.hypot(swing, (2 * train.stiffness * pack.work(travel)) ** 0.5))
    speed = swing / (train.stiffness * front) ** 0.5
    motor, top = np.abs(rest) + train.damping * speed, np.abs(rest) + _top(train, front, swing)
    torn = np.asarray(powered) & _fed(train, speed)
    if train.kind == "load":
        torn = torn | (top > train.overload)
    return motor, np.where(torn, np.inf, top)


def _moving(motion: Motion, powered: Any, pending: Any) -> tuple[Values, Values]:
    """Upper bounds of motor and shaft torque while the tool keeps turning against its load; inf: no bound."""
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
        # a swing about the speed at which motor and load balance must not reach the breakdown slip
        motor = rest = np.asarray(load, float)
        # NaN for a load beyond the breakdown torque
        slip = law.kloss_slip(np.asarray(train.engine.torque, float), train.engine.slip, load)
        speed = train.engine.synchronous * (1 - slip)
        broken = train.engine.synchronous * (1 - train.engine.slip**2 / slip)
        energy = front * (motion.motor - speed) ** 2 + tool * (motion.tool - speed) ** 2
        swing = np.hypot(motion.elastic - load, (stiffness * energy) ** 0.5)
        slowest = speed - swing / (stiffness * tool) ** 0.5
        goes_on = np.asarray(powered) & (speed - swing / (stiffness * front) ** 0.5 > broken)
    lasts = goes_on & (slowest > 0) & ~np.asarray(pending) & (np.asarray(motion.rate) == 0)
    return motor, np.where(lasts, np.abs(rest) + _top(train, inertia, swing), np.inf)
