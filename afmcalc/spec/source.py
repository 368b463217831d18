"""Where a spec was read from, and where in its text each key stands."""

import json
import re
from collections import deque
from collections.abc import Iterable, Mapping
from functools import cached_property
from itertools import count
from typing import NamedTuple

from ..errors import Label, Place
from ..findings import Finding
from .catalogues import Lists

_SEARCHED = 1 << 20
"""Characters of a text in which places are looked for."""


class Source(Label):
    """Name of a text in messages; carries the text, so that an error can show the line."""

    text: str
    overridden: Mapping[str, str]
    """Dotted paths whose values are no longer those of the text → what gave them, where that is told."""
    findings: tuple[Finding, ...]
    """Numbers without a unit that may be meant in another than SI."""
    lists: Lists = Lists()
    """Lists of one's own that it names, for what is validated of it."""

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
        """Origin of the value at a dotted path: the text, or an option of the command line."""
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
    """Takes the tokens of a text one by one. JSON is read as an inline table of TOML with colons."""

    def __init__(self, text: str) -> None:
        self.tokens = deque(token for token in re.finditer(_TOKEN, text) if token.lastgroup != "blank")
        self.end = 0
        """Of the token that was taken last."""
        self.spans: dict[str, Span] = {}

    def next(self) -> str:
        return self.tokens[0].group() if self.tokens else ""

    def take(self) -> re.Match[str]:
        token = self.tokens.popleft()
        self.end = token.end()
        return token

    def skip(self, *signs: str) -> None:
        while self.next() in signs:
            self.take()

    def document(self) -> dict[str, Span]:
        table = ""
        while self.tokens:
            match self.next():
                case "\n":
                    self.take()
                case "{":
                    self.value("")
                case "[":
                    start = self.tokens[0].start()
                    self.skip("[")
                    table = self.key("")
                    self.skip("]")
                    self.spans[table] = Span(start, self.end, start, self.end)
                case _:
                    self.pair(table)
        return self.spans

    def key(self, table: str) -> str:
        parts = [table] if table else []
        while True:
            token = self.take()
            parts.append(_unquoted(token.group()) if token.lastgroup == "text" else token.group())
            if self.next() != ".":
                return ".".join(parts)
            self.take()

    def pair(self, table: str) -> None:
        start = self.tokens[0].start()
        path = self.key(table)
        end = self.end
        self.skip("\n", "=", ":")
        self.spans[path] = Span(start, end, *self.value(path))

    def value(self, path: str) -> tuple[int, int]:
        """Step over a value; where it begins and ends."""
        start = self.tokens[0].start()
        if (opening := self.next()) in ("[", "{"):
            self.take()
            self.skip("\n", ",")
            for number in count():
                if self.next() in ("]", "}"):
                    break
                if opening == "{":
                    self.pair(path)
                else:
                    item = self.value(f"{path}.{number}")
                    self.spans[f"{path}.{number}"] = Span(*item, *item)
                self.skip("\n", ",")
            self.take()
        else:
            while self.next() not in ("", "\n", ",", "]", "}"):
                self.take()
        return start, self.end


def _unquoted(text: str) -> str:
    try:
        return str(json.loads(text, strict=False))
    except ValueError:
        return text[1:-1]
