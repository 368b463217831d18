"""Long slip in one stride: a torque that stays constant parts the motor side from the swinging rest of the drive.

Once static friction has decayed, the sleeve is held and the tool stands, the pack slides at a constant torque. The
driven half then swings freely about its twist, which a matrix exponential gives for any time, and the motor side runs
down alone, which is one smooth equation.
"""

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import expm

from ...arrays import Floats
from .plant import Mode, Plant, Sliding, State

_LEAST = 5.0
"""Swings below which a stride is not worth it."""
_STILL = 1e-7
"""Deceleration of the motor side, relative to T/J_1, that counts as none: the slip does not end."""
_EXACT = 1e-10
_SWINGS = 100
"""Swings of a stride whose heat is told one by one."""
_CALM = 1e-5
"""Swing, relative to the torque, that counts as none."""
_STEP = 1e-6
"""Of the speed, relative, over which a slope is taken."""
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
    run = _run_down(plant, t, y, mode, lambda speed: torque, slowest, bound, lasting=lasting)
    return _arrived(plant, y, sliding, run, run.time - t) if run.time - t >= least or run.endless else None


def creep(plant: Plant, t: float, y: State, mode: Mode, bound: float, *, lasting: bool) -> Stride | None:
    """Go on while static friction comes back slowly and nothing swings: the shaft has the torque of the pack.

    Args and result as ``stride``.
    """
    slow, train = plant.creeping(), plant.train
    if slow is None:
        return None
    natural = math.sqrt(train.stiffness / train.driven_inertia)
    least = _LEAST * 2 * math.pi / natural

    def drag(speed: float) -> float:
        return mode.pack * slow.torque(abs(speed))

    def carried(speed: float) -> tuple[float, float]:
        """Speed of the driven half and twist of the shaft that go with the torque."""
        faster, slowing = speed * (1 + _STEP), (plant.motor(speed, mode) - drag(speed)) / train.motor_inertia
        driven = (drag(faster) - drag(speed)) / (faster - speed) * slowing / train.stiffness
        return driven, (drag(speed) - train.damping * driven) / train.stiffness

    speed = plant.motor_speed(y)
    # the torque is largest at the end: a standing tool is to stand through it
    if bound - t < least or mode.pack * speed <= slow.least or slow.torque(slow.least) >= plant.tool.holds(mode):
        return None
    driven, twist = carried(speed)
    off = train.stiffness * (y[plant.TWIST] - twist), (y[plant.DRIVEN] - driven) * train.stiffness / natural
    if math.hypot(*off) > _CALM * abs(drag(speed)):
        return None
    run = _run_down(plant, t, y, mode, drag, slow.least, bound, lasting=lasting)
    if run.time - t < least and not run.endless:
        return None
    (speed, _, work, resisted), new = run.states, list(y)
    new[plant.DRIVEN], new[plant.TWIST] = carried(speed)
    new[plant.V] = speed - new[plant.DRIVEN]
    new[plant.size] += work
    stored = train.stiffness * (new[plant.TWIST] ** 2 - y[plant.TWIST] ** 2) / 2
    new[plant.size + 1] += resisted - stored
    times = np.linspace(t, run.time, _CREPT + 1)[1:-1]
    rows = [
        (at, drag(speed), speed, y[plant.size + 1] + heat)
        for at, speed, heat in np.stack([times, *run.course(times)[[0, 3]]], axis=1).tolist()
    ]
    return Stride(run.time, new, run.endless, rows)


class _RunDown(NamedTuple):
    """The motor side at the end of a stride."""

    time: float
    states: list[float]
    """Speed, angle, work of the motor and against the pack, J."""
    endless: bool
    course: Callable[[Floats], Floats]
    """The states at times on the way."""


def _run_down(
    plant: Plant, t: float, y: State, mode: Mode, drag: Callable[[float], float], slowest: float, bound: float, *,
    lasting: bool,
) -> _RunDown:  # fmt: skip
    """Let the motor side run down against the torque of a pack that slips at its speed."""
    train, forward = plant.train, mode.pack

    def rates(at: float, states: Floats) -> list[float]:
        speed = float(states[0])
        driven, resisting = plant.motor(speed, mode), drag(speed)
        return [(driven - resisting) / train.motor_inertia, speed, driven * speed, resisting * speed]

    def near(at: float, states: Floats) -> float:
        return forward * float(states[0]) - slowest

    def still(at: float, states: Floats) -> float:
        return -forward * rates(at, states)[0] - _STILL * abs(drag(float(states[0]))) / train.motor_inertia

    near.terminal = still.terminal = True  # type: ignore[attr-defined]
    start = [plant.motor_speed(y), 0.0, 0.0, 0.0]
    if lasting and still(t, np.array(start)) <= 0:
        return _RunDown(t, start, True, lambda times: np.zeros((4, times.size)))
    events = [near, still] if lasting else [near]
    found = solve_ivp(rates, (t, bound), start, "DOP853", events=events, rtol=_EXACT, atol=_EXACT, dense_output=True)
    ended = lasting and bool(found.t_events[1].size)
    return _RunDown(float(found.t[-1]), found.y[:, -1].tolist(), ended, found.sol)


def _arrived(plant: Plant, y: State, sliding: Sliding, run: _RunDown, time: float) -> Stride:
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
    new[plant.V] = speed - driven
    new[plant.DRIVEN], new[plant.TWIST] = driven, twist
    motor, pack, shaft = plant.size, plant.size + 1, plant.size + 2
    new[motor] += work
    new[pack] += torque * (angle - (twist - y[plant.TWIST]))
    new[shaft] += float(before @ before - after @ after) / (2 * train.stiffness)
    return Stride(run.time, new, run.endless, _course(plant, y, run, (turning, scale, before), (torque, time)))


def _course(
    plant: Plant, y: State, run: _RunDown, swing: tuple[Floats, float, Floats], over: tuple[float, float]
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
    speed, angle, *_ = run.course(times)
    heat = y[plant.size + 1] + torque * (angle - (swung - stretched)[:, 0] / plant.train.stiffness)
    slip = speed - swung[:, 1] / scale
    return [(at, torque, *both) for at, *both in np.stack([times, slip, heat], axis=1).tolist()]
