"""Laws of a sleeve between disc springs: where it is in balance a solver finds (``engines.balance``).

They take the place of those of ``equations.indirect`` and ``equations.curved`` whose springs are straight.
"""

from ..equations.arrays import chosen, larger, place_of_largest, place_of_smallest, smaller
from ..equations.wiring import Either, Same
from .balance import Balance
from .characteristics import SetSpring

_ROUNDING = 1e-12


def closing_spring(closing_force, closing_stiffness, closing_disc):
    """The closing spring as it is set.
    Source: DIN EN 16984 of disc springs, F = F_п1 + c_1 x of a straight one. Validity: As the spring."""
    return SetSpring(closing_force, closing_stiffness, closing_disc)


def control_spring(control_force, control_stiffness, control_disc):
    """The control spring as it is set.
    Source: DIN EN 16984 of disc springs, F = F_п2 + c_2 x of a straight one. Validity: As the spring."""
    return SetSpring(control_force, control_stiffness, control_disc)


def balance(closing_spring, control_spring, pairs, net_gain_acting):
    """Balance of the forces on a sleeve off its stop, N(x)(1 + zκf) = F_2(x).
    Source: S21 (6)–(9), the springs as curved as they are. Validity: Straight walls."""
    _ = closing_spring.disc and closing_spring.deflection, control_spring.disc and control_spring.deflection
    return Balance(closing_spring, control_spring, pairs, net_gain_acting, 0.0, True)


def travel_moving(balance, friction):
    """Axial travel of the sleeve in balance off its stop, x.
    Source: S21 (6)–(9), the springs as curved as they are; by Newton's steps. Validity: f ≥ f_L."""
    return balance.travel(friction)


net_gain_there = Same("net_gain_acting")


def control_force_there(control_spring, travel_moving):
    """Force of the control spring where the sleeve is, F_2(x).
    Source: S21 (6)–(9), the springs as curved as they are. Validity: f ≥ f_L."""
    return control_spring.force(travel_moving)


def normal_force_moving(control_force_there, pairs, net_gain_there, friction):
    """Normal force with the sleeve off its stop, N = F_2(x)/(1 + zκf).
    Source: S21 (6)–(9), the springs as curved as they are. Validity: f ≥ f_L."""
    return control_force_there / (1 + pairs * net_gain_there * friction)


def constant_torque_slope(closing_spring, control_spring, pairs, friction_leaving, friction_max, closing_force):
    """Slope of the gain that gives equal torques at f_max and at f_L, C_1* with the secants of the springs.
    Source: Handbook, chapter 12. Validity: f_L > 0. With disc springs no slope holds the torque exactly."""
    slackened = closing_force * friction_leaving / larger(friction_max, friction_leaving * (1 + 1e-6))
    travel = closing_spring.slackens(slackened)
    springs = closing_spring.secant(-travel) + control_spring.secant(travel)
    return springs / (pairs * friction_leaving * closing_force)


def sleeve_stiffness_there(closing_spring, control_spring, pairs, friction_leaving, net_gain):
    """Stiffness against which the sleeve moves as it leaves its stop, D(f_L).
    Source: S21 (10), (11), in κ, with the slopes of the springs as set. Validity: κ ≥ 0."""
    closing = closing_spring.stiffness(0.0)
    return closing + control_spring.stiffness(0.0) + pairs * closing * friction_leaving * net_gain


def jumping_slope(sleeve_stiffness_there, pairs, friction_leaving, closing_force):
    """Slope above which the sleeve jumps off its stop as friction rises in slip, D(f_L)/(z f_L F_п1).
    Source: Handbook, chapter 12. Validity: f_L > 0."""
    return sleeve_stiffness_there / (pairs * friction_leaving * closing_force)


# behind curved walls


def _balance(closing_spring, control_spring, pairs, net_gain_acting, gain_slope):
    """Balance of the forces on a sleeve off its stop, N(x)(1 + zκ(x)f) = F_2(x), κ(x) = κ + C_1 x.
    Source: S21 (6)–(9), handbook, chapter 12, the springs as curved as they are. Validity: Walls that steepen along the
    travel."""
    _ = closing_spring.disc and closing_spring.deflection, control_spring.disc and control_spring.deflection
    return Balance(closing_spring, control_spring, pairs, net_gain_acting, gain_slope, False)


