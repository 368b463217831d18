"""What a page is shown of a clutch: fragments of HTML, from the functions that the commands ask."""

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any, NamedTuple

from markupsafe import Markup

from ..analysis.answers import Answers
from ..analysis.check import check_at_once
from ..analysis.compare import change
from ..analysis.dossier import Dossier
from ..analysis.figures import Request, gathered
from ..analysis.requirements import simulating
from ..engines import build
from ..errors import AfmcalcError, CalculationError
from ..messages import localized, told, translate
from ..render.document import Column, document
from ..render.drawing import Drawing
from ..render.layout import cells, ranked
from ..render.plot import quick, sheet_of
from ..render.plot.chart import Chart, Sheet
from ..render.plot.figure import inline_svg
from ..render.report.markup import drawing
from ..render.report.page import template, verdict
from ..render.units import display_unit
from .base import Base, editable

HERE = Path(__file__).parent
Fields = Mapping[str, str]


class Ask(NamedTuple):
    """What a page asks: of which clutch, and what of it."""

    name: str
    """``live``, or the name of a tab."""
    base: Base
    fields: Fields
    pinned: tuple[Base, Fields] | None = None
    options: Mapping[str, str] = {}
    first: int = 0
    """Number of the first base that the answer may make."""


def fragment(name: str, *arguments: object) -> str:
    """Fill a macro of the page."""
    return str(getattr(template("parts.html", HERE).module, name)(*arguments))


def asked(base: Base, fields: Fields) -> Answers:
    """Return the clutch that a form is of, to be asked."""
    return Answers(build(base.spec(base.changed(fields))))


def live(ask: Ask) -> dict[str, Any]:
    """Return what is shown of a clutch after each change."""
    answers = asked(ask.base, ask.fields)
    torque, _ = answers.ask("torque")
    checked, findings = check_at_once(answers)
    notes = []
    if simulating(answers.clutch):
        notes.append(told("What is simulated or sampled is not judged here: see the tabs."))
    judged = verdict(Dossier(answers.clutch.spec, checked, findings, []))
    pinned = None
    if ask.pinned:
        with suppress(AfmcalcError):
            pinned = asked(*ask.pinned).ask("torque")[0]
    fragments = {
        "verdict": fragment("verdict", judged, checked, ranked(findings), notes),
        "section": _figure("section", answers, 1),
        "torque": _figure("torque", answers, 2),
        "numbers": fragment("numbers", *_numbers(torque, pinned)),
        "compare": fragment("compare", [*_inputs(ask)]) if ask.pinned else "",
    }
    return {"fragments": fragments, "command": ask.base.command("torque", fields=ask.fields)}


class Cell(NamedTuple):
    """One number of a result."""

    path: str
    value: Any
    shown: str
    pinned: str | None
    change: str | None


class NumberRow(NamedTuple):
    """A quantity with its numbers."""

    symbol: str
    name: str
    unit: str
    cells: list[Cell]


def _numbers(result: Any, pinned: Any) -> tuple[list[NumberRow], list[NumberRow]]:
    """Lay out single values and triples of a result, beside those of a pinned one."""
    now, before = document(result), document(pinned) if pinned else None
    of_pinned = {column.path: column for column in (*before.singles, *before.triples)} if before else {}
    singles = [_row(column, of_pinned.get(column.path), [""]) for column in now.singles if not column.hidden]
    ends = [".min", ".mean", ".max"]
    return singles, [_row(column, of_pinned.get(column.path), ends) for column in now.triples if not column.hidden]


def _row(column: Column, pinned: Column | None, ends: Sequence[str]) -> NumberRow:
    texts = cells(column)
    values, others = (pinned.values, cells(pinned)) if pinned else ([None] * len(ends), [None] * len(ends))
    return NumberRow(
        column.symbol,
        column.name,
        display_unit(column.units[0] if column.units else column.unit),
        [
            Cell(column.path + end, value, shown, other, _moved(value, before))
            for end, value, shown, before, other in zip(ends, column.values, texts, values, others, strict=True)
        ],
    )


def _moved(now: object, before: object) -> str | None:
    share = change(now, before)
    return localized(f"{share:+.1%}") if share else None


def _inputs(ask: Ask) -> Iterator[tuple[str, str, str, str]]:
    """Give each key whose text differs from the pinned one: path, label, both texts."""
    if ask.pinned:
        base, fields = ask.pinned
        before, now = base.texts(fields), ask.base.texts(ask.fields)
        for path, key in editable().items():
            if before.get(path, "") != now.get(path, ""):
                yield path, translate(key.description), before.get(path, ""), now.get(path, "")


def _figure(name: str, answers: Answers, number: int) -> str:
    try:
        sheet = sheet_of(name, gathered(name, Request([answers])))
    except CalculationError as error:
        return fragment("answer", [], [], [], [error.told()])
    return fragment("figure", sheet.title, *drawn(sheet, number))


def drawn(sheet: Sheet, number: int) -> tuple[Markup, str]:
    """Draw a sheet as part of a page, with its caption; ``number`` is that of no other drawing of the page."""
    (panel, *_) = sheet.panels
    if isinstance(panel, Drawing):
        svg = panel.svg()
    elif isinstance(panel, Chart) and quick.is_plain(panel) and len(sheet.panels) == 1:
        svg = quick.svg_of(panel)
    else:
        svg = inline_svg(sheet)
    return drawing(svg, sheet.title, number), sheet.caption
