"""Geometry of the friction surface."""

from typing import Annotated

from .calls import equation
from .terms import *


@equation
def mean_radius_uniform_wear(inner_radius: InnerRadius, outer_radius: OuterRadius) -> MeanRadius:
    """Mean friction radius at uniform wear (p·r constant), (r_i + r_o)/2.

    Source: Juvinall & Marshek, Fundamentals of Machine Component Design, ch. 18.
    Validity: 0 < r_i < r_o; discs worn in.

    >>> mean_radius_uniform_wear(0.5, 1.5)
    1.0
    """
    return (inner_radius + outer_radius) / 2


@equation
def mean_radius_uniform_pressure(inner_radius: InnerRadius, outer_radius: OuterRadius) -> MeanRadius:
    """Mean friction radius at uniform pressure, ⅔ (r_o³ − r_i³)/(r_o² − r_i²).

    Source: Juvinall & Marshek, Fundamentals of Machine Component Design, ch. 18.
    Validity: 0 < r_i < r_o; new, stiff discs.
    """
    return 2 * (outer_radius**3 - inner_radius**3) / (3 * (outer_radius**2 - inner_radius**2))


@equation
def mean_pressure(
    force: AxialForce, inner_radius: InnerRadius, outer_radius: OuterRadius, pi: Pi
) -> Annotated[Number, Term("p", "", "Pa")]:
    """Mean surface pressure of a ring, F/(π (r_o² − r_i²)).

    Source: Juvinall & Marshek, Fundamentals of Machine Component Design, ch. 18.
    Validity: Full rings; grooves and sectors raise it.
    """
    return force / (pi * (outer_radius**2 - inner_radius**2))


@equation
def peak_pressure_uniform_wear(
    force: AxialForce, inner_radius: InnerRadius, outer_radius: OuterRadius, pi: Pi
) -> Annotated[Number, Term("p_i", "at the inner edge", "Pa")]:
    """Surface pressure at the inner edge with uniform wear, F/(2 π r_i (r_o − r_i)).

    Source: Juvinall & Marshek, Fundamentals of Machine Component Design, ch. 18.
    Validity: p·r constant; full rings.
    """
    return force / (2 * pi * inner_radius * (outer_radius - inner_radius))
