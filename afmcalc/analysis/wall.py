"""The wall of a pocket at the ball circle: where the ball is and touches, from the stop to the face, and what it bears.

On a straight wall that is most at the largest torque, on a curved one wherever its path takes it.
"""

import math
from bisect import bisect_left
from collections.abc import Sequence
from typing import Literal, NamedTuple

import numpy as np

from ..engines.indirect import IndirectClutch
from ..engines.protocol import Clutch
from ..equations import synthesis
from ..equations import wall as wall_law
from ..equations.arrays import Values
from ..errors import given
from ..result import Result, quantity
from ..spec.models import ControlUnit
from . import hertz

DEFAULT_CLEARANCE = 0.002
"""s and y where the spec gives none, m: S21 takes 2…3 mm."""
CHORD = 1e-6
"""How far a chord may lie off the wall, m."""
CHORD_SHARE = 1e-5
"""The same of a ball above 200 mm, of its radius: a wall of some metres needs no more chords."""
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
    face_gap: float
    """s, m."""
    ball_radius: float
    """r_ш, m."""

    @property
    def sleeves(self) -> int:
        """Sleeves that the ball moves in: one with a curved wall, seated in the other; two with straight walls."""
        return 1 if self.steepening > 0 else 2

    @property
    def angle(self) -> float:
        """α_0, rad."""
        return math.atan(self.tangent)

    @property
    def undercut_radius(self) -> float | None:
        """Radius of a ball that would undercut it, m; None of a straight wall."""
        if self.steepening == 0:
            return None
        return float(wall_law.path_radius(self.steepening, math.cos(self.angle)))

    @property
    def can_be_cut(self) -> bool:
        """Whether a ball of its own size can have made it."""
        return self.undercut_radius is None or self.ball_radius < self.undercut_radius

    def angle_at(self, depth: float) -> float:
        """Wall angle where the ball is ξ from its place at the stop, rad."""
        return math.atan(wall_law.path_tangent(self.tangent, self.steepening, depth))

    def contact_depth(self, depth: float) -> float:
        """How far below the face the ball at ξ touches, m."""
        return float(wall_law.contact_depth(self.ball_radius, math.sin(self.angle_at(depth)), depth, self.face_gap))

    def at(self, depth: float) -> WallPoint:
        """The ball at ξ."""
        angle = self.angle_at(depth)
        around = wall_law.path(self.tangent, self.steepening, depth)
        return WallPoint(
            travel=self.sleeves * depth,
            wall_angle=angle,
            path_axial=depth,
            path_around=around,
            wall_axial=wall_law.wall_axial(depth, self.ball_radius, math.sin(angle)),
            wall_around=wall_law.wall_around(around, self.ball_radius, math.cos(angle)),
        )

    def smallest_ball(self, travel: float, clearance: float) -> float:
        """Radius of the smallest ball that touches below the face all along, m.

        Least deep at the largest travel, or at the stop where a ball so large undercuts the wall: between them no
        place asks for more than both.
        """

        def needed(depth: float) -> tuple[float, float, float, float]:
            return 2 * depth, self.face_gap, clearance, math.sin(self.angle_at(depth))

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
    def chord(self) -> float:
        """How far a chord may lie off the wall, m."""
        return max(CHORD, CHORD_SHARE * self.ball_radius)

    @property
    def width(self) -> float:
        """Width of the pocket at the face, m."""
        return 2 * self.at(self.mouth).wall_around

    def points(self) -> list[WallPoint]:
        """Places from the stop to the mouth, so near that chords between them keep within ``chord`` of the wall."""
        end, enough, chord = self.mouth, 1, self.chord
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
    unit, radius = given(clutch.spec.control_unit), float(clutch.mean_radius)
    circle = given(unit.ball_circle_radius)
    tangent = float(synthesis.tan_wall_angle(clutch.gain, circle, radius))
    slope = float(clutch.sleeve.gain_slope) if clutch.sleeve else 0.0
    steepening = 0.0 if slope == 0 else float(wall_law.path_steepening(slope, circle, radius))
    return Wall(tangent, steepening, face_gap, ball_radius)


