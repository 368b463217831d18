"""Torque over the tolerances of making and the scatter of service: distribution, risks, life, what matters most."""

import os
from typing import Literal, NamedTuple

from ...engines.protocol import Clutch
from ...equations.overload import machine_torque
from ...errors import AfmcalcError, Problem, SpecError
from ...findings import Finding
from ...messages import say
from ...result import Result, quantity
from ...spec import Spec
from ...spec.tolerance import Tolerance
from .distributions import inputs_of
from .exact import Exact, exact_of
from .histogram import Histogram, histogram_of_exact, histogram_of_sample
from .run import Plan, simulate, spread_of
from .sampling import CELL, Model
from .sobol import sobol_indices
from .tally import Tally, deviation, mean, merged, quantiles

ROBUST = (0.005, 0.995)
"""Probabilities whose quantiles stand for the smallest and largest torque."""


class InputRow(Result):
    """One number that scatters."""

    path: str = quantity("", None, "field")
    distribution: str = quantity("", None, "distribution")
    center: float = quantity("", None, "center, SI")
    spread: float = quantity("", None, "spread, SI")
    unit: str = quantity("", None, "SI unit")


class QuantileRow(Result):
    """One quantile of the torque."""

    probability: float = quantity("1", "p", "probability")
    torque: float = quantity("N*m", "T_p", "torque not exceeded with this probability")
    standard_error: float = quantity("N*m", "±", "standard error")


class IndexRow(Result):
    """Sobol indices of one input."""

    path: str = quantity("", None, "field")
    first_order: float = quantity("1", "S_1", "first-order Sobol index")
    first_order_standard_error: float = quantity("1", "± S_1", "standard error of S_1")
    total: float = quantity("1", "S_T", "total Sobol index")
    total_standard_error: float = quantity("1", "± S_T", "standard error of S_T")


class ToleranceResult(Result):
    """Distribution of the slip torque; standard errors are 0 where the answer is exact."""

    method: Literal["exact", "monte-carlo", "quasi-monte-carlo"] = quantity("", None, "how it was calculated")
    samples: int | None = quantity("", None, "sample size", optional=True)
    mean: float = quantity("N*m", "T_m", "mean torque")
    mean_standard_error: float = quantity("N*m", "± T_m", "standard error of the mean")
    standard_deviation: float = quantity("N*m", "s_T", "standard deviation of the torque")
    standard_deviation_standard_error: float = quantity("N*m", "± s_T", "standard error of the standard deviation")
    accuracy_factor_robust: float = quantity("1", "K_т,r", "robust accuracy factor q(99.5 %)/q(0.5 %)")
    accuracy_factor_robust_standard_error: float = quantity("1", "± K_т,r", "standard error of K_т,r")
    torque_limit: float | None = quantity("N*m", "T_lim", "torque whose exceedance is asked for", optional=True)
    probability_above_limit: float | None = quantity("1", "P(T>T_lim)", "probability above the limit", optional=True)
    probability_above_limit_standard_error: float | None = quantity(
        "1", "± P(T>T_lim)", "standard error of it", optional=True
    )
    machine_torque: float = quantity("N*m", "T_н.маш", "machine nominal torque, T_н/β_н")
    probability_below_machine: float = quantity("1", "P(T<T_н.маш)", "probability below the machine's nominal torque")
    probability_below_machine_standard_error: float = quantity("1", "± P(T<T_н.маш)", "standard error of it")
    life_protected: float | None = quantity(
        "1", "N", "expected slips to failure of the protected side (Miner)", optional=True
    )
    life_protected_standard_error: float | None = quantity("1", "± N", "standard error of it", optional=True)
    life_unprotected: float | None = quantity(
        "1", "N'", "expected slips to failure of the unprotected side (Miner)", optional=True
    )
    life_unprotected_standard_error: float | None = quantity("1", "± N'", "standard error of it", optional=True)
    inputs: list[InputRow] = quantity("", None, "what scatters")
    sobol: list[IndexRow] = quantity("", None, "share in the variance of the torque")
    quantiles: list[QuantileRow] = quantity("", None, "quantiles of the torque")


class Study(NamedTuple):
    """All that one sample tells."""

    result: ToleranceResult
    histogram: Histogram
    findings: list[Finding]


