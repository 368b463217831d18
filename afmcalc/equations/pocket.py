"""Indirect regulation by pockets whose wall steepens along the travel (theory, section 12); C_1 = 0 is straight.

The gain grows with the travel of the sleeve, C(x) = C_0 + C_1 x, and so does κ. The balance of ``indirect`` then is a
quadratic in x; of its roots the larger is stable, and the one a sleeve that leaves its stop comes to.
"""

from ._types import Number


def gain_at(gain: Number, gain_slope: Number, travel: Number) -> Number:
    """Gain where the sleeve has travelled to, C(x) = C_0 + C_1 x.

    Source: Theory, section 12: tan α(x) = tan α_0 + (r/R) C_1 x.

    Args:
        gain: C_0, gain at the stop [1].
        gain_slope: C_1, how the gain grows with travel [1/m].
        travel: x, axial travel of the sleeve [m].

    Returns:
        C(x) [1].

    Validity:
        0 ≤ x ≤ x_max of the pocket as cut.
    """
    return gain + gain_slope * travel


def slope_feedback(pairs: Number, friction: Number, gain_slope: Number) -> Number:
    """Feedback that a metre of travel adds, w = z f C_1.

    Source: Theory, section 12 (a = c_1 w).

    Args:
        pairs: z, friction pairs [1].
        friction: f, coefficient of friction [1].
        gain_slope: C_1, how the gain grows with travel [1/m].

    Returns:
        w [1/m].

    Validity:
        As ``gain_at``.
    """
    return pairs * friction * gain_slope


def tangent_stiffness_squared(
    closing_force: Number,
    closing_stiffness: Number,
    control_force: Number,
    control_stiffness: Number,
    sleeve_stiffness: Number,
    slope_feedback: Number,
) -> Number:
    """Square of the stiffness of the balance where the sleeve is, k_t² = (D + w F_п1)² − 4 w (F_п1 c_2 + F_п2 c_1).

    Source: Theory, section 12 (there b² + 4 a g).

    Args:
        closing_force: F_п, closing-spring force as set (S21: F_п1) [N].
        closing_stiffness: c_1, stiffness of the closing spring [N/m].
        control_force: F_п2, control-spring force as set [N].
        control_stiffness: c_2, stiffness of the control spring [N/m].
        sleeve_stiffness: D, D(f) of a straight pocket, at κ of the stop [N/m].
        slope_feedback: w, z f C_1 [1/m].

    Returns:
        k_t² [N^2/m^2].

    Validity:
        Negative where the sleeve can rest nowhere but at its stop.
    """
    springs = closing_force * control_stiffness + control_force * closing_stiffness
    raised = sleeve_stiffness + slope_feedback * closing_force
    return raised * raised - 4 * slope_feedback * springs


def sleeve_stiffness(
    straight_stiffness: Number, closing_force: Number, slope_feedback: Number, tangent_stiffness: Number
) -> Number:
    """Stiffness that takes the place of D(f) in N = (F_п1 c_2 + F_п2 c_1)/D, D' = (D + w F_п1 + k_t)/2.

    Source: Theory, section 12; D itself with w = 0, where k_t = D.

    Args:
        straight_stiffness: D, D(f) of a straight pocket, at κ of the stop [N/m].
        closing_force: F_п, closing-spring force as set (S21: F_п1) [N].
        slope_feedback: w, z f C_1 [1/m].
        tangent_stiffness: k_t, stiffness of the balance where the sleeve is [N/m].

    Returns:
        D' [N/m].

    Validity:
        The sleeve is off its stop.
    """
    return (straight_stiffness + slope_feedback * closing_force + tangent_stiffness) / 2


def travel(closing_force: Number, normal_force: Number, closing_stiffness: Number) -> Number:
    """Travel at which the closing spring has slackened to the normal force, x = (F_п1 − N)/c_1.

    Source: S21 (9).

    Args:
        closing_force: F_п, closing-spring force as set (S21: F_п1) [N].
        normal_force: N, normal force on the pairs [N].
        closing_stiffness: c_1, stiffness of the closing spring [N/m].

    Returns:
        x [m].

    Validity:
        The sleeve is off its stop.
    """
    return (closing_force - normal_force) / closing_stiffness


def leaving_friction(closing_force: Number, control_force: Number, pairs: Number, net_gain: Number) -> Number:
    """Friction at which the sleeve leaves its stop, f_L = (F_п2/F_п1 − 1)/(z κ).

    Source: S21 (14) for f_set; f_set itself with the control spring set by (14).

    Args:
        closing_force: F_п, closing-spring force as set (S21: F_п1) [N].
        control_force: F_п2, control-spring force as made [N].
        pairs: z, friction pairs [1].
        net_gain: κ = C − 2 R f_1/d, gain net of the key's friction [1].

    Returns:
        f_L [1].

    Validity:
        κ > 0; not above 0 where the sleeve never rests.
    """
    return (control_force / closing_force - 1) / (pairs * net_gain)


