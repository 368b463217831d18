"""Indirect regulation: the release force moves a sleeve that slackens the closing spring (S21; handbook, chapter 5).

The clutch acts as an all-driving one with the gain ``equivalent_gain``, and a spring pre-stressed to reach the
nominal torque without release force. Every argument may be an array; shapes broadcast.
"""

from typing import Annotated

from .terms import *


def gain_threshold(
    mean_radius: MeanRadius, key_friction: KeyFriction, hub_diameter: HubDiameter
) -> Annotated[Number, "C_thr", "1"]:
    """Gain at which feedback begins, 2 R f_1/d: below it the key's friction holds the sleeve.

    Source: S21, after (5), as tan α > 2 f_1 for d = r; handbook, chapter 5.
    Validity: Friction at the key opposes the sleeve's motion.
    """
    return 2 * mean_radius * key_friction / hub_diameter


def net_gain(gain: Gain, mean_radius: MeanRadius, key_friction: KeyFriction, hub_diameter: HubDiameter) -> NetGain:
    """Gain net of the key's friction while the sleeve moves off its stop, κ = C − 2 R f_1/d.

    Source: S21 (10), (16).
    Validity: κ > 0; κ = 0 is an ordinary clutch, κ < 0 is none.
    """
    return gain - gain_threshold(mean_radius, key_friction, hub_diameter)


def net_gain_returning(
    gain: Gain, mean_radius: MeanRadius, key_friction: KeyFriction, hub_diameter: HubDiameter
) -> NetGainReturning:
    """Gain with the key's friction reversed, while the sleeve moves back, κ₊ = C + 2 R f_1/d.

    Source: Handbook, chapter 5 (beyond S21).
    Validity: Friction falling, load kept.
    """
    return gain + gain_threshold(mean_radius, key_friction, hub_diameter)


def torque_per_force(
    pairs: Pairs, mean_radius: MeanRadius, friction_set: FrictionSet
) -> Annotated[Number, "T_н/F_п1", "m"]:
    """Slip torque per closing force at the setting, T_н/F_п1 = z R f_set.

    Source: S21 (4): at the setting the sleeve rests and N = F_п1.
    Validity: The control spring set by (14).
    """
    return mean_radius * pairs * friction_set


def control_force(
    closing_force: IndirectClosingForce, pairs: Pairs, net_gain: NetGain, friction_set: FrictionSet
) -> ControlForce:
    """Control-spring force that just holds the sleeve at its stop at the setting, F_п2 = F_п1 (1 + z f_set κ).

    Source: S21 (14); C from it is (5).
    Validity: κ ≥ 0.
    """
    return closing_force * (1 + pairs * friction_set * net_gain)


def sleeve_stiffness(
    closing_stiffness: ClosingStiffness,
    control_stiffness: ControlStiffness,
    pairs: Pairs,
    friction: Friction,
    net_gain: NetGain,
) -> SleeveStiffness:
    """Stiffness against which the sleeve moves, D(f) = c_1 + c_2 + z c_1 f κ.

    Source: S21 (10), (11), in κ (handbook, chapter 5).
    Validity: κ ≥ 0, then D > 0.
    """
    return closing_stiffness + control_stiffness + pairs * closing_stiffness * friction * net_gain


def travel(
    pairs: Pairs,
    closing_force: IndirectClosingForce,
    friction: Friction,
    friction_set: FrictionSet,
    net_gain: NetGain,
    sleeve_stiffness: SleeveStiffness,
) -> Travel:
    """Axial travel of the sleeve, x = z F_п1 (f − f_set) κ/D(f).

    Source: S21 (10), (16).
    Validity: f ≥ f_set; below it the sleeve rests at its stop, x = 0. Always x < F_п1/c_1.
    """
    return pairs * closing_force * (friction - friction_set) * net_gain / sleeve_stiffness


