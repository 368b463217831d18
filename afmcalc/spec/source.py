"""The text that a spec was read from, and the line of each key in it."""

import re
from collections.abc import Iterable, Mapping

from ..errors import Label, Place
from ..findings import Finding
from .catalogues import Lists


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
        source.text, source.overridden, source.findings = text, dict(overridden or {}), tuple(findings)
        return source

    def but(self, paths: Iterable[str]) -> "Source":
        """The same text, with other values at some paths."""
        gone = dict.fromkeys(paths, "")
        findings = (finding for finding in self.findings if finding.path not in gone)
        return Source(self, self.text, {**self.overridden, **gone}, findings)

    def origin(self, path: str) -> str:
        """Origin of the value at a dotted path: the text, or an option of the command line."""
        return next((by for gone, by in self.overridden.items() if f"{path}.".startswith(f"{gone}.")), "") or self

    def place(self, path: str) -> Place | None:
        """Line of the key at a dotted path; of a missing one, that of the table that lacks it."""
        if not path or any(f"{path}.".startswith(f"{gone}.") for gone in self.overridden):
            return None
        lines = self.text.split("\n")
        number = _json_line(self.text, path) if self.text.lstrip()[:1] == "{" else _toml_line(lines, path)
        return Place(number, lines[number - 1]) if number else None


_KEY = re.compile(r"""\s*((?:[\w-]+|"[^"]*"|'[^']*')(?:\s*\.\s*(?:[\w-]+|"[^"]*"|'[^']*'))*)\s*=""")


def _toml_line(lines: Iterable[str], path: str) -> int:
    """Line of ``key =`` under its ``[table]``, else of the innermost table or key around it; 0: there is none."""
    best, number, table = "", 0, ""
    for at, line in enumerate(lines, start=1):
        if line.lstrip()[:1] == "[" and (head := line.split("#")[0].strip()).endswith("]"):
            name = table = _bare(head.strip("[]"))
        elif match := _KEY.match(line):
            name = f"{table}.{_bare(match[1])}" if table else _bare(match[1])
        else:
            continue
        if f"{path}.".startswith(f"{name}.") and len(name) > len(best):
            best, number = name, at
    return number


def _bare(key: str) -> str:
    return re.sub(r"""["'\s]""", "", key)


def _json_line(text: str, path: str) -> int:
    """Line of the last key of a path that is found, each behind the one before it; 0: none is."""
    spec = re.search(r'"spec"\s*:', text)
    at, found = spec.end() if spec else 0, 0
    for name in path.split("."):
        match = re.compile(rf'"{re.escape(name)}"\s*:').search(text, at)
        if match is None:
            break
        at, found = match.end(), text.count("\n", 0, match.start()) + 1
    return found
