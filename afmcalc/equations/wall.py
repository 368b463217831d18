"""The wall of a pocket, straight or curved, in the cylindrical section at the ball circle (handbook, chapter 12).

Coordinates of a sleeve: ξ from where the ball's centre is at the stop along the axis out of the pocket, Y around the
circle. The curved wall is in one sleeve, the ball stays seated in the other and ξ is the travel; with straight walls
alike in both ξ is half of it, as in S21.
"""

from typing import Annotated

from .terms import *


def path_steepening(
    gain_slope: GainSlope, ball_circle_radius: BallCircleRadius, mean_radius: MeanRadius
) -> PathSteepening:
    """How fast the path of the ball's centre steepens, Y'' = (r/R) C_1.

    Source: Handbook, chapter 12: tan α(x) = tan α_0 + (r/R) C_1 x with x = ξ.
    Validity: 0 for a straight wall.
    """
    return gain_slope * ball_circle_radius / mean_radius


def path_tangent(
    tan_wall_angle: TanAngleAtStop, path_steepening: PathSteepening, path_depth: PathDepth
) -> TanWallAngle:
    """Tangent of the wall angle where the ball is, tan α = tan α_0 + Y'' ξ.

    Source: Handbook, chapter 12.
    Validity: ξ ≥ 0.
    """
    return tan_wall_angle + path_steepening * path_depth


def path(tan_wall_angle: TanAngleAtStop, path_steepening: PathSteepening, path_depth: PathDepth) -> PathPlace:
    """Path of the ball's centre in a sleeve, Y = ξ tan α_0 + Y'' ξ²/2.

    Source: Handbook, chapter 12: r dφ = tan α dx.
    Validity: ξ ≥ 0.
    """
    return path_depth * tan_wall_angle + path_steepening * path_depth * path_depth / 2


def wall_axial(
    path_depth: PathDepth, ball_radius: BallRadius, sin_wall_angle: SinAngleAtBall
) -> Annotated[Number, "ξ_w", "m"]:
    """Place of the contact along the axis, ξ − r_ш sin α.

    Source: Handbook, chapter 12: the wall is r_ш off the path of the ball's centre.
    Validity: No undercut.
    """
    return path_depth - ball_radius * sin_wall_angle


def wall_around(
    path: PathPlace, ball_radius: BallRadius, cos_wall_angle: CosAngleAtBall
) -> Annotated[Number, "Y_w", "m"]:
    """Place of the contact around the circle, Y + r_ш cos α.

    Source: Handbook, chapter 12: the wall is r_ш off the path of the ball's centre.
    Validity: No undercut.
    """
    return path + ball_radius * cos_wall_angle


def contact_depth(
    ball_radius: BallRadius, sin_wall_angle: SinAngleAtBall, path_depth: PathDepth, face_gap: FaceGap
) -> Annotated[Number, "h_w", "m"]:
    """Depth of the contact below the face, r_ш sin α − ξ − s/2.

    Source: S21 (23) with the angle where the ball is (handbook, chapter 12); at the stop its centre is s/2 off the
        face.
    Validity: Falls all along while there is no undercut.
    """
    return ball_radius * sin_wall_angle - path_depth - face_gap / 2


def path_radius(path_steepening: PathSteepening, cos_wall_angle: CosAngleAtBall) -> PathRadius:
    """Radius of curvature of the path, ρ = 1/(Y'' cos³α): no ball as large can run on it without undercutting the wall.

    Source: Handbook, chapter 12: (1 + tan²α)^{3/2}/Y''.
    Validity: Y'' > 0; least at the stop. The wall is convex with the radius ρ − r_ш.
    """
    return 1 / (path_steepening * cos_wall_angle * cos_wall_angle * cos_wall_angle)


def hertz_relative_radius(ball_radius: BallRadius, path_radius: PathRadius) -> Annotated[Number, "R_e", "m"]:
    """Radius of a ball that presses a flat as this one does a convex wall, R_e = 2 r_ш (ρ − r_ш)/(2 ρ − r_ш).

    Source: Johnson, Contact Mechanics (1985), (4.5): the mean 1/R_e = A + B of the relative curvatures 1/r_ш +
        1/(ρ − r_ш) in the section and 1/r_ш across it.
    Validity: ρ > r_ш. On the safe side: p_0 by it exceeds that of the ellipse by 2.6 % at ρ = 2 r_ш, 8.5 % at 1.4 r_ш.
    """
    return 2 * ball_radius * (path_radius - ball_radius) / (2 * path_radius - ball_radius)
