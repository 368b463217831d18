"""A spec with other values of some of its keys, and its text: the one that was read, its comments and order kept."""

import os
from collections.abc import Iterable, Mapping
from typing import Any, TypeVar

from pydantic import BaseModel

from ..equations.arrays import Values
from ..messages import say
from ..units import table
from ..variants import foreign_keys
from .keys import keys
from .models import Spec, resolved
from .parse import is_json
from .read import make_spec, put
from .rules import given_in
from .write import to_toml, value_as_written, written

_REPLACED = table("""\
control_unit.gain = control_unit.wall_angle; control_unit.wall_angle = control_unit.gain;
control_unit.gain_slope = control_unit.pocket; control_unit.pocket = control_unit.gain_slope;
friction_group.mean_radius = friction_group.inner_radius friction_group.outer_radius friction_group.radius_model;
closing_spring.force = adjustment.nominal_torque;
adjustment.nominal_torque = closing_spring.force control_spring.force;
closing_spring.stiffness = closing_spring.disc closing_spring.coil;
control_spring.stiffness = control_spring.disc control_spring.coil; fatigue.polar_section_modulus = shaft;
shaft.diameter = fatigue.polar_section_modulus; friction.min friction.mean friction.max = friction.material;
friction.driving.min friction.driving.mean friction.driving.max = friction.driving.material;
friction.driven.min friction.driven.mean friction.driven.max = friction.driven.material""")
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
        for other in _REPLACED.get(path, "").split()
        if other not in given and value_at(spec, other) is not None
    }


def without_replaced(spec: Spec, paths: Iterable[str]) -> Spec:
    """Return the spec without the keys that those at ``paths`` stand in for; friction of a material as numbers."""
    gone: dict[str, object] = dict.fromkeys(replaced(spec, paths))
    for material in [path for path in gone if path.endswith(".material")]:
        group = material.removesuffix(".material")
        gone[f"{group}.min"], _, gone[f"{group}.max"] = value_at(spec, group).range
    return with_values(spec, gone)


def with_values(model: M, values: Mapping[str, object]) -> M:
    """Copy a spec with unvalidated values (numbers, arrays, None) at some paths; each of its blocks is copied once."""
    update: dict[str, Any] = {}
    below: dict[str, dict[str, object]] = {}
    for path, value in values.items():
        name, _, rest = path.partition(".")
        if rest:
            below.setdefault(name, {})[rest] = value
        else:
            update[name] = value
    update |= {name: with_values(getattr(model, name), inner) for name, inner in below.items()}
    return model.model_copy(update=update)


def with_key(spec: Spec, path: str, value: Values) -> Spec:
    """Copy a spec with an unvalidated value (real, or an array) for a key, and without what the key stands in for."""
    return with_values(without_replaced(spec, [path]), {path: value})


def respecified(spec: Spec, values: Mapping[str, object]) -> Spec:
    """Return the validated spec with other values of some keys, None for none, and without what they stand in for."""
    given = [path for path, value in values.items() if value is not None]
    data = without_replaced(spec, given).model_dump(exclude_none=True)
    for path, value in values.items():
        put(data, path, value)
    return make_spec(data, spec.label.but(values))


def as_written(spec: Spec) -> Spec:
    """Return the spec as it reads once it is written to a file: no number has more digits than count."""
    return make_spec(written(resolved(spec)), spec.label)


def as_variant(spec: Spec, variant: str) -> Spec:
    """Build the spec of the same pack as another variant, without keys that it does not have, if nothing is lacking."""
    data = resolved(spec) | {"variant": variant}
    for path in foreign_keys(given_in(data), variant):
        put(data, path, None)
    return make_spec(data, say("as {variant}", variant=variant))


def with_nominal_torque(spec: Spec, nominal_torque: float) -> Spec:
    """Return the spec with its spring set for a nominal torque."""
    return with_key(spec, "adjustment.nominal_torque", nominal_torque)


def saved(spec: Spec, changes: Mapping[str, Any], changed: Spec, folder: str = "") -> str:
    """Return the text of ``spec`` with other values of some keys.

    What was read as TOML keeps comments, order and the units of what stays; any other text is written anew.

    Args:
        spec: as it was read.
        changes: path → value, None for none.
        changed: the spec with these values.
        folder: where the text will be: its catalogues are relative to it.
    """
    source = spec.label
    if not source.text or is_json(source):
        return to_toml(resolved(changed))
    import tomlkit

    document = tomlkit.parse(source.text)
    overridden = {path: value_at(changed, path) for path in source.overridden}
    gone = dict.fromkeys(replaced(spec, changes))
    listed = spec.catalogues.model_dump(exclude_none=True) if spec.catalogues else {}
    lists = {f"catalogues.{name}": os.path.relpath(file, folder or ".") for name, file in listed.items()}
    changed_values = {path: value for path, value in changes.items() if value != value_at(spec, path)}
    values = {**overridden, **gone, **changed_values, **lists}
    for path, value in values.items():
        _put(document, path, value)
    for path in foreign_keys(given_in(document.unwrap()), changed.variant):
        _put(document, path, None)
    return tomlkit.dumps(document).rstrip() + "\n"


def _put(document: Any, path: str, value: Any) -> None:
    """Set a value in a document, or take it out; comments beside it stay."""
    *blocks, name = path.split(".")
    table = document
    for block in blocks:
        if block not in table:
            if value is None:
                return
            table[block] = {}
        table = table[block]
    if value is None:
        table.pop(name, None)
    else:
        table[name] = in_units(value, path)


def in_units(value: Any, path: str) -> Any:
    """Return the value of a key as a file has it: with its unit."""
    value = value.model_dump(exclude_none=True) if isinstance(value, BaseModel) else value
    key = keys().get(path)
    return written(value, path) if isinstance(value, Mapping) else value_as_written(value, key and key.unit)
