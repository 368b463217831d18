"""Where every key stands in a text, TOML or JSON. Loaded only when there is an error to show."""

import json
import re
from typing import NamedTuple


class Span(NamedTuple):
    """Where a key and its value begin and end; the head of a table stands for both."""

    key: int
    name_end: int
    value: int
    end: int


_TOKEN = re.compile(
    r"""(?P<blank>[ \t\r]+|\#[^\n]*)
    |(?P<line>\n)
    |(?P<text>\"{3}(?:\\.|[^\\])*?\"{3,5}|'{3}.*?'{3,5}|"(?:\\.|[^"\\\n])*"|'[^'\n]*')
    |(?P<sign>[][{}=:,.])
    |(?P<bare>[^][{}=:,.\s\#"']+)""",
    re.VERBOSE | re.DOTALL,
)


def spans(text: str) -> dict[str, Span]:
    """Where every key stands in valid TOML or JSON, by dotted path; items of a list by their number."""
    return _Reader(text).document()


class _Reader:
    """Walks the tokens of a text once. JSON is read as an inline table of TOML with colons."""

    def __init__(self, text: str) -> None:
        self.tokens = [token for token in _TOKEN.finditer(text) if token.lastgroup != "blank"]
        self.at = 0
        self.found: dict[str, Span] = {}

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
        return self.found

    def header(self) -> str:
        start = self.tokens[self.at].start()
        while self.is_at("["):
            self.at += 1
        path = self.key("")
        while self.is_at("]"):
            self.at += 1
        end = self.tokens[self.at - 1].end()
        self.found[path] = Span(start, end, start, end)
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
        self.found[path] = Span(start, end, *self.value(path))

    def value(self, path: str) -> tuple[int, int]:
        """Step over a value; where it begins and ends."""
        start = self.tokens[self.at].start()
        if self.is_at("["):
            self.at += 1
            number = 0
            while not self.ends("]"):
                item = self.value(f"{path}.{number}")
                self.found[f"{path}.{number}"] = Span(*item, *item)
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
