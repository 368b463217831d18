"""An event, stepped until nothing more can come: one drive as numbers, or many as arrays, by the same steps."""

import functools
import math
import operator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..equations import drive
from ..equations import heat as law
from ..equations.arrays import Floats, Values, is_array
from ..errors import CalculationError
from ..messages import say
from ..progress import tell
from .bounds import settled, slips_below
from .motion import Motion, clip, cut, larger, where
from .pack_and_sleeve import DirectPack, Sleeve
from .train import Train

STEPS_A_SWING = 150
"""Steps in a swing of the driven half on its shaft."""
_BALLS = 30
"""Steps in a swing of the balls on their springs."""
_LAG = 8
"""Steps in the lag of a release force."""
_FINEST = 4
"""Times that these may shorten a step: springs that the key all but locks are stiff, and still."""
_RINGING = 1 / 16
"""Share of a swing of the balls that the key takes, at least; where it takes little, the balls ring on, and need steps.
"""
_YIELDING = 1e-3
"""Stiffness of a control unit, of the shaft's, below which it is no spring: its wall holds the torque."""
_STEADY = 3
"""Times the step is longer where slip goes on through the swings of the shaft."""
_BLOCK = 64
"""Steps between two looks at what may still come."""
_PLACES = slice(0, -2), slice(1, -1), slice(2, None)
"""Of a block: two moments before a step, that before it, that after it."""
MOST_STEPS = 100_000
"""Of an event; longer ones end unsettled."""
_LANES = 2048
"""Drives stepped at a time; the states of so many stay in the processor's cache."""
_FEW = 6
"""Drives that are stepped faster one by one, as numbers."""
CLOSE = 2e-3
"""Error of the peak, relative, up to which a step is fine enough."""
CLOSE_CLUTCH = 3e-3
"""Error of the peak at the clutch, whose torque springs as its slip ends, up to which a step is fine enough."""
SPREAD = 0.01
"""Relative error of heat and slip time beyond which they are ill-conditioned."""
CLOSED = 1e-3
"""Relative error of the energy balance beyond which a result is an error."""
_HALVINGS = 3
_QUIET = 1e-3
"""Swing, relative to the torque, below which nothing swings."""
_SILENT = 1e-9
"""Swing below which nothing swings where a swing may grow again."""
_CARRIES = 1e-6
"""Share of the slip torque that a motor may lack and still never stop."""
_SWINGS = 6.0
"""Swings of the driven half after an event within which its peak has come."""
_LONG = 20.0
"""Times the run-down at T(f) that is waited for: motor and load may all but balance the slipping clutch, the key hold
the sleeve far off."""


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
    """So far, in the pack, J."""


class Event(NamedTuple):
    """Results of an event for a drive, or for many; torques in N·m."""

    peak: Any
    peak_clutch: Any
    peak_wall: Any
    """Torque of the balls over cos α, at most: the force of their walls times n r."""
    travel_max: Any
    slip_time: Any
    heat: Any
    key_heat: Any
    """Until the last slip ended: the drive that sticks swings on, and loses more at the key."""
    trip_torque: Any
    """Of the clutch as it begins to slip; 0 where it does not."""
    residual: Any
    """Error of the energy balance, relative to the largest energy in it."""
    time: Any
    """From which nothing more could come, s."""
    last: Any
    """Torque of the clutch at the end."""
    stuck: Any
    """True if the pack does not slip at the end."""
    passed: Any
    """True if no torque of the shaft exceeds the peak any more."""
    settled: Any
    """True if nothing more can come."""
    pulled: Any
    """Torque with which the pack slipped as the motor was switched off; 0 where it did not."""
    rows: Any = ()
    """Every step, ``Row``s; of many drives an array of them. None of events that are not whole."""
    peak_error: Any = 0.0
    """Change of the peak against twice the step, relative."""
    clutch_error: Any = 0.0
    """Change of the peak at the clutch against twice the step, relative."""
    slip_error: Any = 0.0
    """Change of heat or slip time against twice the step, relative."""
    other: Any = None
    """Event with twice the step, of one drive."""


