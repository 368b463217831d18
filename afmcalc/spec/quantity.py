"""Reading of quantities in a spec: a number in SI, or a string with a unit of the right dimension."""

import math
import operator
import re
import sys
from collections.abc import Callable
from dataclasses import dataclass
from decimal import Decimal
from functools import cache, partial
from typing import Any, TypeGuard

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema, core_schema

from ..findings import Finding, finding
from ..messages import deferred, did_you_mean, filled, say, translate
from ..units import ZEROS, UnknownUnitError, product, table, words

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
"""SI unit of a field → name of the quantity, and an example of a value."""

_FOREIGN = {"J": deferred("an energy"), "m^2": deferred("an area"), "K": deferred("a temperature difference")}
"""SI unit of a quantity that no field has → its name, for messages."""

_COMMON = ("kN", "MN", "mm", "cm", "MPa", "kPa", "GPa", "ms", "kg", "Nm", "кН", "мм", "см", "МПа", "мс", "кг")
"""Units that are suggested before others."""

NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
"""Pattern of a number."""


def wrong(template: str, unit: str, **values: object) -> ValueError:
    """Error about a field with the SI unit ``unit``; ``kind`` and ``allowed`` are filled into the template."""
    return ValueError(filled(template, {"kind": translate(EXAMPLES[unit][0]), "allowed": allowed(unit), **values}))


@cache
def factor(text: str, unit: str) -> Decimal:
    """Factor from the unit ``text`` to a field's SI ``unit``, as a decimal: for cm^3 exactly 1e-6.

    Raises ValueError if ``text`` is no unit, or a unit of another dimension.
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
        return product("rpm").factor  # 1/min counts revolutions; 1/s could also be radians
    kinds = {si: kind for si, (kind, _) in EXAMPLES.items() if si not in ("1", "K abs")} | _FOREIGN
    other = next((translate(kind) for si, kind in kinds.items() if product(si).exponents == given.exponents), None)
    if other is None:
        raise wrong("{text!r} is no unit of {kind}; {allowed}", unit, text=text)
    raise wrong("{text} is {other}, not {kind}; {allowed}", unit, text=text, other=other)


def _fits(text: str, unit: str) -> bool:
    """True if a text is a unit with the dimension of ``unit``."""
    try:
        return product(text).exponents == product(unit).exponents
    except ValueError:
        return False


def allowed(unit: str) -> str:
    """Part of a message: the values allowed in a field with the SI unit ``unit``."""
    kind, example = EXAMPLES[unit]
    if unit == "1":
        return say("give {kind} such as {example}", kind=translate(kind), example=example)
    return say(
        'give {kind}: a number in SI ({unit}) or a string with a unit such as "{example}"',
        kind=translate(kind), unit=translate(unit, "unit"), example=example,
    )  # fmt: skip


_LONGEST = 100
"""Largest number of characters of a text that is read as a quantity."""

_RARELY_SI: dict[str, tuple[Callable[[float], bool], str, float]] = {
    "N": (lambda force: 0 < force < 20, "kN", math.inf), "m": (lambda length: length >= 0.5, "mm", 10.0),
    "rad/s": (lambda speed: speed > 1000, "rpm", math.inf), "W": (lambda power: 0 < power < 500, "kW", math.inf),
}  # fmt: skip
"""SI unit → test for numbers rarely meant in this unit, unit probably meant, largest number accepted without unit."""


def asked_unit(value: object, unit: str | None, path: str = "") -> Finding | None:
    """Warning about a number without a unit that is probably not meant in SI; None for any other value.

    Raises ValueError if the number is too large to be meant in SI.

    >>> asked_unit(2, "N", "force").message, asked_unit("2 N", "N")
    ('force: a number without a unit is in SI, 2 N; 2 kN? Write "2 kN" or "2 N"', None)
    """
    if unit not in _RARELY_SI or not is_number(value) or not value <= sys.float_info.max:
        return None
    rare, other, largest = _RARELY_SI[unit]
    given, meant = f"{value:g} {unit}", f"{value:g} {other}"
    if value > largest:
        raise ValueError(
            say('a number without a unit is in SI, and {given} is too large: write "{meant}"', given=given, meant=meant)
        )
    if rare(value):
        return finding("number-without-unit", "warning", value=float(value), path=path, given=given, meant=meant)
    return None


def is_number(value: object) -> TypeGuard[float]:
    """True for a number, not for a boolean."""
    return isinstance(value, int | float) and not isinstance(value, bool)


def parse_quantity(value: object, unit: str) -> float:
    """Number in the SI ``unit``, from a number or a string such as ``"20 N/mm"``.

    Raises ValueError if it is not a number, not finite, or has an unknown unit or a unit of another dimension.

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
    """Text of a number with its decimal comma replaced by a point; ValueError if it may separate thousands.

    >>> with_point("2,5 kN"), with_point("0,125"), with_point("2 kN")
    ('2.5 kN', '0.125', '2 kN')
    """
    # sign, digits before and after the comma, the rest
    if (match := re.fullmatch(r"(?s)\s*([+-]?)(\d+),(\d+)(?![\d.,])(.*)", text)) is None:
        return text
    sign, whole, decimals, unit = match.groups()
    if len(decimals) == 3 and 0 < int(whole) < 1000:
        point, grouped = f"{sign}{whole}.{decimals}{unit}", f"{sign}{whole}{decimals}{unit}"
        raise ValueError(say("{text}: {point} or {grouped}?", text=text.strip(), point=point, grouped=grouped))
    return f"{sign}{whole}.{decimals}{unit}"


