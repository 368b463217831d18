"""The wall of a pocket, straight or curved, in the cylindrical section at the ball circle (handbook, chapter 12).

Coordinates of a sleeve: ξ from where the ball's centre is at the stop along the axis out of the pocket, Y around the
circle. With the curved wall in one sleeve the ball stays seated in the other and ξ is the travel; with walls alike in
both ξ is half of it, as in S21.
"""

from typing import Annotated

from .calls import equation
from .terms import *


@equation
def path_steepening(
    gain_slope: GainSlope, ball_circle_radius: BallCircleRadius, mean_radius: MeanRadius, sleeves: Sleeves
) -> PathSteepening:
    """How fast the path of the ball's centre steepens, Y'' = m (r/R) C_1.

    Source: Handbook, chapter 12: tan α(x) = tan α_0 + (r/R) C_1 x with x = m ξ.
    Validity: 0 for a straight wall.
    """
    return sleeves * gain_slope * ball_circle_radius / mean_radius


@equation
def path_tangent(
    tan_wall_angle: TanAngleAtStop, path_steepening: PathSteepening, path_depth: PathDepth
) -> TanWallAngle:
    """Tangent of the wall angle where the ball is, tan α = tan α_0 + Y'' ξ.

    Source: Handbook, chapter 12.
    Validity: ξ ≥ 0.
    """
    return tan_wall_angle + path_steepening * path_depth


@equation
def path(tan_wall_angle: TanAngleAtStop, path_steepening: PathSteepening, path_depth: PathDepth) -> PathPlace:
    """Path of the ball's centre in a sleeve, Y = ξ tan α_0 + Y'' ξ²/2.

    Source: Handbook, chapter 12: r dφ = tan α dx.
    Validity: ξ ≥ 0.
    """
    return path_depth * tan_wall_angle + path_steepening * path_depth * path_depth / 2


@equation
def wall_axial(
    path_depth: PathDepth, ball_radius: BallRadius, sin_wall_angle: SinAngleAtBall
) -> Annotated[Number, "ξ_w", "m"]:
    """Place of the contact along the axis, ξ − r_ш sin α.

    Source: Handbook, chapter 12: the wall is r_ш off the path of the ball's centre.
    Validity: No undercut.
    """
    return path_depth - ball_radius * sin_wall_angle


@equation
def wall_around(
    path: PathPlace, ball_radius: BallRadius, cos_wall_angle: CosAngleAtBall
) -> Annotated[Number, "Y_w", "m"]:
    """Place of the contact around the circle, Y + r_ш cos α.

    Source: Handbook, chapter 12: the wall is r_ш off the path of the ball's centre.
    Validity: No undercut.
    """
    return path + ball_radius * cos_wall_angle


@equation
def contact_depth(
    ball_radius: BallRadius, sin_wall_angle: SinAngleAtBall, path_depth: PathDepth, face_gap: FaceGap
) -> Annotated[Number, "h_w", "m"]:
    """Depth of the contact below the face, r_ш sin α − ξ − s/2.

    Source: S21 (23) with the angle where the ball is (handbook, chapter 12); at the stop its centre is s/2 off the
        face.
    Validity: Falls all along while there is no undercut.
    """
    return ball_radius * sin_wall_angle - path_depth - face_gap / 2


@equation
def path_radius(path_steepening: PathSteepening, cos_wall_angle: CosAngleAtBall) -> PathRadius:
    """Radius of curvature of the path, ρ = 1/(Y'' cos³α): no ball as large can run on it without undercutting the wall.

    Source: Handbook, chapter 12: (1 + tan²α)^{3/2}/Y''.
    Validity: Y'' > 0; least at the stop. The wall is convex with the radius ρ − r_ш.
    """
    return 1 / (path_steepening * cos_wall_angle * cos_wall_angle * cos_wall_angle)


@equation
def seat_force(
    contact_force: CurvedWallForce,
    sin_sum_of_angles: SinSumOfAngles,
    sin_wall_angle: SinSeatAngle,
    cos_wall_angle: CosSeatAngle,
) -> Annotated[Number, "F_s", "N"]:
    """Force of the wall that seats the ball in the other sleeve, F_s = F_n sin(α + α_0)/sin 2α_0.

    Source: Handbook, chapter 12, with the balance of the ball: pushed at the angle α, borne by the seat's walls at α_0.
    Validity: α ≥ α_0: else the ball climbs out of its seat. Seat with straight walls.
    """
    return contact_force * sin_sum_of_angles / (2 * sin_wall_angle * cos_wall_angle)


@equation
def hertz_curvature_ratio(path_radius: PathRadius, ball_radius: BallRadius) -> CurvatureRatio:
    """Ratio of the relative curvatures of ball and convex wall, A/B = ρ/(ρ − r_ш).

    Source: Johnson, Contact Mechanics (1985), (4.5): A = (1/r_ш + 1/(ρ − r_ш))/2, B = 1/(2 r_ш).
    Validity: ρ > r_ш; the wall is straight across the section.
    """
    return path_radius / (path_radius - ball_radius)


@equation
def hertz_relative_radius(ball_radius: BallRadius, curvature_ratio: CurvatureRatio) -> Annotated[Number, "R_e", "m"]:
    """Relative radius of curvature of the contact, R_e = 1/(2√(A B)) = r_ш/√(A/B).

    Source: Johnson, Contact Mechanics (1985), (4.5).
    Validity: As ``hertz_curvature_ratio``.
    """
    return ball_radius / curvature_ratio**0.5


@equation
def hertz_axes(axis_ratio: AxisRatio, integral_b: IntegralB, integral_d: IntegralD) -> CurvatureRatio:
    """Ratio of the curvatures that gives the contact an ellipse, A/B = 𝐁/(k² 𝐃).

    Source: Johnson, Contact Mechanics (1985), (4.26a), with 𝐃 = (K − E)/e² and 𝐁 = K − 𝐃.
    Validity: 0 < k ≤ 1; 1 for a circle.
    """
    return integral_b / (axis_ratio * axis_ratio * integral_d)


@equation
def hertz_ellipse_factor(
    axis_ratio: AxisRatio, integral_b: IntegralB, integral_d: IntegralD, pi: Pi
) -> Annotated[Number, "φ", "1"]:
    """How much an elliptic contact is larger than a circular one of equal R_e, φ = (4/π) √(k 𝐁 𝐃).

    Source: Johnson, Contact Mechanics (1985), (4.27): (a b)^{3/2} = 3 F R_e φ/(4 E_c).
    Validity: 0 < k ≤ 1; 1 for a circle. A ball on a flat of the radius R_e φ bears as much at the same pressure.
    """
    return 4 * (axis_ratio * integral_b * integral_d) ** 0.5 / pi