def tolerance(
    clutch: Clutch, *, threads: int | None = None, block: int = CELL
) -> tuple[ToleranceResult, list[Finding]]:
    """Calculate the distribution of the torque; ``study`` without its histogram."""
    found = study(clutch, threads=threads, block=block)
    return found.result, found.findings


def study(clutch: Clutch, *, threads: int | None = None, block: int = CELL) -> Study:
    """Calculate the distribution of the torque by the [tolerance] block of the spec.

    Args:
        clutch: the clutch.
        threads: how many; None for as many as there are processors, up to 8. Changes no digit.
        block: samples evaluated at once. Changes no digit.

    Raises:
        SpecError: no [tolerance] block, or a field that the clutch does not have.
        AfmcalcError: quasi-Monte Carlo without SciPy.
    """
    spec = clutch.spec
    block_given = _block(spec)
    inputs = inputs_of(spec)
    model = Model(spec, inputs, block_given.friction_correlation or 0.0)
    machine = _machine_torque(clutch)
    shown = [
        InputRow(path=each.path, distribution=each.kind, center=each.center, spread=each.spread, unit=each.unit)
        for each in inputs
    ]
    findings = [*clutch.findings(), *_findings(model, block_given)]
    exact = exact_of(model) if block_given.method == "auto" else None
    if exact is not None:
        return Study(
            _exact_result(exact, model, block_given, machine, shown), histogram_of_exact(exact), findings
        )  # fmt: skip
    if threads is None:
        threads = min(len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1, 8)
    if threads < 1 or block < 1:
        raise AfmcalcError(say("threads and block must be at least 1"))
    quasi = block_given.method == "quasi-monte-carlo"
    plan = Plan(block_given.samples, block_given.seed, quasi, threads, block)
    tallies = simulate(model, plan, block_given.torque_limit, machine)
    indices = sobol_indices(model, Plan(block_given.sobol_base, block_given.seed, quasi, threads))
    rows = [
        IndexRow(
            path=index.name,
            first_order=index.first_order,
            first_order_standard_error=index.first_order_error,
            total=index.total,
            total_standard_error=index.total_error,
        )
        for index in indices
    ]
    whole = merged(tallies)
    result = _sampled_result(tallies, whole, block_given, machine, shown, rows, has_life=spec.fatigue is not None)
    return Study(result, histogram_of_sample(whole), findings)


def _block(spec: Spec) -> Tolerance:
    """Return the [tolerance] block; refuse fields that this clutch does not have."""
    given = spec.tolerance
    if given is None:
        message = say(
            'required by tolerance, for example [tolerance.fields] "closing_spring.force" = '
            '{{ distribution = "normal", spread = "5 %" }}'
        )
        raise SpecError(spec.label, [Problem("tolerance", None, message)])
    unlike = spec.friction.unlike
    wrong = {"friction": unlike, "friction.driving": not unlike, "friction.driven": not unlike}
    for path in given.fields:
        if wrong.get(path):
            use = "friction.driving and friction.driven" if unlike else "friction"
            raise SpecError(
                spec.label, [Problem(f"tolerance.fields.{path}", None, say("this clutch has {use} instead", use=use))]
            )
    return given


def _machine_torque(clutch: Clutch) -> float:
    """T_н.маш; with mean-friction the margin is in the spring already."""
    setting = clutch.spec.adjustment
    margin = setting.margin if setting.method == "min-friction" else 1.0
    return float(machine_torque(clutch.nominal_torque, margin))


