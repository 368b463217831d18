"""Report of a clutch as a document and as a page, from its dossier (the results of all its calculations)."""

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from datetime import date
from itertools import chain, count
from typing import Any, Literal, NamedTuple

from ... import __version__
from ...analysis.check import CheckResult, CheckRow
from ...analysis.dossier import Dossier
from ...analysis.explain.explain import Meaning
from ...findings import Finding
from ...messages import filled, localized, named, native, printable, say, spoken, translate, with_unit
from ...papers.register import Misprint, misprints, references
from ...spec import Spec, resolved
from ...spec.keys import keys, path_of, scatter_at
from ...spec.models import TitleBlock
from ..amounts import display, display_unit, measured, worded
from ..plot import sheet_of
from ..plot.chart import Sheet
from ..plot.figure import inline_svg
from ..text_tables import TextTable, ranked
from . import blocks
from .blocks import Block, Document, Piece, Text, listed, piece, text, when
from .chapters import Chapter, chapters, explained, peaks
from .html import page
from .pieces import MISPRINT, cell, cited, name_of, plain, said, unparted
from .title import text_as_given, title_block, today
from .words import PEOPLE, SHORT, form, titled, told


@dataclass(frozen=True)
class Subject:
    """Subject of a report: the dossier of a clutch, and the title block."""

    dossier: Dossier
    given: str
    """Text of the spec as given."""
    title: TitleBlock = TitleBlock()
    """Title block of the spec, as it is: without a date if the spec gives no date."""
    digest: str = ""
    """SHA-256 of the file as given."""
    source: str = ""
    """Name of the source from which the spec was read, such as a file name."""
    overrides: Sequence[str] = ()
    """Overrides ``PATH=VALUE`` of values in the spec."""
    with_source: bool = False
    """True if the text of the spec as given becomes an appendix."""
    short: bool = False
    """True if the report is to take two pages: task, limits, section, peaks, heat, conclusions."""


def subject_of(
    dossier: Dossier, overrides: Sequence[str] = (), *, with_source: bool = False, short: bool = False
) -> Subject:
    """Subject of the report on a clutch that was read from a source."""
    source = dossier.spec.label
    texts = text_as_given(source), title_block(dossier.spec), source.digest, source, overrides
    return Subject(dossier, *texts, with_source, short)


_PROGRAM = f"afmcalc {__version__}"


class _SpecLine(NamedTuple):
    """A key of the spec with its value, after defaults are filled in."""

    group: str
    path: str
    symbol: str
    about: str
    value: str
    unit: str
    numeric: bool

    def cells(self, changed: Collection[str]) -> list[Text]:
        """Row of a table; it marks the key as overridden if the key is among ``changed``."""
        mark = when(self.path in changed, " ", piece("soft", f"({say('overridden')})"))
        set_so = cell if self.numeric or self.path == "adjustment.method" else plain
        return [said(self.symbol), text(said(self.about), mark), set_so(self.value), text(self.unit)]


def _in_a_line(group: tuple[str, Iterable[_SpecLine]]) -> Text:
    """Write the numbers in a group of the spec in one line."""
    title, lines = group
    shown = [line for line in lines if line.symbol and line.numeric]
    each = [
        text(said(line.symbol), " = ", cell(line.value), f" {line.unit}" if line.unit != "–" else "") for line in shown
    ]
    return text(f"{title}: ", listed(each, "; "), ". ") if shown else text()


def render(subject: Subject) -> str:
    """Write the page; the same subject gives the same text."""
    return page(report(subject))


def report(subject: Subject) -> Document:
    """Lay a report out; the same subject gives the same document."""
    laid_out = _report(subject)
    body, numbers = cited(laid_out.body)
    sources = references()
    entries = [(text(str(number)), text(sources[key])) for key, number in numbers.items()]
    body = [
        replace(each, body=[blocks.Definitions("references", entries)]) if each.key == "references" else each
        for each in body
    ]
    return replace(laid_out, body=[each for each in body if entries or each.key != "references"])


