"""Hertz contact of a ball on a flat or convex wall (Johnson, Contact Mechanics, section 4.2): numbers or arrays."""

import math

from ..equations import synthesis, wall
from ..equations.arrays import Values
from ..equations.calls import unnoted
from ..spec.models import Contact

_ITERATIONS = 30
"""Each leaves at most a quarter of the error: d ln(𝐁/𝐃)/d ln k lies between 0 and 1/2."""


def integrals(axis_ratio: Values) -> tuple[Values, Values]:
    """Complete elliptic integrals 𝐁 and 𝐃 of the modulus √(1 − k²): 𝐃 = R_D(0, k², 1)/3, 𝐁 = K − 𝐃, exact at k = 1."""
    from scipy.special import elliprd, elliprf

    squared = axis_ratio * axis_ratio
    part = elliprd(0, squared, 1) / 3
    return elliprf(0, squared, 1) - part, part


@unnoted()
def axis_ratio(curvature_ratio: Values) -> Values:
    """Minor over major semi-axis of the ellipse that two curvatures give; a larger ratio is a slimmer ellipse."""
    ratio = curvature_ratio ** (-2 / 3)
    for _ in range(_ITERATIONS):
        ratio = ratio * (wall.hertz_axes(ratio, *integrals(ratio)) / curvature_ratio) ** 0.5
    return ratio


def allowable_force(contact: Contact, ball_radius: Values, path_radius: Values | None = None) -> Values:
    """Normal force at which a ball reaches the allowable pressure, N.

    ``path_radius`` is ρ of the path of the ball's centre, m, the wall straight across it; None of a straight wall.
    """
    modulus = synthesis.hertz_contact_modulus(
        contact.ball_modulus, contact.ball_poisson, contact.wall_modulus, contact.wall_poisson
    )
    radius = ball_radius if path_radius is None else _radius_on_flat(ball_radius, path_radius)
    return synthesis.hertz_allowable_force(contact.allowable_pressure, radius, modulus, math.pi)


def pressure(contact: Contact, force: Values, ball_radius: Values, path_radius: Values | None = None) -> Values:
    """Largest contact pressure p_0 under a normal force, Pa; the rest as ``allowable_force``."""
    allowable = allowable_force(contact, ball_radius, path_radius)
    return synthesis.hertz_pressure(contact.allowable_pressure, force, allowable)


def _radius_on_flat(ball_radius: Values, path_radius: Values) -> Values:
    """Radius R_e φ of a ball that bears on a flat what this one does on a wall of the radius ρ − r_ш, m."""
    curvatures = wall.hertz_curvature_ratio(path_radius, ball_radius)
    slimness = axis_ratio(curvatures)
    factor = wall.hertz_ellipse_factor(slimness, *integrals(slimness), math.pi)
    return wall.hertz_relative_radius(ball_radius, curvatures) * factor
