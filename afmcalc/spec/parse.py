"""The text of a spec: its file, TOML or JSON made plain data within stated limits, the line of each key."""

import json
import os
import re
import sys
import tomllib
from collections.abc import Iterable, Mapping
from contextlib import suppress
from os import PathLike
from pathlib import Path

from ..errors import AfmcalcError, FileError, Label, Place, Problem, SpecError, reason
from ..findings import Finding
from ..messages import deferred, did_you_mean, say, translate
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
        """Text with other values at some paths."""
        gone = dict.fromkeys(paths, "")
        findings = (finding for finding in self.findings if finding.path not in gone)
        return Source(self, self.text, {**self.overridden, **gone}, findings)

    def origin(self, path: str) -> str:
        """Origin of the value at a dotted path: the text, or an option of the command line."""
        return next((by for gone, by in self.overridden.items() if f"{path}.".startswith(f"{gone}.")), "") or self

    def place(self, path: str) -> Place | None:
        """Line of the key at a dotted path of a TOML text; of a missing one, that of the table that lacks it."""
        if not path or is_json(self) or any(f"{path}.".startswith(f"{gone}.") for gone in self.overridden):
            return None
        lines = self.text.split("\n")
        number = _toml_line(lines, path)
        return Place(number, lines[number - 1]) if number else None


_STANDARD_INPUT = deferred("standard input")
PREFIX = "example:"
"""Prefix that makes the name of an example a source."""


def _folder() -> Path:
    """Folder of the examples: inside the installed package, or beside it in a checkout."""
    packaged = Path(__file__).parents[1] / "configs"
    return packaged if packaged.is_dir() else Path(__file__).parents[2] / "configs"


def example_names() -> list[str]:
    """Names of the examples, files of ``configs/`` without their ending."""
    return sorted(path.stem for path in _folder().glob("*.toml"))


def example_text(name: str) -> str:
    """Text of an example; an ``AfmcalcError`` where there is none of that name."""
    if name not in (known := example_names()):
        hint = did_you_mean(name, known) or say("; there are: {names}", names=", ".join(known))
        raise AfmcalcError("{prefix}{name}: no such example{hint}", prefix=PREFIX, name=name, hint=hint)
    return (_folder() / f"{name}.toml").read_text(encoding="utf-8")


LONGEST = 64 << 20
"""Bytes of a file; the JSON of a long sweep is a spec too."""
LONGEST_TOML = 1 << 18
"""Characters of a TOML text, which takes longer to read than JSON."""
LONGEST_TEXT = 1_000
"""Characters of a key or a text."""
MOST_VALUES = 100_000
"""Keys, and items of lists, in all."""
DEEPEST = 32
"""Tables and lists inside each other, and parts of a dotted key."""
MOST_BITS = 1024
"""Bits of a whole number: as many as a real one can hold."""
_LONG_KEY = rf"""(?m)(?:^|[\[{{,])[ \t]*(?:(?:[\w-]+|"[^"\n]*"|'[^'\n]*')[ \t]*\.[ \t]*){{{DEEPEST}}}"""


def too_deep() -> str:
    """Refusal of what is nested too deep."""
    return say("is nested more than {most} levels deep", most=DEEPEST)


def text_of(source: str | PathLike[str] | None) -> Source:
    """Return the text of a spec as given, with what to call it in messages.

    Raises FileError: it cannot be read; SpecError: it is no text, or too long for a spec.
    """
    return decoded(*bytes_of(source))


def bytes_of(source: str | PathLike[str] | None) -> tuple[bytes, str]:
    """Return what is in the file of a spec, and what to call it in messages; the errors are those of ``text_of``."""
    source = f"{PREFIX}default" if source is None else source
    label = translate(_STANDARD_INPUT) if source == "-" else str(source)
    if label.startswith(PREFIX):
        return example_text(label.removeprefix(PREFIX)).encode(), label
    try:
        if source == "-":
            raw = sys.stdin.buffer.read(LONGEST + 1)
        else:
            with open(source, "rb") as file:
                raw = file.read(LONGEST + 1)
    except FileNotFoundError as error:
        hint = _nearest(label)
        raise FileError("{label}: cannot be read: {why}{hint}", label=label, why=reason(error), hint=hint) from None
    except (OSError, ValueError) as error:
        why = reason(error) if isinstance(error, OSError) else error
        raise FileError("{label}: cannot be read: {why}", label=label, why=why) from None
    if len(raw) > LONGEST:
        raise _refused(label, say("is larger than {most} MiB, the most that is read", most=LONGEST >> 20))
    return raw, label


def _nearest(path: str) -> str:
    """Return a hint at the nearest file name in the folder of a path."""
    folder, name = os.path.split(path)
    with suppress(OSError):
        return did_you_mean(name, os.listdir(folder or "."))
    return ""


