"""From what was calculated of a clutch to the page of its report."""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from datetime import date
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from jinja2 import Environment, FileSystemLoader, StrictUndefined, Template
from markupsafe import Markup

from ...analysis.dossier import Dossier
from ...messages import localized, named, printable, spoken, term, translate
from ...messages import told as message
from ...papers.register import references
from ...spec import resolved
from ...spec.keys import keys, scatter_at
from ...spec.models import TitleBlock
from ..layout import ranked
from ..plot import sheet_of
from ..plot.chart import Sheet
from ..plot.figure import inline_svg
from ..units import display, display_unit, worded
from ..verdict import verdict
from .chapters import Chapter, chapters
from .markup import cell, css_string, drawing, symbol
from .words import FORMS, Form, told


@dataclass(frozen=True)
class Subject:
    """What was calculated of a clutch, and whose report it is."""

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


@cache
def template(name: str, folder: Path | None = None) -> Template:
    """A page to be filled, in any language: nothing of it is worked out beforehand.

    One of another folder may take in those that stand here.
    """
    here = Path(__file__).parent
    environment = Environment(
        loader=FileSystemLoader([folder or here, here]),
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
        "display": display,
        "display_unit": display_unit,
        "css": css_string,
        "term": term,
        "translate": translate,
        "worded": worded,
        "three": lambda value: localized(f"{value:.3g}"),
    }
    environment.globals.update(told=told, _=message)
    return environment.get_template(name)


def render(subject: Subject) -> str:
    """Write the page; the same subject gives the same text."""
    dossier, form = subject.dossier, FORMS.get(spoken(), FORMS["en"])
    parts = chapters(dossier)
    sheets = [] if dossier.section is None else [("spec", sheet_of("section", dossier.section))]
    sheets += [(chapter.topic.name, sheet) for chapter in parts for sheet in chapter.sheets]
    figures = [
        {"number": number, "chapter": key, "sheet": sheet, "svg": _panels(sheet, number)}
        for number, (key, sheet) in enumerate(sheets, 1)
    ]
    name = named(dossier.spec.name) or message("Adaptive friction clutch")
    empty = {"requirements": not dossier.check.requirements}
    cited = {source for chapter in parts for source in chapter.topic.sources}
    return template("page.html").render(
        subject=subject,
        name=name,
        running=" · ".join(part for part in (name, subject.title.drawing, subject.title.revision) if part),
        entries=_entries(subject, form),
        verdict=verdict(dossier.check, dossier.findings),
        keys=list(_spec_lines(resolved(dossier.spec))),
        chapters=parts,
        figures=figures,
        sections=[name for name in form.sections if name in form.always or not empty.get(name)],
        symbols=_symbols(parts),
        form=form,
        language=spoken(),
        findings=ranked(dossier.findings),
        references=[(key, text) for key, text in references().items() if key in cited],
    )


def _panels(sheet: Sheet, number: int) -> Markup:
    """Draw each panel by itself: between them a page may end."""
    drawn = [inline_svg(Sheet("", [panel])) for panel in sheet.panels]
    return Markup("\n").join(drawing(svg, sheet.title, f"{number}-{place}") for place, svg in enumerate(drawn, 1))


def _entries(subject: Subject, form: Form) -> list[tuple[str, str]]:
    """Title block: what is given of it, and what every report has; a date of ISO 8601 as the language writes it."""
    title = dict(subject.title) | {
        "variant": translate(subject.dossier.spec.variant, "value"),
        "program": f"afmcalc {subject.version}",
    }
    with suppress(ValueError):
        title["date"] = date.fromisoformat(title["date"] or "").strftime(translate("%Y-%m-%d", "date"))
    return [(name, title[name]) for name in form.entries if title[name] or name in form.signed]


def _symbols(parts: list[Chapter]) -> list[tuple[str, str]]:
    """Symbols of the formulas, each with what it stands for where it is first told."""
    meanings: dict[str, str] = {}
    for step in (block.step for chapter in parts for block in chapter.blocks):
        for part in step.where:
            if part.text:
                meanings.setdefault(part.symbol, part.text)
        # the heading of its step begins with a capital
        name = translate(step.name)
        first = name[:1].lower() if name[1:2].islower() else name[:1]
        meanings.setdefault(step.symbol, first + name[1:])
    return sorted(meanings.items(), key=lambda item: item[0].casefold())


def _spec_lines(data: dict[str, Any], prefix: str = "") -> Iterator[_SpecLine]:
    """Every key of a spec that has a value."""
    for name, value in data.items():
        path = prefix + name
        key = keys().get(path)
        if key is None:
            yield from _spec_lines(value, f"{path}.")
        elif isinstance(value, dict):
            yield from (_scatter(path, field, given) for field, given in value.items())
        else:
            shown = list(value) if isinstance(value, tuple) else str(value) if key.unit is None else value
            if path == "name" or path.startswith("report."):  # what a user writes is not translated
                shown = term(str(value), "name")
            unit, numeric = key.unit or "", key.unit is not None
            about = translate(key.description)
            yield _SpecLine(path, key.symbol or "", about, display(shown, unit), display_unit(unit), numeric)


def _scatter(path: str, name: str, given: dict[str, Any]) -> _SpecLine:
    """Show a distribution of [tolerance.fields]: its kind, then its numbers in the unit of what scatters."""
    quantity, key = scatter_at(name), keys().get(name)
    unit = quantity.unit if quantity else ""
    parts = {part: value for part, value in given.items() if part != "distribution"}
    numbers = [f"{translate(part, 'value')} {display(value, unit)}" for part, value in parts.items()]
    # a spread in percent has no other unit
    shown_unit = "" if all(isinstance(value, str) for value in parts.values()) else display_unit(unit)
    symbol, about = "f", translate("scatter of the friction in service")
    if key:
        symbol = key.symbol or ""
        about = message("scatter: {about}", about=translate(key.description).partition(";")[0])
    value = (", " if spoken() == "en" else "; ").join([worded(given["distribution"]), *numbers])
    return _SpecLine(f'{path}."{name}"', symbol, about, value, shown_unit, False)
