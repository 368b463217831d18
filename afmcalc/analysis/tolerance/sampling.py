"""Samples of the scattering numbers, in replicates of their own streams.

The sample is cut into a fixed number of replicates, each with its own stream and its own statistics: they run in any
number of threads and blocks and still give the same digits, and the spread between them is the standard error.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

from ...engines import build
from ...engines.protocol import Clutch
from ...errors import AfmcalcError
from ...spec import Spec
from ...spec.edit import with_value
from ...spec.tolerance import FRICTION
from .distributions import Input, normal_probability, normal_score

REPLICATES = 32
CELL = 16384
"""Numbers drawn at once: what stays in the cache."""


@dataclass(frozen=True)
class Model:
    """The torque of a clutch as a function of what scatters."""

    spec: Spec
    inputs: Sequence[Input]
    correlation: float = 0.0
    """Of f_1 and f_2."""
    _means: tuple[float, float] = field(init=False, default=(0.0, 0.0))

    def __post_init__(self) -> None:
        """Note the friction where none scatters."""
        first, second = self.spec.friction.groups
        object.__setattr__(self, "_means", (first.mean, second.mean))

    @property
    def pair(self) -> tuple[int, int] | None:
        """Places of the two correlated frictions."""
        names = [each.path for each in self.inputs]
        if self.correlation and "friction.driving" in names and "friction.driven" in names:
            return names.index("friction.driving"), names.index("friction.driven")
        return None

    def clutch(self, values: Sequence[Any]) -> Clutch:
        """Engine with values (numbers or arrays) in place of those of the spec."""
        spec = self.spec
        for each, value in zip(self.inputs, values, strict=True):
            if each.path not in FRICTION:
                spec = with_value(spec, each.path.split("."), value)
        return build(spec)

    def torque(self, values: Sequence[Any], clutch: Clutch | None = None) -> Any:
        """Slip torque, N·m."""
        clutch = clutch or self.clutch(values)
        named = {each.path: value for each, value in zip(self.inputs, values, strict=True)}
        common = named.get("friction")
        if common is not None or not self.spec.friction.unlike:
            return clutch.torque(self._means[0] if common is None else common)
        return clutch.torque(
            named.get("friction.driving", self._means[0]), named.get("friction.driven", self._means[1])
        )


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
        import numpy as np

        self.inputs, self.pair, self.correlation = inputs, model.pair, model.correlation
        self.generator = np.random.Generator(np.random.SFC64(np.random.SeedSequence(seed, spawn_key=(replicate,))))
        self.sequence = sobol_sequence(len(inputs), self.generator) if quasi else None

    def fill(self, columns: Sequence[Any]) -> None:
        """Fill one cell: an array per input, all of one length."""
        width = len(columns[0])
        if self.sequence is not None:
            points = self.sequence.random(width)
            for number, (each, column) in enumerate(zip(self.inputs, columns, strict=True)):
                column[...] = each.quantiles(points[:, number])
            uniform = points
        else:
            uniform = None
            for number, (each, column) in enumerate(zip(self.inputs, columns, strict=True)):
                if not self._paired(number):
                    each.draw(self.generator, column)
        for start in range(0, len(self.inputs), len(self.inputs) if self.pair is None else self._period):
            self._correlate(columns, uniform, start)

    @property
    def _period(self) -> int:
        return len({each.path for each in self.inputs})

    def _paired(self, number: int) -> bool:
        return self.pair is not None and number % self._period in self.pair

    def _correlate(self, columns: Sequence[Any], uniform: Any, start: int) -> None:
        """Fill the two frictions by a Gaussian copula."""
        if self.pair is None:
            return
        first, second = (start + place for place in self.pair)
        if uniform is None:
            self.generator.standard_normal(out=columns[first])
            self.generator.standard_normal(out=columns[second])
            one, two = columns[first].copy(), columns[second].copy()
        else:
            one, two = normal_score(uniform[:, first]), normal_score(uniform[:, second])
        two = self.correlation * one + (1 - self.correlation**2) ** 0.5 * two
        columns[first][...] = self.inputs[first].quantiles(normal_probability(one))
        columns[second][...] = self.inputs[second].quantiles(normal_probability(two))


def sobol_sequence(dimensions: int, generator: Any) -> Any:
    """Return SciPy's scrambled Sobol sequence.

    Raises:
        AfmcalcError: SciPy is not installed.
    """
    try:
        from scipy.stats import qmc
    except ImportError:
        raise AfmcalcError("quasi-Monte Carlo needs SciPy: pip install 'afmcalc[stats]'") from None
    import inspect

    # the argument was renamed; either way the generator is ours
    name = "rng" if "rng" in inspect.signature(qmc.Sobol.__init__).parameters else "seed"
    return qmc.Sobol(dimensions, scramble=True, **{name: generator})


def cells(size: int, block: int) -> Iterator[list[int]]:
    """Cut a replicate into blocks of whole cells, each block a list of cell widths."""
    per_block = max(1, block // CELL)
    while size > 0:
        widths: list[int] = []
        while size > 0 and len(widths) < per_block:
            widths.append(min(CELL, size))
            size -= widths[-1]
        yield widths


def in_threads(work: Callable[[int], Any], count: int, threads: int) -> list[Any]:
    """Results of ``work(0…count−1)`` in order, whatever the threads."""
    if threads <= 1:
        return [work(index) for index in range(count)]
    from concurrent.futures import ThreadPoolExecutor

    pool = ThreadPoolExecutor(threads)
    try:
        return list(pool.map(work, range(count)))
    finally:
        # after Ctrl-C nothing new is begun
        pool.shutdown(cancel_futures=True)
