"""Commands about the spec itself: init, check, schema."""

import os
from typing import Annotated, Any, Literal, TypeAlias

import typer
from typer import Argument, Option

from ..errors import AfmcalcError, SpecError
from ..messages import native, say, translate
from .files import refuse, write
from .names import completing
from .options import Common, ForceOption, QuietOption, SpecArgument, output_option, with_common

Kind: TypeAlias = Literal["machine", "clutch", "drive", "tolerance"]
_COMMAND = {"machine": "design", "clutch": "torque", "drive": "simulate", "tolerance": "tolerance"}
"""Kind of a template → the command that calculates it."""


def init(
    file: Annotated[
        str, Argument(metavar="FILE", help="File to write; - for standard output.", show_default=False)
    ] = "clutch.toml",
    kind: Annotated[
        Kind | None,
        Option(
            help="What it is for: from a motor's plate to a clutch, one clutch alone, one in its drive, or with "
            "tolerances.  [default: machine]"
        ),
    ] = None,
    example: Annotated[
        str | None,
        Option(
            "--from",
            metavar="EXAMPLE",
            help="Copy this example (afmcalc list examples).",
            autocompletion=completing("example"),
        ),
    ] = None,
    schema: Annotated[
        bool, Option("--schema", help="Write the JSON Schema beside FILE too, for completion in an editor.")
    ] = False,
    force: ForceOption = False,
    quiet: QuietOption = False,
) -> None:
    """Write an annotated spec to start from: the motor's plate, the shaft, the space, what may vary.

    \b
    afmcalc init clutch.toml
    afmcalc init indirect.toml --from indirect
    afmcalc init driven.toml --kind drive --schema
    """  # noqa: D301
    from ..spec.parse import PREFIX, example_text
    from ..spec.write import annotated

    if kind and example:
        raise AfmcalcError("give --kind or --from, not both")
    if schema and file == "-":
        raise AfmcalcError("--schema writes a file beside FILE: name one")
    name = example.removeprefix(PREFIX) if example else "default" if kind == "clutch" else kind or "machine"
    text = annotated(example_text(name))
    written = [(file, text)]
    if schema:
        beside = os.path.join(os.path.dirname(file), _SCHEMA)
        written = [(file, f"#:schema ./{_SCHEMA}\n{text}"), (beside, _schema_of(None))]
    refuse(*(path for path, _ in written), force=force)
    for path, content in written:
        write(content, path, force=force, utf8=True)
    if file != "-":
        command = ("design" if "\n[search]" in text else "check") if example else _COMMAND[kind or "machine"]
        Common("init", quiet=quiet).note(
            say("wrote {written}; calculate it with: afmcalc {command} {file}",
                written=", ".join(path for path, _ in written), command=command, file=file)
        )  # fmt: skip


_SCHEMA = "afmcalc.schema.json"


def _schema_of(kind: str | None) -> str:
    import json

    from ..analysis.registry import schema

    return json.dumps(_described(schema(kind)), indent=2, ensure_ascii=False) + "\n"


def _described(part: Any) -> Any:
    """Part of a schema with descriptions and symbols in the language of the user; names stay."""
    if isinstance(part, list):
        return [_described(each) for each in part]
    if not isinstance(part, dict):
        return part
    said = {"description": translate, "symbol": native}
    return {
        name: said[name](each) if name in said and isinstance(each, str) else _described(each)
        for name, each in part.items()
    }


@with_common
def check(
    spec: SpecArgument = None,
    strict: Annotated[bool, Option("--strict", help="Warnings fail the check too.")] = False,
    *,
    common: Common,
) -> None:
    """Verdict, requirements, limits and findings; exit code 1 if one is an error.

    \b
    afmcalc check clutch.toml && echo fine
    afmcalc check clutch.toml --strict --json
    """  # noqa: D301
    try:
        output = common.calculate(common.clutch(spec), strict=strict)
    except SpecError as error:
        if common.chosen_format == "json":
            from ..analysis.check import refused

            common.emit(*refused(error))
        raise
    if not output.result.passed:
        raise typer.Exit(1)


def schema(
    command: Annotated[
        str | None,
        Argument(
            metavar="COMMAND",
            autocompletion=completing("described"),
            help="Command whose JSON is described; without it the spec.",
        ),
    ] = None,
    output: Annotated[str | None, output_option("Write to FILE instead of standard output.")] = None,
    force: ForceOption = False,
) -> None:
    """JSON Schema of the spec, or of a command's JSON output.

    \b
    afmcalc schema > clutch.schema.json
    afmcalc schema torque
    """  # noqa: D301
    refuse(output, force=force)
    write(_schema_of(command), output, force=force)
