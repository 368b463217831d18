"""Quantities in a spec: a number in SI, or a string with a unit of the right dimension."""

import math
import re
import sys
from collections.abc import Callable
from decimal import Decimal
from functools import cache

from ..findings import Finding, finding
from ..messages import deferred, did_you_mean, filled, say, translate
from ..units import BASES, ZEROS, UnknownUnitError, product, table, words

_EXAMPLES = table("""\
N = a force | 2 kN; m = a length | 100 mm; N*m = a torque | 200 N*m; N/m = a stiffness | 20 N/mm;
1/m = a slope of the gain | 18.75 1/m; rad = an angle | 30 deg; Pa = a pressure or stress | 400 MPa;
m^3 = a section modulus | 15 cm^3; rad/s = a speed of rotation | 1430 rpm; W = a power | 11 kW;
m/s = a speed | 0.3 m/s; s = a time | 10 ms; kg = a mass | 2 kg; kg*m^2 = a moment of inertia | 8 kg*m^2;
N*m/rad = a torsional stiffness | 8 kN*m/rad; kg/m^3 = a density | 7850 kg/m^3;
J/kg/K = a specific heat | 480 J/kg/K; W/m/K = a thermal conductivity | 50 W/m/K;
W/K = a cooling per kelvin | 2.5 W/K; J/m^2 = a work per area | 1 J/mm^2;
m^3/J = a wear per energy | 2e-5 mm^3/J; 1 = a plain number | 0.3""") | {"K abs": "a temperature | 20 degC"}
EXAMPLES = {unit: tuple(row.split(" | ")) for unit, row in _EXAMPLES.items()}
"""SI unit of a field → the quantity, and an example of a value."""

_FOREIGN = {"J": deferred("an energy"), "m^2": deferred("an area"), "K": deferred("a temperature difference")}
"""SI unit of a dimension that no field has → name of the quantity."""

_COMMON = ("kN", "MN", "mm", "cm", "MPa", "kPa", "GPa", "ms", "kg", "Nm", "кН", "мм", "см", "МПа", "мс", "кг")
"""Units to suggest before others."""


NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
"""A number as it is read."""


def wrong(template: str, unit: str, **values: object) -> ValueError:
    """Return an error about a field of the SI unit ``unit``; it fills ``kind`` and ``allowed`` of the template."""
    return ValueError(filled(template, {"kind": translate(EXAMPLES[unit][0]), "allowed": allowed(unit), **values}))


@cache
def factor(text: str, unit: str) -> Decimal:
    """Return the value of one ``text`` in the SI unit of a field, as a decimal: 15 cm^3 is exactly 15e-6 m^3.

    A ``ValueError`` says that it is no unit, or one of another dimension than the field's ``unit``.
    """
    try:
        given = product(text)
    except UnknownUnitError as error:
        (word,) = error.args
        near = did_you_mean(word, [name for name in (*_COMMON, *words()) if _fits(text.replace(word, name), unit)])
        raise wrong("unknown unit {names!r}{hint}; {allowed}", unit, names=word, hint=near) from None
    except ValueError:
        raise wrong("{text!r} is not a unit; {allowed}", unit, text=text) from None
    if given.exponents == product(unit).exponents:
        return given.factor
    if unit == "rad/s" and given == product("1/min")._replace(latin=given.latin):
        return product("rpm").factor  # a speed of rotation in 1/min is one of revolutions; in 1/s it could be either
    kinds = {si: kind for si, (kind, _) in EXAMPLES.items() if si not in ("1", "K abs")} | _FOREIGN
    other = next((translate(kind) for si, kind in kinds.items() if product(si).exponents == given.exponents), None)
    if other is None:
        powers = [(base, power) for base, power in zip(BASES, given.exponents, strict=True) if power]
        bases = ((translate(base, "unit"), power) for base, power in powers)
        raised = [base if power == 1 else say("{base}^{power}", base=base, power=power) for base, power in bases]
        dimension = "*".join(raised) if raised else "1"
        other = say("of dimension {dimension}", dimension=dimension)
    raise wrong("{text} is {other}, not {kind}; {allowed}", unit, text=text, other=other)


def _fits(text: str, unit: str) -> bool:
    """True if a text is a unit of the dimension of ``unit``."""
    try:
        return product(text).exponents == product(unit).exponents
    except ValueError:
        return False


