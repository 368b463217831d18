"""Layout of a clutch: its parts in half section, as rings along the axis; numbers or arrays.

The parts are arranged as in the papers: F11 fig. 1 and S19 fig. 1 if the clutch is direct, S21 fig. 1 if indirect.
The web of the housing is at 0. Clearances, thrust bearings, feather keys, splines and bolts are not included, so the
space is the smallest possible. Springs without a part in the spec, and balls without a diameter, are left out.
"""

import math
from collections.abc import Iterator
from functools import reduce
from itertools import combinations, product
from typing import Any, Literal, NamedTuple, TypeAlias

from ..equations import control_unit, drive, effects, springs
from ..equations.arrays import Values, larger, smaller
from ..spec.models import DiscStack, Room, Spec, bore_of
from .characteristics import STEEL, characteristic
from .selection import Clutch

FACE_GAP = 0.002
"""Default of the gap s between the faces of the pockets, m (S21: 2…3 mm)."""
TOUCHES = 1e-9
"""Largest overlap that counts as touching, m: a rounding error."""

PartName = Literal[
    "housing", "hub", "pack", "pressure disc", "thrust disc", "ball sleeve", "thrust sleeve", "stop ring", "balls",
    "closing spring", "control spring",
]  # fmt: skip
Half = Literal["driving", "hub", "driven"]
"""Half of the clutch with which a part turns: ``driving``, ``hub`` (from discs to balls, if indirect) or ``driven``."""


class Ring(NamedTuple):
    """Ring of rectangular section, m; empty where right ≤ left or outer ≤ inner."""

    left: Values
    right: Values
    inner: Values
    outer: Values
    half: Half = "driven"
    given_mass: Values | None = None
    """Mass, kg; None: the ring is of solid steel."""

    @property
    def extends(self) -> Any:
        """True if the ring is not empty."""
        return (self.right > self.left) & (self.outer > self.inner)

    @property
    def mass(self) -> Values:
        """Mass, kg."""
        if self.given_mass is not None:
            return self.given_mass
        length = (self.right - self.left) * self.extends
        return springs.ring_mass(STEEL, 2 * self.outer, 2 * self.inner, length, math.pi)

    @property
    def inertia(self) -> Values:
        """Moment of inertia about the axis, kg·m²."""
        return drive.ring_inertia(self.mass, 2 * self.outer, 2 * self.inner)

    def overlap(self, other: "Ring") -> Values:
        """Overlap with another ring, axial or radial, whichever is smaller, m; ≤ 0 if the rings do not overlap."""
        along = smaller(self.right - other.left, other.right - self.left)
        across = smaller(self.outer - other.inner, other.outer - self.inner)
        return smaller(along, across) * (self.extends & other.extends)


class SectionPart(NamedTuple):
    """One part of the clutch in half section."""

    name: PartName
    boxes: tuple[Ring, ...]
    turning: tuple[Ring, ...] = ()
    """Rings that have the mass of the part; if empty, the ``boxes`` have the mass."""
    pockets: bool = False
    """True if the part has the pockets of the balls."""

    @property
    def bodies(self) -> tuple[Ring, ...]:
        """Rings that have the mass of the part; each ring turns with one half of the clutch."""
        return self.turning or self.boxes


class SpringSize(NamedTuple):
    """Inner and outer radius and length of a spring as set, m, and its mass, kg; all 0 if its part is not known."""

    inner: Values = 0.0
    outer: Values = 0.0
    length: Values = 0.0
    mass: Values = 0.0


class Sizes(NamedTuple):
    """Dimensions of the layout, m."""

    travels: bool
    pairs: Values
    inner_radius: Values
    outer_radius: Values
    bore_radius: float
    hub_radius: float
    disc: float
    plate: float
    wall: float
    ball: Values = 0.0
    """Diameter of a ball; 0 for a clutch without balls."""
    balls: int = 0
    circle: Values = 0.0
    gap: float = FACE_GAP
    depth: float | None = None
    """Thickness of the sleeves with pockets; None: the depth of a pocket plus ``plate``."""
    travel: Values = 0.0
    closing: SpringSize = SpringSize()
    control: SpringSize = SpringSize()

    @property
    def reach(self) -> Values:
        """Outermost radius of the balls."""
        return self.circle + self.ball / 2

    @property
    def behind(self) -> Values:
        """Axial position of the right face of the pressure disc."""
        return 3 * self.plate + self.pairs * self.disc

    @property
    def depth_there(self) -> Values:
        """Thickness of a sleeve with pockets; 0 for a clutch without balls."""
        cut = self.depth
        if cut is None:
            cut = control_unit.pocket_depth_cut(self.ball / 2, self.gap) + self.plate
        there: Any = self.ball > 0
        return cut * there

    @property
    def rim(self) -> Values:
        """Outer radius of the sleeves: up to the balls, at most the pack's bore less ``wall``, at least the hub's."""
        return larger(smaller(self.reach, self.inner_radius - self.wall) * (self.ball > 0), self.hub_radius)


