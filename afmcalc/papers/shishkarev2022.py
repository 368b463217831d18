"""Шишкарев 2022 (S22), overload with a margin: curves of figures 1–4, claims P9–P12, P18–P22, P31–P37, P43–P46."""

from typing import Any

import numpy as np

from ..equations import accuracy, adjustment, direct, indirect, overload
from ..equations.arrays import Values
from ..messages import translate
from .claims import Curves, Recomputed, judged, near

_THRESHOLD: Any = adjustment.DIRECT_ONE_MATERIAL["pairs_threshold"]
_GAIN_LIMIT: Any = direct.DIFFERENTIATED["gain_limit"]
_REDUCED_LIMIT: Any = direct.ALL_DRIVING["gain_limit"]

MARGIN, LOW, HIGH = 1.25, 0.1, 0.8
HIGH_GAIN = _REDUCED_LIMIT(1)
"""Recommended upper limit of the reduced gain zC."""
_FORCE = 4, 200.0, 1.0
"""Number of pairs z, spring force F_п, N, and radius R, m; the claims depend only on the product F_п R = 200 N·m."""


def factor(reduced: Values, friction: Values = HIGH, low: float = LOW, margin: float = MARGIN) -> Any:
    """Factor A of (15) at a reduced gain: ratio of the published actuation torque to the expected torque."""
    here, at_min = overload.loop_gain(reduced, 1, friction), overload.loop_gain(reduced, 1, low)
    return overload.actuation_factor(here, at_min, friction, low, margin)


def expected_factor(reduced: Values, friction: Values = HIGH) -> Any:
    """Expected accuracy factor K_т by (18) at a reduced gain, from f_min up to ``friction``."""
    return accuracy.accuracy_factor_of_path(0, 1, reduced, LOW, LOW, friction, friction)


def actual_factor(reduced: Values) -> Any:
    """Actual accuracy factor K_т, by (18) or (19): the clutch trips at actuation torque T_ср or, if larger, T_муф."""
    return expected_factor(reduced) * np.maximum(factor(reduced), 1.0)


def figure_1() -> Curves:
    """Bound (11) of the friction over the number of pairs, reconstructed."""
    pairs, smooth = np.arange(2.0, 11.0), np.linspace(2, 10, 161)
    yield smooth, overload.friction_bound(smooth, MARGIN, 5.0)
    yield pairs, overload.friction_bound(pairs, MARGIN, 5.0)
    yield smooth, HIGH


def figure_2() -> Curves:
    """Discriminant and roots of (17) over the reduced gain; the right root only up to a friction of 1."""
    reduced = np.linspace(0.02, 5, 250)
    gains = {low: overload.loop_gain(reduced, 1, low) for low in (0.1, 0.2)}
    for gain in gains.values():
        yield reduced, overload.discriminant(MARGIN, gain)
    for low, gain in gains.items():
        yield reduced, overload.friction_at_equal_potential(low, MARGIN, gain)
    shown = reduced[reduced >= 1]
    yield shown, overload.friction_at_unit_loop_gain(shown)


def figure_3() -> Curves:
    """Actual and expected accuracy factor over the reduced gain."""
    reduced = np.linspace(0, 5, 501)
    yield reduced, actual_factor(reduced)
    yield reduced, expected_factor(reduced)


def figure_4() -> Curves:
    """Factor A over the number of driving pairs."""
    bypass = np.array([1.0, 2.0, 3.0])
    # gain C = 1/(z_1 f_max) for z_1 ≥ 2 bypass pairs; for z_1 = 1 the stated reduced gain
    differentiated = factor(np.array([1.6, *((4 - z1) / (z1 * HIGH) for z1 in (2.0, 3.0))]))
    yield bypass, factor(1.6)
    yield bypass, factor(5.0)
    yield bypass, differentiated
    yield bypass, 1 / differentiated


def p9() -> Recomputed:
    """Judge the printed ratio of the actual accuracy factor to the expected accuracy factor."""
    computed = factor(5)
    return judged(near(computed, 3, 0.005), deviation=computed / 3 - 1, factor=computed)


def p10() -> Recomputed:
    """Judge the printed optimum of the reduced gain."""
    scan = np.linspace(0.5, 5.5, 5001)
    best = scan[np.argmin(actual_factor(scan))]
    values = {"best": best, "closed": overload.optimal_reduced_gain(HIGH), "there": factor(1.6)}
    return judged(near(best, 1.6, 0.05), deviation=best / 1.6 - 1, **values)


def p11() -> Recomputed:
    """Judge the printed f_min above which the published actuation torque T_ср exceeds the clutch's nominal torque."""
    threshold = overload.friction_at_unit_loop_gain(5)
    ratios = [factor(5, low, low) for low in (0.1, 0.2, 0.3)]
    as_printed = near(threshold, 0.2, 1e-12) and ratios[0] < 1 < ratios[2]
    return judged(as_printed, deviation=threshold / 0.2 - 1, threshold=threshold, ratios=ratios)


