"""Where the parts of a clutch lie in its half section, as rings along the axis: for numbers and for arrays alike.

The arrangement is that of the papers: F11 fig. 1 and S19 fig. 1 of a direct clutch, S21 fig. 1 of an indirect one. The
web of the housing is at 0. Clearances, thrust bearings, keys, splines and bolts are not in it, so it is the least
space; what the spec does not tell (springs that are not named, the ball) is left out.
"""

import math
from collections.abc import Iterator
from itertools import combinations, product
from typing import Any, Literal, NamedTuple

from ..arrays import Values, chosen, larger, smaller
from ..equations import effects, synthesis
from ..equations import layout as law
from ..equations import springs as springs_law
from ..spec.models import CoilSprings, Spec, bore_of
from .protocol import Clutch
from .springs import characteristic

STEEL = 7850.0
"""Density that every part is taken to have, kg/m³."""
FACE_GAP = 0.002
"""s where the spec gives none, m (S21: 2…3 mm)."""
TOUCHES = 1e-9
"""Overlap that rounding may make of parts that touch, m."""

PartName = Literal[
    "housing", "hub", "pack", "pressure disc", "thrust disc", "ball sleeve", "thrust sleeve", "stop ring", "balls",
    "closing spring", "control spring",
]  # fmt: skip
Half = Literal["driving", "hub", "driven"]
"""What a part turns with: the housing, what is between discs and balls (indirect), or the hub."""


class Box(NamedTuple):
    """A ring of rectangular section, m."""

    left: Values
    right: Values
    inner: Values
    outer: Values


class Solid(NamedTuple):
    """Mass that a part adds to one half, spread over a ring: one of steel unless the mass is given."""

    half: Half
    box: Box
    given: Values | None = None
    """kg."""

    @property
    def mass(self) -> Values:
        """Mass, kg."""
        if self.given is not None:
            return self.given
        left, right, inner, outer = self.box
        length = larger(right - left, 0.0)
        return springs_law.ring_mass(STEEL, 2 * larger(outer, inner), 2 * inner, length, math.pi)

    @property
    def inertia(self) -> Values:
        """Moment of inertia about the axis, kg·m²."""
        return law.ring_inertia(self.mass, 2 * self.box.outer, 2 * self.box.inner)


class SectionPart(NamedTuple):
    """One part of the clutch in half section."""

    name: PartName
    boxes: tuple[Box, ...]
    bodies: tuple[Solid, ...]


class SpringSize(NamedTuple):
    """Room that a spring takes as it is set, m, and its mass, kg; nothing of a spring that is not named."""

    inner: Values = 0.0
    outer: Values = 0.0
    length: Values = 0.0
    mass: Values = 0.0


class Sizes(NamedTuple):
    """What the layout is made of, m."""

    travels: bool
    pairs: Values
    inner_radius: Values
    outer_radius: Values
    bore: float
    """Radius of the bore."""
    hub: float
    """Radius of the hub."""
    disc: float
    plate: float
    wall: float
    ball: Values = 0.0
    """Diameter; 0 of a clutch without balls."""
    balls: int = 0
    circle: Values = 0.0
    gap: float = FACE_GAP
    depth: float | None = None
    """Thickness of the sleeves that the pockets are cut into; None: the pocket and a floor as thick as a plate."""
    travel: Values = 0.0
    closing: SpringSize = SpringSize()
    control: SpringSize = SpringSize()


def sizes_of(clutch: Clutch) -> Sizes:
    """Return the sizes of a clutch whose spec has an envelope, the sleeve with room to travel."""
    spec: Any = clutch.spec
    room, group, unit = spec.envelope, spec.friction_group, spec.control_unit
    control = {}
    if unit is not None and unit.ball_diameter is not None and unit.ball_circle_radius is not None:
        control = {
            "ball": unit.ball_diameter, "balls": unit.balls or 0, "circle": unit.ball_circle_radius,
            "gap": FACE_GAP if unit.face_gap is None else unit.face_gap, "depth": unit.sleeve_depth,
        }  # fmt: skip
    hub = room.hub_diameter if unit is None or unit.hub_diameter is None else unit.hub_diameter
    return Sizes(
        spec.kind.travels, group.pairs, group.inner_radius, group.outer_radius, bore_of(spec) / 2, hub / 2,
        room.disc_thickness, room.plate_thickness, room.housing_wall, **control,
        travel=clutch.sleeve.travel_max if clutch.sleeve else 0.0,
        closing=_spring(spec, "closing", clutch.closing_force),
        control=_spring(spec, "control", clutch.sleeve.control_force) if clutch.sleeve else SpringSize(),
    )  # fmt: skip


