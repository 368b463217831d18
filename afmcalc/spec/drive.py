"""What stands around the clutch and happens to it: [drive], all reduced to the clutch shaft; what it heats: [heat]."""

from collections.abc import Iterable
from typing import Annotated, Literal

from ..messages import say
from .fields import (
    Block,
    Broken,
    Coefficient,
    Length,
    Quantity,
    Ratio,
    RuledBlock,
    Temperature,
    Time,
    TimeOrNone,
    Torque,
    TorqueOrNone,
    key,
    required,
)

Inertia = Annotated[float, Quantity("kg*m^2", gt=0)]
Speed = Annotated[float, Quantity("rad/s", gt=0)]
TorsionalStiffness = Annotated[float, Quantity("N*m/rad", gt=0)]
Slip = Annotated[float, Quantity("1", gt=0, le=1)]
DiscMass = Annotated[float, Quantity("kg", gt=0)]
Density = Annotated[float, Quantity("kg/m^3", gt=0)]
SpecificHeat = Annotated[float, Quantity("J/kg/K", gt=0)]
Conductivity = Annotated[float, Quantity("W/m/K", gt=0)]
Cooling = Annotated[float, Quantity("W/K", gt=0)]
Wear = Annotated[float, Quantity("m^3/J", gt=0)]
EventKind = Literal["stop", "load"]


class Motor(Block):
    """An induction motor by Kloss, M_1 = 2 M_b/(s/s_b + s_b/s)."""

    breakdown_torque: Torque = required("breakdown torque of the motor", "M_b")
    breakdown_slip: Slip = required("slip at breakdown", "s_b")
    synchronous_speed: Speed = required("synchronous speed, reduced to the clutch", "ω_s")


class Event(Block):
    """What makes the clutch slip, at t = 0."""

    kind: EventKind = required(
        "stop: the tool is stopped in stop_time; load: its load rises to torque within rise_time"
    )
    stop_time: TimeOrNone | None = key("time in which the tool is stopped; 0 is a sudden lock", "t_b")
    torque: Torque | None = key(
        "load to which that of the tool rises; it resists as friction does: it holds a stopped tool, and does not turn "
        "it back as that of a hoist would",
        "M_L",
    )
    rise_time: TimeOrNone | None = key("time in which the load rises", "t_r")
    duration: Time | None = key("time that is simulated; default until nothing more can come", "t_max")


class Drive(Block):
    """The drive around the clutch."""

    dynamic_factor: Coefficient | None = key(
        "dynamic factor of the unprotected side; default that of the event, 1 without one", "k_д"
    )
    speed: Speed | None = key("speed before the event; default that of motor under load_torque", "ω_0")
    motor_inertia: Inertia | None = key("inertia of the motor side, driving half of the clutch included", "J_1")
    hub_inertia: Inertia | None = key("inertia between the discs and the balls (indirect only)", "J_h")
    driven_inertia: Inertia | None = key("inertia of the driven half of the clutch", "J_2")
    tool_inertia: Inertia | None = key("inertia of the tool (event of kind load)", "J_3")
    shaft_stiffness: TorsionalStiffness | None = key("torsional stiffness of the shaft between clutch and tool", "k")
    damping_ratio: Ratio | None = key("damping ratio of the driven half on the shaft; default 0", "ζ")
    load_torque: TorqueOrNone | None = key("load before the event; default T_н.маш", "T_0")
    motor_torque: TorqueOrNone | None = key("torque of the motor, constant; default load_torque", "M_1")
    motor: Motor | None = None
    cut_off: Time | None = key(
        "time from the first slip until the motor is switched off, the clutch slipping or stuck again; default never",
        "t_off",
    )
    event: Event | None = None


_LINING = ("lining_conductivity", "lining_density", "lining_specific_heat")


class Heat(RuledBlock):
    """Discs that take the heat, air that takes it from them, lining that is worn."""

    disc_mass: DiscMass | None = key("mass of all discs that take the heat", "m")
    specific_heat: SpecificHeat | None = key("specific heat of the discs", "c_p")
    conductivity: Conductivity | None = key("thermal conductivity of the discs", "k_t")
    density: Density | None = key("density of the discs", "ρ")
    lining_conductivity: Conductivity | None = key(
        "thermal conductivity of the lining; absent: the discs take all the heat", "k_l"
    )
    lining_density: Density | None = key("density of the lining", "ρ_l")
    lining_specific_heat: SpecificHeat | None = key("specific heat of the lining", "c_l")
    ambient: Temperature | None = key("temperature around the clutch, and of the discs before a trip", "Θ_0")
    cooling: Cooling | None = key("heat given off per kelvin above the surroundings, α A_c", "α A_c")
    wear: Wear | None = key("volume of lining worn per energy", "w")
    lining: Length | None = key("thickness that a pair may lose", "s_w")

    def broken_rules(self) -> Iterable[Broken]:
        """A lining has all its data or none."""
        given = [name for name in _LINING if getattr(self, name) is not None]
        for name in _LINING if given else ():
            if name not in given:
                yield name, say("required beside heat.{given}", given=given[0])


def missing_of(drive: Drive) -> list[str]:
    """Keys of the [drive] block that are missing, without which neither a simulation nor V1 can be asked."""
    if drive.motor is not None:
        return ["event"]
    ends = drive.motor_inertia is not None or drive.cut_off is not None
    return [*(["speed"] if drive.speed is None else []), *([] if ends else ["motor_inertia"])]
