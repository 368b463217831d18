"""Шишкарев 2022 (S22), overload with a torque margin: curves of figures 1–4, claims P9–P12, P18–P22 and P31–P37."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from ..equations import accuracy, adjustment, direct, indirect, overload
from ..equations.arrays import Values
from ..messages import translate
from .claims import Recomputed, near

_THRESHOLD: Any = adjustment.DIRECT_ONE_MATERIAL["pairs_threshold"]
_GAIN_LIMIT: Any = direct.DIFFERENTIATED["gain_limit"]
_REDUCED_LIMIT: Any = direct.ALL_DRIVING["gain_limit"]

MARGIN, LOW, HIGH = 1.25, 0.1, 0.8
HIGH_GAIN = float(_REDUCED_LIMIT(1))
"""Largest zC."""
_FORCE = 4, 200.0, 1.0
"""z, F_п and R, of which claims take F_п R = 200 N·m."""


def factor(reduced: Values, friction: Values = HIGH, low: float = LOW, margin: float = MARGIN) -> Values:
    """A of (15) with a reduced gain: published over expected torque."""
    here, at_min = overload.loop_gain(reduced, 1, friction), overload.loop_gain(reduced, 1, low)
    return overload.actuation_factor(here, at_min, friction, low, margin)


def expected_factor(reduced: Values, friction: Values = HIGH) -> Values:
    """K_т of (18) with a reduced gain, up to a friction."""
    return accuracy.accuracy_factor_of_path(0, 1, reduced, LOW, LOW, friction, friction)


def actual_factor(reduced: Values) -> Values:
    """K_т of (18) or (19) by case: the trip is at the larger of T_ср and T_муф."""
    return expected_factor(reduced) * np.maximum(factor(reduced), 1.0)


def figure_1() -> Iterator[tuple[Values, Values]]:
    """Friction bound (11) over the number of pairs, reconstructed."""
    pairs, smooth = np.arange(2.0, 11.0), np.linspace(2, 10, 161)
    yield smooth, overload.friction_bound(smooth, MARGIN, 5.0)
    yield pairs, overload.friction_bound(pairs, MARGIN, 5.0)
    yield smooth, HIGH


def figure_2() -> Iterator[tuple[Values, Values]]:
    """Discriminant and roots of (17) over the reduced gain; the right root where it lies below f = 1."""
    reduced = np.linspace(0.02, 5, 250)
    gains = {low: overload.loop_gain(reduced, 1, low) for low in (0.1, 0.2)}
    for gain in gains.values():
        yield reduced, overload.discriminant(MARGIN, gain)
    for low, gain in gains.items():
        yield reduced, overload.friction_at_equal_potential(low, MARGIN, gain)
    shown = reduced[reduced >= 1]
    yield shown, overload.friction_at_unit_loop_gain(shown)


def figure_3() -> Iterator[tuple[Values, Values]]:
    """Actual and expected accuracy over the reduced gain."""
    reduced = np.linspace(0, 5, 501)
    yield reduced, actual_factor(reduced)
    yield reduced, expected_factor(reduced)


def figure_4() -> Iterator[tuple[Values, Values]]:
    """A over the number of driving pairs."""
    bypass = np.array([1.0, 2.0, 3.0])
    # C = 1/(z_1 f_max) for z_1 ≥ 2; z_1 = 1 with the stated reduced gain
    differentiated = factor(np.array([1.6, *((4 - z1) / (z1 * HIGH) for z1 in (2.0, 3.0))]))
    yield bypass, factor(1.6)
    yield bypass, factor(5.0)
    yield bypass, differentiated
    yield bypass, 1 / differentiated


def p9() -> Recomputed:
    """Ratio of the two accuracy factors."""
    computed = float(factor(5))
    return Recomputed({"factor": computed}, near(computed, 3, 0.005), deviation=computed / 3 - 1)


def p10() -> Recomputed:
    """Optimum of the reduced gain."""
    scan = np.linspace(0.5, 5.5, 5001)
    best = float(scan[np.argmin(actual_factor(scan))])
    values = {
        "best": best, "closed": float(overload.optimal_reduced_gain(HIGH)), "there": factor(1.6),
    }  # fmt: skip
    return Recomputed(values, near(best, 1.6, 0.05), deviation=best / 1.6 - 1)


def p11() -> Recomputed:
    """Friction above which T_ср exceeds the clutch's nominal torque."""
    threshold = float(overload.friction_at_unit_loop_gain(5))
    ratios = [float(factor(5, low, low)) for low in (0.1, 0.2, 0.3)]
    as_printed = near(threshold, 0.2, 1e-12) and ratios[0] < 1 < ratios[2]
    return Recomputed({"threshold": threshold, "ratios": ratios}, as_printed, deviation=threshold / 0.2 - 1)


