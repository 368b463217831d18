"""What a designer should know of the sleeve of an indirect clutch."""

from typing import TYPE_CHECKING

from ..findings import Finding, finding
from . import geometry

if TYPE_CHECKING:
    from .indirect import IndirectClutch


def sleeve_findings(clutch: "IndirectClutch") -> list[Finding]:
    """Springs that are curved, idle feedback, the key's hysteresis, a pocket that lets the torque fall."""
    springs = [] if clutch.law.curved is None else [finding("curved-springs", "info", path=_curved_path(clutch))]
    gain, threshold = float(clutch.gain), float(clutch.gain_threshold)
    if clutch.net_gain == 0:
        path = geometry.gain_path(clutch.spec)
        return [*springs, finding("feedback-idle/key", "warning", value=gain, limit=threshold, path=path)]
    return [*springs, *_slope_findings(clutch), *_key_findings(clutch)]


def _curved_path(clutch: "IndirectClutch") -> str:
    assert clutch.law.curved is not None
    return "control_spring.disc" if clutch.law.curved.closing is None else "closing_spring.disc"


def _slope_findings(clutch: "IndirectClutch") -> list[Finding]:
    """Beyond C_1* the sleeve runs off under a load that reaches T_н, and the torque falls."""
    slope, path = float(clutch.gain_slope), "control_unit.gain_slope"
    leaving = float(clutch.leaving_friction)
    if slope == 0 or not 0 < leaving < clutch.friction[0].max:
        return []
    best, jumping = float(clutch.constant_torque_slope), float(clutch.law.jumping_slope(clutch.closing_force))
    if slope <= best * (1 + 1e-9):
        return []
    falls, most = float(clutch.torque(clutch.friction[0].max)), float(clutch.torque_max)
    code = "torque-jumps" if slope > jumping else "torque-falls-with-travel"
    return [finding(code, "warning", value=slope, limit=best, path=path, most=most, falls=falls, jumping=jumping)]


def _key_findings(clutch: "IndirectClutch") -> list[Finding]:
    """How the key holds the sleeve back; a warning where the machine's torque is then no longer transmitted."""
    if clutch.law.key_friction == 0:
        return []
    returning, nominal = float(clutch.torque_returning_min), float(clutch.nominal_torque)
    key = "control_unit.key_friction"
    found = [finding("hysteresis", "info", value=float(clutch.hysteresis_ratio), limit=1.0, path=key)]
    machine = float(clutch.machine_torque)
    if returning < machine * (1 - 1e-12):
        found.append(finding("returning-below-nominal", "warning", value=returning, limit=nominal, path=key))
    elif returning < nominal * (1 - 1e-12):
        found.append(finding("returning-covered", "info", value=returning, limit=nominal, path=key, machine=machine))
    return found
