"""F11: P13–P16, all of fig. 2."""

import math
from collections.abc import Callable

from ...equations import accuracy
from ...messages import say
from ..figures.fokin2011 import CONTROLLED, GAIN, RANGES, factor, line
from .found import Found, bisect, verdict


def p13() -> Found:
    """Curves 1–3 rise with n, line 4 is level."""

    def shapes(bypass: int) -> list[float]:
        return [float(factor(1.5, 1, *own, bypass) - factor(0.5, 1, *own, bypass)) for own in RANGES]

    def as_described(rises: list[float]) -> bool:
        return all(rise > 0 for rise in rises[:3]) and abs(rises[3]) < 1e-12

    return Found(
        say("K_т(n = 1.5) − K_т(0.5): {two:.3f} with z_1 = 2; {one:.3f} with z_1 = 1", two=shapes(2), one=shapes(1)),
        verdict(as_described(shapes(2)), as_described(shapes(1))),
    )


def p14() -> Found:
    """Unlike materials beat one material for p > 1, except at n = 1.5."""
    ranges = RANGES[:3]
    lines = [line(*own) for own in ranges]
    at = [float(factor(1.5, 1.2, *own)) for own in ranges]
    worse_at_n = all(curve > level for curve, level in zip(at, lines, strict=True))
    meet = [_break_even(1.5, *own) for own in ranges]
    # K_т tends to a limit as n grows: above the p of that limit no n breaks even
    last = [_break_even(1e12, *own) for own in ranges]
    return Found(
        say(
            "lines {lines:.3f}; n 1.5, p 1.2: {at:.3f}; break-even at n 1.5: p = {meet:.3f}; at some n: p < {last:.3f}",
            lines=lines,
            at=at,
            meet=meet,
            last=last,
        ),
        verdict(worse_at_n),
    )


def _break_even(n: float, low: float, high: float) -> float:
    """Return p where the curve at n meets the line of the same friction."""
    return bisect(lambda p: float(factor(n, p, low, high)) - line(low, high), 1, 2)


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
    return Found(
        say(
            "elasticities: n {in_n:.3f}, p {in_p:.3f}, m {by_max:.3f} (by f_1max) or {by_min:.3f} (by f_1min)",
            in_n=in_n,
            in_p=in_p,
            by_max=in_m[0],
            by_min=in_m[1],
        ),
        verdict(abs(in_n) > max(abs(in_p), *map(abs, in_m))),
    )


def p16() -> Found:
    """The loss of accuracy is steepest at n = 1.2…1.5."""
    at = (0.5, 1.0, 1.2, 1.5)
    slopes = [float(accuracy.slope_in_ratio_max(1, CONTROLLED, GAIN, n, 1, *RANGES[0])) for n in at]
    return Found(
        say("∂K_т/∂n at n = {at}: {slopes:.3f}", at=at, slopes=slopes), verdict(min(slopes[2:]) >= max(slopes[:2]))
    )


CHECKS = {"P13": p13, "P14": p14, "P15": p15, "P16": p16}
