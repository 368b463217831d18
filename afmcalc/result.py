"""Results are values: frozen, typed, SI, with symbol, unit and description on every field."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Self

from pydantic import BaseModel, ConfigDict, Field, PrivateAttr
from pydantic.fields import FieldInfo

from .errors import AfmcalcError
from .findings import Finding

if TYPE_CHECKING:
    import pandas


class Result(BaseModel):
    """Base class of every result; all formats are made from its fields."""

    model_config = ConfigDict(frozen=True, allow_inf_nan=False, extra="forbid", defer_build=True)

    def words(self, name: str) -> str | None:
        """Words shown to people in place of a field's value; None: the value is shown; empty: nothing is shown."""
        return None

    @classmethod
    def detailed(cls) -> type[Self]:
        """Return the class with the fields that are declared outside of it; by default there are no such fields."""
        return cls

    def to_dict(self) -> dict[str, Any]:
        """Plain data, SI, as in the JSON of the command."""
        return self.model_dump(mode="json")


@dataclass(frozen=True)
class Shown:
    """Presentation of a result field; called by pydantic, it writes unit and symbol into the JSON Schema."""

    unit: str = ""
    """SI unit; "1" for a pure number, empty for a value that is no quantity."""
    symbol: str | None = None
    """Symbol of the papers."""
    digits: int = 0
    """Significant figures shown to people; 0: as many as ``render.amounts`` gives to the unit."""
    null: str = "–"
    """Text shown to people in place of a missing value."""
    unit_in: str = ""
    """Name of the attribute that has the SI unit of the value, if the unit is not constant."""
    is_unit: bool = False
    """True if the value is the unit of other fields."""
    error_of: str = ""
    """Name of another field of which this field is the standard error; people see it beside that field's value."""
    code: bool = False
    """True if the value is a name that a user types: it is never translated."""
    detail: bool = False
    """True if tables for people leave the field out when they are long."""
    details: bool = False
    """True if the field is shown to people only with ``--details``."""
    data: bool = False
    """True if a list is for programs: CSV writes it, formats for people leave it out."""
    across: bool = False
    """True if the records of a list are shown to people side by side, with quantities as rows."""
    folds: bool = False
    """True if values that are the same in all rows of a table are shown once, in a line above the table."""
    ranked: bool = False
    """True if a dictionary is shown with its largest magnitude first."""
    keys_are: str = "parameter"
    """Name of the keys of a dictionary."""
    in_words: Callable[[str], str] | None = None
    """Function from a name (a value, an item of a list, a key of a dictionary) to the words shown to people."""
    steps: bool = False
    """True if a list holds the steps of an explanation."""
    asked: bool = False
    """True if the value is a quantity of a clutch, which ``analysis.asking`` fills in."""
    quantity: str = ""
    """Name of the quantity of the clutch, if it is not the name of the field."""

    def __call__(self, schema: dict[str, Any]) -> None:
        """Write unit and symbol into the JSON Schema of the field."""
        schema |= {"unit": self.unit, "symbol": self.symbol}


def quantity(unit: str, symbol: str | None, description: str, *, optional: bool = False, **shown: Any) -> Any:
    """Declare a result field: SI unit ("1" for a pure number), symbol of the papers, description; rest as in ``Shown``.

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
    """Presentation of a field of a result."""
    return field.json_schema_extra if isinstance(field.json_schema_extra, Shown) else Shown()


class Triple(Result):
    """A quantity at the smallest, the mean and the largest friction."""

    min: float = Field(description="at f_min")
    mean: float = Field(description="at the mean friction")
    max: float = Field(description="at f_max")


class OpenTriple(Result):
    """Optional ``Triple``: null where there is none."""

    min: float | None = Field(description="at f_min")
    mean: float | None = Field(description="at the mean friction")
    max: float | None = Field(description="at f_max")


class Series(Result):
    """One swept key: its value at every point of the grid; subclasses add the results at these points."""

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
    """Base class of results of commands; in Python, a result also has the other parts of the command's output."""

    of_several: ClassVar[bool] = False
    """True if the result is about several clutches, not only the clutch of the spec."""
    many_lists: ClassVar[bool] = False
    """True if the result has several lists that belong together: CSV then has a row for each number of each list."""
    rows_with_values: ClassVar[bool] = False
    """True if CSV repeats the single values of the result in every row of its list."""

    _output: Output = PrivateAttr()
    _render: Callable[[Output, str], str] = PrivateAttr()

    def printed_as(self, output: Output, render: Callable[[Output, str], str]) -> Self:
        """Copy of the answer that has the whole output, and a function that writes the output in a format."""
        answer = self.model_copy()
        answer._output, answer._render = output, render
        return answer

    @property
    def spec(self) -> dict[str, Any] | None:
        """The spec as resolved, SI."""
        return self._output.spec

    @property
    def findings(self) -> list[Finding]:
        """Findings on the clutch."""
        return self._output.findings

    def to_dataframe(self) -> "pandas.DataFrame":
        """Table with a row for each friction, else with the rows of the CSV; needs pandas.

        Columns are named as the fields; ``attrs["units"]`` has their SI units, ``attrs["values"]`` the values that are
        the same for all frictions.
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
        ends = {name: dict(value) for name, value in self if isinstance(value, Triple | OpenTriple) and len(frame) == 1}
        if not ends:
            frame.attrs["units"] = units
            return frame
        rows = pandas.DataFrame(ends)
        rows.attrs["units"] = {name: units.get(f"{name}.min", "1") for name in ends}
        single = [name for name in frame.columns if name.rpartition(".")[0] not in ends]
        rows.attrs["values"] = {name: frame[name].iloc[0] for name in single}
        return rows

    def __repr__(self) -> str:
        """Tables of the terminal."""
        return self._render(self._output, "table") if hasattr(self, "_output") else super().__repr__()

    __str__ = __repr__

    def _repr_html_(self) -> str:
        return self._render(self._output, "html")

    def _repr_markdown_(self) -> str:
        return self._render(self._output, "markdown")
