"""Torque over the tolerances of making and the scatter of service: distribution, risks, life, what matters most."""

import os
from collections.abc import Iterator

from ...engines.protocol import Clutch
from ...errors import AfmcalcError
from ...findings import Finding, finding
from ...messages import say
from ...spec import Spec
from ...spec.tolerance import FRICTION, Tolerance
from .model import Model, inputs_of, with_setting
from .result import InputRow, Study, ToleranceResult
from .sampling import Plan, peak_figures, sampled_figures, simulate, sobol_indices
from .service import exact_of
from .statistics import histogram, merged, needed, ranked

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
    return Study(result, bars, [*clutch.findings(), *_findings(given, result)])


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