def allowed(unit: str) -> str:
    """Say what may stand in a field of the SI unit ``unit``."""
    kind, example = EXAMPLES[unit]
    if unit == "1":
        return say("give {kind} such as {example}", kind=translate(kind), example=example)
    return say(
        'give {kind}: a number in SI ({unit}) or a string with a unit such as "{example}"',
        kind=translate(kind), unit=translate(unit, "unit"), example=example,
    )  # fmt: skip


_LONGEST = 100
"""Largest number of characters of a text that is read as a quantity."""
_QUANTITY = re.compile(rf"\s*({NUMBER})(.*)", re.DOTALL)
_COMMA = re.compile(r"\s*([+-]?)(\d+),(\d+)(?![\d.,])(.*)", re.DOTALL)
"""A number with one comma: sign, digits before and after it, the unit."""

_RARELY_SI: dict[str, tuple[Callable[[float], bool], str, float]] = {
    "N": (lambda force: 0 < force < 20, "kN", math.inf), "m": (lambda length: length >= 0.5, "mm", 10.0),
    "rad/s": (lambda speed: speed > 1000, "rpm", math.inf), "W": (lambda power: 0 < power < 500, "kW", math.inf),
}  # fmt: skip
"""SI unit → whether a number is rarely meant in it, the unit that may be meant, the largest number meant in SI."""


def asked_unit(value: object, unit: str | None, path: str = "") -> Finding | None:
    """Return a finding for a number without a unit that is rarely meant in SI; None for any other value.

    Raises:
        ValueError: the number is so large that it is never meant in SI.

    >>> asked_unit(2, "N", "force").message, asked_unit("2 N", "N")
    ('force: a number without a unit is in SI, 2 N; 2 kN? Write "2 kN" or "2 N"', None)
    """
    if unit not in _RARELY_SI or isinstance(value, bool) or not isinstance(value, int | float):
        return None
    rare, other, largest = _RARELY_SI[unit]
    if not rare(value) or not value <= sys.float_info.max:
        return None
    given, meant = f"{value:g} {unit}", f"{value:g} {other}"
    if value > largest:
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
        raise wrong("a boolean is not {kind}; {allowed}", unit)
    if isinstance(value, str):
        number = _parse_text(value, unit)
    elif isinstance(value, int | float):
        number = float(value) if abs(value) <= sys.float_info.max else math.inf
    else:
        raise wrong("{kind} is wanted; {allowed}", unit)
    if not math.isfinite(number):
        raise wrong("must be finite; {allowed}", unit)
    return number


def with_point(text: str) -> str:
    """Return the text of one number with a point for its decimal comma.

    Raises:
        ValueError: the comma may separate thousands.

    >>> with_point("2,5 kN"), with_point("0,125"), with_point("2 kN")
    ('2.5 kN', '0.125', '2 kN')
    """
    if (match := _COMMA.fullmatch(text)) is None:
        return text
    sign, whole, decimals, unit = match.groups()
    if len(decimals) == 3 and 0 < int(whole) < 1000:
        point, grouped = f"{sign}{whole}.{decimals}{unit}", f"{sign}{whole}{decimals}{unit}"
        raise ValueError(say("{text}: {point} or {grouped}?", text=text.strip(), point=point, grouped=grouped))
    return f"{sign}{whole}.{decimals}{unit}"


def _parse_text(text: str, unit: str) -> float:
    match = _QUANTITY.fullmatch(with_point(text)) if len(text) <= _LONGEST else None
    if match is None:
        raise wrong("cannot be read as a number with a unit; {allowed}", unit)
    number, written = match[1], match[2].strip()
    if not written and unit == "1":
        return float(number)
    if not written:
        raise wrong("has no unit; {allowed}", unit)
    if unit == "1":
        raise wrong("is dimensionless and takes no unit; {allowed}", unit)
    absolute = unit == "K abs"
    if absolute and written not in ZEROS:
        raise wrong("{text!r} is no unit of {kind}; {allowed}", unit, text=written)
    zero, times = (ZEROS[written], Decimal(1)) if absolute else (Decimal(0), factor(written, unit))
    try:
        return float(Decimal(number) * times + zero)
    except ArithmeticError:  # the exponent is outside the range of Decimal, perhaps in a number that is 0
        return float(number)


def whole_number(value: object) -> int:
    """Read a number that counts something; a ``ValueError`` where it is none."""
    if isinstance(value, str) and value.strip().isdecimal():
        raise ValueError(say("must be a whole number, without quotes: {number}", number=value.strip()))
    if isinstance(value, bool) or not isinstance(value, int | float) or value != value // 1:
        raise ValueError(say("must be a whole number"))
    return int(value)
