"""The keys of a spec, read off the models: paths, units, symbols."""

import math
from functools import cache
from typing import Any, NamedTuple, get_args, get_origin

from annotated_types import Ge, Gt
from pydantic import BaseModel
from pydantic.fields import FieldInfo

from .fields import unit_of
from .models import Deferred, Spec


class Key(NamedTuple):
    """One key of the spec."""

    path: str
    unit: str | None
    """SI unit of a number; None for text."""
    symbol: str | None
    description: str
    whole: bool = False
    """Whether it counts something."""


ALIASES = {
    "C": "control_unit.gain",
    "z": "friction_group.pairs",
    "z1": "friction_group.driving_pairs",
    "R": "friction_group.mean_radius",
    "F": "closing_spring.force",
    "f_min": "friction.min",
    "f_cp": "friction.mean",
    "f_mean": "friction.mean",
    "f_max": "friction.max",
    "c1": "closing_spring.stiffness",
    "c2": "control_spring.stiffness",
    "beta": "adjustment.margin",
    "T_n": "adjustment.nominal_torque",
    "r": "control_unit.ball_circle_radius",
    "alpha": "control_unit.wall_angle",
    "f1": "control_unit.key_friction",
    "d": "control_unit.hub_diameter",
}
"""Symbols that stand for a path on the command line."""


def _block(annotation: Any) -> type[BaseModel] | None:
    """Return the model class in ``Model`` or ``Model | None``; a dictionary of models is none."""
    if get_origin(annotation) is dict:
        return None
    for candidate in (annotation, *get_args(annotation)):
        if isinstance(candidate, type) and issubclass(candidate, BaseModel):
            return candidate
    return None


def _block_of(field: FieldInfo) -> type[BaseModel] | None:
    """Return the model of a field that is a table."""
    for item in field.metadata:
        if isinstance(item, Deferred):
            return item.model()
    return _block(field.annotation)


def field_metadata(path: str) -> list[Any]:
    """Everything noted in the annotation of the key at a dotted path."""
    *blocks, name = path.split(".")
    model: type[BaseModel] = Spec
    for block in blocks:
        found = _block_of(model.model_fields[block])
        assert found is not None
        model = found
    field = model.model_fields[name]
    nested = [item for part in get_args(field.annotation) for item in getattr(part, "__metadata__", ())]
    return [*field.metadata, *nested]


def _unit(annotation: Any, metadata: list[Any]) -> str | None:
    if found := unit_of(metadata):
        return found
    for candidate in get_args(annotation):
        if found := unit_of(list(getattr(candidate, "__metadata__", ()))):
            return found
    return None


def _is_int(annotation: Any) -> bool:
    """Whether the type is ``int``, also as one that may be left out."""
    return annotation is int or any(_is_int(part) for part in get_args(annotation))


@cache
def keys(model: type[BaseModel] = Spec, prefix: str = "") -> dict[str, Key]:
    """Every value key below ``model`` by dotted path."""
    found: dict[str, Key] = {}
    for name, field in model.model_fields.items():
        path = prefix + name
        if block := _block_of(field):
            found |= keys(block, path + ".")
            continue
        extra = field.json_schema_extra if isinstance(field.json_schema_extra, dict) else {}
        symbol = extra.get("symbol")
        unit = _unit(field.annotation, field.metadata)
        symbol_text = str(symbol) if symbol else None
        found[path] = Key(path, unit, symbol_text, field.description or "", _is_int(field.annotation))
    return found


def names_in(path: tuple[str, ...], root: type[BaseModel] = Spec) -> list[str]:
    """Return the names allowed in the block at ``path``."""
    model = root
    for name in path:
        field = model.model_fields.get(name)
        block = _block_of(field) if field else None
        if block is None:
            return []
        model = block
    return list(model.model_fields)


def least(path: str) -> tuple[float, bool]:
    """Return the bound of the key from below, and whether it is itself allowed."""
    noted = field_metadata(path)
    noted += [inner for item in noted if isinstance(item, FieldInfo) for inner in item.metadata]
    for bound in noted:
        if isinstance(bound, Gt):
            return float(str(bound.gt)), False
        if isinstance(bound, Ge):
            return float(str(bound.ge)), True
    return -math.inf, False


def is_whole(path: str) -> bool:
    """Whether the key counts something."""
    return keys()[path].whole
