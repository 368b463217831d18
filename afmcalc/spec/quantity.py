"""Quantities in a spec: a number in SI, or a string with a unit of the right dimension."""

import math
import re
from collections.abc import Callable
from decimal import Decimal

from ..messages import localized, say, term
from ..source import Unlikely
from .units import EXAMPLES, SCALES, allowed, factor

_LONGEST = 100
"""Characters of a quantity that is worth reading."""
_QUANTITY = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)(.*)", re.DOTALL)
_GROUPED = re.compile(r"\s*([+-]?\d(?:[\d ,.]*?\d)??)(?:\s+(1\s*/.*)|\s*([^\d\s,.].*)?)", re.DOTALL)
"""A number that may have groups and a comma, and its unit, which may be ``1/m``."""

_DECIMAL_COMMA = re.compile(r"\s*([+-]?\d+),(\d+\s*[^\d\s,.].*)", re.DOTALL)
_THOUSANDS = re.compile(r"[+-]?[1-9]\d{0,2},\d{3}(?!\d)")
"""A comma that may be that of groups."""

_UNLIKELY: dict[str, tuple[Callable[[float], bool], str]] = {
    "N": (lambda force: 0 < force < 20, "kN"),
    "m": (lambda length: length >= 0.5, "mm"),
    "rad/s": (lambda speed: speed > 1000, "rpm"),
}
"""SI unit → whether a number is rarely meant in it, and the unit that may be meant."""
_LARGEST = {"m": 10.0}
"""SI unit → number above which it cannot be meant."""


def unlikely(value: object, unit: str | None, path: str = "") -> Unlikely | None:
    """Return a number without a unit where it is rarely or never meant in SI; None for any other value.

    >>> unlikely(2, "N").meant, unlikely("2 N", "N"), unlikely(100, "m").possible
    ('2 kN', None, False)
    """
    if unit not in _UNLIKELY or isinstance(value, bool) or not isinstance(value, int | float):
        return None
    rare, other = _UNLIKELY[unit]
    if not rare(value):
        return None
    possible = value <= _LARGEST.get(unit, math.inf)
    return Unlikely(path, float(value), f"{value:g} {unit}", f"{value:g} {other}", possible)


def impossible(found: Unlikely) -> str:
    """Say what a number without a unit cannot be."""
    return say(
        'a number without a unit is in SI, and {given} is too large: write "{meant}"',
        given=found.given,
        meant=found.meant,
    )


def parse_quantity(value: object, unit: str) -> float:
    """Read ``value`` as a quantity of the dimension of ``unit``, in SI.

    Args:
        value: a number in SI or a string such as ``"20 N/mm"``.
        unit: SI unit of the field, a key of ``units.EXAMPLES``.

    Returns:
        The number in SI.

    Raises:
        ValueError: not a number, not finite, an unknown unit or one of another dimension.

    >>> parse_quantity("20 N/mm", "N/m")
    20000.0
    """
    if isinstance(value, bool):
        raise ValueError(say("a boolean is not {kind}; {allowed}", kind=_kind(unit), allowed=allowed(unit)))
    if isinstance(value, int | float):
        number = _as_float(value)
    elif isinstance(value, str):
        number = _parse_text(value, unit)
    else:
        raise ValueError(say("{kind} is wanted; {allowed}", kind=_kind(unit), allowed=allowed(unit)))
    if not math.isfinite(number):
        raise ValueError(say("must be finite; {allowed}", allowed=allowed(unit)))
    return number


def _kind(unit: str) -> str:
    return term(EXAMPLES[unit][0])


def _as_float(value: int | float) -> float:
    try:
        return float(value)
    except OverflowError:
        return math.inf


def _parse_text(text: str, unit: str) -> float:
    if (comma := _DECIMAL_COMMA.fullmatch(text)) and localized("0.5") == "0,5" and not _THOUSANDS.match(text.strip()):
        text = f"{comma[1]}.{comma[2]}"
    match = _QUANTITY.fullmatch(text) if len(text) <= _LONGEST else None
    if match is None:
        raise ValueError(say("cannot be read as a number with a unit; {allowed}", allowed=allowed(unit)))
    number, unit_text = match[1], match[2].strip()
    if unread := unread_number(text):
        raise ValueError(unread)
    if not unit_text:
        raise ValueError(say("has no unit; {allowed}", allowed=allowed(unit)))
    if unit == "1":
        raise ValueError(say("is dimensionless and takes no unit; {allowed}", allowed=allowed(unit)))
    zero = _zero(unit_text, unit) if unit in SCALES else Decimal(0)
    times = Decimal(1) if unit in SCALES else factor(unit_text, unit)
    try:
        return float(Decimal(number) * times + zero)
    except ArithmeticError:  # an exponent beyond those of Decimal; that of 0 counts too
        return float(number)


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


def _zero(unit_text: str, unit: str) -> Decimal:
    """Where the scale ``unit_text`` begins, in SI units of the field."""
    if unit_text not in SCALES[unit]:
        raise ValueError(
            say("{text!r} is no unit of {kind}; {allowed}", text=unit_text, kind=_kind(unit), allowed=allowed(unit))
        )
    return SCALES[unit][unit_text]
