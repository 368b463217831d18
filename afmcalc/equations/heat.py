"""Heat and wear of a trip (theory of the drive, sections 9 and 10)."""

from ._types import Number


def run_down_time(inertia: Number, speed: Number, torque: Number, motor_torque: Number) -> Number:
    """Slip until the motor side stands, the tool being blocked, J_1 ω_0/(T − M_1).

    Source: Theory of the drive, V1.

    Args:
        inertia: J_1, moment of inertia of the motor side [kg*m^2].
        speed: ω_0, speed of the motor side as the slip begins [rad/s].
        torque: T, slip torque [N*m].
        motor_torque: M_1, torque of the motor [N*m].

    Returns:
        t [s].

    Validity:
        T > M_1, both constant.
    """
    return inertia * speed / (torque - motor_torque)


def run_down_energy(inertia: Number, speed: Number, torque: Number, motor_torque: Number) -> Number:
    """Heat of a slip until the motor side stands, ½ J_1 ω_0² T/(T − M_1).

    Source: Theory of the drive, V1.

    Args:
        inertia: J_1, moment of inertia of the motor side [kg*m^2].
        speed: ω_0, speed of the motor side as the slip begins [rad/s].
        torque: T, slip torque [N*m].
        motor_torque: M_1, torque of the motor [N*m].

    Returns:
        Q [J].

    Validity:
        T > M_1, both constant.
    """
    return inertia * speed * speed * torque / (2 * (torque - motor_torque))


def speed_after(speed: Number, inertia: Number, torque: Number, motor_torque: Number, time: Number) -> Number:
    """Speed of the motor side while the clutch slips, ω_0 − (T − M_1) t/J_1.

    Source: Theory of the drive, V1 (balance of the motor side).

    Args:
        speed: ω_0, speed of the motor side as the slip begins [rad/s].
        inertia: J_1, moment of inertia of the motor side [kg*m^2].
        torque: T, slip torque [N*m].
        motor_torque: M_1, torque of the motor [N*m].
        time: t, since the slip began [s].

    Returns:
        ω [rad/s].

    Validity:
        Until ω = 0.
    """
    return speed - (torque - motor_torque) * time / inertia


def slip_energy(torque: Number, speed: Number, speed_end: Number, time: Number) -> Number:
    """Heat of a slip whose speed changes evenly, T (ω_0 + ω) t/2.

    Source: Theory of the drive, section 10; at an even speed Q = T ω t.

    Args:
        torque: T, slip torque [N*m].
        speed: ω_0, slip speed as the slip begins [rad/s].
        speed_end: ω, slip speed as it ends [rad/s].
        time: t, it lasts [s].

    Returns:
        Q [J].

    Validity:
        T constant.
    """
    return torque * (speed + speed_end) * time / 2


def friction_area(inner_radius: Number, outer_radius: Number, pi: Number) -> Number:
    """Area of a pair of faces, π (r_o² − r_i²).

    Source: Theory of the drive, section 10.

    Args:
        inner_radius: r_i [m].
        outer_radius: r_o [m].
        pi: π, a symbol under SymPy [1].

    Returns:
        A [m^2].

    Validity:
        Full rings; grooves and sectors take from it.
    """
    return pi * (outer_radius**2 - inner_radius**2)


def specific_work(energy: Number, pairs: Number, area: Number) -> Number:
    """Specific work of a trip, Q/(z A).

    Source: Theory of the drive, section 10.

    Args:
        energy: Q, heat of a trip [J].
        pairs: z, number of friction pairs [1].
        area: A, area of a pair [m^2].

    Returns:
        q_A [J/m^2].

    Validity:
        All pairs alike.
    """
    return energy / (pairs * area)


def power_density(torque: Number, speed: Number, pairs: Number, area: Number) -> Number:
    """Power per area of a pair, T ω/(z A).

    Source: Theory of the drive, section 10.

    Args:
        torque: T, slip torque [N*m].
        speed: ω, speed of slip [rad/s].
        pairs: z, number of friction pairs [1].
        area: A, area of a pair [m^2].

    Returns:
        q [W/m^2].

    Validity:
        All pairs alike.
    """
    return torque * speed / (pairs * area)


def temperature_rise(energy: Number, mass: Number, specific_heat: Number) -> Number:
    """Mean rise of temperature of the discs by a trip, Q/(m c).

    Source: Theory of the drive, section 10.

    Args:
        energy: Q, heat of a trip [J].
        mass: m, mass of the discs that take it [kg].
        specific_heat: c, specific heat of the discs [J/kg/K].

    Returns:
        ΔΘ [K].

    Validity:
        No cooling during the trip; nothing flows into linings and housing.
    """
    return energy / (mass * specific_heat)


