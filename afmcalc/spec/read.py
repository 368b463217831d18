"""From a source to a spec: a file in TOML or JSON, standard input, an example, plain data; with overrides."""

import json
import os
import re
import tomllib
from collections.abc import Collection, Iterable, Mapping
from copy import deepcopy
from os import PathLike
from typing import Any, TypeAlias

from pydantic import ValidationError

from ..errors import AfmcalcError, Problem, SpecError
from ..messages import did_you_mean, say
from .fields import Broken, keys_below, names_in
from .keys import elsewhere, names, path_of
from .models import Spec
from .parse import PREFIX, Source, check_size, is_json, parse, text_of, too_deep
from .problems import given_at, problems_in
from .quantity import asked_unit
from .removed import OLD, instead_of, moved_in
from .rules import Table, given_in
from .search import flat

Overrides: TypeAlias = Collection[str] | Mapping[str, object]
"""Texts ``path=value``, an empty value removes the key; or path → value, None removes it."""

_SEARCH = "search."


def read_spec(source: str | PathLike[str] | Mapping[str, object] | None = None, overrides: Overrides = ()) -> Spec:
    """Read a clutch spec.

    Args:
        source: path of a TOML or JSON file, ``"-"`` for standard input, ``"example:NAME"`` for a file that ships,
            None for ``example:default``; or plain data of the same structure.
            JSON printed by any command counts: its ``spec`` block is taken.
        overrides: ``"path=value"`` strings applied before validation, an empty value removes the key; or path → value,
            None removes the key. A name or a symbol stands for its path.

    Returns:
        The validated spec, SI inside.

    Raises:
        SpecError: every problem found, with file, line, key, value and what is allowed.
        FileError: the file cannot be read.
    """
    if isinstance(source, Mapping):
        data = deepcopy(dict(source))
        apply_overrides(data, overrides)
        return make_spec(data)
    return spec_of(text_of(source), overrides)


def spec_of(source: Source, overrides: Overrides = ()) -> Spec:
    """Read a clutch spec from its text; see ``read_spec``."""
    return make_spec(*data_of(source, overrides))


def data_of(source: Source, overrides: Overrides) -> tuple[dict[str, object], Source, list[Broken]]:
    """Parse a text and override its values.

    What it is called then asks after numbers without a unit; those that cannot be meant in SI are returned. JSON is
    what programs write, in SI: there only an override may be meant otherwise.
    """
    data = parse(source)
    _locate(data, source)
    changed = apply_overrides(data, overrides) if overrides else {}
    _locate(data, "")
    in_si, known = is_json(source), keys_below(Spec)
    questions, broken = [], []
    for path, value in given_in(data).items():
        # center and ends of what scatters are in the unit of its key
        key = known.get(path) or known.get(re.sub(r"^(tolerance\.fields|search)\.|\.(center|min|max)$", "", path))
        if key and key.unit not in (None, "1") and (path in changed or not in_si):
            numbers = value if isinstance(value, list) else [value]
            try:
                questions += [asked_unit(number, key.unit, path) for number in numbers if not isinstance(number, str)]
            except ValueError as error:
                broken.append((path, str(error)))
    by = "--set" if source.startswith(PREFIX) else ""
    return data, Source(source, source.text, dict.fromkeys(changed, by), filter(None, questions)), broken


def _locate(data: Mapping[str, object], beside: str) -> None:
    """Make paths of catalogues whole: of a text they are relative to its file, of an override to where we are."""
    if isinstance(listed := data.get("catalogues"), dict):
        folder = os.path.dirname(os.path.abspath(beside or "-"))
        listed |= {name: os.path.join(folder, file) for name, file in listed.items() if isinstance(file, str)}


def make_spec(data: Table, label: str = "spec", broken: Iterable[Broken] = ()) -> Spec:
    """Validate a spec given as nested mappings; ``label`` names it in errors, ``broken`` are rules its text breaks.

    Raises SpecError: every problem found.
    """
    source = label if isinstance(label, Source) else Source(label)
    if not OLD.isdisjoint(data) and (moved := moved_in(given_in(data))):
        told = ((path, say("is now {place}, in a spec with [search]", place=place)) for path, place in moved.items())
        raise SpecError(source, [Problem(path, None, message) for path, message in told])
    if named := data.get("catalogues"):
        from .lists import own_lists

        source.lists = own_lists(named)
    problems, more = [Problem(path, given_at(path, data), message) for path, message in broken], 0
    try:
        spec = Spec.model_validate(dict(data), context=source)
        if not problems:
            return spec
    except ValidationError as error:
        found, more = problems_in(error, data, Spec)
        problems += found
    raise SpecError(source, problems, more)


