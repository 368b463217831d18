"""What a report says itself, in one table that a catalogue can hold; and where it says it, by language."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from ...messages import Text, spoken, translate

REPORT: Mapping[str, str] = {
    "kind": "Calculation report",
    "unnamed": "Adaptive friction clutch",
    # title block
    "organisation": "Organisation",
    "project": "Project",
    "drawing": "Drawing no.",
    "revision": "Revision",
    "variant": "Variant",
    "date": "Date",
    "author": "Calculated by",
    "checked": "Checked by",
    "norm_control": "Standards checked by",
    "approved": "Approved by",
    "program": "Program",
    "file": "Spec",
    "digest": "SHA-256 of the spec as given",
    "changed": "Overridden on the command line",
    # the verdict, by what became of the requirements and of the check
    "verdict/none/passed": "The clutch passes every check. The spec states no requirements.",
    "verdict/none/warned": "The clutch passes the checks, with warnings to weigh. The spec states no requirements.",
    "verdict/none/exceeded": "The clutch goes beyond limits of the checks: weigh them. The spec states no "
    "requirements.",
    "verdict/none/failed": "The clutch fails the checks and must not be made so. The spec states no requirements.",
    "verdict/met/passed": "The clutch meets every requirement and passes every check.",
    "verdict/met/warned": "The clutch meets every requirement and passes the checks, with warnings to weigh.",
    "verdict/met/exceeded": "The clutch meets every requirement but goes beyond limits of the checks: weigh them.",
    "verdict/met/failed": "The clutch meets the requirements but fails the checks and must not be made so.",
    "verdict/open/passed": "The clutch meets every requirement that could be judged and passes every check; "
    "some requirements are not judged.",
    "verdict/open/warned": "The clutch meets every requirement that could be judged and passes the checks, with "
    "warnings to weigh; some requirements are not judged.",
    "verdict/open/exceeded": "The clutch meets every requirement that could be judged but goes beyond limits "
    "of the checks: weigh them; some requirements are not judged.",
    "verdict/open/failed": "The clutch fails the checks and must not be made so; some requirements are not judged.",
    "verdict/missed/passed": "The clutch passes every check but does not meet its requirements.",
    "verdict/missed/warned": "The clutch does not meet its requirements; it passes the checks, with warnings to weigh.",
    "verdict/missed/exceeded": "The clutch does not meet its requirements and goes beyond limits of the checks.",
    "verdict/missed/failed": "The clutch fails the checks and does not meet its requirements: it must not be made so.",
    # chapters
    "contents": "Contents",
    "requirements": "Requirements",
    "requirements/none": "The spec states no requirements; the clutch is calculated as it is given.",
    "requirements/about": "What the clutch is to hold, by the block [requirements] of the spec.",
    "checks": "Checks",
    "checks/about": "Every limit the clutch is held against; utilisation 1 is the limit.",
    "findings": "Findings",
    "spec": "Initial data",
    "resolved": "Values calculated with",
    "given": "The spec as given",
    "calculation": "Calculation",
    "calculation/about": "Each formula stands once, with its source; below it the numbers put in, in SI units, and "
    "what comes out, in the units of the tables.",
    "one-friction": "All pairs are alike: f_1 = f_2 = f.",
    "as-set/min-friction": "Where nothing else is said, the spring is set at f_min.",
    "as-set/mean-friction": "Where nothing else is said, the spring is set at the mean friction.",
    "steps": "Derivation",
    "plots": "Plots",
    "conclusion": "Conclusion",
    "limited": "What limits the clutch first is “{name}” ({symbol}): it uses {utilisation:.3g} of that limit.",
    "limited/exceeded": "The clutch goes farthest beyond “{name}” ({symbol}): {utilisation:.3g} of that limit.",
    "symbols": "Symbols",
    "references": "References",
    "misprints": "M with a number is a misprint of a paper, mended here; afmcalc equations --misprints lists them.",
    # a derivation
    "where": "where",
    "by": "by ({number})",
    "is": "{source} by ({number})",
    "again": "By formula ({number}).",
    "differs": "The print differs: {printed}",
    "friction": "Friction",
    "branch": "Friction is",
    "setting": "Spring set at",
    "side": "Side",
    "numbers": "Numbers put in",
    "value": "Value",
    "branch/": "rising",
    "branch/returning": "falling, the sleeve moves back",
    "branch/held": "falling from {after}, the key holds the sleeve",
    "setting/min-friction": "f_min",
    "setting/mean-friction": "mean f",
    "side/protected": "protected",
    "side/unprotected": "unprotected",
    # tables
    "verdict": "Verdict",
    "requirement": "Requirement",
    "bound": "Is to be",
    "check": "Check",
    "condition": "Condition",
    "limit": "Limit",
    "unit": "Unit",
    "utilisation": "Utilisation",
    "symbol": "Symbol",
    "quantity": "Quantity",
    "key": "Key",
    "grade/pass": "pass",
    "grade/note": "note",
    "grade/warning": "warning",
    "grade/fail": "fail",
    "grade/held": "held",
    "grade/missed": "missed",
    "grade/open": "not judged",
    "level/info": "note",
    "level/warning": "warning",
    "level/error": "error",
    # a figure
    "figure": "Fig. {number}.",
    "see": "Fig. {number}",
}
"""Key → what is said; fields are those of ``messages``."""


def told(key: str, **values: object) -> str:
    """Say what stands under a key, in the language of the user."""
    return translate(Text(REPORT[key], values))


class Form(NamedTuple):
    """What stands where."""

    sections: Sequence[str]
    """In their order; one without content is left out, unless it is always there."""
    always: Sequence[str]
    """Sections that stand even where there is nothing to tell."""
    entries: Sequence[str]
    """Of the title block, in their order."""
    signed: Sequence[str]
    """Entries that have a place in every title block: one may sign there."""
    lined: bool
    """Whether each symbol of a formula is explained on a line of its own."""


_ENTRIES = ("organisation", "project", "drawing", "revision", "date", "variant")

FORMS = {
    "en": Form(
        sections=("requirements", "checks", "spec", "calculation", "plots", "conclusion", "references"),
        always=(),
        entries=(*_ENTRIES, "author", "checked", "norm_control", "approved", "program"),
        signed=("author", "checked", "approved"),
        lined=False,
    ),
    # ГОСТ Р 2.105-2019, 2.106: a расчёт (РР)
    "ru": Form(
        sections=(
            *("requirements", "spec", "checks", "calculation", "plots"),
            *("conclusion", "symbols", "references"),
        ),
        always=("requirements", "symbols"),
        entries=("drawing", "organisation", "project", "revision", "date", "variant")
        + ("author", "checked", "norm_control", "approved", "program"),
        signed=("drawing", "author", "checked", "norm_control", "approved"),
        lined=True,
    ),
}
"""Language → form."""


def form_spoken() -> Form:
    """Form of a calculation in the language of the user; one that has none of its own takes the English one."""
    return FORMS.get(spoken(), FORMS["en"])
