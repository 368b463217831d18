"""Laws of a sleeve between disc springs behind curved walls; for straight walls see ``disc_balance``."""

import numpy as np

from ..equations.arrays import chosen, larger, place_of_largest, place_of_smallest, smaller
from ..equations.wiring import Either
from .balance import Balance

_ROUNDING = 1e-12


def balance(closing_spring, control_spring, pairs, net_gain_acting, gain_slope):
    """Balance of the forces on a sleeve off its stop, N(x)(1 + zκ(x)f) = F_2(x), κ(x) = κ + C_1 x.
    Source: S21 (6)–(9), handbook, chapter 12, with the curved characteristics of the springs. Validity: Walls that
    steepen along the travel."""
    _ = closing_spring.disc and closing_spring.deflection, control_spring.disc and control_spring.deflection
    return Balance(closing_spring, control_spring, pairs, net_gain_acting, gain_slope, False)


def travel_returning(balance_at_returning, friction, travel_max):
    """Travel when friction falls from f_max under load: the largest equilibrium.
    Source: Handbook, chapter 12. Validity: f ≤ f_max."""
    return balance_at_returning.travel_returning(friction, travel_max)


def is_reseated(travel_returning, is_held_at_stop):
    """Condition that the sleeve is back at its stop.
    Source: Handbook, chapter 12. Validity: Friction falling, load kept."""
    return (travel_returning <= 0) & is_held_at_stop


normal_force_let_go = Either("is_reseated", "normal_force_seated_at_returning", "normal_force_moving_back")


def net_gain_there(net_gain_acting, gain_slope, travel_moving):
    """Net gain where the sleeve is, κ(x) = κ + C_1 x.
    Source: Handbook, chapter 12. Validity: Walls that steepen along the travel."""
    return net_gain_acting + gain_slope * travel_moving


def net_gain_back(net_gain_returning, gain_slope, travel_returning):
    """Net gain of a sleeve that moves back, κ₊(x) = κ₊ + C_1 x.
    Source: Handbook, chapter 12. Validity: Walls that steepen along the travel."""
    return net_gain_returning + gain_slope * travel_returning


def control_force_back(control_spring, travel_returning):
    """Force of the control spring while the sleeve moves back, F_2(x).
    Source: Handbook, chapter 12. Validity: Friction falling, load kept."""
    return control_spring.force(travel_returning)


def normal_force_moving_back(control_force_back, pairs, net_gain_back, friction):
    """Normal force while the sleeve moves back, N = F_2(x)/(1 + zκ₊(x)f).
    Source: Handbook, chapter 12. Validity: Friction falling, load kept."""
    return control_force_back / (1 + pairs * net_gain_back * friction)


def _turns(balance, travel_start, travel_end, friction_low, friction_high, torque_high, arm):
    """Points of smallest and largest torque between two travels: (torque, friction) of each.
    Source: Handbook, chapter 12; the places are those where the slope of the torque changes its sign. Validity: At
    frictions within a range."""
    way = balance.way(travel_start + balance.nought, travel_end + balance.nought)  # + nought: both get the full shape
    friction = np.asarray(balance.friction(way))
    torque = balance.pressed(way) * arm * friction
    inside = (friction >= friction_low * (1 - _ROUNDING)) & (friction <= friction_high * (1 + _ROUNDING))
    torque, friction = np.where(inside, torque, torque_high), np.where(inside, friction, friction_high)
    places = torque.argmin(axis=0)[None], torque.argmax(axis=0)[None]
    turns = [[np.take_along_axis(each, at, axis=0)[0] for each in (torque, friction)] for at in places]
    return [(one, two) if way.ndim > 1 else (float(one), float(two)) for one, two in turns]


