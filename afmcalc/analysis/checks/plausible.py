"""What can be made and calculated, yet is so unusual that a slip of the pen is likelier than a purpose.

The ranges are wide: they are no limits of a design, they find a millimetre written for a metre.
"""

import math
from collections.abc import Iterator
from typing import NamedTuple

from ...engines.protocol import Clutch
from ...findings import Finding, finding
from ...spec.edit import value_at
from ...spec.materials import catalogue
from ..answers import Answers
from ..registry import ANALYSES
from ..unit import SynthesisResult

FRICTION = (0.02, 1.0)
"""The papers have 0.1 to 0.8; dry rubber and clean metal in a vacuum are beyond, neither is a friction lining."""
MEAN_RADIUS = (0.01, 1.0)
"""m."""
PAIRS = (1, 40)
MARGIN = (1.0, 3.0)
WALL_ANGLE = (math.radians(5), math.radians(60))
"""Steeper the ball hardly bears along the axis, flatter it hardly bears around it."""
BALL_CIRCLE = (0.2, 2.0)
"""Of the mean friction radius."""
PRESSURE = (1e3, 5e6)
"""Pa, of the pack's force over a full disc of the mean radius; linings bear 0.05 to 2 MPa."""
DEFLECTION = (0.0, 2.0)
"""Of the mean friction radius: a spring deflected by more is longer than the clutch is wide."""


class _Figure(NamedTuple):
    """A figure of the design, and between what it usually lies."""

    code: str
    path: str
    value: float
    usual: tuple[float, float]


def unusual_findings(answers: Answers) -> list[Finding]:
    """Say of every figure outside its usual range what it is and what is usual."""
    linings = catalogue().values()
    least, most = min(each.friction_min for each in linings), max(each.friction_max for each in linings)
    found = []
    for code, path, value, (low, high) in (*_of_the_pack(answers.clutch), *_of_the_control_unit(answers)):
        if not low * (1 - 1e-9) <= value <= high * (1 + 1e-9):
            limit = low if value < low else high
            own = finding(
                code, "warning", value=value, limit=limit, path=path, low=low, high=high, least=least, most=most
            )
            found.append(own)
    return found


def _of_the_pack(clutch: Clutch) -> Iterator[_Figure]:
    spec, radius = clutch.spec, float(clutch.mean_radius)
    blocks = ("friction.driving", "friction.driven") if spec.friction.unlike else ("friction",)
    for path, each in zip(blocks, clutch.friction, strict=False):
        yield _Figure("unusual/friction", f"{path}.min", each.min, FRICTION)
        yield _Figure("unusual/friction", f"{path}.max", each.max, FRICTION)
    yield _Figure("unusual/mean-radius", "friction_group.mean_radius", radius, MEAN_RADIUS)
    yield _Figure("unusual/pairs", "friction_group.pairs", spec.friction_group.pairs, PAIRS)
    yield _Figure("unusual/margin", "adjustment.margin", spec.adjustment.margin, MARGIN)
    pressure = float(clutch.pack_force_at_rest) / (math.pi * radius**2)
    yield _Figure("unusual/pressure", "closing_spring.force", pressure, PRESSURE)
    deflected = (DEFLECTION[0], DEFLECTION[1] * radius)
    springs = {"closing_spring": clutch.closing_force, "control_spring": clutch.control_force}
    for name, force in springs.items():
        if force is not None and (stiffness := value_at(spec, f"{name}.stiffness")):
            yield _Figure("unusual/deflection", f"{name}.stiffness", float(force) / stiffness, deflected)


def _of_the_control_unit(answers: Answers) -> Iterator[_Figure]:
    clutch = answers.clutch
    if not ANALYSES["synthesize"].applies(clutch):
        return
    found, radius = answers.of(SynthesisResult), float(clutch.mean_radius)
    own = "wall_angle" if value_at(clutch.spec, "control_unit.gain") is None else "gain"
    yield _Figure("unusual/wall-angle", f"control_unit.{own}", found.wall_angle, WALL_ANGLE)
    circle = (BALL_CIRCLE[0] * radius, BALL_CIRCLE[1] * radius)
    yield _Figure("unusual/ball-circle", "control_unit.ball_circle_radius", found.ball_circle_radius, circle)
