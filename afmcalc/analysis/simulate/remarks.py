"""What a designer should know of an event in the drive."""

from collections.abc import Sequence

from ...engines.protocol import Clutch
from ...equations import drive as law
from ...findings import Finding, finding
from .cases import Outcome
from .plant import Plant
from .train import Train

_ENDS = ("f_min", "f_cp", "f_max")
_CLOSED = 1e-6
_NEAR = 1e-3
"""Relative difference below which a figure of the spec is what the simulation gives."""


def remarks_of(clutch: Clutch, train: Train, found: Sequence[Outcome]) -> list[Finding]:
    """Return the remarks on an event, ``found`` at f_min, mean friction and f_max."""
    return [
        _inertia(train, found),
        *_before(train, found),
        *_endless(train, found),
        *_unclosed(found),
        *_lag(clutch, found),
        *_dynamic_factor(clutch, found),
        *_judder(clutch, train, found),
    ]


def _inertia(train: Train, found: Sequence[Outcome]) -> Finding:
    """What the driven half alone does to the shaft."""
    path, torque = "drive.driven_inertia", train.inertia_torque
    return finding("inertia-torque", "info", value=torque, limit=found[-1].case.plant.sliding, path=path)


def _before(train: Train, found: Sequence[Outcome]) -> list[Finding]:
    """The drive before the event: does the clutch carry the load, the motor drive it?"""
    said = []
    load, motor = train.load, float(train.engine.at(train.speed))
    for end, each in zip(_ENDS, found, strict=True):
        carried = each.case.plant.breakaway
        if carried < load:
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
    going = [(end, each) for end, each in zip(_ENDS, found, strict=True) if each.endless]
    if going:
        at, least = ", ".join(end for end, _ in going), min(abs(each.trip.last) for _, each in going)
        said.append(finding("motor-never-stops", "error", value=least, limit=strongest, path=path, at=at))
    cut = [
        (end, each)
        for end, each in zip(_ENDS, found, strict=True)
        if train.cut_off is not None and each.energy and each.case.plant.sliding <= strongest
    ]
    if cut and train.cut_off is not None:
        at, least = ", ".join(end for end, _ in cut), min(each.case.plant.sliding for _, each in cut)
        heat = max(each.energy or 0.0 for _, each in cut)
        said.append(
            finding(
                "motor-stops-at-cut-off", "warning", value=least, limit=strongest, path=path, at=at, heat=heat,
                off=train.cut_off,
            )
        )  # fmt: skip
    for end, each in zip(_ENDS, found, strict=True):
        path, lasted = "drive.event.duration", each.trip.time
        if not each.trip.stuck:
            if not each.endless:
                said.append(finding("slip-outlasts-duration", "warning", value=lasted, path=path, at=end))
        elif not each.trip.settled:
            said.append(finding("event-not-settled", "warning", value=lasted, path=path, at=end))
    return said


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


def _dynamic_factor(clutch: Clutch, found: Sequence[Outcome]) -> list[Finding]:
    """Say that the dynamic factor given, which the life takes, is smaller than that of the event."""
    assumed, computed = clutch.spec.drive.dynamic_factor, max(each.dynamic_factor for each in found)
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