def constant_torque_slope(
    closing_stiffness: Number, control_stiffness: Number, pairs: Number, leaving_friction: Number, closing_force: Number
) -> Number:
    """Slope that holds the torque once the sleeve is off its stop, C_1* = (c_1 + c_2)/(z f_L F_п1).

    Source: Theory, section 12.

    Args:
        closing_stiffness: c_1, stiffness of the closing spring [N/m].
        control_stiffness: c_2, stiffness of the control spring [N/m].
        pairs: z, friction pairs [1].
        leaving_friction: f_L, friction at which the sleeve leaves its stop, f_set or by the forces as made [1].
        closing_force: F_п, closing-spring force as set (S21: F_п1) [N].

    Returns:
        C_1* [1/m].

    Validity:
        f_L > 0. Above it the torque falls as friction rises.
    """
    return (closing_stiffness + control_stiffness) / (pairs * leaving_friction * closing_force)


def jumping_slope(sleeve_stiffness: Number, pairs: Number, leaving_friction: Number, closing_force: Number) -> Number:
    """Slope above which the sleeve jumps off its stop as friction rises in slip, D(f_L)/(z f_L F_п1).

    Source: Theory, section 12: there b = 0 at the stop.

    Args:
        sleeve_stiffness: D, D(f_L) of a straight pocket [N/m].
        pairs: z, friction pairs [1].
        leaving_friction: f_L, friction at which the sleeve leaves its stop [1].
        closing_force: F_п, closing-spring force as set (S21: F_п1) [N].

    Returns:
        C_1,j [1/m].

    Validity:
        f_L > 0. Above C_1* already the sleeve jumps under a load that rises while the clutch still holds.
    """
    return sleeve_stiffness / (pairs * leaving_friction * closing_force)


def force_elasticity_in_feedback(
    closing_stiffness: Number, pairs: Number, friction: Number, feedback_part: Number, tangent_stiffness: Number
) -> Number:
    """Elasticity of N, spring forces fixed, in a parameter to which a part of κ is proportional, −z c_1 f κ_part/k_t.

    Source: Derivative of the balance (theory, sections 5 and 12); C_1 x is the part of the slope.

    Args:
        closing_stiffness: c_1, stiffness of the closing spring [N/m].
        pairs: z, friction pairs [1].
        friction: f, coefficient of friction [1].
        feedback_part: κ_p, the part of κ in question [1].
        tangent_stiffness: k_t, stiffness of the balance where the sleeve is; D(f) of a straight pocket [N/m].

    Returns:
        ∂ln N/∂ln p [1].

    Validity:
        The sleeve is off its stop.
    """
    return -pairs * closing_stiffness * friction * feedback_part / tangent_stiffness


def force_elasticity_in_control_stiffness(
    closing_stiffness: Number,
    control_stiffness: Number,
    travel: Number,
    tangent_stiffness: Number,
    normal_force: Number,
) -> Number:
    """Elasticity of N in the stiffness of the control spring, c_1 c_2 x/(k_t N).

    Source: Derivative of the balance (theory, sections 5 and 12).

    Args:
        closing_stiffness: c_1, stiffness of the closing spring [N/m].
        control_stiffness: c_2, stiffness of the control spring [N/m].
        travel: x, axial travel of the sleeve [m].
        tangent_stiffness: k_t, stiffness of the balance where the sleeve is [N/m].
        normal_force: N, normal force on the pairs [N].

    Returns:
        ∂ln N/∂ln c_2 [1].

    Validity:
        The sleeve is off its stop.
    """
    return closing_stiffness * control_stiffness * travel / (tangent_stiffness * normal_force)


def force_elasticity_in_control_force(
    closing_stiffness: Number, control_force: Number, tangent_stiffness: Number, normal_force: Number
) -> Number:
    """Elasticity of N in the force of the control spring, c_1 F_п2/(k_t N).

    Source: Derivative of the balance (theory, sections 5 and 12).

    Args:
        closing_stiffness: c_1, stiffness of the closing spring [N/m].
        control_force: F_п2, control-spring force as set [N].
        tangent_stiffness: k_t, stiffness of the balance where the sleeve is [N/m].
        normal_force: N, normal force on the pairs [N].

    Returns:
        ∂ln N/∂ln F_п2 [1].

    Validity:
        The sleeve is off its stop.
    """
    return closing_stiffness * control_force / (tangent_stiffness * normal_force)


def force_elasticity_in_closing_spring(
    spring_part: Number,
    control_stiffness: Number,
    slope_feedback: Number,
    tangent_stiffness: Number,
    normal_force: Number,
) -> Number:
    """Elasticity of N in a part of the closing spring's force, F_part (c_2 − w N)/(k_t N): F_п1 itself, −c_1 x for c_1.

    Source: Derivative of the balance (theory, sections 5 and 12).

    Args:
        spring_part: F_part, part of F_п1 − c_1 x proportional to the parameter [N].
        control_stiffness: c_2, stiffness of the control spring [N/m].
        slope_feedback: w, z f C_1 [1/m].
        tangent_stiffness: k_t, stiffness of the balance where the sleeve is [N/m].
        normal_force: N, normal force on the pairs [N].

    Returns:
        ∂ln N/∂ln p [1].

    Validity:
        The sleeve is off its stop; F_п2 fixed.
    """
    return spring_part * (control_stiffness - slope_feedback * normal_force) / (tangent_stiffness * normal_force)
