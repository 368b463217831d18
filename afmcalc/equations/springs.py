"""Disc springs and stacks of them."""

from ._types import Number


def disc_factor_load(diameter_ratio: Number, logarithm: Number, pi: Number) -> Number:
    """Factor of a disc spring's load, K_1 = ((δ − 1)/δ)²/{π[(δ + 1)/(δ − 1) − 2/ln δ]}.

    Source: DIN EN 16984 (Almen & László 1936); theory of the drive, section 11.

    Args:
        diameter_ratio: δ, outer over inner diameter [1].
        logarithm: ln δ [1].
        pi: π, a symbol under SymPy [1].

    Returns:
        K_1 [1].

    Validity:
        δ > 1.
    """
    ratio = diameter_ratio
    return ((ratio - 1) / ratio) ** 2 / (pi * ((ratio + 1) / (ratio - 1) - 2 / logarithm))


def disc_factor_membrane(diameter_ratio: Number, logarithm: Number, pi: Number) -> Number:
    """Factor of the stress by turning inside out, K_2 = (6/π)[(δ − 1)/ln δ − 1]/ln δ.

    Source: DIN EN 16984 (Almen & László 1936); theory of the drive, section 11.

    Args:
        diameter_ratio: δ, outer over inner diameter [1].
        logarithm: ln δ [1].
        pi: π, a symbol under SymPy [1].

    Returns:
        K_2 [1].

    Validity:
        δ > 1.
    """
    return 6 * ((diameter_ratio - 1) / logarithm - 1) / (pi * logarithm)


def disc_factor_bending(diameter_ratio: Number, logarithm: Number, pi: Number) -> Number:
    """Factor of the stress by bending, K_3 = (3/π)(δ − 1)/ln δ.

    Source: DIN EN 16984 (Almen & László 1936); theory of the drive, section 11.

    Args:
        diameter_ratio: δ, outer over inner diameter [1].
        logarithm: ln δ [1].
        pi: π, a symbol under SymPy [1].

    Returns:
        K_3 [1].

    Validity:
        δ > 1.
    """
    return 3 * (diameter_ratio - 1) / (pi * logarithm)


def disc_factor_flats(thickness: Number, reduced_thickness: Number, free_height: Number) -> Number:
    """Factor of a disc spring with flats, K_4² = −c_1/2 + √(c_1²/4 + c_2).

    Source: DIN EN 16984; theory of the drive, section 11: the force at ¾ of the cone height stays that of a plain disc.

    Args:
        thickness: t, thickness of the disc without flats [m].
        reduced_thickness: t', reduced thickness as made [m].
        free_height: l_0, free height of the disc [m].

    Returns:
        K_4 [1].

    Validity:
        t' ≤ t; without flats K_4 = 1.
    """
    reduced, height = reduced_thickness / thickness, free_height / thickness
    first = reduced**2 / ((height / 4 - reduced + 0.75) * (5 * height / 8 - reduced + 0.375))
    second = first * (5 * (height - 1) ** 2 / 32 + 1) / reduced**3
    return ((first**2 / 4 + second) ** 0.5 - first / 2) ** 0.5


def disc_force(
    modulus: Number,
    poisson: Number,
    factor_load: Number,
    factor_flats: Number,
    outer_diameter: Number,
    thickness: Number,
    cone_height: Number,
    deflection: Number,
) -> Number:
    """Force of a disc spring, 4E/(1 − ν²) t³ s K_4²/(K_1 D_e²) [K_4² (h_0/t − s/t)(h_0/t − s/(2t)) + 1].

    Source: DIN EN 16984 (Almen & László 1936); theory of the drive, section 11.

    Args:
        modulus: E, Young's modulus [Pa].
        poisson: ν, Poisson's ratio [1].
        factor_load: K_1 [1].
        factor_flats: K_4 [1].
        outer_diameter: D_e [m].
        thickness: t, thickness of the disc; with flats t' [m].
        cone_height: h_0, l_0 − t, with flats l_0 − t' [m].
        deflection: s, deflection of the disc [m].

    Returns:
        F [N].

    Validity:
        0 ≤ s ≤ h_0; beyond ¾ of it the lever shortens, the true force is larger.
    """
    square = factor_flats * factor_flats
    rigid = 4 * modulus * thickness * deflection * square / ((1 - poisson * poisson) * factor_load * outer_diameter**2)
    return rigid * (square * (cone_height - deflection) * (cone_height - deflection / 2) + thickness**2)


