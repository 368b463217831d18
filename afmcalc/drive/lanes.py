"""Many drives at once: the same law in fixed time steps, stick and slip by projection (Moreau–Jean).

Every step first calculates the speeds without the torque of the clutch, then the torque that brings the slip to rest.
Where this torque exceeds the capacity, the clutch slips. The shaft is stepped by the implicit midpoint rule, so that
the step is limited by accuracy, not by stability.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import fields, is_dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..engines.quantities import Quantities
from ..equations import direct
from ..equations.arrays import Floats, Values
from ..messages import say
from ..progress import tell
from .pack import DirectPack, Sleeve
from .rest import Slipping, Stuck, settled, slips_below
from .train import Train

_LANES = 8192
"""Drives stepped at a time; the states of so many stay in the processor's cache."""
_LOOKED = 200
"""Steps between two checks whether the peaks have passed."""
_STANDING = 1e-9
"""Speed, relative to that before the event, below which the tool counts as standing."""
_REPORT = 100
"""Steps between two reports of progress."""
_SWING_OVER = 0.01
"""Duration of a swing of the balls between their walls, in steps, below which the balls count as at rest."""


class _Lanes(ABC):
    """Clutches of many drives: what they do, and what in one more step."""

    def __init__(self, train: Train, pack: DirectPack | Sleeve, h: Floats) -> None:
        """Begin stuck, in the state after the torque has risen to the load."""
        self.pack, self.h = pack, h
        self._static = bool(np.any(np.asarray(pack.static_ratio) != 1))
        self.slip, self.rate, self.travel, self.top, self._trend = (np.zeros(h.size) for _ in range(5))
        self.torque = np.broadcast_to(train.load, h.shape).astype(float)
        self.balls = self.torque.copy()
        """Torque on the driven half: that of the balls, or of the pack of a direct clutch."""
        self.turn = np.broadcast_to(pack.turn_under(train.load), h.shape).astype(float)
        self.normal = np.broadcast_to(pack.pressed_at_stop(train.load, pack.stop_gains[0]), h.shape).astype(float)

    @abstractmethod
    def solver(self, free: Floats, motor: Floats, driven: Floats) -> "Callable[[Values], _StepResult]":
        """Friction at the slip over sliding friction → a step, from the speeds of both halves without the torques."""

    def step(self, free: Floats, motor: Floats, driven: Floats) -> "_StepResult":
        """Make a step from the speeds that both halves have without the torques of the clutch."""
        solve, slip, self.top = self.solver(free, motor, driven), self.slip + self._trend, np.zeros(self.slip.shape)
        for _ in range(2 if self._static else 1):
            # friction is that at the slip in the middle of the step: first of a predicted slip, then of the result
            result = solve(self.pack.ratio((self.slip + slip) / 2) if self._static else 1.0)
            self.top, slip = np.maximum(self.top, np.abs(result.clutch)), result.slip
        self._trend = np.where(slip == 0, 0.0, slip - self.slip) if self._static else self._trend
        self.torque, self.balls, self.slip, self.rate, normal = result
        self.normal = np.asarray(normal)
        return result


