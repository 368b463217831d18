"""From spec to data and text."""

import json
import re
from collections.abc import Iterator, Mapping
from decimal import Decimal
from typing import Any

from .models import Spec
from .paths import keys, unit_at
from .quantity import parse_quantity
from .units import KNOWN

_WRITTEN = {"N": "kN", "m": "mm", "N*m": "N*m", "N/m": "N/mm", "rad": "deg", "Pa": "MPa", "m^3": "cm^3"}
"""SI unit → the one that a written spec has."""

_DIGITS = 12
"""More of a calculated number are rounding error and noise to a reader."""

_COMMENT = 36
"""Column of the comments, as in the examples."""

_HEADING = (
    'A quantity is a number in SI or a string with a unit: "2 kN", "100 mm", "20 N/mm", "30 deg", "200 N*m", "400 MPa".'
)


def resolved(spec: Spec) -> dict[str, Any]:
    """Return the spec as plain data, SI, with defaults filled in.

    Reading it again gives the same clutch, with the same keys free: what follows from other keys (the mean of the
    friction range, the range of a material, the spring force from a nominal torque) is not filled in, so that it
    still follows when one of them is overridden.
    """
    data = spec.model_dump(exclude_none=True)
    group = data["friction_group"]
    if spec.kind.chooses_bypass:
        group.setdefault("driving_pairs", spec.bypass_pairs)
    if "inner_radius" in group:
        group.setdefault("radius_model", "uniform-wear")
    return data


def to_toml(data: Mapping[str, object], about: str = "") -> str:
    """Write plain spec data as TOML for people: quantities with their units, what each key is beside it.

    Args:
        data: the spec, SI.
        about: what it is, for its first line.
    """
    heading = [f"# {line}" for line in (about, _HEADING) if line]
    return "\n".join([*heading, "", *_table(data, "")]) + "\n"


def _table(data: Mapping[str, object], path: str) -> Iterator[str]:
    """Lines of a table: its keys, then the tables in it."""
    inner = {name: value for name, value in data.items() if isinstance(value, Mapping) and not _scatters(path)}
    for name, value in data.items():
        if name not in inner:
            yield _line(path + name if path else name, name, value, path)
    for name, value in inner.items():
        yield from ["", f"[{path}{name}]"] if _has_keys(value) or _scatters(f"{path}{name}.") else []
        yield from _table(value, f"{path}{name}.")


def _has_keys(data: Mapping[str, object]) -> bool:
    return any(not isinstance(value, Mapping) for value in data.values())


def _scatters(path: str) -> bool:
    """Whether the keys of a table are paths themselves."""
    return path == "tolerance.fields."


def _line(path: str, name: str, value: Any, table: str) -> str:
    if _scatters(table):
        unit = unit_at(name)
        parts = ", ".join(f"{part} = {_value(each, unit)}" for part, each in value.items() if each is not None)
        return f"{_text(name)} = {{ {parts} }}"
    key = keys().get(path)
    line = f"{name} = {_value(value, key.unit if key else None)}"
    said = ", ".join(filter(None, (key.symbol, re.split(r"; | \(", key.description)[0]))) if key else ""
    return f"{line:<{_COMMENT - 1}} # {said}" if said else line


def _value(value: Any, unit: str | None) -> str:
    """Write a value; of a number no more digits than count, unless it has them from whoever gave it."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, list | tuple):
        return f"[{', '.join(_value(item, unit) for item in value)}]"
    if unit in _WRITTEN:
        return _text(_quantity(value, unit))
    return str(value) if isinstance(value, int) else f"{value:.{_DIGITS}g}"


def _text(value: str) -> str:
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")


def _quantity(value: float, unit: str) -> str:
    """Write a number in SI with the engineer's unit, or with its own where only that reads back to the same."""
    written = _WRITTEN[unit]
    # of a decimal zero the exponent would be kept
    text = f"{Decimal(value) / KNOWN[unit][written]:.{_DIGITS}g}" if value else "0"
    plain = f"{value:.{_DIGITS}g}"
    if float(plain) == value and parse_quantity(f"{text} {written}", unit) != value:
        return f"{plain} {unit}"
    return f"{_trimmed(text)} {written}"


def _trimmed(text: str) -> str:
    """A decimal number without trailing zeros, which ``Decimal`` keeps."""
    mantissa, exponent, power = text.partition("e")
    return (mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa) + exponent + power
