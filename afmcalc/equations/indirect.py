"""Indirect regulation: the release force moves a sleeve that slackens the closing spring (S21; theory, section 5).

The clutch acts as an all-driving one with the gain ``equivalent_gain``, and a spring pre-stressed to reach the
nominal torque without release force. Every argument may be an array; shapes broadcast.
"""

from ._types import Number


def gain_threshold(mean_radius: Number, key_friction: Number, hub_diameter: Number) -> Number:
    """Gain the key's friction eats up, 2 R f_1/d: below it no torque moves the sleeve.

    Source: S21, condition of (15), (16) for feedback to act; theory, section 5.

    Args:
        mean_radius: R_cp, mean friction radius [m].
        key_friction: f_1, friction coefficient at the key [1].
        hub_diameter: d, hub diameter at the key [m].

    Returns:
        C_0, the threshold 2 R f_1/d [1].

    Validity:
        Friction at the key opposes the sleeve's motion.
    """
    return 2 * mean_radius * key_friction / hub_diameter


def net_gain(gain: Number, mean_radius: Number, key_friction: Number, hub_diameter: Number) -> Number:
    """Gain net of the key's friction while the sleeve moves off its stop, κ = C − 2 R f_1/d.

    Source: S21 (10), (16).

    Args:
        gain: C, feedback gain [1].
        mean_radius: R_cp, mean friction radius [m].
        key_friction: f_1, friction coefficient at the key [1].
        hub_diameter: d, hub diameter at the key [m].

    Returns:
        κ [1].

    Validity:
        κ > 0; κ = 0 is an ordinary clutch, κ < 0 is none.
    """
    return gain - gain_threshold(mean_radius, key_friction, hub_diameter)


def net_gain_returning(gain: Number, mean_radius: Number, key_friction: Number, hub_diameter: Number) -> Number:
    """Gain with the key's friction reversed, while the sleeve moves back, κ₊ = C + 2 R f_1/d.

    Source: Theory, section 5 (beyond S21).

    Args:
        gain: C, feedback gain [1].
        mean_radius: R_cp, mean friction radius [m].
        key_friction: f_1, friction coefficient at the key [1].
        hub_diameter: d, hub diameter at the key [m].

    Returns:
        κ₊ [1].

    Validity:
        Friction falling, load kept.
    """
    return gain + gain_threshold(mean_radius, key_friction, hub_diameter)


def torque_per_force(pairs: Number, mean_radius: Number, friction_set: Number) -> Number:
    """Slip torque per closing force at the setting, T_н/F_п1 = z R f_set.

    Source: S21, before (14): at the setting the sleeve rests and N = F_п1.

    Args:
        pairs: z, friction pairs [1].
        mean_radius: R_cp, mean friction radius [m].
        friction_set: f_set, friction at the setting (f_min or f_cp) [1].

    Returns:
        T_н/F_п1 [m].

    Validity:
        The control spring set by (14).
    """
    return mean_radius * pairs * friction_set


def control_force(closing_force: Number, pairs: Number, net_gain: Number, friction_set: Number) -> Number:
    """Control-spring force that just holds the sleeve at its stop at the setting, F_п2 = F_п1 (1 + z f_set κ).

    Source: S21 (14); C from it is (5).

    Args:
        closing_force: F_п, closing-spring force as set (S21: F_п1) [N].
        pairs: z, friction pairs [1].
        net_gain: κ = C − 2 R f_1/d, gain net of the key's friction [1].
        friction_set: f_set, friction at the setting (f_min or f_cp) [1].

    Returns:
        F_п2 [N].

    Validity:
        κ ≥ 0.
    """
    return closing_force * (1 + pairs * friction_set * net_gain)


