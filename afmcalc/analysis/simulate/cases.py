"""Which events are simulated: the clutch at a friction, an ordinary clutch in its place, and for how long."""

import math
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple, cast

from ...arrays import Values
from ...engines import setting
from ...engines.laws import DirectLaw
from ...engines.protocol import Clutch
from ...equations import adjustment
from ...equations.heat import run_down_time
from ...errors import CalculationError
from ...extras import need
from ...messages import say
from .direct import DirectPack, DirectPlant
from .indirect import IndirectPlant
from .plant import Plant
from .sleeve import Sleeve
from .train import Train, train_of

if TYPE_CHECKING:
    from .machine import Trip

_SWINGS = 6.0
"""Swings of the driven half after an event within which its peak has come."""


class Case(NamedTuple):
    """A clutch in its drive at one friction."""

    plant: Plant
    horizon: float
    """Time within which the slip ends, or at least the peak has passed, s."""
    endless: bool
    """Whether the motor is strong enough to slip for ever."""

    def run(self, *, recorded: bool = False) -> "Trip":
        """Simulate.

        Raises:
            AfmcalcError: SciPy is missing.
            CalculationError: the integration fails.
        """
        need("drive")
        from .machine import trip

        return trip(self.plant, self.horizon, recorded=recorded)


def case_of(clutch: Clutch, friction: float, friction_driven: float | None = None) -> Case:
    """Return the event at one friction.

    Args:
        clutch: a clutch with float parameters and an event in its [drive] block.
        friction: f, or f_1 of the driving pairs.
        friction_driven: f_2; None for f.

    Raises:
        SpecError: no event.
    """
    train = train_of(clutch)
    plant = _plant(clutch, train, friction, friction if friction_driven is None else friction_driven)
    duration = _duration(train, plant.sliding)
    event = clutch.spec.drive.event
    assert event is not None
    horizon = event.duration or (_peak_time(train) if duration is None else duration)
    return Case(plant, horizon, duration is None)


def ordinary_case(clutch: Clutch, friction: float, friction_driven: float | None = None) -> Case:
    """Return the event with an ordinary clutch of equal T_н in place, until its peak; arguments as ``case_of``."""
    whole = _without_hub(train_of(clutch))
    own = DirectLaw(
        clutch.mean_radius, clutch.bypass_pairs, clutch.spec.friction_group.pairs - clutch.bypass_pairs, 0.0
    )
    per_force = own.torque_per_force(*setting.friction_at_setting(clutch.spec))
    force = adjustment.closing_force(clutch.nominal_torque, setting.margin(clutch.spec), per_force)
    pack = _pack(clutch, own, force, friction, friction if friction_driven is None else friction_driven)
    return Case(DirectPlant(whole, replace(pack, lag=0.0)), _peak_time(whole), endless=False)


class Outcome(NamedTuple):
    """What an event does at one friction."""

    case: Case
    trip: "Trip"
    ordinary: Plant
    """An ordinary clutch of equal T_н in its place."""
    ordinary_peak: float

    @property
    def dynamic_factor(self) -> float:
        """k_д."""
        return self.trip.peak / self.case.plant.sliding

    @property
    def slip_time(self) -> float | None:
        """Time of slip; None where it does not end."""
        return self.trip.slip_time if self.trip.ended else None

    @property
    def heat(self) -> float | None:
        """Heat in the pack; None where it does not end."""
        return self.trip.heat if self.trip.ended else None


def outcome_of(clutch: Clutch, friction: float, friction_driven: float | None = None) -> Outcome:
    """Simulate the clutch, and an ordinary one in its place, at one friction; arguments as ``case_of``."""
    case = case_of(clutch, friction, friction_driven)
    ordinary = ordinary_case(clutch, friction, friction_driven)
    return Outcome(case, case.run(), ordinary.plant, ordinary.run().peak)


