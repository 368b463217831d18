"""The wall of a pocket, straight or curved, in the cylindrical section at the ball circle (theory, section 12).

Coordinates of a sleeve: ξ from where the ball's centre is at the stop along the axis out of the pocket, Y around the
circle. With the curved wall in one sleeve the ball stays seated in the other and ξ is the travel; with walls alike in
both ξ is half of it, as in S21.
"""

from ._types import Number


def path_steepening(gain_slope: Number, ball_circle_radius: Number, mean_radius: Number, sleeves: Number) -> Number:
    """How fast the path of the ball's centre steepens, Y'' = m (r/R) C_1.

    Source: Theory, section 12: tan α(x) = tan α_0 + (r/R) C_1 x with x = m ξ.

    Args:
        gain_slope: C_1, how the gain grows with travel [1/m].
        ball_circle_radius: r, radius of the ball circle [m].
        mean_radius: R_cp, mean friction radius [m].
        sleeves: m, sleeves that the ball moves in: 1 or 2 [1].

    Returns:
        Y'' [1/m].

    Validity:
        0 for a straight wall.
    """
    return sleeves * gain_slope * ball_circle_radius / mean_radius


def path_tangent(tan_wall_angle: Number, path_steepening: Number, path_depth: Number) -> Number:
    """Tangent of the wall angle where the ball is, tan α = tan α_0 + Y'' ξ.

    Source: Theory, section 12.

    Args:
        tan_wall_angle: tan α_0, tangent of the wall angle at the stop [1].
        path_steepening: Y'', second derivative of the path of the ball's centre [1/m].
        path_depth: ξ, along the axis from the place at the stop [m].

    Returns:
        tan α [1].

    Validity:
        ξ ≥ 0.
    """
    return tan_wall_angle + path_steepening * path_depth


def path(tan_wall_angle: Number, path_steepening: Number, path_depth: Number) -> Number:
    """Path of the ball's centre in a sleeve, Y = ξ tan α_0 + Y'' ξ²/2.

    Source: Theory, section 12: r dφ = tan α dx.

    Args:
        tan_wall_angle: tan α_0, tangent of the wall angle at the stop [1].
        path_steepening: Y'', second derivative of the path of the ball's centre [1/m].
        path_depth: ξ, along the axis from the place at the stop [m].

    Returns:
        Y, around the ball circle [m].

    Validity:
        ξ ≥ 0.
    """
    return path_depth * tan_wall_angle + path_steepening * path_depth * path_depth / 2


def wall_axial(path_depth: Number, ball_radius: Number, sin_wall_angle: Number) -> Number:
    """Place of the contact along the axis, ξ − r_ш sin α.

    Source: Theory, section 12: the wall is r_ш off the path of the ball's centre.

    Args:
        path_depth: ξ, along the axis from the place at the stop [m].
        ball_radius: r_ш, ball radius [m].
        sin_wall_angle: sin α, where the ball is [1].

    Returns:
        ξ_w [m].

    Validity:
        No undercut.
    """
    return path_depth - ball_radius * sin_wall_angle


def wall_around(path: Number, ball_radius: Number, cos_wall_angle: Number) -> Number:
    """Place of the contact around the circle, Y + r_ш cos α.

    Source: Theory, section 12: the wall is r_ш off the path of the ball's centre.

    Args:
        path: Y, place on the path, around the ball circle [m].
        ball_radius: r_ш, ball radius [m].
        cos_wall_angle: cos α, where the ball is [1].

    Returns:
        Y_w [m].

    Validity:
        No undercut.
    """
    return path + ball_radius * cos_wall_angle


def contact_depth(ball_radius: Number, sin_wall_angle: Number, path_depth: Number, face_gap: Number) -> Number:
    """Depth of the contact below the face, r_ш sin α − ξ − s/2.

    Source: S21 (23) with the angle where the ball is (theory, section 12); at the stop its centre is s/2 off the face.

    Args:
        ball_radius: r_ш, ball radius [m].
        sin_wall_angle: sin α, where the ball is [1].
        path_depth: ξ, along the axis from the place at the stop [m].
        face_gap: s, gap between the faces [m].

    Returns:
        h_w [m].

    Validity:
        Falls all along while there is no undercut.
    """
    return ball_radius * sin_wall_angle - path_depth - face_gap / 2


