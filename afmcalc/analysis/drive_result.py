"""Results of a simulation of the drive."""

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, Literal

from ..result import Answer, OpenTriple, Result, Series, Triple, quantity

if TYPE_CHECKING:
    from ..spec.models import Drive

NOT_ENDED = "not ended"
"""Text for a slip that does not end: the motor keeps it going, or the simulated time is too short (see findings)."""


def _open(unit: str, symbol: str, description: str, **shown: Any) -> Any:
    """Declare a field that is left out where it does not apply; people are told of a slip that does not end."""
    return quantity(unit, symbol, description, optional=True, null=NOT_ENDED, **shown)


def ends_of(values: Iterable[Any]) -> dict[str, Any]:
    """Values at f_min, mean friction and f_max as fields of a ``Triple``, or of an ``OpenTriple``."""
    return dict(zip(("min", "mean", "max"), values, strict=True))


class SimulatePoint(Result):
    """The event at one chosen friction."""

    friction: float | None = quantity("1", "f", "coefficient of friction of all pairs", optional=True)
    friction_driving: float | None = quantity("1", "f_1", "friction of the driving pairs", optional=True)
    friction_driven: float | None = quantity("1", "f_2", "friction of the driven pairs", optional=True)
    sliding_torque: float = quantity("N*m", "T", "sliding torque")
    peak_torque: float = quantity("N*m", "T_peak", "peak torque in the shaft")
    peak_torque_clutch: float = quantity("N*m", "T_peak,c", "peak torque at the clutch")
    dynamic_factor: float = quantity("1", "k_д", "peak torque in the shaft over sliding torque")
    slip_time: float | None = quantity("s", "t_s", "time of slip", null=NOT_ENDED, digits=3)
    slip_energy: float | None = quantity("J", "Q", "heat in the pack", null=NOT_ENDED)
    key_energy: float | None = _open("J", "Q_key", "energy lost at the key until the slip ends")
    travel_max: float | None = quantity("m", "x_max", "largest travel of the sleeve", optional=True)
    peak_torque_conventional: float = quantity("N*m", "T_peak,0", "peak torque with an ordinary clutch of equal T_н")


class SimulateSweep(Series):
    """Peaks over a swept key."""

    peak_torque_max: list[float] = quantity("N*m", "T_peak(f_max)", "peak torque in the shaft at f_max")
    peak_torque_mean: list[float] = quantity("N*m", "T_peak(f_cp)", "peak torque in the shaft at the mean friction")
    peak_torque_min: list[float] = quantity("N*m", "T_peak(f_min)", "peak torque in the shaft at f_min")
    peak_torque_bypass: list[float | None] | None = quantity(
        "N*m", "T_peak,1", "peak torque in the shaft at f_max if the bypass pairs alone carry", optional=True
    )
    dynamic_factor: list[float] = quantity("1", "k_д", "peak torque in the shaft over sliding torque at f_max")
    inertia_torque: list[float] = quantity("N*m", "T_J", "inertia torque ω_0 √(k (J_2 + J_h))")


