"""Long slip in one stride: a torque that stays constant parts the motor side from the swinging rest of the drive.

Once static friction has decayed, the sleeve is held and the tool stands, the pack slides at a constant torque. The
driven half then swings freely about its twist, which a matrix exponential gives for any time, and the motor side runs
down alone, which is one smooth equation.
"""

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.polynomial import chebyshev
from scipy.integrate import solve_ivp
from scipy.linalg import expm

from ..arrays import Floats, Values
from .plant import Creep, Mode, Plant, Sliding, State

_LEAST = 5.0
"""Swings below which a stride is not worth it."""
_STILL = 1e-7
"""Deceleration of the motor side, relative to T/J_1, that counts as none: the slip does not end."""
_EXACT = 1e-10
_SWINGS = 100
"""Swings of a stride whose heat is told one by one."""
_CALM, _NEARLY = 1e-5, 1e-2
"""Swing about a slow slip, relative to the torque, that counts as none; and about rest, at which that is looked at."""
_NODES, _ITERATIONS = 64, 16
"""Of the series for a slow slip."""
_CONVERGED = 1e-9
"""Speed of the driven half, relative to the slip, up to which that series is exact."""
_UNGROWN = 1e-9
"""Growth of a swing, as an exponent, that is none."""
_CREPT = 48
"""Parts of slow slip of which the heat is told."""
_SHOWN = 12
"""Moments of a swing at which it is, and parts of what is left."""


class Stride(NamedTuple):
    """Where a stride ends."""

    time: float
    y: State
    endless: bool
    """Whether the motor side no longer slows down."""
    course: list[tuple[float, float, float, float]]
    """Time, torque, slip and heat in the pack on the way."""


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
    sliding = plant.steadily(t, y, mode)
    if sliding is None:
        return None
    train, torque = plant.train, sliding.torque
    natural = math.sqrt(train.stiffness / sliding.inertia)
    stretch, speed = train.stiffness * y[plant.TWIST] - torque, y[plant.DRIVEN]
    swing = math.hypot(stretch, speed * math.sqrt(train.stiffness * sliding.inertia))
    most = min(sliding.most, plant.tool.holds(mode) - abs(torque), largest * abs(torque))
    if swing * (1 + train.damping * natural / train.stiffness) > most:
        return None
    slowest = swing / math.sqrt(train.stiffness * sliding.inertia) + sliding.slip
    least = _LEAST * 2 * math.pi / natural
    if mode.pack * plant.motor_speed(y) <= slowest or bound - t < least:
        return None
    way = mode.pack

    def rates(at: float, states: Floats) -> list[float]:
        speed = float(states[0])
        driven = way * plant.motor(way * speed, mode)
        return [(driven - abs(torque)) / train.motor_inertia, speed, driven * speed, 0.0]

    start = [way * plant.motor_speed(y), 0.0, 0.0, 0.0]
    run = _run_down(plant, t, start, rates, lambda speed: abs(torque), slowest, bound, lasting=lasting)
    return _arrived(plant, y, mode.pack, sliding, run, run.time - t) if run.time - t >= least or run.endless else None


def creep(plant: Plant, t: float, y: State, mode: Mode, bound: float, *, lasting: bool) -> Stride | None:
    """Go on while friction rises slowly as the slip slows down and nothing swings: the shaft has the pack's torque.

    Args and result as ``stride``.
    """
    slow, train, way = plant.creeping(mode), plant.train, mode.pack
    if slow is None or way * y[plant.V] <= slow.least or slow.torque(slow.least) >= plant.tool.holds(mode):
        return None
    natural = math.sqrt(train.stiffness / slow.inertia)
    least, torque = _LEAST * 2 * math.pi / natural, float(slow.torque(way * y[plant.V]))
    swing = math.hypot(train.stiffness * y[plant.TWIST] - way * torque, y[plant.DRIVEN] * train.stiffness / natural)
    if (
        bound - t < least
        or swing > _NEARLY * torque
        or (path := _slow_path(plant, mode, slow, way * y[plant.V])) is None
    ):
        return None
    _, driven, twist, _ = path(way * y[plant.V])
    begin = way * plant.motor_speed(y) - driven
    off = train.stiffness * (y[plant.TWIST] - way * twist), (y[plant.DRIVEN] - way * driven) * train.stiffness / natural
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
    new[plant.V], new[plant.DRIVEN], new[plant.TWIST] = way * slip, way * driven, way * twist
    for place, work in enumerate(works, plant.size):
        new[place] += work
    times = np.linspace(t, run.time, _CREPT + 1)[1:-1]
    rows = [
        (at, way * float(slow.torque(slip)), way * slip, y[plant.size + 1] + heat)
        for at, slip, heat in np.stack([times, *run.course(times)[[0, 2]]], axis=1).tolist()
    ]
    return Stride(run.time, new, run.endless, rows)


