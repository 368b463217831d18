"""Report of a clutch as a document and as a page, from its dossier (the results of all its calculations)."""

import json
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from datetime import date
from itertools import count
from typing import Any, NamedTuple

from ... import __version__
from ...analysis.check import CheckResult, CheckRow
from ...analysis.dossier import Dossier
from ...findings import Finding
from ...messages import filled, localized, named, native, printable, say, spoken, translate, with_unit
from ...papers.register import misprints, references
from ...spec import Spec, resolved
from ...spec.keys import keys, path_of, scatter_at
from ...spec.models import TitleBlock
from ...spec.parse import is_json, parse
from ...spec.write import annotated
from ..amounts import display, display_unit, measured, worded
from ..plot import sheet_of
from ..plot.chart import Sheet
from ..plot.figure import inline_svg
from ..text_tables import TextTable, ranked
from . import blocks
from .blocks import Block, Document, Text, listed, piece, text, today, when
from .chapters import chapters, explained, peaks
from .html import page
from .pieces import MISPRINT, cell, cited, name_of, plain, said, table, unparted
from .words import PEOPLE, SHORT, form, titled, told

_PROGRAM = f"afmcalc {__version__}"
_MOST, _LEAST = 12, 4
"""Largest number of requirements and limits together in a short report, and smallest number of limits."""
_ELSEWHERE = ("name", "report", "requirements", "catalogues", "objectives", "search")
_PATH = re.compile(r"\[([a-z_.]+)\]|\b[a-z_]+(?:\.[a-z_]+)+\b")


class Subject(NamedTuple):
    """Subject of a report: the dossier of a clutch, and how the report shows it."""

    dossier: Dossier
    overrides: Sequence[str] = ()
    """Overrides ``PATH=VALUE`` of values in the spec."""
    with_source: bool = False
    """True if the text of the spec as given becomes an appendix."""
    short: bool = False
    """True if the report is to take two pages: task, limits, section, peaks, heat, conclusions."""

    @property
    def title(self) -> dict[str, str]:
        """Entries of the [report] block of the spec, empty if not given, but dated today if it has no date."""
        block = self.dossier.spec.report or TitleBlock()
        return {name: printable(text or "") for name, text in block} | ({} if block.date else {"date": today()})


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

    @property
    def in_short(self) -> Text:
        """Symbol, number and unit; empty for a value that is no number or has no symbol."""
        unit = when(self.unit != "–", " ", self.unit)
        return when(self.symbol and self.numeric, said(self.symbol), " = ", cell(self.value), unit)


def render(subject: Subject) -> str:
    """Write the page; the same subject gives the same text."""
    return page(report(subject))


