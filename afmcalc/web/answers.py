"""What a page is shown of a clutch: fragments of HTML, from the functions that the commands ask."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any, NamedTuple

from markupsafe import Markup

from ..analysis.answers import Answers
from ..analysis.check import check_at_once
from ..analysis.dossier import Dossier, dossier
from ..analysis.figures import Request, gathered, plot_of
from ..analysis.registry import ANALYSES
from ..analysis.requirements import simulating
from ..engines import build
from ..errors import AfmcalcError, CalculationError
from ..findings import Finding
from ..messages import told, translate
from ..render.document import Column, document
from ..render.drawing import Drawing
from ..render.layout import TextTable, blocks, cells, ranked
from ..render.plot import sheet_of
from ..render.plot.chart import Sheet
from ..render.plot.figure import inline_svg
from ..render.report.chapters import chapters
from ..render.report.markup import drawing
from ..render.report.page import template, verdict
from ..render.units import display_unit
from .base import Base, editable, refusal

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


def answer(ask: Ask) -> dict[str, Any]:
    """Answer what a page asks, or say what is wrong with it."""
    try:
        return _live(ask) if ask.name == "live" else TABS[ask.name](ask)
    except AfmcalcError as error:
        return refusal(error)


def _fragment(name: str, *arguments: object, **named: object) -> str:
    return str(getattr(template("parts.html", HERE).module, name)(*arguments, **named))


def _clutch(base: Base, fields: Fields) -> Answers:
    return Answers(build(base.spec(base.changed(fields))))


def _live(ask: Ask) -> dict[str, Any]:
    answers = _clutch(ask.base, ask.fields)
    torque, _ = answers.ask("torque")
    checked, findings = check_at_once(answers)
    notes = []
    if simulating(answers.clutch):
        notes.append(told("What is simulated or sampled is not judged here: see the tabs."))
    judged = verdict(Dossier(answers.clutch.spec, checked, findings, []))
    pinned = None
    if ask.pinned:
        with suppress(AfmcalcError):
            pinned = _clutch(*ask.pinned).ask("torque")[0]
    fragments = {
        "verdict": _fragment("verdict", judged, checked, ranked(findings), notes),
        "section": _figure("section", answers, 1),
        "torque": _figure("torque", answers, 2),
        "numbers": _fragment("numbers", *_numbers(torque, pinned)),
        "compare": _fragment("compare", [*_inputs(ask)]) if ask.pinned else "",
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
    others = [None] * len(ends) if pinned is None else cells(pinned)
    numbers = zip(ends, column.values, cells(column), others, strict=True)
    return NumberRow(
        column.symbol, column.name, display_unit(column.units[0] if column.units else column.unit),
        [Cell(column.path + end, value, shown, other, None) for end, value, shown, other in numbers],
    )  # fmt: skip


def _inputs(ask: Ask) -> Iterator[tuple[str, str, str, str]]:
    """Give each key whose text differs from the pinned one: path, label, both texts."""
    if ask.pinned:
        base, fields = ask.pinned
        before, now = base.texts(fields), ask.base.texts(ask.fields)
        for path, key in editable().items():
            if before.get(path, "") != now.get(path, ""):
                yield path, translate(key.description), before.get(path, ""), now.get(path, "")


def _figure(kind: str, answers: Answers, number: int, sweep: str | None = None) -> str:
    """Draw a plot; nothing where there is no curve."""
    if not plot_of(kind).applies(answers.clutch):
        return ""
    try:
        sheet = sheet_of(kind, gathered(kind, Request([answers], sweep)))
    except CalculationError:
        return ""
    svg, caption = _drawn(sheet, number)
    return _fragment("figure", sheet.title, svg, caption)


def _drawn(sheet: Sheet, number: int) -> tuple[Markup, str]:
    (panel, *_) = sheet.panels
    return drawing(panel.svg() if isinstance(panel, Drawing) else inline_svg(sheet), sheet.title, number), sheet.caption


def _analysed(*names: str) -> Callable[[Ask], dict[str, Any]]:
    """Make a tab of analyses of a clutch: their tables, plots and findings."""

    def tab(ask: Ask) -> dict[str, Any]:
        answers = _clutch(ask.base, ask.fields)
        tables: list[TextTable] = []
        figures: list[tuple[Markup, str]] = []
        findings: list[Finding] = []
        for name in names:
            result, remarks = answers.ask(name)
            tables += blocks(document(result))
            findings += remarks
            plot = ANALYSES[name].plot
            if plot and plot.applies(answers.clutch):
                with suppress(CalculationError):
                    figures.append(
                        _drawn(sheet_of(plot.name, gathered(plot.name, Request([answers]))), 3 + len(figures))
                    )
        html = _fragment("answer", tables, figures, ranked(findings), [])
        return {"html": html, "command": ask.base.command(names[0], fields=ask.fields)}

    return tab


def _explanation(ask: Ask) -> dict[str, Any]:
    spec = ask.base.spec(ask.base.changed(ask.fields))
    html = _fragment("explanation", [part for part in chapters(dossier(spec)) if part.blocks], False)
    return {"html": html, "command": ask.base.command("explain", "torque", fields=ask.fields)}


TABS: Mapping[str, Callable[[Ask], dict[str, Any]]] = {
    "accuracy": _analysed("accuracy"),
    "drive": _analysed("simulate"),
    "heat": _analysed("heat"),
    "tolerance": _analysed("tolerance"),
    "explanation": _explanation,
}