def sleeve_stiffness(
    closing_stiffness: Number, control_stiffness: Number, pairs: Number, friction: Number, net_gain: Number
) -> Number:
    """Stiffness against which the sleeve moves, D(f) = c_1 + c_2 + z c_1 f κ.

    Source: S21 (10), (11), in κ (theory, section 5).

    Args:
        closing_stiffness: c_1, stiffness of the closing spring [N/m].
        control_stiffness: c_2, stiffness of the control spring [N/m].
        pairs: z, friction pairs [1].
        friction: f, coefficient of friction [1].
        net_gain: κ = C − 2 R f_1/d, gain net of the key's friction [1].

    Returns:
        D [N/m].

    Validity:
        κ ≥ 0, then D > 0.
    """
    return closing_stiffness + control_stiffness + pairs * closing_stiffness * friction * net_gain


def travel(
    pairs: Number,
    closing_force: Number,
    friction: Number,
    friction_set: Number,
    net_gain: Number,
    sleeve_stiffness: Number,
) -> Number:
    """Axial travel of the sleeve, x = z F_п1 (f − f_set) κ/D(f).

    Source: S21 (10), (16).

    Args:
        pairs: z, friction pairs [1].
        closing_force: F_п, closing-spring force as set (S21: F_п1) [N].
        friction: f, coefficient of friction [1].
        friction_set: f_set, friction at the setting (f_min or f_cp) [1].
        net_gain: κ = C − 2 R f_1/d, gain net of the key's friction [1].
        sleeve_stiffness: D, stiffness against which the sleeve moves [N/m].

    Returns:
        x [m].

    Validity:
        f ≥ f_set; below it the sleeve rests at its stop, x = 0. Always x < F_п1/c_1.
    """
    return pairs * closing_force * (friction - friction_set) * net_gain / sleeve_stiffness


def normal_force_seated(control_force: Number, pairs: Number, net_gain: Number, friction: Number) -> Number:
    """Normal force with the sleeve at its stop, N = F_п2/(1 + z κ f).

    Source: S21 p. 2: the stop 10 belongs to the pressure disc 5, so spring 11 presses the pack through sleeve and stop;
        N = F_п1 + S with the stop's reaction S = F_п2 − F_п1 − T κ/R (theory, section 5).

    Args:
        control_force: F_п2, control-spring force as set [N].
        pairs: z, friction pairs [1].
        net_gain: κ = C − 2 R f_1/d, gain net of the key's friction [1].
        friction: f, coefficient of friction [1].

    Returns:
        N [N].

    Validity:
        S ≥ 0, that is N ≥ F_п1, or f ≤ f_set with the control spring set by (14); κ ≥ 0.
    """
    return control_force / (1 + pairs * net_gain * friction)


def normal_force_balanced(control_force: Number, pairs: Number, net_gain: Number, friction: Number) -> Number:
    """Normal force that balances the control spring where the sleeve is, N = F_2/(1 + z κ f).

    Source: S21 (9) with (10), the springs as curved as they are.

    Args:
        control_force: F_2, force of the control spring where the sleeve is [N].
        pairs: z, friction pairs [1].
        net_gain: κ = C − 2 R f_1/d, gain net of the key's friction [1].
        friction: f, coefficient of friction [1].

    Returns:
        N [N].

    Validity:
        x ≥ 0 is such that the closing spring, slackened by x, presses with the same N.
    """
    return control_force / (1 + pairs * net_gain * friction)


def travel_as_made(
    closing_force: Number,
    control_force: Number,
    pairs: Number,
    friction: Number,
    net_gain: Number,
    sleeve_stiffness: Number,
) -> Number:
    """Axial travel of the sleeve with any two spring forces, x = [(1 + z κ f) F_п1 − F_п2]/D(f).

    Source: S21 (10), in κ.

    Args:
        closing_force: F_п, closing-spring force as set (S21: F_п1) [N].
        control_force: F_п2, control-spring force as made [N].
        pairs: z, friction pairs [1].
        friction: f, coefficient of friction [1].
        net_gain: κ = C − 2 R f_1/d, gain net of the key's friction [1].
        sleeve_stiffness: D, stiffness against which the sleeve moves [N/m].

    Returns:
        x [m].

    Validity:
        x ≥ 0; where it would be negative the sleeve rests at its stop.
    """
    return ((1 + pairs * net_gain * friction) * closing_force - control_force) / sleeve_stiffness


