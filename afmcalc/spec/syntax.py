"""Where a text is no TOML or no JSON, and how to put it right; loaded only then."""

import json
import re
from collections.abc import Callable
from typing import TypeAlias

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


_Cure: TypeAlias = tuple[str, int, int]
"""Message on a stretch of a line, where it begins and ends."""


def toml_problem(text: str, error: ValueError) -> Problem:
    """Tell what the TOML parser met."""
    why = str(error)
    match = _POSITION.search(why)
    if match is None or match[1] is None:
        at = len(text.rstrip())
    else:
        before = text.split("\n", int(match[1]))[: int(match[1]) - 1]
        at = sum(len(line) + 1 for line in before) + int(match[2]) - 1
    why, place = _cured(text, at, _POSITION.sub("", why), _of_key)
    return Problem("", None, say("is not valid TOML: {why}", why=why), place=place)


def json_problem(text: str, error: json.JSONDecodeError) -> Problem:
    """Tell what the JSON parser met."""
    why, place = _cured(text, error.pos, error.msg, lambda line, why: None)
    return Problem("", None, say("is not valid JSON: {why}", why=why), place=place)


def _cured(text: str, at: int, why: str, of_key: Callable[[str, str], _Cure | None]) -> tuple[str, Place]:
    """Message on a place, in plain words or, where the cure is not known, those of the parser; and the place."""
    begin = text.rfind("\n", 0, at) + 1
    line = text[begin : begin + 1000].partition("\n")[0].rstrip("\r")
    if cure := of_key(line, why) or _of_value(line, at - begin):
        message, start, end = cure
        return message, place_at(text, begin + start, begin + end)
    return why[:1].lower() + why[1:], place_at(text, at, at + 1)


def _of_key(line: str, why: str) -> _Cure | None:
    """Fault of the key of a line."""
    match = _KEY.match(line)
    if match is None:
        return None
    key, start, end = match[2], match.start(2), match.end(2)
    if why == "Cannot overwrite a value":
        return say("the key {key} stands twice", key=key), start, end
    if why.endswith("twice"):
        return say("the table [{key}] stands twice", key=key), start, end
    if not key.isascii() and any(letter.isalpha() for letter in key):
        hint = elsewhere(plain(key)) or in_latin(key)
        return say("keys are written in Latin letters{hint}", hint=hint), start, end
    if not match[1].strip() and line[end:].lstrip().startswith(":"):
        return say("write = between key and value, not a colon"), start, end + 1
    return None


def _of_value(line: str, column: int) -> _Cure | None:
    """Fault of the value at a column of a line, or before it."""
    signs = [sign.end() for sign in re.finditer(r"[=:][ \t]*", line) if sign.start() <= column]
    if not signs:
        return None
    start = signs[-1]
    for pattern, cure in _VALUES:
        if (match := re.compile(pattern + _END).match(line, start)) and (message := cure(match)):
            return message, start, max(match.end(), start + 1)
    if line.count('"', start) % 2:
        return say("the closing quote is missing"), start, len(line)
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
"""Pattern of a wrong value → how it is put right; the first that fits."""
