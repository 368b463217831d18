"""Parameters of a torque law from the keys of a spec: mean radius, feedback gain, friction and force as set."""

from collections.abc import Callable, Iterator
from typing import Any

from ..equations import adjustment, direct
from ..equations.arrays import Values, tangent
from ..findings import Finding, finding
from ..messages import term
from ..spec.models import Friction, Method, Range, Spec

_MEAN_RADIUS = {
    "uniform-wear": direct.mean_radius_uniform_wear,
    "uniform-pressure": direct.mean_radius_uniform_pressure,
}


def mean_radius(spec: Spec) -> Any:
    """R_cp, given or from the two radii."""
    group = spec.friction_group
    if group.mean_radius is not None:
        return group.mean_radius
    return _MEAN_RADIUS[group.radius_model or "uniform-wear"](group.inner_radius, group.outer_radius)


def feedback_gain(spec: Spec) -> Any:
    """C, given or from the wall angle; 0 without a control unit."""
    unit = spec.control_unit
    if unit is None:
        return 0.0
    if unit.wall_angle is None:
        return unit.gain
    return direct.gain(mean_radius(spec), unit.ball_circle_radius, tangent(unit.wall_angle))


def angle_given(spec: Spec) -> bool:
    """Whether the gain follows from a wall angle."""
    return spec.control_unit is not None and spec.control_unit.wall_angle is not None


def gain_path(spec: Spec) -> str:
    """Key of the spec that the gain follows from."""
    return "control_unit.wall_angle" if angle_given(spec) else "control_unit.gain"


def force_path(spec: Spec) -> str:
    """Key of the spec that the force of the closing spring follows from."""
    return "closing_spring.force" if spec.closing_spring.force is not None else "adjustment.nominal_torque"


def frictions(spec: Spec) -> tuple[Range, Range]:
    """Ranges of f_1 and f_2, twice the same with one material."""
    first, second = spec.friction.groups
    return first, second


def at_setting(friction: tuple[Range, Range], spec: Spec, method: Method | None = None) -> tuple[Values, Values]:
    """f_1 and f_2 at which the spring is set, by the spec's own method or another: the smallest, or the mean."""
    first, second = friction
    mean = (method or spec.adjustment.method) == "mean-friction"
    return (first.mean, second.mean) if mean else (first.min, second.min)


def margin(spec: Spec) -> Any:
    """β_н as far as it is in the spring: with mean-friction only (S19; in S22 it divides the machine's torque)."""
    return spec.adjustment.margin if spec.adjustment.method == "mean-friction" else 1.0


def closing_force(spec: Spec, torque_per_force: Callable[[], Any]) -> Any:
    """F_п as given, or from the nominal torque and T/F_п at the setting: every law is proportional to F_п (S19)."""
    if spec.closing_spring.force is not None:
        return spec.closing_spring.force
    return adjustment.closing_force(spec.adjustment.nominal_torque, margin(spec), torque_per_force())


def material_findings(friction: Friction) -> Iterator[Finding]:
    """Materials echoed with their source, as what they are read, and what counts where it may be one of several."""
    for block, of_group in friction.blocks.items():
        path, rows = f"{block}.material", of_group.materials
        for name, row in rows.items():
            code = "material" if name == row.name else "material/read"
            yield finding(
                code, "info", path=path, name=name, row=row.name, about=term(row.description),
                condition=term(row.condition), source=row.source, low=row.friction_min, high=row.friction_max,
            )  # fmt: skip
        if len(rows) > 1:
            low, _, high = of_group.range
            yield finding("lining-unknown", "info", path=path, names=", ".join(rows), low=low, high=high)


def setting_findings(spec: Spec, nominal: float, lowest: float) -> Iterator[Finding]:
    """Materials with their source; a wished torque that the ``nominal`` one misses, or that service falls below."""
    wished = spec.adjustment.nominal_torque
    yield from material_findings(spec.friction)
    if wished is not None and abs(nominal - wished) > 1e-4 * wished:
        path = "adjustment.nominal_torque"
        yield finding("nominal-torque-missed", "warning", value=nominal, limit=wished, path=path)
    if lowest < nominal * (1 - 1e-12):
        path = "adjustment.method"
        yield finding("below-nominal-torque", "warning", value=lowest, limit=nominal, path=path)


def machine_findings(spec: Spec, lowest: float, highest: float) -> Iterator[Finding]:
    """A service factor assumed, a machine not driven at every friction, slip as it starts."""
    if (plate := spec.machine) is None:
        return
    if plate.service_factor is None:
        yield service_factor_assumed()
    if lowest < (asked := float(plate.torque)) * (1 - 1e-9):
        yield finding("machine-not-driven", "warning", value=lowest, limit=asked, path="machine.power")
    if plate.starting_torque is not None and (start := float(plate.starting_torque)) > lowest * (1 + 1e-9):
        code = "slips-at-start/always" if start > highest else "slips-at-start"
        path = "machine.starting_torque_ratio"
        yield finding(code, "info", value=start, limit=lowest, path=path, highest=highest)


def service_factor_assumed() -> Finding:
    """Say that no service factor is given."""
    return finding("service-factor-assumed", "info", value=1.0, path="machine.service_factor")
