"""Synthesis of the control unit: wall angle, balls, pockets, contact (S21; theory, section 5)."""

from ._types import Number


def tan_wall_angle(gain: Number, ball_circle_radius: Number, mean_radius: Number) -> Number:
    """Tangent of the wall angle that gives a gain, tan α = C r/R.

    Source: S21 (24).

    Args:
        gain: C, feedback gain [1].
        ball_circle_radius: r, radius of the ball circle [m].
        mean_radius: R_cp, mean friction radius [m].

    Returns:
        tan α [1].

    Validity:
        C ≥ 0.
    """
    return gain * ball_circle_radius / mean_radius


def ball_radius(travel: Number, face_gap: Number, edge_clearance: Number, sin_wall_angle: Number) -> Number:
    """Ball radius for a travel, r_ш = (x_max + s + 2 y)/(2 sin α).

    Source: S21 (23).

    Args:
        travel: x, axial travel of the sleeve [m].
        face_gap: s, gap between the faces [m].
        edge_clearance: y, clearance of the contact from the pocket's edge [m].
        sin_wall_angle: sin α [1].

    Returns:
        r_ш [m].

    Validity:
        α > 0.
    """
    return (travel + face_gap + 2 * edge_clearance) / (2 * sin_wall_angle)


def edge_clearance(ball_radius: Number, travel: Number, face_gap: Number, sin_wall_angle: Number) -> Number:
    """Clearance that a given ball leaves, y = r_ш sin α − (x_max + s)/2: the inverse of (23).

    Source: S21 (23).

    Args:
        ball_radius: r_ш, ball radius [m].
        travel: x, axial travel of the sleeve [m].
        face_gap: s, gap between the faces [m].
        sin_wall_angle: sin α [1].

    Returns:
        y [m].

    Validity:
        α > 0.
    """
    return ball_radius * sin_wall_angle - (travel + face_gap) / 2


def pocket_depth(ball_radius: Number, sin_wall_angle: Number, face_gap: Number) -> Number:
    """Pocket depth to the virtual apex, where the walls would meet, h_1 = r_ш/sin α − s/2.

    Source: S21 (20).

    Args:
        ball_radius: r_ш, ball radius [m].
        sin_wall_angle: sin α [1].
        face_gap: s, gap between the faces [m].

    Returns:
        h_1 [m].

    Validity:
        α > 0.
    """
    return ball_radius / sin_wall_angle - face_gap / 2


def pocket_depth_from_travel(
    ball_radius: Number, sin_wall_angle: Number, cos_wall_angle: Number, travel: Number, edge_clearance: Number
) -> Number:
    """Pocket depth from the travel, h_2 = r_ш cos α cot α + x_max/2 + y; equal to h_1.

    Source: S21 (22), (21).

    Args:
        ball_radius: r_ш, ball radius [m].
        sin_wall_angle: sin α [1].
        cos_wall_angle: cos α [1].
        travel: x, axial travel of the sleeve [m].
        edge_clearance: y, clearance of the contact from the pocket's edge [m].

    Returns:
        h_2 [m].

    Validity:
        α > 0.
    """
    return ball_radius * cos_wall_angle * cos_wall_angle / sin_wall_angle + travel / 2 + edge_clearance


def pocket_depth_cut(ball_radius: Number, face_gap: Number) -> Number:
    """Depth to cut a pocket to, h_c = r_ш − s/2: the lowest point of the ball below the face.

    Source: Geometry of S21 (20): the ball's centre lies s/2 above the face.

    Args:
        ball_radius: r_ш, ball radius [m].
        face_gap: s, gap between the faces [m].

    Returns:
        h_c [m].

    Validity:
        The walls end under the ball, h_c ≤ h_1.
    """
    return ball_radius - face_gap / 2


def pocket_width(pocket_depth: Number, tan_wall_angle: Number) -> Number:
    """Width of the pocket's mouth at the face, b = 2 h_1 tan α.

    Source: Geometry of S21 (20): the walls meet at the virtual apex.

    Args:
        pocket_depth: h_1, pocket depth to the virtual apex [m].
        tan_wall_angle: tan α [1].

    Returns:
        b [m].

    Validity:
        Straight walls.
    """
    return 2 * pocket_depth * tan_wall_angle


def ball_pitch(ball_circle_radius: Number, sin_half_pitch: Number) -> Number:
    """Distance between the centres of neighbouring balls, t_ш = 2 r sin(π/n).

    Source: Geometry: chord of the ball circle.

    Args:
        ball_circle_radius: r, radius of the ball circle [m].
        sin_half_pitch: sin(π/n), sine of half the pitch angle of n balls [1].

    Returns:
        t_ш [m].

    Validity:
        n ≥ 2.
    """
    return 2 * ball_circle_radius * sin_half_pitch


