"""One time step of a clutch in its drive, for one drive as numbers or many as arrays.

Friction is solved by projection (Moreau–Jean): first the speeds without the torque of a friction element, then the
torque that brings its slip to zero; if this torque exceeds the capacity, the element slips. The stop of the sleeve is
rigid: if balls pass the stop within a step, their work at both walls is exact. The shaft is stepped by the implicit
midpoint rule, so that accuracy limits the step, not stability.
"""

from collections.abc import Callable, Sequence
from dataclasses import fields, is_dataclass, replace
from typing import Any, Self

import numpy as np

from ..engines.quantities import Quantities
from ..equations import direct
from ..equations.arrays import is_array, larger
from .pack_and_sleeve import DirectPack, Sleeve
from .train import Train

_NEARLY_NO = 1e-30
"""Smallest turn, rad, of balls that have just passed their stop."""


def where(condition: Any, yes: Any, no: Any) -> Any:
    """Elementwise choice."""
    return (yes if condition else no) if condition.__class__ is bool else np.where(condition, yes, no)


def clip(value: Any, least: Any, most: Any) -> Any:
    """Value within limits, elementwise."""
    if value.__class__ is float and least.__class__ is float and most.__class__ is float:
        return least if value < least else most if value > most else value
    return np.minimum(np.maximum(value, least), most)


def _any(condition: Any) -> bool:
    return condition if condition.__class__ is bool else bool(condition.any())


def _all(condition: Any) -> bool:
    return condition if condition.__class__ is bool else bool(condition.all())


def _chosen(condition: Any, yes: tuple[Any, ...], no: tuple[Any, ...]) -> tuple[Any, ...]:
    if condition.__class__ is bool:
        return yes if condition else no
    return tuple(np.where(condition, one, other) for one, other in zip(yes, no, strict=True))


def cut(whole: Any, lanes: Any, shape: tuple[int, ...] | None = None) -> Any:
    """Record or list with some lanes (drives) of its arrays, broadcast to ``shape`` first; of one lane, numbers."""
    if isinstance(whole, np.ndarray):
        part = (whole if shape is None else np.broadcast_to(whole, shape).reshape(-1))[..., lanes]
        return part if is_array(part) else part.item()
    if isinstance(whole, list):
        return [cut(value, lanes, shape) for value in whole]
    if isinstance(whole, Quantities):
        return Quantities(whole.laws, {name: cut(value, lanes, shape) for name, value in whole.given.items()})
    if not is_dataclass(whole) or isinstance(whole, type):
        return whole
    return replace(whole, **{part.name: cut(getattr(whole, part.name), lanes, shape) for part in fields(whole)})


def stacked(records: Sequence[Any]) -> Any:
    """Record of arrays, made of many records of the same kind with numbers; the inverse of ``cut``."""
    first = records[0]
    if is_dataclass(first) and not isinstance(first, type):
        columns = {part.name: stacked([getattr(record, part.name) for record in records]) for part in fields(first)}
        return replace(first, **columns)
    return np.array(records, float) if isinstance(first, int | float) else first


class Many:
    """State of one drive as numbers, or of many as arrays."""

    def lanes(self, kept: Any) -> Self:
        """State of only the drives at the indices ``kept``; for a single index as numbers."""
        found = object.__new__(type(self))
        vars(found).update({name: cut(value, kept) for name, value in vars(self).items()})
        return found