def _travel_returning(balance_at_returning, friction, travel_max):
    """Travel when friction falls from f_max under load; the last place that holds the sleeve.
    Source: Handbook, chapter 12. Validity: f ≤ f_max."""
    return balance_at_returning.travel_returning(friction, travel_max)


def _is_reseated(travel_returning, is_held_at_stop):
    """Condition that the sleeve is back at its stop.
    Source: Handbook, chapter 12. Validity: Friction falling, load kept."""
    return (travel_returning <= 0) & is_held_at_stop


def _net_gain_there(net_gain_acting, gain_slope, travel_moving):
    """Net gain where the sleeve is, κ(x) = κ + C_1 x.
    Source: Handbook, chapter 12. Validity: Walls that steepen along the travel."""
    return net_gain_acting + gain_slope * travel_moving


def _net_gain_back(net_gain_returning, gain_slope, travel_returning):
    """Net gain where the sleeve that moves back is, κ₊(x) = κ₊ + C_1 x.
    Source: Handbook, chapter 12. Validity: Walls that steepen along the travel."""
    return net_gain_returning + gain_slope * travel_returning


def _control_force_back(control_spring, travel_returning):
    """Force of the control spring where the sleeve that moves back is, F_2(x).
    Source: Handbook, chapter 12. Validity: Friction falling, load kept."""
    return control_spring.force(travel_returning)


def _normal_force_moving_back(control_force_back, pairs, net_gain_back, friction):
    """Normal force while the sleeve moves back, N = F_2(x)/(1 + zκ₊(x)f).
    Source: Handbook, chapter 12. Validity: Friction falling, load kept."""
    return control_force_back / (1 + pairs * net_gain_back * friction)


def _turns(balance, travel_start, travel_end, friction_low, friction_high, torque_high, arm):
    """Points of smallest and largest torque between two travels: (torque, friction) of each.
    Source: Handbook, chapter 12; the places are those where the slope of the torque changes its sign. Validity: At
    frictions within a range."""
    import numpy as np

    way = balance.way(travel_start + balance.nought, travel_end + balance.nought)  # a travel may have a smaller shape
    friction = np.asarray(balance.friction(way))
    torque = balance.pressed(way) * arm * friction
    inside = (friction >= friction_low * (1 - _ROUNDING)) & (friction <= friction_high * (1 + _ROUNDING))
    torque, friction = np.where(inside, torque, torque_high), np.where(inside, friction, friction_high)
    places = torque.argmin(axis=0)[None], torque.argmax(axis=0)[None]
    turns = [[np.take_along_axis(each, at, axis=0)[0] for each in (torque, friction)] for at in places]
    return [(one, two) if way.ndim > 1 else (float(one), float(two)) for one, two in turns]


def _turning_points(
    balance, travel_at_f_min, travel_max, friction_min, friction_max, torque_at_f_max, mean_radius, pairs
):
    """Points of smallest and largest torque while the sleeve moves.
    Source: Handbook, chapter 12. Validity: Friction rising from f_min to f_max."""
    arm = mean_radius * pairs
    return _turns(balance, travel_at_f_min, travel_max, friction_min, friction_max, torque_at_f_max, arm)


def _turning_points_from_mean(
    balance, travel_at_f_mean, travel_max, friction_mean, friction_max, torque_at_f_max, mean_radius, pairs
):
    """Points of smallest and largest torque while the sleeve moves, from the mean friction on.
    Source: Handbook, chapter 12. Validity: Friction rising from f_cp to f_max."""
    arm = mean_radius * pairs
    return _turns(balance, travel_at_f_mean, travel_max, friction_mean, friction_max, torque_at_f_max, arm)


