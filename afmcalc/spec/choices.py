"""What a searched parameter may be: one value, a list or an even grid, held to the bounds of a spec's field."""

from collections.abc import Callable, Mapping
from functools import cache
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple, TypeAlias

from pydantic import BeforeValidator, TypeAdapter, ValidationError
from pydantic_core import PydanticKnownError

from .fields import Count, Force, Length, Ratio, Stiffness, StiffnessOrNone, WallAngle

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


def _choice(kind: Any, most: int = MOST_VALUES) -> Any:
    """Type of a searched parameter: one value, a list, or a table with start, stop and count (or step).

    Its values are held to what a spec's field of the ``kind`` is held to.
    """

    def number(value: object) -> float:
        try:
            return float(_adapter(kind).validate_python(value))
        except ValidationError as error:
            detail: Any = error.errors(include_url=False)[0]
            if detail["type"] == "value_error":
                raise detail["ctx"]["error"] from None
            raise PydanticKnownError(detail["type"], detail.get("ctx")) from None

    def read(value: object) -> Choice:
        if isinstance(value, Choice):
            return value
        if isinstance(value, list | tuple):
            if not value:
                raise ValueError("must not be an empty list")
            _check_count(len(value), min(most, MOST_LISTED))
            return Choice(tuple(sorted({number(item) for item in value})))
        if not isinstance(value, Mapping):
            return Choice((number(value),))
        return _grid(value, number, whole=kind is Count, most=most)

    schema: Any = float | str | list[float | str] | dict[str, float | str]
    return Annotated[Any, BeforeValidator(read, json_schema_input_type=schema)]


@cache
def _adapter(kind: Any) -> TypeAdapter[float]:
    return TypeAdapter(kind)


def _check_count(count: float, most: int) -> None:
    if not count <= most:
        raise ValueError(f"{count:,.10g} values; at most {most:,} here")


def _grid(value: Mapping[str, Any], number: Callable[[object], float], *, whole: bool, most: int) -> Choice:
    if unknown := sorted(set(value) - {"start", "stop", "count", "step"}):
        raise ValueError(f"unknown key {unknown[0]!r}; a range has start, stop and count (or step)")
    if "start" not in value or "stop" not in value:
        raise ValueError("a range has start, stop and count (or step)")
    start, stop = number(value["start"]), number(value["stop"])
    if start > stop:
        raise ValueError(f"the range is inverted: start {start:g} is above stop {stop:g}")
    if "count" in value and "step" in value:
        raise ValueError("give count or step, not both")
    if "count" in value:
        count = value["count"]
        if isinstance(count, bool) or not isinstance(count, int) or count < 1:
            raise ValueError("count must be a whole number of at least 1")
        _check_count(count, most)
    else:
        step = number(value["step"]) if "step" in value else 1.0 if whole else 0.0
        if not step > 0:
            raise ValueError("a range needs count, or a step greater than 0")
        steps = (stop - start) / step * (1 + 1e-12)
        _check_count(steps + 1, most)
        count = int(steps) + 1
        stop = start + (count - 1) * step
    if whole and count > 1 and (stop - start) % (count - 1):
        raise ValueError("count does not give whole numbers; use step")
    return Choice((), start, stop, count)


if TYPE_CHECKING:
    Pairs: TypeAlias = Choice
    Lengths: TypeAlias = Choice
    Ratios: TypeAlias = Choice
    Angles: TypeAlias = Choice
    Stiffnesses: TypeAlias = Choice
    StiffnessesOrNone: TypeAlias = Choice
    Forces: TypeAlias = Choice
    Diameters: TypeAlias = Choice
else:
    Pairs = _choice(Count)
    Lengths = _choice(Length)
    Ratios = _choice(Ratio)
    Angles = _choice(WallAngle)
    Stiffnesses = _choice(Stiffness)
    StiffnessesOrNone = _choice(StiffnessOrNone)
    Forces = _choice(Force, MOST_LISTED)
    Diameters = _choice(Length, MOST_LISTED)
