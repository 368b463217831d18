"""Both adjustment methods side by side (S19)."""

import math
from collections.abc import Iterator
from typing import Any, Literal

from ..engines import build
from ..engines.protocol import Clutch
from ..equations import accuracy, adjustment
from ..findings import Finding, finding
from ..messages import term
from ..result import Answer, Result, Triple, described, quantity
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
    mid_torque: float = quantity("N*m", "T_mid", "torque at the middle of the band")
    accuracy_factor: float = quantity("1", "K_т", "accuracy factor")
    holds_nominal: bool = described("holds T_н over the friction range")
    holds_machine: bool = described("holds T_н.маш over the friction range")


class AdjustResult(Answer):
    """Both methods for one nominal torque."""

    nominal_torque: float = quantity("N*m", "T_н", "nominal torque of the clutch, which both methods are set for")
    machine_torque: float = quantity("N*m", "T_н.маш", "nominal torque of the machine")
    margin: float = quantity("1", "β_н", "torque margin of the mean-friction method")
    min_friction: MethodResult = quantity("", "1", "set at f_min")
    mean_friction: MethodResult = quantity("", "2", "set at the mean friction, with margin")
    force_ratio: float | None = quantity(
        "1", "F_п1/F_п2", "spring force set at f_min over that set at the mean friction, without margin", optional=True
    )
    scatter_ratio: float | None = quantity("1", "ΔT_2/ΔT_1", "band set at the mean friction over that set at f_min")
    narrower: Literal["min-friction", "mean-friction", "equal"] = described("method with the narrower band")
    pairs_threshold: float | None = quantity(
        "1", "z_lim", "number of pairs above which the band set at f_min is the narrower, S19 (12)", optional=True
    )


def set_by(spec: Spec, method: Method, nominal_torque: float) -> Clutch:
    """Build the clutch of ``spec`` with its spring set by ``method`` for ``nominal_torque``."""
    return build(with_nominal_torque(spec, nominal_torque, method))


def adjust(clutch: Clutch) -> tuple[AdjustResult, list[Finding]]:
    """Set the clutch by both methods for its nominal torque and compare the scatter bands."""
    nominal, machine = float(clutch.nominal_torque), float(clutch.machine_torque)
    first, second = clutches = [set_by(clutch.spec, method, nominal) for method in METHODS]
    results = [_method(one, nominal, machine) for one in clutches]
    bands = [result.scatter for result in results]
    ratio = _ratio(clutch, first, bands)
    narrower: Literal["min-friction", "mean-friction", "equal"] = "equal"
    if ratio is None and bands[1] > 1e-12 * nominal:
        narrower = METHODS[0]
    elif ratio is not None and abs(ratio - 1) > 1e-12:
        narrower = METHODS[0] if ratio > 1 else METHODS[1]
    result = AdjustResult(
        nominal_torque=nominal,
        machine_torque=machine,
        margin=clutch.spec.adjustment.margin,
        min_friction=results[0],
        mean_friction=results[1],
        force_ratio=None if clutch.sleeve is not None else adjustment.force_ratio(*_per_force(first)[::-1]),
        scatter_ratio=ratio,
        narrower=narrower,
        pairs_threshold=_threshold(clutch),
    )
    findings = clutch.findings()
    if narrower != "equal":
        index = METHODS.index(narrower)
        if not results[index].holds_nominal:
            findings.append(
                finding(
                    "narrower-below-nominal" if results[index].holds_machine else "narrower-below-nominal/machine",
                    # a warning where the clutch has that setting
                    "warning" if narrower == clutch.spec.adjustment.method else "info",
                    value=float(clutches[index].torque_min), limit=nominal, path="adjustment.method",
                    method=term(narrower), machine=machine,
                )
            )  # fmt: skip
    return result, [*findings, *_re_made(clutch, first, second)]


def _re_made(clutch: Clutch, first: Clutch, second: Clutch) -> Iterator[Finding]:
    """Say what the clutches compared have that the clutch as made has not."""
    control, unit = clutch.spec.control_spring, clutch.spec.control_unit
    if clutch.sleeve is None or first.sleeve is None or second.sleeve is None:
        return
    if control is not None and control.force is not None:
        forces = {"at_min": float(first.sleeve.control_force), "at_mean": float(second.sleeve.control_force)}
        yield finding("control-spring-re-set", "info", value=control.force, path="control_spring.force", **forces)
    if unit is not None and unit.pocket is not None:
        slopes = {"at_min": float(first.sleeve.gain_slope), "at_mean": float(second.sleeve.gain_slope)}
        value = float(clutch.sleeve.gain_slope)
        yield finding("pockets-re-cut", "info", value=value, path="control_unit.pocket", **slopes)


def _method(clutch: Clutch, nominal: float, machine: float) -> MethodResult:
    torque, lowest = triple(clutch, clutch.torque), float(clutch.torque_min) * (1 + 1e-12)
    return MethodResult(
        closing_force=clutch.closing_force,
        torque=torque,
        scatter=clutch.scatter,
        mid_torque=accuracy.mid_band_torque(clutch.torque_max, clutch.torque_min),
        accuracy_factor=clutch.accuracy_factor,
        holds_nominal=lowest >= nominal,
        holds_machine=lowest >= machine,
    )


def _ratio(clutch: Clutch, set_at_min: Clutch, bands: list[float]) -> float | None:
    """ΔT_2/ΔT_1; None when the torque does not wander at all, for friction does not, or pockets hold it."""
    if bands[0] <= 1e-12 * float(set_at_min.torque_max):
        return None
    if clutch.sleeve is not None:
        # the stop moves with the setting, and K_т with it
        return bands[1] / bands[0]
    return float(adjustment.scatter_ratio(clutch.spec.adjustment.margin, *_per_force(set_at_min)))


def _per_force(clutch: Clutch) -> list[Any]:
    """Torque per unit of spring force at which each method sets, g(f_min) and g(f_cp)."""
    return [clutch.torque_per_force(method) for method in METHODS]


def _threshold(clutch: Clutch) -> float | None:
    """z of S19 (12); None where it does not apply, or one method is narrower whatever the number of pairs."""
    spec, friction, margin, gain = clutch.spec, clutch.friction[0], clutch.spec.adjustment.margin, clutch.gain
    if spec.kind.travels or spec.friction.unlike:
        return None
    if not (margin - 1) * gain > 0 or margin * friction.min >= friction.mean:
        return None
    threshold = float(adjustment.pairs_threshold(clutch.bypass_pairs, gain, friction.min, friction.mean, margin))
    return threshold if math.isfinite(threshold) else None
