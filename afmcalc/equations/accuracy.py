"""Accuracy of direct regulation: K_т, its slopes and its elasticities (handbook, chapter 3)."""

from typing import Annotated

from .terms import *


def accuracy_factor(
    bypass_pairs: BypassPairs,
    controlled_pairs: ControlledPairs,
    gain: Gain,
    friction_driving_min: FrictionDrivingMin,
    friction_driven_min: FrictionDrivenMin,
    friction_driving_max: FrictionDrivingMax,
    friction_driven_max: FrictionDrivenMax,
) -> AccuracyFactor:
    """Accuracy factor along the common path, K_т = T(f_1max, f_2max)/T(f_1min, f_2min).

    Source: F11 (14); with one material S19 and S22 (18).
    Validity: f_1 and f_2 move together (F11's working hypothesis). Below 1 where the torque falls with friction (unlike
        materials, z_1 C f_1 > 1); the ratio largest/smallest torque is then 1/K_т.

    >>> accuracy_factor(1, 7, 0.0, 0.125, 0.125, 0.75, 0.75)
    6.0
    """
    largest = bypass_pairs * friction_driving_max + controlled_pairs * friction_driven_max
    least = bypass_pairs * friction_driving_min + controlled_pairs * friction_driven_min
    feedback = controlled_pairs * gain
    return largest * (1 + feedback * friction_driven_min) / (least * (1 + feedback * friction_driven_max))


def conventional_accuracy_factor(
    bypass_pairs: BypassPairs,
    controlled_pairs: ControlledPairs,
    friction_driving_min: FrictionDrivingMin,
    friction_driven_min: FrictionDrivenMin,
    friction_driving_max: FrictionDrivingMax,
    friction_driven_max: FrictionDrivenMax,
) -> Annotated[Number, "K_т,0", "1"]:
    """Accuracy factor of an ordinary clutch in its place, K_т at C = 0; with one material f_max/f_min.

    Source: F11 (14) at C = 0.
    Validity: f_1 and f_2 move together (F11's working hypothesis).

    >>> conventional_accuracy_factor(1, 7, 0.125, 0.125, 0.75, 0.75)
    6.0
    """
    return (bypass_pairs * friction_driving_max + controlled_pairs * friction_driven_max) / (
        bypass_pairs * friction_driving_min + controlled_pairs * friction_driven_min
    )


def mid_band_torque(torque_max: TorqueMax, torque_min: TorqueMin) -> Annotated[Number, "T_mid", "N*m"]:
    """Torque at the middle of the scatter band, (T_min + T_max)/2.

    Source: S19, conclusions.
    Validity: Any variant.

    >>> mid_band_torque(300.0, 100.0)
    200.0
    """
    return (torque_min + torque_max) / 2


def scatter_band(torque_max: TorqueMax, torque_min: TorqueMin) -> Scatter:
    """Torque scatter band, ΔT = T_max − T_min.

    Source: S19 (10), (11).
    Validity: Any clutch.
    """
    return torque_max - torque_min


def accuracy_factor_of_torques(torque_max: TorqueMax, torque_min: TorqueMin) -> AccuracyFactor:
    """Accuracy factor, T_max/T_min.

    Source: Handbook, chapter 3 (beyond F11).
    """
    return torque_max / torque_min


def accuracy_factor_worst_case(torque_max: TorqueMax, torque_min: TorqueMin) -> Annotated[Number, "K_т,w", "1"]:
    """Accuracy factor with f_1 and f_2 independent: largest over smallest torque of the four corners of their ranges.

    Source: Handbook, chapter 3 (beyond F11).
    Validity: T is monotone in f_1 and in f_2.
    """
    return torque_max / torque_min


def accuracy_factor_peak(peak_max: PeakMax, peak_min: PeakMin) -> Annotated[Number, "K_т,p", "1"]:
    """Accuracy factor by breakaway peaks, P(f_max)/P(f_min).

    Source: Handbook, chapter 3 (beyond F11).
    Validity: Upper bound: it depends on how much the balls carried before slip.
    """
    return peak_max / peak_min


def accuracy_factor_by_ratios(
    bypass_pairs: BypassPairs,
    controlled_pairs: ControlledPairs,
    gain: Gain,
    ratio_max: FrictionRatioMax,
    ratio_min: FrictionRatioMin,
    friction_driving_min: FrictionDrivingMin,
    friction_driving_max: FrictionDrivingMax,
) -> AccuracyFactor:
    """Accuracy factor in ratios, n = f_2max/f_1max, p = f_2min/f_1min, m = f_1max/f_1min.

    Source: F11 (17) with (15), (16).
    Validity: As ``accuracy_factor``; n and p are free as long as f_2min ≤ f_2max.
    """
    spread = friction_driving_max / friction_driving_min
    largest, least = bypass_pairs + controlled_pairs * ratio_max, bypass_pairs + controlled_pairs * ratio_min
    at_min = 1 + controlled_pairs * gain * ratio_min * friction_driving_min
    at_max = 1 + controlled_pairs * gain * ratio_max * friction_driving_max
    return spread * largest * at_min / (least * at_max)


