"""The form of a report: what stands where, by what the readers of a language are used to."""

from collections.abc import Sequence
from typing import NamedTuple


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
