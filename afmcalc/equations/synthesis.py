"""The laws solved for gain, pairs, radius or stiffness: the clutch for an accuracy or a torque."""


def gain_for_accuracy_factor(
    bypass_pairs,
    controlled_pairs,
    accuracy_factor,
    friction_driving_min,
    friction_driven_min,
    friction_driving_max,
    friction_driven_max,
):
    """Gain for a wanted K_т, C = (A − K_т)/[z_2 (K_т f_2max − A f_2min)] with A = K_т at C = 0.

    Source: F11 (14) solved for C.
    Validity: A f_2min/f_2max < K_т ≤ A. The gain limit of the variant is a condition of its own.

    >>> gain_for_accuracy_factor(0, 8, 2.0, 0.125, 0.125, 0.5, 0.5)
    0.5
    """
    largest = bypass_pairs * friction_driving_max + controlled_pairs * friction_driven_max
    ordinary = largest / (bypass_pairs * friction_driving_min + controlled_pairs * friction_driven_min)
    fall = accuracy_factor * friction_driven_max - ordinary * friction_driven_min
    return (ordinary - accuracy_factor) / (controlled_pairs * fall)


def gain_for_torque(
    torque, closing_force, mean_radius, bypass_pairs, controlled_pairs, friction_driving, friction_driven
):
    """Gain for a wanted torque at one friction, C = [F_п R (z_1 f_1 + z_2 f_2)/T − 1]/(z_2 f_2).

    Source: F11 (12) solved for C.
    Validity: T not above that of the ordinary clutch (C = 0); z_2 ≥ 1.
    """
    carried = bypass_pairs * friction_driving + controlled_pairs * friction_driven
    return (closing_force * mean_radius * carried / torque - 1) / (controlled_pairs * friction_driven)


def controlled_pairs_for_accuracy_factor(gain, accuracy_factor, friction_min, friction_max):
    """Controlled pairs for a wanted K_т, z_2 = (f_max/f_min − K_т)/[C f_max (K_т − 1)].

    Source: S22 (18), F11 (14) with one material, solved for z_2.
    Validity: One material; C > 0; 1 < K_т ≤ f_max/f_min. Not rounded to a whole number.
    """
    return (friction_max / friction_min - accuracy_factor) / (gain * friction_max * (accuracy_factor - 1))


def controlled_pairs_for_torque(
    torque, closing_force, mean_radius, bypass_pairs, gain, friction_driving, friction_driven
):
    """Controlled pairs for a wanted torque, z_2 = (T − F_п R z_1 f_1)/[f_2 (F_п R − C T)].

    Source: F11 (12) solved for z_2.
    Validity: C T < F_п R: with ever more pairs the torque tends to F_п R/C and no further. Not rounded to a whole
        number.
    """
    arm = closing_force * mean_radius
    return (torque - arm * bypass_pairs * friction_driving) / (friction_driven * (arm - gain * torque))


def mean_radius_for_torque(
    torque, closing_force, bypass_pairs, controlled_pairs, gain, friction_driving, friction_driven
):
    """Mean radius for a wanted torque at fixed gain, R = T (1 + C z_2 f_2)/[F_п (z_1 f_1 + z_2 f_2)].

    Source: F11 (12) solved for R.
    Validity: C given as such, not by a wall angle (C would follow R).
    """
    carried = bypass_pairs * friction_driving + controlled_pairs * friction_driven
    return torque * (1 + gain * controlled_pairs * friction_driven) / (closing_force * carried)


def net_loop_gain_linear(
    friction_min, friction_set, friction_max, closing_stiffness, control_stiffness, accuracy_factor
):
    """Linear coefficient of the quadratic in zκ that a wanted K_т leads to.

    Source: S21 (15) mended (M9) with the seated sleeve below f_set (handbook, chapter 5), powers of zκ collected.
    Validity: As ``net_loop_gain_for_accuracy_factor``.
    """
    springs = closing_stiffness + control_stiffness
    rising = friction_max * (springs * friction_min + closing_stiffness * friction_set)
    return rising - accuracy_factor * friction_min * (springs * friction_set + closing_stiffness * friction_max)


