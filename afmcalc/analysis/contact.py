"""What a ball bears: on a straight wall at the largest torque, on a curved one wherever its path takes it."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Literal, NamedTuple

import numpy as np

from ..arrays import Values
from ..equations import synthesis as law
from ..equations import wall as wall_law
from ..equations.calls import unnoted
from ..spec.models import ControlUnit
from . import hertz
from .wall import Wall

if TYPE_CHECKING:
    from ..engines.indirect import IndirectClutch

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
    seat_force: float | None = None
    """F_s of the straight walls that seat the ball in the other sleeve, N."""
    seat_utilisation: float | None = None


def places_along(clutch: "IndirectClutch", wall: Wall) -> tuple[list[float], list[float]]:
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
        return float(law.contact_force(torque, unit.balls, unit.ball_circle_radius, math.cos(angle)))

    def borne_at(angle: float) -> float:
        path = wall_law.path_radius(wall.steepening, math.cos(angle)) if wall.steepening > 0 else None
        return float(hertz.allowable_force(elastic, ball, path))

    with unnoted():  # where the force and where the pressure is largest; of a number of balls not given, of all
        cosines = np.cos(angles)
        forces = law.contact_force(np.array(torques, float), unit.balls or 1, unit.ball_circle_radius, cosines)
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
    pressure = None if borne is None else float(law.hertz_pressure(elastic.allowable_pressure, critical, borne))
    contact = contact._replace(
        contact_utilisation=allowable and used / allowable,
        contact_force_critical=None if worst == most else critical,
        contact_pressure=pressure,
    )
    if wall.steepening == 0 or wall.sleeves == 2:
        return contact
    with unnoted():
        stop = wall.angle
        seat = float(np.max(wall_law.seat_force(forces, np.sin(np.add(angles, stop)), math.sin(stop), math.cos(stop))))
        flat = None if by_hertz is None else float(hertz.allowable_force(elastic, ball))
    bears = min((limit for limit in (given, flat) if limit is not None), default=None)
    return contact._replace(seat_force=seat, seat_utilisation=bears and seat / bears)
