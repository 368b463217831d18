"""From text to spec: TOML or JSON, a path, standard input or the built-in default."""

import json
import sys
from collections.abc import Iterable, Mapping
from os import PathLike
from typing import Any

from pydantic import BaseModel, ValidationError

from ..errors import AfmcalcError, FileError, Problem, SpecError
from .models import Spec

STANDARD_INPUT = "standard input"
BUILT_IN = "built-in default"


def read_spec(source: str | PathLike[str] | None = None, overrides: Iterable[str] = ()) -> Spec:
    """Read a clutch spec.

    Args:
        source: path of a TOML or JSON file, ``"-"`` for standard input, None for the built-in base clutch.
            JSON printed by any command counts: its ``spec`` block is taken.
        overrides: ``"path=value"`` strings applied before validation; an empty value removes the key.

    Returns:
        The validated spec, SI inside.

    Raises:
        SpecError: every problem found, with file, key, value and what is allowed.
        FileError: the file cannot be read.
    """
    text, label = text_of(source)
    data = apply_overrides(parse(text, label), overrides, label)
    return make_spec(data, label)


def make_spec(data: Mapping[str, Any], label: str = "spec") -> Spec:
    """Validate a spec given as nested mappings; ``label`` names it in errors."""
    try:
        return Spec.model_validate(dict(data))
    except ValidationError as error:
        raise SpecError(label, problems_of(error, data)) from None


def label_of(source: str | PathLike[str] | None) -> str:
    """What to call the source of a spec in messages."""
    if source is None:
        return BUILT_IN
    return STANDARD_INPUT if source == "-" else str(source)


def text_of(source: str | PathLike[str] | None) -> tuple[str, str]:
    """Return the text of a spec as given, and what to call it in messages.

    Raises:
        FileError: it cannot be read.
    """
    if source is None:
        from .builtin import default_text

        return default_text(), label_of(source)
    label = label_of(source)
    try:
        if source == "-":
            raw = sys.stdin.buffer.read()
        else:
            with open(source, "rb") as file:
                raw = file.read()
    except OSError as error:
        raise FileError(f"{label}: cannot be read: {error.strerror or error}") from None
    except ValueError as error:
        raise FileError(f"{label}: cannot be read: {error}") from None
    try:
        return raw.decode("utf-8-sig"), label
    except UnicodeDecodeError as error:
        raise AfmcalcError(f"{label}: is not UTF-8 text (byte {error.start})") from None


def parse(text: str, label: str) -> dict[str, Any]:
    """Parse TOML or JSON text; JSON is what begins with a bracket or brace that TOML could not."""
    start = text.lstrip()[:1]
    if not start:
        raise AfmcalcError(f"{label}: is empty; a clutch spec in TOML or JSON is wanted")
    if start == "{" or label.endswith(".json"):
        return _parse_json(text, label)
    import tomllib

    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise AfmcalcError(f"{label}: is not valid TOML: {error}") from None
    except RecursionError:
        raise AfmcalcError(f"{label}: is nested too deeply for a spec") from None
    except ValueError:
        raise AfmcalcError(f"{label}: is not valid TOML: a number has too many digits") from None


def _parse_json(text: str, label: str) -> dict[str, Any]:
    def unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        seen: dict[str, Any] = {}
        for key, value in pairs:
            if key in seen:
                raise AfmcalcError(f"{label}: is not a spec: key {key!r} stands twice in one JSON object")
            seen[key] = value
        return seen

    try:
        data = json.loads(text, object_pairs_hook=unique)
    except json.JSONDecodeError as error:
        raise AfmcalcError(f"{label}: is not valid JSON: {error}") from None
    except RecursionError:
        raise AfmcalcError(f"{label}: is nested too deeply for a spec") from None
    except ValueError:
        raise AfmcalcError(f"{label}: is not valid JSON: a number has too many digits") from None
    if not isinstance(data, dict):
        raise AfmcalcError(f"{label}: is not a spec: a JSON object is wanted")
    if "spec" in data:
        if data["spec"] is None and "command" in data:
            raise AfmcalcError(f"{label}: the output of {data['command']!r} carries no clutch")
        data = data["spec"]
        if not isinstance(data, dict):
            raise AfmcalcError(f"{label}: its spec block is no object")
    return data


