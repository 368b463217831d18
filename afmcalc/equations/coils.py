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
