"""The handbook as a document: Markdown that includes formulas, misprints, figures and lists from the program."""

import re
from collections.abc import Sequence

from markdown_it import MarkdownIt
from markdown_it.tree import SyntaxTreeNode

from ... import __version__
from ...analysis.handbook_content import Entry, Handbook
from ...formula_tree import symbol_tree, value_tree
from ...messages import say, spoken, translate
from ...papers.handbook_text import ways_in
from ...papers.register import Misprint, misprints, references
from ...units import typeset
from ..amounts import measured, worded
from ..plot import sheet_of
from ..plot.schemes import SCHEMES
from . import blocks
from .blocks import Block, Document, Piece, Text, broken, equated, formula, listed, piece, text, today, when
from .chapters import explained
from .html import page
from .page import figure_of
from .pieces import said, table

_INLINE = re.compile(r"\{(see|value) ([^{}]+)\}")
_NAMED = re.compile("``([a-z_.]+)``")
_BLOCK = re.compile(r"\{(equation|misprint|figure|plot|list|mend) ([^{}]+)\}")
_ARROWS = {"+": "↑", "-": "↓", "±": "↕"}


def render(handbook: Handbook) -> str:
    """Write the page; the same program gives the same text."""
    return page(book(handbook))


def book(handbook: Handbook) -> Document:
    """Lay the handbook out."""
    about = say("What afmcalc calculates and why: every formula is set from the function that calculates it.")
    program, name = f"afmcalc {__version__}", say("Handbook")
    cover = [blocks.Paragraph(text(about))]
    return Document(spoken(), program, program, name, cover, _Book(handbook).chapters(), name, today(), paper="book")


