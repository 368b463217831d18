"""All that is to be said of one clutch, for a report."""

from ..engines.protocol import Clutch
from ..findings import Finding
from ..result import Result, quantity
from .accuracy import AccuracyResult, accuracy
from .adjust import AdjustResult, adjust
from .checks.check import CheckResult, check
from .checks.limits import Check, checks
from .life import LifeResult, Model, life
from .overload import OverloadResult, applies, overload
from .synthesize import SynthesisResult, synthesize
from .torque import TorqueResult, torque


class Dossier(Result):
    """The results of every analysis that applies to a clutch; null where one does not."""

    check: CheckResult = quantity("", None, "verdict")
    checks: list[Check] = quantity("", None, "limits and utilisations")
    torque: TorqueResult = quantity("", None, "torque and forces")
    accuracy: AccuracyResult = quantity("", None, "accuracy")
    adjust: AdjustResult = quantity("", None, "both settings")
    overload: OverloadResult | None = quantity("", None, "overload with a torque margin", optional=True)
    synthesis: SynthesisResult | None = quantity("", None, "control unit", optional=True)
    life: LifeResult | None = quantity("", None, "fatigue life", optional=True)


def dossier(clutch: Clutch, model: Model = "mean-stress") -> tuple[Dossier, list[Finding]]:
    """Run every analysis that applies.

    Args:
        clutch: the clutch.
        model: rule for the damaging stress of the life.

    Returns:
        The results, and the findings of all of them, each once.
    """
    verdict, findings = check(clutch)
    unit, spec = clutch.spec.control_unit, clutch.spec
    synthesized = synthesize(clutch) if unit and unit.ball_circle_radius is not None and clutch.gain > 0 else None
    lived = life(clutch, model) if spec.fatigue is not None else None
    overloaded = overload(clutch) if applies(clutch) else None
    for part in (overloaded, lived):
        findings += part[1] if part else []
    findings = list(dict.fromkeys(findings))
    found = Dossier(
        check=verdict,
        checks=checks(clutch, synthesized[0] if synthesized else None, lived[0] if lived else None, findings),
        torque=torque(clutch)[0],
        accuracy=accuracy(clutch)[0],
        adjust=adjust(clutch)[0],
        overload=overloaded[0] if overloaded else None,
        synthesis=synthesized[0] if synthesized else None,
        life=lived[0] if lived else None,
    )
    return found, findings