def rooms_of(clutch: Clutch) -> dict[str, Room]:
    """Return name → room left for each spring as set, between the housing and hub, sleeve or stop."""
    size: Any = sizes_of(clutch)
    envelope = clutch.spec.envelope
    left = math.inf if envelope is None or envelope.length is None else envelope.length - size.behind - size.plate
    if not size.travels:
        boss = size.plate + max(size.depth_there, size.plate) + size.gap + size.depth_there > size.behind
        return {"closing": _room(size, size.rim if size.ball and boss else size.hub_radius, left)}
    control_at = size.behind + size.closing.length + size.plate
    boss = 2 * size.plate + 2 * size.depth_there + size.gap > control_at
    return {
        "closing": _room(
            size,
            size.reach + size.wall if size.ball else size.hub_radius,
            left - size.plate - max(size.control.length, size.travel),
        ),
        "control": _room(size, size.rim if boss else size.hub_radius, left - size.plate - size.closing.length),
    }


def _room(size: Sizes, inner: Any, length: Any) -> Room:
    return Room.model_construct(
        inner_diameter=2 * inner,
        outer_diameter=2 * float(size.outer_radius),
        length=max(length, TOUCHES) if length < math.inf else None,
    )


def sizes_of(clutch: Clutch) -> Sizes:
    """Return the dimensions of a clutch whose spec has an envelope, including the travel of the sleeve."""
    spec: Any = clutch.spec
    room, group, unit, travels = spec.envelope, spec.friction_group, spec.control_unit, spec.kind.travels
    hub = room.hub_diameter if unit is None or unit.hub_diameter is None else unit.hub_diameter
    size = Sizes(
        travels, group.pairs, group.inner_radius, group.outer_radius, bore_of(spec) / 2, hub / 2,
        room.disc_thickness, room.plate_thickness, room.housing_wall,
        travel=clutch["travel_max"] if travels else 0.0,
        closing=_spring(spec, "closing", clutch["closing_force"]),
        control=_spring(spec, "control", clutch["control_force"]) if travels else SpringSize(),
    )  # fmt: skip
    if unit is None or unit.ball_diameter is None or unit.ball_circle_radius is None:
        return size
    gap = FACE_GAP if unit.face_gap is None else unit.face_gap
    return size._replace(
        ball=unit.ball_diameter, balls=0 if unit.balls is None else unit.balls, circle=unit.ball_circle_radius, gap=gap,
        depth=unit.sleeve_depth,
    )  # fmt: skip


def _spring(spec: Spec, name: str, force: Values) -> SpringSize:
    """Return the size of a spring as set; all 0 if its part, or the circle of several coil springs, is not known."""
    if (part := spec.spring_parts.get(name)) is None:
        return SpringSize()
    room = getattr(spec, f"{name}_spring").room or Room()
    if isinstance(part, DiscStack):
        inner, outer = part.inner_diameter / 2, part.outer_diameter / 2
    elif part.count == 1:
        inner, outer = (part.coil_diameter - part.wire_diameter) / 2, (part.coil_diameter + part.wire_diameter) / 2
    elif room.inner_diameter is not None and room.outer_diameter is not None:
        circle, half = (room.inner_diameter + room.outer_diameter) / 4, (part.coil_diameter + part.wire_diameter) / 2
        inner, outer = circle - half, circle + half
    else:
        return SpringSize()
    own = characteristic(part)
    return SpringSize(inner, outer, own.free_length - own.deflection(force), own.mass)


