"""What pydantic finds wrong, told for people: path, value as written, what is allowed."""

import json
import math
import re
from collections.abc import Iterator, Mapping

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails

from ..errors import Problem
from ..messages import say
from .models import Spec
from .names import elsewhere
from .rules import RuleError, Table
from .suggest import did_you_mean
from .walk import choices_at, names_in

_MOST_TOLD = 100
"""Problems that are told; of the others the number."""


def problems_of(error: ValidationError, data: Table, model: type[BaseModel]) -> tuple[list[Problem], int]:
    """Problems of ``data``, each once, and how many more there are.

    What pydantic found, and the rules between keys that it met broken.
    """
    found = list(_found(error, ()))
    told = [_told(each, data, model) for each in found[:_MOST_TOLD]]
    return list(dict.fromkeys(told)), len(found[_MOST_TOLD:])


def mistaken(data: Table, model: type[BaseModel]) -> Problem | None:
    """Say that a file is of another kind than what is read, in one sentence; None when it is not."""
    if _REQUIRED.isdisjoint(data) and "variant" in data:
        wanted = say("is a clutch spec, no requirements: afmcalc init --kind requirements writes such a file")
        return Problem("", None, wanted) if model is not Spec else None
    if len(_REQUIRED & set(data)) > 1 and "variant" not in data and model is Spec:
        return Problem("", None, say("is a requirements file, no clutch: afmcalc design finds the clutches for it"))
    return None


_REQUIRED = frozenset(("variants", "objectives", "wanted", "search"))
"""What only a requirements file has."""


def _found(error: ValidationError, above: tuple[str, ...]) -> Iterator[Problem | tuple[ErrorDetails, tuple[str, ...]]]:
    """Problems of the table at the path ``above``; what pydantic found as it says it, with its path."""
    for detail in error.errors(include_url=False):
        location = (*above, *map(str, detail["loc"]))
        broken = detail.get("ctx", {}).get("error")
        if not isinstance(broken, RuleError):
            yield detail, location
            continue
        if broken.others:
            yield from _found(broken.others, location)
        for problem in broken.problems:
            yield problem._replace(path=".".join((*location, problem.path)))


def _told(found: Problem | tuple[ErrorDetails, tuple[str, ...]], data: Table, model: type[BaseModel]) -> Problem:
    if isinstance(found, Problem):
        return found._replace(given=_given(found.path, data))
    detail, location = found
    path = ".".join(location)
    given = _given(path, data)
    return Problem(path, given, _message(detail, location, given, model), detail["type"] == "extra_forbidden")


def _given(path: str, data: object) -> str | None:
    """Value at a path as it was written; keys may have dots themselves."""
    if not isinstance(data, Mapping):
        return None
    if path in data:
        if isinstance(data[path], Mapping):
            return None
        text = json.dumps(data[path], ensure_ascii=False, default=str)
        return text if len(text) <= 60 else text[:57] + "..."
    parts = path.split(".")
    splits = ((".".join(parts[:depth]), ".".join(parts[depth:])) for depth in range(1, len(parts)))
    return next((_given(below, data[block]) for block, below in splits if block in data), None)


def _message(detail: ErrorDetails, location: tuple[str, ...], given: str | None, root: type[BaseModel]) -> str:
    context = detail.get("ctx", {})
    match detail["type"]:
        case "missing":
            choices = ", ".join(choices_at(location, root))
            return say("required: one of {choices}", choices=choices) if choices else say("required")
        case "extra_forbidden":
            return _unknown_key(location, root)
        case "model_type" | "model_attributes_type" | "dict_type":
            names = ", ".join(names_in(location, root))
            return say("must be a table with the keys {names}", names=names) if names else say("must be a table")
        case "literal_error":
            expected = context["expected"].replace("'", "").replace(" or ", ", ")
            hint = did_you_mean(str(detail["input"]), expected.split(", "))
            return say("must be one of {expected}{hint}", expected=expected, hint=hint)
        case "string_type":
            return say("must be text in quotes")
        case "bool_type" | "bool_parsing":
            return say("must be true or false, without quotes")
        case "tuple_type":
            return say("must be a list in brackets")
        case "too_short":
            return say("must not be empty")
        case "greater_than":
            return say("must be greater than {bound:g}", bound=context["gt"])
        case "greater_than_equal":
            return say("must be at least {bound:g}", bound=context["ge"])
        case "less_than_equal":
            return say("must be at most {bound:g}", bound=context["le"])
        case "less_than":
            if location[-1:] == ("wall_angle",):
                return _too_steep(given)
            return say("must be less than {bound:g}", bound=context["lt"])
        case "value_error":
            return str(context["error"])
        case _:
            return detail["msg"]


def _too_steep(given: str | None) -> str:
    """Refuse a wall angle; what is no angle in rad may be one in deg."""
    if given and re.fullmatch(r"[\d.]+", given) and math.pi < float(given) < 90:
        return say('a plain number is in rad, and must be less than pi/2: write "{given} deg"', given=given)
    return say("must be less than 90 deg (pi/2 rad)")


def _unknown_key(location: tuple[str, ...], root: type[BaseModel]) -> str:
    *block, name = location
    allowed = names_in(tuple(block), root)
    if hint := did_you_mean(name, allowed) or elsewhere(name, root):
        return say("unknown key{hint}", hint=hint)
    return say("unknown key; allowed here: {names}", names=", ".join(allowed))
