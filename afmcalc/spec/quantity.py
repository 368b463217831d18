"""Quantities in a spec: a number in SI, or a string with a unit of the right dimension; the one table of units."""

import math
import re
import sys
from collections.abc import Callable, Mapping
from decimal import Decimal
from functools import cache
from typing import NamedTuple

from ..findings import Finding, finding
from ..messages import did_you_mean, localized, say, term

EXAMPLES = {
    "N": ("a force", "2 kN"),
    "m": ("a length", "100 mm"),
    "N*m": ("a torque", "200 N*m"),
    "N/m": ("a stiffness", "20 N/mm"),
    "1/m": ("a slope of the gain", "18.75 1/m"),
    "rad": ("an angle", "30 deg"),
    "Pa": ("a pressure or stress", "400 MPa"),
    "m^3": ("a section modulus", "15 cm^3"),
    "rad/s": ("a speed of rotation", "1430 rpm"),
    "m/s": ("a speed", "0.3 m/s"),
    "s": ("a time", "10 ms"),
    "kg": ("a mass", "2 kg"),
    "kg*m^2": ("a moment of inertia", "8 kg*m^2"),
    "N*m/rad": ("a torsional stiffness", "8 kN*m/rad"),
    "kg/m^3": ("a density", "7850 kg/m^3"),
    "K abs": ("a temperature", "20 degC"),
    "J/kg/K": ("a specific heat", "480 J/kg/K"),
    "W/m/K": ("a thermal conductivity", "50 W/m/K"),
    "W/K": ("a cooling per kelvin", "2.5 W/K"),
    "J/m^2": ("a work per area", "1 J/mm^2"),
    "m^3/J": ("a wear per energy", "2e-5 mm^3/J"),
    "1": ("a plain number", "0.3"),
}
"""SI unit of a field → what it is, and how one may be written."""

_FOREIGN = {
    "J": say("an energy"),
    "m^2": say("an area"),
    "K": say("a temperature difference"),
    "W": say("a power"),
}
"""Dimensions that no field has, by a unit of theirs."""

# An angle and an energy are dimensions of their own, so that 0.1 rad is no coefficient and 200 J is no torque.
_BASES = ("m", "N", "rad", "J", "s", "kg", "K")

_RPM = Decimal("0.1047197551196597746154214461")

_PREFIXED = {
    "m": "1 m", "meter": "1 m", "metre": "1 m", "N": "1 N", "newton": "1 N", "rad": "1 rad", "radian": "1 rad",
    "J": "1 J", "joule": "1 J", "s": "1 s", "second": "1 s", "g": "1e-3 kg", "gram": "1e-3 kg", "K": "1 K",
    "kelvin": "1 K", "Pa": "1 N/m^2", "pascal": "1 N/m^2", "bar": "1e5 N/m^2", "W": "1 J/s", "watt": "1 J/s",
}  # fmt: skip
_PLAIN = {
    "in": "25.4e-3 m", "inch": "25.4e-3 m", "ft": "0.3048 m", "foot": "0.3048 m", "lbf": "4.4482216152605 N",
    "kgf": "9.80665 N", "kp": "9.80665 N", "psi": "6894.757293168361336722673445 N/m^2",
    "ksi": "6894757.293168361336722673445 N/m^2", "deg": "0.01745329251994329576923690768489 rad",
    "degree": "0.01745329251994329576923690768489 rad", "°": "0.01745329251994329576923690768489 rad",
    "rpm": "0.1047197551196597746154214461 rad/s",
    **dict.fromkeys(("rev", "revolution", "U"), "6.283185307179586476925286766559 rad"),
    "min": "60 s", "minute": "60 s", "h": "3600 s", "hour": "3600 s",
}  # fmt: skip
"""UnitProduct → what it is in SI; those above take a prefix."""
_PREFIXES = {
    "k": "1e3", "kilo": "1e3", "M": "1e6", "mega": "1e6", "G": "1e9", "giga": "1e9", "d": "0.1", "deci": "0.1",
    "c": "0.01", "centi": "0.01", "m": "1e-3", "milli": "1e-3", "u": "1e-6", "µ": "1e-6", "μ": "1e-6", "micro": "1e-6",
}  # fmt: skip

_RUSSIAN = {
    "м": "m", "Н": "N", "рад": "rad", "Дж": "J", "с": "s", "г": "g", "К": "K", "Па": "Pa", "бар": "bar", "Вт": "W",
    "град": "deg", "кгс": "kgf", "об": "rev", "мин": "min", "ч": "h",
}  # fmt: skip
_RUSSIAN_PREFIXES = {"к": "k", "М": "M", "Г": "G", "д": "d", "с": "c", "м": "m", "мк": "u"}

