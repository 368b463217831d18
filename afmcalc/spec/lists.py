"""Lists of one's own in the place of those that ship: friction materials, disc springs, balls; TOML or CSV."""

import re
from collections.abc import Iterable, Iterator, Mapping
from csv import DictReader
from os import PathLike
from typing import Annotated, Any, Literal, TypeVar

from pydantic import AfterValidator, BeforeValidator, ValidationError

from ..errors import AfmcalcError, SpecError
from ..messages import say
from .catalogues import Disc, Lists, Material, plain
from .fields import Broken, Key, Name, Quantity, RuledBlock, key, keys_below, required
from .models import Coefficient, DiscSpring, Stress
from .parse import Source, check_size, text_of, toml_of
from .problems import problems_in
from .quantity import parse_quantity

Celsius = Annotated[float, Quantity("K abs", gt=0), AfterValidator(lambda kelvin: round(kelvin - 273.15, 6))]
Names = Annotated[
    tuple[Name, ...],
    BeforeValidator(lambda given: [each.strip() for each in given.split(";")] if isinstance(given, str) else given),
]


def own_lists(named: object) -> Lists:
    """Read the files that a table of catalogues names."""
    given: Mapping[str, object] = named if isinstance(named, Mapping) else {}
    return Lists(**{name: read(file) for name, read in _READ.items() if isinstance(file := given.get(name), str)})


class _Row(RuledBlock):
    name: Name = required("what it is called")
    source: Name


class _MaterialRow(_Row):
    description: Name = required("material")
    condition: Literal["dry", "in oil"]
    friction_min: Coefficient
    friction_max: Coefficient
    pressure_min: Stress | None = None
    pressure_max: Stress | None = None
    temperature_min: Celsius | None = None
    temperature_max: Celsius | None = None
    also: Names = key("read as this one too", default=())

    def broken_rules(self) -> Iterable[Broken]:
        """A range is given wholly or not at all."""
        for name in ("friction", "pressure", "temperature"):
            low, high = getattr(self, f"{name}_min"), getattr(self, f"{name}_max")
            if (low is None) != (high is None) or (low is not None and low > high):
                yield "", say("{name}_min and {name}_max: both are needed, the lower one first", name=name)


class _DiscRow(_Row, DiscSpring):
    """A cone that does not snap through, as a stack in a spec is one."""

    designation: Name = key("as a list of parts calls it", default="")


R = TypeVar("R", bound=_Row)


def friction_materials(file: str) -> dict[str, Material]:
    """Every material of a file by name."""
    rows = _rows(text_of(file), "materials", _MaterialRow)
    return {row.name: Material(**row.model_dump(), citation=row.source) for row in rows}


def discs(file: str) -> tuple[Disc, ...]:
    """Every size of disc spring of a file."""
    rows = _rows(text_of(file), "discs", _DiscRow)
    return tuple(Disc(series=row.name, printed_force=None, **row.model_dump(exclude={"name"})) for row in rows)


def _rows(source: Source, table: str, model: type[R]) -> Iterator[R]:
    """Read the rows of a list, TOML or CSV."""
    given: list[tuple[str, Mapping[str, object]]] = []
    if source.lower().endswith(".csv"):
        given = [(row.pop("name", ""), row) for row in DictReader(_lines(source), restkey="", restval="")]
    else:
        data = toml_of(source)
        check_size(data, source)
        listed = data.pop(table, {})
        if isinstance(listed, dict) and not data:
            given = [(name, row) for name, row in listed.items() if isinstance(row, dict)]
    if not given:
        raise AfmcalcError(
            "{label}: is no list of {table}: TOML has a table [{table}.NAME] for each and nothing else, CSV a heading "
            "and a line",
            label=source,
            table=table,
        )
    taken = set[str]()
    for name, cells in given:
        label, columns = f"{source}: {name}", dict(_columns(cells, keys_below(model))) | {"name": name}
        try:
            row = model.model_validate(columns)
        except ValidationError as error:
            raise SpecError(label, *problems_in(error, columns, model)) from None
        names = {plain(each) for each in (name, *getattr(row, "also", ()), getattr(row, "designation", "") or name)}
        if not name or taken & names:
            why = say("every row has a name of its own, which no other row has")
            raise AfmcalcError("{label}: {why}", label=label, why=why)
        taken |= names
        yield row


def _columns(cells: Mapping[str, object], keys: Mapping[str, Key]) -> Iterator[tuple[str, object]]:
    """Read the cells by column: a heading may end in a unit, and a list hold both ends of a range."""
    for heading, cell in cells.items():
        name, _, unit = heading.partition("_")
        if isinstance(cell, list) and cell and f"{name}_min" in keys:
            yield from _columns({f"{name}_min_{unit}": cell[0], f"{name}_max_{unit}": cell[-1]}, keys)
            continue
        column = next((each for each in keys if f"{heading}_".startswith(f"{each}_")), heading)
        unit, text = heading[len(column) + 1 :], str(cell).strip()
        if column not in keys or (unit and keys[column].unit is None):
            yield heading, cell
        elif unit and text:
            yield column, f"{text} {'degC' if unit == 'C' else unit}"
        elif text:
            number = keys[column].unit and re.fullmatch(r"\d+(\.\d+)?", text)
            yield column, float(text) if number else text if isinstance(cell, str) else cell


def balls(file: str | PathLike[str]) -> list[float]:
    """Ball diameters of a file in ascending order, m; numbers are in mm.

    Raises:
        FileError: the file cannot be read.
        AfmcalcError: the file is no such list.
    """
    source = text_of(file)
    listed: object
    if source.lower().endswith(".csv"):
        heading, *cells = [line.strip() for line in _lines(source)] or [""]
        listed = [float(cell) if re.fullmatch(r"[\d.]+", cell) else cell for cell in cells if heading == "diameter_mm"]
    else:
        listed = toml_of(source).get("diameters")
    if not isinstance(listed, list) or not listed:
        raise AfmcalcError(
            "{label}: is no list of balls: TOML has diameters = [5, 6, 6.35] in mm, CSV the heading diameter_mm "
            "and a line for each",
            label=source,
        )
    return sorted(_diameter(item, source) for item in listed)


def _diameter(item: object, label: str) -> float:
    """Read one entry: a number in mm, or a string with a unit."""
    try:
        size = parse_quantity(item, "m") / (1 if isinstance(item, str) else 1000)
    except ValueError as error:
        raise AfmcalcError("{label}: {item!r:.80}: {why}", label=label, item=item, why=error) from None
    if size <= 0:
        raise AfmcalcError("{label}: {item!r:.80}: must be greater than 0", label=label, item=item)
    return size


def _lines(source: Source) -> list[str]:
    return [line for line in source.text.splitlines() if line.strip() and not line.startswith("#")]


_READ: dict[str, Any] = {"materials": friction_materials, "discs": discs, "balls": balls}
