"""The keys of a model of the spec, read off its fields: paths, units, bounds, symbols."""

from functools import cache
from typing import NamedTuple, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from .fields import Quantity


class Key(NamedTuple):
    """One key of the spec."""

    path: str
    unit: str | None
    """SI unit of a number; None for text."""
    symbol: str | None
    description: str
    about: Quantity | None = None
    """What a number may be; None for text."""


@cache
def keys_below(model: type[BaseModel], prefix: str = "") -> dict[str, Key]:
    """Every value key below ``model`` by dotted path."""
    found: dict[str, Key] = {}
    for name, field in model.model_fields.items():
        path = prefix + name
        if block := _block_of(field):
            found |= keys_below(block, path + ".")
            continue
        extra = field.json_schema_extra if isinstance(field.json_schema_extra, dict) else {}
        symbol, about = extra.get("symbol"), _quantity(field)
        unit = about.unit if about else None
        found[path] = Key(path, unit, str(symbol) if symbol else None, field.description or "", about)
    return found


def names_in(path: tuple[str, ...], model: type[BaseModel]) -> list[str]:
    """Return the names allowed in the block at ``path``."""
    block = _model_at(path, model)
    return list(block.model_fields) if block else []


def choices_at(path: tuple[str, ...], model: type[BaseModel]) -> list[str]:
    """Return the words that the key at ``path`` may be; none where it is no choice of words."""
    block = _model_at(path[:-1], model)
    return [*block.model_json_schema()["properties"][path[-1]].get("enum", ())] if block else []


def _model_at(path: tuple[str, ...], model: type[BaseModel]) -> type[BaseModel] | None:
    """Return the model of the block at ``path``."""
    for name in path:
        field = model.model_fields.get(name)
        block = _block_of(field) if field else None
        if block is None:
            return None
        model = block
    return model


def _block_of(field: FieldInfo) -> type[BaseModel] | None:
    """Return the model of a field that is a table, ``Model`` or ``Model | None``; a dictionary of models is none."""
    for candidate in (field.annotation, *get_args(field.annotation)):
        if isinstance(candidate, type) and issubclass(candidate, BaseModel):
            return None if get_origin(field.annotation) is dict else candidate
    return None


def _quantity(field: FieldInfo) -> Quantity | None:
    nested = (item for part in get_args(field.annotation) for item in getattr(part, "__metadata__", ()))
    return next((item for item in (*field.metadata, *nested) if isinstance(item, Quantity)), None)
