"""A document for people as typed blocks: what it says, before it is set as a page or on sheets of paper."""

from collections.abc import Sequence
from dataclasses import dataclass, fields, is_dataclass
from typing import Any, Literal

from .formulas import Formula


@dataclass(frozen=True)
class Piece:
    """A part of a text that is set apart, or leads somewhere."""

    kind: Literal["sub", "sup", "b", "em", "q", "code", "soft", "sources", "grade", "link"]
    body: "Text"
    to: str = ""
    """Target of a link; the kind of a grade."""


class Text(tuple["str | Piece", ...]):
    """A text in pieces."""

    def __str__(self) -> str:
        """Return its letters alone."""
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
    """Set a text apart."""
    return Piece(kind, text(body), to)


def when(there: object, *parts: "str | Piece | Text") -> Text:
    """Join texts where there is something to tell, else none."""
    return text(*parts) if there else Text()


def listed(parts: "Sequence[str | Piece | Text]", sign: str = ", ") -> Text:
    """Join texts with a sign between them; empty ones are left out."""
    shown = [part for part in parts if part]
    return text(*[each for part in shown for each in (sign, part)][1:])


@dataclass(frozen=True)
class Paragraph:
    """A paragraph; its ``role`` is ``note``, ``sum`` and a grade of a verdict, or nothing."""

    text: Text
    role: str = ""
    key: str = ""


@dataclass(frozen=True)
class Heading:
    """A heading without a number, below that of its section."""

    level: int
    text: Text


@dataclass(frozen=True)
class Table:
    """A table: a row of one cell heads the rows below it. One that has a number has a caption that links lead to.

    That of the ``role`` signatures has cells to sign: who answers for what.
    """

    role: str
    title: Text
    head: Sequence[Text]
    rows: Sequence[Sequence[Text]]
    numeric: Sequence[bool] = ()
    """True if each column is set flush right."""
    number: int = 0
    named: bool = False
    """True if links lead to the rows, by what stands in the first cell."""


@dataclass(frozen=True)
class Figure:
    """Drawings, one below the other."""

    number: int
    drawings: "Sequence[Drawing]"
    title: Text
    caption: Text


@dataclass(frozen=True)
class Drawing:
    """A drawing as SVG."""

    svg: str


@dataclass(frozen=True)
class Step:
    """A quantity as an engineer writes it: formula, what its symbols are, numbers put in, notes."""

    what: Text
    number: str = ""
    """Of its formula, where that stands here; links lead to it."""
    formula: Formula | None = None
    where: Sequence[Text] = ()
    lined: bool = False
    """True if each symbol is explained on a line of its own."""
    head: Sequence[Text] = ()
    """Of the labels and the numbers, where there are several labels."""
    lines: Sequence[tuple[Sequence[Text], Sequence[Formula]]] = ()
    """Labels, and numbers put in with what comes out, between which a line may end."""
    notes: Sequence[Text] = ()
    key: str = ""
    """Anchor that links lead to, where that is no formula."""


@dataclass(frozen=True)
class Findings:
    """Findings, each with its grade."""

    items: Sequence[tuple[Piece, Text]]


@dataclass(frozen=True)
class Bullets:
    """A list, or the lines of a ``derivation``."""

    items: Sequence[Text]
    role: str = ""


@dataclass(frozen=True)
class Definitions:
    """Symbols and what they are (``symbols``), or sources by their numbers (``references``)."""

    role: Literal["symbols", "references"]
    items: Sequence[tuple[Text, Text]]


@dataclass(frozen=True)
class Code:
    """A text of a file or command line, as it is."""

    code: str


@dataclass(frozen=True)
class Entries:
    """Entries of a title block: name, value, and whether that is long."""

    items: Sequence[tuple[str, str, bool]]


@dataclass(frozen=True)
class Section:
    """A numbered section, or an appendix under a letter; links lead to its key."""

    key: str
    label: str
    title: Text
    body: "Sequence[Block]"
    appendix: bool = False


Block = Paragraph | Heading | Table | Figure | Step | Findings | Bullets | Definitions | Code | Entries | Section


@dataclass(frozen=True)
class Document:
    """A report, short or not, or the handbook."""

    language: str
    program: str
    kind: str
    name: str
    cover: Sequence[Block]
    body: Sequence[Section]
    running: str
    """Running title of a sheet that has no frame."""
    date: str
    """Day of the file, ISO 8601."""
    contents: bool = True
    paper: Literal["plain", "framed", "report", "book"] = "plain"
    short: bool = False
    """True if it is to be two sheets."""
    author: str = ""
    frame: "Frame | None" = None
    """Title block of sheets that have a frame."""


@dataclass(frozen=True)
class Frame:
    """Entries of a title block of ГОСТ 2.104, forms 2 and 2а."""

    headline: str
    drawing: str
    organisation: str
    revision: str
    people: Sequence[tuple[str, str]]
    """Role and name, row for row."""
    changes: Sequence[str]
    """Heads of the columns of changes."""
    stage: Sequence[str]
    margin: Sequence[str]
    """Heads of the cells in the left margin, from the top."""


def data_of(node: Any) -> Any:
    """Return a document as data of JSON: a block says what it is in ``kind``."""
    if is_dataclass(node):
        return {"kind": type(node).__name__.lower()} | {
            field.name: data_of(getattr(node, field.name)) for field in fields(node)
        }
    return [data_of(each) for each in node] if isinstance(node, list | tuple) else node
