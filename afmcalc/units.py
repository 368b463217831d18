"""The only table of units, and the grammar of their products; other modules refer to a unit by its name."""

import re
from collections.abc import Mapping
from decimal import Decimal
from functools import cache
from typing import NamedTuple

# An angle and an energy are dimensions of their own, so that 0.1 rad is no coefficient and 200 J is no torque.
BASES = ("m", "N", "rad", "J", "s", "kg", "K")


def table(text: str) -> dict[str, str]:
    """Name → value, from a text ``names = value; …`` in which several names may share a value."""
    rows = (row.split(" = ") for row in re.split(r";\s", text))
    return {name: value for names, value in rows for name in names.split()}


PREFIXED = table("""\
m meter metre = 1 m; N newton = 1 N; rad radian = 1 rad; J joule = 1 J; s second = 1 s; g gram = 1e-3 kg;
K kelvin = 1 K; Pa pascal = 1 N/m^2; bar = 1e5 N/m^2; W watt = 1 J/s""")
PLAIN = table("""\
in inch = 25.4e-3 m; ft foot = 0.3048 m; lbf = 4.4482216152605 N; kgf kp = 9.80665 N;
psi = 6894.757293168361336722673445 N/m^2; ksi = 6894757.293168361336722673445 N/m^2;
rpm = 0.1047197551196597746154214461 rad/s; deg degree ° = 0.01745329251994329576923690768489 rad;
rev revolution U = 6.283185307179586476925286766559 rad; min minute = 60 s; h hour = 3600 s""")
"""Unit → its value in SI; the units in ``PREFIXED`` may also have a prefix."""
PREFIXES = table("""\
k kilo = 1e3; M mega = 1e6; G giga = 1e9; d deci = 0.1; c centi = 0.01; m milli = 1e-3; u µ μ micro = 1e-6""")

RUSSIAN = table("""\
м = m; Н = N; рад = rad; Дж = J; с = s; г = g; К = K; Па = Pa; бар = bar; Вт = W; град = deg; кгс = kgf;
об = rev; мин = min; ч = h""")
RUSSIAN_PREFIXES = table("""\
к = k; М = M; Г = G; д = d; с = c; м = m; мк = u""")

ZEROS = {"K": Decimal(0), "К": Decimal(0)} | dict.fromkeys(("degC", "°C", "°С"), Decimal("273.15"))
"""Scale of a temperature, in Latin or Cyrillic letters → its zero point, K."""

ENGINEER = table("""\
N = kN; m = mm; m^3 = cm^3; N/m = N/mm; 1/m = 1/mm; rad = deg; Pa = MPa; J = kJ; W = kW; J/m^2 = J/mm^2;
W/m^2 = W/mm^2; N^2/m^2 = N^2/mm^2""") | {"K abs": "degC"}
"""SI unit → the unit in which engineers read the quantity, if it is not the SI unit."""


class UnitProduct(NamedTuple):
    """A unit, or a product of units."""

    factor: Decimal
    """Value in SI."""
    exponents: tuple[int, ...]
    """Exponents of ``BASES``, in their order."""
    latin: str
    """Spelling in Latin letters."""


class UnknownUnitError(ValueError):
    """A word that is no unit; ``args[0]`` is the word."""


@cache
def words() -> dict[str, UnitProduct]:
    """Name of a unit, with and without every possible prefix → the unit."""
    known = {name: UnitProduct(Decimal(1), tuple(int(name == base) for base in BASES), name) for name in BASES}
    for name, value in (PREFIXED | PLAIN).items():
        number, si = value.split()
        exponents = _product(si, known).exponents
        for prefix, by in {"": "1", **(PREFIXES if name in PREFIXED else {})}.items():
            known[prefix + name] = UnitProduct(Decimal(by) * Decimal(number), exponents, prefix + name)
    for prefix, latin_prefix in {"": "", **RUSSIAN_PREFIXES}.items():
        for name, latin in RUSSIAN.items():
            if not prefix or latin in PREFIXED:
                known.setdefault(prefix + name, known[latin_prefix + latin])
    return known


_SIGNS = str.maketrans({"·": "*", "⋅": "*", "×": "*", "⁻": "-", "−": "-", "¹": "1", "²": "2", "³": "3", "⁴": "4"})
_FACTOR = re.compile(r"(\s*[*/]\s*|\s+|)([^\W\d_]+|°)(?:\^?(-?[1-4])(?!\d))?")


@cache
def product(text: str) -> UnitProduct:
    """Unit of a product such as ``kN*m/rad``, ``1/min``, ``min^-1``, ``J/(kg*K)`` or ``kgm2``.

    Raises UnknownUnitError if a word in the text is no unit, and ValueError if the text is no product of units.
    """
    return _product(text, words())


def _product(text: str, words: Mapping[str, UnitProduct]) -> UnitProduct:
    plain = text.translate(_SIGNS).replace("**", "^").strip()
    divisor = r"/\s*\(([^()/]*)\)"
    plain = re.sub(divisor, lambda match: "/" + re.sub(r"\s*\*\s*|\s+", "/", match[1].strip()), plain)
    plain = re.sub(r"^1\s*(?=/)", "", plain)
    factor, exponents, latin, at = Decimal(1), [0] * len(BASES), "", 0
    while at < len(plain) or not at:
        match = _FACTOR.match(plain, at)
        if match is None or (match[1] == "" if at else "*" in match[1]):
            raise ValueError(text)
        *head, last = _units(match[2], words)
        sign = -1 if "/" in match[1] else 1
        for unit, power in [*((unit, sign) for unit in head), (last, sign * int(match[3] or 1))]:
            factor *= unit.factor**power
            exponents = [total + power * more for total, more in zip(exponents, unit.exponents, strict=True)]
        latin += match[1] + "*".join(unit.latin for unit in (*head, last)) + (match[3] or "")
        at = match.end()
    return UnitProduct(factor, tuple(exponents), latin)


def _units(word: str, words: Mapping[str, UnitProduct]) -> list[UnitProduct]:
    """Units that are joined in a word: a single unit, or a force or mass with a length (Nm, kgm2)."""
    for name in (word, word.removesuffix("s") if len(word) > len("hour") else word):
        if name in words:
            return [words[name]]
    for at in range(1, len(word)):
        head, tail = words.get(word[:at]), words.get(word[at:])
        if head and tail and head.latin[-1] in "Ng" and tail.latin in ("m", "cm", "mm"):
            return [head, tail]
    raise UnknownUnitError(word)


@cache
def per_si(name: str) -> float:
    """Number of units in one SI unit; 1 for a temperature scale, whose degree is as large as a kelvin.

    >>> per_si("kN"), per_si("J/mm²"), per_si("degC")
    (0.001, 1e-06, 1.0)
    """
    return 1.0 if name in ZEROS else float(1 / product(name).factor)


def in_unit(value: float, name: str) -> float:
    """SI value converted to the unit or temperature scale ``name``.

    >>> in_unit(0.1, "mm"), in_unit(300.15, "°C")
    (100.0, 27.0)
    """
    return (value - float(ZEROS.get(name, 0))) * per_si(name)


def typeset(unit: str) -> str:
    """Name of a unit as typeset; empty for a pure number.

    >>> typeset("kg*m^2"), typeset("degC"), typeset("1")
    ('kg·m²', '°C', '')
    """
    name = unit.removesuffix(" abs").replace("degC", "°C").replace("*", "·").replace("^2", "²").replace("^3", "³")
    return "" if name == "1" else name
