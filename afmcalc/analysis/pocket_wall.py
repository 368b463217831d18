"""Wall of a pocket at the ball circle, for drawings: centre and contact of the ball, from the stop to the face."""

import math
from typing import NamedTuple

from ..engines import Clutch
from ..equations import curved_wall as law
from ..result import Result, quantity

CHORDS = 32
"""Number of chords for drawing a curved wall: they stay within 0.01 mm of the wall for balls up to 60 mm."""


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
    """Tangent of the wall angle at the stop, tan α_0."""
    steepening: float
    """Change of the tangent along the axis, Y'', 1/m; 0: a straight wall."""
    face_gap: float
    """Gap between the sleeves at the stop, s, m."""
    ball_radius: float
    """Radius of the ball, r_ш, m."""
    undercut_radius: float = math.inf
    """Smallest ball radius at which the wall is undercut, ρ_0, m; infinite for a straight wall."""

    @property
    def sleeves(self) -> int:
        """Number of sleeves on whose walls the ball runs: 2 if straight, 1 if curved (the second sleeve seats it)."""
        return 1 if self.steepening > 0 else 2

    @property
    def can_be_cut(self) -> bool:
        """True if the ball does not undercut the wall."""
        return self.ball_radius < self.undercut_radius

    def at(self, depth: float) -> WallPoint:
        """Place of the ball when its centre has moved by ``depth`` (ξ, m) along the axis from the stop."""
        angle = law.wall_angle_at_ball(law.tan_wall_angle_at_ball(self.tangent, self.steepening, depth))
        around = law.path_around(self.tangent, self.steepening, depth)
        return WallPoint(
            travel=self.sleeves * depth, wall_angle=angle, path_axial=depth, path_around=around,
            wall_axial=law.wall_axial(depth, self.ball_radius, angle),
            wall_around=law.wall_around(around, self.ball_radius, angle),
        )  # fmt: skip

    def clearance(self, travel: float) -> float:
        """Depth of the contact below the face, m: the smaller of its depths at the stop and at ``travel``."""
        points = (self.at(depth) for depth in (0.0, travel / self.sleeves))
        return min(-point.wall_axial for point in points) - self.face_gap / 2

    @property
    def mouth(self) -> float:
        """Axial path ξ of the ball's centre at which the ball touches the edge of the pocket, m."""
        return float(law.travel_to_mouth(self.ball_radius, self.tangent, self.steepening, self.face_gap))

    def points(self) -> list[WallPoint]:
        """Places of the ball from the stop to the mouth of the pocket, at the ends of the chords."""
        end, count = self.mouth, CHORDS if self.steepening else 1
        return [self.at(end * i / count) for i in range(count + 1)]


def wall_of(clutch: Clutch, face_gap: float, ball_radius: float = 0.0) -> Wall:
    """Return the wall of a clutch's pockets for a ball radius, m, which may be 0 if only the wall's shape matters."""
    shape = clutch["tan_wall_angle"], clutch.get("path_steepening", 0.0)
    return Wall(*shape, face_gap, ball_radius, clutch.get("undercut_radius", math.inf))
