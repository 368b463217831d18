"""Шишкарев 2022 (S22), overload with a torque margin: figures 1–4, and the claims P9–P12, P18–P22 and P31–P37."""

from typing import Any

import numpy as np

from ..equations import accuracy, adjustment, direct, indirect, overload
from ..equations.arrays import Values
from ..messages import say, translate
from .claims import Found, PaperAxis, PaperFigure, curve, near, verdict

_THRESHOLD: Any = adjustment.DIRECT_ONE_MATERIAL["pairs_threshold"]
_GAIN_LIMIT: Any = direct.DIFFERENTIATED["gain_limit"]
_REDUCED_LIMIT: Any = direct.ALL_DRIVING["gain_limit"]

MARGIN, LOW, HIGH = 1.25, 0.1, 0.8
HIGH_GAIN = float(_REDUCED_LIMIT(1))
"""Largest zC."""


def factor(reduced: Values, friction: Values = HIGH, low: float = LOW) -> Values:
    """A of (15) with a reduced gain: published over expected torque."""
    here, at_min = overload.loop_gain(reduced, 1, friction), overload.loop_gain(reduced, 1, low)
    return overload.actuation_factor(here, at_min, friction, low, MARGIN)


def expected_factor(reduced: Values) -> Values:
    """K_т of (18) with a reduced gain."""
    return accuracy.accuracy_factor_of_path(0, 1, reduced, LOW, LOW, HIGH, HIGH)


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
        curve(
            number, f"left root, f_min = {low:g}", reduced,
            overload.friction_at_equal_potential(low, MARGIN, gains[low]),
        )
        for number, low in (("3", 0.1), ("5", 0.2))
    ]  # fmt: skip
    shown = reduced[reduced >= 1]
    right.append(curve("4, 6", "right root 1/(zC), both f_min", shown, overload.friction_at_unit_loop_gain(shown)))
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
        best=best, closed=closed, there=factor(1.6),
    )  # fmt: skip
    return Found(text, verdict(near(best, 1.6, 0.05)), best / 1.6 - 1)


def p11() -> Found:
    """Friction above which T_ср exceeds the clutch's nominal torque."""
    threshold = float(overload.friction_at_unit_loop_gain(5))
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
    """Curves 4 and 6 of fig. 2 fall: the right end of (17), from its discriminant, comes down to f_min."""
    reduced = np.linspace(HIGH_GAIN / 4, HIGH_GAIN, 61)
    ends = [np.asarray(_right_end(reduced, low)) for low in (0.1, 0.2)]
    narrows = all(np.all(np.diff(end) < 0) for end in ends)
    text = say(
        "right end of (17) at zC 1.25, 2.5, 5: {first:.3f} with f_min 0.1, {second:.3f} with 0.2",
        first=ends[0][[0, 20, 60]].tolist(),
        second=ends[1][[0, 20, 60]].tolist(),
    )
    return Found(text, verdict(bool(narrows)))


def _right_end(reduced: Values, low: float) -> Values:
    """Right end of (17) as printed, by its discriminant."""
    u = overload.loop_gain(reduced, 1, low)
    weight = MARGIN * (1 + u)
    return (weight + overload.discriminant(MARGIN, u) ** 0.5) / (2 * reduced * (weight - u))


def p19() -> Found:
    """Minimum of fig. 1."""
    bound = {z: float(overload.friction_bound(z, MARGIN, 5)) for z in range(2, 31)}
    best = min(bound, key=lambda z: bound[z])
    text = say("minimum at z = {best}, f = {bound:.2f}", best=best, bound=bound[best])
    return Found(text, verdict(False, best == 3 and bound[best] > HIGH), best / 3 - 1)


def p20() -> Found:
    """Safe range of f_min with fewer driving pairs."""
    limits = [float(overload.friction_at_unit_loop_gain((4 - z1) * _GAIN_LIMIT(z1, HIGH))) for z1 in (1, 2, 3)]
    text = say("1/[(z − z_1) C] for z_1 = 1, 2, 3: {limits:.3f}", limits=limits)
    return Found(text, verdict(limits[0] > limits[1] > limits[2]))


