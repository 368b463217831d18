"""What a designer should know of the springs, where the spec says which parts they are."""

from collections.abc import Iterator

from ..findings import Finding, finding
from ..spec.models import Spec
from ..spec.springs import ClosingSpring, ControlSpring
from .characteristic import LEAST_USED, MOST_USED, DiscCharacteristic, characteristic

_ROUNDING = 1e-9


def part_findings(spec: Spec, closing_force: float, control_force: float | None, travel: float) -> list[Finding]:
    """Springs that cannot give their force, or are used where disc springs should not be.

    Args:
        spec: the clutch.
        closing_force: F_п as set, N.
        control_force: F_п2, N; None where there is no such spring.
        travel: x_max of the sleeve, which slackens the first and presses the second, m.
    """
    found = [*_of("closing_spring", spec.closing_spring, closing_force, -travel)]
    if spec.control_spring is not None and control_force is not None:
        found += _of("control_spring", spec.control_spring, control_force, travel)
    return found


def _of(path: str, spring: ClosingSpring | ControlSpring, force: float, travel: float) -> Iterator[Finding]:
    if spring.part is None:
        return
    own, path = characteristic(spring.part), f"{path}.{'disc' if spring.disc else 'coil'}"
    most = float(own.force(own.end))
    if most < force * (1 - _ROUNDING):
        yield finding("spring-too-weak", "error", value=most, limit=force, path=path)
        return
    if not isinstance(own, DiscCharacteristic):
        return
    cone = spring.disc.series * own.cone_height if spring.disc else 1.0
    start = float(own.deflection(force))
    low, high = sorted((start / cone, (start + travel) / cone))
    if low < LEAST_USED * (1 - _ROUNDING) or high > MOST_USED * (1 + _ROUNDING):
        farthest = high if high > MOST_USED else low
        yield finding("spring-beyond-range", "warning", value=farthest, path=path, low=low, high=high)
