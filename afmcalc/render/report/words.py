"""Titles of sections, entries and cases of a report, and the order of sections and entries in each language."""

from collections.abc import Mapping, Sequence
from typing import Literal, NamedTuple

from ...messages import spoken, translate

REPORT: Mapping[str, str] = {
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
    # chapters
    "requirements": "Requirements",
    "checks": "Checks",
    "spec": "Initial data",
    "calculation": "Calculation",
    "peaks": "Peaks and heat",
    "as-set/min-friction": "Where nothing else is said, the spring is set at f_min.",
    "as-set/mean-friction": "Where nothing else is said, the spring is set at the mean friction.",
    "conclusion": "Conclusions",
    "next": "What is to be done next",
    "symbols": "Symbols",
    "references": "References",
    "misprints": "Misprints of the papers",
    "source": "The spec as given",
    # a derivation
    "friction": "Case",
    "setting": "Spring set at",
    "side": "Side",
    "setting/min-friction": "f_min",
    "setting/mean-friction": "mean f",
    "side/protected": "protected",
    "side/unprotected": "unprotected",
    # tables of a spec
    "group/": "Clutch",
    "group/friction": "Friction",
    "group/driving": "Driving pairs",
    "group/driven": "Driven pairs",
    "group/friction_group": "Friction discs",
    "group/closing_spring": "Closing spring",
    "group/control_spring": "Control spring",
    "group/room": "Room for the spring",
    "group/disc": "Disc springs",
    "group/coil": "Coil springs",
    "group/control_unit": "Control unit: balls and pockets",
    "group/contact": "Contact of ball and wall",
    "group/pressure_disc_key": "Key of the pressure disc",
    "group/adjustment": "Setting of the spring",
    "group/machine": "Machine",
    "group/drive": "Drive",
    "group/motor": "Motor by its slip",
    "group/event": "What happens to the tool",
    "group/shaft": "Shaft",
    "group/fatigue": "Fatigue of the shaft",
    "group/heat": "Heat and wear",
    "group/tolerance": "Tolerances and scatter",
    "group/envelope": "Space for the clutch",
    "group/requirements": "Requirements",
    "group/drawing": "Notes of the drawing",
    "group/report": "Title block",
    "group/search": "Search by design",
    # findings
    "level/info": "note",
    "level/warning": "warning",
    "level/error": "error",
}
"""Key → its English text."""
SHORT = ("requirements", "checks", "peaks", "spec", "conclusion", "references")
"""Sections of a short report."""
PEOPLE = ("author", "checked", "norm_control", "approved")
"""Roles of the people who sign, in their order."""


def told(key: str) -> str:
    """Text of ``REPORT`` under a key, translated."""
    return translate(REPORT[key])


def titled(path: str) -> str:
    """Title of a table of a spec by its path; the path itself if the table has no title."""
    name = path.rpartition(".")[2]
    return told(f"group/{name}") if f"group/{name}" in REPORT else path


class Form(NamedTuple):
    """Order of the parts of a report."""

    sections: Sequence[str]
    """Sections in their order; an empty section is left out, but requirements not on framed sheets."""
    appendices: Sequence[str]
    """Appendices in their order, each with a letter; an empty appendix is left out."""
    letters: str
    entries: Sequence[str]
    """Entries of the title block, in their order."""
    signed: Sequence[str]
    """Entries and roles that are shown even if empty, to be filled in by hand."""
    paper: Literal["plain", "framed"]
    """Layout of the sheets: ``plain`` with a running title, or ``framed`` with frame, title block, and each symbol of a
    formula explained on its own line."""


FORMS = {
    "en": Form(
        sections=("requirements", "checks", "spec", "calculation", "conclusion", "references"),
        appendices=("symbols", "misprints", "source"),
        letters="ABC",
        entries=("organisation", "project", "drawing", "revision", "date", "variant", "program"),
        signed=("author", "checked", "approved"),
        paper="plain",
    ),
    # ГОСТ Р 2.105-2019, 2.106: a расчёт (РР)
    "ru": Form(
        sections=("requirements", "spec", "checks", "calculation", "conclusion", "symbols", "references"),
        appendices=("misprints", "source"),
        letters="АБВ",
        entries=("drawing", "organisation", "project", "revision", "date", "variant", "program"),
        signed=("drawing", *PEOPLE),
        paper="framed",
    ),
}
"""Language → form of a report; other languages take the English form."""


def form() -> Form:
    """Form of a report in the language of the user."""
    return FORMS.get(spoken(), FORMS["en"])
