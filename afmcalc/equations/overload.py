"""Overload with a torque margin: potential and actuation torque (S22; handbook, chapter 6).

One material. S22 sets a clutch at f_min: its nominal torque and the machine's are those of the case ``overload``,
whatever the method of the spec. u = (z − z_1) C f_min and v = (z − z_1) C f are the loop gains at f_min and at f.
"""

from .arrays import chosen, larger, smaller
from .wiring import Same


def loop_gain(controlled_pairs, gain, friction):
    """Loop gain, v = (z − z_1) C f. Source: S22 (5)–(24), the group (z − z_1) C f. Validity: All-driving: z_1 = 0."""
    return controlled_pairs * gain * friction


def expected_torque(pairs, closing_force, mean_radius, friction, loop_gain):
    """Expected slip torque, T_муф = z F_п R f/(1 + v). Source: S22 (4), (16). Validity: One material."""
    return pairs * closing_force * mean_radius * friction / (1 + loop_gain)


def potential_torque(pairs, closing_force, mean_radius, friction, margin, loop_gain_at_f_min):
    """Torque the pack could carry while the machine runs at T_н.маш, T_п = z F_п R f [β_н + (β_н − 1) u]/[β_н (1 + u)].
    Source: S22 (5), (8), (20) mended (M16) with β_н = 1, (22). Validity: Below slip the load is shared z_1 : z_2
    between bypass and controlled pairs."""
    share = margin + (margin - 1) * loop_gain_at_f_min
    return pairs * closing_force * mean_radius * friction * share / (margin * (1 + loop_gain_at_f_min))


def distance_to_gain_limit(bypass_pairs, gain, friction):
    """Distance of the bypass pairs' loop gain from its limit, 1 − z_1 C f. Source: F11 (20). Validity: z_1 ≥ 1."""
    return 1 - bypass_pairs * gain * friction


def force_bypass_first(closing_force, gain, mean_radius, distance_to_gain_limit, machine_torque_at_overload):
    """Normal force under T_н.маш, bypass pairs carrying first, N = (F_п − C T_н.маш/R)/(1 − z_1 C f), F_п at most.
    Source: F11: the balls bear what the bypass pairs do not hold. Validity: Below slip; N = F_п where z_1 C f ≥ 1."""
    left = closing_force - gain * machine_torque_at_overload / mean_radius
    return chosen(
        distance_to_gain_limit > 0, lambda: smaller(closing_force, left / distance_to_gain_limit), lambda: closing_force
    )


def potential_torque_bypass_first(pairs, force_bypass_first, mean_radius, friction):
    """Torque the pack could carry under T_н.маш where the bypass pairs carry first, T_п = z R f N.
    Source: F11's loading; (22) shares the load z_1 : z_2 instead. Validity: One material."""
    return pairs * mean_radius * friction * force_bypass_first


def potential_torque_bound(pairs, closing_force, mean_radius, friction):
    """Upper bound of the trip torque, z R f F_п: the balls give the spring no relief yet.
    Source: Handbook, chapter 6. Validity: Any sharing of the load and any lag."""
    return pairs * mean_radius * friction * closing_force


def potential_torque_risen(potential_torque, loop_gain, risen_load):
    """Potential torque under a load that has risen by ΔT above T_н.маш, T_п(ΔT) = T_п − v ΔT.
    Source: S22 (6), (9). Validity: 0 ≤ ΔT ≤ ΔT', up to slip; the release force follows the load without lag."""
    return potential_torque - loop_gain * risen_load


def potential_torque_gain(pairs, bypass_pairs, closing_force, mean_radius, friction, friction_min, gain, margin):
    """Excess of T_п of the differentiated clutch over that of the all-driving one, z F_п R f z_1 C f_min/{β_н (1 + zC
    f_min)[1 + (z − z_1) C f_min]}.
    Source: Difference of S22 (22) and (8) (M15, M18). Validity: Equal spring force, gain and margin."""
    all_driving = 1 + pairs * gain * friction_min
    differentiated = 1 + (pairs - bypass_pairs) * gain * friction_min
    bypass = bypass_pairs * gain * friction_min
    return pairs * closing_force * mean_radius * friction * bypass / (margin * all_driving * differentiated)


def load_rise(potential_torque, machine_torque_at_overload, loop_gain):
    """Load rise until slip, ΔT' = (T_п − T_н.маш)/(1 + v).
    Source: S22 (12), (13). Validity: The release force follows the load without lag."""
    return (potential_torque - machine_torque_at_overload) / (1 + loop_gain)


def load_rise_max(pairs, closing_force, mean_radius, friction_min, margin, loop_gain_at_f_min):
    """Load rise until slip at f_min, z F_п R f_min (β_н − 1)/[β_н (1 + u)]. Source: S22 (7). Validity: f = f_min."""
    loaded = margin * (1 + loop_gain_at_f_min)
    return pairs * closing_force * mean_radius * friction_min * (margin - 1) / loaded


