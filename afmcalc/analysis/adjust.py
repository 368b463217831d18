"""Both adjustment methods side by side (S19)."""

import math
from typing import Literal

from ..engines import Clutch
from ..engines.quantities import Quantities
from ..findings import Finding, finding
from ..messages import translate
from ..result import Answer, Triple, described, quantity
from ..spec.models import Method
from .asking import Asking, answer, asked
from .clutch_findings import clutch_findings

METHODS: dict[Method, str] = {"min-friction": "by_min", "mean-friction": "by_mean"}
"""Adjustment method → case in which the clutch is set by this method for its nominal torque."""


class MethodResult(Asking):
    """The clutch set by one method for the nominal torque."""

    closing_force: float = asked()
    torque: Triple = asked()
    scatter: float = asked()
    mid_torque: float = asked()
    accuracy_factor: float = asked()
    holds_nominal: bool = described("holds T_н over the friction range")
    holds_machine: bool = described("holds T_н.маш over the friction range")


class AdjustResult(Asking, Answer):
    """Both methods for one nominal torque."""

    nominal_torque: float = asked(description="nominal torque of the clutch, which both methods are set for")
    machine_torque: float = asked()
    margin: float = asked(description="torque margin of the mean-friction method")
    min_friction: MethodResult = quantity("", "1", "set at f_min")
    mean_friction: MethodResult = quantity("", "2", "set at the mean friction, with margin")
    force_ratio: float | None = asked(optional=True)
    scatter_ratio: float | None = asked()
    narrower: Literal["min-friction", "mean-friction", "equal"] = described("method with the narrower band")
    pairs_threshold: float | None = asked(optional=True)


def adjust(clutch: Clutch) -> tuple[AdjustResult, list[Finding]]:
    """Set the clutch by both methods for its nominal torque and compare the scatter bands."""
    nominal = clutch["nominal_torque"]
    clutches: dict[Method, Quantities] = {method: clutch.at(case) for method, case in METHODS.items()}
    results = {}
    for method, own in clutches.items():
        lowest = own["torque_min"] * (1 + 1e-12)
        holds = {f"holds_{name}": lowest >= clutch[f"{name}_torque"] for name in ("nominal", "machine")}
        results[method] = answer(MethodResult, own, **holds)
    at_min, at_mean = results.values()
    # the torque does not scatter if the friction is constant, or if curved pockets keep the torque constant
    wanders = at_min.scatter > 1e-12 * clutches["min-friction"]["torque_max"]
    ratio = clutch["scatter_ratio"] if wanders else None
    wider = clutch["scatter_ratio"] if wanders else 1 + at_mean.scatter / nominal
    narrower: Literal["min-friction", "mean-friction", "equal"] = "equal"
    if abs(wider - 1) > 1e-12:
        narrower = "min-friction" if wider > 1 else "mean-friction"
    # number of pairs above which min-friction has the narrower scatter band, S19 (12), if there is such a number
    margin, threshold = clutch["margin"], math.inf
    ahead = "pairs_threshold" in clutch and (margin - 1) * clutch["gain"] > 0
    if ahead and margin * clutch["friction_min"] < clutch["friction_mean"]:
        threshold = clutch["pairs_threshold"]
    result = answer(
        AdjustResult, clutch, min_friction=at_min, mean_friction=at_mean, scatter_ratio=ratio, narrower=narrower,
        pairs_threshold=threshold if math.isfinite(threshold) else None,
    )  # fmt: skip
    findings = clutch_findings(clutch)
    if narrower != "equal" and not results[narrower].holds_nominal:
        findings.append(
            finding(
                "narrower-below-nominal" if results[narrower].holds_machine else "narrower-below-nominal/machine",
                # the finding is a warning if the spec sets the clutch by this method
                "warning" if narrower == clutch.spec.adjustment.method else "info",
                value=clutches[narrower]["torque_min"], limit=nominal, path="adjustment.method",
                method=translate(narrower), machine=result.machine_torque,
            )
        )  # fmt: skip
    # each method replaces a control-spring force and pockets in the spec by its own
    (first, second), control, unit = clutches.values(), clutch.spec.control_spring, clutch.spec.control_unit
    if control is not None and control.force is not None:
        forces, path = {"at_min": first["control_force"], "at_mean": second["control_force"]}, "control_spring.force"
        findings.append(finding("control-spring-re-set", "info", value=control.force, path=path, **forces))
    if unit is not None and unit.pocket is not None:
        slopes, path = {"at_min": first["gain_slope"], "at_mean": second["gain_slope"]}, "control_unit.pocket"
        findings.append(finding("pockets-re-cut", "info", value=clutch["gain_slope"], path=path, **slopes))
    return result, findings