def p21() -> Found:
    """Actuation torque with differentiated pairs, equal in all but z_1; and with the gains of fig. 4, over T_н."""
    bypass = np.array([1.0, 2.0, 3.0])

    def torques(reduced: float) -> list[float]:
        """T_ср(f_max) at F_п R = 200 N·m, all-driving first; C is the same, so (z − z_1) C is less."""
        gains = np.array([reduced, *(reduced * (1 - bypass / 4))])
        expected = overload.expected_torque(4, 200.0, 1.0, HIGH, overload.loop_gain(gains, 1, HIGH))
        return np.asarray(factor(gains) * expected).tolist()

    equal, optimum = torques(HIGH_GAIN), torques(1.6)
    drawn = np.array([1.6, 1.25, 1 / 2.4])
    text = say(
        "zC 5: all-driving {driving:.1f N·m}, z_1 = 1, 2, 3 {equal:.1f N·m}; zC 1.6: {least:.1f N·m}, {optimum:.1f N·m}"
        "; T_ср(f_max)/T_н with the gains of fig. 4 {published:.2f}, all-driving {whole:.2f} at zC 1.6",
        driving=equal[0],
        equal=equal[1:],
        least=optimum[0],
        optimum=optimum[1:],
        published=np.asarray(factor(drawn) * expected_factor(drawn)).tolist(),
        whole=float(factor(1.6) * expected_factor(1.6)),
    )
    return Found(text, verdict(min(equal[1:]) > equal[0], equal[1] > equal[0]))


def p22() -> Found:
    """Three claims that hold."""
    net = indirect.net_gain(1.0, indirect.gain_threshold(0.1, 0.15, 0.05))
    friction = np.linspace(LOW, HIGH, 101)
    rises = bool(np.all(np.diff(friction / indirect.sleeve_stiffness(20e3, 10e3, 8, friction, net)) > 0))
    ends = [float(overload.friction_at_equal_potential(low, MARGIN, 5 * low)) for low in (0.1, 0.2)]
    thresholds = [float(_THRESHOLD(1, 1.6, 0.15, 0.33, margin)) for margin in (1.25, 1.5)]
    text = say(
        "rises: {rises}; {ends:.3f}; z > {thresholds:.3f}",
        rises=translate("yes" if rises else "no"), ends=ends, thresholds=thresholds,
    )  # fmt: skip
    return Found(text, verdict(rises and ends[0] < 0.1 and ends[1] < 0.2 and thresholds[1] < thresholds[0]))


def p31() -> Found:
    """The potential torque falls by less than the load rises, at f_min."""
    fall = float(overload.loop_gain(HIGH_GAIN, 1, LOW))
    return Found(say("it falls by zC f_min = {fall:.2f} of the rise", fall=fall), verdict(fall < 1))


def p32() -> Found:
    """The potential torque falls faster at f_max than at f_min."""
    slow, fast = (float(overload.loop_gain(HIGH_GAIN, 1, friction)) for friction in (LOW, HIGH))
    text = say("by {slow:.2f} of the rise at f_min, {fast:.2f} at f_max", slow=slow, fast=fast)
    return Found(text, verdict(fast > slow))


def p33() -> Found:
    """With a margin, accuracy falls as the reduced gain grows, since T_ср exceeds T_муф over more of the friction."""
    reduced = np.linspace(0.25, HIGH_GAIN, 96)
    best = float(overload.optimal_reduced_gain(HIGH))
    rising = np.diff(actual_factor(reduced)) > 0
    shown = np.array([0.5, 1.25, 2.0, 5.0])
    text = say(
        "zC 0.5, 1.25, 2, 5: K_т {factors:.3f}; T_ср > T_муф from f = {ends:.3f} on to f_max",
        factors=np.asarray(actual_factor(shown)).tolist(),
        ends=np.minimum(overload.friction_at_unit_loop_gain(shown), HIGH).tolist(),
    )
    return Found(text, verdict(bool(np.all(rising)), bool(np.all(rising == (reduced[:-1] >= best - 1e-9)))))


