"""Samples of the scattering numbers, in replicates of their own streams.

The sample is cut into a fixed number of replicates, each with its own stream and its own statistics: they run in any
number of threads and blocks and still give the same digits, and the spread between them is the standard error.
"""

import inspect
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Protocol, TypeVar

import numpy as np

from ...errors import AfmcalcError
from ...messages import say
from .distributions import Array, Input, normal_probability, normal_score
from .model import Model

REPLICATES = 32
CELL = 16384
"""Numbers drawn at once: what stays in the cache."""
Found = TypeVar("Found")


def sizes(samples: int, quasi: bool) -> list[int]:
    """Sizes of the replicates; a Sobol sequence needs powers of two."""
    if quasi:
        each = 1 << max(5, -(-samples // REPLICATES) - 1).bit_length()
        return [each] * REPLICATES
    whole, rest = divmod(samples, REPLICATES)
    return [whole + (index < rest) for index in range(REPLICATES)]


class Stream:
    """Random or quasi-random columns, one per input, cell by cell."""

    def __init__(self, inputs: Sequence[Input], seed: int, replicate: int, *, quasi: bool, model: Model) -> None:
        """Open the stream of one replicate; ``inputs`` may hold an input more than once (Sobol indices)."""
        self.inputs, self.pair, self.correlation = inputs, model.pair, model.correlation
        self.generator = np.random.Generator(np.random.SFC64(np.random.SeedSequence(seed, spawn_key=(replicate,))))
        self.sequence = sobol_sequence(len(inputs), self.generator) if quasi else None

    def fill(self, columns: Sequence[Array]) -> None:
        """Fill one cell: an array per input, all of one length."""
        points = None if self.sequence is None else self.sequence.random(len(columns[0]))
        for number, (each, column) in enumerate(zip(self.inputs, columns, strict=True)):
            if points is not None:
                column[...] = each.quantiles(points[:, number])
            elif not self._paired(number):
                each.draw(self.generator, column)
        if self.pair is not None:
            for start in range(0, len(self.inputs), self._period):
                self._correlate(columns, points, (start + self.pair[0], start + self.pair[1]))

    @property
    def _period(self) -> int:
        return len({each.path for each in self.inputs})

    def _paired(self, number: int) -> bool:
        return self.pair is not None and number % self._period in self.pair

    def _correlate(self, columns: Sequence[Array], points: Array | None, pair: tuple[int, int]) -> None:
        """Fill the two frictions by a Gaussian copula."""
        first, second = pair
        if points is None:
            one, two = (self.generator.standard_normal(len(columns[first])) for _ in pair)
        else:
            one, two = normal_score(points[:, first]), normal_score(points[:, second])
        two = self.correlation * one + (1 - self.correlation**2) ** 0.5 * two
        columns[first][...] = self.inputs[first].quantiles(normal_probability(one))
        columns[second][...] = self.inputs[second].quantiles(normal_probability(two))


class Points(Protocol):
    """A quasi-random sequence."""

    def random(self, n: int) -> Array:
        """Return the next ``n`` points, a row each."""


def sobol_sequence(dimensions: int, generator: np.random.Generator) -> Points:
    """Return SciPy's scrambled Sobol sequence.

    Raises:
        AfmcalcError: SciPy is not installed.
    """
    try:
        from scipy.stats import qmc
    except ImportError:
        raise AfmcalcError(say("quasi-Monte Carlo needs SciPy: pip install 'afmcalc[stats]'")) from None
    # the argument was renamed; either way the generator is ours
    name = "rng" if "rng" in inspect.signature(qmc.Sobol.__init__).parameters else "seed"
    found: Points = qmc.Sobol(dimensions, scramble=True, **{name: generator})
    return found


def cells(size: int) -> Iterator[int]:
    """Cut a replicate into cells: the width of each."""
    for start in range(0, size, CELL):
        yield min(CELL, size - start)


def in_threads(work: Callable[[int], Found], count: int, threads: int) -> list[Found]:
    """Results of ``work(0…count−1)`` in order, whatever the threads."""
    if threads <= 1:
        return [work(index) for index in range(count)]
    pool = ThreadPoolExecutor(threads)
    try:
        return list(pool.map(work, range(count)))
    finally:
        # after Ctrl-C nothing new is begun
        pool.shutdown(cancel_futures=True)
