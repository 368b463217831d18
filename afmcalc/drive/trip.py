"""One drive through an event: smooth phases between located switches, every peak an event of its own."""

import math
from collections.abc import Callable
from functools import cache, partial
from typing import NamedTuple

import numpy as np
from scipy.integrate import DOP853, OdeSolver, Radau
from scipy.optimize import brentq

from ..equations.arrays import finite
from ..errors import CalculationError
from .coast import Heating, stride
from .plant import DRIVEN, NORMAL, SIZE, TOOL, TURN, TWIST, WORKS, Guard, Mode, Plant, State, V
from .rest import Stuck, settled

TOLERANCE = 1e-9
MOST_STEPS = 40_000
"""Of an event: twice what a history of seconds takes of a drive that hardly damps."""
PATIENCE = 20_000
"""Steps after which a drive that does not settle is left, where no duration is given."""
QUIET = 1_000
"""Steps without slip or a higher peak after which nothing more comes of a standing drive that nothing feeds."""
_STEPS_A_PERIOD = 4
_REVERSED = 1e-9
"""Speed, relative to that before the event, with which something has turned back and is no rounding."""
_LOOK = 3.0
"""Swings of the driven half after which a slip may be taken in one stride: its peak has come."""
_UNSEEN = 1e-3
"""Swing, relative to the torque, that a history does not miss."""
_INSIDE = (0.25, 0.5, 0.75)
"""Points of a step that a history shows beside its ends."""
_TORQUES = 2
"""Torques whose peaks are located, before the guards in what is looked at."""
_NEAR = 1e-7
"""Part of a step within which a peak is located."""
_LOOKED_AT = tuple(2.0**-power for power in range(3, 31, 3))
"""Places in a step at which a guard that begins at 0 is looked for above it."""


class Moment(NamedTuple):
    """One row of a history."""

    time: float
    torque_shaft: float
    torque_clutch: float
    speed_motor: float
    speed_driven: float
    speed_tool: float
    travel: float


def trip(plant: Plant, horizon: float, *, recorded: bool = False, given: bool = False) -> "Trip":
    """Integrate an event until nothing more can come, or to the horizon; a history is run out to one ``given``.

    Raises:
        CalculationError: the integration fails.
    """
    event = Trip(plant, horizon, recorded=recorded, given=given)
    event.run()
    return event


