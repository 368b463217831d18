"""The disc springs of DIN EN 16983, series A, B and C."""

from collections.abc import Mapping
from csv import DictReader
from functools import cache
from importlib.resources import files
from typing import NamedTuple

_MILLI = 1e-3


class Disc(NamedTuple):
    """One size, SI."""

    series: str
    """A, B or C: stiff, middle, soft."""
    outer_diameter: float
    inner_diameter: float
    thickness: float
    reduced_thickness: float | None
    """As made with flats, of discs thicker than 6 mm."""
    free_height: float
    printed_force: float | None
    """Force printed in the standard, at ¾ of the cone height, N."""

    @property
    def name(self) -> str:
        """As the standard calls it."""
        return f"{self.series} {self.outer_diameter / _MILLI:g}"

    @property
    def cone_height(self) -> float:
        """l_0 − t, m."""
        return self.free_height - self.thickness


@cache
def discs() -> tuple[Disc, ...]:
    """Every size, in the order of the data file."""
    text = files("afmcalc.spec").joinpath("disc-springs.csv").read_text(encoding="utf-8")
    return tuple(_disc(row) for row in DictReader(text.splitlines()))


def _disc(row: Mapping[str, str]) -> Disc:
    def metres(column: str) -> float:
        # millimetres to the last digit, so that 25.4 mm is 0.0254 m
        return float(f"{row[column]}e-3")

    reduced, force = row["reduced_thickness_mm"], row["force_at_0.75_h0_N"]
    return Disc(
        series=row["series"],
        outer_diameter=metres("outer_diameter_mm"),
        inner_diameter=metres("inner_diameter_mm"),
        thickness=metres("thickness_mm"),
        reduced_thickness=metres("reduced_thickness_mm") if reduced else None,
        free_height=metres("free_height_mm"),
        printed_force=float(force) if force else None,
    )
