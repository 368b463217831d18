"""Simulation of an event by time steps until nothing more can happen: one drive as numbers, or many as arrays."""

import math
import operator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..equations import drive
from ..equations import heat as law
from ..equations.arrays import Floats, Values, is_array, larger
from ..errors import CalculationError
from ..messages import say
from ..progress import tell
from .bounds import settled, slips_below
from .motion import Many, Motion, clip, cut, where
from .pack_and_sleeve import DirectPack, Sleeve
from .train import Train

STEPS_A_SWING = 150
"""Time steps per swing of the driven half on its shaft."""
_BALLS = 30
"""Time steps per swing of the balls on their springs."""
_LAG = 8
"""Time steps per lag of the release force."""
_FINEST = 4
"""Largest factor by which balls or lag shorten a step: a sleeve nearly locked by its feather key hardly moves."""
_RINGING = 1 / 16
"""Smallest share of a swing of the balls that the feather key is assumed to dissipate when the step is chosen."""
_STEADY = 3
"""Largest factor by which a step is lengthened while the clutch slips throughout the swings of the shaft."""
_BLOCK = 64
"""Number of steps between two tests of what may still happen."""
_PLACES = slice(0, -2), slice(1, -1), slice(2, None)
"""Slices of a block of steps: for each step the moment two steps earlier, the moment before it and its own end."""
MOST_STEPS = 100_000
"""Largest number of steps of an event; a longer event ends before it has settled."""
_LANES = 1024
"""Number of drives stepped at a time, each with two step sizes: their states fit in the processor's cache."""
_FEW: dict[type, int] = {DirectPack: 8, Sleeve: 14}
"""Largest number of drives that are stepped faster one by one, as numbers, than together as arrays."""
CLOSE = 2e-3
"""Relative error of the peak up to which a step is fine enough."""
CLOSE_CLUTCH = 3e-3
"""Relative error of the clutch's peak up to which a step is fine enough; the clutch torque jumps as slip ends."""
SPREAD = 0.01
"""Relative error of heat or slip time above which the event counts as ill-conditioned."""
CLOSED = 1e-3
"""Relative error of the energy balance above which there is an error finding."""
_QUIET = 1e-3
"""Torque amplitude of a swing, relative to the torque, below which the swing is neglected."""
_SILENT = 1e-9
"""Torque amplitude, relative to the torque, below which a swing that may grow again is neglected."""
_CARRIES = 1e-6
"""Share of the slip torque by which the motor may fall short and still count as never stopping."""
_SWINGS = 6.0
"""Number of swings of the driven half after the event within which the peak occurs."""
_LONG = 20.0
"""Longest slip, over the run-down time at T(f): motor and load may nearly balance the slipping clutch, and the feather
key may hold the sleeve far off its stop."""


class Row(NamedTuple):
    """One moment of an event; torques in N·m, speeds in rad/s."""

    time: float
    torque_shaft: float
    torque_clutch: float
    speed_motor: float
    speed_driven: float
    speed_tool: float
    travel: float
    slip: float
    heat: float
    """Heat in the pack up to this moment, J."""


class Event(NamedTuple):
    """Results of an event for a drive, or for many; torques in N·m."""

    peak: Any
    peak_clutch: Any
    peak_wall: Any
    """Largest torque of the balls over cos α: force on a wall times number of balls and radius of their circle."""
    travel_max: Any
    slip_time: Any
    heat: Any
    key_heat: Any
    """Heat at the feather key until the last slip ended, J; the swings of the stuck drive afterwards do not count."""
    trip_torque: Any
    """Torque of the clutch as it begins to slip; 0 if it does not slip."""
    residual: Any
    """Error of the energy balance, relative to the largest energy in it."""
    time: Any
    """End of the simulation, s."""
    last: Any
    """Torque of the clutch at the end."""
    stuck: Any
    """True if the pack does not slip at the end."""
    passed: Any
    """True if no later torque of the shaft exceeds the peak."""
    settled: Any
    """True if the clutch sticks for ever and the peak has passed."""
    ended: Any
    """True if the slip has ended for ever, or at least at the end of the given duration."""
    pulled: Any
    """Torque of the slipping pack as the motor was switched off; 0 if it did not slip then."""
    rows: Any = None
    """Every step, a tuple of ``Row``s; None if the event was simulated only to its peak."""
    peak_error: Any = 0.0
    clutch_error: Any = 0.0
    time_error: Any = 0.0
    heat_error: Any = 0.0
    """Relative changes of shaft peak, clutch peak, slip time and heat, compared with a run at twice the step."""


