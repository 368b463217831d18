"""Pressure on the faces of the pack at rest, where it is pressed most (handbook, chapter 11)."""

import math


def outer_diameter(outer_radius):
    """Outer diameter of the friction surface, 2 r_o. Source: Definition."""
    return 2 * outer_radius


def disc_bore(inner_radius):
    """Inner diameter of the friction surface, 2 r_i. Source: Definition."""
    return 2 * inner_radius


def mean_diameter(mean_radius):
    """Mean friction diameter, 2 R_cp. Source: Definition."""
    return 2 * mean_radius


def mean_pressure(pack_force_at_rest, inner_radius, outer_radius):
    """Mean surface pressure of a ring, F/(π (r_o² − r_i²)).
    Source: Juvinall & Marshek, Fundamentals of Machine Component Design, ch. 18. Validity: Full rings; grooves and
    sectors raise it."""
    return pack_force_at_rest / (math.pi * (outer_radius**2 - inner_radius**2))


def _peak_pressure(pack_force_at_rest, inner_radius, outer_radius):
    """Surface pressure at the inner edge with uniform wear, F/(2 π r_i (r_o − r_i)).
    Source: Juvinall & Marshek, Fundamentals of Machine Component Design, ch. 18. Validity: p·r constant; full rings."""
    return pack_force_at_rest / (2 * inner_radius * math.pi * (outer_radius - inner_radius))


UNIFORM_WEAR = {"peak_pressure": _peak_pressure}
