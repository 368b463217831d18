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
    "returning-below-nominal": "when friction falls from f_max to f_min under a load that lasts, the torque falls to "
    "{value:.5g N·m}, below the nominal torque {limit:.5g N·m}: the friction at the key holds the sleeve back",
    "unexpected-verdict": "{row}: {verdict}; on record is: {record}",
    "below-nominal-torque": "the torque falls to {value:.5g N·m} in service, below the nominal torque {limit:.5g N·m}",
    "feedback-idle": "the gain is 0: the control unit gives no release force, the clutch is an ordinary one",
    "feedback-idle/key": "C equals 2 R f_1/d = {limit:.5g}: the key holds the sleeve, the clutch is an ordinary one",
    "gain-above-limit": (
        "C = {value:.4g} is above 1/(z_1 f_1max) = {limit:.4g}: at f_max the bypass pairs alone may carry "
        "{peak:.5g N·m} before the balls take over, the sustained torque is {sustained:.5g N·m}"
    ),
    "hysteresis": (
        "the key's friction gives hysteresis: while the load lasts, the sleeve returns only when friction has "
        "fallen {value:.4g} times, and the torque then stays below the rising branch; full unloading reseats it"
    ),
    "material": "{name}: friction {low:g}…{high:g} from the catalogue ({source})",
    "nominal-torque-missed": (
        "closing_spring.force is given, so it decides: it gives a nominal torque of {value:.5g N·m}, "
        "not the {limit:.5g N·m} of adjustment.nominal_torque"
    ),
    "reduced-gain-above-limit": "the reduced gain zC = {value:.4g} is above the recommended {limit:g} (S22)",
    "torque-falls": "the torque falls as the friction of both groups rises: the largest torque is at f_min",
}
"""Code of a finding, with its case where it has several → its sentence."""


def sentence(code: str, values: Mapping[str, Any]) -> str:
    """Return the sentence of a finding."""
    return say(FINDINGS[code], **values)
