"""Indirect regulation by pockets whose wall steepens along the travel (handbook, chapter 12).

The gain grows with the travel of the sleeve, C(x) = C + C_1 x, and so does κ. The balance of ``indirect`` then is a
quadratic equation in x; one root is stable, and a sleeve that leaves its stop moves to that.
"""

import math

from .arrays import larger, quotient, smaller
from .wiring import Either, Same


def gain_acting(gain, gain_slope, travel):
    """Gain where the sleeve has travelled to, C(x) = C_0 + C_1 x.
    Source: Handbook, chapter 12: tan α(x) = tan α_0 + (r/R) C_1 x. Validity: 0 ≤ x ≤ x_max of the pocket as cut."""
    return gain + gain_slope * travel


def is_seated(friction, friction_leaving):
    """Condition that the sleeve is at its stop, f ≤ f_L.
    Source: S21, text of fig. 1 (handbook, chapter 12). Validity: From a steep wall the sleeve jumps beyond f_L."""
    return friction <= friction_leaving


def slope_feedback(pairs, friction, gain_slope):
    """Feedback that a metre of travel adds, w = z f C_1.
    Source: Handbook, chapter 12 (a = c_1 w). Validity: As ``gain_acting``."""
    return pairs * friction * gain_slope


def tangent_stiffness_squared(
    closing_force, closing_stiffness, control_force, control_stiffness, sleeve_stiffness, slope_feedback
):
    """Square of the stiffness of the balance where the sleeve is, k_t² = (D + w F_п1)² − 4 w (F_п1 c_2 + F_п2 c_1).
    Source: Handbook, chapter 12 (there b² + 4 a g). Validity: Negative where the sleeve can rest nowhere but at its
    stop."""
    springs = closing_force * control_stiffness + control_force * closing_stiffness
    raised = sleeve_stiffness + slope_feedback * closing_force
    return raised * raised - 4 * slope_feedback * springs


def tangent_stiffness(tangent_stiffness_squared):
    """Stiffness of the balance where the sleeve is, k_t = √(k_t²).
    Source: Handbook, chapter 12. Validity: The sleeve is off its stop; where it is about to jump rounding may make the
    square negative, then 0."""
    return larger(tangent_stiffness_squared, 0 * tangent_stiffness_squared) ** 0.5


def sleeve_stiffness_curved(sleeve_stiffness, closing_force, slope_feedback, tangent_stiffness):
    """Stiffness that takes the place of D(f) in N = (F_п1 c_2 + F_п2 c_1)/D, D' = (D + w F_п1 + k_t)/2.
    Source: Handbook, chapter 12; D itself with w = 0, where k_t = D. Validity: The sleeve is off its stop."""
    return (sleeve_stiffness + slope_feedback * closing_force + tangent_stiffness) / 2


def normal_force_moving(closing_force, closing_stiffness, control_force, control_stiffness, sleeve_stiffness_curved):
    """Normal force with the sleeve off its stop, N = (F_п1 c_2 + F_п2 c_1)/D'.
    Source: S21 (9) with (10); (11); D' in the place of D (handbook, chapter 12). Validity: f > f_L."""
    balanced = (closing_force * control_stiffness + control_force * closing_stiffness) / sleeve_stiffness_curved
    return smaller(closing_force, balanced)


def travel_moving(closing_force, normal_force_moving, closing_stiffness):
    """Travel at which the closing spring has slackened to the normal force, x = (F_п1 − N)/c_1.
    Source: S21 (9). Validity: The sleeve is off its stop."""
    return (closing_force - normal_force_moving) / closing_stiffness


# over the range: the torque may have an extreme where the sleeve leaves its stop


def friction_leaving_in_range(friction_leaving, friction_min, friction_max):
    """Friction at which the sleeve leaves its stop, f_L limited to [f_min, f_max].
    Source: Handbook, chapter 12. Validity: f_min ≤ f_max."""
    return smaller(larger(friction_leaving, friction_min), friction_max)


