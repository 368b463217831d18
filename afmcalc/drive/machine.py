"""The drive through an event: smooth phases between located switches, every peak an event of its own."""

import math
from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np
from scipy.integrate import DOP853, OdeSolver, Radau
from scipy.optimize import brentq

from ..arrays import finite
from ..errors import CalculationError
from ..messages import say
from ..progress import pulse
from .coast import creep, stride
from .plant import Mode, Plant, State, Torques
from .rest import Stuck, settled

TOLERANCE = 1e-9
MOST_SWITCHES = 20_000
MOST_STEPS = 40_000
"""Of an event: twice what a history of seconds takes of a drive that hardly damps."""
PATIENCE = 20_000
"""Steps after which a drive that does not settle is left, where no duration is given."""
_STEPS_A_PERIOD = 4
_WORKS = 5
"""Energies that are summed along with the states: of motor, pack, shaft, tool, key."""
_REVERSED = 1e-9
"""Speed, relative to that before the event, with which something has turned back and is no rounding."""
_LOOK = 3.0
"""Swings of the driven half after which a slip may be taken in one stride: its peak has come."""
_UNSEEN = 1e-3
"""Swing, relative to the torque, that a history does not miss."""
_INSIDE = (0.25, 0.5, 0.75)
"""Points of a step that a history shows beside its ends."""


class Heating(NamedTuple):
    """A moment of a slip."""

    time: float
    torque: float
    """Of the pack, N·m; of the sign of the slip."""
    slip: float
    """rad/s."""
    heat: float
    """In the pack so far, J."""


class Moment(NamedTuple):
    """One row of a history."""

    time: float
    torque_shaft: float
    torque_clutch: float
    speed_motor: float
    speed_driven: float
    speed_tool: float
    travel: float


class Trip(NamedTuple):
    """What an event did."""

    peak: float
    """In the shaft, N·m."""
    peak_clutch: float
    peak_wall: float
    """Of the balls over cos α, N·m: what their walls bear, times n r."""
    slip_time: float
    heat: float
    """In the pack, J."""
    key_heat: float
    travel_max: float
    trip_torque: float | None
    """Of the clutch as it began to slip; None where it did not."""
    stuck: bool
    """Whether the pack does not slip at the end."""
    ended: bool
    """Whether the slip ended, and as far as is known for good."""
    settled: bool
    """Whether nothing more can come."""
    endless: bool
    """Whether the motor drives it for ever."""
    last: float
    """Torque of the clutch at the end, N·m."""
    state: State
    """States and work at the end."""
    time: float
    """From which nothing more could come, s."""
    residual: float
    """Error of the energy balance, relative to the largest energy in it."""
    course: list[Heating]
    """Of the slip, in order."""
    history: list[Moment]


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


