"""Synthesis of the control unit: wall angle, travel, balls, pockets, contact (S21 (16)–(24))."""

import math
from collections.abc import Sequence
from typing import Any

from ..arrays import finite
from ..engines.protocol import Clutch
from ..equations import synthesis as law
from ..errors import Problem, SpecError
from ..findings import Finding
from ..messages import say
from ..spec import Spec, resolved
from ..spec.models import ControlUnit
from ..spec.read import diameters, next_size
from . import fit
from .contact import BallContact, contact_of, places_along
from .unit import SynthesisResult
from .wall import Wall, clearances, wall_of


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
    travel = _travel(clutch)
    gap, clearance = clearances(unit)
    bare = wall_of(clutch, gap)
    sine = math.sin(bare.angle)
    smallest = bare.smallest_ball(travel, clearance)
    sizes = balls or diameters()
    chosen = unit.ball_diameter or next_size(sizes, 2 * smallest)
    own = None if chosen is None else chosen / 2
    wall = bare._replace(ball_radius=smallest if own is None else own)
    depth = law.pocket_depth(wall.ball_radius, sine, gap)
    curved = bare.steepening > 0
    width = wall.width if curved else law.pocket_width(depth, bare.tangent)
    pitch = _pitch(unit)
    contact = _contact(clutch, unit, wall, own)
    result = SynthesisResult(
        wall_angle=bare.angle,
        ball_circle_radius=unit.ball_circle_radius,
        travel_max=travel,
        face_gap=gap,
        edge_clearance=clearance,
        ball_radius=smallest,
        ball_diameter_standard=chosen,
        edge_clearance_standard=None if own is None else wall.clearance(travel),
        pocket_depth=depth,
        pocket_depth_cut=law.pocket_depth_cut(wall.ball_radius, gap),
        pocket_width=width,
        ball_pitch=pitch,
        web=None if pitch is None else law.web(pitch, width),
        contact_force=contact.force,
        contact_force_allowable=contact.allowable,
        contact_basis=contact.basis,
        contact_utilisation=contact.utilisation,
        contact_force_hertz=contact.hertz,
        contact_pressure=contact.pressure,
        gain_at_least_contact_force=least_contact_force_gain(clutch),
        **(_of_the_curve(clutch, wall, contact, travel) if curved else {}),
    )
    return result, [*clutch.findings(), *fit.findings(clutch, unit, result, sizes)]


def _of_the_curve(clutch: Clutch, wall: Wall, contact: BallContact, travel: float) -> dict[str, Any]:
    """What a curved wall has and a straight one has not."""
    unit = clutch.spec.control_unit
    assert unit is not None
    return {
        "wall_angle_max": wall.angle_at(travel / wall.sleeves),
        "gain_slope": clutch.gain_slope,
        "profiled": unit.profiled or "one",
        "undercut_radius": wall.undercut_radius,
        "contact_force_critical": contact.critical,
        "seat_force": contact.seat,
        "seat_utilisation": contact.seat_utilisation,
        "wall": wall.points() if wall.can_be_cut else None,
    }


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


def _pitch(unit: ControlUnit) -> float | None:
    """Distance between neighbouring balls; None of a single one, or when their number is not given."""
    if unit.balls is None or unit.balls < 2:
        return None
    return float(law.ball_pitch(unit.ball_circle_radius, math.sin(math.pi / unit.balls)))


def _contact(clutch: Clutch, unit: ControlUnit, wall: Wall, ball_radius: float | None) -> BallContact:
    """Largest F_n along the common path, and what it may be."""
    if wall.steepening > 0:
        places = places_along(clutch, wall)
    else:
        first, second = clutch.friction
        torque = max(clutch.ball_torque(first.min, second.min), clutch.ball_torque(first.max, second.max))
        places = [torque], [wall.angle]
    return contact_of(unit, wall, *places, ball_known=ball_radius is not None)


def least_contact_force_gain(clutch: Clutch) -> float | None:
    """Gain at which F_n at f_max is least (spring force kept); None if F_n only grows or only falls."""
    import numpy as np

    unit = clutch.spec.control_unit
    assert unit is not None
    assert unit.ball_circle_radius is not None
    by_gain = clutch.ball_torque_by_gain()
    if by_gain is None:
        return None
    (a0, a1), (b0, b1), start = by_gain
    ratio = unit.ball_circle_radius / float(clutch.mean_radius)
    cubic = law.least_contact_force_cubic(a0, a1, b0, b1, ratio)
    with np.errstate(over="raise", divide="raise", invalid="raise"):
        roots = np.roots([float(finite(each)) for each in cubic])
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