def _exact_result(
    exact: Exact, model: Model, given: Tolerance, machine: float, shown: list[InputRow]
) -> ToleranceResult:
    average = exact.mean_of(lambda torque: torque)
    spread = exact.mean_of(lambda torque: (torque - average) ** 2) ** 0.5
    low, high = (exact.quantile(p) for p in ROBUST)
    limit = given.torque_limit
    life: dict[str, float | None] = {}
    if model.spec.fatigue is not None:
        for side, damage in zip(("protected", "unprotected"), exact.damages(), strict=True):
            life |= {f"life_{side}": 1 / damage, f"life_{side}_standard_error": 0.0}
    return ToleranceResult(
        method="exact",
        mean=average,
        mean_standard_error=0.0,
        standard_deviation=spread,
        standard_deviation_standard_error=0.0,
        accuracy_factor_robust=high / low,
        accuracy_factor_robust_standard_error=0.0,
        torque_limit=limit,
        probability_above_limit=None if limit is None else 1 - exact.below(limit),
        probability_above_limit_standard_error=None if limit is None else 0.0,
        machine_torque=machine,
        probability_below_machine=exact.below(machine),
        probability_below_machine_standard_error=0.0,
        **life,
        inputs=shown,
        sobol=[
            IndexRow(
                path=" + ".join(each.path for each in model.inputs),
                first_order=1.0,
                first_order_standard_error=0.0,
                total=1.0,
                total_standard_error=0.0,
            )
        ],
        quantiles=[QuantileRow(probability=p, torque=exact.quantile(p), standard_error=0.0) for p in given.quantiles],
    )


def _sampled_result(
    tallies: list[Tally],
    whole: Tally,
    given: Tolerance,
    machine: float,
    shown: list[InputRow],
    rows: list[IndexRow],
    *,
    has_life: bool,
) -> ToleranceResult:
    asked = [*given.quantiles, *ROBUST]
    by_replicate = [quantiles(each, asked) for each in tallies]
    found = quantiles(whole, asked)
    errors = [_error([row[k] for row in by_replicate]) for k in range(len(asked))]
    limit = given.torque_limit
    life: dict[str, float | None] = {}
    for side, name in (("protected", "damage"), ("unprotected", "damage_unprotected")) if has_life else ():

        def rate(tally: Tally, name: str = name) -> float:
            return float(getattr(tally, name) / tally.count)

        # the error of 1/x by that of x
        expected = 1 / rate(whole)
        life |= {f"life_{side}": expected, f"life_{side}_standard_error": expected**2 * spread_of(rate, tallies)}
    # where no sample or every sample counts, the spread between replicates is 0, but the error is not
    least = 1 / whole.count
    return ToleranceResult(
        method=given.method if given.method != "auto" else "monte-carlo",
        samples=whole.count,
        mean=mean(whole),
        mean_standard_error=spread_of(mean, tallies),
        standard_deviation=deviation(whole),
        standard_deviation_standard_error=spread_of(deviation, tallies),
        accuracy_factor_robust=found[-1] / found[-2],
        accuracy_factor_robust_standard_error=_error([row[-1] / row[-2] for row in by_replicate]),
        torque_limit=limit,
        probability_above_limit=None if limit is None else whole.above / whole.count,
        probability_above_limit_standard_error=None
        if limit is None
        else max(least, spread_of(lambda t: t.above / t.count, tallies)),
        machine_torque=machine,
        probability_below_machine=whole.below / whole.count,
        probability_below_machine_standard_error=max(least, spread_of(lambda t: t.below / t.count, tallies)),
        **life,
        inputs=shown,
        sobol=rows,
        quantiles=[
            QuantileRow(probability=p, torque=torque, standard_error=error)
            for p, torque, error in zip(given.quantiles, found, errors, strict=False)
        ],
    )


def _error(values: list[float]) -> float:
    from statistics import stdev

    return float(stdev(values) / len(values) ** 0.5)


def _findings(model: Model, given: Tolerance) -> list[Finding]:
    names = {each.path for each in model.inputs}
    found = []
    if not names & {"friction", "friction.driving", "friction.driven"}:
        message = "friction does not scatter in [tolerance.fields]: the torque is taken at the mean friction"
        found.append(Finding(level="info", code="friction-fixed", message=message, path="tolerance.fields"))
    if {"friction.driving", "friction.driven"} <= names and given.friction_correlation is None:
        message = (
            "the correlation of f_1 and f_2 is not given: they are taken as independent (F11 has them together, 1)"
        )
        found.append(
            Finding(level="info", code="friction-independent", message=message, path="tolerance.friction_correlation")
        )
    if model.spec.fatigue is not None:
        message = (
            "expected life by Miner's rule: each slip loads the shaft with its torque, damage 1/N by the S-N line, "
            "extrapolated below the endurance limit as the paper does"
        )
        found.append(Finding(level="info", code="miner", message=message, path="fatigue"))
    return found