class DirectLanes(_Lanes):
    """Packs of direct clutches."""

    pack: DirectPack

    def __init__(self, train: Train, pack: DirectPack, h: Floats, per_torque: Floats) -> None:
        """Begin stuck under the load; ``per_torque``: speed that 1 N·m adds to the driven half in a step."""
        super().__init__(train, pack, h)
        self._each = h / train.motor_inertia + per_torque
        lag = np.broadcast_to(np.asarray(pack.lag, float), h.shape)
        self._half = np.exp(-h / (2 * np.where(lag > 0, lag, np.inf))) * (lag > 0) if np.any(lag > 0) else None
        """Factor by which a deviation of the normal force decays in half a step; None without lag."""

    def solver(self, free: Floats, motor: Floats, driven: Floats) -> "Callable[[Values], _StepResult]":
        """The torque that brings the slip to rest, or the capacity."""
        needed = (motor - free) / self._each

        def solve(ratio: Values) -> _StepResult:
            capacity, normal = self._capacity(ratio), self.normal
            torque = np.maximum(np.minimum(needed, capacity), -capacity)
            if self._half is not None:
                balance = self.pack.pressed_at_stop(torque, self.pack.stop_gains[0])
                normal = balance + (normal - balance) * self._half**2
            # the slip is exactly 0 where it sticks
            return _StepResult(torque, torque, self._each * (needed - torque), self.rate, normal)

        return solve

    def _capacity(self, ratio: Values) -> Values:
        """Largest torque of the pack; with lag at the normal force that this torque gives in the middle of the step."""
        pack = self.pack
        if self._half is None:
            return pack.torque(ratio)
        loop = pack.gain * pack.controlled_pairs * pack.driven * (1 - self._half)
        alone: Values = pack.closing_force * (1 - self._half) + self.normal * self._half
        middle: Values = direct.normal_force(alone, 1.0, loop, ratio)
        return pack.carried(middle, ratio)


