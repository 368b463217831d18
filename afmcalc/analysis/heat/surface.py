"""Temperature of faces and disc during a slip, whose heat flows into disc and lining, layers of a depth."""

from collections.abc import Callable
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
        ends, rises = _over_time(course, end, lambda p: 1 / (p * sum(each.admittance(p) for each in bodies)))
        best = int(np.argmax(rises))
        if best >= _FINE:
            break
        end = ends[2 * best + 2]
    return float(rises[best])


def most_in_disc(bodies: list[Body], course: Course) -> float:
    """Largest heat per area in the disc, the first of the bodies, J/m².

    Of the flux Y_d/ΣY flows into it, as it is as hot as the lining where they touch. The mean of the disc is never
    above the largest rise of the faces: no place within a body that is heated at its face alone is ever hotter than
    the face has been (maximum principle of the equation of heat).
    """
    disc = bodies[0].admittance
    _, heats = _over_time(
        course, course.time[-1], lambda p: disc(p) / (p * p * sum(each.admittance(p) for each in bodies))
    )
    return float(heats.max())


def _over_time(course: Course, end: float, transform: Callable[[Floats], Floats]) -> tuple[Floats, Floats]:
    """Times until an end, and what the flux gives at all but the first, of its transform under an even flux of 1."""
    ends = np.linspace(course.time[0], end, _PANELS + 1)
    flux = np.diff(course.heat_at(ends)) / np.diff(ends)
    steps = np.diff(_inverse(transform, ends - ends[0]))
    return ends, np.convolve(flux, steps)[:_PANELS]


def _inverse(transform: Callable[[Floats], Floats], times: Floats) -> Floats:
    """What a transform is of, at several times, the first of them 0 (Abate and Valkó 2004)."""
    angle = np.arange(1, _TERMS) * np.pi / _TERMS
    cot = 1 / np.tan(angle)
    nodes = 0.4 * _TERMS * np.concatenate([[1.0], angle * (cot + 1j)])
    weights = np.exp(nodes) * np.concatenate([[0.5], 1 + 1j * angle * (1 + cot * cot) - 1j * cot])
    values: Floats = 0.4 / times[1:] * (weights[:, None] * transform(nodes[:, None] / times[1:])).real.sum(axis=0)
    return np.concatenate([[0.0], values])
