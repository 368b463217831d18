"""Фокин and others 2011 (F11): curves of figure 2, and the claims P13–P16, P23, P47 and P48 about the figure.

Ratios of friction: n = f_2max/f_1max, p = f_2min/f_1min, m = f_1max/f_1min (driven pairs f_2, driving pairs f_1).
"""

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from ..equations import accuracy, unlike
from ..equations.arrays import Values
from .claims import Curves, Recomputed, judged

RANGES = ((0.10, 0.6), (0.14, 0.7), (0.16, 0.7), (0.16, 0.8))
"""Smallest and largest friction of the driving pairs, f_1min and f_1max, for curves 1–4."""
CONTROLLED, GAIN = 6, 1.25
_ALONG = np.linspace(0.5, 1.5, 101)
"""Values of the ratio n, the abscissa of the figure."""


def factor(n: Values, p: Values, low: Values, high: Values, bypass: int = 1) -> Any:
    """Accuracy factor K_т of curves 1–4."""
    return unlike.accuracy_factor_by_ratios(bypass, CONTROLLED, GAIN, n, p, low, high)


def line(low: float, high: float) -> float:
    """Accuracy factor K_т of lines 5–7, for one material; F11 counts only the driven pairs in z."""
    return accuracy.accuracy_factor_of_path(0, CONTROLLED, GAIN, low, low, high, high)


def figure_2() -> Curves:
    """Accuracy factor K_т over n = f_2max/f_1max: curves 1–4 by (17), lines 5–7 for one material."""
    ratios = _meeting_lines()
    # curve 4 has no line to meet; it has the ratio p of curve 3, whose f_1min is the same
    for limits, p in zip(RANGES, [*ratios, ratios[-1]], strict=True):
        yield _ALONG, factor(_ALONG, p, *limits)
    for limits in RANGES[:3]:
        yield _ALONG, line(*limits)


def p13() -> Recomputed:
    """Judge the claim that curves 1–3 rise with the ratio n and that curve 4 is level."""
    two, one = ([factor(1.5, 1, *own, z1) - factor(0.5, 1, *own, z1) for own in RANGES] for z1 in (2, 1))
    as_described = [min(rises[:3]) > 0 and abs(rises[3]) < 1e-12 for rises in (two, one)]
    return judged(*as_described, two=two, one=one)


def p14() -> Recomputed:
    """Judge the claim that unlike materials are better than one material for p > 1, and equally good at n = 1.5."""
    ranges = RANGES[:3]
    meet, lines = _meeting_lines(), [line(*limits) for limits in ranges]

    def as_described(bypass: int) -> Any:
        curves = [factor(_ALONG, p, *limits, bypass) - line(*limits) for p, limits in zip(meet, ranges, strict=True)]
        return all(np.all(curve[:-1] < 0) and abs(curve[-1]) < 1e-6 for curve in map(np.asarray, curves))

    return judged(
        as_described(2),
        as_described(1),
        meet=meet,
        lines=lines,
        early=[np.interp(line(*limits), factor(_ALONG, 1.01, *limits), _ALONG) for limits in ranges],
        at=[factor(1.5, 1.2, *limits) for limits in ranges],
        # K_т tends to a limit as n grows; if p is larger than at this limit, no n gives the K_т of the line
        last=[_break_even(1e12, *limits) for limits in ranges],
    )


def _meeting_lines() -> list[Any]:
    """Values of the ratio p with which curves 1–3 meet their lines 5–7 at n = 1.5."""
    return [_break_even(1.5, *limits) for limits in RANGES[:3]]


def _break_even(n: float, low: float, high: float) -> float:
    """Value of the ratio p with which the curve meets the line of the same friction range at the ratio n."""
    ratios = np.linspace(1, 2, 10001)
    return np.interp(-line(low, high), -factor(n, ratios, low, high), ratios)


def _elasticity(function: Callable[[float], Values]) -> float:
    step = 1e-5
    return (math.log(function(1 + step)) - math.log(function(1 - step))) / (2 * step)


def p15() -> Recomputed:
    """Judge the claim that the ratios p and m have less effect on K_т than the ratio n."""
    low, high = RANGES[0]
    values = {
        "in_n": _elasticity(lambda t: factor(t, 1, low, high)),
        "in_p": _elasticity(lambda t: factor(1, t, low, high)),
        "by_max": _elasticity(lambda t: factor(1, 1, low, high * t)),
        "by_min": _elasticity(lambda t: factor(1, 1, low / t, high)),
    }
    in_n, *others = map(abs, values.values())
    return judged(in_n > max(others), **values)


def p16() -> Recomputed:
    """Judge the claim that accuracy is lowest (K_т largest) at small p and n = 1.2…1.5, on curve 1."""
    at = (0.5, 1.0, 1.2, 1.5)

    def as_described(bypass: int) -> Any:
        curves = [[[factor(n, p, *limits, bypass) for n in at] for p in (0.8, 1.0, 1.2)] for limits in RANGES]
        small, large = curves[0][0], curves[0][-1]
        others = max(max(levels) for limits in curves[1:] for levels in limits)
        return min(small[2:]) > max(*small[:2], *large, others)

    return judged(
        as_described(2),
        as_described(1),
        at=at,
        small=[factor(n, 0.8, *RANGES[0]) for n in at],
        level=[factor(n, 1, *RANGES[0]) for n in at],
        slopes=[unlike.slope_in_ratio_max(1, CONTROLLED, GAIN, n, 1, *RANGES[0]) for n in at],
    )


def p23() -> Recomputed:
    """Judge the claim that accuracy rises with the ratio p on every curve."""

    def slopes(bypass: int, n: Values = 1.0, p: Values = 1.0) -> list[Any]:
        return [unlike.slope_in_ratio_min(bypass, CONTROLLED, GAIN, n, p, *limits) for limits in RANGES]

    n, p = np.meshgrid(np.linspace(0.5, 1.5, 21), np.linspace(0.5, 2, 31))
    falls = [all(np.all(slope < 0) for slope in slopes(bypass, n, p)) for bypass in (2, 1)]
    return judged(*falls, two=slopes(2), one=slopes(1))


def p47() -> Recomputed:
    """Judge the claim that unlike materials can be more accurate than one material."""

    def factors(n: float, p: float, bypass: int = 1) -> list[Any]:
        return [factor(n, p, *limits, bypass) for limits in RANGES[:3]]

    better: list[Any] = [np.all(np.less(factors(1.0, 1.2, z1), factors(1.0, 1.0, z1))) for z1 in (2, 1)]
    return judged(*better, alike=factors(1.0, 1.0), p=factors(1.0, 1.2), n=factors(0.8, 1.0))


def p48() -> Recomputed:
    """Judge the claim that a ratio n above 1 raises the accuracy and a ratio n below 1 lowers it."""
    curves = [[factor(n, 1, *limits) for n in (0.8, 1.0, 1.2)] for limits in RANGES]
    return judged(all(curve[0] > curve[1] > curve[2] for curve in curves), first=curves[0], last=curves[-1])
