"""Commands about the spec itself: init, check, schema."""

from typing import Annotated, Any, Literal

import typer
from typer import Argument, Option

from ..errors import AfmcalcError, SpecError
from ..messages import native, say, translate
from .files import refuse, write
from .options import Common, ForceOption, QuietOption, SpecArgument, completing, output_option

Kind = Literal["machine", "clutch", "drive", "tolerance"]
_COMMAND = {"machine": "design", "clutch": "torque", "drive": "simulate", "tolerance": "tolerance"}
"""Kind of a template → the command that calculates it."""


def init(
    file: Annotated[
        str, Argument(metavar="FILE", help="File to write; - for standard output.", show_default=False)
    ] = "clutch.toml",
    kind: Annotated[
        Kind | None,
        Option(
            help="machine: from a motor's plate to a clutch; clutch: a clutch alone; drive: a clutch in its drive; "
            "tolerance: with tolerances.  [default: machine]"
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
    force: ForceOption = False,
    quiet: QuietOption = False,
) -> None:
    """Write an annotated spec to start from: the motor's plate, the shaft, the space, what may vary.

    \b
    afmcalc init clutch.toml
    afmcalc init indirect.toml --from indirect
    afmcalc init driven.toml --kind drive
    """
    from ..spec.parse import PREFIX, example_text
    from ..spec.write import annotated

    if kind and example:
        raise AfmcalcError("give --kind or --from, not both")
    name = example.removeprefix(PREFIX) if example else "default" if kind == "clutch" else kind or "machine"
    text = annotated(example_text(name))
    refuse(file, force=force)
    write(text, file, force=force, utf8=True)
    if file != "-":
        command = ("design" if "\n[search]" in text else "check") if example else _COMMAND[kind or "machine"]
        message = say("wrote {file}; calculate it with: afmcalc {command} {file}", command=command, file=file)
        Common("init", quiet=quiet).note(message)


def _described(part: dict[str, Any]) -> dict[str, Any]:
    """Part of a schema with its description and symbol in the user's language; other names are not translated."""
    said = {"description": translate, "symbol": native}
    return {name: said[name](each) if name in said and isinstance(each, str) else each for name, each in part.items()}


def check(
    common: Common,
    spec: SpecArgument = None,
    strict: Annotated[bool, Option("--strict", help="Warnings fail the check too.")] = False,
    verbose: Annotated[bool, Option("--verbose", "-v", help="Show every check and note; JSON and CSV do.")] = False,
) -> None:
    """Verdict, requirements, limits and findings; exit code 1 if one is an error.

    \b
    afmcalc check clutch.toml && echo fine
    afmcalc check clutch.toml --strict --json
    """
    from ..analysis.check import brief
    from ..render.document import with_details

    try:
        clutch = common.clutch(spec)
        result, findings = common.ask(clutch, strict=strict)
    except SpecError as error:
        if common.chosen_format == "json":
            from ..analysis.check import refused

            common.emit(*refused(error))
        raise
    whole = verbose or common.chosen_format in ("json", "csv")
    shown, told = (result, findings) if whole else brief(result, findings)
    with with_details(verbose):
        common.emit(shown, told, clutch.spec)
    if not result.passed:
        raise typer.Exit(1)


def schema(
    command: Annotated[
        str | None,
        Argument(
            metavar="COMMAND",
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
    """
    import json

    from ..analysis.registry import schema as schema_of

    refuse(output, force=force)
    described = json.loads(json.dumps(schema_of(command)), object_hook=_described)
    write(json.dumps(described, indent=2, ensure_ascii=False) + "\n", output, force=force)
