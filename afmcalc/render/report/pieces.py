"""Texts in pieces: symbols with their indices, powers, sources by their numbers."""

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import fields, is_dataclass, replace
from typing import Any

from ...messages import filled, printable, translate
from ...papers.register import sources
from ...spec.keys import keys
from ..symbols import split
from .blocks import Formula, Piece, Svg, Table, Text, piece, text

_UNIT = re.compile(r"(?<!\w)(\d[\d.,]*) (?=(?:[^\W\d_]{1,3}|°[CС])(?![^\W\d_]))")
"""Pattern of a number before a unit (a word of up to three letters); the 19 of S19 does not match."""
_POWER = re.compile(r"([\d.]+|\(.* ± .*\))e([+-]\d+)")
_MINUS = re.compile(r"(?<![\w.\]})-])-(?=\d)")
_REST = re.compile(r"; |: | \(")
MISPRINT = re.compile(r"\bM\d+\b")
_LETTERING = re.compile("(?<=>)[^<]+")
_WHERE = (
    r"(?:,? (?P<formulas>\(\d[\d.]*[a-z]?\)(?:(?:, |–)\(\d[\d.]*[a-z]?\))*)"
    r"|,? (?P<place>(?:chapters?|ch\.|sec\.|fig\.|гл\.|разд\.|рис\.) \d[\d-]*(?: (?:and|и) \d+)?))?"
)
"""Pattern of formulas or a chapter after the name of a source."""


def plain(words: str | None) -> Text:
    """Typeset a text given by the user as it is, with invisible characters escaped."""
    return text(unparted(printable(words or "", lines=True)))


def unparted(words: str) -> str:
    """Text in which each number stays in one line with its unit.

    >>> unparted("37 kW at 1460 rpm, 20 °C").count("\u00a0")
    3
    """
    return _UNIT.sub("\\1\u00a0", words)


def said(words: str, ours: bool = True) -> Text:
    """Typeset a text with its symbols; a quotation (``ours`` is False) stays as printed.

    >>> said("T_н < -1")
    ('T', Piece(kind='sub', body=('n',), to=''), ' < −1')
    """
    pieces = split(_MINUS.sub("−", unparted(printable(words, lines=True))), ours)
    return text(*(piece("sub", each) if low else each for each, low in pieces))


def cell(words: str) -> Text:
    """Typeset a cell of a table: a key as code, a power of ten with its exponent, anything else with its symbols.

    >>> str(cell("no limit (3.3493e+15)")), cell("1e-11")
    ('no limit (3.3493·1015)', ('10', Piece(kind='sup', body=('−11',), to='')))
    """
    if words in keys():
        return text(piece("code", words))
    parts: list[str | Piece] = []
    for each in said(words):
        before, *powers = _POWER.split(each) if isinstance(each, str) else (each,)
        parts.append(before)
        for mantissa, power, after in zip(powers[::3], powers[1::3], powers[2::3], strict=True):
            ten = "10" if mantissa == "1" else f"{mantissa}·10".replace("-", "−")
            parts += [ten, piece("sup", str(int(power)).replace("-", "−")), after]
    return text(*parts)


def table(
    role: str, heads: Iterable[str], rows: Sequence[Sequence[Text]], title: str = "", *, named: bool = False
) -> Table:
    """Table under English headings, which are translated."""
    return Table(role, text(title), [text(translate(head)) for head in heads], rows, named=named)


def name_of(path: str) -> str:
    """Name of a key of the spec, without remarks on the use of the key."""
    return _REST.split(translate(keys()[path].description))[0]


def cited(blocks: Sequence[Any]) -> tuple[list[Any], dict[str, int]]:
    """Blocks with a number in place of each cited source, and source → number, in the order of first mention."""
    numbers: dict[str, int] = {}
    known = sources()

    def cite(found: re.Match[str]) -> str:
        key = next(key for key in known if found[key])
        number = numbers.setdefault(key, len(numbers) + 1)
        name = f"{found[key]} " if "name_stays" in known[key] and found[key] != key else ""
        if formulas := found["formulas"]:
            many = formulas.count("(") > 1
            mark = filled(
                "[{number}, eqs. {at}]" if many else "[{number}, eq. {at}]", {"number": number, "at": formulas}
            )
        else:
            mark = f"[{number}, {found['place']}]" if found["place"] else f"[{number}]"
        return name + mark

    named = "|".join(rf"(?P<{key}>(?<!\w)(?:{entry['cited']})(?!\w))" for key, entry in known.items())
    pattern = re.compile(f"(?:{named}){_WHERE}")
    return [_changed(block, lambda words: pattern.sub(cite, words)) for block in blocks], numbers


def _changed(node: Any, change: Callable[[str], str]) -> Any:
    """Change every text of a block, in the order in which it is read."""
    if isinstance(node, Piece) and node.kind == "sources":
        parts: list[Any] = [*_changed(node.body, change)]
        parts[0], parts[-1] = parts[0][1:], parts[-1][:-1] if parts[1:] else parts[0][1:-1]
        inside = text(*parts)  # round brackets in place of the square ones, or none before a number in square brackets
        return piece("sources", inside if str(inside).startswith("[") else text("(", inside, ")"))
    if isinstance(node, Svg):
        return Svg(_LETTERING.sub(lambda found: change(found[0]), node))
    if isinstance(node, Text):
        return text(*(change(each) if isinstance(each, str) else _changed(each, change) for each in node))
    if isinstance(node, list | tuple):
        return [_changed(each, change) for each in node]
    if not is_dataclass(node) or isinstance(node, type | Formula):
        return node
    return replace(node, **{field.name: _changed(getattr(node, field.name), change) for field in fields(node)})
