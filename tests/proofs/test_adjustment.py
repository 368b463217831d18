"""Adjustment and life (S19; handbook, chapter 4)."""

import sympy as sp
from proofs.symbols import *

from afmcalc.equations import accuracy, adjustment, direct, life


def _torque(force, friction, bypass=z1):
    return direct.torque(force, R, bypass, z - bypass, C, friction, friction)


def _arm(friction):
    """Lever arm R g(f): slip torque over spring force."""
    return _torque(sp.Integer(1), friction)


def spring_forces_of_both_methods():
    """S19 (5)–(8): the springs for one nominal torque; (6) is β_н T_н, as the paper says after (7) (M32, withdrawn)."""
    first = adjustment.closing_force(T_n, 1, _arm(fmin))
    second = adjustment.closing_force(T_n, beta, _arm(fcp))
    yield "(5): T(f_min) = T_н", _torque(first, fmin) - T_n
    yield "(6): T(f_cp) = β_н T_н", _torque(second, fcp) - beta * T_n
    yield "its inverse", adjustment.nominal_torque(second * _arm(fcp), beta) - T_n
    printed = fcp * (1 + (z - 1) * C * fmin) / (fmin * (1 + (z - 1) * C * fcp))
    ratio = adjustment._force_ratio(_arm(fcp), _arm(fmin))
    yield "(7), z_1 = 1", (ratio - printed).subs(z1, 1)
    yield "(7) is F_п1/F_п2 with F = β_н F_п2", ratio - first / (second / beta)
    literal = solved(_torque(F1, fmin) - beta * _torque(F2, fcp), F1) / F2
    yield Refutation("M32, withdrawn: with the margin kept (7) would be β_н times larger", literal - ratio)
    yield "(8): T_min1 through F_п2", _torque(ratio * F2, fmin) - _torque(F2, fcp)
    printed_9 = z * F2 * R * fcp * fmax * (1 + (z - 1) * C * fmin)
    printed_9 /= fmin * (1 + (z - 1) * C * fmax) * (1 + (z - 1) * C * fcp)
    yield "(9): T_max1 through F_п2", (_torque(ratio * F2, fmax) - printed_9).subs(z1, 1)


def _bands():
    """ΔT_1 and ΔT_2 from the torques, for the forces of both methods."""
    ratio = adjustment._force_ratio(_arm(fcp), _arm(fmin))
    return (_torque(ratio * F2, fmax) - _torque(ratio * F2, fmin), _torque(beta * F2, fmax) - _torque(beta * F2, fmin))


def bands_of_both_methods():
    """S19 (10), (11) mended (M6), and their ratio."""
    first, second = _bands()
    own = adjustment._scatter_of_one_material(F, R, z, z - z1, C, fmin, fmax)
    yield "ΔT = T_max − T_min", own - (_torque(F, fmax) - _torque(F, fmin))
    printed_10 = z * F2 * R * fcp * (fmax - fmin) / (fmin * (1 + (z - 1) * C * fcp) * (1 + (z - 1) * C * fmax))
    yield "(10)", (first - printed_10).subs(z1, 1)
    printed_11 = z * F2 * R * (fmax - fmin) / ((1 + (z - 1) * C * fmin) * (1 + (z - 1) * C * fmax))
    yield "(11) mended", (second - beta * printed_11).subs(z1, 1)
    yield Refutation("M6: printed (11)", (second - printed_11).subs(z1, 1))
    yield "ΔT_2/ΔT_1", adjustment._scatter_ratio_direct(beta, _arm(fmin), _arm(fcp)) - second / first
    nominal = _torque(adjustment._force_ratio(_arm(fcp), _arm(fmin)) * F2, fmin)
    own, other = (
        accuracy.mid_torque(_torque(force, fmax), _torque(force, fmin))
        for force in (beta * F2, adjustment._force_ratio(_arm(fcp), _arm(fmin)) * F2)
    )
    yield "the middles of the bands are in the same ratio", own / other - second / first
    yield "ΔT_2/ΔT_1 = T_min2/T_н", second / first - _torque(beta * F2, fmin) / nominal


def pairs_threshold_from_the_bands():
    """S19 (12), (13): where the bands are equal; with printed (11) there is no such z."""
    first, second = _bands()
    threshold = solved(sp.numer(sp.together(sp.factor(second / first - 1))), z)
    yield "(12) from (10) and (11) mended", adjustment._pairs_threshold(z1, C, fmin, fcp, beta) - threshold
    printed_13 = fmax / (beta - 1) * (1 / fmin - beta / fcp) + 1
    yield "(13): C = 1/f_max", adjustment._pairs_threshold(1, 1 / fmax, fmin, fcp, beta) - printed_13
    unmended = sp.numer(sp.together(sp.factor((second / beta) / first - 1)))
    yield Refutation("M6: printed (11) gives equal bands for no z", unmended.subs(z, threshold))


def threshold_is_not_inverse_to_the_gain():
    """S19 after (12): z − z_1, not z, is inversely proportional to C (M33)."""
    threshold = adjustment._pairs_threshold(z1, C, fmin, fcp, beta)
    yield "(z − z_1) C is constant", sp.diff((threshold - z1) * C, C)
    yield Refutation("M33: z C is not", sp.diff(threshold * C, C))


def cycles_from_the_line():
    """S19 (14)–(20): (18)–(20) from (14)–(17)."""
    limit, stress, exponent, base, modulus, low, band = positive("tau_limb tau m_tau N_0 W_p T_min dT")
    cycles = life.cycles_of_line(base, limit, stress, exponent)
    yield "(14)", sp.expand_power_base(cycles * stress**exponent, force=True) - limit**exponent * base
    whole = sp.expand_power_base(life.damage(limit, stress, exponent, base) * cycles, force=True)
    yield "damage of a cycle: N of them add up to 1", whole - 1
    yield "T' = k_д T", life.side_torque(base, low) - base * low
    stresses = [life.shear_stress(torque, modulus) for torque in (low, low + band)]
    yield "(16), (17)", stresses[0] - low / modulus
    mean = life.mean_stress(*stresses)
    yield "(15), (18)", mean - (2 * low + band) / (2 * modulus)
    often, rarely = positive("n_1 n_2")
    damage = (often / cycles + rarely / (2 * cycles)) / (often + rarely)
    slips = life.cycles_of_mean_damage(damage)
    yield "Miner: after that many slips the damage is 1", slips * (often + rarely / 2) / cycles - (often + rarely)
    for power in (1, 2, 6):
        direct_form = life.cycles_of_line(base, limit, mean, power)
        yield f"(19), (20) at m_τ = {power}", life.cycles_of_band(limit, modulus, low, band, power, base) - direct_form
    yield Refutation(
        "M23: a wider band shortens life at equal T_min",
        sp.diff(life.cycles_of_band(limit, modulus, low, band, 6, base), band),
    )


def equivalent_stresses():
    """Amplitude-based rules from their definitions."""
    amplitude, mean, psi, ultimate = positive("tau_a tau_m psi tau_u")
    low, high = mean - amplitude, mean + amplitude
    yield "τ_a", life.stress_amplitude(low, high) - amplitude
    yield "τ_m", life.mean_stress(low, high) - mean
    yield "Серенсен–Кинасошвили", life._equivalent_stress_sensitivity(amplitude, mean, psi) - amplitude - psi * mean
    goodman = life._equivalent_stress_goodman(amplitude, mean, ultimate)
    yield "Goodman line: τ_a/τ_eq + τ_m/τ_u = 1", amplitude / goodman + mean / ultimate - 1
