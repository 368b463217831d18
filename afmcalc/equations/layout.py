"""Rings that a clutch is made of (handbook, chapter 9)."""

from typing import Annotated

from .calls import equation
from .terms import *


@equation
def ring_inertia(
    mass: RingMass, outer_diameter: RingOuterDiameter, inner_diameter: RingInnerDiameter
) -> Annotated[Number, "J", "kg*m^2"]:
    """Moment of inertia of a ring about its axis, J = m (D² + d²)/8.

    Source: Geometry; handbook, chapter 9.
    Validity: Rectangular section, uniform density.
    """
    return mass * (outer_diameter * outer_diameter + inner_diameter * inner_diameter) / 8
