"""One drive through an event: smooth phases between located switches, every peak an event of its own."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import NamedTuple

import numpy as np
from scipy.integrate import DOP853, OdeSolver, Radau
from scipy.optimize import brentq

from ..arrays import finite
from ..errors import CalculationError
from ..progress import pulse
from .coast import Heating, creep, stride
from .plant import DRIVEN, NORMAL, SIZE, TOOL, TURN, TWIST, Guard, Mode, Plant, State, Torques, V
from .rest import Stuck, settled

TOLERANCE = 1e-9
MOST_SWITCHES = 20_000
MOST_STEPS = 40_000
"""Of an event: twice what a history of seconds takes of a drive that hardly damps."""
PATIENCE = 20_000
"""Steps after which a drive that does not settle is left, where no duration is given."""
QUIET = 2_000
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
_LOOKED_AT = tuple(2.0**-power for power in range(30, 0, -3))
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


@dataclass
class Trip:
    """What an event did."""

    peak: float = 0.0
    """In the shaft, N·m."""
    peak_clutch: float = 0.0
    peak_wall: float = 0.0
    """Of the balls over cos α, N·m: what their walls bear, times n r."""
    slip_time: float = 0.0
    heat: float = 0.0
    """In the pack, J."""
    key_heat: float = 0.0
    travel_max: float = 0.0
    trip_torque: float | None = None
    """Of the clutch as it began to slip; None where it did not."""
    stuck: bool = True
    """Whether the pack does not slip at the end."""
    ended: bool = False
    """Whether the slip ended, and as far as is known for good."""
    settled: bool = False
    """Whether nothing more can come."""
    endless: bool = False
    """Whether the motor drives it for ever."""
    last: float = 0.0
    """Torque of the clutch at the end, N·m."""
    state: State = field(default_factory=list)
    """States and work at the end."""
    time: float = 0.0
    """From which nothing more could come, s."""
    residual: float = 0.0
    """Error of the energy balance, relative to the largest energy in it."""
    course: list[Heating] = field(default_factory=list)
    """Of the slip, in order."""
    history: list[Moment] = field(default_factory=list)


def trip(plant: Plant, horizon: float, *, recorded: bool = False, given: bool = False) -> Trip:
    """Integrate an event until nothing more can come, or to the horizon.

    Args:
        plant: the drive.
        horizon: time that is simulated at most, s.
        recorded: whether to keep the history.
        given: whether the horizon is a duration asked for: a history is run out to it.

    Raises:
        CalculationError: the integration fails.
    """
    return _Run(plant, horizon, recorded=recorded, given=given).trip()


class _Seen(NamedTuple):
    """What is looked at in a moment of a mode."""

    torques: Torques
    guards: list[float]


class _Run:
    """One event under way."""

    def __init__(self, plant: Plant, horizon: float, *, recorded: bool, given: bool) -> None:
        self.plant, self.horizon, self.given, self.recorded = plant, horizon, given, recorded
        self.seen = Trip()
        """What has been seen of it."""
        self.off = math.inf
        """When the motor is switched off."""
        self.stuck_since: float | None = 0.0
        self.gripped: float | None = 0.0
        """Since when the pack sticks, whatever the balls do."""
        self.looked = 0.0
        """When it was last seen that something may still come."""
        self.steps = self.quiet = 0
        """Steps taken, and those since the pack slipped or a peak rose."""
        self.look = math.inf
        """When to see whether the slip can be taken in one stride."""
        self.swings = _LOOK * 2 * math.pi / plant.natural
        self.scales = np.array(plant.scales())

    def trip(self) -> Trip:
        """Go through the phases; what they did, and whether the energy closes."""
        plant, seen, t, y = self.plant, self.seen, 0.0, self.plant.start()
        before = plant.stored(y)
        y, mode = plant.switched(t, [*y, *[0.0] * (len(self.scales) - SIZE)], Mode(over=not plant.train.time), None)
        self._note(t, y, mode)
        self._slips(t, y, mode)
        for _ in range(MOST_SWITCHES):
            t, y, mode = self._phase(t, y, mode)
            if t >= min(self.horizon, self._resting(mode)):
                seen.settled, self.looked = self._settled(t, y, mode), t
            if t >= self.horizon or seen.endless or (seen.settled and not (self.given and self.recorded)):
                break
        else:
            raise CalculationError("simulate: the drive sticks and slips without end")
        motor, seen.heat, shaft, tool, seen.key_heat = y[SIZE:]
        left = before + motor - plant.stored(y) - seen.heat - shaft - tool - seen.key_heat
        seen.residual = abs(left) / max(before, abs(motor), abs(tool), seen.heat)
        seen.history.sort(key=lambda row: row.time)
        seen.stuck = mode.pack == 0
        seen.ended = seen.stuck and (seen.settled or self.given or seen.trip_torque is None)
        seen.last, seen.state, seen.time = plant.torques(t, y, mode).clutch, y, t
        return seen

    def _resting(self, mode: Mode) -> float:
        """When to see whether anything may still come: half a swing after it stuck, or was seen last.

        On a standing tool its torque then has had its top, or had it as it stuck; else after a whole one.
        """
        since = self.gripped if self.stuck_since is None else self.stuck_since
        if not mode.over or since is None:
            return math.inf
        share = 1.0 if self.plant.train.kind == "load" and mode.tool else 0.5
        return max(since, self.plant.train.time, self.looked) + share * self.plant.swing(mode)

    def _settled(self, t: float, y: State, mode: Mode) -> bool:
        """Whether nothing more can come."""
        plant, peak = self.plant, self.seen.peak
        pending = mode.powered and self.off < math.inf
        if not mode.over or mode.pack or mode.tool < 0:
            return False
        fed = mode.powered and plant.train.engine.slip is not None
        if mode.tool == 0 and not pending and not fed and (self.quiet > QUIET or plant.swings_out(y, mode, peak)):
            return True
        if self.stuck_since is None:
            return False
        elastic, standing = plant.train.stiffness * y[TWIST], mode.tool == 0
        stuck = Stuck(plant.motor_speed(y), y[TOOL], elastic, standing, mode.powered, pending)
        return bool(settled(plant.train, stuck, plant.pack.sticks_up_to(y[TURN], y[NORMAL]), peak))

    def _phase(self, t: float, y: State, mode: Mode) -> tuple[float, State, Mode]:
        """Integrate to the next switch, and make it."""
        plant, train = self.plant, self.plant.train
        stage = math.inf if mode.over else train.time
        off = self.off if mode.powered else math.inf
        bound = min(self.horizon, stage, off, self._resting(mode))
        end, y, hit = self._integrate(t, y, mode, min(bound, self.look))
        if end == self.look < bound:
            if mode.over and not (mode.tool and train.kind == "load"):
                end, y = self._stride(end, y, mode, bound)
            self.look = end + self.swings
        self.seen.slip_time += end - t if mode.pack else 0.0
        self._note(end, y, mode)
        if stage <= end and train.kind == "stop":
            y[TOOL] = 0.0
        staged = mode._replace(over=stage <= end or mode.over, powered=mode.powered and end < off)
        y, new = plant.switched(end, y, staged, hit)
        self._note(end, y, new)
        if (bool(new.pack), new.still) != (bool(mode.pack), mode.still):
            self._slips(end, y, new)
        return end, y, new

    def _stride(self, t: float, y: State, mode: Mode, bound: float) -> tuple[float, State]:
        """Take in one stride what is left of a steady slip; a history keeps the swings that show."""
        largest = _UNSEEN if self.recorded else math.inf
        lasting = self.off == math.inf and not self.given
        found = stride(self.plant, t, y, mode, bound, lasting=lasting, largest=largest)
        found = found or creep(self.plant, t, y, mode, bound, lasting=lasting)
        if found is None:
            return t, y
        self.seen.course += found.course
        self.seen.endless = found.endless
        return found.time, found.y

    def _slips(self, t: float, y: State, mode: Mode) -> None:
        """Take down that slip, or anything that moves, begins or ends."""
        self.stuck_since = t if mode.still else None
        if mode.pack or self.gripped is None:
            self.gripped = None if mode.pack else t
        self.look = t + self.swings if mode.pack else math.inf
        if mode.pack and self.seen.trip_torque is None:
            self.seen.trip_torque = abs(self.plant.torques(t, y, mode).clutch)
            cut_off = self.plant.train.cut_off
            self.off = math.inf if cut_off is None else t + float(cut_off)

    def _note(self, t: float, y: State, mode: Mode, torques: Torques | None = None) -> None:
        """Take down torques and travel."""
        plant, seen, travel = self.plant, self.seen, self.plant.travel(y)
        torques = plant.torques(t, y, mode) if torques is None else torques
        if mode.pack or abs(torques.shaft) > seen.peak:
            self.quiet = 0
        seen.peak = max(seen.peak, abs(torques.shaft))
        seen.peak_clutch = max(seen.peak_clutch, abs(torques.clutch))
        seen.peak_wall = max(seen.peak_wall, abs(torques.balls) * plant.pack.leaning(y[TURN]))
        seen.travel_max = max(seen.travel_max, travel)
        if mode.pack:
            seen.course.append(Heating(t, torques.clutch, y[V], y[SIZE + 1]))
        if self.recorded:
            speeds = plant.motor_speed(y), y[DRIVEN], y[TOOL]
            seen.history.append(Moment(t, torques.shaft, torques.clutch, *speeds, travel))

    def _integrate(self, t: float, y: State, mode: Mode, bound: float) -> tuple[float, State, Guard | None]:
        """Step until a guard falls to 0 or to the bound; which guard, None at the bound."""
        plant = self.plant
        longest = (plant.swing(mode) if mode.still else 2 * math.pi / plant.natural) / _STEPS_A_PERIOD
        # a swing of the balls may be one step, which is cut where they turn: what is between its ends is less exact
        tolerance = TOLERANCE / 100 if mode.moving else TOLERANCE
        solver = (Radau if plant.stiff else DOP853)(
            lambda at, states: plant.rates(at, states.tolist(), mode),
            t,
            np.array([finite(each) for each in y]),
            bound,
            rtol=tolerance,
            atol=self.scales * tolerance,
            max_step=longest,
        )
        which = range(_TORQUES + min(3, len(plant.guards(mode))))
        slopes = self._growth(t, y, mode, solver.f.tolist(), which)
        while solver.status == "running":
            solver.step()
            self._patient(float(solver.t))
            if solver.status == "failed":
                raise CalculationError("simulate: the integration fails at t = {time:g} s", time=solver.t)
            states = solver.y.tolist()
            now = self._look_at(solver.t, states, mode)
            before, slopes = slopes, self._growth(solver.t, states, mode, solver.f.tolist(), which)
            # a torque had a peak where its growth changes sign; a guard that had a trough may have fallen below 0 there
            turned = [
                number
                for number, (first, last) in enumerate(zip(before, slopes, strict=True))
                if first * last < 0
                and (self._rises(number, now, solver, first, last) if number < _TORQUES else first < 0)
            ]
            if turned or min(now.guards) < 0 or self.recorded:
                crossed = self._inside(solver, mode, turned)
                if crossed is not None:
                    return crossed
            self._note(solver.t, states, mode, now.torques)
            if self.horizon <= solver.t < bound:
                return self.horizon, states, None
        return bound, solver.y.tolist(), None

    def _rises(self, number: int, now: _Seen, solver: OdeSolver, *growths: float) -> bool:
        """Whether a peak of the torque of shaft or clutch in the last step may be the highest so far."""
        torque, highest = (
            (now.torques.shaft, self.seen.peak) if number == 0 else (now.torques.clutch, self.seen.peak_clutch)
        )
        reach = max(map(abs, growths)) / self.plant.moment * float(solver.t - solver.t_old)
        return self.recorded or abs(torque) + reach > highest

    def _patient(self, t: float) -> None:
        """Count a step; after too many the drive is left, or the duration given is refused."""
        pulse()
        self.steps += 1
        self.quiet += 1
        if not self.given and self.steps > PATIENCE:
            self.horizon = t
        if self.steps > MOST_STEPS:
            raise CalculationError(
                "simulate: at {time:.3g} s of {horizon:.3g} s {most:,} steps are taken: a shorter "
                "drive.event.duration, or inertias, stiffness and times that lie less far apart",
                time=t,
                horizon=self.horizon,
                most=MOST_STEPS,
            )

    def _look_at(self, t: float, y: State, mode: Mode) -> _Seen:
        torques = self.plant.torques(t, y, mode)
        return _Seen(torques, [self.plant.guard(each, t, y, mode, torques) for each in self.plant.guards(mode)])

    def _watched(self, t: float, y: State, mode: Mode, which: Sequence[int]) -> list[float]:
        """Torques of shaft and clutch, then guards that are speeds while something slips: of pack, tool, balls."""
        torques, guards = self.plant.torques(t, y, mode), self.plant.guards(mode)
        own = torques.shaft, torques.clutch
        return [
            own[number] if number < _TORQUES else self.plant.guard(guards[number - _TORQUES], t, y, mode, torques)
            for number in which
        ]

    def _growth(self, t: float, y: State, mode: Mode, rates: State, which: Sequence[int]) -> list[float]:
        """By how much what is watched grows in a moment; 0 where rounding decides."""
        moment = self.plant.moment
        ahead = [own + moment * rate for own, rate in zip(y, rates, strict=True)]
        pairs = zip(self._watched(t, y, mode, which), self._watched(t + moment, ahead, mode, which), strict=True)
        return [b - a if abs(b - a) > 1e-12 * abs(a) else 0.0 for a, b in pairs]

    def _inside(self, solver: OdeSolver, mode: Mode, turned: list[int]) -> tuple[float, State, Guard] | None:
        """Look into a step: note the peaks up to the first guard that falls to 0, and return that."""
        plant, dense, start = self.plant, solver.dense_output(), float(solver.t_old)
        guards = plant.guards(mode)

        def at(time: float) -> State:
            states: State = dense(time).tolist()
            return states

        def slope(number: int, time: float) -> float:
            states = at(time)
            return self._growth(time, states, mode, plant.rates(time, states, mode), (number,))[0]

        def guard(number: int, time: float) -> float:
            states = at(time)
            return plant.guard(guards[number], time, states, mode, plant.torques(time, states, mode))

        marks = []
        for number in turned:
            mark = _peak(partial(slope, number), start, solver.t)
            # what turns back and on again within a step has stood still in it; rounding has not
            if number < _TORQUES or guard(number - _TORQUES, mark) < -_REVERSED * plant.train.speed:
                marks.append(mark)
        if self.recorded:
            marks += [start + share * (solver.t - start) for share in _INSIDE]
        for mark in [*sorted(marks), float(solver.t)]:
            states = at(mark)
            now = self._look_at(mark, states, mode)
            fallen = [number for number, value in enumerate(now.guards) if value < 0]
            if fallen:
                time, first = min((_crossing(partial(guard, number), start, mark), number) for number in fallen)
                return time, at(time), guards[first]
            self._note(mark, states, mode, now.torques)
        return None


def _peak(slope: Callable[[float], float], start: float, end: float) -> float:
    """Return where a slope changes sign; the height there has the square of its relative error."""
    first = slope(start)
    return float(brentq(slope, start, end, xtol=_NEAR * (end - start))) if first * slope(end) < 0 else start


def _crossing(guard: Callable[[float], float], start: float, end: float) -> float:
    """Return where a guard that begins at 0 or above and ends below last falls to 0."""
    if not guard(start) > 0:
        ends = (start + share * (end - start) for share in _LOOKED_AT)
        above = [each for each in ends if guard(each) > 0]
        if not above:
            return start
        start = above[-1]
    return float(brentq(guard, start, end, xtol=1e-14, rtol=1e-14))