def p12() -> Recomputed:
    """Judge the claim that the discriminant of (17) is positive."""
    values = [overload.discriminant(MARGIN, 0.05 * i * low) for low in (0.1, 0.2) for i in range(101)]
    return judged(min(values) > 0, low=min(values), high=max(values))


def p18() -> Recomputed:
    """Judge the claim, by curves 4 and 6 of fig. 2, that the right end of the interval (17) falls as zC grows."""
    reduced = np.linspace(HIGH_GAIN / 4, HIGH_GAIN, 61)
    ends = []
    for low in (0.1, 0.2):  # right end of the interval (17) as printed, from its discriminant
        u = overload.loop_gain(reduced, 1, low)
        weight = MARGIN * (1 + u)
        ends.append((weight + overload.discriminant(MARGIN, u) ** 0.5) / (2 * reduced * (weight - u)))
    first, second = (end[[0, 20, 60]] for end in ends)
    return judged(np.all(np.diff(ends) < 0), first=first, second=second)


def p19() -> Recomputed:
    """Judge the claim that fig. 1 has its minimum at z = 3, above practically all coefficients of friction."""
    bound = {z: overload.friction_bound(z, MARGIN, 5) for z in range(2, 31)}
    best = min(bound, key=lambda z: bound[z])
    mended = best == 3 and bound[best] > HIGH
    return judged(False, mended, deviation=best / 3 - 1, best=best, bound=bound[best])


def p20() -> Recomputed:
    """Judge the claim that fewer driving pairs widen the safe range of f_min."""
    limits = [overload.friction_at_unit_loop_gain((4 - z1) * _GAIN_LIMIT(z1, HIGH)) for z1 in (1, 2, 3)]
    return judged(limits[0] > limits[1] > limits[2], limits=limits)


def p21() -> Recomputed:
    """Judge the claim that actuation torque T_ср is larger if differentiated, at equal C or with gains of fig. 4."""

    def torques(reduced: float) -> list[Any]:
        """Published actuation torque T_ср at f_max for z_1 = 0…3 bypass pairs at equal C, so that (z − z_1) C falls."""
        gains = reduced * (1 - np.arange(4) / 4)
        expected = overload.expected_torque(*_FORCE, HIGH, overload.loop_gain(gains, 1, HIGH))
        return factor(gains) * expected

    (driving, *equal), (least, *optimum) = torques(HIGH_GAIN), torques(1.6)
    drawn = np.array([1.6, 1.25, 1 / 2.4])
    return judged(
        min(equal) > driving,
        equal[0] > driving,
        driving=driving,
        equal=equal,
        least=least,
        optimum=optimum,
        published=factor(drawn) * expected_factor(drawn),
        whole=factor(1.6) * expected_factor(1.6),
    )


def p22() -> Recomputed:
    """Judge three claims: T(f) has no dip (S21); curves 3 and 5 lie below f_min; (12) of S19 falls as β_н grows."""
    net = indirect.net_gain(1.0, indirect.gain_threshold(0.1, 0.15, 0.05))
    friction = np.linspace(LOW, HIGH, 101)
    rises = np.all(np.diff(friction / indirect.sleeve_stiffness(20e3, 10e3, 8, friction, net)) > 0)
    ends = [overload.friction_at_equal_potential(low, MARGIN, 5 * low) for low in (0.1, 0.2)]
    thresholds = [_THRESHOLD(1, 1.6, 0.15, 0.33, margin) for margin in (1.25, 1.5)]
    values = {"rises": translate("yes" if rises else "no"), "ends": ends, "thresholds": thresholds}
    return judged(rises and ends[0] < 0.1 and ends[1] < 0.2 and thresholds[1] < thresholds[0], **values)


def p31() -> Recomputed:
    """Judge the claim that, at f_min, the potential torque falls by less than the load rises."""
    fall = overload.loop_gain(HIGH_GAIN, 1, LOW)
    return judged(fall < 1, fall=fall)


def p32() -> Recomputed:
    """Judge the claim that the potential torque falls faster at f_max than at f_min."""
    slow, fast = (overload.loop_gain(HIGH_GAIN, 1, friction) for friction in (LOW, HIGH))
    return judged(fast > slow, slow=slow, fast=fast)


def p33() -> Recomputed:
    """Judge the claim that, with a margin, accuracy falls as zC grows, because T_ср > T_муф at more frictions."""
    reduced = np.linspace(0.25, HIGH_GAIN, 96)
    best = overload.optimal_reduced_gain(HIGH)
    rising = np.diff(actual_factor(reduced)) > 0
    shown = np.array([0.5, 1.25, 2.0, 5.0])
    ends = np.minimum(overload.friction_at_unit_loop_gain(shown), HIGH)
    values = {"factors": actual_factor(shown), "ends": ends}
    return judged(np.all(rising), np.all(rising == (reduced[:-1] >= best - 1e-9)), **values)


