"""Synthesis of the control unit: wall angle, travel, balls, pockets, contact (S21 (16)–(24))."""

import math
from collections.abc import Iterator, Sequence
from typing import Any, ClassVar

from ..engines import build
from ..engines.protocol import Clutch
from ..equations import synthesis as law
from ..errors import given
from ..findings import Finding, finding
from ..messages import say
from ..result import Answer, Sentence, described, quantity
from ..spec import Spec, resolved
from ..spec.edit import with_key
from ..spec.lists import ball_designation, diameters, next_size
from ..spec.models import ControlUnit
from .wall import DEFAULT_CLEARANCE, Basis, WallPoint, clearances, contact_of, places_along, wall_of

_STEPS = 120
"""Gains tried for one with which a curved wall can be cut: up to ten times as large."""


class SynthesisResult(Answer):
    """A control unit that fits the clutch."""

    rows_with_values: ClassVar[bool] = True

    wall_angle: float = quantity("rad", "α", "wall angle of the pockets; of a curved wall at the stop")
    wall_angle_max: float | None = quantity("rad", "α_max", "wall angle at the largest travel", optional=True)
    gain_slope: float | None = quantity("1/m", "C_1", "how the gain grows with the sleeve's travel", optional=True)
    ball_circle_radius: float = quantity("m", "r", "radius of the ball circle")
    travel_max: float = quantity("m", "x_max", "largest travel of the sleeve")
    face_gap: float = quantity("m", "s", "gap between the faces")
    edge_clearance: float = quantity("m", "y", "clearance asked for")
    ball_radius: float = quantity("m", "r_ш", "smallest ball radius")
    undercut_radius: float | None = quantity(
        "m", "ρ_0", "radius of a ball that undercuts the curved wall: all smaller ones run on it", optional=True
    )
    ball_diameter_standard: float | None = quantity("m", "d_ш", "ball chosen: given, or the next standard one")
    ball_designation: Sentence | None = described("designation of the ball, without its grade", optional=True)
    edge_clearance_standard: float | None = quantity("m", "y_st", "clearance with the ball chosen")
    pocket_depth: float = quantity(
        "m", "h_1", "pocket depth to the virtual apex, for the ball chosen (the smallest where none is)"
    )
    pocket_depth_cut: float = quantity("m", "h_c", "pocket depth to cut: the ball's lowest point, where the walls end")
    pocket_width: float = quantity("m", "b", "width of the pocket's mouth at the face")
    ball_pitch: float | None = quantity("m", "t_ш", "distance between the centres of neighbouring balls")
    web: float | None = quantity("m", "e", "web between neighbouring pockets at the face")
    contact_force: float | None = quantity("N", "F_n", "largest normal force on one ball")
    contact_force_critical: float | None = quantity(
        "N", "F_n,c", "normal force on one ball where the contact pressure is largest", optional=True
    )
    contact_force_allowable: float | None = quantity("N", "[F_n]", "allowable normal force on one ball")
    contact_basis: Basis | None = described("where the allowable force is from")
    contact_utilisation: float | None = quantity("1", "F_n/[F_n]", "utilisation of the contact")
    contact_force_hertz: float | None = quantity(
        "N", "[F_n]_H", "normal force on one ball at the allowable contact pressure", optional=True
    )
    contact_pressure: float | None = quantity(
        "Pa", "p_0", "largest contact pressure of ball and wall (Hertz)", optional=True
    )
    wall: list[WallPoint] | None = described(
        "curved wall from the stop to the face, from the ball's centre at the stop", optional=True
    )

    @property
    def contact_path(self) -> str:
        """Key of the spec that the allowable force is from, or would be."""
        return "control_unit.allowable_contact_force" if self.contact_basis == "given" else "control_unit.contact"

    @property
    def ball_diameter(self) -> float:
        """The ball chosen, or the smallest where none is."""
        return 2 * self.ball_radius if self.ball_diameter_standard is None else self.ball_diameter_standard


