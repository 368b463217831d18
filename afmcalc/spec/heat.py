"""What a trip heats and wears: the [heat] block of a spec."""

from typing import Annotated

from pydantic import model_validator

from ..messages import say
from . import rules
from .drive import Drive
from .fields import Block, Length, Quantity, key_field

DiscMass = Annotated[float, Quantity("kg", gt=0)]
Density = Annotated[float, Quantity("kg/m^3", gt=0)]
Temperature = Annotated[float, Quantity("K abs", ge=173.15)]
"""A number without a unit is in kelvin; the bound tells 20 from 20 degC."""
SpecificHeat = Annotated[float, Quantity("J/kg/K", gt=0)]
Conductivity = Annotated[float, Quantity("W/m/K", gt=0)]
Cooling = Annotated[float, Quantity("W/K", gt=0)]
Wear = Annotated[float, Quantity("m^3/J", gt=0)]

_LINING = ("lining_conductivity", "lining_density", "lining_specific_heat")


class Heat(Block):
    """Discs that take the heat, air that takes it from them, lining that is worn."""

    disc_mass: DiscMass | None = key_field("mass of all discs that take the heat", "m")
    specific_heat: SpecificHeat | None = key_field("specific heat of the discs", "c_p")
    conductivity: Conductivity | None = key_field("thermal conductivity of the discs", "k_t")
    density: Density | None = key_field("density of the discs", "ρ")
    lining_conductivity: Conductivity | None = key_field(
        "thermal conductivity of the lining; absent: the discs take all the heat", "k_l"
    )
    lining_density: Density | None = key_field("density of the lining", "ρ_l")
    lining_specific_heat: SpecificHeat | None = key_field("specific heat of the lining", "c_l")
    ambient: Temperature | None = key_field("temperature around the clutch, and of the discs before a trip", "Θ_0")
    cooling: Cooling | None = key_field("heat given off per kelvin above the surroundings, α A_c", "α A_c")
    wear: Wear | None = key_field("volume of lining worn per energy", "w")
    lining: Length | None = key_field("thickness that a pair may lose", "s_w")

    @model_validator(mode="after")
    def _check_lining(self) -> "Heat":
        given = [name for name in _LINING if getattr(self, name) is not None]
        if given and len(given) < len(_LINING):
            missing = [name for name in _LINING if name not in given]
            message = say("required beside heat.{given}", given=given[0])
            raise rules.RuleError([rules.wrong(name, message) for name in missing])
        return self


def missing_of(drive: Drive) -> list[str]:
    """Keys of the [drive] block that are missing, without which neither a simulation nor V1 can be asked."""
    if drive.motor is not None:
        return ["event"]
    held = drive.motor_inertia is not None or drive.cut_off is not None
    return [*(["speed"] if drive.speed is None else []), *([] if held else ["motor_inertia"])]
