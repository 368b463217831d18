"""From what was calculated of a clutch to the page of its report."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from datetime import date
from functools import cache
from itertools import chain, count, islice
from pathlib import Path
from typing import Any, NamedTuple

from jinja2 import Environment, FileSystemLoader, StrictUndefined, Template
from markupsafe import Markup

from ...analysis.dossier import Dossier
from ...analysis.explain.explain import Meaning
from ...findings import Finding
from ...messages import localized, named, percent, printable, spoken, term, translate
from ...messages import told as message
from ...papers.register import Misprint, misprints, references
from ...spec import Spec, resolved
from ...spec.keys import keys, path_of, scatter_at
from ...spec.models import TitleBlock
from ..layout import ranked
from ..plot import sheet_of
from ..plot.chart import Sheet
from ..plot.figure import inline_svg
from ..symbols import latin_symbols, native
from ..units import display, display_unit, worded
from .chapters import Chapter, chapters, explained, peaks
from .frame import frame
from .markup import MISPRINT, cell, cited, css_string, drawing, marks, name_of, symbol
from .words import FORMS, SHORT, Form, told


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
    with_source: bool = False
    """Whether the text as given is an appendix."""
    short: bool = False
    """Whether it is to be two pages: task, limits, section, peaks, heat, conclusions."""
    symbols: str = ""
    """``latin`` or ``papers``: letters of the indices; by default Latin in English."""


class _SpecLine(NamedTuple):
    """A key of the spec as resolved."""

    group: str
    path: str
    symbol: str
    about: str
    value: str
    unit: str
    numeric: bool
    overridden: bool = False


class _Figure(NamedTuple):
    """A drawing with its number."""

    number: int
    sheet: Sheet
    svg: Markup


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
        "in_words": in_words,
        "marks": marks,
        "term": term,
        "translate": translate,
        "worded": worded,
        "three": _three,
    }
    environment.globals.update(told=told, _=message, frame=frame)
    return environment.get_template(name)


def _three(share: float) -> str:
    """Share of a limit in three digits, in more where it would be shown as the whole."""
    return localized(next((text for digits in range(3, 10) if float(text := f"{share:.{digits}g}") != 1), "1"))


def render(subject: Subject) -> str:
    """Write the page; the same subject gives the same text."""
    with latin_symbols((subject.symbols or {"en": "latin"}.get(spoken())) == "latin") as latin:
        head, start, main = _page(subject, latin).partition("<main>")
    main, numbers = cited(main)
    sources = references()
    entry = Markup("<div><dt>{}</dt><dd>{}</dd></div>\n").format
    listed = Markup().join(entry(number, sources[key]) for key, number in numbers.items())
    return head + start + (_LIST.sub(lambda found: f"{found[1]}{listed}{found[2]}" if numbers else "", main))


_LIST = re.compile(r'(<section id="references">.*?<dl class="references">\n?)(</dl>\n</section>\n)', re.DOTALL)
"""The list of sources, which only a page that cites one has."""


def _page(subject: Subject, latin: Mapping[str, str]) -> str:
    dossier, short, form = subject.dossier, subject.short, FORMS.get(spoken(), FORMS["en"])
    parts, loads = ([], peaks(dossier)) if short else (chapters(dossier), [])
    if short:
        form = form._replace(sections=SHORT, appendices=(), always=())
    drawn = _section(dossier, short) | {chapter.topic.name: chapter.sheets for chapter in parts}
    # what is said of the papers has an appendix of its own
    findings, rows = ranked(dossier.findings), dossier.check.checks
    required, held = ([row for row in rows if row.is_requirement is asked] for asked in (True, False))
    remarks = [finding for finding in findings if MISPRINT.search(finding.message)]
    mended = _mended(parts, remarks, chain(*drawn.values()))
    has = {
        "requirements": required, "peaks": loads, "symbols": spoken() != "en" or subject.symbols != "papers",
        "misprints": mended, "source": subject.with_source,
    }  # fmt: skip
    labels = _labels(form, has)
    counts = {"requirements": bool(required), "checks": 1, "spec": not short, "peaks": 1, "misprints": 1}
    counts |= {chapter.topic.name: len(chapter.tables) for chapter in parts}
    order = chain(*((chapter.topic.name for chapter in parts) if name == "calculation" else [name] for name in labels))
    tables = _numbered((name, counts.get(name, 0)) for name in order)
    name = named(dossier.spec.name) or message("Adaptive friction clutch")
    most = max(_LEAST, _MOST - len(required))
    changed = _changed(subject.overrides)
    title = dict(subject.title)
    groups: dict[str, list[_SpecLine]] = {}
    for line in _spec_lines(_with_frictions(dossier.spec)):
        groups.setdefault(line.group, []).append(line._replace(overridden=line.path in changed))
    return template("page.html").render(
        subject=subject,
        name=name,
        running=" · ".join(part for part in (name, subject.title.drawing, subject.title.revision) if part),
        entries=_entries(subject, form),
        people=[(who, title[who]) for who in form.people if title[who] or who in form.signed],
        overridden=[name_of(path) if path in keys() else path for path in changed],
        sentence=translate(dossier.check.verdict.sentence),
        groups=groups,
        count=len(held),
        limits=sorted(held, key=lambda row: -(row.utilisation or 0.0))[:most] if short else held,
        peaks=loads,
        chapters=parts,
        figures=_figures(drawn),
        tables=tables,
        labels=labels,
        sections=[*labels],
        symbols=lambda: _symbols(parts, chain(*groups.values()), dossier, latin),
        form=form,
        # a title block would take the room of what has two pages
        paper="plain" if short else "report" if subject.title.form == "report" else form.paper,
        language=spoken(),
        findings=[finding for finding in findings if finding not in remarks],
        remarks=remarks,
        misprints=mended,
        next=_next(dossier),
        latin=latin,
    )


_MOST, _LEAST = 12, 4
"""Requirements and limits that a short report shows together, and how many limits at least."""


def _section(dossier: Dossier, short: bool) -> dict[str, Sequence[Sheet]]:
    """The clutch in section, which stands with the initial data; in a short report without its table."""
    if dossier.section is None:
        return {}
    sheet = sheet_of("section", dossier.section)
    return {"spec": [replace(sheet, panels=[panel.without_table() for panel in sheet.panels]) if short else sheet]}


def _labels(form: Form, has: Mapping[str, object]) -> dict[str, str]:
    """Number of each section that has content, letter of each appendix, in the order of the page."""
    sections, appendices = (
        [name for name in names if name in form.always or has.get(name, True)]
        for names in (form.sections, form.appendices)
    )
    labels = {name: str(number) for number, name in enumerate(sections, 1)}
    lettered = zip(appendices, form.letters, strict=False)
    return labels | {name: message("Appendix {letter}", letter=letter) for name, letter in lettered}


def _figures(drawn: Mapping[str, Sequence[Sheet]]) -> dict[str, list[_Figure]]:
    """Draw what each section shows, numbered in the order of the page."""
    numbers = count(1)
    return {
        name: [_Figure(number, sheet, _panels(sheet, number)) for sheet, number in zip(sheets, numbers, strict=False)]
        for name, sheets in drawn.items()
    }


def _numbered(counts: Iterable[tuple[str, int]]) -> dict[str, list[int]]:
    """Number the tables of each part, in the order of the page."""
    numbers = count(1)
    return {name: list(islice(numbers, many)) for name, many in counts}


def _changed(overrides: Iterable[str]) -> list[str]:
    """Paths of the keys, or tables, that overrides change."""
    given = (override.partition("=")[0].strip() for override in overrides)
    return [path_of(name) or name for name in given]


def _mended(parts: Iterable[Chapter], remarks: Iterable[Finding], sheets: Iterable[Sheet]) -> list[Misprint]:
    """Return the misprints that a report names."""
    texts = [part for chapter in parts for block in chapter.blocks for part in (block.step.source, block.step.differs)]
    texts += [str([table.title, table.rows]) for chapter in parts for table in chapter.tables]
    texts += [*(finding.message for finding in remarks), *(sheet.caption for sheet in sheets)]
    named = {mark for text in texts for mark in MISPRINT.findall(text)}
    return [each for each in misprints() if each.id in named]


def _next(dossier: Dossier) -> list[str]:
    """What is to be done next, the gravest first."""
    rows = sorted(dossier.check.checks, key=lambda row: -(row.utilisation or 0.0))
    lines = [
        message(
            "Bring “{name}” to its limit: {used} of it is used.", name=worded(row.name), used=percent(row.utilisation)
        )
        for row in rows
        if row.passed is False and row.utilisation is not None
    ]
    lines += [
        message("Give what it takes to judge “{name}”.", name=worded(row.name)) for row in rows if row.passed is None
    ]
    grave = [finding for finding in ranked(dossier.findings) if finding.level != "info"]
    lines += [in_words(translate(finding.message)) for finding in grave if not finding.code.startswith("requirement-")]
    return lines or [translate("Nothing by this calculation: it goes to be checked and approved.")]


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


def _symbols(
    parts: list[Chapter], lines: Iterable[_SpecLine], dossier: Dossier, latin: Mapping[str, str]
) -> list[tuple[str, str, str]]:
    """Symbols, what the papers write where that is another, and what each stands for where it is first told."""
    meanings: dict[str, str] = {}
    for step in (block.step for chapter in parts for block in chapter.blocks):
        for part in step.where:
            if part.text:
                meanings.setdefault(native(part.symbol), part.text)
        # the heading of its step begins with a capital
        name = explained(Meaning(step.symbol, step.name, step.unit))
        first = name[:1].lower() if name[1:2].islower() else name[:1]
        meanings.setdefault(native(step.symbol), first + name[1:])
    tables = (table for chapter in parts for table in chapter.tables if table.header[0] == translate("Symbol"))
    named = (
        (row[0], row[1], row[-1] if table.header[-1] == translate("Unit") else "–")
        for table in tables
        for row in table.rows
    )
    for shown, text, unit in chain(named, ((native(line.symbol), line.about, line.unit) for line in lines)):
        if shown:
            meanings.setdefault(shown, f"{text}, {unit}" if unit not in ("", "–") else text)
    # what stands in no formula and no table, but in a check, a note or a meaning
    known = {native(key.symbol): name_of(path) for path, key in keys().items() if key.symbol}
    notes = (*(row.symbol for row in dossier.check.checks), *(finding.message for finding in dossier.findings))
    said = native(" ".join(map(translate, (*notes, *meanings.values()))))
    # in a ratio, a symbol may be another quantity
    alone = [each for each in known if "_" in each and not any(each in other for other in meanings)]
    meanings |= {each: known[each] for each in alone if re.search(rf"(?<!\w){re.escape(each)}(?![\w.,]*\w)", said)}
    rows = ((each, latin.get(each, ""), text) for each, text in meanings.items())
    return sorted(rows, key=lambda row: row[0].casefold())


def _with_frictions(spec: Spec) -> dict[str, Any]:
    """Return a spec as resolved, with the friction of its materials, and the mean also where it follows."""
    data: dict[str, Any] = resolved(spec)
    friction = spec.friction
    if friction.unlike:
        groups = {"driving": friction.driving, "driven": friction.driven}
        data["friction"] |= {
            name: block.range._asdict() | data["friction"][name] for name, block in groups.items() if block
        }
    else:
        data["friction"] = friction.range._asdict() | data["friction"]
    return data


def _spec_lines(data: dict[str, Any], prefix: str = "") -> Iterator[_SpecLine]:
    """Every key of a spec that has a value, less what the cover or the requirements show."""
    group = _titled(prefix.rstrip("."))
    for name, value in data.items():
        path = prefix + name
        key = keys().get(path)
        if path in _ELSEWHERE:
            continue
        if key is None:
            yield from _spec_lines(value, f"{path}.")
        elif isinstance(value, dict):
            yield from (_scatter(group, field, given) for field, given in value.items())
        else:
            whole = localized(str(value)) if type(value) is int else str(value)
            shown = list(value) if isinstance(value, tuple) else whole if key.unit is None else value
            unit, numeric = key.unit or "", key.unit is not None
            yield _SpecLine(
                group, path, key.symbol or "", name_of(path), display(shown, unit), display_unit(unit), numeric
            )


_ELSEWHERE = ("name", "report", "requirements", "catalogues")


def _titled(path: str) -> str:
    """Title of a table of the spec, after that of the one that it stands in."""
    above, _, _ = path.rpartition(".")
    blocks: Any = template("blocks.html").module
    return ": ".join(blocks.titled(each).strip() for each in filter(None, (above, path))) or translate("Clutch")


def in_words(text: str) -> str:
    """Set names in the place of keys and tables of the spec.

    >>> in_words("see friction.min, closing_spring.disc and [heat], not drive.none")
    'see “smallest coefficient of friction”, “Closing spring: Disc springs” and “Heat and wear”, not drive.none'
    """

    def named_so(found: re.Match[str]) -> str:
        path = found[1] or found[0]
        name = name_of(path) if path in keys() else _titled(path)
        return found[0] if path in name.split(": ") else translate("“…”", "symbol").replace("…", name)

    return _PATH.sub(named_so, text)


_PATH = re.compile(r"\[([a-z_.]+)\]|\b[a-z_]+(?:\.[a-z_]+)+\b")


def _scatter(group: str, name: str, given: dict[str, Any]) -> _SpecLine:
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
        about = message("scatter: {about}", about=name_of(name))
    value = (", " if spoken() == "en" else "; ").join([worded(given["distribution"]), *numbers])
    return _SpecLine(group, f"tolerance.fields.{name}", symbol, about, value, shown_unit, False)
