"""The figures of a distribution of torque, read off a sample or off the exact answer."""

from collections.abc import Callable, Sequence
from typing import Literal, NamedTuple

import numpy as np

from ...spec.tolerance import Tolerance
from .exact import Exact
from .histogram import histogram_of_exact, histogram_of_sample
from .model import Model
from .ranked import Population, spread
from .result import Estimate, Histogram
from .sobol import Index
from .tally import Tally, deviation, estimate, mean, merged, ranked, ranked_values

ROBUST = (0.005, 0.995)
"""Probabilities whose quantiles stand for the smallest and largest torque."""


LIFE_PROBABILITIES = (0.01, 0.1, 0.5)
"""Of the quantiles of life: the share of clutches that have failed by then."""


class Life(NamedTuple):
    """Slips to failure of one side, over the clutches."""

    harmonic: Estimate
    """By the mean damage of a slip."""
    quantiles: list[Estimate]


class Figures(NamedTuple):
    """What is told of the torque, however it was found."""

    method: Literal["exact", "monte-carlo", "quasi-monte-carlo"]
    samples: int | None
    no_clutch: Estimate | None
    mean: Estimate
    deviation: Estimate
    robust: Estimate
    """K_т,r."""
    quantiles: list[Estimate]
    above_limit: Estimate | None
    below_machine: Estimate
    lives: tuple[Life, ...]
    """Protected, unprotected side; none without a part whose life is asked for."""
    sobol: list[Index]
    histogram: Histogram


def exact_figures(exact: Exact, given: Tolerance, machine: float) -> Figures:
    """Figures without error."""
    average = exact.mean_of(lambda torque: torque)
    low, high = (exact.quantile(p) for p in ROBUST)
    limit = given.torque_limit
    name = " + ".join(each.path for each in exact.model.inputs)
    lives = [Estimate(life) for life in exact.lives()] if exact.model.spec.fatigue else []
    return Figures(
        method="exact",
        samples=None,
        no_clutch=None,
        mean=Estimate(average),
        deviation=Estimate(exact.mean_of(lambda torque: (torque - average) ** 2) ** 0.5),
        robust=Estimate(high / low),
        quantiles=[Estimate(exact.quantile(p)) for p in given.quantiles],
        above_limit=None if limit is None else Estimate(1 - exact.below(limit)),
        below_machine=Estimate(exact.below(machine)),
        lives=tuple(Life(life, [life] * len(LIFE_PROBABILITIES)) for life in lives),
        sobol=[Index(name, Estimate(1.0), Estimate(1.0))],
        histogram=histogram_of_exact(exact),
    )


def sampled_figures(model: Model, tallies: Sequence[Tally], given: Tolerance, sobol: list[Index]) -> Figures:
    """Figures of a sample; errors of moments and probabilities from their spread between the replicates."""
    whole = merged(tallies)
    quasi = given.method == "quasi-monte-carlo"
    torques = Population(ranked(whole), [ranked(each) for each in tallies] if quasi else [])
    return Figures(
        method="quasi-monte-carlo" if quasi else "monte-carlo",
        samples=whole.count + whole.impossible,
        no_clutch=_share(lambda t: t.impossible / (t.count + t.impossible), tallies, whole) if model.may_fail else None,
        mean=estimate(mean, tallies, whole),
        deviation=estimate(deviation, tallies, whole),
        robust=torques.ratio(*ROBUST),
        quantiles=[torques.quantile(p) for p in given.quantiles],
        above_limit=None if given.torque_limit is None else _share(lambda t: t.above / t.count, tallies, whole),
        below_machine=_share(lambda t: t.below / t.count, tallies, whole),
        lives=tuple(_life(tallies, side) for side in (0, 1)) if whole.lives else (),
        sobol=sobol,
        histogram=histogram_of_sample(torques.whole),
    )


def _share(figure: Callable[[Tally], float], tallies: Sequence[Tally], whole: Tally) -> Estimate:
    """A probability; where no sample or every sample counts, the spread is 0, but the error is not."""
    found = estimate(figure, tallies, whole)
    return found._replace(standard_error=max(1 / whole.count, found.standard_error))


def _life(tallies: Sequence[Tally], side: int) -> Life:
    parts = [np.concatenate([lives[side] for lives in each.lives]) for each in tallies]
    whole = np.concatenate(parts)
    damage = float((1 / whole).mean())
    # the error of 1/x is that of x over x²
    error = spread([float((1 / part).mean()) for part in parts]) / damage**2
    lives = ranked_values(whole)
    return Life(Estimate(1 / damage, error), [lives.estimate(p) for p in LIFE_PROBABILITIES])
