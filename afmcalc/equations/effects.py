"""Effects that the torque law neglects (handbook, chapter 13)."""


def spline_share(spline_friction, friction, mean_radius, spline_radius):
    """Share of a pair's normal force that its disc's spline can hold, μ_s f R/r_s.
    Source: Finkin, J. Lubr. Technol. 90 (1968) 65; handbook, chapter 13. Validity: ε < 1: beyond it the spline
    locks."""
    return spline_friction * friction * mean_radius / spline_radius


def next_force_closing(normal_force, share, share_next):
    """Normal force on the next pair when the pack closes under torque, N (1 − ε)/(1 + ε').
    Source: Balance of the disc between them; handbook, chapter 13. Validity: Every disc moves away from the spring."""
    return normal_force * (1 - share) / (1 + share_next)


def next_force_opening(normal_force, share, share_next):
    """Normal force on the next pair when the balls unload the pack, N (1 + ε)/(1 − ε').
    Source: Balance of the disc between them; handbook, chapter 13. Validity: Every disc moves towards the spring; the
    result is at most the force that closed the pack."""
    return normal_force * (1 + share) / (1 - share_next)


def ball_mass(density, ball_radius, pi):
    """Mass of a ball, ρ (4/3) π r_ш³. Source: Handbook, chapter 13."""
    return 4 * pi * density * ball_radius**3 / 3


def centrifugal_thrust(balls, ball_mass, speed, ball_circle_radius, tan_wall_angle):
    """Axial force of the balls that are thrown against conical pockets, ½ n m_ш ω² r tan α.
    Source: Handbook, chapter 13. Validity: Pockets are cones; in grooves along the circle the balls lie against the
    rim, and ΔN = 0."""
    return balls * ball_mass * speed * speed * ball_circle_radius * tan_wall_angle / 2


def force_lost_by_wear(stiffness, pairs, wear):
    """Spring force lost when every pair has worn, c_п z δ.
    Source: Handbook, chapter 10. Validity: Linear spring that is not re-adjusted."""
    return stiffness * pairs * wear


def key_share(pairs, mean_radius, friction, key_friction, key_diameter):
    """Share of the force on the pack that the key of the pressure disc holds, e = 2 z R f f_7/d_7.
    Source: S21: discs 4 sit on disc 5, whose key 7 passes the whole torque. Validity: The key slides as the sleeve
    moves; with e ≥ 1 it locks itself."""
    return 2 * pairs * mean_radius * friction * key_friction / key_diameter
