"""Catalogues of friction materials with sources, disc springs and balls: lists that ship, or the user's own lists."""

import re
from collections.abc import Iterable, Iterator, Mapping
from csv import DictReader, Error
from decimal import Decimal
from functools import cache
from os import PathLike
from pathlib import Path
from typing import Annotated, Any, Literal, NamedTuple, TypeVar

from pydantic import AfterValidator, BeforeValidator, ValidationError

from ..errors import AfmcalcError, SpecError
from ..messages import say
from .fields import (
    Broken,
    Coefficient,
    Key,
    Length,
    Name,
    RuledBlock,
    Stress,
    greater,
    key,
    keys_below,
    required,
)
from .parse import Source, parse, text_of
from .problems import problems_in
from .quantity import NUMBER, Quantity

Celsius = Annotated[float, Quantity("K abs", gt=0), AfterValidator(lambda kelvin: round(kelvin - 273.15, 6))]
Names = Annotated[
    tuple[Name, ...],
    BeforeValidator(lambda given: [each.strip() for each in given.split(";")] if isinstance(given, str) else given),
]


class Row(RuledBlock):
    """Row of a list of friction materials or disc springs."""

    name: Name = required("what it is called")
    source: Name = required("short name of its source")


class Material(Row):
    """Friction material, a row of the catalogue or the worst case of several; SI, temperatures in °C."""

    description: Name = required("material")
    condition: Literal["dry", "in oil"]
    friction_min: Coefficient
    friction_max: Coefficient
    pressure_min: Stress | None = key("lower end of the printed range of the allowable pressure")
    pressure_max: Stress | None = key("its upper end")
    temperature_min: Celsius | None = key("lower end of the printed range of the allowable temperature")
    temperature_max: Celsius | None = key("its upper end")
    also: Names = key("other names of it", default=())
    citation: Name | None = key("the source in full; default its short name")

    def broken_rules(self) -> Iterable[Broken]:
        """Yield the broken rules: a range must have both ends, the lower end first."""
        for name in ("friction", "pressure", "temperature"):
            low, high = getattr(self, f"{name}_min"), getattr(self, f"{name}_max")
            if (low is None) != (high is None) or (low is not None and low > high):
                yield "", say("{name}_min and {name}_max: both are needed, the lower one first", name=name)


SNAPS = 1.4
"""Largest ratio of cone height to thickness at which the force of a disc spring is monotone (√2, rounded down)."""


class DiscSpring(RuledBlock):
    """A disc spring."""

    outer_diameter: Length = required("outer diameter of a disc", "D_e")
    inner_diameter: Length = required("inner diameter of a disc", "D_i")
    thickness: Length = required("thickness of a disc", "t")
    reduced_thickness: Length | None = key("thickness of a disc with flats", "t'")
    free_height: Length = required("height of a disc without load", "l_0")

    def broken_rules(self) -> Iterable[Broken]:
        """Yield the broken rules: a disc spring must be a cone, and must not snap through."""
        broken = [
            *greater("outer_diameter", self.outer_diameter, "inner_diameter", self.inner_diameter),
            *greater("free_height", self.free_height, "thickness", self.thickness),
            *greater("thickness", self.thickness, "reduced_thickness", self.reduced_thickness),
        ]
        yield from broken
        if not broken and self.free_height - self.thickness > SNAPS * self.thickness:
            most = (1 + SNAPS) * self.thickness
            yield "free_height", say("must be at most {most:.5g} m: a higher disc snaps through", most=most)


class Disc(Row, DiscSpring):
    """One size of disc spring in a list, SI."""

    designation: Name = key("designation in a list of parts; default name and source", default="")

    @property
    def title(self) -> str:
        """Designation of the disc spring in a part list."""
        return self.designation or f"{self.name} ({self.source})"


class Lists(NamedTuple):
    """The user's own lists; None: the list that ships with the program."""

    materials: dict[str, Material] | None = None
    discs: tuple[Disc, ...] | None = None
    balls: tuple[float, ...] | None = None


R = TypeVar("R", bound=Row)
_HERE = Path(__file__).parent


@cache
def friction_materials() -> dict[str, Material]:
    """Every material that ships with the program, by name."""
    return materials_in(_HERE / "materials.toml")


@cache
def discs() -> tuple[Disc, ...]:
    """Every disc spring of DIN EN 16983."""
    return discs_in(_HERE / "disc-springs.csv")


