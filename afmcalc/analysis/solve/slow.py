"""Search for a wanted value of what is asked of one clutch at a time: an event in the drive, a sample, a life.

Each value takes up to a second and is known to some digits only, so that few are looked at, and brackets are narrowed
by secants.
"""

import math
from collections.abc import Callable

import numpy as np

from ...arrays import Floats
from .search import Curve, Domain, Function

STEPS = 1e-2
"""Jump, relative to the step between two values, below which the quantity only comes in the steps of a sample."""
_CLOSE = 1e-10
"""Relative width to which a bracket is narrowed."""


def places(domain: Domain, now: float | None, count: int, reach: float, *, whole: bool) -> Floats:
    """Values to look at: even steps over a domain that ends, and even ratios from now/reach to now times reach."""
    around = now * np.geomspace(1 / reach, reach, count) if now else np.zeros(0)
    if math.isfinite(domain.high):
        around = np.concatenate([around, np.linspace(domain.low, domain.high, count)])
    around = np.round(around) if whole else around
    low = around >= domain.low if domain.low_taken else around > domain.low
    return np.unique(around[low & (around <= domain.high)])


def looked(function: Function, wanted: float, at: Floats) -> tuple[Curve, list[float]]:
    """Return the quantity where it is known, and one root for each pair of neighbours that it passes without a jump.

    Where all miss the wanted value on the same side, the extreme next to it is looked for.
    """
    value = function(at)
    at, value = at[~np.isnan(value)], value[~np.isnan(value)]
    side = np.sign(value - wanted)
    k = int(np.argmin(np.abs(value - wanted))) if len(at) else 0
    if 0 < k < len(at) - 1 and bool((side == side[0]).all()):
        extreme = _extreme(lambda x: float(side[0] * (function(np.array([x]))[0] - wanted)), at[k - 1], at[k + 1])
        at = np.insert(at, k + int(extreme > at[k]), extreme)
        value = function(at)
        side = np.sign(value - wanted)
    on = side == 0
    solutions = at[on & ~np.concatenate([[False], on[:-1]])].tolist()
    for i in np.flatnonzero(side[:-1] * side[1:] < 0):
        root = _passed(function, wanted, at[i], at[i + 1])
        sides = np.clip(np.outer(root, [1 - 2 * _CLOSE, 1 + 2 * _CLOSE]).ravel(), at[i], at[i + 1])
        beside, step = function(sides), min(wanted, abs(value[i + 1] - value[i]))
        if len(root) and bool((np.abs(beside - wanted) <= STEPS * step).all()):
            solutions += root.tolist()
        else:
            at, value = np.append(at, sides), np.append(value, beside)
    order = np.argsort(at)
    return Curve(at[order], value[order], None, None), sorted(solutions)


def _extreme(distance: Callable[[float], float], low: float, high: float) -> float:
    """Where a distance is least within a bracket."""
    from scipy.optimize import minimize_scalar

    within = {"xatol": 1e-4 * (high - low)}
    return float(minimize_scalar(distance, bounds=(low, high), method="bounded", options=within).x)


def _passed(function: Function, wanted: float, low: float, high: float) -> Floats:
    """Where the quantity passes the wanted value between two others; nothing where it is not known."""
    from scipy.optimize import brentq

    def gap(x: float) -> float:
        # what has no end is far away
        return float(np.clip(function(np.array([x]))[0] - wanted, -10 * wanted, 10 * wanted))

    try:
        return np.array([brentq(gap, low, high, xtol=_CLOSE * high, rtol=_CLOSE)])
    except ValueError:
        return np.zeros(0)
