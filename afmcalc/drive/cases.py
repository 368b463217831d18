"""Which events are simulated: the clutch at a friction, an ordinary clutch in its place, and for how long."""

import functools
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ..engines import Clutch
from ..equations import heat
from ..equations.arrays import Values
from .pack import DirectPack, Sleeve, ordinary_pack, pack_of
from .plant import Plant, plant_of
from .train import Train, train_of

if TYPE_CHECKING:
    from .trip import Trip

_SWINGS = 6.0
"""Swings of the driven half after an event within which its peak has come."""
_LONG = 20.0
"""Times the run-down at T(f) that is waited for: motor and load may all but balance the slipping clutch, the key hold
the sleeve far off."""


class Case(NamedTuple):
    """A clutch in its drive at one friction."""

    plant: Plant
    horizon: float
    """Time that is simulated at most, s."""
    given: bool
    """Whether that is the duration asked for."""

    def run(self, *, recorded: bool = False) -> "Trip":
        """Simulate.

        Raises:
            CalculationError: the integration fails.
        """
        return run_of(self, recorded)


@functools.lru_cache(maxsize=64)
def run_of(case: Case, recorded: bool) -> "Trip":  # noqa: FBT001
    """Simulate; the last are cached, as heat and the requirements ask again what was simulated for the peaks."""
    from .trip import trip

    return trip(case.plant, case.horizon, recorded=recorded, given=case.given)


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
        """Time of slip; None where it has not ended."""
        return self.trip.slip_time if self.trip.ended else None

    @property
    def energy(self) -> float | None:
        """Heat in the pack; None where the slip has not ended."""
        return self.trip.heat if self.trip.ended else None

    @property
    def key_energy(self) -> float | None:
        """Energy lost at the key until the slip has ended, or until the end where it does not slip; None as above."""
        trip = self.trip
        return (trip.key_heat if trip.trip_torque is None else trip.key_heat_slipping) if trip.ended else None

    @property
    def endless(self) -> bool:
        """Whether the motor is what keeps it slipping."""
        train = self.case.plant.train
        strong = train.cut_off is None and abs(self.trip.last) <= train.engine.torque
        return not self.trip.ended and (self.trip.endless or (strong and not self.trip.stuck))

    @property
    def potential(self) -> float | None:
        """T_п, at which it would slip if the release force did not follow the load; None of an indirect clutch."""
        pack = self.case.plant.pack
        return pack.potential(self.case.plant.train.load, pack.static_ratio) if isinstance(pack, DirectPack) else None

    @property
    def trip_position(self) -> float | None:
        """Where the trip lies between T_муф (0) and T_п (1); None without slip, or where the two are one."""
        expected, held, at = self.case.plant.breakaway, self.potential, self.trip.trip_torque
        return None if at is None or held is None or held <= expected else (at - expected) / (held - expected)


def case_of(clutch: Clutch, friction: float, friction_driven: float | None = None) -> Case:
    """Return the event at one friction.

    Args:
        clutch: a clutch with float parameters and an event in its [drive] block.
        friction: f, or f_1 of the driving pairs.
        friction_driven: f_2; None for f.

    Raises:
        SpecError: no event.
    """
    pack = pack_of(clutch, friction, friction if friction_driven is None else friction_driven)
    return _case(clutch, plant_of(train_of(clutch), pack))


def _case(clutch: Clutch, plant: Plant) -> Case:
    event = clutch.spec.drive.event
    assert event is not None
    return Case(plant, event.duration or longest(plant), event.duration is not None)


def outcome_of(clutch: Clutch, friction: float, friction_driven: float | None = None) -> Outcome:
    """Simulate the clutch, and an ordinary one in its place, at one friction; arguments as ``case_of``."""
    case = case_of(clutch, friction, friction_driven)
    pack = ordinary_pack(clutch, friction, friction if friction_driven is None else friction_driven)
    ordinary = _case(clutch, plant_of(train_of(clutch), pack))
    return Outcome(case, case.run(), ordinary.plant, ordinary.run().peak)


def bracket_of(outcome: Outcome) -> Sequence[Outcome]:
    """Return the event as it is, then with N at the stop along κ alone, along κ₊ alone; empty without a key's play."""
    case, pack = outcome.case, outcome.case.plant.pack
    if not isinstance(pack, Sleeve) or pack.net_gain == pack.net_gain_returning:
        return []
    plants = (replace(case.plant, pack=replace(pack, branch=branch)) for branch in (1, -1))
    cases = (case._replace(plant=plant, horizon=case.horizon if case.given else longest(plant)) for plant in plants)
    return [outcome, *(outcome._replace(case=each, trip=each.run()) for each in cases)]


def longest(plant: Plant) -> float:
    """Time within which a drive has settled, if it does, s: a bound that few come near."""
    return float(whole_time(plant.train, plant.sliding)) + _slip_time(plant)


def whole_time(train: Train, sliding: Values) -> Values:
    """Time within which nothing but the end of a slip is left to come, s, rather too long."""
    off = 0.0 if train.cut_off is None else train.cut_off
    run_down = _LONG * (train.front + train.tool_inertia) * train.speed / sliding
    return peak_time(train, sliding) + off + run_down


def peak_time(train: Train, sliding: Values) -> Values:
    """Time within which the peak has come, s: some swings of the driven half, one of the stuck drive.

    Where the tool has an inertia of its own, that within which its load has stopped it comes before.
    """
    if train.kind != "load":
        return swings_time(train)
    resisted = [(train.driven_inertia + train.tool_inertia, sliding)]
    if train.engine.slip is not None:
        # while the clutch holds, the motor is slowed with the tool, and pulls the harder for it
        resisted.append((train.front + train.tool_inertia, train.engine.torque))
    times = (
        inertia * train.speed / np.maximum(np.abs(train.overload - torque), 0.05 * sliding)
        for inertia, torque in resisted
    )
    return swings_time(train) + functools.reduce(np.maximum, times)


def swings_time(train: Train) -> Values:
    """Time of the event and of some swings of the driven half, one of the stuck drive, s."""
    swings = (2 * np.pi * (inertia / train.stiffness) ** 0.5 for inertia in (train.driven_inertia, train.front))
    return train.time + sum(share * swing for share, swing in zip((_SWINGS, 1.0), swings, strict=True))


def _slip_time(plant: Plant) -> float:
    """Time within which the slip ends, s, if it does."""
    train, drive = plant.train, plant.train.engine.torque
    if train.cut_off is not None:
        gained = train.speed + max(drive - plant.least, 0.0) * train.cut_off / train.motor_inertia
        return train.cut_off + float(heat.run_down_time(train.motor_inertia, gained, plant.least, 0.0))
    if plant.least > drive:
        return float(heat.run_down_time(train.motor_inertia, train.speed, plant.least, drive))
    if plant.sliding > drive:
        return _LONG * float(heat.run_down_time(train.motor_inertia, train.speed, plant.sliding, drive))
    return 0.0
