"""Results are values: frozen, typed, SI, with symbol, unit and description on every field."""

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar

from pydantic import BaseModel, ConfigDict, Field, InstanceOf, WithJsonSchema

from .findings import Finding


class Result(BaseModel):
    """Base of every result; all formats are read off its fields."""

    model_config = ConfigDict(frozen=True, allow_inf_nan=False, extra="forbid", defer_build=True)

    findings_first: ClassVar[bool] = False
    """Whether the findings are what the command is called for (CSV then lists them)."""
    of_several: ClassVar[bool] = False
    """Whether it is of more clutches than the one of the spec."""
    many_lists: ClassVar[bool] = False
    """Whether it holds several lists that belong together: CSV has one figure of any of them in each row."""

    def words(self, name: str) -> str | None:
        """Return what people are told instead of a field's value; None: the value; "" of a nested result: nothing."""
        return None


def quantity(unit: str, symbol: str | None, description: str, *, optional: bool = False, **extra: Any) -> Any:
    """Declare a result field: SI unit ("1" for a pure number), symbol of the papers, what it is.

    ``optional`` leaves the field null (and out of tables) where it does not apply.
    """
    about = {"unit": unit, "symbol": symbol, **extra}
    if optional:
        return Field(default=None, description=description, json_schema_extra=about)
    return Field(description=description, json_schema_extra=about)


Sentence = Annotated[InstanceOf[str], WithJsonSchema({"type": "string"})]
"""A text that stays the ``Text`` it is, so that people are told it in their language; ``str`` would forget that."""


class Triple(Result):
    """A quantity at the smallest, the mean and the largest friction."""

    min: float = Field(description="at f_min")
    mean: float = Field(description="at the mean friction")
    max: float = Field(description="at f_max")


class OpenTriple(Result):
    """The same of a quantity that need not be: null where there is none."""

    min: float | None = Field(description="at f_min")
    mean: float | None = Field(description="at the mean friction")
    max: float | None = Field(description="at f_max")


class Series(Result):
    """One swept key: its coordinate at every point of the grid; subclasses add the answers there."""

    parameter: str = quantity("", None, "swept key as called")
    path: str = quantity("", None, "spec path")
    unit: str = quantity("", None, "SI unit of the values")
    values: list[float] = quantity("", None, "value at every point", axis=True)


@dataclass(frozen=True)
class Output:
    """What every command prints."""

    command: Annotated[str, Field(description="name of the command")]
    version: Annotated[str, Field(description="version of afmcalc")]
    spec: Annotated[dict[str, Any] | None, Field(description="the spec as resolved, SI")]
    result: Annotated[Any, Field(description="the result of the command")]
    findings: Annotated[list[Finding], Field(description="what a designer should know")]
