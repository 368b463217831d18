"""Pockets whose wall steepens along the travel (handbook, chapter 12), from the balance of the thrust sleeve."""

import sympy as sp
from proofs.symbols import *

from afmcalc.equations import curved, indirect

X = positive("x")
KAPPA, SLOPE = positive("kappa C_1")
HOLDING = indirect.constant_torque_slope(c1, c2, z, fset, F)
CONTROL = indirect.control_force_set(F, z, KAPPA, fset)
W = curved.slope_feedback(z, f, SLOPE)
D = indirect.sleeve_stiffness(c1, c2, z, f, KAPPA)


def _balance(travel):
    """Force on the sleeve off its stop, N + T κ(x)/R − F_п2 − c_2 x, with N = F_п1 − c_1 x and T = z R f N."""
    pressed = F - c1 * travel
    torque = indirect.torque(pressed, R, z, f)
    return pressed + torque * curved.gain_acting(KAPPA, SLOPE, travel) / R - F2 - c2 * travel


K_SQUARED = curved.tangent_stiffness_squared(F, c1, F2, c2, D, W)


def _at_root(expression, k):
    """Numerator of an expression in k_t where k_t² is what it is."""
    return sp.rem(sp.numer(sp.together(expression)), k**2 - K_SQUARED, k)


def curved_pocket_balance():
    """The travel is the larger root of a quadratic; N by way of a stiffness in the place of D(f)."""
    key = indirect.gain_threshold(R, fk, d)
    net = indirect.net_gain(curved.gain_acting(C, SLOPE, X), indirect.gain_threshold(R, fk, d))
    yield "κ(x) = κ_0 + C_1 x", net - curved.gain_acting(C - key, SLOPE, X)
    stiffness = curved.sleeve_stiffness_curved(D, F, W, sp.sqrt(K_SQUARED))
    normal = symbolic(indirect.normal_force_moving)(F, c1, F2, c2, stiffness)
    found = curved.travel_moving(F, normal, c1)
    yield "F_п1 − c_1 x = N", F - c1 * found - normal
    k = positive("k")
    at_k = curved.travel_moving(
        F, symbolic(indirect.normal_force_moving)(F, c1, F2, c2, curved.sleeve_stiffness_curved(D, F, W, k)), c1
    )
    yield "the sleeve is in balance", _at_root(_balance(at_k), k)
    constant, linear, square = (sp.Poly(-_balance(X), X).coeff_monomial(X**power) for power in range(3))
    yield "a = z f c_1 C_1", square - c1 * W
    yield "b = D − w F_п1", linear - (D - W * F)
    yield "k_t² = b² + 4 a g", K_SQUARED - linear**2 + 4 * square * constant
    # −∂(balance)/∂x at the root is k_t itself, not −k_t: the larger root, where the balance pushes back
    there = -sp.diff(_balance(X), X).subs(X, at_k)
    yield "k_t is the stiffness of the balance", _at_root(there - k, k)
    straight = curved.sleeve_stiffness_curved(D, F, 0, D)
    yield "C_1 = 0 is the straight pocket", straight - D
    yield "and its k_t is D", curved.tangent_stiffness_squared(F, c1, F2, c2, D, 0) - D**2


def curved_pocket_holds_the_torque():
    """C_1* = (c_1 + c_2)/(z f_L F_п1): T = T_н for every f above f_L; x = (F_п1/c_1)(1 − f_L/f) whatever the gain."""
    yield "f_L is f_set where (14) sets the control spring", indirect.friction_leaving_made(CONTROL, F, z, KAPPA) - fset
    leaving = indirect.friction_leaving_made(F2, F, z, KAPPA)
    at_stop = indirect.normal_force_seated(F2, z, KAPPA, leaving)
    yield "the pack is pressed by F_п1 alone there", at_stop - F
    best = indirect.constant_torque_slope(c1, c2, z, leaving, F)
    travel = F / c1 * (1 - leaving / f)
    yield "x in balance", _balance(travel).subs(SLOPE, best)
    yield "T = z R f_L F_п1", indirect.torque(F - c1 * travel, R, z, f) - z * R * leaving * F
    held = F / c1 * (1 - fset / f)
    yield "the same with f_set", _balance(held).subs({SLOPE: HOLDING, F2: CONTROL})
    # in general T = R S(x)/κ(x), of which the sign of the slope is that of c_1 + c_2 − C_1 z f_set F_п1
    spring = CONTROL - F + (c1 + c2) * X
    torque = R * spring / curved.gain_acting(KAPPA, SLOPE, X)
    turned = sp.diff(torque, X) * curved.gain_acting(KAPPA, SLOPE, X) ** 2 / (R * KAPPA)
    yield "∂T/∂x falls with C_1 through C_1*", turned - z * fset * F * (HOLDING - SLOPE)
    yield Refutation("another slope does not hold it", turned.subs(SLOPE, 2 * HOLDING))


def curved_pocket_jumps():
    """Where b is 0 at the stop: beyond that slope the smallest travel is unstable."""
    at_leaving = indirect.sleeve_stiffness(c1, c2, z, fset, KAPPA)
    jumping = indirect.jumping_slope(at_leaving, z, fset, F)
    stiffness = -sp.diff(_balance(X), X).subs({X: 0, f: fset, F2: CONTROL})
    yield "the balance is neutral at the stop", stiffness.subs(SLOPE, jumping)
    yield "above C_1* by c_1 κ/F_п1", jumping - HOLDING - c1 * KAPPA / F
    # a clutch that still holds, under a torque T: S(x) − T κ(x)/R, no pack in it
    held, torque = CONTROL - F + (c1 + c2) * X, z * R * fset * F
    pushed = sp.diff(torque * curved.gain_acting(KAPPA, SLOPE, X) / R - held, X)
    yield "holding at T_н it is neutral at C_1*", pushed.subs(SLOPE, HOLDING)
