"""Laws of a sleeve between disc springs; ``engines.balance`` finds the equilibrium numerically.

They replace the laws of ``equations.indirect`` and ``equations.curved`` that assume linear springs.
"""

from ..equations.arrays import larger
from ..equations.wiring import Same
from .balance import Balance
from .characteristics import SetSpring


def closing_spring(closing_force, closing_stiffness, closing_disc):
    """Closing spring as set.
    Source: DIN EN 16984 for disc springs, F = F_п1 + c_1 x for a linear one. Validity: That of the spring law."""
    return SetSpring(closing_force, closing_stiffness, closing_disc)


def control_spring(control_force, control_stiffness, control_disc):
    """Control spring as set.
    Source: DIN EN 16984 for disc springs, F = F_п2 + c_2 x for a linear one. Validity: That of the spring law."""
    return SetSpring(control_force, control_stiffness, control_disc)


def balance(closing_spring, control_spring, pairs, net_gain_acting):
    """Balance of the forces on a sleeve off its stop, N(x)(1 + zκf) = F_2(x).
    Source: S21 (6)–(9), with the curved characteristics of the springs. Validity: Straight walls."""
    _ = closing_spring.disc and closing_spring.deflection, control_spring.disc and control_spring.deflection
    return Balance(closing_spring, control_spring, pairs, net_gain_acting, 0.0, True)


def travel_moving(balance, friction):
    """Axial travel of the sleeve in balance off its stop, x.
    Source: S21 (6)–(9), with the curved characteristics of the springs; by Newton's method. Validity: f ≥ f_L."""
    return balance.travel(friction)


net_gain_there = Same("net_gain_acting")


def control_force_there(control_spring, travel_moving):
    """Force of the control spring at the travel of the sleeve, F_2(x).
    Source: S21 (6)–(9), with the curved characteristics of the springs. Validity: f ≥ f_L."""
    return control_spring.force(travel_moving)


def normal_force_moving(control_force_there, pairs, net_gain_there, friction):
    """Normal force with the sleeve off its stop, N = F_2(x)/(1 + zκf).
    Source: S21 (6)–(9), with the curved characteristics of the springs. Validity: f ≥ f_L."""
    return control_force_there / (1 + pairs * net_gain_there * friction)


def constant_torque_slope(closing_spring, control_spring, pairs, friction_leaving, friction_max, closing_force):
    """Slope of the gain that gives equal torques at f_max and at f_L, C_1* with the secant stiffnesses of the springs.
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


NO_DISC = {"closing_disc": None, "control_disc": None}
"""Default values: a spring that is linear while the other one has disc springs has no disc."""
