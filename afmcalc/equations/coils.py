"""Coil springs."""

from typing import Annotated

from .calls import equation
from .terms import *


@equation
def coil_stiffness(
    shear_modulus: ShearModulus, wire_diameter: WireDiameter, coil_diameter: CoilDiameter, turns: CoilTurns
) -> Annotated[Number, Term("R", "", "N/m")]:
    """Stiffness of a coil spring, G d⁴/(8 D³ n).

    Source: EN 13906-1; theory of the drive, section 11.
    Validity: A small pitch.
    """
    return shear_modulus * wire_diameter**4 / (8 * coil_diameter**3 * turns)


@equation
def coil_correction(wire_diameter: WireDiameter, coil_diameter: CoilDiameter) -> CoilCorrection:
    """Factor of a coil's curvature (Bergsträßer), (w + ½)/(w − ¾), w = D/d.

    Source: EN 13906-1; theory of the drive, section 11.
    Validity: 4 ≤ w ≤ 20.
    """
    index = coil_diameter / wire_diameter
    return (index + 0.5) / (index - 0.75)


@equation
def coil_stress(
    force: SpringForce, wire_diameter: WireDiameter, coil_diameter: CoilDiameter, correction: CoilCorrection, pi: Pi
) -> ShearStress:
    """Shear stress at the inside of a coil, k_τ 8 F D/(π d³).

    Source: EN 13906-1; theory of the drive, section 11.
    Validity: Round wire.
    """
    return correction * 8 * force * coil_diameter / (pi * wire_diameter**3)


@equation
def coil_solid_length(wire_diameter: LargestWireDiameter, turns: CoilTurns) -> Annotated[Number, Term("L_c", "", "m")]:
    """Length of a coil spring pressed solid, (n + 2) d.

    Source: EN 13906-1, ends closed and ground; theory of the drive, section 11.
    Validity: Cold coiled, ends closed and ground: two more turns in all.
    """
    return (turns + 2) * wire_diameter


@equation
def coil_least_gap(
    wire_diameter: WireDiameter, coil_diameter: CoilDiameter, turns: CoilTurns
) -> Annotated[Number, Term("S_a", "", "m")]:
    """Gaps that must stay between the turns, together, S_a = n (0.0015 D²/d + 0.1 d).

    Source: EN 13906-1, cold coiled, static; theory of the drive, section 11.
    Validity: Cold coiled, static or quasi-static.
    """
    return turns * (0.0015 * coil_diameter**2 / wire_diameter + 0.1 * wire_diameter)


@equation
def coil_mass(
    density: Density, wire_diameter: WireDiameter, coil_diameter: CoilDiameter, turns: CoilTurns, pi: Pi
) -> SpringMass:
    """Mass of a coil spring, ρ (π/4) d² π D (n + 2).

    Source: Theory of the drive, section 11: volume of the wire.
    Validity: A small pitch; two more turns at the ends.
    """
    return density * pi * pi * wire_diameter**2 * coil_diameter * (turns + 2) / 4


@equation
def coil_endurance(amplitude: EnduredAmplitude, mean: EnduredMean, ultimate: ShearStrength) -> EnduredStress:
    """Shear stress that alternates about 0 and a wire bears for ever, S_se = S_sa/(1 − S_sm/S_su).

    Source: Shigley, sec. 10-9 (Goodman's line through Zimmerli's point 1957).
    Validity: S_sm < S_su.
    """
    return amplitude / (1 - mean / ultimate)


@equation
def coil_upper_stress(
    lower_stress: LowerStress, endurance: EnduredStress, ultimate: ShearStrength
) -> Annotated[Number, Term("τ_O", "", "Pa")]:
    """Upper shear stress a wire bears for ever, τ_O = [2 S_se S_su + τ_U (S_su − S_se)]/(S_su + S_se).

    Source: Shigley, sec. 10-9 (Goodman: τ_a/S_se + τ_m/S_su = 1); stresses with k_τ, as EN 13906-1 has them.
    Validity: Wire not shot peened; diameter to some 10 mm.
    """
    return (2 * endurance * ultimate + lower_stress * (ultimate - endurance)) / (ultimate + endurance)


@equation
def coil_buckling_root(
    coil_diameter: CoilDiameter, free_length: FreeLength, modulus_ratio: ModulusRatio, seating: SeatingFactor, pi: Pi
) -> BucklingRoot:
    """What stands under the root of the deflection of buckling, 1 − (1 − G/E)/(½ + G/E) [π D/(ν L_0)]².

    Source: EN 13906-1 (Haringx 1948); theory of the drive, section 11.
    Validity: Negative where the spring never buckles.
    """
    slender = pi * coil_diameter / (seating * free_length)
    return 1 - (1 - modulus_ratio) / (0.5 + modulus_ratio) * slender**2


@equation
def coil_buckling_deflection(
    free_length: FreeLength, modulus_ratio: ModulusRatio, root: BucklingRoot
) -> Annotated[Number, Term("s_K", "", "m")]:
    """Deflection at which a coil spring without guide buckles, s_K = L_0 (1 − √q)/[2 (1 − G/E)].

    Source: EN 13906-1 (Haringx 1948); theory of the drive, section 11.
    Validity: q ≥ 0.
    """
    return free_length * (1 - root**0.5) / (2 * (1 - modulus_ratio))
