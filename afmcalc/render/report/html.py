"""A document as one self-contained HTML page."""

import re
from collections.abc import Iterable, Sequence
from html import escape
from importlib.resources import files

from ...formula_tree import Node, Tree
from ...messages import say
from ..plot.paint import COLOURS, GRID, INK, PAPER, SHADE, WRONG
from . import blocks
from .blocks import Block, Document, Formula, Piece, Section, Text

_APART = ("section", "div", "dl", "ol", "ul", "tr", "tbody")
"""Elements whose parts are each written on their own line."""


def element(tag: str, *body: str, **attributes: object) -> str:
    """HTML of an element; its ``body`` is already markup."""
    given = (
        f' {name.strip("_").replace("_", "-")}="{escape(str(value))}"'
        for name, value in attributes.items()
        if value not in ("", None)
    )
    between = "\n" if tag in _APART else ""
    return f"<{tag}{''.join(given)}>" + between.join(body) + (f"</{tag}>" if tag != "meta" else "")


def inline(pieces: Text) -> str:
    """HTML of a text."""
    return "".join(escape(each, quote=False) if isinstance(each, str) else _piece(each) for each in pieces)


def _piece(each: Piece) -> str:
    body = inline(each.body)
    match each.kind:
        case "link":
            return element("a", body, href=f"#{each.to}")
        case "grade":
            return element("span", body, class_=f"verdict {each.to}")
        case "soft" | "sources":
            return element("span", body, class_=each.kind)
        case "q":
            return element("q", body, lang="ru")
    return element(each.kind, body)


def math(formula: Formula) -> str:
    """MathML of a formula."""
    return element("math", *map(_node, formula.tree), display="block")


def _side(tree: Tree) -> str:
    body = "".join(map(_node, tree))
    return body if len(tree) == 1 else element("mrow", body)


def _node(node: str | Node) -> str:
    if isinstance(node, str):
        return element("mi" if node.isalpha() or node == "∂" else "mo", escape(node))
    match node.kind:
        case "number":
            return element("mn", node.text)
        case "text":
            return element("mtext", escape(node.text))
        case "function":
            gap = element("mspace", width="0.17em")
            return gap + element("mi", node.text, mathvariant="normal") + gap
        case "gap":
            return element("mspace", width=f"{node.text}em")
        case "root":
            return element("msqrt", *map(_node, node.parts[0]))
        case "brackets":
            return element("mrow", element("mo", "("), *map(_node, node.parts[0]), element("mo", ")"))
        case "rows":
            return element("mtable", *(element("mtr", element("mtd", *map(_node, row))) for row in node.parts))
        case "fraction":
            return element("mfrac", *map(_side, node.parts))
    _, below, above = node.parts
    return element("msubsup" if below and above else "msub" if below else "msup", *map(_side, filter(None, node.parts)))


def fragment(parts: Iterable[Block], level: int = 2) -> str:
    """HTML of blocks; the headings of their sections begin at ``level``."""
    return "\n".join(_block(each, level) for each in parts)


def _block(block: Block, level: int) -> str:
    match block:
        case blocks.Paragraph(text, role, key):
            return element("p", inline(text), class_=role, id=key)
        case blocks.Heading(own, text):
            return element(f"h{own}", inline(text))
        case blocks.Table():
            return table(block)
        case blocks.Figure():
            svg = "\n".join(
                drawing(each, str(block.title), f"{block.number}-{n}") for n, each in enumerate(block.drawings, 1)
            )
            caption = f"{_caption(say('Figure {number}', number=block.number), block.title)}. {inline(block.caption)}"
            parts = element("div", svg, class_="scroll"), element("figcaption", caption)
            return element("figure", *parts, id=f"figure-{block.number}")
        case blocks.Step():
            return _step(block)
        case blocks.Definitions("findings", found):
            return _list((f"{inline(grade)} {element('span', inline(text))}" for grade, text in found), "findings")
        case blocks.Bullets(texts, role):
            return _list(map(inline, texts), role)
        case blocks.Definitions(role, pairs):
            return _pairs(((inline(name), inline(text), "") for name, text in pairs), role)
        case blocks.Code(code):
            return element("pre", escape(code, quote=False))
        case blocks.Entries(entries):
            rows = ((escape(name), escape(value), "wide" if long else "") for name, value, long in entries)
            return _pairs(rows, "block")
        case Section(key, label, title, body):
            heading = element(f"h{level}", element("span", label, class_="count"), " ", inline(title))
            return element("section", heading, fragment(body, level + 1), id=key)


def _list(items: Iterable[str], role: str) -> str:
    return element("ul", *(element("li", each) for each in items), class_=role)


def _pairs(entries: Iterable[tuple[str, str, str]], role: str) -> str:
    rows = (element("div", element("dt", name), element("dd", text), class_=kind) for name, text, kind in entries)
    return element("dl", *rows, class_=role)


def _caption(name: str, title: Text) -> str:
    return element("b", name) + (f" – {inline(title)}" if title else "")


