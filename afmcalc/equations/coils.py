"""Coil springs."""

from ._types import Number


def coil_stiffness(shear_modulus: Number, wire_diameter: Number, coil_diameter: Number, turns: Number) -> Number:
    """Stiffness of a coil spring, G d⁴/(8 D³ n).

    Source: EN 13906-1; theory of the drive, section 11.

    Args:
        shear_modulus: G [Pa].
        wire_diameter: d [m].
        coil_diameter: D, mean diameter of the coil [m].
        turns: n, active coils [1].

    Returns:
        R [N/m].

    Validity:
        A small pitch.
    """
    return shear_modulus * wire_diameter**4 / (8 * coil_diameter**3 * turns)


def coil_correction(wire_diameter: Number, coil_diameter: Number) -> Number:
    """Factor of a coil's curvature (Bergsträßer), (w + ½)/(w − ¾), w = D/d.

    Source: EN 13906-1; theory of the drive, section 11.

    Args:
        wire_diameter: d [m].
        coil_diameter: D, mean diameter of the coil [m].

    Returns:
        k_τ [1].

    Validity:
        4 ≤ w ≤ 20.
    """
    index = coil_diameter / wire_diameter
    return (index + 0.5) / (index - 0.75)


def coil_stress(force: Number, wire_diameter: Number, coil_diameter: Number, correction: Number, pi: Number) -> Number:
    """Shear stress at the inside of a coil, k_τ 8 F D/(π d³).

    Source: EN 13906-1; theory of the drive, section 11.

    Args:
        force: F, force of the spring [N].
        wire_diameter: d [m].
        coil_diameter: D, mean diameter of the coil [m].
        correction: k_τ; 1 where it rests [1].
        pi: π, a symbol under SymPy [1].

    Returns:
        τ [Pa].

    Validity:
        Round wire.
    """
    return correction * 8 * force * coil_diameter / (pi * wire_diameter**3)


def coil_solid_length(wire_diameter: Number, turns: Number) -> Number:
    """Length of a coil spring pressed solid, (n + 2) d.

    Source: EN 13906-1, ends closed and ground; theory of the drive, section 11.

    Args:
        wire_diameter: d, largest wire diameter [m].
        turns: n, active coils [1].

    Returns:
        L_c [m].

    Validity:
        Cold coiled, ends closed and ground: two more turns in all.
    """
    return (turns + 2) * wire_diameter


def coil_least_gap(wire_diameter: Number, coil_diameter: Number, turns: Number) -> Number:
    """Gaps that must stay between the turns, together, S_a = n (0.0015 D²/d + 0.1 d).

    Source: EN 13906-1, cold coiled, static; theory of the drive, section 11.

    Args:
        wire_diameter: d [m].
        coil_diameter: D, mean diameter of the coil [m].
        turns: n, active coils [1].

    Returns:
        S_a [m].

    Validity:
        Cold coiled, static or quasi-static.
    """
    return turns * (0.0015 * coil_diameter**2 / wire_diameter + 0.1 * wire_diameter)


def coil_mass(density: Number, wire_diameter: Number, coil_diameter: Number, turns: Number, pi: Number) -> Number:
    """Mass of a coil spring, ρ (π/4) d² π D (n + 2).

    Source: Theory of the drive, section 11: volume of the wire.

    Args:
        density: ρ [kg/m^3].
        wire_diameter: d [m].
        coil_diameter: D, mean diameter of the coil [m].
        turns: n, active coils [1].
        pi: π, a symbol under SymPy [1].

    Returns:
        m [kg].

    Validity:
        A small pitch; two more turns at the ends.
    """
    return density * pi * pi * wire_diameter**2 * coil_diameter * (turns + 2) / 4


def coil_endurance(amplitude: Number, mean: Number, ultimate: Number) -> Number:
    """Shear stress that alternates about 0 and a wire bears for ever, S_se = S_sa/(1 − S_sm/S_su).

    Source: Shigley, sec. 10-9 (Goodman's line through Zimmerli's point 1957).

    Args:
        amplitude: S_sa, amplitude of a shear stress that is borne for ever [Pa].
        mean: S_sm, mean of that shear stress [Pa].
        ultimate: S_su, shear strength [Pa].

    Returns:
        S_se [Pa].

    Validity:
        S_sm < S_su.
    """
    return amplitude / (1 - mean / ultimate)


def coil_upper_stress(lower_stress: Number, endurance: Number, ultimate: Number) -> Number:
    """Upper shear stress a wire bears for ever, τ_O = [2 S_se S_su + τ_U (S_su − S_se)]/(S_su + S_se).

    Source: Shigley, sec. 10-9 (Goodman: τ_a/S_se + τ_m/S_su = 1); stresses with k_τ, as EN 13906-1 has them.

    Args:
        lower_stress: τ_U, least shear stress of the stroke, with k_τ [Pa].
        endurance: S_se, shear stress that alternates about 0 and is borne for ever [Pa].
        ultimate: S_su, shear strength [Pa].

    Returns:
        τ_O [Pa].

    Validity:
        Wire not shot peened; diameter to some 10 mm.
    """
    return (2 * endurance * ultimate + lower_stress * (ultimate - endurance)) / (ultimate + endurance)


def coil_buckling_root(
    coil_diameter: Number, free_length: Number, modulus_ratio: Number, seating: Number, pi: Number
) -> Number:
    """What stands under the root of the deflection of buckling, 1 − (1 − G/E)/(½ + G/E) [π D/(ν L_0)]².

    Source: EN 13906-1 (Haringx 1948); theory of the drive, section 11.

    Args:
        coil_diameter: D, mean diameter of the coil [m].
        free_length: L_0, length without load [m].
        modulus_ratio: G/E, shear modulus over Young's modulus [1].
        seating: ν, factor of the seating, ½ between parallel plates [1].
        pi: π, a symbol under SymPy [1].

    Returns:
        q [1].

    Validity:
        Negative where the spring never buckles.
    """
    slender = pi * coil_diameter / (seating * free_length)
    return 1 - (1 - modulus_ratio) / (0.5 + modulus_ratio) * slender**2


def coil_buckling_deflection(free_length: Number, modulus_ratio: Number, root: Number) -> Number:
    """Deflection at which a coil spring without guide buckles, s_K = L_0 (1 − √q)/[2 (1 − G/E)].

    Source: EN 13906-1 (Haringx 1948); theory of the drive, section 11.

    Args:
        free_length: L_0, length without load [m].
        modulus_ratio: G/E, shear modulus over Young's modulus [1].
        root: q, what stands under the root of that deflection [1].

    Returns:
        s_K [m].

    Validity:
        q ≥ 0.
    """
    return free_length * (1 - root**0.5) / (2 * (1 - modulus_ratio))
