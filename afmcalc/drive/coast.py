"""Long slip in one stride, on a standing tool: steady slip with free swings, or slow slip without any.

Once static friction has decayed and the sleeve is held, the pack slides at a constant torque: the driven half swings
freely about its twist, and the motor side runs down alone, which is one smooth equation. Where static friction comes
back as the slip slows down, and nothing swings, shaft and driven half follow the torque of the pack.
"""

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.polynomial import chebyshev
from scipy.integrate import solve_ivp
from scipy.linalg import expm

from ..arrays import Floats, Values
from .plant import DRIVEN, NORMAL, SIZE, TWIST, Mode, Plant, State, V

_LEAST = 5.0
"""Swings below which a stride is not worth it."""
_STILL = 1e-7
"""Deceleration of the motor side, relative to T/J_1, that counts as none: the slip does not end."""
_EXACT = 1e-10
_DECAYED = 20.0
"""Exponent at which static friction is nothing, e^−20 = 2e-9."""
_BALANCED = 1e-10
"""Change of a late normal force in its time of lag, relative to it, that is none."""
_SWINGS, _SHOWN = 100, 12
"""Swings of a stride whose heat is told one by one, moments in each and parts of what is left."""
_CALM, _NEARLY = 1e-5, 1e-2
"""Swing about a slow slip, relative to the torque, that counts as none; and about rest, at which that is looked at."""
_SLOW = 0.3
"""Growth of a swing by falling friction, relative to its frequency, up to which a slip is slow."""
_STEP = 1e-6
"""Of friction, relative, over which the growth of the torque is taken."""
_NODES, _ITERATIONS = 64, 16
"""Of the series for a slow slip."""
_CONVERGED = 1e-9
"""Speed of the driven half, relative to the slip, up to which that series is exact."""
_UNGROWN = 1e-9
"""Growth of a swing, as an exponent, that is none."""
_CREPT = 48
"""Parts of slow slip of which the heat is told."""
_CLOSE = 1e-9


class Heating(NamedTuple):
    """A moment of a slip."""

    time: float
    torque: float
    """Of the pack, N·m; of the sign of the slip."""
    slip: float
    """rad/s."""
    heat: float
    """In the pack so far, J."""


class Stride(NamedTuple):
    """Where a stride ends."""

    time: float
    y: State
    endless: bool
    """Whether the motor side no longer slows down."""
    course: list[Heating]
    """The slip on the way."""


class Creep(NamedTuple):
    """A pack whose torque rises slowly as its slip falls."""

    torque: Callable[[Values], Values]
    """Slip → torque, N·m, both without a sign."""
    inertia: float
    """Of what follows the shaft's twist, kg·m²."""
    least: float
    """Slip down to which friction rises slowly against a swing of the shaft, rad/s."""


def stride(
    plant: Plant, t: float, y: State, mode: Mode, bound: float, *, lasting: bool, largest: float = math.inf
) -> Stride | None:
    """Go as far as the slip stays what it is, at most to ``bound``; None where that is not far, or not known.

    Args:
        plant: the drive; its tool stands.
        t: time, s.
        y: states and work.
        mode: the pack slips.
        bound: latest time, s.
        lasting: whether the motor is never switched off.
        largest: swing, relative to the torque, beyond which none is wanted.
    """
    if (sliding := _sliding(plant, t, y, mode)) is None:
        return None
    pulled, most = sliding
    train, way, torque = plant.train, mode.pack, mode.pack * pulled
    inertia = train.hub_inertia + train.driven_inertia
    natural, scale = math.sqrt(train.stiffness / inertia), math.sqrt(train.stiffness * inertia)
    # in energy's own measure the swing is a rotation that shrinks
    swing = np.array([train.stiffness * y[TWIST] - torque, scale * y[DRIVEN]])
    size = math.hypot(*swing)
    if size * (1 + train.damping * natural / train.stiffness) > min(most, plant.holds - pulled, largest * pulled):
        return None
    slowest = size / scale + (_DECAYED / plant.pack.decay_rate if plant.pack.static_ratio > 1 else 0.0)
    begin, least = way * plant.motor_speed(y), _LEAST * 2 * math.pi / natural
    if begin <= slowest or bound - t < least:
        return None

    def rates(at: float, states: Floats) -> list[float]:
        speed = float(states[0])
        driven = way * plant.motor(way * speed, mode)
        return [(driven - pulled) / train.motor_inertia, speed, driven * speed, 0.0]

    run = _run_down(plant, t, [begin, 0.0, 0.0, 0.0], rates, lambda speed: pulled, slowest, bound, lasting=lasting)
    if run.time - t < least and not run.endless:
        return None
    turning = np.array([[0.0, natural], [-natural, -train.damping / inertia]])
    after = expm(turning * (run.time - t)) @ swing
    (speed, angle, work, _), new = run.states, list(y)
    new[TWIST], new[DRIVEN] = float(after[0] + torque) / train.stiffness, float(after[1]) / scale
    new[V] = way * speed - new[DRIVEN]
    heat, damped = torque * (way * angle - (new[TWIST] - y[TWIST])), (swing @ swing - after @ after) / 2
    for place, energy in enumerate((work, heat, damped / train.stiffness), SIZE):
        new[place] += float(energy)
    # what happens on the way, swing by swing; after many as if the driven half stood
    part = 2 * math.pi / natural / _SHOWN
    step, swings = expm(turning * part), [swing]
    for _ in range(min(int((run.time - t) / part), _SWINGS * _SHOWN)):
        swings.append(step @ swings[-1])
    shown = part * np.arange(1, len(swings))
    times = t + np.concatenate([shown, np.linspace(part * len(swings), max(part * len(swings), run.time - t), _SHOWN)])
    stretch, moved = np.array([*swings[1:], *np.zeros((_SHOWN, 2))])[times < run.time].T
    times = times[times < run.time]
    speeds, angles = way * run.course(times)[:2]
    heats = y[SIZE + 1] + torque * (angles - (stretch - swing[0]) / train.stiffness)
    rows = zip(times.tolist(), (speeds - moved / scale).tolist(), heats.tolist(), strict=True)
    return Stride(run.time, new, run.endless, [Heating(at, torque, slip, heat) for at, slip, heat in rows])