def turning_points(
    balance, travel_at_f_min, travel_max, friction_min, friction_max, torque_at_f_max, mean_radius, pairs
):
    """Points (torque, friction) of smallest and largest torque while the sleeve moves.
    Source: Handbook, chapter 12. Validity: Friction rising from f_min to f_max."""
    arm = mean_radius * pairs
    return _turns(balance, travel_at_f_min, travel_max, friction_min, friction_max, torque_at_f_max, arm)


def turning_points_from_mean(
    balance, travel_at_f_mean, travel_max, friction_mean, friction_max, torque_at_f_max, mean_radius, pairs
):
    """Points (torque, friction) of smallest and largest torque while the sleeve moves, from the mean friction on.
    Source: Handbook, chapter 12. Validity: Friction rising from f_cp to f_max."""
    arm = mean_radius * pairs
    return _turns(balance, travel_at_f_mean, travel_max, friction_mean, friction_max, torque_at_f_max, arm)


def extreme_points(torque_at_f_min, torque_at_leaving_in_range, turning_points, torque_at_f_max, friction_min,
            friction_leaving_in_range, friction_max):  # fmt: skip
    """Torques and frictions, two tuples, of all possible extremes, in the order of friction.
    Source: Handbook, chapter 12. Validity: Friction rising."""
    ends = (torque_at_f_min, friction_min), (torque_at_leaving_in_range, friction_leaving_in_range)
    return tuple(zip(*ends, *turning_points, (torque_at_f_max, friction_max), strict=True))


def torque_min(extreme_points):
    """Smallest slip torque over the range. Source: Handbook, chapter 12. Validity: Friction rising."""
    return smaller(*extreme_points[0])


def torque_max(extreme_points):
    """Largest slip torque over the range; where the torque jumps, the value just before the jump counts.
    Source: Handbook, chapter 12. Validity: Friction rising."""
    return larger(*extreme_points[0])


def friction_of_torque_min(extreme_points):
    """Friction where the torque is smallest. Source: Handbook, chapter 12. Validity: Of equal torques the first."""
    return place_of_smallest(*extreme_points)


def friction_of_torque_max(extreme_points):
    """Friction where the torque is largest. Source: Handbook, chapter 12. Validity: Of equal torques the last."""
    return place_of_largest(*extreme_points)


def torque_min_from_mean(torque_at_f_mean, torque_at_leaving_from_mean, turning_points_from_mean, torque_at_f_max):
    """Smallest slip torque from the mean friction on. Source: Handbook, chapter 12. Validity: Friction rising."""
    between = (point[0] for point in turning_points_from_mean)
    return smaller(torque_at_f_mean, torque_at_leaving_from_mean, *between, torque_at_f_max)


def torque_max_from_mean(torque_at_f_mean, torque_at_leaving_from_mean, turning_points_from_mean, torque_at_f_max):
    """Largest slip torque from the mean friction on. Source: Handbook, chapter 12. Validity: Friction rising."""
    between = (point[0] for point in turning_points_from_mean)
    return larger(torque_at_f_mean, torque_at_leaving_from_mean, *between, torque_at_f_max)


def torque_returning_turn(balance_at_returning, travel_max, travel_returning_at_f_min, friction_min, friction_max,
                           torque_at_f_max, mean_radius, pairs):  # fmt: skip
    """Smallest torque while the sleeve returns.
    Source: Handbook, chapter 12. Validity: Friction falling from f_max to f_min."""
    ends, arm = (travel_max, travel_returning_at_f_min), mean_radius * pairs
    return _turns(balance_at_returning, *ends, friction_min, friction_max, torque_at_f_max, arm)[0][0]


def torque_returning_min(torque_returning_at_f_min, torque_returning_at_unlocking, travel_max, torque_returning_turn):
    """Smallest slip torque, friction falling from f_max under load.
    Source: Handbook, chapter 12. Validity: A sleeve still at its stop at f_max does not return: the stop bears a part
    of the control spring."""
    least = smaller(torque_returning_at_f_min, torque_returning_at_unlocking)
    return chosen(travel_max > 0, lambda: smaller(least, torque_returning_turn), lambda: least)
