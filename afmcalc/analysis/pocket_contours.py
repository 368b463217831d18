"""Contours for the shop: two sleeves with pockets in the section at the ball circle.

A pocket is cut to the lowest point of the ball; a groove between the ends of its walls keeps the ball off the floor.
Coordinates: from the centre of the ball at the stop, along the axis into the first sleeve, and around the circle. If
the wall is curved, the first sleeve has it and the second seats the ball; else both sleeves have the same wall.
"""

import math
from typing import NamedTuple, TypeAlias

from ..engines import Clutch
from ..engines.rings import parts_of, sizes_of
from ..errors import CalculationError
from ..spec import Spec
from .pocket_wall import Wall, wall_of
from .synthesize import SynthesisResult

Points: TypeAlias = list[tuple[float, float]]
"""Points of a contour: coordinates along the axis and around the circle, m."""

BESIDE = 0.5
"""Width of sleeve drawn beside a pocket, over half the pocket width; default depth behind it, over the pocket depth."""
RELIEF, RELIEF_STEP = 0.05, 1e-4
"""Depth of the groove under a ball, relative to the ball diameter; step to which this depth is rounded up, m."""


class Contour(NamedTuple):
    """One line of the drawing."""

    layer: str
    points: Points
    closed: bool = True


class SleeveSizes(NamedTuple):
    """Sizes that both sleeves share, m."""

    outer_diameter: float
    bore: float
    depth: float
    """Length B along the axis, m."""
    pocket_end: float
    """Radius at which a pocket ends towards the axis; outwards the pocket is open."""
    relief: float
    """Depth of the groove below the lowest point of the ball."""
    groove: float
    """Width of the groove around the circle."""
    assumed: frozenset[str]
    """Names of the sizes that the spec does not give."""


class ShopDrawing(NamedTuple):
    """Shop drawing: the pockets of one ball with the sleeves at their stop, and the sizes of the sleeves."""

    name: str
    spec: Spec
    sleeve: SleeveSizes
    masses: tuple[float, ...]
    """Masses of the parts with pockets, kg; empty without a layout."""
    contours: list[Contour]
    extent: tuple[float, float]
    """Distances from the ball's centre to the drawn ends of the sleeves, m: along the axis, and around the circle."""
    synthesis: SynthesisResult


def shop_drawing(clutch: Clutch, unit: SynthesisResult) -> ShopDrawing:
    """Lay out the pockets of a control unit that ``synthesize.pocket`` has designed.

    Raises CalculationError if the wall cannot be cut, or if pockets cut into each other or through a sleeve.
    """
    wall = wall_of(clutch, unit.face_gap, unit.ball_diameter / 2)
    if not wall.can_be_cut:
        raise CalculationError(
            "no pocket to draw: a ball of {ball:.5g mm} undercuts its curved wall, as does every one from "
            "{limit:.5g mm} on (afmcalc pocket says what makes it possible)",
            ball=unit.ball_diameter,
            limit=2 * wall.undercut_radius,
        )
    if unit.web is not None and unit.web <= 0:
        raise CalculationError("no pocket to draw: the pockets cut into each other")
    sleeve = _sleeve_of(clutch.spec, unit, wall)
    path = [(-place.path_axial, place.path_around) for place in wall.points()]
    first = _pocket(wall, unit.pocket_depth_cut, sleeve.relief)
    second = _mirrored(_pocket(wall._replace(steepening=0.0), unit.pocket_depth_cut, sleeve.relief))
    extent = unit.face_gap / 2 + sleeve.depth, (1 + BESIDE) * max(abs(around) for _, around in (*first, *second))
    parts = [] if clutch.spec.envelope is None else parts_of(sizes_of(clutch))
    return ShopDrawing(
        name=clutch.spec.name or clutch.spec.variant,
        spec=clutch.spec,
        sleeve=sleeve,
        masses=tuple(float(sum(body.mass for body in part.bodies)) for part in parts if part.pockets),
        contours=[
            Contour("SLEEVE_1", _sleeve(first, extent)),
            Contour("SLEEVE_2", _mirrored(_sleeve(_mirrored(second), extent))),
            Contour("POCKET_1", first),
            Contour("POCKET_2", second),
            Contour("PATH", path, closed=False),
        ],
        extent=extent,
        synthesis=unit,
    )


def _sleeve_of(spec: Spec, unit: SynthesisResult, wall: Wall) -> SleeveSizes:
    """Return the sizes of the sleeves: as given, else as in the layout, else in proportion to the ball."""
    given, room = spec.control_unit, spec.envelope
    assert given is not None
    circle, ball, cut, assumed = unit.ball_circle_radius, unit.ball_diameter, unit.pocket_depth_cut, {"outer_diameter"}
    relief = math.ceil(RELIEF * ball / RELIEF_STEP - 1e-9) * RELIEF_STEP
    bore, depth = given.hub_diameter, given.sleeve_depth
    if bore is None and room is not None:
        bore = room.hub_diameter
    if bore is None:
        bore, assumed = 2 * max(circle - ball, 0.3 * circle), assumed | {"bore"}
    if depth is None and room is not None:
        depth = cut + room.plate_thickness
    elif depth is None:
        depth, assumed = (1 + BESIDE) * cut + relief, assumed | {"depth"}
    if depth <= cut + relief:
        raise CalculationError(
            "no pocket to draw: {cut:.5g mm} deep, and {relief:.5g mm} under the ball, it goes through a sleeve of "
            "{depth:.5g mm}",
            cut=cut,
            relief=relief,
            depth=depth,
        )
    return SleeveSizes(
        outer_diameter=2 * circle + ball,
        bore=bore,
        depth=depth,
        pocket_end=max(circle - ball / 2 - relief, bore / 2),
        relief=relief,
        groove=2 * _floor_half(wall, cut),
        assumed=frozenset(assumed),
    )


def _floor_half(wall: Wall, depth: float) -> float:
    """Half the width of a pocket at the depth of the ball's lowest point, where the walls end, m."""
    start = wall.at(0.0)
    return start.wall_around - (depth + wall.face_gap / 2 + start.wall_axial) * wall.tangent


def _pocket(wall: Wall, depth: float, relief: float) -> Points:
    """Contour of a pocket: one wall down to the floor, the groove, the other wall back; both ends lie at the face."""
    floor, half = depth + wall.face_gap / 2, _floor_half(wall, depth)
    above = [(-place.wall_axial, place.wall_around) for place in wall.points()]
    upper = [(floor + relief, half), (floor, half), *above]
    # both halves have the same point on the axis: keep it once
    return [(along, -around) for along, around in reversed(upper)] + upper[abs(half) < 1e-12 :]


def _mirrored(points: Points) -> Points:
    """Contour rotated by 180°, as it lies in the opposite sleeve."""
    return [(-along, -around) for along, around in points]


def _sleeve(pocket: Points, extent: tuple[float, ...]) -> Points:
    """Contour of a sleeve with its pocket, drawn to ``extent``: distances along the axis and around the circle."""
    (back, side), face = extent, pocket[0][0]
    return [(back, -side), (face, -side), *pocket, (face, side), (back, side)]
