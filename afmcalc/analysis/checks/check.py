"""Check of a design: its findings and whether it passes."""

from typing import ClassVar

from ...engines.protocol import Clutch
from ...errors import SpecError
from ...findings import Finding, finding
from ...result import Answer, quantity
from ..answers import Answers
from ..registry import ANALYSES
from .limits import Utilisation, hub_findings, utilisations
from .plausible import unusual_findings
from .pressure import pressure_findings
from .requirements import RequirementRow, requirement_rows, simulates


class CheckResult(Answer):
    """Whether a design passes, and how many findings of each level it has."""

    findings_first: ClassVar[bool] = True

    passed: bool = quantity("", None, "whether the check passed")
    errors: int = quantity("", None, "findings that must be put right")
    warnings: int = quantity("", None, "findings to think about")
    notes: int = quantity("", None, "findings worth knowing")
    requirements: list[RequirementRow] = quantity("", None, "requirements")
    limits: list[Utilisation] = quantity("", None, "every limit, and how much of it is used")


def check(clutch: Clutch, *, strict: bool = False, answers: Answers | None = None) -> tuple[CheckResult, list[Finding]]:
    """Collect the findings of a design.

    Args:
        clutch: the clutch.
        strict: warnings fail the check too.
        answers: what was asked of it already.

    Returns:
        The verdict and the findings.
    """
    answers = answers or Answers(clutch)
    findings = all_findings(answers)
    requirements, missed = requirement_rows(answers)
    findings += missed
    levels = [each.level for each in findings]
    failing = {"error", "warning"} if strict else {"error"}
    result = CheckResult(
        passed=failing.isdisjoint(levels),
        errors=levels.count("error"),
        warnings=levels.count("warning"),
        notes=levels.count("info"),
        requirements=requirements,
        limits=utilisations(answers, findings),
    )
    return result, findings


def refused(error: SpecError) -> tuple[CheckResult, list[Finding]]:
    """Verdict on what is no spec, each of its problems a finding."""
    found = [
        finding("bad-spec", "error", path=problem.path or None, where=problem.where(error.source), problem=str(problem))
        for problem in error.problems
    ]
    errors = len(found) + error.more
    return CheckResult(passed=False, errors=errors, warnings=0, notes=0, requirements=[], limits=[]), found


def found_unsimulated(clutch: Clutch) -> list[Finding]:
    """Return what a check finds but for what has to be simulated or sampled first; a life takes its event's factor."""
    answers = Answers(clutch)
    return [*all_findings(answers, simulated=False), *requirement_rows(answers, simulated=False)[1]]


def all_findings(answers: Answers, *, simulated: bool = True) -> list[Finding]:
    """Return the findings of every analysis that a check takes in and that applies to the clutch, each once.

    Args:
        answers: what was asked of the clutch.
        simulated: whether those that simulate an event are asked.
    """
    clutch = answers.clutch
    judged = [
        each.name
        for each in ANALYSES.values()
        if each.judged and each.applies(clutch) and (simulated or not simulates(each.name, clutch))
    ]
    found = [*clutch.findings(), *pressure_findings(clutch), *hub_findings(answers), *unusual_findings(answers)]
    unit = clutch.spec.control_unit
    if unit is not None and unit.ball_circle_radius is None:
        found.append(finding("control-unit-not-judged", "info", path="control_unit.ball_circle_radius"))
    for name in judged:
        found += answers.ask(name)[1]
    return list(dict.fromkeys(found))
