"""The friction-material catalogue: each entry with its own source, never merged."""

from functools import cache
from typing import NamedTuple

from ..errors import Problem
from ..messages import say
from .rules import wrong
from .suggest import did_you_mean


class Material(NamedTuple):
    """One row of the catalogue, SI."""

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


@cache
def catalogue() -> dict[str, Material]:
    """Every material by name, in the order of the data file."""
    import tomllib
    from importlib.resources import files

    data = tomllib.loads(files("afmcalc.spec").joinpath("materials.toml").read_text(encoding="utf-8"))
    sources = data["sources"]
    entries: dict[str, Material] = {}
    for name, row in data["materials"].items():
        pressure, temperature = row.get("pressure_kPa"), row.get("temperature_C")
        entries[name] = Material(
            name=name,
            description=row["description"],
            condition=row["condition"],
            friction_min=row["friction"][0],
            friction_max=row["friction"][1],
            pressure_min=pressure[0] * 1e3 if pressure else None,
            pressure_max=pressure[-1] * 1e3 if pressure else None,
            temperature_min=float(temperature[0]) if temperature else None,
            temperature_max=float(temperature[-1]) if temperature else None,
            source=sources[row["source"]]["short"],
            citation=sources[row["source"]]["full"],
        )
    return entries


def friction_range(name: str) -> tuple[float, float]:
    """Smallest and largest coefficient of friction of a material."""
    entry = catalogue()[name]
    return entry.friction_min, entry.friction_max


def problems(name: str, given: dict[str, float | None]) -> list[Problem]:
    """Problems of a friction block that names a material: unknown, or beside numbers of its own."""
    known = catalogue()
    if name not in known:
        hint, listed = did_you_mean(name, known), ", ".join(known)
        return [wrong("material", say("unknown material{hint}; the catalogue has {listed}", hint=hint, listed=listed))]
    low, high = friction_range(name)
    return [
        wrong(
            key,
            say(
                "excludes material ({name!r} has {low:g}…{high:g}): give material, or min and max",
                name=name,
                low=low,
                high=high,
            ),
        )
        for key, value in given.items()
        if value is not None
    ]
