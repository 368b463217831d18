"""The formats a result is printed in."""

import json
import re
from collections.abc import Callable
from dataclasses import asdict
from importlib import import_module

from ...messages import printable
from ...result import Output

FORMATS = ("table", "json", "csv", "markdown")
"""Names of the formats that a user chooses from; a notebook asks for html too, --excel for excel."""

Render = Callable[[Output, bool], str]
"""``render(output, terminal)`` → the text for standard output or a file."""

_HOMES = {"excel": ("csv", "excel"), "html": ("notebook", "render")}


def renderer(name: str) -> Render:
    """Return the render function of a format, importing only its module."""
    if name == "json":
        return to_json
    module, function = _HOMES.get(name, (name, "render"))
    return getattr(import_module(f".{module}", __package__), function)


def to_json(output: Output, terminal: bool) -> str:
    """Write the whole output as JSON: SI, full precision, finite; fields that do not apply are null."""
    data = {
        "command": output.command,
        "version": output.version,
        "spec": output.spec,
        "result": output.result.model_dump(mode="json"),
        "findings": [asdict(finding) for finding in output.findings],
    }
    return printable(json.dumps(data, indent=2, ensure_ascii=False, allow_nan=False), lines=True) + "\n"


def in_ascii(text: str) -> str:
    """Return the same JSON in ASCII, for a stream that has not all letters."""
    return re.sub("[^\x00-\x7f]", lambda sign: json.dumps(sign[0])[1:-1], text)
