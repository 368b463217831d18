"""What the torque law neglects (theory of the drive, section 13)."""

from ._types import Number


def spline_share(spline_friction: Number, friction: Number, mean_radius: Number, spline_radius: Number) -> Number:
    """Share of a pair's normal force that its disc's spline can hold, μ_s f R/r_s.

    Source: Finkin, J. Lubr. Technol. 90 (1968) 65; theory of the drive, section 13.

    Args:
        spline_friction: μ_s, friction of the disc in its spline [1].
        friction: f, coefficient of friction of the pair [1].
        mean_radius: R_cp, mean friction radius [m].
        spline_radius: r_s, radius of the spline [m].

    Returns:
        ε [1].

    Validity:
        ε < 1: beyond it the spline locks.
    """
    return spline_friction * friction * mean_radius / spline_radius


def next_force_closing(normal_force: Number, share: Number, share_next: Number) -> Number:
    """Normal force on the next pair when the pack closes under torque, N (1 − ε)/(1 + ε').

    Source: Balance of the disc between them; theory of the drive, section 13.

    Args:
        normal_force: N, normal force on the pair nearer to the spring [N].
        share: ε, share of that pair at the disc [1].
        share_next: ε', share of the next pair at the disc [1].

    Returns:
        N' [N].

    Validity:
        Every disc moves away from the spring.
    """
    return normal_force * (1 - share) / (1 + share_next)


def next_force_opening(normal_force: Number, share: Number, share_next: Number) -> Number:
    """Normal force on the next pair when the balls unload the pack, N (1 + ε)/(1 − ε').

    Source: Balance of the disc between them; theory of the drive, section 13.

    Args:
        normal_force: N, normal force on the pair nearer to the spring [N].
        share: ε, share of that pair at the disc [1].
        share_next: ε', share of the next pair at the disc [1].

    Returns:
        N' [N].

    Validity:
        Every disc moves towards the spring; no more than what the pack was closed with.
    """
    return normal_force * (1 + share) / (1 - share_next)


def tan_wall_angle_loading(tan_wall_angle: Number, wall_friction: Number) -> Number:
    """Tangent that a sliding cam's wall acts with while it is driven up, tan(α − ρ), tan ρ = μ.

    Source: Theory of the drive, section 13: wedge with friction.

    Args:
        tan_wall_angle: tan α [1].
        wall_friction: μ, friction of the cam on the wall [1].

    Returns:
        tan(α − ρ) [1].

    Validity:
        tan α > μ; else the cams hold by themselves.
    """
    return (tan_wall_angle - wall_friction) / (1 + tan_wall_angle * wall_friction)


def tan_wall_angle_unloading(tan_wall_angle: Number, wall_friction: Number) -> Number:
    """Tangent that a sliding cam's wall acts with while it is driven back, tan(α + ρ), tan ρ = μ.

    Source: Theory of the drive, section 13: wedge with friction.

    Args:
        tan_wall_angle: tan α [1].
        wall_friction: μ, friction of the cam on the wall [1].

    Returns:
        tan(α + ρ) [1].

    Validity:
        μ tan α < 1.
    """
    return (tan_wall_angle + wall_friction) / (1 - tan_wall_angle * wall_friction)


def ball_mass(density: Number, ball_radius: Number, pi: Number) -> Number:
    """Mass of a ball, ρ (4/3) π r_ш³.

    Source: Theory of the drive, section 13.

    Args:
        density: ρ [kg/m^3].
        ball_radius: r_ш [m].
        pi: π, a symbol under SymPy [1].

    Returns:
        m_ш [kg].

    Validity:
        None.
    """
    return 4 * pi * density * ball_radius**3 / 3


def centrifugal_thrust(
    balls: Number, ball_mass: Number, speed: Number, ball_circle_radius: Number, tan_wall_angle: Number
) -> Number:
    """Axial force of the balls that are thrown against conical pockets, ½ n m_ш ω² r tan α.

    Source: Theory of the drive, section 13.

    Args:
        balls: n, number of balls [1].
        ball_mass: m_ш [kg].
        speed: ω, speed of rotation [rad/s].
        ball_circle_radius: r, radius of the ball circle [m].
        tan_wall_angle: tan α [1].

    Returns:
        ΔN [N].

    Validity:
        Pockets are cones; in grooves along the circle the balls lie against the rim, and ΔN = 0.
    """
    return balls * ball_mass * speed * speed * ball_circle_radius * tan_wall_angle / 2


def force_lost_by_wear(stiffness: Number, pairs: Number, wear: Number) -> Number:
    """Spring force lost when every pair has worn, c_п z δ.

    Source: Theory of the drive, section 10.

    Args:
        stiffness: c_п, stiffness of the spring that follows the pack [N/m].
        pairs: z, number of friction pairs [1].
        wear: δ, wear of a pair [m].

    Returns:
        ΔF [N].

    Validity:
        Nobody sets the spring again; a straight spring.
    """
    return stiffness * pairs * wear
