"""What a designer should know of an event in the drive."""

import math
from collections.abc import Sequence

from ...engines.protocol import Clutch
from ...equations import drive as law
from ...findings import Finding, Level, finding
from .cases import Outcome
from .plant import Plant
from .result import SimulateResult
from .train import Train

_ENDS = ("f_min", "f_cp", "f_max")
_NEVER: tuple[tuple[str, Level], ...] = (("motor-never-stops", "error"), ("motor-never-stops/held", "error"))
_LATE: tuple[tuple[str, Level], ...] = (
    ("motor-stops-at-cut-off", "warning"),
    ("motor-stops-at-cut-off/held", "warning"),
)
"""What the motor does, and whether the pack slips with less than T(f) of the rising branch."""
_CLOSED = 1e-6
_NEAR = 1e-3
"""Relative difference below which a figure of the spec is what the simulation gives."""
_ROUNDING = 1e-9


def remarks_of(clutch: Clutch, train: Train, found: Sequence[Outcome], result: SimulateResult) -> list[Finding]:
    """Return the remarks on an event, ``found`` at f_min, mean friction and f_max, and on its ``result``."""
    return [
        _inertia(train, found),
        *_ordinary(train, found),
        *_before(train, found),
        *_endless(train, found),
        *_unclosed(found),
        *_lag(clutch, found),
        *_dynamic_factor(clutch, result),
        *_judder(clutch, train, found),
    ]


def _inertia(train: Train, found: Sequence[Outcome]) -> Finding:
    """What turns behind the discs does to the shaft: a sudden stop by its speed, a slow one by its deceleration."""
    path, plant = "drive.driven_inertia", found[-1].case.plant
    behind, limit, load = train.driven_inertia + train.hub_inertia, plant.sliding, min(train.load, plant.sliding)
    swing = math.pi * math.sqrt(behind / train.stiffness)
    # the slip begins as the tool, slowing down with ω_0/t_b, has wound the shaft up from the load
    wound = math.sqrt(2 * (limit - load) * train.time / (train.stiffness * train.speed))
    if train.kind == "load" or train.time <= wound + swing:
        return finding("inertia-torque", "info", value=train.inertia_torque, limit=limit, path=path)
    beyond = law.stop_torque(behind, train.speed / train.time, limit, load)
    return finding("inertia-torque/slow", "info", value=float(beyond), limit=limit, path=path, swing=swing)


def _ordinary(train: Train, found: Sequence[Outcome]) -> list[Finding]:
    """Where the ordinary clutch of equal nominal torque is no like for like comparison."""
    said, load = [], train.load
    if train.hub_inertia:
        inertia = train.driven_inertia + train.hub_inertia
        said.append(finding("ordinary-carries-hub", "info", value=inertia, path="drive.hub_inertia"))
    carried = min(each.ordinary.sliding for each in found)
    if carried < load * (1 - _ROUNDING):
        path = "adjustment.method"
        said.append(finding("ordinary-slips-before-event", "info", value=carried, limit=load, path=path))
    return said


def _before(train: Train, found: Sequence[Outcome]) -> list[Finding]:
    """The drive before the event: does the clutch carry the load, the motor drive it?"""
    said = []
    load, motor = train.load, float(train.engine.at(train.speed))
    for end, each in zip(_ENDS, found, strict=True):
        carried = each.case.plant.breakaway
        if carried < load * (1 - _ROUNDING):
            path = "drive.load_torque"
            said.append(finding("slips-before-event", "error", value=carried, limit=load, path=path, at=end))
    if abs(motor - load) > _NEAR * max(load, motor):
        path = "drive.speed" if train.engine.slip is not None else "drive.motor_torque"
        said.append(finding("drive-not-in-balance", "info", value=motor, limit=load, path=path))
    return said


def _endless(train: Train, found: Sequence[Outcome]) -> list[Finding]:
    """Does the motor stop, and does the slip end within the time that is simulated?"""
    said = []
    strongest, path = float(train.engine.torque), "drive.cut_off"
    for end, each in zip(_ENDS, found, strict=True):
        pulled = abs(each.trip.last) if each.endless else _at_cut_off(each)
        if pulled is None or not (each.endless or pulled <= strongest):
            continue
        sliding, off = each.case.plant.sliding, train.cut_off
        code, level = _NEVER[pulled < sliding * (1 - _NEAR)] if each.endless else _LATE[pulled < sliding * (1 - _NEAR)]
        heat = each.energy or 0.0
        said.append(
            finding(code, level, value=pulled, limit=strongest, path=path, at=end, sliding=sliding, heat=heat, off=off)
        )
    for end, each in zip(_ENDS, found, strict=True):
        path, lasted = "drive.event.duration", each.trip.time
        if not each.trip.stuck:
            if not each.endless:
                said.append(finding("slip-outlasts-duration", "warning", value=lasted, path=path, at=end))
        elif not each.trip.settled:
            said.append(finding("event-not-settled", "warning", value=lasted, path=path, at=end))
    return said


def _at_cut_off(each: Outcome) -> float | None:
    """Torque with which the pack slips as the motor is switched off, N·m; None where it does not slip then."""
    course, off = each.trip.course, each.case.plant.train.cut_off
    if off is None or not course or not each.energy:
        return None
    return next((abs(moment.torque) for moment in course if moment.time >= course[0].time + off), None)


def _unclosed(found: Sequence[Outcome]) -> list[Finding]:
    """Does the energy close? It always has."""
    worst = max(each.trip.residual for each in found)
    return [finding("energy-not-closed", "error", value=worst, limit=_CLOSED)] if worst > _CLOSED else []


def _lag(clutch: Clutch, found: Sequence[Outcome]) -> list[Finding]:
    """S22's open question, as a number: where between T_муф and T_п does this drive trip?"""
    unit, each = clutch.spec.control_unit, found[-1]
    share, at, held = each.trip_position, each.trip.trip_torque, each.potential
    if unit is None or not unit.release_lag or share is None:
        return []
    expected, path = each.case.plant.breakaway, "control_unit.release_lag"
    return [finding("release-lag", "info", value=at, limit=expected, path=path, share=share, held=held)]


def _dynamic_factor(clutch: Clutch, result: SimulateResult) -> list[Finding]:
    """Say that the dynamic factor given, which the life takes, is smaller than that of the event."""
    assumed, computed = clutch.spec.drive.dynamic_factor, result.largest_dynamic_factor
    if clutch.spec.fatigue is None or assumed is None or computed <= assumed * (1 + _NEAR):
        return []
    path = "drive.dynamic_factor"
    return [finding("dynamic-factor-exceeded", "warning", value=computed, limit=float(assumed), path=path)]


def _judder(clutch: Clutch, train: Train, found: Sequence[Outcome]) -> list[Finding]:
    """Whether slow slip is steady (V6), where friction falls most with speed."""
    friction = clutch.spec.friction
    ratio, speed = friction.static_ratio or 1.0, friction.stribeck_speed
    if ratio == 1 or speed is None:
        return []

    def needed(plant: Plant) -> float:
        return float(law.judder_damping(plant.growth, clutch.mean_radius, ratio, speed))

    worst = max(found, key=lambda each: needed(each.case.plant))
    own, ordinary, damping = needed(worst.case.plant), needed(worst.ordinary), train.damping
    if damping > own:
        return []
    return [finding("judder", "info", value=own, limit=damping, path="drive.damping_ratio", ordinary=ordinary)]