def normal_force_seated(
    control_force: ControlForce, pairs: Pairs, net_gain: NetGain, friction: Friction
) -> NormalForce:
    """Normal force with the sleeve at its stop, N = F_п2/(1 + z κ f).

    Source: S21, text of fig. 1: the stop 10 belongs to the pressure disc 5, so spring 11 presses the pack through
        sleeve and stop; N = F_п1 + S with the stop's reaction S = F_п2 − F_п1 − T κ/R (handbook, chapter 5).
    Validity: S ≥ 0, that is N ≥ F_п1, or f ≤ f_set with the control spring set by (14); κ ≥ 0.
    """
    return control_force / (1 + pairs * net_gain * friction)


def normal_force_balanced(
    control_force: TensedControlForce, pairs: Pairs, net_gain: NetGain, friction: Friction
) -> NormalForce:
    """Normal force that balances the control spring where the sleeve is, N = F_2/(1 + z κ f).

    Source: S21 (6)–(9), the springs as curved as they are.
    Validity: x ≥ 0 is such that the closing spring, slackened by x, presses with the same N.
    """
    return control_force / (1 + pairs * net_gain * friction)


def travel_as_made(
    closing_force: IndirectClosingForce,
    control_force: ControlForce,
    pairs: Pairs,
    friction: Friction,
    net_gain: NetGain,
    sleeve_stiffness: SleeveStiffness,
) -> Travel:
    """Axial travel of the sleeve with any two spring forces, x = [(1 + z κ f) F_п1 − F_п2]/D(f).

    Source: S21 (10), in κ.
    Validity: x ≥ 0; where it would be negative the sleeve rests at its stop.
    """
    return ((1 + pairs * net_gain * friction) * closing_force - control_force) / sleeve_stiffness


def normal_force_moving(
    closing_force: IndirectClosingForce,
    closing_stiffness: ClosingStiffness,
    control_force: ControlForce,
    control_stiffness: ControlStiffness,
    sleeve_stiffness: SleeveStiffness,
) -> NormalForce:
    """Normal force with the sleeve off its stop, N = (F_п1 c_2 + F_п2 c_1)/D(f), which is F_п1 − c_1 x.

    Source: S21 (9) with (10); (11).
    Validity: f ≥ f_set.
    """
    return (closing_force * control_stiffness + control_force * closing_stiffness) / sleeve_stiffness


def torque(normal_force: NormalForce, mean_radius: MeanRadius, pairs: Pairs, friction: Friction) -> SlipTorque:
    """Slip torque of all pairs under a normal force, T = z R f N.

    Source: S21 (9).
    Validity: The clutch slips.
    """
    return normal_force * mean_radius * pairs * friction


def release_force(torque: SlipTorque, gain: Gain, mean_radius: MeanRadius) -> ReleaseForce:
    """Release force of the balls on the sleeve, F_p = T tan α/r = T C/R.

    Source: S21 (2), (7).
    Validity: All torque passes the balls.
    """
    return torque * gain / mean_radius


def key_friction_force(
    torque: SlipTorque, key_friction: KeyFriction, hub_diameter: HubDiameter
) -> Annotated[Number, "F_тр", "N"]:
    """Friction force of the key on the sleeve, F_тр = 2 T f_1/d.

    Source: S21 (3), (8).
    Validity: The sleeve moves or is about to; all torque passes the key.
    """
    return 2 * torque * key_friction / hub_diameter


def stop_reaction(
    control_force: ControlForce,
    closing_force: ClosingForceAtStop,
    torque: SlipTorque,
    net_gain: NetGain,
    mean_radius: MeanRadius,
) -> Annotated[Number, "S", "N"]:
    """Reaction of the stop on the sleeve that rests there, S = F_п2 − F_п1 − T κ/R_cp.

    Source: S21 (1) with the force on the stop 10, which the paper takes as 0 at the setting; handbook, chapter 5.
    Validity: S ≥ 0; the key at the limit of its friction. 0 once the sleeve has left its stop.
    """
    return control_force - closing_force - torque * net_gain / mean_radius


