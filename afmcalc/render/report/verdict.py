"""The verdict of a report, and what limits the clutch."""

from typing import Literal, NamedTuple

from ...analysis.dossier import Dossier
from ..units import worded
from .words import told


class Verdict(NamedTuple):
    """What became of a clutch."""

    grade: Literal["pass", "warning", "fail"]
    sentence: str
    limit: str
    """What limits the clutch first; empty where nothing does."""


def verdict(dossier: Dossier) -> Verdict:
    """Sum up requirements and checks."""
    required, checked = _required(dossier), _checked(dossier)
    sentence, limit = told(f"verdict/{required}/{checked}"), _limit(dossier)
    if required == "missed" or checked == "failed":
        return Verdict("fail", sentence, limit)
    return Verdict("pass" if required in ("none", "met") and checked == "passed" else "warning", sentence, limit)


def _required(dossier: Dossier) -> Literal["none", "met", "open", "missed"]:
    passed = [row.passed for row in dossier.requirements]
    if False in passed:
        return "missed"
    return "none" if not passed else "open" if None in passed else "met"


def _checked(dossier: Dossier) -> Literal["passed", "warned", "exceeded", "failed"]:
    """What became of everything but the requirements."""
    levels = {each.level for each in dossier.findings if not each.code.startswith("requirement-")}
    if "error" in levels:
        return "failed"
    if any(each.verdict != "pass" for each in dossier.limits):
        return "exceeded"
    return "warned" if "warning" in levels else "passed"


def _limit(dossier: Dossier) -> str:
    """Name the limit of which the clutch uses most."""
    most = max(dossier.limits, key=lambda each: each.utilisation, default=None)
    if most is None:
        return ""
    key = "limited" if most.verdict == "pass" else "limited/exceeded"
    return told(key, name=worded(most.name), symbol=most.symbol, utilisation=most.utilisation)
