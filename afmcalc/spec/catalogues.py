"""Catalogues that ship: disc springs of DIN EN 16983, balls of ISO 3290-1, friction materials with their sources."""

import re
import tomllib
from collections.abc import Mapping, Sequence
from csv import reader
from decimal import Decimal
from functools import cache
from importlib.resources import files
from itertools import islice
from typing import Any, NamedTuple

from ..messages import say


class Disc(NamedTuple):
    """One size, SI."""

    series: str
    """A, B or C: stiff, middle, soft; of a list of one's own what the disc is called."""
    outer_diameter: float
    inner_diameter: float
    thickness: float
    reduced_thickness: float | None
    """Thickness as made with flats, of discs thicker than 6 mm."""
    free_height: float
    printed_force: float | None
    """Force printed in the standard, at ¾ of the cone height, N."""
    source: str = ""
    """Source of a disc of one's own list."""
    designation: str = ""
    """Designation of one's own list, such as by a standard of one's country."""

    @property
    def name(self) -> str:
        """Name in the standard, or in one's own list."""
        return self.series if self.source else f"{self.series} {self.outer_diameter / 1e-3:g}"

    @property
    def title(self) -> str:
        """Name in a list of parts."""
        if self.designation:
            return self.designation
        return f"{self.name} ({self.source})" if self.source else f"DIN EN 16983 {self.name}"

    @property
    def cone_height(self) -> float:
        """l_0 − t, m."""
        return self.free_height - self.thickness


@cache
def discs() -> tuple[Disc, ...]:
    """Every size, in the order of the data file."""
    text = files("afmcalc.spec").joinpath("disc-springs.csv").read_text(encoding="utf-8")
    discs = []
    for series, *lengths, force in islice(reader(text.splitlines()), 1, None):
        # millimetres to the last digit, so that 25.4 mm is 0.0254 m
        outer, inner, thickness, reduced, height = (float(f"{mm or 0}e-3") for mm in lengths)
        discs.append(Disc(series, outer, inner, thickness, reduced or None, height, float(force) if force else None))
    return tuple(discs)


@cache
def balls() -> tuple[float, ...]:
    """Nominal diameters of balls by ISO 3290-1 in ascending order, m."""
    text = files("afmcalc.spec").joinpath("balls.csv").read_text(encoding="utf-8")
    return tuple(sorted(float(line) / 1000 for line in text.splitlines() if line[:1].isdigit()))


def ball_designation(diameter: float) -> str | None:
    """Designation of a ball, but for its grade; None of a size that is no standard one."""
    # inch sizes to three decimals, in specs as in lists of balls: 11.1125 is 11.112, 20.6375 is 20.638
    sizes = (float(Decimal(f"{size * 1e3:.9g}").quantize(Decimal("0.001"))) for size in balls())
    size = next((size for size in sizes if abs(diameter * 1e3 - size) < 1e-3), None)
    return None if size is None else say("ball {diameter:.6g} mm, ISO 3290-1", diameter=size)


class Material(NamedTuple):
    """One row of the catalogue, SI; or the worst of several."""

    name: str
    description: str
    condition: str
    friction_min: float
    friction_max: float
    pressure_min: float | None
    """Lower end of the allowable surface pressure's printed range, Pa."""
    pressure_max: float | None
    """Upper end, Pa."""
    temperature_min: float | None
    """Lower end of the allowable temperature's printed range, °C."""
    temperature_max: float | None
    """Upper end, °C."""
    source: str
    """Short name of the source."""
    citation: str
    """The source in full."""
    also: tuple[str, ...]
    """Other names that are read as this one."""


@cache
def friction_materials() -> dict[str, Material]:
    """Every material by name, in the order of the data file."""
    data = tomllib.loads(files("afmcalc.spec").joinpath("materials.toml").read_text(encoding="utf-8"))
    materials: dict[str, Material] = {}
    for name, row in data["materials"].items():
        source = data["sources"][row["source"]]
        pressure: list[float | None] = [kpa * 1e3 for kpa in row.get("pressure_kPa", ())] or [None]
        temperature: list[float | None] = [float(celsius) for celsius in row.get("temperature_C", ())] or [None]
        materials[name] = Material(
            name=name, description=row["description"], condition=row["condition"], friction_min=row["friction"][0],
            friction_max=row["friction"][1], pressure_min=pressure[0], pressure_max=pressure[-1],
            temperature_min=temperature[0], temperature_max=temperature[-1], source=source["short"],
            citation=source["full"], also=tuple(row.get("also", ())),
        )  # fmt: skip
    return materials


class Lists(NamedTuple):
    """Lists of one's own; None: the one that ships."""

    materials: dict[str, Material] | None = None
    discs: tuple[Disc, ...] | None = None
    balls: list[float] | None = None


def material_named(name: str, listed: Mapping[str, Material]) -> Material | None:
    """Return the material of a name, or of another that is read as it, capitals, spaces and hyphens aside."""
    read_as = (row for row in listed.values() if plain(name) in map(plain, (row.name, *row.also)))
    return listed.get(name) or next(read_as, None)


def plain(name: str) -> str:
    """Return a name as it is compared with others."""
    return re.sub(r"[\W_]+", "", name.casefold().replace("ё", "е"))


def worst_of(materials: Sequence[Material]) -> Material:
    """One material as bad as the worst of several in everything that any of them tells."""
    least: dict[str, Any] = {}
    for name in ("friction_min", "pressure_min", "pressure_max", "temperature_min", "temperature_max"):
        told = (getattr(each, name) for each in materials)
        least[name] = min((value for value in told if value is not None), default=None)
    names, most = ", ".join(each.name for each in materials), max(each.friction_max for each in materials)
    return materials[0]._replace(name=names, friction_max=most, **least)
