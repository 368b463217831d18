"""Changes of a spec: overrides of its data, ``path=value`` or a mapping; other values of some keys of a whole one."""

import json
import tomllib
from collections.abc import Collection, Iterable, Mapping
from typing import Any, TypeAlias, TypeVar

from pydantic import BaseModel

from ..equations.arrays import Values
from ..errors import AfmcalcError
from ..messages import did_you_mean, say
from .fields import names_in
from .keys import elsewhere, names, path_of
from .make import make_spec
from .models import Spec, resolved
from .parse import check_size, too_deep
from .removed import instead_of
from .rules import foreign_keys, given_in
from .search import flat
from .write import written

Overrides: TypeAlias = Collection[str] | Mapping[str, object]
"""Texts ``path=value``, an empty value removes the key; or path → value, None removes it."""

_REPLACED = {
    "control_unit.gain": ("control_unit.wall_angle",),
    "control_unit.wall_angle": ("control_unit.gain",),
    "control_unit.gain_slope": ("control_unit.pocket",),
    "control_unit.pocket": ("control_unit.gain_slope",),
    "friction_group.mean_radius": (
        "friction_group.inner_radius", "friction_group.outer_radius", "friction_group.radius_model",
    ),
    "closing_spring.force": ("adjustment.nominal_torque",),
    "adjustment.nominal_torque": ("closing_spring.force", "control_spring.force"),
    "closing_spring.stiffness": ("closing_spring.disc", "closing_spring.coil"),
    "control_spring.stiffness": ("control_spring.disc", "control_spring.coil"),
    "fatigue.polar_section_modulus": ("shaft",),
    "shaft.diameter": ("fatigue.polar_section_modulus",),
    **{f"friction.{end}": ("friction.material",) for end in ("min", "mean", "max")},
    **{
        f"friction.{group}.{end}": (f"friction.{group}.material",)
        for group in ("driving", "driven")
        for end in ("min", "mean", "max")
    },
}  # fmt: skip
"""Key → keys it stands in for: where it is set, they are taken out of the spec."""

_SEARCH = "search."

M = TypeVar("M", bound=BaseModel)


def put(data: dict[str, Any], path: str, value: Any) -> None:
    """Set a nested value, None removes it; a ``ValueError`` has the path of a block on the way that is no table."""
    *blocks, name = path.split(".")
    for depth, block in enumerate(blocks, start=1):
        data = data.setdefault(block, {})
        if not isinstance(data, dict):
            raise ValueError(".".join(blocks[:depth]))
    if value is None:
        data.pop(name, None)
    else:
        data[name] = value


def apply_overrides(data: dict[str, object], overrides: Overrides) -> dict[str, object]:
    """Apply overrides to parsed data; return the dotted paths that they name, each with its value."""
    pairs: Iterable[tuple[str, object]]
    if isinstance(overrides, Mapping):
        pairs = (  # of NumPy its own numbers
            (f"{name}={value}", value.tolist() if hasattr(value, "tolist") else value)
            for name, value in overrides.items()
        )
    else:
        pairs = ((override, _value(override)) for override in overrides)
    changed: dict[str, object] = {}
    for override, value in pairs:
        path = _path(override)
        if path.startswith(_SEARCH) and isinstance(table := data.setdefault("search", {}), dict):
            data["search"] = dict(flat(table)) | {path.removeprefix(_SEARCH): value}
            changed[path] = value
            continue
        try:
            put(data, path, value)
        except ValueError as error:
            path = str(error)
            raise AfmcalcError("--set {override:.80}: {path} is no table", override=override, path=path) from None
        changed[path] = value
    return changed


def key_of(override: str) -> str:
    """Return the key of an override as given; refuse where there is no equals sign, or nothing before it."""
    given, separator, _ = override.partition("=")
    if not separator or not given.strip():
        raise AfmcalcError(
            "--set {override:.80}: write PATH=VALUE, both and the equals sign in one word, for example "
            "control_unit.gain=0.5",
            override=override,
        )
    return given.strip()


def _path(override: str) -> str:
    """Path of the key that an override gives by path, name or symbol."""
    given = key_of(override)
    if given.startswith(_SEARCH):
        name = given.removeprefix(_SEARCH)
        return _SEARCH + (path_of(name) or name)
    path = path_of(given) or given
    *blocks, last = path.split(".")
    known = names_in(blocks, Spec)
    if last not in known:
        hint = instead_of(path) or did_you_mean(last, known)
        hint = hint or elsewhere(last) or did_you_mean(last, names())
        if known and not hint:
            hint = say("; known here: {names}", names=", ".join(known))
        raise AfmcalcError(
            "--set {override:.80}: unknown key {path!r:.80}{hint}", override=override, path=path, hint=hint
        )
    return path


def _value(override: str) -> object:
    """Read a number, boolean, quoted string or inline table as TOML, anything else as plain text; nothing is None."""
    text = override.partition("=")[2].strip()
    if not text:
        return None
    try:
        read = tomllib.loads(f"value = {text}")
    except tomllib.TOMLDecodeError:
        return text
    except RecursionError:
        raise AfmcalcError("--set {override:.80}: {why}", override=override, why=too_deep()) from None
    except ValueError:
        raise AfmcalcError("--set {override:.80}: a number has too many digits", override=override) from None
    if set(read) != {"value"}:  # further lines are part of the text
        return text
    check_size(read["value"], say("--set {override:.80}", override=override))
    return read["value"]


def as_override(value: object) -> str:
    """Return the text that an override has for a value.

    >>> as_override("2 kN"), as_override("0.5"), as_override(True), as_override(["a", 1])
    ('2 kN', '"0.5"', 'true', '["a", 1]')
    """
    if isinstance(value, str) and value.strip() == value != "" and _value(f"={value}") == value:
        return value
    # what JSON writes of a text, a number, a truth value or a list is TOML
    return json.dumps(value, ensure_ascii=False)


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
