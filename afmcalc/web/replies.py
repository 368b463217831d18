"""Answers to the page: fragments of HTML, from the functions that the commands ask."""

from collections import namedtuple
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from typing import Any

from markupsafe import Markup
from tomli_w import dumps

from .. import __version__
from ..analysis.asking import Answers
from ..analysis.check import check, check_at_once, simulating
from ..analysis.compare import change
from ..analysis.design import shown
from ..analysis.design_grid import candidate
from ..analysis.dossier import dossier
from ..analysis.plot_data import ParetoFigure, Request, gathered
from ..analysis.registry import ANALYSES
from ..analysis.sweep import parse_axis
from ..engines import build
from ..errors import AfmcalcError, CalculationError
from ..messages import localized, native, say, translate
from ..render.amounts import display_unit
from ..render.document import Column, document
from ..render.plot import sheet_of
from ..render.plot.chart import Chart, Line, Sheet
from ..render.plot.figure import inline_svg
from ..render.report import Subject, render
from ..render.report.chapters import chapters
from ..render.report.html import drawing
from ..render.report.title import text_as_given, title_block
from ..render.text_tables import TextTable, blocks, cells, ranked
from ..result import Result
from ..spec import Spec, make_spec, resolved, to_toml
from ..spec.parse import Source, parse
from ..spec.write import written
from .curve import curve
from .filled import template
from .form import Base, State, editable, refusal

Job = Mapping[str, Any]
"""Question: its ``name``, the state ``pinned``, ``options`` of a tab, number of the ``first`` base to make."""
Answer = dict[str, Any]
_OBJECTIVES = ["closing_force", "accuracy_factor"]


def answer(state: State, job: Job) -> Answer:
    """Answer what a page asks, or say what is wrong with it."""
    try:
        return _ANSWERS[job["name"]](state, job)
    except AfmcalcError as error:
        return refusal(error)


def fragment(name: str, *arguments: object) -> str:
    """Fill a macro of the page."""
    return str(getattr(template("parts.html").module, name)(*arguments))


def _live(state: State, job: Job) -> Answer:
    """Show a clutch after each change, judged at once but for its event; its numbers beside those of the pinned one."""
    answers, pinned = Answers(build(state.spec)), job["pinned"]
    checked, findings = check_at_once(answers)
    judging = bool(simulating(answers.clutch))
    before, inputs, curves = None, [], list[Line]()
    if pinned:
        old, new = pinned.texts, state.texts
        inputs = [
            (path, translate(key.description), old.get(path, ""), new.get(path, "")) for path, key in editable().items()
        ]
        with suppress(AfmcalcError):
            then = Answers(build(pinned.spec))
            before = then.ask("torque")[0]
            curves = sheet_of("torque", gathered("torque", Request([then]))).panels[0].lines
    fragments = {
        "verdict": fragment("verdict", checked, ranked(findings), judging),
        "section": _figure("section", answers, 1),
        "torque": _figure("torque", answers, 2, curves),
        "numbers": fragment("numbers", *_numbers(answers.ask("torque")[0], before)),
        "compare": fragment("compare", [each for each in inputs if each[2] != each[3]]) if pinned else "",
    }
    return {"fragments": fragments, "command": state.command("torque"), "judging": judging}


def _check(state: State, job: Job) -> Answer:
    """Judge a clutch by all that the command asks."""
    checked, findings = check(build(state.spec))
    return {"html": fragment("verdict", checked, ranked(findings), False), "command": state.command("check")}


Cell = namedtuple("Cell", "path value shown pinned change")
Quantity = namedtuple("Quantity", "symbol name unit cells")


def _numbers(result: Result, pinned: Result | None) -> tuple[list[Quantity], list[Quantity]]:
    """Lay out single values and triples of a result, beside those of a pinned one."""
    now, then = document(result), document(pinned) if pinned else None
    before = {column.path: column for column in (*then.singles, *then.triples)} if then else {}

    def row(column: Column, ends: Sequence[str]) -> Quantity:
        other, none = before.get(column.path), [None] * len(ends)
        values, texts = (other.values, cells(other)) if other else (none, none)
        each = [
            Cell(column.path + end, value, text, old, share and localized(f"{share:+.1%}"))
            for end, value, text, old, was in zip(ends, column.values, cells(column), texts, values, strict=True)
            for share in [change(value, was) or None]
        ]
        return Quantity(column.symbol, column.name, display_unit((column.units or [column.unit])[0]), each)

    singles = [row(column, [""]) for column in now.singles if not column.hidden]
    return singles, [row(column, [".min", ".mean", ".max"]) for column in now.triples if not column.hidden]


def _figure(name: str, answers: Answers, number: int, pinned: Sequence[Line] = ()) -> str:
    try:
        sheet = sheet_of(name, gathered(name, Request([answers])))
    except CalculationError as error:
        return fragment("answer", [], [], [], [str(error)])
    return fragment("figure", sheet.title, *_drawn(sheet, number, pinned))