def path_radius(path_steepening: Number, cos_wall_angle: Number) -> Number:
    """Radius of curvature of the path, ρ = 1/(Y'' cos³α): no ball as large can run on it without undercutting the wall.

    Source: Theory, section 12: (1 + tan²α)^{3/2}/Y''.

    Args:
        path_steepening: Y'', second derivative of the path of the ball's centre [1/m].
        cos_wall_angle: cos α, where the ball is [1].

    Returns:
        ρ [m].

    Validity:
        Y'' > 0; least at the stop. The wall is convex with the radius ρ − r_ш.
    """
    return 1 / (path_steepening * cos_wall_angle * cos_wall_angle * cos_wall_angle)


def seat_force(
    contact_force: Number, sin_sum_of_angles: Number, sin_wall_angle: Number, cos_wall_angle: Number
) -> Number:
    """Force of the wall that seats the ball in the other sleeve, F_s = F_n sin(α + α_0)/sin 2α_0.

    Source: Theory, section 12, with the balance of the ball: pushed at the angle α, borne by the seat's walls at α_0.

    Args:
        contact_force: F_n, force of the curved wall on the ball [N].
        sin_sum_of_angles: sin(α + α_0) [1].
        sin_wall_angle: sin α_0, sine of the angle of the seat's walls [1].
        cos_wall_angle: cos α_0 [1].

    Returns:
        F_s, the larger of the two [N].

    Validity:
        α ≥ α_0: else the ball climbs out of its seat. Seat with straight walls.
    """
    return contact_force * sin_sum_of_angles / (2 * sin_wall_angle * cos_wall_angle)


def hertz_curvature_ratio(path_radius: Number, ball_radius: Number) -> Number:
    """Ratio of the relative curvatures of ball and convex wall, A/B = ρ/(ρ − r_ш).

    Source: Johnson, Contact Mechanics (1985), (4.5): A = (1/r_ш + 1/(ρ − r_ш))/2, B = 1/(2 r_ш).

    Args:
        path_radius: ρ, radius of curvature of the path [m].
        ball_radius: r_ш, ball radius [m].

    Returns:
        A/B [1].

    Validity:
        ρ > r_ш; the wall is straight across the section.
    """
    return path_radius / (path_radius - ball_radius)


def hertz_relative_radius(ball_radius: Number, curvature_ratio: Number) -> Number:
    """Relative radius of curvature of the contact, R_e = 1/(2√(A B)) = r_ш/√(A/B).

    Source: Johnson, Contact Mechanics (1985), (4.5).

    Args:
        ball_radius: r_ш, ball radius [m].
        curvature_ratio: A/B, ratio of the relative curvatures [1].

    Returns:
        R_e [m].

    Validity:
        As ``hertz_curvature_ratio``.
    """
    return ball_radius / curvature_ratio**0.5


def hertz_axes(axis_ratio: Number, integral_b: Number, integral_d: Number) -> Number:
    """Ratio of the curvatures that gives the contact an ellipse, A/B = 𝐁/(k² 𝐃).

    Source: Johnson, Contact Mechanics (1985), (4.26a), with 𝐃 = (K − E)/e² and 𝐁 = K − 𝐃.

    Args:
        axis_ratio: k, minor over major semi-axis [1].
        integral_b: 𝐁, complete elliptic integral of modulus √(1 − k²) [1].
        integral_d: 𝐃, complete elliptic integral of modulus √(1 − k²) [1].

    Returns:
        A/B [1].

    Validity:
        0 < k ≤ 1; 1 for a circle.
    """
    return integral_b / (axis_ratio * axis_ratio * integral_d)


def hertz_ellipse_factor(axis_ratio: Number, integral_b: Number, integral_d: Number, pi: Number) -> Number:
    """How much an elliptic contact is larger than a circular one of equal R_e, φ = (4/π) √(k 𝐁 𝐃).

    Source: Johnson, Contact Mechanics (1985), (4.27): (a b)^{3/2} = 3 F R_e φ/(4 E_c).

    Args:
        axis_ratio: k, minor over major semi-axis [1].
        integral_b: 𝐁, complete elliptic integral of modulus √(1 − k²) [1].
        integral_d: 𝐃, complete elliptic integral of modulus √(1 − k²) [1].
        pi: π, a symbol under SymPy [1].

    Returns:
        φ [1].

    Validity:
        0 < k ≤ 1; 1 for a circle. A ball on a flat of the radius R_e φ bears as much at the same pressure.
    """
    return 4 * (axis_ratio * integral_b * integral_d) ** 0.5 / pi
