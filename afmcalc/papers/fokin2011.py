"""Фокин and others 2011 (F11): figure 2, and the claims P13–P16 about it."""

import math
from collections.abc import Callable

import numpy as np

from ..arrays import Values
from ..equations import accuracy
from ..messages import say
from .claims import Found, verdict
from .figures import PaperAxis, PaperFigure, curve

RANGES = ((0.10, 0.6), (0.14, 0.7), (0.16, 0.7), (0.16, 0.8))
"""f_1min and f_1max of curves 1–4."""
CONTROLLED, GAIN = 6, 1.25


def factor(n: Values, p: Values, low: Values, high: Values, bypass: int = 1) -> Values:
    """K_т of curves 1–4."""
    return accuracy.accuracy_factor_by_ratios(bypass, CONTROLLED, GAIN, n, p, low, high)


def line(low: float, high: float) -> float:
    """K_т of lines 5–7: one material; F11 counts only the driven pairs in z."""
    return float(accuracy.accuracy_factor(0, CONTROLLED, GAIN, low, low, high, high))


def figure_2() -> PaperFigure:
    """K_т over n = f_2max/f_1max, formula (17); lines 5–7 one material."""
    n = np.linspace(0.5, 1.5, 101)
    curves = [
        curve(str(number), f"f_1 = {low:.2f}…{high:.1f}", n, factor(n, 1.0, low, high))
        for number, (low, high) in enumerate(RANGES, start=1)
    ]
    curves += [
        curve(str(number), f"one material, f = {low:.2f}…{high:.1f}", n, line(low, high))
        for number, (low, high) in enumerate(RANGES[:3], start=5)
    ]
    return PaperFigure(
        name="F11 fig. 2",
        title="accuracy factor against the ratio of the largest frictions",
        panels=[curves],
        x=PaperAxis("ratio f_2max/f_1max", "n"),
        y=[PaperAxis("accuracy factor", "K_т")],
        inputs="Formula (17), z_2 = 6, C = 1.25; lines 5–7: z = 6, all pairs controlled.",
        corrections=[
            "M4: z_1 = 1, printed 2, with which all four curves fall (z_1 = 2 with C = 0.625 mends it too)",
            "M5: K_т grows with n while C < 1/(z_1 f_1max), so n > 1 lowers the accuracy",
        ],
        assumed="p = f_2min/f_1min = 1 and n = 0.5…1.5.",
    )


def p13() -> Found:
    """Curves 1–3 rise with n, line 4 is level."""

    def shapes(bypass: int) -> list[float]:
        return [float(factor(1.5, 1, *own, bypass) - factor(0.5, 1, *own, bypass)) for own in RANGES]

    def as_described(rises: list[float]) -> bool:
        return all(rise > 0 for rise in rises[:3]) and abs(rises[3]) < 1e-12

    text = say("K_т(n = 1.5) − K_т(0.5): {two:.3f} with z_1 = 2; {one:.3f} with z_1 = 1", two=shapes(2), one=shapes(1))
    return Found(text, verdict(as_described(shapes(2)), as_described(shapes(1))))


def p14() -> Found:
    """Unlike materials beat one material for p > 1, except at n = 1.5."""
    ranges = RANGES[:3]
    lines = [line(*own) for own in ranges]
    at = [float(factor(1.5, 1.2, *own)) for own in ranges]
    worse_at_n = all(curve > level for curve, level in zip(at, lines, strict=True))
    meet = [_break_even(1.5, *own) for own in ranges]
    # K_т tends to a limit as n grows: above the p of that limit no n breaks even
    last = [_break_even(1e12, *own) for own in ranges]
    text = say(
        "lines {lines:.3f}; n 1.5, p 1.2: {at:.3f}; break-even at n 1.5: p = {meet:.3f}; at some n: p < {last:.3f}",
        lines=lines,
        at=at,
        meet=meet,
        last=last,
    )
    return Found(text, verdict(worse_at_n))


def _break_even(n: float, low: float, high: float) -> float:
    """Return p where the curve at n meets the line of the same friction."""
    ratios = np.linspace(1, 2, 10001)
    return float(np.interp(-line(low, high), -factor(n, ratios, low, high), ratios))


def _elasticity(function: Callable[[float], float]) -> float:
    step = 1e-5
    return (math.log(function(1 + step)) - math.log(function(1 - step))) / (2 * step)


def p15() -> Found:
    """P and m matter less than n."""
    low, high = RANGES[0]
    in_n = _elasticity(lambda t: float(factor(t, 1, low, high)))
    in_p = _elasticity(lambda t: float(factor(1, t, low, high)))
    in_m = [
        _elasticity(lambda t: float(factor(1, 1, low, high * t))),
        _elasticity(lambda t: float(factor(1, 1, low / t, high))),
    ]
    text = say(
        "elasticities: n {in_n:.3f}, p {in_p:.3f}, m {by_max:.3f} (by f_1max) or {by_min:.3f} (by f_1min)",
        in_n=in_n,
        in_p=in_p,
        by_max=in_m[0],
        by_min=in_m[1],
    )
    return Found(text, verdict(abs(in_n) > max(abs(in_p), *map(abs, in_m))))


def p16() -> Found:
    """The loss of accuracy is steepest at n = 1.2…1.5."""
    at = (0.5, 1.0, 1.2, 1.5)
    slopes = [float(accuracy.slope_in_ratio_max(1, CONTROLLED, GAIN, n, 1, *RANGES[0])) for n in at]
    text = say("∂K_т/∂n at n = {at}: {slopes:.3f}", at=at, slopes=slopes)
    return Found(text, verdict(min(slopes[2:]) >= max(slopes[:2])))