def simulate(
    train: Train, pack: DirectPack | Sleeve, duration: float | None = None, *, whole: bool = True, full: bool = False
) -> Event:
    """Simulate events until nothing more can happen, or with ``whole=False`` until their peak has passed.

    The step is halved until twice the step changes the peak by 0.2 % at most, and in whole events the peak at the
    clutch by 0.3 %; it is halved at most three times, and not for long events.

    Args:
        train: drive, or drives as arrays.
        pack: clutch at one friction, or clutches; shapes broadcast.
        duration: end of the event, s; None: until nothing more can happen.
        whole: step on to the end of the slip.
        full: step on to the end of a given duration, even if nothing more can happen.

    Raises CalculationError if the duration has too many steps.
    """
    shape = np.broadcast_shapes(*shapes(train), *shapes(pack), np.shape(0.0 if duration is None else duration))
    h, end = step_of(train, pack), horizon(train, pack) if duration is None else duration
    until = {"given": duration is not None, "whole": whole, "full": full}
    if duration is not None:
        steps = np.ceil(end / (h * 2 * _BLOCK)) * 2 * _BLOCK
        if (needed := float(np.max(steps))) > MOST_STEPS:
            raise CalculationError(
                "simulate: {steps:.4g} time steps are needed, at most {most} are made: a shorter drive.event.duration, "
                "or inertias, stiffness and times that lie less far apart", steps=needed, most=MOST_STEPS,
            )  # fmt: skip
        h = end / steps
    h, end = (np.broadcast_to(value, shape).reshape(-1) for value in (h, end))
    parts = []
    for first in range(0, h.size, _LANES):
        lanes = slice(first, first + _LANES)
        parts.append(_refined(cut(train, lanes, shape), cut(pack, lanes, shape), h[lanes], end[lanes], until))
        if shape:
            tell(say("stepping the drives"), min(first + _LANES, h.size), h.size)
    joined = [np.concatenate(each).reshape(shape) for each in zip(*parts, strict=True)]
    return Event(*(joined if shape else (figure.item() for figure in joined)))


def _refined(train: Train, pack: Any, h: Floats, end: Floats, until: dict[str, Any]) -> Event:
    """Events simulated with steps halved until their peaks are accurate enough."""
    both = np.arange(2 * h.size) % h.size
    motion = Motion(cut(train, both), cut(pack, both), np.append(2 * h, h))
    columns = [column.reshape(2, -1) for column in stepped(motion, end[both], **until)]
    fine = _compared(*(Event(*(column[half] for column in columns)) for half in (1, 0)))
    for _ in range(3):
        rough = fine.peak_error > CLOSE
        open_ = rough | (until["whole"] & (fine.clutch_error > CLOSE_CLUTCH))
        lanes = np.flatnonzero(open_ & (fine.time < h * MOST_STEPS / 2))
        if not lanes.size:
            break
        h, before = h / 2, Event(*(part[lanes] for part in fine))
        motion = Motion(cut(train, lanes), cut(pack, lanes), h[lanes])
        finer = _compared(stepped(motion, end[lanes], **until), before)
        # take the finer result only where the peak was rough, so that whole events and events up to the peak agree
        enough = ~rough[lanes]
        finer.peak[enough], finer.peak_error[enough] = before.peak[enough], before.peak_error[enough]
        for part, new in zip(fine, finer, strict=True):
            part[lanes] = new
    return fine


def _compared(fine: Event, coarse: Event) -> Event:
    """Event ``fine`` with its errors: relative differences of ``coarse``, with twice the step; absolute ones from 0."""
    names = {"peak_error": "peak", "clutch_error": "peak_clutch", "time_error": "slip_time", "heat_error": "heat"}
    errors = {}
    for error, name in names.items():
        own, other = getattr(fine, name), getattr(coarse, name)
        errors[error] = abs(own - other) / np.where(own == 0, 1.0, own)
    return fine._replace(**errors)


