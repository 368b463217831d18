"""Specs with other values of some keys, and their text: the original text with its comments and order."""

import json
import os
import re
from collections.abc import Iterable, Mapping
from os import PathLike
from typing import Any, TypeVar

from pydantic import BaseModel

from ..equations.arrays import Values
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
"""Key → other keys that are removed from the spec when the key is set."""

M = TypeVar("M", bound=BaseModel)


def value_at(spec: Spec, path: str) -> Any:
    """Value at a dotted path as given; None if the spec does not give it."""
    value: Any = spec
    for part in path.split("."):
        value = getattr(value, part, None)
    return value


def replaced(spec: Spec, paths: Iterable[str]) -> dict[str, str]:
    """Path of a replaced key of the spec → key among ``paths`` that replaces it."""
    given = set(paths)
    return {
        other: path
        for path in sorted(given)
        for other in _REPLACED.get(path, "").split()
        if other not in given and value_at(spec, other) is not None
    }


def _instead(spec: Spec, paths: Iterable[str]) -> dict[str, object]:
    """Values to set with the keys at ``paths``: None for replaced keys, numbers for the friction of a material."""
    values: dict[str, object] = dict.fromkeys(replaced(spec, paths))
    for material in [path for path in values if path.endswith(".material")]:
        group = material.removesuffix(".material")
        values[f"{group}.min"], _, values[f"{group}.max"] = value_at(spec, group).range
    return values


def with_values(model: M, values: Mapping[str, object]) -> M:
    """Copy of a spec with unvalidated values (numbers, arrays, None) at some paths."""
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
    """Copy of a spec with an unvalidated value (number or array) of a key, without the keys that the key replaces."""
    return with_values(spec, {**_instead(spec, [path]), path: value})


def respecified(spec: Spec, values: Mapping[str, object]) -> Spec:
    """Validated spec with other values of some keys (None removes a key), without the keys that these replace."""
    given = [path for path, value in values.items() if value is not None]
    data = with_values(spec, _instead(spec, given)).model_dump(exclude_none=True)
    for path, value in values.items():
        put(data, path, value)
    return make_spec(data, spec.label.but(values))


def as_written(spec: Spec) -> Spec:
    """Spec as read back from its file: numbers rounded to the digits that are written."""
    return make_spec(written(resolved(spec)), spec.label)


def candidate(spec: Spec, changes: Mapping[str, Any]) -> Spec:
    """Spec with the ``changes`` (path → value), without [search] and without keys foreign to its variant.

    Raises SpecError if the changed spec is invalid.
    """
    foreign = foreign_keys({**given_in(spec.model_dump()), **changes}, changes.get("variant", spec.variant))
    return respecified(spec, {**changes, "search": None, **dict.fromkeys(foreign)})


def saved(spec: Spec, changes: Mapping[str, Any], changed: Spec, path: str | PathLike[str]) -> str:
    """Text of ``spec`` with other values of some keys.

    A spec read from TOML keeps its comments, its order and the units of unchanged values, unless the new file is JSON;
    any other spec is written anew.

    ``changes``: path → value, None to remove the key; ``changed``: the spec with these values; ``path``: the new file,
    to whose folder paths of catalogues become relative.
    """
    source = spec.label
    if os.fspath(path).lower().endswith(".json"):
        return json.dumps(resolved(changed), indent=2, ensure_ascii=False) + "\n"
    if not source.text or is_json(source):
        return to_toml(resolved(changed))
    import tomlkit

    # comments above a heading are moved behind it meanwhile, since tomlkit takes them for the end of the table before
    text = source.text.replace("\r\n", "\n")
    above = r"(?m)^((?:[ \t]*\n){0,20}(?:[ \t]*#.*\n){0,20})([ \t]*\[.*)$"
    folded = re.sub(above, lambda part: part[2] + f"#\ue000{part[1]}".replace("\n", "\ue001"), text)
    document = tomlkit.parse(folded)
    overridden = {path: value_at(changed, path) for path in source.overridden}
    listed = spec.catalogues.model_dump(exclude_none=True) if spec.catalogues else {}
    lists = {f"catalogues.{name}": os.path.relpath(file, os.path.dirname(path) or ".") for name, file in listed.items()}
    changed_values = {path: value for path, value in changes.items() if value != value_at(spec, path)}
    values = {**overridden, **_instead(spec, changes), **changed_values, **lists}
    for path, value in values.items():
        put(document, path, None if value is None else in_units(value, path))
    for path in foreign_keys(given_in(document.unwrap()), changed.variant):
        put(document, path, None)
    changed_text = tomlkit.dumps(document).rstrip() + (text[len(text.rstrip()) :] or "\n")
    parts = r"(?m)(?:^\n)?^(.*)#\ue000(.*)$"
    unfolded = re.sub(parts, lambda part: part[2].replace("\ue001", "\n") + part[1], changed_text)
    return unfolded.replace("\n", "\r\n") if "\r\n" in source.text else unfolded


def in_units(value: Any, path: str) -> Any:
    """Value of a key as written in a file, with its unit."""
    value = value.model_dump(exclude_none=True) if isinstance(value, BaseModel) else value
    key = keys().get(path)
    return written(value, path) if isinstance(value, Mapping) else value_as_written(value, key and key.unit)
