"""Which elements of an indirect clutch stick and which slip, after any of them has changed.

Pack and balls share the hub, so that one cannot be decided without the other: of the modes that the states allow the
one is taken in which nothing contradicts – no torque beyond what sticks, no acceleration against the slip.
"""

from abc import abstractmethod
from collections.abc import Iterator, Sequence
from enum import IntEnum
from itertools import product
from typing import NamedTuple

from ..equations import drive as law
from .plant import Balls, Mode, Plant, State, sign
from .sleeve import Sleeve

_ROUNDING = 1e-9
"""Relative contradiction that is none."""
_NOTHING = 1e-10
"""Share of the energy in the drive that a last swing of the balls at their stop may lose unseen."""


class SleevePlant(Plant):
    """What is asked here of an indirect clutch in its drive; its states go on with the following."""

    RATE, TURN, HELD = 4, 5, 6
    """w = ω_h − ω_2, the turn φ of the balls, the N that the key holds at the stop."""
    sleeve: Sleeve

    @abstractmethod
    def normal(self, y: Sequence[float], mode: Mode, balls: float) -> float:
        """Normal force on the pairs; a pack that the springs leave has none."""

    @abstractmethod
    def capacity(self, y: Sequence[float], mode: Mode, balls: float) -> float:
        """Largest torque of the pack at rest."""

    @abstractmethod
    def limits(self, y: Sequence[float]) -> tuple[float, float]:
        """Torques between which the key holds the sleeve off its stop."""


class Guard(IntEnum):
    """Guards of an indirect clutch by their place."""

    PACK = 0
    TOOL = 1
    BALLS = 2
    HOLD = 3
    STOP = 4
    SIDE = 5


class _Before(NamedTuple):
    """What was as the guard fell."""

    mode: Mode
    hit: int | None
    clutch: float
    balls: float
    normal: float


def switched(plant: SleevePlant, t: float, y: State, mode: Mode, hit: int | None) -> tuple[State, Mode]:
    """Bring to rest what has come to rest, then find the mode that follows."""
    torques = plant.torques(t, y, mode)
    before = _Before(mode, hit, torques.clutch, torques.balls, plant.normal(y, mode, torques.balls))
    _come_to_rest(plant, y, before)
    torn = hit == Guard.TOOL and not mode.tool
    tool = plant.tool.settled(t, mode, plant.shaft(y), y[plant.TOOL], torn=torn)
    y[plant.HELD] = before.normal
    # what a guard has ended does not go on: where nearly nothing moves, rounding would have it so for ever
    candidates = [
        own._replace(tool=tool) for own in _candidates(plant, y, before) if own != mode or hit in (None, Guard.TOOL)
    ]
    return y, min(candidates, key=lambda own: _contradiction(plant, t, y, own))


def _come_to_rest(plant: SleevePlant, y: State, before: _Before) -> None:
    mode = before.mode
    if before.hit == Guard.PACK:
        y[plant.V] = 0.0
    elif before.hit == Guard.TOOL and mode.tool:
        y[plant.TOOL] = 0.0
    elif before.hit == Guard.BALLS and mode.balls in ("out", "back"):
        y[plant.RATE] = 0.0
    elif before.hit == Guard.STOP:
        # the balls roll through to the other wall, unless what is left of the swing is nothing
        y[plant.TURN] = 0.0
        _seat(plant, y, mode)


def _seat(plant: SleevePlant, y: State, mode: Mode) -> None:
    """Join hub and driven half where the energy of their swing is nothing; the key takes it."""
    train, stored = plant.train, plant.stored(y)
    hub = train.hub_inertia if mode.pack else train.motor_inertia + train.hub_inertia
    both = hub + train.driven_inertia
    if hub * train.driven_inertia / both * y[plant.RATE] ** 2 > _NOTHING * plant.stored(plant.start()):
        return
    lost = y[plant.RATE] * train.driven_inertia / both
    y[plant.V] += lost if mode.pack else 0.0
    y[plant.DRIVEN] += y[plant.RATE] - lost
    y[plant.RATE] = 0.0
    y[-1] += stored - plant.stored(y)


