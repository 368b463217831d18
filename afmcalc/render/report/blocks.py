"""A document for people as typed blocks: its content, before it is set as a page or on sheets of paper."""

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Any, Literal

from ...errors import AfmcalcError
from ...formula_tree import TIMES, Node, Tree
from ...formula_tree import text as line_of

SHORT = 64
"""Largest number of signs in a line of a formula."""


@dataclass(frozen=True)
class Piece:
    """A part of a text with its own markup, or a link."""

    kind: Literal["sub", "sup", "b", "em", "q", "code", "soft", "sources", "grade", "link"]
    body: "Text"
    to: str = ""
    """Target of a link, or the name of a grade."""


class Text(tuple["str | Piece", ...]):
    """A text in pieces."""

    def __str__(self) -> str:
        """Return the text without its markup."""
        return "".join(each if isinstance(each, str) else str(each.body) for each in self)


def text(*parts: "str | Piece | Text") -> Text:
    """Join texts and pieces.

    >>> text("a", text("b", piece("sub", "c")))
    ('ab', Piece(kind='sub', body=('c',), to=''))
    """
    joined: list[str | Piece] = []
    for part in parts:
        for each in part if isinstance(part, Text) else (part,):
            if isinstance(each, str) and joined and isinstance(joined[-1], str):
                joined[-1] += each
            elif each:
                joined.append(each)
    return Text(joined)


def piece(kind: Any, body: "str | Text", to: str = "") -> Piece:
    """Build a piece: a text with its own markup, or a link."""
    return Piece(kind, text(body), to)


def when(there: object, *parts: "str | Piece | Text") -> Text:
    """Join texts if ``there`` is true; otherwise return an empty text."""
    return text(*parts) if there else Text()


def listed(parts: "Sequence[str | Piece | Text]", sign: str = ", ") -> Text:
    """Join texts with a sign between them; empty texts are left out."""
    shown = [part for part in parts if part]
    return text(*[each for part in shown for each in (sign, part)][1:])


@dataclass(frozen=True)
class Formula:
    """Formula as a tree, and as a line of text for screen readers."""

    tree: Tree
    alt: str


def formula(*sides: Tree) -> Formula:
    """Equation with two or more sides.

    >>> formula(("F",), (Node("fraction", parts=(("a", "b"), ("c",))),)).alt
    'F = ab/c'
    """
    tree = equated(*sides)
    return Formula(tree, line_of(tree))


def equated(*sides: Tree) -> Tree:
    """Tree of the sides of an equation, joined by equals signs."""
    return tuple(sign for side in sides for sign in ("=", *side))[1:]


def size(tree: Tree) -> int:
    """Approximate number of signs in a formula."""
    return sum(len(node) if isinstance(node, str) else len(node.text) + sum(map(size, node.parts)) for node in tree)


def broken(tree: Tree, most: int = SHORT) -> Tree:
    """Break a sum or product longer than ``most`` into lines, as MathML breaks no formula and paper does not scroll."""
    if size(tree) <= most:
        return tree
    rows: list[Tree] = [()]
    for node in tree:
        if rows[-1] and (node in ("+", "−") or (node in ("·", TIMES) and size(rows[-1]) > most / 2)):
            rows.append(())
        rows[-1] += (node,)
    return (Node("rows", parts=tuple(rows)),) if len(rows) > 1 else tree


@dataclass(frozen=True)
class Paragraph:
    """A paragraph; its ``role`` is empty, ``note``, or ``sum`` followed by the grade of a verdict."""

    text: Text
    role: str = ""
    key: str = ""


@dataclass(frozen=True)
class Heading:
    """A heading without a number, one level below the heading of its section."""

    level: int
    text: Text


@dataclass(frozen=True)
class Table:
    """A table; a row of one cell is a heading for the rows below it. Links lead to the caption of a numbered table.

    A table with the ``role`` "signatures" has empty cells in which people sign.
    """

    role: str
    title: Text
    head: Sequence[Text]
    rows: Sequence[Sequence[Text]]
    numeric: Sequence[bool] = ()
    """For each column True if it is set flush right."""
    number: int = 0
    named: bool = False
    """True if links lead to rows, named by the text of the first cell."""


@dataclass(frozen=True)
class Figure:
    """Drawings, one below the other."""

    number: int
    drawings: "Sequence[Svg]"
    title: Text
    caption: Text


class Svg(str):
    """A drawing as SVG."""


@dataclass(frozen=True)
class Step:
    """A quantity as an engineer writes it: formula, meanings of its symbols, numbers put in, notes."""

    what: Text
    number: str = ""
    """Number of the formula, to which links lead; empty if the formula is not printed here."""
    formula: Formula | None = None
    where: Sequence[Text] = ()
    lined: bool = False
    """True if each symbol is explained on its own line."""
    head: Sequence[Text] = ()
    """Headings for the columns of labels and for the numbers; only if there are several columns of labels."""
    lines: Sequence[tuple[Sequence[Text], Sequence[Formula]]] = ()
    """For each case its labels, and the formulas with numbers and with the value; a line may end between formulas."""
    notes: Sequence[Text] = ()
    key: str = ""
    """Anchor to which links lead if the formula has no number."""


@dataclass(frozen=True)
class Bullets:
    """A list, or the lines of a ``derivation``."""

    items: Sequence[Text]
    role: str = ""


@dataclass(frozen=True)
class Definitions:
    """Symbols and their meanings, sources by their numbers, or findings after their grades."""

    role: Literal["symbols", "references", "findings"]
    items: Sequence[tuple[Text, Text]]


@dataclass(frozen=True)
class Code:
    """A text of a file or a command line, unchanged."""

    code: str


@dataclass(frozen=True)
class Entries:
    """Entries of a title block: name, value, and a flag that is True for a long value."""

    items: Sequence[tuple[str, str, bool]]


@dataclass(frozen=True)
class Section:
    """A numbered section, or an appendix with a letter; links lead to its ``key``."""

    key: str
    label: str
    title: Text
    body: "Sequence[Block]"
    appendix: bool = False


Block = Paragraph | Heading | Table | Figure | Step | Bullets | Definitions | Code | Entries | Section


@dataclass(frozen=True)
class Document:
    """A full report, a short report, or the handbook."""

    language: str
    program: str
    kind: str
    name: str
    cover: Sequence[Block]
    body: Sequence[Section]
    running: str
    """Running title of a sheet without frame."""
    date: str
    """Date of the file, ISO 8601."""
    paper: Literal["plain", "framed", "report", "book"] = "plain"
    short: bool = False
    """True if the report is to take two sheets."""
    author: str = ""
    frame: Mapping[str, Any] | None = None
    """Entries of a title block of ГОСТ 2.104, forms 2 and 2а, for sheets with a frame."""


def today() -> str:
    """Today's date, or the date in SOURCE_DATE_EPOCH, which makes a build repeatable."""
    epoch = os.environ.get("SOURCE_DATE_EPOCH", "")
    if not epoch:
        return datetime.now().date().isoformat()
    if not epoch.isdecimal() or len(epoch) > 11:  # enough digits up to the year 5000
        raise AfmcalcError("SOURCE_DATE_EPOCH = {epoch!r:.40}: seconds since 1970 are wanted", epoch=epoch)
    return datetime.fromtimestamp(int(epoch), UTC).date().isoformat()


def data_of(block: Any) -> dict[str, Any]:
    """Block or formula as an object of JSON; ``kind`` is its type."""
    return {"kind": type(block).__name__.lower()} | vars(block)