def friction_leaving_from_mean(friction_leaving, friction_mean, friction_max):
    """Friction from the mean on at which the sleeve leaves its stop, f_L limited to [f_cp, f_max].
    Source: Handbook, chapter 12. Validity: f_cp ≤ f_max."""
    return smaller(larger(friction_leaving, friction_mean), friction_max)


torque_between, friction_between = Same("torque_at_leaving_in_range"), Same("friction_leaving_in_range")


def torque_min_from_mean(torque_at_f_mean, torque_at_leaving_from_mean, torque_at_f_max):
    """Smallest slip torque from the mean friction on.
    Source: Handbook, chapter 12: T is monotone on either side of f_L. Validity: Straight springs."""
    return smaller(torque_at_f_mean, torque_at_leaving_from_mean, torque_at_f_max)


def torque_max_from_mean(torque_at_f_mean, torque_at_leaving_from_mean, torque_at_f_max):
    """Largest slip torque from the mean friction on.
    Source: Handbook, chapter 12: T is monotone on either side of f_L. Validity: Straight springs."""
    return larger(torque_at_f_mean, torque_at_leaving_from_mean, torque_at_f_max)


# friction falling under load


def is_locked(friction, net_gain_returning, friction_max, net_gain, gain_slope, travel_max):
    """Condition that the key still keeps the sleeve where it was at f_max, f κ₊(x) ≥ f_max κ(x).
    Source: Handbook, chapter 12. Validity: Friction falling from f_max, load kept."""
    steeper = gain_slope * travel_max
    return friction * (net_gain_returning + steeper) >= friction_max * (net_gain + steeper) * (1 - 1e-12)


def stays_off(sleeve_stiffness_at_returning, slope_feedback, closing_force, normal_force_at_f_max,
              tangent_stiffness_squared_at_returning):  # fmt: skip
    """Condition that a sleeve that has jumped off its stop has not yet jumped back.
    Source: Handbook, chapter 12: D_κ₊ < w F_п1, and a balance off the stop exists, k_t² ≥ 0. Validity: It was off its
    stop at f_max, N < F_п1."""
    jumped = (sleeve_stiffness_at_returning < slope_feedback * closing_force) & (normal_force_at_f_max < closing_force)
    return jumped & (tangent_stiffness_squared_at_returning >= 0)


is_reseated = Either("stays_off", "never", "is_held_at_stop")


def hysteresis_ratio(net_gain_returning, net_gain, gain_slope, travel_max):
    """Ratio by which friction must fall before the sleeve moves back, κ₊(x_max)/κ(x_max).
    Source: Handbook, chapter 12. Validity: κ(x_max) > 0."""
    return quotient(net_gain_returning + gain_slope * travel_max, net_gain + gain_slope * travel_max)


def friction_unlocking(friction_max, hysteresis_ratio, friction_min):
    """Friction at which the key lets the sleeve go, f_max κ/κ₊, at least f_min.
    Source: Handbook, chapter 12. Validity: Friction falling from f_max, load kept."""
    return larger(friction_max / hysteresis_ratio, friction_min)


def torque_returning_min(torque_returning_at_f_min, torque_returning_at_unlocking):
    """Smallest slip torque, as friction falls from f_max under load: at f_min, or where the key lets the sleeve go.
    Source: Handbook, chapter 12: while the sleeve returns, the torque may rise. Validity: Straight springs."""
    return smaller(torque_returning_at_f_min, torque_returning_at_unlocking)


def _is_held(friction_leaving):
    """Condition that the sleeve rests at its stop at some friction, f_L > 0.
    Source: Handbook, chapter 12. Validity: Any springs; where it never rests no wall holds the torque."""
    return friction_leaving > 0


CONSTANT_TORQUE = {
    "can_hold_torque": _is_held,
    "no_slope": math.nan,
    "gain_slope": Either("can_hold_torque", "constant_torque_slope", "no_slope"),
}

CASES = {
    "leaving_in_range": {"friction": "friction_leaving_in_range"},
    "leaving_from_mean": {"friction": "friction_leaving_from_mean"},
    "unlocking": {"friction": "friction_unlocking"},
}