def decoded(raw: bytes, label: str) -> Source:
    """Return the text of a file: UTF-8, or UTF-16 with its mark, as PowerShell writes; else a ``SpecError``."""
    if raw.startswith(b"%PDF"):
        raise _refused(label, say("is a PDF; a spec is a text in TOML or JSON"))
    wide = raw.startswith((b"\xff\xfe", b"\xfe\xff"))
    try:
        return Source(label, raw.decode("utf-16" if wide else "utf-8-sig"))
    except UnicodeDecodeError as error:
        line = raw.count(b"\n", 0, error.start) + 1
        raise _refused(label, say("is not UTF-8 text (line {line}): save it as UTF-8", line=line)) from None


def _refused(label: str, message: str, path: str = "") -> SpecError:
    return SpecError(label, [Problem(path, None, message)])


def _at_line(source: Source, number: int, message: str) -> SpecError:
    """Return the error of a parser with the line it names, 0: the last."""
    lines = source.text.rstrip().split("\n")
    number = number or len(lines)
    text = lines[number - 1] if number <= len(lines) else ""
    return SpecError(source, [Problem("", None, message, Place(number, text))])


def parse(source: Source) -> dict[str, object]:
    """Parse TOML or JSON text, what begins with a brace; a ``SpecError`` where it is neither, or beyond a limit."""
    if not source.text.strip():
        raise _refused(source, say("is empty; a clutch spec in TOML or JSON is wanted"))
    try:
        data = _json_of(source) if is_json(source) else toml_of(source)
    except RecursionError:
        raise _refused(source, too_deep()) from None
    check_size(data, source)
    return data


def is_json(source: Source) -> bool:
    """True if a text is meant as JSON."""
    return source.text.lstrip()[:1] == "{" or source.endswith(".json")


def toml_of(source: Source) -> dict[str, object]:
    """Parse TOML text; a ``SpecError`` where it is none, or too long."""
    if len(source.text) > LONGEST_TOML:
        raise _refused(source, say("is larger than {most} KiB, the most for TOML", most=LONGEST_TOML >> 10))
    # a dotted key of very many parts would take gigabytes to read
    if re.search(_LONG_KEY, source.text):
        raise _refused(source, say("a key has more than {most} parts, the most there may be", most=DEEPEST))
    try:
        return tomllib.loads(source.text)
    except tomllib.TOMLDecodeError as error:
        line = re.search(r"at line (\d+)", str(error))
        bare = str(error).startswith(("Invalid value", "Expected newline"))
        hint = say('; text, a decimal comma and a unit stand in quotes: "2,5 kN"') if bare else ""
        message = say("is not valid TOML: {why}{hint}", why=error, hint=hint)
        raise _at_line(source, int(line[1]) if line else 0, message) from None
    except ValueError:
        raise _refused(source, say("is not valid TOML: a number has too many digits")) from None


def _json_of(source: Source) -> dict[str, object]:
    def unique(pairs: list[tuple[str, object]]) -> dict[str, object]:
        seen: dict[str, object] = {}
        for key, value in pairs:
            if key in seen:
                raise _refused(source, say("is not a spec: key {key!r} stands twice in one JSON object", key=key))
            seen[key] = value
        return seen

    try:
        data = json.loads(source.text, object_pairs_hook=unique)
    except json.JSONDecodeError as error:
        raise _at_line(source, error.lineno, say("is not valid JSON: {why}", why=error.msg)) from None
    except AfmcalcError:
        raise
    except ValueError:
        raise _refused(source, say("is not valid JSON: a number has too many digits")) from None
    if not isinstance(data, dict):
        raise _refused(source, say("is not a spec: a JSON object is wanted"))
    spec = data.get("spec", data)
    if spec is None and "command" in data:
        raise _refused(source, say("the output of {command!r} carries no clutch", command=data["command"]))
    if not isinstance(spec, dict):
        raise _refused(source, say("its spec block is no object"))
    return spec


def check_size(data: object, label: str) -> None:
    """Hold parsed data to every limit; a ``SpecError`` where it is beyond one."""
    left: list[tuple[str, int, object]] = [("", 0, data)]
    for path, depth, value in left:
        texts = [*value] if isinstance(value, dict) else [value] if isinstance(value, str) else []
        if depth > DEEPEST:
            raise _refused(label, too_deep())
        if len(left) > MOST_VALUES:
            raise _refused(label, say("has more than {most:,} values", most=MOST_VALUES))
        if any(len(text) > LONGEST_TEXT for text in texts):
            why = say("has more than {most:,} characters", most=LONGEST_TEXT)
        elif any(re.search("[\ud800-\udfff]", text) for text in texts):  # JSON spells them, a shell hands on bytes
            why = say("holds a lone surrogate, which is no character")
        elif isinstance(value, int) and value.bit_length() > MOST_BITS:
            why = say("is beyond the range of numbers")
        else:
            if isinstance(value, dict):
                left += [(f"{path}.{key}" if path else key, depth + 1, inner) for key, inner in value.items()]
            elif isinstance(value, list):
                left += [(path, depth + 1, inner) for inner in value]
            continue
        raise _refused(label, why, path)


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
