"""Whether anything can still come of a drive whose clutch sticks: the energy of its swings about where they end.

The swings of a stuck drive about its rest, or about the speed at which the motor balances the load, keep or lose energy
unless the motor feeds them: a bound of every torque that follows (Lyapunov). Numbers, or arrays in a sweep.
"""

from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..equations import drive as law
from ..equations.arrays import Floats, Values
from .train import Train

Flags: TypeAlias = NDArray[np.bool_]

_LOOKS = np.linspace(-1.0, 1.0, 17)
"""Places in a swing at which it is seen whether the motor feeds it."""
_SEEN = 1e-5
"""By how much of it a peak may yet be passed."""
_STEPPED = 3e-4
"""The same of a peak that is stepped."""
_AT_LIMIT = 1e-6
"""By how much of it a limit may be passed: as a slip ends the torque swings back to what slipped."""


class Stuck(NamedTuple):
    """A drive whose clutch sticks, its event over."""

    motor: Values
    """Speed of what turns before the shaft, rad/s."""
    tool: Values
    elastic: Values
    """Torque of the shaft's twist, N·m."""
    standing: Flags | bool
    """Whether the tool stands."""
    powered: Flags | bool
    """Whether the motor is on."""
    pending: Flags | bool
    """Whether it will be switched off."""


def settled(train: Train, stuck: Stuck, limit: Values, peak: Values) -> Flags:
    """Whether the clutch, which sticks up to ``limit``, does so for ever, and no shaft torque passes the ``peak``."""
    with np.errstate(all="ignore"):
        still, moving = _standing(train, stuck), _moving(train, stuck)
        motor, shaft = (np.where(stuck.standing, first, last) for first, last in zip(still, moving, strict=True))
        behind = train.hub_inertia + train.driven_inertia
        clutch = law.sticking_torque(motor, train.motor_inertia, shaft, behind)
        found: Flags = (clutch <= limit * (1 + _AT_LIMIT)) & (shaft <= peak * (1 + _SEEN))
    return found


class Slipping(NamedTuple):
    """Drives of which some slip."""

    torque: Values
    """Of the clutch, N·m."""
    speed: Values
    """Of the driven half, rad/s."""
    sliding: Values
    """T(f), N·m."""
    breakaway: Values
    """T(r_s f), N·m."""


def slips_below(train: Train, stuck: Stuck, slipping: Slipping, peak: Values) -> Flags:
    """Whether no torque of the shaft passes the peak while the clutch slips on forwards, nor after it."""
    behind, front = train.hub_inertia + train.driven_inertia, train.front
    swing = np.hypot(stuck.elastic - slipping.torque, slipping.speed * (train.stiffness * behind) ** 0.5)
    top = np.maximum(np.abs(slipping.torque) + _top(train, behind, swing), slipping.breakaway)
    # as the slip ends the stalled motor may swing the shaft up, until it slips again
    rest = np.where(stuck.powered, train.engine.at(0.0 * stuck.motor), 0.0)
    beyond = np.where(rest < slipping.sliding, np.maximum(slipping.breakaway - rest, 0.0), 0.0)
    grows = np.asarray(stuck.powered) & fed(train, beyond / (train.stiffness * front) ** 0.5)
    again = np.where(grows, slipping.breakaway + beyond * (behind / front) ** 0.5, 0.0)
    return np.asarray(stuck.standing) & (np.maximum(top, again) <= peak * (1 + _STEPPED))


def fed(train: Train, speed: Values) -> Flags:
    """Whether a motor about its standstill gives a swing of that speed more than the shaft takes from it."""
    if train.engine.slip is None:
        return np.zeros(np.shape(speed), bool)
    at = np.multiply.outer(_LOOKS, speed)
    given = (train.engine.at(at) - train.engine.at(0.0 * at)) * at
    return np.any(given > train.damping * at * at * (1 + 1e-9), axis=0)


def _top(train: Train, inertia: Values, swing: Values) -> Floats:
    """Largest torque of a shaft that swings by ``swing``, its damping with it."""
    return swing * (1 + train.damping / (train.stiffness * inertia) ** 0.5)


def _standing(train: Train, stuck: Stuck) -> tuple[Values, Values]:
    """Torques of motor and shaft at most, on a standing tool; a switched off motor leaves no more."""
    front = train.front
    rest = np.where(stuck.powered, train.engine.at(0.0 * stuck.motor), 0.0)
    swing = np.hypot(stuck.elastic - rest, stuck.motor * (train.stiffness * front) ** 0.5)
    speed = swing / (train.stiffness * front) ** 0.5
    top = np.abs(rest) + _top(train, front, swing)
    torn = np.asarray(stuck.powered) & fed(train, speed)
    if train.kind == "load":
        torn = torn | (top > train.overload)
    return np.abs(rest) + train.damping * speed, np.where(torn, np.inf, top)


def _moving(train: Train, stuck: Stuck) -> tuple[Values, Values]:
    """Torques of motor and shaft at most, of a tool that keeps turning against its load."""
    if train.kind == "stop":
        return np.inf, np.inf
    front, tool, load = train.front, train.tool_inertia, train.overload
    if train.engine.slip is None:
        given = np.where(stuck.powered, train.engine.torque, 0.0)
        rest, inertia = law.sticking_torque(given, front, load, tool), front * tool / (front + tool)
        swing = np.hypot(stuck.elastic - rest, (stuck.motor - stuck.tool) * (train.stiffness * inertia) ** 0.5)
        slowest = (front * stuck.motor + tool * stuck.tool) / (front + tool) - swing / (train.stiffness * tool) ** 0.5
        goes_on = np.asarray(given >= load)
    else:
        # about the speed at which the motor balances the load, between that and standstill it must not break down
        inertia, given = front * tool / (front + tool), np.asarray(load, float)
        # a load beyond the breakdown torque has none: NaN
        slip = law.kloss_slip(np.asarray(train.engine.torque, float), train.engine.slip, load)
        speed = train.engine.synchronous * (1 - slip)
        broken = train.engine.synchronous * (1 - train.engine.slip**2 / slip)
        off, behind = stuck.motor - speed, stuck.tool - speed
        energy = front * off * off + tool * behind * behind
        swing = np.hypot(stuck.elastic - load, (train.stiffness * energy) ** 0.5)
        slowest, rest = speed - swing / (train.stiffness * tool) ** 0.5, given
        goes_on = np.asarray(stuck.powered) & (speed - swing / (train.stiffness * front) ** 0.5 > broken)
    lasts = goes_on & (slowest > 0) & ~np.asarray(stuck.pending)
    return given, np.where(lasts, np.abs(rest) + _top(train, inertia, swing), np.inf)
