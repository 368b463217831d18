"""Indirect regulation (S21; handbook, chapter 5), from the balance of the thrust sleeve."""

import pytest
import sympy as sp
from proofs.symbols import *

from afmcalc.equations import accuracy, direct, indirect, sleeve

KAPPA = indirect.net_gain(C, indirect.gain_threshold(R, fk, d))
CONTROL = indirect.control_force_set(F, z, KAPPA, fset)
"""F_п2 that S21 (14) sets."""


def _stiffness(friction, kappa=KAPPA):
    return indirect.sleeve_stiffness(c1, c2, z, friction, kappa)


def _torque(travel, friction):
    """(9)."""
    return indirect.torque(F - c1 * travel, R, z, friction)


def _balance(control, friction, key_sign):
    """(6)–(8): F_п1 − c_1 x + T tan α/r ∓ 2 T f_1/d − F_п2 − c_2 x with tan α = C r/R."""
    torque = _torque(x, friction)
    return F - c1 * x + torque * (C * r / R) / r + key_sign * 2 * torque * fk / d - control - c2 * x


def _travel(control, key_sign=-1):
    return solved(_balance(control, f, key_sign), x)


def setting_of_the_control_spring():
    """S21 (14) from (1)–(4), (13); C from it is (5)."""
    nominal = indirect.torque(F, R, z, fset)
    yield "(1): the sleeve just rests at T_н", F + nominal * C / R - CONTROL - 2 * nominal * fk / d
    yield "T_н/F_п1 at the setting", indirect.torque_per_force(z, R, fset) - nominal / F
    yield "(14)", CONTROL - (F * (1 + z * C * fset) - 2 * z * F * R * fset * fk / d)
    gain = 2 * R * fk / d + (CONTROL - F) / (z * F * fset)
    yield "(5)", gain - C
    yield "(2), (13): F_p,min = z F_п1 C f_min", indirect.release_force(nominal, C, R) - z * F * C * fset
    yield "(3), (8)", indirect.key_friction_force(nominal, fk, d) - 2 * nominal * fk / d
    yield "S = 0 at T_н", indirect.stop_reaction_seated(CONTROL, F, nominal, KAPPA, R)
    yield "F_p = T tan α/r", indirect.release_force(nominal, R * q / r, R) - nominal * q / r


def travel_and_torque_from_the_balance():
    """S21 (10), (11), (16) from (6)–(9), (14)."""
    moved = _travel(F2)
    printed_d = (1 + z * C * f) * c1 + c2 - 2 * z * R * c1 * f * fk / d
    yield "D(f)", _stiffness(f) - printed_d
    yield "(10)", moved - ((1 + z * C * f) * F - F2 - 2 * z * F * R * f * fk / d) / printed_d
    yield "(11)", _torque(moved, f) - z * R * f * (F * c2 + F2 * c1) / printed_d
    normal = symbolic(indirect.normal_force_moving)(F, c1, F2, c2, _stiffness(f))
    yield "(9): N = F_п1 − c_1 x", normal - (F - c1 * moved)
    key = indirect.key_friction_force(_torque(moved, f), fk, d)
    balls = indirect.release_force(_torque(moved, f), C, R)
    yield "(6) with (7), (8)", F - c1 * moved + balls - F2 - c2 * moved - key
    tensed = sleeve.tensed_force(F2, c2, moved)
    yield "(9), (10): N = F_2/(1 + zκf)", indirect.normal_force_seated(tensed, z, KAPPA, f) - normal
    set_travel = _travel(CONTROL)
    yield "(16)", indirect.travel_as_set(z, F, f, fset, KAPPA, _stiffness(f)) - set_travel
    yield "(12): no dip, x(f_set) = 0", set_travel.subs(f, fset)


