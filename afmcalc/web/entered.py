"""Numbers at the fields of the page: shown in the unit at the field, and read in this unit if no unit is typed."""

import ast
import operator
import re
from collections.abc import Callable, Mapping
from typing import Any

from ..messages import translate
from ..render.amounts import shown_unit
from ..spec.fields import Key
from ..spec.quantity import NUMBER
from ..units import in_unit, typeset

_AT_FIELDS = {"rad/s": "rpm", "m^3/J": "mm^3/J"}
"""SI unit → unit at a field, in addition to the engineer's units: as on motor plates and in data of lining makers."""
_TERM = rf"(?:\d+,\d+|{NUMBER})"
_ENTRY = re.compile(rf"\s*([-+(]*\s*{_TERM}(?:\s*\)*\s*[-+*/]\s*[-+(]*{_TERM})*\s*\)*)\s*([^\s)].*)?", re.DOTALL)
"""Pattern of a number, or a sum or product of numbers with decimal points or commas, followed by a unit."""
_LONGEST = 100
_OPERATORS: Mapping[type[ast.AST], Callable[..., float]] = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv,
    ast.UAdd: operator.pos, ast.USub: operator.neg,
}  # fmt: skip


def unit_at_field(key: Key) -> str:
    """Unit in which a bare number at the field of a key is read; empty for a number without a unit."""
    unit = key.about.unit if key.about else "1"
    shown = _AT_FIELDS.get(unit, shown_unit(unit)) if shown_unit("N") == "kN" else unit.removesuffix(" abs")
    return "" if shown == "1" else shown


def unit_shown(key: Key) -> str:
    """Unit at the field of a key, as shown to people."""
    return translate(typeset(unit_at_field(key)), "unit")


def at_field(key: Key, value: object) -> str:
    """Text at the field of a key for a value in SI; empty for None.

    >>> from ..spec.keys import keys
    >>> at_field(keys()["closing_spring.force"], 2000.0), at_field(keys()["friction_group.pairs"], 8)
    ('2', '8')
    """
    if not isinstance(value, int | float):
        return "" if value is None else str(value)
    unit = unit_at_field(key)
    return f"{in_unit(value, unit) if unit else value:.10g}"


def as_spec(key: Key, text: str) -> str:
    """Text in a spec for a text typed at the field of a key: sums and products calculated, a missing unit added.

    >>> from ..spec.keys import keys
    >>> force = keys()["closing_spring.force"]
    >>> as_spec(force, "1.3*1,2"), as_spec(force, "2000 N"), as_spec(force, "2,5"), as_spec(force, "two")
    ('1.56 kN', '2000 N', '2,5 kN', 'two')
    """
    match = _ENTRY.fullmatch(text) if key.about and len(text) <= _LONGEST else None
    if match is None:
        return text
    number, unit = match[1].strip(), match[2]
    if re.search(r"\d\s*\)*\s*[-+*/]", re.sub(r"[eE][-+]", "", number)) or "(" in number:
        try:
            number = f"{_calculated(ast.parse(number.replace(',', '.'), mode='eval').body):.12g}"
        except (ArithmeticError, SyntaxError, TypeError):
            return text
    elif unit:
        return text
    return " ".join(filter(None, (number, unit or unit_at_field(key))))


def _calculated(node: Any) -> float:
    match node:
        case ast.Constant(int() | float() as value):
            return value
        case ast.UnaryOp(sign, operand):
            return _OPERATORS[type(sign)](_calculated(operand))
        case ast.BinOp(left, sign, right):
            return _OPERATORS[type(sign)](_calculated(left), _calculated(right))
    raise TypeError
