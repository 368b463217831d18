"""Torque over the tolerances of making and the scatter of service: distribution, risks, life, what matters most.

A sample is cut into a fixed number of replicates, each with its own stream and its own statistics: they run in any
number of threads and still give the same digits, and the spread between them is the standard error.
"""

import math
import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np

from ...drive.peaks import peaks_of
from ...engines import Clutch
from ...errors import AfmcalcError, CalculationError
from ...findings import Finding, finding
from ...messages import say
from ...progress import Count
from ...spec import Spec
from ...spec.edit import with_values
from ...spec.tolerance import FRICTION, Tolerance
from ..clutch_findings import clutch_findings
from ..registry import ANALYSES
from .model import Array, Model, inputs_of, normal_probability, normal_score, with_setting
from .result import (
    LIFE_PROBABILITIES,
    ROBUST,
    Estimate,
    IndexRow,
    InputRow,
    LifeRow,
    PeakRow,
    QuantileRow,
    Study,
    ToleranceResult,
)
from .service import exact_of, life_of, service_of, unprotected
from .statistics import (
    Grid,
    Ranked,
    Tally,
    deviation,
    estimate,
    histogram,
    mean,
    merged,
    needed,
    ranked,
    ranked_values,
    share,
)

REPLICATES = 32
CELL = 16384
"""Numbers drawn at once; so many stay in the processor's cache."""
POPULATION = 200_000
"""Largest number of clutches whose life is calculated: a life takes a calculation at every node of the service."""
DRIVES = 4096
"""Number of drives that are simulated; each takes thousands of steps."""
_LEAST_CLUTCHES = 2
"""Smallest number of clutches in a replicate: a single value has no spread."""
R = TypeVar("R")


