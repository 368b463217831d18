"""JSON Schemas, read off the pydantic models."""

from dataclasses import fields
from importlib import import_module
from typing import Any

from pydantic import create_model

from ..errors import AfmcalcError
from ..messages import say
from ..result import Output
from ..spec import Spec
from ..spec.suggest import did_you_mean

DIALECT = "https://json-schema.org/draft/2020-12/schema"

RESULTS = {
    "torque": ("torque", "TorqueResult"),
    "accuracy": ("accuracy", "AccuracyResult"),
    "adjust": ("adjust", "AdjustResult"),
    "overload": ("overload", "OverloadResult"),
    "synthesize": ("synthesize", "SynthesisResult"),
    "life": ("life", "LifeResult"),
    "compare": ("compare", "CompareResult"),
    "solve": ("solve.solve", "SolveResult"),
    "tolerance": ("tolerance.study", "ToleranceResult"),
    "design": ("design.design", "DesignResult"),
    "materials": ("materials", "MaterialsResult"),
    "explain": ("explain.explain", "ExplainResult"),
    "equations": (".papers.register", "EquationsResult"),
    "reproduce": (".papers.claims", "ReproduceResult"),
    "check": ("checks.check", "CheckResult"),
}
"""Command → module of this package and class of its result."""


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
    if command not in RESULTS:
        hint = did_you_mean(command, RESULTS)
        raise AfmcalcError(
            say(
                "no JSON of a command {command!r}{hint}; described are: spec, requirements, {results}",
                command=command,
                hint=hint,
                results=", ".join(RESULTS),
            )
        )
    module, name = RESULTS[command]
    result = getattr(import_module(f".{module}", __package__), name)
    parts: dict[str, Any] = {field.name: (field.type, ...) for field in fields(Output)}
    parts["result"] = (result, ...)
    model = create_model(f"{name.removesuffix('Result')}Output", __doc__=Output.__doc__, **parts)
    return {"$schema": DIALECT, **model.model_json_schema(mode="serialization")}
