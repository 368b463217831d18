"""Synthesis of the control unit: wall angle, balls, pockets, contact (S21; theory, section 5)."""

from typing import Annotated

from .calls import equation
from .terms import *


@equation
def tan_wall_angle(gain: Gain, ball_circle_radius: BallCircleRadius, mean_radius: MeanRadius) -> TanWallAngle:
    """Tangent of the wall angle that gives a gain, tan α = C r/R.

    Source: S21 (24).
    Validity: C ≥ 0.
    """
    return gain * ball_circle_radius / mean_radius


@equation
def ball_radius(
    travel: Travel, face_gap: FaceGap, edge_clearance: EdgeClearance, sin_wall_angle: SinWallAngle
) -> BallRadius:
    """Ball radius for a travel, r_ш = (x_max + s + 2 y)/(2 sin α).

    Source: S21 (23).
    Validity: α > 0.
    """
    return (travel + face_gap + 2 * edge_clearance) / (2 * sin_wall_angle)


@equation
def edge_clearance(
    ball_radius: BallRadius, travel: Travel, face_gap: FaceGap, sin_wall_angle: SinWallAngle
) -> EdgeClearance:
    """Clearance that a given ball leaves, y = r_ш sin α − (x_max + s)/2: the inverse of (23).

    Source: S21 (23).
    Validity: α > 0.
    """
    return ball_radius * sin_wall_angle - (travel + face_gap) / 2


@equation
def pocket_depth(ball_radius: BallRadius, sin_wall_angle: SinWallAngle, face_gap: FaceGap) -> PocketDepth:
    """Pocket depth to the virtual apex, where the walls would meet, h_1 = r_ш/sin α − s/2.

    Source: S21 (20).
    Validity: α > 0.
    """
    return ball_radius / sin_wall_angle - face_gap / 2


@equation
def pocket_depth_from_travel(
    ball_radius: BallRadius,
    sin_wall_angle: SinWallAngle,
    cos_wall_angle: CosWallAngle,
    travel: Travel,
    edge_clearance: EdgeClearance,
) -> Annotated[Number, Term("h_2", "", "m")]:
    """Pocket depth from the travel, h_2 = r_ш cos α cot α + x_max/2 + y; equal to h_1.

    Source: S21 (22), (21).
    Validity: α > 0.
    """
    return ball_radius * cos_wall_angle * cos_wall_angle / sin_wall_angle + travel / 2 + edge_clearance


@equation
def pocket_depth_cut(ball_radius: BallRadius, face_gap: FaceGap) -> Annotated[Number, Term("h_c", "", "m")]:
    """Depth to cut a pocket to, h_c = r_ш − s/2: the lowest point of the ball below the face.

    Source: Geometry of S21 (20): the ball's centre lies s/2 above the face.
    Validity: The walls end under the ball, h_c ≤ h_1.
    """
    return ball_radius - face_gap / 2


@equation
def pocket_width(pocket_depth: PocketDepth, tan_wall_angle: TanWallAngle) -> PocketWidth:
    """Width of the pocket's mouth at the face, b = 2 h_1 tan α.

    Source: Geometry of S21 (20): the walls meet at the virtual apex.
    Validity: Straight walls.
    """
    return 2 * pocket_depth * tan_wall_angle


@equation
def ball_pitch(ball_circle_radius: BallCircleRadius, sin_half_pitch: SinHalfPitch) -> BallPitch:
    """Distance between the centres of neighbouring balls, t_ш = 2 r sin(π/n).

    Source: Geometry: chord of the ball circle.
    Validity: n ≥ 2.
    """
    return 2 * ball_circle_radius * sin_half_pitch


@equation
def web(ball_pitch: BallPitch, pocket_width: PocketWidth) -> Annotated[Number, Term("e", "", "m")]:
    """Web that is left between neighbouring pockets at the face, e = t_ш − b.

    Source: Geometry: chord of the ball circle.
    Validity: Not above 0 the pockets cut into each other.
    """
    return ball_pitch - pocket_width


@equation
def contact_force(
    torque: PassedTorque, balls: Balls, ball_circle_radius: BallCircleRadius, cos_wall_angle: CosWallAngle
) -> ContactForce:
    """Normal force on one ball, F_n = T/(n r cos α).

    Source: S21, contact force after (24), mended (M10).
    Validity: All balls share the torque alike; T is what passes the balls (direct clutches: T_2).
    """
    return torque / (balls * ball_circle_radius * cos_wall_angle)


@equation
def least_contact_force_cubic(
    numerator_constant: NumeratorConstant,
    numerator_slope: NumeratorSlope,
    denominator_constant: DenominatorConstant,
    denominator_slope: DenominatorSlope,
    radius_ratio: RadiusRatio,
) -> Annotated[Number, Term("k", "coefficients of q²C(a + bC)(a' + b'C) − (a b' − a' b)(1 + q²C²)", "1")]:
    """Coefficients, highest power first, of the cubic in C whose root makes the contact force least.

    Source: Derivative of F_n ∝ (a + b C)·√(1 + q²C²)/(a' + b' C), q = r/R (theory, section 5).
    Validity: b' a > b a': the torque falls with C.
    """
    squared = radius_ratio * radius_ratio
    fall = numerator_constant * denominator_slope - numerator_slope * denominator_constant
    return (
        squared * numerator_slope * denominator_slope,
        squared * (numerator_constant * denominator_slope + numerator_slope * denominator_constant - fall),
        squared * numerator_constant * denominator_constant,
        -fall,
    )


@equation
def hertz_contact_modulus(
    ball_modulus: BallModulus, ball_poisson: BallPoisson, wall_modulus: WallModulus, wall_poisson: WallPoisson
) -> ContactModulus:
    """Contact modulus E_c from 1/E_c = (1 − ν_1²)/E_1 + (1 − ν_2²)/E_2.

    Source: Johnson, Contact Mechanics (1985), (4.2a).
    Validity: Elastic half-spaces.
    """
    return 1 / ((1 - ball_poisson * ball_poisson) / ball_modulus + (1 - wall_poisson * wall_poisson) / wall_modulus)


@equation
def hertz_allowable_force(
    allowable_pressure: AllowablePressureOnFlat, ball_radius: BallRadius, contact_modulus: ContactModulus, pi: Pi
) -> AllowableForce:
    """Force at which a ball on a flat reaches the allowable pressure, F = π³ p_0³ r²/(6 E_c²).

    Source: Johnson, Contact Mechanics (1985), (4.24) with R = r (ball on flat).
    Validity: Elastic, frictionless, contact small against the ball; the wall is flat.
    """
    return pi**3 * allowable_pressure**3 * ball_radius**2 / (6 * contact_modulus**2)


@equation
def hertz_pressure(
    allowable_pressure: AllowablePressure, force: ContactForce, allowable_force: AllowableForce
) -> Annotated[Number, Term("p_0", "", "Pa")]:
    """Largest contact pressure under a force, p_0 = p_0,allow (F_n/F_n,allow)^{1/3}.

    Source: Johnson, Contact Mechanics (1985), (4.24), (4.30): p_0³ grows as the force, whatever the curvatures.
    Validity: Elastic, frictionless, contact small against the ball.
    """
    return allowable_pressure * (force / allowable_force) ** (1 / 3)