_COMMON = ("kN", "MN", "mm", "cm", "MPa", "kPa", "GPa", "ms", "kg", "Nm", "кН", "мм", "см", "МПа", "мс", "кг")
"""Units to suggest before others."""

FREEZING = Decimal("273.15")
"""0 °C in kelvin."""
SCALES: dict[str, dict[str, Decimal]] = {
    "K abs": {"K": Decimal(0), "К": Decimal(0)} | dict.fromkeys(("degC", "°C", "°С"), FREEZING),
}
"""UnitProduct of a field that counts from a zero of its own → scale as written → its zero, in SI."""


class UnitProduct(NamedTuple):
    """A unit, or a product of units."""

    factor: Decimal
    """How many SI units it is."""
    exponents: tuple[int, ...]
    """Powers of ``_BASES``."""
    latin: str
    """How it is written in Latin letters."""


class UnknownUnitError(ValueError):
    """A word that is no unit; ``args`` hold it."""


@cache
def _words() -> dict[str, UnitProduct]:
    """Every word that is a unit."""
    known = {name: UnitProduct(Decimal(1), tuple(int(name == base) for base in _BASES), name) for name in _BASES}
    table = {
        prefix + name: (by, *si.split(), prefix + name)
        for prefix, by in {"": "1", **_PREFIXES}.items()
        for name, si in _PREFIXED.items()
    }
    table |= {name: ("1", *si.split(), name) for name, si in _PLAIN.items()}
    for prefix, latin_prefix in {"": "", **_RUSSIAN_PREFIXES}.items():
        for name, latin in _RUSSIAN.items():
            if not prefix or latin in _PREFIXED:
                table.setdefault(prefix + name, table[latin_prefix + latin])
    powers = {si: _product(si, known).exponents for si in {si for _, _, si, _ in table.values()}}
    for word, (by, number, si, latin) in table.items():
        known[word] = UnitProduct(Decimal(by) * Decimal(number), powers[si], latin)
    return known


_SIGNS = str.maketrans({"·": "*", "⋅": "*", "×": "*", "⁻": "-", "−": "-", "¹": "1", "²": "2", "³": "3", "⁴": "4"})
_FACTOR = re.compile(r"(\s*[*/]\s*|\s+|)([^\W\d_]+|°)(?:\^?(-?[1-4])(?!\d))?")
_DIVISOR = re.compile(r"/\s*\(([^()/]*)\)")


def _product(text: str, words: Mapping[str, UnitProduct]) -> UnitProduct:
    """Read a product such as ``kN*m/rad``, ``1/min``, ``min^-1``, ``J/(kg*K)`` or ``kgm2``.

    Raises:
        UnknownUnitError: a word of it is no unit.
        ValueError: it is no product.
    """
    plain = text.translate(_SIGNS).replace("**", "^").strip()
    plain = _DIVISOR.sub(lambda match: "/" + re.sub(r"\s*\*\s*|\s+", "/", match[1].strip()), plain)
    plain = re.sub(r"^1\s*(?=/)", "", plain)
    factor, exponents, latin, at = Decimal(1), [0] * len(_BASES), "", 0
    while at < len(plain) or not at:
        match = _FACTOR.match(plain, at)
        if match is None or (match[1] == "" if at else "*" in match[1]):
            raise ValueError(text)
        sign = -1 if "/" in match[1] else 1
        for unit, power in _factors(match[2], sign * int(match[3] or 1), sign, words):
            factor *= unit.factor**power
            exponents = [total + power * more for total, more in zip(exponents, unit.exponents, strict=True)]
        latin += match[1] + "*".join(unit.latin for unit, _ in _factors(match[2], 1, 1, words)) + (match[3] or "")
        at = match.end()
    return UnitProduct(factor, tuple(exponents), latin)


def _factors(word: str, power: int, sign: int, words: Mapping[str, UnitProduct]) -> list[tuple[UnitProduct, int]]:
    """Units that a word is made of, with their powers: one, or a force or mass with a length (Nm, kgm2)."""
    for name in (word, word.removesuffix("s") if len(word) > len("hour") else word):
        if name in words:
            return [(words[name], power)]
    for at in range(1, len(word)):
        head, tail = words.get(word[:at]), words.get(word[at:])
        if head and tail and head.latin[-1] in "Ng" and tail.latin in ("m", "cm", "mm"):
            return [(head, sign), (tail, power)]
    raise UnknownUnitError(word)