def p34() -> Found:
    """The all-driving clutch is the more accurate one, without and with the effect of the margin."""
    pairs = np.arange(2.0, 13.0)
    reduced = (pairs - 1) * _GAIN_LIMIT(1, HIGH)
    expected, actual = np.asarray(expected_factor(reduced)), np.asarray(actual_factor(reduced))
    driving = [float(of(HIGH_GAIN)) for of in (expected_factor, actual_factor)]
    text = say(
        "all-driving (zC 5): K_т {driving:.2f} expected and actual; one driving pair, z 4, 5, 6, 8: "
        "{expected:.2f} expected, {actual:.2f} actual",
        driving=driving,
        expected=expected[[2, 3, 4, 6]].tolist(),
        actual=actual[[2, 3, 4, 6]].tolist(),
    )
    return Found(text, verdict(bool(np.any((expected > driving[0]) & (actual > driving[1])))))


def p35() -> Found:
    """The potential torque of the all-driving clutch is the smaller one, whatever z_1."""

    def potential(reduced: float) -> float:
        return float(overload.potential_torque(4, 200.0, 1.0, HIGH, MARGIN, overload.loop_gain(reduced, 1, LOW)))

    torques = [potential(HIGH_GAIN * (1 - bypass / 4)) for bypass in range(4)]
    text = say("all-driving {least:.0f N·m}; z_1 = 1, 2, 3: {torques:.0f N·m}", least=torques[0], torques=torques[1:])
    return Found(text, verdict(min(torques[1:]) > torques[0]))


def p36() -> Found:
    """There is an interval of friction in which T_ср does not exceed the nominal torque."""
    friction = np.linspace(LOW, HIGH, 70001)
    gains, at_min = (overload.loop_gain(HIGH_GAIN, 1, f) for f in (friction, LOW))
    expected = overload.expected_torque(1, 1.0, 1.0, friction, gains) / overload.expected_torque(
        1, 1.0, 1.0, LOW, at_min
    )
    ratios = np.asarray(factor(HIGH_GAIN, friction))
    ends = [float(friction[of <= 1 + 1e-12][-1]) for of in (ratios, ratios * expected)]
    text = say(
        "T_ср ≤ T_муф up to f = {expected:.3f}, T_ср ≤ T_н.муф up to f = {nominal:.3f}",
        expected=ends[0],
        nominal=ends[1],
    )
    return Found(text, verdict(near(ends[1], 1 / HIGH_GAIN, 0.001), near(ends[0], 1 / HIGH_GAIN, 0.001)))


def p37() -> Found:
    """Without a margin both torques are smaller, at the largest reduced gain."""
    at_min = overload.loop_gain(HIGH_GAIN, 1, LOW)
    potential = [float(overload.potential_torque(4, 200.0, 1.0, HIGH, m, at_min)) for m in (1.0, MARGIN)]
    friction = np.array([LOW, 0.15, 0.2, 0.4, HIGH])
    gains = overload.loop_gain(HIGH_GAIN, 1, friction)
    factors = [np.asarray(overload.actuation_factor(gains, at_min, friction, LOW, m)) for m in (1.0, MARGIN)]
    text = say(
        "T_п(f_max) {without:.0f N·m} without, {with_margin:.0f N·m} with it; T_ср/T_муф at f {friction}: "
        "{bare:.3f} without, {factors:.3f} with it",
        without=potential[0],
        with_margin=potential[1],
        friction=friction.tolist(),
        bare=factors[0].tolist(),
        factors=factors[1].tolist(),
    )
    less = potential[0] < potential[1]
    smaller = factors[0] < factors[1]
    return Found(
        text, verdict(bool(less and np.all(smaller)), bool(less and np.all(smaller[friction > 1 / HIGH_GAIN])))
    )
