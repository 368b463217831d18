"""Indirect regulation: the release force moves a sleeve that slackens the closing spring (S21; handbook, chapter 5).

``net_gain_acting`` is κ while the sleeve moves off its stop, κ₊ in the case ``returning``; values fixed at the setting
depend on ``net_gain``.
"""

from .arrays import larger, quotient, smaller
from .wiring import Either, Same

bypass_pairs = 0


def torque_per_force(pairs, mean_radius, friction):
    """Slip torque per closing force at the setting, T_н/F_п1 = z R f_set.
    Source: S21 (4): at the setting the sleeve rests and N = F_п1. Validity: The control spring set by (14)."""
    return mean_radius * pairs * friction


# gains


def gain_threshold(mean_radius, key_friction, hub_diameter):
    """Gain at which feedback begins, 2 R f_1/d: below it the key's friction holds the sleeve.
    Source: S21, after (5), as tan α > 2 f_1 for d = r; handbook, chapter 5. Validity: Friction at the key opposes the
    sleeve's motion."""
    return 2 * mean_radius * key_friction / hub_diameter


def net_gain(gain, gain_threshold):
    """Gain net of the key's friction while the sleeve moves off its stop, κ = C − 2 R f_1/d.
    Source: S21 (10), (16). Validity: κ > 0; κ = 0 is an ordinary clutch, κ < 0 is none."""
    return gain - gain_threshold


def net_gain_returning(gain, gain_threshold):
    """Gain with the key's friction reversed, while the sleeve moves back, κ₊ = C + 2 R f_1/d.
    Source: Handbook, chapter 5 (beyond S21). Validity: Friction falling, load kept."""
    return gain + gain_threshold


net_gain_acting = Same("net_gain")
gain_acting = Same("gain")


def _equivalent_gain(net_gain, closing_stiffness, control_stiffness):
    """Gain of the all-driving clutch with the same torque curve, κ c_1/(c_1 + c_2).
    Source: Identity of S21 (11) with S22 (4): T = [F_п1 (1 + z C_eff f_set)] z R f/(1 + z C_eff f). Validity: f ≥
    f_set."""
    return net_gain * closing_stiffness / (closing_stiffness + control_stiffness)


def nominal_torque_ratio(pairs, gain, friction_set, normal_force_at_setting, closing_force):
    """Nominal torque over that of a base clutch of equal spring and gain, K_п = (1 + z C f_set) N(f_set)/F_п1.
    Source: S21, after fig. 2 (with f_set = f_min and N = F_п1); of any two springs handbook, chapter 5. Validity: The
    base clutch, all pairs controlled, has its feedback active at f_set."""
    return (1 + pairs * gain * friction_set) * normal_force_at_setting / closing_force


# setting


def control_force_set(closing_force, pairs, net_gain, friction_set):
    """Control-spring force that just holds the sleeve at its stop at the setting, F_п2 = F_п1 (1 + z f_set κ).
    Source: S21 (14); C from it is (5). Validity: κ ≥ 0."""
    return closing_force * (1 + pairs * friction_set * net_gain)


def friction_leaving_made(control_force_made, closing_force, pairs, net_gain):
    """Friction at which the sleeve leaves its stop, f_L = (F_п2/F_п1 − 1)/(z κ).
    Source: S21 (14) for f_set; f_set itself with the control spring set by (14). Validity: κ > 0; f_L ≤ 0 means that
    the sleeve never rests at its stop."""
    return quotient(control_force_made / closing_force - 1, pairs * net_gain)


control_force = Same("control_force_set")
friction_leaving = Same("friction_set")

# friction rising


def is_seated(friction, friction_leaving):
    """Condition that the sleeve is at its stop, f < f_L.
    Source: S21, text of fig. 1 (handbook, chapter 5). Validity: Straight walls: at f_L both laws give the same
    force."""
    return friction < friction_leaving


def sleeve_stiffness(closing_stiffness, control_stiffness, pairs, friction, net_gain_acting):
    """Stiffness against which the sleeve moves, D(f) = c_1 + c_2 + z c_1 f κ.
    Source: S21 (10), (11), in κ (handbook, chapter 5). Validity: κ ≥ 0, then D > 0."""
    return closing_stiffness + control_stiffness + pairs * closing_stiffness * friction * net_gain_acting


