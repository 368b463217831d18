"""The friction faces, and direct regulation: the release force acts on the spring-loaded pack (handbook, chapter 2).

One law for every direct variant. The pairs form two groups: the *bypass* (driving) pairs z_1 carry
torque straight between the half-couplings, the *controlled* (driven) pairs z_2 carry theirs through
the balls. Conventional: z_2 = 0. All-driving: z_1 = 0. Every argument may be an array; shapes broadcast.
"""

from typing import Annotated

from .terms import *

RECOMMENDED_REDUCED_GAIN = 5
"""Largest zC of an all-driving clutch (S22, after (6), from its reference [4])."""


def mean_radius_uniform_wear(inner_radius: InnerRadius, outer_radius: OuterRadius) -> MeanRadius:
    """Mean friction radius at uniform wear (p·r constant), (r_i + r_o)/2.

    Source: Juvinall & Marshek, Fundamentals of Machine Component Design, ch. 18.
    Validity: 0 < r_i < r_o; discs worn in.

    >>> mean_radius_uniform_wear(0.5, 1.5)
    1.0
    """
    return (inner_radius + outer_radius) / 2


def mean_radius_uniform_pressure(inner_radius: InnerRadius, outer_radius: OuterRadius) -> MeanRadius:
    """Mean friction radius at uniform pressure, ⅔ (r_o³ − r_i³)/(r_o² − r_i²).

    Source: Juvinall & Marshek, Fundamentals of Machine Component Design, ch. 18.
    Validity: 0 < r_i < r_o; new, stiff discs.
    """
    return 2 * (outer_radius**3 - inner_radius**3) / (3 * (outer_radius**2 - inner_radius**2))


def mean_pressure(
    force: AxialForce, inner_radius: InnerRadius, outer_radius: OuterRadius, pi: Pi
) -> Annotated[Number, "p", "Pa"]:
    """Mean surface pressure of a ring, F/(π (r_o² − r_i²)).

    Source: Juvinall & Marshek, Fundamentals of Machine Component Design, ch. 18.
    Validity: Full rings; grooves and sectors raise it.
    """
    return force / (pi * (outer_radius**2 - inner_radius**2))


def peak_pressure_uniform_wear(
    force: AxialForce, inner_radius: InnerRadius, outer_radius: OuterRadius, pi: Pi
) -> Annotated[Number, "p_i", "Pa"]:
    """Surface pressure at the inner edge with uniform wear, F/(2 π r_i (r_o − r_i)).

    Source: Juvinall & Marshek, Fundamentals of Machine Component Design, ch. 18.
    Validity: p·r constant; full rings.
    """
    return force / (2 * pi * inner_radius * (outer_radius - inner_radius))


def gain(mean_radius: MeanRadius, ball_circle_radius: BallCircleRadius, tan_wall_angle: TanWallAngle) -> Gain:
    """Feedback gain C = (R_cp/r)·tan α.

    Source: F11, after (11); S19 and S21 use the same definition.
    Validity: 0 ≤ α < 90°; α = 0 gives no release force.

    >>> gain(0.1, 0.05, 0.25)
    0.5
    """
    return mean_radius / ball_circle_radius * tan_wall_angle


def controlled_pairs(pairs: Pairs, bypass_pairs: BypassPairs) -> ControlledPairs:
    """Pairs whose torque passes the balls, z_2 = z − z_1.

    Source: S22 (22).
    Validity: z_1 ≤ z; none of a conventional clutch.
    """
    return pairs - bypass_pairs


def reduced_gain(controlled_pairs: ControlledPairs, gain: Gain) -> Annotated[Number, "z_2 C", "1"]:
    """Reduced gain, z_2 C: the gain of the whole feedback loop per unit of friction.

    Source: S22 (zC of the all-driving clutch); S19 ((z − 1)C).
    Validity: Any direct variant; 0 for the conventional clutch.
    """
    return controlled_pairs * gain


def normal_force(
    closing_force: ClosingForce, controlled_pairs: ControlledPairs, gain: Gain, friction_driven: FrictionDriven
) -> NormalForce:
    """Normal force on the friction pairs, N = F_п/(1 + C z_2 f_2).

    Source: F11 (3) with (11) mended (M1).
    Validity: C, f_2 ≥ 0; balls and thrust bearing without friction.
    """
    return closing_force / (1 + gain * controlled_pairs * friction_driven)


def release_force(
    closing_force: ClosingForce, controlled_pairs: ControlledPairs, gain: Gain, friction_driven: FrictionDriven
) -> ReleaseForce:
    """Release force of the control unit, F_p = F_п C z_2 f_2/(1 + C z_2 f_2).

    Source: F11 (11), mended (M1: the print has lost C from the numerator).
    Validity: C, f_2 ≥ 0.
    """
    feedback = gain * controlled_pairs * friction_driven
    return closing_force * feedback / (1 + feedback)