def _sliding(plant: Plant, t: float, y: State, mode: Mode) -> tuple[float, float] | None:
    """Torque at which the pack slides, and the swing of the shaft up to which it stays that; None where it changes."""
    pack, train = plant.pack, plant.train
    if not pack.travels:
        late = abs(plant.rates(t, y, mode)[NORMAL]) * pack.lag
        return None if late > _BALANCED * y[NORMAL] else (plant.sliding, math.inf)
    if mode.moving or (mode.balls == "seat" and mode.hold) or mode.pack != mode.side:
        return None
    normal = plant.normal(y, mode, 0.0)
    torque = pack.carried(normal, 1.0)
    if mode.balls == "lock":
        low, high = pack.key_limits(plant.travel(y))
    else:
        off = (pack.resting_force - normal) * pack.mean_radius
        low, high = off / pack.net_gain_returning, min(off / pack.net_gain, pack.lift)
    return torque, min(high - torque, torque - low) * (train.hub_inertia + train.driven_inertia) / train.hub_inertia


def creep(plant: Plant, t: float, y: State, mode: Mode, bound: float, *, lasting: bool) -> Stride | None:
    """Go on while friction rises slowly as the slip slows down and nothing swings: the shaft has the pack's torque.

    Args and result as ``stride``.
    """
    slow, train, way = creeping(plant, mode), plant.train, mode.pack
    if slow is None or way * y[V] <= slow.least or slow.torque(slow.least) >= plant.holds:
        return None
    natural = math.sqrt(train.stiffness / slow.inertia)
    least, torque = _LEAST * 2 * math.pi / natural, float(slow.torque(way * y[V]))
    swing = math.hypot(train.stiffness * y[TWIST] - way * torque, y[DRIVEN] * train.stiffness / natural)
    if bound - t < least or swing > _NEARLY * torque or (path := _slow_path(plant, mode, slow, way * y[V])) is None:
        return None
    _, driven, twist, _ = path(way * y[V])
    begin = way * plant.motor_speed(y) - driven
    off = train.stiffness * (y[TWIST] - way * twist), (y[DRIVEN] - way * driven) * train.stiffness / natural
    if math.hypot(*off) > _CALM * torque:
        return None

    def rates(at: float, states: Floats) -> list[float]:
        slip = float(states[0])
        slowing, driven, _, steep = path(slip)
        speed, torque = slip + driven, float(slow.torque(slip))
        power, growth = way * plant.motor(way * speed, mode) * speed, (-steep - train.damping) / (2 * slow.inertia)
        return [slowing, power, torque * slip, train.damping * driven * driven, growth]

    # a swing unseen grows back where friction falls with the slip: before it is as large as it was, it is integrated
    run = _run_down(plant, t, [begin, 0.0, 0.0, 0.0, 0.0], rates, slow.torque, slow.least, bound, lasting=lasting)
    if run.time - t < least and not run.endless:
        return None
    (slip, *works, _), new = run.states, list(y)
    _, driven, twist, _ = path(slip)
    new[V], new[DRIVEN], new[TWIST] = way * slip, way * driven, way * twist
    for place, work in enumerate(works, SIZE):
        new[place] += work
    times = np.linspace(t, run.time, _CREPT + 1)[1:-1]
    rows = zip(times.tolist(), *run.course(times)[[0, 2]].tolist(), strict=True)
    shown = [Heating(at, way * float(slow.torque(slip)), way * slip, y[SIZE + 1] + heat) for at, slip, heat in rows]
    return Stride(run.time, new, run.endless, shown)


