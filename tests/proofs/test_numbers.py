"""Numbers the papers print, and what they leave out, in exact fractions (handbook, chapters 4–8); of arrays in floats."""

import math

import numpy as np
import sympy as sp
from proofs.symbols import *

from afmcalc.equations import (
    adjustment,
    control_unit,
    curved,
    curved_wall,
    direct,
    indirect,
    life,
    overload,
    pressure,
    unlike,
)

RATIONAL = sp.Rational


def numbers_of_s19():
    """S19, the example and fig. 2 (M7, M8, M22, M24, M25, M44, M45)."""

    def threshold(gain):
        return adjustment._pairs_threshold(1, gain, RATIONAL(15, 100), RATIONAL(33, 100), RATIONAL(5, 4))

    yield "P1: z > 8.197 with C = 1.6", threshold(RATIONAL(8, 5)) - RATIONAL(1082, 132)
    yield "M7: the printed 9.23 is C = 1.4", sp.Integer(round(threshold(RATIONAL(7, 5)) * 1000)) - 9225
    yield Refutation("M7: not C = 1.6", sp.Integer(round(threshold(RATIONAL(8, 5)) * 100)) - 923)

    def cycles(low, high):
        mean = life.mean_stress(*(life.shear_stress(torque, RATIONAL(15, 10**6)) for torque in (low, high)))
        return life.cycles_of_line(10**7, 400 * 10**6, mean, 6)

    def band(scatter):
        return life.cycles_of_band(400 * 10**6, RATIONAL(15, 10**6), 200, scatter, 6, 10**7)

    yield "P2: (1500/900)^6", band(500) / band(1100) - RATIONAL(5, 3) ** 6
    yield "M45: from ΔT = 0 it would be (1500/400)^6, 2781", band(0) / band(1100) - RATIONAL(15, 4) ** 6
    for high, ratio in ((700, RATIONAL(13, 9)), (1300, RATIONAL(19, 15))):
        fall = cycles(200, high) / cycles(600, high)
        yield f"P3, M8: N falls by the 6th power of {ratio}", fall - ratio**6
        yield Refutation("M8: it is not the ratio of mean torques", fall - ratio)
    yield (
        "M44: 1.44, the ratio of mean torques, has curve 1 at the T_min of a",
        life.mean_stress(600, 700) / life.mean_stress(200, 700) - RATIONAL(13, 9),
    )
    stress = life.mean_stress(*(life.shear_stress(torque, RATIONAL(15, 10**6)) for torque in (200, 1300)))
    yield "M22: the stress of fig. 2 is at most 50 MPa", stress - 50 * 10**6
    yield "M22: N/N_0 there is 8^6", cycles(200, 1300) / 10**7 - 8**6
    factor, first, second = positive("k dT_1 dT_2")
    yield "M24: one factor keeps the order of the bands", factor * first / (factor * second) - first / second
    bands = [adjustment._scatter_of_one_material(force, R, z, z - 1, C, fmin, fmax) for force in (F, q * F)]
    least = [direct.torque(force, R, 1, z - 1, C, fmin, fmin) for force in (F, q * F)]
    yield "M25: T_min2/T_min1 = ΔT_2/ΔT_1", least[1] / least[0] - bands[1] / bands[0]
    yield "M25: T_min2 = 200·627/500", RATIONAL(200 * 627, 500) - RATIONAL(2508, 10)


def numbers_of_s21():
    """S21, what its gain in capacity costs (M27) and the sleeve in slip (M48), with the data of fig. 2."""
    kappa, back = (
        gain(C, indirect.gain_threshold(R, fk, d)) for gain in (indirect.net_gain, indirect.net_gain_returning)
    )
    control = indirect.control_force_set(F, z, kappa, fmin)
    nominal = indirect.torque(F, R, z, fmin)
    data = {C: 1, z: 8, R: RATIONAL(1, 10), d: RATIONAL(1, 20), fk: RATIONAL(15, 100), fmin: RATIONAL(1, 10)}
    yield (
        "M27: T_н is that of a direct clutch with spring F_п2 and gain κ",
        nominal - direct.torque(control, R, 0, z, kappa, fmin, fmin),
    )
    same_pack = nominal / direct.torque(control, R, 0, z, C, fmin, fmin)
    at_one = same_pack.subs(data)
    yield "M27: capacity at equal force on the pack", same_pack - (1 + z * C * fmin) / (1 + z * kappa * fmin)
    yield "M27: 1.364 at C = 1", sp.Integer(round(at_one * 1000)) - 1364
    yield Refutation("M27: not K_п = 1.8", at_one - indirect.nominal_torque_ratio(z, C, fmin, 1, 1).subs(data))
    yield "M27: both springs are 2.32 F_п1", (control / F + 1).subs(data) - RATIONAL(232, 100)

    # the sleeve held at x, where it came to at f_max: what the key bears at a lower f
    held = F - x
    reached = held + indirect.torque(held, R, z, fmax) * kappa / R
    torque = indirect.torque(held, R, z, f)
    share = (held + indirect.release_force(torque, C, R) - reached) / (2 * torque * fk / d)
    yield "M48: share of the key's friction", share - (C - kappa * fmax / f) / (2 * R * fk / d)
    yield "M48: 1 at f_max", share.subs(f, fmax) - 1
    yield "M48: −1 at f_max κ/κ₊, where the sleeve returns", share.subs(f, fmax * kappa / back) + 1
    yield "M48: 4 times at C = 1", indirect.hysteresis_ratio(kappa, back).subs(data) - 4


