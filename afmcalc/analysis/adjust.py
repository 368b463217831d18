"""Both adjustment methods side by side (S19)."""

import math
from collections.abc import Iterator
from typing import Literal

from ..engines import build
from ..engines.protocol import Clutch
from ..equations import adjustment
from ..findings import Finding, finding
from ..result import Result, Triple, quantity
from ..spec import Spec
from ..spec.edit import with_nominal_torque
from ..spec.models import Method
from .torque import triple

METHODS: tuple[Method, Method] = ("min-friction", "mean-friction")


class MethodResult(Result):
    """The clutch set by one method for the nominal torque."""

    closing_force: float = quantity("N", "F_п", "closing-spring force as set")
    torque: Triple = quantity("N*m", "T", "slip torque")
    scatter: float = quantity("N*m", "ΔT", "torque scatter band")
    accuracy_factor: float = quantity("1", "K_т", "accuracy factor")


class AdjustResult(Result):
    """Both methods for one nominal torque."""

    nominal_torque: float = quantity("N*m", "T_н", "nominal torque of the clutch, which both methods are set for")
    margin: float = quantity("1", "β_н", "torque margin of the mean-friction method")
    min_friction: MethodResult = quantity("", "1", "set at f_min")
    mean_friction: MethodResult = quantity("", "2", "set at the mean friction, with margin")
    scatter_ratio: float | None = quantity("1", "ΔT_2/ΔT_1", "band of mean-friction over that of min-friction")
    scatter_difference: float = quantity("N*m", "ΔT_2−ΔT_1", "band of mean-friction less that of min-friction")
    narrower: Literal["min-friction", "mean-friction", "equal"] = quantity("", None, "method with the narrower band")
    pairs_threshold: float | None = quantity(
        "1", "z_12", "pairs above which min-friction is narrower, S19 (12)", optional=True
    )
    pairs_threshold_at_gain_limit: float | None = quantity(
        "1", "z_13", "the same at the gain limit 1/(z_1 f_max), S19 (13)", optional=True
    )


def set_by(spec: Spec, method: Method, nominal_torque: float) -> Clutch:
    """Build the clutch of ``spec`` with its spring set by ``method`` for ``nominal_torque``."""
    return build(with_nominal_torque(spec, nominal_torque, method))


def adjust(clutch: Clutch) -> tuple[AdjustResult, list[Finding]]:
    """Set the clutch by both methods for its nominal torque and compare the scatter bands."""
    nominal = float(clutch.nominal_torque)
    first, second = (set_by(clutch.spec, method, nominal) for method in METHODS)
    results = [_method(each) for each in (first, second)]
    bands = [result.scatter for result in results]
    ratio = _ratio(clutch, first, bands)
    narrower: Literal["min-friction", "mean-friction", "equal"] = "equal"
    if ratio is None and bands[1] > 1e-12 * nominal:
        narrower = METHODS[0]
    elif ratio is not None and abs(ratio - 1) > 1e-12:
        narrower = METHODS[0] if ratio > 1 else METHODS[1]
    rule = clutch.spec.kind.gain_limit
    # a limit of the reduced gain follows the pairs asked for
    limit = clutch.gain_limit if rule is not None and rule.reduced is None else None
    result = AdjustResult(
        nominal_torque=nominal,
        margin=clutch.spec.adjustment.margin,
        min_friction=results[0],
        mean_friction=results[1],
        scatter_ratio=ratio,
        scatter_difference=bands[1] - bands[0],
        narrower=narrower,
        pairs_threshold=_threshold(clutch, float(clutch.gain)),
        pairs_threshold_at_gain_limit=None if limit is None else _threshold(clutch, float(limit)),
    )
    return result, [*clutch.findings(), *_re_made(clutch, first, second)]


def _re_made(clutch: Clutch, first: Clutch, second: Clutch) -> Iterator[Finding]:
    """Say what the clutches compared have that the clutch as made has not."""
    control, unit = clutch.spec.control_spring, clutch.spec.control_unit
    if control is not None and control.force is not None:
        forces = {"at_min": float(first.control_force or 0.0), "at_mean": float(second.control_force or 0.0)}
        yield finding("control-spring-re-set", "info", value=control.force, path="control_spring.force", **forces)
    if unit is not None and unit.pocket is not None:
        slopes = {"at_min": float(first.gain_slope or 0.0), "at_mean": float(second.gain_slope or 0.0)}
        own = float(clutch.gain_slope or 0.0)
        yield finding("pockets-re-cut", "info", value=own, path="control_unit.pocket", **slopes)


def _method(clutch: Clutch) -> MethodResult:
    torque = triple(clutch, clutch.torque)
    return MethodResult(
        closing_force=clutch.closing_force,
        torque=torque,
        scatter=clutch.scatter,
        accuracy_factor=clutch.accuracy_factor,
    )


def _ratio(clutch: Clutch, set_at_min: Clutch, bands: list[float]) -> float | None:
    """ΔT_2/ΔT_1; None when the torque does not wander at all, for friction does not, or pockets hold it."""
    if bands[0] <= 1e-12 * float(set_at_min.torque_max):
        return None
    if clutch.friction_set is not None:
        # the stop moves with the setting, and K_т with it
        return bands[1] / bands[0]
    at_min, at_mean = (set_at_min.torque_per_force(method) for method in METHODS)
    return float(adjustment.scatter_ratio(clutch.spec.adjustment.margin, at_min, at_mean))


def _threshold(clutch: Clutch, gain: float) -> float | None:
    """z of S19 (12); None where it does not apply."""
    spec = clutch.spec
    if spec.kind.travels or spec.friction.unlike:
        return None
    if not (spec.adjustment.margin - 1) * gain > 0:
        return None
    own = clutch.friction[0]
    threshold = float(adjustment.pairs_threshold(clutch.bypass_pairs, gain, own.min, own.mean, spec.adjustment.margin))
    return threshold if math.isfinite(threshold) else None
