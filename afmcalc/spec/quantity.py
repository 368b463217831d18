"""Quantities in a spec: a number in SI, or a string with a unit of the right dimension."""

import math
import re
from decimal import Decimal
from functools import cache
from typing import TYPE_CHECKING, Any

from .units import KNOWN, SIGNS

if TYPE_CHECKING:
    import pint

EXAMPLES = {
    "N": ("a force", "2 kN"),
    "m": ("a length", "100 mm"),
    "N*m": ("a torque", "200 N*m"),
    "N/m": ("a stiffness", "20 N/mm"),
    "rad": ("an angle", "30 deg"),
    "Pa": ("a pressure or stress", "400 MPa"),
    "m^3": ("a section modulus", "15 cm^3"),
    "1": ("a plain number", "0.3"),
}
"""SI unit of a field → what it is, and how one may be written."""

_QUANTITY = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)(.*)", re.DOTALL)
_UNIT_TEXT = re.compile(r"[\w\s*/^().°·⋅×µμ⁻¹²³⁴-]+")
_WORD = re.compile(r"[^\W\d_]+(?:_[^\W\d_]+)*")


def parse_quantity(value: object, unit: str) -> float:
    """Read ``value`` as a quantity of the dimension of ``unit``, in SI.

    Args:
        value: a number in SI or a string such as ``"20 N/mm"``.
        unit: SI unit of the field, a key of ``EXAMPLES``.

    Returns:
        The number in SI.

    Raises:
        ValueError: not a number, not finite, an unknown unit or one of another dimension.

    >>> parse_quantity("20 N/mm", "N/m")
    20000.0
    """
    kind, _ = EXAMPLES[unit]
    if isinstance(value, bool):
        raise ValueError(f"a boolean is not {kind}; {_allowed(unit)}")
    if isinstance(value, int | float):
        number = _as_float(value)
    elif isinstance(value, str):
        number = _parse_text(value, unit)
    else:
        raise ValueError(f"{kind} is wanted; {_allowed(unit)}")
    if not math.isfinite(number):
        raise ValueError(f"must be finite; {_allowed(unit)}")
    return number


def _as_float(value: int | float) -> float:
    try:
        return float(value)
    except OverflowError:
        return math.inf


def _allowed(unit: str) -> str:
    kind, example = EXAMPLES[unit]
    if unit == "1":
        return f"give {kind} such as {example}"
    return f'give {kind}: a number in SI ({unit}) or a string with a unit such as "{example}"'


def _parse_text(text: str, unit: str) -> float:
    match = _QUANTITY.fullmatch(text)
    if match is None:
        raise ValueError(f"cannot be read as a number with a unit; {_allowed(unit)}")
    number, unit_text = match[1], match[2].strip()
    if re.match(r",\d", unit_text):
        raise ValueError("a decimal comma is not read; write a decimal point")
    if not unit_text:
        raise ValueError(f"has no unit; {_allowed(unit)}")
    if unit == "1":
        raise ValueError(f"is dimensionless and takes no unit; {_allowed(unit)}")
    known = KNOWN[unit].get(unit_text.translate(SIGNS))
    return float(Decimal(number) * (looked_up(unit_text, unit) if known is None else known))


@cache
def looked_up(unit_text: str, unit: str) -> Decimal:
    """How many SI units of the field one ``unit_text`` is; decimal, so that 15 cm^3 is exactly 15e-6 m^3."""
    import pint

    registry = _registry()
    if _UNIT_TEXT.fullmatch(unit_text) is None:
        raise ValueError(f"{unit_text!r} is not a unit; {_allowed(unit)}")
    try:
        given = registry.parse_units(re.sub("[·⋅×]", "*", unit_text))
        wanted = registry.parse_units(unit)
    except pint.UndefinedUnitError as error:
        names = error.unit_names if isinstance(error.unit_names, str) else ", ".join(error.unit_names)
        raise ValueError(f"unknown unit {names!r}{_did_you_mean(unit_text, unit)}; {_allowed(unit)}") from None
    except Exception:
        # pint reports malformed unit expressions by whatever its tokenizer happens to raise
        raise ValueError(f"{unit_text!r} is not a unit; {_allowed(unit)}") from None
    if given.dimensionality != wanted.dimensionality:
        raise ValueError(f"{unit_text} is {_dimension_name(given)}, not {EXAMPLES[unit][0]}; {_allowed(unit)}")
    return Decimal(registry.Quantity(Decimal(1), given).to(wanted).magnitude)


@cache
def _registry() -> "pint.UnitRegistry[Any]":
    from importlib.resources import files

    import pint

    lines = files("afmcalc.spec").joinpath("units.txt").read_text(encoding="utf-8").splitlines()
    return pint.UnitRegistry(lines, non_int_type=Decimal)


def _dimension_name(unit: "pint.Unit") -> str:
    registry = _registry()
    names = {registry.parse_units(si).dimensionality: name for si, (name, _) in EXAMPLES.items() if si != "1"}
    dimensionality = unit.dimensionality
    names |= {registry.parse_units(si).dimensionality: name for si, name in _FOREIGN.items()}
    return names.get(dimensionality, f"of dimension {dimensionality}")


_FOREIGN = {"J": "an energy", "kg": "a mass", "s": "a time", "m^2": "an area"}


def _did_you_mean(unit_text: str, unit: str) -> str:
    from .suggest import did_you_mean

    known = [name for base, names in _SPELLINGS.items() if base in _WORD.findall(unit) for name in names.split()]
    if power := re.fullmatch(r"(\w*?[^\W\d])([2-4])", unit_text):
        return f"; write {power[1]}^{power[2]}"
    for word in _WORD.findall(unit_text):
        if hint := did_you_mean(word, known):
            return hint
    return ""


_SPELLINGS = {
    "N": "N kN MN kgf lbf newton kilonewton Н кН кгс Nm kNm Nmm N*m",
    "m": "mm cm m in ft meter metre millimeter мм см м",
    "rad": "deg rad degree radian град рад",
    "Pa": "MPa kPa GPa Pa bar psi ksi megapascal МПа кПа Па",
}
"""Spellings to suggest, by the SI units that make up a field's own."""
