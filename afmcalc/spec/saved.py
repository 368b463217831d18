"""A spec with other values as text: the file that was read, its comments and order kept, or a new one."""

import os
from collections.abc import Mapping
from typing import Any

from pydantic import BaseModel

from ..variants import foreign_keys
from .edit import replaced, value_at
from .keys import keys
from .models import Spec, resolved
from .parse import is_json
from .rules import given_in
from .write import to_toml, value_as_written, written


def saved(spec: Spec, changes: Mapping[str, Any], changed: Spec, folder: str = "") -> str:
    """Return the text of ``spec`` with other values of some keys.

    What was read as TOML keeps comments, order and the units of what stays; any other text is written anew.

    Args:
        spec: as it was read.
        changes: path → value, None for none.
        changed: the spec with these values.
        folder: where the text will be: its catalogues are relative to it.
    """
    source = spec.label
    if not source.text or is_json(source):
        return to_toml(resolved(changed))
    import tomlkit

    document = tomlkit.parse(source.text)
    overridden = {path: value_at(changed, path) for path in source.overridden}
    gone = dict.fromkeys(replaced(spec, changes))
    listed = spec.catalogues.model_dump(exclude_none=True) if spec.catalogues else {}
    lists = {f"catalogues.{name}": os.path.relpath(file, folder or ".") for name, file in listed.items()}
    changed_values = {path: value for path, value in changes.items() if value != value_at(spec, path)}
    values = {**overridden, **gone, **changed_values, **lists}
    for path, value in values.items():
        _put(document, path, value)
    for path in foreign_keys(given_in(document.unwrap()), changed.variant):
        _put(document, path, None)
    return tomlkit.dumps(document).rstrip() + "\n"


def _put(document: Any, path: str, value: Any) -> None:
    """Set a value in a document, or take it out; comments beside it stay."""
    *blocks, name = path.split(".")
    table = document
    for block in blocks:
        if block not in table:
            if value is None:
                return
            table[block] = {}
        table = table[block]
    if value is None:
        table.pop(name, None)
    else:
        key = keys().get(path)
        value = value.model_dump(exclude_none=True) if isinstance(value, BaseModel) else value
        table[name] = written(value, path) if isinstance(value, Mapping) else value_as_written(value, key and key.unit)