def step_of(train: Train, pack: DirectPack | Sleeve) -> Values:
    """Finest time step, s, by the swings of the driven half, the swings of the balls, and the lag."""
    fastest = (train.stiffness / train.driven_inertia) ** 0.5
    step: Values = 2 * np.pi / (fastest * STEPS_A_SWING)
    if isinstance(pack, Sleeve):
        stiffness = pack.torsional(0.0, pack.stop_gain, pack.net_gain, pack.lift)
        stiffness = np.maximum(stiffness, 1e-3 * train.stiffness)  # a wall may make it 0
        swinging = (stiffness * (1 / train.hub_inertia + 1 / train.driven_inertia)) ** 0.5
        lost = np.maximum(1 - pack.net_gain / pack.net_gain_returning, _RINGING)
        step = np.clip(2 * np.pi / (swinging * _BALLS), step * lost / _FINEST, step)
    elif np.any(pack.lag):
        step = np.where(np.asarray(pack.lag) > 0, np.clip(pack.lag / _LAG, step / _FINEST, step), step)
    return step


_HISTORY = ("time", "torque", "clutch", "motor", "driven", "tool", "turn", "slip", "heat")
_MOMENT = (*_HISTORY, "key_heat", "top", "balls", "normal")
_moment = operator.attrgetter(*_MOMENT)


class _Watch(Many):
    """Peaks and times of one event or many, evaluated after every block of steps."""

    def __init__(self, motion: Motion, *, recorded: bool) -> None:
        zero, train = np.asarray(motion.h * 0.0), motion.train
        self.peak = zero + train.load
        self.travel_max = zero + motion.pack.travel(motion.turn)
        self.peak_clutch = self.peak_wall = self.slip_time = self.trip_torque = self.key_heat = self.pulled = zero
        self.most = zero + motion.stored
        self.off: Any = motion.h * 0.0 + math.inf
        self.over: Any = zero != 0
        self.last = np.array([np.broadcast_arrays(zero, *_moment(motion))[1:]] * 2)
        """Values at the last two moments; shape (2, columns of ``_MOMENT``, drives)."""
        self.begun = motion.left
        self.history = [self.last[1:]] if recorded else None

    def block(self, motion: Motion) -> None:
        """Make the steps of one block of time, and update peaks and times."""
        cut_off, block = motion.train.cut_off, np.empty((2 + _BLOCK, *self.last.shape[1:]))
        block[:2] = self.last
        powered: Any = 1.0
        for place in range(2, 2 + _BLOCK):
            if cut_off is not None:
                powered = clip((self.off - motion.time) / motion.h, 0.0, 1.0)
            motion.step(powered)
            if cut_off is not None:
                begins = (motion.slip != 0) & (self.off == math.inf)
                self.off = where(begins, motion.time - motion.h + cut_off, self.off)
            for column, value in enumerate(_moment(motion)):
                block[place, column] = value
        if self.history is not None:
            self.history.append(block[2:])
        self.last = block[-2:]
        self._take(motion, block)
        self.most = np.maximum(self.most, motion.stored)

    def _take(self, motion: Motion, block: Floats) -> None:
        """Update peaks and times from a block of steps; its first two rows are the moments before it."""
        pack, moments = motion.pack, dict(zip(_MOMENT, np.moveaxis(block, 1, 0), strict=True))
        time, top, balls, turn = (moments[name][2:] for name in ("time", "top", "balls", "turn"))
        holding, held, clutch = (moments["clutch"][place] for place in _PLACES)
        slipping, slip, after = (moments["slip"][place] for place in _PLACES)
        slid, slides = slip != 0, after != 0
        # slip begins and ends within a step: found by extrapolating torque or slip to its limit
        rising, falling = held - holding, slipping - slip
        begun = 1 - np.clip((clutch - held) / np.where(rising == 0, np.inf, rising), 0.0, 1.0)
        left = np.clip(slip / np.where(falling == 0, np.inf, falling), 0.0, 1.0)
        share = np.where(slides, np.where(slid, 1.0, begun), np.where(slid, left, 0.0))
        self.slip_time = self.slip_time + motion.h * share.sum(axis=0)
        tripped = (self.trip_torque != 0) | np.logical_or.accumulate(slides)
        torque = np.maximum(abs(clutch), abs(held))
        self.trip_torque = _first(slides & (self.trip_torque == 0), torque, self.trip_torque)
        if motion.train.cut_off is not None:
            switched = (time >= self.off) & slides & (self.pulled == 0)
            self.pulled = _first(switched, abs(clutch), self.pulled)
        self.key_heat = _first((slides | slid | ~tripped)[::-1], moments["key_heat"][:1:-1], self.key_heat)
        highest = _tops(*(moments["torque"][place] for place in _PLACES)).max(axis=0)
        self.peak = np.where(self.over, self.peak, np.maximum(self.peak, highest))
        if motion.static:
            ends = slid & ~slides & (slip != falling)
            risen = self._ending(motion, moments["normal"][1:-1], abs(held), slip + falling / 2, left)
            top = np.maximum(top, np.where(ends, risen, 0.0))
        self.peak_clutch = np.maximum(self.peak_clutch, top.max(axis=0))
        self.peak_wall = np.maximum(self.peak_wall, (abs(balls) * pack.leaning(turn)).max(axis=0))
        self.travel_max = np.maximum(self.travel_max, pack.travel(abs(turn).max(axis=0)))

    def _ending(self, motion: Motion, normal: Floats, held: Floats, slip: Floats, left: Floats) -> Any:
        """Torque of the clutch as slip ends after the share ``left`` of a step, at static friction, N·m."""
        pack = motion.pack
        risen = held * pack.static_ratio / pack.ratio(slip)
        if pack.travels:
            return risen  # the feather key keeps the normal force constant meanwhile
        # a lag keeps the normal force partly; in other direct clutches the force falls as torque rises
        balance = pack.pressed_at_stop(risen, pack.stop_gains[0])
        late = pack.carried(balance + (normal - balance) * motion.half_lag ** (2 * left), pack.static_ratio)
        return np.where(pack.lag > motion.h, late, np.clip(risen, held, np.maximum(held, pack.breakaway)))

    def event(self, motion: Motion, still: Any, *, given: bool) -> Event:
        """Event up to now; ``still``: nothing more can happen; ``given``: the end of the duration ends the slip too."""
        size = larger(self.most, abs(motion.motor_work), abs(motion.tool_work), motion.heat)
        residual, stuck = abs(motion.left - self.begun) / size, motion.slip == 0
        return Event(
            self.peak, self.peak_clutch, self.peak_wall, self.travel_max, self.slip_time, motion.heat, self.key_heat,
            self.trip_torque, residual, motion.time, motion.clutch, stuck, self.over, still,
            stuck & (still | given | (self.trip_torque == 0)), self.pulled, self._rows(motion),
        )  # fmt: skip

    def _rows(self, motion: Motion) -> NDArray[np.object_]:
        """Rows of all steps, a tuple for each drive."""
        rows = np.empty(np.shape(motion.h), object)
        if self.history is not None:
            history = np.concatenate(self.history)[:, : len(_HISTORY)]
            turn = history[:, _HISTORY.index("turn")]
            turn[:] = motion.pack.travel(turn)
            for lane in np.ndindex(rows.shape):
                rows[lane] = tuple(map(Row._make, history[(..., *lane)].tolist()))
        return rows


