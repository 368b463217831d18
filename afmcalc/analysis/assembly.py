"""Data of the drawing of the whole clutch: parts at rest and at f_max, main dimensions, part list, assumed sizes.

Parts lie where the layout places them. Keys of the spec that the layout needs and that have no value get defaults,
which are listed as assumed.
"""

from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

from ..engines import Clutch, build
from ..engines.rings import FACE_GAP, TOUCHES, PartName, Sizes, SpringSize, overlaps, parts_of, sizes_of
from ..errors import CalculationError
from ..messages import translate
from ..spec.edit import value_at, with_values
from ..spec.models import DiscStack, Envelope, Room, Spec
from .asking import Answers
from .half_section import LayoutPart, rows_of
from .pocket_wall import wall_of
from .registry import ANALYSES
from .synthesize import pocket


class MainDimension(NamedTuple):
    """A main dimension, m."""

    key: str
    symbol: str
    about: str
    low: float
    """Start of a length along the axis, m; of a diameter the negative radius, m."""
    high: float
    at: float
    """Place of the dimension line, m: for a length its radius, for a diameter its place along the axis."""
    assumed: bool
    """True if the dimension depends on a key that was filled in."""


class Box(NamedTuple):
    """Half of the section through a ring, m: its ends along the axis, and its inner and outer radius."""

    left: float
    right: float
    inner: float
    outer: float

    def common(self, others: Iterable["Box"]) -> Iterator["Box"]:
        """Yield the overlaps with other boxes, except overlaps that are rounding errors."""
        for other in others:
            left, inner = max(self.left, other.left), max(self.inner, other.inner)
            right, outer = min(self.right, other.right), min(self.outer, other.outer)
            if min(right - left, outer - inner) > TOUCHES:
                yield Box(left, right, inner, outer)


class DrawnPart(NamedTuple):
    """A part of the clutch as drawn, and its row of the part list."""

    name: PartName
    number: int
    row: LayoutPart
    boxes: list[Box]
    pockets: list[Box]
    """Areas where a ball overlaps the part: there the pocket is cut out of the part."""
    moved: list[Box]
    """Boxes of the part at f_max; empty if the part does not move."""
    assumed: bool
    """True if the size of the part depends on a key that was filled in."""
    pieces: int
    turns: float
    """Number of turns of a coil spring, or of packs of disc springs in series; 0 if the part is no spring."""


class ClutchSection(NamedTuple):
    """Data of the drawing of a clutch, m."""

    name: str | None
    parts: dict[PartName, DrawnPart]
    bypass_pairs: int
    """Number of friction pairs that bypass the control unit; 0 without a control unit."""
    travel: float
    measures: dict[str, MainDimension]
    overlaps: list[tuple[PartName, PartName, float]]
    """Two parts that collide in the layout, and their largest overlap, m."""
    assumed: dict[str, float]
    """Key of the spec → value filled in for the drawing, SI."""


_MOST = 500
"""Largest number of friction pairs, and of balls, that is drawn."""


def section(answers: Answers) -> ClutchSection:
    """Lay out a clutch for its drawing, with defaults for the keys that its spec leaves open.

    Raises CalculationError for more pairs or balls than a drawing shows, or a bore as wide as the housing.
    """
    for key in ("friction_group.pairs", "control_unit.balls"):
        if (value_at(answers.clutch.spec, key) or 0) > _MOST:
            raise CalculationError(
                "plot section: {key} is more than {most}, the most that are drawn", key=key, most=_MOST
            )
    clutch, sizes, assumed = _completed(answers)
    spec, laid_out, travel = clutch.spec, parts_of(sizes), float(sizes.travel)
    boxes = {part.name: [Box(*map(float, ring[:4])) for ring in part.boxes if ring.extends] for part in laid_out}
    if len(boxes["housing"]) < 2:
        size = sizes.outer_radius + sizes.wall
        raise CalculationError(
            "plot section: the bore, {bore:.4g mm} wide, is no narrower than the housing, {housing:.4g mm}",
            bore=2 * sizes.bore_radius,
            housing=2 * float(size),
        )
    balls = {part.name: boxes["balls"] if part.pockets else [] for part in laid_out}
    parts = {
        row.part: DrawnPart(
            row.part, number, row, boxes[row.part],
            [hole for box in boxes[row.part] for hole in box.common(balls[row.part])],
            [*_moved(clutch, row.part, boxes[row.part], travel)] if travel else [],
            _rests_on(assumed, *_KEYS.get(row.part, _BODY)),
            *_pieces(spec, row.part),
        )
        for number, row in enumerate(rows_of(laid_out), 1)
    }  # fmt: skip
    # the collisions that ``layout`` reports; none without [envelope], as thicknesses are then assumed
    given = [] if answers.clutch.spec.envelope is None else overlaps(parts_of(sizes_of(answers.clutch)))
    return ClutchSection(
        spec.name, parts, int(clutch.bypass_pairs) if spec.kind.controlled else 0, travel,
        {each.key: each for each in _measures(sizes, boxes, assumed)},
        [(one, other, float(missing)) for one, other, missing in given if missing > TOUCHES], assumed,
    )  # fmt: skip


