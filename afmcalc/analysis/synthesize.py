"""Synthesis of the control unit: wall angle, travel, balls, pockets, contact (S21 (16)–(24))."""

import math
from collections.abc import Sequence
from typing import Any, Literal

from ..arrays import finite
from ..engines.protocol import Clutch
from ..equations import synthesis as law
from ..errors import Problem, SpecError
from ..findings import Finding, finding
from ..messages import say
from ..result import Result, quantity
from ..spec import Spec, resolved
from ..spec.balls import diameters
from ..spec.contact import Contact
from ..spec.models import ControlUnit

DEFAULT_CLEARANCE = 0.002
"""s and y where the spec gives none, m: S21 takes 2…3 mm."""


class SynthesisResult(Result):
    """A control unit that fits the clutch."""

    wall_angle: float = quantity("rad", "α", "wall angle of the pockets")
    ball_circle_radius: float = quantity("m", "r", "radius of the ball circle")
    travel_max: float = quantity("m", "x_max", "largest travel of the sleeve")
    face_gap: float = quantity("m", "s", "gap between the faces")
    edge_clearance: float = quantity("m", "y", "clearance asked for")
    ball_radius: float = quantity("m", "r_ш", "smallest ball radius")
    ball_diameter_standard: float | None = quantity("m", "d_ш", "ball chosen: given, or the next standard one")
    edge_clearance_standard: float | None = quantity("m", "y_st", "clearance with the ball chosen")
    pocket_depth: float = quantity(
        "m", "h_1", "pocket depth to the virtual apex, for the ball chosen (the smallest where none is)"
    )
    pocket_depth_cut: float = quantity("m", "h_c", "pocket depth to cut: the ball's lowest point, where the walls end")
    pocket_width: float = quantity("m", "b", "width of the pocket's mouth at the face")
    ball_pitch: float | None = quantity("m", "t_ш", "distance between the centres of neighbouring balls")
    web: float | None = quantity("m", "e", "web between neighbouring pockets at the face")
    contact_force: float | None = quantity("N", "F_n", "largest normal force on one ball")
    contact_force_allowable: float | None = quantity("N", "[F_n]", "allowable normal force on one ball")
    contact_basis: Literal["given", "hertz-ball-on-flat"] | None = quantity(
        "", None, "where the allowable force is from"
    )
    contact_utilisation: float | None = quantity("1", "F_n/[F_n]", "utilisation of the contact")
    gain_at_least_contact_force: float | None = quantity(
        "1", "C_Fn", "gain of the least contact force at equal spring force; beyond it F_n grows", optional=True
    )

    @property
    def ball_diameter(self) -> float:
        """The ball chosen, or the smallest where none is."""
        return 2 * self.ball_radius if self.ball_diameter_standard is None else self.ball_diameter_standard


def synthesize(clutch: Clutch, balls: Sequence[float] | None = None) -> tuple[SynthesisResult, list[Finding]]:
    """Design the control unit of a clutch.

    Args:
        clutch: a clutch with a control unit.
        balls: standard ball diameters in ascending order, m; None for the list that ships.

    Returns:
        The result and its findings.

    Raises:
        SpecError: the spec lacks what synthesis needs.
    """
    unit = _unit(clutch)
    assert unit.ball_circle_radius is not None
    radius = float(clutch.mean_radius)
    tangent = float(law.tan_wall_angle(clutch.gain, unit.ball_circle_radius, radius))
    angle = math.atan(tangent)
    sine, cosine = math.sin(angle), math.cos(angle)
    travel = _travel(clutch)
    gap, clearance = (DEFAULT_CLEARANCE if given is None else given for given in (unit.face_gap, unit.edge_clearance))
    smallest = law.ball_radius(travel, gap, clearance, sine)
    sizes = balls or diameters()
    chosen = unit.ball_diameter or _next(sizes, 2 * smallest)
    own = None if chosen is None else chosen / 2
    fitting = smallest if own is None else own
    depth = law.pocket_depth(fitting, sine, gap)
    width = law.pocket_width(depth, tangent)
    pitch = _pitch(unit)
    force = _contact_force(clutch, unit, cosine)
    allowable, basis = _allowable(unit, own)
    result = SynthesisResult(
        wall_angle=angle,
        ball_circle_radius=unit.ball_circle_radius,
        travel_max=travel,
        face_gap=gap,
        edge_clearance=clearance,
        ball_radius=smallest,
        ball_diameter_standard=chosen,
        edge_clearance_standard=None if own is None else law.edge_clearance(own, travel, gap, sine),
        pocket_depth=depth,
        pocket_depth_cut=law.pocket_depth_cut(fitting, gap),
        pocket_width=width,
        ball_pitch=pitch,
        web=None if pitch is None else law.web(pitch, width),
        contact_force=force,
        contact_force_allowable=allowable,
        contact_basis=basis,
        contact_utilisation=None if force is None or allowable is None else force / allowable,
        gain_at_least_contact_force=least_contact_force_gain(clutch),
    )
    return result, [*clutch.findings(), *_findings(clutch, unit, result, sizes[-1])]


