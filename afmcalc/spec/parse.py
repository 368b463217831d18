"""From a file to plain data: bytes, text, TOML or JSON, within stated limits; the examples that ship."""

import json
import os
import re
import sys
import tomllib
from contextlib import suppress
from os import PathLike
from pathlib import Path

from ..errors import AfmcalcError, FileError, Place, Problem, SpecError, reason
from ..messages import deferred, did_you_mean, say, translate
from .source import Source

_STANDARD_INPUT = deferred("standard input")
PREFIX = "example:"
"""Prefix that makes the name of an example a source."""


def _folder() -> Path:
    """Where the examples are: inside the installed package, or beside it in a checkout."""
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

    # JSON of very many values would take gigabytes to read
    if source.text.count(",") > MOST_COMMAS or source.text.count("{") + source.text.count("[") > MOST_BRACKETS:
        raise _refused(source, say("holds more than {most:,} values, the most that are read", most=MOST_COMMAS))
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
    keys = items = 0
    left: list[tuple[str, int, object]] = [("", 0, data)]
    while left:
        path, depth, value = left.pop()
        if depth > DEEPEST:
            raise _refused(label, too_deep())
        if isinstance(value, dict):
            if (keys := keys + len(value)) > MOST_KEYS:
                raise _refused(label, say("has more than {most:,} keys", most=MOST_KEYS))
            if any(len(key) > LONGEST_TEXT for key in value):
                raise _refused(label, say("a key has more than {most:,} characters", most=LONGEST_TEXT), path)
            if any(map(_has_surrogate, value)):
                raise _refused(label, say("holds a lone surrogate, which is no character"), path)
            left += [(f"{path}.{key}" if path else key, depth + 1, inner) for key, inner in value.items()]
        elif isinstance(value, list):
            if (items := items + len(value)) > MOST_ITEMS:
                raise _refused(label, say("has more than {most:,} items in its lists", most=MOST_ITEMS))
            left += [(path, depth + 1, inner) for inner in value]
        elif isinstance(value, str) and len(value) > LONGEST_TEXT:
            raise _refused(label, say("has more than {most:,} characters", most=LONGEST_TEXT), path)
        elif isinstance(value, str) and _has_surrogate(value):
            raise _refused(label, say("holds a lone surrogate, which is no character"), path)
        elif isinstance(value, int) and value.bit_length() > MOST_BITS:
            raise _refused(label, say("is beyond the range of numbers"), path)


def _has_surrogate(text: str) -> bool:
    """True if a text cannot be written as UTF-8: JSON spells halves of characters, a shell hands on bytes."""
    return re.search("[\ud800-\udfff]", text) is not None
