"""Direct regulation: the release force acts on the spring-loaded pack itself (theory, section 2).

One law for every direct variant. The pairs form two groups: the *bypass* (driving) pairs z_1 carry
torque straight between the half-couplings, the *controlled* (driven) pairs z_2 carry theirs through
the balls. Conventional: z_2 = 0. All-driving: z_1 = 0. Every argument may be an array; shapes broadcast.
"""

from ._types import Number

RECOMMENDED_REDUCED_GAIN = 5
"""Largest zC of an all-driving clutch (S22, after its reference [4])."""


def gain(mean_radius: Number, ball_circle_radius: Number, tan_wall_angle: Number) -> Number:
    """Feedback gain C = (R_cp/r)·tan α.

    Source: F11, after (11); S19 and S21 use the same definition.

    Args:
        mean_radius: R_cp, mean friction radius [m].
        ball_circle_radius: r, radius of the ball circle [m].
        tan_wall_angle: tan α, wall angle from the axis [1].

    Returns:
        C [1].

    Validity:
        0 ≤ α < 90°; α = 0 gives no release force.

    >>> gain(0.1, 0.05, 0.25)
    0.5
    """
    return mean_radius / ball_circle_radius * tan_wall_angle


def controlled_pairs(pairs: Number, bypass_pairs: Number) -> Number:
    """Pairs whose torque passes the balls, z_2 = z − z_1.

    Source: F11, before (1).

    Args:
        pairs: z, friction pairs, all groups [1].
        bypass_pairs: z_1, pairs that bypass the control unit [1].

    Returns:
        z_2 [1].

    Validity:
        z_1 ≤ z; none of a conventional clutch.
    """
    return pairs - bypass_pairs


def reduced_gain(controlled_pairs: Number, gain: Number) -> Number:
    """Reduced gain, z_2 C: the gain of the whole feedback loop per unit of friction.

    Source: S22 (zC of the all-driving clutch); S19 ((z − 1)C).

    Args:
        controlled_pairs: z_2, pairs whose torque passes the balls [1].
        gain: C, feedback gain [1].

    Returns:
        z_2 C, the reduced gain [1].

    Validity:
        Any direct variant; 0 for the conventional clutch.
    """
    return controlled_pairs * gain


def normal_force(closing_force: Number, controlled_pairs: Number, gain: Number, friction_driven: Number) -> Number:
    """Normal force on the friction pairs, N = F_п/(1 + C z_2 f_2).

    Source: F11 (3) with (11) mended (M1).

    Args:
        closing_force: F_п, closing-spring force as set [N].
        controlled_pairs: z_2, pairs whose torque passes the balls [1].
        gain: C, feedback gain [1].
        friction_driven: f_2, friction of the controlled pairs [1].

    Returns:
        N [N].

    Validity:
        C, f_2 ≥ 0; balls and thrust bearing without friction.
    """
    return closing_force / (1 + gain * controlled_pairs * friction_driven)


def release_force(closing_force: Number, controlled_pairs: Number, gain: Number, friction_driven: Number) -> Number:
    """Release force of the control unit, F_p = F_п C z_2 f_2/(1 + C z_2 f_2).

    Source: F11 (11), mended (M1: the print has lost C from the numerator).

    Args:
        closing_force: F_п, closing-spring force as set [N].
        controlled_pairs: z_2, pairs whose torque passes the balls [1].
        gain: C, feedback gain [1].
        friction_driven: f_2, friction of the controlled pairs [1].

    Returns:
        F_p [N].

    Validity:
        C, f_2 ≥ 0.
    """
    feedback = gain * controlled_pairs * friction_driven
    return closing_force * feedback / (1 + feedback)


