"""Bins for positive numbers of any magnitude: as many to each power of two, numbered by the leading bits of a float."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .distributions import Array

BINS = 8192
_LEAST_SHARE = 1e-15
"""Smallest number that has a bin, as a share of the pilot's largest: zeros would ask for endless powers of two."""
_GREATEST = int(np.float64(np.finfo(np.float64).max).view(np.uint64))


@dataclass(frozen=True)
class Grid:
    """Bins chosen from a pilot sample, each a run of neighbouring floats that share their leading bits."""

    first: int
    """Leading bits of the first bin."""
    shift: int
    """How many of the trailing bits a bin spans."""

    @classmethod
    def of(cls, pilot: Array) -> "Grid":
        """Bins over the pilot's range and half of it again on either side, as bits go (nearly logarithmic)."""
        high = float(pilot.max())
        low = max(float(pilot.min()), _LEAST_SHARE * high)
        start, end = (int(np.float64(value).view(np.uint64)) for value in (low, max(low, high)))
        margin = max((end - start) // 2, BINS // 4)
        start, end = max(start - margin, 0), min(end + margin, _GREATEST)
        shift = 0
        while (end >> shift) - (start >> shift) >= BINS:
            shift += 1
        return cls(start >> shift, shift)

    def number(self, values: Array, into: NDArray[np.uint64]) -> None:
        """Write the number of the bin of each value; whatever has no bin, negative values too, gets BINS or more."""
        np.right_shift(values.view(np.uint64), np.uint64(self.shift), out=into)
        # below the first bin it wraps round to a number beyond the last
        np.subtract(into, np.uint64(self.first), out=into)

    @property
    def edges(self) -> Array:
        """Ends of the bins, one more than there are bins."""
        leading = np.arange(self.first, self.first + BINS + 1, dtype=np.uint64)
        ends: Array = np.minimum(leading << np.uint64(self.shift), np.uint64(_GREATEST)).view(np.float64)
        return ends
