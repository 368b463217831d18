"""Setting of the closing spring (настройка): every law is proportional to F_п, so one rule serves all (S19)."""

from collections.abc import Callable
from typing import Any, Protocol

from ..arrays import Values
from ..equations import adjustment
from ..findings import Finding
from ..spec.models import Method, Range, Spec


class Settable(Protocol):
    """A clutch whose torque is proportional to its closing force."""

    @property
    def spec(self) -> Spec: ...  # noqa: D102
    @property
    def friction(self) -> tuple[Range, Range]: ...  # noqa: D102
    @property
    def closing_force(self) -> Values: ...  # noqa: D102
    def torque(self, friction: Any, friction_driven: Any = None) -> Any: ...  # noqa: D102


def margin(spec: Spec, method: Method | None = None) -> Any:
    """β_н as far as it is in the spring: with mean-friction only (S19; in S22 it divides the machine's torque)."""
    return spec.adjustment.margin if (method or spec.adjustment.method) == "mean-friction" else 1.0


def friction_at_setting(spec: Spec, method: Method | None = None) -> tuple[Any, Any]:
    """f_1 and f_2 at which the spring is set: the smallest, or the mean."""
    first, second = spec.friction.groups
    mean = (method or spec.adjustment.method) == "mean-friction"
    return (first.mean, second.mean) if mean else (first.min, second.min)


def closing_force(spec: Spec, torque_per_force: Callable[[], Any]) -> Any:
    """F_п as given, or from the nominal torque and T/F_п at the setting."""
    if spec.closing_spring.force is not None:
        return spec.closing_spring.force
    return adjustment.closing_force(spec.adjustment.nominal_torque, margin(spec), torque_per_force())


def nominal_torque(clutch: Settable) -> Values:
    """T_н that the spring as set gives."""
    at_setting = clutch.torque(*friction_at_setting(clutch.spec))
    torque: Values = adjustment.nominal_torque(at_setting, margin(clutch.spec))
    return torque


def _material_findings(spec: Spec) -> list[Finding]:
    """Echo the values that a material of the catalogue stands for, with their source."""
    named = {"friction": spec.friction.material}
    for group in ("driving", "driven"):
        block = getattr(spec.friction, group)
        named[f"friction.{group}"] = block.material if block else None
    found = []
    for path, name in named.items():
        if name is not None:
            from ..spec.materials import catalogue

            entry = catalogue()[name]
            message = (
                f"{name}: friction {entry.friction_min:g}…{entry.friction_max:g} from the catalogue ({entry.source})"
            )
            found.append(Finding(level="info", code="material", message=message, path=f"{path}.material"))
    return found


def findings(clutch: Settable) -> list[Finding]:
    """Remarks on the setting: the wished nominal torque missed, or not reached at f_min."""
    found = _material_findings(clutch.spec)
    first, second = clutch.friction
    reached, wished = float(nominal_torque(clutch)), clutch.spec.adjustment.nominal_torque
    if wished is not None and abs(reached - wished) > 1e-4 * wished:
        message = (
            f"closing_spring.force is given, so it decides: it gives a nominal torque of {reached:.5g} N·m, "
            f"not the {wished:.5g} N·m of adjustment.nominal_torque"
        )
        found.append(
            Finding(
                level="warning", code="nominal-torque-missed", message=message,
                value=reached, limit=wished, path="adjustment.nominal_torque",
            )
        )  # fmt: skip
    lowest = min(clutch.torque(first.min, second.min), clutch.torque(first.max, second.max))
    if lowest < reached * (1 - 1e-12):
        message = f"the torque falls to {lowest:.5g} N·m in service, below the nominal torque {reached:.5g} N·m"
        found.append(
            Finding(
                level="warning", code="below-nominal-torque", message=message,
                value=lowest, limit=reached, path="adjustment.method",
            )
        )  # fmt: skip
    return found
