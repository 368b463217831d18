"""The drive through an event: smooth phases between located switches, every peak an event of its own."""

import math
from functools import partial
from typing import NamedTuple

import numpy as np
from scipy.integrate import DOP853, OdeSolver, Radau

from ...arrays import finite
from ...errors import CalculationError
from ...messages import say
from .coast import stride
from .plant import Mode, Plant, State
from .roots import TORQUES, crossing, root, turned_in

TOLERANCE = 1e-9
MOST_SWITCHES = 20_000
MOST_STEPS = 40_000
"""Of an event: twice what a history of seconds takes of a drive that hardly damps."""
_STEPS_A_PERIOD = 4
_WORKS = 5
"""Energies that are summed along with the states: of motor, pack, shaft, tool, key."""
_SLIPPING = 3
"""Guards that are speeds while something slips, the first ones: of pack, tool, balls."""
_REVERSED = 1e-9
"""Speed, relative to that before the event, with which something has turned back and is no rounding."""
_LOOK = 3.0
"""Swings of the driven half after which a slip may be taken in one stride: its peak has come."""
_UNSEEN = 1e-3
"""Swing, relative to the torque, that a history does not miss."""
_INSIDE = (0.25, 0.5, 0.75)
"""Points of a step that a history shows beside its ends."""


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
    slip_time: float
    heat: float
    """In the pack, J."""
    key_heat: float
    travel_max: float
    trip_torque: float | None
    """Of the clutch as it began to slip; None where it did not."""
    ended: bool
    """Whether the slip ended."""
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
    history: list[Moment]


def trip(plant: Plant, horizon: float, *, recorded: bool = False) -> Trip:
    """Integrate an event until nothing more can come, or to the horizon.

    Args:
        plant: the drive.
        horizon: time that is simulated at most, s.
        recorded: whether to keep the history.

    Raises:
        CalculationError: the integration fails.
    """
    return _Run(plant, horizon, recorded=recorded).trip()


