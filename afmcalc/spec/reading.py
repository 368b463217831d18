"""From text to spec: TOML or JSON, a path, standard input or the built-in default."""

from collections.abc import Iterator, Mapping
from copy import deepcopy
from os import PathLike
from typing import TypeVar

from pydantic import BaseModel, ValidationError

from ..errors import Problem, SpecError
from ..source import Source
from .models import Spec
from .overrides import Overrides, apply_overrides, overridden
from .parsing import is_json, parse, text_of
from .quantity import unlikely
from .rules import Table, get
from .walk import keys_below


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
    return make_spec(*data_of(text, label, overrides, Spec))


def data_of(text: str, label: Source, overrides: Overrides, model: type[BaseModel]) -> tuple[Table, Source]:
    """Parse a text and override its values; what it is called then knows the numbers without a unit to ask after.

    JSON is what programs write, in SI: there only an override may be meant otherwise.
    """
    data = apply_overrides(parse(text, label), overrides, model)
    paths = overridden(overrides, model)
    asked = [key for key in keys_below(model).values() if key.path in paths or not is_json(text, label)]
    numbers = ((key, value) for key in asked for value in _numbers(get(data, *key.path.split("."))))
    doubts = [each for key, value in numbers if (each := unlikely(value, key.unit, key.path))]
    return data, Source(label, label.text, label.overridden.union(paths), doubts)


def _numbers(value: object) -> Iterator[object]:
    """What stands in a list or a range, or a value itself."""
    if isinstance(value, dict):
        yield from (each for name, each in value.items() if name in ("start", "stop", "step"))
    elif isinstance(value, list):
        yield from value
    else:
        yield value


M = TypeVar("M", bound=BaseModel)


def make_spec(data: Table, label: str = "spec") -> Spec:
    """Validate a spec given as nested mappings; ``label`` names it in errors."""
    return validated(Spec, data, label)


def validated(model: type[M], data: Table, label: str) -> M:
    """Validate plain data, read from where ``label`` says.

    Raises:
        SpecError: every problem found.
    """
    doubts = label.doubts if isinstance(label, Source) else ()
    problems: list[Problem] = []
    more = 0
    try:
        made = model.model_validate(dict(data), context=label)
        if all(each.possible for each in doubts):
            return made
    except ValidationError as error:
        from .problems import mistaken, problems_of

        if mistake := mistaken(data, model):
            raise SpecError(label, [mistake]) from None
        problems, more = problems_of(error, data, model)
    from .problems import too_large

    raise SpecError(label, [*too_large(doubts, data), *problems], more)
