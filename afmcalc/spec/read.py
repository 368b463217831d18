"""From a source to a spec: a file in TOML or JSON, standard input, an example, plain data."""

import os
import re
from collections.abc import Mapping
from copy import deepcopy
from os import PathLike

from .edit import Overrides, apply_overrides
from .fields import Broken, keys_below
from .make import make_spec
from .models import Spec
from .parse import PREFIX, is_json, parse, text_of
from .quantity import asked_unit
from .rules import given_in
from .source import Source


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
