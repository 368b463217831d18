"""Long slip in one stride, on a standing tool: steady slip with free swings, or slow slip without any.

Once static friction has decayed and the sleeve is held, the pack slides at a constant torque: the driven half swings
freely about its twist, and the motor side runs down alone, which is one smooth equation. Where static friction comes
back as the slip slows down, and nothing swings, shaft and driven half follow the torque of the pack.
"""

import cmath
import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.polynomial import chebyshev
from scipy.integrate import solve_ivp

from ..equations.arrays import Floats, Values
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
_SWINGS, _SHOWN, _PARTS = 100, 12, 48
"""Swings of a stride whose heat is told one by one, moments in each and parts of what is left; parts without swings."""
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
    """A pack whose torque rises slowly as its slip falls, or not at all."""

    torque: Callable[[Values], Values]
    """Slip → torque, N·m, both without a sign."""
    inertia: float
    """Of what follows the shaft's twist, kg·m²."""
    least: float
    """Slip down to which it is so, rad/s."""


class Glide(NamedTuple):
    """A slip of which shaft and driven half follow the torque, but for a free swing; all along the slip."""

    creep: Creep
    path: Callable[[float], list[float]]
    """Slip → its growth, speed of the driven half, twist of the shaft, slope of the torque."""
    slip: float
    """At the begin, rad/s."""
    swing: Floats
    """Of the shaft's torque, and of the driven half's speed times √(k J): in that measure a swing is a rotation."""


def stride(
    plant: Plant, t: float, y: State, mode: Mode, bound: float, *, lasting: bool, largest: float = math.inf
) -> Stride | None:
    """Go as far as the slip stays what it is, at most to ``bound``; None where that is not far, or not known.

    The tool stands; ``lasting``: the motor is never switched off; ``largest`` swing, relative to the torque, for which
    a stride is wanted.
    """
    for glide in (_steady(plant, t, y, mode, largest), _creeping(plant, y, mode)):
        far = glide and _far(plant, t, y, mode, bound, glide, lasting=lasting)
        if far:
            return far
    return None


def _far(plant: Plant, t: float, y: State, mode: Mode, bound: float, glide: Glide, *, lasting: bool) -> Stride | None:
    """Go on until the slip is slow, no longer slows down, or to the bound; None where that is not far."""
    train, way, (drag, inertia, least) = plant.train, mode.pack, glide.creep
    natural, scale = math.sqrt(train.stiffness / inertia), math.sqrt(train.stiffness * inertia)
    shortest = _LEAST * 2 * math.pi / natural
    if glide.slip <= least or bound - t < shortest:
        return None

    def rates(at: float, states: Floats) -> list[float]:
        slip = float(states[0])
        slowing, driven, _, steep = glide.path(slip)
        speed = slip + driven
        power, growth = way * plant.motor(way * speed, mode) * speed, (-steep - train.damping) / (2 * inertia)
        return [slowing, power, float(drag(slip)) * slip, train.damping * driven * driven, growth]

    def near(at: float, states: Floats) -> float:
        return float(states[0]) - least

    # a swing unseen grows back where friction falls with the slip: before it is as large as it was, it is integrated
    def swings(at: float, states: Floats) -> float:
        return _UNGROWN - float(states[-1])

    def still(at: float, states: Floats) -> float:
        return -rates(at, states)[0] - _STILL * float(drag(float(states[0]))) / train.motor_inertia

    near.terminal = swings.terminal = still.terminal = True  # type: ignore[attr-defined]
    start = np.array([glide.slip, 0.0, 0.0, 0.0, 0.0])
    if lasting and still(t, start) <= 0:
        return Stride(t, y, True, [])
    run = solve_ivp(
        rates, (t, bound), start, "DOP853", events=[near, swings, still][: 3 if lasting else 2],
        rtol=_EXACT, atol=_EXACT, dense_output=True,
    )  # fmt: skip
    time, endless = float(run.t[-1]), lasting and bool(run.t_events[2].size)
    if time - t < shortest and not endless:
        return None
    # the swing dies away as it grew: at its mean rate over the stride
    swing, loss = glide.swing, -float(run.y[-1, -1]) / max(time - t, math.ulp(t))
    stretch, moved = (_swung(natural, loss, time - t) @ swing).tolist()
    (slip, *works, _), new = run.y[:, -1].tolist(), list(y)
    _, driven, twist, _ = glide.path(slip)
    new[DRIVEN], new[TWIST] = way * (driven + moved / scale), way * (twist + stretch / train.stiffness)
    new[V] = way * (slip + driven) - new[DRIVEN]
    works[1] -= drag(slip) * (stretch - swing[0]) / train.stiffness
    works[2] += (swing @ swing - stretch**2 - moved**2) / 2 / train.stiffness
    for place, work in enumerate(works, SIZE):
        new[place] += float(work)
    # what happens on the way, swing by swing; after many as if the driven half stood
    times = np.linspace(t, time, _PARTS + 1)[1:-1]
    turns = np.zeros((times.size, 2))
    if swing.any():
        part, seen = 2 * math.pi / natural / _SHOWN, [swing]
        step = _swung(natural, loss, part)
        for _ in range(min(int((time - t) / part), _SWINGS * _SHOWN)):
            seen.append(step @ seen[-1])
        rest = np.linspace(part * len(seen), max(part * len(seen), time - t), _SHOWN)
        times = t + np.concatenate([part * np.arange(1, len(seen)), rest])
        turns, times = np.array([*seen[1:], *np.zeros((_SHOWN, 2))])[times < time], times[times < time]
    slips, _, heats = run.sol(times)[:3]
    heats = y[SIZE + 1] + heats - drag(slips) * (turns[:, 0] - swing[0]) / train.stiffness
    torques = way * drag(slips) + 0.0 * slips
    course = np.stack([times, torques, way * (slips - turns[:, 1] / scale), heats], axis=1)
    return Stride(time, new, endless, [Heating(*row) for row in course.tolist()])


