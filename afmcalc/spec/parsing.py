"""From a file to plain data: bytes, text, TOML or JSON, within stated limits."""

import json
import sys
from os import PathLike

from ..errors import AfmcalcError, FileError, Problem, SpecError, reason
from ..messages import say
from ..source import BUILT_IN, STANDARD_INPUT, Source
from .limits import LONGEST, LONGEST_TOML, check_counts, check_key_lengths, check_size, too_deep


def text_of(source: str | PathLike[str] | None) -> tuple[str, Source]:
    """Return the text of a spec as given, and what to call it in messages.

    Raises:
        FileError: it cannot be read.
        SpecError: it is no text, or too long for a spec.
    """
    raw, label = bytes_of(source)
    return text_in(raw, label)


def bytes_of(source: str | PathLike[str] | None) -> tuple[bytes, str]:
    """Return what is in the file of a spec, and what to call it in messages.

    Raises:
        FileError: it cannot be read.
        SpecError: it is too long for a spec.
    """
    if source is None:
        from .builtin import default_text

        return default_text().encode(), BUILT_IN
    label = STANDARD_INPUT if source == "-" else str(source)
    if label.startswith("example:"):
        from .builtin import PREFIX, example_text

        return example_text(label.removeprefix(PREFIX)).encode(), label
    try:
        if source == "-":
            raw = sys.stdin.buffer.read(LONGEST + 1)
        else:
            with open(source, "rb") as file:
                raw = file.read(LONGEST + 1)
    except OSError as error:
        raise FileError(say("{label}: cannot be read: {why}", label=label, why=reason(error))) from None
    except ValueError as error:
        raise FileError(say("{label}: cannot be read: {why}", label=label, why=error)) from None
    if len(raw) > LONGEST:
        raise _refused(label, say("is larger than {most} MiB, the most that is read", most=LONGEST >> 20))
    return raw, label


def text_in(raw: bytes, label: str) -> tuple[str, Source]:
    """Return the text of a file, and its name with the text.

    Raises:
        SpecError: it is no text.
    """
    text = _decoded(raw, label)
    return text, Source(label, text)


def _decoded(raw: bytes, label: str) -> str:
    """Text of a file: UTF-8, or UTF-16 with its mark, as PowerShell writes."""
    if raw.startswith((b"\xff\xfe", b"\xfe\xff")):
        try:
            return raw.decode("utf-16")
        except UnicodeDecodeError as error:
            raise _refused(label, say("is not UTF-16 text (byte {byte})", byte=error.start)) from None
    try:
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = raw.count(b"\n", 0, error.start) + 1
        raise _refused(
            label, say("is not UTF-8 text (line {line}, byte {byte}): save it as UTF-8", line=line, byte=error.start)
        ) from None


def _refused(label: str, message: str) -> SpecError:
    return SpecError(label, [Problem("", None, message)])


def parse(text: str, label: str) -> dict[str, object]:
    """Parse TOML or JSON text; JSON is what begins with a bracket or brace that TOML could not.

    Raises:
        SpecError: it is neither, or beyond a limit.
    """
    if not text.strip():
        raise _refused(label, say("is empty; a clutch spec in TOML or JSON is wanted"))
    try:
        data = _json_of(text, label) if is_json(text, label) else toml_of(text, label)
    except RecursionError:
        raise _refused(label, too_deep()) from None
    check_size(data, label)
    return data


def is_json(text: str, label: str) -> bool:
    """Whether a text is meant as JSON."""
    return text.lstrip()[:1] == "{" or label.endswith(".json")


def toml_of(text: str, label: str) -> dict[str, object]:
    """Parse TOML text.

    Raises:
        SpecError: it is none, or beyond a limit.
    """
    import tomllib

    if len(text) > LONGEST_TOML:
        raise _refused(label, say("is larger than {most} KiB, the most for TOML", most=LONGEST_TOML >> 10))
    check_key_lengths(text, label)
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        from .syntax import toml_problem

        raise SpecError(label, [toml_problem(text, error)]) from None
    except ValueError:
        raise _refused(label, say("is not valid TOML: a number has too many digits")) from None


def _json_of(text: str, label: str) -> dict[str, object]:
    def unique(pairs: list[tuple[str, object]]) -> dict[str, object]:
        seen: dict[str, object] = {}
        for key, value in pairs:
            if key in seen:
                raise _refused(label, say("is not a spec: key {key!r} stands twice in one JSON object", key=key))
            seen[key] = value
        return seen

    check_counts(text, label)
    try:
        data = json.loads(text, object_pairs_hook=unique)
    except json.JSONDecodeError as error:
        from .syntax import json_problem

        raise SpecError(label, [json_problem(text, error)]) from None
    except AfmcalcError:
        raise
    except ValueError:
        raise _refused(label, say("is not valid JSON: a number has too many digits")) from None
    if not isinstance(data, dict):
        raise _refused(label, say("is not a spec: a JSON object is wanted"))
    if "spec" in data:
        if data["spec"] is None and "command" in data:
            raise _refused(label, say("the output of {command!r} carries no clutch", command=data["command"]))
        data = data["spec"]
        if not isinstance(data, dict):
            raise _refused(label, say("its spec block is no object"))
    return data
