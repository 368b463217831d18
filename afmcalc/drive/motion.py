"""One step of a clutch in its drive, for one drive as numbers or many as arrays: the law of its motion, written once.

Fixed steps, friction by projection (Moreau–Jean): first the speeds without the torque of an element, then the torque
that brings its slip to rest; where that exceeds what friction carries, the element slips. The stop of the sleeve is
rigid: balls that pass it within a step exchange with both walls exactly the work of these walls. The shaft is stepped
by the implicit midpoint rule, so that the step is limited by accuracy, not by stability.
"""

from collections.abc import Callable, Sequence
from dataclasses import fields, is_dataclass, replace
from typing import Any

import numpy as np

from ..engines.quantities import Quantities
from ..equations import direct
from ..equations.arrays import is_array
from .pack_and_sleeve import DirectPack, Sleeve
from .train import Train

_NEARLY_NO = 1e-30
"""Turn of balls that have passed their stop, rad, at least."""


def where(condition: Any, yes: Any, no: Any) -> Any:
    """Elementwise choice."""
    return (yes if condition else no) if condition.__class__ is bool else np.where(condition, yes, no)


def clip(value: Any, least: Any, most: Any) -> Any:
    """Value within limits, elementwise."""
    if value.__class__ is float and least.__class__ is float and most.__class__ is float:
        return least if value < least else most if value > most else value
    return np.minimum(np.maximum(value, least), most)


def larger(first: Any, second: Any) -> Any:
    """Elementwise maximum of two."""
    if first.__class__ is float and second.__class__ is float:
        return first if first >= second else second
    return np.maximum(first, second)


def _any(condition: Any) -> bool:
    return condition if condition.__class__ is bool else bool(condition.any())


def cut(whole: Any, lanes: Any, shape: tuple[int, ...]) -> Any:
    """Record with only some lanes of every array in it, or with numbers of one, also in nested records."""
    if isinstance(whole, np.ndarray):
        part = np.broadcast_to(whole, shape).reshape(-1)[lanes]
        return part if is_array(part) else part.item()
    if isinstance(whole, Quantities):
        return Quantities(whole.laws, {name: cut(value, lanes, shape) for name, value in whole.given.items()})
    if not is_dataclass(whole) or isinstance(whole, type):
        return whole
    return replace(whole, **{part.name: cut(getattr(whole, part.name), lanes, shape) for part in fields(whole)})


def stacked(records: Sequence[Any]) -> Any:
    """Record of arrays, of many records of numbers that are alike; the inverse of ``cut``."""
    first = records[0]
    if is_dataclass(first) and not isinstance(first, type):
        columns = {part.name: stacked([getattr(record, part.name) for record in records]) for part in fields(first)}
        return replace(first, **columns)
    return np.array(records, float) if isinstance(first, int | float) else first