_BODY = ("friction_group", "envelope")
_SLEEVE = (*_BODY, "control_unit")
_KEYS: dict[PartName, tuple[str, ...]] = {
    "balls": ("control_unit",), "closing spring": ("closing_spring",), "control spring": ("control_spring",),
    "ball sleeve": _SLEEVE, "thrust sleeve": _SLEEVE, "stop ring": _SLEEVE, "thrust disc": _SLEEVE,
}  # fmt: skip
"""Part → blocks of the spec that determine its size; the size of all other parts is determined by ``_BODY``."""


def _rests_on(assumed: dict[str, float], *paths: str) -> bool:
    return any(f"{key}.".startswith(f"{path}.") for key in assumed for path in paths)


def _completed(answers: Answers) -> tuple[Clutch, Sizes, dict[str, float]]:
    """Return a clutch with all keys for a layout, its sizes, and path → value of the keys filled in.

    The values filled in are mostly shares of the mean friction radius.
    """
    clutch = answers.clutch
    radius, travels, assumed = float(clutch.mean_radius), clutch.spec.kind.travels, dict[str, float]()

    def fill(block: str, empty: Any = None, **values: float) -> Any:
        """Return a block of the spec, its missing keys filled in; a missing block is first set to ``empty``."""
        nonlocal clutch
        spec = clutch.spec
        if value_at(spec, block) is None:
            spec = with_values(spec, {block: empty})
        missing = {f"{block}.{name}": value for name, value in values.items()}
        missing = {path: value for path, value in missing.items() if value_at(spec, path) is None}
        assumed.update(missing)
        clutch = build(with_values(spec, missing))
        return value_at(clutch.spec, block)

    shaft = clutch.spec.shaft.diameter if clutch.spec.shaft else 0.0
    hub, reach = max(0.6 * radius, 1.4 * shaft), 0.0
    if clutch.spec.control_unit is not None:
        unit = fill("control_unit", balls=6, ball_circle_radius=0.5 * radius, face_gap=FACE_GAP)
        circle, ball = unit.ball_circle_radius, unit.ball_diameter
        if ball is None:
            if clutch.gain > 0:  # by synthesis, also if the ball circle was filled in
                asked = ANALYSES["pocket"].applies(answers.clutch)
                ball = (answers.ask("pocket") if asked else pocket(clutch))[0].ball_diameter
            else:
                ball = 0.4 * circle
            fill("control_unit", ball_diameter=ball)
        reach = circle + ball / 2
        hub = unit.hub_diameter or max(min(hub, 0.9 * (2 * circle - ball)), 0.2 * radius, 1.05 * shaft)
    fill("friction_group", inner_radius=0.8 * radius, outer_radius=1.2 * radius)
    if clutch.spec.envelope is None:
        thick = {"disc_thickness": 0.03 * radius, "plate_thickness": 0.08 * radius, "housing_wall": 0.06 * radius}
        round_ = ({} if shaft else {"bore": 0.6 * hub}) | ({} if travels else {"hub_diameter": hub})
        fill("envelope", Envelope.model_construct().model_copy(update=dict.fromkeys(thick)), **round_, **thick)
    sizes = sizes_of(clutch)
    for name in ("closing", "control")[: 1 + travels]:
        if getattr(sizes, name).length > 0:
            continue
        part: Any = clutch.spec.spring_parts.get(name)  # coil springs whose circle the spec does not give, or None
        inner = 2 * (max(reach, sizes.hub_radius) + sizes.wall) + 0.04 * radius
        outer = inner + (0.16 * radius if part is None else 2 * (part.coil_diameter + part.wire_diameter))
        room = fill(
            f"{name}_spring.room", Room(), outer_diameter=outer, length=0.25 * radius + 1.2 * float(sizes.travel)
        )
        room = fill(f"{name}_spring.room", inner_diameter=min(inner, 0.98 * room.outer_diameter))
        own = SpringSize(room.inner_diameter / 2, room.outer_diameter / 2, room.length)
        own = own if part is None else getattr(sizes_of(clutch), name)
        sizes = sizes._replace(closing=own) if name == "closing" else sizes._replace(control=own)
    return clutch, sizes, assumed