class SleeveLanes(_Lanes):
    """Packs, hubs and balls of indirect clutches."""

    pack: Sleeve

    def __init__(self, train: Train, pack: Sleeve, h: Floats, per_torque: Floats) -> None:
        """Begin stuck, with a load beyond T_н off the stop; ``per_torque`` as of ``DirectLanes``."""
        super().__init__(train, pack, h)
        self._mass_at_stop: Values = pack.inertia(0.0, pack.net_gain) / h
        self._mass_back: Values = pack.inertia(0.0, pack.net_gain_returning) / h
        self._share = pack.net_gain / pack.net_gain_returning
        self._across = h / train.hub_inertia
        """Speed that a torque of 1 N·m adds to the hub in a step."""
        self._pack, self._balls = h / train.motor_inertia + self._across, self._across + per_torque
        self._gained, self._turned, self.travel = self.slip, self.turn, pack.travel(self.turn)

    def solver(self, free: Floats, motor: Floats, driven: Floats) -> "Callable[[Values], _StepResult]":
        """The torques of pack and balls that bring their slips to rest, or what they can carry."""
        hub = driven + self.rate
        joint = _Joint(motor - hub, hub - free, self._pack, self._across, self._balls)

        def solve(ratio: Values) -> _StepResult:
            result, self._turned = self._stepped(joint, ratio)
            return result

        return solve

    def step(self, free: Floats, motor: Floats, driven: Floats) -> "_StepResult":
        """As of every clutch; the sleeve follows the balls."""
        before = self.rate
        result = super().step(free, motor, driven)
        self._gained, self.turn = result.rate - before, self._turned
        self.travel = np.maximum(self.travel, self.pack.travel(self.turn))
        return result

    def _stepped(self, joint: "_Joint", ratio: Values) -> "tuple[_StepResult, Floats]":
        """Torques and speeds after a step, and the turn of the balls."""
        pack, h = self.pack, self.h
        at_stop = self.turn == 0
        moving = self._moving(joint, ratio)
        resting = self._at_stop(joint, ratio)
        after = self.turn + h / 2 * (self.rate + moving.rate)
        stays = at_stop & (resting.rate == 0)
        turns = (np.abs(self.turn) < h * np.abs(self.rate)) & (self.turn * moving.rate <= 0)
        near = np.flatnonzero(~at_stop & (turns | (self.turn * after < 0)))
        if near.size:
            crosses, seated, ahead, bounced = self._bounced(joint, ratio, near)
            stays[near] |= crosses & seated & (resting.rate[near] == 0)
            after[near] = np.where(crosses, ahead, after[near])
            parts = [np.array(value) for value in moving[:4]]
            for whole, part in zip(parts, bounced[:4], strict=True):
                whole[near] = np.where(crosses, part, whole[near])
            moving = _StepResult(*[*parts, pack.closing_force])
        pairs = zip(resting, moving._replace(normal=pack.closing_force), strict=True)
        result = _StepResult(*(np.where(at_stop | stays, rest, move) for rest, move in pairs))
        return result, np.where(stays, 0.0, np.where(at_stop, h / 2 * (self.rate + result.rate), after))

    def _bounced(
        self, joint: "_Joint", ratio: Values, near: NDArray[np.intp]
    ) -> "tuple[NDArray[np.bool_], NDArray[np.bool_], Floats, _StepResult]":
        """Follow the balls through the stop to the other wall and back in one step, in closed form at constant torques.

        Returns:
            Whether the balls come to the stop, whether they come to rest there, their turn, torques and speeds.
        """
        pack, whole, begun, before = self.pack, self.h.shape, self.turn[near], self.rate[near]
        joint = _Joint(*(np.broadcast_to(value, whole)[near] for value in joint))
        pressed, mass, back, lift, share, h = (
            np.broadcast_to(value, whole)[near]
            for value in (pack.closing_force, self._mass_at_stop, self._mass_back, pack.lift, self._share, self.h)
        )
        first, capacity = (
            np.where(begun < 0, -1.0, 1.0),
            np.broadcast_to(pack.carried(pack.closing_force, ratio), whole)[near],
        )
        resting = joint.boxed(capacity, -np.inf, np.inf, pressed)
        sticks = np.abs(resting.clutch) < capacity
        # speed of the balls gained in a step without their torque, and what their torque takes of it
        yields = np.where(sticks, joint.balls - joint.across * joint.across / joint.pack, joint.balls)
        gained = joint.rate + joint.across * np.where(sticks, joint.slip / joint.pack, resting.clutch) - before

        def slowed(side: Floats) -> tuple[Floats, Floats]:
            """Speed that balls lose per step while they move out along a wall, and gain while they move back."""
            return (
                (yields * lift - side * gained) / (1 + yields * mass),
                (yields * lift * share - side * gained) / (1 + yields * back),
            )

        with np.errstate(all="ignore"):
            (out, home), away, speed = slowed(first), np.abs(begun) / h, first * before
            # to the stop: up to the turning point first, where the balls still move out
            top = away + np.where(speed > 0, speed * speed / (2 * out), 0.0)
            nearing = np.maximum(-speed, 0.0)
            arriving = np.sqrt(nearing * nearing + 2 * home * top)
            # share of the step that is left once the balls are at the stop
            time_left = 1 - np.where(speed > 0, speed / out, 0.0) - 2 * top / (nearing + arriving)
            crosses = (time_left > 0) & ((speed <= 0) | (out > 0))
            speed, side = np.where(crosses, arriving, 0.0), -first
            walls = slowed(side), (out, home)
            # a swing over both walls takes a time, and leaves a share of the speed
            keeps = [np.sqrt(b / a) for a, b in walls]
            takes = [1 / a + 1 / np.sqrt(a * b) for a, b in walls]
            swing, kept = speed * (takes[0] + keeps[0] * takes[1]), keeps[0] * keeps[1]
            # the balls swing so only where both walls push them back
            swings = (np.minimum(out, home) > 0) & (np.minimum(*walls[0]) > 0)
            seated = swings & ((swing < (1 - kept) * time_left) | (swing < _SWING_OVER))
            count = np.where(kept < 1, np.log1p(-(1 - kept) * time_left / swing) / np.log(kept), time_left / swing)
            count = swings * np.floor(np.nan_to_num(count, nan=0.0, posinf=0.0, neginf=0.0))
            passed = np.where(kept < 1, swing * (1 - kept**count) / (1 - kept), swing * count)
            time_left = time_left - np.where(count > 0, passed, 0.0)
            speed = speed * np.where(count > 0, kept**count, 1.0)
            turn, rate, going = np.zeros(near.size), np.zeros(near.size), crosses & ~seated
            for place, (out, home) in zip((side, -side), walls, strict=True):
                up = np.where(out > 0, speed / out, np.inf)
                high, down = speed * up / 2, np.where(home > 0, speed / np.sqrt(out * home), np.inf)
                falls = np.clip(time_left - up, 0.0, np.inf) * (home > 0)
                turns = np.where(
                    time_left < up, speed * time_left - out * time_left * time_left / 2, high - home * falls * falls / 2
                )
                moves = np.where(time_left < up, speed - out * time_left, -home * falls)
                ends = going & (time_left < up + down)
                turn, rate = np.where(ends, place * h * turns, turn), np.where(ends, place * moves, rate)
                going, time_left = going & ~ends, time_left - up - down
                speed = speed * np.sqrt(home / out)
        return crosses, seated, turn, joint.pushed(capacity, (before + gained - rate) / yields, pressed)

    def _moving(self, joint: "_Joint", ratio: Values) -> "_StepResult":
        """Torques and speeds with the balls off the stop; the key sticks at ball torques between S/κ₊ and S/κ."""
        pack = self.pack
        side, ahead = np.where(self.turn < 0, -1.0, 1.0), self.h / 2 * self.rate
        travel = pack.travel(self.turn + ahead)
        way = np.where(self.turn * self.rate >= 0, pack.net_gain, pack.net_gain_returning)
        # torque that accelerates the sleeve's mass, per speed that the balls gain in a step
        mass = pack.inertia(travel, pack.steeper(way, travel)) / self.h
        joint = joint.heavier(mass, self.rate)
        # implicit midpoint: the speed before the step gives half of the turn, the speed after it the other half
        halfway = pack.travel(self.turn + ahead / 2)
        moment = pack.driving_moment(halfway, self.rate + self._gained / 2)
        nets = [pack.steeper(net, halfway) for net in (pack.net_gain, pack.net_gain_returning)]
        most, least = (side * (moment / net) for net in nets)
        normal = pack.pressed(travel)
        capacity = pack.carried(normal, ratio)
        result = joint.boxed(capacity, np.minimum(least, most), np.maximum(least, most), normal)
        outwards = result.balls == most
        stiff = self.h / 4 * pack.torsional(halfway, np.where(outwards, *nets), np.abs(result.balls))
        # a negative stiffness is limited: the divisor 1 + balls · stiff in `yielding` stays at least 1/2
        result = joint.yielding(
            result, np.where(result.rate == 0, 0.0, np.maximum(stiff, -0.5 / joint.balls)), capacity
        )
        return result._replace(balls=result.balls + mass * (result.rate - self.rate))

    def _at_stop(self, joint: "_Joint", ratio: Values) -> "_StepResult":
        """Torques and speeds at the stop: N falls along κ and rises along κ₊; beyond S(0)/κ the sleeve lifts off."""
        pack = self.pack
        alone, share = joint.rate / joint.balls, joint.across / joint.balls
        stuck = (joint.slip + joint.across * alone) / (joint.pack - joint.across * share)
        # without the impulse by which the balls come to rest at the stop, as it does not act on the sleeve
        steady = alone - self.rate / joint.balls
        normal = np.clip(self.normal, *pack.play(steady + share * stuck))
        way = np.where(stuck < 0, -1.0, 1.0)
        before = pack.carried(self.normal, ratio)
        sticking = steady + share * way * before
        side = way * np.where(sticking < 0, -1.0, 1.0)
        rising, falling = (pack.slipping_at_stop(ratio, side * net, way * steady, share) for net in pack.stop_gains)
        low, high = pack.play(sticking)
        slipping = np.where(self.normal > high, rising, np.where(self.normal < low, falling, before))
        sticks = np.abs(stuck) <= pack.carried(normal, ratio)
        clutch = np.where(sticks, stuck, way * slipping)
        balls = alone + share * clutch
        lifted = np.abs(balls) > pack.lift
        mass = self._mass_at_stop
        off = joint.heavier(mass, 0.0).pushed(
            pack.carried(pack.closing_force, ratio), np.copysign(pack.lift, balls), pack.closing_force
        )
        slip = np.where(sticks, 0.0, joint.slip - joint.pack * clutch + joint.across * balls)
        pressed = np.where(sticks, normal, slipping / pack.carried(1.0, ratio))
        off = off._replace(balls=off.balls + mass * off.rate)
        resting = clutch, balls, slip, 0.0, pressed
        return _StepResult(*(np.where(lifted, *parts) for parts in zip(off, resting, strict=True)))


