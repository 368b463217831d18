"""Adjustment: the closing-spring force for a nominal torque, by both methods (S19; handbook, chapter 4).

``margin_in_spring`` is the margin that the spring force includes: β_н with mean-friction, else 1 (S19; in S22 β_н
divides the torque of the machine). In the cases ``by_min`` and ``by_mean`` the clutch is set anew for its nominal
torque; in ``overload`` it stays as set, with its nominal torque at f_min, as in S22.
"""

margin = 1.0


def closing_force(nominal_torque_wanted, margin_in_spring, torque_per_force_at_setting):
    """Closing-spring force that gives the nominal torque at the setting, β_н T_н/[R g(f_set)].
    Source: S19 (1), (2), (5) with β_н = 1 and f_set = f_min; (3), (4), (6) with f_set = f_cp. Validity: T proportional
    to F_п, as in every variant."""
    return margin_in_spring * nominal_torque_wanted / torque_per_force_at_setting


def nominal_torque(torque_at_setting, margin_in_spring):
    """Nominal torque that the spring as set gives, T(f_set)/β_н: the inverse of ``closing_force``.
    Source: S19 (1)–(4). Validity: As ``closing_force``."""
    return torque_at_setting / margin_in_spring


def machine_torque(nominal_torque, margin, margin_in_spring):
    """Nominal torque of the machine, T_н.маш = T_н.муф/β_н.
    Source: S22 (1). Validity: β_н ≥ 1. Of a clutch set at the mean friction T_н itself, margin included (S19)."""
    return nominal_torque * margin_in_spring / margin


def closing_force_by_min(nominal_torque, torque_per_force_at_f_min):
    """Closing-spring force set at f_min for the nominal torque, F_п1 = T_н/[R g(f_min)].
    Source: S19 (1), (2), (5). Validity: T proportional to F_п, as in every variant."""
    return nominal_torque / torque_per_force_at_f_min


def closing_force_by_mean(nominal_torque, margin, torque_per_force_at_f_mean):
    """Closing-spring force set at the mean friction for the nominal torque, with margin, β_н T_н/[R g(f_cp)].
    Source: S19 (3), (4), (6). Validity: T proportional to F_п, as in every variant."""
    return margin * nominal_torque / torque_per_force_at_f_mean


def _force_ratio(torque_per_force_at_f_mean, torque_per_force_at_f_min):
    """Spring forces of the two methods for one nominal torque without margin, F_п1/F_п2 = g(f_cp)/g(f_min).
    Source: S19 (7), from (5) and (6) without the β_н that (6) prints beside T_н. Validity: Any variant."""
    return torque_per_force_at_f_mean / torque_per_force_at_f_min


def _scatter_ratio_direct(margin, torque_per_force_at_f_min, torque_per_force_at_f_mean):
    """Bands of the two methods on a direct clutch, ΔT_2/ΔT_1 = β_н g(f_min)/g(f_cp), which is T_min2/T_н.
    Source: S19 (10), (11) mended (M6); handbook, chapter 4. Validity: Direct clutches: K_т does not depend on the
    method."""
    return margin * torque_per_force_at_f_min / torque_per_force_at_f_mean


def scatter_ratio(scatter_at_by_mean, scatter_at_by_min):
    """Bands of the two methods, ΔT_2/ΔT_1.
    Source: S19 (10), (11). Validity: The torque wanders, ΔT_1 > 0; of an indirect clutch the stop moves with the
    setting, and K_т with it."""
    return scatter_at_by_mean / scatter_at_by_min


def _scatter_of_one_material(closing_force, mean_radius, pairs, controlled_pairs, gain, friction_min, friction_max):
    """Torque scatter band, ΔT = z F_п R (f_max − f_min)/([1 + z_2 C f_min][1 + z_2 C f_max]).
    Source: S19 (10); (11) mended (M6) with F_п = β_н F_п2. Validity: Direct clutch, one material; F_п includes the
    margin."""
    at_min, at_max = 1 + controlled_pairs * gain * friction_min, 1 + controlled_pairs * gain * friction_max
    return pairs * closing_force * mean_radius * (friction_max - friction_min) / (at_min * at_max)


def _pairs_threshold(bypass_pairs, gain, friction_min, friction_mean, margin):
    """Number of pairs above which min-friction is narrower, (1/f_min − β_н/f_cp)/((β_н − 1) C) + z_1.
    Source: S19 (12) for z_1 = 1; (13) with C = 1/f_max. Validity: Direct clutch, one material, β_н > 1, C > 0. At β_н =
    1 mean-friction is always narrower."""
    return (1 / friction_min - margin / friction_mean) / ((margin - 1) * gain) + bypass_pairs


DIRECT = {"force_ratio": _force_ratio, "scatter_ratio": _scatter_ratio_direct}
DIRECT_ONE_MATERIAL = {"pairs_threshold": _pairs_threshold, "scatter_of_one_material": _scatter_of_one_material}
