"""Direct regulation and its accuracy (F11; handbook, chapters 2 and 3)."""

import sympy as sp
from proofs.symbols import *

from afmcalc.equations import accuracy, control_unit, direct, indirect, pack, unlike


def _balance():
    """Release force, normal force and torque from F11 (1)–(10) alone: F_o r = R z_2 f_2 (F − F_p), F_o = F_p/tan α."""
    release = positive("F_p")
    solution = solved(release / t * r - R * f2 * z2 * (F - release), release)
    normal = F - solution
    return solution, normal, R * (z1 * f1 + z2 * f2) * normal


def torque_law_from_the_balance():
    """F11 (11) mended and (12) from (1)–(10)."""
    release, normal, torque = _balance()
    gain = pack._gain(R, r, t)
    yield "C = (R/r)·tan α", gain - R * t / r
    yield "(11) mended solves (7) with (10)", direct.release_force(F, z2, gain, f2) - release
    yield "(3) with (11): N", direct.normal_force(F, z2, gain, f2) - normal
    ball = positive("F_o")
    carried = indirect.torque(normal, R, z2, f2)
    printed_8 = indirect.torque(normal, R, z1, f1) + ball * r
    yield "(4), (7) in (1): (9) (M43)", printed_8.subs(ball, carried / r) - R * (z1 * f1 + z2 * f2) * normal
    around = control_unit.circumferential_force(carried, r)
    yield "(5), (10): F_o = T_2/r = F_p/tan α", around - release.subs(C, gain) / t
    yield "(12) follows from (9)", direct.torque(F, R, z1, z2, gain, f1, f2) - torque
    yield "(2) + (6) is (12)", indirect.torque(normal, R, z1, f1) + indirect.torque(normal, R, z2, f2) - torque
    yield "T/F_п is the torque of one newton", direct.torque_per_force(R, z1, z2, gain, f1, f2) - torque / F
    yield "(2), (4)", direct._driving_torque(normal, R, z1, f1) - R * f1 * z1 * (F - release)
    yield "the first torque: N = F_п", direct._onset_torque(F, R, z1, f1) - R * f1 * z1 * F
    yield "a group's torque is R f z N", indirect.torque(N, R, z1, f1) - R * f1 * z1 * N
    yield "z_1 + z_2 = z", z1 + pack.controlled_pairs(z, z1) - z
    yield "reduced gain", pack.reduced_gain(z2, C) - z2 * C
    printed = z2 * F * f2 / (1 + z2 * C * f2)
    yield Refutation(
        "M1: printed (11) in (9) does not give (12)",
        R * (z1 * f1 + z2 * f2) * (F - printed) - torque.subs(t, C * r / R),
    )


def one_material_law():
    """F11 (13), S19 (1), (2): one bypass pair; S22 (4), (16): none."""
    yield "(13): z_1 = 1", direct.torque(F, R, 1, z - 1, C, f, f) - z * F * R * f / (1 + (z - 1) * C * f)
    yield "S22 (16): z_1 = 0", direct.torque(F, R, 0, z, C, f, f) - z * F * R * f / (1 + z * C * f)
    yield "conventional: z_2 = 0", direct.torque(F, R, z, 0, C, f, f) - z * F * R * f


def accuracy_factor_is_the_ratio_of_torques():
    """F11 (14) from (12)."""
    torques = [direct.torque(F, R, z1, z2, C, a, b) for a, b in ((f1max, f2max), (f1min, f2min))]
    factor = accuracy.accuracy_factor_of_path(z1, z2, C, f1min, f2min, f1max, f2max)
    yield "(14) = T(f_max)/T(f_min)", factor - torques[0] / torques[1]
    yield "of the two torques", accuracy.accuracy_factor(*torques) - factor
    yield "of any two corners", accuracy.accuracy_factor(*torques) - factor
    yield "by peaks, where T is the peak", accuracy.accuracy_factor(*torques) - factor
    yield "ΔT = (K_т − 1) T(f_min)", accuracy.scatter(*torques) - (factor - 1) * torques[1]
    middle = accuracy.mid_torque(*torques)
    yield "T_mid is as far below T_max as above T_min", (torques[0] - middle) - (middle - torques[1])
    ordinary = accuracy.conventional_accuracy_factor(z1, z2, f1min, f2min, f1max, f2max)
    yield "K_т,0 is (14) at C = 0", ordinary - accuracy.accuracy_factor_of_path(z1, z2, 0, f1min, f2min, f1max, f2max)
    one = accuracy.accuracy_factor_of_path(z1, z2, C, fmin, fmin, fmax, fmax)
    yield (
        "one material (handbook, chapter 3; lines 5–7 of fig. 2)",
        one - fmax / fmin * (1 + z2 * C * fmin) / (1 + z2 * C * fmax),
    )


def accuracy_by_ratios():
    """F11 (17) from (14) with (15), (16)."""
    factor = accuracy.accuracy_factor_of_path(z1, z2, C, f1min, p * f1min, f1max, n * f1max)
    yield "(17)", unlike.accuracy_factor_by_ratios(z1, z2, C, n, p, f1min, f1max) - factor


def _factor():
    return accuracy.accuracy_factor_of_path(z1, z2, C, f1min, p * f1min, f1max, n * f1max)


