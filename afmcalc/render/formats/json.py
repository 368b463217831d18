"""JSON: SI, full precision, finite."""

import json
import re
from dataclasses import asdict

from ...messages import printable
from ...result import Output


def render(output: Output, terminal: bool) -> str:
    """Write the whole output object; fields that do not apply are null."""
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
