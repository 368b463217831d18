"""Commands about the spec itself: init, check, schema."""

import os
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeAlias

import typer
from typer import Argument, Option

from ..errors import AfmcalcError, SpecError
from ..messages import say, translate
from ..variants import VARIANTS
from .files import refuse, write
from .help import completing
from .options import Common, ForceOption, QuietOption, SpecArgument, output_option, with_common

_EXAMPLES = {name: variant.example for name, variant in VARIANTS.items() if variant.example} | {
    "unlike-materials": None
}
"""Clutch to start from → its example, where the names differ."""
_DEFAULT = next(name for name, example in _EXAMPLES.items() if example == "default")
_KINDS = {
    "clutch": "torque", "requirements": "design", "machine": "design", "tolerance": "tolerance", "drive": "simulate",
}  # fmt: skip
"""What a file is for → the command that calculates it; all but a clutch are the example of that name."""

if TYPE_CHECKING:
    Example: TypeAlias = str
    Kind: TypeAlias = str
else:
    Example = Literal[tuple(_EXAMPLES)]
    Kind = Literal[tuple(_KINDS)]


def init(
    file: Annotated[
        str | None, Argument(metavar="FILE", help="File to write (clutch.toml); - for standard output.")
    ] = None,
    kind: Annotated[
        Kind,
        Option(
            help="A clutch, one with a drive or with tolerances; one with a search for design, or from a motor's plate."
        ),
    ] = "clutch",
    variant: Annotated[Example | None, Option(help="Clutch to start from.")] = None,
    schema: Annotated[
        bool, Option("--schema", help="Write the JSON Schema beside FILE too, for completion in an editor.")
    ] = False,
    output: Annotated[str | None, output_option("The same as FILE.")] = None,
    force: ForceOption = False,
    quiet: QuietOption = False,
) -> None:
    """Write an annotated spec to start from.

    \b
    afmcalc init clutch.toml
    afmcalc init indirect.toml --variant indirect
    afmcalc init driven.toml --kind drive --variant indirect
    afmcalc init wanted.toml --kind requirements --schema
    afmcalc init mixer.toml --kind machine
    """  # noqa: D301
    from ..spec.write import annotated

    if output and file:
        raise AfmcalcError("give FILE or --output, not both")
    if variant and kind not in ("clutch", "drive"):
        raise AfmcalcError("--variant belongs to --kind clutch or drive")
    target = output or file or f"{kind if _KINDS[kind] == 'design' else 'clutch'}.toml"
    if schema and target == "-":
        raise AfmcalcError("--schema writes a file beside FILE: name one")
    text = annotated(_text(kind, variant))
    written = [(target, text)]
    if schema:
        name = "afmcalc.schema.json"
        beside = os.path.join(os.path.dirname(target), name)
        written = [(target, f"#:schema ./{name}\n{text}"), (beside, _schema_of(None))]
    refuse(*(path for path, _ in written), force=force)
    for path, content in written:
        write(content, path, force=force, utf8=True)
    if target != "-":
        Common("init", quiet=quiet).wrote(
            say("wrote {written}; calculate it with: afmcalc {command} {target}",
                written=", ".join(path for path, _ in written), command=_KINDS[kind], target=target)
        )  # fmt: skip


def _text(kind: str, variant: str | None) -> str:
    """Text of the example to start from."""
    from ..spec.parse import example_text
    from ..spec.write import in_a_drive

    if kind != "clutch" and variant in (None, _DEFAULT):
        return example_text(kind)
    name = variant or _DEFAULT
    text = example_text(_EXAMPLES[name] or name)
    return in_a_drive(text, hub=name in VARIANTS and VARIANTS[name].travels) if kind == "drive" else text


def _schema_of(kind: str | None) -> str:
    import json

    from ..analysis.registry import schema

    return json.dumps(_described(schema(kind)), indent=2, ensure_ascii=False) + "\n"


def _described(part: Any) -> Any:
    """Return a part of a schema with its descriptions in the language of the user; names stay."""
    if isinstance(part, list):
        return [_described(each) for each in part]
    if not isinstance(part, dict):
        return part
    return {
        name: translate(each) if name == "description" and isinstance(each, str) else _described(each)
        for name, each in part.items()
    }


@with_common
def examples(*, common: Common) -> None:
    """Files that ship: SPEC may be example:NAME.

    \b
    afmcalc examples
    afmcalc torque example:indirect
    """  # noqa: D301
    common.without_clutch()


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


@with_common
def materials(*, common: Common) -> None:
    """Friction materials for friction.material, each with its source.

    \b
    afmcalc materials
    afmcalc materials --materials own.csv
    afmcalc torque --set friction.min= --set friction.mean= --set friction.max= --set friction.material=woven-dry
    """  # noqa: D301
    from dataclasses import replace

    replace(common, materials=None).without_clutch(common.materials)


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