def numbers_of_s22():
    """S22, figs 3 and 4 and what is concluded from them (M14, M30, M46, M49–M51), f 0.1…0.8, β_н 1.25."""
    low, high, margin = RATIONAL(1, 10), RATIONAL(8, 10), RATIONAL(5, 4)

    def factor(reduced):
        return overload.actuation_factor(reduced * high, reduced * low, high, low, margin)

    yield "P9: A = 3 at zC = 5", factor(sp.Integer(5)) - 3
    yield "M14: A = 1 for z_1 = 2", factor(RATIONAL(5, 4)) - 1
    for reduced, thousandths in ((RATIONAL(8, 5), 1225), (RATIONAL(5, 12), 419)):
        yield "M14: A for z_1 = 1, 3", sp.Integer(round(factor(reduced) * 1000)) - thousandths
    yield Refutation("M30: zC = 5 and zC = 1.6 are two lines", factor(sp.Integer(5)) - factor(RATIONAL(8, 5)))
    expected = overload.expected_torque(1, 1, 1, high, q * high) / overload.expected_torque(1, 1, 1, low, q * low)
    published = sp.together(factor(q) * expected)
    for bypass, actual in ((1, RATIONAL(133, 20)), (2, RATIONAL(9, 2)), (3, RATIONAL(25, 4))):
        reduced = (4 - bypass) * direct._gain_limit_breakaway(bypass, high)
        larger = sp.Max(1, factor(reduced))
        yield f"M46: actual K_т for z_1 = {bypass}, C by (24)", larger * expected.subs(q, reduced) - actual
    fifth = RATIONAL(1, 5)
    at_fifth = overload.actuation_factor(5 * fifth, 5 * low, fifth, low, margin)
    yield "M49: T_ср is the expected torque at f = 0.2, zC = 5", at_fifth - 1
    rise = overload.expected_torque(1, 1, 1, fifth, 5 * fifth) / overload.expected_torque(1, 1, 1, low, 5 * low)
    yield Refutation("M49: and not the nominal one", at_fifth * rise - 1)
    for pairs, of_expected, of_actual in (
        (4, RATIONAL(11, 4), RATIONAL(133, 20)),
        (8, RATIONAL(15, 8), RATIONAL(333, 40)),
    ):
        reduced = (pairs - 1) * direct._gain_limit_breakaway(1, high)
        yield f"M50: expected K_т, z_1 = 1, z = {pairs}", expected.subs(q, reduced) - of_expected
        yield f"M50: actual K_т, z_1 = 1, z = {pairs}", factor(reduced) * expected.subs(q, reduced) - of_actual
    yield "M50: expected K_т, all-driving at zC = 5", expected.subs(q, 5) - RATIONAL(12, 5)
    yield "M50: actual K_т, all-driving at zC = 5", published.subs(q, 5) - RATIONAL(36, 5)
    yield (
        "M51: below the optimum the actual K_т falls, at zC = 1 it is 44/9 > 9/2",
        (sp.Max(1, factor(sp.Integer(1))) * expected.subs(q, 1) - RATIONAL(44, 9)),
    )
    yield "(19) alone begins at 1/β_н", published.subs(q, 0) - 1 / margin
    numerator = sp.Poly(sp.numer(sp.together(sp.diff(published, q))), q)
    yield (
        "and only rises: every coefficient of its slope is positive; the minimum of fig. 3 is of (18) and (19)",
        sum(1 for coefficient in numerator.all_coeffs() if coefficient < 0),
    )


def off(found, expected, within=1e-9):
    """0 where two numbers, or arrays, agree."""
    found, expected = np.ravel(found), np.ravel(expected)
    return 0 if found.shape == expected.shape and np.allclose(found, expected, rtol=within, atol=0) else 1