def slope_in_ratio_max(
    bypass_pairs: BypassPairs,
    controlled_pairs: ControlledPairs,
    gain: Gain,
    ratio_max: FrictionRatioMax,
    ratio_min: FrictionRatioMin,
    friction_driving_min: FrictionDrivingMin,
    friction_driving_max: FrictionDrivingMax,
) -> Annotated[Number, "∂K_т/∂n", "1"]:
    """Slope ∂K_т/∂n; its sign is that of 1 − z_1 C f_1max for every n.

    Source: F11 (18), mended (M2: printed with the factor z_1 − C f_1max).
    Validity: As ``accuracy_factor_by_ratios``.
    """
    spread = friction_driving_max / friction_driving_min
    at_min = 1 + controlled_pairs * gain * ratio_min * friction_driving_min
    at_max = 1 + controlled_pairs * gain * ratio_max * friction_driving_max
    sign = 1 - bypass_pairs * gain * friction_driving_max
    return controlled_pairs * spread * at_min * sign / ((bypass_pairs + controlled_pairs * ratio_min) * at_max**2)


def slope_in_ratio_min(
    bypass_pairs: BypassPairs,
    controlled_pairs: ControlledPairs,
    gain: Gain,
    ratio_max: FrictionRatioMax,
    ratio_min: FrictionRatioMin,
    friction_driving_min: FrictionDrivingMin,
    friction_driving_max: FrictionDrivingMax,
) -> Annotated[Number, "∂K_т/∂p", "1"]:
    """Slope ∂K_т/∂p; its sign is that of z_1 C f_1min − 1 for every p.

    Source: F11 (22), mended (M3: printed with the factor C f_1min − z_1).
    Validity: As ``accuracy_factor_by_ratios``.
    """
    spread = friction_driving_max / friction_driving_min
    largest, least = bypass_pairs + controlled_pairs * ratio_max, bypass_pairs + controlled_pairs * ratio_min
    at_max = 1 + controlled_pairs * gain * ratio_max * friction_driving_max
    sign = bypass_pairs * gain * friction_driving_min - 1
    return controlled_pairs * spread * largest * sign / (least**2 * at_max)


def torque_elasticity_in_gain(
    controlled_pairs: ControlledPairs, gain: Gain, friction_driven: FrictionDriven
) -> Annotated[Number, "∂ln T/∂ln C", "1"]:
    """Elasticity ∂ln T/∂ln C of the direct law, −C z_2 f_2/(1 + C z_2 f_2).

    Source: derivative of F11 (12).
    Validity: As ``direct.torque``.
    """
    feedback = gain * controlled_pairs * friction_driven
    return -feedback / (1 + feedback)


def torque_elasticity_in_friction_driving(
    bypass_pairs: BypassPairs,
    controlled_pairs: ControlledPairs,
    friction_driving: FrictionDriving,
    friction_driven: FrictionDriven,
) -> Annotated[Number, "∂ln T/∂ln f_1", "1"]:
    """Elasticity ∂ln T/∂ln f_1 of the direct law, z_1 f_1/(z_1 f_1 + z_2 f_2).

    Source: derivative of F11 (12).
    Validity: As ``direct.torque``. Equally ∂ln T/∂ln z_1 at fixed z_2.
    """
    return bypass_pairs * friction_driving / (bypass_pairs * friction_driving + controlled_pairs * friction_driven)


def torque_elasticity_in_friction_driven(
    bypass_pairs: BypassPairs,
    controlled_pairs: ControlledPairs,
    gain: Gain,
    friction_driving: FrictionDriving,
    friction_driven: FrictionDriven,
) -> Annotated[Number, "∂ln T/∂ln f_2", "1"]:
    """Elasticity ∂ln T/∂ln f_2 of the direct law; negative where z_1 C f_1 > 1.

    Source: derivative of F11 (12).
    Validity: As ``direct.torque``. Equally ∂ln T/∂ln z_2 at fixed z_1.
    """
    carried = controlled_pairs * friction_driven
    sign = 1 - bypass_pairs * gain * friction_driving
    return carried * sign / ((bypass_pairs * friction_driving + carried) * (1 + gain * carried))
