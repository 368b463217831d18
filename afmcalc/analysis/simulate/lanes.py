"""The clutches of many drives in one time step: which torque brings a slip to rest, and what of it they can carry."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...arrays import Floats, Values
from ...equations import direct
from ...equations import drive as law
from .direct import DirectPack
from .sleeve import Sleeve
from .train import Train


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
        self._across = h / train.hub_inertia
        """What a torque adds to the speed of the hub in a step."""
        self._pack, self._balls = h / train.motor_inertia + self._across, self._across + per_torque
        self.slip, self.rate, self._trend, self._gained = (np.zeros(h.size) for _ in range(4))
        self.torque = np.broadcast_to(train.load, h.shape).astype(float)
        self.balls = self.torque.copy()
        self.turn = np.broadcast_to(pack.turn_under(train.load), h.shape).astype(float)
        self.held = np.broadcast_to(pack.pressed_at_stop(train.load, pack.net_gain), h.shape).astype(float)
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
        crosses = self.turn * after < 0
        stays = at_stop & (still.rate == 0)
        if crosses.any():
            rolled, ahead = self._rolled(joint, moving, pairs)
            after = np.where(crosses, ahead, after)
            # a swing between the walls that turns within a step is over
            stays |= crosses & (still.rate == 0) & (rolled.rate * self.rate <= 0)
            moving = _picked(crosses, rolled, moving)
        found = _picked(at_stop | stays, still, moving._replace(normal=own.closing_force))
        return found, np.where(stays, 0.0, np.where(at_stop, h / 2 * (self.rate + found.rate), after))

    def _mass(self, travel: Floats, out: NDArray[np.bool_]) -> Values:
        """Torque that the sleeve's mass takes for a speed of the balls gained in a step."""
        own = self.pack
        net = own.steeper(np.where(out, own.net_gain, own.net_gain_returning), travel)
        mass: Values = own.inertia(travel, net) / self.h
        return mass

    def _rolled(self, joint: "_Joint", moving: "_Found", pairs: Values) -> "tuple[_Found, Floats]":
        """Through the stop to the other wall, each for its share of the step, and where to; ``moving`` on the first."""
        own, side = self.pack, np.where(self.turn < 0, -1.0, 1.0)
        normal = own.closing_force
        capacity = pairs * own.mean_radius * normal
        mass = self._mass_at_stop
        other = joint.heavier(mass, self.rate).pushed(capacity, -side * own.lift, normal)
        balls = other.balls + mass * (other.rate - self.rate)
        # the time to the stop at the acceleration of the first wall
        away, nearing, gained = np.abs(self.turn), -side * self.rate, -side * (moving.rate - self.rate)
        root = np.sqrt(np.maximum(nearing * nearing + 2 * gained / self.h * away, 0.0))
        with np.errstate(divide="ignore", invalid="ignore"):
            share = np.clip(2 * away / (self.h * (nearing + root)), 0.0, 1.0)
        found = joint.pushed(capacity, share * moving.balls + (1 - share) * balls, normal)
        bent = share * (1 - share) * (moving.rate - other.rate)
        return found, self.turn + self.h / 2 * (self.rate + found.rate + bent)

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
        normal = self._played(alone + share * stuck)
        way = np.where(stuck < 0, -1.0, 1.0)
        held = alone + share * way * pairs * radius * self.held
        side = way * np.where(held < 0, -1.0, 1.0)
        # N = F_п2 − κ |T_b|/R with T_b = alone + share·T_f, along the slip
        rising, falling = (
            pairs * (radius * own.control_force - side * net * way * alone) / (1 + side * pairs * net * share)
            for net in (own.net_gain, own.net_gain_returning)
        )
        low, high = self._bounds(held)
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

    def _bounds(self, balls: Floats) -> tuple[Values, Values]:
        own = self.pack
        return own.pressed_at_stop(balls, own.net_gain_returning), own.pressed_at_stop(balls, own.net_gain)

    def _played(self, balls: Floats) -> Floats:
        """N at the stop as it follows a torque of the balls."""
        low, high = self._bounds(balls)
        played: Floats = np.clip(self.held, low, high)
        return played


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