def _report(subject: Subject) -> Document:
    dossier, short, title = subject.dossier, subject.short, subject.title
    name = unparted(printable(named(dossier.spec.name) or say("Adaptive friction clutch")))
    kind = say("Calculation report")
    paper = "report" if title.form == "report" and not short else form().paper
    verdict = blocks.Paragraph(said(dossier.check.verdict.sentence), f"sum {dossier.check.grade}", "verdict")
    return Document(
        language=spoken(),
        program=_PROGRAM,
        kind=kind,
        name=name,
        cover=[_entries(subject), _signatures(title), verdict, *_trip(dossier.check)],
        body=_Parts(subject).sections(),
        running=" · ".join(map(printable, filter(None, (name, title.drawing, title.revision)))),
        date=_day(title),
        contents=not short,
        paper=paper,
        short=short,
        author=title.author or "",
        frame=_frame(title, f"{name}. {kind}") if paper == "framed" else None,
    )


def _trip(check: CheckResult) -> list[Block]:
    """Range of the slip torque, also relative to the rated torque; empty if the rated torque is not known."""
    if check.trip_ratio_min is None:
        return []
    torque = with_unit(display([check.torque_min, check.torque_max], "N*m"), display_unit("N*m"))
    ratio = display([check.trip_ratio_min, check.trip_ratio_max], "1")
    rated = measured(check.running_torque, "N*m")
    words = say(
        "It slips at T_min … T_max = {torque}: {ratio} times the rated torque at the clutch, T_0 = {rated}.",
        torque=torque, ratio=ratio, rated=rated,
    )  # fmt: skip
    return [blocks.Paragraph(said(words))]


def _day(title: TitleBlock) -> str:
    """Date in the title block; today's date if that is no date of ISO 8601."""
    with suppress(ValueError):
        return date.fromisoformat(title.date or "").isoformat()
    return today()