class _Run:
    """One event under way: what has been seen of it."""

    def __init__(self, plant: Plant, horizon: float, *, recorded: bool, given: bool) -> None:
        self.plant, self.horizon, self.given = plant, horizon, given
        self.history: list[Moment] | None = [] if recorded else None
        self.peak = self.peak_clutch = self.peak_wall = self.travel_max = self.slip_time = 0.0
        self.trip_torque: float | None = None
        self.off = math.inf
        """When the motor is switched off."""
        self.course: list[Heating] = []
        self.stuck_since: float | None = 0.0
        self.gripped: float | None = 0.0
        """Since when the pack sticks, whatever the balls do."""
        self.seen = 0.0
        """When it was last seen that something may still come."""
        self.endless = self.settled = False
        self.steps = 0
        self.look = math.inf
        """When to see whether the slip can be taken in one stride."""
        natural = math.sqrt(float(plant.train.stiffness / plant.train.driven_inertia))
        self.natural = natural
        self.swings = _LOOK * 2 * math.pi / natural
        self.moment = 1e-6 / natural
        """Time over which a slope is taken."""
        self.scales = np.array([*plant.scales(), *[plant.stored(plant.start())] * _WORKS])

    def trip(self) -> Trip:
        plant, t, recorded = self.plant, 0.0, self.history is not None
        y = plant.start()
        before = plant.stored(y)
        y, mode = plant.switched(t, [*y, *[0.0] * _WORKS], Mode(over=not plant.train.time), None)
        self._note(t, y, mode)
        self._slips(t, y, mode)
        for _ in range(MOST_SWITCHES):
            t, y, mode = self._phase(t, y, mode)
            if t >= min(self.horizon, self._resting(mode)):
                self.settled, self.seen = self._settled(t, y, mode), t
            if t >= self.horizon or self.endless or (self.settled and not (self.given and recorded)):
                break
        else:
            raise CalculationError(say("simulate: the drive sticks and slips without end"))
        motor, pack, shaft, tool, key = y[plant.size :]
        scale = max(before, abs(motor), abs(tool), pack)
        residual = abs(before + motor - plant.stored(y) - pack - shaft - tool - key) / scale
        history = sorted(self.history or [], key=lambda row: row.time)
        return Trip(
            self.peak,
            self.peak_clutch,
            self.peak_wall,
            self.slip_time,
            pack,
            key,
            self.travel_max,
            self.trip_torque,
            mode.pack == 0,
            mode.pack == 0 and (self.settled or self.given or self.trip_torque is None),
            self.settled,
            self.endless,
            plant.torques(t, y, mode).clutch,
            y,
            t,
            residual,
            self.course,
            history,
        )

    def _resting(self, mode: Mode) -> float:
        """When to see whether anything may still come: half a swing after it stuck, or was seen last.

        On a standing tool its torque then has had its top, or had it as it stuck; else after a whole one.
        """
        since = self.gripped if self.stuck_since is None else self.stuck_since
        if not mode.over or since is None:
            return math.inf
        share = 1.0 if self.plant.train.kind == "load" and mode.tool else 0.5
        return max(since, self.plant.train.time, self.seen) + share * self.plant.swing(mode)

    def _settled(self, t: float, y: State, mode: Mode) -> bool:
        """Whether nothing more can come."""
        plant = self.plant
        pending = mode.powered and self.off < math.inf
        if not mode.over or mode.pack or mode.tool < 0:
            return False
        if mode.tool == 0 and not pending and plant.swings_out(y, mode, self.peak):
            return True
        if self.stuck_since is None:
            return False
        elastic = plant.train.stiffness * y[plant.TWIST]
        speeds = plant.motor_speed(y), y[plant.TOOL]
        stuck = Stuck(*speeds, elastic, standing=mode.tool == 0, powered=mode.powered, pending=pending)
        return bool(settled(plant.train, stuck, plant.sticks_up_to(t, y, mode), self.peak))

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
        self.slip_time += end - t if mode.pack else 0.0
        self._note(end, y, mode)
        if stage <= end and train.kind == "stop":
            y[plant.TOOL] = 0.0
        staged = mode._replace(over=stage <= end or mode.over, powered=mode.powered and end < off)
        y, new = plant.switched(end, y, staged, hit)
        self._note(end, y, new)
        if (bool(new.pack), _still(new)) != (bool(mode.pack), _still(mode)):
            self._slips(end, y, new)
        return end, y, new

    def _stride(self, t: float, y: State, mode: Mode, bound: float) -> tuple[float, State]:
        """Take in one stride what is left of a steady slip; a history keeps the swings that show."""
        largest = _UNSEEN if self.history is not None else math.inf
        lasting = self.off == math.inf and not self.given
        found = stride(self.plant, t, y, mode, bound, lasting=lasting, largest=largest)
        found = found or creep(self.plant, t, y, mode, bound, lasting=lasting)
        if found is None:
            return t, y
        self.course += [Heating(*each) for each in found.course]
        self.endless = found.endless
        return found.time, found.y

    def _slips(self, t: float, y: State, mode: Mode) -> None:
        """Take down that slip, or anything that moves, begins or ends."""
        self.stuck_since = t if _still(mode) else None
        if mode.pack or self.gripped is None:
            self.gripped = None if mode.pack else t
        self.look = t + self.swings if mode.pack else math.inf
        if mode.pack and self.trip_torque is None:
            self.trip_torque = abs(self.plant.torques(t, y, mode).clutch)
            cut_off = self.plant.train.cut_off
            self.off = math.inf if cut_off is None else t + float(cut_off)

    def _note(self, t: float, y: State, mode: Mode, torques: Torques | None = None) -> None:
        """Take down torques and travel."""
        own, travel = self.plant, self.plant.travel(y)
        torques = own.torques(t, y, mode) if torques is None else torques
        self.peak = max(self.peak, abs(torques.shaft))
        self.peak_clutch = max(self.peak_clutch, abs(torques.clutch))
        self.peak_wall = max(self.peak_wall, abs(torques.balls) * math.hypot(1.0, own.leaning(y)))
        self.travel_max = max(self.travel_max, travel)
        if mode.pack:
            self.course.append(Heating(t, torques.clutch, y[own.V], y[own.size + 1]))
        if self.history is not None:
            speeds = own.motor_speed(y), y[own.DRIVEN], y[own.TOOL]
            self.history.append(Moment(t, torques.shaft, torques.clutch, *speeds, travel))

    def _integrate(self, t: float, y: State, mode: Mode, bound: float) -> tuple[float, State, int | None]:
        """Step until a guard falls to 0 or to the bound; which guard, None at the bound."""
        plant = self.plant
        method = Radau if plant.stiff else DOP853
        natural = 2 * math.pi / self.natural
        solver = method(
            lambda at, states: plant.rates(at, states.tolist(), mode),
            t,
            np.array([finite(each) for each in y]),
            bound,
            rtol=TOLERANCE,
            atol=self.scales * TOLERANCE,
            max_step=(self.plant.swing(mode) if _still(mode) else natural) / _STEPS_A_PERIOD,
        )
        slopes = growth(plant, t, y, mode, solver.f.tolist(), seen(plant, t, y, mode), self.moment)
        while solver.status == "running":
            solver.step()
            self._patient(float(solver.t))
            if solver.status == "failed":
                raise CalculationError(say("simulate: the integration fails at t = {time:g} s", time=solver.t))
            states = solver.y.tolist()
            now = seen(plant, solver.t, states, mode)
            before, slopes = slopes, growth(plant, solver.t, states, mode, solver.f.tolist(), now, self.moment)
            turned = turned_in(before, slopes)
            if turned or min(now.guards) < 0 or self.history is not None:
                crossed = self._inside(solver, mode, turned)
                if crossed is not None:
                    return crossed
            self._note(solver.t, states, mode, now.torques)
            if self.horizon <= solver.t < bound:
                return self.horizon, states, None
        return bound, solver.y.tolist(), None

    def _patient(self, t: float) -> None:
        """Count a step; after too many the drive is left, or the duration given is refused."""
        pulse()
        self.steps += 1
        if not self.given and self.steps > PATIENCE:
            self.horizon = t
        if self.steps > MOST_STEPS:
            raise CalculationError(
                say(
                    "simulate: at {time:.3g} s of {horizon:.3g} s {most:,} steps are taken: a shorter "
                    "drive.event.duration, or inertias, stiffness and times that lie less far apart",
                    time=t,
                    horizon=self.horizon,
                    most=MOST_STEPS,
                )
            )

    def _inside(self, solver: OdeSolver, mode: Mode, turned: list[int]) -> tuple[float, State, int] | None:
        """Look into a step: note the peaks up to the first guard that falls to 0, and return that."""
        plant, dense, start = self.plant, solver.dense_output(), float(solver.t_old)

        def at(time: float) -> State:
            states: State = dense(time).tolist()
            return states

        def slope(number: int, time: float) -> float:
            states = at(time)
            rates = plant.rates(time, states, mode)
            return growth(plant, time, states, mode, rates, seen(plant, time, states, mode), self.moment)[number]

        def guard(number: int, time: float) -> float:
            return seen(plant, time, at(time), mode).guards[number]

        marks = []
        for number in turned:
            mark = peak(partial(slope, number), start, solver.t)
            # what turns back and on again within a step has stood still in it; rounding has not
            if number < TORQUES or guard(number - TORQUES, mark) < -_REVERSED * plant.train.speed:
                marks.append(mark)
        if self.history is not None:
            marks += [start + share * (solver.t - start) for share in _INSIDE]
        for mark in [*sorted(marks), float(solver.t)]:
            states = at(mark)
            now = seen(plant, mark, states, mode)
            fallen = [i for i, value in enumerate(now.guards) if value < 0]
            if fallen:
                time, first = min((crossing(partial(guard, number), start, mark), number) for number in fallen)
                return time, at(time), first
            self._note(mark, states, mode, now.torques)
        return None


