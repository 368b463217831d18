"""Overload with a torque margin: potential and actuation torque (S22; theory, section 6).

One material, set at f_min. u = (z − z_1) C f_min and v = (z − z_1) C f are the loop gains at f_min and at f.
"""

from ._types import Number


def loop_gain(controlled_pairs: Number, gain: Number, friction: Number) -> Number:
    """Loop gain, v = (z − z_1) C f.

    Source: S22 (5)–(24), the group (z − z_1) C f.

    Args:
        controlled_pairs: z_2, pairs whose torque passes the balls [1].
        gain: C, feedback gain [1].
        friction: f, coefficient of friction [1].

    Returns:
        v, loop gain (u at f_min) [1].

    Validity:
        All-driving: z_1 = 0.
    """
    return controlled_pairs * gain * friction


def expected_torque(
    pairs: Number, closing_force: Number, mean_radius: Number, friction: Number, loop_gain: Number
) -> Number:
    """Expected slip torque, T_муф = z F_п R f/(1 + v).

    Source: S22 (4), (16).

    Args:
        pairs: z, friction pairs [1].
        closing_force: F_п, closing-spring force as set (S21: F_п1) [N].
        mean_radius: R_cp, mean friction radius [m].
        friction: f, coefficient of friction [1].
        loop_gain: v, loop gain at f [1].

    Returns:
        T_муф [N*m].

    Validity:
        One material.
    """
    return pairs * closing_force * mean_radius * friction / (1 + loop_gain)


def machine_torque(nominal_torque: Number, margin: Number) -> Number:
    """Nominal torque of the machine, T_н.маш = T_н.муф/β_н.

    Source: S22 (1)–(3).

    Args:
        nominal_torque: T_н.муф, torque of the clutch at f_min [N*m].
        margin: β_н, torque margin [1].

    Returns:
        T_н.маш [N*m].

    Validity:
        β_н ≥ 1.
    """
    return nominal_torque / margin


def potential_torque(
    pairs: Number, closing_force: Number, mean_radius: Number, friction: Number, margin: Number, loop_gain_min: Number
) -> Number:
    """Torque the pack could carry while the machine runs at T_н.маш, T_п = z F_п R f [β_н + (β_н − 1) u]/[β_н (1 + u)].

    Source: S22 (5), (8), (20) mended (M16) with β_н = 1, (22).

    Args:
        pairs: z, friction pairs [1].
        closing_force: F_п, closing-spring force as set (S21: F_п1) [N].
        mean_radius: R_cp, mean friction radius [m].
        friction: f, coefficient of friction [1].
        margin: β_н, torque margin [1].
        loop_gain_min: u, loop gain at f_min [1].

    Returns:
        T_п [N*m].

    Validity:
        Below slip the load is shared z_1 : z_2 between bypass and controlled pairs.
    """
    return (
        pairs
        * closing_force
        * mean_radius
        * friction
        * (margin + (margin - 1) * loop_gain_min)
        / (margin * (1 + loop_gain_min))
    )


def load_rise(potential_torque: Number, machine_torque: Number, loop_gain: Number) -> Number:
    """Load rise until slip, ΔT' = (T_п − T_н.маш)/(1 + v).

    Source: S22 (12), (13).

    Args:
        potential_torque: T_п, potential torque [N*m].
        machine_torque: T_н.маш, nominal torque of the machine [N*m].
        loop_gain: v, loop gain at f [1].

    Returns:
        ΔT' [N*m].

    Validity:
        The release force follows the load without lag.
    """
    return (potential_torque - machine_torque) / (1 + loop_gain)