def disc_stiffness(
    modulus: Number,
    poisson: Number,
    factor_load: Number,
    factor_flats: Number,
    outer_diameter: Number,
    thickness: Number,
    cone_height: Number,
    deflection: Number,
) -> Number:
    """Stiffness of a disc spring, 4E/(1 − ν²) t K_4²/(K_1 D_e²) [K_4² (h_0² − 3 h_0 s + 3 s²/2) + t²].

    Source: DIN EN 16984 (Almen & László 1936), derivative of the force; theory of the drive, section 11.

    Args:
        modulus: E, Young's modulus [Pa].
        poisson: ν, Poisson's ratio [1].
        factor_load: K_1 [1].
        factor_flats: K_4 [1].
        outer_diameter: D_e [m].
        thickness: t, thickness of the disc; with flats t' [m].
        cone_height: h_0, l_0 − t, with flats l_0 − t' [m].
        deflection: s, deflection of the disc [m].

    Returns:
        k [N/m].

    Validity:
        0 ≤ s ≤ h_0.
    """
    square = factor_flats * factor_flats
    rigid = 4 * modulus * thickness * square / ((1 - poisson * poisson) * factor_load * outer_diameter**2)
    return rigid * (square * (cone_height**2 - 3 * cone_height * deflection + 3 * deflection**2 / 2) + thickness**2)


def disc_stress(
    modulus: Number,
    poisson: Number,
    factor_load: Number,
    factor_flats: Number,
    outer_diameter: Number,
    thickness: Number,
    cone_height: Number,
    deflection: Number,
    membrane: Number,
    bending: Number,
) -> Number:
    """Stress of a disc spring at an edge, −4E/(1 − ν²) s K_4/(K_1 D_e²) [K_4 K_m (h_0 − s/2) + K_b t].

    Source: DIN EN 16984 (Almen & László 1936); theory of the drive, section 11.

    Args:
        modulus: E, Young's modulus [Pa].
        poisson: ν, Poisson's ratio [1].
        factor_load: K_1 [1].
        factor_flats: K_4 [1].
        outer_diameter: D_e [m].
        thickness: t, thickness of the disc; with flats t' [m].
        cone_height: h_0, l_0 − t, with flats l_0 − t' [m].
        deflection: s, deflection of the disc [m].
        membrane: K_m, factor of the membrane: of edge I and II K_2, of III and IV (K_2 − 2 K_3)/δ, of OM 0 [1].
        bending: K_b, factor of bending: of I K_3, of II −K_3, of III −K_3/δ, of IV K_3/δ, of OM 3/π [1].

    Returns:
        σ, tension positive [Pa].

    Validity:
        Elastic, without what shot peening and setting leave.
    """
    rigid = -4 * modulus * deflection * factor_flats / ((1 - poisson * poisson) * factor_load * outer_diameter**2)
    return rigid * (factor_flats * membrane * (cone_height - deflection / 2) + bending * thickness)


def stack_length(parallel: Number, series: Number, free_height: Number, thickness: Number) -> Number:
    """Length of a stack of disc springs without load, i [l_0 + (n − 1) t].

    Source: DIN EN 16984; theory of the drive, section 11.

    Args:
        parallel: n, discs laid into each other [1].
        series: i, such packs against each other [1].
        free_height: l_0, free height of a disc [m].
        thickness: t, thickness of the disc; with flats t' [m].

    Returns:
        L_0 [m].

    Validity:
        None.
    """
    return series * (free_height + (parallel - 1) * thickness)


def stack_force_with_friction(
    force: Number, parallel: Number, surface_friction: Number, edge_friction: Number
) -> Number:
    """Force of a stack that friction holds, n F/[1 − w_M (n − 1) − w_R]; on the way back both signs are the other.

    Source: DIN EN 16984; theory of the drive, section 11.

    Args:
        force: n F, force of the stack without friction [N].
        parallel: n, discs laid into each other [1].
        surface_friction: w_M, friction of the cones on each other; on the way back −w_M [1].
        edge_friction: w_R, friction of the edges; on the way back −w_R [1].

    Returns:
        F_R [N].

    Validity:
        w_M (n − 1) + w_R < 1.
    """
    return force / (1 - surface_friction * (parallel - 1) - edge_friction)


def ring_mass(density: Number, outer_diameter: Number, inner_diameter: Number, thickness: Number, pi: Number) -> Number:
    """Mass of a disc, ρ π/4 (D_e² − D_i²) t.

    Source: Theory of the drive, section 11: volume of a ring.

    Args:
        density: ρ [kg/m^3].
        outer_diameter: D_e [m].
        inner_diameter: D_i [m].
        thickness: t, thickness of the disc; with flats t' [m].
        pi: π, a symbol under SymPy [1].

    Returns:
        m [kg].

    Validity:
        A flat cone.
    """
    return density * pi * (outer_diameter**2 - inner_diameter**2) * thickness / 4