@cache
def factor(text: str, unit: str) -> Decimal:
    """How many SI units of the field one ``text`` is; decimal, so that 15 cm^3 is exactly 15e-6 m^3.

    Raises:
        ValueError: no unit, or one of another dimension than the field's ``unit``.
    """
    try:
        given = _product(text, _words())
    except UnknownUnitError as error:
        if hint := _in_one_alphabet(text, unit):
            raise ValueError(say("unknown unit {text!r}{hint}", text=text, hint=hint)) from None
        (word,) = error.args
        near = did_you_mean(word, [name for name in (*_COMMON, *_words()) if _fits(text.replace(word, name), unit)])
        message = say("unknown unit {names!r}{hint}; {allowed}", names=word, hint=near, allowed=allowed(unit))
        raise ValueError(message) from None
    except ValueError:
        raise ValueError(say("{text!r} is not a unit; {allowed}", text=text, allowed=allowed(unit))) from None
    if given.exponents == _product(unit, _words()).exponents:
        return given.factor
    if unit == "rad/s" and given == _product("1/min", _words())._replace(latin=given.latin):
        return _RPM  # a speed of rotation in 1/min is one of revolutions; in 1/s it could be either
    kinds = {si: kind for si, (kind, _) in EXAMPLES.items() if si != "1" and si not in SCALES} | _FOREIGN
    others = (term(kind) for si, kind in kinds.items() if _product(si, _words()).exponents == given.exponents)
    other = next(others, say("of dimension {dimension}", dimension=_dimension(given.exponents)))
    raise ValueError(
        say("{text} is {other}, not {kind}; {allowed}", text=text, other=other, kind=_kind(unit), allowed=allowed(unit))
    )


def _fits(text: str, unit: str) -> bool:
    """Whether a text is a unit of the dimension of ``unit``."""
    try:
        return _product(text, _words()).exponents == _product(unit, _words()).exponents
    except ValueError:
        return False


def _dimension(exponents: tuple[int, ...]) -> str:
    powers = zip(_BASES, exponents, strict=True)
    return "*".join(base if power == 1 else f"{base}^{power}" for base, power in powers if power) or "1"


_CYRILLIC = str.maketrans("ABEKMHOPCTXacekmop", "АВЕКМНОРСТХасекмор")


def _in_one_alphabet(text: str, unit: str) -> str:
    """Hint for a unit of the field that is typed with letters of two alphabets, or of the wrong one; else nothing."""
    meant = text.translate(_CYRILLIC)
    if not _fits(meant, unit):
        return ""
    latin = _product(meant, _words()).latin
    return say("; write {latin!r}, or {meant!r} in Cyrillic letters alone", latin=latin, meant=meant)


def allowed(unit: str) -> str:
    """Say what may stand in a field of the SI unit ``unit``."""
    kind, example = EXAMPLES[unit]
    if unit == "1":
        return say("give {kind} such as {example}", kind=term(kind), example=example)
    return say(
        'give {kind}: a number in SI ({unit}) or a string with a unit such as "{example}"',
        kind=term(kind),
        unit=unit,
        example=example,
    )


_LONGEST = 100
"""Characters of a quantity that is worth reading."""
_QUANTITY = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)(.*)", re.DOTALL)
_GROUPED = re.compile(r"\s*([+-]?\d(?:[\d ,.]*?\d)??)(?:\s+(1\s*/.*)|\s*([^\d\s,.].*)?)", re.DOTALL)
"""A number that may have groups and a comma, and its unit, which may be ``1/m``."""

_DECIMAL_COMMA = re.compile(r"\s*([+-]?\d+),(\d+\s*[^\d\s,.].*)", re.DOTALL)
_THOUSANDS = re.compile(r"[+-]?[1-9]\d{0,2},\d{3}(?!\d)")
"""A comma that may be that of groups."""

RARELY_SI: dict[str, tuple[Callable[[float], bool], str]] = {
    "N": (lambda force: 0 < force < 20, "kN"),
    "m": (lambda length: length >= 0.5, "mm"),
    "rad/s": (lambda speed: speed > 1000, "rpm"),
}
"""SI unit → whether a number is rarely meant in it, and the unit that may be meant."""
_LARGEST = {"m": 10.0}
"""SI unit → number above which it cannot be meant."""


def asked_unit(value: object, unit: str | None, path: str = "") -> Finding | None:
    """Ask after a number without a unit that is rarely meant in SI; None for any other value.

    Raises:
        ValueError: it is never meant in SI.

    >>> asked_unit(2, "N", "force").message, asked_unit("2 N", "N")
    ('force: a number without a unit is in SI, 2 N; 2 kN? Write "2 kN" or "2 N"', None)
    """
    if unit not in RARELY_SI or isinstance(value, bool | str) or not isinstance(value, int | float):
        return None
    rare, other = RARELY_SI[unit]
    if not rare(value) or not value <= sys.float_info.max:
        return None
    given, meant = f"{value:g} {unit}", f"{value:g} {other}"
    if value > _LARGEST.get(unit, math.inf):
        message = say(
            'a number without a unit is in SI, and {given} is too large: write "{meant}"', given=given, meant=meant
        )
        raise ValueError(message)
    return finding("number-without-unit", "warning", value=float(value), path=path, given=given, meant=meant)


