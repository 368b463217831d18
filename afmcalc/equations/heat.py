"""Heat and wear of a trip (handbook, chapters 9 and 10)."""

from typing import Annotated

from .terms import *


def run_down_time(
    inertia: MotorInertia, speed: MotorSpeedAtSlip, torque: SlipTorque, motor_torque: MotorTorque
) -> SlipDuration:
    """Slip until the motor side stands, the tool being blocked, J_1 ω_0/(T − M_1).

    Source: Handbook, chapter 9, V1.
    Validity: T > M_1, both constant.
    """
    return inertia * speed / (torque - motor_torque)


def run_down_energy(
    inertia: MotorInertia, speed: MotorSpeedAtSlip, torque: SlipTorque, motor_torque: MotorTorque
) -> TripHeat:
    """Heat of a slip until the motor side stands, ½ J_1 ω_0² T/(T − M_1).

    Source: Handbook, chapter 9, V1.
    Validity: T > M_1, both constant.
    """
    return inertia * speed * speed * torque / (2 * (torque - motor_torque))


def speed_after(
    speed: MotorSpeedAtSlip, inertia: MotorInertia, torque: SlipTorque, motor_torque: MotorTorque, time: Time
) -> MotorSpeed:
    """Speed of the motor side while the clutch slips, ω_0 − (T − M_1) t/J_1.

    Source: Handbook, chapter 9, V1 (balance of the motor side).
    Validity: Until ω = 0.
    """
    return speed - (torque - motor_torque) * time / inertia


def slip_energy(torque: SlipTorque, speed: SlipSpeedStart, speed_end: SlipSpeedEnd, time: SlipDuration) -> TripHeat:
    """Heat of a slip whose speed changes evenly, T (ω_0 + ω) t/2.

    Source: Handbook, chapter 10; at an even speed Q = T ω t.
    Validity: T constant.
    """
    return torque * (speed + speed_end) * time / 2


def friction_area(inner_radius: InnerRadius, outer_radius: OuterRadius, pi: Pi) -> PairArea:
    """Area of a pair of faces, π (r_o² − r_i²).

    Source: Handbook, chapter 10.
    Validity: Full rings; grooves and sectors reduce it.
    """
    return pi * (outer_radius**2 - inner_radius**2)


def specific_work(energy: TripHeat, pairs: Pairs, area: PairArea) -> Annotated[Number, "q_A", "J/m^2"]:
    """Specific work of a trip, Q/(z A).

    Source: Handbook, chapter 10.
    Validity: All pairs alike.
    """
    return energy / (pairs * area)


def slip_power(torque: SlipTorque, speed: SlipSpeed) -> SlipPower:
    """Power of a slip, T ω.

    Source: Handbook, chapter 10.
    """
    return torque * speed


def power_density(power: SlipPower, pairs: Pairs, area: PairArea) -> Annotated[Number, "q", "W/m^2"]:
    """Power per area of a pair, P/(z A).

    Source: Handbook, chapter 10.
    Validity: All pairs alike.
    """
    return power / (pairs * area)


def temperature_rise(energy: TripHeat, mass: DiscsMass, specific_heat: SpecificHeat) -> TripRise:
    """Mean rise of temperature of the discs by a trip, Q/(m c).

    Source: Handbook, chapter 10.
    Validity: No cooling during the trip; nothing flows into linings and housing.
    """
    return energy / (mass * specific_heat)


def effusivity(conductivity: Conductivity, density: Density, specific_heat: SpecificHeat) -> Effusivity:
    """Square root of k ρ c, by which bodies in contact share the heat.

    Source: Carslaw & Jaeger, Conduction of Heat in Solids (1959), 2.9 and 2.15; handbook, chapter 10.
    Validity: Half-spaces.
    """
    return (conductivity * density * specific_heat) ** 0.5


