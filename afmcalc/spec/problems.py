"""Problems of plain data, in sentences for people: path, value as written, what is allowed."""

import json
import math
import re
from collections.abc import Iterable, Mapping
from typing import Literal, get_args, get_origin

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails

from ..errors import Problem
from ..messages import did_you_mean, say
from ..variants import VARIANTS
from .fields import block_at, keys_below, names_in
from .keys import elsewhere
from .models import Spec
from .removed import instead_of
from .rules import Table

_MOST_TOLD = 100
"""Problems that are told; of the others the number."""


def problems_in(error: ValidationError, data: Table, model: type[BaseModel]) -> tuple[list[Problem], int]:
    """Return what pydantic found in plain data, each thing once, and how many more there are."""
    details = error.errors(include_url=False)
    return [*dict.fromkeys(_problem(detail, data, model) for detail in details[:_MOST_TOLD])], len(details[_MOST_TOLD:])


def _problem(detail: ErrorDetails, data: Table, model: type[BaseModel]) -> Problem:
    location = tuple(map(str, detail["loc"]))
    path = ".".join(location)
    given = given_at(path, data)
    return Problem(path, given, _message(detail, location, given, model))


def given_at(path: str, data: object) -> str | None:
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
    return next((given_at(below, data[block]) for block, below in splits if block in data), None)


def _choices(table: type[BaseModel], name: str) -> Iterable[str]:
    """Return the words that a key may be; none where it is not one of a few words."""
    annotation = table.model_fields[name].annotation
    if name == "variant":
        return VARIANTS
    return get_args(annotation) if get_origin(annotation) is Literal else ()


def _message(detail: ErrorDetails, location: tuple[str, ...], given: str | None, root: type[BaseModel]) -> str:
    context = detail.get("ctx", {})
    match detail["type"]:
        case "missing":
            table = block_at(location[:-1], root)
            choices = ", ".join(_choices(table, location[-1])) if table else ""
            return say("required: one of {choices}", choices=choices) if choices else say("required")
        case "extra_forbidden":
            *block, name = location
            names = names_in(block, root)
            hint = instead_of(".".join(location)) or did_you_mean(name, names)
            if hint := hint or (elsewhere(name) if root is Spec else ""):
                return say("unknown key{hint}", hint=hint)
            return say("unknown key; allowed here: {names}", names=", ".join(names))
        case "model_type" | "model_attributes_type" | "dict_type":
            keys = ", ".join(names_in(location, root))
            return say("must be a table with the keys {names}", names=keys) if keys else say("must be a table")
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
            key = keys_below(root).get(".".join(location))
            if key and key.unit == "K abs" and given and re.fullmatch(r"[-\d.]+", given):
                return say(
                    'a number without a unit is in K, and must be at least {bound:g}: "{number} degC"?',
                    bound=context["ge"],
                    number=given,
                )
            return say("must be at least {bound:g}", bound=context["ge"])
        case "less_than_equal":
            return say("must be at most {bound:g}", bound=context["le"])
        case "less_than" if location[-1:] == ("wall_angle",):
            if given and re.fullmatch(r"[\d.]+", given) and math.pi < float(given) < 90:
                return say('a plain number is in rad, and must be less than pi/2: write "{given} deg"', given=given)
            return say("must be less than 90 deg (pi/2 rad)")
        case "less_than":
            return say("must be less than {bound:g}", bound=context["lt"])
        case "value_error":
            return str(context["error"])
        case _:
            return detail["msg"]
