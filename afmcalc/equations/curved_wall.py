"""Curved wall of a pocket in one sleeve; the ball stays seated in the other sleeve (handbook, chapter 12).

Coordinates in the cylindrical section at the ball circle: ξ along the axis from the ball's centre at the stop, equal to
the travel; Y around the circle.
"""

import math

from .arrays import atan, beside, cos, larger, largest_along, sin, smaller, spread, zero_of


def path_steepening(gain_slope, ball_circle_radius, mean_radius):
    """Second derivative of the path of the ball's centre, Y'' = (r/R) C_1.
    Source: Handbook, chapter 12: tan α(x) = tan α_0 + (r/R) C_1 x. Validity: One sleeve has the curved wall; 0 for a
    straight one."""
    return gain_slope * ball_circle_radius / mean_radius


def undercut_radius(path_steepening, cos_wall_angle):
    """Radius of curvature of the path, ρ = 1/(Y'' cos³α): no ball as large can run on it without undercutting the wall.
    Source: Handbook, chapter 12: (1 + tan²α)^{3/2}/Y''. Validity: Y'' > 0; least at the stop. The wall is convex with
    the radius ρ − r_ш."""
    return 1 / (path_steepening * cos_wall_angle * cos_wall_angle * cos_wall_angle)


def tan_wall_angle_at_ball(tan_wall_angle, path_steepening, travel):
    """Tangent of the wall angle where the ball is, tan α = tan α_0 + Y'' ξ.
    Source: Handbook, chapter 12. Validity: ξ ≥ 0."""
    return tan_wall_angle + path_steepening * travel


def wall_angle_at_ball(tan_wall_angle_at_ball):
    """Wall angle where the ball is, α. Source: Handbook, chapter 12. Validity: ξ ≥ 0."""
    return atan(tan_wall_angle_at_ball)


def path_around(tan_wall_angle, path_steepening, travel):
    """Path of the ball's centre around the circle, Y = ξ tan α_0 + Y'' ξ²/2.
    Source: Handbook, chapter 12: r dφ = tan α dx. Validity: ξ ≥ 0."""
    return travel * tan_wall_angle + path_steepening * travel * travel / 2


def wall_axial(travel, ball_radius_chosen, wall_angle_at_ball):
    """Place of the contact along the axis, ξ − r_ш sin α.
    Source: Handbook, chapter 12: the wall is r_ш off the path of the ball's centre. Validity: No undercut."""
    return travel - ball_radius_chosen * sin(wall_angle_at_ball)


def wall_around(path_around, ball_radius_chosen, wall_angle_at_ball):
    """Place of the contact around the circle, Y + r_ш cos α.
    Source: Handbook, chapter 12: the wall is r_ш off the path of the ball's centre. Validity: No undercut."""
    return path_around + ball_radius_chosen * cos(wall_angle_at_ball)


def wall_angle_max(tan_wall_angle, path_steepening, travel_max):
    """Wall angle at the largest travel, arctan(tan α_0 + Y'' x_max).
    Source: Handbook, chapter 12. Validity: x_max ≥ 0."""
    return atan(tan_wall_angle + path_steepening * travel_max)


def ball_radius(face_gap, edge_clearance, sin_wall_angle, travel_max, wall_angle_max):
    """Smallest ball radius for a travel, the larger of S21 (23) at the stop and at x_max with the angles there.
    Source: S21 (23) with the angle where the ball is (handbook, chapter 12). Validity: Between the two no place asks
    for more."""
    at_stop = (face_gap + 2 * edge_clearance) / (2 * sin_wall_angle)
    return larger(at_stop, (2 * travel_max + face_gap + 2 * edge_clearance) / (2 * sin(wall_angle_max)))


def edge_clearance_standard(ball_radius_chosen, travel_max, face_gap, sin_wall_angle, wall_angle_max):
    """Least clearance with the ball chosen, r_ш sin α − ξ − s/2 at the stop or at x_max.
    Source: S21 (23) with the angle where the ball is (handbook, chapter 12). Validity: The ball does not undercut the
    wall."""
    moved = ball_radius_chosen * sin(wall_angle_max) - travel_max
    return smaller(ball_radius_chosen * sin_wall_angle, moved) - face_gap / 2


