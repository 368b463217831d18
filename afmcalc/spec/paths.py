"""The keys of a spec, read off the models: paths, units, symbols."""

from functools import cache
from typing import NamedTuple, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from .fields import Quantity
from .models import Spec


class Key(NamedTuple):
    """One key of the spec."""

    path: str
    unit: str | None
    """SI unit of a number; None for text."""
    symbol: str | None
    description: str


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


def _block_of(field: FieldInfo) -> type[BaseModel] | None:
    """Return the model of a field that is a table, ``Model`` or ``Model | None``; a dictionary of models is none."""
    for candidate in (field.annotation, *get_args(field.annotation)):
        if isinstance(candidate, type) and issubclass(candidate, BaseModel):
            return None if get_origin(field.annotation) is dict else candidate
    return None


def quantity_at(path: str) -> Quantity | None:
    """Return what the number at a dotted path may be; None for text."""
    *blocks, name = path.split(".")
    model: type[BaseModel] = Spec
    for block in blocks:
        found = _block_of(model.model_fields[block])
        assert found is not None
        model = found
    return _quantity(model.model_fields[name])


def _quantity(field: FieldInfo) -> Quantity | None:
    nested = (item for part in get_args(field.annotation) for item in getattr(part, "__metadata__", ()))
    return next((item for item in (*field.metadata, *nested) if isinstance(item, Quantity)), None)


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
        symbol, about = extra.get("symbol"), _quantity(field)
        found[path] = Key(path, about.unit if about else None, str(symbol) if symbol else None, field.description or "")
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


def is_whole(path: str) -> bool:
    """Whether the key counts something."""
    return path in keys() and (about := quantity_at(path)) is not None and about.whole
