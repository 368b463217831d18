"""Every place where a quantity takes a wanted value, and its extremes, over the whole domain of a parameter.

The engines answer for arrays, so a curve is sampled at once, and a bracket is narrowed by sampling it again: kinks and
smooth extremes alike, to the last bit.
"""

import math
from collections.abc import Callable
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ...arrays import Floats
from .domain import SAME, Domain

Function: TypeAlias = Callable[[Floats], Floats]
Truths: TypeAlias = NDArray[np.bool_]

_STEP = 0.05
"""Between samples, in the logarithm of the distance from an end."""
_ROUNDING = 1e-13
"""Relative difference that rounding can make."""
_RUN = 20
"""Samples in a row that rounding does not leave steady by chance."""
_ZOOM = 65
"""Samples of a bracket."""


class Curve(NamedTuple):
    """The quantity over its domain: samples and every extreme that faces the wanted value."""

    at: Floats
    """Values of the parameter, rising."""
    value: Floats
    limit_low: float | None
    """What is approached, not reached, towards the low end; None where the end is a value."""
    limit_high: float | None
    """What is approached, not reached, without end."""


def explore(function: Function, wanted: float, domain: Domain) -> Curve:
    """Sample a quantity over a domain and refine its extremes on the wanted value's side.

    Args:
        function: the quantity at an array of values of the parameter.
        wanted: value wanted of the quantity.
        domain: where the parameter may lie.

    Returns:
        The curve without the values at which rounding alone would reach a limit.
    """
    at = _samples(domain)
    value = function(at)
    at, value = at[np.isfinite(value)], value[np.isfinite(value)]
    if not len(at):
        return Curve(at, value, None, None)
    low = 0 if domain.low_taken else _approached(value)
    high = lost = 0
    if not math.isfinite(domain.high):
        high, lost = _approached(value[::-1]), _noisy(function, at, value)
    limit_low, limit_high = float(value[0]) if low else None, float(value[-1]) if high else None
    kept = slice(low, len(value) - max(high, lost))
    at, value = at[kept], value[kept]
    if lost > high:
        limit_high = _limit(at, value)
    return Curve(*_with_extremes(function, wanted, at, value), limit_low, limit_high)


def roots(function: Function, wanted: float, curve: Curve) -> list[float]:
    """Return every value of the parameter at which the quantity is the wanted one: crossed, touched or at an end."""
    at, gap = curve.at, curve.value - wanted
    if not len(at):
        return []
    side = np.where(np.abs(gap) <= _ROUNDING * abs(wanted), 0.0, np.sign(gap))
    crossed = np.flatnonzero(side[:-1] * side[1:] < 0)
    found = [root for i in crossed if (root := _crossing(function, wanted, at[i], at[i + 1])) is not None]
    on = side == 0
    for i in np.flatnonzero(on & ~np.concatenate([[False], on[:-1]])):
        # a stretch on the wanted value counts once, where it begins
        stretch = 0 < i < len(on) - 1 and on[i + 1]
        found.append(
            _edge(lambda x: np.abs(function(x) - wanted) <= _ROUNDING * wanted, at[i - 1], at[i])[1]
            if stretch
            else float(at[i])
        )
    near = ~on & (np.abs(gap) <= SAME * abs(wanted)) & _lowest(np.abs(gap))
    near[crossed] = near[crossed + 1] = False
    # beside what is only approached there is no end to touch
    near[0] &= curve.limit_low is None
    near[-1] &= curve.limit_high is None
    near[:-1] &= ~on[1:]
    near[1:] &= ~on[:-1]
    return sorted([*found, *at[near].tolist()])


