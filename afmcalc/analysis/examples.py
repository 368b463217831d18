"""The specs that ship, as a result."""

import tomllib

from ..findings import Finding
from ..result import Answer, Result, quantity
from ..spec.parse import example_names, example_text


class ExampleRow(Result):
    """One file: any SPEC argument takes ``example:`` with its name."""

    name: str = quantity("", None, "name after example:", code=True)
    variant: str | None = quantity("", None, "variant of the clutch", optional=True)
    about: str = quantity("", None, "what it is")


class ExamplesResult(Answer):
    """The examples."""

    examples: list[ExampleRow] = quantity("", None, "examples that ship")


def examples() -> tuple[ExamplesResult, list[Finding]]:
    """List the examples."""
    return ExamplesResult(examples=[_row(name) for name in example_names()]), []


def _row(name: str) -> ExampleRow:
    text = example_text(name)
    about = text.partition("\n")[0].removeprefix("# ")
    return ExampleRow(name=name, variant=tomllib.loads(text).get("variant"), about=about)