def apply_overrides(
    data: dict[str, Any], overrides: Iterable[str], label: str, model: type[BaseModel] = Spec
) -> dict[str, Any]:
    """Apply ``path=value`` overrides to parsed data; an empty value removes the key."""
    for override in overrides:
        from .paths import ALIASES, names_in
        from .suggest import did_you_mean

        name, separator, text = override.partition("=")
        path = ALIASES.get(name.strip(), name.strip()) if model is Spec else name.strip()
        if not separator or not path:
            raise AfmcalcError(f"--set {override}: write PATH=VALUE, for example control_unit.gain=0.5")
        parts = path.split(".")
        if parts[-1] not in (known := names_in(tuple(parts[:-1]), model)):
            hint = did_you_mean(parts[-1], known) or (f"; known here: {', '.join(known)}" if known else "")
            raise AfmcalcError(f"--set {override}: unknown key {path!r}{hint}")
        block = data
        for depth, part in enumerate(parts[:-1], start=1):
            nested = block.setdefault(part, {})
            if not isinstance(nested, dict):
                raise AfmcalcError(f"--set {override}: {'.'.join(parts[:depth])} is no table")
            block = nested
        if text.strip():
            block[parts[-1]] = _override_value(text.strip())
        else:
            block.pop(parts[-1], None)
    return data


def _override_value(text: str) -> Any:
    """Read a number, boolean, quoted string or inline table as TOML, anything else as plain text."""
    import tomllib

    try:
        return tomllib.loads(f"value = {text}")["value"]
    except (tomllib.TOMLDecodeError, KeyError):
        return text


def problems_of(error: ValidationError, data: Mapping[str, Any], model: type[BaseModel] = Spec) -> list[Problem]:
    """Turn pydantic's errors into ours: path, value as written, what is allowed."""
    problems = []
    for detail in error.errors(include_url=False):
        location = tuple(str(part) for part in detail["loc"])
        problems.append(Problem(".".join(location), _given(location, data), _message(detail, location, model)))
    return list(dict.fromkeys(problems))


def _given(location: tuple[str, ...], data: Any) -> str | None:
    for part in location:
        if not isinstance(data, Mapping) or part not in data:
            return None
        data = data[part]
    if isinstance(data, Mapping):
        return None if location else "…"
    text = json.dumps(data, ensure_ascii=False, default=str)
    return text if len(text) <= 60 else text[:57] + "..."


def _message(detail: Any, location: tuple[str, ...], root: type[BaseModel]) -> str:
    from .paths import names_in
    from .suggest import did_you_mean

    context = detail.get("ctx", {})
    match detail["type"]:
        case "missing":
            return "required"
        case "extra_forbidden":
            return _unknown_key(location, root)
        case "model_type" | "model_attributes_type" | "dict_type":
            return f"must be a table with the keys {', '.join(names_in(location, root))}"
        case "literal_error":
            expected = context["expected"].replace("'", "").replace(" or ", ", ")
            return f"must be one of {expected}{did_you_mean(str(detail['input']), expected.split(', '))}"
        case "string_type":
            return "must be text in quotes"
        case "greater_than":
            return f"must be greater than {context['gt']:g}"
        case "greater_than_equal":
            return f"must be at least {context['ge']:g}"
        case "less_than_equal":
            return f"must be at most {context['le']:g}"
        case "less_than":
            if location[-1:] == ("wall_angle",):
                return "must be less than 90 deg (pi/2 rad)"
            return f"must be less than {context['lt']:g}"
        case _:
            message: str = detail["msg"]
            return message.removeprefix("Value error, ")


def _unknown_key(location: tuple[str, ...], root: type[BaseModel]) -> str:
    from .paths import keys, names_in
    from .suggest import did_you_mean

    *block, name = location
    allowed = names_in(tuple(block), root)
    if hint := did_you_mean(name, allowed):
        return f"unknown key{hint}"
    elsewhere = [path for path in keys(root) if path.rpartition(".")[2] == name]
    if elsewhere:
        return f"unknown key; did you mean {' or '.join(elsewhere)}?"
    return f"unknown key; allowed here: {', '.join(allowed)}"
