"""Warnings of values that are possible, but so unusual that a typing error is likely.

The ranges are no limits of a design: they are wide, and detect values typed in a wrong unit, such as mm for m.
"""

import math
from collections.abc import Iterator

from ..engines import Clutch
from ..errors import CalculationError
from ..findings import Finding, finding
from ..spec.catalogues import friction_materials
from ..spec.edit import value_at


def unusual(clutch: Clutch) -> Iterator[Finding]:
    """Yield a warning for each number outside its usual range."""
    linings = (clutch.spec.lists.materials or friction_materials()).values()
    least, most = min(lining.friction_min for lining in linings), max(lining.friction_max for lining in linings)
    for code, path, value, low, high in _figures(clutch):
        if not low * (1 - 1e-9) <= value <= high * (1 + 1e-9):
            limit = low if value < low else high
            yield finding(
                code, "warning", value=value, limit=limit, path=path, low=low, high=high, least=least, most=most
            )


def _figures(clutch: Clutch) -> Iterator[tuple[str, str, float, float, float]]:
    """Yield numbers of the design: code of the finding, key, value, and the ends of the usual range."""
    spec, radius = clutch.spec, clutch["mean_radius"]
    blocks = ("friction.driving", "friction.driven") if spec.friction.unlike else ("friction",)
    for path, friction in zip(blocks, spec.friction.groups, strict=False):
        # the papers use 0.1 to 0.8; outside are dry rubber and clean metal in a vacuum, neither is a friction lining
        yield "unusual/friction", f"{path}.min", friction.min, 0.02, 1.0
        yield "unusual/friction", f"{path}.max", friction.max, 0.02, 1.0
    yield "unusual/mean-radius", "friction_group.mean_radius", radius, 0.01, 1.0
    yield "unusual/pairs", "friction_group.pairs", spec.friction_group.pairs, 1, 40
    yield "unusual/margin", "adjustment.margin", spec.adjustment.margin, 1.0, 3.0
    # pressure on a full circular area of the mean radius; linings bear 0.05 to 2 MPa
    pressure = clutch["pack_force_at_rest"] / (math.pi * radius**2)
    yield "unusual/pressure", "closing_spring.force", pressure, 1e3, 5e6
    for name in ("closing", "control") if spec.kind.travels else ("closing",):
        key, force = f"{name}_spring.stiffness", clutch[f"{name}_force"]
        if stiffness := value_at(spec, key):
            deflection = force / stiffness
            if math.isinf(deflection):
                raise CalculationError(
                    "{key} = {stiffness:.5g N/m}: a spring as soft as that has {force:.5g N} at a deflection beyond "
                    "the range of numbers",
                    key=key,
                    stiffness=stiffness,
                    force=force,
                )
            # a spring with a larger deflection is longer than the clutch is wide
            yield "unusual/deflection", key, deflection, 0.0, 2 * radius
    if "ball_circle_radius" in clutch and clutch["gain"] > 0:
        path = "control_unit.wall_angle" if value_at(spec, "control_unit.gain") is None else "control_unit.gain"
        # the contact force is almost tangential at a smaller wall angle, almost axial at a larger angle
        yield "unusual/wall-angle", path, clutch["wall_angle"], math.radians(5), math.radians(60)
        circle = clutch["ball_circle_radius"]
        yield "unusual/ball-circle", "control_unit.ball_circle_radius", circle, 0.2 * radius, 2 * radius