def travel_to_mouth(ball_radius_chosen, tan_wall_angle, path_steepening, face_gap):
    """Travel at which the ball would touch the edge of the pocket, r_ш sin α(ξ) = ξ + s/2.
    Source: S21 (23) with the angle where the ball is (handbook, chapter 12), solved for ξ. Validity: The ball does not
    undercut the wall."""

    def depth(place):
        return ball_radius_chosen * sin(atan(tan_wall_angle + path_steepening * place)) - place - face_gap / 2

    return zero_of(depth, ball_radius_chosen)


def pocket_width(travel_to_mouth, tan_wall_angle, path_steepening, ball_radius_chosen):
    """Width of the pocket's mouth at the face, b = 2 (Y + r_ш cos α) with Y = ξ tan α_0 + Y'' ξ²/2.
    Source: Handbook, chapter 12: the wall is r_ш off the path of the ball's centre. Validity: No undercut."""
    around = travel_to_mouth * tan_wall_angle + path_steepening * travel_to_mouth * travel_to_mouth / 2
    return 2 * (around + ball_radius_chosen * cos(atan(tan_wall_angle + path_steepening * travel_to_mouth)))


def friction_along_wall(friction_leaving_in_range, friction_max, friction_of_torque_max):
    """Frictions at which the ball comes along the wall, 65 over the range, and that of the largest torque.
    Source: Handbook, chapter 12. Validity: At a jump the place just before it."""
    before = larger(friction_of_torque_max * (1 - 1e-12), friction_leaving_in_range)
    return beside(spread(friction_leaving_in_range, friction_max, 65), before)


def contact_force_at_ball(torque, balls, ball_circle_radius, tan_wall_angle_at_ball):
    """Normal force on one ball where it is, T/(n r cos α).
    Source: S21, contact force after (24), mended (M10), with the angle where the ball is. Validity: All balls share the
    torque alike."""
    return torque * (1 + tan_wall_angle_at_ball**2) ** 0.5 / (balls * ball_circle_radius)


def contact_force(contact_force_at_ball_at_along_wall):
    """Largest normal force on one ball along the wall.
    Source: S21, contact force after (24), mended (M10), with the angle where the ball is. Validity: As the sleeve
    leaves its stop for x_max."""
    return largest_along(contact_force_at_ball_at_along_wall)


def contact_radius_at_ball(ball_radius_chosen, path_steepening, tan_wall_angle_at_ball):
    """Radius of a ball that presses a flat as this one does the convex wall, R_e = 2 r_ш (ρ − r_ш)/(2 ρ − r_ш).
    Source: Johnson, Contact Mechanics (1985), (4.5): the mean 1/R_e = A + B of the relative curvatures 1/r_ш + 1/(ρ −
    r_ш) in the section and 1/r_ш across it. Validity: ρ > r_ш. On the safe side: p_0 by it exceeds that of the ellipse
    by 2.6 % at ρ = 2 r_ш, 8.5 % at 1.4 r_ш."""
    path_radius = (1 + tan_wall_angle_at_ball**2) ** 1.5 / path_steepening
    return 2 * ball_radius_chosen * (path_radius - ball_radius_chosen) / (2 * path_radius - ball_radius_chosen)


def contact_pressure_at_ball(allowable_pressure, contact_force_at_ball, contact_radius_at_ball, contact_modulus):
    """Largest contact pressure where the ball is, p_0 = p_0,allow (F_n/F)^{1/3} with F = π³ p_0,allow³ R_e²/(6 E_c²).
    Source: Johnson, Contact Mechanics (1985), (4.24), (4.30). Validity: Elastic, frictionless, contact small against
    the ball."""
    allowable = (math.pi * allowable_pressure) ** 3 * contact_radius_at_ball**2 / (6 * contact_modulus**2)
    return allowable_pressure * (contact_force_at_ball / allowable) ** (1 / 3)


def contact_pressure(contact_pressure_at_ball_at_along_wall):
    """Largest contact pressure along the wall; it need not be where the force is largest.
    Source: Johnson, Contact Mechanics (1985), (4.24), with the wall where the ball is. Validity: As the sleeve leaves
    its stop for x_max."""
    return largest_along(contact_pressure_at_ball_at_along_wall)


def contact_force_hertz(contact_force, allowable_pressure, contact_pressure):
    """Largest force on a ball with which the pressure is the allowable one, F_n (p_0,allow/p_0)³.
    Source: Johnson, Contact Mechanics (1985), (4.24): p_0³ grows as the force, whatever the curvatures. Validity: All
    forces along the wall grow alike."""
    return contact_force * (allowable_pressure / contact_pressure) ** 3


CASES = {"along_wall": {"friction": "friction_along_wall"}}
