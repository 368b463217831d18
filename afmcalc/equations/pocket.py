"""Indirect regulation by pockets whose wall steepens along the travel (handbook, chapter 12); C_1 = 0 is straight.

The gain grows with the travel of the sleeve, C(x) = C_0 + C_1 x, and so does κ. The balance of ``indirect`` then is a
quadratic in x; of its roots the larger is stable, and the one a sleeve that leaves its stop comes to.
"""

from typing import Annotated

from .terms import *


def gain_at(gain: InitialGain, gain_slope: GainSlope, travel: Travel) -> Annotated[Number, "C(x)", "1"]:
    """Gain where the sleeve has travelled to, C(x) = C_0 + C_1 x.

    Source: Handbook, chapter 12: tan α(x) = tan α_0 + (r/R) C_1 x.
    Validity: 0 ≤ x ≤ x_max of the pocket as cut.
    """
    return gain + gain_slope * travel


def slope_feedback(pairs: Pairs, friction: Friction, gain_slope: GainSlope) -> SlopeFeedback:
    """Feedback that a metre of travel adds, w = z f C_1.

    Source: Handbook, chapter 12 (a = c_1 w).
    Validity: As ``gain_at``.
    """
    return pairs * friction * gain_slope


def tangent_stiffness_squared(
    closing_force: IndirectClosingForce,
    closing_stiffness: ClosingStiffness,
    control_force: ControlForce,
    control_stiffness: ControlStiffness,
    sleeve_stiffness: StraightStiffness,
    slope_feedback: SlopeFeedback,
) -> Annotated[Number, "k_t²", "N^2/m^2"]:
    """Square of the stiffness of the balance where the sleeve is, k_t² = (D + w F_п1)² − 4 w (F_п1 c_2 + F_п2 c_1).

    Source: Handbook, chapter 12 (there b² + 4 a g).
    Validity: Negative where the sleeve can rest nowhere but at its stop.
    """
    springs = closing_force * control_stiffness + control_force * closing_stiffness
    raised = sleeve_stiffness + slope_feedback * closing_force
    return raised * raised - 4 * slope_feedback * springs


def sleeve_stiffness(
    straight_stiffness: StraightStiffness,
    closing_force: IndirectClosingForce,
    slope_feedback: SlopeFeedback,
    tangent_stiffness: TangentStiffness,
) -> Annotated[Number, "D'", "N/m"]:
    """Stiffness that takes the place of D(f) in N = (F_п1 c_2 + F_п2 c_1)/D, D' = (D + w F_п1 + k_t)/2.

    Source: Handbook, chapter 12; D itself with w = 0, where k_t = D.
    Validity: The sleeve is off its stop.
    """
    return (straight_stiffness + slope_feedback * closing_force + tangent_stiffness) / 2


def travel(
    closing_force: IndirectClosingForce, normal_force: NormalForce, closing_stiffness: ClosingStiffness
) -> Travel:
    """Travel at which the closing spring has slackened to the normal force, x = (F_п1 − N)/c_1.

    Source: S21 (9).
    Validity: The sleeve is off its stop.
    """
    return (closing_force - normal_force) / closing_stiffness


def leaving_friction(
    closing_force: IndirectClosingForce, control_force: ControlForce, pairs: Pairs, net_gain: NetGain
) -> LeavingFriction:
    """Friction at which the sleeve leaves its stop, f_L = (F_п2/F_п1 − 1)/(z κ).

    Source: S21 (14) for f_set; f_set itself with the control spring set by (14).
    Validity: κ > 0; f_L ≤ 0 means that the sleeve never rests at its stop.
    """
    return (control_force / closing_force - 1) / (pairs * net_gain)


def constant_torque_slope(
    closing_stiffness: ClosingStiffness,
    control_stiffness: ControlStiffness,
    pairs: Pairs,
    leaving_friction: LeavingFriction,
    closing_force: IndirectClosingForce,
) -> Annotated[Number, "C_1*", "1/m"]:
    """Slope that holds the torque once the sleeve is off its stop, C_1* = (c_1 + c_2)/(z f_L F_п1).

    Source: Handbook, chapter 12.
    Validity: f_L > 0. Above it the torque falls as friction rises.
    """
    return (closing_stiffness + control_stiffness) / (pairs * leaving_friction * closing_force)


def jumping_slope(
    sleeve_stiffness: LeavingStiffness,
    pairs: Pairs,
    leaving_friction: LeavingFriction,
    closing_force: IndirectClosingForce,
) -> Annotated[Number, "C_1,j", "1/m"]:
    """Slope above which the sleeve jumps off its stop as friction rises in slip, D(f_L)/(z f_L F_п1).

    Source: Handbook, chapter 12: there b = 0 at the stop.
    Validity: f_L > 0. Above C_1* already the sleeve jumps under a load that rises while the clutch still holds.
    """
    return sleeve_stiffness / (pairs * leaving_friction * closing_force)


def force_elasticity_in_feedback(
    closing_stiffness: ClosingStiffness,
    pairs: Pairs,
    friction: Friction,
    feedback_part: FeedbackPart,
    tangent_stiffness: TangentStiffness,
) -> ForceElasticity:
    """Elasticity of N, spring forces fixed, in a parameter to which a part of κ is proportional, −z c_1 f κ_part/k_t.

    Source: Derivative of the balance (handbook, chapters 5 and 12); C_1 x is the part of the slope.
    Validity: The sleeve is off its stop.
    """
    return -pairs * closing_stiffness * friction * feedback_part / tangent_stiffness


def force_elasticity_in_control_stiffness(
    closing_stiffness: ClosingStiffness,
    control_stiffness: ControlStiffness,
    travel: Travel,
    tangent_stiffness: TangentStiffness,
    normal_force: NormalForce,
) -> Annotated[Number, "∂ln N/∂ln c_2", "1"]:
    """Elasticity of N in the stiffness of the control spring, c_1 c_2 x/(k_t N).

    Source: Derivative of the balance (handbook, chapters 5 and 12).
    Validity: The sleeve is off its stop.
    """
    return closing_stiffness * control_stiffness * travel / (tangent_stiffness * normal_force)


def force_elasticity_in_control_force(
    closing_stiffness: ClosingStiffness,
    control_force: ControlForce,
    tangent_stiffness: TangentStiffness,
    normal_force: NormalForce,
) -> Annotated[Number, "∂ln N/∂ln F_п2", "1"]:
    """Elasticity of N in the force of the control spring, c_1 F_п2/(k_t N).

    Source: Derivative of the balance (handbook, chapters 5 and 12).
    Validity: The sleeve is off its stop.
    """
    return closing_stiffness * control_force / (tangent_stiffness * normal_force)


def force_elasticity_in_closing_spring(
    spring_part: SpringPart,
    control_stiffness: ControlStiffness,
    slope_feedback: SlopeFeedback,
    tangent_stiffness: TangentStiffness,
    normal_force: NormalForce,
) -> ForceElasticity:
    """Elasticity of N in a part of the closing spring's force, F_part (c_2 − w N)/(k_t N): F_п1 itself, −c_1 x for c_1.

    Source: Derivative of the balance (handbook, chapters 5 and 12).
    Validity: The sleeve is off its stop; F_п2 fixed.
    """
    return spring_part * (control_stiffness - slope_feedback * normal_force) / (tangent_stiffness * normal_force)