class _Parts:
    """The sections of a report: the content of each, and the numbers of its tables and figures."""

    def __init__(self, subject: Subject) -> None:
        dossier, short = subject.dossier, subject.short
        self.subject, self.dossier, self.short = subject, dossier, short
        self.chapters, self.peaks = ([], peaks(dossier)) if short else (chapters(dossier), [])
        # remarks on misprints of the papers have their own appendix
        findings, rows = ranked(dossier.findings), dossier.check.checks
        self.required, self.held = ([row for row in rows if row.is_requirement is asked] for asked in (True, False))
        self.remarks = [finding for finding in findings if MISPRINT.search(finding.message)]
        self.findings = [finding for finding in findings if finding not in self.remarks]
        self.drawn = _section(dossier, short) | {chapter.topic.name: chapter.sheets for chapter in self.chapters}
        self.mended = _mended(self.chapters, self.remarks, chain(*self.drawn.values()))
        self.lines = [*_spec_lines(_with_frictions(dossier.spec))]
        self._tables, self._figures = count(1), count(1)

    def sections(self) -> list[blocks.Section]:
        """Lay out the sections that have content, and the appendices with their letters, in order."""
        has: dict[str, object] = {
            "requirements": self.required, "peaks": self.peaks, "misprints": self.mended,
            "source": self.subject.with_source,
        }  # fmt: skip
        set_so = form()._replace(sections=SHORT, appendices=(), always=()) if self.short else form()
        sections, appendices = (
            [name for name in names if name in set_so.always or has.get(name, True)]
            for names in (set_so.sections, set_so.appendices)
        )
        self.labels = {name: str(number) for number, name in enumerate(sections, 1)}
        lettered = zip(appendices, set_so.letters, strict=False)
        self.labels |= {name: say("Appendix {letter}", letter=letter) for name, letter in lettered}
        return [
            blocks.Section(
                name,
                label,
                text(told("next" if self.short and name == "conclusion" else name)),
                [*getattr(self, f"_{name}")()],
                name in appendices,
            )
            for name, label in self.labels.items()
        ]

    def _requirements(self) -> Iterator[Block]:
        if not self.required:
            yield blocks.Paragraph(
                text(say("The spec states no requirements; the clutch is calculated as it is given."))
            )
            return
        number = next(self._tables)
        lead = say("What the clutch is to hold, and what it uses of each limit:")
        yield blocks.Paragraph(text(lead, " ", see("table", number), "."))
        yield from judged(self.required, number, say("Requirements"))

    def _checks(self) -> Iterator[Block]:
        held, many = self.held, len(self.held)
        if self.short:
            most = max(_LEAST, _MOST - len(self.required))
            held = sorted(held, key=lambda row: -(row.utilisation or 0.0))[:most]
        lead = say("Every limit the clutch is held against; utilisation 1 is the limit:")
        if len(held) < many:
            lead = say(
                "The {shown} limits of which the clutch uses most, of {count}; utilisation 1 is the limit:",
                shown=len(held), count=many,
            )  # fmt: skip
        number = next(self._tables)
        yield blocks.Paragraph(text(lead, " ", see("table", number), "."))
        yield from judged(held, number, say("Limits and their utilisation"))
        if self.findings and not self.short:
            yield blocks.Heading(3, text(say("Findings")))
            yield findings_of(self.findings)
        if self.remarks and not self.short:
            at = piece("link", self.labels["misprints"], "misprints")
            lead = say("Remarks that concern misprints of the papers:")
            yield blocks.Paragraph(text(lead, " ", at, "."), "note")

    def _spec(self) -> Iterator[Block]:
        figures = self._shown("spec")
        drawing = say("The clutch in section:")
        lead = text(drawing, " ", see("figure", *(each.number for each in figures)), ". ") if figures else text()
        lead = text(lead, say("The values calculated with:"), " ")
        if self.short:
            yield blocks.Paragraph(text(lead, *map(_in_a_line, self._groups().items())))
        else:
            number = next(self._tables)
            yield blocks.Paragraph(text(lead, see("table", number), "."))
            rows: list[list[Text]] = []
            changed = _changed(self.subject.overrides)
            for group, lines in self._groups().items():
                rows += [[text(group)], *(line.cells(changed) for line in lines)]
            heads = map(text, (say("Symbol"), say("Quantity"), say("Value"), say("Unit")))
            title = text(say("Values calculated with"))
            yield blocks.Table("keys", title, [*heads], rows, [False, False, True, False], number)
        yield from figures

    def _groups(self) -> dict[str, list[_SpecLine]]:
        groups: dict[str, list[_SpecLine]] = {}
        for line in self.lines:
            groups.setdefault(line.group, []).append(line)
        return groups

    def _shown(self, name: str) -> list[blocks.Figure]:
        """Draw the figures of a section."""
        return [figure_of(next(self._figures), sheet) for sheet in self.drawn.get(name, ())]

    def _peaks(self) -> Iterator[Block]:
        number = next(self._tables)
        yield blocks.Paragraph(text(say("What a trip loads and heats:"), " ", see("table", number), "."))
        yield quantities(self.peaks[0]._replace(title=told("peaks")), number)

    def _calculation(self) -> Iterator[Block]:
        if not self.short:
            lead = say(
                "Each formula stands once, with its source; below it the numbers put in, in SI units, and what "
                "comes out, in the units of the tables."
            )
            notes = [told("as-set/" + self.dossier.spec.adjustment.method)]
            notes += [] if self.dossier.spec.friction.unlike else [say("All pairs are alike: f_1 = f_2 = f.")]
            yield blocks.Paragraph(listed([text(lead), *map(said, notes)], " "))
        for place, chapter in enumerate(self.chapters, 1):
            label = f"{self.labels['calculation']}.{place}"
            topic = chapter.topic
            yield blocks.Section(topic.name, label, text(translate(topic.title)), [*self._chapter(chapter)])

    def _chapter(self, chapter: Chapter) -> Iterator[Block]:
        topic, tables = chapter.topic, [quantities(table, next(self._tables)) for table in chapter.tables]
        figures = self._shown(topic.name)
        results = [see("table", *(each.number for each in tables))] if tables else []
        results += [see("figure", *(each.number for each in figures))] if figures else []
        parts: list[Text | Piece | str] = [said(topic.about), say("Results:"), listed(results)]
        parts[1:1] = [piece("sources", f"[{', '.join(topic.sources)}]")] if topic.sources else []
        yield blocks.Paragraph(text(listed(parts, " "), "."))
        yield from tables
        yield from figures
        if chapter.steps:
            yield blocks.Heading(4, text(say("Derivation")))
            yield from chapter.steps

    def _conclusion(self) -> Iterator[Block]:
        check = self.dossier.check
        if not self.short:
            yield blocks.Paragraph(said(check.verdict.sentence), f"sum {check.grade}")
            yield blocks.Bullets([said(topic.conclusion) for topic in self.dossier.topics if topic.conclusion])
            yield blocks.Heading(3, text(told("next")))
        yield blocks.Bullets([*map(said, _next(self.dossier))], "next")

    def _references(self) -> Iterator[Block]:
        yield from ()  # the cited sources are known only after everything else is laid out

    def _symbols(self) -> Iterator[Block]:
        if spoken() == "en":
            yield blocks.Paragraph(text(say("In brackets: as the papers write a symbol.")))
        rows = _symbols(self.chapters, self.lines)
        yield blocks.Definitions(
            "symbols",
            [
                (text(said(symbol, False), when(papers, " (", said(papers, False), ")")), said(words))
                for symbol, papers, words in rows
            ],
        )

    def _misprints(self) -> Iterator[Block]:
        number = next(self._tables)
        lead = say("Where this calculation departs from the print of its sources, by the number that stands there:")
        yield blocks.Paragraph(text(lead, " ", see("table", number), "."))
        heads = map(text, (say("No."), say("Where"), say("Printed"), say("Should be")))
        rows = [
            [
                text(each.id),
                said(translate(each.where)),
                said(translate(each.printed), False),
                said(translate(each.correct)),
            ]
            for each in self.mended
        ]
        yield blocks.Table("misprints", text(told("misprints")), [*heads], rows, number=number, named=True)
        if self.remarks:
            yield findings_of(self.remarks)

    def _source(self) -> Iterator[Block]:
        if overrides := self.subject.overrides:
            lead = say("Overridden on the command line")
            yield blocks.Paragraph(text(lead, ": ", listed([piece("code", plain(each)) for each in overrides])))
        yield blocks.Code(printable(self.subject.given, lines=True))


