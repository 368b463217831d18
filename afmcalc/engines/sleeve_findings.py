"""What a designer should know of the sleeve of an indirect clutch."""

from collections.abc import Callable

from ..arrays import Values
from ..findings import Finding, finding
from . import geometry
from .laws import IndirectLaw
from .protocol import Clutch


def sleeve_findings(clutch: Clutch, law: IndirectLaw, hysteresis_ratio: Callable[[], Values]) -> list[Finding]:
    """Springs that are curved, idle feedback, the key's hysteresis, a pocket that lets the torque fall."""
    springs = [] if law.curved is None else [finding("curved-springs", "info", path=_curved_path(law))]
    gain, threshold = float(law.gain), float(law.gain_threshold)
    if law.net_gain == 0:
        path = geometry.gain_path(clutch.spec)
        return [*springs, finding("feedback-idle/key", "warning", value=gain, limit=threshold, path=path)]
    key = _key_findings(clutch, hysteresis_ratio) if law.key_friction else []
    return [*springs, *_slope_findings(clutch, law), *key]


def _curved_path(law: IndirectLaw) -> str:
    assert law.curved is not None
    return "control_spring.disc" if law.curved.closing is None else "closing_spring.disc"


def _slope_findings(clutch: Clutch, law: IndirectLaw) -> list[Finding]:
    """Beyond C_1* the sleeve runs off under a load that reaches T_н, and the torque falls."""
    slope, path = float(law.gain_slope), "control_unit.gain_slope"
    leaving = float(law.leaving_friction(clutch.closing_force))
    if slope == 0 or not 0 < leaving < clutch.friction[0].max:
        return []
    force, friction_max = clutch.closing_force, clutch.friction[0].max
    best, jumping = float(law.constant_torque_slope(force, friction_max)), float(law.jumping_slope(force))
    if slope <= best * (1 + 1e-9):
        return []
    falls, most = float(clutch.torque(friction_max)), float(clutch.torque(leaving))
    code = "torque-jumps" if slope > jumping else "torque-falls-with-travel"
    return [finding(code, "warning", value=slope, limit=best, path=path, most=most, falls=falls, jumping=jumping)]


def _key_findings(clutch: Clutch, hysteresis_ratio: Callable[[], Values]) -> list[Finding]:
    """How the key holds the sleeve back; a warning where the machine's torque is then no longer transmitted."""
    least = clutch.torque_returning_min
    assert least is not None
    returning, nominal = float(least), float(clutch.nominal_torque)
    key = "control_unit.key_friction"
    found = [finding("hysteresis", "info", value=float(hysteresis_ratio()), limit=1.0, path=key)]
    machine = float(clutch.machine_torque)
    if returning < machine * (1 - 1e-12):
        found.append(finding("returning-below-nominal", "warning", value=returning, limit=nominal, path=key))
    elif returning < nominal * (1 - 1e-12):
        found.append(finding("returning-covered", "info", value=returning, limit=nominal, path=key, machine=machine))
    return found
