"""Hertz contact of a ball on a flat or convex wall (Johnson, Contact Mechanics, section 4.2): numbers or arrays."""

import math

from ..equations import synthesis, wall
from ..equations.arrays import Values
from ..spec.models import Contact


def allowable_force(contact: Contact, ball_radius: Values, path_radius: Values | None = None) -> Values:
    """Normal force at which a ball reaches the allowable pressure, N.

    ``path_radius`` is ρ of the path of the ball's centre, m, the wall straight across it; None of a straight wall.
    """
    modulus = synthesis.hertz_contact_modulus(
        contact.ball_modulus, contact.ball_poisson, contact.wall_modulus, contact.wall_poisson
    )
    radius = ball_radius if path_radius is None else wall.hertz_relative_radius(ball_radius, path_radius)
    return synthesis.hertz_allowable_force(contact.allowable_pressure, radius, modulus, math.pi)


def pressure(contact: Contact, force: Values, ball_radius: Values, path_radius: Values | None = None) -> Values:
    """Largest contact pressure p_0 under a normal force, Pa; the rest as ``allowable_force``."""
    allowable = allowable_force(contact, ball_radius, path_radius)
    return synthesis.hertz_pressure(contact.allowable_pressure, force, allowable)
