"""JSON Schemas, read off the pydantic models."""

from dataclasses import fields
from typing import Any

from pydantic import create_model

from ..errors import AfmcalcError
from ..letters import did_you_mean
from ..messages import say
from ..result import Output
from ..spec import Spec
from .registry import ANALYSES

DIALECT = "https://json-schema.org/draft/2020-12/schema"


def schema(command: str | None = None) -> dict[str, Any]:
    """Return the JSON Schema of a spec (None), of requirements, or of the output of a command.

    Raises:
        AfmcalcError: no such command.
    """
    if command is None or command == "spec":
        return {"$schema": DIALECT, **Spec.model_json_schema()}
    if command == "requirements":
        from ..spec.requirements import Requirements

        return {"$schema": DIALECT, **Requirements.model_json_schema()}
    if command not in ANALYSES:
        hint = did_you_mean(command, ANALYSES)
        raise AfmcalcError(
            say(
                "no JSON of a command {command!r}{hint}; described are: spec, requirements, {results}",
                command=command,
                hint=hint,
                results=", ".join(ANALYSES),
            )
        )
    result = ANALYSES[command].result_class
    parts: dict[str, Any] = {field.name: (field.type, ...) for field in fields(Output)}
    parts["result"] = (result, ...)
    model = create_model(f"{result.__name__.removesuffix('Result')}Output", __doc__=Output.__doc__, **parts)
    return {"$schema": DIALECT, **model.model_json_schema(mode="serialization")}
