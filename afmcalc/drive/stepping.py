"""Many drives at once: the same laws in fixed time steps, stick and slip by projection (Moreau–Jean).

Every step takes the velocities that the clutch would leave alone and asks which torque brings the slip to rest; what is
beyond the capacity slips. The shaft is stepped by the implicit midpoint rule: accuracy alone bounds the step.
"""

from collections.abc import Callable
from dataclasses import fields, is_dataclass, replace
from typing import Any, NamedTuple, TypeVar, cast

import numpy as np
from numpy.typing import NDArray

from ..arrays import Floats
from ..messages import say
from ..progress import tell
from .direct import DirectPack
from .lanes import DirectLanes, SleeveLanes
from .rest import Slipping, Stuck, settled, slips_below
from .sleeve import Sleeve
from .train import Train

_LANES = 8192
"""Drives stepped at a time: their states stay in the processor's cache."""


_LOOKED = 200
"""Steps after which it is seen again whether the peaks have passed."""
_STANDING = 1e-9
"""Speed of a tool that stands, relative to that before the event."""
_TOLD = 100
"""Steps after which it is told how far it is."""


class Marched(NamedTuple):
    """What many events did, an array each."""

    peak: Floats
    peak_clutch: Floats
    heat: Floats
    travel: Floats
    slip: Floats
    """Slip of the pack at the end, rad/s."""
    passed: NDArray[np.bool_]
    """Whether it was seen that no torque passes the peak any more."""


