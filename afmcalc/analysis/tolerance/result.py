"""What a study of tolerances tells: every figure of a sample with its standard error."""

from functools import cache
from typing import Any, ClassVar, Literal, NamedTuple, Self

from ...findings import Finding
from ...result import Answer, Result, described, quantity, shown_as
from ...spec.tolerance import Setting

ROBUST = (0.005, 0.995)
"""Probabilities whose quantiles stand for the smallest and largest torque."""
LIFE_PROBABILITIES = (0.01, 0.1, 0.5)
"""Of the quantiles of life: the share of clutches that have failed by then."""


class Estimate(NamedTuple):
    """A figure of a sample and its standard error, 0 where it is exact."""

    value: float
    standard_error: float = 0.0


class Estimated(Result):
    """A result that holds estimates; written flat, the error in a field that says whose it is (``error_of``)."""

    @classmethod
    @cache
    def error_fields(cls) -> dict[str, str]:
        """Return the field of the error by that of the figure."""
        errors = {name: shown_as(field).error_of for name, field in cls.model_fields.items()}
        return {figure: name for name, figure in errors.items() if figure}

    @classmethod
    def of(cls, **figures: object) -> Self:
        """Build the result from figures, an ``Estimate`` giving both of its fields."""
        flat = dict(figures)
        for name, figure in figures.items():
            if isinstance(figure, Estimate):
                flat[name], flat[cls.error_fields()[name]] = figure
        return cls.model_validate(flat)

    def estimate(self, name: str) -> Estimate:
        """Return a figure with its error."""
        return Estimate(getattr(self, name), getattr(self, self.error_fields()[name]))


def error(of: str, figure: Any, description: str = "standard error of it", symbol: str | None = None) -> Any:
    """Declare the field of the standard error of a figure, ``figure`` being the field above of the name ``of``."""
    shown = shown_as(figure)
    return quantity(
        shown.unit, symbol or f"± {shown.symbol}", description, optional=not figure.is_required(), error_of=of
    )


class InputRow(Result):
    """One number that scatters."""

    path: str = described("parameter")
    distribution: str = described("distribution")
    min: float | None = described("min", optional=True, unit_in="unit")
    center: float = described("mean or peak", unit_in="unit")
    max: float | None = described("max", optional=True, unit_in="unit")
    spread: float = described("deviation or half-width", unit_in="unit")
    unit: str = described("unit", is_unit=True)


class QuantileRow(Estimated):
    """One quantile of the torque."""

    probability: float = quantity("1", None, "probability")
    torque: float = quantity("N*m", "T_p", "torque not exceeded with this probability")
    standard_error: float = error("torque", torque, "standard error", symbol="±")


class LifeRow(Estimated):
    """One quantile of the life over the clutches."""

    probability: float = quantity("1", None, "share of clutches failed")
    protected: float = quantity("1", "N_ц,p", "slips, protected side")
    protected_standard_error: float = error("protected", protected, "standard error of N_ц,p")
    unprotected: float = quantity("1", "N'_ц,p", "slips, unprotected side")
    unprotected_standard_error: float = error("unprotected", unprotected, "standard error of N'_ц,p")


class PeakRow(Estimated):
    """One quantile of the peak torque in the shaft."""

    probability: float = quantity("1", None, "probability")
    peak_torque: float = quantity("N*m", "T_peak,p", "peak torque not exceeded with this probability")
    standard_error: float = error("peak_torque", peak_torque, "standard error", symbol="±")


class IndexRow(Estimated):
    """Sobol indices of one input."""

    path: str = described("parameter")
    first_order: float = quantity("1", "S_1", "first-order Sobol index")
    first_order_standard_error: float = error("first_order", first_order, "standard error of S_1")
    total: float = quantity("1", "S_T", "total Sobol index")
    total_standard_error: float = error("total", total, "standard error of S_T")


