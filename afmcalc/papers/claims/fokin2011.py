"""F11: P13–P16, all of fig. 2."""

import math
from collections.abc import Callable

from ...equations import accuracy
from . import Row, figures, verdict

_RANGES = ((0.1, 0.6), (0.14, 0.7), (0.16, 0.7), (0.16, 0.8))
_INPUTS = "C 1.25, z_2 6; f_1 0.1…0.6, 0.14…0.7, 0.16…0.7, 0.16…0.8"
_GAIN, _DRIVEN = 1.25, 6


def _factor(n: float, p: float, low: float, high: float, bypass: int = 1) -> float:
    return float(accuracy.accuracy_factor_by_ratios(bypass, _DRIVEN, _GAIN, n, p, low, high))


def _line(low: float, high: float) -> float:
    """Lines 5–7: one material; F11 counts only the driven pairs in z."""
    return float(accuracy.accuracy_factor(1, _DRIVEN, _GAIN, low, low, high, high))


def p13() -> Row:
    """Curves 1–3 rise with n, line 4 is level."""

    def shapes(bypass: int) -> list[float]:
        return [_factor(1.5, 1, *own, bypass) - _factor(0.5, 1, *own, bypass) for own in _RANGES]

    def as_described(rises: list[float]) -> bool:
        return all(rise > 0 for rise in rises[:3]) and abs(rises[3]) < 1e-12

    return Row(
        id="P13",
        source="F11 fig. 2",
        inputs=f"{_INPUTS}; z_1 = 2 printed",
        printed="curves 1–3 rise with n, 4 is level",
        computed=f"K_т(n = 1.5) − K_т(0.5): {figures(shapes(2))} with z_1 = 2; {figures(shapes(1))} with z_1 = 1",
        deviation=None,
        verdict=verdict(as_described(shapes(2)), as_described(shapes(1))),
        correction="M4",
        why="with z_1 = 2 the gain 1.25 exceeds 1/(z_1 f_1max) and all four fall; z_1 = 1 mends it (or C = 0.625)",
    )


def p14() -> Row:
    """Unlike materials beat one material for p > 1, except at n = 1.5."""
    lines = [_line(*own) for own in _RANGES[:3]]
    at = [_factor(1.5, 1.2, *own) for own in _RANGES[:3]]
    worse_at_n = all(curve > line for curve, line in zip(at, lines, strict=True))
    break_even = [_break_even(*own) for own in _RANGES[:3]]
    return Row(
        id="P14",
        source="F11 fig. 2, lines 5–7",
        inputs=_INPUTS,
        printed="for p > 1 unlike materials are better, except at n = 1.5",
        computed=f"lines {figures(lines)}; n 1.5, p 1.2: {figures(at)}; break-even at n 1.5: p = {figures(break_even)}",
        deviation=None,
        verdict=verdict(worse_at_n),
        correction=None,
        why="the exception at n = 1.5 holds only for p below the break-even, not for p = 1.2",
    )


def _break_even(friction_min: float, friction_max: float) -> float:
    """Return p between 1 and 2 where the curve at n = 1.5 meets the line, by bisection."""
    low, high = 1.0, 2.0
    for _ in range(100):
        middle = (low + high) / 2
        above = _factor(1.5, middle, friction_min, friction_max) > _line(friction_min, friction_max)
        low, high = (middle, high) if above else (low, middle)
    return low


def _elasticity(function: Callable[[float], float]) -> float:
    step = 1e-5
    return (math.log(function(1 + step)) - math.log(function(1 - step))) / (2 * step)


def p15() -> Row:
    """P and m matter less than n."""
    low, high = _RANGES[0]
    in_n = _elasticity(lambda t: _factor(t, 1, low, high))
    in_p = _elasticity(lambda t: _factor(1, t, low, high))
    in_m = [_elasticity(lambda t: _factor(1, 1, low, high * t)), _elasticity(lambda t: _factor(1, 1, low / t, high))]
    return Row(
        id="P15",
        source="F11 text, curve 1",
        inputs=f"{_INPUTS}; n = p = 1",
        printed="p and m matter less than n",
        computed=f"elasticities: n {in_n:.3f}, p {in_p:.3f}, m {in_m[0]:.3f} (by f_1max) or {in_m[1]:.3f} (by f_1min)",
        deviation=None,
        verdict=verdict(abs(in_n) > max(abs(in_p), *map(abs, in_m))),
        correction=None,
        why="n matters least",
    )


def p16() -> Row:
    """The loss of accuracy is steepest at n = 1.2…1.5."""
    low, high = _RANGES[0]
    at = (0.5, 1.0, 1.2, 1.5)
    slopes = [float(accuracy.slope_in_ratio_max(1, _DRIVEN, _GAIN, n, 1, low, high)) for n in at]
    return Row(
        id="P16",
        source="F11 text, curve 1",
        inputs=f"{_INPUTS}; p = 1",
        printed="the loss of accuracy is steepest at n = 1.2…1.5",
        computed=f"∂K_т/∂n at n = {', '.join(map(str, at))}: {figures(slopes)}",
        deviation=None,
        verdict=verdict(min(slopes[2:]) >= max(slopes[:2])),
        correction=None,
        why="the slope falls with n throughout",
    )


CHECKS = (p13, p14, p15, p16)
