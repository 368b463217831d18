"""S22: P9–P12 and P18–P22."""

from ...equations import adjustment, direct, indirect, overload
from . import Row, figures, near, verdict

_LOW, _HIGH, _MARGIN = 0.1, 0.8, 1.25
_INPUTS = "β_н 1.25, f 0.1…0.8"


def _factor(reduced: float, friction: float = _HIGH, low: float = _LOW, margin: float = _MARGIN) -> float:
    return float(overload.actuation_factor(reduced * friction, reduced * low, friction, low, margin))


def _expected(reduced: float) -> float:
    """K_т expected, S22 (18)."""
    at = [overload.expected_torque(1, 1.0, 1.0, f, reduced * f) for f in (_HIGH, _LOW)]
    return float(at[0] / at[1])


def p9() -> Row:
    """Ratio of the two accuracy factors."""
    computed = _factor(5)
    return Row(
        id="P9",
        source="S22 fig. 3",
        inputs=f"{_INPUTS}, zC 5",
        printed="K_т actual is 3 times K_т expected",
        computed=f"A = {computed:.3f}",
        deviation=computed / 3 - 1,
        verdict=verdict(near(computed, 3, 0.005)),
        correction=None,
        why="A = T_ср/T_муф at f_max",
    )


def p10() -> Row:
    """Optimum of the reduced gain."""
    scan = [0.5 + 0.001 * i for i in range(5001)]
    actual = [max(1.0, _factor(reduced)) * _expected(reduced) for reduced in scan]
    best = scan[actual.index(min(actual))]
    closed = float(overload.optimal_reduced_gain(_HIGH))
    return Row(
        id="P10",
        source="S22 fig. 3",
        inputs=_INPUTS,
        printed="optimum zC ≈ 1.6",
        computed=f"zC = {best:.3f} by scan, {closed:.3f} = 1/f_max; A(1.6) = {_factor(1.6):.3f}",
        deviation=best / 1.6 - 1,
        verdict=verdict(near(best, 1.6, 0.05), near(best, closed, 0.002)),
        correction="M13",
        why="the kink is where A = 1",
    )


def p11() -> Row:
    """Friction above which T_ср exceeds the clutch's nominal torque."""
    threshold = float(overload.interval_high(5))
    ratios = [_factor(5, low, low) for low in (0.1, 0.2, 0.3)]
    return Row(
        id="P11",
        source="S22 (14)",
        inputs="β_н 1.25, zC 5",
        printed="T_ср > T_н.муф needs f_min > 0.2",
        computed=f"1/(zC) = {threshold:.3f}; T_ср/T_н.муф at f_min 0.1, 0.2, 0.3: {figures(ratios)}",
        deviation=threshold / 0.2 - 1,
        verdict=verdict(near(threshold, 0.2, 1e-12) and ratios[0] < 1 < ratios[2]),
        correction=None,
        why="T_ср/T_н.муф = [1 + (β_н − 1) zC f_min]/β_н",
    )


def p12() -> Row:
    """The discriminant of (17) is positive."""
    values = [float(overload.discriminant(_MARGIN, 0.05 * i * low)) for low in (0.1, 0.2) for i in range(101)]
    return Row(
        id="P12",
        source="S22 fig. 2",
        inputs="β_н 1.25, zC up to 5, f_min 0.1 and 0.2",
        printed="D > 0",
        computed=f"D from {min(values):.4f} to {max(values):.4f}",
        deviation=None,
        verdict=verdict(min(values) > 0),
        correction=None,
        why="D = (β_н + (β_н − 2) u)² is a perfect square, zero only at u = 1.667",
    )


def p18() -> Row:
    """Curves 4 and 6 of fig. 2."""
    root = [float(overload.interval_high(5)) for _ in (0.1, 0.2)]
    return Row(
        id="P18",
        source="S22 fig. 2",
        inputs="β_н 1.25, zC 5, f_min 0.1 and 0.2",
        printed="curves 4 and 6 lie apart",
        computed=f"right end of (17): {figures(root)} for both",
        deviation=None,
        verdict=verdict(root[0] != root[1]),
        correction=None,
        why="the right end is 1/(zC) whatever f_min is",
    )


