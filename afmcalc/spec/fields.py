"""Field types of the spec: SI numbers that also take a string with a unit; and the keys that its models have."""

import math
from abc import abstractmethod
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cache, partial
from typing import Annotated, Any, NamedTuple, Self, TypeAlias, get_args, get_origin

from pydantic import (
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
    ValidationError,
    model_validator,
)
from pydantic.fields import FieldInfo
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema, core_schema

from ..messages import say
from .quantity import parse_quantity, whole_number

Broken: TypeAlias = tuple[str, str]
"""A rule that a table breaks: dotted path of the key, below the table, and what is wrong."""


def rule_error(broken: Iterable[Broken], others: ValidationError | None = None) -> ValidationError:
    """Return pydantic's error for rules that a table breaks, beside what pydantic itself found in it."""
    lines: list[Any] = [*others.errors(include_url=False)] if others else []
    lines += [
        {"type": "value_error", "loc": tuple(path.split(".")), "input": None, "ctx": {"error": ValueError(message)}}
        for path, message in broken
    ]
    return ValidationError.from_exception_data("spec", lines)


class Block(BaseModel):
    """Base of every table of a spec."""

    # only Spec is ever built on its own: building each block too would double the start-up time
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, defer_build=True)


class RuledBlock(Block):
    """A table with rules between its keys."""

    @abstractmethod
    def broken_rules(self) -> Iterable[Broken]:
        """Rules that it breaks."""

    @model_validator(mode="after")
    def _hold_to_rules(self) -> Self:
        if broken := [*self.broken_rules()]:
            raise rule_error(broken)
        return self


def key(description: str, symbol: str | None = None, default: Any = None, **bounds: Any) -> Any:
    """A spec key: what it is, the papers' symbol, its default and the bounds of a plain type."""
    extra: dict[str, Any] | None = {"symbol": symbol} if symbol else None
    return Field(default=default, description=description, json_schema_extra=extra, **bounds)


def required(description: str, symbol: str | None = None, **bounds: Any) -> Any:
    """A spec key that must be given."""
    return key(description, symbol, ..., **bounds)


@dataclass(frozen=True)
class Quantity:
    """Unit and bounds of a number of a spec; stands in its annotation, where tables and sweeps find its unit."""

    unit: str
    """SI unit, a key of ``quantity.EXAMPLES``."""
    gt: float | None = None
    ge: float | None = None
    lt: float | None = None
    le: float | None = None
    whole: bool = False

    @property
    def limits(self) -> tuple[float, float]:
        """Ends of what is allowed, themselves in or out."""
        low, high = self.ge if self.gt is None else self.gt, self.le if self.lt is None else self.lt
        return -math.inf if low is None else float(low), math.inf if high is None else float(high)

    @property
    def read(self) -> Callable[[object], float]:
        """Function that reads a number in SI, or a string with a unit."""
        return whole_number if self.whole else partial(parse_quantity, unit=self.unit)

    # pydantic's own way, an annotation per step, would take three times as long at every start
    def __get_pydantic_core_schema__(self, source: object, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Validate: read, then hold to the bounds."""
        if self.whole:
            number: CoreSchema = core_schema.int_schema(ge=None if self.ge is None else int(self.ge))
        else:
            number = core_schema.float_schema(gt=self.gt, ge=self.ge, lt=self.lt, le=self.le)
        return core_schema.no_info_before_validator_function(self.read, number)

    def __get_pydantic_json_schema__(self, core: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Describe: a number, or a string where there is a unit to write."""
        number = handler(core)
        as_text = self.unit != "1" and handler.mode == "validation"
        return {"anyOf": [number, {"type": "string"}]} if as_text else number


def _one_line(value: object) -> object:
    """Refuse a text that is not one line of printable signs: it goes to terminals and files as it is."""
    if isinstance(value, str) and not value.isprintable():
        raise ValueError(say("must be one line of printable text, without control characters"))
    return value


Torque = Annotated[float, Quantity("N*m", gt=0)]
Name = Annotated[str, BeforeValidator(_one_line)]


class Key(NamedTuple):
    """One key of the spec."""

    path: str
    unit: str | None
    """SI unit of a number; None for text."""
    symbol: str | None
    description: str
    about: Quantity | None = None
    """Unit and bounds of a number; None for text."""


@cache
def keys_below(model: type[BaseModel], prefix: str = "") -> dict[str, Key]:
    """Every value key below ``model`` by dotted path."""
    keys: dict[str, Key] = {}
    for name, field in model.model_fields.items():
        path = prefix + name
        extra = field.json_schema_extra if isinstance(field.json_schema_extra, dict) else {}
        symbol, about = extra.get("symbol"), _quantity(field)
        if block := _block_of(field):
            below = keys_below(block, path + ".")
            # of the friction f_1 of a group f_1min is the smallest
            letter = f"{str(symbol or '').partition('_')[0]}_"
            for each, key in below.items():
                own = key.symbol.replace(letter, str(symbol)) if symbol and key.symbol else key.symbol
                keys[each] = key._replace(symbol=own)
            continue
        unit = about.unit if about else None
        keys[path] = Key(path, unit, str(symbol) if symbol else None, field.description or "", about)
    return keys


def names_in(path: Sequence[str], model: type[BaseModel]) -> list[str]:
    """Return the names allowed in the block at ``path``."""
    block = block_at(path, model)
    return list(block.model_fields) if block else []


def block_at(path: Sequence[str], model: type[BaseModel]) -> type[BaseModel] | None:
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
    of = (getattr(item, "about", item) for item in (*field.metadata, *nested))
    return next((item for item in of if isinstance(item, Quantity)), None)