def report(subject: Subject) -> Document:
    """Lay a report out; the same subject gives the same document."""
    dossier, short, title = subject.dossier, subject.short, subject.title
    name = unparted(printable(named(dossier.spec.name) or say("Adaptive friction clutch")))
    kind, day = say("Calculation report"), today()
    with suppress(ValueError):
        day = date.fromisoformat(title["date"]).isoformat()
    paper = "report" if title["form"] == "report" and not short else form().paper
    verdict = blocks.Paragraph(said(dossier.check.verdict.sentence), f"sum {dossier.check.grade}", "verdict")
    cover = [_entries(subject), _signatures(title), verdict, *_trip(dossier.check)]
    body, numbers = cited(_Parts(subject).sections())
    sources = references()
    entries = [(text(str(number)), text(sources[key])) for key, number in numbers.items()]
    body = [
        replace(each, body=[blocks.Definitions("references", entries)]) if each.key == "references" else each
        for each in body
        if entries or each.key != "references"
    ]
    running = " · ".join(filter(None, (name, title["drawing"], title["revision"])))
    frame = _frame(title, f"{name}. {kind}") if paper == "framed" else None
    more: dict[str, Any] = {"paper": paper, "short": short, "author": title["author"], "frame": frame}
    return Document(spoken(), _PROGRAM, kind, name, cover, body, running, day, **more)


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
        self.steps = [step for chapter in self.chapters for step in chapter.topic.derivations]
        self.drawn = {chapter.topic.name: chapter.sheets for chapter in self.chapters}
        if dossier.section is not None:
            sheet = sheet_of("section", dossier.section)
            panels = [panel.without_table() for panel in sheet.panels] if short else sheet.panels
            self.drawn["spec"] = [sheet._replace(panels=panels)]
        texts = [str([table.title, table.rows]) for chapter in self.chapters for table in chapter.tables]
        texts += [text for step in self.steps for text in (step.source, step.differs)]
        texts += [*(finding.message for finding in self.remarks)]
        texts += [sheet.caption for sheets in self.drawn.values() for sheet in sheets]
        named = {mark for text in texts for mark in MISPRINT.findall(text)}
        self.mended = [each for each in misprints() if each.id in named]
        self.lines = [*_spec_lines(_with_frictions(dossier.spec))]
        self._tables, self._figures = count(1), count(1)

    def sections(self) -> list[blocks.Section]:
        """Lay out the sections that have content, and the appendices with their letters, in order."""
        has: dict[str, object] = {
            "requirements": self.required or (form().paper == "framed" and not self.short), "peaks": self.peaks,
            "misprints": self.mended, "source": self.subject.with_source,
        }  # fmt: skip
        sections, appendices = (
            [name for name in names if has.get(name, True)]
            for names in ((SHORT, ()) if self.short else (form().sections, form().appendices))
        )
        self.labels = {name: str(number) for number, name in enumerate(sections, 1)}
        lettered = zip(appendices, form().letters, strict=False)
        self.labels |= {name: say("Appendix {letter}", letter=letter) for name, letter in lettered}
        # the references, cited in all sections, are known only after them
        titles = {name: told("next" if self.short and name == "conclusion" else name) for name in self.labels}
        return [
            blocks.Section(name, label, text(titles[name]), [*getattr(self, f"_{name}", tuple)()], name in appendices)
            for name, label in self.labels.items()
        ]

    def _numbered(self, table: blocks.Table) -> blocks.Table:
        return replace(table, number=next(self._tables))

    def _shown(self, name: str) -> list[blocks.Figure]:
        """Draw the figures of a section."""
        return [figure_of(next(self._figures), sheet) for sheet in self.drawn.get(name, ())]

    def _led(self, lead: str | Text, table: blocks.Table, *more: Block) -> list[Block]:
        """A paragraph that leads to a table, and the table with its number."""
        table = self._numbered(table)
        return [blocks.Paragraph(text(lead, " ", see(table), ".")), table, *more]

    def _requirements(self) -> Iterable[Block]:
        if not self.required:
            words = say("The spec states no requirements; the clutch is calculated as it is given.")
            return [blocks.Paragraph(text(words))]
        lead = say("What the clutch is to hold, and what it uses of each limit:")
        return self._led(lead, *judged(self.required, say("Requirements")))

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
        yield from self._led(lead, *judged(held, say("Limits and their utilisation")))
        if self.short:
            return
        if self.findings:
            yield blocks.Heading(3, text(say("Findings")))
            yield findings_of(self.findings)
        if self.remarks:
            lead, at = say("Remarks that concern misprints of the papers:"), self.labels["misprints"]
            yield blocks.Paragraph(text(lead, " ", piece("link", at, "misprints"), "."), "note")

    def _spec(self) -> Iterator[Block]:
        figures, lead = self._shown("spec"), text(say("The values calculated with:"))
        groups: dict[str, list[_SpecLine]] = {}
        for line in self.lines:
            groups.setdefault(line.group, []).append(line)
        if figures:
            lead = text(say("The clutch in section:"), " ", see(*figures), ". ", lead)
        if self.short:
            numbers = {group: [line.in_short for line in lines] for group, lines in groups.items()}
            each = (text(f"{group}: ", listed(own, "; "), ". ") for group, own in numbers.items() if any(own))
            yield blocks.Paragraph(text(lead, " ", *each))
        else:
            rows: list[list[Text]] = []
            changed = _changed(self.subject.overrides)
            for group, lines in groups.items():
                rows += [[text(group)], *(line.cells(changed) for line in lines)]
            shown = table("keys", ("Symbol", "Quantity", "Value", "Unit"), rows, say("Values calculated with"))
            yield from self._led(lead, replace(shown, numeric=[False, False, True, False]))
        yield from figures

    def _peaks(self) -> Iterable[Block]:
        return self._led(say("What a trip loads and heats:"), quantities(self.peaks[0]._replace(title=told("peaks"))))

    def _calculation(self) -> Iterator[Block]:
        lead = say(
            "Each formula stands once, with its source; below it the numbers put in, in SI units, and what comes out, "
            "in the units of the tables."
        )
        notes = [told("as-set/" + self.dossier.spec.adjustment.method)]
        notes += [] if self.dossier.spec.friction.unlike else [say("All pairs are alike: f_1 = f_2 = f.")]
        yield blocks.Paragraph(listed([text(lead), *map(said, notes)], " "))
        for place, (topic, tables, steps, _) in enumerate(self.chapters, 1):
            label = f"{self.labels['calculation']}.{place}"
            results, figures = [self._numbered(quantities(table)) for table in tables], self._shown(topic.name)
            sources = when(topic.sources, piece("sources", f"[{', '.join(topic.sources)}]"))
            parts: list[Text | str] = [said(topic.about), sources, say("Results:")]
            parts.append(listed([see(*results), see(*figures)]))
            body: list[Block] = [blocks.Paragraph(text(listed(parts, " "), ".")), *results, *figures]
            body += [blocks.Heading(4, text(say("Derivation"))), *steps] if steps else []
            yield blocks.Section(topic.name, label, text(translate(topic.title)), body)

    def _conclusion(self) -> Iterator[Block]:
        check = self.dossier.check
        if not self.short:
            yield blocks.Paragraph(said(check.verdict.sentence), f"sum {check.grade}")
            yield blocks.Bullets([said(topic.conclusion) for topic in self.dossier.topics if topic.conclusion])
            yield blocks.Heading(3, text(told("next")))
        not_judged = [worded(row.name) for row in check.checks if row.passed is None]
        lines = [*map(in_words, self.dossier.steps)]
        lines += [say("Give what it takes to judge “{name}”.", name=name) for name in not_judged]
        lines = lines or [translate("Nothing by this calculation: it goes to be checked and approved.")]
        yield blocks.Bullets([*map(said, lines)], "next")

    def _symbols(self) -> Iterator[Block]:
        if spoken() == "en":
            yield blocks.Paragraph(text(say("In brackets: as the papers write a symbol.")))
        shown: list[tuple[str, str]] = []
        for step in self.steps:
            shown += [(part.symbol, explained(part.text, part.unit)) for part in step.where if part.text]
            # the name is the heading of the step and therefore begins with a capital
            name = explained(step.name, step.unit)
            shown.append((step.symbol, (name[:1].lower() if name[1:2].islower() else name[:1]) + name[1:]))
        tables = [each for chapter in self.chapters for each in chapter.tables if each.header[0] == translate("Symbol")]
        unit = translate("Unit")
        rows = [(*row[:2], row[-1] if each.header[-1] == unit else "") for each in tables for row in each.rows]
        rows += [(line.symbol, line.about, line.unit) for line in self.lines]
        shown += [(symbol, ", ".join(part for part in parts if part not in ("", "–"))) for symbol, *parts in rows]
        meanings: dict[str, str] = {}
        for symbol, words in shown:
            if symbol:
                meanings.setdefault(native(symbol), words)
        of_papers = [*(key.symbol or "" for key in keys().values()), *(symbol for symbol, _ in shown)]
        printed = {own: symbol for symbol in of_papers if (own := native(symbol)) != symbol and spoken() == "en"}
        items = [
            (text(said(own, False), when(own in printed, " (", said(printed.get(own, ""), False), ")")), said(words))
            for own, words in sorted(meanings.items(), key=lambda each: each[0].casefold())
        ]
        yield blocks.Definitions("symbols", items)

    def _misprints(self) -> Iterator[Block]:
        lead = say("Where this calculation departs from the print of its sources, by the number that stands there:")
        rows = [
            [
                text(each.id),
                said(translate(each.where)),
                said(translate(each.printed), False),
                said(translate(each.correct)),
            ]
            for each in self.mended
        ]
        heads = "No.", "Where", "Printed", "Should be"
        yield from self._led(lead, table("misprints", heads, rows, told("misprints"), named=True))
        if self.remarks:
            yield findings_of(self.remarks)

    def _source(self) -> Iterator[Block]:
        if overrides := self.subject.overrides:
            lead = say("Overridden on the command line")
            yield blocks.Paragraph(text(lead, ": ", listed([piece("code", plain(each)) for each in overrides])))
        source = self.dossier.spec.label
        given = source.text
        if spoken() != "en" and source.startswith("example:"):
            given = say("# {file}, its comments translated", file=source) + f"\n{annotated(given)}"
        if is_json(source):  # JSON of a command has the spec among the rest
            given = json.dumps(parse(source), indent=2, ensure_ascii=False)
        yield blocks.Code(printable(given.strip("\n"), lines=True))


