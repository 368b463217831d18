"""Fatigue life of a part under the varying load of the clutch (S19 (14)–(20); handbook, chapter 4).

The case ``unprotected`` multiplies the load by the dynamic factor; in ``forecast`` friction ranges from its mean to
f_max. By the papers' rule a load cycle is T_min → T_max; by the rules of amplitude each slip is a cycle 0 → T(f) → 0,
and the damage is the mean of 256 slips over the range (Miner).
"""

import math

from .arrays import larger, mean_along, quotient, smaller, spread
from .wiring import Either, Same

load_factor = 1.0
dynamic_factor = 1.0
ultimate_strength = math.inf
mean_stress_sensitivity = 0.0
torque_low, torque_high = Same("torque_min"), Same("torque_max")


def side_torque(load_factor, torque):
    """Torque on the side of the clutch in question, T' = k_д T on the unprotected one.
    Source: S19, after (20): the drive's dynamics multiply what the clutch passes. Validity: k_д ≥ 1 between clutch and
    tool, 1 on the protected side."""
    return load_factor * torque


def shear_stress(side_torque, polar_section_modulus):
    """Shear stress of a torque, τ = T/W_p. Source: S19 (16), (17). Validity: Torsion, elastic."""
    return side_torque / polar_section_modulus


stress_low, stress_high = Same("shear_stress_at_low"), Same("shear_stress_at_high")


def mean_stress(stress_low, stress_high):
    """Mean stress of the cycle, (τ_max + τ_min)/2: what the papers take as damaging.
    Source: S19 (15), (18). Validity: The paper's rule; it ignores the amplitude (M23)."""
    return (stress_high + stress_low) / 2


def stress_amplitude(stress_low, stress_high):
    """Amplitude of the cycle, (τ_max − τ_min)/2. Source: Definition. Validity: τ_max ≥ τ_min."""
    return (larger(stress_high, stress_low) - smaller(stress_high, stress_low)) / 2


damaging_stress = Same("mean_stress")


def _equivalent_stress_sensitivity(stress_amplitude, mean_stress, mean_stress_sensitivity):
    """Equivalent alternating stress τ_a + ψ_τ τ_m.
    Source: Серенсен–Кинасошвили, in: Серенсен С.В., Когаев В.П., Шнейдерович Р.М. Несущая способность и расчёт деталей
    машин на прочность. Validity: 0 ≤ ψ_τ ≤ 1."""
    return stress_amplitude + mean_stress_sensitivity * mean_stress


def _equivalent_stress_goodman(stress_amplitude, mean_stress, ultimate_strength):
    """Equivalent alternating stress of the Goodman line, τ_a/(1 − τ_m/τ_u).
    Source: Goodman; Juvinall & Marshek, Fundamentals of Machine Component Design, ch. 8. Validity: τ_m < τ_u."""
    return stress_amplitude * ultimate_strength / (ultimate_strength - mean_stress)


def cycles_of_line(base_cycles, endurance_limit, damaging_stress, exponent):
    """Cycles to failure on the S-N line, N_ц = N_0 (τ_limb/τ)^m_τ.
    Source: S19 (14); with the mean stress (18)–(20). Validity: τ ≥ τ_limb, that is N_ц ≤ N_0: below the endurance limit
    the line is extrapolated."""
    return base_cycles * (endurance_limit / damaging_stress) ** exponent


def cycles_of_band(endurance_limit, polar_section_modulus, torque_low_of_side, scatter_of_side, exponent, base_cycles):
    """Cycles from the smallest torque and the scatter band, N_ц = N_0 (2 τ_limb W_p/(2 T_min + ΔT))^m_τ.
    Source: S19 (19), (20). Validity: Mean-stress rule; as ``cycles_of_line``."""
    swing = 2 * torque_low_of_side + scatter_of_side
    return base_cycles * (2 * endurance_limit * polar_section_modulus / swing) ** exponent