def normal_force_moving(
    closing_force: Number,
    closing_stiffness: Number,
    control_force: Number,
    control_stiffness: Number,
    sleeve_stiffness: Number,
) -> Number:
    """Normal force with the sleeve off its stop, N = (F_п1 c_2 + F_п2 c_1)/D(f), which is F_п1 − c_1 x.

    Source: S21 (9) with (10); (11).

    Args:
        closing_force: F_п, closing-spring force as set (S21: F_п1) [N].
        closing_stiffness: c_1, stiffness of the closing spring [N/m].
        control_force: F_п2, control-spring force as set [N].
        control_stiffness: c_2, stiffness of the control spring [N/m].
        sleeve_stiffness: D, stiffness against which the sleeve moves [N/m].

    Returns:
        N [N].

    Validity:
        f ≥ f_set.
    """
    return (closing_force * control_stiffness + control_force * closing_stiffness) / sleeve_stiffness


def torque(normal_force: Number, mean_radius: Number, pairs: Number, friction: Number) -> Number:
    """Slip torque of all pairs under a normal force, T = z R f N.

    Source: S21 (9).

    Args:
        normal_force: N, normal force on the pairs [N].
        mean_radius: R_cp, mean friction radius [m].
        pairs: z, friction pairs [1].
        friction: f, coefficient of friction [1].

    Returns:
        T [N*m].

    Validity:
        The clutch slips.
    """
    return normal_force * mean_radius * pairs * friction


def release_force(torque: Number, gain: Number, mean_radius: Number) -> Number:
    """Release force of the balls on the sleeve, F_p = T tan α/r = T C/R.

    Source: S21 (6), (7).

    Args:
        torque: T, slip torque [N*m].
        gain: C, feedback gain [1].
        mean_radius: R_cp, mean friction radius [m].

    Returns:
        F_p [N].

    Validity:
        All torque passes the balls.
    """
    return torque * gain / mean_radius


def accuracy_factor(
    friction_min: Number,
    friction_set: Number,
    friction_max: Number,
    closing_stiffness: Number,
    control_stiffness: Number,
    pairs: Number,
    net_gain: Number,
) -> Number:
    """Accuracy factor, K_т = f_max D(f_set) (1 + z κ f_min)/[f_min D(f_max) (1 + z κ f_set)].

    Source: S21 (15), mended (M9), with f_set = f_min; theory, section 5 for f_min < f_set ≤ f_max, where the sleeve
        rests at f_min.

    Args:
        friction_min: f_min, smallest coefficient of friction [1].
        friction_set: f_set, friction at the setting (f_min or f_cp) [1].
        friction_max: f_max, largest coefficient of friction [1].
        closing_stiffness: c_1, stiffness of the closing spring [N/m].
        control_stiffness: c_2, stiffness of the control spring [N/m].
        pairs: z, friction pairs [1].
        net_gain: κ = C − 2 R f_1/d, gain net of the key's friction [1].

    Returns:
        K_т [1].

    Validity:
        f_min ≤ f_set ≤ f_max, κ ≥ 0.
    """
    at_set = sleeve_stiffness(closing_stiffness, control_stiffness, pairs, friction_set, net_gain)
    at_max = sleeve_stiffness(closing_stiffness, control_stiffness, pairs, friction_max, net_gain)
    rising = friction_max * at_set / (friction_min * at_max)
    return rising * ((1 + pairs * net_gain * friction_min) / (1 + pairs * net_gain * friction_set))