def _candidates(plant: SleevePlant, y: State, before: _Before) -> Iterator[Mode]:
    """Modes that the states allow, those first in which more sticks; what was torn loose does not stick."""
    if y[plant.V]:
        packs = [sign(y[plant.V])]
    elif before.hit == Guard.PACK and not before.mode.pack:
        packs = [sign(before.clutch)]
    else:
        packs = [0, 1, -1]
    for pack, (balls, side, hold) in product(packs, _balls(plant, y, before)):
        yield before.mode._replace(pack=pack, balls=balls, side=side, hold=hold)


def _balls(plant: SleevePlant, y: State, before: _Before) -> list[tuple[Balls, int, int]]:
    """What the balls may do, on which side, and how the key holds."""
    mode, hit, rate, turn = before.mode, before.hit, y[plant.RATE], y[plant.TURN]
    torn = hit == Guard.BALLS and mode.balls in ("seat", "lock")
    if turn:
        side = sign(turn)
        if rate:
            return [("out" if side * rate > 0 else "back", side, 1)]
        moving: list[tuple[Balls, int, int]] = [("out", side, 1), ("back", side, 1)]
        return moving if torn else [("lock", side, 1), *moving]
    if rate:
        return [("out", sign(rate), 1)]
    if torn:
        return [("out", mode.side, 1)]
    if hit == Guard.SIDE:
        return [("seat", -mode.side, 1)]
    if hit == Guard.HOLD:
        return [("seat", mode.side, 0 if mode.hold else _reached(plant, before))]
    sides = (mode.side, -mode.side)
    holds = dict.fromkeys((mode.hold, 1, 0, -1))
    at_stop: list[tuple[Balls, int, int]] = [("seat", side, hold) for side, hold in product(sides, holds)]
    return [*at_stop, *(("out", side, 1) for side in sides)]


def _reached(plant: SleevePlant, before: _Before) -> int:
    """Which of its bounds a held normal force has reached."""
    low, high = plant.sleeve.play(before.balls)
    return 1 if high - before.normal < before.normal - low else -1


def _contradiction(plant: SleevePlant, t: float, y: State, mode: Mode) -> float:
    """By how much a mode contradicts itself, relative to what sticks."""
    train, own = plant.train, plant.sleeve
    torques = plant.torques(t, y, mode)
    capacity = plant.capacity(y, mode, torques.balls)
    along = mode.side * torques.balls
    found = []
    if not mode.pack:
        found.append(abs(torques.clutch) - capacity)
    elif not y[plant.V]:
        rate = law.slip_acceleration(
            torques.motor, train.motor_inertia, torques.clutch, torques.balls, train.hub_inertia
        )
        found.append(-mode.pack * rate * train.hub_inertia)
    if mode.balls == "seat":
        found += [along - own.lift, -along, _hold(plant, y, mode, along)]
    elif mode.balls == "lock":
        low, high = plant.limits(y)
        found += [along - high, low - along]
    elif not y[plant.RATE]:
        rate = law.slip_acceleration(
            torques.clutch, train.hub_inertia, torques.balls, torques.shaft, train.driven_inertia
        )
        outwards = mode.side * rate * train.driven_inertia
        found.append(-outwards if mode.balls == "out" else outwards)
    worst = max(found, default=0.0) / plant.sliding
    return worst if worst > _ROUNDING else 0.0


def _hold(plant: SleevePlant, y: State, mode: Mode, along: float) -> float:
    """Against the play of N: it falls only along κ, rises only along κ₊, and is held between, as a torque."""
    own, held = plant.sleeve, y[plant.HELD]
    if own.stop_gains[0] == own.stop_gains[1]:
        return 0.0 if mode.hold > 0 else plant.sliding
    low, high = own.play(along)
    off = {1: high - held, -1: held - low, 0: max(held - high, low - held)}[mode.hold]
    return off * own.mean_radius