def _slow_path(plant: Plant, mode: Mode, slow: Creep, begin: float) -> Callable[[float], list[float]] | None:
    """Motion without swings, by the slip: growth of slip, speed of the driven half, twist, slope of the torque.

    Each is the series that solves Newton's law the better the slower the slip changes; None where it does not converge.
    """
    train, way = plant.train, mode.pack
    wide = (begin - slow.least) / 2
    place = chebyshev.chebpts2(_NODES)
    slip = slow.least + wide * (place + 1)
    torque, driven, last = slow.torque(slip) + 0.0 * slip, np.zeros(_NODES), math.inf

    def fitted(values: Floats) -> Floats:
        return np.asarray(chebyshev.chebfit(place, values, _NODES - 1), float)

    def slope(values: Floats) -> Floats:
        return np.asarray(chebyshev.chebval(place, chebyshev.chebder(fitted(values))), float) / wide

    slowing = np.zeros(_NODES)
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

    # a motor that wins speeds the slip up: no farther than the series goes
    def path(at: float) -> list[float]:
        found: list[float] = (
            np.cos(orders * math.acos(min(max((at - slow.least) / wide - 1, -1.0), 1.0))) @ series
        ).tolist()
        return found

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
    ended = lasting and bool(found.t_events[2].size)
    return _RunDown(float(found.t[-1]), found.y[:, -1].tolist(), ended, found.sol)


def _arrived(plant: Plant, y: State, way: int, sliding: Sliding, run: _RunDown, time: float) -> Stride:
    """States and work after a stride: the driven half has swung freely about its twist, everything behind it stood."""
    train, torque = plant.train, sliding.torque
    natural = math.sqrt(train.stiffness / sliding.inertia)
    # in energy's own measure the swing is a rotation that shrinks
    turning = np.array([[0.0, natural], [-natural, -train.damping / sliding.inertia]])
    scale = math.sqrt(train.stiffness * sliding.inertia)
    before = np.array([train.stiffness * y[plant.TWIST] - torque, scale * y[plant.DRIVEN]])
    after = expm(turning * time) @ before
    twist, driven = float(after[0] + torque) / train.stiffness, float(after[1]) / scale
    (speed, angle, work, _), new = run.states, list(y)
    new[plant.V] = way * speed - driven
    new[plant.DRIVEN], new[plant.TWIST] = driven, twist
    motor, pack, shaft = plant.size, plant.size + 1, plant.size + 2
    new[motor] += work
    new[pack] += torque * (way * angle - (twist - y[plant.TWIST]))
    # what damping takes is integrated beside the products of the two: a b, their squares
    (_, turn), (_, lost) = turning
    products = np.array([[0, 2 * turn, 0, 0], [-turn, lost, turn, 0], [0, -2 * turn, 2 * lost, 0], [0, 0, 1, 0]])
    squared = expm(products * time)[3, :3] @ [before[0] ** 2, before[0] * before[1], before[1] ** 2]
    new[shaft] += float(squared) * train.damping / (scale * scale)
    return Stride(run.time, new, run.endless, _course(plant, y, way, run, (turning, scale, before), (torque, time)))


def _course(
    plant: Plant, y: State, way: int, run: _RunDown, swing: tuple[Floats, float, Floats], over: tuple[float, float]
) -> list[tuple[float, float, float, float]]:
    """Time, torque, slip and heat on the way: swing by swing, after many as if the driven half stood."""
    (turning, scale, stretched), (torque, lasts) = swing, over
    part = 2 * math.pi / turning[0, 1] / _SHOWN
    count = min(int(lasts / part), _SWINGS * _SHOWN)
    step, start = expm(turning * part), run.time - lasts
    rows = [stretched]
    for _ in range(count):
        rows.append(step @ rows[-1])
    swung = np.array([*rows[1:], *np.zeros((_SHOWN, 2))])
    after = start + part * (count + 1)
    times = np.concatenate([start + part * np.arange(1, count + 1), np.linspace(after, max(after, run.time), _SHOWN)])
    inside = times < run.time
    times, swung = times[inside], swung[inside]
    speed, angle = way * run.course(times)[:2]
    heat = y[plant.size + 1] + torque * (angle - (swung - stretched)[:, 0] / plant.train.stiffness)
    slip = speed - swung[:, 1] / scale
    return [(at, torque, *both) for at, *both in np.stack([times, slip, heat], axis=1).tolist()]