def synthesize(clutch: Clutch, balls: Sequence[float] | None = None) -> tuple[SynthesisResult, list[Finding]]:
    """Design the control unit of a clutch, with ``balls`` to choose from, m, ascending; None: those of the spec.

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
    sizes = balls or clutch.spec.lists.balls or diameters()
    chosen = unit.ball_diameter or next_size(sizes, 2 * smallest)
    wall = bare._replace(ball_radius=smallest if chosen is None else chosen / 2)
    depth = law.pocket_depth(wall.ball_radius, sine, gap)
    curved = bare.steepening > 0
    width = wall.width if curved else law.pocket_width(depth, bare.tangent)
    pitch = None
    if unit.balls is not None and unit.balls > 1:
        pitch = float(law.ball_pitch(unit.ball_circle_radius, math.sin(math.pi / unit.balls)))
    # the largest F_n along the common path
    if clutch.sleeve is not None and curved:
        places = places_along(clutch.sleeve, wall)
    else:
        first, second = clutch.friction
        torque = max(clutch.ball_torque(first.min, second.min), clutch.ball_torque(first.max, second.max))
        places = [torque], [wall.angle]
    contact = contact_of(unit, wall, *places, ball_known=chosen is not None)
    of_the_curve: dict[str, Any] = {}
    if curved:
        of_the_curve = {
            "wall_angle_max": wall.angle_at(travel / wall.sleeves),
            "gain_slope": clutch.sleeve and clutch.sleeve.gain_slope,
            "undercut_radius": wall.undercut_radius,
            "wall": wall.points() if wall.can_be_cut else None,
        }
    result = SynthesisResult(
        wall_angle=bare.angle,
        ball_circle_radius=unit.ball_circle_radius,
        travel_max=travel,
        face_gap=gap,
        edge_clearance=clearance,
        ball_radius=smallest,
        ball_diameter_standard=chosen,
        ball_designation=None if chosen is None else ball_designation(chosen),
        edge_clearance_standard=None if chosen is None else wall.clearance(travel),
        pocket_depth=depth,
        pocket_depth_cut=law.pocket_depth_cut(wall.ball_radius, gap),
        pocket_width=width,
        ball_pitch=pitch,
        web=None if pitch is None else law.web(pitch, width),
        **contact._asdict(),
        **of_the_curve,
    )
    return result, [
        *clutch.findings(),
        *_ball_findings(clutch, unit, result, sizes[-1]),
        *_curve_findings(clutch, result, sizes),
        *_room_findings(unit, result),
        *_contact_findings(clutch, unit, result),
    ]


def _unit(clutch: Clutch) -> ControlUnit:
    """Return the control unit; refuse a clutch without what synthesis needs."""
    unit = clutch.spec.control_unit
    if unit is None:
        raise clutch.spec.refused("variant", say("has no control unit to synthesize"), clutch.spec.variant)
    if unit.ball_circle_radius is None:
        raise clutch.spec.refused("control_unit.ball_circle_radius", say("required by synthesize"))
    if clutch.gain == 0:
        raise clutch.spec.refused("control_unit.gain", say("must be greater than 0 to synthesize pockets"), "0")
    return unit


def _travel(clutch: Clutch) -> float:
    """x_max; a direct clutch has no sleeve, and its law no travel."""
    return float(clutch.sleeve.travel_max) if clutch.sleeve else 0.0


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


def contact_limits(clutch: Clutch, result: SynthesisResult) -> Iterator[tuple[float, float, bool]]:
    """Yield each limit of the contact: normal force on a ball, what it may be, N, and whether Hertz says so."""
    unit = clutch.spec.control_unit
    if unit is None or result.contact_force is None:
        return
    if unit.allowable_contact_force is not None:
        yield result.contact_force, unit.allowable_contact_force, False
    if result.contact_force_hertz is not None:
        yield result.contact_force_critical or result.contact_force, result.contact_force_hertz, True


def _ball_findings(clutch: Clutch, unit: ControlUnit, result: SynthesisResult, largest: float) -> Iterator[Finding]:
    """Say what is taken where the spec says nothing, and whether the ball chosen will do."""
    for key in ("face_gap", "edge_clearance"):
        if getattr(unit, key) is None:
            yield finding("default-clearance", "info", value=DEFAULT_CLEARANCE, path=f"control_unit.{key}")
    if not clutch.spec.kind.travels:
        yield finding("no-sleeve-travel", "info", value=0.0)
    chosen, smallest = result.ball_diameter_standard, 2 * result.ball_radius
    if chosen is None:
        yield finding("no-standard-ball", "error", value=smallest, limit=largest)
    elif chosen < smallest * (1 - 1e-12):
        yield finding("ball-too-small", "error", value=chosen, limit=smallest, path="control_unit.ball_diameter")


def _curve_findings(clutch: Clutch, result: SynthesisResult, sizes: Sequence[float]) -> Iterator[Finding]:
    """Say what cannot be cut, and what would; and how the ball is held in the other sleeve."""
    limit = result.undercut_radius
    if limit is None:
        return
    key = "gain_slope" if given(clutch.spec.control_unit).pocket is None else "pocket"
    yield finding("ball-slides-in-seat", "info", path=f"control_unit.{key}")
    if result.ball_diameter >= 2 * limit:
        path = "control_unit.ball_diameter" if result.ball_diameter_standard is None else "control_unit.gain_slope"
        needed, value, gain = 2 * result.ball_radius, result.ball_diameter, _gain_that_can_be_cut(clutch, sizes)
        code = "wall-undercut" if gain is None else "wall-undercut/gain"
        yield finding(code, "error", value=value, limit=2 * limit, path=path, needed=needed, gain=gain)


def _gain_that_can_be_cut(clutch: Clutch, sizes: Sequence[float]) -> float | None:
    """Smallest gain, in steps of 2 %, with which a standard ball is large enough and does not undercut."""
    gain, (gap, clearance) = float(clutch.gain), clearances(given(clutch.spec.control_unit))
    for _ in range(_STEPS):
        gain *= 1.02
        steeper = build(with_key(clutch.spec, "control_unit.gain", gain))
        wall = wall_of(steeper, gap)
        chosen = next_size(sizes, 2 * wall.smallest_ball(_travel(steeper), clearance))
        if chosen is not None and wall._replace(ball_radius=chosen / 2).can_be_cut:
            return gain
    return None


def _room_findings(unit: ControlUnit, result: SynthesisResult) -> Iterator[Finding]:
    """Say what is in the way of what: balls of balls or the axis, pockets of pockets or the back of the sleeve."""
    diameter, pitch, circle = result.ball_diameter, result.ball_pitch, result.ball_circle_radius
    path, width, depth = "control_unit.balls", result.pocket_width, result.pocket_depth_cut
    if pitch is None:
        if diameter >= 2 * circle:
            path = "control_unit.ball_circle_radius"
            yield finding("ball-reaches-axis", "error", value=diameter / 2, limit=circle, path=path)
    else:
        if diameter >= pitch:
            yield finding("balls-overlap", "error", value=diameter, limit=pitch, path=path, balls=unit.balls)
        if width >= pitch:
            yield finding("pockets-overlap", "error", value=width, limit=pitch, path=path, balls=unit.balls)
    if unit.sleeve_depth is not None and depth >= unit.sleeve_depth:
        path = "control_unit.sleeve_depth"
        yield finding("depth-beyond-sleeve", "error", value=depth, limit=unit.sleeve_depth, path=path)


def _contact_findings(clutch: Clutch, unit: ControlUnit, result: SynthesisResult) -> Iterator[Finding]:
    """Say what of the contact is not known or assumed, and what is exceeded."""
    if unit.balls is None:
        yield finding("balls-not-given", "info", path="control_unit.balls")
    elastic = unit.elasticity
    if unit.contact is None and result.contact_pressure is not None:
        yield finding(
            "contact-assumed", "info", value=result.contact_pressure, limit=elastic.allowable_pressure,
            path="control_unit.contact", modulus=elastic.wall_modulus, poisson=elastic.wall_poisson,
        )  # fmt: skip
    for force, allowable, by_hertz in contact_limits(clutch, result):
        if force > allowable:
            code, path = "contact-force-exceeded", "control_unit.allowable_contact_force"
            if by_hertz:
                code, path = "contact-force-exceeded/hertz", "control_unit.contact"
            reached, allowed = result.contact_pressure, elastic.allowable_pressure
            yield finding(code, "error", value=force, limit=allowable, path=path, reached=reached, allowed=allowed)
