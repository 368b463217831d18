"""Where in a step of the integration a torque has its peak, and a guard falls to 0."""

from collections.abc import Callable
from typing import NamedTuple

from scipy.optimize import brentq

from .plant import Mode, Plant, State, Torques

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
