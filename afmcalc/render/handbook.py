"""The handbook: the theory as one page; its formulas are typeset from the functions that calculate them.

A chapter is a Markdown file of ``afmcalc/papers/handbook``, in Russian the file of the same name in its folder ``ru``.
A paragraph in braces is put in by the program: ``{equation direct.torque}``, ``{misprint M1}``, ``{figure F11-1}``,
``{list notation}``. In a sentence ``{see direct.torque}`` is the number of a formula, a chapter, a paper or a misprint
with a link to it, and ``{value default accuracy.accuracy_factor}`` a number that a command gives for an example. Fenced
lines are steps of a derivation.
"""

import re
import tomllib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cache
from importlib.resources import files
from typing import Any, NamedTuple

from markdown_it import MarkdownIt
from markdown_it.token import Token
from markupsafe import Markup

from .. import __version__
from ..analysis.explain.formula import FormulaText, Leaf, symbol_latex
from ..analysis.explain.trace import Call, CallReader
from ..analysis.registry import ANALYSES, EXPLAINED
from ..engines import build
from ..equations.calls import noted
from ..equations.catalogue import Equation, equations
from ..messages import spoken, told, translate
from ..papers.claims import reproduce
from ..papers.register import misprints, references, register
from ..result import shown_as
from ..spec import Spec, read_spec
from ..units import typeset
from .plot.figure import inline_svg
from .plot.schemes import SCHEMES
from .report.markup import drawing, symbol
from .report.page import template
from .report.chapters import broken, math
from .symbols import value_latex
from .units import measured, worded

_FOLDER = files("afmcalc.papers").joinpath("handbook")
_EXAMPLES = ("default", "unlike-materials", "indirect", "drive", "constant-torque", "tolerance")
"""Examples that the formulas are worked for, the first that has the formula."""


Table = tuple[tuple[str, ...], Sequence[tuple[str, ...]], str]
"""Keys of the headings, rows, and what the first cell is: ``id`` that links lead to, ``link``, or nothing."""


class Card(NamedTuple):
    """A formula as the handbook shows it."""

    number: str
    name: str
    """Of the equation function."""
    symbol: str
    about: str
    source: str
    formula: str
    """MathML."""
    where: list[tuple[str, str, str]]
    """Symbol, meaning and unit of what it is calculated from."""
    worked: str
    """MathML: the numbers of an example put in; empty where no explained command calculates the formula."""
    example: str
    validity: str
    proofs: list[str]
    printed: list[str]
    """What the papers print instead."""
    commands: list[str]
    """Commands that calculate it."""


@dataclass
class Chapter:
    """One chapter: its number is in the name of its file."""

    number: int
    title: str
    tokens: list[Token]
    sections: list[tuple[str, str]] = field(default_factory=list)
    """Anchor and heading of each section."""
    html: Markup = Markup()


def chapter_texts(language: str | None = None) -> dict[int, str]:
    """Markdown of every chapter by its number, in the user's language or the one named."""
    folder = _FOLDER / "ru" if (language or spoken()) == "ru" else _FOLDER
    names = sorted(entry.name for entry in folder.iterdir() if entry.name.endswith(".md"))
    return {int(name[:2]): folder.joinpath(name).read_text(encoding="utf-8") for name in names}


def render() -> str:
    """Write the page; the same program gives the same text."""
    book = _Book(chapter_texts())
    for chapter in book.chapters:
        chapter.html = book.html(chapter)
    return template("handbook.html").render(
        chapters=book.chapters, language=spoken(), version=__version__
    )