def effusivity(conductivity: Number, density: Number, specific_heat: Number) -> Number:
    """Square root of k ρ c, by which bodies in contact share the heat.

    Source: Carslaw & Jaeger, Conduction of Heat in Solids (1959), 2.9 and 2.15; theory of the drive, section 10.

    Args:
        conductivity: k, thermal conductivity [W/m/K].
        density: ρ [kg/m^3].
        specific_heat: c, specific heat [J/kg/K].

    Returns:
        b [W*s^0.5/m^2/K].

    Validity:
        Half-spaces.
    """
    return (conductivity * density * specific_heat) ** 0.5


def share_of_flux(own: Number, other: Number) -> Number:
    """Share of the heat that one of two bodies takes, b/(b + b_l).

    Source: Theory of the drive, section 10.

    Args:
        own: b, effusivity of the body [W*s^0.5/m^2/K].
        other: b_l, effusivity of the other [W*s^0.5/m^2/K].

    Returns:
        β [1].

    Validity:
        Half-spaces whose surfaces are equally hot.
    """
    return own / (own + other)


def surface_rise(flux: Number, fall: Number, time: Number, effusivity: Number, pi: Number) -> Number:
    """Rise of a surface under a flux that falls evenly, 2 (q_0 − ⅔ s t) √(t/π)/b.

    Source: Carslaw & Jaeger, Conduction of Heat in Solids (1959), 2.9 (7), by Duhamel; theory of the drive, section 10.

    Args:
        flux: q_0, into the surface as the slip begins [W/m^2].
        fall: s, how fast the flux falls; 0 for a constant one [W/m^2/s].
        time: t, since the slip began [s].
        effusivity: b, √(k ρ c) [W*s^0.5/m^2/K].
        pi: π, a symbol under SymPy [1].

    Returns:
        ΔΘ_s [K].

    Validity:
        A half-space: the heat has not reached the middle of the disc, k t/(ρ c l²) < 0.05.
    """
    return 2 * (flux - 2 * fall * time / 3) * (time / pi) ** 0.5 / effusivity


def surface_rise_thin(
    flux: Number,
    fall: Number,
    time: Number,
    conductivity: Number,
    density: Number,
    specific_heat: Number,
    depth: Number,
) -> Number:
    """Rise of a face whose heat has come through, (q_0 − s t/2) t/(ρ c l) + (q_0 − s t) l/(3 k) + s ρ c l³/(45 k²).

    Source: Carslaw & Jaeger, Conduction of Heat in Solids (1959), 3.8 (3), by Duhamel; theory of the drive, section 10.

    Args:
        flux: q_0, into the face as the slip begins [W/m^2].
        fall: s, how fast the flux falls; 0 for a constant one [W/m^2/s].
        time: t, since the slip began [s].
        conductivity: k, thermal conductivity [W/m/K].
        density: ρ [kg/m^3].
        specific_heat: c, specific heat [J/kg/K].
        depth: l, depth to the middle of the disc [m].

    Returns:
        ΔΘ_s [K].

    Validity:
        k t/(ρ c l²) > 1; before that less the terms of ``surface_rise_term``.
    """
    mean = (flux - fall * time / 2) * time / (density * specific_heat * depth)
    across = (flux - fall * time) * depth / (3 * conductivity)
    return mean + across + fall * density * specific_heat * depth**3 / (45 * conductivity**2)


def surface_rise_term(
    flux: Number,
    fall: Number,
    order: Number,
    exponential: Number,
    conductivity: Number,
    density: Number,
    specific_heat: Number,
    depth: Number,
    pi: Number,
) -> Number:
    """What a wave of the disc's temperature still lacks at the face, 2 l e_n/(π² k n²) [q_0 + s ρ c l²/(π² k n²)].

    Source: Carslaw & Jaeger, Conduction of Heat in Solids (1959), 3.8 (3), by Duhamel; theory of the drive, section 10.

    Args:
        flux: q_0, into the face as the slip begins [W/m^2].
        fall: s, how fast the flux falls; 0 for a constant one [W/m^2/s].
        order: n, number of half waves, 1, 2, … [1].
        exponential: e_n, exp(−n² π² k t/(ρ c l²)) [1].
        conductivity: k, thermal conductivity [W/m/K].
        density: ρ [kg/m^3].
        specific_heat: c, specific heat [J/kg/K].
        depth: l, depth to the middle of the disc [m].
        pi: π, a symbol under SymPy [1].

    Returns:
        ΔΘ_n [K].

    Validity:
        None.
    """
    wave = pi * pi * conductivity * order * order
    return 2 * depth * exponential * (flux + fall * density * specific_heat * depth**2 / wave) / wave