def march(
    train: Train,
    pack: DirectPack | Sleeve,
    step: Floats,
    steps: int,
    look: int | None = None,
) -> Marched:
    """Step events from start to ``steps`` times ``step``.

    Args:
        train: drives, numbers or arrays that broadcast to the shape of ``step``.
        pack: clutches, likewise.
        step: time step of each, s.
        steps: how many.
        look: steps from which on it is seen whether all peaks have passed, and the rest left out; None: never.

    Returns:
        Peaks, heat and travel, in the shape of ``step``.
    """
    parts: list[Marched] = []
    blocks, least = -(-step.size // _LANES), look or steps

    def behind(number: int) -> None:
        if number % _TOLD == 0:
            # up to the first look it may be that none needs more
            each = least if number < least else steps
            tell(say("stepping the drives"), len(parts) * each + number, blocks * each)

    for start in range(0, step.size, _LANES):
        lanes = slice(start, start + _LANES)
        own, h = _cut(train, lanes, step.shape), step.ravel()[lanes]
        shaft = Shaft(own, h)
        if isinstance(pack, DirectPack):
            clutch: DirectLanes | SleeveLanes = DirectLanes(own, _cut(pack, lanes, step.shape), h, shaft.per_torque)
        else:
            clutch = SleeveLanes(own, _cut(pack, lanes, step.shape), h, shaft.per_torque)
        parts.append(_march(own, shaft, clutch, h, steps, behind, least))
    return Marched(*(np.concatenate(each).reshape(step.shape) for each in zip(*parts, strict=True)))


D = TypeVar("D")


def _cut(whole: D, lanes: slice, shape: tuple[int, ...]) -> D:
    """Take some lanes of every array, in a record of records too."""
    if isinstance(whole, np.ndarray):
        return cast(D, np.broadcast_to(whole, shape).reshape(-1)[lanes])
    if not is_dataclass(whole) or isinstance(whole, type):
        return whole
    cut: Any = replace(whole, **{own.name: _cut(getattr(whole, own.name), lanes, shape) for own in fields(whole)})
    return cast(D, cut)


def _march(
    train: Train,
    shaft: "Shaft",
    clutch: DirectLanes | SleeveLanes,
    h: Floats,
    steps: int,
    behind: Callable[[int], None],
    look: int,
) -> Marched:
    motor = earlier = shaft.driven
    each = h / train.motor_inertia
    peak, peak_clutch, heat = (np.zeros(h.size) for _ in range(3))
    off = np.full(h.size, np.inf)
    passed = over = np.zeros(h.size, bool)
    # friction that rises as a slip slows down may still raise the torque: such a drive is over only with all others
    steady = np.asarray(clutch.pack.static_ratio) == 1
    for number in range(steps):
        behind(number)
        # the torque at the speed in the middle of the step, as the last step foretells it
        driving = train.engine.at(1.5 * motor - 0.5 * earlier)
        if train.cut_off is not None:
            driving = driving * np.clip(off / h - number, 0.0, 1.0)
        free = shaft.free(number, clutch.passed)
        before, earlier, motor = clutch.slip, motor, motor + each * driving
        clutch.step(free, motor, shaft.driven)
        motor = motor - each * clutch.torque
        shaft.take(free + shaft.per_torque * clutch.passed)
        np.maximum(peak, np.abs(shaft.torque), out=peak, where=~over)
        np.maximum(peak_clutch, clutch.top, out=peak_clutch, where=~over)
        heat += clutch.torque * (before + clutch.slip)
        if train.cut_off is not None:
            off = np.where((clutch.slip != 0) & np.isinf(off), number * h + train.cut_off, off)
        if number + 1 >= look and (number + 1 - look) % _LOOKED == 0:
            passed = over | _passed(train, shaft, clutch, motor, (number + 1) * h, off, peak)
            over = passed & steady
            if passed.all():
                break
    return Marched(peak, peak_clutch, h / 2 * heat, clutch.travel, clutch.slip, passed)


def _passed(
    train: Train,
    shaft: "Shaft",
    clutch: DirectLanes | SleeveLanes,
    motor: Floats,
    time: Floats,
    off: Floats,
    peak: Floats,
) -> NDArray[np.bool_]:
    """Whether no torque passes the peak any more."""
    standing = np.abs(shaft.tool) <= _STANDING * train.speed
    powered, pending = time < off, (time < off) & np.isfinite(off)
    stuck = Stuck(motor, shaft.tool, shaft.elastic, standing, powered, pending)
    sliding, breakaway = (clutch.pack.torque(ratio) for ratio in (1.0, clutch.pack.static_ratio))
    slipping = Slipping(clutch.torque, shaft.driven, sliding, breakaway)
    still = settled(train, stuck, clutch.sticks_up_to, peak)
    gone = slips_below(train, stuck, slipping, peak) & (clutch.slip > 0)
    over: NDArray[np.bool_] = (clutch.rate == 0) & (time > train.time) & np.where(clutch.slip == 0, still, gone)
    return over


class Shaft:
    """Driven half, shaft and tool of many drives: implicit midpoint."""

    def __init__(self, train: Train, h: Floats) -> None:
        """Begin under the load."""
        self.train, self.h = train, h
        self.driven, self.tool = (np.broadcast_to(train.speed, h.shape).astype(float) for _ in range(2))
        self.torque = self.elastic = np.broadcast_to(train.load, h.shape).astype(float)
        self._until = float(np.max(train.time / h)) + 1
        if train.kind == "stop":
            self.tool = self._led(0 * h)
        self._after, self._rate = self.tool, self.driven - self.tool
        # torque at the middle of the step: elastic torque + link·(u + u⁺), u the rate of twist
        self._coupling = h * (h * train.stiffness / 4 + train.damping / 2)
        self._stretch = h / 2 * train.stiffness
        own = train.driven_inertia + self._coupling
        self._kept, self._lost = (train.driven_inertia - self._coupling) / own, h / own
        self._drawn = self._coupling / own
        other = train.tool_inertia + self._coupling
        self._joint = own, other, own * other - self._coupling * self._coupling
        self.per_torque = self._lost if train.kind == "stop" else h * other / self._joint[2]
        """What a torque on the driven half adds to its speed in a step."""

    def _led(self, time: Floats) -> Floats:
        """Speed of a tool that is being stopped."""
        left = 1 - time / np.where(self.train.time > 0, self.train.time, 1.0)
        led: Floats = np.where(time < self.train.time, self.train.speed * left, 0.0)
        return led

    def free(self, number: int, passed: Floats) -> Floats:
        """Speed of the driven half without the clutch; moves the tool on, under the torque ``passed`` before."""
        if self.train.kind == "load":
            self._rate = self.driven - self.tool
            return self._loaded((number + 0.5) * self.h, passed)
        speed: Floats = self._kept * self.driven - self._lost * self.elastic
        if number < self._until:
            self._after = self._led((number + 1) * self.h)
            speed = speed + self._drawn * (self.tool + self._after)
        return speed

    def _loaded(self, middle: Floats, passed: Floats) -> Floats:
        """Tool with an inertia of its own, held by its load where that can hold it."""
        train, h, coupling = self.train, self.h, self._coupling
        impulse = h * self.elastic + coupling * self._rate
        own, other, det = self._joint
        first, second = train.driven_inertia * self.driven - impulse, train.tool_inertia * self.tool + impulse
        risen = np.where(train.time > 0, np.minimum(middle / np.where(train.time > 0, train.time, 1.0), 1.0), 1.0)
        load = train.load + (train.overload - train.load) * risen
        # what the clutch adds to the tool is that of its torque before: a part of the second order
        alone = coupling * (first + h * passed) + own * second
        held = np.clip(alone / (h * own), -load, load)
        self._after = (alone - own * h * held) / det
        left: Floats = (other * first + coupling * (second - h * held)) / det
        return left

    def take(self, driven: Floats) -> None:
        """Move on with the speed the driven half has come to."""
        rate = driven - self._after
        self.elastic = self.elastic + self._stretch * (self._rate + rate)
        self.driven, self.tool, self._rate = driven, self._after, rate
        self.torque = self.elastic + self.train.damping * rate
