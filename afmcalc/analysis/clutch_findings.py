"""Findings that all analyses of a clutch share: findings on the limits of its law, its setting and its springs."""

from collections.abc import Iterator

from ..engines import Clutch
from ..engines.checks import failures_of
from ..findings import Finding, Level, finding
from ..messages import translate
from ..spec.models import Friction, Spec


def clutch_findings(clutch: Clutch) -> list[Finding]:
    """Return the findings on a clutch: failed checks of its law, and remarks on setting, materials and spring parts."""
    spec = clutch.spec
    found = [*spec.label.findings, *failures_of(spec, clutch, "torque")]
    if spec.friction.unlike:
        most, at = clutch["torque_max"], clutch["friction_of_torque_max"]
        if (factor := clutch["torque_at_f_max"] / most) < 1:
            found.append(finding("torque-falls", "info", value=factor, limit=1.0, most=most, at=at))
    if spec.kind.travels:
        found += _of_sleeve(clutch)
    nominal, wished = clutch["nominal_torque"], spec.adjustment.nominal_torque
    if wished is not None and abs(nominal - wished) > 1e-4 * wished:
        path = "adjustment.nominal_torque"
        found.append(finding("nominal-torque-missed", "warning", value=nominal, limit=wished, path=path))
    if spec.machine is not None and spec.machine.service_factor is None:
        found.append(finding("service-factor-assumed", "info", value=1.0, path="machine.service_factor"))
    found += material_findings(spec.friction)
    if spec.spring_parts:
        from ..engines.parts import part_findings

        found += part_findings(clutch)
    return found


def _of_sleeve(clutch: Clutch) -> Iterator[Finding]:
    """Yield findings on disc springs, pockets in which the torque falls, and hysteresis by feather-key friction."""
    discs = [name for name in ("closing_spring", "control_spring") if getattr(clutch.spec, name).disc is not None]
    if discs:
        yield finding("curved-springs", "info", path=f"{discs[0]}.disc")
    if clutch["net_gain"] == 0:
        return
    if "gain_slope" in clutch and 0 < clutch["friction_leaving"] < clutch["friction_max"]:
        slope, best, jumping = (clutch[f"{of}_slope"] for of in ("gain", "constant_torque", "jumping"))
        if slope > best * (1 + 1e-9):
            code, path = "torque-jumps" if slope > jumping else "torque-falls-with-travel", "control_unit.gain_slope"
            most, falls = clutch["torque_at_leaving"], clutch["torque_at_f_max"]
            yield finding(code, "warning", value=slope, limit=best, path=path, jumping=jumping, most=most, falls=falls)
    if clutch["key_friction"]:
        names, key = ("torque_returning_min", "nominal_torque", "machine_torque"), "control_unit.key_friction"
        returning, nominal, machine = (clutch[name] for name in names)
        yield finding("hysteresis", "info", value=clutch["hysteresis_ratio"], limit=1.0, path=key)
        if machine * (1 - 1e-12) <= returning < nominal * (1 - 1e-12):
            yield finding("returning-covered", "info", value=returning, limit=nominal, path=key, machine=machine)


def material_findings(friction: Friction) -> Iterator[Finding]:
    """Yield findings on the catalogue row of each material, and on the friction range if a material has several."""
    for block, of_group in friction.blocks.items():
        path, rows = f"{block}.material", of_group.materials
        for name, row in rows.items():
            code = "material" if name == row.name else "material/read"
            yield finding(
                code, "info", path=path, name=name, row=row.name, about=translate(row.description),
                condition=translate(row.condition), source=row.source, low=row.friction_min, high=row.friction_max,
            )  # fmt: skip
        if len(rows) > 1:
            low, _, high = of_group.range
            yield finding("lining-unknown", "info", path=path, names=", ".join(rows), low=low, high=high)


def speed_findings(spec: Spec) -> Iterator[Finding]:
    """Yield a finding on the speed before the event if it is taken from the rating plate of the motor."""
    if spec.drive.speed is None and spec.speed is not None:
        yield finding("speed-from-plate", "info", value=float(spec.speed), path="drive.speed")


def carried_by_motor(value: float, motor: float, at: str, carries: str, heat: float, off: float | None) -> Finding:
    """Finding that the motor can carry the slip torque: for ever if ``off`` is None, else until it is switched off."""
    code = "motor-never-stops" if off is None else "motor-stops-at-cut-off"
    level: Level = "error" if off is None else "info"
    path = "drive.cut_off"
    return finding(code, level, value=value, limit=motor, path=path, at=at, carries=carries, heat=heat, off=off)
