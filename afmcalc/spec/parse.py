"""Text of a spec: read the file, parse TOML or JSON into plain data within limits, find the line of a key."""

import json
import os
import re
import sys
import tomllib
from collections.abc import Iterable, Mapping
from contextlib import suppress
from hashlib import sha256
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..errors import AfmcalcError, FileError, Place, Problem, SpecError, reason
from ..findings import Finding
from ..messages import did_you_mean, say

if TYPE_CHECKING:
    from .catalogues import Lists


class Source(str):
    """Name of a text in messages: a str that also has the text, so that an error can show a line."""

    text: str
    digest: str = ""
    """SHA-256 of the file; empty if the text was not read from a file."""
    overridden: Mapping[str, str] = {}
    """Dotted paths whose values were overridden → origin of the new value, or empty."""
    findings: tuple[Finding, ...] = ()
    """Warnings about numbers without a unit that are probably not meant in SI."""
    lists: "Lists | None" = None
    """The user's own lists that the text names, for validation."""

    def __new__(cls, label: str, text: str = "", **more: Any) -> "Source":
        """Create the name of a text; ``more``: the other attributes."""
        source = str.__new__(cls, label)
        vars(source).update(text=text, **more)
        return source

    def but(self, paths: Iterable[str]) -> "Source":
        """Copy that marks the values at some paths as overridden."""
        gone = dict.fromkeys(paths, "")
        findings = tuple(finding for finding in self.findings if finding.path not in gone)
        return Source(self, **vars(self) | {"overridden": {**self.overridden, **gone}, "findings": findings})

    def refused(self, problems: Iterable[Problem], more: int = 0) -> SpecError:
        """Error about this text; each problem has the origin and the line of its value."""
        located = [
            each._replace(origin=self.origin(each.path), place=each.place or self.place(each.path)) for each in problems
        ]
        return SpecError(self, located, more)

    def origin(self, path: str) -> str:
        """Origin of the value at a dotted path: this text, or an option of the command line."""
        return next((by for gone, by in self.overridden.items() if f"{path}.".startswith(f"{gone}.")), "") or self

    def place(self, path: str) -> Place | None:
        """Line of the key at a dotted path of a TOML text, or of its table if the key is missing; None if unknown."""
        if not path or is_json(self) or any(f"{path}.".startswith(f"{gone}.") for gone in self.overridden):
            return None
        best, found, table = "", None, ""
        for number, line in enumerate(self.text.split("\n"), start=1):
            if line.lstrip()[:1] == "[" and (head := line.split("#")[0].strip()).endswith("]"):
                name = table = _bare(head.strip("[]"))
            elif match := re.match(_KEY, line):
                name = f"{table}.{_bare(match[1])}" if table else _bare(match[1])
            else:
                continue
            if f"{path}.".startswith(f"{name}.") and len(name) > len(best):
                best, found = name, Place(number, line)
        return found


_NAME = r"""(?:[\w-]+|"[^"]*"|'[^']*')"""
_KEY = rf"\s*({_NAME}(?:\s*\.\s*{_NAME})*)\s*="
"""Pattern of a key at the beginning of a line."""


def _bare(key: str) -> str:
    return re.sub(r"""["'\s]""", "", key)


PREFIX = "example:"
"""Prefix of the name of an example that is given as a source."""


def _folder() -> Path:
    """Folder of the examples, in the installed package or in a checkout."""
    packaged = Path(__file__).parents[1] / "configs"
    return packaged if packaged.is_dir() else Path(__file__).parents[2] / "configs"


def example_names() -> list[str]:
    """Names of the examples, files of ``configs/`` without their ending."""
    return sorted(path.stem for path in _folder().glob("*.toml"))


def example_text(name: str) -> str:
    """Text of an example; raises ``AfmcalcError`` if there is no example of that name."""
    if name not in (known := example_names()):
        hint = did_you_mean(name, known) or say("; there are: {names}", names=", ".join(known))
        raise AfmcalcError("{prefix}{name}: no such example{hint}", prefix=PREFIX, name=name, hint=hint)
    return (_folder() / f"{name}.toml").read_text(encoding="utf-8")


LONGEST = 64 << 20
"""Largest number of bytes of a file; the JSON output of a long sweep is also read as a spec."""
LONGEST_TOML = 1 << 18
"""Largest number of characters of a TOML text; TOML takes longer to parse than JSON."""
DEEPEST = 32
"""Largest depth of nested tables and lists, and number of parts of a dotted key."""
MOST_BITS = 1024
"""Largest number of bits of a whole number, so that it can be converted to a float."""
_LONG_KEY = rf"""(?m)(?:^|[\[{{,])[ \t]*(?:(?:[\w-]+|"[^"\n]*"|'[^'\n]*')[ \t]*\.[ \t]*){{{DEEPEST}}}"""


def too_deep() -> str:
    """Message that the data is nested too deep."""
    return say("is nested more than {most} levels deep", most=DEEPEST)


def too_long() -> str:
    """Message that a number has too many digits."""
    return say("a number has too many digits")