def simulate(
    train: Train, pack: DirectPack | Sleeve, duration: float | None = None, *, whole: bool = True, full: bool = False
) -> Event:
    """Step events until nothing more can come, or until their peak has passed where they are not ``whole``.

    The step is halved until twice the step changes the peak by 0.2 % at most, and in whole events that at the clutch by
    0.3 %; at most three times and not for long events.

    Args:
        train: drive, or drives as arrays.
        pack: clutch at one friction, or clutches; shapes broadcast.
        duration: end of the event, s; None until nothing more can come.
        whole: step on to the end of the slip.
        full: step on to the end of a given duration, whatever may come.

    Raises:
        CalculationError: the duration has too many steps.
    """
    shape = np.broadcast_shapes(*shapes(train), *shapes(pack), np.shape(0.0 if duration is None else duration))
    h, end = step_of(train, pack), horizon(train, pack) if duration is None else duration
    blocks, given = np.ceil(end / (h * 2 * _BLOCK)), duration is not None
    if duration is not None and np.max(blocks) * 2 * _BLOCK > MOST_STEPS:
        raise CalculationError(
            "simulate: {steps:.4g} time steps are needed, at most {most} are made: a shorter drive.event.duration, or "
            "inertias, stiffness and times that lie less far apart",
            steps=float(np.max(blocks)) * 2 * _BLOCK,
            most=MOST_STEPS,
        )
    if duration is not None:
        h = end / (blocks * 2 * _BLOCK)
    if not shape:
        h, end = float(h), float(end)
        return _refined(train, pack, h, end, given=given, whole=whole, full=full)
    h, end = (np.broadcast_to(value, shape).reshape(-1) for value in (h, end))
    parts = []
    for first in range(0, h.size, _LANES):
        lanes = slice(first, first + _LANES)
        own, clutch = cut(train, lanes, shape), cut(pack, lanes, shape)
        parts.append(_refined(own, clutch, h[lanes], end[lanes], given=given, whole=whole, full=full))
        tell(say("stepping the drives"), min(first + _LANES, h.size), h.size)
    joined = (np.concatenate(each).reshape(shape) for each in zip(*(part[:-1] for part in parts), strict=True))
    return Event(*joined)


def _refined(train: Train, pack: Any, h: Any, end: Any, *, given: bool, whole: bool, full: bool) -> Event:
    """Events with steps fine enough for their peaks."""
    coarse = stepped(Motion(train, pack, 2 * h), end, given=given, whole=whole, full=full)
    fine = _compared(stepped(Motion(train, pack, h), end, given=given, whole=whole, full=full), coarse)
    for _ in range(_HALVINGS):
        rough = fine.peak_error > CLOSE
        open_ = (rough | (whole & (fine.clutch_error > CLOSE_CLUTCH))) & (fine.time < h * MOST_STEPS / 2)
        if not np.any(open_):
            break
        h = h / 2
        if not is_array(h):
            finer = _compared(stepped(Motion(train, pack, h), end, given=given, whole=whole, full=full), fine)
            fine = finer._replace(**_peak(rough, finer, fine))
            continue
        lanes = np.flatnonzero(open_)
        drives, clutches = cut(train, lanes, h.shape), cut(pack, lanes, h.shape)
        before = Event(*(part[lanes] for part in fine[:-1]))
        finer = _compared(
            stepped(Motion(drives, clutches, h[lanes]), end[lanes], given=given, whole=whole, full=full), before
        )
        for part, new in zip(fine[:-1], finer._replace(**_peak(rough[lanes], finer, before))[:-1], strict=True):
            part[lanes] = new
    return fine


def _peak(rough: Any, finer: Event, before: Event) -> dict[str, Any]:
    """Peak and its error, of finer steps only where it was ``rough``: events, and peaks asked alone, agree."""
    return {name: where(rough, getattr(finer, name), getattr(before, name)) for name in ("peak", "peak_error")}


def _compared(fine: Event, coarse: Event) -> Event:
    """Event with the errors that twice the step tells."""
    return fine._replace(
        peak_error=_change(fine.peak, coarse.peak),
        clutch_error=_change(fine.peak_clutch, coarse.peak_clutch),
        slip_error=larger(_change(fine.heat, coarse.heat), _change(fine.slip_time, coarse.slip_time)),
        other=coarse._replace(rows=()),
    )


def _change(own: Any, other: Any) -> Any:
    """Relative difference; 0 where there is nothing."""
    return abs(own - other) / where(own == 0, 1.0, own)


