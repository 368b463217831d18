"""S21: P5–P8, figs 2 and 4."""

import math
from collections.abc import Callable

from ...equations import accuracy, indirect, synthesis
from . import Row, figures, near, verdict

_Z, _R, _D, _KEY, _C1, _C2, _LOW, _HIGH = 8, 0.1, 0.05, 0.15, 20e3, 10e3, 0.1, 0.8
_INPUTS = "f 0.1…0.8, z 8, R 0.1 m, d 0.05 m, f_1 0.15, c_1 20 N/mm, c_2 10 N/mm"
_AXIS = (3.0, 12.0)
"""The range of C in fig. 2 is not printed; over this one both printed averages come out."""


def _factor(gain: float, c1: float = _C1) -> float:
    net = indirect.net_gain(gain, _R, _KEY, _D)
    return float(indirect.accuracy_factor(_LOW, _LOW, _HIGH, c1, _C2, _Z, net))


def _mean(function: Callable[[float], float], low: float, high: float) -> float:
    """Average over the gain by the midpoint rule."""
    count = 2000
    return sum(function(low + (high - low) * (i + 0.5) / count) for i in range(count)) / count


def _stiffer(gain: float) -> float:
    return _factor(gain) / _factor(gain, 2 * _C1)


def _doubled(gain: float) -> float:
    return _factor(gain) / _factor(2 * gain)


def p5() -> Row:
    """K_т falls when c_1 is doubled."""
    at = [_stiffer(gain) for gain in (1.0, 4.0)]
    average = _mean(_stiffer, *_AXIS)
    return Row(
        id="P5",
        source="S21 fig. 2",
        inputs=f"{_INPUTS}; c_1 20 → 40 N/mm",
        printed="K_т falls 1.03 times on average",
        computed=f"{at[0]:.3f} at C 1, {at[1]:.3f} at C 4; {average:.3f} on average over C 3…12",
        deviation=at[0] / 1.03 - 1,
        verdict=verdict(all(near(value, 1.03, 0.005) for value in at), near(average, 1.03, 0.005)),
        correction="C from 3 to 12, chosen to fit",
        why="axis not printed: two averages (this, P6) fitted by two ends of a range are consistent, not confirmed",
    )


def p6() -> Row:
    """K_т falls when C is doubled."""
    at = [_doubled(gain) for gain in (1.0, 2.0)]
    average = _mean(_doubled, _AXIS[0], _AXIS[1] / 2)
    return Row(
        id="P6",
        source="S21 fig. 2",
        inputs=f"{_INPUTS}; C doubled",
        printed="K_т falls 1.18 times on average",
        computed=f"{at[0]:.3f} (C 1 → 2), {at[1]:.3f} (2 → 4); {average:.3f} on average with C and 2C in 3…12",
        deviation=at[0] / 1.18 - 1,
        verdict=verdict(all(near(value, 1.18, 0.005) for value in at), near(average, 1.18, 0.005)),
        correction="C from 3 to 12, chosen to fit",
        why="axis not printed: two averages (this, P5) fitted by two ends of a range are consistent, not confirmed",
    )


def p7() -> Row:
    """The base clutch is more accurate."""
    gains = (1.0, 2.0, 4.0)
    base = [float(accuracy.accuracy_factor(0, _Z, gain, _LOW, _LOW, _HIGH, _HIGH)) for gain in gains]
    own = [_factor(gain) for gain in gains]
    return Row(
        id="P7",
        source="S21 fig. 2",
        inputs=_INPUTS,
        printed="the base clutch is more accurate than the indirect one",
        computed=f"C 1, 2, 4: base {figures(base)}; indirect {figures(own)}",
        deviation=None,
        verdict=verdict(all(first < second for first, second in zip(base, own, strict=True))),
        correction=None,
        why="the paper's conclusion 1 says the opposite (M26)",
    )


def _ball(gain: float, force: float) -> tuple[float, float]:
    """r_ш and x_max with r = 50 mm, s = y = 2 mm (not printed)."""
    net = indirect.net_gain(gain, _R, _KEY, _D)
    stiffness = indirect.sleeve_stiffness(_C1, _C2, _Z, _HIGH, net)
    travel = float(indirect.travel(_Z, force, _HIGH, _LOW, net, stiffness))
    sine = math.sin(math.atan(synthesis.tan_wall_angle(gain, 0.05, _R)))
    return float(synthesis.ball_radius(travel, 0.002, 0.002, sine)), travel


def p8() -> Row:
    """Ball radius falls, travel grows with the gain."""
    gains = [0.6 + 0.001 * i for i in range(30000)]
    points = [_ball(gain, 1000.0) for gain in gains]
    radii, travels = [point[0] for point in points], [point[1] for point in points]
    grows = all(later > earlier for earlier, later in zip(travels, travels[1:], strict=False))
    top = radii.index(max(radii))
    bottom = top + radii[top:].index(min(radii[top:]))
    falls_between = all(b < a for a, b in zip(radii[top:bottom], radii[top + 1 : bottom], strict=False))
    return Row(
        id="P8",
        source="S21 fig. 4",
        inputs=f"{_INPUTS}; F_п1 1 kN, r 50 mm, s = y = 2 mm (none printed)",
        printed="r_ш falls, x_max grows with C",
        computed=f"x_max grows; r_ш rises to C = {gains[top]:.2f}, falls to C = {gains[bottom]:.1f}, then grows again",
        deviation=None,
        verdict=verdict(grows and top == 0 and bottom == len(radii) - 1, grows and falls_between),
        correction="with its range of C stated",
        why="r_ш ∝ (x_max + s + 2y)/sin α has a maximum just above the threshold 0.6 and a minimum beyond",
    )


CHECKS = (p5, p6, p7, p8)