class _Book:
    """The chapters, with the number of every formula in them."""

    def __init__(self, texts: dict[int, str]) -> None:
        parser = MarkdownIt("commonmark", {"html": False}).enable("table")
        self.chapters = []
        self.numbers: dict[str, str] = {}
        self._figures = 0
        for number, text in texts.items():
            head, _, body = text.partition("\n")
            chapter = Chapter(number, head.removeprefix("# "), parser.parse(body))
            count = 0
            for kind, name in _directives(chapter.tokens):
                if kind == "equation":
                    count += 1
                    self.numbers[name] = f"{number}.{count}"
            self.chapters.append(chapter)
        self._parser = parser
        parser.renderer.rules |= {
            "text": self._text,
            "fence": self._fence,
            "softbreak": lambda *_: "\n",
        }

    def html(self, chapter: Chapter) -> Markup:
        """Set a chapter; its sections are collected on the way."""
        parts: list[Token] = []
        for token, after in zip(chapter.tokens, [*chapter.tokens[1:], None], strict=True):
            if token.type == "heading_open" and after is not None:
                anchor = f"{chapter.number}-{len(chapter.sections) + 1}"
                token.attrSet("id", f"section-{anchor}")
                token.tag = "h3"
                chapter.sections.append((f"section-{anchor}", after.content))
            token.tag = "h3" if token.type == "heading_close" else token.tag
            parts.append(token)
        for place, token in enumerate(parts):
            if token.type == "inline" and (found := _blocks_of(token)):
                html = Markup("\n").join(self._block(kind, name) for kind, name in found)
                parts[place] = Token("html_block", "", 0, content=str(html))
                parts[place - 1].hidden = parts[place + 1].hidden = True
        return Markup(self._parser.renderer.render(parts, self._parser.options, {}))  # noqa: S704

    def _linked(self, text: str, module: str) -> Markup:
        """Set a text of a docstring: a function that it names becomes the number of its formula."""
        pieces = [symbol(piece) for piece in _NAMED.split(text)]
        names = _NAMED.findall(text)
        full = (name if "." in name else f"{module}.{name}" for name in names)
        pieces[1::2] = [self._see(name) if name in self.numbers else symbol(name) for name in full]
        return Markup("").join(pieces)

    def _block(self, kind: str, name: str) -> Markup:
        macros: Any = template("blocks.html").module
        if kind == "equation":
            shown, module = card(name, self.numbers[name]), name.partition(".")[0]
            return macros.card(shown, self._linked(shown.source, module), self._linked(shown.validity, module))
        if kind == "misprint":
            return macros.misprint(next(entry for entry in misprints() if entry.id == name))
        if kind == "figure":
            self._figures += 1
            sheet = SCHEMES[name]()
            svg = drawing(inline_svg(sheet), sheet.title, self._figures)
            return macros.figure(self._figures, sheet, svg)
        return macros.table(*LISTS[name]())

    def _text(self, tokens: list[Token], place: int, *_: Any) -> str:
        pieces = _INLINE.split(tokens[place].content)
        shown = [symbol(pieces[0])]
        for kind, name, text in zip(pieces[1::3], pieces[2::3], pieces[3::3], strict=True):
            shown += [self._see(name) if kind == "see" else Markup.escape(value(*name.split())), symbol(text)]
        return str(Markup("").join(shown))

    def _see(self, name: str) -> Markup:
        link = Markup('<a href="#{}">{}</a>').format
        if name in self.numbers:
            return link(f"formula-{self.numbers[name]}", f"({self.numbers[name]})")
        if name.isdecimal():
            return link(f"chapter-{name}", told("chapter {number}", number=name))
        return link(name, name if name[0] == "M" and name[1:].isdecimal() else f"[{name}]")

    def _fence(self, tokens: list[Token], place: int, *_: Any) -> str:
        lines = (Markup("<p>{}</p>").format(symbol(line)) for line in tokens[place].content.splitlines())
        return str(Markup('<div class="derivation">{}</div>').format(Markup("").join(lines)))


_INLINE = re.compile(r"\{(see|value) ([^{}]+)\}")
_NAMED = re.compile("``([a-z_.]+)``")
_BLOCK = re.compile(r"\{(equation|misprint|figure|list) ([^{}]+)\}")


def _blocks_of(token: Token) -> list[tuple[str, str]]:
    """What the program puts in the place of a paragraph; nothing where it is one of prose."""
    lines = [_BLOCK.fullmatch(line.strip()) for line in token.content.splitlines()]
    return [(line[1], line[2]) for line in lines if line] if all(lines) else []


def _directives(tokens: list[Token]) -> Iterator[tuple[str, str]]:
    return (pair for token in tokens if token.type == "inline" for pair in _blocks_of(token))


@cache
def _spec(example: str) -> Spec:
    return read_spec(f"example:{example}")


@cache
def _answer(example: str, command: str) -> Any:
    return ANALYSES[command].function(build(_spec(example)))[0]