def see(what: Literal["table", "figure"], *numbers: int) -> Text:
    """Text that names tables or figures, each with a link."""
    name = {"table": "table {number}", "figure": "figure {number}"}[what]
    shown = ((number, filled(name, {"number": number}).replace(" ", "\xa0")) for number in numbers)
    return listed([piece("link", name, f"{what}-{number}") for number, name in shown])


def judged(rows: Sequence[CheckRow], number: int = 0, title: str = "") -> Iterator[Block]:
    """Lay out the checks in ``rows``, each with limit and utilisation."""
    heads = "Verdict", "Check", "Condition", "Value", "Limit", "Unit", "Utilisation"
    cells = [
        [
            text(piece("grade", translate(row.grade), row.grade)),
            said(worded(row.name)),
            said(row.symbol),
            text(display(row.value, row.shown_unit)),
            text("≥ " if row.least else "≤ ", display(row.limit, row.shown_unit, 5)),
            text(display_unit(row.shown_unit)),
            text("–" if row.utilisation is None else _three(row.utilisation)),
        ]
        for row in rows
    ]
    numeric = [False, False, False, True, True, False, True]
    yield blocks.Table("judged", text(title), [text(translate(head)) for head in heads], cells, numeric, number)
    if any(row.shown_unit == "K abs" for row in rows):
        note = say("The share of a temperature is that of the rise which its limit allows.")
        yield blocks.Paragraph(text(note), "note")


def quantities(block: TextTable, number: int = 0) -> blocks.Table:
    """Lay out a table of numbers."""
    role = "quantities" if block.header[-1] == translate("Unit") else ""
    rows = [[*map(cell, row)] for row in block.rows]
    return blocks.Table(role, said(block.title), [*map(said, block.header)], rows, block.numeric, number)