def see(*shown: blocks.Table | blocks.Figure) -> Text:
    """Text that names tables or figures, each with a link."""
    whats = ((type(each).__name__.lower(), each.number) for each in shown)
    names = ((what, number, filled(f"{what} {{number}}", {"number": number})) for what, number in whats)
    return listed([piece("link", name.replace(" ", "\xa0"), f"{what}-{number}") for what, number, name in names])


def judged(rows: Sequence[CheckRow], title: str = "") -> tuple[blocks.Table, *tuple[Block, ...]]:
    """Lay out the checks in ``rows``, each with limit and utilisation; a note may follow the table."""
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
    laid_out = replace(table("judged", heads, cells, title), numeric=numeric)
    if not any(row.shown_unit == "K abs" for row in rows):
        return (laid_out,)
    note = say("The share of a temperature is that of the rise which its limit allows.")
    return laid_out, blocks.Paragraph(text(note), "note")


def quantities(block: TextTable) -> blocks.Table:
    """Lay out a table of numbers."""
    role = "quantities" if block.header[-1] == translate("Unit") else ""
    rows = [[*map(cell, row)] for row in block.rows]
    return blocks.Table(role, said(block.title), [*map(said, block.header)], rows, block.numeric)


def findings_of(findings: Iterable[Finding], *, keys: bool = False) -> blocks.Definitions:
    """Lay out findings; the keys of the spec are replaced by names unless ``keys`` is true."""
    items = []
    for finding in findings:
        grade = {"error": "fail", "warning": "warning", "info": "note"}[finding.level]
        words = said(finding.message if keys else in_words(finding.message))
        code = when(keys and finding.path, " ", piece("code", finding.path or ""))
        items.append((text(piece("grade", told(f"level/{finding.level}"), grade)), text(words, code)))
    return blocks.Definitions("findings", items)


