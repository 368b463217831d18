"""The clutches of many drives in one time step: which torque brings a slip to rest, and what of it they can carry."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..arrays import Floats, Values
from ..equations import direct
from ..equations import drive as law
from .direct import DirectPack
from .sleeve import Sleeve
from .train import Train

_SWING_OVER = 0.01
"""Time of a swing of the balls between their walls, in steps, below which it is over."""


class DirectLanes:
    """Packs of direct clutches."""

    rate: Values = 0.0

    def __init__(self, train: Train, pack: DirectPack, h: Floats, per_torque: Floats) -> None:
        """Begin stuck, the release force that of the load; ``per_torque`` is what it adds to the driven half."""
        self.pack, self._each = pack, h / train.motor_inertia + per_torque
        self._static = bool(np.any(np.asarray(pack.static_ratio) != 1))
        self.slip, self.travel, self._trend = (np.zeros(h.size) for _ in range(3))
        self.torque = np.broadcast_to(train.load, h.shape).astype(float)
        self.normal = np.broadcast_to(pack.under(train.load), h.shape).astype(float)
        lag = np.broadcast_to(np.asarray(pack.lag, float), h.shape)
        self._half = np.exp(-h / (2 * np.where(lag > 0, lag, np.inf))) * (lag > 0) if np.any(lag > 0) else None
        """What is left of a deviation after half a step; None without lag."""

    @property
    def passed(self) -> Floats:
        """Torque on the driven half: that of the pack."""
        return self.torque

    @property
    def sticks_up_to(self) -> Values:
        """Torque up to which a stuck pack sticks, N·m."""
        return self.pack.torque(self.pack.static_ratio)

    def step(self, free: Floats, motor: Floats, driven: Floats) -> None:
        """Find the torque of the pack, from the speeds of both halves without it."""
        own = self.pack
        needed = (motor - free) / self._each
        slip, self.top = self.slip + self._trend, np.zeros(needed.shape)
        for _ in range(2 if self._static else 1):
            # static friction is that of the middle of the step: foretold, then mended
            capacity = self._capacity(ratio_of(own, (self.slip + slip) / 2) if self._static else 1.0)
            self.torque = np.maximum(np.minimum(needed, capacity), -capacity)
            self.top = np.maximum(self.top, np.abs(self.torque))
            # exactly 0 where it sticks
            slip = self._each * (needed - self.torque)
        if self._static:
            self._trend = np.where(slip == 0, 0.0, slip - self.slip)
        self.slip = slip
        if self._half is not None:
            balance = own.under(np.abs(self.torque))
            self.normal = balance + (self.normal - balance) * self._half**2

    def _capacity(self, ratio: Values) -> Values:
        """Largest torque of the pack; a late normal force is that of the middle of the step, its own torque in it."""
        own = self.pack
        if self._half is None:
            return own.torque(ratio)
        loop = own.gain * own.controlled_pairs * own.driven * (1 - self._half)
        alone: Values = own.closing_force * (1 - self._half) + self.normal * self._half
        middle: Values = direct.normal_force(alone, 1.0, loop, ratio)
        return own.carried(middle, ratio)


class SleeveLanes:
    """Packs, hubs and balls of indirect clutches."""

    def __init__(self, train: Train, pack: Sleeve, h: Floats, per_torque: Floats) -> None:
        """Begin stuck, the key as after a torque that has risen to the load; beyond T_н off the stop."""
        self.pack, self.h = pack, h
        self._static = bool(np.any(np.asarray(pack.static_ratio) != 1))
        self._mass_at_stop: Values = pack.inertia(0.0, pack.net_gain) / h
        self._mass_back: Values = pack.inertia(0.0, pack.net_gain_returning) / h
        self._share = pack.net_gain / pack.net_gain_returning
        self._across = h / train.hub_inertia
        """What a torque adds to the speed of the hub in a step."""
        self._pack, self._balls = h / train.motor_inertia + self._across, self._across + per_torque
        self.slip, self.rate, self._trend, self._gained = (np.zeros(h.size) for _ in range(4))
        self.torque = np.broadcast_to(train.load, h.shape).astype(float)
        self.balls = self.torque.copy()
        self.turn = np.broadcast_to(pack.turn_under(train.load), h.shape).astype(float)
        self.held = np.broadcast_to(pack.pressed_at_stop(train.load, pack.stop_gains[0]), h.shape).astype(float)
        self.travel = pack.travel(self.turn)

    @property
    def passed(self) -> Floats:
        """Torque on the driven half: that of the balls."""
        return self.balls

    @property
    def sticks_up_to(self) -> Values:
        """Torque up to which nothing of it slips or moves, N·m."""
        return self.pack.sticks_up_to(self.turn)

    def step(self, free: Floats, motor: Floats, driven: Floats) -> None:
        """Find the torques of pack and balls, from the speeds of both halves without them."""
        hub = driven + self.rate
        joint = _Joint(motor - hub, hub - free, self._pack, self._across, self._balls)
        slip, self.top = self.slip + self._trend, np.zeros(self.slip.shape)
        for _ in range(2 if self._static else 1):
            pairs = self.pack.friction_pairs * ratio_of(self.pack, (self.slip + slip) / 2)
            found, turn = self._found(joint, pairs)
            self.top, slip = np.maximum(self.top, np.abs(found.clutch)), found.slip
        self._trend = np.where(slip == 0, 0.0, slip - self.slip)
        self._gained = found.rate - self.rate
        self.torque, self.balls, self.slip, self.rate, _ = found
        self.held, self.turn = np.asarray(found.normal), turn
        self.travel = np.maximum(self.travel, self.pack.travel(turn))

    def _found(self, joint: "_Joint", pairs: Values) -> "tuple[_Found, Floats]":
        """Torques and speeds after a step, and the turn of the balls."""
        own, h = self.pack, self.h
        at_stop = self.turn == 0
        moving = self._moving(joint, pairs)
        still = self._still(joint, pairs)
        after = self.turn + h / 2 * (self.rate + moving.rate)
        stays = at_stop & (still.rate == 0)
        turns = (np.abs(self.turn) < h * np.abs(self.rate)) & (self.turn * moving.rate <= 0)
        near = np.flatnonzero(~at_stop & (turns | (self.turn * after < 0)))
        if near.size:
            crosses, seated, ahead, bounced = self._bounced(joint, pairs, near)
            stays[near] |= crosses & seated & (still.rate[near] == 0)
            after[near] = np.where(crosses, ahead, after[near])
            parts = [np.array(value) for value in moving[:4]]
            for whole, part in zip(parts, bounced[:4], strict=True):
                whole[near] = np.where(crosses, part, whole[near])
            moving = _Found(parts[0], parts[1], parts[2], parts[3], own.closing_force)
        found = _picked(at_stop | stays, still, moving._replace(normal=own.closing_force))
        return found, np.where(stays, 0.0, np.where(at_stop, h / 2 * (self.rate + found.rate), after))

    def _mass(self, travel: Floats, out: NDArray[np.bool_]) -> Values:
        """Torque that the sleeve's mass takes for a speed of the balls gained in a step."""
        own = self.pack
        net = own.steeper(np.where(out, own.net_gain, own.net_gain_returning), travel)
        mass: Values = own.inertia(travel, net) / self.h
        return mass

    def _bounced(
        self, joint: "_Joint", pairs: Values, near: NDArray[np.intp]
    ) -> "tuple[NDArray[np.bool_], NDArray[np.bool_], Floats, _Found]":
        """Through the stop to the other wall and back, as often as a step has it: with constant torques in closed form.

        Returns:
            Whether the balls come to the stop, whether they come to rest there, their turn, torques and speeds.
        """
        own, whole, begun, before = self.pack, self.h.shape, self.turn[near], self.rate[near]
        joint = _Joint(*(np.broadcast_to(value, whole)[near] for value in joint))
        pressed, mass, back, lift, share, h = (
            np.broadcast_to(value, whole)[near]
            for value in (own.closing_force, self._mass_at_stop, self._mass_back, own.lift, self._share, self.h)
        )
        first, capacity = (
            np.where(begun < 0, -1.0, 1.0),
            np.broadcast_to(pairs * own.mean_radius, whole)[near] * pressed,
        )
        resting = joint.boxed(capacity, -np.inf, np.inf, pressed)
        sticks = np.abs(resting.clutch) < capacity
        # speed of the balls gained in a step without their torque, and what their torque takes of it
        yields = np.where(sticks, joint.balls - joint.across * joint.across / joint.pack, joint.balls)
        gained = joint.rate + joint.across * np.where(sticks, joint.slip / joint.pack, resting.clutch) - before

        def slowed(side: Floats) -> tuple[Floats, Floats]:
            """Speed that a wall takes in a step from balls that move out, and gives them on their way back."""
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
            left = 1 - np.where(speed > 0, speed / out, 0.0) - 2 * top / (nearing + arriving)
            crosses = (left > 0) & ((speed <= 0) | (out > 0))
            speed, side = np.where(crosses, arriving, 0.0), -first
            walls = slowed(side), (out, home)
            # a swing over both walls takes a time, and leaves a share of the speed
            keeps = [np.sqrt(b / a) for a, b in walls]
            takes = [1 / a + 1 / np.sqrt(a * b) for a, b in walls]
            swing, kept = speed * (takes[0] + keeps[0] * takes[1]), keeps[0] * keeps[1]
            # only where both walls send the balls back is there such a swing
            swings = (np.minimum(out, home) > 0) & (np.minimum(*walls[0]) > 0)
            seated = swings & ((swing < (1 - kept) * left) | (swing < _SWING_OVER))
            count = np.where(kept < 1, np.log1p(-(1 - kept) * left / swing) / np.log(kept), left / swing)
            count = swings * np.floor(np.nan_to_num(count, nan=0.0, posinf=0.0, neginf=0.0))
            passed = np.where(kept < 1, swing * (1 - kept**count) / (1 - kept), swing * count)
            left = left - np.where(count > 0, passed, 0.0)
            speed = speed * np.where(count > 0, kept**count, 1.0)
            turn, rate, going = np.zeros(near.size), np.zeros(near.size), crosses & ~seated
            for place, (out, home) in zip((side, -side), walls, strict=True):
                up = np.where(out > 0, speed / out, np.inf)
                high, down = speed * up / 2, np.where(home > 0, speed / np.sqrt(out * home), np.inf)
                falls = np.clip(left - up, 0.0, np.inf) * (home > 0)
                turns = np.where(left < up, speed * left - out * left * left / 2, high - home * falls * falls / 2)
                moves = np.where(left < up, speed - out * left, -home * falls)
                ends = going & (left < up + down)
                turn, rate = np.where(ends, place * h * turns, turn), np.where(ends, place * moves, rate)
                going, left = going & ~ends, left - up - down
                speed = speed * np.sqrt(home / out)
        balls = (before + gained - rate) / yields
        needed = (joint.slip + joint.across * balls) / joint.pack
        clutch = np.clip(needed, -capacity, capacity)
        rate = joint.rate + joint.across * clutch - joint.balls * balls
        slip = np.where(clutch == needed, 0.0, joint.slip - joint.pack * clutch + joint.across * balls)
        return crosses, seated, turn, _Found(clutch, balls, slip, rate, pressed)

    def _moving(self, joint: "_Joint", pairs: Values) -> "_Found":
        """Off the stop: the key holds between S/κ₊ and S/κ."""
        own = self.pack
        side, ahead = np.where(self.turn < 0, -1.0, 1.0), self.h / 2 * self.rate
        travel = own.travel(self.turn + ahead)
        mass = self._mass(travel, self.turn * self.rate >= 0)
        joint = joint.heavier(mass, self.rate)
        # implicit midpoint: half of the way on is that of the speed before, the other half that of the speed to come
        halfway = own.travel(self.turn + ahead / 2)
        moment = own.moment(halfway) - own.taken(halfway, self.rate + self._gained / 2)
        nets = [own.steeper(net, halfway) for net in (own.net_gain, own.net_gain_returning)]
        most, least = (side * (moment / net) for net in nets)
        normal = np.maximum(own.pressed(travel), 0.0)
        capacity = pairs * own.mean_radius * normal
        found = joint.boxed(capacity, np.minimum(least, most), np.maximum(least, most), normal)
        outwards = found.balls == most
        stiff = self.h / 4 * own.torsional(halfway, np.where(outwards, *nets), np.abs(found.balls))
        # a wall may yield the more the further it gives way, but never faster than what is on it can follow
        found = joint.yielding(found, np.where(found.rate == 0, 0.0, np.maximum(stiff, -0.5 / joint.balls)), capacity)
        return found._replace(balls=found.balls + mass * (found.rate - self.rate))

    def _still(self, joint: "_Joint", pairs: Values) -> "_Found":
        """At the stop: N falls along κ, rises along κ₊, is held between; beyond S(0)/κ the sleeve lifts off."""
        own, radius = self.pack, self.pack.mean_radius
        alone, share = joint.rate / joint.balls, joint.across / joint.balls
        stuck = (joint.slip + joint.across * alone) / (joint.pack - joint.across * share)
        # the impulse that stops balls coming to their stop is no torque that pushes the sleeve
        steady = alone - self.rate / joint.balls
        normal = np.clip(self.held, *own.play(steady + share * stuck))
        way = np.where(stuck < 0, -1.0, 1.0)
        held = steady + share * way * pairs * radius * self.held
        side = way * np.where(held < 0, -1.0, 1.0)
        rising, falling = (own.slipping_at_stop(pairs, side * net, way * steady, share) for net in own.stop_gains)
        low, high = own.play(held)
        slipping = np.where(self.held > high, rising, np.where(self.held < low, falling, pairs * radius * self.held))
        sticks = np.abs(stuck) <= pairs * radius * normal
        clutch = np.where(sticks, stuck, way * slipping)
        balls = alone + share * clutch
        lifted = np.abs(balls) > own.lift
        mass = self._mass_at_stop
        off = joint.heavier(mass, 0.0).pushed(
            pairs * radius * own.closing_force, np.copysign(own.lift, balls), own.closing_force
        )
        slip = np.where(sticks, 0.0, joint.slip - joint.pack * clutch + joint.across * balls)
        pressed = np.where(sticks, normal, slipping / (pairs * radius))
        return _Found(
            np.where(lifted, off.clutch, clutch),
            np.where(lifted, off.balls + mass * off.rate, balls),
            np.where(lifted, off.slip, slip),
            np.where(lifted, off.rate, 0.0),
            np.where(lifted, own.closing_force, pressed),
        )