def accuracy_factor(
    friction_min: FrictionMin,
    friction_set: FrictionSet,
    friction_max: FrictionMax,
    closing_stiffness: ClosingStiffness,
    control_stiffness: ControlStiffness,
    pairs: Pairs,
    net_gain: NetGain,
) -> AccuracyFactor:
    """Accuracy factor, K_т = f_max D(f_set) (1 + z κ f_min)/[f_min D(f_max) (1 + z κ f_set)].

    Source: S21 (15), mended (M9), with f_set = f_min; handbook, chapter 5 for f_min < f_set ≤ f_max, where the sleeve
        rests at f_min.
    Validity: f_min ≤ f_set ≤ f_max, κ ≥ 0.
    """
    at_set = sleeve_stiffness(closing_stiffness, control_stiffness, pairs, friction_set, net_gain)
    at_max = sleeve_stiffness(closing_stiffness, control_stiffness, pairs, friction_max, net_gain)
    rising = friction_max * at_set / (friction_min * at_max)
    return rising * ((1 + pairs * net_gain * friction_min) / (1 + pairs * net_gain * friction_set))


def accuracy_factor_hysteresis(
    torque_max: RisingTorqueMax, torque_returning: ReturningTorqueMin
) -> Annotated[Number, "K_т,h", "1"]:
    """Accuracy factor under a load that lasts, K_т,h = T_max/T_ret,min.

    Source: Handbook, chapter 5 (beyond S21).
    Validity: Friction falls from f_max to f_min without full unloading.
    """
    return torque_max / torque_returning


def equivalent_gain(
    net_gain: NetGain, closing_stiffness: ClosingStiffness, control_stiffness: ControlStiffness
) -> Annotated[Number, "C_eff", "1"]:
    """Gain of the all-driving clutch with the same torque curve, κ c_1/(c_1 + c_2).

    Source: Identity of S21 (11) with S22 (4): T = [F_п1 (1 + z C_eff f_set)] z R f/(1 + z C_eff f).
    Validity: f ≥ f_set.
    """
    return net_gain * closing_stiffness / (closing_stiffness + control_stiffness)


def nominal_torque_ratio(pairs: Pairs, gain: Gain, friction_set: FrictionSet) -> NominalTorqueRatio:
    """Nominal torque against the base clutch of equal spring and gain, all pairs controlled, K_п = 1 + z C f_set.

    Source: S21, after fig. 2 (with f_set = f_min).
    Validity: The base clutch's feedback is active at f_set.
    """
    return 1 + pairs * gain * friction_set


def nominal_torque_ratio_as_made(
    pairs: Pairs, gain: Gain, friction_set: FrictionSet, normal_force: NormalForce, closing_force: ClosingForceAtStop
) -> NominalTorqueRatio:
    """Nominal torque against the base clutch of equal spring and gain, F_п2 as made, K_п = (1 + z C f_set) N/F_п1.

    Source: Handbook, chapter 5 (beyond S21).
    Validity: N at f_set; S21 (14) makes it F_п1. As ``nominal_torque_ratio``.
    """
    return (1 + pairs * gain * friction_set) * normal_force / closing_force


def hysteresis_ratio(net_gain: NetGain, net_gain_returning: NetGainReturning) -> Annotated[Number, "κ₊/κ", "1"]:
    """By how much friction must fall before the sleeve moves back, κ₊/κ.

    Source: Handbook, chapter 5 (beyond S21).
    Validity: κ > 0.
    """
    return net_gain_returning / net_gain


def seated_elasticity_in_feedback(
    pairs: Pairs, friction: Friction, feedback_part: FeedbackPart, net_gain: NetGain
) -> Annotated[Number, "∂ln(1 + zκf)/∂ln p", "1"]:
    """Elasticity of 1 + z κ f in a parameter to which a part of κ is proportional, z f κ_part/(1 + z κ f).

    Source: Derivative of 1 + z κ f (handbook, chapter 5, the seated sleeve).
    Validity: κ ≥ 0.
    """
    return pairs * friction * feedback_part / (1 + pairs * net_gain * friction)
