"""Whether a control unit as synthesized can be made: what is in the way of what, and what would make room."""

from collections.abc import Iterator, Sequence

from ..engines import build
from ..engines.protocol import Clutch
from ..findings import Finding, finding
from ..recorders import unrecorded
from ..spec.edit import with_key
from ..spec.models import ControlUnit
from ..spec.read import next_size
from .unit import SynthesisResult
from .wall import DEFAULT_CLEARANCE, clearances, wall_of

_STEPS = 120
"""Gains tried for one with which a curved wall can be cut: up to ten times as large."""


def findings(clutch: Clutch, unit: ControlUnit, result: SynthesisResult, sizes: Sequence[float]) -> list[Finding]:
    """Say what a designer should know of a control unit as synthesized; ``sizes``: the standard balls there are."""
    return [
        *_ball_findings(clutch, unit, result, sizes[-1]),
        *_curve_findings(clutch, result, sizes),
        *_room_findings(unit, result),
        *_contact_findings(clutch, unit, result),
    ]


def _ball_findings(clutch: Clutch, unit: ControlUnit, result: SynthesisResult, largest: float) -> list[Finding]:
    found = []
    for key, given in (("face_gap", unit.face_gap), ("edge_clearance", unit.edge_clearance)):
        if given is None:
            found.append(finding("default-clearance", "info", value=DEFAULT_CLEARANCE, path=f"control_unit.{key}"))
    if not clutch.spec.kind.travels:
        found.append(finding("no-sleeve-travel", "info", value=0.0))
    chosen, smallest = result.ball_diameter_standard, 2 * result.ball_radius
    if chosen is None:
        found.append(finding("no-standard-ball", "error", value=smallest, limit=largest))
    elif chosen < smallest * (1 - 1e-12):
        path = "control_unit.ball_diameter"
        found.append(finding("ball-too-small", "error", value=chosen, limit=smallest, path=path))
    return found


def _curve_findings(clutch: Clutch, result: SynthesisResult, sizes: Sequence[float]) -> list[Finding]:
    """Say what cannot be cut, and what would; and how the ball is held in the other sleeve."""
    limit, found = result.undercut_radius, []
    if limit is None:
        return []
    if result.profiled == "both":
        found.append(finding("both-sleeves-unstable", "warning", value=2.0, path="control_unit.profiled"))
    else:
        found.append(finding("ball-slides-in-seat", "info", path="control_unit.profiled"))
    if result.ball_diameter >= 2 * limit:
        path = "control_unit.gain_slope"
        if result.ball_diameter_standard is None:
            path = "control_unit.ball_diameter"
        needed, value = 2 * result.ball_radius, result.ball_diameter
        gain = _gain_that_can_be_cut(clutch, sizes)
        code = "wall-undercut" if gain is None else "wall-undercut/gain"
        found.append(finding(code, "error", value=value, limit=2 * limit, path=path, needed=needed, gain=gain))
    return found


@unrecorded()
def _gain_that_can_be_cut(clutch: Clutch, sizes: Sequence[float]) -> float | None:
    """Smallest gain, in steps of 2 %, with which a standard ball is large enough and does not undercut."""
    unit, gain = clutch.spec.control_unit, float(clutch.gain)
    assert unit is not None
    gap, clearance = clearances(unit)
    for _ in range(_STEPS):
        gain *= 1.02
        steeper = build(with_key(clutch.spec, "control_unit.gain", gain))
        wall = wall_of(steeper, gap)
        chosen = next_size(
            sizes, 2 * wall.smallest_ball(float(steeper.travel(steeper.friction[0].max) or 0.0), clearance)
        )
        if chosen is not None and wall._replace(ball_radius=chosen / 2).can_be_cut:
            return gain
    return None


def _room_findings(unit: ControlUnit, result: SynthesisResult) -> list[Finding]:
    """Say what is in the way of what: balls of balls or the axis, pockets of pockets or the back of the sleeve."""
    diameter, pitch, path = result.ball_diameter, result.ball_pitch, "control_unit.balls"
    found = []
    if pitch is None:
        if diameter >= 2 * result.ball_circle_radius:
            path = "control_unit.ball_circle_radius"
            found.append(
                finding("ball-reaches-axis", "error", value=diameter / 2, limit=result.ball_circle_radius, path=path)
            )
    else:
        if diameter >= pitch:
            found.append(finding("balls-overlap", "error", value=diameter, limit=pitch, path=path, balls=unit.balls))
        if result.pocket_width >= pitch:
            width = result.pocket_width
            found.append(finding("pockets-overlap", "error", value=width, limit=pitch, path=path, balls=unit.balls))
    if unit.sleeve_depth is not None and result.pocket_depth_cut >= unit.sleeve_depth:
        depth, path = result.pocket_depth_cut, "control_unit.sleeve_depth"
        found.append(finding("depth-beyond-sleeve", "error", value=depth, limit=unit.sleeve_depth, path=path))
    return found


def _contact_findings(clutch: Clutch, unit: ControlUnit, result: SynthesisResult) -> list[Finding]:
    found = []
    if unit.balls is None:
        found.append(finding("balls-not-given", "info", path="control_unit.balls"))
    if unit.contact is None and result.contact_pressure is not None:
        steel = unit.elasticity
        found.append(
            finding(
                "contact-assumed", "info", value=result.contact_pressure, limit=steel.allowable_pressure,
                path="control_unit.contact", modulus=steel.wall_modulus, poisson=steel.wall_poisson,
            )
        )  # fmt: skip
    for force, allowable, by_hertz in contact_limits(clutch, result):
        if force > allowable:
            code, path = "contact-force-exceeded", "control_unit.allowable_contact_force"
            if by_hertz:
                code, path = "contact-force-exceeded/hertz", "control_unit.contact"
            reached, allowed = result.contact_pressure, unit.elasticity.allowable_pressure
            found.append(
                finding(code, "error", value=force, limit=allowable, path=path, reached=reached, allowed=allowed)
            )
    if result.seat_force is not None and result.seat_utilisation is not None and result.seat_utilisation > 1:
        force, path = result.seat_force, result.contact_path
        allowable = force / result.seat_utilisation
        found.append(finding("seat-force-exceeded", "error", value=force, limit=allowable, path=path))
    return found


def contact_limits(clutch: Clutch, result: SynthesisResult) -> Iterator[tuple[float, float, bool]]:
    """Yield each limit of the contact: normal force on a ball, what it may be, N, and whether Hertz says so."""
    unit = clutch.spec.control_unit
    if unit is None or result.contact_force is None:
        return
    if unit.allowable_contact_force is not None:
        yield result.contact_force, unit.allowable_contact_force, False
    if result.contact_force_hertz is not None:
        yield result.contact_force_critical or result.contact_force, result.contact_force_hertz, True