def load_rise_at_min(
    pairs: Number,
    closing_force: Number,
    mean_radius: Number,
    friction_min: Number,
    margin: Number,
    loop_gain_min: Number,
) -> Number:
    """Load rise until slip at f_min, z F_п R f_min (β_н − 1)/[β_н (1 + u)].

    Source: S22 (7).

    Args:
        pairs: z, friction pairs [1].
        closing_force: F_п, closing-spring force as set (S21: F_п1) [N].
        mean_radius: R_cp, mean friction radius [m].
        friction_min: f_min, smallest coefficient of friction [1].
        margin: β_н, torque margin [1].
        loop_gain_min: u, loop gain at f_min [1].

    Returns:
        ΔT_max [N*m].

    Validity:
        f = f_min.
    """
    return pairs * closing_force * mean_radius * friction_min * (margin - 1) / (margin * (1 + loop_gain_min))


def actuation_factor(
    loop_gain: Number, loop_gain_min: Number, friction: Number, friction_min: Number, margin: Number
) -> Number:
    """Published over expected actuation torque, A = [β_н v (1 + u) + (1 − v²) f_min/f]/[β_н (1 + u)].

    Source: S22 (14), (15) mended (M11), (21) with β_н = 1, (23).

    Args:
        loop_gain: v, loop gain at f [1].
        loop_gain_min: u, loop gain at f_min [1].
        friction: f, coefficient of friction [1].
        friction_min: f_min, smallest coefficient of friction [1].
        margin: β_н, torque margin [1].

    Returns:
        A = T_ср/T_муф [1].

    Validity:
        As published: rests on T_ср = T_п − ΔT', which the paper's own (12) contradicts (M12).
    """
    return (margin * loop_gain * (1 + loop_gain_min) + (1 - loop_gain * loop_gain) * friction_min / friction) / (
        margin * (1 + loop_gain_min)
    )


def actuation_torque_published(potential_torque: Number, load_rise: Number) -> Number:
    """Actuation torque as published, T_ср = T_п − ΔT'.

    Source: S22 (14).

    Args:
        potential_torque: T_п, potential torque [N*m].
        load_rise: ΔT', load rise until slip [N*m].

    Returns:
        T_ср [N*m].

    Validity:
        See M12: the weights of T_п and T_н.маш are swapped against the equilibrium.
    """
    return potential_torque - load_rise


def actuation_torque_equilibrium(machine_torque: Number, load_rise: Number) -> Number:
    """Load at slip, T_н.маш + ΔT': equal to T_муф(f) for every margin.

    Source: Theory, section 6 (M12).

    Args:
        machine_torque: T_н.маш, nominal torque of the machine [N*m].
        load_rise: ΔT', load rise until slip [N*m].

    Returns:
        T_eq, load at slip [N*m].

    Validity:
        The release force follows the load without lag.
    """
    return machine_torque + load_rise


def interval_low(friction_min: Number, margin: Number, loop_gain_min: Number) -> Number:
    """Friction at which T_п = T_н.маш, f_min/(β_н + (β_н − 1) u): one end of the interval where T_ср < T_муф.

    Source: S22 (17).

    Args:
        friction_min: f_min, smallest coefficient of friction [1].
        margin: β_н, torque margin [1].
        loop_gain_min: u, loop gain at f_min [1].

    Returns:
        f_low, one end of the interval [1].

    Validity:
        At or below f_min; clip to the friction range.
    """
    return friction_min / (margin + (margin - 1) * loop_gain_min)


def interval_high(reduced_gain: Number) -> Number:
    """Friction at which v = 1, 1/((z − z_1) C): the other end of the interval where T_ср < T_муф.

    Source: S22 (17).

    Args:
        reduced_gain: zC, reduced gain (z − z_1) C [1].

    Returns:
        f_high, the other end of the interval [1].

    Validity:
        C > 0.
    """
    return 1 / reduced_gain


def discriminant(margin: Number, loop_gain_min: Number) -> Number:
    """Discriminant of (17), D = (β_н + (β_н − 2) u)²: a perfect square, never negative.

    Source: S22 (17).

    Args:
        margin: β_н, torque margin [1].
        loop_gain_min: u, loop gain at f_min [1].

    Returns:
        D [1].

    Validity:
        Any β_н, u.
    """
    root = margin + (margin - 2) * loop_gain_min
    return root * root


