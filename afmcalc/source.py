"""What a text is called in messages, and where in it something stands."""

from collections.abc import Iterable
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

from .messages import say

if TYPE_CHECKING:
    from .spans import Span

_WIDTH = 100
"""Characters of a line that are shown."""
_SEARCHED = 1 << 20
"""Characters of a text in which places are looked for."""


class Place(NamedTuple):
    """A stretch of one line, counted from 1."""

    line: int
    column: int
    width: int
    text: str
    """The whole line."""

    def __str__(self) -> str:
        """As editors take it."""
        return f"{self.line}:{self.column}"

    def shown(self) -> tuple[str, str]:
        """The line, what is too long cut off, and a caret under what is meant."""
        start = max(0, self.column - 1 - _WIDTH // 2) if len(self.text) > _WIDTH else 0
        cut = "".join(sign if sign.isprintable() else " " for sign in self.text[start : start + _WIDTH])
        before = self.column - 1 - start
        carets = "^" * max(1, min(self.width, _WIDTH - before))
        number = str(self.line)
        return f"  {number} | {cut.rstrip()}", f"  {' ' * len(number)} | {' ' * before}{carets}"


class Unlikely(NamedTuple):
    """A number without a unit that may be meant in another than SI."""

    path: str
    value: float
    given: str
    """With its SI unit."""
    meant: str
    """With the unit that may be meant."""
    possible: bool


STANDARD_INPUT, BUILT_IN = say("standard input"), say("built-in default")
LABELS = {str.__str__(each): each for each in (STANDARD_INPUT, BUILT_IN)}
"""What a text is called that is in no file."""


class Source(str):
    """What a text is called in messages; carries the text, so that an error can show the line."""

    text: str
    overridden: frozenset[str]
    doubts: tuple[Unlikely, ...]
    """Numbers without a unit that may be meant in another than SI."""

    def __new__(
        cls, label: str, text: str = "", overridden: Iterable[str] = (), doubts: Iterable[Unlikely] = ()
    ) -> "Source":
        """Name ``text``; the values at the dotted paths ``overridden`` are no longer those that stand in it."""
        made = super().__new__(cls, label)
        made.text, made.overridden, made.doubts = text, frozenset(overridden), tuple(doubts)
        return made

    def but(self, paths: Iterable[str]) -> "Source":
        """The same text, with other values at some paths."""
        gone = set(paths)
        kept = (each for each in self.doubts if each.path not in gone)
        return Source(self, self.text, self.overridden | gone, kept)

    @cached_property
    def _spans(self) -> "dict[str, Span]":
        from .spans import spans

        try:
            return spans(self.text) if len(self.text) <= _SEARCHED else {}
        except RecursionError:
            return {}

    def place(self, path: str, *, key: bool = False) -> Place | None:
        """Where the value at a dotted path stands, or its ``key``; of a missing one, the table that lacks it."""
        if any(f"{path}.".startswith(f"{gone}.") for gone in self.overridden):
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
