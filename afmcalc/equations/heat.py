"""Heat and wear of a trip (handbook, chapters 9 and 10)."""


def run_down_time(inertia, speed, torque, motor_torque):
    """Time of slip until the motor side stands still, with the tool blocked, J_1 ω_0/(T − M_1).
    Source: Handbook, chapter 9, V1. Validity: T > M_1, both constant."""
    return inertia * speed / (torque - motor_torque)


def speed_after(speed, inertia, torque, motor_torque, time):
    """Speed of the motor side while the clutch slips, ω_0 − (T − M_1) t/J_1.
    Source: Handbook, chapter 9, V1 (balance of the motor side). Validity: Until ω = 0."""
    return speed - (torque - motor_torque) * time / inertia


def slip_energy(torque, speed, speed_end, time):
    """Heat of a slip whose speed changes evenly, T (ω_0 + ω) t/2.
    Source: Handbook, chapter 10; at an even speed Q = T ω t. Validity: T constant."""
    return torque * (speed + speed_end) * time / 2


def friction_area(inner_radius, outer_radius, pi):
    """Area of a pair of faces, π (r_o² − r_i²).
    Source: Handbook, chapter 10. Validity: Full rings; grooves and sectors reduce it."""
    return pi * (outer_radius**2 - inner_radius**2)


def specific_work(energy, pairs, area):
    """Specific work of a trip, Q/(z A). Source: Handbook, chapter 10. Validity: All pairs alike."""
    return energy / (pairs * area)


def slip_power(torque, speed):
    """Power of a slip, T ω. Source: Handbook, chapter 10."""
    return torque * speed


def power_density(power, pairs, area):
    """Power per area of a pair, P/(z A). Source: Handbook, chapter 10. Validity: All pairs alike."""
    return power / (pairs * area)


def temperature_rise(energy, mass, specific_heat):
    """Mean rise of temperature of the discs by a trip, Q/(m c).
    Source: Handbook, chapter 10. Validity: No cooling during the trip; nothing flows into linings and housing."""
    return energy / (mass * specific_heat)


def heated_depth(mass, density, pairs, area):
    """Depth of disc that a face has to heat, m/(ρ z A).
    Source: Handbook, chapter 10: the mass of the discs shared among the pairs. Validity: One face of each pair is a
    disc's."""
    return mass / (density * pairs * area)


def share_of_rise(temperature, ambient, temperature_limit):
    """Share that a temperature uses of the rise that a limit allows, (Θ − Θ_0)/(Θ_max − Θ_0).
    Source: Handbook, chapter 10; a ratio of absolute temperatures would be no share. Validity: Θ_0 < Θ_max."""
    return (temperature - ambient) / (temperature_limit - ambient)


def trips_without_cooling(temperature_limit, ambient, rise):
    """Trips one upon the other until the discs reach a limit, (Θ_max − Θ_0)/ΔΘ.
    Source: Handbook, chapter 10. Validity: No cooling between them."""
    return (temperature_limit - ambient) / rise


def trips_per_time(cooling, temperature_limit, ambient, energy):
    """Trips per time whose heat is given off at the limit, α A_c (Θ_max − Θ_0)/Q.
    Source: Handbook, chapter 10. Validity: Mean temperature over many trips; each trip goes beyond it by up to ΔΘ."""
    return cooling * (temperature_limit - ambient) / energy


def trips_to_wear_out(pairs, area, lining, wear, energy):
    """Trips until the lining is gone, z A s_w/(w Q).
    Source: Handbook, chapter 10. Validity: Wear per energy does not depend on temperature."""
    return pairs * area * lining / (wear * energy)


def setting_loss_per_wear(stiffness, pairs, force):
    """Share of the force on the pack lost per wear of a pair, c_п z/F.
    Source: Handbook, chapter 10. Validity: Linear spring that is not re-adjusted."""
    return stiffness * pairs / force


def time_between_trips(mass, specific_heat, cooling, logarithm):
    """Time between trips at which each of them warms the discs just to the allowable temperature, m c λ/(α A_c).
    Source: Handbook, chapter 10: one body that cools between trips, which are all alike. Validity: ΔΘ < Θ_max − Θ_0;
    the trip is short against the time between."""
    return mass * specific_heat * logarithm / cooling
