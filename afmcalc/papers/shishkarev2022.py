"""Шишкарев 2022 (S22), overload with a torque margin: figures 1–4, and the claims P9–P12 and P18–P22."""

import numpy as np

from ..arrays import Values
from ..equations import accuracy, adjustment, direct, indirect, overload
from ..messages import say, term
from .claims import Found, near, verdict
from .figures import PaperAxis, PaperFigure, curve

MARGIN, LOW, HIGH = 1.25, 0.1, 0.8


def factor(reduced: Values, friction: float = HIGH, low: float = LOW) -> Values:
    """A of (15) with a reduced gain: published over expected torque."""
    here, at_min = overload.loop_gain(reduced, 1, friction), overload.loop_gain(reduced, 1, low)
    return overload.actuation_factor(here, at_min, friction, low, MARGIN)


def expected_factor(reduced: Values) -> Values:
    """K_т of (18) with a reduced gain."""
    return accuracy.accuracy_factor(0, 1, reduced, LOW, LOW, HIGH, HIGH)


def actual_factor(reduced: Values) -> Values:
    """K_т of (18) or (19) by case: the trip is at the larger of T_ср and T_муф."""
    return expected_factor(reduced) * np.maximum(factor(reduced), 1.0)


def figure_1() -> PaperFigure:
    """Friction bound (11) over the number of pairs, reconstructed."""
    pairs = np.arange(2.0, 11.0)
    smooth = np.linspace(2, 10, 161)
    return PaperFigure(
        name="S22 fig. 1",
        title="friction up to which (10) is positive, against the number of pairs",
        panels=[
            [
                curve("", "(11), reconstructed", smooth, overload.friction_bound(smooth, MARGIN, 5.0)),
                curve("", "whole numbers of pairs", pairs, overload.friction_bound(pairs, MARGIN, 5.0), points=True),
                curve("", "f_max = 0.8", smooth, HIGH),
            ]
        ],
        x=PaperAxis("number of friction pairs", "z"),
        y=[PaperAxis("coefficient of friction", "f")],
        inputs="zC = 5, β_н = 1.25.",
        corrections=[
            "a reconstruction: formulas (10) and (11) are damaged in the text; read as 1 + z (z − 1)(β_н − 1)(1 − C f) "
            "and f < 1/[5 (z − 1)(β_н − 1)] + z/5, they give the minimum at z = 3 that the text states, f = 1.0 there",
            "M15, M18: as a difference of torques (10) cannot be right, it is a pure number; (22) less (8) is positive "
            "for every f",
        ],
    )


def figure_2() -> PaperFigure:
    """Discriminant and roots of (17) over the reduced gain."""
    reduced = np.linspace(0.02, 5, 250)
    gains = {low: overload.loop_gain(reduced, 1, low) for low in (0.1, 0.2)}
    left = [
        curve(number, f"D, f_min = {low:g}", reduced, overload.discriminant(MARGIN, gains[low]))
        for number, low in (("1", 0.1), ("2", 0.2))
    ]
    right = [
        curve(number, f"left root, f_min = {low:g}", reduced, overload.interval_low(low, MARGIN, gains[low]))
        for number, low in (("3", 0.1), ("5", 0.2))
    ]
    shown = reduced[reduced >= 1]
    right.append(curve("4, 6", "right root 1/(zC), both f_min", shown, overload.interval_high(shown)))
    return PaperFigure(
        name="S22 fig. 2",
        title="discriminant and roots of (17) against the reduced gain",
        panels=[left, right],
        x=PaperAxis("reduced gain", "zC"),
        y=[PaperAxis("discriminant", "D"), PaperAxis("coefficient of friction", "f")],
        inputs="β_н = 1.25, f_min = 0.1 and 0.2; the right root is drawn where it lies below f = 1.",
        corrections=[
            "(17): D = (β_н + (β_н − 2) zC f_min)², a perfect square",
            "P18: curves 4 and 6 coincide, both are 1/(zC)",
            "M37: the caption says reduced coefficient of friction for reduced gain",
        ],
    )


def figure_3() -> PaperFigure:
    """Expected and actual accuracy over the reduced gain."""
    reduced = np.linspace(0, 5, 501)
    return PaperFigure(
        name="S22 fig. 3",
        title="expected and actual accuracy factor against the reduced gain",
        panels=[
            [
                curve("1", "actual, max(T_ср, T_муф)", reduced, actual_factor(reduced)),
                curve("2", "expected (18)", reduced, expected_factor(reduced)),
            ]
        ],
        x=PaperAxis("reduced gain", "zC"),
        y=[PaperAxis("accuracy factor", "K_т")],
        inputs="β_н = 1.25, f = 0.1…0.8; curve 1 is (18) or (19) by case, the larger of T_ср and T_муф.",
        corrections=[
            "M11: (15) with [1 − v²] f_min divided by f",
            "M13: the best actual accuracy is at zC = 1/f_max = 1.25 (A = 1), printed ≈ 1.6, where A = 1.225",
            "M12: at equilibrium the trip is at T_муф and curve 2 holds throughout",
        ],
    )


