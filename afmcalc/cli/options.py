"""The options every command shares."""

import inspect
import sys
from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from functools import wraps
from typing import Annotated, Any, Literal

import typer

from ..errors import AfmcalcError
from ..messages import say

SpecArgument = Annotated[
    str | None,
    typer.Argument(metavar="SPEC", help="TOML or JSON file, - for standard input; without it the base clutch."),
]


@dataclass(frozen=True)
class Common:
    """Options of every command."""

    set: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="PATH=VALUE", help="Override a spec key; repeatable. Empty VALUE removes it."),
    ] = None
    format: Annotated[
        Literal["table", "json", "csv", "markdown"] | None,
        typer.Option("--format", help="How to print. JSON and CSV are SI in full precision.  [default: table]"),
    ] = None
    json: Annotated[bool, typer.Option("--json", help="The same as --format json.")] = False
    output: Annotated[
        str | None, typer.Option("--output", "-o", metavar="FILE", help="Write to FILE instead of standard output.")
    ] = None
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="No notes on standard error.")] = False

    @property
    def chosen_format(self) -> str:
        """The format asked for; ``--json`` is a short form."""
        if self.json and self.format not in (None, "json"):
            raise AfmcalcError(say("--json and --format {format} exclude each other", format=self.format))
        return "json" if self.json else self.format or "table"

    def to_standard_output(self) -> "Common":
        """The same options with the result on standard output, for a command whose FILE is something else."""
        return replace(self, output=None)

    def keep(self, source: str | None) -> None:
        """Refuse to write over the spec that is read."""
        import os

        if source not in (None, "-") and self.output and os.path.exists(self.output):
            assert source is not None
            if os.path.exists(source) and os.path.samefile(source, self.output):
                raise AfmcalcError(
                    say("--output {output}: is the SPEC itself; write to another file", output=self.output)
                )

    def takes_no_clutch(self, name: str) -> None:
        """Refuse overrides where there is no spec to override."""
        if self.set:
            raise AfmcalcError(say("{name} takes no clutch, so --set has nothing to override", name=name))

    def note(self, text: str) -> None:
        """Say something beside the result."""
        if not self.quiet:
            print(say("note: {text}", text=text), file=sys.stderr)


def with_common(function: Callable[..., None]) -> Callable[..., None]:
    """Give a command the common options; it receives them as ``common``."""
    own = inspect.signature(function, eval_str=True)
    parameters = [p for p in own.parameters.values() if p.name != "common"]
    parameters += [
        inspect.Parameter(option.name, inspect.Parameter.KEYWORD_ONLY, default=option.default, annotation=option.type)
        for option in fields(Common)
    ]

    @wraps(function)
    def command(**arguments: Any) -> None:
        options = {option.name: arguments.pop(option.name) for option in fields(Common)}
        function(**arguments, common=Common(**options))

    command.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    command.__annotations__ = {p.name: p.annotation for p in parameters}
    del command.__wrapped__
    return command
