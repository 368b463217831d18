"""Where a text is no TOML or no JSON, and how to put it right; loaded only then."""

import json
import re
from collections.abc import Callable
from typing import NamedTuple

from ..errors import Place, Problem
from ..messages import in_latin, plain, say
from .keys import elsewhere
from .quantity import NUMBER, unread_number
from .source import place_at

_POSITION = re.compile(r" \(at (?:line (\d+), column (\d+)|end of document)\)$")
_UNIT = r"""[ \t]*(?:(?:1?[ \t]*/[ \t]*)?[^\W\d_](?:[^],}#"'\n]*[^],}#"'\s])?|[°%])"""
_END = r"""(?=[ \t]*(?:[],}#]|$))"""
_KEY = re.compile(r"""[ \t]*(\[*[ \t]*)([^]=:\s#"']+)""")
_LONG = 60
"""Characters of a number that nobody wrote by mistake."""
_TRUTH = {"true": "true", "yes": "true", "on": "true", "false": "false", "no": "false", "off": "false"}


class _Cure(NamedTuple):
    """What is wrong with a stretch of a line."""

    message: str
    start: int
    end: int


def toml_problem(text: str, error: ValueError) -> Problem:
    """Tell what the TOML parser match."""
    why = str(error)
    match = _POSITION.search(why)
    if match is None or match[1] is None:
        at = len(text.rstrip())
    else:
        before = text.split("\n", int(match[1]))[: int(match[1]) - 1]
        at = sum(len(line) + 1 for line in before) + int(match[2]) - 1
    why = _POSITION.sub("", why)
    begin, line = _line(text, at)
    cure = _of_key(line, why) or _of_value(line, at - begin)
    why = cure.message if cure else _lowered(why)
    return Problem("", None, say("is not valid TOML: {why}", why=why), place=_place(text, at, begin, cure))


def json_problem(text: str, error: json.JSONDecodeError) -> Problem:
    """Tell what the JSON parser match."""
    begin, line = _line(text, error.pos)
    cure = _of_value(line, error.pos - begin)
    why = cure.message if cure else _lowered(error.msg)
    return Problem("", None, say("is not valid JSON: {why}", why=why), place=_place(text, error.pos, begin, cure))


def _lowered(why: str) -> str:
    return why[:1].lower() + why[1:]


def _line(text: str, at: int) -> tuple[int, str]:
    """The line at a place, and where it begins."""
    begin = text.rfind("\n", 0, at) + 1
    return begin, text[begin : begin + 1000].partition("\n")[0].rstrip("\r")


def _place(text: str, at: int, begin: int, cure: _Cure | None) -> Place:
    return place_at(text, begin + cure.start, begin + cure.end) if cure else place_at(text, at, at + 1)


def _of_key(line: str, why: str) -> _Cure | None:
    """What is wrong with the key of a line."""
    match = _KEY.match(line)
    if match is None:
        return None
    key, start, end = match[2], match.start(2), match.end(2)
    if why == "Cannot overwrite a value":
        return _Cure(say("the key {key} stands twice", key=key), start, end)
    if why.endswith("twice"):
        return _Cure(say("the table [{key}] stands twice", key=key), start, end)
    if not key.isascii() and any(letter.isalpha() for letter in key):
        hint = elsewhere(plain(key)) or in_latin(key)
        return _Cure(say("keys are written in Latin letters{hint}", hint=hint), start, end)
    if not match[1].strip() and line[end:].lstrip().startswith(":"):
        return _Cure(say("write = between key and value, not a colon"), start, end + 1)
    return None


def _of_value(line: str, column: int) -> _Cure | None:
    """What is wrong with the value at a column of a line, or before it."""
    signs = [sign.end() for sign in re.finditer(r"[=:][ \t]*", line) if sign.start() <= column]
    if not signs:
        return None
    start = signs[-1]
    for pattern, cure in _VALUES:
        if (match := re.compile(pattern + _END).match(line, start)) and (message := cure(match)):
            return _Cure(message, start, max(match.end(), start + 1))
    if line.count('"', start) % 2:
        return _Cure(say("the closing quote is missing"), start, len(line))
    return None


def _unread(match: re.Match[str]) -> str | None:
    return unread_number(match[0], quoted=True) if len(match[0]) < _LONG else None


def _decimals(match: re.Match[str]) -> str:
    number = (match[1] or "0").lstrip("0") or "0"
    return say("write {number}.{decimals}", number=number, decimals=match[2] or "0")


def _word(match: re.Match[str]) -> str:
    truth = _TRUTH.get(match[1].lower())
    return say("write {truth}", truth=truth) if truth else say('text stands in quotes: "{text}"', text=match[1])


_VALUES: tuple[tuple[str, Callable[[re.Match[str]], str | None]], ...] = (
    (rf"[+-]?\d[\d ,.]*\d(?:{_UNIT})?", _unread),
    (rf"{NUMBER}{_UNIT}", lambda match: say('a number with a unit stands in quotes: "{value}"', value=match[0])),
    (r"0+([1-9]\d*)", lambda match: say("write {number}", number=match[1])),
    (r"(\d*)\.(\d*)", _decimals),
    (
        r"""[“”„«‘‚'](?P<text>[^“”„»’'"]*)[“”»’']""",
        lambda match: say('plain quotes are wanted: "{text}"', text=match[1]),
    ),
    (r"([^\W\d][\w-]*)", _word),
    (r"", lambda match: say("a value is missing")),
)
"""What people write for a value → how it is put right; the first that fits."""