def _spring(spec: Spec, name: str, force: Values) -> SpringSize:
    """Return the size of a spring as set; nothing of one not named, or of coils on a circle that is not told."""
    if (part := spec.spring_parts.get(name)) is None:
        return SpringSize()
    own: Any = characteristic(part)
    length = own.free_length - own.deflection(force)
    if not isinstance(part, CoilSprings):
        disc = springs_law.ring_mass(STEEL, part.outer_diameter, part.inner_diameter, own.thickness, math.pi)
        mass = part.parallel * part.series * disc
        return SpringSize(part.inner_diameter / 2, part.outer_diameter / 2, length, mass)
    mass = part.count * springs_law.coil_mass(STEEL, part.wire_diameter, part.coil_diameter, part.turns, math.pi)
    wide = part.coil_diameter + part.wire_diameter
    if part.count == 1:
        return SpringSize(wide / 2 - part.wire_diameter, wide / 2, length, mass)
    room = getattr(spec, f"{name}_spring").room
    if room is None or room.inner_diameter is None or room.outer_diameter is None:
        return SpringSize()
    circle = (room.inner_diameter + room.outer_diameter) / 4
    return SpringSize(circle - wide / 2, circle + wide / 2, length, mass)


def parts_of(size: Sizes) -> list[SectionPart]:
    """Lay out the parts of a clutch from the web of the housing on; a ring that is not there has no extent."""
    hub, plate, carrier, gap = size.hub, size.plate, size.inner_radius - size.wall, size.gap
    pack, plate_at = 2 * plate, 2 * plate + size.pairs * size.disc
    behind = plate_at + plate
    there = size.ball > 0
    reach = size.circle + size.ball / 2
    cut = synthesis.pocket_depth_cut(size.ball / 2, gap) + plate if size.depth is None else size.depth
    depth = _where(there, cut + 0.0 * size.ball)
    # a sleeve is as wide as its balls, and goes under the pack
    rim = chosen(there, lambda: larger(smaller(reach, carrier), hub), lambda: hub + 0.0 * reach)
    if size.travels:
        flange = behind + size.closing.length
        face = larger(pack + depth, flange + plate - depth - gap)
        end = larger(face + gap + depth, flange + plate)
        widest = smaller(larger(larger(size.closing.outer, size.control.outer), rim), size.outer_radius)
        nut = larger(flange + plate + larger(size.control.length, size.travel), end + size.travel)
        seat, control_at = larger(size.control.outer, rim), flange + plate
        held = chosen(there, lambda: reach + size.wall, lambda: reach)
        sleeves: tuple[tuple[PartName, Half, tuple[Box, ...]], ...] = (
            ("pressure disc", "hub", (Box(plate_at, behind, carrier, size.outer_radius),)),
            ("ball sleeve", "hub", (Box(pack, face, hub, rim),)),
            ("thrust sleeve", "driven", (Box(face + gap, end, hub, rim), Box(flange, control_at, rim, widest))),
            ("stop ring", "driven", (Box(behind, flange, reach, held),)),
        )
        hub_half: Half = "hub"
    else:
        face, control_at = plate + larger(depth, plate), behind
        second = face + gap
        end = chosen(there, lambda: larger(behind, second + depth), lambda: behind + 0.0 * depth)
        nut = larger(end, behind + size.closing.length)
        seat, hub_half = larger(size.closing.outer, hub), "driven"
        sleeves = (
            ("thrust disc", "driven", (Box(plate, pack, hub, size.outer_radius), Box(pack, face, hub, rim))),
            (
                "pressure disc",
                "driven",
                (
                    Box(plate_at, behind, hub, size.outer_radius),
                    Box(second, plate_at, hub, rim),
                    Box(behind, end, hub, rim),
                ),
            ),
        )
    seat = smaller(seat, size.outer_radius)
    total, wall = nut + plate, size.outer_radius + size.wall
    flanges = (Box(plate, pack, hub, size.outer_radius),) if size.travels else ()
    hub_boxes = (Box(plate, total, size.bore, hub), *flanges, Box(nut, total, hub, seat))
    ball_at = face + gap / 2
    ball = Box(ball_at - size.ball / 2, ball_at + size.ball / 2, size.circle - size.ball / 2, reach)
    all_balls = size.balls * effects.ball_mass(STEEL, size.ball / 2, math.pi)
    # an outer disc is next to the pressure disc, the others take turns
    outer_discs = (size.pairs + size.pairs % 2) / 2 * size.disc
    discs = (
        Solid("driving", Box(pack, pack + outer_discs, size.inner_radius, size.outer_radius)),
        Solid(hub_half, Box(pack + outer_discs, plate_at, size.inner_radius, size.outer_radius)),
        Solid(hub_half, Box(pack, plate_at, carrier, size.inner_radius)),
    )
    closing = Box(behind, behind + size.closing.length, size.closing.inner, size.closing.outer)
    control = Box(control_at, control_at + size.control.length, size.control.inner, size.control.outer)
    return [
        _made("housing", "driving", (Box(0.0, plate, size.bore, wall), Box(plate, total, size.outer_radius, wall))),
        _made("hub", "driven", hub_boxes),
        SectionPart("pack", (Box(pack, plate_at, carrier, size.outer_radius),), discs),
        *(_made(*sleeve) for sleeve in sleeves),
        SectionPart("balls", (ball,), (Solid("driven", ball, all_balls),)),
        SectionPart("closing spring", (closing,), (Solid("driven", closing, size.closing.mass),)),
        *((SectionPart("control spring", (control,), (Solid("driven", control, size.control.mass),)),) * size.travels),
    ]


