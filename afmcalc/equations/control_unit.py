"""Synthesis of the control unit: straight walls, balls, pockets, contact (S21 (16)–(24); handbook, chapter 5)."""

import math

from .arrays import atan, chosen, cos, larger, next_listed, sin
from .wiring import Same

face_gap = edge_clearance = 0.002
travel_max = lining = 0.0
ball_modulus = wall_modulus = 206e9
ball_poisson = wall_poisson = 0.3
allowable_pressure_static = 4.2e9
static_safety = 1.0
largest_driven_torque = Same("driven_torque_max")


def circumferential_force(driven_torque, ball_circle_radius):
    """Circumferential force on all the balls, F_o = T_2/r.
    Source: F11 (5); with (10) it is F_p/tan α. Validity: All of T_2 passes the balls."""
    return driven_torque / ball_circle_radius


def wall_angle(tan_wall_angle):
    """Wall angle of the pockets from the axis, α = arctan(C r/R); of a curved wall at the stop.
    Source: S21 (24). Validity: C ≥ 0."""
    return atan(tan_wall_angle)


def sin_wall_angle(wall_angle):
    """Sine of the wall angle, sin α. Source: Definition. Validity: 0 ≤ α < 90°."""
    return sin(wall_angle)


def cos_wall_angle(wall_angle):
    """Cosine of the wall angle, cos α. Source: Definition. Validity: 0 ≤ α < 90°."""
    return cos(wall_angle)


def wear_play(pairs, lining):
    """Play for the wear of the pack, w_z = z s_w: as it wears the pressure disc comes so much nearer to the balls.
    Source: Geometry. Validity: Direct clutches; without it the worn pack leaves part of its spring force to the
    balls."""
    return pairs * lining


def ball_radius(travel_max, wear_play, face_gap, edge_clearance, sin_wall_angle):
    """Ball radius for a travel, r_ш = (x_max + w_z + s + 2 y)/(2 sin α).
    Source: S21 (23); the play w_z beside its travel is ours. Validity: α > 0."""
    return (travel_max + wear_play + face_gap + 2 * edge_clearance) / (2 * sin_wall_angle)


def ball_diameter_standard(ball_radius, balls_listed):
    """Next standard ball, d_ш ≥ 2 r_ш; NaN where the list has none.
    Source: ISO 3290-1. Validity: A ball that is given takes its place."""
    return next_listed(2 * ball_radius, balls_listed)


def ball_radius_chosen(ball_diameter_standard, ball_radius):
    """Radius of the ball chosen, d_ш/2; without a large enough ball the radius needed. Source: Definition."""
    return chosen(ball_diameter_standard > 0, lambda: ball_diameter_standard / 2, lambda: ball_radius)


def ball_diameter(ball_radius_chosen):
    """Diameter of the ball chosen; without a large enough ball the diameter needed. Source: Definition."""
    return 2 * ball_radius_chosen


def ball_diameter_needed(ball_radius):
    """Smallest ball diameter for a travel, 2 r_ш. Source: S21 (23). Validity: α > 0."""
    return 2 * ball_radius


def ball_bore(ball_circle_radius, ball_diameter):
    """Diameter of the circle inside the balls, 2 r − d_ш; 0 where they reach the axis. Source: Geometry."""
    return larger(2 * ball_circle_radius - ball_diameter, 0.0)


def edge_clearance_standard(ball_radius_chosen, travel_max, wear_play, face_gap, sin_wall_angle):
    """Clearance that a given ball leaves, y = r_ш sin α − (x_max + w_z + s)/2: the inverse of (23).
    Source: S21 (23). Validity: α > 0."""
    return ball_radius_chosen * sin_wall_angle - (travel_max + wear_play + face_gap) / 2


def pocket_depth(ball_radius_chosen, sin_wall_angle, face_gap):
    """Pocket depth to the virtual apex, where the walls would meet, h_1 = r_ш/sin α − s/2.
    Source: S21 (20). Validity: α > 0."""
    return ball_radius_chosen / sin_wall_angle - face_gap / 2


