"""Figures of Шишкарев 2022 (S22): overload with a torque margin."""

import numpy as np

from ...arrays import Values, larger
from ...equations import overload as law
from ...equations.accuracy import accuracy_factor
from ...equations.overload import friction_bound
from .interface import PaperFigure, axis, curve

MARGIN, LOW, HIGH = 1.25, 0.1, 0.8


def factor(reduced: Values, friction: float = HIGH, low: float = LOW) -> Values:
    """A of (15) with a reduced gain: published over expected torque."""
    here, at_min = law.loop_gain(reduced, 1, friction), law.loop_gain(reduced, 1, low)
    found: Values = law.actuation_factor(here, at_min, friction, low, MARGIN)
    return found


def expected_factor(reduced: Values) -> Values:
    """K_т of (18) with a reduced gain."""
    found: Values = accuracy_factor(0, 1, reduced, LOW, LOW, HIGH, HIGH)
    return found


def actual_factor(reduced: Values) -> Values:
    """K_т of (18) or (19) by case: the trip is at the larger of T_ср and T_муф."""
    return expected_factor(reduced) * larger(factor(reduced), 1.0)


def figure_1() -> PaperFigure:
    """Friction bound (11) over the number of pairs, reconstructed."""
    pairs = np.arange(2.0, 11.0)
    smooth = np.linspace(2, 10, 161)
    return PaperFigure(
        name="S22 fig. 1",
        title="friction up to which (10) is positive, against the number of pairs",
        panels=[
            [
                curve("", "(11), reconstructed", smooth, friction_bound(smooth, MARGIN, 5.0)),
                curve("", "whole numbers of pairs", pairs, friction_bound(pairs, MARGIN, 5.0), points=True),
                curve("", "f_max = 0.8", smooth, HIGH),
            ]
        ],
        x=axis("number of friction pairs", "z"),
        y=[axis("coefficient of friction", "f")],
        inputs="zC = 5, β_н = 1.25.",
        corrections=[
            "a reconstruction: formulas (10) and (11) are damaged in the text; read as 1 + z (z − 1)(β_н − 1)(1 − C f) "
            "and f < 1/[5 (z − 1)(β_н − 1)] + z/5, they give the minimum at z = 3 that the text states, f = 1.0 there",
            "M15, M18: as a difference of torques (10) cannot be right, it is a pure number; (22) less (8) is positive "
            "for every f",
        ],
        assumed="",
    )


def figure_2() -> PaperFigure:
    """Discriminant and roots of (17) over the reduced gain."""
    reduced = np.linspace(0.02, 5, 250)
    left, right = [], []
    for number, low in (("1", 0.1), ("2", 0.2)):
        left.append(
            curve(number, f"D, f_min = {low:g}", reduced, law.discriminant(MARGIN, law.loop_gain(reduced, 1, low)))
        )
    for number, low in (("3", 0.1), ("5", 0.2)):
        root = law.interval_low(low, MARGIN, law.loop_gain(reduced, 1, low))
        right.append(curve(number, f"left root, f_min = {low:g}", reduced, root))
    shown = reduced[reduced >= 1]
    right.append(curve("4, 6", "right root 1/(zC), both f_min", shown, law.interval_high(shown)))
    return PaperFigure(
        name="S22 fig. 2",
        title="discriminant and roots of (17) against the reduced gain",
        panels=[left, right],
        x=axis("reduced gain", "zC"),
        y=[axis("discriminant", "D"), axis("coefficient of friction", "f")],
        inputs="β_н = 1.25, f_min = 0.1 and 0.2; the right root is drawn where it lies below f = 1.",
        corrections=[
            "(17): D = (β_н + (β_н − 2) zC f_min)², a perfect square",
            "P18: curves 4 and 6 coincide, both are 1/(zC)",
            "M37: the caption says reduced coefficient of friction for reduced gain",
        ],
        assumed="",
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
        x=axis("reduced gain", "zC"),
        y=[axis("accuracy factor", "K_т")],
        inputs="β_н = 1.25, f = 0.1…0.8; curve 1 is (18) or (19) by case, the larger of T_ср and T_муф.",
        corrections=[
            "M11: (15) with [1 − v²] f_min divided by f",
            "M13: the best actual accuracy is at zC = 1/f_max = 1.25 (A = 1), printed ≈ 1.6, where A = 1.225",
            "M12: at equilibrium the trip is at T_муф and curve 2 holds throughout",
        ],
        assumed="",
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
        x=axis("number of driving pairs", "z_1"),
        y=[axis("actuation factor", "A")],
        inputs="z = 4, β_н = 1.25, f = 0.1…0.8; (z − z_1)C = 1.6 for z_1 = 1, C = 1/(z_1 f_max) for z_1 ≥ 2.",
        corrections=[
            "M14: A = 1.225, 1.000, 0.419 falls with z_1, it does not grow above the all-driving line; the reciprocal "
            "has the shape described",
            "M30: the text gives line 1 both zC = 5 and zC = 1.6",
        ],
        assumed="",
    )