def _first(condition: NDArray[np.bool_], values: Floats, otherwise: Any) -> Any:
    """Value at the first step at which a condition holds, for each drive; ``otherwise`` if it never does."""
    first = np.take_along_axis(values, condition.argmax(axis=0)[None], axis=0)[0]
    return np.where(condition.any(axis=0), first, otherwise)


def _tops(older: Floats, old: Floats, torque: Floats) -> Floats:
    """Largest torques of the shaft, at the vertices of parabolas through three moments."""
    sign = np.where(old < 0, -1.0, 1.0)
    a, b, c = sign * older, sign * old, sign * torque
    bent = 2 * b - a - c
    turned = (b >= a) & (b >= c) & (bent > 0)
    return np.where(turned, b + (c - a) * (c - a) / (8 * np.where(turned, bent, 1.0)), abs(torque))


def stepped(
    motion: Motion, end: Any, *, given: bool = True, whole: bool = True, full: bool = False, behind: Any = None
) -> Event:
    """Step one event or many events from a state; ended events are dropped, the last few are stepped as numbers.

    Args:
        motion: state, with the finest step.
        end: end of the simulation, s: the duration if ``given``, else the horizon.
        given: True if the event has a duration; ``whole`` and ``full`` as in ``simulate``.
        behind: watch with the peaks up to the state, the finest step, and the number of steps made.
    """
    watch, finest, count = behind or (_Watch(motion, recorded=whole), motion.h, 0)
    done, places, many = [], np.arange(np.size(finest)), is_array(finest)
    while not many or places.size > _FEW[type(motion.pack)]:
        watch.block(motion)
        count += _BLOCK
        powered = motion.time < watch.off
        pending = powered & (watch.off < math.inf)
        still = settled(motion, powered, pending, watch.peak)
        watch.over = watch.over | still | slips_below(motion, powered, watch.peak)
        last = (motion.time >= end * (1 - 1e-9)) | (count >= MOST_STEPS)
        last = last | (_lengthened(motion, watch, finest, end) & (not given))
        gone = last | (still & (not full) if whole else watch.over)
        if not many:
            if gone:
                return watch.event(motion, still, given=given)
        elif (part := np.flatnonzero(gone)).size:
            done.append((places[part], watch.lanes(part).event(motion.lanes(part), still[part], given=given)))
            kept = np.flatnonzero(~gone)
            motion, watch = motion.lanes(kept), watch.lanes(kept)
            places, end, finest = places[kept], end[kept], finest[kept]
    for lane, place in enumerate(places):
        state, before = motion.lanes(lane), (watch.lanes(lane), finest[lane].item(), count)
        found = stepped(state, end[lane].item(), given=given, whole=whole, full=full, behind=before)
        done.append((np.array([place]), found))
    order = np.argsort(np.concatenate([place for place, _ in done]))
    sizes, columns = [place.size for place, _ in done], zip(*(event for _, event in done), strict=True)
    return Event(*(np.concatenate(list(map(np.broadcast_to, column, sizes)))[order] for column in columns))


