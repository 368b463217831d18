"""Field types of the spec: SI numbers that also take a string with a unit."""

from dataclasses import dataclass
from typing import Annotated, TypeVar

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema, core_schema

from ..messages import say
from .quantity import parse_quantity


class Block(BaseModel):
    """Base of every table of a spec."""

    # only Spec is ever built on its own: building each block too would double the start-up time
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, defer_build=True)


T = TypeVar("T")


def key_field(description: str, symbol: str | None = None, default: T = None) -> T:  # type: ignore[assignment]
    """A spec key: its default, what it is and the papers' symbol."""
    return Field(default=default, description=description, json_schema_extra={"symbol": symbol} if symbol else None)


@dataclass(frozen=True)
class Quantity:
    """What a number of a spec may be; stands in its annotation, so that tables and sweeps find its unit there."""

    unit: str
    """SI unit, a key of ``units.EXAMPLES``."""
    gt: float | None = None
    ge: float | None = None
    lt: float | None = None
    le: float | None = None
    whole: bool = False

    @property
    def low(self) -> float | None:
        """Lower end of what is allowed, itself in or out."""
        return self.ge if self.gt is None else self.gt

    @property
    def high(self) -> float | None:
        """Upper end."""
        return self.le if self.lt is None else self.lt

    def read(self, value: object) -> float:
        """Read a number in SI, or a string with a unit."""
        if not self.whole:
            return parse_quantity(value, self.unit)
        if isinstance(value, str) and value.strip().isdecimal():
            raise ValueError(say("must be a whole number, without quotes: {number}", number=value.strip()))
        if isinstance(value, bool) or not isinstance(value, int | float) or value != value // 1:
            raise ValueError(say("must be a whole number"))
        return int(value)

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


def _name(value: object) -> object:
    """A name is one line of printable text: it goes to terminals and files as it is."""
    if isinstance(value, str) and not value.isprintable():
        raise ValueError(say("must be one line of printable text, without control characters"))
    return value


Coefficient = Annotated[float, Quantity("1", gt=0)]
Ratio = Annotated[float, Quantity("1", ge=0)]
AtLeastOne = Annotated[float, Quantity("1", ge=1)]
PoissonRatio = Annotated[float, Quantity("1", ge=0, le=0.5)]
Force = Annotated[float, Quantity("N", gt=0)]
Slope = Annotated[float, Quantity("1/m", ge=0)]
Length = Annotated[float, Quantity("m", gt=0)]
Gap = Annotated[float, Quantity("m", ge=0)]
Torque = Annotated[float, Quantity("N*m", gt=0)]
Stiffness = Annotated[float, Quantity("N/m", gt=0)]
TorqueOrNone = Annotated[float, Quantity("N*m", ge=0)]
StiffnessOrNone = Annotated[float, Quantity("N/m", ge=0)]
WallAngle = Annotated[float, Quantity("rad", ge=0, lt=1.5707963267948966)]
Stress = Annotated[float, Quantity("Pa", gt=0)]
SectionModulus = Annotated[float, Quantity("m^3", gt=0)]
Count = Annotated[int, Quantity("1", ge=1, whole=True)]
Name = Annotated[str, BeforeValidator(_name)]
