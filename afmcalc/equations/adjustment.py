"""Adjustment: the closing-spring force for a nominal torque (handbook, chapter 4)."""

from typing import Annotated

from .terms import *


def closing_force(nominal_torque: NominalTorque, margin: Margin, torque_per_force: TorquePerForce) -> ClosingForce:
    """Closing-spring force that gives the nominal torque at the setting, β_н T_н/[R g(f_set)].

    Source: S19 (1), (2), (5) with β_н = 1 and f_set = f_min; (3), (4), (6) with f_set = f_cp.
    Validity: T proportional to F_п, as in every variant.
    """
    return margin * nominal_torque / torque_per_force


def nominal_torque(torque_at_setting: TorqueAtSetting, margin: Margin) -> NominalTorque:
    """Nominal torque that the spring as set gives, T(f_set)/β_н: the inverse of ``closing_force``.

    Source: S19 (1)–(4).
    Validity: As ``closing_force``.
    """
    return torque_at_setting / margin


def force_ratio(
    torque_per_force_mean: TorquePerForceMean, torque_per_force_min: TorquePerForceMin
) -> Annotated[Number, "F_п1/F_п2", "1"]:
    """Spring forces of the two methods for one nominal torque without margin, F_п1/F_п2 = g(f_cp)/g(f_min).

    Source: S19 (7), from (5) and (6) without the β_н that (6) prints beside T_н.
    Validity: Any variant.
    """
    return torque_per_force_mean / torque_per_force_min


def scatter(
    closing_force: ClosingForce,
    mean_radius: MeanRadius,
    pairs: Pairs,
    controlled_pairs: ControlledPairs,
    gain: Gain,
    friction_min: FrictionMin,
    friction_max: FrictionMax,
) -> Scatter:
    """Torque scatter band, ΔT = z F_п R (f_max − f_min)/([1 + z_2 C f_min][1 + z_2 C f_max]).

    Source: S19 (10); (11) mended (M6) with F_п = β_н F_п2.
    Validity: Direct clutch, one material; F_п includes the margin.
    """
    at_min, at_max = (1 + controlled_pairs * gain * friction for friction in (friction_min, friction_max))
    return pairs * closing_force * mean_radius * (friction_max - friction_min) / (at_min * at_max)


def scatter_ratio(
    margin: Margin, torque_per_force_min: TorquePerForceMin, torque_per_force_mean: TorquePerForceMean
) -> Annotated[Number, "ΔT_2/ΔT_1", "1"]:
    """Bands of the two methods on a direct clutch, ΔT_2/ΔT_1 = β_н g(f_min)/g(f_cp), which is T_min2/T_н.

    Source: S19 (10), (11) mended (M6); handbook, chapter 4.
    Validity: Direct clutches: K_т does not depend on the method.
    """
    return margin * torque_per_force_min / torque_per_force_mean


def pairs_threshold(
    bypass_pairs: BypassPairs, gain: Gain, friction_min: FrictionMin, friction_mean: FrictionMean, margin: Margin
) -> Annotated[Number, "z_lim", "1"]:
    """Number of pairs above which min-friction is narrower, (1/f_min − β_н/f_cp)/((β_н − 1) C) + z_1.

    Source: S19 (12) for z_1 = 1; (13) with C = 1/f_max.
    Validity: Direct clutch, one material, β_н > 1, C > 0. At β_н = 1 mean-friction is always narrower.
    """
    return (1 / friction_min - margin / friction_mean) / ((margin - 1) * gain) + bypass_pairs
