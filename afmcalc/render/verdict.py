"""What became of a clutch, in one sentence: the same in a check, a report and on the page."""

from collections.abc import Iterable
from typing import TYPE_CHECKING, Literal, NamedTuple

from ..findings import Finding
from ..messages import told, translate
from .symbols import native
from .units import worded

if TYPE_CHECKING:
    from ..analysis.check import CheckResult
    from ..analysis.limits import Utilisation
    from ..analysis.requirements import RequirementRow

SENTENCES = {
    "none/passed": "The clutch passes every check. The spec states no requirements.",
    "none/warned": "The clutch passes the checks, with warnings to weigh. The spec states no requirements.",
    "none/exceeded": "The clutch goes beyond limits of the checks: weigh them. The spec states no requirements.",
    "none/failed": "The clutch fails the checks and must not be made so. The spec states no requirements.",
    "met/passed": "The clutch meets every requirement and passes every check.",
    "met/warned": "The clutch meets every requirement and passes the checks, with warnings to weigh.",
    "met/exceeded": "The clutch meets every requirement but goes beyond limits of the checks: weigh them.",
    "met/failed": "The clutch meets the requirements but fails the checks and must not be made so.",
    "open/passed": "The clutch meets every requirement that could be judged and passes every check; "
    "some requirements are not judged.",
    "open/warned": "The clutch meets every requirement that could be judged and passes the checks, with "
    "warnings to weigh; some requirements are not judged.",
    "open/exceeded": "The clutch meets every requirement that could be judged but goes beyond limits "
    "of the checks: weigh them; some requirements are not judged.",
    "open/failed": "The clutch fails the checks and must not be made so; some requirements are not judged.",
    "missed/passed": "The clutch passes every check but does not meet its requirements.",
    "missed/warned": "The clutch does not meet its requirements; it passes the checks, with warnings to weigh.",
    "missed/exceeded": "The clutch does not meet its requirements and goes beyond limits of the checks.",
    "missed/failed": "The clutch fails the checks and does not meet its requirements: it must not be made so.",
}
"""Requirements/checks → what is said."""


class Verdict(NamedTuple):
    """What became of a clutch."""

    grade: Literal["pass", "warning", "fail"]
    sentence: str
    limit: str
    """What limits the clutch first; empty where nothing does."""


def verdict(check: "CheckResult", findings: Iterable[Finding]) -> Verdict:
    """Sum up requirements and checks, and name the limit or requirement of which the clutch uses most."""
    passed = {row.passed for row in check.requirements}
    required = "missed" if False in passed else "open" if None in passed else "met" if passed else "none"
    levels = {finding.level for finding in findings if not finding.code.startswith("requirement-")}
    exceeded = any(limit.verdict != "pass" for limit in check.limits)
    checked = "exceeded" if exceeded else "warned" if "warning" in levels else "passed"
    checked = "failed" if "error" in levels or (not check.passed and not check.errors) else checked
    whole = required in ("none", "met") and checked == "passed"
    failed = required == "missed" or checked == "failed"
    used: list[tuple[float, bool | None, Utilisation | RequirementRow]] = [
        *((limit.utilisation, limit.verdict == "pass", limit) for limit in check.limits if not limit.by_choice),
        *((row.utilisation, row.passed, row) for row in check.requirements if row.utilisation is not None),
    ]
    limit = ""
    if used:
        share, held, most = max(used, key=lambda each: each[0])
        limit = told(
            "What limits the clutch first is “{name}” ({symbol}): it uses {utilisation:.1%} of that limit."
            if held
            else "The clutch goes farthest beyond “{name}” ({symbol}): {utilisation:.1%} of that limit.",
            name=worded(most.name), symbol=native(most.symbol), utilisation=share,
        )  # fmt: skip
    sentence = translate(SENTENCES[f"{required}/{checked}"])
    return Verdict("fail" if failed else "pass" if whole else "warning", sentence, limit)
