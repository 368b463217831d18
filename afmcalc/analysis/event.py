"""What a designer should know of an event in the drive."""

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from ..drive.cases import Outcome
from ..drive.pack import Sleeve
from ..drive.plant import Plant
from ..drive.result import SimulateResult
from ..drive.train import Train
from ..engines.parts import checks_of_spec
from ..engines.protocol import Clutch
from ..equations import drive as law
from ..equations import synthesis
from ..findings import Finding, Level, finding
from ..messages import measured, say, term
from .registry import ANALYSES
from .synthesize import synthesize
from .wall import Wall, wall_of

_ENDS = ("f_min", "f_cp", "f_max")
_CLOSED = 1e-6
_NEAR = 1e-3
"""Relative difference below which a figure of the spec is what the simulation gives."""
_ROUNDING = 1e-9


def remarks_of(clutch: Clutch, train: Train, outcomes: Sequence[Outcome], result: SimulateResult) -> Iterator[Finding]:
    """Return the remarks on an event, ``outcomes`` at f_min, mean friction and f_max, and on its ``result``."""
    yield _inertia(train, outcomes)
    taken = {"driven_inertia": train.driven_inertia, "hub_inertia": train.hub_inertia}
    for name, inertia in taken.items():
        if inertia and getattr(clutch.spec.drive, name) is None:
            yield finding("inertia-from-layout", "info", value=float(inertia), path=f"drive.{name}")
    # where the ordinary clutch of equal nominal torque is no like for like comparison
    load, carried = train.load, min(one.ordinary.sliding for one in outcomes)
    if train.hub_inertia:
        inertia = train.driven_inertia + train.hub_inertia
        yield finding("ordinary-carries-hub", "info", value=inertia, path="drive.hub_inertia")
    if carried < load * (1 - _ROUNDING):
        yield finding("ordinary-slips-before-event", "info", value=carried, limit=load, path="adjustment.method")
    # does the clutch carry the load before the event, the motor drive it?
    for end, one in zip(_ENDS, outcomes, strict=True):
        if (carried := one.case.plant.breakaway) < load * (1 - _ROUNDING):
            path = "drive.load_torque"
            yield finding("slips-before-event", "error", value=carried, limit=load, path=path, at=end)
    motor = float(train.engine.at(train.speed))
    if abs(motor - load) > _NEAR * max(load, motor):
        path = "drive.speed" if train.engine.slip is not None else "drive.motor_torque"
        yield finding("drive-not-in-balance", "info", value=motor, limit=load, path=path)
    yield from _endless(train, outcomes)
    if result.energy_residual > _CLOSED:
        yield finding("energy-not-closed", "error", value=result.energy_residual, limit=_CLOSED)
    # S22's open question, as a number: where between T_муф and T_п does this drive trip?
    last, unit = outcomes[-1], clutch.spec.control_unit
    if unit is not None and unit.release_lag and last.trip_position is not None:
        expected, path = last.case.plant.breakaway, "control_unit.release_lag"
        at, share, held = last.trip.trip_torque, last.trip_position, last.potential
        yield finding("release-lag", "info", value=at, limit=expected, path=path, share=share, held=held)
    # the dynamic factor given, which the life takes, may be smaller than that of the event
    assumed, computed = clutch.spec.drive.dynamic_factor, result.largest_dynamic_factor
    if clutch.spec.fatigue is not None and assumed is not None and computed > assumed * (1 + _NEAR):
        path = "drive.dynamic_factor"
        yield finding("dynamic-factor-exceeded", "warning", value=computed, limit=float(assumed), path=path)
    yield from _judder(clutch, train, outcomes)


def _inertia(train: Train, outcomes: Sequence[Outcome]) -> Finding:
    """What turns behind the discs does to the shaft: a sudden stop by its speed, a slow one by its deceleration."""
    path, plant = "drive.driven_inertia", outcomes[-1].case.plant
    behind, limit, load = train.driven_inertia + train.hub_inertia, plant.sliding, min(train.load, plant.sliding)
    swing = math.pi * math.sqrt(behind / train.stiffness)
    # the slip begins as the tool, slowing down with ω_0/t_b, has wound the shaft up from the load
    wound = math.sqrt(2 * (limit - load) * train.time / (train.stiffness * train.speed))
    if train.kind == "load" or train.time <= wound + swing:
        return finding("inertia-torque", "info", value=train.inertia_torque, limit=limit, path=path)
    beyond = law.stop_torque(behind, train.speed / train.time, limit, load)
    return finding("inertia-torque/slow", "info", value=float(beyond), limit=limit, path=path, swing=swing)


def _endless(train: Train, outcomes: Sequence[Outcome]) -> Iterator[Finding]:
    """Does the motor stop, and does the slip end within the time that is simulated?"""
    strongest, path = float(train.engine.torque), "drive.cut_off"
    for end, one in zip(_ENDS, outcomes, strict=True):
        pulled = abs(one.trip.last) if one.endless else _at_cut_off(one)
        if pulled is None or not (one.endless or pulled <= strongest):
            continue
        carries, sliding = measured(pulled, "N*m", 5), one.case.plant.sliding
        if pulled < sliding * (1 - _NEAR):
            carries = say(
                "{pulled:.5g N·m}, as its key holds the sleeve; {sliding:.5g N·m} only as friction rises",
                pulled=pulled, sliding=sliding,
            )  # fmt: skip
        code = "motor-never-stops" if one.endless else "motor-stops-at-cut-off"
        level: Level = "error" if one.endless else "info"
        heat, off = one.energy or 0.0, train.cut_off
        yield finding(
            code, level, value=pulled, limit=strongest, path=path, at=end, carries=carries, heat=heat, off=off
        )
    for end, one in zip(_ENDS, outcomes, strict=True):
        path, lasted = "drive.event.duration", one.trip.time
        if not one.trip.stuck and not one.endless:
            yield finding("slip-outlasts-duration", "warning", value=lasted, path=path, at=end)
        elif one.trip.stuck and not one.trip.settled:
            yield finding("event-not-settled", "warning", value=lasted, path=path, at=end)


