"""The verdict of a report, in one sentence."""

from typing import Literal, NamedTuple

from ...analysis.dossier import Dossier
from .words import told


class Verdict(NamedTuple):
    """What became of a clutch."""

    grade: Literal["pass", "warning", "fail"]
    sentence: str


def verdict(dossier: Dossier) -> Verdict:
    """Sum up requirements and checks."""
    required, checked = _required(dossier), _checked(dossier)
    sentence = told(f"verdict/{required}/{checked}")
    if required == "missed" or checked == "failed":
        return Verdict("fail", sentence)
    return Verdict("warning" if required == "open" or checked == "warned" else "pass", sentence)


def _required(dossier: Dossier) -> Literal["none", "met", "open", "missed"]:
    passed = [row.passed for row in dossier.requirements]
    if False in passed:
        return "missed"
    return "none" if not passed else "open" if None in passed else "met"


def _checked(dossier: Dossier) -> Literal["passed", "warned", "failed"]:
    """What became of everything but the requirements."""
    levels = {each.level for each in dossier.findings if not each.code.startswith("requirement-")}
    return "failed" if "error" in levels else "warned" if "warning" in levels else "passed"
