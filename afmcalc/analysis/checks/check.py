"""Check of a design: its findings and whether it passes."""

from typing import ClassVar

from ...engines.protocol import Clutch
from ...findings import Finding, worst
from ...result import Result, quantity


class CheckResult(Result):
    """Whether a design passes, and how many findings of each level it has."""

    findings_first: ClassVar[bool] = True

    passed: bool = quantity("", None, "whether the check passed")
    errors: int = quantity("", None, "findings that must be put right")
    warnings: int = quantity("", None, "findings to think about")
    notes: int = quantity("", None, "findings worth knowing")


def check(clutch: Clutch, *, strict: bool = False) -> tuple[CheckResult, list[Finding]]:
    """Collect the findings of a design.

    Args:
        clutch: the clutch.
        strict: warnings fail the check too.

    Returns:
        The verdict and the findings.
    """
    findings = all_findings(clutch)
    levels = [finding.level for finding in findings]
    failing = ("error", "warning") if strict else ("error",)
    result = CheckResult(
        passed=worst(findings) not in failing,
        errors=levels.count("error"),
        warnings=levels.count("warning"),
        notes=levels.count("info"),
    )
    return result, findings


def all_findings(clutch: Clutch) -> list[Finding]:
    """Return the findings of every analysis that applies to the clutch, each once."""
    from ..life import life
    from ..synthesize import synthesize
    from .pressure import pressure_findings

    found = [*clutch.findings(), *pressure_findings(clutch)]
    unit = clutch.spec.control_unit
    if unit is not None and unit.ball_circle_radius is not None and clutch.gain > 0:
        found += synthesize(clutch)[1]
    if clutch.spec.fatigue is not None:
        found += life(clutch)[1]
    return list(dict.fromkeys(found))
