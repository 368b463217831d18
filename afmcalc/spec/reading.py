"""From text to spec: TOML or JSON, a path, standard input or the built-in default."""

from collections.abc import Mapping
from copy import deepcopy
from os import PathLike
from typing import TypeVar

from pydantic import BaseModel, ValidationError

from ..errors import SpecError
from ..source import Source
from .models import Spec
from .overrides import Overrides, apply_overrides, overridden
from .parsing import parse, text_of
from .rules import Table


def read_spec(source: str | PathLike[str] | Mapping[str, object] | None = None, overrides: Overrides = ()) -> Spec:
    """Read a clutch spec.

    Args:
        source: path of a TOML or JSON file, ``"-"`` for standard input, ``"example:NAME"`` for a file that ships,
            None for the built-in base clutch; or plain data of the same structure.
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
        return make_spec(apply_overrides(deepcopy(dict(source)), overrides))
    return spec_of(*text_of(source), overrides)


def spec_of(text: str, label: Source, overrides: Overrides = ()) -> Spec:
    """Read a clutch spec from its text, named ``label``; see ``read_spec``."""
    data = apply_overrides(parse(text, label), overrides)
    return make_spec(data, label.but(overridden(overrides)))


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
        from .problems import mistaken, problems_of

        if mistake := mistaken(data, model):
            raise SpecError(label, [mistake]) from None
        raise SpecError(label, *problems_of(error, data, model)) from None
