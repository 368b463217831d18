"""A spec with one thing changed."""

from collections.abc import Sequence
from typing import Any

from .models import Spec
from .reading import make_spec
from .rules import foreign_keys
from .writing import resolved

ALTERNATIVES = {
    "control_unit.gain": ("control_unit.wall_angle",),
    "control_unit.wall_angle": ("control_unit.gain",),
    "friction_group.mean_radius": (
        "friction_group.inner_radius",
        "friction_group.outer_radius",
        "friction_group.radius_model",
    ),
    "adjustment.nominal_torque": ("closing_spring.force",),
    "friction.min": ("friction.material",),
    "friction.mean": ("friction.material",),
    "friction.max": ("friction.material",),
}
"""Keys that a swept key stands in for: they are taken out of the spec."""


def value_at(spec: Spec, path: str) -> Any:
    """Return the value at ``path`` as given; None when absent."""
    value: Any = spec
    for part in path.split("."):
        value = getattr(value, part, None)
    return value


def put(data: dict[str, Any], path: str, value: Any) -> None:
    """Set a nested value; None removes it."""
    *blocks, name = path.split(".")
    for block in blocks:
        data = data.setdefault(block, {})
    if value is None:
        data.pop(name, None)
    else:
        data[name] = value


def with_value(model: Any, path: Sequence[str], value: Any) -> Any:
    """Copy a spec with an unvalidated value (an array) at ``path``."""
    name, *rest = path
    return model.model_copy(update={name: with_value(getattr(model, name), rest, value) if rest else value})


def as_variant(spec: Spec, variant: str) -> Spec:
    """Build the spec of the same pack as another variant: keys the variant does not have are left out.

    Raises:
        SpecError: the spec lacks what the variant needs.
    """
    data = resolved(spec)
    data["variant"] = variant
    for path in foreign_keys(data):
        block = data
        for part in path[:-1]:
            block = block[part]
        block.pop(path[-1])
    return make_spec(data, f"as {variant}")


def with_force(spec: Spec, force: float) -> Spec:
    """Return the spec with its spring set to a force."""
    return spec.model_copy(
        update={
            "closing_spring": spec.closing_spring.model_copy(update={"force": force}),
            "adjustment": spec.adjustment.model_copy(update={"nominal_torque": None}),
        }
    )


def with_nominal_torque(spec: Spec, nominal_torque: float) -> Spec:
    """Return the spec with its spring set for a nominal torque."""
    return spec.model_copy(
        update={
            "closing_spring": spec.closing_spring.model_copy(update={"force": None}),
            "adjustment": spec.adjustment.model_copy(update={"nominal_torque": nominal_torque}),
        }
    )
