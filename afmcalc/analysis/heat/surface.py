"""Temperature of the faces during a slip, whose heat flows into disc and lining, layers of a depth."""

from typing import NamedTuple

import numpy as np

from ...arrays import Floats
from ...equations import heat as law
from .course import Course

_TERMS = 16
"""Terms of the inverse transform: nine digits."""
_DEEP = 20.0
_PANELS = 1024
"""Parts of the time, each of even flux: the largest rise to 1e-4."""
_FINE = 128
"""Panels before which the largest rise is looked for again, in a shorter time."""


class Body(NamedTuple):
    """What is heated, SI."""

    conductivity: float
    density: float
    specific_heat: float
    depth: float | None
    """To the middle of the disc, or through the lining, m; None: endlessly thick."""

    def admittance(self, variable: Floats) -> Floats:
        """Flux into the face per rise, both transformed."""
        own = self.conductivity, self.density, self.specific_heat
        through = np.ones_like(variable)
        if self.depth is not None:
            deep = law.fourier_number(*own, 1 / variable, self.depth) ** -0.5
            # beyond that it is 1 to the last digit, and its exponentials too large
            through = np.tanh(np.where(deep.real > _DEEP, _DEEP, deep))
        found: Floats = law.face_admittance(law.effusivity(*own), variable**0.5, through)
        return found


def largest_rise(bodies: list[Body], course: Course) -> float:
    """Largest rise of a face, K.

    Args:
        bodies: what is heated: disc, or disc and lining, whose faces are equally hot.
        course: of the flux, W/m².

    Returns:
        The rise at the hottest moment, K.
    """
    end = course.time[-1]
    for _ in range(8):
        ends = np.linspace(course.time[0], end, _PANELS + 1)
        flux = np.diff(course.heat_at(ends)) / np.diff(ends)
        steps = np.diff(_rises(bodies, ends - ends[0]))
        rises = np.convolve(flux, steps)[:_PANELS]
        best = int(np.argmax(rises))
        if best >= _FINE:
            break
        end = ends[2 * best + 2]
    return float(rises[best])


def _rises(bodies: list[Body], times: Floats) -> Floats:
    """Rise of the face under an even flux of 1 at several times, from its transform (Abate and Valkó 2004)."""
    angle = np.arange(1, _TERMS) * np.pi / _TERMS
    cot = 1 / np.tan(angle)
    nodes = 0.4 * _TERMS * np.concatenate([[1.0], angle * (cot + 1j)])
    weights = np.exp(nodes) * np.concatenate([[0.5], 1 + 1j * angle * (1 + cot * cot) - 1j * cot])
    at = nodes[:, None] / times[1:]
    transform = 1 / (at * sum(each.admittance(at) for each in bodies))
    rises: Floats = 0.4 / times[1:] * (weights[:, None] * transform).real.sum(axis=0)
    return np.concatenate([[0.0], rises])
