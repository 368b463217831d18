"""What the shop cuts: the pockets of a control unit as contours in the section at the ball circle, and a cutter's way.

Coordinates: from the centre of the ball at the stop, along the axis into the first sleeve, and around the circle. The
first sleeve has the curved wall, if there is one; the second seats the ball, or has the same.
"""

import math
from typing import NamedTuple, TypeAlias

from ..engines.protocol import Clutch
from ..errors import CalculationError
from ..messages import say
from .synthesize import SynthesisResult
from .wall import CHORD, Wall, WallPoint, wall_of

Points: TypeAlias = list[tuple[float, float]]
"""(along the axis, around the circle), m."""

BACK = 0.5
"""What is drawn of a sleeve behind its pocket and beside it, of the pocket's depth and half its width."""


class Contour(NamedTuple):
    """One line of the drawing."""

    layer: str
    points: Points
    closed: bool = True


class CutterPoint(WallPoint):
    """A place of the wall, and the centre of a cutter that touches it there."""

    cutter_axial: float
    cutter_around: float


class ShopDrawing(NamedTuple):
    """The pockets of one ball, the sleeves at their stop."""

    name: str
    contours: list[Contour]
    synthesis: SynthesisResult
    profile: list[CutterPoint]
    """The wall of the first sleeve with the path of the cutter, from the floor to the face."""
    cutter_radius: float
    chord: float


def shop_drawing(
    clutch: Clutch, unit: SynthesisResult, cutter: float | None = None, chord: float = CHORD
) -> ShopDrawing:
    """Lay out the pockets of a control unit as synthesized.

    Args:
        clutch: the clutch.
        unit: its control unit.
        cutter: diameter of the cutter, m; its axis stands on the section. None for one as large as the ball.
        chord: how far a chord may lie off the wall, m.

    Raises:
        CalculationError: the wall cannot be cut, or not with this cutter.
    """
    wall = wall_of(clutch, unit.face_gap, unit.ball_diameter / 2)
    if not wall.can_be_cut:
        assert wall.undercut_radius is not None
        message = say(
            "no pocket to draw: a ball of {ball:.5g mm} undercuts its curved wall, as does every one from "
            "{limit:.5g mm} on (afmcalc synthesize says what makes it possible)",
            ball=unit.ball_diameter,
            limit=2 * wall.undercut_radius,
        )
        raise CalculationError(message)
    radius = wall.ball_radius if cutter is None else cutter / 2
    if not 0 < radius <= wall.ball_radius * (1 + 1e-12):
        message = say(
            "--cutter: {cutter:.5g mm} is none: the pocket takes one of up to {ball:.5g mm}, as large as the ball",
            cutter=2 * radius,
            ball=unit.ball_diameter,
        )
        raise CalculationError(message)
    profile = _profile(wall, radius, chord)
    seat = wall if wall.sleeves == 2 else wall._replace(steepening=0.0)
    path = [(-place.path_axial, place.path_around) for place in profile if place.travel >= 0]
    way = _both_sides([(-place.cutter_axial, place.cutter_around) for place in profile])
    first = _pocket(profile, wall, unit.pocket_depth_cut)
    second = _mirrored(_pocket(_profile(seat, radius, chord), seat, unit.pocket_depth_cut))
    extent = tuple((1 + BACK) * max(map(abs, ends)) for ends in zip(*first, *second, strict=True))
    return ShopDrawing(
        name=clutch.spec.name or clutch.spec.variant,
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


def _pocket(profile: list[CutterPoint], wall: Wall, depth: float) -> Points:
    """Contour of a pocket: up one wall and down the other, the floor between them, open side at the face."""
    floor = depth + wall.face_gap / 2
    start = wall.at(0.0)
    half = start.wall_around - (floor + start.wall_axial) * wall.tangent
    above = [(-place.wall_axial, place.wall_around) for place in profile if -place.wall_axial < floor * (1 - 1e-12)]
    return _both_sides([(floor, half), *above])


def _both_sides(upper: Points) -> Points:
    """A line on one side of the axis, and back on the other."""
    return [(along, -around) for along, around in reversed(upper)] + upper


def _mirrored(points: Points) -> Points:
    """The same in the other sleeve, which turns the other way."""
    return [(-along, -around) for along, around in points]


def _sleeve(pocket: Points, extent: tuple[float, ...]) -> Points:
    """A sleeve with its pocket, drawn as far along and around as ``extent`` says."""
    (back, side), face = extent, pocket[0][0]
    return [(back, -side), (face, -side), *pocket, (face, side), (back, side)]
