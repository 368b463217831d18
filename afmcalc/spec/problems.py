"""Problems that pydantic found in plain data, as messages for users: path, value as written, what is allowed."""

import json
from collections.abc import Callable, Mapping

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails

from ..errors import Problem
from ..messages import deferred, did_you_mean, say, translate
from ..variants import VARIANTS
from .fields import block_at, names_in, words_of
from .rules import Table, given_in

_MOST_TOLD = 100
"""Largest number of problems listed; other problems are only counted."""

_WEIGHT = deferred("the weight of a pack with a vertical axis is not calculated; leave the key out")
REMOVED = {
    "control_unit.profiled": deferred("one sleeve has the curved wall, the other seats the ball; leave the key out"),
    "control_unit.wall_friction": deferred("cams that slide are not calculated, balls roll; leave the key out"),
    "fatigue.load_low": deferred("every slip swings the load from 0 to T(f); leave the key out"),
    "friction.unknown": deferred("of a list of materials the worst counts; leave the key out"),
    **{f"friction_group.{name}": _WEIGHT for name in ("discs_mass", "pressure_disc_mass", "vertical_axis")},
    "tolerance.method": deferred("every sample is random, of tolerance.samples clutches; leave the key out"),
}
"""Path of a removed key → advice."""

_SENTENCES = {
    "string_type": deferred("must be text in quotes"),
    "tuple_type": deferred("must be a list in brackets"),
    "too_short": deferred("must not be empty"),
}
"""Pydantic's type of an error → message, if the message needs no details."""

Elsewhere = Callable[[str], str]
"""Function from the name of an unknown key to a hint on other tables that have a key of this name."""


def problems_in(
    error: ValidationError, data: Table, model: type[BaseModel], elsewhere: Elsewhere = lambda name: ""
) -> tuple[list[Problem], int]:
    """Problems that pydantic found in plain data, without repetitions, and the number of problems left out."""
    details, problems = error.errors(include_url=False), dict[Problem, None]()
    for detail in details[:_MOST_TOLD]:
        location = tuple(map(str, detail["loc"]))
        path = ".".join(location)
        problems[Problem(path, given_at(path, data), _message(detail, location, model, elsewhere))] = None
    return [*problems], len(details[_MOST_TOLD:])


def instead_of(path: str) -> str:
    """Advice on a removed key, to follow "unknown key" in a message; empty for other keys."""
    return say(" since 0.4: {instead}", instead=translate(REMOVED[path])) if path in REMOVED else ""


def given_at(path: str, data: Table) -> str | None:
    """Value at a path as written, in JSON; None for a table or a missing key."""
    value = given_in(data).get(path)
    if value is None or isinstance(value, Mapping):
        return None
    text = json.dumps(value, ensure_ascii=False, default=str)
    return text if len(text) <= 60 else text[:57] + "..."


def _message(detail: ErrorDetails, location: tuple[str, ...], root: type[BaseModel], elsewhere: Elsewhere) -> str:
    context = detail.get("ctx", {})
    match detail["type"]:
        case "missing":
            table, name = block_at(location[:-1], root), location[-1]
            words = VARIANTS if name == "variant" else words_of(table.model_fields[name].annotation) if table else ()
            choices = ", ".join(words)
            return say("required: one of {choices}", choices=choices) if choices else say("required")
        case "extra_forbidden":
            *block, name = location
            names = names_in(block, root)
            if hint := instead_of(".".join(location)) or did_you_mean(name, names) or elsewhere(name):
                return say("unknown key{hint}", hint=hint)
            return say("unknown key; allowed here: {names}", names=", ".join(names))
        case "model_type" | "model_attributes_type" | "dict_type":
            keys = ", ".join(names_in(location, root))
            return say("must be a table with the keys {names}", names=keys) if keys else say("must be a table")
        case "literal_error":
            expected = context["expected"].replace("'", "").replace(" or ", ", ")
            hint = did_you_mean(str(detail["input"]), expected.split(", "))
            return say("must be one of {expected}{hint}", expected=expected, hint=hint)
        case "greater_than_equal":
            return say("must be at least {bound:g}", bound=context["ge"])
        case "less_than_equal":
            return say("must be at most {bound:g}", bound=context["le"])
        case "value_error":
            return str(context["error"])
        case kind:
            return translate(_SENTENCES.get(kind, detail["msg"]))
