"""The handbook as one page: Markdown with formulas, misprints, figures and lists of the program in it."""

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

from markdown_it import MarkdownIt
from markdown_it.token import Token
from markupsafe import Markup, escape

from .. import __version__
from ..analysis.handbook import Entry, Handbook
from ..messages import spoken, told, translate
from ..papers.register import misprints, references
from ..units import typeset
from .plot import sheet_of
from .plot.figure import inline_svg
from .plot.schemes import SCHEMES
from .report.chapters import broken, math
from .report.markup import drawing, symbol
from .report.page import template
from .symbols import value_latex
from .units import measured, worded

Table = tuple[tuple[str, ...], Sequence[tuple[str, ...]], str]
"""Headings, rows, and what the first cell is: ``id`` that links lead to, ``link``, or nothing."""


@dataclass
class _Chapter:
    """One chapter: its number is in the name of its file."""

    number: int
    title: str
    tokens: list[Token]
    sections: list[tuple[str, str]] = field(default_factory=list)
    """Anchor and heading of each section."""
    html: Markup = Markup()


def render(handbook: Handbook) -> str:
    """Write the page; the same program gives the same text."""
    page = _Page(handbook)
    for chapter in page.chapters:
        chapter.html = page.set(chapter)
    return template("handbook.html").render(
        chapters=page.chapters, language=spoken(), version=__version__, running=told("Handbook"), paper="plain"
    )


