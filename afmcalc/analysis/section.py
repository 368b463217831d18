"""The clutch as it is drawn: its parts at rest and at f_max, main dimensions, part list, and what had to be assumed.

Where a part lies is the layout's answer. A clutch whose spec leaves open what a layout needs is completed first, and
every key that is filled in is told: what is drawn is the layout of the spec with these keys.
"""

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any, Literal, NamedTuple

from ..engines.layout import (
    FACE_GAP,
    TOUCHES,
    PartName,
    Ring,
    Sizes,
    SpringSize,
    overlaps,
    parts_of,
    sizes_of,
)
from ..engines.protocol import Clutch
from ..messages import term
from ..spec.edit import value_at, with_values
from ..spec.models import DiscStack, Envelope, Room, Spec
from .layout import LayoutPart, rows_of
from .synthesize import synthesize
from .wall import wall_of


class Measure(NamedTuple):
    """A main dimension: a length along the axis, or a diameter, m."""

    key: str
    symbol: str
    about: str
    kind: Literal["length", "diameter"]
    ends: tuple[float, float]
    """Places along the axis; of a diameter the radius below and above the axis."""
    at: float
    """Radius that a length is measured at, place along the axis of a diameter."""
    assumed: bool
    """Whether it rests on a key that was filled in."""

    @property
    def value(self) -> float:
        """The dimension, m."""
        return self.ends[1] - self.ends[0]


class Box(NamedTuple):
    """Half of the section through a ring, m."""

    left: float
    right: float
    inner: float
    outer: float

    def common(self, other: "Box") -> "Box | None":
        """Return what it has in common with another one, if it is more than rounding makes."""
        left, inner = max(self.left, other.left), max(self.inner, other.inner)
        right, outer = min(self.right, other.right), min(self.outer, other.outer)
        return Box(left, right, inner, outer) if min(right - left, outer - inner) > TOUCHES else None


class DrawnPart(NamedTuple):
    """A part, and its row of the part list."""

    name: PartName
    number: int
    pieces: int
    row: LayoutPart
    assumed: bool
    """Whether its size rests on a key that was filled in."""
    boxes: list[Box]
    pockets: list[Box]
    """What the pockets take away where a ball is."""
    moved: list[Box]
    """Where it is at f_max; empty of what does not move."""
    turns: float
    """Turns of a spring, or packs of discs against each other; 0 of what is no spring."""
    single: bool
    """Whether it is a spring of one coil."""


class Overlap(NamedTuple):
    """Two parts that are in each other's way."""

    first: PartName
    second: PartName
    missing: float
    """By how much at most, m."""
    boxes: list[Box]


class ClutchSection(NamedTuple):
    """All there is to draw of a clutch, m."""

    name: str | None
    parts: list[DrawnPart]
    pairs: int
    bypass_pairs: int
    """Pairs that bypass the control unit; 0 of a clutch without one."""
    faces: tuple[float, float]
    """Inner and outer radius of the friction faces."""
    hub: float
    """Radius."""
    bore: float
    """Radius; 0: none."""
    travel: float
    measures: list[Measure]
    overlaps: list[Overlap]
    assumed: dict[str, float]
    """Key of the spec → what was filled in for the drawing, SI."""

    def part(self, name: PartName) -> DrawnPart | None:
        """Return the part of a name, if there is one."""
        return next((part for part in self.parts if part.name == name), None)

    @property
    def mass(self) -> float:
        """Mass of all parts whose mass is known, kg."""
        return sum(part.row.mass for part in self.parts)


def section(clutch: Clutch) -> ClutchSection:
    """Lay out a clutch for its drawing, whatever its spec leaves open."""
    clutch, sizes, assumed = _completed(clutch)
    spec, laid_out = clutch.spec, parts_of(sizes)
    rows = {row.part: row for row in rows_of(laid_out)}
    boxes = {part.name: [_box(ring) for ring in part.boxes if ring.extends] for part in laid_out if part.name in rows}
    ball = boxes.get("balls", [])
    parts: list[DrawnPart] = []
    for name, row in rows.items():
        pieces, turns, single = _pieces(spec, name)
        in_pockets = ball if any(part.pockets for part in laid_out if part.name == name) else []
        parts.append(
            DrawnPart(
                name=name,
                number=len(parts) + 1,
                pieces=pieces,
                row=row,
                assumed=_rests_on(assumed, *_KEYS.get(name, _BODY)),
                boxes=boxes[name],
                pockets=[hole for box in boxes[name] for other in in_pockets if (hole := box.common(other))],
                moved=_moved(clutch, name, boxes[name], float(sizes.travel)),
                turns=turns,
                single=single,
            )
        )
    return ClutchSection(
        name=spec.name,
        parts=parts,
        pairs=int(spec.friction_group.pairs),
        bypass_pairs=int(clutch.bypass_pairs) if spec.kind.controlled else 0,
        faces=(float(sizes.inner_radius), float(sizes.outer_radius)),
        hub=sizes.hub_radius,
        bore=sizes.bore_radius,
        travel=float(sizes.travel),
        measures=[*_measures(sizes, boxes, assumed)],
        overlaps=[
            Overlap(
                one,
                other,
                float(missing),
                [same for box in boxes[one] for beside in boxes[other] if (same := box.common(beside))],
            )
            for one, other, missing in overlaps(laid_out)
            if missing > TOUCHES
        ],
        assumed=assumed,
    )


