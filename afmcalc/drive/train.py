"""The drive around a clutch, reduced to its shaft: inertias, shaft, motor, event.

Everything is typed as a number; in a sweep arrays stand in the place of numbers, as they do in the spec.
"""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..engines import Clutch
from ..engines.rings import inertia_of, parts_of, sizes_of
from ..equations import drive as law
from ..equations.arrays import Values, is_array
from ..messages import say
from ..spec.models import EventKind


@dataclass(frozen=True)
class Engine:
    """The motor: a constant torque, or Kloss' curve."""

    torque: float
    """M_1, or M_b, N·m."""
    slip: float | None
    """s_b; None for a constant torque."""
    synchronous: float
    """ω_s, rad/s."""

    def at(self, speed: Values) -> Values | float:
        """M_1 at a speed, N·m."""
        if self.slip is None:
            return self.torque
        return law.kloss_torque(self.torque, self.slip, law.motor_slip(speed, self.synchronous))


@dataclass(frozen=True)
class Train:
    """Motor side J_1, driven half J_2 (indirect: hub J_h between), shaft k, d, tool."""

    motor_inertia: float
    hub_inertia: float
    driven_inertia: float
    tool_inertia: float
    stiffness: float
    damping: float
    speed: float
    load: float
    """T_0, before the event."""
    engine: Engine
    kind: EventKind
    time: float
    """t_b of a stop, t_r of a load."""
    overload: float
    """M_L, to which a load rises."""
    cut_off: float | None

    @property
    def inertia_torque(self) -> float:
        """ω_0 √(k (J_2 + J_h)), N·m: what the motor does not drive any more as the discs slip."""
        return law.inertia_torque(self.speed, self.stiffness, self.driven_inertia + self.hub_inertia)

    @property
    def front(self) -> float:
        """Inertia of all that turns before the shaft, kg·m²."""
        return self.motor_inertia + self.hub_inertia + self.driven_inertia

    @property
    def without_hub(self) -> "Train":
        """Drive in which the hub belongs to the driven half."""
        return replace(self, driven_inertia=self.driven_inertia + self.hub_inertia, hub_inertia=0.0)

    def passed(self, time: Any) -> Any:
        """Share of the event that has passed: of the stop, or of the rise of the load."""
        if is_array(time):
            return np.where(time < self.time, time / np.where(self.time > 0, self.time, 1.0), 1.0)
        return time / self.time if time < self.time else 1.0

    def led(self, time: Any) -> Any:
        """Speed of a tool that is being stopped, rad/s."""
        return self.speed * (1 - self.passed(time))

    def load_at(self, time: Any) -> Any:
        """Torque with which the load resists, N·m."""
        return self.load + (self.overload - self.load) * self.passed(time)


def inertias_of(clutch: Clutch) -> tuple[Any, Any]:
    """J_2 and J_h, kg·m²: as given, else of the layout, which the rules then see to; a direct clutch has no J_h."""
    driven: Any = clutch.spec.drive.driven_inertia
    hub: Any = clutch.spec.drive.hub_inertia if clutch.spec.kind.travels else 0.0
    if driven is None or hub is None:
        parts = parts_of(sizes_of(clutch))
        driven = inertia_of(parts, "driven") if driven is None else driven
        hub = inertia_of(parts, "hub") if hub is None else hub
    return driven, hub


def train_of(clutch: Clutch) -> Train:
    """Return the drive of a clutch.

    Raises:
        SpecError: the spec has no event, or a motor that cannot carry the load.
    """
    # the rules of the spec require what is asked for here beside an event
    given: Any = clutch.spec.drive
    if (event := given.event) is None:
        message = say(
            'required by simulate: what happens, for example event = {{ kind = "stop", stop_time = "10 ms" }}; '
            "afmcalc init --kind drive writes a spec that has it"
        )
        raise clutch.spec.refused("drive.event", message)
    load: Any = clutch["running_torque"] if given.load_torque is None else given.load_torque
    motor, speed = given.motor, given.speed
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
        # the formula has no slip without load, where the motor runs at its synchronous speed
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
