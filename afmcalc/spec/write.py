"""Writing of specs: data and text of the file, in the engineer's units."""

import math
import re
from collections.abc import Collection, Mapping
from decimal import Decimal
from typing import Any

from ..errors import Problem, SpecError
from ..messages import named, say, translate
from ..units import ENGINEER, ZEROS, product
from .keys import key_of_number
from .models import Spec
from .parse import example_text
from .quantity import parse_quantity

WRITTEN = ("N", "m", "N*m", "N/m", "rad", "Pa", "m^3", "rad/s", "K abs", "W")
"""SI units of numbers that are written with a unit; other numbers are written without a unit."""
_UNITS = ENGINEER | {"rad/s": "rpm"}
"""SI unit → unit in which a quantity is written: rpm for speeds, as on the rating plate of a motor."""

_DIGITS = 12
"""Number of significant digits written; further digits of a calculated number are rounding errors."""


def to_toml(data: Mapping[str, object]) -> str:
    """TOML text in the engineer's units, from plain spec data in SI."""
    import tomli_w

    return tomli_w.dumps(written(data))


def written(data: Mapping[str, Any], path: str = "") -> dict[str, Any]:
    """Plain spec data in the engineer's units, rounded to ``_DIGITS``, from data in SI at a path."""
    table = {}
    for name, value in data.items():
        inner = f"{path}.{name}" if path else name
        if not isinstance(value, Mapping):
            key = key_of_number(inner)
            table[name] = value_as_written(value, key and key.unit)
        elif value:
            table[name] = written(value, inner)
    return table


def value_as_written(value: Any, unit: str | None) -> Any:
    """Value as written in a file: with the engineer's unit, rounded to the digits written."""
    if isinstance(value, list | tuple):
        return [value_as_written(item, unit) for item in value]
    if isinstance(value, bool | str):
        return value
    if unit in WRITTEN:
        return _quantity(value, unit)
    text = f"{value:.{_DIGITS}g}"
    return value if isinstance(value, int) else int(text) if text.isdecimal() else float(text)


def _quantity(value: float, unit: str) -> str:
    """Text of an SI number in the engineer's unit, or in SI if only the SI text reads back as the same number."""
    written = _UNITS.get(unit, unit)
    number = Decimal(value) - ZEROS["degC"] if unit == "K abs" else Decimal(value) / product(written).factor
    text = f"{float(number):.{_DIGITS}g}"
    plain = f"{value:.{_DIGITS}g}"
    if not math.isfinite(float(number)) or (
        float(plain) == value and parse_quantity(f"{text} {written}", unit) != value
    ):
        return f"{plain} {unit.removesuffix(' abs')}"
    return f"{text} {written}"


def comment(line: str) -> str:
    """Comment in a line of an example; empty if the line has no comment.

    >>> comment('# sleeve_depth = "25 mm"     # of the sleeve'), comment("# A clutch."), comment("[drive]")
    ('of the sleeve', 'A clutch.', '')
    """
    # "# " before a key or block that the user may activate is no comment
    before, mark, text = re.sub(r"^# (?=\[|[\w.\"]+ = )", "", line).partition("# ")
    return text if mark and before.count('"') % 2 == 0 else ""


def annotated(text: str) -> str:
    """Text of an example with its comments and its name translated."""
    lines = ((line, comment(line)) for line in text.splitlines())
    translated = "".join(f"{line.removesuffix(words)}{translate(words, 'comment')}\n" for line, words in lines)
    return re.sub(r'(?m)(?<=^name = ").*(?="$)', lambda match: named(match[0]), translated, count=1)


def lines_of(kind: str, paths: Collection[str]) -> str:
    """Indented lines of a template that give some keys, with the headings of their tables, no line commented out."""
    heading, table, lines = "", "", list[str]()
    for line in annotated(example_text(kind)).splitlines():
        name = line.removeprefix("# ").partition(" = ")[0].replace('"', "")
        if line.startswith("["):
            heading, table = line, line[1:].partition("]")[0]
        elif f"{table}.{name}" in paths:
            lines += [heading] * (heading not in lines) + [line.removeprefix("# ")]
    return "\n".join(f"  {line}" for line in lines)


def lacking(spec: Spec, command: str, needs: str, kind: str, paths: Collection[str]) -> SpecError:
    """Error of a spec that lacks keys that a command needs, with the lines of a template that would give the keys."""
    message = say("{command} needs {needs}", command=command, needs=needs)
    if lines := lines_of(kind, paths):
        message += "\n" + say(
            "to paste, below the heading of its table where the file has that; the values are those of afmcalc init "
            "--kind {kind}, put in your own:\n{lines}",
            kind=kind, lines=lines,
        )  # fmt: skip
    return spec.label.refused([Problem("", None, message)])