def _samples(domain: Domain) -> Floats:
    """Values over a domain, dense towards its ends; logarithmic where it has no end."""
    if math.isfinite(domain.high):
        inner = domain.low + (domain.high - domain.low) / (1 + np.exp(-np.arange(-30, 30, _STEP)))
    else:
        inner = domain.low + np.exp(np.arange(-30, 40, _STEP))
    ends = [*([domain.low] if domain.low_taken else []), *([domain.high] if math.isfinite(domain.high) else [])]
    inner = inner[(inner > domain.low) & (inner < domain.high)]
    return np.unique(np.concatenate([inner, ends]))


def _approached(value: Floats) -> int:
    """How many leading samples only approach the first: no clutch reaches a limit, numbers do by rounding."""
    away = np.abs(value - value[0]) > SAME * abs(value[0])
    count = int(np.argmax(away))
    # a stretch that is level from where it begins is reached
    return count if abs(value[count - 1] - value[0]) > _ROUNDING * abs(value[0]) else 0


def _noisy(function: Function, at: Floats, value: Floats) -> int:
    """How many last samples are only rounding: a step of its size moves them by more than counts as reached."""
    steady = np.abs(function(at * (1 + _ROUNDING)) - value) < SAME * np.abs(value)
    runs = np.convolve(steady, np.ones(_RUN), "valid") == _RUN
    return int(np.argmax(runs[::-1]))


def _limit(at: Floats, value: Floats) -> float:
    """What a curve tends to as its last decade does, by L + a/x."""
    near, far = len(at) - 1, max(len(at) - 1 - round(math.log(10) / _STEP), 0)
    limit = (value[near] * at[near] - value[far] * at[far]) / (at[near] - at[far])
    return float(limit) if abs(limit) > 1e-3 * abs(value[near]) else 0.0


def _lowest(gap: Floats) -> Truths:
    """Where neither neighbour is lower."""
    padded = np.concatenate([[np.inf], gap, [np.inf]])
    return np.logical_and(gap <= padded[:-2], gap <= padded[2:])


def _with_extremes(function: Function, wanted: float, at: Floats, value: Floats) -> tuple[Floats, Floats]:
    """Add the extremes that come nearest to the wanted value from either side, each narrowed from its bracket."""
    gap, side = np.abs(value - wanted), np.sign(value - wanted)
    bracketed = _lowest(gap)
    bracketed[[0, -1]] = False
    found = []
    for i in np.flatnonzero(bracketed):
        level = max(gap[i - 1], gap[i + 1]) - gap[i] <= SAME * (abs(value[i]) + abs(wanted))
        if not level and side[i - 1] == side[i] == side[i + 1]:
            found.append(_extreme(function, side[i], at[i - 1], at[i + 1]))
    if not found:
        return at, value
    joined = np.concatenate([at, found])
    joined, first = np.unique(joined, return_index=True)
    return joined, np.concatenate([value, function(np.array(found))])[first]


def _extreme(function: Function, side: float, low: float, high: float) -> float:
    """Where the quantity is smallest (side 1) or largest (side −1) in a bracket."""
    for _ in range(12):
        at = np.linspace(low, high, _ZOOM)
        i = int(np.argmin(side * function(at)))
        best, low, high = at[i], at[max(i - 1, 0)], at[min(i + 1, _ZOOM - 1)]
    return float(best)


def _crossing(function: Function, wanted: float, low: float, high: float) -> float | None:
    """Where the quantity crosses the wanted value in a bracket; None where it jumps over it."""
    ends = np.array(_edge(lambda at: function(at) > wanted, low, high))
    gap = np.abs(function(ends) - wanted)
    return float(ends[np.argmin(gap)]) if min(gap) <= 1e-6 * abs(wanted) else None


def _edge(holds: Callable[[Floats], Truths], low: float, high: float) -> tuple[float, float]:
    """Narrow a bracket at whose ends a condition differs until no number lies between them."""
    while True:
        at = np.linspace(low, high, _ZOOM)
        there = holds(at)
        i = int(np.argmax(there != there[0]))
        if at[i - 1] == low and at[i] == high:
            return float(low), float(high)
        low, high = at[i - 1], at[i]