def parts_of(size: Sizes) -> list[SectionPart]:
    """Return the parts of a clutch laid out from the web of the housing; rings that are absent are empty."""
    hub, plate, gap, closing, control = size.hub_radius, size.plate, size.gap, size.closing, size.control
    carrier, faces = size.inner_radius - size.wall, size.outer_radius
    pack, plate_at, behind = 2 * plate, size.behind - plate, size.behind
    there: Any = size.ball > 0
    reach, depth, rim = size.reach, size.depth_there, size.rim
    half: Half = "hub" if size.travels else "driven"
    flange = (plate, pack, hub, faces)
    if size.travels:
        thrust = behind + closing.length
        control_at, seat = thrust + plate, larger(control.outer, rim)
        face = larger(pack + depth, control_at - depth - gap)
        end = larger(face + gap + depth, control_at)
        nut = larger(control_at + larger(control.length, size.travel), end + size.travel)
        collar = (thrust, control_at, rim, smaller(larger(closing.outer, seat), faces))
        sleeves = [
            _part("pressure disc", half, (plate_at, behind, carrier, faces)),
            _part("ball sleeve", half, (pack, face, hub, rim), pockets=True),
            _part("thrust sleeve", "driven", (face + gap, end, hub, rim), collar, pockets=True),
            _part("stop ring", "driven", (behind, thrust, reach, reach + size.wall * there)),
        ]
    else:
        control_at, seat = behind, larger(closing.outer, hub)
        face = plate + larger(depth, plate)
        end = larger(behind, (face + gap + depth) * there)
        nut = larger(end, behind + closing.length)
        bosses = (face + gap, plate_at, hub, rim), (behind, end, hub, rim)
        sleeves = [
            _part("thrust disc", half, flange, (pack, face, hub, rim), pockets=True),
            _part("pressure disc", half, (plate_at, behind, hub, faces), *bosses, pockets=True),
        ]
    total, wall, middle = nut + plate, faces + size.wall, face + gap / 2
    # outer and inner discs alternate; the disc next to the pressure disc is an outer disc
    outer_discs = pack + (size.pairs + size.pairs % 2) / 2 * size.disc
    discs = (
        Ring(pack, outer_discs, size.inner_radius, faces, "driving"),
        Ring(outer_discs, plate_at, size.inner_radius, faces, half),
        Ring(pack, plate_at, carrier, size.inner_radius, half),
    )
    ball = middle - size.ball / 2, middle + size.ball / 2, larger(size.circle - size.ball / 2, 0.0), reach
    all_balls = size.balls * effects.ball_mass(STEEL, size.ball / 2, math.pi)
    set_springs = [
        _part("closing spring", "driven", (behind, behind + closing.length, *closing[:2]), mass=closing.mass),
        _part("control spring", "driven", (control_at, control_at + control.length, *control[:2]), mass=control.mass),
    ]
    return [
        _part("housing", "driving", (0.0, plate, size.bore_radius, wall), (plate, total, faces, wall)),
        _part(
            "hub", "driven", (plate, total, size.bore_radius, hub), *[flange] * size.travels,
            (nut, total, hub, smaller(seat, faces)),
        ),
        SectionPart("pack", (Ring(pack, plate_at, carrier, faces),), discs),
        *sleeves,
        _part("balls", "driven", ball, mass=all_balls),
        *set_springs[: 1 + size.travels],
    ]  # fmt: skip


_Sides: TypeAlias = tuple[Values, Values, Values, Values]


def _part(name: PartName, half: Half, *rings: _Sides, mass: Values | None = None, pockets: bool = False) -> SectionPart:
    return SectionPart(name, tuple(Ring(*sides, half, mass) for sides in rings), pockets=pockets)


def overlaps(parts: list[SectionPart]) -> Iterator[tuple[PartName, PartName, Values]]:
    """Yield the names of every two parts and their largest overlap, m; ≤ 0 if they do not collide.

    A part that extends beyond the housing collides with the housing, a part inside the bore of the hub with the hub.
    """
    for first, second in combinations(parts, 2):
        if not (first.pockets and second.name == "balls"):
            missing = reduce(larger, (one.overlap(other) for one, other in product(first.boxes, second.boxes)))
            if first.name in ("housing", "hub"):
                missing = reduce(larger, (_outside(first, ring) for ring in second.boxes), missing)
            yield first.name, second.name, missing


def _outside(around: SectionPart, ring: Ring) -> Values:
    """Length by which a ring extends beyond the housing, or into the bore of the hub, m; ≤ 0 if it does not."""
    if around.name == "hub":
        return (around.boxes[0].inner - ring.inner) * ring.extends
    web, drum = around.boxes
    return larger(ring.outer - web.outer, ring.right - drum.right, web.left - ring.left) * ring.extends


def length_of(parts: list[SectionPart]) -> Values:
    """Length of the clutch along the axis, m: the length of the housing, which encloses everything."""
    return parts[0].boxes[1].right


def inertia_of(parts: list[SectionPart], half: Half) -> Values:
    """Moment of inertia of the parts of one half, kg·m²."""
    return sum(body.inertia for part in parts for body in part.bodies if body.half == half)