def p12() -> Recomputed:
    """The discriminant of (17) is positive."""
    values = [float(overload.discriminant(MARGIN, 0.05 * i * low)) for low in (0.1, 0.2) for i in range(101)]
    return Recomputed({"low": min(values), "high": max(values)}, min(values) > 0)


def p18() -> Recomputed:
    """Curves 4 and 6 of fig. 2 fall: the right end of (17), from its discriminant, comes down to f_min."""
    reduced = np.linspace(HIGH_GAIN / 4, HIGH_GAIN, 61)
    ends = [np.asarray(_right_end(reduced, low)) for low in (0.1, 0.2)]
    first, second = (end[[0, 20, 60]].tolist() for end in ends)
    return Recomputed({"first": first, "second": second}, bool(np.all(np.diff(ends) < 0)))


def _right_end(reduced: Values, low: float) -> Values:
    """Right end of (17) as printed, by its discriminant."""
    u = overload.loop_gain(reduced, 1, low)
    weight = MARGIN * (1 + u)
    return (weight + overload.discriminant(MARGIN, u) ** 0.5) / (2 * reduced * (weight - u))


def p19() -> Recomputed:
    """Minimum of fig. 1."""
    bound = {z: float(overload.friction_bound(z, MARGIN, 5)) for z in range(2, 31)}
    best = min(bound, key=lambda z: bound[z])
    mended = best == 3 and bound[best] > HIGH
    return Recomputed({"best": best, "bound": bound[best]}, as_printed=False, corrected=mended, deviation=best / 3 - 1)


def p20() -> Recomputed:
    """Safe range of f_min with fewer driving pairs."""
    limits = [float(overload.friction_at_unit_loop_gain((4 - z1) * _GAIN_LIMIT(z1, HIGH))) for z1 in (1, 2, 3)]
    return Recomputed({"limits": limits}, limits[0] > limits[1] > limits[2])


def p21() -> Recomputed:
    """Actuation torque with differentiated pairs, equal in all but z_1; and with the gains of fig. 4, over T_н."""

    def torques(reduced: float) -> list[float]:
        """T_ср(f_max), all-driving first; C is the same, so (z − z_1) C is less."""
        gains = reduced * (1 - np.arange(4) / 4)
        expected = overload.expected_torque(*_FORCE, HIGH, overload.loop_gain(gains, 1, HIGH))
        return np.asarray(factor(gains) * expected).tolist()

    (driving, *equal), (least, *optimum) = torques(HIGH_GAIN), torques(1.6)
    drawn = np.array([1.6, 1.25, 1 / 2.4])
    values = {
        "driving": driving, "equal": equal, "least": least, "optimum": optimum,
        "published": np.asarray(factor(drawn) * expected_factor(drawn)).tolist(),
        "whole": float(factor(1.6) * expected_factor(1.6)),
    }  # fmt: skip
    return Recomputed(values, min(equal) > driving, equal[0] > driving)


def p22() -> Recomputed:
    """Three claims that hold."""
    net = indirect.net_gain(1.0, indirect.gain_threshold(0.1, 0.15, 0.05))
    friction = np.linspace(LOW, HIGH, 101)
    rises = bool(np.all(np.diff(friction / indirect.sleeve_stiffness(20e3, 10e3, 8, friction, net)) > 0))
    ends = [float(overload.friction_at_equal_potential(low, MARGIN, 5 * low)) for low in (0.1, 0.2)]
    thresholds = [float(_THRESHOLD(1, 1.6, 0.15, 0.33, margin)) for margin in (1.25, 1.5)]
    values = {"rises": translate("yes" if rises else "no"), "ends": ends, "thresholds": thresholds}
    return Recomputed(values, rises and ends[0] < 0.1 and ends[1] < 0.2 and thresholds[1] < thresholds[0])


