"""The figures of a distribution of torque, read off a sample or off the exact answer."""

from collections.abc import Callable, Sequence
from typing import Literal, NamedTuple

from ...spec.tolerance import Tolerance
from .exact import Exact
from .histogram import histogram_of_exact, histogram_of_sample
from .result import Estimate, Histogram
from .sobol import Index
from .tally import Tally, deviation, estimate, mean, merged, quantiles, spread

ROBUST = (0.005, 0.995)
"""Probabilities whose quantiles stand for the smallest and largest torque."""


class Figures(NamedTuple):
    """What is told of the torque, however it was found."""

    method: Literal["exact", "monte-carlo", "quasi-monte-carlo"]
    samples: int | None
    mean: Estimate
    deviation: Estimate
    robust: Estimate
    """K_т,r."""
    quantiles: list[Estimate]
    above_limit: Estimate | None
    below_machine: Estimate
    life: tuple[Estimate, Estimate] | None
    """Protected, unprotected side."""
    sobol: list[Index]
    histogram: Histogram


def exact_figures(exact: Exact, given: Tolerance, machine: float) -> Figures:
    """Figures without error."""
    average = exact.mean_of(lambda torque: torque)
    low, high = (exact.quantile(p) for p in ROBUST)
    limit = given.torque_limit
    name = " + ".join(each.path for each in exact.model.inputs)
    return Figures(
        method="exact",
        samples=None,
        mean=Estimate(average),
        deviation=Estimate(exact.mean_of(lambda torque: (torque - average) ** 2) ** 0.5),
        robust=Estimate(high / low),
        quantiles=[Estimate(exact.quantile(p)) for p in given.quantiles],
        above_limit=None if limit is None else Estimate(1 - exact.below(limit)),
        below_machine=Estimate(exact.below(machine)),
        life=_lives(*(Estimate(damage) for damage in exact.damages())) if exact.model.spec.fatigue else None,
        sobol=[Index(name, Estimate(1.0), Estimate(1.0))],
        histogram=histogram_of_exact(exact),
    )


def sampled_figures(tallies: Sequence[Tally], given: Tolerance, sobol: list[Index], *, has_life: bool) -> Figures:
    """Figures of a sample, the error of each from its spread between the replicates."""
    whole = merged(tallies)
    asked = [*given.quantiles, *ROBUST]
    by_replicate = [quantiles(each, asked) for each in tallies]
    found = quantiles(whole, asked)
    errors = [spread([row[k] for row in by_replicate]) for k in range(len(asked))]
    damages = [estimate(lambda t: t.damage / t.count, tallies, whole),
               estimate(lambda t: t.damage_unprotected / t.count, tallies, whole)]  # fmt: skip
    return Figures(
        method="quasi-monte-carlo" if given.method == "quasi-monte-carlo" else "monte-carlo",
        samples=whole.count,
        mean=estimate(mean, tallies, whole),
        deviation=estimate(deviation, tallies, whole),
        robust=Estimate(found[-1] / found[-2], spread([row[-1] / row[-2] for row in by_replicate])),
        quantiles=[Estimate(*pair) for pair in zip(found, errors, strict=True)][: len(given.quantiles)],
        above_limit=None if given.torque_limit is None else _share(lambda t: t.above / t.count, tallies, whole),
        below_machine=_share(lambda t: t.below / t.count, tallies, whole),
        life=_lives(*damages) if has_life else None,
        sobol=sobol,
        histogram=histogram_of_sample(whole),
    )


def _share(figure: Callable[[Tally], float], tallies: Sequence[Tally], whole: Tally) -> Estimate:
    """A probability; where no sample or every sample counts, the spread is 0, but the error is not."""
    found = estimate(figure, tallies, whole)
    return found._replace(standard_error=max(1 / whole.count, found.standard_error))


def _lives(protected: Estimate, unprotected: Estimate) -> tuple[Estimate, Estimate]:
    """Lives by damages; the error of 1/x is that of x over x²."""

    def life(damage: Estimate) -> Estimate:
        return Estimate(1 / damage.value, damage.standard_error / damage.value**2)

    return life(protected), life(unprotected)
