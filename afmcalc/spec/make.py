"""Plain data made a spec, or another model of a file."""

from collections.abc import Iterable
from typing import TypeVar

from pydantic import BaseModel, ValidationError

from ..errors import Problem, SpecError
from ..messages import say
from .catalogues import Lists
from .fields import Broken
from .lists import own_lists
from .models import Spec
from .problems import given_at, problems_in
from .removed import OLD, moved_in
from .rules import Table, given_in
from .source import Source

M = TypeVar("M", bound=BaseModel)


def make_spec(data: Table, label: str = "spec", broken: Iterable[Broken] = ()) -> Spec:
    """Validate a spec given as nested mappings; ``label`` names it in errors."""
    return validated(Spec, data, label, broken)


def validated(model: type[M], data: Table, label: str, broken: Iterable[Broken] = ()) -> M:
    """Validate plain data, read from where ``label`` says; ``broken`` are rules that its text breaks.

    Raises SpecError: every problem found.
    """
    problems = [Problem(path, given_at(path, data), message) for path, message in broken]
    more = 0
    label = label if isinstance(label, Source) else Source(label)
    named = data.get("catalogues")
    if not OLD.isdisjoint(data) and (moved := moved_in(given_in(data))):
        told = ((path, say("is now {place}, in a spec with [search]", place=place)) for path, place in moved.items())
        problems += [Problem(path, None, message) for path, message in told]
        raise SpecError(label, problems)
    label.lists = own_lists(named) if named else Lists()
    try:
        made = model.model_validate(dict(data), context=label)
        if not problems:
            return made
    except ValidationError as error:
        found, more = problems_in(error, data, model)
        problems += found
    raise SpecError(label, problems, more)
