"""Lists of one's own in the place of those that ship: friction materials, disc springs, balls; TOML or CSV."""

import math
import os
import re
import sys
from collections.abc import Iterator, Mapping, Sequence
from csv import DictReader
from functools import lru_cache
from importlib.resources import files
from os import PathLike
from typing import Any, NamedTuple

from ..errors import AfmcalcError
from ..messages import did_you_mean, say
from .catalogues import Disc, Lists, Material, plain
from .parse import check_size, text_of, toml_of
from .quantity import parse_quantity
from .source import Source

_WORDS = dict.fromkeys(("name", "description", "condition", "source", "also"), "")
_MATERIAL = _WORDS | {
    "friction_min": "1",
    "friction_max": "1",
    "pressure_min": "Pa",
    "pressure_max": "Pa",
    "temperature_min": "K abs",
    "temperature_max": "K abs",
}
_SIZES = ("outer_diameter", "inner_diameter", "thickness", "reduced_thickness", "free_height")
_DISC = {"name": "", **dict.fromkeys(_SIZES, "m"), "source": ""}
"""Columns of a list of one's own, each with its SI unit; empty of words."""
_CONDITIONS = ("dry", "in oil")
SNAPS = 2.4
"""Height over thickness up to which the force of a disc only grows (1 + √2)."""


def own_lists(named: object) -> Lists:
    """Read the files that a table of catalogues names."""
    given: Mapping[str, object] = named if isinstance(named, Mapping) else {}
    return Lists(**{name: _read(name, file) for name in _READ if isinstance(file := given.get(name), str)})


def _read(name: str, file: str) -> Any:
    try:
        changed = os.stat(file).st_mtime_ns
    except (OSError, ValueError):
        changed = 0
    return _unchanged(name, file, changed)


@lru_cache(maxsize=64)
def _unchanged(name: str, file: str, changed: int) -> Any:
    """Read a file once: every clutch that a design writes is read with its lists."""
    return _READ[name](file)


def friction_materials(file: str) -> dict[str, Material]:
    """Every material of a file by name."""
    return {row.name: _material(row) for row in _rows_of(text_of(file), "materials", _MATERIAL)}


def _material(row: "_Row") -> Material:
    row.need("description", "condition", "friction_min", "friction_max")
    if (condition := row.words["condition"]) not in _CONDITIONS:
        raise row.refused(say("condition: {given!r} is neither dry nor in oil", given=condition))
    row.ends("friction")
    numbers, words = row.numbers, row.words
    coldest, hottest = (each and round(each - 273.15, 6) for each in row.ends("temperature"))
    return Material(
        row.name, words["description"], condition, numbers["friction_min"], numbers["friction_max"],
        *row.ends("pressure"), coldest, hottest, words["source"], words["source"], row.also,
    )  # fmt: skip


def discs(file: str) -> tuple[Disc, ...]:
    """Every size of disc spring of a file."""
    return tuple(_disc(row) for row in _rows_of(text_of(file), "discs", _DISC))


def _disc(row: "_Row") -> Disc:
    row.need("outer_diameter", "inner_diameter", "thickness", "free_height")
    outer, inner, thickness, reduced, height = (row.numbers.get(size, 0.0) for size in _SIZES)
    if not (inner < outer and reduced < thickness < height <= SNAPS * thickness):
        raise row.refused(
            say(
                "is no disc spring: inner_diameter < outer_diameter, reduced_thickness < thickness < free_height, and "
                "free_height at most {most:g} thickness",
                most=SNAPS,
            )
        )
    return Disc(row.name, outer, inner, thickness, reduced or None, height, None, row.words["source"])


class _Row(NamedTuple):
    """A row of a list of one's own."""

    label: str
    """What it is called in errors."""
    name: str
    numbers: dict[str, float]
    """Numbers of its columns, SI."""
    words: dict[str, str]

    @property
    def also(self) -> tuple[str, ...]:
        """Other names."""
        return tuple(each.strip() for each in self.words.get("also", "").split(";") if each.strip())

    def take(self, cells: Mapping[str, object], columns: Mapping[str, str]) -> None:
        """Read the cells; a heading may end in a unit, and a list hold both ends of a range."""
        for heading, value in cells.items():
            column = max((each for each in columns if f"{heading}_".startswith(f"{each}_")), key=len, default="")
            name, _, unit = heading.partition("_")
            if not column and isinstance(value, list) and value and f"{name}_min" in columns:
                unit = unit and f"_{unit}"
                self.take({f"{name}_min{unit}": value[0], f"{name}_max{unit}": value[-1]}, columns)
            elif not column:
                hint, known = did_you_mean(heading, columns), ", ".join(columns)
                raise self.refused(
                    say("unknown column {heading!r}{hint}; there are: {known}", heading=heading, hint=hint, known=known)
                )
            elif value not in ("", None):
                text = ";".join(map(str, value)) if isinstance(value, list) else str(value).strip()
                if not text.isprintable():
                    raise self.refused(say("must be one line of printable text, without control characters"))
                if columns[column]:
                    self.numbers[column] = self.number(column, text, heading[len(column) + 1 :], columns[column])
                else:
                    self.words[column] = text

    def number(self, column: str, cell: str, unit: str, wanted: str) -> float:
        """Read a cell in the unit of its heading; without one in SI, or with a unit of its own."""
        bare = re.fullmatch(r"\d+(\.\d+)?", cell)
        unit = {"C": "degC"}.get(unit, unit)
        try:
            number = parse_quantity(f"{cell} {unit}" if unit else float(cell) if bare else cell, wanted)
            if number <= 0:
                raise ValueError(say("must be greater than {bound:g}", bound=0))
        except ValueError as error:
            raise self.refused(say("{column} = {given}: {why}", column=column, given=cell, why=error.args[0])) from None
        return number

    def refused(self, why: str) -> AfmcalcError:
        """Say what is wrong with it."""
        return AfmcalcError("{label}: {why}", label=self.label, why=why)

    def need(self, *columns: str) -> None:
        """Refuse a row that lacks one of some columns, or its source."""
        for column in (*columns, "source"):
            if column not in self.numbers and column not in self.words:
                raise self.refused(say("{column}: required", column=column))

    def ends(self, name: str) -> tuple[float | None, float | None]:
        """Ends of a range, which is given wholly or not at all."""
        low, high = (self.numbers.get(f"{name}_{end}") for end in ("min", "max"))
        if (low is None) != (high is None) or (low or 0.0) > (high or 0.0):
            raise self.refused(say("{name}_min and {name}_max: both are needed, the lower one first", name=name))
        return low, high


