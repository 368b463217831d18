"""Results are values: frozen, typed, SI, with symbol, unit and description on every field."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Self

from pydantic import BaseModel, ConfigDict, Field, PrivateAttr
from pydantic.fields import FieldInfo

from .errors import AfmcalcError
from .findings import Finding

if TYPE_CHECKING:
    import pandas


class Result(BaseModel):
    """Base of every result; all formats are read off its fields."""

    model_config = ConfigDict(frozen=True, allow_inf_nan=False, extra="forbid", defer_build=True)

    def words(self, name: str) -> str | None:
        """Words for people in place of a field's value; None for the value itself, "" for nothing."""
        return None

    def to_dict(self) -> dict[str, Any]:
        """Return plain data, SI, as the JSON of the command has it."""
        return self.model_dump(mode="json")


@dataclass(frozen=True)
class Shown:
    """Presentation of a result field; called by pydantic, it writes unit and symbol into the JSON Schema."""

    unit: str = ""
    """SI unit; "1" of a pure number, empty of what is no quantity."""
    symbol: str | None = None
    """Symbol of the papers."""
    null: str = "–"
    """Meaning of a missing value, for people."""
    unit_in: str = ""
    """Attribute that holds the SI unit of the value, where the unit is no constant."""
    is_unit: bool = False
    """True if the value is the unit of other fields."""
    error_of: str = ""
    """Field whose standard error this is; people see it beside the figure."""
    code: bool = False
    """True if the value is a name that a user types: it is never translated."""
    detail: bool = False
    """Left out of tables for people when the table is long."""
    details: bool = False
    """Left out for people unless they ask for details."""
    data: bool = False
    """A list for programs: CSV writes it, people are spared it."""
    across: bool = False
    """True if people see the records of a list side by side, quantities as rows."""
    folds: bool = False
    """True if a table tells what is the same in all of its rows once, in a line above it."""
    by: str = ""
    """Field of the records whose every value gets a table of its own, for people."""
    ranked: bool = False
    """True if a dictionary is shown with its largest magnitude first."""
    keys_are: str = "parameter"
    """Name of the keys of a dictionary."""
    in_words: Callable[[str], str] | None = None
    """``name`` → what people read in place of a name, of each in a list, or of each key of a dictionary."""
    steps: bool = False
    """True if a list holds the steps of an explanation."""
    asked: bool = False
    """True if the value is a quantity of a clutch, as ``analysis.asking`` asks it."""
    quantity: str = ""
    """Its name, where it is not that of the field."""

    def __call__(self, schema: dict[str, Any]) -> None:
        """Write what a program wants to know."""
        schema |= {"unit": self.unit, "symbol": self.symbol}


def quantity(unit: str, symbol: str | None, description: str, *, optional: bool = False, **shown: Any) -> Any:
    """Declare a result field: SI unit ("1" for a pure number), symbol of the papers, what it is; rest as ``Shown``.

    ``optional`` leaves the field null (and out of tables) where it does not apply.
    """
    about = Shown(unit, symbol, **shown)
    if optional:
        return Field(default=None, description=description, json_schema_extra=about)
    return Field(description=description, json_schema_extra=about)


def described(description: str, **shown: Any) -> Any:
    """Declare a result field without unit and symbol: words, a yes or no, a part of the result."""
    return quantity("", None, description, **shown)


def shown_as(field: FieldInfo) -> Shown:
    """Return how a field of a result is shown."""
    return field.json_schema_extra if isinstance(field.json_schema_extra, Shown) else Shown()


class AtEnds(Result):
    """Base of a quantity at the smallest, the mean and the largest friction."""

    @classmethod
    def of(cls, values: Iterable[Any]) -> Self:
        """Build it of three values."""
        return cls(**dict(zip(("min", "mean", "max"), values, strict=True)))