def accuracy_factor_expected(expected_torque: Number, nominal_torque: Number) -> Number:
    """Expected accuracy factor, T_муф(f_max)/T_н.муф.

    Source: S22 (18).

    Args:
        expected_torque: T_муф, expected slip torque at f_max [N*m].
        nominal_torque: T_н.муф, nominal torque of the clutch, T_муф at f_min [N*m].

    Returns:
        K_т,exp [1].

    Validity:
        The clutch set at f_min.
    """
    return expected_torque / nominal_torque


def accuracy_factor_actual(actuation_torque: Number, nominal_torque: Number) -> Number:
    """Actual accuracy factor, the larger of published and expected torque at f_max over T_н.муф.

    Source: S22 (19).

    Args:
        actuation_torque: T_act, the larger of T_ср and T_муф at f_max [N*m].
        nominal_torque: T_н.муф, nominal torque of the clutch, T_муф at f_min [N*m].

    Returns:
        K_т,act [1].

    Validity:
        The published actuation torque (M12).
    """
    return actuation_torque / nominal_torque


def accuracy_factor_equilibrium(torque_max: Number, torque_min: Number) -> Number:
    """Accuracy factor with the torque at equilibrium, T_eq(f_max)/T_eq(f_min).

    Source: Theory, section 6 (M12).

    Args:
        torque_max: T_eq.max, load at slip at f_max [N*m].
        torque_min: T_eq.min, load at slip at f_min [N*m].

    Returns:
        K_т,eq [1].

    Validity:
        Quasi-static loading.
    """
    return torque_max / torque_min


def optimal_reduced_gain(friction_max: Number) -> Number:
    """Reduced gain at which the actual accuracy is best, 1/f_max.

    Source: S22, text on the optimum, mended (M13); A = 1 there.

    Args:
        friction_max: f_max, largest coefficient of friction [1].

    Returns:
        (zC)_opt, reduced gain (z − z_1) C [1].

    Validity:
        Published actuation torque; a kink of max(T_ср, T_муф).
    """
    return 1 / friction_max


def best_actual_accuracy_factor(friction_min: Number, friction_max: Number) -> Number:
    """Accuracy factor at the optimal reduced gain, (f_max + f_min)/(2 f_min).

    Source: Theory, section 6.

    Args:
        friction_min: f_min, smallest coefficient of friction [1].
        friction_max: f_max, largest coefficient of friction [1].

    Returns:
        K_т [1].

    Validity:
        All-driving; (z − z_1) C = 1/f_max.
    """
    return (friction_max + friction_min) / (2 * friction_min)


def potential_torque_gain_of_differentiated(
    pairs: Number,
    bypass_pairs: Number,
    closing_force: Number,
    mean_radius: Number,
    friction: Number,
    friction_min: Number,
    gain: Number,
    margin: Number,
) -> Number:
    """By how much T_п of the differentiated clutch exceeds that of the all-driving one.

    z F_п R f z_1 C f_min/{β_н (1 + zC f_min)[1 + (z − z_1) C f_min]}

    Source: Difference of S22 (22) and (8) (M15, M18).

    Args:
        pairs: z, friction pairs [1].
        bypass_pairs: z_1, pairs that bypass the control unit [1].
        closing_force: F_п, closing-spring force as set (S21: F_п1) [N].
        mean_radius: R_cp, mean friction radius [m].
        friction: f, coefficient of friction [1].
        friction_min: f_min, smallest coefficient of friction [1].
        gain: C, feedback gain [1].
        margin: β_н, torque margin [1].

    Returns:
        T'_п − T_п [N*m].

    Validity:
        Equal spring force, gain and margin.
    """
    all_driving = 1 + pairs * gain * friction_min
    differentiated = 1 + (pairs - bypass_pairs) * gain * friction_min
    return (
        pairs
        * closing_force
        * mean_radius
        * friction
        * bypass_pairs
        * gain
        * friction_min
        / (margin * all_driving * differentiated)
    )