def step_of(train: Train, pack: DirectPack | Sleeve) -> Values:
    """Time step with so many in a swing of the driven half, or of the balls, s."""
    fastest = (train.stiffness / train.driven_inertia) ** 0.5
    step: Values = 2 * np.pi / (fastest * STEPS_A_SWING)
    if isinstance(pack, Sleeve):
        stiffness = pack.torsional(0.0, pack.net_gain, pack.lift)
        straight = np.maximum(stiffness, _YIELDING * train.stiffness)
        swinging = (straight * (1 / train.hub_inertia + 1 / train.driven_inertia)) ** 0.5
        lost = np.maximum(1 - pack.net_gain / pack.net_gain_returning, _RINGING)
        step = np.clip(2 * np.pi / (swinging * _BALLS), step * lost / _FINEST, step)
        # discs that stick and break loose while the balls swing: the peak comes closer by the first order alone
        step = np.where(np.asarray(pack.static_ratio) > 1, step / 2, step)
    elif np.any(pack.lag):
        step = np.where(np.asarray(pack.lag) > 0, np.clip(pack.lag / _LAG, step / _FINEST, step), step)
    return step


_HISTORY = ("time", "torque", "clutch", "motor", "driven", "tool", "turn", "slip", "heat")
_MOMENT = (*_HISTORY, "key_heat", "top", "balls", "normal")
_moment = operator.attrgetter(*_MOMENT)


class _Watch:
    """Peaks and times of an event, or of many, read off the steps of a block at a time."""

    def __init__(self, motion: Motion, *, recorded: bool) -> None:
        zero, train = np.asarray(motion.h * 0.0), motion.train
        self.peak = zero + train.load
        self.travel_max = zero + motion.travel
        self.peak_clutch = self.peak_wall = self.slip_time = self.trip_torque = self.key_heat = self.pulled = zero
        self.most = zero + motion.stored
        self.off: Any = motion.h * 0.0 + math.inf
        self.over: Any = zero != 0
        self.last = np.array([np.broadcast_arrays(zero, *_moment(motion))[1:]] * 2)
        """The last two moments."""
        self.begun = motion.left
        self.history = [self.last[1:]] if recorded else None

    def block(self, motion: Motion, steps: int) -> None:
        """Step on, and take down what happens."""
        cut_off, block = motion.train.cut_off, np.empty((2 + steps, *self.last.shape[1:]))
        block[:2] = self.last
        powered: Any = 1.0
        for place in range(2, 2 + steps):
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
        """Peaks and times of a block: two moments before it, and its steps."""
        pack, moments = motion.pack, dict(zip(_MOMENT, np.moveaxis(block, 1, 0), strict=True))
        time, top, balls, turn = (moments[name][2:] for name in ("time", "top", "balls", "turn"))
        holding, held, clutch = (moments["clutch"][place] for place in _PLACES)
        slipping, slip, after = (moments["slip"][place] for place in _PLACES)
        slid, slides = slip != 0, after != 0
        # slip begins and ends within a step: where torque or slip, going on as before, come to the limit
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
            top = np.maximum(top, np.where(ends, self._ending(motion, moments["normal"][1:-1], held, slip, falling), 0))
        self.peak_clutch = np.maximum(self.peak_clutch, top.max(axis=0))
        self.peak_wall = np.maximum(self.peak_wall, (abs(balls) * pack.leaning(turn)).max(axis=0))
        if pack.travels:
            self.travel_max = np.maximum(self.travel_max, pack.travel(abs(turn).max(axis=0)))

    def _ending(self, motion: Motion, normal: Floats, held: Floats, slip: Floats, falling: Floats) -> Any:
        """Torque of the clutch as slip ends, when friction has risen to that of rest."""
        pack, held = motion.pack, abs(held)
        risen = held * pack.static_ratio / pack.ratio(slip + falling / 2)
        if pack.travels:
            return risen  # the key holds the normal force meanwhile
        # so does a lag, in part; the force of other direct clutches falls
        balance = pack.pressed_at_stop(risen, pack.stop_gains[0])
        left = np.clip(slip / np.where(falling == 0, np.inf, falling), 0.0, 1.0)
        late = pack.carried(balance + (normal - balance) * motion.half_lag ** (2 * left), pack.static_ratio)
        return np.where(pack.lag > motion.h, late, np.clip(risen, held, np.maximum(held, pack.breakaway)))

    def lanes(self, kept: Any) -> "_Watch":
        """Of some of many drives."""
        found = object.__new__(_Watch)
        shape = self.peak.shape
        vars(found).update({name: cut(value, kept, shape) for name, value in vars(self).items() if name != "last"})
        found.last = self.last[..., kept]
        found.history = self.history and [block[..., kept] for block in self.history]
        return found

    def event(self, motion: Motion, ended: Any) -> Event:
        """Event so far."""
        size = larger(larger(self.most, abs(motion.motor_work)), larger(abs(motion.tool_work), motion.heat))
        residual = abs(motion.left - self.begun) / size
        figures = (
            self.peak, self.peak_clutch, self.peak_wall, self.travel_max, self.slip_time, motion.heat, self.key_heat,
            self.trip_torque, residual, motion.time, motion.clutch, motion.slip == 0, self.over, ended, self.pulled,
            self._rows(motion),
        )  # fmt: skip
        if is_array(motion.h):
            return Event(*figures)
        return Event(*(figure.item() if hasattr(figure, "item") else figure for figure in figures))

    def _rows(self, motion: Motion) -> Any:
        """Every step, of many drives an array of such rows."""
        many = is_array(motion.h)
        if self.history is None:
            return np.empty(motion.h.shape, object) if many else ()
        history = np.concatenate(self.history)[:, : len(_HISTORY)]
        turn = history[:, _HISTORY.index("turn")]
        turn[:] = motion.pack.travel(turn) if motion.pack.travels else 0.0
        if not many:
            return tuple(map(Row._make, history.tolist()))
        rows = np.empty(motion.h.shape, object)
        for lane in range(rows.size):
            rows[lane] = tuple(map(Row._make, history[..., lane].tolist()))
        return rows