class Triple(AtEnds):
    """A quantity at the smallest, the mean and the largest friction."""

    min: float = Field(description="at f_min")
    mean: float = Field(description="at the mean friction")
    max: float = Field(description="at f_max")


class OpenTriple(AtEnds):
    """Optional ``Triple``: null where there is none."""

    min: float | None = Field(description="at f_min")
    mean: float | None = Field(description="at the mean friction")
    max: float | None = Field(description="at f_max")


class Series(Result):
    """One swept key: its coordinate at every point of the grid; subclasses add the answers there."""

    parameter: str = described("swept key as called")
    path: str = described("spec path")
    unit: str = described("SI unit of the values")
    values: list[float] = described("value at every point")


@dataclass(frozen=True)
class Output:
    """Output of every command."""

    command: Annotated[str, Field(description="name of the command")]
    version: Annotated[str, Field(description="version of afmcalc")]
    spec: Annotated[dict[str, Any] | None, Field(description="the spec as resolved, SI")]
    result: Annotated[Any, Field(description="the result of the command")]
    findings: Annotated[list[Finding], Field(description="what a designer should know")]


class Answer(Result):
    """Base of what a command calculates; asked from Python it carries the rest of what the command prints."""

    findings_first: ClassVar[bool] = False
    """True if the findings are what the command is called for: ``--quiet`` keeps them."""
    of_several: ClassVar[bool] = False
    """True if it is of more clutches than the one of the spec."""
    many_lists: ClassVar[bool] = False
    """True if it holds several lists that belong together: CSV has one figure of any of them in each row."""
    rows_with_values: ClassVar[bool] = False
    """True if CSV has the single values in every row of its list."""

    _output: Output = PrivateAttr()
    _render: Callable[[Output, str], str] = PrivateAttr()

    def printed_as(self, output: Output, render: Callable[[Output, str], str]) -> Self:
        """Return the answer with the output that it is in, and with what writes that in a format."""
        answer = self.model_copy()
        answer._output, answer._render = output, render
        return answer

    @property
    def output(self) -> Output:
        """Output of the command; only of an answer that was asked for from Python."""
        return self._output

    @property
    def result(self) -> Self:
        """The answer itself, which holds the fields of the result."""
        return self

    @property
    def spec(self) -> dict[str, Any] | None:
        """The spec as resolved, SI."""
        return self._output.spec

    @property
    def findings(self) -> list[Finding]:
        """Findings on the clutch."""
        return self._output.findings

    def to_dataframe(self) -> "pandas.DataFrame":
        """Return a table: a row per friction, else the rows of the CSV; needs pandas.

        Columns are named as the fields; ``attrs["units"]`` has their SI units, ``attrs["values"]`` what holds for all
        frictions.
        """
        import io

        try:
            import pandas
        except ModuleNotFoundError:
            raise AfmcalcError("to_dataframe() needs pandas, not installed here: pip install pandas") from None
        frame = pandas.read_csv(io.StringIO(self._render(self._output, "csv")))
        heads = [column.rstrip("]").partition(" [") for column in frame.columns]
        frame.columns = [name for name, _, _ in heads]
        units = {name: unit for name, _, unit in heads if unit}
        ends = {name: dict(value) for name, value in self if isinstance(value, AtEnds) and len(frame) == 1}
        if not ends:
            frame.attrs["units"] = units
            return frame
        rows = pandas.DataFrame(ends)
        rows.attrs["units"] = {name: units.get(f"{name}.min", "1") for name in ends}
        single = [name for name in frame.columns if name.rpartition(".")[0] not in ends]
        rows.attrs["values"] = {name: frame[name].iloc[0] for name in single}
        return rows

    def __repr__(self) -> str:
        """Return the tables of the terminal."""
        return self._render(self._output, "table") if hasattr(self, "_output") else super().__repr__()

    __str__ = __repr__

    def _repr_html_(self) -> str:
        return self._render(self._output, "html")

    def _repr_markdown_(self) -> str:
        return self._render(self._output, "markdown")
