"""Quantiles of a sample by rank, with errors that hold for few samples too."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from statistics import stdev

import numpy as np

from ...arrays import finite
from .distributions import Array
from .result import Estimate

_SCORE = 1.959963984540054
"""Of the normal distribution, either side of the middle 95 %."""


@dataclass(frozen=True)
class Ranked:
    """How many of a sample lie below a value; linear between the values given."""

    values: Array
    """In rising order."""
    counts: Array
    """Samples below each of them."""
    size: int
    ulps: float = 0.0
    """Resolution of the values, in units of their last place."""

    def quantile(self, p: float) -> float:
        """Value not exceeded with probability p."""
        return self._at(p * self.size)

    def estimate(self, p: float) -> Estimate:
        """Quantile, its error from the order statistics that hold it in 95 of 100 samples, and from the resolution.

        The ranks are those of the binomial distribution, so nothing is assumed of the density; where the sample ends
        before them (``needed``) the error is too small.
        """
        value, reach = self.quantile(p), _SCORE * (self.size * p * (1 - p)) ** 0.5
        interval = self._at(p * self.size + reach) - self._at(p * self.size - reach)
        resolution = self.ulps * float(np.spacing(value)) / 12**0.5
        return Estimate(value, float(np.hypot(interval / (2 * _SCORE), resolution)))

    def shares_below(self, values: Array) -> Array:
        """Share of the sample below each value."""
        shares: Array = np.interp(values, self.values, self.counts) / self.size
        return shares

    def _at(self, rank: float) -> float:
        return float(np.interp(rank, self.counts, self.values))


def needed(p: float) -> int:
    """Size of a sample that has order statistics on either side of a quantile for its error."""
    return int(np.ceil(_SCORE**2 * max(p / (1 - p), (1 - p) / p)))


@dataclass(frozen=True)
class Population:
    """A sample and, where it is quasi-random, its replicates, whose spread is then less than chance would give."""

    whole: Ranked
    replicates: Sequence[Ranked]

    def quantile(self, p: float) -> Estimate:
        """Quantile; its error from the replicates if they are large enough to have it."""
        found = self.whole.estimate(p)
        return Estimate(found.value, self._error(lambda each: each.quantile(p), (p,)) or found.standard_error)

    def ratio(self, low: float, high: float) -> Estimate:
        """Quotient of a high and a low quantile; far apart in probability, they err independently."""
        over, under = self.whole.estimate(high), self.whole.estimate(low)
        value = over.value / under.value
        relative = np.hypot(over.standard_error / over.value, under.standard_error / under.value)
        error = self._error(lambda each: each.quantile(high) / each.quantile(low), (low, high))
        return Estimate(value, error or float(value * relative))

    def _error(self, figure: Callable[[Ranked], float], probabilities: Sequence[float]) -> float | None:
        if not self.replicates or min(each.size for each in self.replicates) < max(map(needed, probabilities)):
            return None
        return spread([figure(each) for each in self.replicates])


def spread(values: Sequence[float]) -> float:
    """Standard error of a figure of the whole sample, from its values in the replicates.

    Raises:
        OverflowError: one is not finite.
    """
    for value in values:
        finite(value)
    return float(stdev(values) / len(values) ** 0.5)