@cache
def balls() -> tuple[float, ...]:
    """Nominal diameters of balls by ISO 3290-1 in ascending order, m."""
    return balls_in(_HERE / "balls.csv")


def materials_in(file: str | PathLike[str]) -> dict[str, Material]:
    """All materials of a file, by name."""
    return {row.name: row for row in _rows(text_of(file), "materials", Material)}


def discs_in(file: str | PathLike[str]) -> tuple[Disc, ...]:
    """All disc springs of a file."""
    return (*_rows(text_of(file), "discs", Disc),)


def _rows(source: Source, table: str, model: type[R]) -> Iterator[R]:
    """Validated rows of a list, TOML or CSV."""
    if source.lower().endswith(".csv"):
        try:
            given = [(row.pop("name", ""), row) for row in DictReader(_lines(source), restkey="", restval="")]
        except Error as error:
            raise AfmcalcError("{label}: is no CSV: {why}", label=source, why=error) from None
    else:
        listed: Any = (data := parse(source)).pop(table, {})
        given = [(name, row) for name, row in listed.items() if isinstance(row, dict)] if listed and not data else []
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


def _columns(cells: Mapping[str, Any], keys: Mapping[str, Key]) -> Iterator[tuple[str, object]]:
    """Names and values of a row; the unit in a heading is added to the value, a pair becomes _min and _max."""
    for heading, cell in cells.items():
        name, _, unit = heading.partition("_")
        if isinstance(cell, list) and cell and f"{name}_min" in keys:
            yield from _columns({f"{name}_min_{unit}": cell[0], f"{name}_max_{unit}": cell[-1]}, keys)
        elif cell != "":
            of_unit = (each for each, key in keys.items() if key.unit and f"{heading}_".startswith(f"{each}_"))
            column = next(of_unit, heading)
            unit = heading[len(column) + 1 :].replace("C", "degC")
            yield column, f"{cell} {unit}" if unit and re.fullmatch(NUMBER, str(cell)) else cell


def balls_in(file: str | PathLike[str]) -> tuple[float, ...]:
    """Ball diameters of a file in ascending order, m; numbers are in mm."""
    source = text_of(file)
    if source.lower().endswith(".csv"):
        heading, *cells = [line.strip() for line in _lines(source)] or [""]
        listed: Any = cells if heading == "diameter_mm" else None
    else:
        listed = parse(source).get("diameters")
    if not listed or not isinstance(listed, list):
        raise AfmcalcError(
            "{label}: is no list of balls: TOML has diameters = [5, 6, 6.35] in mm, CSV the heading diameter_mm "
            "and a line for each",
            label=source,
        )
    sizes = []
    for item in listed:
        try:
            sizes.append(Quantity("m", gt=0).read(float(item) / 1000 if re.fullmatch(NUMBER, str(item)) else item))
        except ValueError as error:
            raise AfmcalcError("{label}: {item!r:.80}: {why}", label=source, item=item, why=error) from None
    return (*sorted(sizes),)


def _lines(source: Source) -> list[str]:
    return [line for line in source.text.splitlines() if line.strip() and not line.startswith("#")]


READ: dict[str, Any] = {"materials": materials_in, "discs": discs_in, "balls": balls_in}
"""Key of [catalogues] → function that reads its file."""


def ball_designation(diameter: float) -> str | None:
    """Designation of a ball without its grade; None if the size is not in the standard."""
    # specs and lists of balls round inch sizes to three decimals: 11.1125 is 11.112, 20.6375 is 20.638
    sizes = (float(Decimal(f"{size * 1e3:.9g}").quantize(Decimal("0.001"))) for size in balls())
    size = next((size for size in sizes if abs(diameter * 1e3 - size) < 1e-3), None)
    return None if size is None else say("ball {diameter:.6g} mm, ISO 3290-1", diameter=size)


def material_named(name: str, listed: Mapping[str, Material]) -> Material | None:
    """Material by one of its names, ignoring capitals, spaces and hyphens; None if the list has no such name."""
    read_as = (row for row in listed.values() if plain(name) in map(plain, (row.name, *row.also)))
    return listed.get(name) or next(read_as, None)


def plain(name: str) -> str:
    """Name reduced to small letters, digits and decimal points, for comparison."""
    return re.sub(r"(?!(?<=\d)[.,]\d)[\W_]", "", name.casefold().replace("ё", "е"))
