"""Words of a report for each case, section and entry, and their order by language; the page has the rest."""

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
    # findings
    "level/info": "note",
    "level/warning": "warning",
    "level/error": "error",
}
"""Key → what is said."""


def told(key: str) -> str:
    """Say what stands under a key, in the language of the user."""
    return translate(REPORT[key])


def titled(path: str) -> str:
    """Title of a table of a spec."""
    name = path.rpartition(".")[2]
    return told(f"group/{name}") if f"group/{name}" in REPORT else path


SHORT = ("requirements", "checks", "peaks", "spec", "conclusion", "references")
"""Sections of a report of two pages."""


class Form(NamedTuple):
    """Order of the parts of a report."""

    sections: Sequence[str]
    """In their order; one without content is left out, unless it is always there."""
    appendices: Sequence[str]
    """After them, each under a letter; one without content is left out."""
    letters: str
    always: Sequence[str]
    """Sections that stand even where there is nothing to tell."""
    entries: Sequence[str]
    """Of the title block, in their order."""
    signed: Sequence[str]
    """Entries that have a place in every title block: one may sign there."""
    paper: Literal["plain", "framed"]
    """Of the form ``calculation``: sheets with a running title, or with frame and title block; there each symbol of a
    formula is explained on a line of its own."""


PEOPLE = ("author", "checked", "norm_control", "approved")
"""Roles of those who sign, in their order."""

FORMS = {
    "en": Form(
        sections=("requirements", "checks", "spec", "calculation", "conclusion", "references"),
        appendices=("symbols", "misprints", "source"),
        letters="ABC",
        always=(),
        entries=("organisation", "project", "drawing", "revision", "date", "variant", "program"),
        signed=("author", "checked", "approved"),
        paper="plain",
    ),
    # ГОСТ Р 2.105-2019, 2.106: a расчёт (РР)
    "ru": Form(
        sections=("requirements", "spec", "checks", "calculation", "conclusion", "symbols", "references"),
        appendices=("misprints", "source"),
        letters="АБВ",
        always=("requirements", "symbols"),
        entries=("drawing", "organisation", "project", "revision", "date", "variant", "program"),
        signed=("drawing", *PEOPLE),
        paper="framed",
    ),
}
"""Language → form; one that has none of its own takes the English one."""


def form() -> Form:
    """Form of a report in the language of the user."""
    return FORMS.get(spoken(), FORMS["en"])
