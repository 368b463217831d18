"""Answers to the page: fragments of HTML, from the same analyses that the commands run."""

from base64 import b64encode
from collections import namedtuple
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from functools import lru_cache
from json import dumps, loads
from typing import Any

from markupsafe import Markup

from ..analysis.asking import Answers
from ..analysis.check import check, check_at_once, simulating
from ..analysis.compare import change
from ..analysis.design import shown
from ..analysis.dossier import dossier
from ..analysis.plot_data import ParetoFigure, Request, gathered
from ..analysis.registry import ANALYSES
from ..analysis.sweep import parse_axis
from ..engines import build
from ..errors import AfmcalcError, CalculationError, SpecError
from ..messages import localized, native, say
from ..render.amounts import display_unit
from ..render.document import Column, document
from ..render.plot import sheet_of
from ..render.plot.chart import Chart, Line, Sheet
from ..render.plot.figure import inline_svg
from ..render.report import Subject, render
from ..render.report.html import drawing
from ..render.text_tables import TextTable, blocks, cells, ranked
from ..result import Result
from ..spec import make_spec, resolved, to_toml
from ..spec.edit import candidate
from ..spec.parse import Source, parse
from .aids import FILES, formulas, held, mendings, now, sketch
from .entered import unit_shown
from .form import Base, State, editable, key_at, refused
from .fragments import curve, template
from .strip import tiles, values

Job = Mapping[str, Any]
"""Request: its ``name``, the state ``pinned`` or None, ``options`` of a tab, number of the ``first`` new base."""
Answer = dict[str, Any]


def answer(state: State, job: Job) -> Answer:
    """Answer to a job, or the sentences of its error."""
    try:
        return _ANSWERS[job["name"]](state, job)
    except AfmcalcError as error:
        return refused(error)


def fragment(name: str, *arguments: object) -> str:
    """HTML of a macro of ``parts.html``."""
    return str(getattr(template("parts.html").module, name)(*arguments))


def _live(state: State, job: Job) -> Answer:
    """Answer after a change: verdict of the quick checks, drawing, torque, numbers beside those of the pinned state."""
    options, pinned, entries = job["options"], job["pinned"], dict[str, str]()
    if options.get("as", "").strip():
        try:
            state, entries = held(state, options)
        except SpecError:
            raise
        except AfmcalcError as error:
            return refused(error, "hold-as")
    answers = Answers(build(state.spec))
    checked, findings = check_at_once(answers)
    without = simulating(answers.clutch)
    before, inputs, curves = None, [], list[Line]()
    if pinned:
        old, new = pinned.texts, state.texts
        texts = ((key, old.get(path, ""), new.get(path, ""), unit_shown(key)) for path, key in editable().items())
        inputs = [row for row in texts if row[1] != row[2]]
        with suppress(AfmcalcError):
            then = Answers(build(pinned.spec))
            before = then.ask("torque")[0]
            curves = sheet_of("torque", gathered("torque", Request([then]))).panels[0].lines
    fragments = {
        "strip": fragment("strip", [*tiles(answers, checked, without, _pinned(dumps(pinned), quick=True))]),
        "verdict": fragment("verdict", checked, ranked(findings), bool(without)),
        "section": _figure("section", answers, 1),
        "torque": _figure("torque", answers, 2, curves),
        "numbers": fragment("numbers", *_numbers(answers.ask("torque")[0], before)),
        "compare": fragment("compare", inputs) if pinned else "",
    }
    more = {"command": state.command("torque"), "judging": bool(without), "entries": state.calculated | entries}
    if "hold" in options and not entries:
        more["as"] = now(answers.clutch, options["hold"])
    return {"fragments": fragments} | more


def _check(state: State, job: Job) -> Answer:
    """Answer with the verdict of all checks, simulations included."""
    answers = Answers(build(state.spec))
    checked, findings = check(answers.clutch, answers=answers)
    strip = fragment("strip", [*tiles(answers, checked, (), _pinned(dumps(job["pinned"]), quick=False))])
    html = fragment("verdict", checked, ranked(findings), False)
    return {"html": html, "strip": strip, "command": state.command("check")}


@lru_cache(maxsize=4)
def _pinned(state: str, *, quick: bool) -> dict[str, list[Any]]:
    """Numbers of the strip for a pinned state in JSON; empty without a pinned state, or if the state is no clutch."""
    pinned = loads(state)
    with suppress(AfmcalcError):
        answers = pinned and Answers(build(State(Base(*pinned[0]), pinned[1]).spec))
        return values(answers, simulating(answers.clutch) if quick else ()) if answers else {}
    return {}