def heated_depth(mass: Number, density: Number, pairs: Number, area: Number) -> Number:
    """Depth of disc that a face has to heat, m/(ρ z A).

    Source: Theory of the drive, section 10: the mass of the discs shared among the pairs.

    Args:
        mass: m, mass of the discs that take the heat [kg].
        density: ρ [kg/m^3].
        pairs: z, number of friction pairs [1].
        area: A, area of a pair [m^2].

    Returns:
        l [m].

    Validity:
        One face of each pair is a disc's.
    """
    return mass / (density * pairs * area)


def fourier_number(conductivity: Number, density: Number, specific_heat: Number, time: Number, depth: Number) -> Number:
    """How far the heat has come in a time, k t/(ρ c l²).

    Source: Carslaw & Jaeger, Conduction of Heat in Solids (1959), 3.3; theory of the drive, section 10.

    Args:
        conductivity: k, thermal conductivity [W/m/K].
        density: ρ [kg/m^3].
        specific_heat: c, specific heat [J/kg/K].
        time: t [s].
        depth: l, depth to the middle of the disc [m].

    Returns:
        Fo [1].

    Validity:
        None.
    """
    return conductivity * time / (density * specific_heat * depth * depth)


def trips_without_cooling(temperature_limit: Number, ambient: Number, rise: Number) -> Number:
    """Trips one upon the other until the discs reach a limit, (Θ_max − Θ_0)/ΔΘ.

    Source: Theory of the drive, section 10.

    Args:
        temperature_limit: Θ_max, largest temperature the discs may have [K].
        ambient: Θ_0, temperature before the first trip [K].
        rise: ΔΘ, rise by a trip [K].

    Returns:
        n [1].

    Validity:
        No cooling between them.
    """
    return (temperature_limit - ambient) / rise


def trips_per_time(cooling: Number, temperature_limit: Number, ambient: Number, energy: Number) -> Number:
    """Trips per time whose heat is given off at the limit, α A_c (Θ_max − Θ_0)/Q.

    Source: Theory of the drive, section 10.

    Args:
        cooling: α A_c, heat given off per kelvin [W/K].
        temperature_limit: Θ_max, largest temperature the discs may have [K].
        ambient: Θ_0, temperature of the surroundings [K].
        energy: Q, heat of a trip [J].

    Returns:
        ν [1/s].

    Validity:
        Mean temperature over many trips; each trip goes beyond it by up to ΔΘ.
    """
    return cooling * (temperature_limit - ambient) / energy


def trips_to_wear_out(pairs: Number, area: Number, lining: Number, wear: Number, energy: Number) -> Number:
    """Trips until the lining is gone, z A s_w/(w Q).

    Source: Theory of the drive, section 10.

    Args:
        pairs: z, number of friction pairs [1].
        area: A, area of a pair [m^2].
        lining: s_w, thickness that a pair may lose [m].
        wear: w, volume worn per energy [m^3/J].
        energy: Q, heat of a trip [J].

    Returns:
        n_w [1].

    Validity:
        Wear per energy does not depend on temperature.
    """
    return pairs * area * lining / (wear * energy)


def setting_loss_per_wear(stiffness: Number, pairs: Number, force: Number) -> Number:
    """Share of the force on the pack lost per wear of a pair, c z/F.

    Source: Theory of the drive, section 10.

    Args:
        stiffness: c, stiffness of the spring that follows the pack [N/m].
        pairs: z, number of friction pairs [1].
        force: F, force on the pack at rest [N].

    Returns:
        ΔF/(F δ) [1/m].

    Validity:
        Nobody sets the spring again; a straight spring.
    """
    return stiffness * pairs / force


def time_between_trips(mass: Number, specific_heat: Number, cooling: Number, logarithm: Number) -> Number:
    """Time between trips after each of which the discs just reach a limit, m c λ/(α A_c).

    Source: Theory of the drive, section 10: one body that cools between trips, when every trip is as the last.

    Args:
        mass: m, mass of the discs that take the heat [kg].
        specific_heat: c, specific heat of the discs [J/kg/K].
        cooling: α A_c, heat given off per kelvin [W/K].
        logarithm: λ, −ln(1 − ΔΘ/(Θ_max − Θ_0)), of the share of the limit that a trip leaves [1].

    Returns:
        t_p [s].

    Validity:
        ΔΘ < Θ_max − Θ_0; the trip is short against the time between.
    """
    return mass * specific_heat * logarithm / cooling
