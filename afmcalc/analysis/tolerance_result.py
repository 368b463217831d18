"""Results of a study of tolerances: every figure of the sample with its standard error."""

from typing import Any, ClassVar

from ..result import Answer, Result, described, quantity, shown_as
from ..spec.scatter import Setting


def _error(of: str, figure: Any) -> Any:
    """Declare the field of the standard error of a figure, ``figure`` being the field above of the name ``of``."""
    shown = shown_as(figure)
    optional = not figure.is_required()
    return quantity(shown.unit, f"± {shown.symbol}", "standard error of it", optional=optional, error_of=of)


def _optional(unit: str, symbol: str, description: str) -> Any:
    return quantity(unit, symbol, description, optional=True)


class InputRow(Result):
    """One number that scatters."""

    path: str = described("parameter")
    distribution: str = described("distribution")
    min: float | None = described("min", optional=True, unit_in="unit")
    center: float = described("mean or peak", unit_in="unit")
    max: float | None = described("max", optional=True, unit_in="unit")
    spread: float = described("deviation or half-width", unit_in="unit")
    unit: str = described("unit", is_unit=True)


class QuantileRow(Result):
    """Quantiles at one probability: torque, life of the shaft, peak torque."""

    probability: float = quantity("1", None, "probability")
    torque: float = quantity("N*m", "T_p", "torque not exceeded with this probability")
    torque_standard_error: float = _error("torque", torque)
    life_protected: float | None = _optional("1", "N_ц,p", "slips, protected side")
    life_protected_standard_error: float | None = _error("life_protected", life_protected)
    life_unprotected: float | None = _optional("1", "N'_ц,p", "slips, unprotected side")
    life_unprotected_standard_error: float | None = _error("life_unprotected", life_unprotected)
    peak_torque: float | None = _optional("N*m", "T_peak,p", "peak torque not exceeded with this probability")
    peak_torque_standard_error: float | None = _error("peak_torque", peak_torque)


class IndexRow(Result):
    """Sobol indices of one input."""

    path: str = described("parameter")
    first_order: float = quantity("1", "S_1", "first-order Sobol index")
    first_order_standard_error: float = _error("first_order", first_order)
    total: float = quantity("1", "S_T", "total Sobol index")
    total_standard_error: float = _error("total", total)


class Bar(Result):
    """One bar of the histogram of the torque."""

    low: float = quantity("N*m", None, "lower end of the bar")
    high: float = quantity("N*m", None, "upper end of the bar")
    density: float = quantity("1/(N*m)", None, "probability density")


class ToleranceResult(Answer):
    """Distribution of the slip torque, of life and of peak torque."""

    many_lists: ClassVar[bool] = True

    setting: Setting = described("how the springs are set")
    samples: int = described("sample size")
    probability_no_clutch: float | None = _optional(
        "1", "P(–)", "share of samples that make no working clutch; all other figures are of those that do"
    )
    probability_no_clutch_standard_error: float | None = _error("probability_no_clutch", probability_no_clutch)
    mean: float = quantity("N*m", "T_m", "mean torque")
    mean_standard_error: float = _error("mean", mean)
    standard_deviation: float = quantity("N*m", "s_T", "standard deviation of the torque")
    standard_deviation_standard_error: float = _error("standard_deviation", standard_deviation)
    accuracy_factor_robust: float = quantity("1", "K_т,r", "robust accuracy factor q(99.5 %)/q(0.5 %)")
    accuracy_factor_robust_standard_error: float = _error("accuracy_factor_robust", accuracy_factor_robust)
    torque_limit: float | None = _optional("N*m", "T_lim", "torque limit whose exceedance is asked for")
    probability_above_limit: float | None = _optional("1", "P(T>T_lim)", "probability above the limit")
    probability_above_limit_standard_error: float | None = _error("probability_above_limit", probability_above_limit)
    machine_torque: float = quantity("N*m", "T_н.маш", "nominal torque of the machine")
    probability_below_machine: float = quantity("1", "P(T<T_н.маш)", "probability below the machine's nominal torque")
    probability_below_machine_standard_error: float = _error("probability_below_machine", probability_below_machine)
    life_protected: float | None = _optional(
        "1", "N_ц", "slips to failure at the clutches' mean damage, protected side (harmonic mean of lives)"
    )
    life_protected_standard_error: float | None = _error("life_protected", life_protected)
    life_unprotected: float | None = _optional(
        "1", "N'_ц", "slips to failure at the clutches' mean damage, unprotected side"
    )
    life_unprotected_standard_error: float | None = _error("life_unprotected", life_unprotected)
    peak_torque_mean: float | None = _optional("N*m", "T_peak,m", "mean peak torque in the shaft")
    peak_torque_mean_standard_error: float | None = _error("peak_torque_mean", peak_torque_mean)
    peak_torque_deviation: float | None = _optional("N*m", "s_peak", "standard deviation of the peak torque")
    peak_torque_deviation_standard_error: float | None = _error("peak_torque_deviation", peak_torque_deviation)
    probability_peak_above: float | None = _optional(
        "1", "P(T_peak)", "probability of a peak above requirements.peak_torque"
    )
    probability_peak_above_standard_error: float | None = _error("probability_peak_above", probability_peak_above)
    inputs: list[InputRow] = described("what scatters")
    sobol: list[IndexRow] = described("share in the variance of the torque")
    quantiles: list[QuantileRow] = described("quantiles of torque, life of the shaft and peak torque")
    histogram: list[Bar] = described("histogram of the middle 99.9 % of the torques", data=True)
