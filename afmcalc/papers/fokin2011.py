"""Фокин and others 2011 (F11): figure 2, and the claims P13–P16 and P23 about it."""

import math
from collections.abc import Callable

import numpy as np

from ..equations import accuracy, unlike
from ..equations.arrays import Values
from ..messages import say
from .claims import Found, PaperAxis, PaperFigure, curve, verdict

RANGES = ((0.10, 0.6), (0.14, 0.7), (0.16, 0.7), (0.16, 0.8))
"""f_1min and f_1max of curves 1–4."""
CONTROLLED, GAIN = 6, 1.25


def factor(n: Values, p: Values, low: Values, high: Values, bypass: int = 1) -> Values:
    """K_т of curves 1–4."""
    return unlike.accuracy_factor_by_ratios(bypass, CONTROLLED, GAIN, n, p, low, high)


def line(low: float, high: float) -> float:
    """K_т of lines 5–7: one material; F11 counts only the driven pairs in z."""
    return float(accuracy.accuracy_factor_of_path(0, CONTROLLED, GAIN, low, low, high, high))


def figure_2() -> PaperFigure:
    """K_т over n = f_2max/f_1max, formula (17); lines 5–7 one material."""
    n = np.linspace(0.5, 1.5, 101)
    ratios = _meeting_lines()
    curves = [
        curve(str(number), f"f_1 = {low:.2f}…{high:.1f}", n, factor(n, p, low, high))
        # line 4 has no pair; it takes p of curve 3, which has its f_1min
        for number, ((low, high), p) in enumerate(zip(RANGES, [*ratios, ratios[-1]], strict=True), start=1)
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
        assumed="p = 1.033, 1.018, 1.020, 1.020: curves 1–3 meet lines 5–7 at n = 1.5 (P14); n = 0.5…1.5.",
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
    """Unlike materials beat one material for p > 1, except at n = 1.5 where they are level."""
    ranges = RANGES[:3]
    meet, lines = _meeting_lines(), [line(*limits) for limits in ranges]
    n = np.linspace(0.5, 1.5, 101)

    def as_described(bypass: int) -> bool:
        curves = [factor(n, p, *limits, bypass) - line(*limits) for p, limits in zip(meet, ranges, strict=True)]
        return all(np.all(curve[:-1] < 0) and abs(curve[-1]) < 1e-6 for curve in map(np.asarray, curves))

    text = say(
        "with p = {meet:.3f} curves 1–3 lie below lines {lines:.3f} and meet them at n = 1.5; with p = 1.01 they cross "
        "at n = {early:.2f}, with p = 1.2 they are at {at:.3f} for n = 1.5, and for p > {last:.3f} they never meet",
        meet=meet,
        lines=lines,
        early=[float(np.interp(line(*limits), factor(n, 1.01, *limits), n)) for limits in ranges],
        at=[float(factor(1.5, 1.2, *limits)) for limits in ranges],
        # K_т tends to a limit as n grows: above the p of that limit no n breaks even
        last=[_break_even(1e12, *limits) for limits in ranges],
    )
    return Found(text, verdict(as_described(2), as_described(1)))


def _meeting_lines() -> list[float]:
    """Return p with which curves 1–3 meet their lines 5–7 at n = 1.5."""
    return [_break_even(1.5, *limits) for limits in RANGES[:3]]


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
        in_n=in_n, in_p=in_p, by_max=in_m[0], by_min=in_m[1],
    )  # fmt: skip
    return Found(text, verdict(abs(in_n) > max(abs(in_p), *map(abs, in_m))))


def p16() -> Found:
    """The loss of accuracy, read as the level of K_т, is greatest at small p and n = 1.2…1.5, on curve 1."""
    at = (0.5, 1.0, 1.2, 1.5)

    def as_described(bypass: int) -> bool:
        curves = [[[float(factor(n, p, *limits, bypass)) for n in at] for p in (0.8, 1.0, 1.2)] for limits in RANGES]
        small, large = curves[0][0], curves[0][-1]
        others = max(max(levels) for limits in curves[1:] for levels in limits)
        return min(small[2:]) > max(small[:2]) and min(small[2:]) > max(*large, others)

    text = say(
        "K_т at n = {at}: {small:.3f} with p = 0.8, {level:.3f} with p = 1, where ∂K_т/∂n = {slopes:.3f}",
        at=at,
        small=[float(factor(n, 0.8, *RANGES[0])) for n in at],
        level=[float(factor(n, 1, *RANGES[0])) for n in at],
        slopes=[float(unlike.slope_in_ratio_max(1, CONTROLLED, GAIN, n, 1, *RANGES[0])) for n in at],
    )
    return Found(text, verdict(as_described(2), as_described(1)))


def p23() -> Found:
    """Accuracy rises with p, on every curve."""

    def slopes(bypass: int, n: Values = 1.0, p: Values = 1.0) -> list[Values]:
        return [unlike.slope_in_ratio_min(bypass, CONTROLLED, GAIN, n, p, *limits) for limits in RANGES]

    n, p = np.meshgrid(np.linspace(0.5, 1.5, 21), np.linspace(0.5, 2, 31))
    text = say("∂K_т/∂p at n = p = 1: {two:.3f} with z_1 = 2; {one:.3f} with z_1 = 1", two=slopes(2), one=slopes(1))
    falls = [all(np.all(np.asarray(slope) < 0) for slope in slopes(bypass, n, p)) for bypass in (2, 1)]
    return Found(text, verdict(*falls))