def parse_quantity(value: object, unit: str) -> float:
    """Read a number in SI, or a string such as ``"20 N/mm"``, as a quantity in SI of the dimension of ``unit``.

    Raises:
        ValueError: not a number, not finite, an unknown unit or one of another dimension.

    >>> parse_quantity("20 N/mm", "N/m")
    20000.0
    """
    if isinstance(value, bool):
        raise ValueError(say("a boolean is not {kind}; {allowed}", kind=_kind(unit), allowed=allowed(unit)))
    if isinstance(value, str):
        number = _parse_text(value, unit)
    elif isinstance(value, int | float):
        number = float(value) if abs(value) <= sys.float_info.max else math.inf
    else:
        raise ValueError(say("{kind} is wanted; {allowed}", kind=_kind(unit), allowed=allowed(unit)))
    if not math.isfinite(number):
        raise ValueError(say("must be finite; {allowed}", allowed=allowed(unit)))
    return number


def _kind(unit: str) -> str:
    return term(EXAMPLES[unit][0])


def _parse_text(text: str, unit: str) -> float:
    if (comma := _DECIMAL_COMMA.fullmatch(text)) and localized("0.5") == "0,5" and not _THOUSANDS.match(text.strip()):
        text = f"{comma[1]}.{comma[2]}"
    match = _QUANTITY.fullmatch(text) if len(text) <= _LONGEST else None
    if match is None:
        raise ValueError(say("cannot be read as a number with a unit; {allowed}", allowed=allowed(unit)))
    number, written = match[1], match[2].strip()
    if unread := unread_number(text):
        raise ValueError(unread)
    if not written:
        raise ValueError(say("has no unit; {allowed}", allowed=allowed(unit)))
    if unit == "1":
        raise ValueError(say("is dimensionless and takes no unit; {allowed}", allowed=allowed(unit)))
    if unit not in SCALES:
        zero, times = Decimal(0), factor(written, unit)
    elif written in SCALES[unit]:
        zero, times = SCALES[unit][written], Decimal(1)
    else:
        message = say("{text!r} is no unit of {kind}; {allowed}", text=written, kind=_kind(unit), allowed=allowed(unit))
        raise ValueError(message)
    try:
        return float(Decimal(number) * times + zero)
    except ArithmeticError:  # an exponent beyond those of Decimal; that of 0 counts too
        return float(number)


def whole_number(value: object) -> int:
    """Read a number that counts something.

    Raises:
        ValueError: it is none.
    """
    if isinstance(value, str) and value.strip().isdecimal():
        raise ValueError(say("must be a whole number, without quotes: {number}", number=value.strip()))
    if isinstance(value, bool) or not isinstance(value, int | float) or value != value // 1:
        raise ValueError(say("must be a whole number"))
    return int(value)


def unread_number(text: str, *, quoted: bool = False) -> str | None:
    """Say how a number with a decimal comma or with its digits in groups is to be written; None when it has neither.

    >>> unread_number("0,5 mm"), unread_number("2 000")
    ('a decimal comma is not read: write 0.5 mm', 'spaces in a number are not read: write 2000')
    """
    match = _GROUPED.fullmatch(text)
    if match is None or not set(match[1]) & set(", "):
        return None

    unit = (match[2] or match[3] or "").strip()

    def written(number: str) -> str:
        whole = f"{number} {unit}".strip()
        return f'"{whole}"' if quoted and unit else whole

    number = match[1].replace(" ", "")
    if "," not in number:
        return say("spaces in a number are not read: write {number}", number=written(number))
    if "." in number or number.count(",") > 1:
        decimal = "," if number.rfind(",") > number.rfind(".") and number.count(",") == 1 else "."
        whole = "".join(sign for sign in number if sign == decimal or sign not in ",.").replace(",", ".")
        return say("a number has no commas: write {number}", number=written(whole))
    point = written(number.replace(",", "."))
    if _THOUSANDS.fullmatch(number):
        grouped = written(number.replace(",", ""))
        return say("a comma is not read: write {grouped} or {point}, whichever is meant", grouped=grouped, point=point)
    return say("a decimal comma is not read: write {point}", point=point)
