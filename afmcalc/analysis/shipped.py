"""Results that list what ships with the program: example specs, friction materials, disc springs, balls."""

import tomllib
from collections.abc import Mapping, Sequence
from typing import Any, TypeVar

from ..findings import Finding
from ..result import Answer, Result, described, quantity
from ..spec.catalogues import Disc, Material, ball_designation, friction_materials
from ..spec.catalogues import balls as standard_balls
from ..spec.catalogues import discs as standard_discs
from ..spec.parse import example_names, example_text
from ..units import ZEROS

R = TypeVar("R", bound=Result)


class ExampleRow(Result):
    """One file: any SPEC argument takes ``example:`` with its name."""

    name: str = described("name after example:", code=True)
    variant: str | None = described("variant of the clutch", optional=True)
    about: str = described("what it is")


class ExamplesResult(Answer):
    """The examples."""

    examples: list[ExampleRow] = described("examples that ship")


def examples() -> tuple[ExamplesResult, list[Finding]]:
    """List the examples."""
    texts = {name: example_text(name) for name in example_names()}
    rows = [
        ExampleRow(name=name, variant=tomllib.loads(text).get("variant"), about=text.splitlines()[0].removeprefix("# "))
        for name, text in texts.items()
    ]
    return ExamplesResult(examples=rows), []


class MaterialRow(Result):
    """One material: friction against smooth iron or steel, and what it stands."""

    name: str = described("name for friction.material")
    description: str = described("material")
    condition: str = described("condition")
    friction_min: float = quantity("1", "f_min", "smallest friction")
    friction_max: float = quantity("1", "f_max", "largest friction")
    pressure_min: float | None = quantity("Pa", "p_max from", "allowable pressure, lower end", optional=True)
    pressure_max: float | None = quantity("Pa", "p_max to", "allowable pressure, upper end", optional=True)
    temperature_min: float | None = quantity(
        "K abs", "t_max from", "allowable temperature, lower end", optional=True, digits=5
    )
    temperature_max: float | None = quantity(
        "K abs", "t_max to", "allowable temperature, upper end", optional=True, digits=5
    )
    source: str = described("source")
    also: str = described("read as this one too", code=True, detail=True)


class MaterialsResult(Answer):
    """The catalogue."""

    materials: list[MaterialRow] = described("friction materials")
    sources: list[str] = described("sources")


def materials(listed: Mapping[str, Material] | None = None) -> tuple[MaterialsResult, list[Finding]]:
    """List the friction materials that ship, or the materials of a user's catalogue."""
    entries = (friction_materials() if listed is None else listed).values()
    rows = []
    for entry in entries:
        ends = {name: getattr(entry, name) for name in ("temperature_min", "temperature_max")}
        kelvin = {name: None if end is None else end + float(ZEROS["degC"]) for name, end in ends.items()}
        rows.append(_row(MaterialRow, entry, also=", ".join(entry.also), **kelvin))
    return MaterialsResult(
        materials=rows, sources=list(dict.fromkeys(entry.citation or entry.source for entry in entries))
    ), []


def _row(kind: type[R], entry: object, **values: Any) -> R:
    """Row of a list, its fields from the attributes of a catalogue entry; ``values`` take precedence."""
    return kind(**{name: getattr(entry, name) for name in kind.model_fields} | values)


class DiscRow(Result):
    """One disc spring."""

    name: str = described("name of the disc", code=True)
    outer_diameter: float = quantity("m", "D_e", "outer diameter")
    inner_diameter: float = quantity("m", "D_i", "inner diameter")
    thickness: float = quantity("m", "t", "thickness")
    free_height: float = quantity("m", "l_0", "free height")


class DiscsResult(Answer):
    """The disc springs."""

    discs: list[DiscRow] = described("disc springs")


def discs(listed: Sequence[Disc] | None = None) -> tuple[DiscsResult, list[Finding]]:
    """List the disc springs that ship, or the disc springs of a user's catalogue."""
    return DiscsResult(discs=[_row(DiscRow, disc) for disc in listed or standard_discs()]), []


class BallRow(Result):
    """One ball."""

    diameter: float = quantity("m", "d_ш", "ball diameter")
    designation: str | None = described("designation of the ball", optional=True)


class BallsResult(Answer):
    """The ball diameters."""

    balls: list[BallRow] = described("balls")


def balls(listed: Sequence[float] | None = None) -> tuple[BallsResult, list[Finding]]:
    """List the ball diameters that ship, or the diameters of a user's catalogue, m."""
    sizes = listed or standard_balls()
    return BallsResult(balls=[BallRow(diameter=size, designation=ball_designation(size)) for size in sizes]), []
