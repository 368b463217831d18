"""Setting of the closing spring (настройка): every law is proportional to F_п, so one rule serves all (S19)."""

from collections.abc import Callable
from typing import Any

from ..arrays import Values
from ..equations import adjustment
from ..findings import Finding, finding
from ..spec.models import Method, Spec


def margin(spec: Spec, method: Method | None = None) -> Any:
    """β_н as far as it is in the spring: with mean-friction only (S19; in S22 it divides the machine's torque)."""
    return spec.adjustment.margin if (method or spec.adjustment.method) == "mean-friction" else 1.0


def margin_over_machine(spec: Spec) -> Any:
    """β_н as far as it lies between clutch and machine: with min-friction only (S22)."""
    return spec.adjustment.margin / margin(spec)


def friction_at_setting(spec: Spec, method: Method | None = None) -> tuple[Values, Values]:
    """f_1 and f_2 at which the spring is set: the smallest, or the mean."""
    first, second = spec.friction.groups
    mean = (method or spec.adjustment.method) == "mean-friction"
    return (first.mean, second.mean) if mean else (first.min, second.min)


def closing_force(spec: Spec, torque_per_force: Callable[[], Any]) -> Any:
    """F_п as given, or from the nominal torque and T/F_п at the setting."""
    if spec.closing_spring.force is not None:
        return spec.closing_spring.force
    return adjustment.closing_force(spec.adjustment.nominal_torque, margin(spec), torque_per_force())


def _material_findings(spec: Spec) -> list[Finding]:
    """Echo the values that a material of the catalogue stands for, with their source."""
    found = []
    for path, name in spec.friction.materials.items():
        from ..spec.catalogues import friction_materials

        entry = friction_materials()[name]
        ends = {"low": entry.friction_min, "high": entry.friction_max}
        found.append(finding("material", "info", path=path, name=name, source=entry.source, **ends))
    return found


def findings(spec: Spec, nominal: float, lowest: float) -> list[Finding]:
    """Remarks on the setting: the wished nominal torque missed, or not reached at an end of the range.

    Args:
        spec: the clutch.
        nominal: T_н that the spring as set gives, N·m.
        lowest: smaller of the torques at f_min and f_max, N·m.
    """
    found = _material_findings(spec)
    wished = spec.adjustment.nominal_torque
    if wished is not None and abs(nominal - wished) > 1e-4 * wished:
        path = "adjustment.nominal_torque"
        found.append(finding("nominal-torque-missed", "warning", value=nominal, limit=wished, path=path))
    if lowest < nominal * (1 - 1e-12):
        path = "adjustment.method"
        found.append(finding("below-nominal-torque", "warning", value=lowest, limit=nominal, path=path))
    return found
