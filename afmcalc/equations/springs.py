"""Disc springs, stacks of them, and coil springs."""


def disc_factor_load(diameter_ratio, logarithm, pi):
    """Factor of a disc spring's load, K_1 = ((δ − 1)/δ)²/{π[(δ + 1)/(δ − 1) − 2/ln δ]}.
    Source: DIN EN 16984 (Almen & László 1936); handbook, chapter 11. Validity: δ > 1."""
    ratio = diameter_ratio
    return ((ratio - 1) / ratio) ** 2 / (pi * ((ratio + 1) / (ratio - 1) - 2 / logarithm))


def disc_factor_membrane(diameter_ratio, logarithm, pi):
    """Factor of the stress by turning inside out, K_2 = (6/π)[(δ − 1)/ln δ − 1]/ln δ.
    Source: DIN EN 16984 (Almen & László 1936); handbook, chapter 11. Validity: δ > 1."""
    return 6 * ((diameter_ratio - 1) / logarithm - 1) / (pi * logarithm)


def disc_factor_bending(diameter_ratio, logarithm, pi):
    """Factor of the stress by bending, K_3 = (3/π)(δ − 1)/ln δ.
    Source: DIN EN 16984 (Almen & László 1936); handbook, chapter 11. Validity: δ > 1."""
    return 3 * (diameter_ratio - 1) / (pi * logarithm)


def disc_flats_first(thickness, reduced_thickness, free_height):
    """First coefficient of a disc spring with flats. Source: DIN EN 16984; handbook, chapter 11. Validity: t' ≤ t."""
    reduced, height = reduced_thickness / thickness, free_height / thickness
    return reduced**2 / ((height / 4 - reduced + 0.75) * (5 * height / 8 - reduced + 0.375))


def disc_flats_second(first, thickness, reduced_thickness, free_height):
    """Second coefficient of a disc spring with flats. Source: DIN EN 16984; handbook, chapter 11. Validity: t' ≤ t."""
    return first * (thickness / reduced_thickness) ** 3 * (5 * (free_height / thickness - 1) ** 2 / 32 + 1)


def disc_factor_flats(first, second):
    """Factor of a disc spring with flats.
    Source: DIN EN 16984; handbook, chapter 11: the force at ¾ of the cone height stays that of a plain disc. Validity:
    t' ≤ t; without flats K_4 = 1."""
    return ((first**2 / 4 + second) ** 0.5 - first / 2) ** 0.5


def disc_force(modulus, poisson, factor_load, factor_flats, outer_diameter, thickness, cone_height, deflection):
    """Force of a disc spring, 4E/(1 − ν²) t³ s K_4²/(K_1 D_e²) [K_4² (h_0/t − s/t)(h_0/t − s/(2t)) + 1].
    Source: DIN EN 16984 (Almen & László 1936); handbook, chapter 11. Validity: 0 ≤ s ≤ h_0; beyond ¾ h_0 the lever
    shortens and the true force is larger."""
    square = factor_flats * factor_flats
    rigid = 4 * modulus * thickness * deflection * square / ((1 - poisson * poisson) * factor_load * outer_diameter**2)
    return rigid * (square * (cone_height - deflection) * (cone_height - deflection / 2) + thickness**2)


def disc_stiffness(modulus, poisson, factor_load, factor_flats, outer_diameter, thickness, cone_height, deflection):
    """Stiffness of a disc spring, 4E/(1 − ν²) t K_4²/(K_1 D_e²) [K_4² (h_0² − 3 h_0 s + 3 s²/2) + t²].
    Source: DIN EN 16984 (Almen & László 1936), derivative of the force; handbook, chapter 11. Validity: 0 ≤ s ≤ h_0."""
    square = factor_flats * factor_flats
    rigid = 4 * modulus * thickness * square / ((1 - poisson * poisson) * factor_load * outer_diameter**2)
    return rigid * (square * (cone_height**2 - 3 * cone_height * deflection + 3 * deflection**2 / 2) + thickness**2)


def disc_stress(
    modulus, poisson, factor_load, factor_flats, outer_diameter, thickness, cone_height, deflection, membrane, bending
):
    """Stress of a disc spring at an edge, −4E/(1 − ν²) s K_4/(K_1 D_e²) [K_4 K_m (h_0 − s/2) + K_b t].
    Source: DIN EN 16984 (Almen & László 1936); handbook, chapter 11. Validity: Elastic; residual stresses of shot
    peening and presetting are not counted."""
    rigid = -4 * modulus * deflection * factor_flats / ((1 - poisson * poisson) * factor_load * outer_diameter**2)
    return rigid * (factor_flats * membrane * (cone_height - deflection / 2) + bending * thickness)