def text_of(source: str | PathLike[str] | None) -> Source:
    """Text of a spec in UTF-8, or in UTF-16 with byte order mark; with its name in messages.

    Raises FileError if the file cannot be read, SpecError if it is no text, or too long for a spec.
    """
    source = f"{PREFIX}default" if source is None else source
    label = say("standard input") if source == "-" else str(source)
    try:
        if label.startswith(PREFIX):
            raw = example_text(label.removeprefix(PREFIX)).encode()
        elif source == "-":
            raw = sys.stdin.buffer.read(LONGEST + 1)
        else:
            with open(source, "rb") as file:
                raw = file.read(LONGEST + 1)
    except (OSError, ValueError) as error:
        why = reason(error) if isinstance(error, OSError) else error
        hint = _nearest(label) if isinstance(error, FileNotFoundError) else ""
        raise FileError("{label}: cannot be read: {why}{hint}", label=label, why=why, hint=hint) from None
    if len(raw) > LONGEST:
        raise _refused(label, say("is larger than {most} MiB, the most that is read", most=LONGEST >> 20))
    if raw.startswith(b"%PDF"):
        raise _refused(label, say("is a PDF; a spec is a text in TOML or JSON"))
    wide = raw.startswith((b"\xff\xfe", b"\xfe\xff"))
    try:
        return Source(label, raw.decode("utf-16" if wide else "utf-8-sig"), digest=sha256(raw).hexdigest())
    except UnicodeDecodeError as error:
        line = raw.count(b"\n", 0, error.start) + 1
        raise _refused(label, say("is not UTF-8 text (line {line}): save it as UTF-8", line=line)) from None


def _nearest(path: str) -> str:
    """Hint "did you mean" with the most similar file name in the folder of a path; empty if no name is similar."""
    folder, name = os.path.split(path)
    with suppress(OSError):
        return did_you_mean(name, os.listdir(folder or "."))
    return ""


def _refused(label: str, message: str, path: str = "") -> SpecError:
    return SpecError(label, [Problem(path, None, message)])


def _at_line(source: Source, number: int, message: str) -> SpecError:
    """Error of a parser at a line number; 0 means the last line."""
    lines = source.text.rstrip().split("\n")
    number = number or len(lines)
    return SpecError(source, [Problem("", None, message, Place(number, "".join(lines[number - 1 : number])))])


def parse(source: Source) -> dict[str, object]:
    """Data of a TOML or JSON text (see ``is_json``); raises ``SpecError`` if it is neither, or too large."""
    if not source.text.strip():
        raise _refused(source, say("is empty; a clutch spec in TOML or JSON is wanted"))
    try:
        data = _json_of(source) if is_json(source) else _toml_of(source)
    except RecursionError:
        raise _refused(source, too_deep()) from None
    check_size(data, source)
    return data


def is_json(source: Source) -> bool:
    """True if a text begins with a brace, or its file name ends in .json."""
    return source.text.lstrip()[:1] == "{" or source.endswith(".json")


def _toml_of(source: Source) -> dict[str, object]:
    if len(source.text) > LONGEST_TOML:
        raise _refused(source, say("is larger than {most} KiB, the most for TOML", most=LONGEST_TOML >> 10))
    # a dotted key of very many parts would take gigabytes to parse
    if re.search(_LONG_KEY, source.text):
        raise _refused(source, too_deep())
    try:
        return tomllib.loads(source.text)
    except tomllib.TOMLDecodeError as error:
        line = re.search(r"at line (\d+)", str(error))
        bare = str(error).startswith(("Invalid value", "Expected newline"))
        hint = say('; text, a decimal comma and a unit stand in quotes: "2,5 kN"') if bare else ""
        message = say("is not valid TOML: {why}{hint}", why=error, hint=hint)
        raise _at_line(source, int(line[1]) if line else 0, message) from None
    except ValueError:
        raise _refused(source, say("is not valid TOML: {why}{hint}", why=too_long(), hint="")) from None


def _json_of(source: Source) -> dict[str, object]:
    def unique(pairs: list[tuple[str, object]]) -> dict[str, object]:
        data = dict(pairs)
        if len(data) < len(pairs):
            twice = next(key for place, (key, _) in enumerate(pairs) if key in dict(pairs[:place]))
            raise _refused(source, say("is not a spec: key {key!r} stands twice in one JSON object", key=twice))
        return data

    try:
        data = json.loads(source.text, object_pairs_hook=unique)
    except json.JSONDecodeError as error:
        raise _at_line(source, error.lineno, say("is not valid JSON: {why}", why=error.msg)) from None
    except AfmcalcError:
        raise
    except ValueError:
        raise _refused(source, say("is not valid JSON: {why}", why=too_long())) from None
    if not isinstance(data, dict):
        raise _refused(source, say("is not a spec: a JSON object is wanted"))
    spec = data.get("spec", data)
    if spec is None and "command" in data:
        raise _refused(source, say("the output of {command!r} carries no clutch", command=data["command"]))
    if not isinstance(spec, dict):
        raise _refused(source, say("its spec block is no object"))
    return spec


def check_size(data: object, label: str) -> None:
    """Check the depth of parsed data and the size of its whole numbers; raises SpecError if one exceeds its limit."""
    left: list[tuple[str, int, object]] = [("", 0, data)]
    for path, depth, value in left:
        if depth > DEEPEST:
            raise _refused(label, too_deep())
        if isinstance(value, int) and value.bit_length() > MOST_BITS:
            raise _refused(label, say("is beyond the range of numbers"), path)
        if isinstance(value, dict):
            left += [(f"{path}.{key}" if path else key, depth + 1, inner) for key, inner in value.items()]
        elif isinstance(value, list):
            left += [(path, depth + 1, inner) for inner in value]