class Motion:
    """State of a drive and its clutch, stepped through an event; speeds in rad/s, torques in N·m, work in J."""

    def __init__(self, train: Train, pack: DirectPack | Sleeve, h: Any) -> None:
        """Begin in steady running under the load, stuck; an indirect clutch with a load beyond T_н off the stop.

        ``h``: first step, s; an array of many drives gives their number.
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
        """Torque of the shaft's twist; of the shaft; of the pack; between hub and driven half."""
        self.turn = zero + pack.turn_under(train.load)
        self.normal = zero + pack.pressed_at_stop(train.load, pack.stop_gains[0])
        self.motor_work = self.heat = self.key_heat = self.shaft_heat = self.tool_work = zero
        self.twisting = self.driven - self.tool
        self.h = h
        self.set_step(h)

    def set_step(self, h: Any) -> None:
        """Set the time step, s."""
        train, pack = self.train, self.pack
        # what is extrapolated from the last step goes on at its rate
        longer = h / self.h
        self.before = self.motor - (self.motor - self.before) * longer
        self.trend, self.gained, self.h = self.trend * longer, self.gained * longer, h
        # torque at the middle of the step: elastic torque + link·(u + u⁺), u the rate of twist
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
            """Factor by which a deviation of the normal force decays in half a step; 0 without lag."""
            if h.__class__ is float:
                self.half_lag = float(self.half_lag)

    def lanes(self, kept: Any) -> "Motion":
        """Some of many drives."""
        found, shape = object.__new__(Motion), self.h.shape
        vars(found).update({name: cut(value, kept, shape) for name, value in vars(self).items()})
        return found

    def step(self, powered: Any) -> None:
        """Make a step with the motor on for a share of it."""
        train, h, half = self.train, self.h, self.h / 2
        # torque of the motor at the speed in the middle of the step, extrapolated from the last step
        self.driving = driving = train.engine.at(1.5 * self.motor - 0.5 * self.before) * powered
        fast, slip, tool, rate = self.motor, self.slip, self.tool, self.rate
        free = self._without_clutch()
        motor = fast + h / train.motor_inertia * driving
        ahead, self.top = slip + self.trend, h * 0.0
        clutch_at = self._sleeve(motor, free) if self.pack.travels else self._discs(motor, free)
        for _ in range(2 if self.static else 1):
            # friction is that at the slip in the middle of the step: first of a predicted slip, then of the result
            result = clutch_at(self.pack.ratio((slip + ahead) / 2) if self.static else 1.0)
            ahead, self.top = result[2], larger(self.top, abs(result[0]))
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
        """Speed of the driven half after the step without the clutch; the tool steps under its last torque."""
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
        """Direct clutch, by friction ratio: the torque that brings the slip to rest, or the capacity."""
        pack, normal, kept = self.pack, self.normal, self.half_lag
        needed = (motor - free) / self._of_pack
        loop = pack.gain * pack.controlled_pairs * pack.driven * (1 - kept)
        alone = pack.closing_force * (1 - kept) + normal * kept

        def result(ratio: Any) -> tuple[Any, ...]:
            # the normal force that the torque at slip gives in the middle of the step
            capacity = pack.carried(direct.normal_force(alone, 1.0, loop, ratio), ratio)
            torque = clip(needed, -capacity, capacity)
            balance = pack.pressed_at_stop(torque, pack.stop_gains[0])
            pressed = balance + (normal - balance) * kept * kept
            # the slip is exactly 0 where it sticks
            return torque, torque, self._of_pack * (needed - torque), self.rate, pressed, self.turn, 0.0

        return result

    def _sleeve(self, motor: Any, free: Any) -> Callable[[Any], tuple[Any, ...]]:
        """Indirect clutch, by friction ratio: torques that bring the slips of pack and balls to rest, or capacities."""
        hub = self.driven + self.rate
        v, w, at_stop = motor - hub, hub - free, self.turn == 0
        if at_stop is True:
            return lambda ratio: self._at_stop(v, w, ratio)
        moving = self._moving(v, w, where(self.turn < 0, -1.0, 1.0))

        def result(ratio: Any) -> tuple[Any, ...]:
            found = moving(ratio)
            passes = (self.turn * found[5] <= 0) & (~at_stop if at_stop.__class__ is not bool else True)
            near = passes | at_stop
            if not _any(near):
                return found
            resting = self._at_stop(v, w, ratio)
            comes_to_rest = passes & (resting[3] == 0)
            if _any(passes):
                through = self._through(v, w, ratio)
                found = tuple(where(passes, one, other) for one, other in zip(through, found, strict=True))
            stops = at_stop | comes_to_rest
            return tuple(where(stops, one, other) for one, other in zip(resting, found, strict=True))

        return result

    def _moving(self, v: Any, w: Any, side: Any) -> Callable[[Any], tuple[Any, ...]]:
        """Balls off the stop, on one side or the other; the key sticks at ball torques between S/κ₊ and S/κ."""
        pack, h, rate, turn = self.pack, self.h, self.rate, self.turn
        ahead = h / 2 * rate
        # implicit midpoint: the speed before the step gives half of the turn, the speed after it the other half
        travel = pack.travel(turn + ahead)
        moment, gain = pack.driving_moment(travel, rate + self.gained / 2), pack.gain(travel)
        out = turn * rate >= 0
        kappa, returning = pack.steeper(pack.net_gain, travel), pack.steeper(pack.net_gain_returning, travel)
        way = where(out, kappa, returning)
        # torque that accelerates the sleeve's mass and tensions the springs, per speed that the balls gain in a step
        stiff = pack.torsional(travel, way, moment / way)
        mass = pack.inertia(travel, way) / h + larger(h / 4 * stiff, -0.25 / self._of_balls)
        most, least = side * moment / kappa, side * moment / returning
        A, B, D, v, w = self._heavier(v, w, mass, rate)
        low, high, both = where(side < 0, most, least), where(side < 0, least, most), A - B * B / D
        pressed = pack.pressed(travel)

        def result(ratio: Any) -> tuple[Any, ...]:
            capacity = pack.carried(pressed, ratio)
            first = clip((v + B * w / D) / both, -capacity, capacity)
            wanted = (w + B * first) / D
            balls = clip(wanted, low, high)
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
        """Slips without torques, and what 1 N·m takes of them, with a torque of ``mass`` times the speed gained."""
        A, B, D = self._of_pack, self._across, self._of_balls
        whole = 1 + D * mass
        slowed = (w + D * mass * before) / whole
        return A - B * B * mass / whole, B / whole, D / whole, v + B * mass * (slowed - before), slowed

    def _through(self, v: Any, w: Any, ratio: Any) -> tuple[Any, ...]:
        """Balls that pass the stop: their torque does the work of both walls, S(0)/κ₊ on the way in, S(0)/κ out."""
        pack, h, rate, turn = self.pack, self.h, self.rate, self.turn
        mass = pack.inertia(0.0, pack.net_gain) / h
        capacity = pack.carried(pack.closing_force, ratio)
        A, B, D, v, w = self._heavier(v, w, mass, rate)
        lift, back = pack.lift, pack.lift * pack.net_gain / pack.net_gain_returning
        side, way = where(turn < 0, 1.0, -1.0), abs(turn)

        def passed(free: Any, of_balls: Any) -> tuple[Any, Any]:
            """Torque of the balls and their turn, from their speed without it, and what 1 N·m takes of that."""
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

    def _at_stop(self, v: Any, w: Any, ratio: Any) -> tuple[Any, ...]:
        """Balls at the stop: N falls along κ and rises along κ₊; beyond S(0)/κ the sleeve lifts off."""
        pack, rate = self.pack, self.rate
        A, B, D = self._of_pack, self._across, self._of_balls
        alone, share = w / D, B / D
        stuck = (v + B * alone) / (A - B * share)
        # without the impulse by which the balls come to rest at the stop, as it does not act on the sleeve
        steady = alone - rate / D
        normal = clip(self.normal, *pack.play(steady + share * stuck))
        way = where(stuck < 0, -1.0, 1.0)
        before = pack.carried(self.normal, ratio)
        sticking = steady + share * way * before
        side = way * where(sticking < 0, -1.0, 1.0)
        rising, falling = (pack.slipping_at_stop(ratio, side * net, way * steady, share) for net in pack.stop_gains)
        low, high = pack.play(sticking)
        slipping = where(self.normal > high, rising, where(self.normal < low, falling, before))
        sticks = abs(stuck) <= pack.carried(normal, ratio)
        clutch = where(sticks, stuck, way * slipping)
        balls = alone + share * clutch
        lifted = abs(balls) > pack.lift
        slip = where(sticks, 0.0, v - A * clutch + B * balls)
        pressed = where(sticks, normal, slipping / pack.carried(1.0, ratio))
        resting = clutch, balls, slip, 0.0, pressed, 0.0, 0.0
        if not _any(lifted):
            return resting
        off = self._moving(v, w, where(balls < 0, -1.0, 1.0))(ratio)
        return tuple(where(lifted, one, other) for one, other in zip(off, resting, strict=True))

    @property
    def stored(self) -> Any:
        """Kinetic and elastic energy, J."""
        train, pack = self.train, self.pack
        hub = self.driven + self.rate
        energy = (
            train.motor_inertia * self.motor * self.motor
            + train.hub_inertia * hub * hub
            + train.driven_inertia * self.driven * self.driven
            + train.tool_inertia * self.tool * self.tool
            + self.elastic * self.elastic / train.stiffness
        ) / 2
        if pack.travels:
            travel = pack.travel(self.turn)
            energy = energy + pack.mass * pack.speed(travel, self.rate) ** 2 / 2 + pack.work(travel)
        return energy

    @property
    def left(self) -> Any:
        """Energy that is stored or has gone, less the motor's work, J: constant but for the error of the steps."""
        gone = self.heat + self.key_heat + self.shaft_heat + self.tool_work
        return self.stored + gone - self.motor_work

    @property
    def travel(self) -> Any:
        """Travel of the sleeve, m."""
        return self.pack.travel(self.turn) if self.pack.travels else self.turn
