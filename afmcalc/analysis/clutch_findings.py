"""What a designer should know of a clutch, whatever is asked: the limits of its law, its setting, its springs."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from ..engines.quantities import Quantities
from ..findings import Finding, finding
from ..messages import term
from ..spec.models import Friction, Spec

if TYPE_CHECKING:
    from ..engines.springs import SpringDemand


def clutch_findings(spec: Spec, clutch: Quantities) -> list[Finding]:
    """Return the findings on the limits of the law, on the setting, and on springs given as parts."""
    lowest, highest = float(clutch["torque_min"]), float(clutch["torque_max"])
    law = _of_sleeve(spec, clutch) if spec.kind.travels else _of_direct(spec, clutch)
    found = [*spec.label.findings, *law, *_of_setting(spec, float(clutch["nominal_torque"]), lowest)]
    found += _of_machine(spec, lowest, highest)
    if spec.spring_parts:
        from ..engines.parts import part_findings

        found += part_findings(spec, demands_on_springs(spec, clutch))
    return found


def demands_on_springs(spec: Spec, clutch: Quantities, travel: float = 0.0) -> "list[SpringDemand]":
    """Return force as set and stroke of each spring; ``travel`` counts where it exceeds that of the law."""
    from ..engines.springs import spring_demands

    control = None
    if spec.kind.travels:
        control, travel = float(clutch["control_force"]), max(travel, float(clutch["travel_max"]))
    return spring_demands(spec, float(clutch["closing_force"]), control, travel)


def _gain_path(spec: Spec) -> str:
    """Key of the spec that the gain follows from."""
    unit = spec.control_unit
    return "control_unit.gain" if unit is None or unit.wall_angle is None else "control_unit.wall_angle"


def _of_direct(spec: Spec, clutch: Quantities) -> Iterator[Finding]:
    """Gain limits, idle feedback, a torque that falls with friction."""
    path, rule = _gain_path(spec), spec.kind.gain_limit
    if spec.kind.controlled and clutch["gain"] == 0:
        yield finding("feedback-idle", "warning", value=0.0, limit=0.0, path=path)
    elif rule is not None and clutch["gain"] > (limit := clutch["gain_limit"]) * (1 + 1e-9):
        value, bound = map(float, rule.stated(clutch["gain"], clutch["reduced_gain"], limit))
        peak, sustained = clutch["breakaway_torque_at_f_max"], clutch["torque_at_f_max"]
        yield finding(rule.code, "warning", value=value, limit=bound, path=path, peak=peak, sustained=sustained)
    if spec.friction.unlike:
        most, at = float(clutch["torque_max"]), float(clutch["friction_of_torque_max"])
        if (factor := float(clutch["torque_at_f_max"]) / most) < 1:
            yield finding("torque-falls", "info", value=factor, limit=1.0, most=most, at=at)


def _of_sleeve(spec: Spec, clutch: Quantities) -> Iterator[Finding]:
    """Curved springs, idle feedback, the key's hysteresis, a pocket in which the torque falls."""
    discs = [name for name in ("closing_spring", "control_spring") if getattr(spec, name).disc is not None]
    if discs:
        yield finding("curved-springs", "info", path=f"{discs[0]}.disc")
    if clutch["net_gain"] == 0:
        gain, threshold = float(clutch["gain"]), float(clutch["gain_threshold"])
        yield finding("feedback-idle/key", "warning", value=gain, limit=threshold, path=_gain_path(spec))
        return
    if "gain_slope" in clutch and 0 < clutch["friction_leaving"] < clutch["friction_max"]:
        yield from _of_slope(clutch)
    if clutch["key_friction"]:
        yield from _of_key(clutch)


def _of_slope(clutch: Quantities) -> Iterator[Finding]:
    """Finding where C_1 exceeds C_1*: a load that reaches T_н makes the sleeve run off, and the torque falls."""
    slope, best, jumping = (float(clutch[name]) for name in ("gain_slope", "constant_torque_slope", "jumping_slope"))
    if slope > best * (1 + 1e-9):
        code, path = "torque-jumps" if slope > jumping else "torque-falls-with-travel", "control_unit.gain_slope"
        most, falls = float(clutch["torque_at_leaving"]), float(clutch["torque_at_f_max"])
        yield finding(code, "warning", value=slope, limit=best, path=path, jumping=jumping, most=most, falls=falls)


def _of_key(clutch: Quantities) -> Iterator[Finding]:
    """Findings on the hysteresis by the key; a warning where the torque may fall below that of the machine."""
    names = ("torque_returning_min", "nominal_torque", "machine_torque")
    returning, nominal, machine = (float(clutch[name]) for name in names)
    key = "control_unit.key_friction"
    yield finding("hysteresis", "info", value=float(clutch["hysteresis_ratio"]), limit=1.0, path=key)
    if returning < machine * (1 - 1e-12):
        yield finding("returning-below-nominal", "warning", value=returning, limit=nominal, path=key)
    elif returning < nominal * (1 - 1e-12):
        yield finding("returning-covered", "info", value=returning, limit=nominal, path=key, machine=machine)


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


def _of_setting(spec: Spec, nominal: float, lowest: float) -> Iterator[Finding]:
    """Materials with their source; a wished torque that the ``nominal`` one misses, or that service falls below."""
    wished = spec.adjustment.nominal_torque
    yield from material_findings(spec.friction)
    if wished is not None and abs(nominal - wished) > 1e-4 * wished:
        path = "adjustment.nominal_torque"
        yield finding("nominal-torque-missed", "warning", value=nominal, limit=wished, path=path)
    if lowest < nominal * (1 - 1e-12):
        path = "adjustment.method"
        yield finding("below-nominal-torque", "warning", value=lowest, limit=nominal, path=path)


def _of_machine(spec: Spec, lowest: float, highest: float) -> Iterator[Finding]:
    """A service factor assumed, a machine not driven at every friction, slip as it starts."""
    if (plate := spec.machine) is None:
        return
    if plate.service_factor is None:
        yield finding("service-factor-assumed", "info", value=1.0, path="machine.service_factor")
    if lowest < (asked := float(plate.torque)) * (1 - 1e-9):
        yield finding("machine-not-driven", "warning", value=lowest, limit=asked, path="machine.power")
    if plate.starting_torque is not None and (start := float(plate.starting_torque)) > lowest * (1 + 1e-9):
        code = "slips-at-start/always" if start > highest else "slips-at-start"
        path = "machine.starting_torque_ratio"
        yield finding(code, "info", value=start, limit=lowest, path=path, highest=highest)
