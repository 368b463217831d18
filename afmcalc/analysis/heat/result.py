"""What is told of heat and wear of a trip."""

from ...result import Answer, OpenTriple, Triple, quantity
from ..simulate.result import NOT_ENDED
from .trip import EnergySource


class HeatResult(Answer):
    """Heat and wear of one trip; what the spec does not allow to tell is left out."""

    energy_source: EnergySource = quantity("", None, "where time and heat of the slip are from")
    slip_time: OpenTriple = quantity("s", "t_s", "time of slip", null=NOT_ENDED)
    energy: OpenTriple = quantity("J", "Q", "heat of a trip", null=NOT_ENDED)
    specific_work: OpenTriple | None = quantity(
        "J/m^2", "q_A", "work per area of a pair", optional=True, null=NOT_ENDED
    )
    power_density: Triple | None = quantity("W/m^2", "q", "largest power per area of a pair", optional=True)
    temperature_rise: OpenTriple | None = quantity(
        "K", "ΔΘ_d", "mean rise of the discs by a trip, the lining taking its share", optional=True, null=NOT_ENDED
    )
    temperature: OpenTriple | None = quantity(
        "K abs", "Θ", "mean temperature of the discs after a trip", optional=True, null=NOT_ENDED
    )
    surface_temperature_rise: OpenTriple | None = quantity(
        "K",
        "ΔΘ_s",
        "largest rise of the faces during a trip, the lining taking its share",
        optional=True,
        null=NOT_ENDED,
    )
    face_temperature: OpenTriple | None = quantity(
        "K abs", "Θ_s", "largest temperature of the faces during a trip", optional=True, null=NOT_ENDED
    )
    temperature_limit: float | None = quantity(
        "K abs", "Θ_max", "temperature the discs are held against", optional=True
    )
    trips_without_cooling: OpenTriple | None = quantity(
        "1", "n", "trips one upon the other until the limit, all their heat in the discs", optional=True
    )
    trips_per_hour: OpenTriple | None = quantity(
        "1/h", "ν", "trips per hour, mean temperature at the limit", optional=True
    )
    trips_per_hour_peak: OpenTriple | None = quantity(
        "1/h", "ν_p", "trips per hour, temperature after each trip at the limit", optional=True
    )
    trips_to_wear_out: OpenTriple | None = quantity("1", "n_w", "trips until the lining is gone", optional=True)
    setting_loss_per_wear: float | None = quantity(
        "1/m", "ΔF/(F δ)", "share of the force on the pack lost per wear of a pair", optional=True
    )
    setting_loss_worn: float | None = quantity(
        "1", "ΔF/F", "share of the force on the pack lost when the lining is gone", optional=True
    )