_SHARES: dict[PartName, tuple[float, float]] = {
    "thrust sleeve": (1, 1), "closing spring": (0, 1), "control spring": (1, 0),
}  # fmt: skip
"""Part → shares of the sleeve's travel by which its left and its right end move."""


def _moved(clutch: Clutch, name: PartName, boxes: list[Box], travel: float) -> Iterator[Box]:
    """Yield the boxes of a part at f_max if it moves; a ball moves by half the sleeve's travel, or stays seated."""
    left, right = _SHARES.get(name, (0.0, 0.0))
    if name == "balls":
        left = right = 1 - 1 / wall_of(clutch, FACE_GAP).sleeves
    if left or right:
        yield from (box._replace(left=box.left + left * travel, right=box.right + right * travel) for box in boxes)


def _pieces(spec: Spec, name: PartName) -> tuple[int, float]:
    """Return number of pieces of a part, and number of coil-spring turns or disc-spring packs, 0 for other parts."""
    spring, _, kind = name.partition(" ")
    part = spec.spring_parts.get(spring)
    if part is not None:
        return (part.parallel * part.series, part.series) if isinstance(part, DiscStack) else (part.count, part.turns)
    counts = {"pack": spec.friction_group.pairs, "balls": value_at(spec, "control_unit.balls")}
    return int(counts.get(name, 1)), 4.0 if kind == "spring" else 0.0


def _measures(sizes: Sizes, boxes: dict[PartName, list[Box]], assumed: dict[str, float]) -> Iterator[MainDimension]:
    """Yield the main dimensions of the parts that the clutch has."""

    def measure(key: str, symbol: str, about: str, low: Any, high: Any, at: float, *paths: str) -> MainDimension:
        return MainDimension(key, symbol, about, float(low), float(high), at, _rests_on(assumed, *paths))

    (web, around), pack, inner, outer = boxes["housing"], boxes["pack"][0], sizes.inner_radius, sizes.outer_radius
    faces, hub, bore, end = "friction_group", sizes.hub_radius, sizes.bore_radius, around.right
    yield measure("length", "L", translate("length"), 0, end, web.outer, *{path.partition(".")[0] for path in assumed})
    for box in boxes["closing spring"]:
        about = translate("length of the closing spring as set")
        yield measure("closing_length", "L_1", about, box.left, box.right, box.outer, "closing_spring")
    for box in boxes.get("control spring", []):
        about = translate("length of the control spring as set")
        yield measure("control_length", "L_2", about, box.left, box.right, box.outer, "control_spring")
    for box in boxes["balls"]:
        middle, half, unit = (box.left + box.right) / 2, sizes.gap / 2, "control_unit"
        about = translate("gap between the faces")
        yield measure("face_gap", "s", about, middle - half, middle + half, box.outer, f"{unit}.face_gap")
        about = translate("ball circle")
        yield measure("ball_circle", "2r", about, -sizes.circle, sizes.circle, middle, f"{unit}.ball_circle_radius")
    for box in sorted(boxes.get("thrust sleeve", []), key=lambda box: box.outer)[-1:] if sizes.travel else ():
        about = translate("travel of the sleeve at f_max")
        yield measure("travel", "x_max", about, box.right, box.right + sizes.travel, box.outer)
    yield measure("inner_diameter", "2r_i", translate("inside of the friction faces"), -inner, inner, pack.left, faces)
    yield measure(
        "outer_diameter", "2r_o", translate("outside of the friction faces"), -outer, outer, pack.right, faces
    )
    about = translate("outer diameter of the housing")
    yield measure("housing", "D_h", about, -web.outer, web.outer, web.left, faces, "envelope.housing_wall")
    yield measure("hub", "d", translate("diameter of the hub"), -hub, hub, end, "envelope.hub_diameter")
    if bore:
        yield measure("bore", "", translate("bore of the hub"), -bore, bore, end, "envelope.bore")