def numbers_of_slips():
    """Frictions of slips: in the middles of 256 equal parts of the range, of the common path where materials differ."""
    middles = (np.arange(256) + 0.5) / 256
    yield "life.friction_slips", off(life.friction_slips(0.1, 0.7), 0.1 + 0.6 * middles)
    first, second = (0.1, 0.2, 0.6), (0.2, 0.5, 0.7)  # f_1 and f_2 come to their means at 0.4 of the path
    bend = unlike.bend_of_path(*first, *second)
    yield "unlike.bend_of_path", off(bend, 0.4)
    yield "at an end of the path", off([unlike.bend_of_path(*[0.1, 0.1, 0.3] * 2), unlike.bend_of_path(*[0.1, 0.3, 0.3] * 2)],
                                       [1e-12, 1 - 1e-12], 1e-13)  # fmt: skip
    yield "no path", off(unlike.bend_of_path(*[0.2] * 6), 1e-12)
    for slips, range_ in ((unlike.friction_driving_slips, first), (unlike.friction_driven_slips, second)):
        yield slips.__name__, off(slips(*range_, bend), np.interp(middles, [0, 0.4, 1], range_))
        from_mean = slips(range_[1], *range_[1:], 1e-12)
        yield "from the mean on", off(from_mean, range_[1] + (range_[2] - range_[1]) * middles)
    yield "life.counted_damage", off([life.counted_damage(0.2, 3.0, 2.0), life.counted_damage(0.2, 2.0, 2.0)], [0.2, 0])
    yield "a slip swings the load from 0", off(life._each_slip(None)["torque_low"], 0)
    yield "life.scatter_of_side", life.scatter_of_side(7, 3) - 4
    yield "overload.load_risen", overload.load_risen(7, 3) - 10
    yield "overload.reduced_gain_of_pairs", overload.reduced_gain_of_pairs(7, 3) - 21


def numbers_of_curved_walls():
    """Hertz at a wall of mean curvature; where the ball is; rounding at the end of the lock, the jump, the tangent."""
    path, ball, tan = 0.05, 0.008, 0.5
    radius = curved_wall.contact_radius_at_ball(ball, (1 + tan * tan) ** 1.5 / path, tan)
    mean = (1 / ball + 1 / (path - ball) + 1 / ball) / 2
    yield "curved_wall.contact_radius_at_ball", off(radius, 1 / mean)
    force, modulus, allowable = 900.0, 1.1e11, 3e9
    contact = (3 * force * radius / (4 * modulus)) ** (1 / 3)
    pressure = curved_wall.contact_pressure_at_ball(allowable, force, radius, modulus)
    yield "curved_wall.contact_pressure_at_ball", off(pressure, 3 * force / (2 * math.pi * contact**2))
    borne = curved_wall.contact_force_hertz(force, allowable, pressure)
    yield (
        "curved_wall.contact_force_hertz",
        off(curved_wall.contact_pressure_at_ball(allowable, borne, radius, modulus), allowable),
    )
    along = curved_wall.friction_along_wall(0.2, 0.8, 0.5)
    yield "curved_wall.friction_along_wall", off(along.ravel(), [*np.linspace(0.2, 0.8, 65), 0.5], 1e-11)
    yield "just before a jump", 0 if 0.5 - 2e-12 < along.ravel()[-1] < 0.5 else 1
    for law, wall in ((indirect.is_locked, ()), (curved.is_locked, (2.0, 0.1))):
        steeper = math.prod(wall) if wall else 0
        holds = [law(0.5 * (1 - share), 3 - steeper, 1.0, 1.5 - steeper, *wall) for share in (1e-13, 1e-11)]
        yield f"{law.__module__}.is_locked", off(holds, [True, False])
    yield (
        "curved.stays_off",
        0 if curved.stays_off(1.0, 2.0, 1.0, 0.5, 0.5) and not curved.stays_off(1.0, 2.0, 1.0, 0.5, -0.5) else 1,
    )
    yield (
        "curved.tangent_stiffness",
        off([curved.tangent_stiffness(each) for each in (0.25, 0.0, -1e-9)], [0.5, 0.0, 0.0]),
    )


def numbers_of_sizes():
    """Diameters are twice the radii; between the balls there is the circle less one ball, nothing without balls."""
    for law in (pressure.outer_diameter, pressure.disc_bore, pressure.mean_diameter, control_unit.ball_diameter,
                control_unit.ball_diameter_needed):  # fmt: skip
        yield law.__name__, law(7) - 14
    yield "control_unit.ball_bore", control_unit.ball_bore(30, 10) - 50
    yield "balls beyond the axis", off(control_unit.ball_bore(3.0, 10.0), 0.0)