def _points(torque_at_f_min, torque_at_leaving_in_range, turning_points, torque_at_f_max, friction_min,
            friction_leaving_in_range, friction_max):  # fmt: skip
    """Torques and frictions among which are the extremes, in the order of friction.
    Source: Handbook, chapter 12. Validity: Friction rising."""
    ends = (torque_at_f_min, friction_min), (torque_at_leaving_in_range, friction_leaving_in_range)
    return tuple(zip(*ends, *turning_points, (torque_at_f_max, friction_max), strict=True))


def _torque_min(extreme_points):
    """Smallest slip torque over the range. Source: Handbook, chapter 12. Validity: Friction rising."""
    return smaller(*extreme_points[0])


def _torque_max(extreme_points):
    """Largest slip torque over the range; of a jump the torque just before it.
    Source: Handbook, chapter 12. Validity: Friction rising."""
    return larger(*extreme_points[0])


def _friction_of_torque_min(extreme_points):
    """Friction where the torque is smallest. Source: Handbook, chapter 12. Validity: Of equal torques the first."""
    return place_of_smallest(*extreme_points)


def _friction_of_torque_max(extreme_points):
    """Friction where the torque is largest. Source: Handbook, chapter 12. Validity: Of equal torques the last."""
    return place_of_largest(*extreme_points)


def _torque_min_from_mean(torque_at_f_mean, torque_at_leaving_from_mean, turning_points_from_mean, torque_at_f_max):
    """Smallest slip torque from the mean friction on. Source: Handbook, chapter 12. Validity: Friction rising."""
    between = (point[0] for point in turning_points_from_mean)
    return smaller(torque_at_f_mean, torque_at_leaving_from_mean, *between, torque_at_f_max)


def _torque_max_from_mean(torque_at_f_mean, torque_at_leaving_from_mean, turning_points_from_mean, torque_at_f_max):
    """Largest slip torque from the mean friction on. Source: Handbook, chapter 12. Validity: Friction rising."""
    between = (point[0] for point in turning_points_from_mean)
    return larger(torque_at_f_mean, torque_at_leaving_from_mean, *between, torque_at_f_max)


def _torque_returning_turn(balance_at_returning, travel_max, travel_returning_at_f_min, friction_min, friction_max,
                           torque_at_f_max, mean_radius, pairs):  # fmt: skip
    """Smallest torque while the sleeve returns.
    Source: Handbook, chapter 12. Validity: Friction falling from f_max to f_min."""
    ends, arm = (travel_max, travel_returning_at_f_min), mean_radius * pairs
    return _turns(balance_at_returning, *ends, friction_min, friction_max, torque_at_f_max, arm)[0][0]


def _torque_returning_min(torque_returning_at_f_min, torque_returning_at_unlocking, travel_max, torque_returning_turn):
    """Smallest slip torque, friction falling from f_max under load.
    Source: Handbook, chapter 12. Validity: A sleeve that f_max leaves at its stop does not return: the stop still bears
    a part of the control spring."""
    least = smaller(torque_returning_at_f_min, torque_returning_at_unlocking)
    return chosen(travel_max > 0, lambda: smaller(least, torque_returning_turn), lambda: least)


NO_DISC = {"closing_disc": None, "control_disc": None}
"""One of the springs may be straight."""

CURVED = {
    "balance": _balance, "travel_returning": _travel_returning, "is_reseated": _is_reseated,
    "net_gain_there": _net_gain_there, "net_gain_back": _net_gain_back, "control_force_back": _control_force_back,
    "normal_force_moving_back": _normal_force_moving_back,
    "normal_force_let_go": Either("is_reseated", "normal_force_seated_at_returning", "normal_force_moving_back"),
    "turning_points": _turning_points, "turning_points_from_mean": _turning_points_from_mean, "extreme_points": _points,
    "torque_min": _torque_min, "torque_max": _torque_max, "friction_of_torque_min": _friction_of_torque_min,
    "friction_of_torque_max": _friction_of_torque_max, "torque_min_from_mean": _torque_min_from_mean,
    "torque_max_from_mean": _torque_max_from_mean, "torque_returning_turn": _torque_returning_turn,
    "torque_returning_min": _torque_returning_min,
}  # fmt: skip