def accuracy_factor_hysteresis(torque_max: Number, torque_returning: Number) -> Number:
    """Accuracy factor under a load that lasts, K_т,h = T_max/T_ret,min.

    Source: Theory, section 5 (beyond S21).

    Args:
        torque_max: T_max, largest slip torque, friction rising [N*m].
        torque_returning: T_ret,min, smallest slip torque, friction falling from f_max under load [N*m].

    Returns:
        K_т,h [1].

    Validity:
        Friction falls from f_max to f_min without full unloading.
    """
    return torque_max / torque_returning


def equivalent_gain(net_gain: Number, closing_stiffness: Number, control_stiffness: Number) -> Number:
    """Gain of the all-driving clutch with the same torque curve, κ c_1/(c_1 + c_2).

    Source: Identity of S21 (11) with S22 (4): T = [F_п1 (1 + z C_eff f_set)] z R f/(1 + z C_eff f).

    Args:
        net_gain: κ = C − 2 R f_1/d, gain net of the key's friction [1].
        closing_stiffness: c_1, stiffness of the closing spring [N/m].
        control_stiffness: c_2, stiffness of the control spring [N/m].

    Returns:
        C_eff [1].

    Validity:
        f ≥ f_set.
    """
    return net_gain * closing_stiffness / (closing_stiffness + control_stiffness)


def nominal_torque_ratio(pairs: Number, gain: Number, friction_set: Number) -> Number:
    """Nominal torque against the base clutch of equal spring and gain, all pairs controlled, K_п = 1 + z C f_set.

    Source: S21, before its conclusions (with f_set = f_min).

    Args:
        pairs: z, friction pairs [1].
        gain: C, feedback gain [1].
        friction_set: f_set, friction at the setting (f_min or f_cp) [1].

    Returns:
        K_п [1].

    Validity:
        The base clutch's feedback is active at f_set.
    """
    return 1 + pairs * gain * friction_set


def nominal_torque_ratio_as_made(
    pairs: Number, gain: Number, friction_set: Number, normal_force: Number, closing_force: Number
) -> Number:
    """Nominal torque against the base clutch of equal spring and gain, F_п2 as made, K_п = (1 + z C f_set) N/F_п1.

    Source: Theory, section 5 (beyond S21).

    Args:
        pairs: z, friction pairs [1].
        gain: C, feedback gain [1].
        friction_set: f_set, friction at the setting (f_min or f_cp) [1].
        normal_force: N, normal force on the pairs [N].
        closing_force: F_п1, closing-spring force as set [N].

    Returns:
        K_п [1].

    Validity:
        N at f_set; S21 (14) makes it F_п1. As ``nominal_torque_ratio``.
    """
    return (1 + pairs * gain * friction_set) * normal_force / closing_force


def hysteresis_ratio(net_gain: Number, net_gain_returning: Number) -> Number:
    """By how much friction must fall before the sleeve moves back, κ₊/κ.

    Source: Theory, section 5 (beyond S21).

    Args:
        net_gain: κ = C − 2 R f_1/d, gain net of the key's friction [1].
        net_gain_returning: κ₊ = C + 2 R f_1/d [1].

    Returns:
        κ₊/κ [1].

    Validity:
        κ > 0.
    """
    return net_gain_returning / net_gain


def seated_elasticity_in_feedback(pairs: Number, friction: Number, feedback_part: Number, net_gain: Number) -> Number:
    """Elasticity of 1 + z κ f in a parameter to which a part of κ is proportional, z f κ_part/(1 + z κ f).

    Source: Derivative of 1 + z κ f (theory, section 5, the seated sleeve).

    Args:
        pairs: z, friction pairs [1].
        friction: f, coefficient of friction [1].
        feedback_part: κ_p, the part of κ in question [1].
        net_gain: κ = C − 2 R f_1/d, gain net of the key's friction [1].

    Returns:
        ∂ln(1 + zκf)/∂ln p [1].

    Validity:
        κ ≥ 0.
    """
    return pairs * friction * feedback_part / (1 + pairs * net_gain * friction)
