"""Quantities in a spec: a number in SI, or a string with a unit of the right dimension."""

import math
import re
from decimal import Decimal

from ..messages import say, translate
from .units import EXAMPLES, KNOWN, SCALES, SIGNS, allowed

_QUANTITY = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)(.*)", re.DOTALL)


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
    return translate(EXAMPLES[unit][0])


def _as_float(value: int | float) -> float:
    try:
        return float(value)
    except OverflowError:
        return math.inf


def _parse_text(text: str, unit: str) -> float:
    match = _QUANTITY.fullmatch(text)
    if match is None:
        raise ValueError(say("cannot be read as a number with a unit; {allowed}", allowed=allowed(unit)))
    number, unit_text = match[1], match[2].strip()
    if re.match(r",\d", unit_text):
        raise ValueError(say("a decimal comma is not read; write a decimal point"))
    if not unit_text:
        raise ValueError(say("has no unit; {allowed}", allowed=allowed(unit)))
    if unit == "1":
        raise ValueError(say("is dimensionless and takes no unit; {allowed}", allowed=allowed(unit)))
    if unit in SCALES:
        return float(Decimal(number) + _zero(unit_text, unit))
    return float(Decimal(number) * _factor(unit_text, unit))


def _zero(unit_text: str, unit: str) -> Decimal:
    """Where the scale ``unit_text`` begins, in SI units of the field."""
    if unit_text not in SCALES[unit]:
        raise ValueError(
            say("{text!r} is no unit of {kind}; {allowed}", text=unit_text, kind=_kind(unit), allowed=allowed(unit))
        )
    return SCALES[unit][unit_text]


def _factor(unit_text: str, unit: str) -> Decimal:
    """How many SI units of the field one ``unit_text`` is."""
    known = KNOWN[unit].get(unit_text.translate(SIGNS))
    if known is not None:
        return known
    from .lookup import looked_up

    return looked_up(unit_text, unit)
