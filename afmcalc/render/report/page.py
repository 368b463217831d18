"""From what was found of a clutch to the page of its report."""

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import date
from functools import cache
from pathlib import Path
from typing import Any, Literal, NamedTuple

from jinja2 import Environment, FileSystemLoader, StrictUndefined, Template

from ...analysis.dossier import Dossier
from ...messages import localized, named, printable, spoken, term, translate
from ...messages import told as message
from ...papers import REFERENCES
from ...spec import resolved
from ...spec.keys import keys, unit_at
from ...spec.models import TitleBlock
from ..layout import ranked
from ..plot.chart import Sheet
from ..plot.figure import inline_svg
from ..units import display, display_unit, worded
from .chapters import Chapter, chapters
from .markup import cell, css_string, drawing, mathml, symbol
from .words import FORMS, told


@dataclass(frozen=True)
class Subject:
    """What was found of a clutch, and whose report it is."""

    dossier: Dossier
    given: str
    """The spec as given, its text."""
    title: TitleBlock = TitleBlock()
    """What the title block says; without a date it has none."""
    digest: str = ""
    """SHA-256 of the file as given."""
    source: str = ""
    """Where the spec was read."""
    overrides: Sequence[str] = ()
    """``PATH=VALUE`` put over it."""
    version: str = ""


class _SpecLine(NamedTuple):
    """A key of the spec as resolved."""

    path: str
    symbol: str
    about: str
    value: str
    unit: str
    numeric: bool


class _Figure(NamedTuple):
    """A drawing of a chapter."""

    number: int
    chapter: str
    """Key of the chapter it belongs to."""
    sheet: Sheet
    svg: str


@cache
def _template() -> Template:
    """The page to be filled, in any language: nothing of it is worked out beforehand."""
    environment = Environment(
        loader=FileSystemLoader(Path(__file__).parent),
        optimized=False,
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        finalize=lambda value: printable(value, lines=True) if type(value) is str else value,
    )
    environment.filters |= {
        "symbol": symbol,
        "cell": cell,
        "mathml": mathml,
        "display": display,
        "display_unit": display_unit,
        "css": css_string,
        "translate": translate,
        "told": worded,
        "three": lambda value: localized(f"{value:.3g}"),
    }
    return environment.get_template("page.html")


def render(subject: Subject) -> str:
    """Write the page; the same subject gives the same text."""
    dossier = subject.dossier
    found = chapters(dossier)
    figures = _figures(found)
    name = named(dossier.spec.name) or told("unnamed")
    return _template().render(
        subject=subject,
        told=told,
        name=name,
        running=" · ".join(part for part in (name, subject.title.drawing, subject.title.revision) if part),
        entries=_entries(subject),
        verdict=verdict(dossier),
        keys=_keys(subject),
        chapters=found,
        figures=figures,
        sections=_sections(dossier, figures),
        symbols=_symbols(found),
        form=FORMS[spoken()],
        language=spoken(),
        findings=ranked(dossier.findings),
        references=_references(found),
    )


class Verdict(NamedTuple):
    """What became of a clutch."""

    grade: Literal["pass", "warning", "fail"]
    sentence: str
    limit: str
    """What limits the clutch first; empty where nothing does."""


def verdict(dossier: Dossier) -> Verdict:
    """Sum up requirements and checks."""
    required, checked = _required(dossier), _checked(dossier)
    sentence, limit = told(f"verdict/{required}/{checked}"), _limit(dossier)
    if required == "missed" or checked == "failed":
        return Verdict("fail", sentence, limit)
    return Verdict("pass" if required in ("none", "met") and checked == "passed" else "warning", sentence, limit)


def _required(dossier: Dossier) -> Literal["none", "met", "open", "missed"]:
    passed = [row.passed for row in dossier.requirements]
    if False in passed:
        return "missed"
    return "none" if not passed else "open" if None in passed else "met"


def _checked(dossier: Dossier) -> Literal["passed", "warned", "exceeded", "failed"]:
    """What became of everything but the requirements."""
    levels = {each.level for each in dossier.findings if not each.code.startswith("requirement-")}
    if "error" in levels:
        return "failed"
    if any(each.verdict != "pass" for each in dossier.limits):
        return "exceeded"
    return "warned" if "warning" in levels else "passed"


def _limit(dossier: Dossier) -> str:
    """Name the limit of which the clutch uses most."""
    most = max(dossier.limits, key=lambda each: each.utilisation, default=None)
    if most is None:
        return ""
    key = "limited" if most.verdict == "pass" else "limited/exceeded"
    return told(key, name=worded(most.name), symbol=most.symbol, utilisation=most.utilisation)


