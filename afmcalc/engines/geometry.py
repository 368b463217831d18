"""Mean radius and feedback gain from what a spec gives."""

import math
from typing import Any

from ..equations import direct, geometry
from ..spec.models import Spec
from ._arrays import tangent

_MEAN_RADIUS = {
    "uniform-wear": geometry.mean_radius_uniform_wear,
    "uniform-pressure": geometry.mean_radius_uniform_pressure,
}


def mean_radius(spec: Spec) -> Any:
    """R_cp, given or from the two radii."""
    group = spec.friction_group
    if group.mean_radius is not None:
        return group.mean_radius
    return _MEAN_RADIUS[group.radius_model or "uniform-wear"](group.inner_radius, group.outer_radius)


def feedback_gain(spec: Spec) -> Any:
    """C, given or from the wall angle; 0 without a control unit."""
    unit = spec.control_unit
    if unit is None:
        return 0.0
    if unit.gain is not None:
        return unit.gain
    return direct.gain(mean_radius(spec), unit.ball_circle_radius, tangent(unit.wall_angle))


def gain_elasticities(spec: Spec, in_gain: float) -> dict[str, float]:
    """Elasticities by the spec keys behind C, from the one in C (chain rule; C ∝ R tan α/r)."""
    unit = spec.control_unit
    if unit is None:
        return {"friction_group.mean_radius": 0.0}
    if unit.wall_angle is None:
        return {"control_unit.gain": in_gain, "friction_group.mean_radius": 0.0}
    return {
        "control_unit.wall_angle": in_gain * _tangent_elasticity(unit.wall_angle),
        "control_unit.ball_circle_radius": -in_gain,
        "friction_group.mean_radius": in_gain,
    }


def _tangent_elasticity(angle: float) -> float:
    """Return d ln tan α/d ln α = 2α/sin 2α, 1 at α = 0."""
    return 2 * angle / math.sin(2 * angle) if angle else 1.0