class Motion(Many):
    """State of a drive and its clutch, stepped through an event; speeds in rad/s, torques in N·m, work in J."""

    def __init__(self, train: Train, pack: DirectPack | Sleeve, h: Any) -> None:
        """Start in steady running under load with a sticking clutch, its sleeve off the stop if the load exceeds T_н.

        ``h``: first time step, s; for many drives an array with the step of each drive.
        """
        self.train = train
        self.pack: Any = pack
        zero = h * 0.0
        self.static = bool(np.any(np.asarray(pack.static_ratio) != 1))
        self.turning_tool = train.kind == "load"
        self.time, self.slip, self.rate, self.trend, self.gained, self.top = (zero for _ in range(6))
        self.driven = self.motor = self.before = zero + train.speed
        self.tool = zero + train.speed if self.turning_tool else zero + train.led(zero)
        self.elastic = self.torque = self.clutch = self.balls = zero + train.load
        """Torques: elastic part in the shaft, whole shaft, pack, and balls (from hub to driven half)."""
        self.turn = zero + pack.turn_under(train.load)
        self.normal = zero + pack.pressed_at_stop(train.load, pack.stop_gains[0])
        self.motor_work = self.heat = self.key_heat = self.shaft_heat = self.tool_work = zero
        self.twisting = self.driven - self.tool
        self.h = h
        self.set_step(h)

    def set_step(self, h: Any) -> None:
        """Set the time step, s."""
        train, pack = self.train, self.pack
        # values extrapolated from the last step keep their rates
        longer = h / self.h
        self.before = self.motor - (self.motor - self.before) * longer
        self.trend, self.gained, self.h = self.trend * longer, self.gained * longer, h
        # torque at the middle of the step: elastic torque + link·(u + u⁺), with the rate of twist u
        self._link = h * (h * train.stiffness / 4 + train.damping / 2)
        front, rear = train.driven_inertia + self._link, train.tool_inertia + self._link
        self._front, self._rear, self._det = front, rear, front * rear - self._link * self._link
        self.per_torque = h * rear / self._det if self.turning_tool else h / front
        """Speed that a torque of 1 N·m adds to the driven half in a step."""
        if pack.travels:
            self._across = h / train.hub_inertia
            self._of_pack, self._of_balls = h / train.motor_inertia + self._across, self._across + self.per_torque
        else:
            self._of_pack = h / train.motor_inertia + self.per_torque
            self.half_lag = np.exp(-h / (2 * np.where(pack.lag > 0, pack.lag, np.inf))) * (pack.lag > 0)
            """Factor by which the normal force's deviation from equilibrium decays in half a step; 0 without lag."""
            if h.__class__ is float:
                self.half_lag = float(self.half_lag)

    def step(self, powered: Any) -> None:
        """Make a time step; the motor is on for the share ``powered`` of the step."""
        train, h, half = self.train, self.h, self.h / 2
        # torque of the motor at the speed in the middle of the step, extrapolated from the last step
        self.driving = driving = train.engine.at(1.5 * self.motor - 0.5 * self.before) * powered
        fast, slip, tool, rate = self.motor, self.slip, self.tool, self.rate
        free = self._without_clutch()
        motor = fast + h / train.motor_inertia * driving
        ahead = slip + self.trend
        clutch_at = self._sleeve(motor, free) if self.pack.travels else self._discs(motor, free)
        # friction at the slip in the middle of the step: first from a predicted slip, then from the resulting slip
        result = clutch_at(self.pack.ratio((slip + ahead) / 2) if self.static else 1.0)
        self.top = abs(result[0])
        if self.static and _any(result[2] != ahead):
            result = clutch_at(self.pack.ratio((slip + result[2]) / 2))
            self.top = larger(self.top, abs(result[0]))
        self.clutch, self.balls, self.slip, self.rate, self.normal, self.turn, lost = result
        if self.static:
            self.trend = where(self.slip == 0, 0.0, self.slip - slip)
        self.gained = self.rate - rate
        self.before, self.motor = fast, motor - h / train.motor_inertia * self.clutch
        self.driven = free + self.per_torque * self.balls
        twisting = self.driven - self.tool
        stretched = (self.twisting + twisting) / 2
        middle = self.elastic + half * train.stiffness * stretched + train.damping * stretched
        self.elastic = self.elastic + h * train.stiffness * stretched
        self.twisting, self.torque = twisting, self.elastic + train.damping * twisting
        self.time = self.time + h
        self.motor_work = self.motor_work + half * driving * (fast + self.motor)
        self.heat = self.heat + half * self.clutch * (slip + self.slip)
        self.key_heat = self.key_heat + lost
        self.shaft_heat = self.shaft_heat + h * train.damping * stretched * stretched
        resisting = self.resisting if self.turning_tool else middle
        self.tool_work = self.tool_work + half * resisting * (tool + self.tool)

    def _without_clutch(self) -> Any:
        """Speed of the driven half after a step without clutch torque; also steps the tool, with the last torque."""
        train, h, link, middle = self.train, self.h, self._link, self.time + self.h / 2
        impulse = h * self.elastic + link * self.twisting
        first = train.driven_inertia * self.driven - impulse
        if not self.turning_tool:
            self.tool = train.led(self.time + h)
            return (first + link * self.tool) / self._front
        second = train.tool_inertia * self.tool + impulse
        load = train.load_at(middle)
        # the tool sees the torque of the last step, which is an error of second order
        alone = link * (first + h * self.balls) + self._front * second
        self.resisting = clip(alone / (h * self._front), -load, load)
        self.tool = (alone - self._front * h * self.resisting) / self._det
        return (self._rear * first + link * (second - h * self.resisting)) / self._det

    def _discs(self, motor: Any, free: Any) -> Callable[[Any], tuple[Any, ...]]:
        """Step of a direct clutch as a function of the friction ratio.

        It returns torques of pack and balls, slip, rate and turn of the balls, normal force N, loss at the feather key.
        """
        pack, normal, kept = self.pack, self.normal, self.half_lag
        needed = (motor - free) / self._of_pack
        loop = pack.gain * pack.controlled_pairs * pack.driven * (1 - kept)
        alone = pack.closing_force * (1 - kept) + normal * kept

        def result(ratio: Any) -> tuple[Any, ...]:
            # slip torque with its own normal force in the middle of the step
            capacity = pack.carried(direct.normal_force(alone, 1.0, loop, ratio), ratio)
            torque = clip(needed, -capacity, capacity)
            balance = pack.pressed_at_stop(torque, pack.stop_gains[0])
            pressed = balance + (normal - balance) * kept * kept
            # the slip is exactly 0 where it sticks
            return torque, torque, self._of_pack * (needed - torque), self.rate, pressed, self.turn, 0.0

        return result

    def _sleeve(self, motor: Any, free: Any) -> Callable[[Any], tuple[Any, ...]]:
        """Step of an indirect clutch as a function of the friction ratio; it returns the same values as ``_discs``."""
        hub, turn, lift = self.driven + self.rate, self.turn, self.pack.lift
        v, w, at_stop, moving = motor - hub, hub - free, turn == 0, None
        rest = self._at_stop(v, w) if _any(at_stop) else None

        def result(ratio: Any) -> tuple[Any, ...]:
            nonlocal moving, rest
            resting, side = rest and rest(ratio), turn
            if resting:
                if _all(at_stop & (abs(resting[1]) <= lift)):
                    return resting
                side = where(at_stop, resting[1], turn)
            # balls leave the stop to the same side at the predicted and at the final friction ratio
            moving = moving or self._moving(v, w, where(side < 0, -1.0, 1.0))
            found = moving(ratio)
            passes = (turn * found[5] <= 0) & (turn != 0)
            if _any(passes):
                rest = rest or self._at_stop(v, w)
                resting = resting or rest(ratio)
                found = _chosen(passes, self._through(v, w, ratio), found)
            return _chosen((at_stop | passes) & (abs(resting[1]) <= lift), resting, found) if resting else found

        return result

    def _moving(self, v: Any, w: Any, side: Any) -> Callable[[Any], tuple[Any, ...]]:
        """Step with balls off their stop to ``side`` ±1; the feather key sticks at ball torques from S/κ₊ to S/κ."""
        pack, h, rate, turn = self.pack, self.h, self.rate, self.turn
        # implicit midpoint: the speed before the step gives half of the turn, the speed after it the other half
        travel = pack.travel(turn + h / 2 * rate)
        moment, gain = pack.driving_moment(travel, rate + self.gained / 2), pack.gain(travel)
        kappa, returning = pack.steeper(pack.net_gain, travel), pack.steeper(pack.net_gain_returning, travel)
        way = where(turn * rate >= 0, kappa, returning)
        # torque that accelerates the sleeve's mass and tensions the springs, per speed that the balls gain in a step
        stiff = pack.torsional(travel, gain, way, moment / way)
        mass = pack.inertia(gain, way) / h + larger(h / 4 * stiff, -0.25 / self._of_balls)
        A, B, D, v, w = self._heavier(v, w, mass, rate)
        most, least, both = moment / kappa, moment / returning, A - B * B / D
        pressed = pack.pressed(travel)

        def result(ratio: Any) -> tuple[Any, ...]:
            capacity = pack.carried(pressed, ratio)
            first = clip((v + B * w / D) / both, -capacity, capacity)
            wanted = (w + B * first) / D
            balls = side * clip(side * wanted, least, most)
            needed = (v + B * balls) / A
            clutch = clip(needed, -capacity, capacity)
            slip = where(clutch == needed, 0.0, v + B * balls - A * clutch)
            after = where(balls == wanted, 0.0, w + B * clutch - D * balls)
            balls = balls + mass * (after - rate)
            moved = h / 2 * (rate + after)
            lost = balls * moved * (1 - where(turn * moved >= 0, kappa, returning) / gain)
            return clutch, balls, slip, after, pack.closing_force, turn + moved, lost

        return result

    def _heavier(self, v: Any, w: Any, mass: Any, before: Any) -> tuple[Any, ...]:
        """Slips of pack and balls per N·m and without torques, if the balls also accelerate ``mass`` (per step)."""
        A, B, D = self._of_pack, self._across, self._of_balls
        whole = 1 + D * mass
        slowed = (w + D * mass * before) / whole
        return A - B * B * mass / whole, B / whole, D / whole, v + B * mass * (slowed - before), slowed

    def _through(self, v: Any, w: Any, ratio: Any) -> tuple[Any, ...]:
        """Step in which balls pass their stop: torque S(0)/κ₊ up to the stop, S(0)/κ beyond it, on the other wall."""
        pack, h, rate, turn = self.pack, self.h, self.rate, self.turn
        mass = pack.inertia(pack.stop_gain, pack.net_gain) / h
        capacity = pack.carried(pack.closing_force, ratio)
        A, B, D, v, w = self._heavier(v, w, mass, rate)
        lift, back = pack.lift, pack.lift * pack.net_gain / pack.net_gain_returning
        side, way = where(turn < 0, 1.0, -1.0), abs(turn)

        def passed(free: Any, of_balls: Any) -> tuple[Any, Any]:
            """Torque and turn of the balls, from their speed without torque, which falls by ``of_balls`` per N·m."""
            reach, yields = side * h / 2 * (rate + free) - way, h / 2 * of_balls
            slope = way - reach + yields * lift
            root = larger(slope * slope + 4 * way * (reach + yields * back), 0.0) ** 0.5
            beyond = larger((root - slope) / 2, _NEARLY_NO)
            return side * (reach - beyond) / yields, beyond

        balls, beyond = passed(w + B * v / A, D - B * B / A)
        needed = (v + B * balls) / A
        clutch = clip(needed, -capacity, capacity)
        sticks = clutch == needed
        slipping, further = passed(w + B * clutch, D)
        balls, beyond = where(sticks, balls, slipping), where(sticks, beyond, further)
        after = w + B * clutch - D * balls
        slip = where(sticks, 0.0, v + B * balls - A * clutch)
        gains = pack.stop_gain
        moment = lift * pack.net_gain
        lost = moment * (beyond * (1 / pack.net_gain - 1 / gains) + way * (1 / gains - 1 / pack.net_gain_returning))
        return clutch, balls + mass * (after - rate), slip, after, pack.closing_force, side * beyond, lost

    def _at_stop(self, v: Any, w: Any) -> Callable[[Any], tuple[Any, ...]]:
        """Step with balls at the stop, which they leave at S(0)/κ; N falls by κ with rising torque, rises by κ₊."""
        pack = self.pack
        A, B, D = self._of_pack, self._across, self._of_balls
        alone, share = w / D, B / D
        stuck = (v + B * alone) / (A - B * share)
        way = where(stuck < 0, -1.0, 1.0)
        # the impulse that brings the balls to rest at the stop is left out: it does not act on the sleeve
        steady = alone - self.rate / D
        low, high = pack.play(steady + share * stuck)
        normal = clip(self.normal, low, high)

        def result(ratio: Any) -> tuple[Any, ...]:
            sticks = abs(stuck) <= pack.carried(normal, ratio)
            if _all(sticks):
                return stuck, alone + share * stuck, stuck * 0.0, 0.0, normal, 0.0, 0.0
            before = pack.carried(self.normal, ratio)
            sticking = steady + share * way * before
            side = way * where(sticking < 0, -1.0, 1.0)
            rising, falling = (pack.slipping_at_stop(ratio, side * net, way * steady, share) for net in pack.stop_gains)
            low, high = pack.play(sticking)
            slipping = where(self.normal > high, rising, where(self.normal < low, falling, before))
            clutch = where(sticks, stuck, way * slipping)
            balls = alone + share * clutch
            slip = where(sticks, 0.0, v - A * clutch + B * balls)
            pressed = where(sticks, normal, slipping / pack.carried(1.0, ratio))
            return clutch, balls, slip, 0.0, pressed, 0.0, 0.0

        return result

    @property
    def stored(self) -> Any:
        """Kinetic and elastic energy, J."""
        train, pack = self.train, self.pack
        energy = train.motor_inertia * self.motor**2 + train.hub_inertia * (self.driven + self.rate) ** 2
        energy = energy + train.driven_inertia * self.driven**2 + train.tool_inertia * self.tool**2
        energy = (energy + self.elastic**2 / train.stiffness) / 2
        if pack.travels:
            travel = pack.travel(self.turn)
            energy = energy + pack.mass * pack.speed(travel, self.rate) ** 2 / 2 + pack.work(travel)
        return energy

    @property
    def left(self) -> Any:
        """Sum of stored and dissipated energy minus the motor's work, J: constant apart from the error of the steps."""
        gone = self.heat + self.key_heat + self.shaft_heat + self.tool_work
        return self.stored + gone - self.motor_work
