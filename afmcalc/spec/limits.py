"""How large what is read may be; refused before any work begins."""

import re

from ..errors import Problem, SpecError
from ..messages import say

LONGEST = 64 << 20
"""Bytes of a file; the JSON of a long sweep is a spec too."""
MOST_COMMAS = 5_000_000
"""Values in a JSON text, all its parts counted."""
MOST_BRACKETS = 500_000
"""Tables and lists in it."""
LONGEST_TOML = 1 << 18
"""Characters of a TOML text, which takes longer to read than JSON."""
LONGEST_TEXT = 1_000
"""Characters of a key or a text."""
MOST_KEYS = 2_000
"""Keys in all tables."""
MOST_ITEMS = 100_000
"""Items in all lists."""
DEEPEST = 32
"""Tables and lists inside each other, and parts of a dotted key."""
MOST_BITS = 1024
"""Of a whole number: what a real one can hold."""


def check_key_lengths(text: str, label: str) -> None:
    """Refuse TOML with a dotted key of so many parts that reading it would take gigabytes.

    Raises:
        SpecError: there is one.
    """
    part = r"""(?:[\w-]+|"[^"\n]*"|'[^'\n]*')[ \t]*"""
    if re.search(rf"(?m)(?:^|[\[{{,])[ \t]*(?:{part}\.[ \t]*){{{DEEPEST}}}", text):
        raise _refused(label, "", say("a key has more than {most} parts, the most there may be", most=DEEPEST))


def check_counts(text: str, label: str) -> None:
    """Refuse JSON of so many values that reading it would take gigabytes.

    Raises:
        SpecError: it is such.
    """
    if text.count(",") > MOST_COMMAS or text.count("{") + text.count("[") > MOST_BRACKETS:
        raise _refused(label, "", say("holds more than {most:,} values, the most that are read", most=MOST_COMMAS))


def check_size(data: object, label: str) -> None:
    """Hold parsed data to every limit.

    Raises:
        SpecError: it is beyond one.
    """
    keys = items = 0
    left: list[tuple[str, int, object]] = [("", 0, data)]
    while left:
        path, depth, value = left.pop()
        if depth > DEEPEST:
            raise _refused(label, "", too_deep())
        if isinstance(value, dict):
            keys += len(value)
            if keys > MOST_KEYS:
                raise _refused(label, "", say("has more than {most:,} keys", most=MOST_KEYS))
            if any(len(key) > LONGEST_TEXT for key in value):
                raise _refused(label, path, say("a key has more than {most:,} characters", most=LONGEST_TEXT))
            left += [(f"{path}.{key}" if path else key, depth + 1, inner) for key, inner in value.items()]
        elif isinstance(value, list):
            items += len(value)
            if items > MOST_ITEMS:
                raise _refused(label, "", say("has more than {most:,} items in its lists", most=MOST_ITEMS))
            left += [(path, depth + 1, inner) for inner in value]
        elif isinstance(value, str) and len(value) > LONGEST_TEXT:
            raise _refused(label, path, say("has more than {most:,} characters", most=LONGEST_TEXT))
        elif isinstance(value, int) and value.bit_length() > MOST_BITS:
            raise _refused(label, path, say("is beyond the range of numbers"))


def too_deep() -> str:
    """Say that tables and lists are nested too deeply."""
    return say("is nested more than {most} levels deep", most=DEEPEST)


def _refused(label: str, path: str, message: str) -> SpecError:
    return SpecError(label, [Problem(path, None, message)])
