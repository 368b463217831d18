"""Field types of the spec: SI numbers that also take a string with a unit."""

from typing import Annotated

from pydantic import BeforeValidator, Field

from .quantity import EXAMPLES, parse_quantity


def _reader(unit: str) -> BeforeValidator:
    def read(value: object) -> float:
        return parse_quantity(value, unit)

    schema = float if unit == "1" else float | str
    return BeforeValidator(read, json_schema_input_type=schema)


def _whole(value: object) -> int:
    """A whole number; 8.0 is one (JSON and sweeps write it so), 8.5 and true are not."""
    if isinstance(value, bool) or not isinstance(value, int | float) or value != value // 1:
        raise ValueError("must be a whole number")
    return int(value)


def unit_of(metadata: list[object]) -> str | None:
    """SI unit noted in a field's annotation, if it has one."""
    return next((item.unit for item in metadata if isinstance(item, Unit)), None)


class Unit:
    """SI unit of a field, kept beside its type so that tables and sweeps can name it."""

    def __init__(self, unit: str) -> None:
        """Note ``unit``, a key of ``EXAMPLES``."""
        if unit not in EXAMPLES:
            raise KeyError(unit)
        self.unit = unit


_POSITIVE = Field(gt=0)
_NOT_NEGATIVE = Field(ge=0)

Coefficient = Annotated[float, _reader("1"), Unit("1"), _POSITIVE]
Ratio = Annotated[float, _reader("1"), Unit("1"), _NOT_NEGATIVE]
AtLeastOne = Annotated[float, _reader("1"), Unit("1"), Field(ge=1)]
Force = Annotated[float, _reader("N"), Unit("N"), _POSITIVE]
Length = Annotated[float, _reader("m"), Unit("m"), _POSITIVE]
Gap = Annotated[float, _reader("m"), Unit("m"), _NOT_NEGATIVE]
Torque = Annotated[float, _reader("N*m"), Unit("N*m"), _POSITIVE]
Stiffness = Annotated[float, _reader("N/m"), Unit("N/m"), _POSITIVE]
StiffnessOrNone = Annotated[float, _reader("N/m"), Unit("N/m"), _NOT_NEGATIVE]
WallAngle = Annotated[float, _reader("rad"), Unit("rad"), _NOT_NEGATIVE, Field(lt=1.5707963267948966)]
Stress = Annotated[float, _reader("Pa"), Unit("Pa"), _POSITIVE]
SectionModulus = Annotated[float, _reader("m^3"), Unit("m^3"), _POSITIVE]
Count = Annotated[int, BeforeValidator(_whole), Unit("1"), Field(ge=1)]
