"""Field types of the spec: SI numbers that also take a string with a unit."""

from typing import TYPE_CHECKING, Annotated, Any, TypeAlias

from pydantic import BeforeValidator, Field

from .quantity import EXAMPLES, parse_quantity


def _quantity(unit: str, **bounds: float) -> Any:
    """Return the type of a field: a number in SI within ``bounds`` (gt, ge, lt, le), or a string with a unit."""

    def read(value: object) -> float:
        return parse_quantity(value, unit)

    bound: Any = Field(**bounds)  # type: ignore[call-overload]
    schema: Any = Annotated[float, bound] if unit == "1" else Annotated[float, bound] | str
    return Annotated[float, BeforeValidator(read, json_schema_input_type=schema), Unit(unit), bound]


def _name(value: object) -> object:
    """A name is one line of printable text: it goes to terminals and files as it is."""
    if isinstance(value, str) and not value.isprintable():
        raise ValueError("must be one line of printable text, without control characters")
    return value


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


if TYPE_CHECKING:
    Coefficient: TypeAlias = float
    Ratio: TypeAlias = float
    AtLeastOne: TypeAlias = float
    PoissonRatio: TypeAlias = float
    Force: TypeAlias = float
    Length: TypeAlias = float
    Gap: TypeAlias = float
    Torque: TypeAlias = float
    Stiffness: TypeAlias = float
    StiffnessOrNone: TypeAlias = float
    WallAngle: TypeAlias = float
    Stress: TypeAlias = float
    SectionModulus: TypeAlias = float
else:
    Coefficient = _quantity("1", gt=0)
    Ratio = _quantity("1", ge=0)
    AtLeastOne = _quantity("1", ge=1)
    PoissonRatio = _quantity("1", ge=0, le=0.5)
    Force = _quantity("N", gt=0)
    Length = _quantity("m", gt=0)
    Gap = _quantity("m", ge=0)
    Torque = _quantity("N*m", gt=0)
    Stiffness = _quantity("N/m", gt=0)
    StiffnessOrNone = _quantity("N/m", ge=0)
    WallAngle = _quantity("rad", ge=0, lt=1.5707963267948966)
    Stress = _quantity("Pa", gt=0)
    SectionModulus = _quantity("m^3", gt=0)
Whole = Annotated[int, BeforeValidator(_whole)]
Count = Annotated[Whole, Unit("1"), Field(ge=1)]
Name = Annotated[str, BeforeValidator(_name)]
