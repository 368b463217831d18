"""The [drive] block: what stands around the clutch and what happens to it, all reduced to the clutch shaft."""

from collections.abc import Iterable
from typing import Annotated, Literal

from pydantic import Field

from ..errors import Problem
from ..messages import say
from ..variants import VARIANTS
from . import rules
from .fields import Block, Coefficient, Quantity, Ratio, Torque, TorqueOrNone, key_field

Inertia = Annotated[float, Quantity("kg*m^2", gt=0)]
Speed = Annotated[float, Quantity("rad/s", gt=0)]
TorsionalStiffness = Annotated[float, Quantity("N*m/rad", gt=0)]
Time = Annotated[float, Quantity("s", gt=0)]
TimeOrNone = Annotated[float, Quantity("s", ge=0)]
Mass = Annotated[float, Quantity("kg", ge=0)]
SlidingSpeed = Annotated[float, Quantity("m/s", gt=0)]
Slip = Annotated[float, Quantity("1", gt=0, le=1)]
EventKind = Literal["stop", "load"]


class Motor(Block):
    """An induction motor by Kloss, M_1 = 2 M_b/(s/s_b + s_b/s)."""

    breakdown_torque: Torque = Field(description="breakdown torque of the motor", json_schema_extra={"symbol": "M_b"})
    breakdown_slip: Slip = Field(description="slip at breakdown", json_schema_extra={"symbol": "s_b"})
    synchronous_speed: Speed = Field(
        description="synchronous speed, reduced to the clutch", json_schema_extra={"symbol": "ω_s"}
    )


class Event(Block):
    """What makes the clutch slip, at t = 0."""

    kind: EventKind = Field(
        description="stop: the tool is stopped in stop_time; load: its load rises to torque within rise_time"
    )
    stop_time: TimeOrNone | None = key_field("time in which the tool is stopped; 0 is a sudden lock", "t_b")
    torque: Torque | None = key_field(
        "load to which that of the tool rises; it resists as friction does: it holds a stopped tool, and does not turn "
        "it back as that of a hoist would",
        "M_L",
    )
    rise_time: TimeOrNone | None = key_field("time in which the load rises", "t_r")
    duration: Time | None = key_field("time that is simulated; default until nothing more can come", "t_max")


class Drive(Block):
    """The drive around the clutch."""

    dynamic_factor: Coefficient | None = key_field(
        "dynamic factor of the unprotected side; default that of the event, 1 without one", "k_д"
    )
    speed: Speed | None = key_field("speed before the event; default that of motor under load_torque", "ω_0")
    motor_inertia: Inertia | None = key_field("inertia of the motor side, driving half of the clutch included", "J_1")
    hub_inertia: Inertia | None = key_field("inertia between the discs and the balls (indirect only)", "J_h")
    driven_inertia: Inertia | None = key_field("inertia of the driven half of the clutch", "J_2")
    tool_inertia: Inertia | None = key_field("inertia of the tool (event of kind load)", "J_3")
    shaft_stiffness: TorsionalStiffness | None = key_field(
        "torsional stiffness of the shaft between clutch and tool", "k"
    )
    damping_ratio: Ratio | None = key_field("damping ratio of the driven half on the shaft; default 0", "ζ")
    load_torque: TorqueOrNone | None = key_field("load before the event; default T_н.маш", "T_0")
    motor_torque: TorqueOrNone | None = key_field("torque of the motor, constant; default load_torque", "M_1")
    motor: Motor | None = None
    cut_off: Time | None = key_field(
        "time from the first slip until the motor is switched off, the clutch slipping or stuck again; default never",
        "t_off",
    )
    event: Event | None = None


_NEEDED = ("motor_inertia", "driven_inertia", "shaft_stiffness")
"""Keys without which no event can be simulated."""
_OF_EVENT = {"stop": ("stop_time",), "load": ("torque", "rise_time")}


def problems(data: rules.Table) -> Iterable[Problem]:
    """Rules of the [drive] block of a spec: what an event needs, what excludes what."""
    if not rules.is_table(data, "drive"):
        return
    if rules.has(data, "drive", "motor") and rules.has(data, "drive", "motor_torque"):
        yield rules.wrong(
            "drive.motor_torque", say("excludes drive.motor: give a constant torque, or the motor's curve")
        )
    if rules.is_table(data, "drive", "event"):
        yield from _event(data)


def _event(data: rules.Table) -> Iterable[Problem]:
    kind = rules.get(data, "drive", "event", "kind")
    variant = VARIANTS.get(str(rules.get(data, "variant")))
    needed = [*_NEEDED, *(["tool_inertia"] if kind == "load" else [])]
    if variant is not None and variant.travels:
        needed.append("hub_inertia")
    if not rules.has(data, "drive", "motor"):
        needed.append("speed")
    for key in needed:
        if not rules.has(data, "drive", key):
            yield rules.beside(f"drive.{key}", "drive.event")
    if kind == "stop" and rules.has(data, "drive", "tool_inertia"):
        yield rules.wrong(
            "drive.tool_inertia", say("only with an event of kind load: a stopped tool moves as it is told")
        )
    for own, keys in _OF_EVENT.items():
        for key in keys:
            given = rules.has(data, "drive", "event", key)
            if own == kind and not given:
                yield rules.wrong(f"drive.event.{key}", say("required for an event of kind {kind}", kind=own))
            if own != kind and given and str(kind) in _OF_EVENT:
                yield rules.wrong(f"drive.event.{key}", say("only for an event of kind {kind}", kind=own))
