"""Reading of a spec from a TOML or JSON file, standard input, an example or plain data; with overrides."""

import json
import os
import tomllib
from collections.abc import Collection, Iterable, Mapping, MutableMapping
from copy import deepcopy
from os import PathLike
from typing import Any

from pydantic import ValidationError

from ..errors import AfmcalcError, Problem
from ..findings import Finding
from ..messages import did_you_mean, say
from .catalogues import READ, Lists
from .fields import Broken, names_in
from .keys import OLD, elsewhere, key_of_number, moved_in, names, path_of
from .models import Spec
from .parse import PREFIX, Source, check_size, is_json, parse, text_of, too_deep, too_long
from .problems import given_at, instead_of, problems_in
from .quantity import asked_unit
from .rules import Table, given_in
from .search import flat

Overrides = Collection[str] | Mapping[str, object]
"""Texts ``path=value``, where an empty value removes the key; or path → value, where None removes it."""

_SEARCH = "search."


def read_spec(source: str | PathLike[str] | Mapping[str, object] | None = None, overrides: Overrides = ()) -> Spec:
    """Validated spec of a clutch, values in SI, read from a source.

    Args:
        source: path of a TOML or JSON file, ``"-"`` for standard input, ``"example:NAME"`` for a file that ships,
            None for ``example:default``; or plain data of the same structure.
            JSON printed by any command is accepted: its ``spec`` block is taken.
        overrides: applied before validation; names and symbols are accepted as paths.

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
    """Validated spec of a text; arguments and errors as of ``read_spec``."""
    return make_spec(*data_of(source, overrides))


def data_of(source: Source, overrides: Overrides) -> tuple[dict[str, object], Source, list[Broken]]:
    """Data of a text with overrides applied, name of the text, and numbers that cannot be meant in SI.

    The name has the warnings about numbers without a unit that are probably not meant in SI. JSON is written by
    programs, in SI, so that only its overrides are examined.
    """
    data = parse(source)
    _locate(data, source)
    changed = apply_overrides(data, overrides) if overrides else {}
    _locate(data, "")
    in_si, questions, broken = is_json(source), list[Finding | None](), list[Broken]()
    for path, value in given_in(data).items():
        if path.endswith(".spread") or (in_si and path not in changed) or not (key := key_of_number(path)):
            continue
        try:
            questions += [
                asked_unit(number, key.unit, path) for number in (value if isinstance(value, list) else [value])
            ]
        except ValueError as error:
            broken.append((path, str(error)))
    by = "--set" if source.startswith(PREFIX) else ""
    told = {"overridden": dict.fromkeys(changed, by), "findings": tuple(filter(None, questions))}
    return data, Source(source, **vars(source) | told), broken


def _locate(data: Mapping[str, object], beside: str) -> None:
    """Make catalogue paths absolute: relative to the file ``beside`` or, if empty, to the working directory."""
    if isinstance(listed := data.get("catalogues"), dict):
        folder = os.path.dirname(os.path.abspath(beside or "-"))
        listed |= {name: os.path.join(folder, file) for name, file in listed.items() if isinstance(file, str)}


def make_spec(data: Table, label: str = "spec", broken: Iterable[Broken] = ()) -> Spec:
    """Validated spec from nested mappings; ``label``: its name in errors; ``broken``: problems found in its text.

    Raises SpecError with every problem found.
    """
    source = label if isinstance(label, Source) else Source(label)
    if not OLD.isdisjoint(data) and (moved := moved_in(given_in(data))):
        told = ((path, say("is now {place}, in a spec with [search]", place=place)) for path, place in moved.items())
        raise source.refused(Problem(path, None, message) for path, message in told)
    if isinstance(named := data.get("catalogues"), Mapping):
        files = {name: file for name, file in named.items() if isinstance(file, str)}
        source.lists = Lists(**{name: read(files[name]) for name, read in READ.items() if name in files})
    problems, more = [Problem(path, given_at(path, data), message) for path, message in broken], 0
    try:
        spec = Spec.model_validate(dict(data), context=source)
        if not problems:
            return spec
    except ValidationError as error:
        found, more = problems_in(error, data, Spec, elsewhere)
        problems += found
    raise source.refused(problems, more)


def put(data: MutableMapping[str, Any], path: str, value: Any) -> None:
    """Set a nested value (None removes it); raises ``ValueError`` with the path of a parent that is no table."""
    *blocks, name = path.split(".")
    for depth, block in enumerate(blocks, start=1):
        if block not in data:
            if value is None:
                return
            data[block] = {}
        data = data[block]
        if not isinstance(data, MutableMapping):
            raise ValueError(".".join(blocks[:depth]))
    if value is None:
        data.pop(name, None)
    else:
        data[name] = value


def apply_overrides(data: dict[str, object], overrides: Overrides) -> dict[str, object]:
    """Apply overrides to parsed data; return their dotted paths and values."""
    changed: dict[str, object] = {}
    for given in overrides:
        if isinstance(overrides, Mapping):
            override, value = f"{given}={overrides[given]}", overrides[given]
            value = value.tolist() if hasattr(value, "tolist") else value  # NumPy numbers become Python numbers
        else:
            override, value = given, _value(given)
        path = _path(override)
        changed[path] = value
        if path.startswith(_SEARCH) and isinstance(table := data.setdefault("search", {}), dict):
            data["search"] = flat(table) | {path.removeprefix(_SEARCH): value}
            continue
        try:
            put(data, path, value)
        except ValueError as error:
            raise AfmcalcError("--set {override:.80}: {path} is no table", override=override, path=error) from None
    return changed


def key_of(override: str) -> str:
    """Key of an override as given; raises ``AfmcalcError`` if the equals sign or the key before it is missing."""
    given, separator, _ = override.partition("=")
    if not separator or not given.strip():
        raise AfmcalcError(
            "--set {override:.80}: write PATH=VALUE, both and the equals sign in one word, for example "
            "control_unit.gain=0.5",
            override=override,
        )
    return given.strip()


def _path(override: str) -> str:
    """Path of the key that an override names by path, name or symbol."""
    given = key_of(override)
    if given.startswith(_SEARCH):
        name = given.removeprefix(_SEARCH)
        return _SEARCH + (path_of(name) or name)
    path = path_of(given) or given
    *blocks, last = path.split(".")
    known = names_in(blocks, Spec)
    if last not in known:
        hint = instead_of(path) or did_you_mean(last, known) or elsewhere(last) or did_you_mean(last, names())
        if known and not hint:
            hint = say("; known here: {names}", names=", ".join(known))
        raise AfmcalcError(
            "--set {override:.80}: unknown key {path!r:.80}{hint}", override=override, path=path, hint=hint
        )
    return path


def _value(override: str) -> object:
    """Value of an override: number, boolean, quoted string or table as in TOML, else the text itself; None if empty."""
    text = override.partition("=")[2].strip()
    if not text:
        return None
    try:
        read = tomllib.loads(f"value = {text}")
    except tomllib.TOMLDecodeError:
        return text
    except (RecursionError, ValueError) as error:
        why = too_deep() if isinstance(error, RecursionError) else too_long()
        raise AfmcalcError("--set {override:.80}: {why}", override=override, why=why) from None
    if set(read) != {"value"}:  # the text has further lines
        return text
    check_size(read["value"], say("--set {override:.80}", override=override))
    return read["value"]


def as_override(value: object) -> str:
    """Text of a value in an override, which ``_value`` reads back.

    >>> as_override("2 kN"), as_override("0.5"), as_override(True), as_override(["a", 1])
    ('2 kN', '"0.5"', 'true', '["a", 1]')
    """
    if isinstance(value, str) and value.strip() == value != "" and _value(f"={value}") == value:
        return value
    # text, number, boolean or list in JSON is also valid TOML
    return json.dumps(value, ensure_ascii=False)