def pocket_depth_from_travel(
    ball_radius_chosen, sin_wall_angle, cos_wall_angle, travel_max, wear_play, edge_clearance_standard
):
    """Pocket depth from the travel, h_2 = r_ш cos α cot α + (x_max + w_z)/2 + y; equal to h_1.
    Source: S21 (22), (21). Validity: α > 0."""
    seated = ball_radius_chosen * cos_wall_angle * cos_wall_angle / sin_wall_angle
    return seated + (travel_max + wear_play) / 2 + edge_clearance_standard


def pocket_depth_cut(ball_radius_chosen, face_gap):
    """Depth to cut a pocket to, h_c = r_ш − s/2: the lowest point of the ball below the face.
    Source: Geometry of S21 (20): the ball's centre lies s/2 above the face. Validity: The walls end under the ball, h_c
    ≤ h_1."""
    return ball_radius_chosen - face_gap / 2


def pocket_width(pocket_depth, tan_wall_angle):
    """Width of the pocket's mouth at the face, b = 2 h_1 tan α.
    Source: Geometry of S21 (20): the walls meet at the virtual apex. Validity: Straight walls."""
    return 2 * pocket_depth * tan_wall_angle


def sin_half_pitch(balls):
    """Sine of half the pitch angle of n balls, sin(π/n). Source: Geometry. Validity: n ≥ 2."""
    return sin(math.pi / balls)


def ball_pitch(ball_circle_radius, sin_half_pitch):
    """Distance between the centres of neighbouring balls, t_ш = 2 r sin(π/n).
    Source: Geometry: chord of the ball circle. Validity: n ≥ 2."""
    return 2 * ball_circle_radius * sin_half_pitch


def web(ball_pitch, pocket_width):
    """Web that is left between neighbouring pockets at the face, e = t_ш − b.
    Source: Geometry: chord of the ball circle. Validity: e > 0; otherwise the pockets cut into each other."""
    return ball_pitch - pocket_width


# contact


def contact_force(largest_driven_torque, balls, ball_circle_radius, cos_wall_angle):
    """Normal force on one ball, F_n = T/(n r cos α).
    Source: S21, contact force after (24), mended (M10). Validity: All balls share the torque alike; T is what passes
    the balls (direct clutches: T_2)."""
    return largest_driven_torque / (balls * ball_circle_radius * cos_wall_angle)


def contact_modulus(ball_modulus, ball_poisson, wall_modulus, wall_poisson):
    """Contact modulus E_c from 1/E_c = (1 − ν_1²)/E_1 + (1 − ν_2²)/E_2.
    Source: Johnson, Contact Mechanics (1985), (4.2a). Validity: Elastic half-spaces."""
    return 1 / ((1 - ball_poisson * ball_poisson) / ball_modulus + (1 - wall_poisson * wall_poisson) / wall_modulus)


def allowable_pressure(allowable_pressure_static, static_safety):
    """Allowable contact pressure with a static safety factor, [p_0] = p_s/∛s_0: the force falls s_0 times.
    Source: ISO 76: s_0 = F_0/F, the force as the cube of the pressure; p_s = 4200 MPa dents a ball by 10⁻⁴ d. Validity:
    Ball and wall of hardened steel; makers of bearings ask for s_0 ≥ 1.5 under shocks."""
    return allowable_pressure_static / static_safety ** (1 / 3)


def contact_force_hertz(allowable_pressure, ball_radius_chosen, contact_modulus):
    """Force at which a ball on a flat reaches the allowable pressure, F = π³ p_0,allow³ r²/(6 E_c²).
    Source: Johnson, Contact Mechanics (1985), (4.24) with R = r (ball on flat). Validity: Elastic, frictionless,
    contact small against the ball; the wall is flat."""
    return (math.pi * allowable_pressure) ** 3 * ball_radius_chosen**2 / (6 * contact_modulus**2)


def contact_pressure(allowable_pressure, contact_force, contact_force_hertz):
    """Largest contact pressure under a force, p_0 = p_0,allow (F_n/F_n,allow)^{1/3}.
    Source: Johnson, Contact Mechanics (1985), (4.24), (4.30): p_0³ grows as the force, whatever the curvatures.
    Validity: Elastic, frictionless, contact small against the ball."""
    return allowable_pressure * (contact_force / contact_force_hertz) ** (1 / 3)