def p34() -> Recomputed:
    """Judge the claim that the all-driving clutch is more accurate, without and with the effect of the margin."""
    reduced = np.arange(1.0, 12.0) * _GAIN_LIMIT(1, HIGH)  # reduced gain of z − 1 pairs, z = 2…12
    expected, actual = expected_factor(reduced), actual_factor(reduced)
    shown, both = [2, 3, 4, 6], (expected_factor, actual_factor)
    driving = [of(HIGH_GAIN) for of in both]
    # compared at equal C: all of the z pairs are controlled, or all except one
    gains, pairs = np.meshgrid(np.linspace(0.05, 1, 20) / HIGH, np.arange(2.0, 13.0))
    better = all(np.all(np.less(of(gains), of(gains * (1 - 1 / pairs)))) for of in both)
    return judged(
        np.any((expected > driving[0]) & (actual > driving[1])),
        better,
        driving=driving,
        expected=expected[shown],
        actual=actual[shown],
        equal=[actual_factor(reduced) for reduced in (1.0, 0.75)],
    )


def _potential(reduced: float, margin: float = MARGIN) -> float:
    """Potential torque T_п at f_max, N·m."""
    return overload.potential_torque(*_FORCE, HIGH, margin, overload.loop_gain(reduced, 1, LOW))


def p35() -> Recomputed:
    """Judge the claim that potential torque is smaller if all-driving than with any number of bypass pairs."""
    least, *torques = (_potential(HIGH_GAIN * (1 - bypass / 4)) for bypass in range(4))
    return judged(min(torques) > least, least=least, torques=torques)


def p36() -> Recomputed:
    """Judge the claim that in an interval of friction the actuation torque T_ср does not exceed the nominal torque."""
    friction = np.linspace(LOW, HIGH, 70001)
    ratios = factor(HIGH_GAIN, friction)
    over_nominal = ratios * expected_factor(HIGH_GAIN, friction)
    expected, nominal = (friction[of <= 1 + 1e-12][-1] for of in (ratios, over_nominal))
    holds = (near(end, 1 / HIGH_GAIN, 0.001) for end in (nominal, expected))
    return judged(*holds, expected=expected, nominal=nominal)


def p37() -> Recomputed:
    """Judge the claim that, at the largest reduced gain, potential and actuation torque are smaller without margin."""
    without, with_margin = (_potential(HIGH_GAIN, margin) for margin in (1.0, MARGIN))
    friction = np.array([LOW, 0.15, 0.2, 0.4, HIGH])
    bare, factors = (factor(HIGH_GAIN, friction, margin=margin) for margin in (1.0, MARGIN))
    less, smaller = without < with_margin, bare < factors
    beyond = smaller[friction > 1 / HIGH_GAIN]
    values = {"without": without, "with_margin": with_margin, "friction": friction, "bare": bare, "factors": factors}
    return judged(less and np.all(smaller), less and np.all(beyond), **values)


def p43() -> Recomputed:
    """Judge the claim that, with a margin, potential torque exceeds nominal torque and is proportional to friction."""
    friction = np.array([LOW, 0.2, 0.4, HIGH])
    gain = overload.loop_gain(HIGH_GAIN, 1, LOW)
    potential = overload.potential_torque(*_FORCE, friction, MARGIN, gain)
    ratios = potential / overload.expected_torque(*_FORCE, LOW, gain)
    as_printed = np.all(ratios > 1) and np.ptp(ratios / friction) < 1e-9
    return judged(as_printed, friction=friction, ratios=ratios)


def p44() -> Recomputed:
    """Judge the claim that curve 2 of fig. 4 lies above line 1 and approaches this line with fewer driving pairs."""
    (_, line), _, (_, curve), (_, reciprocal) = figure_4()

    def as_described(points: Values, level: Values) -> Any:
        return np.all(np.diff(points) > 0) and np.all(points >= level - 1e-9)

    values = {"line": line, "curve": curve, "reciprocal": reciprocal}
    return judged(as_described(curve, line), as_described(reciprocal, 1 / line), **values)


def p45() -> Recomputed:
    """Judge the claim that, at the largest zC, a smaller margin raises the actuation torque only at small friction."""
    friction = np.linspace(LOW, HIGH, 7001)
    rises = factor(HIGH_GAIN, friction, margin=1.0) > factor(HIGH_GAIN, friction)
    limit = friction[~rises][0]
    once = not np.any(rises[friction > limit])
    values = {"limit": limit, "small": overload.friction_at_unit_loop_gain(1.0)}
    return judged(once and near(limit, 0.1, 0.005), once and near(limit, 0.2, 0.0005), **values)


def p46() -> Recomputed:
    """Judge the claim that, without a margin, the actuation torque equals the expected torque only at f_min."""
    friction = np.array([LOW, 0.15, 0.2, 0.4, HIGH])
    factors = factor(HIGH_GAIN, friction, margin=1.0)
    above = factors[1:] > 1 + 1e-9
    values = {"friction": friction, "factors": factors}
    return judged(np.all(above), np.all(above == (friction[1:] > 1 / HIGH_GAIN + 1e-9)), **values)