def stack_length(parallel, series, free_height, thickness):
    """Length of a stack of disc springs without load, i [l_0 + (n − 1) t].
    Source: DIN EN 16984; handbook, chapter 11."""
    return series * (free_height + (parallel - 1) * thickness)


def stack_force_with_friction(force, parallel, surface_friction, edge_friction):
    """Force of a stack that friction holds, n F/[1 − w_M (n − 1) − w_R]; when unloading both signs are reversed.
    Source: DIN EN 16984; handbook, chapter 11. Validity: w_M (n − 1) + w_R < 1."""
    return force / (1 - surface_friction * (parallel - 1) - edge_friction)


def ring_mass(density, outer_diameter, inner_diameter, thickness, pi):
    """Mass of a disc, ρ π/4 (D_e² − D_i²) t. Source: Handbook, chapter 11: volume of a ring. Validity: A flat cone."""
    return density * pi * (outer_diameter**2 - inner_diameter**2) * thickness / 4


def coil_stiffness(shear_modulus, wire_diameter, coil_diameter, turns):
    """Stiffness of a coil spring, G d⁴/(8 D³ n). Source: EN 13906-1; handbook, chapter 11. Validity: Small pitch."""
    return shear_modulus * wire_diameter**4 / (8 * coil_diameter**3 * turns)


def coil_correction(wire_diameter, coil_diameter):
    """Factor of a coil's curvature (Bergsträßer), (w + ½)/(w − ¾), w = D/d.
    Source: EN 13906-1; handbook, chapter 11. Validity: 4 ≤ w ≤ 20."""
    index = coil_diameter / wire_diameter
    return (index + 0.5) / (index - 0.75)


def coil_stress(force, wire_diameter, coil_diameter, correction, pi):
    """Shear stress at the inside of a coil, k_τ 8 F D/(π d³).
    Source: EN 13906-1; handbook, chapter 11. Validity: Round wire."""
    return correction * 8 * force * coil_diameter / (pi * wire_diameter**3)


def coil_solid_length(wire_diameter, turns):
    """Length of a coil spring pressed solid, (n + 2) d.
    Source: EN 13906-1, ends closed and ground; handbook, chapter 11. Validity: Cold coiled, ends closed and ground: two
    more turns in all."""
    return (turns + 2) * wire_diameter


def coil_least_gap(wire_diameter, coil_diameter, turns):
    """Gaps that must stay between the turns, together, S_a = n (0.0015 D²/d + 0.1 d).
    Source: EN 13906-1, cold coiled, static; handbook, chapter 11. Validity: Cold coiled, static or quasi-static."""
    return turns * (0.0015 * coil_diameter**2 / wire_diameter + 0.1 * wire_diameter)


def coil_mass(density, wire_diameter, coil_diameter, turns, pi):
    """Mass of a coil spring, ρ (π/4) d² π D (n + 2).
    Source: Handbook, chapter 11: volume of the wire. Validity: Small pitch; two more turns at the ends."""
    return density * pi * pi * wire_diameter**2 * coil_diameter * (turns + 2) / 4


def coil_endurance(amplitude, mean, ultimate):
    """Fully reversed shear stress that a wire bears for ever, S_se = S_sa/(1 − S_sm/S_su).
    Source: Shigley, sec. 10-9 (Goodman's line through Zimmerli's point 1957). Validity: S_sm < S_su."""
    return amplitude / (1 - mean / ultimate)


def coil_upper_stress(lower_stress, endurance, ultimate):
    """Upper shear stress a wire bears for ever, τ_O = [2 S_se S_su + τ_U (S_su − S_se)]/(S_su + S_se).
    Source: Shigley, sec. 10-9 (Goodman: τ_a/S_se + τ_m/S_su = 1); stresses with k_τ, as EN 13906-1 has them. Validity:
    Wire not shot peened, diameter up to about 10 mm."""
    return (2 * endurance * ultimate + lower_stress * (ultimate - endurance)) / (ultimate + endurance)


def coil_buckling_root(coil_diameter, free_length, modulus_ratio, seating, pi):
    """Radicand of the deflection of buckling, 1 − (1 − G/E)/(½ + G/E) [π D/(ν L_0)]².
    Source: EN 13906-1 (Haringx 1948); handbook, chapter 11. Validity: Negative where the spring never buckles."""
    slender = pi * coil_diameter / (seating * free_length)
    return 1 - (1 - modulus_ratio) / (0.5 + modulus_ratio) * slender**2


def coil_buckling_deflection(free_length, modulus_ratio, root):
    """Deflection at which a coil spring without guide buckles, s_K = L_0 (1 − √q)/[2 (1 − G/E)].
    Source: EN 13906-1 (Haringx 1948); handbook, chapter 11. Validity: q ≥ 0."""
    return free_length * (1 - root**0.5) / (2 * (1 - modulus_ratio))