def torque_per_force(
    mean_radius: MeanRadius,
    bypass_pairs: BypassPairs,
    controlled_pairs: ControlledPairs,
    gain: Gain,
    friction_driving: FrictionDriving,
    friction_driven: FrictionDriven,
) -> Annotated[Number, "T/F_п", "m"]:
    """Slip torque per spring force, T/F_п = R (z_1 f_1 + z_2 f_2)/(1 + C z_2 f_2).

    Source: F11 (12); R g(f) of S19 (1)–(4).
    Validity: As ``torque``.
    """
    return (
        mean_radius
        * (bypass_pairs * friction_driving + controlled_pairs * friction_driven)
        / (1 + gain * controlled_pairs * friction_driven)
    )


def torque(
    closing_force: ClosingForce,
    mean_radius: MeanRadius,
    bypass_pairs: BypassPairs,
    controlled_pairs: ControlledPairs,
    gain: Gain,
    friction_driving: FrictionDriving,
    friction_driven: FrictionDriven,
) -> SlipTorque:
    """Sustained slip torque, T = F_п R (z_1 f_1 + z_2 f_2)/(1 + C z_2 f_2).

    Source: F11 (9), (12), (13); S19 (1), (2); S22 (4), (16).
    Validity: Up to C = 1/(z_1 f_1max) this is also the largest torque of the slip; above it the bypass pairs may give a
        higher breakaway peak first (see ``group_torque``).

    >>> torque(2000.0, 0.1, 1, 7, 0.0, 0.25, 0.25)
    400.0
    """
    return (
        closing_force
        * mean_radius
        * (bypass_pairs * friction_driving + controlled_pairs * friction_driven)
        / (1 + gain * controlled_pairs * friction_driven)
    )


def group_torque(
    normal_force: NormalForce, mean_radius: MeanRadius, pairs: GroupPairs, friction: GroupFriction
) -> Annotated[Number, "T_i", "N*m"]:
    """Torque of one group of pairs under a normal force, T_i = R z_i f_i N.

    Source: F11 (2), (6); S21 (9) for all pairs.
    Validity: Slipping pairs. With N = F_п and the bypass pairs it is what they carry before the balls take a share, the
        condition behind C ≤ 1/(z_1 f_max) (F11, after (20); handbook, chapter 3).
    """
    return normal_force * mean_radius * pairs * friction


def driving_torque(
    normal_force: NormalForce, mean_radius: MeanRadius, bypass_pairs: BypassPairs, friction_driving: FrictionDriving
) -> Annotated[Number, "T_1", "N*m"]:
    """Torque of the bypass pairs, T_1 = R z_1 f_1 N.

    Source: F11 (2), (4).
    Validity: Slipping pairs.
    """
    return group_torque(normal_force, mean_radius, bypass_pairs, friction_driving)


def onset_torque(
    closing_force: ClosingForce, mean_radius: MeanRadius, bypass_pairs: BypassPairs, friction_driving: FrictionDriving
) -> Annotated[Number, "T_1(0)", "N*m"]:
    """Torque that the bypass pairs carry alone, before the balls take a share, T_1(0) = R z_1 f_1 F_п.

    Source: F11, text of fig. 1 (the first torque is carried by the driving group alone), with (2) and N = F_п.
    Validity: The balls have not been driven up their walls yet, so that nothing unloads the pack.
    """
    return group_torque(closing_force, mean_radius, bypass_pairs, friction_driving)


def circumferential_force(
    torque: ControlledTorque, ball_circle_radius: BallCircleRadius
) -> Annotated[Number, "F_o", "N"]:
    """Circumferential force on all the balls, F_o = T_2/r.

    Source: F11 (5); with (10) it is F_p/tan α.
    Validity: All of T_2 passes the balls.
    """
    return torque / ball_circle_radius


def gain_limit_differentiated(bypass_pairs: BypassPairs, friction_driving_max: FrictionDrivingMax) -> GainLimit:
    """Gain above which the bypass pairs alone carry more than the regulated torque, 1/(z_1 f_1max).

    Source: F11, after (20); S22 (24); S19 has C = 1/f_max, that is z_1 = 1.
    Validity: z_1 ≥ 1.
    """
    return 1 / (bypass_pairs * friction_driving_max)


def gain_limit_all_driving(pairs: Pairs) -> GainLimit:
    """Recommended largest gain of the all-driving clutch, from zC ≤ 5.

    Source: S22, after (6), from its reference [4].
    Validity: z_1 = 0. A recommendation, not a law.
    """
    return RECOMMENDED_REDUCED_GAIN / pairs