def figure_4() -> PaperFigure:
    """A over the number of driving pairs."""
    bypass = np.array([1.0, 2.0, 3.0])
    # C = 1/(z_1 f_max) for z_1 ≥ 2; z_1 = 1 with the stated reduced gain
    reduced = np.array([1.6, *((4 - z1) / (z1 * HIGH) for z1 in (2.0, 3.0))])
    found = factor(reduced)
    return PaperFigure(
        name="S22 fig. 4",
        title="actuation factor A at f_max against the number of driving pairs",
        panels=[
            [
                curve("1", "all-driving, zC = 1.6", bypass, factor(np.full(3, 1.6))),
                curve("1'", "all-driving, zC = 5", bypass, factor(np.full(3, 5.0))),
                curve("2", "differentiated, A = T_ср/T_муф (23)", bypass, found, points=True),
                curve("", "its reciprocal T_муф/T_ср", bypass, 1 / found, points=True),
            ]
        ],
        x=PaperAxis("number of driving pairs", "z_1"),
        y=[PaperAxis("actuation factor", "A")],
        inputs="z = 4, β_н = 1.25, f = 0.1…0.8; (z − z_1)C = 1.6 for z_1 = 1, C = 1/(z_1 f_max) for z_1 ≥ 2.",
        corrections=[
            "M14: A = 1.225, 1.000, 0.419 falls with z_1, it does not grow above the all-driving line; the reciprocal "
            "has the shape described",
            "M30: the text gives line 1 both zC = 5 and zC = 1.6",
        ],
    )


def p9() -> Found:
    """Ratio of the two accuracy factors."""
    computed = float(factor(5))
    return Found(say("A = {factor:.3f}", factor=computed), verdict(near(computed, 3, 0.005)), computed / 3 - 1)


def p10() -> Found:
    """Optimum of the reduced gain."""
    scan = np.linspace(0.5, 5.5, 5001)
    best = float(scan[np.argmin(actual_factor(scan))])
    closed = float(overload.optimal_reduced_gain(HIGH))
    text = say(
        "zC = {best:.3f} by scan, {closed:.3f} = 1/f_max; A(1.6) = {there:.3f}",
        best=best,
        closed=closed,
        there=factor(1.6),
    )
    return Found(text, verdict(near(best, 1.6, 0.05), near(best, closed, 0.002)), best / 1.6 - 1)


def p11() -> Found:
    """Friction above which T_ср exceeds the clutch's nominal torque."""
    threshold = float(overload.interval_high(5))
    ratios = [float(factor(5, low, low)) for low in (0.1, 0.2, 0.3)]
    text = say(
        "1/(zC) = {threshold:.3f}; T_ср/T_н.муф at f_min 0.1, 0.2, 0.3: {ratios:.3f}",
        threshold=threshold,
        ratios=ratios,
    )
    return Found(text, verdict(near(threshold, 0.2, 1e-12) and ratios[0] < 1 < ratios[2]), threshold / 0.2 - 1)


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
    bound = {z: float(overload.friction_bound(z, MARGIN, 5)) for z in range(2, 31)}
    best = min(bound, key=lambda z: bound[z])
    text = say("minimum at z = {best}, f = {bound:.2f}", best=best, bound=bound[best])
    return Found(text, verdict(False, best == 3 and bound[best] > HIGH), best / 3 - 1)


def p20() -> Found:
    """Safe range of f_min with fewer driving pairs."""
    limits = [float(overload.interval_high((4 - z1) * direct.gain_limit_differentiated(z1, HIGH))) for z1 in (1, 2, 3)]
    text = say("1/[(z − z_1) C] for z_1 = 1, 2, 3: {limits:.3f}", limits=limits)
    return Found(text, verdict(limits[0] > limits[1] > limits[2]))


def p21() -> Found:
    """Actuation torque with differentiated pairs, over T_н."""
    reduced = np.array([1.6, 1.25, 1 / 2.4])
    published = np.asarray(factor(reduced) * expected_factor(reduced))
    actual = np.asarray(actual_factor(reduced))
    driving = float(factor(1.6) * expected_factor(1.6))
    text = say(
        "T_ср(f_max)/T_н: all-driving {driving:.2f}; z_1 = 1, 2, 3: {published:.2f} "
        "(with max(T_ср, T_муф): {actual:.2f})",
        driving=driving,
        published=published.tolist(),
        actual=actual.tolist(),
    )
    return Found(text, verdict(bool(np.all(published > driving))))


def p22() -> Found:
    """Three claims that hold."""
    net = indirect.net_gain(1.0, 0.1, 0.15, 0.05)
    friction = np.linspace(LOW, HIGH, 101)
    rises = bool(np.all(np.diff(friction / indirect.sleeve_stiffness(20e3, 10e3, 8, friction, net)) > 0))
    ends = [float(overload.interval_low(low, MARGIN, 5 * low)) for low in (0.1, 0.2)]
    thresholds = [float(adjustment.pairs_threshold(1, 1.6, 0.15, 0.33, margin)) for margin in (1.25, 1.5)]
    text = say(
        "rises: {rises}; {ends:.3f}; z > {thresholds:.3f}",
        rises=term("yes" if rises else "no"),
        ends=ends,
        thresholds=thresholds,
    )
    return Found(text, verdict(rises and ends[0] < 0.1 and ends[1] < 0.2 and thresholds[1] < thresholds[0]))