def _unit(clutch: Clutch) -> ControlUnit:
    """Return the control unit; refuse a clutch without what synthesis needs."""
    unit = clutch.spec.control_unit
    if unit is None:
        problem = Problem("variant", clutch.spec.variant, say("has no control unit to synthesize"))
    elif unit.ball_circle_radius is None:
        problem = Problem("control_unit.ball_circle_radius", None, say("required by synthesize"))
    elif clutch.gain == 0:
        problem = Problem("control_unit.gain", "0", say("must be greater than 0 to synthesize pockets"))
    else:
        return unit
    raise SpecError(clutch.spec.label, [problem])


def _travel(clutch: Clutch) -> float:
    """x_max; a direct clutch has no sleeve, and its law no travel."""
    return float(clutch.travel(clutch.friction[0].max) or 0.0)


def _next(sizes: Sequence[float], wanted: float) -> float | None:
    """Smallest standard size not below the wanted one; None when the list ends before it."""
    return next((size for size in sizes if size >= wanted * (1 - 1e-12)), None)


def _pitch(unit: ControlUnit) -> float | None:
    """Distance between neighbouring balls; None of a single one, or when their number is not given."""
    if unit.balls is None or unit.balls < 2:
        return None
    return float(law.ball_pitch(unit.ball_circle_radius, math.sin(math.pi / unit.balls)))


def _contact_force(clutch: Clutch, unit: ControlUnit, cosine: float) -> float | None:
    """Largest F_n along the common path; None when the number of balls is not given."""
    if unit.balls is None:
        return None
    first, second = clutch.friction
    torque = max(clutch.ball_torque(first.min, second.min), clutch.ball_torque(first.max, second.max))
    return float(law.contact_force(torque, unit.balls, unit.ball_circle_radius, cosine))


def _allowable(
    unit: ControlUnit, ball_radius: float | None
) -> tuple[float | None, Literal["given", "hertz-ball-on-flat"] | None]:
    """[F_n] as given, or by Hertz from the elastic data."""
    if unit.allowable_contact_force is not None:
        return unit.allowable_contact_force, "given"
    if unit.contact is None or ball_radius is None:
        return None, None
    return hertz_allowable_force(unit.contact, ball_radius), "hertz-ball-on-flat"


def hertz_allowable_force(contact: Contact, ball_radius: float) -> float:
    """Force at which a ball on a flat wall reaches the allowable pressure."""
    modulus = law.hertz_contact_modulus(
        contact.ball_modulus, contact.ball_poisson, contact.wall_modulus, contact.wall_poisson
    )
    return float(law.hertz_allowable_force(contact.allowable_pressure, ball_radius, modulus, math.pi))


def least_contact_force_gain(clutch: Clutch) -> float | None:
    """Gain at which F_n at f_max is least (spring force kept); None if F_n only grows or only falls."""
    import numpy as np

    unit = clutch.spec.control_unit
    assert unit is not None
    assert unit.ball_circle_radius is not None
    (a0, a1), (b0, b1), start = clutch.ball_torque_by_gain()
    ratio = unit.ball_circle_radius / float(clutch.mean_radius)
    cubic = law.least_contact_force_cubic(a0, a1, b0, b1, ratio)
    with np.errstate(over="raise", divide="raise", invalid="raise"):
        roots = np.roots([finite(each) for each in cubic])
    real = sorted(root.real for root in roots if abs(root.imag) < 1e-9 * abs(root) and root.real > start)
    return float(real[0]) if real else None


def completed(spec: Spec, result: SynthesisResult) -> dict[str, Any]:
    """Return the spec with the control unit as synthesized: wall angle instead of gain, the ball, gap and clearance."""
    data = resolved(spec)
    unit = data["control_unit"]
    unit.pop("gain", None)
    unit |= {
        "wall_angle": result.wall_angle,
        "ball_circle_radius": result.ball_circle_radius,
        "face_gap": result.face_gap,
        "edge_clearance": result.edge_clearance,
    }
    if result.ball_diameter_standard is not None:
        unit["ball_diameter"] = result.ball_diameter_standard
    return data


def _findings(clutch: Clutch, unit: ControlUnit, result: SynthesisResult, largest: float) -> list[Finding]:
    return [
        *_ball_findings(clutch, unit, result, largest),
        *_room_findings(unit, result),
        *_contact_findings(unit, result),
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


def _contact_findings(unit: ControlUnit, result: SynthesisResult) -> list[Finding]:
    found = []
    if unit.balls is None:
        found.append(finding("balls-not-given", "info", path="control_unit.balls"))
    if result.contact_utilisation is not None and result.contact_utilisation > 1:
        force, allowable = result.contact_force, result.contact_force_allowable
        path = "control_unit.allowable_contact_force"
        found.append(finding("contact-force-exceeded", "error", value=force, limit=allowable, path=path))
    return found