def _entries(subject: Subject) -> list[tuple[str, str]]:
    """Title block: what is given of it, and what every report has."""
    title, spec = subject.title, subject.dossier.spec
    program = f"afmcalc {subject.version}"
    own = {"variant": translate(spec.variant, "value"), "program": program}
    own |= {name: getattr(title, name) for name in TitleBlock.model_fields} | {"date": _dated(title.date)}
    form = FORMS[spoken()]
    return [(name, own[name]) for name in form.entries if own[name] or name in form.signed]


def _dated(given: str | None) -> str | None:
    """A date of ISO 8601 as the language writes it; any other as it is."""
    try:
        return date.fromisoformat(given or "").strftime(translate("%Y-%m-%d", "date"))
    except ValueError:
        return given


def _sections(dossier: Dossier, figures: list["_Figure"]) -> list[str]:
    """Sections of the report, in their order."""
    form = FORMS[spoken()]
    empty = {"requirements": not dossier.requirements, "plots": not figures}
    return [name for name in form.sections if name in form.always or not empty.get(name)]


def _symbols(found: list[Chapter]) -> list[tuple[str, str]]:
    """Symbols of the formulas, each with what it stands for where it is first told."""
    told: dict[str, str] = {}
    for block in (block for chapter in found for block in chapter.blocks):
        for each in block.where:
            if each.text:
                told.setdefault(each.symbol, each.text)
        # the heading of its step begins with a capital
        first = block.name[:1].lower() if block.name[1:2].islower() else block.name[:1]
        told.setdefault(block.symbol, first + block.name[1:])
    return sorted(told.items(), key=lambda item: item[0].casefold())


def _keys(subject: Subject) -> list[_SpecLine]:
    known = keys()
    found: list[_SpecLine] = []
    for path, value in _flat(resolved(subject.dossier.spec), ""):
        if isinstance(value, dict):
            found += [_scatter(path, name, each) for name, each in value.items()]
            continue
        key = known[path]
        shown = list(value) if isinstance(value, tuple) else str(value) if key.unit is None else value
        if path == "name" or path.startswith("report."):  # what a user writes is not translated
            shown = term(str(value), "name")
        found.append(
            _SpecLine(
                path,
                key.symbol or "",
                translate(key.description),
                display(shown, key.unit or ""),
                display_unit(key.unit or ""),
                key.unit is not None,
            )
        )
    return found


def _scatter(path: str, name: str, given: dict[str, Any]) -> _SpecLine:
    """Show a distribution of [tolerance.fields]: its kind, then its numbers in the unit of what scatters."""
    unit = unit_at(name) or ""
    given_as = {part: value for part, value in given.items() if part != "distribution"}
    numbers = [f"{translate(part, 'value')} {display(value, unit)}" for part, value in given_as.items()]
    # a spread in percent has no other unit
    shown_unit = "" if all(isinstance(value, str) for value in given_as.values()) else display_unit(unit)
    key = keys().get(name)
    about = (
        message("scatter: {about}", about=translate(key.description).partition(";")[0])
        if key
        else translate("scatter of the friction in service")
    )
    value = (", " if spoken() == "en" else "; ").join([worded(given["distribution"]), *numbers])
    return _SpecLine(f'{path}."{name}"', key.symbol or "" if key else "f", about, value, shown_unit, False)


def _flat(data: dict[str, Any], prefix: str) -> list[tuple[str, Any]]:
    """Value keys with their values; a key that holds a table of the user's own keys keeps it."""
    found: list[tuple[str, Any]] = []
    for name, value in data.items():
        path = prefix + name
        deeper = isinstance(value, dict) and path not in keys()
        found += _flat(value, f"{path}.") if deeper else [(path, value)]
    return found


def _figures(found: list[Chapter]) -> list[_Figure]:
    """The drawings of all chapters, numbered through."""
    sheets = [(chapter.key, sheet) for chapter in found for sheet in chapter.sheets]
    return [
        _Figure(number, key, sheet, drawing(inline_svg(sheet), sheet.title, number))
        for number, (key, sheet) in enumerate(sheets, 1)
    ]


def _references(found: list[Chapter]) -> list[tuple[str, str]]:
    cited = {source for chapter in found for source in chapter.sources}
    return [(key, text) for key, text in REFERENCES.items() if key in cited]
