"""Standard ball sizes: the list that ships, or the user's own."""

import math
import re
import sys
from collections.abc import Sequence
from importlib.resources import files
from os import PathLike

from ..errors import AfmcalcError
from ..messages import say
from ..source import Source
from .limits import check_size
from .parsing import text_of, toml_of

HEADING = "diameter_mm"
"""First line of a list in CSV."""


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
        text = files("afmcalc.spec").joinpath("balls.csv").read_text(encoding="utf-8")
        label = Source("balls.csv", text)
    else:
        text, label = text_of(source)
    listed = (_of_csv if label.lower().endswith(".csv") else _of_toml)(text, label)
    return sorted(_diameter(item, label) for item in listed)


def _of_toml(text: str, label: str) -> Sequence[object]:
    data = toml_of(text, label)
    check_size(data, label)
    listed = data.get("diameters")
    if not isinstance(listed, list) or not listed:
        raise AfmcalcError(
            say("{label}: diameters must be a list of ball diameters in mm, for example [5, 6, 6.35]", label=label)
        )
    return listed


def _of_csv(text: str, label: str) -> Sequence[object]:
    lines = [line.strip() for line in text.splitlines()]
    cells = [line for line in lines if line and not line.startswith("#")]
    if cells[:1] != [HEADING] or not cells[1:]:
        raise AfmcalcError(
            say(
                "{label}: must begin with the heading {heading}, then one ball diameter in mm a line",
                label=label,
                heading=HEADING,
            )
        )
    for cell in cells[1:]:
        if not re.fullmatch(r"\d{1,300}(\.\d+)?", cell, re.ASCII):
            raise AfmcalcError(
                say(
                    "{label}: line {line}: {cell!r} is no diameter in mm, such as 6.35",
                    label=label,
                    line=lines.index(cell) + 1,
                    cell=cell,
                )
            )
    return [float(cell) for cell in cells[1:]]


def _diameter(item: object, label: str) -> float:
    """Read one entry: a number in mm, or a string with a unit."""
    if isinstance(item, str):
        from .quantity import parse_quantity

        try:
            value = parse_quantity(item, "m")
        except ValueError as error:
            raise AfmcalcError(say("{label}: diameters: {item!r}: {why}", label=label, item=item, why=error)) from None
    elif isinstance(item, int | float) and not isinstance(item, bool):
        value = item / 1000 if abs(item) <= sys.float_info.max else math.inf
    else:
        raise AfmcalcError(
            say("{label}: diameters: {item!r} is no diameter; give numbers in mm", label=label, item=item)
        )
    if not 0 < value < math.inf:
        raise AfmcalcError(
            say("{label}: diameters: {item!r} must be greater than 0 and finite", label=label, item=item)
        )
    return value


def next_size(sizes: Sequence[float], wanted: float) -> float | None:
    """Smallest size not below the wanted one; None when the list ends before it."""
    return next((size for size in sizes if size >= wanted * (1 - 1e-12)), None)