def _drawn(sheet: Sheet, number: int, pinned: Sequence[Line] = ()) -> tuple[Markup, str]:
    """Return a sheet as part of a page, with its caption; ``number`` is that of no other drawing of the page."""
    if isinstance(sheet.panels[0], Chart):
        charts = (fragment("curve", sheet.title, curve(chart, pinned)) for chart in sheet.panels)
        return Markup("").join(map(Markup, charts)), sheet.below
    return Markup(drawing(inline_svg(sheet.panels[0]), native(sheet.title), number)), sheet.below  # noqa: S704


def _analysed(state: State, job: Job) -> Answer:
    """Ask an analysis of a clutch, the accuracy also over a sweep: tables, plot and findings."""
    name, sweep = "simulate" if job["name"] == "drive" else job["name"], job["options"].get("sweep", "").strip()
    answers, figures = Answers(build(state.spec)), list[tuple[Markup, str]]()
    try:
        axes = [parse_axis(sweep, answers.clutch.spec)] if sweep else []
        result, findings = ANALYSES[name].function(answers.clutch, axes) if sweep else answers.ask(name)
    except AfmcalcError as error:
        return refusal(error, "sweep" if sweep else "")
    plot = ANALYSES[name].plot
    if plot and plot.applies(answers.clutch):
        with suppress(CalculationError):  # no curve
            sheet = sheet_of(plot.name, gathered(plot.name, Request([answers], sweep or None)))
            figures.append(_drawn(sheet, 2 + list(_ANSWERS).index(job["name"])))  # section and torque are first
    html = fragment("answer", blocks(document(result)), figures, ranked(findings), [])
    return {"html": html, "command": state.command(name, *(["--sweep", sweep] if sweep else []))}


def _report(state: State, job: Job) -> Answer:
    """Return the whole report, or of it how everything was calculated."""
    base, spec = state.base, state.spec
    told_of = dossier(spec)
    if job["name"] == "report":
        given, title = text_as_given(base.source), title_block(spec, {})
        page = render(Subject(told_of, given, title, base.digest, spec.label, state.overrides, __version__))
        html = fragment("report", page)
    else:
        html = fragment("explanation", [chapter for chapter in chapters(told_of) if chapter.steps])
    return {"html": html, "command": state.command("report", "--output", "report.html")}


def search_of(spec: Spec) -> str:
    """Return objectives, requirements and search of a spec as text; without a search one around the clutch."""
    pairs, least = spec.friction_group.pairs, spec.least_pairs
    search: dict[str, Any] = {
        "friction_group.pairs": [pairs + more for more in (-2, 0, 2, 4) if pairs + more >= least],
        "adjustment.nominal_torque": [float(build(spec).nominal_torque)],
    }
    if spec.control_unit is not None and (gain := spec.control_unit.gain):
        search["control_unit.gain"] = [float(f"{share * gain:.3g}") for share in (0.5, 0.75, 1.0, 1.25, 1.5)]
    data = resolved(spec)
    told = {"objectives": spec.objectives or _OBJECTIVES, "requirements": data.get("requirements")}
    told["search"] = data.get("search") or search
    return dumps(written({name: value for name, value in told.items() if value}))


def _design(state: State, job: Job) -> Answer:
    """Search around a clutch; each clutch of the front that is shown is a base to go on from."""
    source = Source(say("search"), job["options"].get("requirements", ""))
    try:
        given = parse(source)
        if others := given.keys() - {"objectives", "requirements", "search"}:
            raise AfmcalcError("{name}: only objectives, requirements and search stand here", name=min(others))
        spec = make_spec(resolved(state.spec) | given, source)
        result, findings = ANALYSES["design"].function(spec)
    except AfmcalcError as error:
        return refusal(error, "requirements")
    front = shown(result)
    bases = [
        Base(say("number {pick} of the front", pick=row.number), to_toml(resolved(candidate(spec, row.changes))), "-")
        for row in front.front
    ]
    numbers = [job["first"] + number for number in range(len(bases))]
    tables, none = blocks(document(front)), TextTable("", [], [], [])
    table = next((each for each in tables if each.source and each.source.path == "front"), none)
    notes = [line for line in (table.legend, table.meanings) if line]
    if more := len(result.front) - len(front.front):
        notes.append(say("the front has {count} more: --all shows them", count=more))
    number = 2 + list(_ANSWERS).index("design")
    drawn = len({*result.objectives}) > 1 and result.front
    figures = [_drawn(sheet_of("pareto", ParetoFigure(spec.name, result)), number)] if drawn else []
    html = fragment("front", table, numbers, figures, ranked(findings), notes)
    html += fragment("answer", [each for each in tables if each is not table], [], [], [])
    return {"html": html, "command": state.command("design"), "bases": bases}


_ANSWERS: Mapping[str, Callable[[State, Job], Answer]] = {
    "live": _live,
    "check": _check,
    **dict.fromkeys(("accuracy", "drive", "heat", "tolerance"), _analysed),
    "design": _design,
    **dict.fromkeys(("explanation", "report"), _report),
}
