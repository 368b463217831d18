"""From text to spec: TOML or JSON, a path, standard input or the built-in default."""

import json
import sys
from collections.abc import Iterable
from os import PathLike
from typing import TypeVar

from pydantic import BaseModel, ValidationError

from ..errors import AfmcalcError, FileError, SpecError
from ..messages import say
from .models import Spec
from .rules import Table

STANDARD_INPUT = "standard input"
BUILT_IN = "built-in default"


def read_spec(source: str | PathLike[str] | None = None, overrides: Iterable[str] = ()) -> Spec:
    """Read a clutch spec.

    Args:
        source: path of a TOML or JSON file, ``"-"`` for standard input, ``"example:NAME"`` for a file that ships,
            None for the built-in base clutch.
            JSON printed by any command counts: its ``spec`` block is taken.
        overrides: ``"path=value"`` strings applied before validation; an empty value removes the key.

    Returns:
        The validated spec, SI inside.

    Raises:
        SpecError: every problem found, with file, key, value and what is allowed.
        FileError: the file cannot be read.
    """
    text, label = text_of(source)
    data = apply_overrides(parse(text, label), overrides)
    return make_spec(data, label)


M = TypeVar("M", bound=BaseModel)


def make_spec(data: Table, label: str = "spec") -> Spec:
    """Validate a spec given as nested mappings; ``label`` names it in errors."""
    return validated(Spec, data, label)


def validated(model: type[M], data: Table, label: str) -> M:
    """Validate plain data, read from where ``label`` says.

    Raises:
        SpecError: every problem found.
    """
    try:
        return model.model_validate(dict(data), context=label)
    except ValidationError as error:
        from .problems import problems_of

        raise SpecError(label, problems_of(error, data, model)) from None


def text_of(source: str | PathLike[str] | None) -> tuple[str, str]:
    """Return the text of a spec as given, and what to call it in messages.

    Raises:
        FileError: it cannot be read.
    """
    if source is None:
        from .builtin import default_text

        return default_text(), BUILT_IN
    label = STANDARD_INPUT if source == "-" else str(source)
    if label.startswith("example:"):
        from .builtin import PREFIX, example_text

        return example_text(label.removeprefix(PREFIX)), label
    try:
        if source == "-":
            raw = sys.stdin.buffer.read()
        else:
            with open(source, "rb") as file:
                raw = file.read()
    except OSError as error:
        raise FileError(say("{label}: cannot be read: {why}", label=label, why=error.strerror or error)) from None
    except ValueError as error:
        raise FileError(say("{label}: cannot be read: {why}", label=label, why=error)) from None
    try:
        return raw.decode("utf-8-sig"), label
    except UnicodeDecodeError as error:
        raise AfmcalcError(say("{label}: is not UTF-8 text (byte {byte})", label=label, byte=error.start)) from None


def parse(text: str, label: str) -> dict[str, object]:
    """Parse TOML or JSON text; JSON is what begins with a bracket or brace that TOML could not."""
    start = text.lstrip()[:1]
    if not start:
        raise AfmcalcError(say("{label}: is empty; a clutch spec in TOML or JSON is wanted", label=label))
    if start == "{" or label.endswith(".json"):
        return _parse_json(text, label)
    import tomllib

    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise AfmcalcError(say("{label}: is not valid TOML: {why}", label=label, why=error)) from None
    except RecursionError:
        raise AfmcalcError(say("{label}: is nested too deeply for a spec", label=label)) from None
    except ValueError:
        raise AfmcalcError(say("{label}: is not valid TOML: a number has too many digits", label=label)) from None


def _parse_json(text: str, label: str) -> dict[str, object]:
    def unique(pairs: list[tuple[str, object]]) -> dict[str, object]:
        seen: dict[str, object] = {}
        for key, value in pairs:
            if key in seen:
                raise AfmcalcError(
                    say("{label}: is not a spec: key {key!r} stands twice in one JSON object", label=label, key=key)
                )
            seen[key] = value
        return seen

    try:
        data = json.loads(text, object_pairs_hook=unique)
    except json.JSONDecodeError as error:
        raise AfmcalcError(say("{label}: is not valid JSON: {why}", label=label, why=error)) from None
    except RecursionError:
        raise AfmcalcError(say("{label}: is nested too deeply for a spec", label=label)) from None
    except ValueError:
        raise AfmcalcError(say("{label}: is not valid JSON: a number has too many digits", label=label)) from None
    if not isinstance(data, dict):
        raise AfmcalcError(say("{label}: is not a spec: a JSON object is wanted", label=label))
    if "spec" in data:
        if data["spec"] is None and "command" in data:
            raise AfmcalcError(
                say("{label}: the output of {command!r} carries no clutch", label=label, command=data["command"])
            )
        data = data["spec"]
        if not isinstance(data, dict):
            raise AfmcalcError(say("{label}: its spec block is no object", label=label))
    return data


def apply_overrides(data: dict[str, object], overrides: Iterable[str], model: type[BaseModel] = Spec) -> Table:
    """Apply ``path=value`` overrides to parsed data; an empty value removes the key."""
    for override in overrides:
        *blocks, name = _path(override, model)
        block = data
        for depth, part in enumerate(blocks, start=1):
            nested = block.setdefault(part, {})
            if not isinstance(nested, dict):
                path = ".".join(blocks[:depth])
                raise AfmcalcError(say("--set {override}: {path} is no table", override=override, path=path))
            block = nested
        if text := override.partition("=")[2].strip():
            block[name] = _override_value(text)
        else:
            block.pop(name, None)
    return data


def _path(override: str, model: type[BaseModel]) -> list[str]:
    """Parts of the path an override names; a symbol stands for its path."""
    from .paths import ALIASES
    from .suggest import did_you_mean
    from .walk import names_in

    name, separator, _ = override.partition("=")
    path = ALIASES.get(name.strip(), name.strip()) if model is Spec else name.strip()
    if not separator or not path:
        raise AfmcalcError(
            say("--set {override}: write PATH=VALUE, for example control_unit.gain=0.5", override=override)
        )
    *blocks, last = path.split(".")
    known = names_in(tuple(blocks), model)
    if last not in known:
        hint = did_you_mean(last, known)
        if known and not hint:
            hint = say("; known here: {names}", names=", ".join(known))
        raise AfmcalcError(say("--set {override}: unknown key {path!r}{hint}", override=override, path=path, hint=hint))
    return [*blocks, last]


def _override_value(text: str) -> object:
    """Read a number, boolean, quoted string or inline table as TOML, anything else as plain text."""
    import tomllib

    try:
        return tomllib.loads(f"value = {text}")["value"]
    except (tomllib.TOMLDecodeError, KeyError):
        return text