def net_loop_gain_constant(friction_min, friction_max, closing_stiffness, control_stiffness, accuracy_factor):
    """Constant of the same quadratic.

    Source: S21 (15) mended (M9) with the seated sleeve below f_set (handbook, chapter 5), powers of zκ collected.
    Validity: Not negative for K_т ≤ f_max/f_min.
    """
    return (closing_stiffness + control_stiffness) * (friction_max - accuracy_factor * friction_min)


def net_loop_gain_for_accuracy_factor(
    friction_min, friction_set, friction_max, closing_stiffness, accuracy_factor, linear, constant
):
    """Net loop gain of the indirect clutch for a wanted K_т, the positive root of a quadratic.

    a (zκ)² + b_κ zκ + d_κ = 0 with a = c_1 f_set f_min f_max (1 − K_т); the form chosen is no 0/0 for K_т = 1.

    Source: S21 (15) mended (M9) with the seated sleeve below f_set (handbook, chapter 5), solved for zκ.
    Validity: 1 < K_т ≤ f_max/f_min.
    """
    square = closing_stiffness * friction_set * friction_min * friction_max * (accuracy_factor - 1)
    return 2 * constant / ((linear**2 + 4 * square * constant) ** 0.5 - linear)


def net_gain_for_accuracy_factor(loop, pairs):
    """Net gain of the indirect clutch for a wanted K_т.

    C is κ + 2 R f_1/d.

    Source: S21 (15) mended (M9), solved for κ.
    Validity: 1 < K_т ≤ f_max/f_min.
    """
    return loop / pairs


def pairs_for_accuracy_factor_indirect(loop, net_gain):
    """Pairs of the indirect clutch for a wanted K_т.

    Source: S21 (15) mended (M9), solved for z.
    Validity: κ > 0; 1 < K_т ≤ f_max/f_min. Not rounded to a whole number.
    """
    return loop / net_gain


def stiffness_ratio_for_accuracy_factor(friction_min, friction_set, friction_max, pairs, net_gain, accuracy_factor):
    """Stiffness ratio of the indirect clutch for a wanted K_т, by which either spring follows from the other.

    With a = zκ, w = K_т f_min (1 + f_set a), v = 1 + f_min a: 1 + c_2/c_1 = f_max a (w − f_set v)/(f_max v − w).

    Source: S21 (15) mended (M9), solved for c_2/c_1: K_т depends on the ratio only.
    Validity: κ > 0; K_т between its value at c_2 = 0 and f_max/f_min.
    """
    loop = pairs * net_gain
    at_min, at_set = 1 + loop * friction_min, 1 + loop * friction_set
    wanted = accuracy_factor * friction_min * at_set
    return friction_max * loop * (wanted - friction_set * at_min) / (friction_max * at_min - wanted) - 1


SYMBOLS = """\
accuracy_factor | K_т.зад | 1 | accuracy factor that is wanted
constant | d_κ | N/m | constant of the quadratic of zκ
controlled_pairs_for_accuracy_factor | z_2 | 1 | pairs whose torque passes the balls
controlled_pairs_for_torque | z_2 | 1 | pairs whose torque passes the balls
gain_for_accuracy_factor | C | 1 | feedback gain
gain_for_torque | C | 1 | feedback gain
linear | b_κ | N/m | coefficient of zκ in its quadratic
loop | zκ | 1 | net gain of all pairs together
mean_radius_for_torque | R_cp | m | mean friction radius
net_gain_for_accuracy_factor | κ | 1 | C − 2 R f_1/d, gain net of the key's friction
net_loop_gain_constant | d_κ | N/m | constant of the quadratic of zκ
net_loop_gain_for_accuracy_factor | zκ | 1 | net gain of all pairs together
net_loop_gain_linear | b_κ | N/m | coefficient of zκ in its quadratic
pairs_for_accuracy_factor_indirect | z | 1 | friction pairs
stiffness_ratio_for_accuracy_factor | c_2/c_1 | 1 |
torque | T_зад | N*m | torque that is wanted
"""  # noqa: E501
