"""Field types of the spec, SI numbers that also accept a string with a unit; and the keys of its models."""

from abc import abstractmethod
from collections.abc import Iterable, Sequence
from functools import cache
from typing import Annotated, Any, Literal, NamedTuple, Self, get_args, get_origin

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, ValidationError, model_validator
from pydantic.fields import FieldInfo

from ..messages import say
from .quantity import Quantity, positive

Broken = tuple[str, str]
"""Violation of a rule: dotted path of the key, relative to the table, and message."""


def rule_error(broken: Iterable[Broken], others: ValidationError | None = None) -> ValidationError:
    """Pydantic's error with the violations of rules, after the errors that pydantic itself found."""
    lines: list[Any] = [*others.errors(include_url=False)] if others else []
    lines += [
        {"type": "value_error", "loc": tuple(path.split(".")), "input": None, "ctx": {"error": ValueError(message)}}
        for path, message in broken
    ]
    return ValidationError.from_exception_data("spec", lines)


def greater(name: str, value: float | None, other: str, least: float | None) -> Iterable[Broken]:
    """Yield the broken rule: a length must exceed another length, if both lengths are given."""
    if value is not None and least is not None and value <= least:
        yield name, say("must be greater than {other} ({least:g} m)", other=other, least=least)


class Block(BaseModel):
    """Base class of every table of a spec."""

    # validators of blocks are built only within the validator of Spec: separate ones would double the start-up time
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, defer_build=True)


class RuledBlock(Block):
    """A table with rules between its keys."""

    @abstractmethod
    def broken_rules(self) -> Iterable[Broken]:
        """Violations of the rules of the table."""

    @model_validator(mode="after")
    def _hold_to_rules(self) -> Self:
        if broken := [*self.broken_rules()]:
            raise rule_error(broken)
        return self


def key(description: str, symbol: str | None = None, default: Any = None, **bounds: Any) -> Any:
    """Field of a key: description, symbol in the papers, default, bounds of a plain type."""
    extra: dict[str, Any] | None = {"symbol": symbol} if symbol else None
    return Field(default=default, description=description, json_schema_extra=extra, **bounds)


def required(description: str, symbol: str | None = None, **bounds: Any) -> Any:
    """Field of a key that must be given; arguments as ``key``."""
    return key(description, symbol, ..., **bounds)


_LONGEST = 1_000
"""Largest number of characters of a name."""


def _one_line(value: object) -> object:
    """Raise an error unless a text is one line of printable characters, as it is printed and written unchanged."""
    if isinstance(value, str) and not (value.isprintable() and len(value) <= _LONGEST):
        raise ValueError(say("must be one line of at most {most:,} printable characters", most=_LONGEST))
    return value


Torque = Annotated[float, positive("N*m")]
Coefficient = Annotated[float, positive("1")]
Length = Annotated[float, positive("m")]
Stress = Annotated[float, positive("Pa")]
Name = Annotated[str, BeforeValidator(_one_line)]


class Key(NamedTuple):
    """One key of the spec."""

    path: str
    symbol: str | None
    description: str
    about: Quantity | None = None
    """Unit and bounds of a number; None for text."""

    @property
    def unit(self) -> str | None:
        """SI unit of a number; None for text."""
        return self.about.unit if self.about else None


@cache
def keys_below(model: type[BaseModel], prefix: str = "") -> dict[str, Key]:
    """All keys with values (not tables) below a model, by dotted path."""
    keys: dict[str, Key] = {}
    for name, field in model.model_fields.items():
        path = prefix + name
        extra = field.json_schema_extra
        symbol: Any = extra.get("symbol") if isinstance(extra, dict) else None
        if not (block := _block_of(field)):
            keys[path] = Key(path, symbol, field.description or "", _quantity(field))
            continue
        # f_min in a table with the symbol f_1 becomes f_1min
        letter = f"{(symbol or '').partition('_')[0]}_"
        for each, key in keys_below(block, path + ".").items():
            own = key.symbol.replace(letter, symbol) if symbol and key.symbol else key.symbol
            keys[each] = key._replace(symbol=own)
    return keys


def names_in(path: Sequence[str], model: type[BaseModel]) -> list[str]:
    """Names of the keys and tables in the block at ``path``; empty if there is no such block."""
    block = block_at(path, model)
    return list(block.model_fields) if block else []


def block_at(path: Sequence[str], model: type[BaseModel]) -> type[BaseModel] | None:
    """Model of the block at ``path``; None if there is no such block."""
    block: type[BaseModel] | None = model
    for name in path:
        field = block.model_fields.get(name) if block else None
        block = _block_of(field) if field else None
    return block


def _block_of(field: FieldInfo) -> type[BaseModel] | None:
    """Model of a field that is a table, ``Model`` or ``Model | None``; None for other fields (dictionaries as well)."""
    kinds = [] if get_origin(field.annotation) is dict else [field.annotation, *get_args(field.annotation)]
    return next((kind for kind in kinds if isinstance(kind, type) and issubclass(kind, BaseModel)), None)


def _quantity(field: FieldInfo) -> Quantity | None:
    nested = (item for part in get_args(field.annotation) for item in getattr(part, "__metadata__", ()))
    return next((item for item in (*field.metadata, *nested) if isinstance(item, Quantity)), None)


def words_of(annotation: Any) -> list[str]:
    """Words allowed as a value of a type; empty if it is not restricted to a few words."""
    parts = get_args(annotation)
    return [*parts] if get_origin(annotation) is Literal else [word for part in parts for word in words_of(part)]
