"""Check of a design: its findings and whether it passes."""

from ..engines.findings import Finding, worst
from ..engines.protocol import Clutch
from .result import Result, quantity


class CheckResult(Result):
    """Whether a design passes, and how many findings of each level it has."""

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
    """Return the findings of every analysis that applies to the clutch."""
    return clutch.findings()
