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
    Source: Balance of the disc between them; handbook, chapter 13. Validity: Every disc moves towards the spring; N' is
    at most the force the pack was closed with."""
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


SYMBOLS = """\
ball_mass | m_ш | kg | mass of a ball
centrifugal_thrust | ΔN | N |
density | ρ | kg/m^3 | density
force_lost_by_wear | ΔF | N |
next_force_closing | N' | N | normal force on the next pair
next_force_opening | N' | N | normal force on the next pair
pi | π | 1 | circumference over diameter of a circle
share | ε | 1 | share of its force that the spline holds, pair nearer to the spring
share_next | ε' | 1 | share of its force that the spline holds, next pair
speed | ω | rad/s | speed of rotation
spline_friction | μ_s | 1 | friction of the disc in its spline
spline_radius | r_s | m | radius of the spline
spline_share | ε | 1 | share of its force that the spline holds, pair nearer to the spring
stiffness | c_п | N/m | stiffness of the spring that follows the pack
wear | δ | m | wear of a pair
"""  # noqa: E501
