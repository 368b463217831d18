"""Torque over the tolerances of making and the scatter of service: distribution, risks, life, what matters most."""

import os
from collections.abc import Sequence

from ...engines.protocol import Clutch
from ...errors import AfmcalcError, Problem, SpecError
from ...findings import Finding
from ...messages import say
from ...spec import Spec
from ...spec.tolerance import Tolerance
from .distributions import Input, inputs_of
from .exact import exact_of
from .figures import LIFE_PROBABILITIES, Figures, exact_figures, sampled_figures
from .model import Model
from .peaks import PeakFigures, peak_figures
from .remarks import findings_of
from .result import IndexRow, InputRow, LifeRow, PeakRow, QuantileRow, Study, ToleranceResult
from .run import Plan, simulate
from .setting import with_setting
from .sobol import sobol_indices

__all__ = ["Study", "ToleranceResult", "study", "tolerance"]


def tolerance(clutch: Clutch, *, threads: int | None = None) -> tuple[ToleranceResult, list[Finding]]:
    """Calculate the distribution of the torque; ``study`` without its histogram."""
    found = study(clutch, threads=threads)
    return found.result, found.findings


def study(clutch: Clutch, *, threads: int | None = None) -> Study:
    """Calculate the distribution of the torque by the [tolerance] block of the spec.

    Args:
        clutch: the clutch.
        threads: how many; None for as many as there are processors, up to 8. Changes no digit.

    Raises:
        SpecError: no [tolerance] block, or a field that the clutch does not have.
        AfmcalcError: quasi-Monte Carlo without SciPy.
    """
    given = _block(clutch.spec)
    spec = with_setting(clutch, given)
    model = Model(spec, inputs_of(spec), given.friction_correlation or 0.0)
    machine = float(clutch.machine_torque)
    figures = _figures(model, given, machine, _threads(threads))
    findings = [*clutch.findings(), *findings_of(model, given, figures)]
    result = _result(figures, model.inputs, given, machine, peak_figures(model, given, clutch))
    return Study(result, figures.histogram, findings)


def _figures(model: Model, given: Tolerance, machine: float, threads: int) -> Figures:
    exact = exact_of(model) if given.method == "auto" else None
    if exact is not None:
        return exact_figures(exact, given, machine)
    quasi = given.method == "quasi-monte-carlo"
    sample, base = (Plan(size, given.seed, quasi, threads) for size in (given.samples, given.sobol_base))
    tallies = simulate(model, sample, given.torque_limit, machine)
    indices = sobol_indices(model, base)
    return sampled_figures(model, tallies, given, indices)


def _threads(given: int | None) -> int:
    if given is None:
        return min(len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1, 8)
    if given < 1:
        raise AfmcalcError(say("threads must be at least 1"))
    return given


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
            use = say("friction.driving and friction.driven") if unlike else "friction"
            raise SpecError(
                spec.label, [Problem(f"tolerance.fields.{path}", None, say("this clutch has {use} instead", use=use))]
            )
    if given.torque_limit is None and spec.requirements is not None:
        return given.model_copy(update={"torque_limit": spec.requirements.torque_max})
    return given


def _result(
    figures: Figures, inputs: Sequence[Input], given: Tolerance, machine: float, peaks: PeakFigures | None
) -> ToleranceResult:
    some = {
        "probability_no_clutch": figures.no_clutch,
        "probability_above_limit": figures.above_limit,
        **dict(zip(("life_protected", "life_unprotected"), (each.harmonic for each in figures.lives), strict=False)),
    }
    return ToleranceResult.of(
        method=figures.method,
        setting=given.setting,
        samples=figures.samples,
        mean=figures.mean,
        standard_deviation=figures.deviation,
        accuracy_factor_robust=figures.robust,
        torque_limit=given.torque_limit,
        machine_torque=machine,
        probability_below_machine=figures.below_machine,
        **{name: figure for name, figure in some.items() if figure is not None},
        life_quantiles=_life_rows(figures),
        **_peak_fields(peaks, given),
        inputs=[
            InputRow(
                path=each.path,
                distribution=each.kind,
                center=each.center,
                spread=each.spread,
                unit=each.unit,
                **dict(zip(("min", "max"), each.bounds, strict=True)),
            )
            for each in inputs
        ],
        sobol=[IndexRow.of(path=each.name, first_order=each.first_order, total=each.total) for each in figures.sobol],
        quantiles=[
            QuantileRow.of(probability=p, torque=torque)
            for p, torque in zip(given.quantiles, figures.quantiles, strict=True)
        ],
    )


def _peak_fields(peaks: PeakFigures | None, given: Tolerance) -> dict[str, object]:
    if peaks is None:
        return {}
    rows = zip(given.quantiles, peaks.quantiles, strict=True)
    return {
        "peak_samples": peaks.samples,
        "peak_torque_mean": peaks.mean,
        "peak_torque_deviation": peaks.deviation,
        **({} if peaks.above is None else {"probability_peak_above": peaks.above}),
        "peak_quantiles": [PeakRow.of(probability=p, peak_torque=torque) for p, torque in rows],
    }


def _life_rows(figures: Figures) -> list[LifeRow] | None:
    if not figures.lives:
        return None
    columns = (life.quantiles for life in figures.lives)
    return [
        LifeRow.of(probability=p, protected=protected, unprotected=unprotected)
        for p, protected, unprotected in zip(LIFE_PROBABILITIES, *columns, strict=True)
    ]
