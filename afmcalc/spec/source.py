"""Where a spec was read from, and where in its text each key stands."""

import json
import re
from collections.abc import Iterable, Mapping
from functools import cached_property
from typing import NamedTuple

from ..errors import Label, Place
from ..findings import Finding

_SEARCHED = 1 << 20
"""Characters of a text in which places are looked for."""


class Source(Label):
    """What a text is called in messages; carries the text, so that an error can show the line."""

    text: str
    overridden: Mapping[str, str]
    """Dotted paths whose values are no longer those of the text → what gave them, where that is told."""
    findings: tuple[Finding, ...]
    """Numbers without a unit that may be meant in another than SI."""

    def __new__(
        cls, label: str, text: str = "", overridden: Mapping[str, str] | None = None, findings: Iterable[Finding] = ()
    ) -> "Source":
        """Name a text."""
        source = str.__new__(cls, label)
        source.name = label.name if isinstance(label, Source) else label
        source.text, source.overridden, source.findings = text, dict(overridden or {}), tuple(findings)
        return source

    def but(self, paths: Iterable[str]) -> "Source":
        """The same text, with other values at some paths."""
        gone = dict.fromkeys(paths, "")
        findings = (finding for finding in self.findings if finding.path not in gone)
        return Source(self.name, self.text, {**self.overridden, **gone}, findings)

    @cached_property
    def _spans(self) -> "dict[str, Span]":
        try:
            return spans(self.text) if len(self.text) <= _SEARCHED else {}
        except RecursionError:
            return {}

    def origin(self, path: str) -> str:
        """What gave the value at a dotted path: the text, or an option of the command line."""
        return next((by for gone, by in self.overridden.items() if f"{path}.".startswith(f"{gone}.")), "") or self.name

    def place(self, path: str, *, key: bool = False) -> Place | None:
        """Where the value at a dotted path stands, or its ``key``; of a missing one, the table that lacks it."""
        if not path or any(f"{path}.".startswith(f"{gone}.") for gone in self.overridden):
            return None
        outside = ["spec"] if "spec" in self._spans else []
        wanted = path
        while wanted:
            if span := self._spans.get(".".join([*outside, wanted])):
                if key or wanted != path:
                    return place_at(self.text, span.key, span.name_end)
                return place_at(self.text, span.value, span.end)
            wanted = wanted.rpartition(".")[0]
        return None


def place_at(text: str, start: int, end: int) -> Place:
    """Place of a stretch of a text, as far as its first line goes."""
    begin = text.rfind("\n", 0, start) + 1
    over = text.find("\n", start)
    line = text[begin : over if over >= 0 else len(text)].removesuffix("\r")
    column = min(start - begin, len(line))
    return Place(text.count("\n", 0, start) + 1, column + 1, min(end - start, len(line) - column), line)


class Span(NamedTuple):
    """Where a key and its value begin and end; the head of a table stands for both."""

    key: int
    name_end: int
    value: int
    end: int


_TOKEN = r"""(?xs)
    (?P<blank>[ \t\r]+|\#[^\n]*)
    |(?P<line>\n)
    |(?P<text>\"{3}(?:\\.|[^\\])*?\"{3,5}|'{3}.*?'{3,5}|"(?:\\.|[^"\\\n])*"|'[^'\n]*')
    |(?P<sign>[][{}=:,.])
    |(?P<bare>[^][{}=:,.\s\#"']+)"""


def spans(text: str) -> dict[str, Span]:
    """Where every key stands in valid TOML or JSON, by dotted path; items of a list by their number."""
    return _Reader(text).document()


class _Reader:
    """Walks the tokens of a text once. JSON is read as an inline table of TOML with colons."""

    def __init__(self, text: str) -> None:
        self.tokens = [token for token in re.finditer(_TOKEN, text) if token.lastgroup != "blank"]
        self.at = 0
        self.spans: dict[str, Span] = {}

    def document(self) -> dict[str, Span]:
        table = ""
        while self.at < len(self.tokens):
            match self.tokens[self.at].group():
                case "\n":
                    self.at += 1
                case "{":
                    self.value("")
                case "[":
                    table = self.header()
                case _:
                    self.pair(table)
        return self.spans

    def header(self) -> str:
        start = self.tokens[self.at].start()
        while self.is_at("["):
            self.at += 1
        path = self.key("")
        while self.is_at("]"):
            self.at += 1
        end = self.tokens[self.at - 1].end()
        self.spans[path] = Span(start, end, start, end)
        return path

    def is_at(self, *signs: str) -> bool:
        return self.at < len(self.tokens) and self.tokens[self.at].group() in signs

    def key(self, table: str) -> str:
        parts = [table] if table else []
        while True:
            token = self.tokens[self.at]
            parts.append(_unquoted(token.group()) if token.lastgroup == "text" else token.group())
            self.at += 1
            if not self.is_at("."):
                return ".".join(parts)
            self.at += 1

    def pair(self, table: str) -> None:
        start = self.tokens[self.at].start()
        path = self.key(table)
        end = self.tokens[self.at - 1].end()
        while self.is_at("\n", "=", ":"):
            self.at += 1
        self.spans[path] = Span(start, end, *self.value(path))

    def value(self, path: str) -> tuple[int, int]:
        """Step over a value; where it begins and ends."""
        start = self.tokens[self.at].start()
        if self.is_at("["):
            self.at += 1
            number = 0
            while not self.ends("]"):
                item = self.value(f"{path}.{number}")
                self.spans[f"{path}.{number}"] = Span(*item, *item)
                number += 1
        elif self.is_at("{"):
            self.at += 1
            while not self.ends("}"):
                self.pair(path)
        else:
            while self.at < len(self.tokens) and not self.is_at("\n", ",", "]", "}"):
                self.at += 1
        return start, self.tokens[self.at - 1].end()

    def ends(self, sign: str) -> bool:
        """Step over what stands between items, and over the closing sign if it is there."""
        while self.is_at("\n", ","):
            self.at += 1
        over = self.is_at(sign)
        self.at += over
        return over


def _unquoted(text: str) -> str:
    try:
        return str(json.loads(text, strict=False))
    except ValueError:
        return text[1:-1]
