"""The wall of a pocket in the section at the ball circle: where the ball is and touches, from the stop to the face."""

import math
from bisect import bisect_left
from typing import NamedTuple

from ..engines.protocol import Clutch
from ..equations import synthesis, wall
from ..equations.calls import unnoted
from ..result import Result, quantity
from ..spec.models import ControlUnit

DEFAULT_CLEARANCE = 0.002
"""s and y where the spec gives none, m: S21 takes 2…3 mm."""
CHORD = 1e-6
"""How far a chord may lie off the wall unless told, m."""
_WITHIN = 8
"""Places of a chord at which it is held against the wall."""


class WallPoint(Result):
    """A place of the ball: its centre and its contact, from the centre at the stop."""

    travel: float = quantity("m", "x", "travel of the sleeve")
    wall_angle: float = quantity("rad", "α", "wall angle")
    path_axial: float = quantity("m", "ξ", "centre of the ball, along the axis out of the pocket")
    path_around: float = quantity("m", "Y", "centre of the ball, around the circle")
    wall_axial: float = quantity("m", "ξ_w", "wall, along the axis")
    wall_around: float = quantity("m", "Y_w", "wall, around the circle")


class Wall(NamedTuple):
    """A wall, straight or curved, and the ball that runs on it."""

    tangent: float
    """tan α_0."""
    steepening: float
    """Y'', 1/m."""
    sleeves: int
    """m: 1 where the ball stays seated in the other sleeve, 2 with walls alike in both."""
    face_gap: float
    """s, m."""
    ball_radius: float
    """r_ш, m."""

    @property
    def angle(self) -> float:
        """α_0, rad."""
        return math.atan(self.tangent)

    @property
    def undercut_radius(self) -> float | None:
        """Radius of a ball that would undercut it, m; None of a straight wall."""
        if self.steepening == 0:
            return None
        return float(wall.path_radius(self.steepening, math.cos(self.angle)))

    @property
    def can_be_cut(self) -> bool:
        """Whether a ball of its own size can have made it."""
        return self.undercut_radius is None or self.ball_radius < self.undercut_radius

    @unnoted()
    def angle_at(self, depth: float) -> float:
        """Wall angle where the ball is ξ from its place at the stop, rad."""
        return math.atan(wall.path_tangent(self.tangent, self.steepening, depth))

    @unnoted()
    def contact_depth(self, depth: float) -> float:
        """How far below the face the ball at ξ touches, m."""
        return float(wall.contact_depth(self.ball_radius, math.sin(self.angle_at(depth)), depth, self.face_gap))

    @unnoted()
    def at(self, depth: float) -> WallPoint:
        """The ball at ξ."""
        angle = self.angle_at(depth)
        around = wall.path(self.tangent, self.steepening, depth)
        return WallPoint(
            travel=self.sleeves * depth,
            wall_angle=angle,
            path_axial=depth,
            path_around=around,
            wall_axial=wall.wall_axial(depth, self.ball_radius, math.sin(angle)),
            wall_around=wall.wall_around(around, self.ball_radius, math.cos(angle)),
        )

    def smallest_ball(self, travel: float, clearance: float) -> float:
        """Radius of the smallest ball that touches below the face all along, m.

        Least deep at the largest travel, or at the stop where a ball so large undercuts the wall: between them no
        place asks for more than both.
        """

        def needed(depth: float) -> tuple[float, float, float, float]:
            return 2 * depth, self.face_gap, clearance, math.sin(self.angle_at(depth))

        with unnoted():
            shallowest = max((0.0, travel / self.sleeves), key=lambda depth: synthesis.ball_radius(*needed(depth)))
        return float(synthesis.ball_radius(*needed(shallowest)))

    def clearance(self, travel: float) -> float:
        """How far below the face the ball touches where it does least, m: at the largest travel, or at the stop."""
        depth = min((0.0, travel / self.sleeves), key=self.contact_depth)
        sine = math.sin(self.angle_at(depth))
        return float(synthesis.edge_clearance(self.ball_radius, 2 * depth, self.face_gap, sine))

    @property
    def mouth(self) -> float:
        """ξ at which the ball would touch the edge of the pocket, m."""
        low, high = 0.0, self.ball_radius
        while True:
            middle = (low + high) / 2
            if middle in (low, high):
                return low
            low, high = (middle, high) if self.contact_depth(middle) > 0 else (low, middle)

    @property
    def width(self) -> float:
        """Width of the pocket at the face, m."""
        return 2 * self.at(self.mouth).wall_around

    def points(self, chord: float = CHORD) -> list[WallPoint]:
        """Places from the stop to the mouth, so near that chords between them keep within ``chord`` of the wall."""
        end, enough = self.mouth, 1
        while self._farthest_off(end, enough) > chord:
            enough *= 2
        counts = range(enough // 2 + 1, enough + 1)
        count = counts[bisect_left(counts, -chord, key=lambda number: -self._farthest_off(end, number))]
        return [self.at(end * i / count) for i in range(count + 1)]

    def _farthest_off(self, end: float, count: int) -> float:
        """How far the wall as far as a place lies off its chords, so many of them, m."""
        if self.steepening == 0:
            return 0.0
        return max(self._off(end * i / count, end * (i + 1) / count) for i in range(count))

    def _off(self, start: float, stop: float) -> float:
        """How far the wall between two places lies off its chord, m."""
        first, last = self.at(start), self.at(stop)
        along, around = last.wall_axial - first.wall_axial, last.wall_around - first.wall_around
        between = (self.at(start + (stop - start) * i / _WITHIN) for i in range(1, _WITHIN))
        crosses = (
            along * (place.wall_around - first.wall_around) - around * (place.wall_axial - first.wall_axial)
            for place in between
        )
        return max(map(abs, crosses)) / math.hypot(along, around)


def clearances(unit: ControlUnit) -> tuple[float, float]:
    """Gap s of the faces and clearance y of the contact, m: as given, or what S21 takes."""
    gap, clearance = (DEFAULT_CLEARANCE if given is None else given for given in (unit.face_gap, unit.edge_clearance))
    return gap, clearance


def wall_of(clutch: Clutch, face_gap: float, ball_radius: float = 0.0) -> Wall:
    """Return the wall of a clutch's pockets, for a ball."""
    unit, radius = clutch.spec.control_unit, float(clutch.mean_radius)
    assert unit is not None
    assert unit.ball_circle_radius is not None
    tangent = float(synthesis.tan_wall_angle(clutch.gain, unit.ball_circle_radius, radius))
    slope = float(clutch.sleeve.gain_slope) if clutch.sleeve else 0.0
    if slope == 0:
        return Wall(tangent, 0.0, 2, face_gap, ball_radius)
    sleeves = 2 if unit.profiled == "both" else 1
    steepening = float(wall.path_steepening(slope, unit.ball_circle_radius, radius, sleeves))
    return Wall(tangent, steepening, sleeves, face_gap, ball_radius)