def sleeve_at_its_stop():
    """S21, text of fig. 1: the stop belongs to the pressure disc, so below the setting both springs press."""
    reaction, pressed = sp.symbols("S N", real=True)
    torque = indirect.torque(pressed, R, z, f)
    # the sleeve: spring 11 against the balls' force less the key's friction, and the stop's reaction
    sleeve = F2 - F - (torque * C / R - 2 * torque * fk / d) - reaction
    disc = F + reaction - pressed
    found = sp.solve([sleeve, disc], [reaction, pressed], dict=True)[0]
    seated = indirect.normal_force_seated(F2, z, KAPPA, f)
    yield "N = F_п2/(1 + zκf)", seated - found[pressed]
    yield "at rest the pack carries F_п2", seated.subs(f, 0) - F2
    yield "S = 0 just at the setting", found[reaction].subs({F2: CONTROL, f: fset})
    at_set = indirect.normal_force_seated(CONTROL, z, KAPPA, fset)
    moving = symbolic(indirect.normal_force_moving)(F, c1, CONTROL, c2, _stiffness(fset))
    yield "both branches meet at f_set", at_set - moving
    own = indirect.torque(seated, R, z, f)
    yield "S = F_п2 − F_п1 − T κ/R", indirect.stop_reaction_seated(F2, F, own, KAPPA, R) - found[reaction]
    yield "a direct clutch with spring F_п2 and gain κ", own - direct.torque(F2, R, 0, z, KAPPA, f, f)
    yield "(10)", indirect.travel_as_made(F, F2, z, f, KAPPA, _stiffness(f)) - _travel(F2)
    yield Refutation("not an ordinary clutch with F_п1", seated.subs(F2, CONTROL) - F)


def accuracy_of_the_indirect_clutch():
    """S21 (15) mended (M9), with f_set = f_min and above it."""

    def torque(friction):
        return _torque(_travel(CONTROL), f).subs(f, friction)

    own = accuracy_as_set(fmin, fset, fmax, c1, c2, z, KAPPA)
    at_stop = indirect.torque(indirect.normal_force_seated(CONTROL, z, KAPPA, fmin), R, z, fmin)
    yield "K_т with the sleeve at its stop below f_set", own - torque(fmax) / at_stop
    direct_clutch = accuracy.accuracy_factor_of_path(0, z, KAPPA, fmin, fmin, fmax, fmax)
    yield "f_set → f_max: a direct clutch of gain κ", own.subs(fset, fmax) - direct_clutch
    printed_set = {fset: fmin}
    yield "(15) mended: f_set = f_min", own.subs(printed_set) - (torque(fmax) / torque(fmin)).subs(printed_set)
    d_min, d_max = (c2 + (1 + z * C * a) * c1 - 2 * z * R * c1 * a * fk for a in (fmin, fmax))
    yield Refutation("M9: printed (15) without d", own.subs(printed_set) - fmax * d_min / (fmin * d_max))


def friction_at_the_key():
    """The threshold 2 R f_1/d, κ and κ₊."""
    threshold = indirect.gain_threshold(R, fk, d)
    yield "κ = 0 at the threshold", KAPPA.subs(C, threshold)
    yield "κ = C − 2 R f_1/d", KAPPA - (C - 2 * R * fk / d)
    yield "κ₊ = C + 2 R f_1/d", indirect.net_gain_returning(C, indirect.gain_threshold(R, fk, d)) - (C + 2 * R * fk / d)
    ordinary = accuracy_as_set(fmin, fset, fmax, c1, c2, z, KAPPA.subs(C, threshold))
    yield "an ordinary clutch there", ordinary - fmax / fmin
    yield "κ₊/κ", indirect.hysteresis_ratio(q, C) - C / q


@pytest.mark.slow
def sleeve_returning():
    """Chapter 5: with the key's friction reversed κ₊ replaces κ; the sleeve is locked until f fell κ₊/κ times."""
    kappa_back = indirect.net_gain_returning(C, indirect.gain_threshold(R, fk, d))
    back = _torque(_travel(CONTROL, key_sign=+1), f)
    normal = symbolic(indirect.normal_force_moving)(F, c1, CONTROL, c2, _stiffness(f, kappa_back))
    yield "T on the way back", indirect.torque(normal, R, z, f) - back
    rising = _torque(_travel(CONTROL), f)
    yield "lower by D_κ/D_κ₊", back / rising - _stiffness(f) / _stiffness(f, kappa_back)
    back_at_stop = indirect.normal_force_seated(CONTROL, z, kappa_back, f) - F
    yield "seated again at f_set κ/κ₊", back_at_stop.subs(f, fset * KAPPA / kappa_back)
    hysteresis = accuracy.accuracy_factor(rising.subs(f, fmax), back)
    yield "K_т,h = T(f_max)/T_ret", hysteresis - rising.subs(f, fmax) / back
    start = f * KAPPA / kappa_back
    yield "it starts where f has fallen by κ₊/κ", _travel(CONTROL, key_sign=+1).subs(f, start) - _travel(CONTROL)