def normal_force_seated(control_force, pairs, net_gain_acting, friction):
    """Normal force with the sleeve at its stop, N = F_п2/(1 + z κ f).
    Source: S21, text of fig. 1: the stop 10 belongs to the pressure disc 5, so spring 11 presses the pack through
    sleeve and stop; N = F_п1 + S with the stop's reaction S = F_п2 − F_п1 − T κ/R (handbook, chapter 5). Validity: S ≥
    0, that is N ≥ F_п1, or f ≤ f_set with the control spring set by (14); κ ≥ 0."""
    return control_force / (1 + pairs * net_gain_acting * friction)


def normal_force_moving(closing_force, closing_stiffness, control_force, control_stiffness, sleeve_stiffness):
    """Normal force with the sleeve off its stop, N = (F_п1 c_2 + F_п2 c_1)/D(f), which is F_п1 − c_1 x.
    Source: S21 (9) with (10); (11). Validity: f ≥ f_set."""
    balanced = (closing_force * control_stiffness + control_force * closing_stiffness) / sleeve_stiffness
    return smaller(closing_force, balanced)


normal_force = Either("is_seated", "normal_force_seated", "normal_force_moving")
pack_force_at_rest = Same("normal_force_at_rest")


def torque(normal_force, mean_radius, pairs, friction):
    """Slip torque of all pairs under a normal force, T = z R f N. Source: S21 (9). Validity: The clutch slips."""
    return normal_force * mean_radius * pairs * friction


breakaway_torque = driven_torque = Same("torque")


def release_force(torque, gain_acting, mean_radius):
    """Release force of the balls on the sleeve, F_p = T tan α/r = T C/R.
    Source: S21 (2), (7). Validity: All torque passes the balls."""
    return torque * gain_acting / mean_radius


def key_friction_force(torque, key_friction, hub_diameter):
    """Friction force of the key on the sleeve, F_тр = 2 T f_1/d.
    Source: S21 (3), (8). Validity: The sleeve moves or is about to; all torque passes the key."""
    return 2 * torque * key_friction / hub_diameter


def stop_reaction_seated(control_force, closing_force, torque, net_gain, mean_radius):
    """Reaction of the stop on the sleeve that rests there, S = F_п2 − F_п1 − T κ/R_cp.
    Source: S21 (1) with the force on the stop 10, which the paper takes as 0 at the setting; handbook, chapter 5.
    Validity: S ≥ 0; the key at the limit of its friction. 0 once the sleeve has left its stop."""
    return control_force - closing_force - torque * net_gain / mean_radius


stop_reaction = Either("is_seated", "stop_reaction_seated", "nothing")


def travel_as_set(pairs, closing_force, friction, friction_set, net_gain, sleeve_stiffness):
    """Axial travel of the sleeve, x = z F_п1 (f − f_set) κ/D(f).
    Source: S21 (10), (16). Validity: f ≥ f_set; below it the sleeve rests at its stop, x = 0. Always x < F_п1/c_1."""
    return pairs * closing_force * (friction - friction_set) * net_gain / sleeve_stiffness


def travel_as_made(closing_force, control_force, pairs, friction, net_gain, sleeve_stiffness):
    """Axial travel of the sleeve with any two spring forces, x = [(1 + z κ f) F_п1 − F_п2]/D(f).
    Source: S21 (10), in κ. Validity: x ≥ 0; where it would be negative the sleeve rests at its stop."""
    return ((1 + pairs * net_gain * friction) * closing_force - control_force) / sleeve_stiffness


travel_moving = Same("travel_as_set")
travel = Either("is_seated", "nothing", "travel_moving")

# over the range

torque_min, torque_max = Same("torque_at_f_min"), Same("torque_at_f_max")
friction_of_torque_min, friction_of_torque_max = Same("friction_min"), Same("friction_max")
torque_min_from_mean, torque_max_from_mean = Same("torque_at_f_mean"), Same("torque_at_f_max")
torque_min_worst_case, torque_max_worst_case = Same("torque_min"), Same("torque_max")
travel_max = Same("travel_at_f_max")
wear_play = 0.0
running_torque = Same("machine_torque")
accuracy_factor_hysteresis = Same("accuracy_factor_at_hysteresis")
accuracy_factor_peak = Same("accuracy_factor")


def driven_torque_max(torque_at_f_min, torque_at_f_max):
    """Largest torque that passes the balls, max[T(f_min), T(f_max)].
    Source: All torque passes the balls, S21 (9). Validity: Straight walls: T rises with f."""
    return larger(torque_at_f_min, torque_at_f_max)