class _StepResult(NamedTuple):
    """Torques of pack and balls, the speeds after the step, and the normal force."""

    clutch: Floats
    balls: Floats
    slip: Floats
    rate: Floats
    normal: Values


class _Joint(NamedTuple):
    """Slip of pack and balls after a step without their torques, and the slip that a torque of 1 N·m takes away."""

    slip: Floats
    rate: Floats
    pack: Values
    across: Values
    """Slip that a torque of 1 N·m on one of them adds to the other."""
    balls: Values

    def heavier(self, mass: Values, before: Values) -> "_Joint":
        """Return the joint with the sleeve's inertia, a torque of ``mass`` times the speed gained over ``before``."""
        whole = 1 + self.balls * mass
        slowed = (self.rate + self.balls * mass * before) / whole
        return _Joint(
            self.slip + self.across * mass * (slowed - before),
            slowed,
            self.pack - self.across * self.across * mass / whole,
            self.across / whole,
            self.balls / whole,
        )

    def pushed(self, capacity: Values, balls: Floats, normal: Values) -> _StepResult:
        """Torques and speeds with a given torque of the balls."""
        slip = self.slip + self.across * balls
        needed = slip / self.pack
        clutch = np.clip(needed, -capacity, capacity)
        rate = self.rate + self.across * clutch - self.balls * balls
        return _StepResult(clutch, balls, np.where(clutch == needed, 0.0, slip - self.pack * clutch), rate, normal)

    def boxed(self, capacity: Values, low: Values, high: Values, normal: Values) -> _StepResult:
        """Torques within limits that bring pack and balls to rest where they can: the solution of a convex problem."""
        both = self.pack - self.across * self.across / self.balls
        first = np.clip((self.slip + self.across * self.rate / self.balls) / both, -capacity, capacity)
        wanted = (self.rate + self.across * first) / self.balls
        balls = np.clip(wanted, low, high)
        result = self.pushed(capacity, balls, normal)
        return result._replace(rate=np.where(balls == wanted, 0.0, result.rate))

    def yielding(self, result: _StepResult, stiff: Floats, capacity: Values) -> _StepResult:
        """Return ``result`` with a torque of the balls that grows with their speed, where ``stiff`` is not 0."""
        whole = 1 + self.balls * stiff
        slip = self.slip + self.across * (result.balls + stiff * (self.rate - self.balls * result.balls) / whole)
        pack = self.pack - self.across * self.across * stiff / whole
        needed = slip / pack
        clutch = np.clip(needed, -capacity, capacity)
        rate = (self.rate + self.across * clutch - self.balls * result.balls) / whole
        slipping = np.where(clutch == needed, 0.0, slip - pack * clutch)
        moving = clutch, result.balls + stiff * rate, slipping, rate, result.normal
        return _StepResult(*(np.where(stiff != 0, *parts) for parts in zip(moving, result, strict=True)))