def figure_of(number: int, sheet: Sheet) -> blocks.Figure:
    """Draw a sheet, each panel by itself, because a page may end between two panels."""
    drawings = [blocks.Svg(inline_svg(panel)) for panel in sheet.panels]
    return blocks.Figure(number, drawings, said(sheet.title), said(in_words(sheet.caption)))


def _three(share: float) -> str:
    """Share of a limit to three digits, or to more digits if three would show 1."""
    return localized(next((shown for digits in range(3, 10) if float(shown := f"{share:.{digits}g}") != 1), "1"))


def _changed(overrides: Iterable[str]) -> list[str]:
    """Paths of the keys, or tables, that overrides change."""
    given = (override.partition("=")[0].strip() for override in overrides)
    return [path_of(name) or name for name in given]


def _entries(subject: Subject) -> blocks.Entries:
    """Entries of the title block: given entries and those of every report; ISO dates become dates of the language."""
    spec = subject.dossier.spec
    title = subject.title | {"variant": translate(spec.variant, "value"), "program": _PROGRAM}
    with suppress(ValueError):
        title["date"] = date.fromisoformat(title["date"]).strftime(translate("%Y-%m-%d", "date"))
    entries = [name for name in form().entries if title[name] or name in form().signed]
    changed = "; ".join(name_of(path) if path in keys() else path for path in _changed(subject.overrides))
    long = {
        say("Spec"): printable(spec.label),
        say("SHA-256 of the spec as given"): spec.label.digest,
        say("Overridden on the command line"): printable(changed),
    }
    given = [(told(name), title[name], False) for name in entries]
    return blocks.Entries([*given, *((name, value, True) for name, value in long.items() if value)])


