"""Mean radius and feedback gain from what a spec gives."""

import math

from ..arrays import Values, tangent
from ..equations import direct
from ..spec.models import FrictionRange, Spec

_MEAN_RADIUS = {
    "uniform-wear": direct.mean_radius_uniform_wear,
    "uniform-pressure": direct.mean_radius_uniform_pressure,
}


def mean_radius(spec: Spec) -> Values:
    """R_cp, given or from the two radii."""
    group = spec.friction_group
    if group.mean_radius is not None:
        return group.mean_radius
    found: Values = _MEAN_RADIUS[group.radius_model or "uniform-wear"](group.inner_radius, group.outer_radius)
    return found


def feedback_gain(spec: Spec) -> Values:
    """C, given or from the wall angle; 0 without a control unit."""
    unit = spec.control_unit
    if unit is None:
        return 0.0
    if unit.gain is not None:
        return unit.gain
    assert unit.wall_angle is not None
    found: Values = direct.gain(mean_radius(spec), unit.ball_circle_radius, tangent(unit.wall_angle))
    return found


def angle_given(spec: Spec) -> bool:
    """Whether the gain follows from a wall angle."""
    return spec.control_unit is not None and spec.control_unit.wall_angle is not None


def gain_path(spec: Spec) -> str:
    """Key of the spec that the gain follows from."""
    return "control_unit.wall_angle" if angle_given(spec) else "control_unit.gain"


def gain_elasticities(spec: Spec, in_gain: float, in_radius: float = 0.0) -> dict[str, float]:
    """Elasticities by the spec keys behind C, from the one in C (chain rule; C ∝ R tan α/r).

    ``in_radius`` is the elasticity in R at fixed C.
    """
    unit = spec.control_unit
    if unit is None:
        return _radius_elasticities(spec, in_radius)
    if unit.wall_angle is None:
        return {"control_unit.gain": in_gain, **_radius_elasticities(spec, in_radius)}
    return {
        "control_unit.wall_angle": in_gain * _tangent_elasticity(unit.wall_angle),
        "control_unit.ball_circle_radius": -in_gain,
        **_radius_elasticities(spec, in_gain + in_radius),
    }


def _radius_elasticities(spec: Spec, in_radius: float) -> dict[str, float]:
    """Elasticities by the radii a spec gives; R is homogeneous of degree 1 in the two, so theirs add up to R's."""
    group = spec.friction_group
    inner, outer = group.inner_radius, group.outer_radius
    if inner is None or outer is None:
        return {"friction_group.mean_radius": in_radius}
    if group.radius_model == "uniform-pressure":
        share = 2 * inner**2 / (outer**2 - inner**2) - 3 * inner**3 / (outer**3 - inner**3)
    else:
        share = inner / (inner + outer)
    return {
        "friction_group.inner_radius": in_radius * share,
        "friction_group.outer_radius": in_radius * (1 - share),
    }


def spread(found: dict[str, float], given: FrictionRange, path: str, end: str | None, elasticity: float) -> None:
    """Add an elasticity in one friction to the keys it follows; a mean that is not given moves with both ends."""
    if end is None or elasticity == 0:
        return
    shares = {end: 1.0}
    if end == "mean" and given.mean is None:
        own = given.range
        shares = {"min": own.min / (2 * own.mean), "max": own.max / (2 * own.mean)}
    for each, share in shares.items():
        found[f"{path}.{each}"] = found.get(f"{path}.{each}", 0.0) + share * elasticity


def force_path(spec: Spec) -> str:
    """Key of the spec that the force of the closing spring follows from."""
    return "closing_spring.force" if spec.closing_spring.force is not None else "adjustment.nominal_torque"


def _tangent_elasticity(angle: float) -> float:
    """Return d ln tan α/d ln α = 2α/sin 2α, 1 at α = 0."""
    return 2 * angle / math.sin(2 * angle) if angle else 1.0
