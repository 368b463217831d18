"""Elliptic contact of a ball on a convex wall (Johnson, Contact Mechanics, section 4.2)."""

import math

from ..equations import synthesis, wall

# what is searched for, or asked along a whole wall, is no step of a calculation: bound here, it is not recorded
from ..equations.wall import hertz_axes, hertz_curvature_ratio, hertz_ellipse_factor, hertz_relative_radius
from ..spec.contact import Contact


def integrals(axis_ratio: float) -> tuple[float, float]:
    """Complete elliptic integrals 𝐁 and 𝐃 of the modulus √(1 − k²), by the arithmetic-geometric mean.

    𝐃 = (K − E)/e² and 𝐁 = K − 𝐃, without the differences: exact for a circle too.
    """
    mean, root, squared = 1.0, axis_ratio, 1 - axis_ratio * axis_ratio
    # of c_n, half the difference of the two means: c_n²/e², from c_1 = (1 − k)/2 by c_{n+1} = c_n²/(4 a_{n+1})
    share, weight, total = (1 - axis_ratio) / (4 * (1 + axis_ratio)), 2.0, 0.0
    while weight == 2.0 or mean - root > 1e-15 * mean:
        mean, root = (mean + root) / 2, math.sqrt(mean * root)
        total += weight * share
        share, weight = share * share * squared / (2 * (mean + root)) ** 2, 2 * weight
    complete = math.pi / (2 * mean)
    part = complete * (1 + total) / 2
    return complete - part, part


def axis_ratio(curvature_ratio: float) -> float:
    """Minor over major semi-axis of the ellipse that two curvatures give; a larger ratio is a slimmer ellipse."""
    low, high = 0.0, 1.0
    while True:
        middle = (low + high) / 2
        if middle in (low, high):
            return high
        if hertz_axes(middle, *integrals(middle)) > curvature_ratio:
            low = middle
        else:
            high = middle


def contact_radius(ball_radius: float, path_radius: float) -> float:
    """Radius R_e φ of a ball that bears on a flat what this one does on a wall of the radius ρ − r_ш, m."""
    curvatures = hertz_curvature_ratio(path_radius, ball_radius)
    slimness = axis_ratio(curvatures)
    factor = hertz_ellipse_factor(slimness, *integrals(slimness), math.pi)
    return float(hertz_relative_radius(ball_radius, curvatures) * factor)


def ball_on_flat(contact: Contact, ball_radius: float) -> float:
    """Force at which a ball on a flat wall reaches the allowable pressure, N."""
    modulus = synthesis.hertz_contact_modulus(
        contact.ball_modulus, contact.ball_poisson, contact.wall_modulus, contact.wall_poisson
    )
    return float(synthesis.hertz_allowable_force(contact.allowable_pressure, ball_radius, modulus, math.pi))


def ball_on_convex_wall(contact: Contact, ball_radius: float, path_radius: float) -> float:
    """Force at which a ball on a wall of the radius ρ − r_ш, straight across, reaches the allowable pressure, N."""
    curvatures = wall.hertz_curvature_ratio(path_radius, ball_radius)
    slimness = axis_ratio(curvatures)
    factor = wall.hertz_ellipse_factor(slimness, *integrals(slimness), math.pi)
    return ball_on_flat(contact, wall.hertz_relative_radius(ball_radius, curvatures) * factor)