def _lengthened(motion: Motion, watch: _Watch, finest: Any, end: Any) -> Any:
    """Lengthen the step in a slow slip without swings; return flags: the motor keeps the clutch slipping for ever.

    The step is limited so that slip and speed of the tool fall by half at most until the next test.
    """
    train, pack, slip = motion.train, motion.pack, abs(motion.slip)
    impedance = (train.stiffness * train.driven_inertia) ** 0.5
    motor = train.engine.at(motion.motor) * (motion.time < watch.off)
    rest, slowing = motion.clutch, np.abs(motor - motion.clutch) / train.motor_inertia
    lasting = slip
    if motion.turning_tool:
        behind = train.driven_inertia + train.hub_inertia
        rest = drive.sticking_torque(motion.clutch, behind, motion.resisting, train.tool_inertia)
        slowing = np.maximum(slowing, np.abs(rest - motion.resisting) / train.tool_inertia)
        lasting = np.where(motion.tool == 0, slip, np.minimum(slip, motion.tool))
    swing = np.hypot(motion.torque - rest, motion.twisting * impedance)
    decay = pack.decay_rate * (np.asarray(pack.static_ratio) > 1)
    # where friction falls with speed faster than the shaft damps, any small swing finally grows to judder
    juddering = pack.judder(0.0) > train.damping
    still = swing < np.where(juddering, _SILENT, _QUIET) * abs(motion.clutch)
    # a slip faster than the swings goes on through them
    faster = swing < slip / 8 * impedance
    if not pack.travels:
        # the torque of slipping discs does not depend on the shaft torque: swings of the shaft do not matter
        still = still | watch.over & ~juddering & (np.asarray(pack.lag) == 0) & faster
    slides = (motion.time > train.time) & (motion.rate == 0) & (motion.slip > 0)
    quiet, steady = slides & still & (pack.judder(slip) <= train.damping), slides & faster
    with np.errstate(all="ignore"):
        long = np.minimum(lasting, 6.4 / decay) / (4 * _BLOCK * slowing)
        left = np.maximum(end - motion.time, 0.0) / _BLOCK
        if train.engine.slip is not None:
            stalling = train.motor_inertia * train.engine.slip * train.engine.synchronous / train.engine.torque
            left = np.minimum(left, 0.1 * stalling)
        if train.cut_off is not None:
            left = np.minimum(left, np.where(motion.time < watch.off, (watch.off - motion.time) / _BLOCK, np.inf))
    longest = np.maximum(np.minimum(np.minimum(long, left), 2 * motion.h), finest)
    step = np.where(quiet, longest, np.where(steady, np.clip(long, finest, _STEADY * finest), finest))
    if not motion.turning_tool:
        braked = np.clip(
            np.minimum((train.time - motion.time) / _BLOCK, left), finest, np.maximum(2 * motion.h, finest)
        )
        step = np.where(_sticks_on(motion, motor, watch.peak, braked), braked, step)
    if np.any(step != motion.h):
        motion.set_step(step if is_array(motion.h) else float(step))
    # a motor that keeps up the slip on the stable branch of its curve does so for ever
    stable = True if train.engine.slip is None else motion.motor > train.engine.synchronous * (1 - train.engine.slip)
    balanced = motor >= motion.clutch * (1 - _CARRIES)
    carries = balanced | np.isinf(end) | (lasting > slowing * np.maximum(end - motion.time, 0.0))
    endless: Any = quiet & stable & carries & (train.cut_off is None)
    return endless


