"""What a searched parameter may be: one value, a list or an even grid, held to the bounds of a spec's field."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple, get_args

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler, TypeAdapter, ValidationError
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema, PydanticKnownError, core_schema

from ..messages import say
from .fields import Count, Force, Length, Quantity, Ratio, Stiffness, StiffnessOrNone, WallAngle
from .rules import Table

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

MOST_VALUES = 1_000_000
"""Values of one searched parameter beyond which a file is refused."""
MOST_LISTED = 10_000
"""The same for values that are written out, and for balls and forces of a catalogue."""


class Choice(NamedTuple):
    """Values of one searched parameter, SI: a list, or an even grid that is not yet laid out."""

    listed: tuple[float, ...]
    start: float = 0.0
    stop: float = 0.0
    length: int = 0

    @property
    def size(self) -> int:
        """How many values."""
        return len(self.listed) or self.length

    @property
    def between(self) -> bool:
        """Whether any value between the ends is meant, and the grid but samples it."""
        return self.length > 1

    def array(self) -> "NDArray[np.float64]":
        """The values, ascending."""
        import numpy as np

        return np.array(self.listed) if self.listed else np.linspace(self.start, self.stop, self.length)


@dataclass(frozen=True)
class Searched:
    """What a searched parameter may be: one value, a list, or a table with start, stop and count (or step)."""

    kind: Any
    """Type of a spec's field; every value is held to what it is held to."""
    most: int = MOST_VALUES

    @property
    def about(self) -> Quantity:
        """What each value may be."""
        found: Quantity = get_args(self.kind)[1]
        return found

    @cached_property
    def _field(self) -> TypeAdapter[float]:
        return TypeAdapter(self.kind)

    def number(self, value: object) -> float:
        """Read one value, SI."""
        try:
            return float(self._field.validate_python(value))
        except OverflowError:
            raise ValueError(say("must be finite")) from None
        except ValidationError as error:
            detail: Any = error.errors(include_url=False)[0]
            if detail["type"] == "value_error":
                raise detail["ctx"]["error"] from None
            raise PydanticKnownError(detail["type"], detail.get("ctx")) from None

    def read(self, value: object) -> Choice:
        """Read what stands in the file."""
        if isinstance(value, Choice):
            return value
        if isinstance(value, list | tuple):
            if not value:
                raise ValueError(say("must not be an empty list"))
            _check_count(len(value), min(self.most, MOST_LISTED))
            return Choice(tuple(sorted({self.number(item) for item in value})))
        return self._grid(value) if isinstance(value, Mapping) else Choice((self.number(value),))

    def _grid(self, value: Table) -> Choice:
        if unknown := sorted(set(value) - {"start", "stop", "count", "step"}):
            raise ValueError(say("unknown key {key!r}; a range has start, stop and count (or step)", key=unknown[0]))
        if "start" not in value or "stop" not in value:
            raise ValueError(say("a range has start, stop and count (or step)"))
        start, stop = self.number(value["start"]), self.number(value["stop"])
        if start > stop:
            raise ValueError(
                say("the range is inverted: start {start:g} is above stop {stop:g}", start=start, stop=stop)
            )
        if "count" in value and "step" in value:
            raise ValueError(say("give count or step, not both"))
        count, whole = value.get("count"), self.kind is Count
        if "count" not in value:
            step = self.number(value["step"]) if "step" in value else 1.0 if whole else 0.0
            if not step > 0:
                raise ValueError(say("a range needs count, or a step greater than 0"))
            steps = (stop - start) / step * (1 + 1e-12)
            _check_count(steps + 1, self.most)
            count = int(steps) + 1
            stop = start + (count - 1) * step
        if isinstance(count, bool) or not isinstance(count, int) or count < 1:
            raise ValueError(say("count must be a whole number of at least 1"))
        _check_count(count, self.most)
        if whole and count > 1 and (stop - start) % (count - 1):
            raise ValueError(say("count does not give whole numbers; use step"))
        return Choice((), start, stop, count)

    def __get_pydantic_core_schema__(self, source: object, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Validate by reading."""
        return core_schema.no_info_plain_validator_function(self.read)

    def __get_pydantic_json_schema__(self, core: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Describe what may stand in the file."""
        one: JsonSchemaValue = {"anyOf": [{"type": "number"}, {"type": "string"}]}
        return {
            "anyOf": [*one["anyOf"], {"type": "array", "items": one}, {"type": "object", "additionalProperties": one}]
        }


def _check_count(count: float, most: int) -> None:
    if not count <= most:
        raise ValueError(say("{count:,.10g} values; at most {most:,} here", count=count, most=most))


Pairs = Annotated[Choice, Searched(Count)]
Lengths = Annotated[Choice, Searched(Length)]
Ratios = Annotated[Choice, Searched(Ratio)]
Angles = Annotated[Choice, Searched(WallAngle)]
Stiffnesses = Annotated[Choice, Searched(Stiffness)]
StiffnessesOrNone = Annotated[Choice, Searched(StiffnessOrNone)]
Forces = Annotated[Choice, Searched(Force, MOST_LISTED)]
Diameters = Annotated[Choice, Searched(Length, MOST_LISTED)]