def _rows_of(source: Source, table: str, columns: Mapping[str, str]) -> Iterator[_Row]:
    """Read the rows of a list, TOML or CSV."""
    given: list[tuple[str, Mapping[str, object]]] = []
    if source.lower().endswith(".csv"):
        lines = [line for line in source.text.splitlines() if line.strip() and not line.startswith("#")]
        given = [(row.pop("name", ""), row) for row in DictReader(lines, restkey="", restval="")]
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
    called = set[str]()
    for name, cells in given:
        row = _Row(f"{source}: {name}", name, {}, {})
        row.take(cells, columns)
        names = {plain(each) for each in (name, *row.also)}
        if not name or called & names:
            raise row.refused(say("every row has a name of its own, which no other row has"))
        called |= names
        yield row


def diameters(source: str | PathLike[str] | None = None) -> list[float]:
    """Standard ball diameters in ascending order, m.

    Source: ISO 3290-1, nominal diameters, for the list that ships.

    Args:
        source: TOML file with ``diameters = […]`` in mm (or strings with units), or CSV file (named ``….csv``) with the
            heading ``diameter_mm`` and one diameter a line; None for the list that ships.

    Raises:
        FileError: the file cannot be read.
        AfmcalcError: the file is no such list.
    """
    if source is None:
        label = Source("balls.csv", files("afmcalc.spec").joinpath("balls.csv").read_text(encoding="utf-8"))
    else:
        label = text_of(source)
    if label.lower().endswith(".csv"):
        return sorted(_of_csv(label))
    data = toml_of(label)
    check_size(data, label)
    listed = data.get("diameters")
    if not isinstance(listed, list) or not listed:
        raise AfmcalcError(
            "{label}: diameters must be a list of ball diameters in mm, for example [5, 6, 6.35]", label=label
        )
    return sorted(_diameter(item, label) for item in listed)


def _of_csv(source: Source) -> list[float]:
    lines = [line.strip() for line in source.text.splitlines()]
    heading, *cells = [line for line in lines if line and not line.startswith("#")] or [""]
    if heading != "diameter_mm" or not cells:
        raise AfmcalcError(
            "{label}: must begin with the heading {heading}, then one ball diameter in mm a line",
            label=source,
            heading="diameter_mm",
        )
    for cell in cells:
        if not re.fullmatch(r"\d{1,300}(\.\d+)?", cell, re.ASCII):
            raise AfmcalcError(
                "{label}: line {line}: {cell!r} is no diameter in mm, such as 6.35",
                label=source,
                line=lines.index(cell) + 1,
                cell=cell,
            )
    return [_diameter(float(cell), source) for cell in cells]


def _diameter(item: object, label: str) -> float:
    """Read one entry: a number in mm, or a string with a unit."""
    if isinstance(item, str):
        try:
            value = parse_quantity(item, "m")
        except ValueError as error:
            raise AfmcalcError("{label}: diameters: {item!r}: {why}", label=label, item=item, why=error) from None
    elif isinstance(item, int | float) and not isinstance(item, bool):
        value = item / 1000 if abs(item) <= sys.float_info.max else math.inf
    else:
        raise AfmcalcError("{label}: diameters: {item!r} is no diameter; give numbers in mm", label=label, item=item)
    if not 0 < value < math.inf:
        raise AfmcalcError("{label}: diameters: {item!r} must be greater than 0 and finite", label=label, item=item)
    return value


def next_size(sizes: Sequence[float], wanted: float) -> float | None:
    """Smallest size not below the wanted one; None when the list ends before it."""
    return next((size for size in sizes if size >= wanted * (1 - 1e-12)), None)


_READ: dict[str, Any] = {"materials": friction_materials, "discs": discs, "balls": diameters}
