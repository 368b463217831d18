"""What a ball bears on a curved wall: more here, less there, as the travel takes it along."""

import math
from typing import Literal, NamedTuple

import numpy as np

from ..engines.protocol import Clutch
from ..equations import synthesis as law
from ..equations import wall as wall_law
from ..equations.synthesis import contact_force
from ..equations.wall import path_radius, seat_force
from ..spec.models import ControlUnit
from . import hertz
from .wall import Wall

Basis = Literal["given", "hertz-ball-on-flat", "hertz-ball-on-curved-wall"]
_PLACES = 65
"""Places of the path at which the contact is held against what it may carry."""


class BallContact(NamedTuple):
    """The contact of a ball; None is not known."""

    force: float | None
    """F_n where it is largest, N."""
    allowable: float | None
    """[F_n] where most of it is used, N."""
    basis: Basis | None
    utilisation: float | None
    seat: float | None = None
    """F_s of the straight walls that seat the ball in the other sleeve, N."""
    seat_utilisation: float | None = None
    critical: float | None = None
    """F_n where most of what is allowed is used, if that is elsewhere, N."""


def contact_along(clutch: Clutch, unit: ControlUnit, wall: Wall, *, ball_known: bool) -> BallContact:
    """Return the contact of a ball on a curved wall from the stop to the largest travel.

    Args:
        clutch: the clutch.
        unit: its control unit.
        wall: its wall, with the ball.
        ball_known: whether there is such a ball, so that Hertz tells what it may carry.
    """
    own = clutch.friction[0]
    leaving = min(max(float(clutch.leaving_friction or own.min), own.min), own.max)
    # where the torque is largest, as long as the sleeve has not jumped from there
    along = np.append(np.linspace(leaving, own.max, _PLACES), max(clutch.torque_range.at_high * (1 - 1e-12), leaving))
    travels = np.broadcast_to(np.asarray(clutch.travel(along), float), along.shape).tolist()
    # force on a flat wall, by which every other is told
    given, flat = unit.allowable_contact_force, None
    if given is None and unit.contact is not None and ball_known and wall.can_be_cut:
        flat = hertz.ball_on_flat(unit.contact, wall.ball_radius)
    places = [
        _Place(wall, unit, wall.angle_at(travel / wall.sleeves), torque, given, flat)
        for travel, torque in zip(travels, clutch.torque(along).tolist(), strict=True)
    ]
    most = max(places, key=lambda place: place.force)
    worst = max(places, key=lambda place: place.force if place.utilisation is None else place.utilisation)
    allowable, basis = _as_recorded(worst)
    if unit.balls is None:
        return BallContact(None, allowable, basis, None)

    def borne(place: _Place) -> float:
        return float(law.contact_force(place.torque, unit.balls, unit.ball_circle_radius, math.cos(place.angle)))

    found = BallContact(borne(most), allowable, basis, worst.utilisation)
    if worst is not most:
        found = found._replace(critical=borne(worst))
    if wall.sleeves == 2:
        return found
    seat = max(place.seat for place in places)
    bears = flat if given is None else given
    return found._replace(seat=seat, seat_utilisation=bears and seat / bears)


def _as_recorded(worst: "_Place") -> tuple[float | None, Basis | None]:
    """[F_n] and where it is from, by the equations as an explanation records them."""
    if worst.given is not None:
        return worst.given, "given"
    if worst.flat is None:
        return None, None
    assert worst.unit.contact is not None
    radius = float(wall_law.path_radius(worst.wall.steepening, math.cos(worst.angle)))
    own = hertz.ball_on_convex_wall(worst.unit.contact, worst.wall.ball_radius, radius)
    return own, "hertz-ball-on-curved-wall"


class _Place(NamedTuple):
    """The ball somewhere on its path."""

    wall: Wall
    unit: ControlUnit
    angle: float
    torque: float
    given: float | None
    flat: float | None
    """What a flat wall may bear by Hertz, N."""

    @property
    def force(self) -> float:
        """F_n, N; of a number of balls that is not given, of all."""
        unit = self.unit
        return float(contact_force(self.torque, unit.balls or 1, unit.ball_circle_radius, math.cos(self.angle)))

    @property
    def seat(self) -> float:
        """F_s, N, where the other sleeve seats the ball between straight walls."""
        own = self.wall.angle
        return float(seat_force(self.force, math.sin(self.angle + own), math.sin(own), math.cos(own)))

    @property
    def utilisation(self) -> float | None:
        """F_n/[F_n]."""
        if self.given is not None:
            return self.force / self.given
        if self.flat is None:
            return None
        radius = float(path_radius(self.wall.steepening, math.cos(self.angle)))
        share = (hertz.contact_radius(self.wall.ball_radius, radius) / self.wall.ball_radius) ** 2
        return self.force / (share * self.flat)