def scatter_of_side(side_torque_at_high, side_torque_at_low):
    """Scatter band on the side in question, ΔT' = k_д (T_max − T_min).
    Source: S19 (19), (20). Validity: As ``side_torque``."""
    return side_torque_at_high - side_torque_at_low


torque_low_of_side = Same("side_torque_at_low")


def is_broken(stress_high, ultimate_strength):
    """Condition that the largest load breaks the part, τ_max ≥ τ_u.
    Source: Definition of the ultimate strength; whatever the rule of the life. Validity: Static load."""
    return stress_high >= ultimate_strength


cycles_extrapolated = Either("is_broken", "nothing", "cycles_of_line")


def is_endless(damaging_stress, endurance_limit):
    """Condition that fatigue sets no limit, τ_eq ≤ τ_limb. Source: Definition of the endurance limit."""
    return damaging_stress <= endurance_limit


endless = math.inf
cycles_of_fatigue = Either("is_endless", "endless", "cycles_extrapolated")
cycles_of_side = Either("is_broken", "nothing", "cycles_of_fatigue")


def cycles(cycles_of_side, cycles_of_side_at_unprotected):
    """Cycles to failure of the side that fails first; infinite where fatigue limits neither. Source: Definition."""
    return smaller(cycles_of_side, cycles_of_side_at_unprotected)


# slip by slip


def damage(endurance_limit, damaging_stress, exponent, base_cycles):
    """Damage of one cycle, 1/N_ц = (τ/τ_limb)^m_τ/N_0; a part fails when its cycles add up to 1.
    Source: Miner, Cumulative damage in fatigue, J. Appl. Mech. 12 (1945), with the S-N line of S19 (14). Validity: As
    ``cycles_of_line``."""
    return (damaging_stress / endurance_limit) ** exponent / base_cycles


def counted_damage(damage, damaging_stress, endurance_limit):
    """Damage of a slip as far as it counts, 1/N_ц above the endurance limit, else 0.
    Source: Handbook, chapter 4. Validity: Slips below the endurance limit do no damage."""
    return damage * (damaging_stress > endurance_limit)


def mean_damage(counted_damage_at_each_slip):
    """Mean damage of a slip, D_m, over 256 slips.
    Source: Miner; friction is uniformly distributed over its range (handbook, chapter 4). Validity: Linear damage."""
    return mean_along(counted_damage_at_each_slip)


def cycles_of_mean_damage(mean_damage):
    """Slips to failure from the mean damage of a slip, N_ц = 1/D_m.
    Source: Miner: D_m is the mean of 1/N_ц(0, T(f)) over the friction of the slips (handbook, chapter 4). Validity:
    Linear damage; slips below the endurance limit do none."""
    return quotient(1.0, mean_damage)


friction_slips_least = Same("friction_min")


def friction_slips(friction_slips_least, friction_max):
    """Frictions of slips that are uniformly distributed over the range, or from the mean on, 256 of them.
    Source: Handbook, chapter 4; S19 forecasts from the mean friction on. Validity: f_min ≤ f_max."""
    return spread(friction_slips_least, friction_max, 256, ends=False)


def _each_slip(damaging_stress):
    return {
        "torque_low": 0.0,
        "damaging_stress": damaging_stress,
        "cycles_extrapolated": Either("is_broken", "nothing", "cycles_of_mean_damage"),
    }


AFTER_EVENT = {"dynamic_factor": Same("drive.dynamic_factor")}
AMPLITUDE = _each_slip(_equivalent_stress_sensitivity)
GOODMAN = _each_slip(_equivalent_stress_goodman)

CASES = {
    "low": {"torque": "torque_low"},
    "high": {"torque": "torque_high"},
    "unprotected": {"load_factor": "dynamic_factor"},
    "forecast": {"torque_low": "torque_min_from_mean", "torque_high": "torque_max_from_mean"},
    "slips": {"friction": "friction_slips"},
    "each_slip": {"torque_high": "torque_at_slips"},
}
FORECAST_OF_SLIPS = {"torque_high": "torque_max_from_mean", "friction_slips_least": "friction_mean"}
