"""Accuracy of the clutch: K_т, its worst cases, its limits, what it is sensitive to, and sweeps of it."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ..engines.findings import Finding
from ..engines.protocol import Clutch
from .result import Result, quantity

if TYPE_CHECKING:
    from .sweep import Axis


class AccuracySweep(Result):
    """One swept key: its coordinate at every point of the grid, and the answers there."""

    parameter: str = quantity("", None, "swept key as called")
    path: str = quantity("", None, "spec path")
    unit: str = quantity("", None, "SI unit of the values")
    values: list[float] = quantity("", None, "value at every point", axis=True)
    accuracy_factor: list[float] = quantity("1", "K_т", "accuracy factor")
    nominal_torque: list[float] = quantity("N*m", "T_н", "nominal torque")
    torque_max: list[float] = quantity("N*m", "T_max", "largest torque")


class AccuracyResult(Result):
    """Accuracy of the clutch over its friction range."""

    accuracy_factor: float = quantity("1", "K_т", "accuracy factor along the common path of f_1 and f_2")
    accuracy_factor_worst_case: float = quantity("1", "K_т,w", "accuracy factor with f_1 and f_2 independent")
    accuracy_factor_peak: float = quantity("1", "K_т,p", "accuracy factor by breakaway peaks (upper bound)")
    conventional_accuracy_factor: float = quantity("1", "K_т,0", "accuracy factor of an ordinary clutch in its place")
    gain_limit: float | None = quantity("1", "C_max", "largest gain at which the law describes the slip", optional=True)
    sensitivity: dict[str, float] = quantity("1", "∂ln K_т/∂ln p", "elasticity of K_т", ranked=True)
    sweep: list[AccuracySweep] | None = quantity(
        "", None, "accuracy over the swept values", optional=True, columns=True
    )


SWEEP_OUTPUTS = {
    "accuracy_factor": lambda clutch: clutch.accuracy_factor,
    "nominal_torque": lambda clutch: clutch.nominal_torque,
    "torque_max": lambda clutch: clutch.torque_max,
}


def accuracy(clutch: Clutch, sweeps: "Sequence[Axis]" = ()) -> tuple[AccuracyResult, list[Finding]]:
    """Calculate the accuracy of a clutch, and over the grid of ``sweeps`` if there are any."""
    result = AccuracyResult(
        accuracy_factor=clutch.accuracy_factor,
        accuracy_factor_worst_case=clutch.accuracy_factor_worst_case,
        accuracy_factor_peak=clutch.accuracy_factor_peak,
        conventional_accuracy_factor=conventional_accuracy_factor(clutch),
        gain_limit=clutch.gain_limit,
        sensitivity=clutch.sensitivity(),
        sweep=_sweep(clutch, sweeps) if sweeps else None,
    )
    return result, clutch.findings()


def conventional_accuracy_factor(clutch: Clutch) -> Any:
    """Return the K_т of an ordinary clutch with the same pairs: its torque follows z_1 f_1 + z_2 f_2."""
    from ..equations.accuracy import accuracy_factor

    first, second = clutch.friction
    bypass = clutch.spec.bypass_pairs
    controlled = clutch.spec.friction_group.pairs - bypass
    return accuracy_factor(bypass, controlled, 0.0, first.min, second.min, first.max, second.max)


def _sweep(clutch: Clutch, axes: "Sequence[Axis]") -> list[AccuracySweep]:
    from .sweep import evaluate, grid

    points = grid(axes)
    answers = {name: array.tolist() for name, array in evaluate(clutch.spec, points, SWEEP_OUTPUTS).items()}
    return [
        AccuracySweep(
            parameter=axis.name,
            path=axis.key.path,
            unit=axis.key.unit or "1",
            values=points[axis.key.path].tolist(),
            **answers,
        )
        for axis in axes
    ]