class _Run:
    """One event under way: what has been seen of it."""

    def __init__(self, plant: Plant, horizon: float, *, recorded: bool) -> None:
        self.plant, self.horizon = plant, horizon
        self.history: list[Moment] | None = [] if recorded else None
        self.peak = self.peak_clutch = self.travel_max = self.slip_time = 0.0
        self.trip_torque: float | None = None
        self.off = math.inf
        """When the motor is switched off."""
        self.stuck_since: float | None = 0.0
        self.endless = False
        self.steps = 0
        self.look = math.inf
        """When to see whether the slip can be taken in one stride."""
        natural = math.sqrt(float(plant.train.stiffness / plant.train.driven_inertia))
        self.longest_step = 2 * math.pi / natural / _STEPS_A_PERIOD
        self.swings = _LOOK * 2 * math.pi / natural
        self.moment = 1e-6 / natural
        """Time over which a slope is taken."""
        self.scales = np.array([*plant.scales(), *[plant.stored(plant.start())] * _WORKS])

    def trip(self) -> Trip:
        plant, t = self.plant, 0.0
        y = plant.start()
        before = plant.stored(y)
        y, mode = plant.switched(t, [*y, *[0.0] * _WORKS], Mode(over=not plant.train.time), None)
        self._note(t, y, mode)
        self._slips(t, y, mode)
        for _ in range(MOST_SWITCHES):
            t, y, mode = self._phase(t, y, mode)
            if t >= self.horizon or t >= self._quiet(mode) or self.endless:
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
            self.slip_time,
            pack,
            key,
            self.travel_max,
            self.trip_torque,
            mode.pack == 0,
            self.endless,
            plant.torques(t, y, mode).clutch,
            y,
            t,
            residual,
            history,
        )

    def _quiet(self, mode: Mode) -> float:
        """When it has stuck for so long after the event that nothing more can come.

        On a standing tool half a swing: its torque then has had its top, or had it as it stuck. Else a whole one,
        unless the motor pulls harder as its speed falls.
        """
        train = self.plant.train
        slowing = train.kind == "load" and mode.tool and train.engine.slip is not None
        if not mode.over or self.stuck_since is None or slowing:
            return math.inf
        inertia = train.motor_inertia + train.hub_inertia + train.driven_inertia
        share = 0.5
        if train.kind == "load" and mode.tool:
            inertia, share = inertia * train.tool_inertia / (inertia + train.tool_inertia), 1.0
        swing = 2 * math.pi * math.sqrt(inertia / train.stiffness)
        return max(self.stuck_since, train.time) + share * swing

    def _phase(self, t: float, y: State, mode: Mode) -> tuple[float, State, Mode]:
        """Integrate to the next switch, and make it."""
        plant, train = self.plant, self.plant.train
        stage = math.inf if mode.over else train.time
        off = self.off if mode.powered else math.inf
        bound = min(self.horizon, stage, off, self._quiet(mode))
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
        found = stride(self.plant, t, y, mode, bound, lasting=self.off == math.inf, largest=largest)
        if found is None:
            return t, y
        self.endless = found.endless
        return found.time, found.y

    def _slips(self, t: float, y: State, mode: Mode) -> None:
        """Take down that slip, or anything that moves, begins or ends."""
        self.stuck_since = t if _still(mode) else None
        self.look = t + self.swings if mode.pack else math.inf
        if mode.pack and self.trip_torque is None:
            self.trip_torque = abs(self.plant.torques(t, y, mode).clutch)
            cut_off = self.plant.train.cut_off
            self.off = math.inf if cut_off is None else t + float(cut_off)

    def _note(self, t: float, y: State, mode: Mode) -> None:
        """Take down torques and travel."""
        own, torques = self.plant, self.plant.torques(t, y, mode)
        travel = own.travel(y)
        self.peak = max(self.peak, abs(torques.shaft))
        self.peak_clutch = max(self.peak_clutch, abs(torques.clutch))
        self.travel_max = max(self.travel_max, travel)
        if self.history is not None:
            speeds = own.motor_speed(y), y[own.DRIVEN], y[own.TOOL]
            self.history.append(Moment(t, torques.shaft, torques.clutch, *speeds, travel))

    def _integrate(self, t: float, y: State, mode: Mode, bound: float) -> tuple[float, State, int | None]:
        """Step until a guard falls to 0 or to the bound; which guard, None at the bound."""
        plant = self.plant
        method = Radau if plant.stiff else DOP853
        solver = method(
            lambda at, states: plant.rates(at, states.tolist(), mode),
            t,
            np.array([finite(each) for each in y]),
            bound,
            rtol=TOLERANCE,
            atol=self.scales * TOLERANCE,
            max_step=self.longest_step,
        )
        slopes = self._slopes(t, y, mode)
        while solver.status == "running":
            solver.step()
            self.steps += 1
            if self.steps > MOST_STEPS:
                raise CalculationError(
                    say(
                        "simulate: at {time:.3g} s of {horizon:.3g} s {most:,} steps are taken: a shorter "
                        "drive.event.duration, or inertias, stiffness and times that lie less far apart",
                        time=solver.t,
                        horizon=self.horizon,
                        most=MOST_STEPS,
                    )
                )
            if solver.status == "failed":
                raise CalculationError(say("simulate: the integration fails at t = {time:g} s", time=solver.t))
            states = solver.y.tolist()
            before, slopes = slopes, self._slopes(solver.t, states, mode)
            turned = turned_in(before, slopes)
            fallen = min(plant.guards(solver.t, states, mode)) < 0
            if turned or fallen or self.history is not None:
                crossed = self._inside(solver, mode, turned)
                if crossed is not None:
                    return crossed
            self._note(solver.t, states, mode)
        return bound, solver.y.tolist(), None

    def _inside(self, solver: OdeSolver, mode: Mode, turned: list[int]) -> tuple[float, State, int] | None:
        """Look into a step: note the peaks up to the first guard that falls to 0, and return that."""
        plant, dense, start = self.plant, solver.dense_output(), float(solver.t_old)

        def at(time: float) -> State:
            states: State = dense(time).tolist()
            return states

        def slope(number: int, time: float) -> float:
            return self._slopes(time, at(time), mode)[number]

        def guard(number: int, time: float) -> float:
            return plant.guards(time, at(time), mode)[number]

        marks = []
        for number in turned:
            mark = root(partial(slope, number), start, solver.t)
            # what turns back and on again within a step has stood still in it; rounding has not
            if number < TORQUES or guard(number - TORQUES, mark) < -_REVERSED * plant.train.speed:
                marks.append(mark)
        if self.history is not None:
            marks += [start + share * (solver.t - start) for share in _INSIDE]
        for mark in [*sorted(marks), float(solver.t)]:
            states = at(mark)
            fallen = [i for i, value in enumerate(plant.guards(mark, states, mode)) if value < 0]
            if fallen:
                time, first = min((crossing(partial(guard, number), start, mark), number) for number in fallen)
                return time, at(time), first
            self._note(mark, states, mode)
        return None

    def _slopes(self, t: float, y: State, mode: Mode) -> list[float]:
        """By how much the torques of shaft and clutch and some guards grow in a moment; 0 where rounding decides."""
        plant = self.plant
        ahead = [own + self.moment * rate for own, rate in zip(y, plant.rates(t, y, mode), strict=True)]
        now, then = (
            (own.shaft, own.clutch, *plant.guards(at, states, mode)[:_SLIPPING])
            for at, states, own in (
                (at, states, plant.torques(at, states, mode)) for at, states in ((t, y), (t + self.moment, ahead))
            )
        )
        return [b - a if abs(b - a) > 1e-12 * abs(a) else 0.0 for a, b in zip(now, then, strict=True)]


def _still(mode: Mode) -> bool:
    """Whether the drive before the shaft turns as one."""
    return not mode.pack and mode.balls in ("seat", "lock")