def equivalent_to_all_driving():
    """The indirect clutch has the torque curve of an all-driving one with C_eff = κ c_1/(c_1 + c_2)."""
    equivalent = indirect._equivalent_gain(KAPPA, c1, c2)
    raised = F * (1 + z * equivalent * fset)
    yield "T(f)", _torque(_travel(CONTROL), f) - direct.torque(raised, R, 0, z, equivalent, f, f)
    own = accuracy_as_set(fmin, fmin, fmax, c1, c2, z, KAPPA)
    yield "K_т", own - accuracy.accuracy_factor_of_path(0, z, equivalent, fmin, fmin, fmax, fmax)


def signs_of_the_derivatives():
    """S21: ∂K_т/∂c_1 < 0 (0 if c_2 = 0), ∂K_т/∂C < 0, ∂K_т/∂c_2 > 0, for κ > 0 (K_т falls with C_eff)."""
    factor = accuracy.accuracy_factor_of_path(0, z, q, fmin, fmin, fmax, fmax)
    in_gain = -z * fmax * (fmax - fmin) / (fmin * (1 + z * q * fmax) ** 2)
    yield "∂K_т/∂C_eff < 0", sp.diff(factor, q) - in_gain
    equivalent = indirect._equivalent_gain(q, c1, c2)
    yield "∂C_eff/∂c_1 > 0, 0 if c_2 = 0", sp.diff(equivalent, c1) - q * c2 / (c1 + c2) ** 2
    yield "∂C_eff/∂c_2 < 0", sp.diff(equivalent, c2) + q * c1 / (c1 + c2) ** 2
    yield "∂C_eff/∂κ > 0", sp.diff(equivalent, q) - c1 / (c1 + c2)


def load_capacity_against_the_base_clutch():
    """S21: K_п = 1 + z C f_min against the base clutch with all pairs controlled; with one bypass pair not (M38)."""
    own = indirect.torque(F, R, z, fset)
    ratio, base = indirect.nominal_torque_ratio(z, C, fset, 1, 1), direct.torque(F, R, 0, z, C, fset, fset)
    yield "K_п", ratio - own / base
    pressed = indirect.nominal_torque_ratio(z, C, fset, F2, F)
    yield "K_п with N(f_set) = F_2", pressed - indirect.torque(F2, R, z, fset) / base
    first_generation = own / direct.torque(F, R, 1, z - 1, C, fset, fset)
    yield Refutation("M38: the base clutch of F11 has one bypass pair", ratio - first_generation)
    yield "M38: against it K_п is 1 + (z − 1) C f_min", first_generation - (1 + (z - 1) * C * fset)


def base_clutch_is_more_accurate():
    """S21 conclusion 1 (M26): K_ind − K_base = z f_max (f_max − f_min)(C c_2 + 2 c_1 R f_1/d)/[…] > 0."""
    own = accuracy_as_set(fmin, fmin, fmax, c1, c2, z, KAPPA)
    base = accuracy.accuracy_factor_of_path(0, z, C, fmin, fmin, fmax, fmax)
    difference = z * fmax * (fmax - fmin) * (C * c2 + 2 * c1 * R * fk / d)
    difference /= fmin * (1 + z * C * fmax) * _stiffness(fmax)
    yield "M26", own - base - difference


def spring_mass_argument():
    """S21 (M27): both springs together are F_п1 (1 + K_п − 2 z R f_min f_1/d)."""
    both = F + indirect.control_force_set(F, z, KAPPA, fmin)
    ratio = indirect.nominal_torque_ratio(z, C, fmin, 1, 1)
    yield "M27", both - F * (1 + ratio - 2 * z * R * fmin * fk / d)


def travel_stays_within_the_spring():
    """x < F_п1/c_1: what is left of the spring force, F_п1 − c_1 x, is positive for κ ≥ 0."""
    moved = indirect.travel_as_set(z, F, f, fset, q, _stiffness(f, q))
    left = F * (c1 + c2 + z * c1 * fset * q) / _stiffness(f, q)
    yield "F_п1 − c_1 x = F_п1 D(f_set)/D(f)", F - c1 * moved - left