def _at_cut_off(each: Outcome) -> float | None:
    """Torque with which the pack slips as the motor is switched off, N·m; None where it does not slip then."""
    course, off = each.trip.course, each.case.plant.train.cut_off
    if off is None or not course or not each.energy:
        return None
    return next((abs(moment.torque) for moment in course if moment.time >= course[0].time + off), None)


def _judder(clutch: Clutch, train: Train, outcomes: Sequence[Outcome]) -> Iterator[Finding]:
    """Whether slow slip is steady (V6), where friction falls most with speed."""
    friction = clutch.spec.friction
    ratio, speed = friction.static_ratio or 1.0, friction.stribeck_speed
    if ratio == 1 or speed is None:
        return

    def needed(plant: Plant) -> float:
        return float(law.judder_damping(plant.pack.growth, clutch.mean_radius, ratio, speed))

    least, ordinary = max((needed(one.case.plant), needed(one.ordinary)) for one in outcomes)
    if train.damping <= least:
        path = "drive.damping_ratio"
        yield finding("judder", "info", value=least, limit=train.damping, path=path, ordinary=ordinary)


class Strength(NamedTuple):
    """What a control unit bears; None where it is not known, or nothing travels."""

    contact_force: float | None
    """On one ball, N."""
    contact_path: str
    """Key of the spec that this is from."""
    travel: float | None
    """At which a ball touches the edge of its pocket, m."""
    clearance: float
    """y that is to be left, m."""
    wall: Wall | None


def contact_forces(clutch: Clutch, outcomes: Sequence[Outcome]) -> list[float] | None:
    """Largest F_n of every event, N; None without balls whose number and circle are known."""
    unit = clutch.spec.control_unit
    if unit is None or unit.balls is None or unit.ball_circle_radius is None or not clutch.gain:
        return None
    if clutch.spec.kind.travels and let_go(outcomes) is None:
        return None  # feedback that the key just holds is simulated without its balls
    count, radius = unit.balls, unit.ball_circle_radius
    return [float(synthesis.contact_force(each.trip.peak_wall, count, radius, 1.0)) for each in outcomes]


def strength_of(clutch: Clutch) -> Strength:
    """Return what the control unit as synthesized bears."""
    if not ANALYSES["synthesize"].applies(clutch):
        return Strength(None, "", None, 0.0, None)
    unit, _ = synthesize(clutch)
    wall = wall_of(clutch, unit.face_gap, unit.ball_diameter / 2)
    if not clutch.spec.kind.travels or unit.ball_diameter_standard is None or not wall.can_be_cut:
        return Strength(unit.contact_force_allowable, unit.contact_path, None, 0.0, None)
    travel = wall.sleeves * wall.mouth
    return Strength(unit.contact_force_allowable, unit.contact_path, travel, unit.edge_clearance, wall)


def let_go(outcomes: Sequence[Outcome]) -> float | None:
    """Travel at which the closing spring presses no more, m; None without a sleeve."""
    pack = outcomes[-1].case.plant.pack
    return float(pack.farthest) if isinstance(pack, Sleeve) else None


def strains(clutch: Clutch, outcomes: Sequence[Outcome]) -> Iterator[Finding]:
    """Say where an event asks for more than balls, pockets or the closing spring have."""
    strength = strength_of(clutch)
    if (forces := contact_forces(clutch, outcomes)) is not None and strength.contact_force is not None:
        force, at = max(zip(forces, _ENDS, strict=True))
        if force > strength.contact_force * (1 + 1e-9):
            limit, path = strength.contact_force, strength.contact_path
            yield finding("event-contact-force", "error", value=force, limit=limit, path=path, at=at)
    travel, at = max((each.trip.travel_max, end) for each, end in zip(outcomes, _ENDS, strict=True))
    if strength.travel is not None and strength.wall is not None:
        left = strength.wall.clearance(travel)
        if travel > strength.travel:
            yield finding("event-ball-leaves-pocket", "error", value=travel, limit=strength.travel, at=at)
        elif left < strength.clearance * (1 - 1e-9):
            path = "control_unit.edge_clearance"
            yield finding(
                "event-clearance", "warning", value=left, limit=strength.clearance, path=path, at=at, travel=travel
            )
    yield from _springs(clutch, travel)
    free = let_go(outcomes)
    if free is not None and travel > free * (1 - 1e-9):
        yield finding("event-spring-let-go", "error", value=travel, limit=free, path="closing_spring", at=at)


def _springs(clutch: Clutch, travel: float) -> Iterator[Finding]:
    """What the springs named do not hold where the sleeve swings, and held where the law has it."""
    own, rules = clutch.spec, {}
    if not own.spring_parts or not own.kind.travels:
        return
    for path, each in checks_of_spec(own, clutch.spring_demands()):
        rules[path, each.rule] = each.beyond > _ROUNDING
    for path, each in checks_of_spec(own, clutch.spring_demands(travel)):
        if each.beyond > _ROUNDING and not rules.get((path, each.rule)):
            yield finding(
                "event-spring", each.rule.level, value=each.value, limit=each.limit, path=path, travel=travel,
                what=term(each.rule.what),
            )  # fmt: skip