class ToleranceResult(Estimated, Answer):
    """Distribution of the slip torque; standard errors are 0 where the answer is exact."""

    many_lists: ClassVar[bool] = True

    method: Literal["exact", "monte-carlo", "quasi-monte-carlo"] = described("how it was calculated")
    setting: Setting = described("how the springs are set")
    samples: int | None = described("sample size", optional=True)
    probability_no_clutch: float | None = quantity(
        "1",
        "P(–)",
        "share of samples that make no working clutch; all other figures are of those that do",
        optional=True,
    )
    probability_no_clutch_standard_error: float | None = error("probability_no_clutch", probability_no_clutch)
    mean: float = quantity("N*m", "T_m", "mean torque")
    mean_standard_error: float = error("mean", mean, "standard error of the mean")
    standard_deviation: float = quantity("N*m", "s_T", "standard deviation of the torque")
    standard_deviation_standard_error: float = error(
        "standard_deviation", standard_deviation, "standard error of the standard deviation"
    )
    accuracy_factor_robust: float = quantity("1", "K_т,r", "robust accuracy factor q(99.5 %)/q(0.5 %)")
    accuracy_factor_robust_standard_error: float = error(
        "accuracy_factor_robust", accuracy_factor_robust, "standard error of K_т,r"
    )
    torque_limit: float | None = quantity("N*m", "T_lim", "torque limit whose exceedance is asked for", optional=True)
    probability_above_limit: float | None = quantity("1", "P(T>T_lim)", "probability above the limit", optional=True)
    probability_above_limit_standard_error: float | None = error("probability_above_limit", probability_above_limit)
    machine_torque: float = quantity("N*m", "T_н.маш", "nominal torque of the machine")
    probability_below_machine: float = quantity("1", "P(T<T_н.маш)", "probability below the machine's nominal torque")
    probability_below_machine_standard_error: float = error("probability_below_machine", probability_below_machine)
    life_protected: float | None = quantity(
        "1",
        "N_ц",
        "slips to failure at the clutches' mean damage, protected side (harmonic mean of lives)",
        optional=True,
    )
    life_protected_standard_error: float | None = error("life_protected", life_protected)
    life_unprotected: float | None = quantity(
        "1", "N'_ц", "slips to failure at the clutches' mean damage, unprotected side", optional=True
    )
    life_unprotected_standard_error: float | None = error("life_unprotected", life_unprotected)
    life_quantiles: list[LifeRow] | None = quantity(
        "", None, "life over the clutches, each in the whole friction of its service", optional=True
    )
    peak_samples: int | None = described("drives simulated", optional=True)
    peak_torque_mean: float | None = quantity("N*m", "T_peak,m", "mean peak torque in the shaft", optional=True)
    peak_torque_mean_standard_error: float | None = error("peak_torque_mean", peak_torque_mean)
    peak_torque_deviation: float | None = quantity(
        "N*m", "s_peak", "standard deviation of the peak torque", optional=True
    )
    peak_torque_deviation_standard_error: float | None = error("peak_torque_deviation", peak_torque_deviation)
    probability_peak_above: float | None = quantity(
        "1", "P(T_peak)", "probability of a peak above requirements.peak_torque", optional=True
    )
    probability_peak_above_standard_error: float | None = error("probability_peak_above", probability_peak_above)
    peak_quantiles: list[PeakRow] | None = described("quantiles of the peak torque", optional=True)
    inputs: list[InputRow] = described("what scatters")
    sobol: list[IndexRow] = described("share in the variance of the torque")
    quantiles: list[QuantileRow] = described("quantiles of the torque")


class Histogram(Result):
    """Bars of equal width over the central part of the torque; none where the torque does not scatter."""

    edges: list[float] = quantity("N*m", "T", "ends of the bars, one more than there are bars")
    probabilities: list[float] = quantity("1", None, "probability of each bar")

    @property
    def densities(self) -> list[float]:
        """Probability of each bar over its width, 1/(N·m)."""
        ends = zip(self.edges, self.edges[1:], self.probabilities, strict=False)
        return [probability / (high - low) for low, high, probability in ends]


class Study(NamedTuple):
    """All that one sample tells."""

    result: ToleranceResult
    histogram: Histogram
    findings: list[Finding]