def _made(name: PartName, half: Half, boxes: tuple[Box, ...]) -> SectionPart:
    return SectionPart(name, boxes, tuple(Solid(half, box) for box in boxes))


_POCKETS = {("pressure disc", "balls"), ("thrust disc", "balls"), ("ball sleeve", "balls"), ("thrust sleeve", "balls")}
"""What is cut into what."""
_DIRECT_ONLY = ("pressure disc", "balls")


def overlaps(parts: list[SectionPart]) -> Iterator[tuple[PartName, PartName, Values]]:
    """Yield every two parts that could be in each other's way, and by how much at most, m; none where it is ≤ 0.

    It is the shorter way out, along the axis or across it. A ball is in the pockets of its two sleeves; those of a
    direct clutch are cut into thrust disc and pressure disc.
    """
    indirect = any(part.name == "thrust sleeve" for part in parts)
    for first, second in combinations(parts, 2):
        pair = first.name, second.name
        if pair in _POCKETS and not (indirect and pair == _DIRECT_ONLY):
            continue
        yield (*pair, overlap(first, second))


def overlap(first: SectionPart, second: SectionPart) -> Values:
    """By how much two parts are in each other's way at most, m."""
    missing: Values = -math.inf
    for one, other in product(first.boxes, second.boxes):
        missing = larger(missing, _overlap(one, other))
    return missing


def _overlap(one: Box, other: Box) -> Values:
    """How far two rings reach into each other, the shorter way; ≤ 0 where they do not, or one has no extent."""
    along = smaller(one.right - other.left, other.right - one.left)
    across = smaller(one.outer - other.inner, other.outer - one.inner)
    there = smaller(along, across)
    for box in (one, other):
        for extent in (box.right - box.left, box.outer - box.inner):
            there = _where(extent > 0, there)
    return there


def _where(condition: Any, value: Values) -> Values:
    return chosen(condition, lambda: value, lambda: 0.0 * value)


def length_of(parts: list[SectionPart]) -> Values:
    """Length along the axis, m: of the housing, which covers everything."""
    return parts[0].boxes[1].right


def inertia_of(parts: list[SectionPart], half: Half) -> Values:
    """Moment of inertia of one half, kg·m²."""
    return sum(body.inertia for part in parts for body in part.bodies if body.half == half)
