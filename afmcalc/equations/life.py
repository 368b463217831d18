"""Fatigue life of a part that the load of the clutch swings (S19 (14)–(20); theory, section 4)."""

from ._types import Number


def shear_stress(torque: Number, polar_section_modulus: Number) -> Number:
    """Shear stress of a torque, τ = T/W_p.

    Source: S19 (15).

    Args:
        torque: T, torque of the side in question, T' on the unprotected one [N*m].
        polar_section_modulus: W_p, polar section modulus [m^3].

    Returns:
        τ [Pa].

    Validity:
        Torsion, elastic.
    """
    return torque / polar_section_modulus


def torque_unprotected(dynamic_factor: Number, torque: Number) -> Number:
    """Torque on the unprotected side, between clutch and tool, T' = k_д T.

    Source: S19, before (14): the drive's dynamics multiply what the clutch passes.

    Args:
        dynamic_factor: k_д, dynamic factor of the unprotected side [1].
        torque: T, slip torque of the clutch [N*m].

    Returns:
        T' [N*m].

    Validity:
        k_д ≥ 1.
    """
    return dynamic_factor * torque


def mean_stress(stress_low: Number, stress_high: Number) -> Number:
    """Mean stress of the cycle, (τ_max + τ_min)/2: what the papers take as damaging.

    Source: S19 (16), (17).

    Args:
        stress_low: τ_min, smallest stress of the cycle [Pa].
        stress_high: τ_max, largest stress of the cycle [Pa].

    Returns:
        τ_m [Pa].

    Validity:
        The paper's rule; it ignores the amplitude (M23).
    """
    return (stress_high + stress_low) / 2


def stress_amplitude(stress_low: Number, stress_high: Number) -> Number:
    """Amplitude of the cycle, (τ_max − τ_min)/2.

    Source: Definition.

    Args:
        stress_low: τ_min, smallest stress of the cycle [Pa].
        stress_high: τ_max, largest stress of the cycle [Pa].

    Returns:
        τ_a [Pa].

    Validity:
        τ_max ≥ τ_min.
    """
    return (stress_high - stress_low) / 2


def equivalent_stress_sensitivity(stress_low: Number, stress_high: Number, sensitivity: Number) -> Number:
    """Equivalent alternating stress τ_a + ψ_τ τ_m.

    Source: Серенсен–Кинасошвили, in: Серенсен С.В., Когаев В.П., Шнейдерович Р.М. Несущая способность и расчёт
        деталей машин на прочность.

    Args:
        stress_low: τ_min, smallest stress of the cycle [Pa].
        stress_high: τ_max, largest stress of the cycle [Pa].
        sensitivity: ψ_τ, sensitivity to the mean stress [1].

    Returns:
        τ_eq, to be held against τ_−1 [Pa].

    Validity:
        0 ≤ ψ_τ ≤ 1.
    """
    return stress_amplitude(stress_low, stress_high) + sensitivity * mean_stress(stress_low, stress_high)


def equivalent_stress_goodman(stress_low: Number, stress_high: Number, ultimate_strength: Number) -> Number:
    """Equivalent alternating stress of the Goodman line, τ_a/(1 − τ_m/τ_u).

    Source: Goodman; Juvinall & Marshek, Fundamentals of Machine Component Design, ch. 8.

    Args:
        stress_low: τ_min, smallest stress of the cycle [Pa].
        stress_high: τ_max, largest stress of the cycle [Pa].
        ultimate_strength: τ_u, ultimate strength in shear [Pa].

    Returns:
        τ_eq, to be held against τ_−1 [Pa].

    Validity:
        τ_m < τ_u.
    """
    amplitude, mean = stress_amplitude(stress_low, stress_high), mean_stress(stress_low, stress_high)
    return amplitude * ultimate_strength / (ultimate_strength - mean)


def cycles(endurance_limit: Number, stress: Number, exponent: Number, base_cycles: Number) -> Number:
    """Cycles to failure on the S-N line, N_ц = N_0 (τ_limb/τ)^m_τ.

    Source: S19 (14); with the mean stress (18)–(20).

    Args:
        endurance_limit: τ_limb, endurance limit in shear [Pa].
        stress: τ, the damaging stress [Pa].
        exponent: m_τ, exponent of the S-N line [1].
        base_cycles: N_0, base cycles of the S-N line [1].

    Returns:
        N_ц [1].

    Validity:
        τ ≥ τ_limb, that is N_ц ≤ N_0: below the endurance limit the line is extrapolated.
    """
    return base_cycles * (endurance_limit / stress) ** exponent


def damage(endurance_limit: Number, stress: Number, exponent: Number, base_cycles: Number) -> Number:
    """Damage of one cycle, 1/N_ц = (τ/τ_limb)^m_τ/N_0; a part fails when its cycles add up to 1.

    Source: Miner, Cumulative damage in fatigue, J. Appl. Mech. 12 (1945), with the S-N line of S19 (14).

    Args:
        endurance_limit: τ_limb, endurance limit in shear [Pa].
        stress: τ, the damaging stress [Pa].
        exponent: m_τ, exponent of the S-N line [1].
        base_cycles: N_0, base cycles of the S-N line [1].

    Returns:
        1/N_ц [1].

    Validity:
        As ``cycles``.
    """
    return (stress / endurance_limit) ** exponent / base_cycles


def cycles_of_mean_damage(mean_damage: Number) -> Number:
    """Slips to failure from the mean damage of a slip, N_ц = 1/D_m.

    Source: Miner: D_m is the mean of 1/N_ц(T_low, T(f)) over the friction of the slips (theory, section 4).

    Args:
        mean_damage: D_m, mean damage of a slip over f_min … f_max [1].

    Returns:
        N_ц [1].

    Validity:
        Linear damage; slips below the endurance limit do none.
    """
    return 1 / mean_damage


def cycles_of_band(
    endurance_limit: Number,
    polar_section_modulus: Number,
    torque_min: Number,
    scatter: Number,
    exponent: Number,
    base_cycles: Number,
) -> Number:
    """Cycles from the smallest torque and the scatter band, N_ц = N_0 (2 τ_limb W_p/(2 T_min + ΔT))^m_τ.

    Source: S19 (19), (20).

    Args:
        endurance_limit: τ_limb, endurance limit in shear [Pa].
        polar_section_modulus: W_p [m^3].
        torque_min: T_min [N*m].
        scatter: ΔT [N*m].
        exponent: m_τ, exponent of the S-N line [1].
        base_cycles: N_0, base cycles of the S-N line [1].

    Returns:
        N_ц [1].

    Validity:
        Mean-stress rule; as ``cycles``.
    """
    return base_cycles * (2 * endurance_limit * polar_section_modulus / (2 * torque_min + scatter)) ** exponent