def slope_in_n():
    """F11 (18) mended is the derivative of (17) (M2); (19)–(21) and n > 1 (M5, M20, M29)."""
    slope = sp.diff(_factor(), n)
    yield "(18) mended", unlike.slope_in_ratio_max(z1, z2, C, n, p, f1min, f1max) - slope
    spread = f1max / f1min
    common = z2 * spread * (1 + z2 * C * p * f1min) / ((z1 + z2 * p) * (1 + z2 * C * n * f1max) ** 2)
    yield Refutation("M2: printed factor z_1 − C f_1max", common * (z1 - C * f1max) - slope)
    yield "print and proof agree for z_1 = 1", (common * (z1 - C * f1max) - slope).subs(z1, 1)
    printed_19 = (z1 - C * f1max) / (z2 * C * f1min * (C * f1max - z1))
    yield "(19) as printed is −1/(z_2 C f_1min)", printed_19 + 1 / (z2 * C * f1min)
    yield "(19): the root in p is −1/(z_2 C f_1min), negative", slope.subs(p, -1 / (z2 * C * f1min))
    yield "at C = 1/(z_1 f_1max) K_т does not depend on n (M5, M20)", slope.subs(C, 1 / (z1 * f1max))
    below = {C: 1 / (z1 * f1max + q)}
    yield (
        "M5, M29: below the limit, C = 1/(z_1 f_1max + q), the sign factor is qC: positive for every n",
        (slope - common * q * C).subs(below),
    )


def slope_in_p():
    """F11 (22) mended is the derivative of (17) (M3); its root in n (M21)."""
    slope = sp.diff(_factor(), p)
    yield "(22) mended", unlike.slope_in_ratio_min(z1, z2, C, n, p, f1min, f1max) - slope
    spread = f1max / f1min
    common = z2 * spread * (z1 + z2 * n) / ((z1 + z2 * p) ** 2 * (1 + z2 * C * n * f1max))
    yield Refutation("M3: printed factor C f_1min − z_1", common * (C * f1min - z1) - slope)
    yield "print and proof agree for z_1 = 1", (common * (C * f1min - z1) - slope).subs(z1, 1)
    yield "M21: the root in n is −z_1/z_2", slope.subs(n, -z1 / z2)
    yield Refutation("M21: printed root −1/z_2", slope.subs(n, -1 / z2))


def gain_limits():
    """F11, after (20), S22 (24): at the limit the bypass pairs alone carry the regulated torque."""
    limit = direct._gain_limit_breakaway(z1, fmax)
    bypass = indirect.torque(F, R, z1, fmax)
    torque = direct.torque(F, R, z1, z2, C, f1, f2)
    yield "z_1 f_max R F = T(f_max) at the limit", bypass - direct.torque(F, R, z1, z2, limit, fmax, fmax)
    yield (
        "T/(R F) − z_1 f_1 has the sign of 1 − z_1 C f_1 (same for unlike materials)",
        (torque - indirect.torque(F, R, z1, f1)) * (1 + C * z2 * f2) - F * R * z2 * f2 * (1 - z1 * C * f1),
    )
    yield "S22: zC = 5 at the recommended limit", pack.reduced_gain(z, direct._gain_limit_reduced(z)) - 5
    slope = sp.diff(torque, f2)
    yield "T falls with f_2 where z_1 C f_1 > 1", slope * (1 + C * z2 * f2) ** 2 - F * R * z2 * (1 - z1 * C * f1)


def breakaway_peaks():
    """Handbook, chapter 3: accuracy by peaks between the limits, and its best value."""
    peak = indirect.torque(F, R, z1, fmax) / direct.torque(F, R, z1, z2, C, fmin, fmin)
    yield "P(f_max)/P(f_min)", z1 * fmax * (1 + z2 * C * fmin) / ((z1 + z2) * fmin) - peak
    limit = direct._gain_limit_breakaway(z1, fmax)
    best = (z1 * fmax + z2 * fmin) / ((z1 + z2) * fmin)
    yield "best: at the gain limit, from above", best - peak.subs(C, limit)
    published = accuracy.accuracy_factor_of_path(z1, z2, limit, fmin, fmin, fmax, fmax)
    yield "best: at the gain limit, from below", best - published
    upper = 1 / (z1 * fmin)
    yield "above 1/(z_1 f_min) it is f_max/f_min", peak.subs(C, upper) - fmax / fmin


def figure_2_needs_one_bypass_pair():
    """F11 fig. 2: curve 4 is level for z_1 = 1, C = 1.25 = 1/0.8; with z_1 = 2 it is not (M4)."""
    slope = unlike.slope_in_ratio_max(z1, 6, sp.Rational(5, 4), n, p, sp.Rational(16, 100), sp.Rational(8, 10))
    yield "level for z_1 = 1", slope.subs(z1, 1)
    yield Refutation("M4: not for z_1 = 2", slope.subs(z1, 2))
    kept = unlike.slope_in_ratio_max(2, 6, sp.Rational(5, 8), n, p, sp.Rational(16, 100), sp.Rational(8, 10))
    yield "M4 is not the only mending: z_1 = 2 with C = 0.625 is level too", kept
