"""The tabs of a page: what takes longer than a change may."""

import json
import time
from collections.abc import Callable, Mapping
from contextlib import suppress
from typing import Any

from markupsafe import Markup

from .. import __version__
from ..analysis.answers import Answers
from ..analysis.design.design import shown
from ..analysis.design.pick import with_picked
from ..analysis.dossier import dossier
from ..analysis.figures import ParetoFigure, Request, gathered
from ..analysis.registry import ANALYSES
from ..analysis.sweep.axes import parse_axis
from ..errors import AfmcalcError, CalculationError
from ..findings import Finding
from ..messages import say, spoken, told, translate
from ..progress import tell
from ..render.document import document
from ..render.layout import TextTable, blocks, ranked
from ..render.plot import sheet_of
from ..render.report import Subject, render
from ..render.report.chapters import chapters
from ..render.report.title import text_as_given, title_block
from ..render.report.words import FORMS
from ..spec import Spec, resolved, to_toml
from ..spec.make import validated
from ..spec.parse import parse
from ..spec.read import data_of
from ..spec.requirements import Requirements
from ..spec.source import Source
from .base import Base, refusal
from .live import Ask, asked, drawn, fragment, live

_MOST = 20
"""Clutches of a front that are shown, each to be loaded."""
_ROUNDING = 90.0
"""Seconds of a search after which no more of them are rounded: the answer has to come in time."""


def answer(ask: Ask) -> dict[str, Any]:
    """Answer what a page asks, or say what is wrong with it."""
    try:
        return TABS[ask.name](ask)
    except AfmcalcError as error:
        return refusal(error)


def _analysed(name: str) -> Callable[[Ask], dict[str, Any]]:
    """Make a tab of an analysis of a clutch: its tables, plot and findings."""

    def tab(ask: Ask) -> dict[str, Any]:
        answers = asked(ask.base, ask.fields)
        result, findings = answers.ask(name)
        return _laid_out(name, answers, blocks(document(result)), findings, ask)

    return tab


def _accuracy(ask: Ask) -> dict[str, Any]:
    answers, sweep = asked(ask.base, ask.fields), ask.options.get("sweep", "").strip()
    try:
        axes = [parse_axis(sweep, answers.clutch.spec)] if sweep else []
        result, findings = ANALYSES["accuracy"].function(answers.clutch, axes)
    except AfmcalcError as error:
        return refusal(error, "sweep")
    return _laid_out("accuracy", answers, blocks(document(result)), findings, ask, sweep)


def _laid_out(
    name: str, answers: Answers, tables: list[TextTable], findings: list[Finding], ask: Ask, sweep: str = ""
) -> dict[str, Any]:
    plot, figures = ANALYSES[name].plot, list[tuple[Markup, str]]()
    if plot and plot.applies(answers.clutch):
        with suppress(CalculationError):  # no curve
            figures.append(
                drawn(sheet_of(plot.name, gathered(plot.name, Request([answers], sweep or None))), _number(name))
            )
    options = ["--sweep", sweep] if sweep else []
    return {
        "html": fragment("answer", tables, figures, ranked(findings), []),
        "command": ask.base.command(name, fields=ask.fields, options=options),
    }


def _number(name: str) -> int:
    """Number of the drawing of an analysis: that of no other on the page, where section and torque curve are first."""
    return 3 + list(ANALYSES).index(name)


def _explanation(ask: Ask) -> dict[str, Any]:
    told_of = [chapter for chapter in chapters(dossier(_spec(ask))) if chapter.blocks]
    lined = FORMS.get(spoken(), FORMS["en"]).lined
    return {"html": fragment("explanation", told_of, lined), "command": _report_command(ask)}


def _report(ask: Ask) -> dict[str, Any]:
    spec, source = _spec(ask), ask.base.source
    overrides = [*ask.base.overrides, *ask.base.changed(ask.fields)]
    title, given = title_block(spec, {}), text_as_given(source)
    page = render(Subject(dossier(spec), given, title, ask.base.digest, spec.label, overrides, __version__))
    return {"html": fragment("report", page), "command": _report_command(ask)}


def _report_command(ask: Ask) -> str:
    return ask.base.command("report", fields=ask.fields, options=["--output", "report.html"])


def _spec(ask: Ask) -> Spec:
    return ask.base.spec(ask.base.changed(ask.fields))


def _design(ask: Ask) -> dict[str, Any]:
    """Search a front, and round each clutch of it that is shown, as ``--pick`` does: a base to go on from."""
    text, overrides, began = ask.options.get("requirements", ""), _catalogues(ask), time.monotonic()
    try:
        need = _requirements(text, overrides)
        result, findings = ANALYSES["design"].function(need)
    except AfmcalcError as error:
        return refusal(error, "requirements")
    front = shown(result, None, _MOST)
    bases: list[Base] = []
    numbers: list[int | None] = []
    for at, row in enumerate(front.front):
        tell(say("rounding"), at, len(front.front))
        if time.monotonic() - began > _ROUNDING:
            numbers.append(None)
            continue
        try:
            spec = with_picked(need, result, row.number)[1]
        except CalculationError:
            numbers.append(None)
            continue
        numbers.append(ask.first + len(bases))
        called = told("number {pick} of the front", pick=row.number)
        about = translate(say("Number {pick} of the front of afmcalc design.", pick=row.number))
        bases.append(Base(called, to_toml(resolved(spec), about), "-"))
    tables = blocks(document(front))
    table = next((each for each in tables if each.source and each.source.path == "front"), TextTable("", [], [], []))
    notes = [table.legend] if table.legend else []
    if result.on_front > len(front.front):
        notes.append(told("{top} of {count} shown; --top {count} shows all", top=_MOST, count=result.on_front))
    figures = []
    if len({*need.objectives}) > 1 and result.front:
        figures.append(drawn(sheet_of("pareto", ParetoFigure(need.name, result)), _number("design")))
    rest = fragment("answer", [each for each in tables if each is not table], [], [], [])
    command = Base("", text, "-", tuple(overrides)).command("design", fields={}, options=["--top", str(_MOST)])
    html = fragment("front", table, numbers, figures, ranked(findings), notes) + rest
    return {"html": html, "command": command, "bases": bases}


def _requirements(text: str, overrides: list[str]) -> Requirements:
    """Read requirements that somebody typed; lists of one's own are those of the clutch."""
    source = Source(told("requirements"), text)
    if "catalogues" in parse(source):
        raise AfmcalcError("catalogues: no file is named here; the lists are those of the clutch")
    return validated(Requirements, *data_of(source, overrides, Requirements))


def _catalogues(ask: Ask) -> list[str]:
    lists = _spec(ask).catalogues
    named = {} if lists is None else lists.model_dump(exclude_none=True)
    return [f"catalogues.{name}={json.dumps(file, ensure_ascii=False)}" for name, file in named.items()]


TABS: Mapping[str, Callable[[Ask], dict[str, Any]]] = {
    "live": live,
    "accuracy": _accuracy,
    "drive": _analysed("simulate"),
    "heat": _analysed("heat"),
    "tolerance": _analysed("tolerance"),
    "design": _design,
    "explanation": _explanation,
    "report": _report,
}