def _swung(natural: float, loss: float, time: float) -> Floats:
    """What a swing is after a time: exp(A t) of A = [[0, ω], [−ω, −2δ]], however strong the damping."""
    root = cmath.sqrt(loss**2 - natural**2)
    slow, fast = cmath.exp((root - loss) * time), cmath.exp((-root - loss) * time)
    even, odd = (slow + fast).real / 2, ((slow - fast) / (2 * root)).real if root else time * slow.real
    return even * np.eye(2) + odd * np.array([[loss, natural], [-natural, -loss]])


def _steady(plant: Plant, t: float, y: State, mode: Mode, largest: float) -> Glide | None:
    """The slip at a constant torque; None where the torque changes, or the swing would change it."""
    if (sliding := _sliding(plant, t, y, mode)) is None:
        return None
    (torque, most), train, way = sliding, plant.train, mode.pack
    inertia = train.hub_inertia + train.driven_inertia
    scale = math.sqrt(train.stiffness * inertia)
    swing = np.array([way * train.stiffness * y[TWIST] - torque, way * scale * y[DRIVEN]])
    size = math.hypot(*swing)
    if size * (1 + train.damping / scale) > min(most, plant.holds - torque, largest * torque):
        return None
    decayed = _DECAYED / plant.pack.decay_rate if plant.pack.static_ratio > 1 else 0.0

    def path(slip: float) -> list[float]:
        slowing = (way * plant.motor(way * slip, mode) - torque) / train.motor_inertia
        return [slowing, 0.0, torque / train.stiffness, 0.0]

    return Glide(Creep(lambda slip: torque, inertia, size / scale + decayed), path, way * plant.motor_speed(y), swing)


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


def _creeping(plant: Plant, y: State, mode: Mode) -> Glide | None:
    """The slip while friction rises slowly as it slows down and hardly anything swings."""
    slow, train, way = creeping(plant, mode), plant.train, mode.pack
    slip = way * y[V]
    if slow is None or slip <= slow.least or slow.torque(slow.least) >= plant.holds:
        return None
    scale, torque = math.sqrt(train.stiffness * slow.inertia), float(slow.torque(slip))

    def swing(driven: float, twist: float) -> float:
        return math.hypot(train.stiffness * (y[TWIST] - way * twist), (y[DRIVEN] - way * driven) * scale)

    if swing(0.0, torque / train.stiffness) > _NEARLY * torque or (path := _slow_path(plant, mode, slow, slip)) is None:
        return None
    _, driven, twist, _ = path(slip)
    if swing(driven, twist) > _CALM * torque:
        return None
    free = np.array([way * train.stiffness * y[TWIST] - train.stiffness * twist, scale * (way * y[DRIVEN] - driven)])
    return Glide(slow, path, way * plant.motor_speed(y) - driven, free)


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