def findings_of(findings: Iterable[Finding], *, keys: bool = False) -> blocks.Findings:
    """Lay out findings; the keys of the spec are replaced by names unless ``keys`` is true."""
    items = []
    for finding in findings:
        grade = {"error": "fail", "warning": "warning", "info": "note"}[finding.level]
        words = said(finding.message if keys else in_words(finding.message))
        code = when(keys and finding.path, " ", piece("code", finding.path or ""))
        items.append((piece("grade", told(f"level/{finding.level}"), grade), text(words, code)))
    return blocks.Findings(items)


def figure_of(number: int, sheet: Sheet) -> blocks.Figure:
    """Draw a sheet, each panel by itself, because a page may end between two panels."""
    drawings = [blocks.Drawing(inline_svg(panel)) for panel in sheet.panels]
    return blocks.Figure(number, drawings, said(sheet.title), said(in_words(sheet.caption)))


def _three(share: float) -> str:
    """Share of a limit to three digits, or to more digits if three would show 1."""
    return localized(next((shown for digits in range(3, 10) if float(shown := f"{share:.{digits}g}") != 1), "1"))


_MOST, _LEAST = 12, 4
"""Largest number of requirements and limits together in a short report, and smallest number of limits."""


def _section(dossier: Dossier, short: bool) -> dict[str, Sequence[Sheet]]:
    """The clutch in section, shown with the initial data; in a short report without its part list."""
    if dossier.section is None:
        return {}
    sheet = sheet_of("section", dossier.section)
    return {"spec": [replace(sheet, panels=[panel.without_table() for panel in sheet.panels]) if short else sheet]}


def _changed(overrides: Iterable[str]) -> list[str]:
    """Paths of the keys, or tables, that overrides change."""
    given = (override.partition("=")[0].strip() for override in overrides)
    return [path_of(name) or name for name in given]


def _mended(parts: Iterable[Chapter], remarks: Iterable[Finding], sheets: Iterable[Sheet]) -> list[Misprint]:
    """Return the misprints that a report names."""
    texts = [part for chapter in parts for step in chapter.topic.derivations for part in (step.source, step.differs)]
    texts += [str([table.title, table.rows]) for chapter in parts for table in chapter.tables]
    texts += [*(finding.message for finding in remarks), *(sheet.caption for sheet in sheets)]
    named = {mark for text in texts for mark in MISPRINT.findall(text)}
    return [each for each in misprints() if each.id in named]


def _next(dossier: Dossier) -> list[str]:
    """Sentences on the next steps for the designer, the most important first."""
    lines = [*map(in_words, dossier.steps)]
    lines += [
        say("Give what it takes to judge “{name}”.", name=worded(row.name))
        for row in dossier.check.checks
        if row.passed is None
    ]
    return lines or [translate("Nothing by this calculation: it goes to be checked and approved.")]


def _entries(subject: Subject) -> blocks.Entries:
    """Entries of the title block: given entries and those of every report; ISO dates become dates of the language."""
    title = dict(subject.title) | {
        "variant": translate(subject.dossier.spec.variant, "value"),
        "program": _PROGRAM,
    }
    with suppress(ValueError):
        title["date"] = date.fromisoformat(title["date"] or "").strftime(translate("%Y-%m-%d", "date"))
    entries = [name for name in form().entries if title[name] or name in form().signed]
    changed = "; ".join(name_of(path) if path in keys() else path for path in _changed(subject.overrides))
    long = {
        say("Spec"): subject.source,
        say("SHA-256 of the spec as given"): subject.digest,
        say("Overridden on the command line"): changed,
    }
    return blocks.Entries(
        [
            *((told(name), printable(title[name] or ""), False) for name in entries),
            *((name, printable(value), True) for name, value in long.items() if value),
        ]
    )


def _signatures(title: TitleBlock) -> blocks.Table:
    """Table of signatures: all roles that sign in this language, and other roles for which a name is given."""
    heads = map(text, (say("Responsible"), say("Name"), say("Signature"), say("Date")))
    names = {who: getattr(title, who) for who in PEOPLE}
    rows = [
        [text(told(who)), text(printable(name or "")), text(), text()]
        for who, name in names.items()
        if name or who in form().signed
    ]
    return blocks.Table("signatures", text(), [*heads], rows)


