"""Histogram of the torque: the sample's own fine bins drawn together, or exact shares."""

import numpy as np

from .exact import Exact
from .result import Histogram
from .tally import BINS, Tally, quantiles

CENTRAL = (0.0005, 0.9995)
"""Probabilities between whose quantiles the bars lie: a long tail would leave them no width."""
_BARS = 60


def histogram_of_sample(tally: Tally) -> Histogram:
    """Draw the fine bins of a sample together, the fewer bars the smaller it is (2·∛n, at most 60)."""
    low, high = quantiles(tally, CENTRAL)
    if _is_single(low, high):
        return Histogram(edges=[], probabilities=[])
    grid = tally.grid
    first, last = (int(np.clip((end - grid.low) // grid.width, 0, BINS - 1)) for end in (low, high))
    bars = min(_BARS, round(2 * tally.count ** (1 / 3)))
    each = -(-(last + 1 - first) // bars)
    count = -(-(last + 1 - first) // each)
    fine = np.pad(tally.bins[first : first + count * each], (0, max(0, first + count * each - BINS)))
    return Histogram(
        edges=(grid.low + grid.width * (first + each * np.arange(count + 1))).tolist(),
        probabilities=(fine.reshape(count, each).sum(axis=1) / tally.count).tolist(),
    )


def histogram_of_exact(exact: Exact) -> Histogram:
    """Exact probability of each bar."""
    low, high = (exact.quantile(p) for p in CENTRAL)
    if _is_single(low, high):
        return Histogram(edges=[], probabilities=[])
    edges = np.linspace(low, high, _BARS + 1)
    return Histogram(edges=edges.tolist(), probabilities=np.diff(exact.all_below(edges)).tolist())


def _is_single(low: float, high: float) -> bool:
    return high - low <= 1e-9 * abs(high)