def _accuracy_factor_as_set(
    friction_min, friction_max, sleeve_stiffness_at_setting, sleeve_stiffness_at_f_max, pairs, net_gain, friction_set
):
    """Accuracy factor, K_т = f_max D(f_set) (1 + z κ f_min)/[f_min D(f_max) (1 + z κ f_set)].
    Source: S21 (15), mended (M9), with f_set = f_min; handbook, chapter 5 for f_min < f_set ≤ f_max, where the sleeve
    rests at f_min. Validity: f_min ≤ f_set ≤ f_max, κ ≥ 0."""
    rising = friction_max * sleeve_stiffness_at_setting / (friction_min * sleeve_stiffness_at_f_max)
    return rising * ((1 + pairs * net_gain * friction_min) / (1 + pairs * net_gain * friction_set))


# walls that hold the torque (handbook, chapter 12)


def constant_torque_slope(closing_stiffness, control_stiffness, pairs, friction_leaving, closing_force):
    """Slope that holds the torque once the sleeve is off its stop, C_1* = (c_1 + c_2)/(z f_L F_п1).
    Source: Handbook, chapter 12. Validity: f_L > 0. Above it the torque falls as friction rises."""
    return (closing_stiffness + control_stiffness) / (pairs * friction_leaving * closing_force)


def jumping_slope(sleeve_stiffness_at_leaving, pairs, friction_leaving, closing_force):
    """Slope above which the sleeve jumps off its stop as friction rises in slip, D(f_L)/(z f_L F_п1).
    Source: Handbook, chapter 12: there b = 0 at the stop. Validity: f_L > 0. Above C_1* already the sleeve jumps under
    a load that rises while the clutch still holds."""
    return sleeve_stiffness_at_leaving / (pairs * friction_leaving * closing_force)


# friction falling under load


def is_locked(friction, net_gain_returning, friction_max, net_gain):
    """Condition that the key still keeps the sleeve where it was at f_max, f κ₊ ≥ f_max κ.
    Source: Handbook, chapter 5 (beyond S21). Validity: Friction falling from f_max, load kept."""
    return friction * net_gain_returning >= friction_max * net_gain * (1 - 1e-12)


def is_held_at_stop(control_force, closing_force, pairs, net_gain_returning, friction):
    """Condition that the control spring keeps the sleeve at its stop, F_п2 > F_п1 (1 + z κ₊ f).
    Source: S21, text of fig. 1, with the key's friction reversed (handbook, chapter 5). Validity: Friction falling,
    load kept."""
    return control_force > closing_force * (1 + pairs * net_gain_returning * friction)


is_reseated = Same("is_held_at_stop")
normal_force_let_go = Either("is_reseated", "normal_force_seated_at_returning", "normal_force_moving_at_returning")
normal_force_returning = Either("is_locked", "normal_force_at_f_max", "normal_force_let_go")


def torque_returning(normal_force_returning, mean_radius, pairs, friction):
    """Slip torque, friction falling from f_max under load, T_ret = z R f N.
    Source: S21 (9); handbook, chapter 5 (beyond S21). Validity: f ≤ f_max; the load lasts."""
    return normal_force_returning * mean_radius * pairs * friction


torque_returning_min = Same("torque_returning_at_f_min")


def hysteresis_ratio(net_gain, net_gain_returning):
    """Ratio by which friction must fall before the sleeve moves back, κ₊/κ.
    Source: Handbook, chapter 5 (beyond S21). Validity: κ > 0."""
    return quotient(net_gain_returning, net_gain)


CONTROL_FORCE_MADE = {
    "is_made": True,
    "control_force": Either("is_made", "control_force_made", "control_force_set"),
    "friction_leaving": Either("is_made", "friction_leaving_made", "friction_set"),
    "travel_moving": Either("is_made", "travel_as_made", "travel_as_set"),
}
"""Laws for a given force of the control spring; in the cases ``by_min`` and ``by_mean`` it is by S21 (14) again."""
STRAIGHT = {"equivalent_gain": _equivalent_gain, "accuracy_factor_as_set": _accuracy_factor_as_set}
_SET = {"is_made": "never", "friction_set": "friction_{}", "closing_force": "closing_force_by_{}"}

CASES = {
    "rest": {"friction": "nothing"},
    "leaving": {"friction": "friction_leaving"},
    "returning": {"net_gain_acting": "net_gain_returning"},
    "hysteresis": {"torque_min": "torque_returning_min"},
    "by_min": {name: target.format("min") for name, target in _SET.items()} | {"margin_in_spring": "unity"},
    "by_mean": {name: target.format("mean") for name, target in _SET.items()} | {"margin_in_spring": "margin"},
}