class SimulateResult(Answer):
    """The event in the drive at f_min, mean friction and f_max; friction is constant during one event."""

    sliding_torque: Triple = quantity("N*m", "T", "sliding torque")
    peak_torque: Triple = quantity("N*m", "T_peak", "peak torque in the shaft")
    peak_torque_clutch: Triple = quantity("N*m", "T_peak,c", "peak torque at the clutch")
    peak_error: Triple = quantity("1", "δ", "change of the peak torque in the shaft against twice the time step")
    dynamic_factor: Triple = quantity("1", "k_д", "peak torque in the shaft over sliding torque")
    peak_over_machine: Triple | None = quantity("1", "T_peak/T_0", "peak torque over the load before it", optional=True)
    slip_time: OpenTriple = quantity("s", "t_s", "time of slip", null=NOT_ENDED, digits=3)
    slip_energy: OpenTriple = quantity("J", "Q", "heat in the pack", null=NOT_ENDED)
    slip_time_spread: OpenTriple | None = _open("1", "δ_t", "change of the time of slip against twice the time step")
    slip_energy_spread: OpenTriple | None = _open("1", "δ_Q", "change of the heat against twice the time step")
    key_energy: OpenTriple | None = _open("J", "Q_key", "energy lost at the key until the slip ends")
    travel_max: Triple | None = quantity("m", "x_max", "largest travel of the sleeve", optional=True)
    contact_force: Triple | None = quantity("N", "F_n", "largest contact force on one ball", optional=True)
    peak_torque_bypass: float | None = quantity(
        "N*m", "T_peak,1", "peak torque in the shaft at f_max if the bypass pairs alone carry", optional=True
    )
    peak_torque_conventional: Triple = quantity(
        "N*m", "T_peak,0", "peak torque in the shaft with an ordinary clutch of equal T_н"
    )
    trip_torque: OpenTriple | None = quantity(
        "N*m", "T_trip", "torque at which the clutch begins to slip", optional=True, null="no slip"
    )
    trip_position: OpenTriple | None = quantity(
        "1", "λ", "where the trip lies: 0 at T_муф (no lag), 1 at T_п (no release)", optional=True, null="no slip"
    )
    inertia_torque: float = quantity("N*m", "T_J", "inertia torque ω_0 √(k (J_2 + J_h)) of a sudden stop")
    load_torque: float = quantity("N*m", "T_0", "load before the event")
    energy_residual: float = quantity("1", "ε", "largest relative error of the energy balance")
    points: list[SimulatePoint] | None = quantity("", None, "at the friction asked for", optional=True)
    sweep: list[SimulateSweep] | None = quantity("", None, "peaks over the swept values", optional=True)
    heat: "HeatResult | None" = quantity("", None, "heat of the trip", optional=True)

    @property
    def judged_peak(self) -> float:
        """Largest peak torque in the shaft, N·m, also if the bypass pairs alone carry."""
        return max(self.peak_torque.min, self.peak_torque.mean, self.peak_torque.max, self.peak_torque_bypass or 0.0)

    @property
    def largest_dynamic_factor(self) -> float:
        """Largest ratio of peak shaft torque to sliding torque at one friction, also if bypass pairs alone carry."""
        slipping = max(self.dynamic_factor.min, self.dynamic_factor.mean, self.dynamic_factor.max)
        return max(slipping, (self.peak_torque_bypass or 0.0) / self.sliding_torque.max)


EnergySource = Literal["simulate", "run-down", "constant-speed"]


class HeatResult(Answer):
    """Heat and wear of one trip; what the spec does not allow to tell is left out."""

    energy_source: EnergySource = quantity("", None, "where time and heat of the slip are from")
    slip_time: OpenTriple = quantity("s", "t_s", "time of slip", null=NOT_ENDED, digits=3)
    energy: OpenTriple = quantity("J", "Q", "heat of a trip", null=NOT_ENDED)
    specific_work: OpenTriple | None = _open("J/m^2", "q_A", "work per area of a pair")
    power_density: Triple | None = quantity("W/m^2", "q", "largest power per area of a pair", optional=True)
    temperature_rise: OpenTriple | None = _open(
        "K", "ΔΘ_d", "mean rise of the discs by a trip, the lining taking its share"
    )
    temperature: OpenTriple | None = _open("K abs", "Θ", "mean temperature of the discs after a trip")
    surface_temperature_rise: OpenTriple | None = _open(
        "K", "ΔΘ_s", "largest rise of the faces during a trip, the lining taking its share"
    )
    face_temperature: OpenTriple | None = _open("K abs", "Θ_s", "largest temperature of the faces during a trip")
    temperature_limit: float | None = quantity(
        "K abs", "Θ_max", "allowable temperature, for the discs", optional=True, digits=5
    )
    trips_without_cooling: OpenTriple | None = quantity(
        "1", "n_Θ", "trips in immediate succession until the limit, no heat given off", optional=True, digits=3
    )
    trips_per_hour: OpenTriple | None = quantity(
        "1/h", "ν", "trips per hour, mean temperature at the limit", optional=True
    )
    trips_per_hour_peak: OpenTriple | None = quantity(
        "1/h", "ν_p", "trips per hour, temperature after each trip at the limit", optional=True
    )
    trips_to_wear_out: OpenTriple | None = quantity(
        "1", "n_w", "trips until the lining is gone", optional=True, digits=3
    )
    setting_loss_per_wear: float | None = quantity(
        "1/m", "ΔF/(F δ)", "share of the force on the pack lost per wear of a pair", optional=True, digits=3
    )
    setting_loss_worn: float | None = quantity(
        "1", "ΔF/F", "share of the force on the pack lost when the lining is gone", optional=True, digits=3
    )


def dynamic_factor(drive: "Drive", event: Callable[[], SimulateResult]) -> float:
    """Dynamic factor of the unprotected side: as in the spec, else the largest T_peak/T of the event, else 1."""
    if drive.dynamic_factor is not None or drive.event is None:
        return 1.0 if drive.dynamic_factor is None else drive.dynamic_factor
    return event().largest_dynamic_factor
