"""S22: P9–P12 and P18–P22."""

import numpy as np

from ...equations import adjustment, direct, indirect, overload
from ...equations.overload import friction_bound
from ...messages import say, term
from ..figures.shishkarev2022 import HIGH, LOW, MARGIN, actual_factor, expected_factor, factor
from .found import Found, near, verdict


def p9() -> Found:
    """Ratio of the two accuracy factors."""
    computed = float(factor(5))
    return Found(say("A = {factor:.3f}", factor=computed), verdict(near(computed, 3, 0.005)), computed / 3 - 1)


def p10() -> Found:
    """Optimum of the reduced gain."""
    scan = np.linspace(0.5, 5.5, 5001)
    best = float(scan[np.argmin(actual_factor(scan))])
    closed = float(overload.optimal_reduced_gain(HIGH))
    return Found(
        say(
            "zC = {best:.3f} by scan, {closed:.3f} = 1/f_max; A(1.6) = {there:.3f}",
            best=best,
            closed=closed,
            there=factor(1.6),
        ),
        verdict(near(best, 1.6, 0.05), near(best, closed, 0.002)),
        best / 1.6 - 1,
    )


def p11() -> Found:
    """Friction above which T_ср exceeds the clutch's nominal torque."""
    threshold = float(overload.interval_high(5))
    ratios = [float(factor(5, low, low)) for low in (0.1, 0.2, 0.3)]
    return Found(
        say(
            "1/(zC) = {threshold:.3f}; T_ср/T_н.муф at f_min 0.1, 0.2, 0.3: {ratios:.3f}",
            threshold=threshold,
            ratios=ratios,
        ),
        verdict(near(threshold, 0.2, 1e-12) and ratios[0] < 1 < ratios[2]),
        threshold / 0.2 - 1,
    )


def p12() -> Found:
    """The discriminant of (17) is positive."""
    values = [float(overload.discriminant(MARGIN, 0.05 * i * low)) for low in (0.1, 0.2) for i in range(101)]
    low, high = min(values), max(values)
    return Found(say("D from {low:.4f} to {high:.4f}", low=low, high=high), verdict(low > 0))


def p18() -> Found:
    """Curves 4 and 6 of fig. 2: the right end of (17) from its discriminant."""
    ends = []
    for low in (0.1, 0.2):
        u = 5 * low
        weight = MARGIN * (1 + u)
        ends.append((weight + float(overload.discriminant(MARGIN, u)) ** 0.5) / (2 * 5 * (weight - u)))
    return Found(say("right end of (17): {ends:.3f} for both", ends=ends), verdict(not near(ends[0], ends[1], 1e-9)))


def p19() -> Found:
    """Minimum of fig. 1."""
    bound = {z: float(friction_bound(z, MARGIN, 5)) for z in range(2, 31)}
    best = min(bound, key=lambda z: bound[z])
    return Found(
        say("minimum at z = {best}, f = {bound:.2f}", best=best, bound=bound[best]),
        verdict(False, best == 3 and bound[best] > HIGH),
        best / 3 - 1,
    )


def p20() -> Found:
    """Safe range of f_min with fewer driving pairs."""
    limits = [float(overload.interval_high((4 - z1) * direct.gain_limit_differentiated(z1, HIGH))) for z1 in (1, 2, 3)]
    return Found(
        say("1/[(z − z_1) C] for z_1 = 1, 2, 3: {limits:.3f}", limits=limits),
        verdict(limits[0] > limits[1] > limits[2]),
    )


def p21() -> Found:
    """Actuation torque with differentiated pairs, over T_н."""
    reduced = np.array([1.6, 1.25, 1 / 2.4])
    published = np.asarray(factor(reduced) * expected_factor(reduced))
    actual = np.asarray(actual_factor(reduced))
    driving = float(factor(1.6) * expected_factor(1.6))
    return Found(
        say(
            "T_ср(f_max)/T_н: all-driving {driving:.2f}; z_1 = 1, 2, 3: {published:.2f} "
            "(with max(T_ср, T_муф): {actual:.2f})",
            driving=driving,
            published=published.tolist(),
            actual=actual.tolist(),
        ),
        verdict(bool(np.all(published > driving))),
    )


def p22() -> Found:
    """Three claims that hold."""
    net = indirect.net_gain(1.0, 0.1, 0.15, 0.05)
    friction = np.linspace(LOW, HIGH, 101)
    rises = bool(np.all(np.diff(friction / indirect.sleeve_stiffness(20e3, 10e3, 8, friction, net)) > 0))
    ends = [float(overload.interval_low(low, MARGIN, 5 * low)) for low in (0.1, 0.2)]
    thresholds = [float(adjustment.pairs_threshold(1, 1.6, 0.15, 0.33, margin)) for margin in (1.25, 1.5)]
    return Found(
        say(
            "rises: {rises}; {ends:.3f}; z > {thresholds:.3f}",
            rises=term("yes" if rises else "no"),
            ends=ends,
            thresholds=thresholds,
        ),
        verdict(rises and ends[0] < 0.1 and ends[1] < 0.2 and thresholds[1] < thresholds[0]),
    )


CHECKS = {"P9": p9, "P10": p10, "P11": p11, "P12": p12, "P18": p18, "P19": p19, "P20": p20, "P21": p21, "P22": p22}