def _signatures(title: Mapping[str, str]) -> blocks.Table:
    """Table of signatures: all roles that sign in this language, and other roles for which a name is given."""
    roles = [who for who in PEOPLE if title[who] or who in form().signed]
    rows = [[text(told(who)), text(title[who]), text(), text()] for who in roles]
    return table("signatures", ("Responsible", "Name", "Signature", "Date"), rows)


def _frame(title: Mapping[str, str], headline: str) -> dict[str, Any]:
    roles = {"Drawn": "author", "Checked": "checked", "": "", "Standards": "norm_control", "Approved": "approved"}
    margin = "Signature and date", "No. of copy", "Instead of no.", "Signature and date", "No. of original"
    return {name: title[name] for name in ("drawing", "organisation", "revision")} | {
        "headline": headline,
        "people": [(translate(role), title.get(who, "")) for role, who in roles.items()],
        "changes": [*map(translate, ("Chg.", "Sheet", "Document no.", "Sign.", "Date"))],
        "stage": [*map(translate, ("Stage", "Sheet", "Sheets"))],
        "margin": [*map(translate, margin)],
    }


def _with_frictions(spec: Spec) -> dict[str, Any]:
    """Return the data of a spec with its friction ranges in full, even if they follow from materials."""
    data: dict[str, Any] = resolved(spec)
    own, friction = data["friction"], spec.friction
    if friction.unlike:
        for name, block in (("driving", friction.driving), ("driven", friction.driven)):
            own |= {name: block.range._asdict() | own[name]} if block else {}
    else:
        data["friction"] = friction.range._asdict() | own
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


def _scatter(group: str, name: str, given: dict[str, Any]) -> _SpecLine:
    """Show a distribution of [tolerance.fields]: its kind, then its numbers in the unit of the key that scatters."""
    quantity, key = scatter_at(name), keys().get(name)
    unit = quantity.unit if quantity else ""
    kind = worded(given.pop("distribution"))
    numbers = [f"{translate(part, 'value')} {display(value, unit)}" for part, value in given.items()]
    # a spread in percent has no further unit
    shown_unit = "" if all(isinstance(value, str) for value in given.values()) else display_unit(unit)
    symbol, about = "f", translate("scatter of the friction in service")
    if key:
        symbol = key.symbol or ""
        about = say("scatter: {about}", about=name_of(name))
    value = (", " if spoken() == "en" else "; ").join([kind, *numbers])
    return _SpecLine(group, f"tolerance.fields.{name}", symbol, about, value, shown_unit, False)