@dataclass(frozen=True)
class Plan:
    """How to sample; threads change the time, never a digit."""

    samples: int
    seed: int
    quasi: bool = False
    threads: int = 1

    @property
    def sizes(self) -> list[int]:
        """Sizes of the replicates; a Sobol sequence needs powers of two."""
        if self.quasi:
            return [1 << max(5, -(-self.samples // REPLICATES) - 1).bit_length()] * REPLICATES
        whole, rest = divmod(self.samples, REPLICATES)
        return [whole + (index < rest) for index in range(REPLICATES)]

    def run(self, work: str, replicate: Callable[[int, Iterator[int]], R]) -> list[R]:
        """Return the results of all replicates in order; ``replicate`` gets its number and the widths of its cells."""
        sizes = self.sizes
        count = Count(work, sum(sizes))

        def cells(size: int) -> Iterator[int]:
            for start in range(0, size, CELL):
                count.add(width := min(CELL, size - start))
                yield width

        with ThreadPoolExecutor(self.threads) as pool:
            return list(pool.map(lambda number: replicate(number, cells(sizes[number])), range(REPLICATES)))


def drawn(
    model: Model, seed: int, stream: int, cells: Iterable[int], *, quasi: bool = False, copies: int = 1
) -> Iterator[list[Array]]:
    """Draw random or quasi-random values of what scatters from a stream, cell by cell: ``copies`` columns of each."""
    inputs, period = [*model.inputs] * copies, len(model.inputs)
    generator = np.random.Generator(np.random.SFC64(np.random.SeedSequence(seed, spawn_key=(stream,))))
    if quasi:
        from scipy.stats import qmc

        sequence = qmc.Sobol(len(inputs), scramble=True, seed=generator)
    for width in cells:
        columns = []
        points = sequence.random(width) if quasi else None
        for number, scattering in enumerate(inputs):
            if points is not None:
                columns.append(scattering.quantiles(points[:, number]))
            elif number % period in model.pair:
                columns.append(np.empty(0))
            else:
                columns.append(scattering.draw(generator, width))
        # the two frictions by a Gaussian copula
        for start in range(0, len(columns), period) if model.pair else ():
            first, second = (start + place for place in model.pair)
            if points is None:
                one, two = generator.standard_normal(width), generator.standard_normal(width)
            else:
                one, two = normal_score(points[:, first]), normal_score(points[:, second])
            two = model.correlation * one + (1 - model.correlation**2) ** 0.5 * two
            columns[first] = inputs[first].quantiles(normal_probability(one))
            columns[second] = inputs[second].quantiles(normal_probability(two))
        yield columns


def simulate(model: Model, plan: Plan, upper: float | None, lower: float) -> list[Tally]:
    """Sample the torque: a tally per replicate, which counts those above ``upper`` and below ``lower``, N·m, too.

    Raises:
        CalculationError: hardly any sample is a clutch.
    """
    # all replicates use the bins and the shift that fit the first cell of the first replicate
    pilot = model.clutches_of(next(drawn(model, plan.seed, 0, [min(CELL, plan.sizes[0])], quasi=plan.quasi)))
    _refuse_few(pilot[0].size)
    torques = np.broadcast_to(model.torque(pilot), pilot[0].shape)
    grid, shift = Grid.of(torques), float(np.median(torques))
    slips = None if model.spec.fatigue is None else service_of(model)

    def replicate(number: int, cells: Iterator[int]) -> Tally:
        tally = Tally(grid, shift)
        for columns in drawn(model, plan.seed, number, cells, quasi=plan.quasi):
            values = model.clutches_of(columns)
            size = values[0].size
            tally.impossible += columns[0].size - size
            if not size:
                continue
            torque = np.broadcast_to(model.torque(values), size)
            tally.add(torque)
            tally.above += 0 if upper is None else int(np.count_nonzero(torque > upper))
            tally.below += int(np.count_nonzero(torque < lower))
            few = min(size, POPULATION // REPLICATES - sum(lives.shape[1] for lives in tally.lives))
            if slips is not None and few > 0:
                clutch = model.clutch([column[:few] for column in values])
                life = life_of(model, clutch, slips)
                tally.lives.append(np.stack([np.broadcast_to(side, few) for side in (life, unprotected(clutch, life))]))
        return tally

    tallies = plan.run(say("sampling"), replicate)
    _refuse_few(min(tally.count for tally in tallies))
    return tallies


def _refuse_few(clutches: int) -> None:
    if clutches < _LEAST_CLUTCHES:
        raise CalculationError(
            "tolerance: hardly a sample is a clutch (feedback must overcome the key's friction, faces have a width)"
        )


def sampled_figures(model: Model, tallies: Sequence[Tally], torques: Ranked, given: Tolerance) -> dict[str, object]:
    """Fields of the result that are figures of a sample; errors of moments and probabilities from the replicates."""
    whole = merged(tallies)
    fields: dict[str, object] = {
        "method": "quasi-monte-carlo" if torques.replicates else "monte-carlo",
        "samples": whole.count + whole.impossible,
        "mean": estimate(mean, tallies, whole),
        "standard_deviation": estimate(deviation, tallies, whole),
        "accuracy_factor_robust": torques.ratio(*ROBUST),
        "probability_below_machine": share(lambda tally: tally.below / tally.count, tallies, whole),
        "quantiles": [QuantileRow.of(probability=p, torque=torques.estimate(p)) for p in given.quantiles],
    }
    if model.may_fail:
        fields["probability_no_clutch"] = share(
            lambda tally: tally.impossible / (tally.count + tally.impossible), tallies, whole
        )
    if given.torque_limit is not None:
        fields["probability_above_limit"] = share(lambda tally: tally.above / tally.count, tallies, whole)
    if whole.lives:
        sides = [np.concatenate(tally.lives, axis=1) for tally in tallies]
        protected, unprotected = (ranked_values(np.concatenate(lives)) for lives in zip(*sides, strict=True))
        for name, parts in zip(("life_protected", "life_unprotected"), zip(*sides, strict=True), strict=True):
            # life at the mean damage of all clutches, 1/E[1/N]; the error of 1/x is that of x over x²
            damage = estimate(lambda lives: (1 / lives).mean(), parts, np.concatenate(parts))
            fields[name] = Estimate(1 / damage.value, damage.standard_error / damage.value**2)
        fields["life_quantiles"] = [
            LifeRow.of(probability=p, protected=protected.estimate(p), unprotected=unprotected.estimate(p))
            for p in LIFE_PROBABILITIES
        ]
    return fields


def sobol_indices(model: Model, plan: Plan) -> list[IndexRow]:
    """First-order and total Sobol indices of the torque, ``plan.samples`` the base sample (Saltelli 2010, Jansen 1999).

    Raises:
        CalculationError: no row of the base sample is a clutch throughout.
    """
    groups: dict[str, tuple[int, ...]] = {}
    """Name → column numbers of what varies independently: one input, or both correlated frictions."""
    for number, scattering in enumerate(model.inputs):
        if number not in model.pair:
            groups[scattering.path] = (number,)
        elif number == model.pair[0]:
            groups["friction.driving + friction.driven"] = model.pair
    count, center = len(model.inputs), model.torque(model.centers)

    def torque(values: Sequence[Array]) -> Array:
        return np.broadcast_to(model.torque(values) - center, values[0].shape)

    def replicate(number: int, cells: Iterator[int]) -> Array:
        """Sums of rows, torques, squares; then for each group the numerators of first-order and total index."""
        sums = np.zeros(3 + 2 * len(groups))
        # other streams than those of the torque sample
        for columns in drawn(model, plan.seed, REPLICATES + number, cells, quasi=plan.quasi, copies=2):
            one, other = columns[:count], columns[count:]
            mixed = ([other[k] if k in members else one[k] for k in range(count)] for members in groups.values())
            samples = [one, other, *mixed]
            if model.may_fail:
                kept = np.logical_and.reduce([model.possible(values) for values in samples])
                samples = [[column[kept] for column in values] for values in samples]
            if not samples[0][0].size:
                continue
            first, second, *others = (torque(values) for values in samples)
            sums[:3] += first.size, first.sum() + second.sum(), (first**2).sum() + (second**2).sum()
            for k, torques in enumerate(others):
                difference = torques - first
                sums[3 + 2 * k : 5 + 2 * k] += (second * difference).sum(), (difference**2).sum() / 2
        return sums

    rows = np.array(plan.run(say("indices"), replicate))
    if not rows[:, 0].any():
        raise CalculationError("tolerance.sobol_base: too few of the samples are a clutch; give a larger one")
    whole = rows.sum(axis=0)
    mean = whole[1] / (2 * whole[0])
    variance = whole[2] / (2 * whole[0]) - mean**2
    # each replicate's variance about the common mean, so that the ratio's numerator and denominator match
    parts = rows[:, 2] / 2 - mean * rows[:, 1] + mean**2 * rows[:, 0]

    def index(column: int) -> Estimate:
        """A ratio of sums; its error from the spread of the replicates about the ratio."""
        if not variance > 0:
            return Estimate(0.0)
        ratio = whole[column] / whole[0] / variance
        residual = rows[:, column] - ratio * parts
        error = math.sqrt(float(np.sum(residual**2)) * len(rows) / (len(rows) - 1)) / whole[0]
        return Estimate(float(ratio), float(error / variance))

    return [
        IndexRow.of(path=name, first_order=index(3 + 2 * k), total=index(4 + 2 * k)) for k, name in enumerate(groups)
    ]


def peak_figures(model: Model, given: Tolerance, clutch: Clutch) -> dict[str, object]:
    """Fields of the result that are figures of the peak torque in the shaft, of the event of the [drive] block.

    The drives are a separate sample, each simulated once; without an event to simulate there are no fields. Unless the
    spec gives a load, that of every drive is the machine's torque of the nominal clutch.

    Raises:
        CalculationError: hardly any sample is a clutch.
    """
    if not ANALYSES["simulate"].applies(clutch):
        return {}
    load = clutch.spec.drive.load_torque
    spec = with_values(model.spec, {"drive.load_torque": float(clutch.running_torque) if load is None else load})
    model = replace(model, spec=spec)
    # other streams than those of the torque and of its indices
    parts = [
        model.clutches_of(next(drawn(model, given.seed, 2 * REPLICATES + number, [DRIVES // REPLICATES])))
        for number in range(REPLICATES)
    ]
    sizes = [part[0].size for part in parts]
    if min(sizes) < _LEAST_CLUTCHES:
        raise CalculationError("tolerance: hardly a sample is a clutch: there is no peak torque to tell")
    values = [np.concatenate(columns) for columns in zip(*parts, strict=True)]
    simulated = peaks_of(model.clutch(values), *model.frictions(model.by_path(values)))
    peaks = np.broadcast_to(simulated.shaft, values[0].shape)
    pieces = np.split(peaks, np.cumsum(sizes)[:-1])
    order = ranked_values(peaks)
    fields: dict[str, object] = {
        "peak_samples": peaks.size,
        "peak_torque_mean": estimate(np.mean, pieces, peaks),
        "peak_torque_deviation": estimate(lambda torques: torques.std(ddof=1), pieces, peaks),
        "peak_quantiles": [PeakRow.of(probability=p, peak_torque=order.estimate(p)) for p in given.quantiles],
    }
    required = model.spec.requirements
    if required is not None and required.peak_torque is not None:
        above = float(np.mean(peaks > required.peak_torque))
        error = max(1 / peaks.size, (above * (1 - above) / peaks.size) ** 0.5)
        fields["probability_peak_above"] = Estimate(above, error)
    return fields


__all__ = ["ToleranceResult", "study", "tolerance"]

_UNSURE = {"monte-carlo": 0.025, "quasi-monte-carlo": 0.005}
"""Relative standard error of the standard deviation beyond which it is too small itself: two of them cover the true
value of lognormal torques in 92…95 % of samples below, in 89, 76 and 57 % at 0.034, 0.046 and 0.065 (quasi: 75 % at
0.013)."""
_HEAVY = 10.0
"""Kurtosis (3 of a normal torque) below which few samples, not the tails, make that error large: it is a fair one."""


def tolerance(clutch: Clutch, *, threads: int | None = None) -> tuple[ToleranceResult, list[Finding]]:
    """Calculate the distribution of the torque; ``study`` without its histogram."""
    whole = study(clutch, threads=threads)
    return whole.result, whole.findings


def study(clutch: Clutch, *, threads: int | None = None, peaks: bool = True) -> Study:
    """Calculate the distribution of the torque, and of the ``peaks``, by the [tolerance] block of the spec.

    By default there are as many threads as processors, up to 8; their number changes no digit.

    Raises:
        SpecError: no [tolerance] block, or a field that the clutch does not have.
    """
    if threads is None:
        processors = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
        threads = min(processors, 8)
    elif threads < 1:
        raise AfmcalcError("threads must be at least 1")
    given = _block(clutch.spec)
    spec = with_setting(clutch, given)
    model = Model(spec, inputs_of(spec), given.friction_correlation or 0.0)
    machine = float(clutch.machine_torque)
    exact = exact_of(model) if given.method == "auto" else None
    if exact is not None:
        figures, bars = exact.figures(given, machine), histogram(exact.quantile, exact.below)
    else:
        quasi = given.method == "quasi-monte-carlo"
        tallies = simulate(model, Plan(given.samples, given.seed, quasi, threads), given.torque_limit, machine)
        sobol = sobol_indices(model, Plan(given.sobol_base, given.seed, quasi, threads))
        torques = ranked(merged(tallies), [ranked(tally) for tally in tallies] if quasi else ())
        figures = {**sampled_figures(model, tallies, torques, given), "sobol": sobol}
        bars = histogram(torques.quantile, torques.below, torques.size)
    inputs = [
        InputRow(
            path=scattering.path,
            distribution=scattering.kind,
            center=scattering.center,
            spread=scattering.spread,
            unit=scattering.unit,
            min=scattering.bounds[0],
            max=scattering.bounds[1],
        )
        for scattering in model.inputs
    ]
    result = ToleranceResult.of(
        **figures,
        **(peak_figures(model, given, clutch) if peaks else {}),
        setting=given.setting,
        torque_limit=given.torque_limit,
        machine_torque=machine,
        inputs=inputs,
    )
    return Study(result, bars, [*clutch_findings(clutch.spec, clutch.quantities), *_findings(given, result)])


def _block(spec: Spec) -> Tolerance:
    """The [tolerance] block; a torque that the requirements limit is the limit whose exceedance is asked for."""
    given = spec.tolerance
    if given is None:
        message = say(
            'required by tolerance, for example [tolerance.fields] "closing_spring.force" = '
            '{{ distribution = "normal", spread = "5 %" }}'
        )
        raise spec.refused("tolerance", message)
    if given.torque_limit is None and spec.requirements is not None:
        return given.model_copy(update={"torque_limit": spec.requirements.torque_max})
    return given


def _findings(given: Tolerance, result: ToleranceResult) -> Iterator[Finding]:
    """Remarks in the order of the [tolerance] block, then on the figures."""
    paths = given.fields.keys()
    if not paths <= set(FRICTION):
        yield finding(given.setting, "info", path="tolerance.setting")
    if not paths & set(FRICTION):
        yield finding("friction-fixed", "info", path="tolerance.fields")
    if {"friction.driving", "friction.driven"} <= paths and given.friction_correlation is None:
        yield finding("friction-independent", "info", path="tolerance.friction_correlation")
    if result.life_quantiles:
        yield finding("miner", "info", path="fatigue")
    if result.probability_no_clutch:
        yield finding("no-clutch", "warning", value=result.probability_no_clutch, limit=0.0, path="tolerance.fields")
    if result.samples is None:
        return
    if result.standard_deviation:
        limit, error = _UNSURE[result.method], result.standard_deviation_standard_error / result.standard_deviation
        kurtosis = 1 + 4 * result.samples * error**2
        # two samples stand behind each index
        of_indices = ((kurtosis - 1) / (8 * given.sobol_base)) ** 0.5
        code, path = "heavy-tails/indices", "tolerance.sobol_base"
        if error > limit:
            code, path = "heavy-tails", "tolerance.samples"
        if kurtosis > _HEAVY and max(error, of_indices) > limit:
            yield finding(code, "warning", value=max(error, of_indices), limit=limit, path=path)
    least = max(needed(p) for p in given.quantiles)
    if result.samples < least:
        yield finding("few-samples", "warning", value=result.samples, limit=least, path="tolerance.samples")
