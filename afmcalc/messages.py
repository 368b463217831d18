"""What is said to people: a sentence per finding, numbers set by their unit.

A sentence is a template of ``str.format`` whose fields may end in a unit people use: ``{force:.5g kN}`` sets a force
given in N. So a sentence holds no arithmetic and a value stays SI; another language is another table.
"""

import math
import string
from collections.abc import Mapping
from typing import Any

SCALES = {
    "N": 1.0,
    "kN": 1e-3,
    "mm": 1e3,
    "N·m": 1.0,
    "N/mm": 1e-3,
    "kPa": 1e-3,
    "MPa": 1e-6,
    "deg": 180 / math.pi,
}
"""Unit of a field → what a value in SI is multiplied by."""


class _Sentence(string.Formatter):
    """``str.format`` whose numbers may carry a unit."""

    def format_field(self, value: Any, format_spec: str) -> Any:
        number, _, unit = format_spec.partition(" ")
        if not unit:
            return super().format_field(value, number)
        return f"{super().format_field(value * SCALES[unit], number)} {unit}"


def say(template: str, /, **values: Any) -> str:
    """Fill a template.

    >>> say("the force is {force:.5g kN}, {times:g} times too much", force=2000.0, times=2)
    'the force is 2 kN, 2 times too much'
    """
    return _Sentence().vformat(template, (), values)


FINDINGS: Mapping[str, str] = {
    "no-candidate": "none of {candidates:,} candidates meets every requirement: {listed}",
}
"""Code of a finding → its sentence."""


def sentence(code: str, values: Mapping[str, Any]) -> str:
    """Return the sentence of a finding."""
    return say(FINDINGS[code], **values)
