"""Fatigue life of a part that the load of the clutch swings (S19 (14)–(20); handbook, chapter 4)."""

from typing import Annotated

from .terms import *


def shear_stress(torque: SideTorque, polar_section_modulus: PolarSectionModulus) -> ShearStress:
    """Shear stress of a torque, τ = T/W_p.

    Source: S19 (16), (17).
    Validity: Torsion, elastic.
    """
    return torque / polar_section_modulus


def torque_unprotected(dynamic_factor: DynamicFactor, torque: SlipTorque) -> Annotated[Number, "T'", "N*m"]:
    """Torque on the unprotected side, between clutch and tool, T' = k_д T.

    Source: S19, after (20): the drive's dynamics multiply what the clutch passes.
    Validity: k_д ≥ 1.
    """
    return dynamic_factor * torque


def mean_stress(stress_low: StressLow, stress_high: StressHigh) -> Annotated[Number, "τ_m", "Pa"]:
    """Mean stress of the cycle, (τ_max + τ_min)/2: what the papers take as damaging.

    Source: S19 (15), (18).
    Validity: The paper's rule; it ignores the amplitude (M23).
    """
    return (stress_high + stress_low) / 2


def stress_amplitude(stress_low: StressLow, stress_high: StressHigh) -> Annotated[Number, "τ_a", "Pa"]:
    """Amplitude of the cycle, (τ_max − τ_min)/2.

    Source: Definition.
    Validity: τ_max ≥ τ_min.
    """
    return (stress_high - stress_low) / 2


def equivalent_stress_sensitivity(
    stress_low: StressLow, stress_high: StressHigh, sensitivity: MeanStressSensitivity
) -> EquivalentStress:
    """Equivalent alternating stress τ_a + ψ_τ τ_m.

    Source: Серенсен–Кинасошвили, in: Серенсен С.В., Когаев В.П., Шнейдерович Р.М. Несущая способность и расчёт деталей
        машин на прочность.
    Validity: 0 ≤ ψ_τ ≤ 1.
    """
    return stress_amplitude(stress_low, stress_high) + sensitivity * mean_stress(stress_low, stress_high)


def equivalent_stress_goodman(
    stress_low: StressLow, stress_high: StressHigh, ultimate_strength: UltimateStrength
) -> EquivalentStress:
    """Equivalent alternating stress of the Goodman line, τ_a/(1 − τ_m/τ_u).

    Source: Goodman; Juvinall & Marshek, Fundamentals of Machine Component Design, ch. 8.
    Validity: τ_m < τ_u.
    """
    amplitude, mean = stress_amplitude(stress_low, stress_high), mean_stress(stress_low, stress_high)
    return amplitude * ultimate_strength / (ultimate_strength - mean)


def cycles(
    endurance_limit: EnduranceLimit, stress: DamagingStress, exponent: FatigueExponent, base_cycles: BaseCycles
) -> Cycles:
    """Cycles to failure on the S-N line, N_ц = N_0 (τ_limb/τ)^m_τ.

    Source: S19 (14); with the mean stress (18)–(20).
    Validity: τ ≥ τ_limb, that is N_ц ≤ N_0: below the endurance limit the line is extrapolated.
    """
    return base_cycles * (endurance_limit / stress) ** exponent


def damage(
    endurance_limit: EnduranceLimit, stress: DamagingStress, exponent: FatigueExponent, base_cycles: BaseCycles
) -> Annotated[Number, "1/N_ц", "1"]:
    """Damage of one cycle, 1/N_ц = (τ/τ_limb)^m_τ/N_0; a part fails when its cycles add up to 1.

    Source: Miner, Cumulative damage in fatigue, J. Appl. Mech. 12 (1945), with the S-N line of S19 (14).
    Validity: As ``cycles``.
    """
    return (stress / endurance_limit) ** exponent / base_cycles


def cycles_of_mean_damage(mean_damage: MeanDamage) -> Cycles:
    """Slips to failure from the mean damage of a slip, N_ц = 1/D_m.

    Source: Miner: D_m is the mean of 1/N_ц(0, T(f)) over the friction of the slips (handbook, chapter 4).
    Validity: Linear damage; slips below the endurance limit do none.
    """
    return 1 / mean_damage


def cycles_of_band(
    endurance_limit: EnduranceLimit,
    polar_section_modulus: PolarSectionModulus,
    torque_min: TorqueMin,
    scatter: Scatter,
    exponent: FatigueExponent,
    base_cycles: BaseCycles,
) -> Cycles:
    """Cycles from the smallest torque and the scatter band, N_ц = N_0 (2 τ_limb W_p/(2 T_min + ΔT))^m_τ.

    Source: S19 (19), (20).
    Validity: Mean-stress rule; as ``cycles``.
    """
    return base_cycles * (2 * endurance_limit * polar_section_modulus / (2 * torque_min + scatter)) ** exponent
