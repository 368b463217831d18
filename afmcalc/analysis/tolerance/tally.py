"""Statistics of a sample that is never held: moments, a histogram for the quantiles, tallies."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from statistics import stdev

import numpy as np
from numpy.typing import NDArray

from .distributions import Array
from .result import Estimate

BINS = 8192


@dataclass(frozen=True)
class Grid:
    """Bins of the histogram, chosen from a pilot sample."""

    low: float
    width: float

    @classmethod
    def of(cls, pilot: Array) -> "Grid":
        """Bins over the pilot's range and half of it again on either side."""
        low, high = float(pilot.min()), float(pilot.max())
        reach = max(high - low, 1e-9 * abs(high), 1e-300)
        return cls(low - reach / 2, 2 * reach / BINS)


@dataclass
class Tally:
    """What is kept of one replicate."""

    grid: Grid
    count: int = 0
    total: float = 0.0
    squares: float = 0.0
    bins: NDArray[np.int64] = field(default_factory=lambda: np.zeros(BINS, np.int64))
    outside: list[Array] = field(default_factory=list)
    """Values beyond the bins, kept as they are: few, since the bins are twice as wide as the pilot's range."""
    above: int = 0
    below: int = 0
    damage: float = 0.0
    damage_unprotected: float = 0.0

    @property
    def shift(self) -> float:
        """Middle of the bins, about which moments are summed."""
        return self.grid.low + self.grid.width * BINS / 2

    def add(self, values: Array, work: Array, index: NDArray[np.intp]) -> None:
        """Take in one cell; ``work`` and ``index`` are buffers of its length."""
        self.count += values.size
        np.subtract(values, self.shift, out=work)
        self.total += float(work.sum())
        np.multiply(work, work, out=work)
        self.squares += float(work.sum())
        np.subtract(values, self.grid.low, out=work)
        work *= 1 / self.grid.width
        if work.min() < 0 or work.max() >= BINS:
            beyond = (work < 0) | (work >= BINS)
            self.outside.append(values[beyond])
            work = work[~beyond]
            index = index[: work.size]
        np.copyto(index, work, casting="unsafe")
        self.bins += np.bincount(index, minlength=BINS)


def merged(tallies: Sequence[Tally]) -> Tally:
    """All replicates together, in their order."""
    whole = Tally(tallies[0].grid)
    for name in ("count", "above", "below"):
        setattr(whole, name, sum(getattr(each, name) for each in tallies))
    for name in ("total", "squares", "damage", "damage_unprotected"):
        setattr(whole, name, math.fsum(getattr(each, name) for each in tallies))
    for each in tallies:
        whole.bins += each.bins
        whole.outside += each.outside
    return whole


def spread(values: Sequence[float]) -> float:
    """Standard error of a figure of the whole sample, from its values in the replicates."""
    return float(stdev(values) / len(values) ** 0.5)


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


def quantiles(tally: Tally, probabilities: Sequence[float]) -> list[float]:
    """Quantiles: linear within a bin, order statistics beyond the bins."""
    outside = np.sort(np.concatenate(tally.outside)) if tally.outside else np.empty(0)
    under = int(np.searchsorted(outside, tally.grid.low))
    cumulative = under + np.cumsum(tally.bins)
    found = []
    for p in probabilities:
        rank = p * tally.count
        if rank < under:
            found.append(float(outside[int(rank)]))
        elif rank > cumulative[-1]:
            found.append(float(outside[min(under + int(rank - cumulative[-1]), outside.size - 1)]))
        else:
            place = int(np.searchsorted(cumulative, rank))
            while place < BINS - 1 and tally.bins[place] == 0:
                place += 1
            inside = (rank - (cumulative[place] - tally.bins[place])) / max(int(tally.bins[place]), 1)
            found.append(float(tally.grid.low + tally.grid.width * (place + inside)))
    return found
