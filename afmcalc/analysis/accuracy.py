"""Accuracy of the clutch: K_т, its worst cases, its limits, what it is sensitive to, and sweeps of it."""

from collections.abc import Callable, Iterator, Sequence
from operator import attrgetter
from typing import Any

from ..engines.protocol import Clutch
from ..equations import accuracy as law
from ..findings import Finding, finding
from ..result import Answer, Series, described, quantity
from .sweep.grid import Axis, replaced, series


class AccuracySweep(Series):
    """Accuracy over a swept key."""

    accuracy_factor: list[float] = quantity("1", "K_т", "accuracy factor")
    accuracy_factor_peak: list[float] = quantity("1", "K_т,p", "accuracy factor by breakaway peaks")
    accuracy_factor_hysteresis: list[float] | None = quantity(
        "1", "K_т,h", "accuracy factor under a load that lasts", optional=True
    )
    nominal_torque: list[float] = quantity("N*m", "T_н", "nominal torque of the clutch")
    torque_max: list[float] = quantity("N*m", "T_max", "largest torque")


class AccuracyResult(Answer):
    """Accuracy of the clutch over its friction range."""

    accuracy_factor: float = quantity("1", "K_т", "accuracy factor, friction of all pairs moving together")
    accuracy_factor_worst_case: float = quantity(
        "1", "K_т,w", "accuracy factor, f_1 of the bypass and f_2 of the other pairs independent"
    )
    accuracy_factor_peak: float = quantity("1", "K_т,p", "accuracy factor by breakaway peaks (upper bound)")
    accuracy_factor_hysteresis: float | None = quantity(
        "1", "K_т,h", "accuracy factor under a load that lasts, T_max/T_ret,min", optional=True
    )
    conventional_accuracy_factor: float = quantity("1", "K_т,0", "accuracy factor of an ordinary clutch in its place")
    gain_limit: float | None = quantity("1", "C_max", "largest gain at which the law describes the slip", optional=True)
    gain_threshold: float | None = quantity("1", "2R f_1/d", "gain at which feedback begins", optional=True)
    equivalent_gain: float | None = quantity(
        "1", "C_eff", "gain of the all-driving clutch with the same torque curve", optional=True
    )
    constant_torque_slope: float | None = quantity(
        "1/m", "C_1*", "growth of the gain with travel at which pockets hold the torque", optional=True
    )
    nominal_torque_ratio: float | None = quantity(
        "1",
        "K_п",
        "nominal torque over that of a base clutch whose pairs are all controlled, of equal spring force and gain",
        optional=True,
    )
    slope_in_ratio_max: float | None = quantity(
        "1", "∂K_т/∂n", "slope of K_т in n = f_2max/f_1max, f_2max moving, F11 (18)", optional=True
    )
    slope_in_ratio_min: float | None = quantity(
        "1", "∂K_т/∂p", "slope of K_т in p = f_2min/f_1min, f_2min moving, F11 (22)", optional=True
    )
    sensitivity: dict[str, float] = quantity(
        "1", "∂ln K_т/∂ln p", "relative sensitivity: % by which K_т changes for 1 % of the parameter p", ranked=True
    )
    sweep: list[AccuracySweep] | None = described("accuracy over the swept values", optional=True)


def sweep_outputs(clutch: Clutch) -> dict[str, Callable[[Clutch], Any]]:
    """What a sweep of the accuracy of such a clutch gives; K_т,h only where it has a sleeve that is held back."""
    names = ["accuracy_factor", "accuracy_factor_peak", "nominal_torque", "torque_max"]
    if clutch.spec.kind.travels:
        names.append("accuracy_factor_hysteresis")
    return {name: attrgetter(name) for name in names}


def accuracy(clutch: Clutch, sweeps: Sequence[Axis] = ()) -> tuple[AccuracyResult, list[Finding]]:
    """Calculate the accuracy of a clutch, and over the grid of ``sweeps`` if there are any."""
    sleeve, (first, second) = clutch.sleeve, clutch.friction
    pairs = clutch.bypass_pairs, clutch.spec.friction_group.pairs - clutch.bypass_pairs
    swept = series(AccuracySweep, clutch, sweeps, sweep_outputs(clutch))
    result = AccuracyResult(
        accuracy_factor=clutch.accuracy_factor,
        accuracy_factor_worst_case=clutch.accuracy_factor_worst_case,
        accuracy_factor_peak=clutch.accuracy_factor_peak,
        accuracy_factor_hysteresis=sleeve and sleeve.accuracy_factor_hysteresis,
        # its torque follows z_1 f_1 + z_2 f_2
        conventional_accuracy_factor=law.conventional_accuracy_factor(
            *pairs, first.min, second.min, first.max, second.max
        ),
        gain_limit=clutch.gain_limit,
        gain_threshold=sleeve and sleeve.gain_threshold,
        equivalent_gain=sleeve and sleeve.equivalent_gain,
        constant_torque_slope=sleeve and sleeve.constant_torque_slope,
        nominal_torque_ratio=sleeve and sleeve.nominal_torque_ratio,
        **_slopes(clutch, pairs),
        # what is left by rounding is nothing
        sensitivity={name: 0.0 if abs(slope) < 1e-12 else slope for name, slope in clutch.sensitivity().items()},
        sweep=swept,
    )
    return result, [*clutch.findings(), *_findings(clutch, swept), *replaced(clutch.spec, sweeps)]


def _slopes(clutch: Clutch, pairs: tuple[Any, Any]) -> dict[str, float]:
    """Slopes of K_т in F11's ratios of unlike materials; none where K_т is not T(f_max)/T(f_min)."""
    if not clutch.spec.friction.unlike:
        return {}
    first, second = clutch.friction
    given = *pairs, clutch.gain, second.max / first.max, second.min / first.min, first.min, first.max
    if abs(law.accuracy_factor_by_ratios(*given) / clutch.accuracy_factor - 1) > 1e-9:
        return {}
    return {
        "slope_in_ratio_max": law.slope_in_ratio_max(*given),
        "slope_in_ratio_min": law.slope_in_ratio_min(*given),
    }


def _findings(clutch: Clutch, swept: list[AccuracySweep] | None) -> Iterator[Finding]:
    """Say where K_т has a kink, and where breakaway peaks of swept points exceed the sustained torque."""
    if clutch.sleeve is not None and clutch.sleeve.gain_slope:
        slope, constant = float(clutch.sleeve.gain_slope), float(clutch.sleeve.constant_torque_slope)
        if abs(slope / constant - 1) <= 1e-9:
            # pockets hold the torque just so: beside it K_т grows on either side
            path = "control_unit.gain_slope"
            yield finding("elasticity-one-sided", "info", value=slope, limit=constant, path=path)
    if swept:
        pairs = zip(swept[0].accuracy_factor, swept[0].accuracy_factor_peak, strict=True)
        if beyond := sum(peak > sustained * (1 + 1e-9) for sustained, peak in pairs):
            points = len(swept[0].values)
            yield finding("sweep-beyond-gain-limit", "warning", value=beyond, limit=0.0, points=points)