Basis = Literal["given", "hertz-ball-on-flat", "hertz-ball-on-curved-wall"]
_PLACES = 65
"""Places of the path at which the contact is held against what it may carry."""


class BallContact(NamedTuple):
    """The contact of a ball, as the fields of the result of a synthesis; None is not known."""

    contact_force: float | None
    """F_n where it is largest, N."""
    contact_force_allowable: float | None
    """[F_n] of the limit of which most is used, N."""
    contact_basis: Basis | None
    contact_force_hertz: float | None
    """[F_n] by Hertz where the contact pressure is largest, if that is a limit, N."""
    contact_utilisation: float | None = None
    contact_force_critical: float | None = None
    """F_n where the contact pressure is largest, if that is elsewhere, N."""
    contact_pressure: float | None = None
    """Largest contact pressure, Pa."""


def places_along(clutch: IndirectClutch, wall: Wall) -> tuple[list[float], list[float]]:
    """Torque and wall angle along the path of a ball on a curved wall, from the stop to the largest travel."""
    low, _, high = clutch.friction[0]
    leaving = min(max(float(clutch.leaving_friction), low), high)
    # where the torque is largest, as long as the sleeve has not jumped from there
    along = np.append(np.linspace(leaving, high, _PLACES), max(clutch.torque_range.at_high * (1 - 1e-12), leaving))
    travels = np.broadcast_to(np.asarray(clutch.travel(along), float), along.shape).tolist()
    return np.asarray(clutch.torque(along)).tolist(), [wall.angle_at(travel / wall.sleeves) for travel in travels]


def contact_of(
    unit: ControlUnit, wall: Wall, torques: Sequence[Values], angles: Sequence[float], *, ball_known: bool
) -> BallContact:
    """Hold the contact of a ball against every limit that the spec gives, or against Hertz where it gives none.

    At places of the ball go through the balls ``torques``, N·m, on walls at ``angles``, rad; ``ball_known``: there is
    such a ball, so that Hertz tells what it may carry.
    """
    given, elastic, ball = unit.allowable_contact_force, unit.elasticity, wall.ball_radius
    elastic_known = ball_known and wall.can_be_cut

    def force_at(torque: Values, angle: float) -> float | None:
        if unit.balls is None:
            return None
        return float(synthesis.contact_force(torque, unit.balls, unit.ball_circle_radius, math.cos(angle)))

    def borne_at(angle: float) -> float:
        path = wall_law.path_radius(wall.steepening, math.cos(angle)) if wall.steepening > 0 else None
        return float(hertz.allowable_force(elastic, ball, path))

    cosines = np.cos(angles)
    forces = synthesis.contact_force(np.array(torques, float), unit.balls or 1, unit.ball_circle_radius, cosines)
    most = worst = int(np.argmax(forces))
    if elastic_known and wall.steepening > 0:
        paths = wall_law.path_radius(wall.steepening, cosines)
        worst = int(np.argmax(forces / hertz.allowable_force(elastic, ball, paths)))
    force = force_at(torques[most], angles[most])
    critical = force if worst == most else force_at(torques[worst], angles[worst])
    borne = borne_at(angles[worst]) if elastic_known else None
    by_hertz = borne if given is None or unit.contact is not None else None
    curved: Basis = "hertz-ball-on-curved-wall" if wall.steepening > 0 else "hertz-ball-on-flat"
    limits: list[tuple[float, float, Basis]] = []
    if given is not None:
        limits.append((float(forces[most]), given, "given"))
    if by_hertz is not None:
        limits.append((float(forces[worst]), by_hertz, curved))
    used, allowable, basis = max(limits, key=lambda limit: limit[0] / limit[1], default=(0.0, None, None))
    contact = BallContact(force, allowable, basis, by_hertz)
    if critical is None:
        return contact
    pressure = None if borne is None else float(synthesis.hertz_pressure(elastic.allowable_pressure, critical, borne))
    return contact._replace(
        contact_utilisation=allowable and used / allowable,
        contact_force_critical=None if worst == most else critical,
        contact_pressure=pressure,
    )