def p31() -> Recomputed:
    """The potential torque falls by less than the load rises, at f_min."""
    fall = float(overload.loop_gain(HIGH_GAIN, 1, LOW))
    return Recomputed({"fall": fall}, fall < 1)


def p32() -> Recomputed:
    """The potential torque falls faster at f_max than at f_min."""
    slow, fast = (float(overload.loop_gain(HIGH_GAIN, 1, friction)) for friction in (LOW, HIGH))
    return Recomputed({"slow": slow, "fast": fast}, fast > slow)


def p33() -> Recomputed:
    """With a margin, accuracy falls as the reduced gain grows, since T_ср exceeds T_муф over more of the friction."""
    reduced = np.linspace(0.25, HIGH_GAIN, 96)
    best = float(overload.optimal_reduced_gain(HIGH))
    rising = np.diff(actual_factor(reduced)) > 0
    shown = np.array([0.5, 1.25, 2.0, 5.0])
    ends = np.minimum(overload.friction_at_unit_loop_gain(shown), HIGH).tolist()
    values = {"factors": np.asarray(actual_factor(shown)).tolist(), "ends": ends}
    return Recomputed(values, bool(np.all(rising)), bool(np.all(rising == (reduced[:-1] >= best - 1e-9))))


def p34() -> Recomputed:
    """The all-driving clutch is the more accurate one, without and with the effect of the margin."""
    reduced = np.arange(1.0, 12.0) * _GAIN_LIMIT(1, HIGH)  # of z - 1 pairs
    expected, actual = np.asarray(expected_factor(reduced)), np.asarray(actual_factor(reduced))
    driving = [float(of(HIGH_GAIN)) for of in (expected_factor, actual_factor)]
    shown = [2, 3, 4, 6]
    values = {
        "driving": driving, "expected": expected[shown].tolist(), "actual": actual[shown].tolist(),
    }  # fmt: skip
    return Recomputed(values, bool(np.any((expected > driving[0]) & (actual > driving[1]))))


def _potential(reduced: float, margin: float = MARGIN) -> float:
    """T_п(f_max)."""
    return float(overload.potential_torque(*_FORCE, HIGH, margin, overload.loop_gain(reduced, 1, LOW)))


def p35() -> Recomputed:
    """The potential torque of the all-driving clutch is the smaller one, whatever z_1."""
    least, *torques = (_potential(HIGH_GAIN * (1 - bypass / 4)) for bypass in range(4))
    return Recomputed({"least": least, "torques": torques}, min(torques) > least)


def p36() -> Recomputed:
    """There is an interval of friction in which T_ср does not exceed the nominal torque."""
    friction = np.linspace(LOW, HIGH, 70001)
    ratios = np.asarray(factor(HIGH_GAIN, friction))
    over_nominal = ratios * expected_factor(HIGH_GAIN, friction)
    expected, nominal = (float(friction[of <= 1 + 1e-12][-1]) for of in (ratios, over_nominal))
    holds = (near(end, 1 / HIGH_GAIN, 0.001) for end in (nominal, expected))
    return Recomputed({"expected": expected, "nominal": nominal}, *holds)


def p37() -> Recomputed:
    """Without a margin both torques are smaller, at the largest reduced gain."""
    without, with_margin = (_potential(HIGH_GAIN, margin) for margin in (1.0, MARGIN))
    friction = np.array([LOW, 0.15, 0.2, 0.4, HIGH])
    bare, factors = (np.asarray(factor(HIGH_GAIN, friction, margin=margin)) for margin in (1.0, MARGIN))
    less, smaller = without < with_margin, bare < factors
    values = {
        "without": without, "with_margin": with_margin, "friction": friction.tolist(), "bare": bare.tolist(),
        "factors": factors.tolist(),
    }  # fmt: skip
    beyond = smaller[friction > 1 / HIGH_GAIN]
    return Recomputed(values, bool(less and np.all(smaller)), bool(less and np.all(beyond)))