def p19() -> Row:
    """Minimum of fig. 1."""
    bound = {z: 1 / (5 * (z - 1) * (_MARGIN - 1)) + z / 5 for z in range(2, 31)}
    best = min(bound, key=lambda z: bound[z])
    return Row(
        id="P19",
        source="S22 fig. 1",
        inputs="β_н 1.25, zC 5; (11) recovered from its symbols as f < 1/[5 (z − 1)(β_н − 1)] + z/5",
        printed="minimum at z = 3, above practically all coefficients of friction",
        computed=f"minimum at z = {best}, f = {bound[best]:.2f}",
        deviation=best / 3 - 1,
        verdict=verdict(False, best == 3 and bound[best] > _HIGH),
        correction="(11) reconstructed",
        why="z = 1 + 1/√(β_н − 1); (11) was recovered with this claim in hand, and is no torque difference (M15)",
    )


def p20() -> Row:
    """Safe range of f_min with fewer driving pairs."""
    limits = [float(overload.interval_high((4 - z1) * direct.gain_limit_differentiated(z1, _HIGH))) for z1 in (1, 2, 3)]
    return Row(
        id="P20",
        source="S22 text",
        inputs="z 4, C by (24), f_max 0.8",
        printed="fewer driving pairs widen the safe range of f_min",
        computed=f"1/[(z − z_1) C] for z_1 = 1, 2, 3: {figures(limits)}",
        deviation=None,
        verdict=verdict(limits[0] > limits[1] > limits[2]),
        correction=None,
        why="they narrow it",
    )


def p21() -> Row:
    """Actuation torque with differentiated pairs."""
    reduced = {1: 1.6, 2: 1.25, 3: 1 / 2.4}
    published = [_factor(value) * _expected(value) for value in reduced.values()]
    actual = [max(1.0, _factor(value)) * _expected(value) for value in reduced.values()]
    driving = _factor(1.6) * _expected(1.6)
    return Row(
        id="P21",
        source="S22 conclusion 7",
        inputs=f"{_INPUTS}; (z − z_1) C = 1.6, 1.25, 1/2.4 for z_1 = 1, 2, 3; all-driving zC = 1.6",
        printed="T_ср is larger with differentiated pairs",
        computed=f"T_ср(f_max)/T_н: all-driving {driving:.2f}; z_1 = 1, 2, 3: {figures(published, 2)} "
        f"(with max(T_ср, T_муф): {figures(actual, 2)})",
        deviation=None,
        verdict=verdict(all(value > driving for value in published)),
        correction=None,
        why="it is the same for z_1 = 1 and smaller for 2 and 3; only max(T_ср, T_муф) at z_1 = 3 is larger",
    )


def p22() -> Row:
    """Three claims that hold."""
    net = indirect.net_gain(1.0, 0.1, 0.15, 0.05)
    curve = [f / indirect.sleeve_stiffness(20e3, 10e3, 8, f, net) for f in (0.1 + 0.007 * i for i in range(101))]
    rises = all(later > earlier for earlier, later in zip(curve, curve[1:], strict=False))
    ends = [float(overload.interval_low(low, _MARGIN, 5 * low)) for low in (0.1, 0.2)]
    thresholds = [float(adjustment.pairs_threshold(1, 1.6, 0.15, 0.33, margin)) for margin in (1.25, 1.5)]
    return Row(
        id="P22",
        source="S21, S22, S19",
        inputs="S21 at C 1; S22 fig. 2, f_min 0.1 and 0.2; S19 (12), β_н 1.25 and 1.5",
        printed="T(f) rises without a dip; curves 3, 5 below f_min; z threshold falls as β_н grows",
        computed=f"rises: {'yes' if rises else 'no'}; {figures(ends)}; z > {figures(thresholds)}",
        deviation=None,
        verdict=verdict(rises and ends[0] < 0.1 and ends[1] < 0.2 and thresholds[1] < thresholds[0]),
        correction=None,
        why="all three hold",
    )


CHECKS = (p9, p10, p11, p12, p18, p19, p20, p21, p22)