class _Found(NamedTuple):
    """Torques of pack and balls, the speeds they leave, the normal force."""

    clutch: Floats
    balls: Floats
    slip: Floats
    rate: Floats
    normal: Values


def _picked(which: NDArray[np.bool_], first: _Found, second: _Found) -> _Found:
    return _Found(*(np.where(which, one, other) for one, other in zip(first, second, strict=True)))


class _Joint(NamedTuple):
    """Slip of the pack and of the balls after a step without their torques, and what a torque takes from each."""

    slip: Floats
    rate: Floats
    pack: Values
    across: Values
    """What a torque of one adds to the slip of the other."""
    balls: Values

    def heavier(self, mass: Values, before: Values) -> "_Joint":
        """The same with the sleeve's mass, which takes a torque for a speed of the balls gained over ``before``."""
        whole = 1 + self.balls * mass
        slowed = (self.rate + self.balls * mass * before) / whole
        return _Joint(
            self.slip + self.across * mass * (slowed - before),
            slowed,
            self.pack - self.across * self.across * mass / whole,
            self.across / whole,
            self.balls / whole,
        )

    def pushed(self, capacity: Values, balls: Floats, normal: Values) -> _Found:
        """Under a torque of the balls."""
        slip = self.slip + self.across * balls
        needed = slip / self.pack
        clutch = np.clip(needed, -capacity, capacity)
        rate = self.rate + self.across * clutch - self.balls * balls
        return _Found(clutch, balls, np.where(clutch == needed, 0.0, slip - self.pack * clutch), rate, normal)

    def boxed(self, capacity: Values, low: Values, high: Values, normal: Values) -> _Found:
        """Torques within their limits that bring to rest what they can: a convex problem of two, solved exactly."""
        both = self.pack - self.across * self.across / self.balls
        first = np.clip((self.slip + self.across * self.rate / self.balls) / both, -capacity, capacity)
        wanted = (self.rate + self.across * first) / self.balls
        balls = np.clip(wanted, low, high)
        needed = (self.slip + self.across * balls) / self.pack
        clutch = np.clip(needed, -capacity, capacity)
        slip = np.where(clutch == needed, 0.0, self.slip - self.pack * clutch + self.across * balls)
        rate = np.where(balls == wanted, 0.0, self.rate + self.across * clutch - self.balls * balls)
        return _Found(clutch, balls, slip, rate, normal)

    def yielding(self, found: _Found, stiff: Floats, capacity: Values) -> _Found:
        """The same with a torque of the balls that grows with their speed, where they move."""
        whole = 1 + self.balls * stiff
        slip = self.slip + self.across * (found.balls + stiff * (self.rate - self.balls * found.balls) / whole)
        pack = self.pack - self.across * self.across * stiff / whole
        needed = slip / pack
        clutch = np.clip(needed, -capacity, capacity)
        rate = (self.rate + self.across * clutch - self.balls * found.balls) / whole
        moves = stiff != 0
        return _Found(
            np.where(moves, clutch, found.clutch),
            np.where(moves, found.balls + stiff * rate, found.balls),
            np.where(moves, np.where(clutch == needed, 0.0, slip - pack * clutch), found.slip),
            np.where(moves, rate, found.rate),
            found.normal,
        )


def ratio_of(pack: DirectPack | Sleeve, slip: Floats) -> Values:
    """Friction at a slip over sliding friction."""
    ratio: Floats = law.stribeck_ratio(pack.static_ratio, np.exp(-pack.decay_rate * np.abs(slip)))
    return ratio