def torque_per_force(
    mean_radius: Number,
    bypass_pairs: Number,
    controlled_pairs: Number,
    gain: Number,
    friction_driving: Number,
    friction_driven: Number,
) -> Number:
    """Slip torque per spring force, T/F_п = R (z_1 f_1 + z_2 f_2)/(1 + C z_2 f_2).

    Source: F11 (12); R g(f) of S19 (1)–(4).

    Args:
        mean_radius: R_cp, mean friction radius [m].
        bypass_pairs: z_1, pairs that bypass the control unit [1].
        controlled_pairs: z_2, pairs whose torque passes the balls [1].
        gain: C, feedback gain [1].
        friction_driving: f_1, friction of the bypass pairs [1].
        friction_driven: f_2, friction of the controlled pairs [1].

    Returns:
        T/F_п [m].

    Validity:
        As ``torque``.
    """
    return (
        mean_radius
        * (bypass_pairs * friction_driving + controlled_pairs * friction_driven)
        / (1 + gain * controlled_pairs * friction_driven)
    )


def torque(
    closing_force: Number,
    mean_radius: Number,
    bypass_pairs: Number,
    controlled_pairs: Number,
    gain: Number,
    friction_driving: Number,
    friction_driven: Number,
) -> Number:
    """Sustained slip torque, T = F_п R (z_1 f_1 + z_2 f_2)/(1 + C z_2 f_2).

    Source: F11 (9), (12), (13); S19 (1), (2); S22 (4), (16).

    Args:
        closing_force: F_п, closing-spring force as set [N].
        mean_radius: R_cp, mean friction radius [m].
        bypass_pairs: z_1, pairs that bypass the control unit [1].
        controlled_pairs: z_2, pairs whose torque passes the balls [1].
        gain: C, feedback gain [1].
        friction_driving: f_1, friction of the bypass pairs [1].
        friction_driven: f_2, friction of the controlled pairs [1].

    Returns:
        T [N*m].

    Validity:
        Up to C = 1/(z_1 f_1max) this is also the largest torque of the slip; above it the bypass
        pairs may give a higher breakaway peak first (see ``group_torque``).

    >>> torque(2000.0, 0.1, 1, 7, 0.0, 0.25, 0.25)
    400.0
    """
    return (
        closing_force
        * mean_radius
        * (bypass_pairs * friction_driving + controlled_pairs * friction_driven)
        / (1 + gain * controlled_pairs * friction_driven)
    )


def group_torque(normal_force: Number, mean_radius: Number, pairs: Number, friction: Number) -> Number:
    """Torque of one group of pairs under a normal force, T_i = R z_i f_i N.

    Source: F11 (2), (6); S21 (9) for all pairs.

    Args:
        normal_force: N, normal force on the pairs [N].
        mean_radius: R_cp, mean friction radius [m].
        pairs: z_i, pairs of the group [1].
        friction: f_i, friction of the group [1].

    Returns:
        T_i [N*m].

    Validity:
        Slipping pairs. With N = F_п and the bypass pairs it is what they carry before the balls take a share, the
        condition behind C ≤ 1/(z_1 f_max) (F11 p. 4; theory, section 3).
    """
    return normal_force * mean_radius * pairs * friction


def gain_limit_differentiated(bypass_pairs: Number, friction_driving_max: Number) -> Number:
    """Gain above which the bypass pairs alone carry more than the regulated torque, 1/(z_1 f_1max).

    Source: F11 p. 4; S22 (24); S19 has C = 1/f_max, that is z_1 = 1.

    Args:
        bypass_pairs: z_1, pairs that bypass the control unit [1].
        friction_driving_max: f_1max, largest friction of the bypass pairs [1].

    Returns:
        C_max, the limit of C [1].

    Validity:
        z_1 ≥ 1.
    """
    return 1 / (bypass_pairs * friction_driving_max)


def gain_limit_all_driving(pairs: Number) -> Number:
    """Recommended largest gain of the all-driving clutch, from zC ≤ 5.

    Source: S22, after its reference [4].

    Args:
        pairs: z, friction pairs [1].

    Returns:
        C_max, the limit of C [1].

    Validity:
        z_1 = 0. A recommendation, not a law.
    """
    return RECOMMENDED_REDUCED_GAIN / pairs
