"""Search for a wanted value of what is asked of one clutch at a time: an event in the drive, a sample, a life.

Each value takes up to a second and is known to some digits only, so that few are looked at, and brackets are narrowed
by secants.
"""

import math

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
    from scipy.optimize import brentq, minimize_scalar

    def gap(x: float) -> float:
        # what has no end is far away
        return float(np.clip(function(np.array([x]))[0] - wanted, -10 * wanted, 10 * wanted))

    at = at[~np.isnan(function(at))]
    value = function(at)
    side = np.sign(value - wanted)
    k = int(np.argmin(np.abs(value - wanted))) if len(at) else 0
    if 0 < k < len(at) - 1 and bool((side == side[0]).all()):
        towards, ends = side[0], (at[k - 1], at[k + 1])
        within = {"xatol": 1e-4 * (ends[1] - ends[0])}
        extreme = minimize_scalar(
            lambda x: towards * function(np.array([x]))[0], bounds=ends, method="bounded", options=within
        )
        at = np.insert(at, k + int(extreme.x > at[k]), extreme.x)
        value = function(at)
        side = np.sign(value - wanted)
    on = np.append(False, side == 0)
    solutions, jumps = at[on[1:] & ~on[:-1]].tolist(), []
    for i in np.flatnonzero(side[:-1] * side[1:] < 0):
        try:
            root = brentq(gap, at[i], at[i + 1], xtol=_CLOSE * at[i + 1], rtol=_CLOSE)
        except ValueError:  # it is not known somewhere between
            continue
        beside = np.clip([root * (1 - 2 * _CLOSE), root * (1 + 2 * _CLOSE)], at[i], at[i + 1])
        step = min(wanted, abs(value[i + 1] - value[i]))
        if bool((np.abs(function(beside) - wanted) <= STEPS * step).all()):
            solutions.append(root)
        else:
            jumps += beside.tolist()
    at = np.sort(np.append(at, jumps))
    return Curve(at, function(at), None, None), sorted(solutions)
