"""Hertz contact of a ball on a flat wall (Johnson, Contact Mechanics, section 4.2): numbers or arrays."""

from ..equations import control_unit as law
from ..equations.arrays import Values
from ..spec.models import Contact


def allowable_force(contact: Contact, ball_radius: Values) -> Values:
    """Normal force at which a ball reaches the allowable pressure, N."""
    modulus = law.contact_modulus(
        contact.ball_modulus, contact.ball_poisson, contact.wall_modulus, contact.wall_poisson
    )
    return law.contact_force_hertz(contact.allowable_pressure, ball_radius, modulus)


def pressure(contact: Contact, force: Values, ball_radius: Values) -> Values:
    """Largest contact pressure p_0 under a normal force, Pa."""
    return law.contact_pressure(contact.allowable_pressure, force, allowable_force(contact, ball_radius))
