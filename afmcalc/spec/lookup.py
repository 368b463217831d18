"""Units that are not known by heart, looked up with pint in ``units.txt``."""

import re
from decimal import Decimal
from functools import cache
from typing import TYPE_CHECKING

import pint

from ..messages import say, term
from .suggest import did_you_mean
from .units import EXAMPLES, KNOWN, SCALES, SIGNS, allowed

if TYPE_CHECKING:
    Registry = pint.UnitRegistry[Decimal]

_UNIT_TEXT = re.compile(r"[\w\s*/^().°·⋅×µμ⁻¹²³⁴-]+")
_WORD = re.compile(r"[^\W\d_]+(?:_[^\W\d_]+)*")

_FOREIGN = {
    "J": say("an energy"),
    "m^2": say("an area"),
    "K": say("a temperature difference"),
    "W": say("a power"),
}
"""Dimensions that no field has, by a unit of theirs."""

_SPELLINGS = {
    "N": "N kN MN kgf lbf newton kilonewton Н кН кгс Nm kNm Nmm N*m",
    "m": "mm cm m in ft meter metre millimeter мм см м",
    "rad": "deg rad degree radian град рад",
    "Pa": "MPa kPa GPa Pa bar psi ksi megapascal МПа кПа Па",
    "s": "s ms min h second с мс мин",
    "rad/s": "rpm rad/s об/мин",
    "kg": "kg g kilogram кг г",
}
"""Spellings to suggest, by the SI units that make up a field's own."""


@cache
def looked_up(unit_text: str, unit: str) -> Decimal:
    """How many SI units of the field one ``unit_text`` is; decimal, so that 15 cm^3 is exactly 15e-6 m^3.

    Raises:
        ValueError: no unit, or one of another dimension than the field's ``unit``.
    """
    if hint := _mixed(unit_text, unit):
        raise ValueError(say("unknown unit {text!r}{hint}", text=unit_text, hint=hint))
    registry = _registry()
    no_unit = say("{text!r} is not a unit; {allowed}", text=unit_text, allowed=allowed(unit))
    if _UNIT_TEXT.fullmatch(unit_text) is None:
        raise ValueError(no_unit)
    try:
        given = registry.parse_units(re.sub("[·⋅×]", "*", unit_text))
        wanted = registry.parse_units(unit)
    except pint.UndefinedUnitError as error:
        names = error.unit_names if isinstance(error.unit_names, str) else ", ".join(error.unit_names)
        hint = _did_you_mean(unit_text, unit)
        raise ValueError(
            say("unknown unit {names!r}{hint}; {allowed}", names=names, hint=hint, allowed=allowed(unit))
        ) from None
    except Exception:
        # pint reports malformed unit expressions by whatever its tokenizer happens to raise
        raise ValueError(no_unit) from None
    if given.dimensionality != wanted.dimensionality:
        raise ValueError(
            say(
                "{text} is {other}, not {kind}; {allowed}",
                text=unit_text,
                other=_dimension_name(given),
                kind=term(EXAMPLES[unit][0]),
                allowed=allowed(unit),
            )
        )
    return Decimal(registry.Quantity(Decimal(1), given).to(wanted).magnitude)


@cache
def _registry() -> "Registry":
    from importlib.resources import files

    lines = files("afmcalc.spec").joinpath("units.txt").read_text(encoding="utf-8").splitlines()
    return pint.UnitRegistry(lines, non_int_type=Decimal)


def _dimension_name(unit: pint.Unit) -> str:
    registry = _registry()
    kinds = {si: name for si, (name, _) in EXAMPLES.items() if si != "1" and si not in SCALES} | _FOREIGN
    names = {registry.parse_units(si).dimensionality: name for si, name in kinds.items()}
    if name := names.get(unit.dimensionality):
        return term(name)
    return say("of dimension {dimension}", dimension=unit.dimensionality)


_CYRILLIC = str.maketrans("ABEKMHOPCTXacekmop", "АВЕКМНОРСТХасекмор")


def _mixed(unit_text: str, unit: str) -> str:
    """Hint for a unit of the field that is typed with letters of two alphabets, or of the wrong one; else nothing."""
    written = unit_text.translate(SIGNS)
    meant = written.translate(_CYRILLIC)
    factor = KNOWN[unit].get(meant)
    if factor is None or written in KNOWN[unit]:
        return ""
    latin = next(text for text, each in KNOWN[unit].items() if each == factor and text.isascii())
    return say("; write {latin!r}, or {meant!r} in Cyrillic letters alone", latin=latin, meant=meant)


def _did_you_mean(unit_text: str, unit: str) -> str:
    known = [name for base, names in _SPELLINGS.items() if base in _WORD.findall(unit) for name in names.split()]
    if power := re.fullmatch(r"(\w*?[^\W\d])([2-4])", unit_text):
        return say("; write {unit}^{power}", unit=power[1], power=power[2])
    hints = (did_you_mean(word, known) for word in _WORD.findall(unit_text))
    return next(filter(None, hints), "")