def _plant(clutch: Clutch, train: Train, driving: float, driven: float) -> Plant:
    own = clutch.law
    if isinstance(own, DirectLaw):
        return DirectPlant(train, _pack(clutch, own, clutch.closing_force, driving, driven))
    if not own.net_gain:
        # feedback that the key just holds: an ordinary clutch
        ordinary = DirectLaw(own.mean_radius, own.pairs, 0.0, 0.0)
        return DirectPlant(_without_hub(train), _pack(clutch, ordinary, clutch.closing_force, driving, driven))
    control = float(own.control_force(clutch.closing_force))
    if control < clutch.closing_force:
        raise CalculationError(
            say(
                "simulate: the control spring ({control:.5g N}) must press more than the closing spring "
                "({closing:.5g N}), else the sleeve is off its stop without load",
                control=control,
                closing=clutch.closing_force,
            )
        )
    friction, unit = clutch.spec.friction, clutch.spec.control_unit
    ratio, decay, radius = friction.static_ratio or 1.0, friction.stribeck_speed, cast(float, own.mean_radius)
    sleeve = Sleeve(
        friction_pairs=cast(float, own.pairs) * driving,
        mean_radius=radius,
        gain=cast(float, own.gain),
        net_gain=cast(float, own.net_gain),
        net_gain_returning=cast(float, own.net_gain_returning),
        closing_force=cast(float, clutch.closing_force),
        control_force=control,
        closing_stiffness=cast(float, own.closing_stiffness),
        control_stiffness=cast(float, own.control_stiffness),
        mass=(unit.sleeve_mass if unit else None) or 0.0,
        static_ratio=ratio,
        decay_rate=radius / decay if decay else 0.0,
    )
    return IndirectPlant(train, sleeve, float(clutch.torque(driving)), float(clutch.torque(ratio * driving)))


def _without_hub(train: Train) -> Train:
    """Without control unit the hub belongs to the driven half."""
    return replace(train, driven_inertia=train.driven_inertia + train.hub_inertia, hub_inertia=0.0)


def _pack(clutch: Clutch, own: DirectLaw, force: Values, driving: float, driven: float) -> DirectPack:
    friction, unit = clutch.spec.friction, clutch.spec.control_unit
    radius = cast(float, own.mean_radius)
    ratio, decay = friction.static_ratio or 1.0, friction.stribeck_speed
    return DirectPack(
        closing_force=cast(float, force),
        mean_radius=radius,
        bypass_pairs=cast(float, own.bypass_pairs),
        controlled_pairs=cast(float, own.controlled_pairs),
        gain=cast(float, own.gain),
        driving=driving,
        driven=driven,
        static_ratio=ratio,
        decay_rate=radius / decay if decay else 0.0,
        lag=(unit.release_lag if unit else None) or 0.0,
    )


def _swing(inertia: float, stiffness: float) -> float:
    return 2 * math.pi * math.sqrt(inertia / stiffness)


def _peak_time(train: Train) -> float:
    """Time within which the peak has come, s: some swings of the driven half, one of the stuck drive."""
    stuck = train.motor_inertia + train.hub_inertia + train.driven_inertia
    return float(train.time + _SWINGS * _swing(train.driven_inertia, train.stiffness) + _swing(stuck, train.stiffness))


def _duration(train: Train, sliding: float) -> float | None:
    """Time within which the slip ends, s; None where it need not."""
    drive, speed = train.engine.torque, train.speed
    if sliding > drive:
        slip = run_down_time(train.motor_inertia, speed, sliding, drive)
    elif train.cut_off is not None:
        gained = speed + (drive - sliding) * train.cut_off / train.motor_inertia
        slip = train.cut_off + run_down_time(train.motor_inertia, gained, sliding, 0.0)
    else:
        return None
    if train.kind == "load":
        # until the tool stands, or has caught up
        slip += (train.driven_inertia + train.tool_inertia) * speed / max(abs(train.overload - sliding), 0.01 * sliding)
    return float(slip) + _peak_time(train)