def value(example: str, path: str) -> str:
    """Return a number that a command gives for an example, with its unit: ``value("default", "torque.torque_max")``."""
    command, *names = path.split(".")
    shown, unit = _answer(example, command), ""
    for name in names:
        if name.isdecimal():
            shown = shown[int(name)]
            continue
        about = shown_as(type(shown).model_fields[name])
        unit = about.unit or unit
        shown = getattr(shown, name)
    return measured(shown, unit)


@cache
def _calls() -> dict[str, tuple[str, Call]]:
    """Equation → the first example that an explained command calculates it for, and its first call there."""
    calls: dict[str, tuple[str, Call]] = {}
    for example in _EXAMPLES:
        for command in EXPLAINED:
            if ANALYSES[command].applies(build(_spec(example))):
                with noted() as notes:
                    ANALYSES[command].function(build(_spec(example)))
                for call in CallReader().calls(notes):
                    calls.setdefault(call.equation.name, (example, call))
    return calls


def card(name: str, number: str) -> Card:
    """Return what the handbook says of a formula."""
    equation, (example, call) = equations()[name], _calls().get(name, ("", None))
    terms, uses = equation.arguments, _uses()[name]
    units = {key: term.unit for key, term in terms.items()}
    symbols = {key: term.symbol for key, term in terms.items()}
    numbers = call.arguments if call else dict.fromkeys(terms, 1.0)
    texts = [FormulaText(part, symbols, numbers, units) for part in _parts(equation)]
    result = symbol_latex(equation.result.symbol)
    worked = ""
    if call and len(texts) == 1:
        shown = value_latex(measured(float(call.value), equation.result.unit))
        worked = math(f"{symbol_latex(call.result)} = {broken(f'{texts[0].latex_with_numbers()} = {shown}')}")
    entries = [entry for entry in register() if entry.function == name]
    return Card(
        number=number,
        name=name,
        symbol=equation.result.symbol,
        about=translate(re.split("[,:;]", equation.summary)[0].rstrip(".")),
        source=translate(equation.source).rstrip("."),
        formula=math(f"{result} = {broken(', '.join(text.latex() for text in texts))}"),
        where=[(term.symbol, translate(term.meaning), translate(typeset(term.unit), "Unit")) for term in terms.values()],
        worked=worked,
        example=example if worked else "",
        validity=translate(equation.validity),
        # the proof of its place in a paper; else those that run it
        proofs=list(dict.fromkeys(entry.proof for entry in entries if entry.proof)) or uses["proofs"][:3],
        printed=[f"{worded(entry.id)}: {worded(entry.printed or '')} ({entry.misprint})" for entry in entries if entry.status == "mended"],
        commands=uses["commands"],
    )


def _parts(equation: Equation) -> list[Callable[..., Any]]:
    """The equation; of one that gives several numbers a function for each."""
    one = equation.function(**{name: Leaf(term.symbol) for name, term in equation.arguments.items()})
    if not isinstance(one, tuple):
        return [equation.function]
    return [lambda place=place, **terms: equation.function(**terms)[place] for place in range(len(one))]


@cache
def _uses() -> dict[str, dict[str, list[str]]]:
    """Equation → commands that calculate it, proofs that run it."""
    return tomllib.loads(_FOLDER.joinpath("uses.toml").read_text(encoding="utf-8"))


def _notation() -> Table:
    terms = (term for equation in equations().values() for term in (*equation.arguments.values(), equation.result))
    rows = {(term.symbol, translate(term.meaning), typeset(term.unit)) for term in terms if term.meaning}
    return ("Symbol", "Quantity", "Unit"), sorted(rows, key=lambda row: (row[0].casefold(), *row)), ""


def _references() -> Table:
    return ("Key", "Source"), list(references().items()), "id"


def _misprints() -> Table:
    rows = [(entry.id, translate(entry.where), translate(entry.status, "value")) for entry in misprints()]
    return ("No.", "Where", "Status"), rows, "link"


def _claims() -> Table:
    rows = [
        (row.id, *map(worded, (row.source, row.inputs, row.printed, row.computed, row.verdict, row.why)))
        for row in reproduce([])[0].rows
    ]
    return ("No.", "Source", "Inputs", "Printed", "Computed", "Verdict", "Why"), rows, "id"


LISTS: dict[str, Callable[[], Table]] = {"notation": _notation, "references": _references, "misprints": _misprints, "claims": _claims}
"""What ``{list NAME}`` puts in: keys of the headings, and rows."""
