"""The formats in which a result is printed."""

import json
import re
from collections.abc import Callable
from dataclasses import asdict
from importlib import import_module
from typing import cast

from ...messages import printable
from ...result import Output

FORMATS = ("table", "json", "csv", "markdown")
"""Names of the formats that a user can choose; there is also html, for notebooks."""

Render = Callable[[Output, bool], str]
"""Function ``render(output, terminal)`` that returns the text for standard output or a file."""


def renderer(name: str) -> Render:
    """Return the render function of a format, importing only its module."""
    if name == "json":
        return to_json
    module = import_module(".notebook" if name == "html" else f".{name}", __package__)
    return cast(Render, module.render)


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
    """JSON with all characters outside ASCII escaped, for a stream that cannot encode them."""
    return re.sub("[^\x00-\x7f]", lambda sign: json.dumps(sign[0])[1:-1], text)
