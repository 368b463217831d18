"""From spec to data and text."""

import re
from collections.abc import Mapping
from decimal import Decimal
from typing import Any

from ..messages import named, native, translate
from ..units import ENGINEER, ZEROS, product
from .keys import keys, scatter_at
from .quantity import parse_quantity

WRITTEN = ("N", "m", "N*m", "N/m", "rad", "Pa", "m^3", "rad/s", "K abs", "W")
"""SI units of what a written spec has with the engineer's unit; other numbers stand alone."""
_UNITS = ENGINEER | {"rad/s": "rpm"}
"""Unit in which each is written: a speed as on the plate of a motor."""

_DIGITS = 12
"""More of a calculated number are rounding error and noise to a reader."""

_COMMENT = 36
"""Column of the comments, as in the examples."""

_HEADING = (
    'A quantity is a number in SI or a string with a unit: "2 kN", "100 mm", "20 N/mm", "30 deg", "200 N*m", "400 MPa".'
)


def to_toml(data: Mapping[str, object], about: str = "") -> str:
    """Write plain spec data, SI, as TOML for people: what it is ``about``, units, and what each key is beside it."""
    import tomli_w

    lines = [f"# {line}" for line in (about, _HEADING) if line] + [""]
    table = ""
    for line in tomli_w.dumps(written(data)).splitlines():
        if line.startswith("["):
            table = line.strip("[]") + "."
        key = keys().get(table + line.partition(" = ")[0])
        words = [native(key.symbol or ""), re.split(r"; | \(", key.description)[0]] if key else []
        text = ", ".join(filter(None, words))
        lines.append(f"{line:<{_COMMENT - 1}} # {text}" if text else line)
    return "\n".join(lines) + "\n"


def written(data: Mapping[str, Any], path: str = "") -> dict[str, Any]:
    """Return plain spec data, SI, as it is written: in the engineer's units, with no more digits than count."""
    table = {}
    for name, value in data.items():
        inner = f"{path}.{name}" if path else name
        if not isinstance(value, Mapping):
            key = keys().get(inner)
            table[name] = value_as_written(value, key.unit if key else None)
        elif path == "tolerance.fields":  # its keys are paths themselves
            about = scatter_at(name)
            table[name] = {
                part: value_as_written(number, about.unit if about else None) for part, number in value.items()
            }
        elif inner == "search":
            units = {axis: keys()[axis].unit if axis in keys() else None for axis in value}
            table[name] = {axis: value_as_written(values, units[axis]) for axis, values in value.items()}
        elif value:
            table[name] = written(value, inner)
    return table


def value_as_written(value: Any, unit: str | None) -> Any:
    """Write a value; of a number no more digits than count, unless it has them from whoever gave it."""
    if isinstance(value, list | tuple):
        return [value_as_written(item, unit) for item in value]
    if isinstance(value, bool | str):
        return value
    if unit in WRITTEN:
        return _quantity(value, unit)
    text = f"{value:.{_DIGITS}g}"
    return value if isinstance(value, int) else int(text) if text.isdecimal() else float(text)


def _quantity(value: float, unit: str) -> str:
    """Write a number in SI with the engineer's unit, or with its own where only that reads back to the same."""
    written = _UNITS.get(unit, unit)
    number = Decimal(value) - ZEROS["degC"] if unit == "K abs" else Decimal(value) / product(written).factor
    text = f"{float(number):.{_DIGITS}g}"
    plain = f"{value:.{_DIGITS}g}"
    if float(plain) == value and parse_quantity(f"{text} {written}", unit) != value:
        return f"{plain} {unit.removesuffix(' abs')}"
    return f"{text} {written}"


def comment(line: str) -> str:
    """Return the comment of a line of an example, or nothing.

    >>> comment('# sleeve_depth = "25 mm"     # of the sleeve'), comment("# A clutch."), comment("[drive]")
    ('of the sleeve', 'A clutch.', '')
    """
    # before a key or block that is there to be taken up
    before, mark, text = re.sub(r"^# (?=\[|[\w.\"]+ = )", "", line).partition("# ")
    return text if mark and before.count('"') % 2 == 0 else ""


def annotated(text: str) -> str:
    """Return an example with its comments, and its name, in the language of the user."""
    lines = ((line, comment(line)) for line in text.splitlines())
    translated = "".join(f"{line.removesuffix(words)}{translate(words, 'comment')}\n" for line, words in lines)
    return re.sub(r'(?m)(?<=^name = ").*(?="$)', lambda match: named(match[0]), translated, count=1)
