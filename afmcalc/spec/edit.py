"""A spec with one thing changed."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, TypeVar

from pydantic import BaseModel

from ..arrays import Values
from ..messages import say
from .models import Method, Spec
from .reading import make_spec
from .rules import foreign_keys
from .writing import resolved, written

_REPLACED = {
    "control_unit.gain": ("control_unit.wall_angle",),
    "control_unit.wall_angle": ("control_unit.gain",),
    "control_unit.gain_slope": ("control_unit.pocket",),
    "control_unit.pocket": ("control_unit.gain_slope",),
    "friction_group.mean_radius": (
        "friction_group.inner_radius",
        "friction_group.outer_radius",
        "friction_group.radius_model",
    ),
    "closing_spring.force": ("adjustment.nominal_torque",),
    "adjustment.nominal_torque": ("closing_spring.force", "control_spring.force"),
    "closing_spring.stiffness": ("closing_spring.disc", "closing_spring.coil"),
    "control_spring.stiffness": ("control_spring.disc", "control_spring.coil"),
    "friction.min": ("friction.material",),
    "friction.mean": ("friction.material",),
    "friction.max": ("friction.material",),
}
"""Key → keys it stands in for: where it is set, they are taken out of the spec."""

M = TypeVar("M", bound=BaseModel)


def value_at(spec: Spec, path: str) -> Any:
    """Return the value at ``path`` as given; None when absent."""
    value: Any = spec
    for part in path.split("."):
        value = getattr(value, part, None)
    return value


def replaced(spec: Spec, paths: Iterable[str]) -> dict[str, str]:
    """Return the keys of the spec that those at ``paths`` stand in for, each with the one that does."""
    given = set(paths)
    return {
        other: path
        for path in sorted(given)
        for other in _REPLACED.get(path, ())
        if other not in given and value_at(spec, other) is not None
    }


def put(data: dict[str, Any], path: str, value: Any) -> None:
    """Set a nested value; None removes it."""
    *blocks, name = path.split(".")
    for block in blocks:
        data = data.setdefault(block, {})
    if value is None:
        data.pop(name, None)
    else:
        data[name] = value


def with_value(model: M, path: Sequence[str], value: object) -> M:
    """Copy a spec with an unvalidated value (an array) at ``path``."""
    return with_values(model, [(path, value)])


def with_values(model: M, values: Iterable[tuple[Sequence[str], object]]) -> M:
    """Copy a spec with unvalidated values at several paths; each of its blocks is copied once."""
    update: dict[str, object] = {}
    below: dict[str, list[tuple[Sequence[str], object]]] = {}
    for (name, *rest), value in values:
        if rest:
            below.setdefault(name, []).append((rest, value))
        else:
            update[name] = value
    update |= {name: with_values(getattr(model, name), inner) for name, inner in below.items()}
    return model.model_copy(update=update)


def with_key(spec: Spec, path: str, value: Values) -> Spec:
    """Copy a spec with an unvalidated value (real, or an array) for a key, and without what the key stands in for."""
    return with_value(_without_replaced(spec, [path]), path.split("."), value)


def respecified(spec: Spec, values: Mapping[str, object]) -> Spec:
    """Return the validated spec with other values of some keys, None for none, and without what they stand in for.

    Raises:
        SpecError: a value no spec may have.
    """
    given = [path for path, value in values.items() if value is not None]
    data = _without_replaced(spec, given).model_dump(exclude_none=True)
    for path, value in values.items():
        put(data, path, value)
    return make_spec(data, spec.label.but(values))


def _without_replaced(spec: Spec, paths: Iterable[str]) -> Spec:
    for other in replaced(spec, paths):
        if other == "friction.material":
            low, _, high = spec.friction.range
            spec = spec.model_copy(update={"friction": spec.friction.model_copy(update={"min": low, "max": high})})
        spec = with_value(spec, other.split("."), None)
    return spec


def as_written(spec: Spec) -> Spec:
    """Return the spec as it reads once it is written to a file: no number has more digits than count."""
    return make_spec(written(resolved(spec)), spec.label)


def as_variant(spec: Spec, variant: str) -> Spec:
    """Build the spec of the same pack as another variant: keys the variant does not have are left out.

    Raises:
        SpecError: the spec lacks what the variant needs.
    """
    data = resolved(spec)
    data["variant"] = variant
    for path in foreign_keys(data):
        put(data, ".".join(path), None)
    return make_spec(data, say("as {variant}", variant=variant))


def with_force(spec: Spec, force: float) -> Spec:
    """Return the spec with its spring set to a force."""
    return with_key(spec, "closing_spring.force", force)


def with_nominal_torque(spec: Spec, nominal_torque: float, method: Method | None = None) -> Spec:
    """Return the spec with its spring set for a nominal torque, by its own method or by another."""
    set_by = spec if method is None else with_value(spec, ("adjustment", "method"), method)
    return with_key(set_by, "adjustment.nominal_torque", nominal_torque)