def _box(ring: Ring) -> Box:
    return Box(float(ring.left), float(ring.right), float(ring.inner), float(ring.outer))


_BODY = ("friction_group", "envelope")
_SLEEVE = (*_BODY, "control_unit")
_KEYS: dict[PartName, tuple[str, ...]] = {
    "balls": ("control_unit",), "closing spring": ("closing_spring",), "control spring": ("control_spring",),
    "ball sleeve": _SLEEVE, "thrust sleeve": _SLEEVE, "stop ring": _SLEEVE, "thrust disc": _SLEEVE,
}  # fmt: skip
"""Blocks of the spec that the size of a part rests on."""


def _rests_on(assumed: dict[str, Any], *paths: str) -> bool:
    return any(f"{key}.".startswith(f"{path}.") for key in assumed for path in paths)


def _completed(clutch: Clutch) -> tuple[Clutch, Sizes, dict[str, float]]:
    """Return a clutch with all that a layout needs, its sizes, and the keys filled in, most in shares of R_cp."""
    radius, travels, assumed = float(clutch.mean_radius), clutch.spec.kind.travels, dict[str, float]()

    def fill(block: str, empty: Any = None, **values: float) -> Any:
        """Fill in the keys of a block that have no value, and return it."""
        nonlocal clutch
        if value_at(clutch.spec, block) is None:
            clutch = replace(clutch, spec=with_values(clutch.spec, {block: empty}))
        missing = {f"{block}.{name}": value for name, value in values.items()}
        missing = {path: value for path, value in missing.items() if value_at(clutch.spec, path) is None}
        assumed.update(missing)
        clutch = replace(clutch, spec=with_values(clutch.spec, missing))
        return value_at(clutch.spec, block)

    hub, clear = 0.6 * radius, math.inf
    if clutch.spec.control_unit is not None:
        unit = fill("control_unit", balls=6, ball_circle_radius=0.5 * radius, face_gap=FACE_GAP)
        if unit.ball_diameter is None:
            ball = synthesize(clutch)[0].ball_diameter if clutch.gain > 0 else 0.4 * unit.ball_circle_radius
            unit = fill("control_unit", ball_diameter=ball)
        clear = 2 * unit.ball_circle_radius - unit.ball_diameter
        hub = unit.hub_diameter or (min(hub, 0.9 * clear) if clear > 0 else hub)
    fill("friction_group", inner_radius=0.8 * radius, outer_radius=1.2 * radius)
    if clutch.spec.envelope is None:
        shaft = clutch.spec.shaft
        if shaft and hub < 1.05 * shaft.diameter:
            hub = (shaft.diameter + clear) / 2 if shaft.diameter < clear < math.inf else 1.2 * shaft.diameter
        given = {} if travels else {"hub_diameter": hub}
        given |= {} if shaft else {"bore": 0.6 * hub}
        thick = {"disc_thickness": 0.03 * radius, "plate_thickness": 0.08 * radius, "housing_wall": 0.06 * radius}
        fill("envelope", Envelope.model_construct().model_copy(update=dict.fromkeys(thick)), **given, **thick)
    sizes = sizes_of(clutch)
    around = {part.name: part.boxes for part in parts_of(sizes)}
    inside = {"closing": around["stop ring"][0] if travels else around["pressure disc"][-1]}
    inside |= {"control": around["thrust sleeve"][0]} if travels else {}
    for name, ring in inside.items():
        if getattr(sizes, name).length > 0:
            continue
        part: Any = clutch.spec.spring_parts.get(name)
        room = value_at(clutch.spec, f"{name}_spring.room") or Room()
        inside_of = max(float(ring.outer), float(sizes.circle + sizes.ball / 2) if name == "closing" else 0.0)
        inner, wide = 2 * inside_of + 0.04 * radius, 0.16 * radius
        if part is not None:  # coils on a circle that is not told
            wide = 2 * (part.coil_diameter + part.wire_diameter)
        if room.outer_diameter is not None:
            inner = min(inner, 0.9 * room.outer_diameter)
        inner = inner if room.inner_diameter is None else room.inner_diameter
        length = 0.25 * radius + 1.2 * float(sizes.travel)
        room = fill(f"{name}_spring.room", Room(), inner_diameter=inner, outer_diameter=inner + wide, length=length)
        if part is None:
            size = SpringSize(room.inner_diameter / 2, room.outer_diameter / 2, room.length)
        else:
            size = getattr(sizes_of(clutch), name)
        sizes = sizes._replace(closing=size) if name == "closing" else sizes._replace(control=size)
    return clutch, sizes, assumed