def put(data: dict[str, Any], path: str, value: Any) -> None:
    """Set a nested value, None removes it; a ``ValueError`` has the path of a block on the way that is no table."""
    *blocks, name = path.split(".")
    for depth, block in enumerate(blocks, start=1):
        data = data.setdefault(block, {})
        if not isinstance(data, dict):
            raise ValueError(".".join(blocks[:depth]))
    if value is None:
        data.pop(name, None)
    else:
        data[name] = value


def apply_overrides(data: dict[str, object], overrides: Overrides) -> dict[str, object]:
    """Apply overrides to parsed data; return the dotted paths that they name, each with its value."""
    pairs: Iterable[tuple[str, object]]
    if isinstance(overrides, Mapping):
        pairs = (  # of NumPy its own numbers
            (f"{name}={value}", value.tolist() if hasattr(value, "tolist") else value)
            for name, value in overrides.items()
        )
    else:
        pairs = ((override, _value(override)) for override in overrides)
    changed: dict[str, object] = {}
    for override, value in pairs:
        path = _path(override)
        if path.startswith(_SEARCH) and isinstance(table := data.setdefault("search", {}), dict):
            data["search"] = dict(flat(table)) | {path.removeprefix(_SEARCH): value}
            changed[path] = value
            continue
        try:
            put(data, path, value)
        except ValueError as error:
            path = str(error)
            raise AfmcalcError("--set {override:.80}: {path} is no table", override=override, path=path) from None
        changed[path] = value
    return changed


def key_of(override: str) -> str:
    """Return the key of an override as given; refuse where there is no equals sign, or nothing before it."""
    given, separator, _ = override.partition("=")
    if not separator or not given.strip():
        raise AfmcalcError(
            "--set {override:.80}: write PATH=VALUE, both and the equals sign in one word, for example "
            "control_unit.gain=0.5",
            override=override,
        )
    return given.strip()


def _path(override: str) -> str:
    """Path of the key that an override gives by path, name or symbol."""
    given = key_of(override)
    if given.startswith(_SEARCH):
        name = given.removeprefix(_SEARCH)
        return _SEARCH + (path_of(name) or name)
    path = path_of(given) or given
    *blocks, last = path.split(".")
    known = names_in(blocks, Spec)
    if last not in known:
        hint = instead_of(path) or did_you_mean(last, known)
        hint = hint or elsewhere(last) or did_you_mean(last, names())
        if known and not hint:
            hint = say("; known here: {names}", names=", ".join(known))
        raise AfmcalcError(
            "--set {override:.80}: unknown key {path!r:.80}{hint}", override=override, path=path, hint=hint
        )
    return path


def _value(override: str) -> object:
    """Read a number, boolean, quoted string or inline table as TOML, anything else as plain text; nothing is None."""
    text = override.partition("=")[2].strip()
    if not text:
        return None
    try:
        read = tomllib.loads(f"value = {text}")
    except tomllib.TOMLDecodeError:
        return text
    except RecursionError:
        raise AfmcalcError("--set {override:.80}: {why}", override=override, why=too_deep()) from None
    except ValueError:
        raise AfmcalcError("--set {override:.80}: a number has too many digits", override=override) from None
    if set(read) != {"value"}:  # further lines are part of the text
        return text
    check_size(read["value"], say("--set {override:.80}", override=override))
    return read["value"]


def as_override(value: object) -> str:
    """Return the text that an override has for a value.

    >>> as_override("2 kN"), as_override("0.5"), as_override(True), as_override(["a", 1])
    ('2 kN', '"0.5"', 'true', '["a", 1]')
    """
    if isinstance(value, str) and value.strip() == value != "" and _value(f"={value}") == value:
        return value
    # what JSON writes of a text, a number, a truth value or a list is TOML
    return json.dumps(value, ensure_ascii=False)
