"""The sections of a report: each a function of the subject, None where it does not apply."""

from collections.abc import Callable
from typing import Any

from ...errors import CalculationError
from ...result import Result, Triple
from ..document import Document, document
from ..layout import Block, blocks
from ..plot import Request, sheet_of
from ..plot.chart import Sheet
from ..units import display, display_unit
from .interface import Section, Subject
from .scatter import scatter_blocks


def _torque(subject: Subject) -> Section:
    return Section(
        "torque",
        "Torque and forces",
        "The slipping clutch at the smallest, the mean and the largest friction, spring as set.",
        blocks(document(subject.dossier.torque)),
        _plots("torque", subject),
        ["S21"] if _indirect(subject) else ["F11"],
    )


def _accuracy(subject: Subject) -> Section:
    plots = [] if not subject.clutch.spec.kind.controlled else _plots("accuracy", subject)
    about = "K_т is the largest over the smallest torque in service; 1 would be perfect."
    sources = ["S21"] if _indirect(subject) else ["F11", "S22"]
    return Section("accuracy", "Accuracy", about, blocks(document(subject.dossier.accuracy)), plots, sources)


def _adjust(subject: Subject) -> Section:
    found = subject.dossier.adjust
    laid_out = document(found)
    own = [row for row in laid_out.singles if not row.path.startswith(("min_friction.", "mean_friction."))]
    methods = _side_by_side({"set at f_min": found.min_friction, "set at mean f": found.mean_friction})
    return Section(
        "adjust",
        "Both settings of the spring",
        "The same nominal torque, reached at the smallest friction or, with the margin, at the mean friction.",
        [methods, *blocks(Document(own, [], [], []))],
        sources=["S19"],
    )


def _overload(subject: Subject) -> Section | None:
    found = subject.dossier.overload
    if found is None:
        return None
    about = "What the drive sees when the clutch, set with a margin over the machine's torque, begins to slip."
    return Section(
        "overload", "Overload", about, blocks(document(found)), _plots("overload", subject), ["S22"]
    )  # fmt: skip


def _synthesis(subject: Subject) -> Section | None:
    found = subject.dossier.synthesis
    if found is None:
        return None
    about = "Wall angle, ball and pocket for the gain; the contact held against what it may carry."
    return Section(
        "synthesize", "Control unit", about, blocks(document(found)), _plots("pocket", subject), ["S21"]
    )  # fmt: skip


def _life(subject: Subject) -> Section | None:
    found = subject.dossier.life
    if found is None:
        return None
    about = f"Cycles to failure on both sides of the clutch, by the rule {found.model}."
    return Section(
        "life", "Life", about, blocks(document(found)), _plots("life", subject, subject.model), ["S19"]
    )  # fmt: skip


def _tolerance(subject: Subject) -> Section | None:
    found = subject.results.get("tolerance")
    if found is None:
        return None
    from ..plot.kinds.tolerance import drawn

    about = "The slip torque as making and service scatter, by the block [tolerance]" + (
        "; the answer is exact." if found.result.method == "exact" else "; ± is the standard error of the sample."
    )
    try:
        plots = [drawn(subject.clutch, found)]
    except CalculationError:
        plots = []
    return Section("tolerance", "Tolerances and scatter", about, scatter_blocks(found.result), plots)


SECTIONS: tuple[Callable[[Subject], Section | None], ...] = (
    _torque,
    _accuracy,
    _adjust,
    _overload,
    _synthesis,
    _life,
    _tolerance,
)
"""In the order of the report. A further one is a function here, of ``subject.results``."""


def sections(subject: Subject) -> list[Section]:
    """Return the sections that apply."""
    return [section for make in SECTIONS if (section := make(subject)) is not None]


def _indirect(subject: Subject) -> bool:
    return subject.clutch.spec.kind.travels


def _plots(kind: str, subject: Subject, model: str | None = None) -> list[Sheet]:
    """The plot of a section; none where there is no curve to draw (friction that does not wander, no limit of life)."""
    try:
        return [sheet_of(kind, Request([subject.clutch], model=model))]
    except CalculationError:
        return []


def _side_by_side(results: dict[str, Result]) -> Block:
    """Set results of one type as columns; a triple takes a row for each friction."""
    columns = [_rows(result) for result in results.values()]
    rows = [[*about, *(column[number][1] for column in columns)] for number, (about, _) in enumerate(columns[0])]
    lined = [[symbol, name, *values, unit] for symbol, name, unit, *values in rows]
    header = ["Symbol", "Quantity", *results, "Unit"]
    return Block("", header, lined, [False, False, *(True for _ in results), False])


def _rows(result: Result) -> list[tuple[tuple[str, str, str], str]]:
    """(symbol, name, unit) and value of every field."""
    found = []
    for name, info in type(result).model_fields.items():
        about: dict[str, Any] = info.json_schema_extra if isinstance(info.json_schema_extra, dict) else {}
        unit, symbol = str(about.get("unit") or ""), str(about.get("symbol") or "")
        value, title, shown = getattr(result, name), info.description or name, display_unit(unit)
        if isinstance(value, Triple):
            found += [
                ((symbol, f"{title} {at}", shown), display(each, unit))
                for at, each in (("at f_min", value.min), ("at mean f", value.mean), ("at f_max", value.max))
            ]
        else:
            found.append(((symbol, title, shown), display(value, unit)))
    return found