def face_admittance(
    effusivity: Effusivity, root: TransformRoot, through: HeatThrough
) -> Annotated[Number, "Y", "W/m^2/K"]:
    """Flux into a face per rise of it, both as Laplace transforms: b √p tanh(l √(p/a)).

    Source: Carslaw & Jaeger, Conduction of Heat in Solids (1959), 2.9 and 3.8, transformed; handbook, chapter 10.
    Validity: A layer of the depth l, evenly warm at first, that loses no heat at its back; bodies whose faces are
        equally hot share the flux, and their admittances add up.
    """
    return effusivity * root * through


def heated_depth(mass: DiscsMass, density: Density, pairs: Pairs, area: PairArea) -> DiscDepth:
    """Depth of disc that a face has to heat, m/(ρ z A).

    Source: Handbook, chapter 10: the mass of the discs shared among the pairs.
    Validity: One face of each pair is a disc's.
    """
    return mass / (density * pairs * area)


def fourier_number(
    conductivity: Conductivity, density: Density, specific_heat: SpecificHeat, time: Time, depth: DiscDepth
) -> Annotated[Number, "Fo", "1"]:
    """How far the heat has come in a time, k t/(ρ c l²).

    Source: Carslaw & Jaeger, Conduction of Heat in Solids (1959), 3.3; handbook, chapter 10.
    """
    return conductivity * time / (density * specific_heat * depth * depth)


def share_of_rise(
    temperature: ReachedTemperature, ambient: StartTemperature, temperature_limit: TemperatureLimit
) -> Annotated[Number, "η_Θ", "1"]:
    """Share that a temperature uses of the rise that a limit allows, (Θ − Θ_0)/(Θ_max − Θ_0).

    Source: Handbook, chapter 10; a ratio of absolute temperatures would be no share.
    Validity: Θ_0 < Θ_max.
    """
    return (temperature - ambient) / (temperature_limit - ambient)


def trips_without_cooling(
    temperature_limit: TemperatureLimit, ambient: StartTemperature, rise: TripRise
) -> Annotated[Number, "n_Θ", "1"]:
    """Trips one upon the other until the discs reach a limit, (Θ_max − Θ_0)/ΔΘ.

    Source: Handbook, chapter 10.
    Validity: No cooling between them.
    """
    return (temperature_limit - ambient) / rise


def trips_per_time(
    cooling: Cooling, temperature_limit: TemperatureLimit, ambient: SurroundingTemperature, energy: TripHeat
) -> Annotated[Number, "ν", "1/s"]:
    """Trips per time whose heat is given off at the limit, α A_c (Θ_max − Θ_0)/Q.

    Source: Handbook, chapter 10.
    Validity: Mean temperature over many trips; each trip goes beyond it by up to ΔΘ.
    """
    return cooling * (temperature_limit - ambient) / energy


def trips_to_wear_out(
    pairs: Pairs, area: PairArea, lining: LiningThickness, wear: SpecificWear, energy: TripHeat
) -> Annotated[Number, "n_w", "1"]:
    """Trips until the lining is gone, z A s_w/(w Q).

    Source: Handbook, chapter 10.
    Validity: Wear per energy does not depend on temperature.
    """
    return pairs * area * lining / (wear * energy)


def setting_loss_per_wear(
    stiffness: FollowingStiffness, pairs: Pairs, force: PackForce
) -> Annotated[Number, "ΔF/(F δ)", "1/m"]:
    """Share of the force on the pack lost per wear of a pair, c_п z/F.

    Source: Handbook, chapter 10.
    Validity: Linear spring that is not re-adjusted.
    """
    return stiffness * pairs / force


def time_between_trips(
    mass: DiscsMass, specific_heat: SpecificHeat, cooling: Cooling, logarithm: CoolingLogarithm
) -> Annotated[Number, "t_p", "s"]:
    """Time between trips after each of which the discs just reach a limit, m c λ/(α A_c).

    Source: Handbook, chapter 10: one body that cools between trips, when every trip is as the last.
    Validity: ΔΘ < Θ_max − Θ_0; the trip is short against the time between.
    """
    return mass * specific_heat * logarithm / cooling