class _Page:
    """The chapters, with the number of every formula in them."""

    def __init__(self, handbook: Handbook) -> None:
        parser = MarkdownIt("commonmark", {"html": False}).enable("table")
        self.handbook, self.numbers, self.figures = handbook, dict[str, str](), 0
        self.lists: dict[str, Callable[[], Table]] = {
            "notation": self._notation,
            "claims": self._claims,
            "misprints": _misprints,
            "references": _references,
        }
        self.chapters = []
        for number, text in handbook.chapters.items():
            head, _, body = text.partition("\n")
            chapter = _Chapter(number, head.removeprefix("# "), parser.parse(body))
            shown = [name for kind, name in _directives(chapter.tokens) if kind == "equation"]
            self.numbers |= {name: f"{number}.{count}" for count, name in enumerate(shown, 1)}
            self.chapters.append(chapter)
        parser.add_render_rule("text", lambda _, tokens, place, *more: self._text(tokens[place]))
        parser.add_render_rule("fence", lambda _, tokens, place, *more: self._fence(tokens[place]))
        parser.add_render_rule("table_open", lambda *_: '<div class="scroll"><table>')
        parser.add_render_rule("table_close", lambda *_: "</table></div>")
        self._parser = parser

    def set(self, chapter: _Chapter) -> Markup:
        """Set a chapter; its sections are collected on the way."""
        tokens = chapter.tokens
        for place, token in enumerate(tokens):
            if token.type == "heading_open":
                anchor = f"section-{chapter.number}-{len(chapter.sections) + 1}"
                token.attrSet("id", anchor)
                chapter.sections.append((anchor, tokens[place + 1].content))
                token.tag = tokens[place + 2].tag = "h3"
            elif token.type == "inline" and (found := _blocks_of(token)):
                html = Markup("\n").join(self._block(kind, name) for kind, name in found)
                tokens[place] = Token("html_block", "", 0, content=str(html))
                tokens[place - 1].hidden = tokens[place + 1].hidden = True
        return Markup(self._parser.renderer.render(tokens, self._parser.options, {}))  # noqa: S704 our own prose, without HTML

    def _block(self, kind: str, name: str) -> Markup:
        macros: Any = template("blocks.html").module
        if kind == "equation":
            return macros.formula(self.numbers[name], *self._formula(self.handbook.formulas[name]))
        if kind == "misprint":
            return macros.misprint(next(entry for entry in misprints() if entry.id == name))
        if kind in ("figure", "plot"):
            self.figures += 1
            sheet = SCHEMES[name]() if kind == "figure" else sheet_of(name.split()[0], self.handbook.plots[name])
            return macros.figure(self.figures, sheet, drawing(inline_svg(sheet), sheet.title, self.figures))
        return macros.table(*self.lists[name]())

    def _formula(self, entry: Entry) -> tuple[Any, ...]:
        """The formula, and what the macro has beside it: MathML, what its symbols are, source and validity."""
        equation = entry.equation
        value = value_latex(measured(entry.value, equation.result.unit))
        return (
            entry,
            math(broken(entry.latex)),
            math(broken(f"{entry.worked} = {value}")) if entry.worked else "",
            [(term.symbol, term.meaning, typeset(term.unit)) for term in equation.arguments.values()],
            self._linked(translate(equation.source).rstrip("."), equation.name),
            self._linked(translate(equation.validity), equation.name),
        )

    def _linked(self, text: str, of: str) -> Markup:
        """Set a text of a docstring: a function that it names becomes the number of its formula."""
        pieces: list[Markup] = []
        for place, piece in enumerate(_NAMED.split(text)):
            name = piece if "." in piece else f"{of.partition('.')[0]}.{piece}"
            pieces.append(self._see(name) if place % 2 and name in self.numbers else symbol(piece))
        return Markup("").join(pieces)

    def _text(self, token: Token) -> str:
        pieces = _INLINE.split(token.content)
        shown = [symbol(pieces[0])]
        for kind, name, text in zip(pieces[1::3], pieces[2::3], pieces[3::3], strict=True):
            shown += [
                self._see(name) if kind == "see" else escape(measured(*self.handbook.values[name])),
                symbol(text),
            ]
        return str(Markup("").join(shown))

    def _see(self, name: str) -> Markup:
        link = Markup('<a href="#{}">{}</a>').format
        if name in self.numbers:
            return link(f"formula-{self.numbers[name]}", f"({self.numbers[name]})")
        if name.isdecimal():
            return link(f"chapter-{name}", told("chapter {number}", number=name))
        return link(name, name if re.fullmatch(r"[MP]\d+", name) else f"[{name}]")

    def _fence(self, token: Token) -> str:
        if token.info == "sh":
            return str(Markup("<pre><code>{}</code></pre>").format(token.content))
        lines = (Markup("<p>{}</p>").format(symbol(line)) for line in token.content.splitlines())
        return str(Markup('<div class="derivation">{}</div>').format(Markup("").join(lines)))

    def _notation(self) -> Table:
        equations = (entry.equation for entry in self.handbook.formulas.values())
        terms = (term for each in equations for term in (*each.arguments.values(), each.result))
        meant = [(term.symbol, translate(term.meaning), typeset(term.unit)) for term in terms if term.meaning]
        rows = {(name, meaning, translate(unit, "unit")) for name, meaning, unit in meant}
        rows_in_order = sorted(rows, key=lambda row: (row[0].casefold(), *row))
        return tuple(map(translate, ("Symbol", "Quantity", "Unit"))), rows_in_order, ""

    def _claims(self) -> Table:
        rows = [
            (
                row.id,
                *map(worded, (row.source, row.inputs)),
                symbol(worded(row.printed), ours=False),
                worded(row.computed),
                worded(row.verdict) + (f" ({worded(row.correction)})" if row.correction else ""),
                worded(row.why),
            )
            for row in self.handbook.claims
        ]
        return tuple(map(translate, ("No.", "Source", "Inputs", "Printed", "Computed", "Verdict", "Why"))), rows, "id"


_INLINE = re.compile(r"\{(see|value) ([^{}]+)\}")
_NAMED = re.compile("``([a-z_.]+)``")
_BLOCK = re.compile(r"\{(equation|misprint|figure|plot|list) ([^{}]+)\}")


def _blocks_of(token: Token) -> list[tuple[str, str]]:
    """What the program puts in the place of a paragraph; nothing where it is one of prose."""
    lines = [_BLOCK.fullmatch(line.strip()) for line in token.content.splitlines()]
    return [(line[1], line[2]) for line in lines if line] if all(lines) else []


def _directives(tokens: list[Token]) -> Iterator[tuple[str, str]]:
    return (pair for token in tokens if token.type == "inline" for pair in _blocks_of(token))


def _misprints() -> Table:
    rows = [(entry.id, translate(entry.where), translate(entry.status, "value")) for entry in misprints()]
    return tuple(map(translate, ("No.", "Where", "Kind"))), rows, "link"


def _references() -> Table:
    rows = [entry for entry in references().items() if entry[0] != "handbook"]  # it does not cite itself
    return tuple(map(translate, ("Cited as", "Source"))), rows, "id"