def _row(cells: Sequence[Text], numeric: Sequence[bool], tag: str = "td", row: str = "", **more: str) -> str:
    numbers = ["number" if each else "" for each in numeric] or [""] * len(cells)
    shown = (element(tag, inline(cell), **more, class_=kind) for cell, kind in zip(cells, numbers, strict=True))
    return element("tr", *shown, id=row)


def _head(heads: Sequence[Text], numeric: Sequence[bool] = ()) -> str:
    return element("thead", _row(heads, numeric, "th", scope="col"))


def table(block: blocks.Table) -> str:
    """HTML of a table."""
    bodies: list[list[str]] = [[]]
    for row in block.rows:
        if len(row) < len(block.head):
            bodies.append([element("tr", element("th", inline(row[0]), scope="rowgroup", colspan=len(block.head)))])
        else:
            bodies[-1].append(_row(row, block.numeric, row=str(row[0]) if block.named else ""))
    caption = ""
    if block.number:
        name = say("Table {number}", number=block.number)
        caption = element("caption", _caption(name, block.title), id=f"table-{block.number}")
    elif block.title:
        caption = element("caption", inline(block.title))
    body = "\n".join(element("tbody", "\n".join(rows)) for rows in bodies if rows)
    whole = element("table", caption, _head(block.head, block.numeric), body, class_=block.role)
    return element("div", whole, class_="scroll")


def _step(step: blocks.Step) -> str:
    parts = [element("p", inline(step.what), class_="what")]
    if step.formula:
        comma = element("span", ",") if step.lined and step.where else ""
        count = element("span", f"({step.number})", class_="count") if step.number else ""
        shown = element("div", math(step.formula), comma, class_="scroll")
        parts.append(element("div", shown, count, class_="formula"))
    if step.where:
        *most, last = map(inline, step.where)
        spans = " ".join([*(element("span", each, ";") for each in most), element("span", last)])
        parts.append(element("p", say("where"), " ", spans, class_="where lined" if step.lined else "where"))
    if step.lines:
        rows = []
        for labels, numbers in step.lines:
            cells = (element("td", inline(label), class_="label") for label in labels)
            rows.append(element("tr", *cells, element("td", " ".join(map(math, numbers)), class_="put")))
        head = _head(step.head) if step.head else ""
        lines = element("table", head, element("tbody", *rows), class_="lines")
        parts.append(element("div", lines, class_="scroll"))
    parts += [element("p", inline(note), class_="note") for note in step.notes]
    return element("div", *parts, class_="step", id=f"formula-{step.number}" if step.number else step.key)


def drawing(svg: str, name: str, number: object) -> str:
    """Adapt a drawing to a page: unique ids, the colours and the width of the page, a name for screen readers."""
    svg = svg[svg.index("<svg") :]
    svg = re.sub(r"<metadata>.*?</metadata>|<style.*?</style>", "", svg, flags=re.DOTALL)
    svg = re.sub(r'\bid="|url\(#|href="#', lambda found: f"{found[0]}fig{number}-", svg)
    lines = [(colour, f"--line-{index}") for index, colour in enumerate(COLOURS[:4])]
    inks = (INK, "--ink"), (GRID, "--grid"), (SHADE, "--shade"), (WRONG, "--bad"), (PAPER, "--paper")
    for colour, variable in (*inks, *lines):
        svg = svg.replace(colour, f"var({variable})")
    opening, _, rest = svg.partition(">")
    opening = re.sub(r'\s(?:width|height|version|xmlns(?::\w+)?)="[^"]*"', "", opening)
    return f'{opening} role="img" aria-label="{escape(name)}">{rest.strip()}'


def _contents(parts: Iterable[Block]) -> str:
    entries = []
    for part in parts:
        if isinstance(part, Section):
            link = element("a", inline(part.title), href=f"#{part.key}")
            entries.append(element("li", element("div", part.label, " ", link), _contents(part.body)))
    return element("ol", *entries) if entries else ""


def page(document: Document) -> str:
    """Write a page; the same document gives the same text."""
    style = files(__package__).joinpath("page.css").read_text(encoding="utf-8")
    head = [
        element("meta", charset="utf-8"),
        element("meta", name="viewport", content="width=device-width, initial-scale=1"),
        element("meta", name="color-scheme", content="light dark"),
        element("meta", name="generator", content=document.program),
        element("title", escape(f"{document.name} – {document.kind}")),
        element("style", style),
    ]
    kind, name = element("p", escape(document.kind), class_="kind"), element("h1", escape(document.name))
    cover = [kind, name, fragment(document.cover)]
    if not document.short:
        contents = say("Contents")
        cover.append(element("nav", element("h2", contents), _contents(document.body), aria_label=contents))
    body = "\n".join((element("header", *cover), element("main", fragment(document.body))))
    whole = element("html", element("head", *head), element("body", body), lang=document.language)
    return f"<!DOCTYPE html>\n{whole}"
