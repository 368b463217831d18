"""Commands about the spec itself: init, check, schema."""

from typing import TYPE_CHECKING, Annotated, Literal, TypeAlias

import typer

from ..errors import AfmcalcError
from ..messages import say
from ..variants import VARIANTS
from .files import SCHEMA, SPEC, write
from .options import Common, SpecArgument, with_common
from .run import calculate, emit

_EXAMPLES = {each.name: each.example for each in VARIANTS.values() if each.example} | dict.fromkeys(
    ["unlike-materials"]
)
"""What to start from → its example, where the names differ."""

if TYPE_CHECKING:
    Example: TypeAlias = str
else:
    Example = Literal[tuple(_EXAMPLES)]
_DEFAULT = next(name for name, example in _EXAMPLES.items() if example == "default")


def init(
    file: Annotated[
        str | None, typer.Argument(metavar="FILE", help="File to write (clutch.toml); - for standard output.")
    ] = None,
    variant: Annotated[
        Example,
        typer.Option("--variant", help="Clutch to start from."),
    ] = _DEFAULT,
    output: Annotated[str | None, typer.Option("--output", "-o", metavar="FILE", help="The same as FILE.")] = None,
    force: Annotated[bool, typer.Option("--force", help="Replace an existing file.")] = False,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="No notes on standard error.")] = False,
) -> None:
    """Write an annotated spec to start from.

    \b
    afmcalc init clutch.toml
    afmcalc init indirect.toml --variant indirect
    """  # noqa: D301
    from ..spec.builtin import example_text

    if output and file:
        raise AfmcalcError(say("give FILE or --output, not both"))
    target = output or file or "clutch.toml"
    write(example_text(_EXAMPLES[variant] or variant), target, SPEC, force=force)
    if target != "-":
        Common("init", quiet=quiet).wrote(
            say("wrote {target}; calculate it with: afmcalc torque {target}", target=target)
        )


@with_common
def check(
    spec: SpecArgument = None,
    strict: Annotated[bool, typer.Option("--strict", help="Warnings fail the check too.")] = False,
    *,
    common: Common,
) -> None:
    """Findings only; exit code 1 if one is an error.

    \b
    afmcalc check clutch.toml && echo fine
    afmcalc check clutch.toml --strict --json
    """  # noqa: D301
    output = calculate(common, spec, lambda clutch: {"strict": strict})
    if not output.result.passed:
        raise typer.Exit(1)


@with_common
def materials(*, common: Common) -> None:
    """Friction materials for friction.material, each with its source.

    \b
    afmcalc materials
    afmcalc torque --set friction.min= --set friction.mean= --set friction.max= --set friction.material=woven-dry
    """  # noqa: D301
    from ..analysis.materials import materials as analysis

    common.takes_no_clutch()
    result, findings = analysis()
    emit(common, result, findings)


def schema(
    command: Annotated[
        str | None, typer.Argument(metavar="COMMAND", help="Command whose JSON is described; without it the spec.")
    ] = None,
    output: Annotated[
        str | None, typer.Option("--output", "-o", metavar="FILE", help="Write to FILE instead of standard output.")
    ] = None,
    force: Annotated[bool, typer.Option("--force", help="Replace FILE, whatever it is.")] = False,
) -> None:
    """JSON Schema of the spec, or of a command's JSON output.

    \b
    afmcalc schema > clutch.schema.json
    afmcalc schema torque
    """  # noqa: D301
    import json

    from ..analysis.schema import schema as describe

    write(json.dumps(describe(command), indent=2, ensure_ascii=False) + "\n", output, SCHEMA, force=force)
