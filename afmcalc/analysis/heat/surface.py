"""Temperature of the faces during a slip, whose heat flows into discs of a thickness."""

from typing import NamedTuple

import numpy as np

from ...arrays import Floats
from ...equations import heat as law

THICK = 0.05
"""Fourier number up to which a disc is as good as endlessly thick, to 1e-9."""
_WAVES = np.arange(1.0, 13.0)
"""Waves of the disc's temperature that still count at that number."""
_POINTS = 41


class Body(NamedTuple):
    """What is heated, SI."""

    conductivity: float
    density: float
    specific_heat: float
    depth: float | None
    """To the middle of the disc, m; None: endlessly thick."""

    @property
    def effusivity(self) -> float:
        """√(k ρ c)."""
        return float(law.effusivity(self.conductivity, self.density, self.specific_heat))

    def fourier(self, time: float) -> float:
        """How far the heat comes in a time; 0 in an endlessly thick disc."""
        if self.depth is None:
            return 0.0
        return float(law.fourier_number(self.conductivity, self.density, self.specific_heat, time, self.depth))


def largest_rise(body: Body, flux: float, mean: float, time: float) -> float:
    """Largest rise of a face, K.

    Args:
        body: what is heated.
        flux: into the face as the slip begins, W/m²; at most twice the mean.
        mean: its mean over the slip, W/m²: it falls evenly.
        time: of slip, s.

    Returns:
        The rise at the hottest moment, K.
    """
    fall = 2 * (flux - mean) / time
    low, high = 0.0, time
    for _ in range(6):
        moments = np.linspace(low, high, _POINTS)
        rises = _rises(body, flux, fall, moments)
        best = int(np.argmax(rises))
        low, high = moments[max(best - 1, 0)], moments[min(best + 1, _POINTS - 1)]
    return float(rises[best])


def _rises(body: Body, flux: float, fall: float, moments: Floats) -> Floats:
    """Rise at several moments."""
    thick = law.surface_rise(flux, fall, moments, body.effusivity, np.pi)
    if body.depth is None:
        return np.asarray(thick)
    own = body.conductivity, body.density, body.specific_heat, body.depth
    numbers = law.fourier_number(*own[:3], moments, body.depth)
    decay = np.exp(-((_WAVES[:, None] * np.pi) ** 2) * numbers)
    lacking = law.surface_rise_term(flux, fall, _WAVES[:, None], decay, *own, np.pi).sum(axis=0)
    rises: Floats = np.where(numbers < THICK, thick, law.surface_rise_thin(flux, fall, moments, *own) - lacking)
    return rises
