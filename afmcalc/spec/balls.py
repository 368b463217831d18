"""Standard ball sizes: the list that ships, or the user's own."""

import math
from os import PathLike

from ..errors import AfmcalcError, FileError


def diameters(source: str | PathLike[str] | None = None) -> list[float]:
    """Standard ball diameters in ascending order, m.

    Args:
        source: TOML file with ``diameters = […]`` in mm (or strings with units); None for the list that ships.

    Raises:
        FileError: the file cannot be read.
        AfmcalcError: the file is no such list.
    """
    import tomllib
    from importlib.resources import files

    if source is None:
        text, label = files("afmcalc.spec").joinpath("balls.toml").read_text(encoding="utf-8"), "balls.toml"
    else:
        label = str(source)
        try:
            with open(source, encoding="utf-8") as file:
                text = file.read()
        except OSError as error:
            raise FileError(f"{label}: cannot be read: {error.strerror or error}") from None
        except UnicodeDecodeError:
            raise AfmcalcError(f"{label}: is not UTF-8 text") from None
    try:
        listed = tomllib.loads(text).get("diameters")
    except tomllib.TOMLDecodeError as error:
        raise AfmcalcError(f"{label}: is not valid TOML: {error}") from None
    if not isinstance(listed, list) or not listed:
        raise AfmcalcError(f"{label}: diameters must be a list of ball diameters in mm, for example [5, 6, 6.35]")
    return sorted(_diameter(item, label) for item in listed)


def _diameter(item: object, label: str) -> float:
    """Read one entry: a number in mm, or a string with a unit."""
    if isinstance(item, str):
        from .quantity import parse_quantity

        try:
            value = parse_quantity(item, "m")
        except ValueError as error:
            raise AfmcalcError(f"{label}: diameters: {item!r}: {error}") from None
    elif isinstance(item, int | float) and not isinstance(item, bool):
        value = item / 1000
    else:
        raise AfmcalcError(f"{label}: diameters: {item!r} is no diameter; give numbers in mm")
    if not 0 < value < math.inf:
        raise AfmcalcError(f"{label}: diameters: {item!r} must be greater than 0 and finite")
    return value