def _parse_text(text: str, unit: str) -> float:
    match = re.fullmatch(rf"(?s)\s*({NUMBER})(.*)", with_point(text)) if len(text) <= _LONGEST else None
    if match is None:
        raise wrong("cannot be read as a number with a unit; {allowed}", unit)
    number, written = match[1], match[2].strip()
    if unit == "1" and not written:
        return float(number)
    if unit == "1":
        raise wrong("is dimensionless and takes no unit; {allowed}", unit)
    if not written:
        raise wrong("has no unit; {allowed}", unit)
    if unit == "K abs" and written not in ZEROS:
        raise wrong("{text!r} is no unit of {kind}; {allowed}", unit, text=written)
    try:
        return float(Decimal(number) + ZEROS[written] if unit == "K abs" else Decimal(number) * factor(written, unit))
    except ArithmeticError:  # the exponent is outside the range of Decimal; float gives 0 or inf
        return float(number)


def whole_number(value: object) -> int:
    """Value as a whole number; raises ``ValueError`` if it is not whole."""
    if isinstance(value, str) and value.strip().isdecimal():
        raise ValueError(say("must be a whole number, without quotes: {number}", number=value.strip()))
    if not is_number(value) or value != value // 1:
        raise ValueError(say("must be a whole number"))
    return int(value)


_BOUNDS = {
    "gt": deferred("must be greater than {bound:g}"),
    "ge": deferred("must be at least {bound:g}"),
    "lt": deferred("must be less than {bound:g}"),
    "le": deferred("must be at most {bound:g}"),
}
"""Kind of bound, a comparison of ``operator`` → message if a number does not pass it."""
_OF_UNIT = {
    ("rad", "lt"): deferred("must be less than 90 deg; a number without a unit is in rad"),
    ("K abs", "ge"): deferred("must be at least {bound:g} K (-100 degC); a number without a unit is in K"),
}


@dataclass(frozen=True)
class Quantity:
    """Unit and bounds of a number in a spec: metadata of the annotation, which tables and sweeps read."""

    unit: str
    """SI unit, a key of ``EXAMPLES``."""
    gt: float | None = None
    ge: float | None = None
    lt: float | None = None
    le: float | None = None
    whole: bool = False

    @property
    def limits(self) -> tuple[float, float]:
        """Lower and upper bound, whether inclusive or not; ±inf without a bound."""
        low, high = self.ge if self.gt is None else self.gt, self.le if self.lt is None else self.lt
        return -math.inf if low is None else float(low), math.inf if high is None else float(high)

    @property
    def bounds(self) -> list[tuple[str, float]]:
        """Bounds, each with its kind, such as ``ge``."""
        return [(name, bound) for name in _BOUNDS if (bound := getattr(self, name)) is not None]

    def read(self, value: object) -> float:
        """Number in SI, from a number or a string with a unit; ValueError if it is not, or is out of bounds."""
        number = whole_number(value) if self.whole else parse_quantity(value, self.unit)
        for name, bound in self.bounds:
            if not getattr(operator, name)(number, bound):
                raise ValueError(filled(_OF_UNIT.get((self.unit, name), _BOUNDS[name]), {"bound": bound}))
        return number

    # pydantic's usual way, an annotation for each step, would take three times as long at every start
    def __get_pydantic_core_schema__(self, source: object, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Schema that calls ``read``, which checks the bounds; the bounds are repeated for the JSON Schema."""
        number: Any = core_schema.int_schema if self.whole else core_schema.float_schema
        return core_schema.no_info_before_validator_function(self.read, number(**dict(self.bounds)))

    def __get_pydantic_json_schema__(self, core: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """JSON Schema: a number, or also a string if it has a unit."""
        number = handler(core)
        as_text = self.unit != "1" and handler.mode == "validation"
        return {"anyOf": [number, {"type": "string"}]} if as_text else number


positive, not_negative = partial(Quantity, gt=0), partial(Quantity, ge=0)
"""Unit of a number greater than 0, and of one that is at least 0."""