class _Book:
    """The chapters, with the number of every formula in them."""

    def __init__(self, handbook: Handbook) -> None:
        parser = MarkdownIt("commonmark", {"html": False}).enable("table")
        self.handbook, self.numbers, self.figures = handbook, dict[str, str](), 0
        self.parts: list[tuple[int, str, list[SyntaxTreeNode]]] = []
        for number, words in handbook.chapters.items():
            head, _, body = words.partition("\n")
            nodes = SyntaxTreeNode(parser.parse(body)).children
            shown = [name for node in nodes for kind, name in _directives(node) if kind == "equation"]
            self.numbers |= {name: f"{number}.{count}" for count, name in enumerate(shown, 1)}
            self.parts.append((number, head.removeprefix("# "), nodes))

    def chapters(self) -> list[blocks.Section]:
        """Lay out every chapter; the number of a chapter is in the name of its file."""
        return [
            blocks.Section(f"chapter-{number}", str(number), said(title), self._chapter(number, nodes))
            for number, title, nodes in self.parts
        ]

    def _chapter(self, number: int, nodes: list[SyntaxTreeNode]) -> list[Block]:
        """Lay out a chapter: the text before its first section, then its sections."""
        body = before = list[Block]()
        sections: list[blocks.Section] = []
        for node in nodes:
            if node.type == "heading":
                body, count = [], len(sections) + 1
                title = self._inline(node)
                sections.append(blocks.Section(f"section-{number}-{count}", f"{number}.{count}", title, body))
            else:
                body += self._blocks(node)
        return [*before, *sections]

    def _blocks(self, node: SyntaxTreeNode) -> list[Block]:
        """Lay out a block of Markdown."""
        match node.type:
            case "fence" if node.info == "sh":
                return [blocks.Code(node.content)]
            case "fence":
                return [blocks.Bullets([*map(said, node.content.splitlines())], "derivation")]
            case "bullet_list":
                return [blocks.Bullets([*map(self._inline, node.children)])]
            case "table":
                rows = (row for part in node.children for row in part.children)
                head, *others = ([*map(self._inline, row.children)] for row in rows)
                return [blocks.Table("", text(), head, others)]
        return [self._block(*each) for each in _directives(node)] or [blocks.Paragraph(self._inline(node))]

    def _block(self, kind: str, name: str) -> Block:
        if kind == "equation":
            return self._formula(self.handbook.formulas[name])
        if kind == "misprint":
            return _misprint(next(entry for entry in misprints() if entry.id == name))
        if kind in ("figure", "plot"):
            self.figures += 1
            sheet = SCHEMES[name]() if kind == "figure" else sheet_of(name.split()[0], self.handbook.plots[name])
            return figure_of(self.figures, sheet)
        if kind == "mend":  # the keys whose change clears a finding, each with its direction: larger, smaller or either
            about, pairs = ways_in(name)
            ways = listed([text(_ARROWS[way], "\xa0", piece("code", path)) for path, way in pairs])
            return blocks.Paragraph(text(when(about, piece("code", about), ": "), ways))
        return getattr(self, f"_{name}")()

    def _formula(self, entry: Entry) -> blocks.Step:
        """Lay out a formula: meanings of its symbols, example, sources, proofs, and the commands that calculate it."""
        equation = entry.equation
        symbol = symbol_tree(equation.result.symbol)
        source = self._linked(translate(equation.source).rstrip("."), equation.name)
        what: list[Piece | Text] = [piece("b", said(equation.result.symbol)), said(translate(equation.about))]
        what += [piece("sources", text("[", source, "]"))] if source else []
        lines = []
        if entry.worked:
            example = piece("soft", say("In numbers, example:{example}", example=entry.example))
            value = value_tree(measured(entry.value, equation.result.unit))
            lines = [([text(example)], [formula(broken(equated(symbol, entry.worked, value)))])]
        notes = []
        if validity := translate(equation.validity):
            notes.append(_note(say("Validity:"), self._linked(validity, equation.name)))
        for place in entry.printed:
            if place.status == "mended":
                print_of = said(worded(place.id)), ": ", said(worded(place.printed or ""), False)
                notes.append(_note(say("Printed:"), *print_of, f" ({place.misprint})"))
        proofs = when(entry.proofs, _note(say("Proved by:"), _codes(entry.proofs), "; "))
        commands = _codes(entry.commands) if entry.commands else text(say("no command"))
        by, function = _note(say("Calculated by:"), commands, "; "), piece("code", equation.name)
        notes.append(text(proofs, by, _note(say("Function:"), function)))
        return blocks.Step(
            what=listed(what, " "),
            number=self.numbers[equation.name],
            formula=formula(broken(equated(symbol, entry.formula))),
            where=[
                _note(said(term.symbol), "– ", said(explained(term.meaning, term.unit)))
                for term in equation.arguments.values()
            ],
            lines=lines,
            notes=notes,
        )

    def _linked(self, words: str, of: str) -> Text:
        """Typeset a text of a docstring; the name of a function in it becomes the number of the function's formula."""
        pieces: list[Piece | Text] = []
        for place, part in enumerate(_NAMED.split(words)):
            name = part if "." in part else f"{of.partition('.')[0]}.{part}"
            pieces.append(self._see(name) if place % 2 and name in self.numbers else said(part))
        return text(*pieces)

    def _inline(self, node: SyntaxTreeNode) -> Text:
        """Typeset a node of Markdown and its children."""
        match node.type:
            case "text":
                return self._text(node.content)
            case "softbreak":
                return text(" ")
            case "code_inline":
                return text(piece("code", node.content))
        inner = text(*map(self._inline, node.children))
        return text(piece("em", inner)) if node.type == "em" else inner

    def _text(self, content: str) -> Text:
        before, *pieces = _INLINE.split(content)
        shown: list[str | Piece | Text] = [said(before)]
        for kind, name, after in zip(pieces[::3], pieces[1::3], pieces[2::3], strict=True):
            shown += [self._see(name) if kind == "see" else measured(*self.handbook.values[name]), said(after)]
        return text(*shown)

    def _see(self, name: str) -> Piece:
        if name in self.numbers:
            return piece("link", f"({self.numbers[name]})", f"formula-{self.numbers[name]}")
        if name.isdecimal():
            return piece("link", say("chapter {number}", number=name), f"chapter-{name}")
        return piece("link", name if re.fullmatch(r"[MP]\d+", name) else f"[{name}]", name)

    def _notation(self) -> blocks.Table:
        equations = (entry.equation for entry in self.handbook.formulas.values())
        terms = (term for each in equations for term in (*each.arguments.values(), each.result))
        meant = {(each.symbol, translate(each.meaning), translate(typeset(each.unit), "unit")) for each in terms}
        rows = sorted((row for row in meant if row[1]), key=lambda row: (row[0].casefold(), *row))
        return table("", ("Symbol", "Quantity", "Unit"), [[*map(said, row)] for row in rows])

    def _claims(self) -> blocks.Table:
        rows = [
            [
                text(row.id),
                *(said(worded(each)) for each in (row.source, row.inputs)),
                said(worded(row.printed), ours=False),
                said(worded(row.computed)),
                said(f"{worded(row.verdict)} ({worded(row.correction)})" if row.correction else worded(row.verdict)),
                said(worded(row.why)),
            ]
            for row in self.handbook.claims
        ]
        heads = "No.", "Source", "Inputs", "Printed", "Computed", "Verdict", "Why"
        return table("claims", heads, rows, named=True)

    def _misprints(self) -> blocks.Table:
        rows = []
        for each in misprints():
            link, status = text(piece("link", each.id, each.id)), text(translate(each.status, "value"))
            rows.append([link, said(translate(each.where)), status])
        return table("", ("No.", "Where", "Kind"), rows)

    def _references(self) -> blocks.Table:
        rows = [[text(name), said(source)] for name, source in references().items() if name != "handbook"]
        return table("", ("Cited as", "Source"), rows, named=True)  # without the handbook, which does not cite itself


def _note(head: str | Text, *parts: str | Piece | Text) -> Text:
    """Text after a head in bold."""
    return text(piece("b", head), " ", *parts)


def _codes(names: Sequence[str]) -> Text:
    return listed([piece("code", name) for name in names])


def _misprint(entry: Misprint) -> blocks.Step:
    """Lay out a misprint: the printed text, the correct text, and the reason."""
    status = [translate(entry.status, "value") + (f" {entry.repeats}" if entry.repeats else "")]
    status += [translate(entry.certainty, "value")] if entry.certainty != entry.status else []
    quote = when(entry.quote, piece("q", said(entry.quote or "", False)))
    reading = when(entry.reading, ". ", _note(say("Right if read as:"), said(translate(entry.reading or ""))))
    notes = [listed([_note(say("Printed") + ":", said(translate(entry.printed), False)), quote], " ")]
    notes += [_note(say("Should be:"), said(translate(entry.correct)))] if entry.correct != "–" else []
    notes.append(_note(say("Why") + ":", said(translate(entry.why)), reading))
    what = _note(entry.id, said(translate(entry.where)), " ", piece("sources", f"[{'; '.join(status)}]"))
    return blocks.Step(what, notes=notes, key=entry.id)


def _directives(node: SyntaxTreeNode) -> list[tuple[str, str]]:
    """Kind and name of each directive in a paragraph of directives; empty for any other block."""
    lines = node.children[0].content.splitlines() if node.type == "paragraph" else []
    found = [_BLOCK.fullmatch(line.strip()) for line in lines]
    return [(line[1], line[2]) for line in found if line] if all(found) else []
