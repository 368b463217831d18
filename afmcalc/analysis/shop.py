"""What the shop cuts: two sleeves with pockets as contours in the section at the ball circle, and a cutter's way.

A pocket is cut to the lowest point of the ball; a groove between the ends of its walls keeps the ball off the floor.
Coordinates: from the centre of the ball at the stop, along the axis into the first sleeve, and around the circle. The
first sleeve has the curved wall, if there is one; the second seats the ball, or has the same.
"""

import math
from typing import NamedTuple, TypeAlias

from ..engines.layout import parts_of, sizes_of
from ..engines.protocol import Clutch
from ..errors import CalculationError
from ..messages import say
from ..spec import Spec
from .synthesize import SynthesisResult
from .wall import Wall, WallPoint, wall_of

Points: TypeAlias = list[tuple[float, float]]
"""(along the axis, around the circle), m."""

BESIDE = 0.5
"""What is drawn of a sleeve beside its pocket, of half its width; behind it of its depth, where nothing is said."""
CUTTER = 0.8
"""Diameter of the cutter unless told, of the ball's: one as large would leave a wall that the ball lies close in."""
RELIEF, RELIEF_STEP = 0.05, 1e-4
"""Depth of the groove under a ball, of its diameter, rounded up to whole steps, m."""


class Contour(NamedTuple):
    """One line of the drawing."""

    layer: str
    points: Points
    closed: bool = True


class CutterPoint(WallPoint):
    """A place of the wall, and the centre of a cutter that touches it there."""

    cutter_axial: float
    cutter_around: float


class SleeveSizes(NamedTuple):
    """Sizes that both sleeves share, m."""

    outer_diameter: float
    bore: float
    depth: float
    """B, along the axis."""
    pocket_end: float
    """Radius at which a pocket ends towards the axis; it is open outwards."""
    relief: float
    """Depth of the groove below the lowest point of the ball."""
    groove: float
    """Its width around the circle."""
    assumed: frozenset[str]
    """Sizes that the spec does not tell."""


class ShopDrawing(NamedTuple):
    """The pockets of one ball, the sleeves at their stop, and what the sleeves are beside them."""

    name: str
    spec: Spec
    sleeve: SleeveSizes
    masses: tuple[float, ...]
    """Of the parts with pockets, kg; none where there is no layout."""
    contours: list[Contour]
    synthesis: SynthesisResult
    profile: list[CutterPoint]
    """The wall of the first sleeve with the path of the cutter, from the floor to the face."""
    cutter_radius: float
    chord: float


def shop_drawing(
    clutch: Clutch, unit: SynthesisResult, cutter: float | None = None, chord: float | None = None
) -> ShopDrawing:
    """Lay out the pockets of a control unit as synthesized.

    Args:
        clutch: the clutch.
        unit: its control unit.
        cutter: diameter of the cutter, m; its axis stands on the section. None for one of ``CUTTER``.
        chord: how far a chord may lie off the wall, m; None for ``Wall.chord``.

    Raises:
        CalculationError: the wall cannot be cut, or not with this cutter.
    """
    wall = wall_of(clutch, unit.face_gap, unit.ball_diameter / 2)
    chord = wall.chord if chord is None else chord
    if not wall.can_be_cut:
        assert wall.undercut_radius is not None
        message = say(
            "no pocket to draw: a ball of {ball:.5g mm} undercuts its curved wall, as does every one from "
            "{limit:.5g mm} on (afmcalc synthesize says what makes it possible)",
            ball=unit.ball_diameter,
            limit=2 * wall.undercut_radius,
        )
        raise CalculationError(message)
    radius = CUTTER * wall.ball_radius if cutter is None else cutter / 2
    if not 0 < radius <= wall.ball_radius * (1 + 1e-12):
        message = say(
            "--cutter: {cutter:.5g mm} is none: the pocket takes one of up to {ball:.5g mm}, as large as the ball",
            cutter=2 * radius,
            ball=unit.ball_diameter,
        )
        raise CalculationError(message)
    if unit.web is not None and unit.web <= 0:
        raise CalculationError("no pocket to draw: the pockets cut into each other")
    sleeve = _sleeve_of(clutch.spec, unit, wall)
    profile = _profile(wall, radius, chord)
    seat = wall if wall.sleeves == 2 else wall._replace(steepening=0.0)
    path = [(-place.path_axial, place.path_around) for place in profile if place.travel >= 0]
    way = _both_sides([(-place.cutter_axial, place.cutter_around) for place in profile])
    first = _pocket(profile, wall, unit.pocket_depth_cut, sleeve.relief)
    second = _mirrored(_pocket(_profile(seat, radius, chord), seat, unit.pocket_depth_cut, sleeve.relief))
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
            Contour("CUTTER", way, closed=False),
        ],
        synthesis=unit,
        profile=profile,
        cutter_radius=radius,
        chord=chord,
    )


def _sleeve_of(spec: Spec, unit: SynthesisResult, wall: Wall) -> SleeveSizes:
    """Return the sizes of the sleeves: as given, else as the layout has them, else in proportion to the ball."""
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
        message = say(
            "no pocket to draw: {cut:.5g mm} deep, and {relief:.5g mm} under the ball, it goes through a sleeve of "
            "{depth:.5g mm}",
            cut=cut,
            relief=relief,
            depth=depth,
        )
        raise CalculationError(message)
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
    """Half the width between the ends of the walls, as deep below the face as the ball reaches."""
    start = wall.at(0.0)
    return start.wall_around - (depth + wall.face_gap / 2 + start.wall_axial) * wall.tangent


def _profile(wall: Wall, cutter: float, chord: float) -> list[CutterPoint]:
    """The wall from where a cutter touches the floor: straight on below the ball at the stop, then up to the face."""
    points = wall.points(chord)
    below = (wall.ball_radius - cutter) * (1 - math.sin(wall.angle))
    if below > 0:
        start, around = points[0], -below * wall.tangent
        points.insert(
            0,
            WallPoint(
                travel=-wall.sleeves * below,
                wall_angle=start.wall_angle,
                path_axial=-below,
                path_around=around,
                wall_axial=start.wall_axial - below,
                wall_around=start.wall_around + around,
            ),
        )
    return [
        CutterPoint(
            **dict(point),
            cutter_axial=point.wall_axial + cutter * math.sin(point.wall_angle),
            cutter_around=point.wall_around - cutter * math.cos(point.wall_angle),
        )
        for point in points
    ]


def _pocket(profile: list[CutterPoint], wall: Wall, depth: float, relief: float) -> Points:
    """Contour of a pocket: up one wall and down the other, the groove between them, open side at the face."""
    floor, half = depth + wall.face_gap / 2, _floor_half(wall, depth)
    above = [(-place.wall_axial, place.wall_around) for place in profile if -place.wall_axial < floor * (1 - 1e-12)]
    return _both_sides([(floor + relief, half), (floor, half), *above])


def _both_sides(upper: Points) -> Points:
    """A line on one side of the axis, and back on the other; a place on the axis is there once."""
    return [(along, -around) for along, around in reversed(upper)] + upper[abs(upper[0][1]) < 1e-12 :]


def _mirrored(points: Points) -> Points:
    """The same in the other sleeve, which turns the other way."""
    return [(-along, -around) for along, around in points]


def _sleeve(pocket: Points, extent: tuple[float, ...]) -> Points:
    """A sleeve with its pocket, drawn as far along and around as ``extent`` says."""
    (back, side), face = extent, pocket[0][0]
    return [(back, -side), (face, -side), *pocket, (face, side), (back, side)]
