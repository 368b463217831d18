"""Whether pockets can cut into each other anywhere in a space."""

import math
from functools import cache

import numpy as np

from ...equations import synthesis
from ...spec.requirements import Requirements
from .space import SAME, Numbers, balls, given

_MOST = 10_000
"""Ball circles beyond which it is not asked beforehand whether pockets can meet at all."""


@cache
@np.errstate(all="ignore")
def never_meet(need: Requirements) -> bool:
    """Whether nowhere in the space pockets meet whose balls do not: a mouth is widest where the wall is flattest.

    Of direct clutches only: where a sleeve travels, a ball stands for many wall angles.
    """
    circles = given(need.search.ball_circle_radius)
    if circles.size > _MOST or need.fixed.balls < 2:
        return need.fixed.balls < 2
    fixed, listed = need.fixed, balls(need)
    circle = circles.array()[:, None]
    pitch = synthesis.ball_pitch(circle, math.sin(math.pi / fixed.balls))
    needed = fixed.face_gap + 2 * fixed.edge_clearance
    # a ball is the next standard one down to where the one before it would do
    sine = np.minimum(needed / np.concatenate([[SAME], listed[:-1]]), 1 - SAME)
    flattest = np.minimum(sine / np.sqrt(1 - sine**2), _flattest(need, circle))
    meet = (listed < pitch) & (listed >= needed) & (_mouth(listed, fixed.face_gap, flattest) >= pitch * (1 - SAME))
    return not meet.any()


def _flattest(need: Requirements, circle: Numbers) -> Numbers:
    """Largest tan α in the space."""
    if need.search.gain is None:
        return np.full(circle.shape, math.tan(given(need.search.wall_angle).array()[-1]))
    largest: Numbers = given(need.search.gain).array()[-1] * circle / need.search.least_mean_radius
    return largest


def _mouth(diameter: Numbers, gap: float, tangent: Numbers) -> Numbers:
    """Width of a pocket's mouth, m."""
    sine = tangent / np.sqrt(1 + tangent * tangent)
    width: Numbers = synthesis.pocket_width(synthesis.pocket_depth(diameter / 2, sine, gap), tangent)
    return width
