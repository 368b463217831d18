"""Adjustment: the closing-spring force for a nominal torque (theory, section 4)."""

from ._types import Number


def closing_force(nominal_torque: Number, margin: Number, torque_per_force: Number) -> Number:
    """Closing-spring force that gives the nominal torque at the setting, β_н T_н/[R g(f_set)].

    Source: S19 (1), (2), (5) with β_н = 1 and f_set = f_min; (3), (4), (6) with f_set = f_cp.

    Args:
        nominal_torque: T_н [N*m].
        margin: β_н, torque margin, 1 for min-friction [1].
        torque_per_force: a_set, slip torque per spring force at the friction of the setting [m].

    Returns:
        F_п [N].

    Validity:
        T proportional to F_п, as in every variant.
    """
    return margin * nominal_torque / torque_per_force


def nominal_torque(torque_at_setting: Number, margin: Number) -> Number:
    """Nominal torque that the spring as set gives, T(f_set)/β_н: the inverse of ``closing_force``.

    Source: S19 (1)–(4).

    Args:
        torque_at_setting: T_set, slip torque at the friction of the setting, with the force as set [N*m].
        margin: β_н, torque margin, 1 for min-friction [1].

    Returns:
        T_н [N*m].

    Validity:
        As ``closing_force``.
    """
    return torque_at_setting / margin


def force_ratio(torque_per_force_mean: Number, torque_per_force_min: Number) -> Number:
    """Spring forces of the two methods for one nominal torque without margin, F_п1/F_п2 = g(f_cp)/g(f_min).

    Source: S19 (7), from (5) and (6) without the β_н that (6) prints beside T_н.

    Args:
        torque_per_force_mean: a_cp, slip torque per spring force at f_cp [m].
        torque_per_force_min: a_min, slip torque per spring force at f_min [m].

    Returns:
        F_п1/F_п2 [1].

    Validity:
        Any variant.
    """
    return torque_per_force_mean / torque_per_force_min


def scatter(
    closing_force: Number,
    mean_radius: Number,
    pairs: Number,
    controlled_pairs: Number,
    gain: Number,
    friction_min: Number,
    friction_max: Number,
) -> Number:
    """Torque scatter band, ΔT = z F_п R (f_max − f_min)/([1 + z_2 C f_min][1 + z_2 C f_max]).

    Source: S19 (10); (11) mended (M6) with F_п = β_н F_п2.

    Args:
        closing_force: F_п, closing-spring force as set, margin included [N].
        mean_radius: R_cp [m].
        pairs: z, friction pairs [1].
        controlled_pairs: z_2, pairs whose torque passes the balls [1].
        gain: C, feedback gain [1].
        friction_min: f_min, smallest coefficient of friction [1].
        friction_max: f_max, largest coefficient of friction [1].

    Returns:
        ΔT [N*m].

    Validity:
        Direct clutch, one material.
    """
    return (
        pairs
        * closing_force
        * mean_radius
        * (friction_max - friction_min)
        / ((1 + controlled_pairs * gain * friction_min) * (1 + controlled_pairs * gain * friction_max))
    )


def scatter_ratio(margin: Number, torque_per_force_min: Number, torque_per_force_mean: Number) -> Number:
    """Bands of the two methods on a direct clutch, ΔT_2/ΔT_1 = β_н g(f_min)/g(f_cp), which is T_min2/T_н.

    Source: S19 (10), (11) mended (M6); theory, section 4.

    Args:
        margin: β_н, torque margin [1].
        torque_per_force_min: a_min, slip torque per spring force at f_min [m].
        torque_per_force_mean: a_cp, slip torque per spring force at f_cp [m].

    Returns:
        ΔT_2/ΔT_1 [1].

    Validity:
        Direct clutches: K_т does not depend on the method.
    """
    return margin * torque_per_force_min / torque_per_force_mean


def pairs_threshold(
    bypass_pairs: Number, gain: Number, friction_min: Number, friction_mean: Number, margin: Number
) -> Number:
    """Number of pairs above which min-friction is narrower, (1/f_min − β_н/f_cp)/((β_н − 1) C) + z_1.

    Source: S19 (12) for z_1 = 1; (13) with C = 1/f_max.

    Args:
        bypass_pairs: z_1, pairs that bypass the control unit [1].
        gain: C, feedback gain [1].
        friction_min: f_min, smallest coefficient of friction [1].
        friction_mean: f_cp, mean coefficient of friction [1].
        margin: β_н, torque margin [1].

    Returns:
        z_lim [1].

    Validity:
        Direct clutch, one material, β_н > 1, C > 0. At β_н = 1 mean-friction is always narrower.
    """
    return (1 / friction_min - margin / friction_mean) / ((margin - 1) * gain) + bypass_pairs
