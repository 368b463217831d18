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


def slip_power(torque: Number, speed: Number) -> Number:
    """Power of a slip, T ω.

    Source: Theory of the drive, section 10.

    Args:
        torque: T, slip torque [N*m].
        speed: ω, speed of slip [rad/s].

    Returns:
        P [W].

    Validity:
        None.
    """
    return torque * speed


def power_density(power: Number, pairs: Number, area: Number) -> Number:
    """Power per area of a pair, P/(z A).

    Source: Theory of the drive, section 10.

    Args:
        power: P, power of the slip [W].
        pairs: z, number of friction pairs [1].
        area: A, area of a pair [m^2].

    Returns:
        q [W/m^2].

    Validity:
        All pairs alike.
    """
    return power / (pairs * area)


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


def face_admittance(effusivity: Number, root: Number, through: Number) -> Number:
    """Flux into a face per rise of it, both as Laplace transforms: b √p tanh(l √(p/a)).

    Source: Carslaw & Jaeger, Conduction of Heat in Solids (1959), 2.9 and 3.8, transformed; theory of the drive, 10.

    Args:
        effusivity: b, √(k ρ c) [W*s^0.5/m^2/K].
        root: √p, root of the variable of the transform [1/s^0.5].
        through: tanh(l √(p/a)), how far the heat comes in 1/p; 1 in a half-space [1].

    Returns:
        Y [W/m^2/K].

    Validity:
        A layer of the depth l behind which no heat leaves, evenly warm at first; bodies whose faces are equally hot
        share the flux, and their admittances add up.
    """
    return effusivity * root * through


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


def share_of_rise(temperature: Number, ambient: Number, temperature_limit: Number) -> Number:
    """Share that a temperature uses of the rise that a limit allows, (Θ − Θ_0)/(Θ_max − Θ_0).

    Source: Theory of the drive, section 10; a ratio of absolute temperatures would be no share.

    Args:
        temperature: Θ, temperature that is reached [K].
        ambient: Θ_0, temperature at the start [K].
        temperature_limit: Θ_max, largest temperature that is allowed [K].

    Returns:
        η [1].

    Validity:
        Θ_0 < Θ_max.
    """
    return (temperature - ambient) / (temperature_limit - ambient)


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
    """Share of the force on the pack lost per wear of a pair, c_п z/F.

    Source: Theory of the drive, section 10.

    Args:
        stiffness: c_п, stiffness of the spring that follows the pack [N/m].
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