def _still(mode: Mode) -> bool:
    """Whether the drive before the shaft turns as one."""
    return not mode.pack and mode.balls in ("seat", "lock")


TORQUES = 2
"""Torques whose peaks are located, before the guards in what is looked at."""
_SLIPPING = 3
"""Guards that are speeds while something slips, the first ones: of pack, tool, balls."""
_NEAR = 1e-7
"""Part of a step within which a peak is located."""
_LOOKED_AT = (0.0, *(2.0**-power for power in range(30, 0, -3)))
"""Places in a step at which a guard that begins at 0 is looked for above it."""


class Seen(NamedTuple):
    """What is looked at in a moment of a mode."""

    torques: Torques
    guards: list[float]


def seen(plant: Plant, t: float, y: State, mode: Mode) -> Seen:
    """Look at a moment."""
    torques = plant.torques(t, y, mode)
    return Seen(torques, plant.guards(t, y, mode, torques))


def growth(plant: Plant, t: float, y: State, mode: Mode, rates: State, at: Seen, moment: float) -> list[float]:
    """By how much the torques of shaft and clutch and some guards grow in a moment; 0 where rounding decides."""
    ahead = [own + moment * rate for own, rate in zip(y, rates, strict=True)]
    now, then = (
        (own.torques.shaft, own.torques.clutch, *own.guards[:_SLIPPING])
        for own in (at, seen(plant, t + moment, ahead, mode))
    )
    return [b - a if abs(b - a) > 1e-12 * abs(a) else 0.0 for a, b in zip(now, then, strict=True)]


def turned_in(before: list[float], after: list[float]) -> list[int]:
    """Which torque had a peak in a step, and which guard a trough: it may have fallen below 0 there."""
    return [
        number
        for number, (first, last) in enumerate(zip(before, after, strict=True))
        if first * last < 0 and (number < TORQUES or first < 0)
    ]


def peak(slope: Callable[[float], float], start: float, end: float) -> float:
    """Return where a slope changes sign; the height there has the square of its relative error."""
    first = slope(start)
    return float(brentq(slope, start, end, xtol=_NEAR * (end - start))) if first * slope(end) < 0 else start


def crossing(guard: Callable[[float], float], start: float, end: float) -> float:
    """Return where a guard that begins at 0 or above and ends below last falls to 0."""
    ends = [start + share * (end - start) for share in _LOOKED_AT]
    above = [each for each in ends if guard(each) > 0]
    return float(brentq(guard, above[-1], end, xtol=1e-14, rtol=1e-14)) if above else start