def _sticks_on(motion: Motion, motor: Any, peak: Any, step: Any) -> Any:
    """Flags: while the tool is braked slowly, the clutch sticks through a block of steps, and no swing raises the peak.

    The shaft torque follows motor and deceleration of the tool, M + J a; the whole drive slows down with the tool.
    """
    train, pack, until = motion.train, motion.pack, motion.time + _BLOCK * step
    inertia = train.front * (motion.tool - train.led(until)) / (_BLOCK * step)
    # beyond its breakdown a motor feeds every swing
    breakdown = 0.0 if train.engine.slip is None else train.engine.synchronous * (1 - train.engine.slip)
    slowest = train.led(until)
    now, then = motor + inertia, train.engine.at(slowest) * (motor != 0) + inertia
    swing = np.hypot(motion.elastic - now, motion.twisting * (train.stiffness * train.front) ** 0.5)
    top = np.maximum(np.abs(now), np.abs(then)) + swing
    limit = np.minimum(pack.breakaway, pack.lift) if pack.travels else np.where(pack.lag > 0, 0.0, pack.breakaway)
    sticks = (motion.slip == 0) & (motion.rate == 0) & (motion.turn == 0) & (top < limit * (1 - CLOSE))
    return sticks & (slowest >= breakdown) & ((swing < _QUIET * np.abs(now)) | (top <= peak * (1 + _QUIET)))


def horizon(train: Train, pack: DirectPack | Sleeve) -> Values:
    """Generous upper bound of the time after which a drive has settled, if it ever does, s."""
    sliding, inertia, motor = pack.sliding, train.motor_inertia, train.engine.torque
    # the balls of a sleeve that moves back pass at least κ/κ₊ of the torque
    least = sliding * (pack.net_gain / pack.net_gain_returning) if isinstance(pack, Sleeve) else sliding
    off = 0.0 if train.cut_off is None else train.cut_off
    run_down = _LONG * (train.front + train.tool_inertia) * train.speed / sliding
    whole = peak_time(train, sliding) + off + run_down
    if train.cut_off is not None:
        gained = train.speed + np.maximum(motor - least, 0.0) * train.cut_off / inertia
        return whole + off + law.run_down_time(inertia, gained, least, 0.0)
    with np.errstate(all="ignore"):
        surely = law.run_down_time(inertia, train.speed, least, np.minimum(motor, np.asarray(least)))
        likely = _LONG * law.run_down_time(inertia, train.speed, sliding, np.minimum(motor, np.asarray(sliding)))
    return whole + np.where(least > motor, surely, np.where(sliding > motor, likely, 0.0))


def peak_time(train: Train, sliding: Values) -> Values:
    """Time within which the peak occurs, s: some swings of the driven half and one swing of the stuck drive.

    In an event of kind load, the time that the load takes to stop the tool is added.
    """
    swings = _SWINGS * train.driven_inertia**0.5 + train.front**0.5
    time: Any = train.time + 2 * np.pi * swings / train.stiffness**0.5
    if train.kind == "load":
        least = np.abs(train.overload - sliding)
        if train.engine.slip is not None:
            # the motor may have to be overcome too
            least = np.minimum(least, np.abs(train.overload - train.engine.torque))
        time = time + (train.front + train.tool_inertia) * train.speed / np.maximum(least, 0.05 * sliding)
    return time


def shapes(record: object) -> list[tuple[int, ...]]:
    """Shapes of the arrays in a record."""
    if not hasattr(record, "__dataclass_fields__"):
        return [record.shape] if isinstance(record, np.ndarray) else []
    return [shape for value in vars(record).values() for shape in shapes(value)]
