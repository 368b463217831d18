"""Histogram of the torque: bars of equal width, their probabilities by rank or exact."""

from collections.abc import Callable

import numpy as np

from .distributions import Array
from .exact import Exact
from .ranked import Ranked
from .result import Histogram

CENTRAL = (0.0005, 0.9995)
"""Probabilities between whose quantiles the bars lie: a long tail would leave them no width."""
_BARS = 60


def histogram_of_sample(torques: Ranked) -> Histogram:
    """Histogram of a sample, the fewer bars the smaller it is (2·∛n, at most 60)."""
    bars = min(_BARS, round(2 * torques.size ** (1 / 3)))
    return _histogram(torques.quantile, torques.shares_below, bars)


def histogram_of_exact(exact: Exact) -> Histogram:
    """Exact probability of each bar."""
    return _histogram(exact.quantile, exact.all_below, _BARS)


def _histogram(quantile: Callable[[float], float], below: Callable[[Array], Array], bars: int) -> Histogram:
    low, high = (quantile(p) for p in CENTRAL)
    if high - low <= 1e-9 * abs(high):
        return Histogram(edges=[], probabilities=[])
    edges = np.linspace(low, high, bars + 1)
    return Histogram(edges=edges.tolist(), probabilities=np.diff(below(edges)).tolist())