def load_risen(machine_torque_at_overload, risen_load):
    """Load that has risen above the machine's nominal torque, T_н.маш + ΔT.
    Source: S22 (6), (9). Validity: 0 ≤ ΔT ≤ ΔT'."""
    return machine_torque_at_overload + risen_load


def actuation_factor(loop_gain, loop_gain_at_f_min, friction, friction_min, margin):
    """Published over expected actuation torque, A = [β_н v (1 + u) + (1 − v²) f_min/f]/[β_н (1 + u)].
    Source: S22 (14), (15) mended (M11), (21) with β_н = 1, (23). Validity: As published: rests on T_ср = T_п − ΔT',
    which the paper's own (12) contradicts (M12)."""
    risen = margin * loop_gain * (1 + loop_gain_at_f_min) + (1 - loop_gain * loop_gain) * friction_min / friction
    return risen / (margin * (1 + loop_gain_at_f_min))


def actuation_torque_published(potential_torque, load_rise):
    """Actuation torque as published, T_ср = T_п − ΔT'.
    Source: S22 (14). Validity: See M12: the weights of T_п and T_н.маш are swapped against the equilibrium."""
    return potential_torque - load_rise


def actuation_torque_equilibrium(machine_torque_at_overload, load_rise):
    """Load at slip, T_н.маш + ΔT': equal to T_муф(f) for every margin.
    Source: Handbook, chapter 6 (M12). Validity: The release force follows the load without lag."""
    return machine_torque_at_overload + load_rise


def actuation_torque_max(actuation_torque_published_at_f_max, expected_torque_at_f_max):
    """Larger of published and expected torque at f_max.
    Source: S22 (19). Validity: The published actuation torque (M12)."""
    return larger(actuation_torque_published_at_f_max, expected_torque_at_f_max)


def friction_at_equal_potential(friction_min, margin, loop_gain_at_f_min):
    """Friction at which T_п = T_н.маш, f_min/(β_н + (β_н − 1) u): the first end of the interval where T_ср < T_муф.
    Source: S22 (17). Validity: At or below f_min; clip to the friction range."""
    return friction_min / (margin + (margin - 1) * loop_gain_at_f_min)


def friction_at_unit_loop_gain(reduced_gain):
    """Friction at which the loop gain v is 1, 1/((z − z_1) C): the second end of the interval where T_ср < T_муф.
    Source: S22 (17). Validity: C > 0."""
    return 1 / reduced_gain


def discriminant(margin, loop_gain_at_f_min):
    """Discriminant of (17), D = (β_н + (β_н − 2) u)²: a perfect square, never negative.
    Source: S22, before (17). Validity: Any β_н, u."""
    root = margin + (margin - 2) * loop_gain_at_f_min
    return root * root


def optimal_reduced_gain(friction_max):
    """Reduced gain at which the actual accuracy is best, 1/f_max.
    Source: S22, text on the optimum, mended (M13); A = 1 there. Validity: Published actuation torque; a kink of
    max(T_ср, T_муф)."""
    return 1 / friction_max


def friction_bound(pairs, margin, reduced_gain_of_pairs):
    """Friction below which S22 (10) is positive, 1/[zC (z − 1)(β_н − 1)] + z/(zC).
    Source: S22 (11), a reconstruction at zC = 5: from the signs left of (10), 1 + z (z − 1)(β_н − 1)(1 − C f), and of
    (11), from the minimum at z = 3 that the text states for β_н = 1.25, and from the value 1.0 there. Validity: z ≥ 2,
    as the paper states it. As a torque difference (10) cannot be right, for it is a pure number (M15)."""
    return 1 / (reduced_gain_of_pairs * (pairs - 1) * (margin - 1)) + pairs / reduced_gain_of_pairs


def reduced_gain_of_pairs(pairs, gain):
    """Reduced gain of all pairs, z C. Source: S22. Validity: The reduced gain of an all-driving clutch."""
    return pairs * gain


accuracy_factor_expected = Same("accuracy_factor_at_expected")
accuracy_factor_actual = Same("accuracy_factor_at_actual")
accuracy_factor_equilibrium = Same("accuracy_factor_at_equilibrium")

CASES = {
    "overload": {"closing_force": "closing_force", "friction_set": "friction_min", "margin_in_spring": "unity"},
    "expected": {"torque_max": "expected_torque_at_f_max", "torque_min": "expected_torque_at_f_min"},
    "actual": {"torque_max": "actuation_torque_max", "torque_min": "expected_torque_at_f_min"},
    "equilibrium": {
        "torque_max": "actuation_torque_equilibrium_at_f_max",
        "torque_min": "actuation_torque_equilibrium_at_f_min",
    },
}
