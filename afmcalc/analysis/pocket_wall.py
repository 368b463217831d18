"""The wall of a pocket at the ball circle, for drawings: where the ball is and touches, from the stop to the face."""

import math
from typing import NamedTuple

from ..engines import Clutch
from ..equations import curved_wall as law
from ..result import Result, quantity

CHORDS = 32
"""Chords that a curved wall is drawn by: within 0.01 mm of it for balls up to 60 mm."""


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
    face_gap: float
    """s, m."""
    ball_radius: float
    """r_ш, m."""

    @property
    def sleeves(self) -> int:
        """Sleeves that the ball moves in: one with a curved wall, seated in the other; two with straight walls."""
        return 1 if self.steepening > 0 else 2

    @property
    def undercut_radius(self) -> float | None:
        """Smallest radius of a ball that undercuts it, m; None for a straight wall."""
        if self.steepening == 0:
            return None
        return float(law.undercut_radius(self.steepening, math.cos(math.atan(self.tangent))))

    @property
    def can_be_cut(self) -> bool:
        """True if the ball does not undercut it."""
        return self.undercut_radius is None or self.ball_radius < self.undercut_radius

    def at(self, depth: float) -> WallPoint:
        """The ball at ξ."""
        angle = law.wall_angle_at_ball(law.tan_wall_angle_at_ball(self.tangent, self.steepening, depth))
        around = law.path_around(self.tangent, self.steepening, depth)
        return WallPoint(
            travel=self.sleeves * depth, wall_angle=angle, path_axial=depth, path_around=around,
            wall_axial=law.wall_axial(depth, self.ball_radius, angle),
            wall_around=law.wall_around(around, self.ball_radius, angle),
        )  # fmt: skip

    def clearance(self, travel: float) -> float:
        """Least depth of the contact below the face, m: at the largest travel, or at the stop."""
        points = (self.at(depth) for depth in (0.0, travel / self.sleeves))
        return min(-point.wall_axial for point in points) - self.face_gap / 2

    @property
    def mouth(self) -> float:
        """ξ at which the ball would touch the edge of the pocket, m."""
        return float(law.travel_to_mouth(self.ball_radius, self.tangent, self.steepening, self.face_gap))

    def points(self) -> list[WallPoint]:
        """Places from the stop to the mouth, ends of chords."""
        end, count = self.mouth, CHORDS if self.steepening else 1
        return [self.at(end * i / count) for i in range(count + 1)]


def wall_of(clutch: Clutch, face_gap: float, ball_radius: float = 0.0) -> Wall:
    """Return the wall of a clutch's pockets, for a ball."""
    steepening = float(clutch["path_steepening"]) if "path_steepening" in clutch else 0.0
    return Wall(float(clutch["tan_wall_angle"]), steepening, face_gap, ball_radius)