class Trip:
    """One event, and what it did."""

    def __init__(self, plant: Plant, horizon: float, *, recorded: bool, given: bool) -> None:
        """Begin before the event; arguments as ``trip``."""
        self.plant, self.horizon, self.given, self.recorded = plant, horizon, given, recorded
        # what it did: torques in N·m, that of the balls over cos α (what their walls bear, times n r), travel in m
        self.peak = self.peak_clutch = self.peak_wall = self.travel_max = 0.0
        self.slip_time = 0.0
        self.heat = self.key_heat = 0.0
        """In the pack, and at the key, J."""
        self.key_heat_slipping = 0.0
        """At the key until the last slip ended, J: the drive that sticks swings on, and loses more there."""
        self.trip_torque: float | None = None
        """Of the clutch as it began to slip; None where it did not."""
        self.stuck = True
        """Whether the pack does not slip at the end."""
        self.ended = self.settled = self.endless = False
        """Whether the slip ended, as far as is known for good; nothing more can come; the motor drives it for ever."""
        self.last = 0.0
        """Torque of the clutch at the end, N·m."""
        self.state: State = []
        """States and work at the end."""
        self.time = 0.0
        """From which nothing more could come, s."""
        self.residual = 0.0
        """Error of the energy balance, relative to the largest energy in it."""
        self.course: list[Heating] = []
        """Of the slip, in order."""
        self.history: list[Moment] = []
        # how it goes on
        self._off = math.inf
        """When the motor is switched off."""
        self._stuck_since: float | None = 0.0
        self._gripped: float | None = 0.0
        """Since when the pack sticks, whatever the balls do."""
        self._looked = 0.0
        """When it was last seen that something may still come."""
        self._steps = self._quiet = 0
        """Steps taken, and those since the pack slipped or a peak rose."""
        self._look = math.inf
        """When to see whether the slip can be taken in one stride."""
        self._paces: dict[tuple[str, bool], float] = {}
        """Last step with the balls moving so, and the pack slipping or not: the next such phase begins with it."""
        self._swings = _LOOK * 2 * math.pi / plant.natural
        self._scales = np.array(plant.scales())

    def run(self) -> None:
        """Go through the phases; what they did, and whether the energy closes."""
        plant, t, y = self.plant, 0.0, self.plant.start()
        before = plant.stored(y)
        y, mode = plant.switched(t, [*y, *[0.0] * WORKS], Mode(over=not plant.train.time), None)
        self._note(t, y, mode)
        self._slips(t, y, mode)
        while True:
            t, y, mode = self._phase(t, y, mode)
            if t >= min(self.horizon, self._resting(mode)) or self._quiet > QUIET:
                self.settled, self._looked = self._settled(t, y, mode), t
            if t >= self.horizon or self.endless or (self.settled and not (self.given and self.recorded)):
                break
        motor, self.heat, shaft, tool, self.key_heat = y[SIZE:]
        left = before + motor - plant.stored(y) - self.heat - shaft - tool - self.key_heat
        self.residual = abs(left) / max(before, abs(motor), abs(tool), self.heat)
        self.history.sort(key=lambda row: row.time)
        self.stuck = mode.pack == 0
        self.ended = self.stuck and (self.settled or self.given or self.trip_torque is None)
        self.last, self.state, self.time = plant.torques(t, y, mode).clutch, y, t

    def _resting(self, mode: Mode) -> float:
        """When to see whether anything may still come: half a swing after it stuck, or was seen last.

        On a standing tool its torque then has had its top, or had it as it stuck; else after a whole one.
        """
        since = self._gripped if self._stuck_since is None else self._stuck_since
        if not mode.over or since is None:
            return math.inf
        share = 1.0 if self.plant.train.kind == "load" and mode.tool else 0.5
        return max(since, self.plant.train.time, self._looked) + share * self.plant.swing(mode)

    def _settled(self, t: float, y: State, mode: Mode) -> bool:
        """Whether nothing more can come."""
        plant = self.plant
        pending = mode.powered and self._off < math.inf
        if not mode.over or mode.pack or mode.tool < 0:
            return False
        fed = mode.powered and plant.train.engine.slip is not None
        if mode.tool == 0 and not pending and not fed and self._quiet > QUIET:
            return True
        if self._stuck_since is None:
            return False
        elastic, standing = plant.train.stiffness * y[TWIST], mode.tool == 0
        stuck = Stuck(plant.motor_speed(y), y[TOOL], elastic, standing, mode.powered, pending)
        return bool(settled(plant.train, stuck, plant.pack.sticks_up_to(y[TURN], y[NORMAL]), self.peak))

    def _phase(self, t: float, y: State, mode: Mode) -> tuple[float, State, Mode]:
        """Integrate to the next switch, and make it."""
        plant, train = self.plant, self.plant.train
        stage = math.inf if mode.over else train.time
        off = self._off if mode.powered else math.inf
        bound = min(self.horizon, stage, off, self._resting(mode))
        end, y, hit = self._integrate(t, y, mode, min(bound, self._look))
        if end == self._look < bound:
            if mode.over and not (mode.tool and train.kind == "load"):
                # a history keeps the swings that show
                largest, lasting = _UNSEEN if self.recorded else math.inf, self._off == math.inf and not self.given
                if far := stride(plant, end, y, mode, bound, lasting=lasting, largest=largest):
                    end, y, self.endless = far.time, far.y, far.endless
                    self.course += far.course
            self._look = end + self._swings
        self.slip_time += end - t if mode.pack else 0.0
        self._note(end, y, mode)
        if stage <= end and train.kind == "stop":
            y[TOOL] = 0.0
        staged = mode._replace(over=stage <= end or mode.over, powered=mode.powered and end < off)
        y, new = plant.switched(end, y, staged, hit)
        self._note(end, y, new)
        if (bool(new.pack), new.still) != (bool(mode.pack), mode.still):
            self._slips(end, y, new)
        return end, y, new

    def _slips(self, t: float, y: State, mode: Mode) -> None:
        """Take down that slip, or anything that moves, begins or ends."""
        self._stuck_since = t if mode.still else None
        if self._gripped is None and not mode.pack:
            self.key_heat_slipping = y[-1]
        if mode.pack or self._gripped is None:
            self._gripped = None if mode.pack else t
        self._look = t + self._swings if mode.pack else math.inf
        if mode.pack and self.trip_torque is None:
            self.trip_torque = abs(self.plant.torques(t, y, mode).clutch)
            cut_off = self.plant.train.cut_off
            self._off = math.inf if cut_off is None else t + float(cut_off)

    def _note(self, t: float, y: State, mode: Mode) -> None:
        """Take down torques and travel."""
        plant, travel, torques = self.plant, self.plant.travel(y), self.plant.torques(t, y, mode)
        if mode.pack or abs(torques.shaft) > self.peak:
            self._quiet = 0
        self.peak = max(self.peak, abs(torques.shaft))
        self.peak_clutch = max(self.peak_clutch, abs(torques.clutch))
        self.peak_wall = max(self.peak_wall, abs(torques.balls) * plant.pack.leaning(y[TURN]))
        self.travel_max = max(self.travel_max, travel)
        if mode.pack:
            self.course.append(Heating(t, torques.clutch, y[V], y[SIZE + 1]))
        if self.recorded:
            speeds = plant.motor_speed(y), y[DRIVEN], y[TOOL]
            self.history.append(Moment(t, torques.shaft, torques.clutch, *speeds, travel))

    def _integrate(self, t: float, y: State, mode: Mode, bound: float) -> tuple[float, State, Guard | None]:
        """Step until a guard falls to 0 or to the bound; which guard, None at the bound."""
        plant = self.plant
        longest = (plant.swing(mode) if mode.still else 2 * math.pi / plant.natural) / _STEPS_A_PERIOD
        # a swing of the balls may be one step, which is cut where they turn: what is between its ends is less exact
        tolerance = TOLERANCE / 100 if mode.moving else TOLERANCE
        kind = mode.balls, bool(mode.pack)
        first = min(self._paces.get(kind, 0.0), bound - t) if mode.moving else 0.0
        solver = (Radau if plant.stiff else DOP853)(
            lambda at, states: plant.rates(at, states.tolist(), mode),
            t,
            np.array([finite(each) for each in y]),
            bound,
            rtol=tolerance,
            atol=self._scales * tolerance,
            max_step=longest,
            first_step=first or None,
        )
        slopes = self._growth(t, y, mode, self._watched(t, y, mode), solver.f.tolist())
        while solver.status == "running":
            solver.step()
            self._patient(float(solver.t))
            if solver.status == "failed":
                raise CalculationError("simulate: the integration fails at t = {time:g} s", time=solver.t)
            self._paces[kind] = float(solver.t - solver.t_old)
            states = solver.y.tolist()
            now, before = self._watched(solver.t, states, mode), slopes
            slopes = self._growth(solver.t, states, mode, now, solver.f.tolist())
            # a torque had a peak where its growth changes sign, which matters if it may be the highest so far;
            # a guard that had a trough may have fallen below 0 there
            moments, highest = float(solver.t - solver.t_old) / plant.moment, (self.peak, self.peak_clutch)
            turned = []
            for number, (first, last) in enumerate(zip(before, slopes, strict=True)):
                reach = moments * max(abs(first), abs(last))
                if number < _TORQUES:
                    matters = self.recorded or abs(now[number]) + reach > highest[number]
                else:
                    matters = first < 0 and now[number] < reach
                if first * last < 0 and matters:
                    turned.append(number)
            if turned or min(now[_TORQUES:]) < 0 or self.recorded:
                crossed = self._inside(solver, mode, turned)
                if crossed is not None:
                    return crossed
            self._note(solver.t, states, mode)
            if self.horizon <= solver.t < bound:
                return self.horizon, states, None
        return bound, solver.y.tolist(), None

    def _patient(self, t: float) -> None:
        """Count a step; after too many the drive is left, or the duration given is refused."""
        self._steps += 1
        self._quiet += 1
        if not self.given and self._steps > PATIENCE:
            self.horizon = t
        if self._steps > MOST_STEPS:
            raise CalculationError(
                "simulate: at {time:.3g} s of {horizon:.3g} s {most:,} steps are taken: a shorter "
                "drive.event.duration, or inertias, stiffness and times that lie less far apart",
                time=t,
                horizon=self.horizon,
                most=MOST_STEPS,
            )

    def _watched(self, t: float, y: State, mode: Mode, guards: int | None = None) -> list[float]:
        """Torques of shaft and clutch, then guards, the first so many: of pack, tool, balls while something slips."""
        torques = self.plant.torques(t, y, mode)
        watched = [self.plant.guard(each, t, y, mode, torques) for each in self.plant.guards(mode)[:guards]]
        return [torques.shaft, torques.clutch, *watched]

    def _growth(self, t: float, y: State, mode: Mode, now: list[float], rates: State) -> list[float]:
        """By how much torques and first guards grow in a moment; 0 where rounding decides."""
        moment = self.plant.moment
        ahead = [state + moment * rate for state, rate in zip(y, rates, strict=True)]
        pairs = zip(now, self._watched(t + moment, ahead, mode, 3), strict=False)
        return [b - a if abs(b - a) > 1e-12 * abs(a) else 0.0 for a, b in pairs]

    def _inside(self, solver: OdeSolver, mode: Mode, turned: list[int]) -> tuple[float, State, Guard] | None:
        """Look into a step: note the peaks up to the first guard that falls to 0, and return that."""
        plant, dense, start, end = self.plant, solver.dense_output(), float(solver.t_old), float(solver.t)

        @cache
        def states(time: float) -> State:
            return dense(time).tolist()

        def watched(time: float) -> list[float]:
            return self._watched(time, states(time), mode)

        @cache
        def value(number: int, time: float) -> float:
            guard = plant.guards(mode)[number - _TORQUES]
            return plant.guard(guard, time, states(time), mode, plant.torques(time, states(time), mode))

        @cache
        def growth(time: float) -> list[float]:
            return self._growth(time, states(time), mode, watched(time), plant.rates(time, states(time), mode))

        def slope(number: int, time: float) -> float:
            return growth(time)[number]

        marks = []
        for number in turned:
            # the height where a slope changes sign has the square of its relative error
            mark, near = start, _NEAR * (end - start)
            if slope(number, start) * slope(number, end) < 0:
                mark = float(brentq(partial(slope, number), start, end, xtol=near))
            # what turns back and on again within a step has stood still in it; rounding has not
            if number < _TORQUES or value(number, mark) < -_REVERSED * plant.train.speed:
                marks.append(mark)
        if self.recorded:
            marks += [start + share * (end - start) for share in _INSIDE]
        for mark in [*sorted(marks), end]:
            guards = enumerate(watched(mark)[_TORQUES:], _TORQUES)
            fallen = [(_crossing(partial(value, number), start, mark), number) for number, at in guards if at < 0]
            if fallen:
                time, number = min(fallen)
                return time, states(time), plant.guards(mode)[number - _TORQUES]
            self._note(mark, states(mark), mode)
        return None


def _crossing(guard: Callable[[float], float], start: float, end: float) -> float:
    """Return where a guard that begins at 0 or above and ends below last falls to 0."""
    if not guard(start) > 0:
        ends = (start + share * (end - start) for share in _LOOKED_AT)
        above = next((each for each in ends if guard(each) > 0), None)
        if above is None:
            return start
        start = above
    return float(brentq(guard, start, end, xtol=1e-14, rtol=1e-14))