def _first(condition: NDArray[np.bool_], values: Floats, otherwise: Any) -> Any:
    """Value at the first step of a condition, for each drive."""
    first = np.take_along_axis(values, condition.argmax(axis=0)[None], axis=0)[0]
    return np.where(condition.any(axis=0), first, otherwise)


def _tops(older: Floats, old: Floats, torque: Floats) -> Floats:
    """Largest torques of the shaft, on the parabolas through three steps."""
    sign = np.where(old < 0, -1.0, 1.0)
    a, b, c = sign * older, sign * old, sign * torque
    bent = 2 * b - a - c
    turned = (b >= a) & (b >= c) & (bent > 0)
    found: Floats = np.where(turned, b + (c - a) * (c - a) / (8 * np.where(turned, bent, 1.0)), abs(torque))
    return found


def stepped(motion: Motion, end: Any, *, given: bool = True, whole: bool = True, full: bool = False) -> Event:
    """Step an event, or many, from a state, to an end that is ``given`` or a horizon; arguments as of ``simulate``."""
    watch = _Watch(motion, recorded=whole)
    return _stepped_on(motion, watch, end, motion.h, 0, (given, whole, full))


def _stepped_on(motion: Motion, watch: _Watch, end: Any, finest: Any, count: int, until: tuple[bool, ...]) -> Event:
    """Step on after ``count`` steps; the drives that have ended are left out, the last few stepped as numbers."""
    (given, whole, full), many = until, is_array(motion.h)
    done, places = [], np.arange(np.size(finest))
    while True:
        watch.block(motion, _BLOCK)
        count += _BLOCK
        powered = motion.time < watch.off
        pending = powered & (watch.off < math.inf)
        still = settled(motion, powered, pending, watch.peak)
        over = watch.over | still | slips_below(motion, powered, watch.peak)
        ended = still & (not full)
        watch.over = over if many else bool(over)
        last = (motion.time >= end * (1 - 1e-9)) | (count >= MOST_STEPS)
        last = last | (_lengthened(motion, watch, finest, end) & (not given))
        gone = last | (ended if whole else over)
        if not many:
            if gone:
                return watch.event(motion, bool(still))
            continue
        part, kept = np.flatnonzero(gone), np.flatnonzero(~gone)
        if part.size:
            done.append((places[part], watch.lanes(part).event(motion.lanes(part), still[part])))
        if kept.size <= _FEW:
            for lane in kept:
                alone = motion.lanes(lane), watch.lanes(lane), end[lane].item(), finest[lane].item()
                found, rows = _stepped_on(*alone, count, until), np.empty(1, object)
                rows[0] = found.rows
                done.append((places[[lane]], found._replace(rows=rows)))
            break
        if part.size:
            motion, watch, places, end, finest = (
                motion.lanes(kept), watch.lanes(kept), places[kept], end[kept], finest[kept]
            )  # fmt: skip
    order = np.argsort(np.concatenate([place for place, _ in done]))
    parts = zip(*(found[:-4] for _, found in done), strict=True)
    return Event(
        *(
            np.concatenate([np.broadcast_to(x, p.shape) for x, (p, _) in zip(each, done, strict=True)])[order]
            for each in parts
        )
    )