def _frame(title: TitleBlock, headline: str) -> blocks.Frame:
    roles = ("Drawn", title.author), ("Checked", title.checked), ("", ""), ("Standards", title.norm_control)
    margin = "Signature and date", "No. of copy", "Instead of no.", "Signature and date", "No. of original"
    return blocks.Frame(
        headline=headline,
        drawing=printable(title.drawing or ""),
        organisation=printable(title.organisation or ""),
        revision=printable(title.revision or ""),
        people=[(translate(role), printable(who or "")) for role, who in (*roles, ("Approved", title.approved))],
        changes=[*map(translate, ("Chg.", "Sheet", "Document no.", "Sign.", "Date"))],
        stage=[*map(translate, ("Stage", "Sheet", "Sheets"))],
        margin=[*map(translate, margin)],
    )


def _symbols(parts: list[Chapter], lines: Iterable[_SpecLine]) -> list[tuple[str, str, str]]:
    """Symbols, each with the papers' symbol if it differs, and with the meaning at its first occurrence."""
    meanings: dict[str, str] = {}
    for step in (step for chapter in parts for step in chapter.topic.derivations):
        for part in step.where:
            if part.text:
                meanings.setdefault(native(part.symbol), explained(part))
        # the name is the heading of the step and therefore begins with a capital
        name = explained(Meaning(step.symbol, step.name, step.unit))
        first = name[:1].lower() if name[1:2].islower() else name[:1]
        meanings.setdefault(native(step.symbol), first + name[1:])
    tables = [table for chapter in parts for table in chapter.tables if table.header[0] == translate("Symbol")]
    named = (
        (row[0], row[1], row[-1] if table.header[-1] == translate("Unit") else "–")
        for table in tables
        for row in table.rows
    )
    for shown, words, unit in chain(named, ((native(line.symbol), line.about, line.unit) for line in lines)):
        if shown:
            meanings.setdefault(shown, f"{words}, {unit}" if unit not in ("", "–") else words)
    of_papers = (
        *(key.symbol or "" for key in keys().values()),
        *(column.symbol for table in tables if table.source for column in table.source.columns),
        *(step.symbol for chapter in parts for step in chapter.topic.derivations),
        *(part.symbol for chapter in parts for step in chapter.topic.derivations for part in step.where),
    )
    printed = {shown: symbol for symbol in of_papers if (shown := native(symbol)) != symbol and spoken() == "en"}
    rows = ((each, printed.get(each, ""), words) for each, words in meanings.items())
    return sorted(rows, key=lambda row: row[0].casefold())


def _with_frictions(spec: Spec) -> dict[str, Any]:
    """Return the data of a spec with its friction ranges in full, even if they follow from materials."""
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
    """Every key of a spec that has a value, except keys that the cover or the requirements show."""
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
                group, path, key.symbol or "", name_of(path), display(shown, unit, 5), display_unit(unit), numeric
            )


_ELSEWHERE = ("name", "report", "requirements", "catalogues", "objectives", "search")


def _titled(path: str) -> str:
    """Title of a table of the spec, preceded by the title of the table that contains it."""
    above, _, _ = path.rpartition(".")
    return ": ".join(map(titled, filter(None, (above, path)))) or titled("")


def in_words(text: str) -> str:
    """Text with the keys and tables of the spec replaced by their names.

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
    """Show a distribution of [tolerance.fields]: its kind, then its numbers in the unit of the key that scatters."""
    quantity, key = scatter_at(name), keys().get(name)
    unit = quantity.unit if quantity else ""
    parts = {part: value for part, value in given.items() if part != "distribution"}
    numbers = [f"{translate(part, 'value')} {display(value, unit)}" for part, value in parts.items()]
    # a spread in percent has no further unit
    shown_unit = "" if all(isinstance(value, str) for value in parts.values()) else display_unit(unit)
    symbol, about = "f", translate("scatter of the friction in service")
    if key:
        symbol = key.symbol or ""
        about = say("scatter: {about}", about=name_of(name))
    value = (", " if spoken() == "en" else "; ").join([worded(given["distribution"]), *numbers])
    return _SpecLine(group, f"tolerance.fields.{name}", symbol, about, value, shown_unit, False)