def _help(state: State, job: Job) -> Answer:
    """Answer with the formulas for a key, or with the drawing that shows the dimension of the key."""
    key = key_at(path := job["options"].get("key", ""))
    steps, drawn = formulas(state.spec, path), ""
    if (name := sketch(path)) and not steps:
        drawn = _figure(name, Answers(build(state.spec)), 100 + list(editable()).index(path))
    return {"html": fragment("help", key, steps, drawn)}


def _mend(state: State, job: Job) -> Answer:
    """Answer with the keys that clear a finding."""
    code, path = (job["options"].get(name, "") for name in ("code", "path"))
    return {"html": fragment("mend", [*mendings(state.spec, code, path)])}


def _file(state: State, job: Job) -> Answer:
    return {"file": b64encode(FILES[job["name"]](state)).decode()}


Cell = namedtuple("Cell", "path value shown pinned change")
Quantity = namedtuple("Quantity", "symbol name unit cells")


def _numbers(result: Result, pinned: Result | None) -> tuple[list[Quantity], list[Quantity]]:
    """Rows of single values and rows of triples of a result, beside the values of the pinned state."""
    now, then = document(result), document(pinned) if pinned else None
    before = {column.path: column for column in (*then.singles, *then.triples)} if then else {}

    def row(column: Column, ends: Sequence[str]) -> Quantity:
        other, none = before.get(column.path), [None] * len(ends)
        texts, shares = (cells(other), map(change, column.values, other.values)) if other else (none, none)
        each = [
            Cell(column.path + end, value, text, old, share and localized(f"{share:+.1%}"))
            for end, value, text, old, share in zip(ends, column.values, cells(column), texts, shares, strict=True)
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
    """Sheet as HTML, and its caption; ``number`` must differ from the numbers of other drawings on the page."""
    if isinstance(sheet.panels[0], Chart):
        charts = (fragment("curve", sheet.title, curve(chart, pinned)) for chart in sheet.panels)
        return Markup("").join(map(Markup, charts)), sheet.below
    return Markup(drawing(inline_svg(sheet.panels[0]), native(sheet.title), number)), sheet.below


def _analysed(state: State, job: Job) -> Answer:
    """Answer with the tables, plots and findings of an analysis; the analysis of accuracy can have a sweep."""
    name, sweep = "simulate" if job["name"] == "drive" else job["name"], job["options"].get("sweep", "").strip()
    answers, figures = Answers(build(state.spec)), list[tuple[Markup, str]]()
    try:
        axes = [parse_axis(sweep, answers.clutch.spec)] if sweep else []
        result, findings = ANALYSES[name].function(answers.clutch, axes) if sweep else answers.ask(name)
    except AfmcalcError as error:
        return refused(error, "sweep" if sweep else "")
    plot = ANALYSES[name].plot
    if plot and plot.applies(answers.clutch):
        with suppress(CalculationError):  # there is nothing to plot
            sheet = sheet_of(plot.name, gathered(plot.name, Request([answers], sweep or None)))
            figures.append(_drawn(sheet, 2 + list(_ANSWERS).index(job["name"])))  # section and torque are first
    html = fragment("answer", blocks(document(result)), figures, ranked(findings), [])
    return {"html": html, "command": state.command(name, *(["--sweep", sweep] if sweep else []))}


def _report(state: State, job: Job) -> Answer:
    """Answer with the report."""
    page = render(Subject(dossier(state.spec), state.overrides))
    return {"html": fragment("report", page), "command": state.command("report", "--output", "report.html")}


def _design(state: State, job: Job) -> Answer:
    """Answer with the front of a search around a clutch; each clutch shown becomes a base of the page."""
    source = Source(say("search"), job["options"].get("requirements", ""))
    try:
        given = parse(source)
        if others := given.keys() - {"objectives", "requirements", "search"}:
            raise AfmcalcError("{name}: only objectives, requirements and search stand here", name=min(others))
        spec = make_spec(resolved(state.spec) | given, source)
        result, findings = ANALYSES["design"].function(spec)
    except AfmcalcError as error:
        return refused(error, "requirements")
    front = shown(result)
    bases = [
        Base(say("number {pick} of the front", pick=row.number), to_toml(resolved(candidate(spec, row.changes))), "-")
        for row in front.front
    ]
    numbers = [job["first"] + number for number in range(len(bases))]
    tables, none = blocks(document(front)), TextTable("", [], [], [])
    table = next((each for each in tables if each.source and each.source.path == "front"), none)
    notes = [*table.notes]
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
    "report": _report,
    "help": _help,
    "mend": _mend,
    **dict.fromkeys(FILES, _file),
}