def creeping(plant: Plant, mode: Mode) -> Creep | None:
    """How the pack slips at the stop where friction rises as it slows down; None where that is not smooth.

    The balls have the torque of the pack, N follows along κ or κ₊, and not so far that the sleeve would leave.
    """
    pack, train = plant.pack, plant.train
    varies, both = pack.static_ratio > 1, train.hub_inertia + train.driven_inertia
    smooth = pack.stop_gains[0] == pack.stop_gains[1] or (mode.hold > 0 and varies)
    if pack.travels and (mode.balls != "seat" or mode.pack != mode.side or not smooth):
        return None
    if not mode.hold or not (varies or pack.travels):
        return None
    net = plant.net_gain(mode)

    def torque(slip: Values) -> Values:
        return pack.slipping_at_stop(1 + (pack.static_ratio - 1) * np.exp(-pack.decay_rate * slip), net, 0.0, 1.0)

    inertia, growth = both, float(torque(0.0))
    if pack.travels:
        # a swing of the shaft takes a share of its torque back from the pack
        loop = pack.friction_pairs * net
        inertia = both * (1 + loop * train.driven_inertia / both) / (1 + loop)
    else:
        growth = max(pack.growth, (pack.torque(1 + _STEP) - pack.torque(1.0)) / _STEP)
    steep = growth * (pack.static_ratio - 1) * pack.decay_rate
    fast = 2 * _SLOW * math.sqrt(train.stiffness * inertia) + train.damping
    decay = pack.decay_rate if varies else 0.0
    least = max(math.log(max(steep, fast) / fast) / decay, 0.1 / decay) if decay else 0.01 * train.speed
    return Creep(torque, inertia, least) if torque(least) < pack.lift * (1 - _CLOSE) else None


def _slow_path(plant: Plant, mode: Mode, slow: Creep, begin: float) -> Callable[[float], list[float]] | None:
    """Motion without swings, by the slip: growth of slip, speed of the driven half, twist, slope of the torque.

    Each is the series that solves Newton's law the better the slower the slip changes; None where it does not converge.
    """
    train, way = plant.train, mode.pack
    wide = (begin - slow.least) / 2
    place = chebyshev.chebpts2(_NODES)
    slip = slow.least + wide * (place + 1)
    torque, slowing, driven, last = slow.torque(slip) + 0.0 * slip, np.zeros(_NODES), np.zeros(_NODES), math.inf

    def fitted(values: Floats) -> Floats:
        return np.asarray(chebyshev.chebfit(place, values, _NODES - 1), float)

    def slope(values: Floats) -> Floats:
        return np.asarray(chebyshev.chebval(place, chebyshev.chebder(fitted(values))), float) / wide

    for _ in range(_ITERATIONS):
        motor = way * train.engine.at(way * (slip + driven)) if mode.powered else 0.0
        bends = slope(driven)
        slowing = (motor - torque) / (train.motor_inertia * (1 + bends))
        twist = (torque - train.damping * driven - slow.inertia * bends * slowing) / train.stiffness
        before, driven = driven, slope(twist) * slowing
        change = float(np.max(np.abs(driven - before)))
        if change >= last:
            break
        last = change
    if last > _CONVERGED * begin:
        return None
    series = np.stack([fitted(values) for values in (slowing, driven, twist, slope(torque))], axis=1)
    orders = np.arange(_NODES)

    def path(at: float) -> list[float]:
        # a motor that wins speeds the slip up: no farther than the series goes
        inside = min(max((at - slow.least) / wide - 1, -1.0), 1.0)
        return (np.cos(orders * math.acos(inside)) @ series).tolist()

    return path


class _RunDown(NamedTuple):
    """A slip at the end of a stride."""

    time: float
    states: list[float]
    endless: bool
    course: Callable[[Floats], Floats]
    """The states at times on the way."""


def _run_down(
    plant: Plant,
    t: float,
    start: list[float],
    rates: Callable[[float, Floats], list[float]],
    drag: Callable[[float], Values],
    slowest: float,
    bound: float,
    *,
    lasting: bool,
) -> _RunDown:
    """Integrate a slip, its speed first among the states, until it is slow, no longer slows down, or at the bound.

    The last state is the growth of a swing that is left out: where it is above 0, it is no longer left out.
    """

    def near(at: float, states: Floats) -> float:
        return float(states[0]) - slowest

    def swings(at: float, states: Floats) -> float:
        return _UNGROWN - float(states[-1])

    def still(at: float, states: Floats) -> float:
        return -rates(at, states)[0] - _STILL * float(drag(float(states[0]))) / plant.train.motor_inertia

    near.terminal = swings.terminal = still.terminal = True  # type: ignore[attr-defined]
    if lasting and still(t, np.array(start)) <= 0:
        return _RunDown(t, start, True, lambda times: np.zeros((len(start), times.size)))
    events = [near, swings, still] if lasting else [near, swings]
    found = solve_ivp(rates, (t, bound), start, "DOP853", events=events, rtol=_EXACT, atol=_EXACT, dense_output=True)
    endless = lasting and bool(found.t_events[2].size)
    return _RunDown(float(found.t[-1]), found.y[:, -1].tolist(), endless, found.sol)
