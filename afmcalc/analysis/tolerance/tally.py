"""Statistics of a sample that is never held: moments, a histogram for the quantiles, tallies."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from .bins import BINS, Grid
from .distributions import Array
from .ranked import Ranked, spread
from .result import Estimate


@dataclass
class Tally:
    """What is kept of one replicate."""

    grid: Grid
    shift: float
    """A torque in the middle of the sample, about which moments are summed."""
    count: int = 0
    impossible: int = 0
    """Samples that are no clutch; the rest is told of the others."""
    total: float = 0.0
    squares: float = 0.0
    bins: NDArray[np.int64] = field(default_factory=lambda: np.zeros(BINS, np.int64))
    outside: list[Array] = field(default_factory=list)
    """Values beyond the bins, kept as they are: few, since the bins are twice as wide as the pilot's range."""
    above: int = 0
    below: int = 0
    lives: list[Array] = field(default_factory=list)
    """Slips to failure of the first clutches, a row for each side."""

    @property
    def clutches(self) -> int:
        """How many lives there are."""
        return sum(each.shape[1] for each in self.lives)

    def add(self, values: Array, work: Array, index: NDArray[np.uint64]) -> None:
        """Take in one cell; ``work`` and ``index`` are buffers of its length."""
        self.count += values.size
        np.subtract(values, self.shift, out=work)
        self.total += float(work.sum())
        np.multiply(work, work, out=work)
        self.squares += float(work.sum())
        self.grid.number(values, index)
        if values.size and index.max() >= BINS:
            beyond = index >= BINS
            self.outside.append(values[beyond])
            index = index[~beyond]
        self.bins += np.bincount(index.view(np.int64), minlength=BINS)


def merged(tallies: Sequence[Tally]) -> Tally:
    """All replicates together, in their order."""
    whole = Tally(tallies[0].grid, tallies[0].shift)
    for name in ("count", "impossible", "above", "below"):
        setattr(whole, name, sum(getattr(each, name) for each in tallies))
    for name in ("total", "squares"):
        setattr(whole, name, math.fsum(getattr(each, name) for each in tallies))
    for each in tallies:
        whole.bins += each.bins
        whole.outside += each.outside
        whole.lives += each.lives
    return whole


def estimate(figure: Callable[[Tally], float], tallies: Sequence[Tally], whole: Tally) -> Estimate:
    """A figure of the whole sample, its error from its spread between the replicates."""
    return Estimate(figure(whole), spread([figure(each) for each in tallies]))


def mean(tally: Tally) -> float:
    """Mean of the sample."""
    return tally.shift + tally.total / tally.count


def deviation(tally: Tally) -> float:
    """Standard deviation of the sample."""
    variance = (tally.squares - tally.total**2 / tally.count) / (tally.count - 1)
    return float(max(variance, 0.0) ** 0.5)


def ranked(tally: Tally) -> Ranked:
    """The torques of a sample by rank: those in the bins to the width of a bin, those beyond as they are."""
    edges = tally.grid.edges
    outside = np.sort(np.concatenate(tally.outside)) if tally.outside else np.empty(0)
    under = int(np.searchsorted(outside, edges[0]))
    filled = np.flatnonzero(tally.bins)
    # empty bins at either end say nothing of the range
    first, last = (int(filled[0]), int(filled[-1]) + 1) if filled.size else (0, -1)
    inner = np.concatenate([[0], np.cumsum(tally.bins[first:last])])[: last - first + 1]
    steps: Array = np.arange(outside.size, dtype=np.float64) + 0.5
    return Ranked(
        np.concatenate([outside[:under], edges[first : last + 1], outside[under:]]),
        np.concatenate([steps[:under], under + inner, tally.bins.sum() + steps[under:]]),
        tally.count,
        2.0**tally.grid.shift,
    )


def ranked_values(values: Array) -> Ranked:
    """Values by rank, kept as they are."""
    return Ranked(np.sort(values), np.arange(values.size, dtype=np.float64) + 0.5, values.size)