def web(ball_pitch: Number, pocket_width: Number) -> Number:
    """Web that is left between neighbouring pockets at the face, e = t_ш − b.

    Source: Geometry: chord of the ball circle.

    Args:
        ball_pitch: t_ш, distance between the centres of neighbouring balls [m].
        pocket_width: b, width of the pocket's mouth [m].

    Returns:
        e [m].

    Validity:
        Not above 0 the pockets cut into each other.
    """
    return ball_pitch - pocket_width


def contact_force(torque: Number, balls: Number, ball_circle_radius: Number, cos_wall_angle: Number) -> Number:
    """Normal force on one ball, F_n = T/(n r cos α).

    Source: S21, contact force after (24), mended (M10).

    Args:
        torque: T, torque that passes the balls [N*m].
        balls: n, number of balls [1].
        ball_circle_radius: r, radius of the ball circle [m].
        cos_wall_angle: cos α [1].

    Returns:
        F_n [N].

    Validity:
        All balls share the torque alike; T is what passes the balls (direct clutches: T_2).
    """
    return torque / (balls * ball_circle_radius * cos_wall_angle)


def least_contact_force_cubic(
    numerator_constant: Number,
    numerator_slope: Number,
    denominator_constant: Number,
    denominator_slope: Number,
    radius_ratio: Number,
) -> Number:
    """Coefficients, highest power first, of the cubic in C whose root makes the contact force least.

    Source: Derivative of F_n ∝ (a + b C)·√(1 + q²C²)/(a' + b' C), q = r/R (theory, section 5).

    Args:
        numerator_constant: a [1].
        numerator_slope: b [1].
        denominator_constant: a' [1].
        denominator_slope: b' [1].
        radius_ratio: q = r/R [1].

    Returns:
        k, coefficients of q²C(a + bC)(a' + b'C) − (a b' − a' b)(1 + q²C²) [1].

    Validity:
        b' a > b a': the torque falls with C.
    """
    squared = radius_ratio * radius_ratio
    fall = numerator_constant * denominator_slope - numerator_slope * denominator_constant
    return (
        squared * numerator_slope * denominator_slope,
        squared * (numerator_constant * denominator_slope + numerator_slope * denominator_constant - fall),
        squared * numerator_constant * denominator_constant,
        -fall,
    )


def hertz_contact_modulus(
    ball_modulus: Number, ball_poisson: Number, wall_modulus: Number, wall_poisson: Number
) -> Number:
    """Contact modulus E_c from 1/E_c = (1 − ν_1²)/E_1 + (1 − ν_2²)/E_2.

    Source: Johnson, Contact Mechanics (1985), (4.2a).

    Args:
        ball_modulus: E_1, elastic modulus of the ball [Pa].
        ball_poisson: ν_1, Poisson's ratio of the ball [1].
        wall_modulus: E_2, elastic modulus of the pocket wall [Pa].
        wall_poisson: ν_2, Poisson's ratio of the pocket wall [1].

    Returns:
        E_c [Pa].

    Validity:
        Elastic half-spaces.
    """
    return 1 / ((1 - ball_poisson * ball_poisson) / ball_modulus + (1 - wall_poisson * wall_poisson) / wall_modulus)


def hertz_allowable_force(
    allowable_pressure: Number, ball_radius: Number, contact_modulus: Number, pi: Number
) -> Number:
    """Force at which a ball on a flat reaches the allowable pressure, F = π³ p_0³ r²/(6 E_c²).

    Source: Johnson, Contact Mechanics (1985), (4.24) with R = r (ball on flat).

    Args:
        allowable_pressure: p_0, allowable maximum contact pressure [Pa].
        ball_radius: r_ш, ball radius [m].
        contact_modulus: E_c [Pa].
        pi: π, a symbol under SymPy [1].

    Returns:
        F_n,allow, allowable normal force on the ball [N].

    Validity:
        Elastic, frictionless, contact small against the ball; the wall is flat.
    """
    return pi**3 * allowable_pressure**3 * ball_radius**2 / (6 * contact_modulus**2)


def hertz_pressure(allowable_pressure: Number, force: Number, allowable_force: Number) -> Number:
    """Largest contact pressure under a force, p_0 = p_0,allow (F_n/F_n,allow)^{1/3}.

    Source: Johnson, Contact Mechanics (1985), (4.24), (4.30): p_0³ grows as the force, whatever the curvatures.

    Args:
        allowable_pressure: p_0,allow, allowable maximum contact pressure [Pa].
        force: F_n, normal force on the ball [N].
        allowable_force: F_n,allow, force at which the ball reaches the allowable pressure [N].

    Returns:
        p_0 [Pa].

    Validity:
        Elastic, frictionless, contact small against the ball.
    """
    return allowable_pressure * (force / allowable_force) ** (1 / 3)