class Marched(NamedTuple):
    """Results of many events, an array for each quantity."""

    peak: Floats
    peak_clutch: Floats
    heat: Floats
    travel: Floats
    slip: Floats
    """Slip of the pack at the end, rad/s."""
    slipped: Floats
    """Time at which it last slipped, s."""
    passed: NDArray[np.bool_]
    """Whether a check showed that no later torque exceeds the peak; of whole slips that none slips any more."""


def march(
    train: Train,
    pack: DirectPack | Sleeve,
    step: Floats,
    steps: int,
    look: int | None = None,
    *,
    whole: bool = False,
) -> Marched:
    """Step events from start to ``steps`` times ``step``, to whose shape drives and clutches broadcast.

    From step ``look`` on it is checked whether all peaks have passed, or of ``whole`` slips whether none slips any
    more, which ends the stepping.
    """
    parts: list[Marched] = []
    blocks, least = -(-step.size // _LANES), look or steps

    def report(number: int) -> None:
        if number % _REPORT == 0:
            # before the first check, that many steps are expected
            expected = least if number < least else steps
            tell(say("stepping the drives"), len(parts) * expected + number, blocks * expected)

    for start in range(0, step.size, _LANES):
        lanes = slice(start, start + _LANES)
        drives, h = _cut(train, lanes, step.shape), step.ravel()[lanes]
        shaft = Shaft(drives, h)
        kind: Any = DirectLanes if isinstance(pack, DirectPack) else SleeveLanes
        clutch = kind(drives, _cut(pack, lanes, step.shape), h, shaft.per_torque)
        parts.append(_march(drives, shaft, clutch, h, steps, report, least, whole=whole))
    return Marched(*(np.concatenate(each).reshape(step.shape) for each in zip(*parts, strict=True)))


def _cut(whole: Any, lanes: slice, shape: tuple[int, ...]) -> Any:
    """Return a record with only some lanes of every array in it, also of arrays in nested records."""
    if isinstance(whole, np.ndarray):
        return np.broadcast_to(whole, shape).reshape(-1)[lanes]
    if isinstance(whole, Quantities):
        return Quantities(whole.laws, {name: _cut(value, lanes, shape) for name, value in whole.given.items()})
    if not is_dataclass(whole) or isinstance(whole, type):
        return whole
    return replace(whole, **{part.name: _cut(getattr(whole, part.name), lanes, shape) for part in fields(whole)})


def _march(
    train: Train,
    shaft: "Shaft",
    clutch: _Lanes,
    h: Floats,
    steps: int,
    report: Callable[[int], None],
    look: int,
    *,
    whole: bool,
) -> Marched:
    motor = earlier = shaft.driven
    each = h / train.motor_inertia
    peak, peak_clutch, heat, slipped = (np.zeros(h.size) for _ in range(4))
    off = np.full(h.size, np.inf)
    passed = over = np.zeros(h.size, bool)
    # with static friction the torque may rise again as the slip slows down: such a drive is stepped to the end of all
    steady = np.asarray(clutch.pack.static_ratio) == 1
    for number in range(steps):
        report(number)
        # motor torque at the speed in the middle of the step, extrapolated from the last step
        driving = train.engine.at(1.5 * motor - 0.5 * earlier)
        if train.cut_off is not None:
            driving = driving * np.clip(off / h - number, 0.0, 1.0)
        free = shaft.free(number, clutch.balls)
        before, earlier, motor = clutch.slip, motor, motor + each * driving
        clutch.step(free, motor, shaft.driven)
        motor = motor - each * clutch.torque
        shaft.take(free + shaft.per_torque * clutch.balls)
        np.maximum(peak, np.abs(shaft.torque), out=peak, where=~over)
        np.maximum(peak_clutch, clutch.top, out=peak_clutch, where=~over)
        heat += clutch.torque * (before + clutch.slip)
        np.copyto(slipped, (number + 1) * h, where=clutch.slip != 0)
        if train.cut_off is not None:
            off = np.where((clutch.slip != 0) & np.isinf(off), number * h + train.cut_off, off)
        if number + 1 >= look and (number + 1 - look) % _LOOKED == 0:
            if whole:
                passed = clutch.slip == 0
            else:
                passed = over | _passed(train, shaft, clutch, motor, (number + 1) * h, off, peak)
                over = passed & steady
            if passed.all():
                break
    return Marched(peak, peak_clutch, h / 2 * heat, clutch.travel, clutch.slip, slipped, passed)


def _passed(
    train: Train,
    shaft: "Shaft",
    clutch: _Lanes,
    motor: Floats,
    time: Floats,
    off: Floats,
    peak: Floats,
) -> NDArray[np.bool_]:
    """Whether no later torque exceeds the peak."""
    standing = np.abs(shaft.tool) <= _STANDING * train.speed
    powered, pending = time < off, (time < off) & np.isfinite(off)
    stuck = Stuck(motor, shaft.tool, shaft.elastic, standing, powered, pending)
    sliding, breakaway = (clutch.pack.torque(ratio) for ratio in (1.0, clutch.pack.static_ratio))
    slipping = Slipping(clutch.torque, shaft.driven, sliding, breakaway)
    still = settled(train, stuck, clutch.pack.sticks_up_to(clutch.turn, clutch.normal), peak)
    gone = slips_below(train, stuck, slipping, peak) & (clutch.slip > 0)
    return (clutch.rate == 0) & (time > train.time) & np.where(clutch.slip == 0, still, gone)


class Shaft:
    """Driven half, shaft and tool of many drives: implicit midpoint."""

    def __init__(self, train: Train, h: Floats) -> None:
        """Begin under the load."""
        self.train, self.h = train, h
        self.driven, self.tool = (np.broadcast_to(train.speed, h.shape).astype(float) for _ in range(2))
        self.torque = self.elastic = np.broadcast_to(train.load, h.shape).astype(float)
        self._until = float(np.max(train.time / h)) + 1
        if train.kind == "stop":
            self.tool = train.led(0 * h)
        self._after, self._rate = self.tool, self.driven - self.tool
        # torque at the middle of the step: elastic torque + link·(u + u⁺), u the rate of twist
        self._coupling = h * (h * train.stiffness / 4 + train.damping / 2)
        self._stretch = h / 2 * train.stiffness
        front = train.driven_inertia + self._coupling
        self._kept, self._lost = (train.driven_inertia - self._coupling) / front, h / front
        self._drawn = self._coupling / front
        rear = train.tool_inertia + self._coupling
        self._joint = front, rear, front * rear - self._coupling * self._coupling
        self.per_torque = self._lost if train.kind == "stop" else h * rear / self._joint[2]
        """Speed that a torque of 1 N·m adds to the driven half in a step."""

    def free(self, number: int, passed: Floats) -> Floats:
        """Return the speed of the driven half without the clutch; step the tool under the last torque ``passed``."""
        if self.train.kind == "load":
            self._rate = self.driven - self.tool
            return self._loaded((number + 0.5) * self.h, passed)
        speed: Floats = self._kept * self.driven - self._lost * self.elastic
        if number < self._until:
            self._after = self.train.led((number + 1) * self.h)
            speed = speed + self._drawn * (self.tool + self._after)
        return speed

    def _loaded(self, middle: Floats, passed: Floats) -> Floats:
        """Step a tool that its load may stop and keep at rest; return the speed of the driven half."""
        train, h, coupling = self.train, self.h, self._coupling
        impulse = h * self.elastic + coupling * self._rate
        front, rear, det = self._joint
        first, second = train.driven_inertia * self.driven - impulse, train.tool_inertia * self.tool + impulse
        load = train.load_at(middle)
        # the tool sees the clutch torque of the last step, which is an error of second order
        alone = coupling * (first + h * passed) + front * second
        resisting = np.clip(alone / (h * front), -load, load)
        self._after = (alone - front * h * resisting) / det
        return (rear * first + coupling * (second - h * resisting)) / det

    def take(self, driven: Floats) -> None:
        """Set the speed of the driven half after the step, and step the shaft with it."""
        rate = driven - self._after
        self.elastic = self.elastic + self._stretch * (self._rate + rate)
        self.driven, self.tool, self._rate = driven, self._after, rate
        self.torque = self.elastic + self.train.damping * rate