_SHARES: dict[PartName, tuple[float, float]] = {
    "thrust sleeve": (1, 1), "closing spring": (0, 1), "control spring": (1, 0),
}  # fmt: skip
"""Shares of the sleeve's travel that the left and the right end of a part move by."""


def _moved(clutch: Clutch, name: PartName, boxes: list[Box], travel: float) -> list[Box]:
    """Return where a part is at f_max; a ball stays in the sleeve that seats it, else goes half as far."""
    left, right = _SHARES.get(name, (0.0, 0.0))
    if name == "balls" and travel:
        left = right = 1 - 1 / wall_of(clutch, FACE_GAP).sleeves
    if not travel or not (left or right):
        return []
    return [box._replace(left=box.left + left * travel, right=box.right + right * travel) for box in boxes]


def _pieces(spec: Spec, name: PartName) -> tuple[int, float, bool]:
    """Return how many there are of a part; of a spring also its turns, or packs, and whether it is of one coil."""
    if name == "pack":
        return int(spec.friction_group.pairs), 0.0, False
    if name == "balls":
        return int((spec.control_unit and spec.control_unit.balls) or 0), 0.0, False
    spring, _, kind = name.partition(" ")
    part = spec.spring_parts.get(spring)
    if part is None:
        return 1, 4.0 if kind == "spring" else 0.0, kind == "spring"
    if isinstance(part, DiscStack):
        return part.parallel * part.series, part.series, False
    return part.count, part.turns, part.count == 1


def _measures(sizes: Sizes, boxes: dict[PartName, list[Box]], assumed: dict[str, float]) -> Iterator[Measure]:
    """Yield the main dimensions."""

    def along(key: str, symbol: str, about: str, ends: Any, at: Any, *paths: str) -> Measure:
        return Measure(
            key, symbol, about, "length", (float(ends[0]), float(ends[1])), float(at), _rests_on(assumed, *paths)
        )

    def across(key: str, symbol: str, about: str, radius: Any, at: Any, *paths: str) -> Measure:
        return Measure(
            key, symbol, about, "diameter", (-float(radius), float(radius)), float(at), _rests_on(assumed, *paths)
        )

    web, around = boxes["housing"]
    pack = boxes["pack"][0]
    inner, outer, end = "friction_group.inner_radius", "friction_group.outer_radius", float(around.right)
    yield along("length", "L", term("length"), (0, end), around.outer, "friction_group", "envelope", "control_unit",
                "closing_spring", "control_spring")  # fmt: skip
    named: tuple[tuple[PartName, str, str], ...] = (
        ("closing spring", "L_1", term("length of the closing spring as set")),
        ("control spring", "L_2", term("length of the control spring as set")),
    )
    for name, symbol, about in named:
        for box in boxes.get(name, []):
            yield along(f"{name.partition(' ')[0]}_length", symbol, about, box, box.outer, f"{name[:-7]}_spring")
    if "balls" in boxes:
        ball = boxes["balls"][0]
        middle, half = (ball.left + ball.right) / 2, sizes.gap / 2
        yield along("face_gap", "s", term("gap between the faces"), (middle - half, middle + half), ball.outer,
                    "control_unit.face_gap")  # fmt: skip
        yield across("ball_circle", "2r", term("ball circle"), sizes.circle, middle, "control_unit.ball_circle_radius")
    if sizes.travel:
        sleeve = max(boxes["thrust sleeve"], key=lambda box: box.outer)
        ends = sleeve.right, sleeve.right + sizes.travel
        yield along("travel", "x_max", term("travel of the sleeve at f_max"), ends, sleeve.outer)
    yield across("inner_diameter", "2r_i", term("inside of the friction faces"), sizes.inner_radius, pack.left, inner)
    yield across("outer_diameter", "2r_o", term("outside of the friction faces"), sizes.outer_radius, pack.right, outer)
    yield across(
        "housing", "D_h", term("outer diameter of the housing"), web.outer, web.left, outer, "envelope.housing_wall"
    )
    hub = "envelope.hub_diameter", "control_unit.hub_diameter"
    yield across("hub", "d", term("diameter of the hub"), sizes.hub_radius, end, *hub)
    if sizes.bore_radius:
        yield across("bore", "", term("bore of the hub"), sizes.bore_radius, end, "envelope.bore")
