"""The drive around a clutch, reduced to its shaft: inertias, shaft, motor, event.

Attributes are declared as numbers; in a sweep they may be arrays, as in the spec.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..engines import Clutch
from ..engines.rings import inertia_of, parts_of, sizes_of
from ..equations import drive as law
from ..equations.arrays import Values, is_array
from ..errors import SpecError
from ..messages import say
from ..spec.models import EventKind, Spec
from ..spec.write import lacking


@dataclass(frozen=True)
class Engine:
    """Motor with a constant torque, or with the torque-speed curve of Kloss."""

    torque: float
    """Constant torque M_1, or breakdown torque M_b, N·m."""
    slip: float | None
    """Breakdown slip s_b; None for a constant torque."""
    synchronous: float
    """Synchronous speed ω_s, rad/s; 0 for a constant torque."""

    def at(self, speed: Values) -> Values | float:
        """Torque of the motor at a speed, N·m."""
        if self.slip is None:
            return self.torque
        return law.kloss_torque(self.torque, self.slip, law.motor_slip(speed, self.synchronous))


@dataclass(frozen=True)
class Train:
    """Inertias of motor side, hub (0 if direct), driven half and tool, shaft, motor and event of a drive, SI."""

    motor_inertia: float
    hub_inertia: float
    driven_inertia: float
    tool_inertia: float
    stiffness: float
    damping: float
    speed: float
    load: float
    """Load torque T_0 before the event, N·m."""
    engine: Engine
    kind: EventKind
    time: float
    """Time t_b in which the tool is braked to a standstill, or t_r in which the load rises, s."""
    overload: float
    """Load torque M_L after its rise, N·m; if the tool is braked, the load before the event."""
    cut_off: float | None

    @property
    def inertia_torque(self) -> float:
        """Torque ω_0 √(k (J_2 + J_h)) with which inertia behind the slipping discs twists the shaft, N·m."""
        return law.inertia_torque(self.speed, self.stiffness, self.driven_inertia + self.hub_inertia)

    @property
    def front(self) -> float:
        """Inertia of motor side, hub and driven half together, kg·m²."""
        return self.motor_inertia + self.hub_inertia + self.driven_inertia

    def passed(self, time: Any) -> Any:
        """Share (0…1) of the time for braking the tool, or for the rise of the load, that has passed."""
        if is_array(time):
            return np.where(time < self.time, time / np.where(self.time > 0, self.time, 1.0), 1.0)
        return time / self.time if time < self.time else 1.0

    def led(self, time: Any) -> Any:
        """Speed of the tool while it is braked to a standstill, rad/s."""
        return self.speed * (1 - self.passed(time))

    def load_at(self, time: Any) -> Any:
        """Torque with which the load resists, N·m."""
        return self.load + (self.overload - self.load) * self.passed(time)


def inertias_of(clutch: Clutch) -> tuple[Any, Any]:
    """Inertias of driven half and hub, kg·m²: as given, else from the layout in [envelope]; hub 0 if direct."""
    driven: Any = clutch.spec.drive.driven_inertia
    hub: Any = clutch.spec.drive.hub_inertia if clutch.spec.kind.travels else 0.0
    if driven is None or hub is None:
        parts = parts_of(sizes_of(clutch))
        driven = inertia_of(parts, "driven") if driven is None else driven
        hub = inertia_of(parts, "hub") if hub is None else hub
    return driven, hub


def without_event(spec: Spec) -> SpecError:
    """Error of a spec without an event; it names every other key that the event needs and the spec lacks."""
    drive, needed = spec.drive, ["motor_inertia", "shaft_stiffness"]
    needed += ["speed"] if spec.speed is None and drive.motor is None else []
    if spec.envelope is None:
        needed += ["driven_inertia", "hub_inertia"] if spec.kind.travels else ["driven_inertia"]
    missing = [f"drive.{name}" for name in needed if getattr(drive, name) is None]
    needs = ", ".join(["drive.event", *missing])
    return lacking(spec, "simulate", needs, "drive", ["drive.event.kind", "drive.event.stop_time", *missing])


def train_of(clutch: Clutch) -> Train:
    """Return the drive of a clutch; raises SpecError without an event, or if the motor cannot carry the load."""
    # validation of the spec guarantees that these values are given if there is an event
    given: Any = clutch.spec.drive
    if (event := given.event) is None:
        raise without_event(clutch.spec)
    load: Any = clutch["running_torque"] if given.load_torque is None else given.load_torque
    motor, speed = given.motor, clutch.spec.speed
    if motor is None:
        engine = Engine(load if given.motor_torque is None else given.motor_torque, None, 0.0)
    else:
        engine = Engine(motor.breakdown_torque, motor.breakdown_slip, motor.synchronous_speed)
    if speed is None:
        if not np.all(load <= engine.torque):
            message = say(
                "required: drive.motor cannot carry the load before the event, its breakdown torque is smaller"
            )
            raise clutch.spec.refused("drive.speed", message)
        # without load the motor runs at its synchronous speed, for which the formula would divide by 0
        slip = law.kloss_slip(engine.torque, engine.slip, load) if np.all(load > 0) else 0.0
        speed = engine.synchronous * (1 - slip)
    (inertia, hub), stiffness, damping = inertias_of(clutch), given.shaft_stiffness, given.damping_ratio
    return Train(
        motor_inertia=given.motor_inertia,
        hub_inertia=hub,
        driven_inertia=inertia,
        tool_inertia=0.0 if given.tool_inertia is None else given.tool_inertia,
        stiffness=stiffness,
        damping=0.0 if damping is None else law.shaft_damping(damping, stiffness, inertia),
        speed=speed,
        load=load,
        engine=engine,
        kind=event.kind,
        time=event.stop_time if event.kind == "stop" else event.rise_time,
        overload=load if event.torque is None else event.torque,
        cut_off=given.cut_off,
    )
