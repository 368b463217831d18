"""The handbook as a document: Markdown that includes formulas, misprints, figures and lists from the program."""

import re
from collections.abc import Callable, Iterator, Sequence

from markdown_it import MarkdownIt
from markdown_it.token import Token

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
from .blocks import Block, Document, Piece, Text, listed, piece, text, when
from .formulas import broken, equated, formula
from .html import page
from .page import figure_of
from .pieces import said
from .title import today


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
        self.lists: dict[str, Callable[[], blocks.Table]] = {
            "notation": self._notation,
            "claims": self._claims,
            "misprints": _misprints,
            "references": _references,
        }
        self.parts: list[tuple[int, str, list[Token]]] = []
        for number, words in handbook.chapters.items():
            head, _, body = words.partition("\n")
            tokens = parser.parse(body)
            shown = [name for kind, name in _directives(tokens) if kind == "equation"]
            self.numbers |= {name: f"{number}.{count}" for count, name in enumerate(shown, 1)}
            self.parts.append((number, head.removeprefix("# "), tokens))

    def chapters(self) -> list[blocks.Section]:
        """Lay out every chapter; the number of a chapter is in the name of its file."""
        return [
            blocks.Section(f"chapter-{number}", str(number), said(title), self._chapter(number, tokens))
            for number, title, tokens in self.parts
        ]

    def _chapter(self, number: int, tokens: list[Token]) -> list[Block]:
        """Lay out a chapter: the text before its first section, then its sections."""
        before: list[Block] = []
        sections: list[blocks.Section] = []
        body = before
        left = iter(tokens)
        for token in left:
            if token.type == "heading_open":
                body, count = [], len(sections) + 1
                title = self._inline(next(left))
                sections.append(blocks.Section(f"section-{number}-{count}", f"{number}.{count}", title, body))
                next(left)
            else:
                body += self._blocks(token, left)
        return [*before, *sections]

    def _blocks(self, token: Token, left: Iterator[Token]) -> Iterator[Block]:
        """Lay out the block that begins with ``token``; the other tokens of the block are taken from ``left``."""
        if token.type == "inline":
            found = _blocks_of(token)
            yield from (self._block(*each) for each in found)
            if not found:
                yield blocks.Paragraph(self._inline(token))
        elif token.type == "fence":
            lines = [*map(said, token.content.splitlines())]
            yield blocks.Code(token.content) if token.info == "sh" else blocks.Bullets(lines, "derivation")
        elif token.type == "bullet_list_open":
            yield blocks.Bullets([*map(self._inline, _until("bullet_list_close", left))])
        elif token.type == "table_open":
            rows: list[int] = []
            cells = [*map(self._inline, _until("table_close", left, rows))]
            head, *others = [cells[start:end] for start, end in zip(rows, [*rows[1:], None], strict=True)]
            yield blocks.Table("", text(), head, others)

    def _block(self, kind: str, name: str) -> Block:
        if kind == "equation":
            return self._formula(self.handbook.formulas[name])
        if kind == "misprint":
            return _misprint(next(entry for entry in misprints() if entry.id == name))
        if kind in ("figure", "plot"):
            self.figures += 1
            sheet = SCHEMES[name]() if kind == "figure" else sheet_of(name.split()[0], self.handbook.plots[name])
            return figure_of(self.figures, sheet)
        if kind == "mend":
            return _mended_by(name)
        return self.lists[name]()

    def _formula(self, entry: Entry) -> blocks.Step:
        """Lay out a formula: meanings of its symbols, example, sources, proofs, and the commands that calculate it."""
        equation = entry.equation
        symbol = symbol_tree(equation.result.symbol)
        source = self._linked(translate(equation.source).rstrip("."), equation.name)
        what = [
            text(_strong(said(equation.result.symbol))),
            said(translate(equation.about)),
            when(source, piece("sources", text("[", source, "]"))),
        ]
        lines = []
        if entry.worked:
            example = piece("soft", say("In numbers, example:{example}", example=entry.example))
            value = value_tree(measured(entry.value, equation.result.unit))
            lines = [([text(example)], [formula(broken(equated(symbol, entry.worked, value)))])]
        notes = []
        if validity := translate(equation.validity):
            notes.append(text(_strong(say("Validity:")), " ", self._linked(validity, equation.name)))
        notes += [
            text(
                *(
                    _strong(say("Printed:")),
                    " ",
                    said(worded(place.id)),
                    ": ",
                    said(worded(place.printed or ""), False),
                ),
                f" ({place.misprint})",
            )
            for place in entry.printed
            if place.status == "mended"
        ]
        proofs = when(entry.proofs, _strong(say("Proved by:")), " ", _codes(entry.proofs), "; ")
        commands = _codes(entry.commands) if entry.commands else text(say("no command"))
        by = text(_strong(say("Calculated by:")), " ", commands, "; ")
        notes.append(text(proofs, by, _strong(say("Function:")), " ", piece("code", equation.name)))
        return blocks.Step(
            what=listed(what, " "),
            number=self.numbers[equation.name],
            formula=formula(broken(equated(symbol, entry.formula))),
            where=[_term(term.symbol, term.meaning, typeset(term.unit)) for term in equation.arguments.values()],
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

    def _inline(self, token: Token) -> Text:
        """Typeset a line of Markdown."""
        levels: list[list[str | Piece | Text]] = [[]]
        for child in token.children or []:
            if child.type == "em_open":
                levels.append([])
            elif child.type == "em_close":
                inner = levels.pop()
                levels[-1].append(piece("em", text(*inner)))
            elif child.type == "code_inline":
                levels[-1].append(piece("code", child.content))
            else:
                levels[-1].append(" " if child.type == "softbreak" else self._text(child.content))
        return text(*levels[0])

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
        meant = [(term.symbol, translate(term.meaning), typeset(term.unit)) for term in terms if term.meaning]
        rows = {(name, meaning, translate(unit, "unit")) for name, meaning, unit in meant}
        rows_in_order = sorted(rows, key=lambda row: (row[0].casefold(), *row))
        return _table(("Symbol", "Quantity", "Unit"), [[*map(said, row)] for row in rows_in_order])

    def _claims(self) -> blocks.Table:
        rows = [
            [
                text(row.id),
                *(said(worded(each)) for each in (row.source, row.inputs)),
                said(worded(row.printed), ours=False),
                said(worded(row.computed)),
                said(worded(row.verdict) + (f" ({worded(row.correction)})" if row.correction else "")),
                said(worded(row.why)),
            ]
            for row in self.handbook.claims
        ]
        heads = "No.", "Source", "Inputs", "Printed", "Computed", "Verdict", "Why"
        return _table(heads, rows, role="claims", named=True)


def _strong(words: str | Text) -> Piece:
    return piece("b", words)


def _codes(names: Sequence[str]) -> Text:
    return listed([piece("code", name) for name in names])


def _term(symbol: str, meaning: str, unit: str) -> Text:
    """Text with a symbol, its meaning and its unit."""
    means = when(meaning, " – ", said(translate(meaning)))
    return text(_strong(said(symbol)), means, f", {translate(unit, 'unit')}" if unit not in ("1", "") else "")


def _misprint(entry: Misprint) -> blocks.Step:
    """Lay out a misprint: the printed text, the correct text, and the reason."""
    status = [translate(entry.status, "value") + (f" {entry.repeats}" if entry.repeats else "")]
    status += [translate(entry.certainty, "value")] if entry.certainty != entry.status else []
    quote = when(entry.quote, piece("q", said(entry.quote or "", False)))
    printed = [text(_strong(say("Printed") + ":")), said(translate(entry.printed), False), quote]
    reading = when(entry.reading, ". ", _strong(say("Right if read as:")), " ", said(translate(entry.reading or "")))
    notes = [
        listed(printed, " "),
        *([text(_strong(say("Should be:")), " ", said(translate(entry.correct)))] if entry.correct != "–" else []),
        text(_strong(say("Why") + ":"), " ", said(translate(entry.why)), reading),
    ]
    what = text(_strong(entry.id), " ", said(translate(entry.where)), " ", piece("sources", f"[{'; '.join(status)}]"))
    return blocks.Step(what, notes=notes, key=entry.id)


_INLINE = re.compile(r"\{(see|value) ([^{}]+)\}")
_NAMED = re.compile("``([a-z_.]+)``")
_BLOCK = re.compile(r"\{(equation|misprint|figure|plot|list|mend) ([^{}]+)\}")


def _blocks_of(token: Token) -> list[tuple[str, str]]:
    """Kind and name of each directive in a paragraph of directives; empty for a paragraph of prose."""
    lines = [_BLOCK.fullmatch(line.strip()) for line in token.content.splitlines()]
    return [(line[1], line[2]) for line in lines if line] if all(lines) else []


def _directives(tokens: list[Token]) -> Iterator[tuple[str, str]]:
    return (pair for token in tokens if token.type == "inline" for pair in _blocks_of(token))


def _until(end: str, left: Iterator[Token], rows: list[int] | None = None) -> list[Token]:
    """Take tokens up to the type ``end``; return the inline tokens; append to ``rows`` how many precede each row."""
    texts: list[Token] = []
    for token in left:
        if token.type == end:
            break
        if token.type == "tr_open" and rows is not None:
            rows.append(len(texts))
        texts += [token] if token.type == "inline" else []
    return texts


def _table(
    heads: Sequence[str], rows: Sequence[Sequence[Text]], *, role: str = "", named: bool = False
) -> blocks.Table:
    return blocks.Table(role, text(), [text(translate(head)) for head in heads], rows, named=named)


def _mended_by(ways: str) -> blocks.Paragraph:
    """Lay out the spec keys whose change clears a finding, each with its direction: larger, smaller or either."""
    about, pairs = ways_in(ways)
    own = when(about, piece("code", about), ": ")
    return blocks.Paragraph(text(own, listed([text(_ARROWS[way], "\xa0", piece("code", path)) for path, way in pairs])))


_ARROWS = {"+": "↑", "-": "↓", "±": "↕"}


def _misprints() -> blocks.Table:
    rows = [
        [text(piece("link", entry.id, entry.id)), said(translate(entry.where)), text(translate(entry.status, "value"))]
        for entry in misprints()
    ]
    return _table(("No.", "Where", "Kind"), rows)


def _references() -> blocks.Table:
    rows = [[text(name), said(source)] for name, source in references().items() if name != "handbook"]
    return _table(("Cited as", "Source"), rows, named=True)  # without the handbook, which does not cite itself
