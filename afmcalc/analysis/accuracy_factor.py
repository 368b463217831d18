"""Accuracy of the clutch: the accuracy factor K_т, its worst case, limits and sensitivities, and sweeps of it."""

from collections.abc import Sequence

from pydantic import SerializeAsAny

from ..engines import Clutch
from ..engines.elasticity import elasticities
from ..findings import Finding, finding
from ..result import Answer, Series, described, quantity
from .asking import Asking, answer, asked, asked_by, with_columns
from .clutch_findings import clutch_findings
from .sweep import Axis, replaced, series

_ROUNDING = 1e-8
"""Largest magnitude of an elasticity that counts as a rounding error."""


class AccuracySweep(Asking, Series):
    """Accuracy over a swept key."""

    accuracy_factor: list[float] = asked()
    accuracy_factor_peak: list[float] = asked(description="accuracy factor by breakaway peaks")
    accuracy_factor_hysteresis: list[float] | None = asked(
        description="accuracy factor under a load that lasts", optional=True
    )
    nominal_torque: list[float] = asked()
    torque_max: list[float] = asked(description="largest torque")


class AccuracyResult(Asking, Answer):
    """Accuracy of the clutch over its friction range."""

    accuracy_factor: float = asked(description="accuracy factor, friction of all pairs moving together")
    accuracy_factor_worst_case: float = asked()
    accuracy_factor_peak: float = asked()
    accuracy_factor_hysteresis: float | None = asked(optional=True)
    conventional_accuracy_factor: float = asked()
    gain_limit: float | None = asked(optional=True)
    gain_threshold: float | None = asked(optional=True)
    equivalent_gain: float | None = asked(optional=True)
    constant_torque_slope: float | None = asked(optional=True)
    nominal_torque_ratio: float | None = asked(optional=True)
    slope_in_ratio_max: float | None = asked(optional=True)
    slope_in_ratio_min: float | None = asked(optional=True)
    sensitivity: dict[str, float] = quantity(
        "1", "∂ln K_т/∂ln p", "relative sensitivity: % by which K_т changes for 1 % of the parameter p", ranked=True
    )
    sweep: list[SerializeAsAny[AccuracySweep]] | None = described("accuracy over the swept values", optional=True)


def accuracy(
    clutch: Clutch, sweeps: Sequence[Axis] = (), columns: Sequence[str] = ()
) -> tuple[AccuracyResult, list[Finding]]:
    """Calculate the accuracy of a clutch; over the grid of ``sweeps`` also the quantities in ``columns``."""
    spec = clutch.spec
    kind = with_columns(AccuracySweep, clutch, columns)
    swept = series(kind, spec, sweeps, asked_by(kind, clutch), open_at=columns)
    slopes = elasticities(clutch)
    # rounding errors become 0, a mean friction without effect is left out
    shown = {path: each.slope if abs(each.slope) > _ROUNDING else 0.0 for path, each in slopes.items()}
    shown = {path: slope for path, slope in shown.items() if slope or not path.endswith(".mean")}
    # F11 differentiates K_т = T(f_max)/T(f_min) of unlike materials
    ratio = clutch.get("accuracy_factor_by_ratios", 0.0) / clutch["accuracy_factor"]
    of_path = {} if abs(ratio - 1) <= 1e-9 else {"slope_in_ratio_max": None, "slope_in_ratio_min": None}
    result = answer(AccuracyResult, clutch, sensitivity=shown, sweep=swept, **of_path)
    findings = clutch_findings(clutch)
    if kinks := [path for path, slope in slopes.items() if slope.kink]:
        path = "control_unit.gain_slope"
        slope, constant = (float(clutch.get(name, 0.0)) for name in ("gain_slope", "constant_torque_slope"))
        if path in kinks and abs(slope - constant) <= 1e-9 * constant:
            # pockets keep the torque constant: K_т grows with a smaller and with a larger slope of the gain
            findings.append(finding("elasticity-one-sided", "info", value=slope, limit=constant, path=path))
        else:
            findings.append(finding("elasticity-one-sided/key", "info", path=kinks[0], paths=", ".join(kinks)))
    if swept:
        pairs = zip(swept[0].accuracy_factor, swept[0].accuracy_factor_peak, strict=True)
        if beyond := sum(peak > sustained * (1 + 1e-9) for sustained, peak in pairs):
            points = len(swept[0].values)
            findings.append(finding("sweep-beyond-gain-limit", "warning", value=beyond, limit=0.0, points=points))
    return result, [*findings, *replaced(spec, sweeps)]
