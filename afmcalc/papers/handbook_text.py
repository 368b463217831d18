"""Chapters of the handbook as they are written, and the sections on errors and warnings in one of the chapters.

The last lines of a section, ``{mend KEY +, KEY -}``, name the keys whose change clears the finding, in the order in
which they are tried, and the direction of change: ``+`` larger, ``-`` smaller, ``±`` either. ``*`` stands for the key
that the finding names; a line ``{mend KEY: …}`` holds only for findings that name KEY.
"""

import re
from functools import cache
from importlib.resources import files
from typing import Literal, NamedTuple, cast

from ..findings import Finding

HANDBOOK = files(__package__).joinpath("handbook")
_FINDINGS = 17
Way = Literal["+", "-", "±"]


def chapter_texts(language: str) -> dict[int, str]:
    """Return the Markdown of every chapter by its number."""
    folder = HANDBOOK / "ru" if language == "ru" else HANDBOOK
    names = sorted(entry.name for entry in folder.iterdir() if entry.name.endswith(".md"))
    return {int(name[:2]): folder.joinpath(name).read_text(encoding="utf-8") for name in names}


class Section(NamedTuple):
    """Section on the code of a finding: its meaning, and the keys whose change clears it."""

    meaning: str
    ways: dict[str, list[tuple[str, Way]]]
    """Key that a finding names, or "" for any key → keys to change, each with its direction of change."""

    def ways_of(self, found: Finding) -> list[tuple[str, Way]]:
        """Return the keys that clear a finding, each with its direction of change."""
        ways = self.ways.get(found.path or "", self.ways.get("", []))
        return [(path.replace("*", found.path or ""), way) for path, way in ways]


@cache
def sections(language: str) -> dict[str, Section]:
    """Return the sections on errors and warnings by their codes."""
    _, *parts = re.split(r"^## `([\w-]+)`\n", chapter_texts(language)[_FINDINGS], flags=re.MULTILINE)
    found = {}
    for code, body in zip(parts[::2], parts[1::2], strict=True):
        meaning = " ".join(re.sub(r"\{mend [^{}]+\}|`", "", body).split())
        found[code] = Section(meaning, dict(map(ways_in, re.findall(r"\{mend ([^{}]+)\}", body))))
    return found


def ways_in(line: str) -> tuple[str, list[tuple[str, Way]]]:
    """Return the key before the colon of a ``mend`` line, or "", and the keys to change with their directions."""
    about, _, listed = line.rpartition(": ")
    pairs = (each.rpartition(" ") for each in listed.split(", "))
    return about, [(path, cast(Way, way)) for path, _, way in pairs]