def _lengthened(motion: Motion, watch: _Watch, finest: Any, end: Any) -> Any:
    """Lengthen the step of a slow slip while nothing swings; where the motor keeps it up for ever.

    Slip and speed of the tool lose half until the next look at most.
    """
    train, pack, slip = motion.train, motion.pack, abs(motion.slip)
    motor = train.engine.at(motion.motor) * (motion.time < watch.off)
    rest, slowing = motion.clutch, np.abs(motor - motion.clutch) / train.motor_inertia
    lasting = slip
    if motion.turning_tool:
        behind = train.driven_inertia + train.hub_inertia
        rest = drive.sticking_torque(motion.clutch, behind, motion.resisting, train.tool_inertia)
        stopping = np.abs(rest - motion.resisting) / train.tool_inertia
        slowing, lasting = (
            np.maximum(slowing, stopping),
            np.where(motion.tool == 0, slip, np.minimum(slip, motion.tool)),
        )
    swing = np.hypot(motion.torque - rest, motion.twisting * (train.stiffness * train.driven_inertia) ** 0.5)
    decay = pack.decay_rate * (np.asarray(pack.static_ratio) > 1)
    # where friction falls with speed faster than the shaft damps, slip judders in the end, from what swings before
    juddering = pack.judder(0.0) > train.damping
    still = swing < np.where(juddering, _SILENT, _QUIET) * abs(motion.clutch)
    if not pack.travels:
        # the torque of slipping discs is not that of the shaft, which may swing as it likes
        free = watch.over & ~juddering & (np.asarray(pack.lag) == 0)
        still = still | free & (swing < slip / 8 * (train.stiffness * train.driven_inertia) ** 0.5)
    slides = (motion.time > train.time) & (motion.rate == 0) & (motion.slip > 0)
    quiet = slides & still & (pack.judder(slip) <= train.damping)
    # a slip faster than the swings goes on through them, and the largest torque has come
    steady = slides & (swing < slip / 8 * (train.stiffness * train.driven_inertia) ** 0.5)
    with np.errstate(all="ignore"):
        long = np.minimum(lasting, 6.4 / decay) / (4 * _BLOCK * slowing)
        left = np.maximum(end - motion.time, 0.0) / _BLOCK
        if train.engine.slip is not None:
            own = train.motor_inertia * train.engine.slip * train.engine.synchronous / train.engine.torque
            long = np.minimum(long, 0.1 * own)
        if train.cut_off is not None:
            before = np.where(motion.time < watch.off, (watch.off - motion.time) / _BLOCK, np.inf)
            left = np.minimum(left, before)
    longest = np.maximum(np.minimum(np.minimum(long, left), 2 * motion.h), finest)
    step = np.where(quiet, longest, np.where(steady, np.clip(long, finest, _STEADY * finest), finest))
    if np.any(step != motion.h):
        motion.set_step(step if is_array(motion.h) else float(step))
    # a motor that carries the slip on the stable branch of its curve does so for ever
    stable = True if train.engine.slip is None else motion.motor > train.engine.synchronous * (1 - train.engine.slip)
    balanced = motor >= motion.clutch * (1 - _CARRIES)
    carries = balanced | np.isinf(end) | (lasting > slowing * np.maximum(end - motion.time, 0.0))
    endless: Any = quiet & stable & carries & (train.cut_off is None)
    return endless


def horizon(train: Train, pack: DirectPack | Sleeve) -> Values:
    """Time within which a drive has settled, if it does, s: a bound that few come near."""
    sliding, least, inertia, motor = pack.sliding, pack.least, train.motor_inertia, train.engine.torque
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
    """Time within which the peak has come, s: some swings of the driven half, one of the stuck drive.

    Where the tool has an inertia of its own, that within which its load has stopped it comes before.
    """
    swings = (2 * np.pi * (inertia / train.stiffness) ** 0.5 for inertia in (train.driven_inertia, train.front))
    time: Any = train.time + sum(share * swing for share, swing in zip((_SWINGS, 1.0), swings, strict=True))
    if train.kind == "load":
        # the motor may have to be overcome too
        against = [sliding] if train.engine.slip is None else [sliding, train.engine.torque]
        least = functools.reduce(np.minimum, (np.abs(train.overload - torque) for torque in against))
        time = time + (train.front + train.tool_inertia) * train.speed / np.maximum(least, 0.05 * sliding)
    return time


def shapes(record: object) -> list[tuple[int, ...]]:
    """Shapes of the arrays in a record."""
    own = vars(record).values() if hasattr(record, "__dataclass_fields__") else ()
    return [np.shape(value) for value in own if isinstance(value, np.ndarray)] + [
        shape for value in own for shape in shapes(value)
    ]
