"""The options every command shares."""

import inspect
from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from copy import copy
from dataclasses import dataclass, fields, replace
from functools import wraps
from typing import Annotated, Any, Literal, get_args

import typer

from ..errors import AfmcalcError
from ..messages import say, told
from ..progress import Bar
from .files import format_of, format_of_spec, refuse, write
from .names import completing, paths
from .signals import unreported
from .streams import tell

LANG = "Language: en or ru; else by AFMCALC_LANG or the locale."

SpecArgument = Annotated[
    str | None,
    typer.Argument(metavar="SPEC", help="TOML or JSON file, - for standard input; without it one that ships."),
]


def _with_equals_sign(overrides: list[str] | None) -> list[str] | None:
    """Judge overrides before the arguments: of ``--set gain 0.7`` the parser takes the value for a SPEC."""
    from ..spec.edit import key_of

    for override in overrides or ():
        key_of(override)
    return overrides


ForceOption = Annotated[bool, typer.Option("--force", "-f", help="Replace a file that exists.")]
Writes = Literal["result", "spec", "document"]
"""What a file gets; the name of a document is judged by its command."""
QuietOption = Annotated[bool, typer.Option("--quiet", "-q", help="No notes; of the findings errors alone.")]


@dataclass(frozen=True)
class Common:
    """Options of every command, and which command it is."""

    command: str
    set: Annotated[
        list[str] | None,
        typer.Option(
            "--set",
            metavar="PATH=VALUE",
            help="Override a spec key; repeatable. Empty VALUE removes it.",
            autocompletion=completing(paths, "="),
            callback=_with_equals_sign,
        ),
    ] = None
    format: Annotated[
        Literal["table", "json", "csv", "markdown"] | None,
        typer.Option("--format", help="How to print. JSON and CSV are SI in full precision.  [default: table]"),
    ] = None
    json: Annotated[bool, typer.Option("--json", help="The same as --format json.")] = False
    units: Annotated[
        Literal["engineer", "si"],
        typer.Option("--units", help="Units of tables and Markdown: mm, kN, MPa, deg, or SI."),
    ] = "engineer"
    output: Annotated[
        str | None, typer.Option("--output", "-o", metavar="FILE", help="Write to FILE instead of standard output.")
    ] = None
    force: ForceOption = False
    yes: Annotated[bool, typer.Option("--yes", help="Go on with what takes longer than a minute.")] = False
    quiet: QuietOption = False
    lang: Annotated[str | None, typer.Option("--lang", metavar="NAME", help=LANG)] = None

    @property
    def chosen_format(self) -> str:
        """The format asked for, or that of the file; ``--json`` is a short form."""
        if self.json and self.format not in (None, "json"):
            raise AfmcalcError(say("--json and --format {format} exclude each other", format=self.format))
        return format_of(self.output, "json" if self.json else self.format)

    def to_standard_output(self) -> "Common":
        """The same options with the result on standard output, for a command whose FILE is something else."""
        return replace(self, output=None)

    def shown(self) -> AbstractContextManager[None]:
        """Show quantities in the units asked for."""
        if self.units == "engineer":
            return nullcontext()
        from ..render.units import shown_in

        return shown_in(self.units)

    def keep(self, *sources: str | None, beside: str | None = None, writes: Writes = "result") -> None:
        """Refuse a file that is one of ``sources``, exists or has a wrong name, or a second one ``beside`` it."""
        if writes == "result":
            self.chosen_format  # noqa: B018
        elif writes == "spec" and self.output:
            format_of_spec(self.output)
        refuse(self.output, beside, force=self.force, inputs=sources)

    def write(self, text: str, *, utf8: bool = False) -> None:
        """Write to the file, or to standard output."""
        write(text, self.output, force=self.force, utf8=utf8)

    def takes_no_clutch(self) -> None:
        """Refuse overrides where there is no spec to override, and what ``keep`` refuses."""
        self.keep()
        if self.set:
            raise AfmcalcError(say("{name} takes no clutch, so --set has nothing to override", name=self.command))

    def bar(self) -> Bar:
        """Progress of what is calculated in the block; what takes longer than a minute is refused without ``--yes``."""
        return Bar(quiet=self.quiet, agreed=self.yes)

    def note(self, text: str) -> None:
        """Say something beside the result."""
        if not self.quiet:
            tell(told("note: {text}", text=text))

    def wrote(self, text: str) -> None:
        """Report what was written."""
        self.note(text)
        unreported.clear()


_EVERYWHERE = tuple(option.name for option in fields(Common)[1:])


def common_options(*names: str, **helps: str) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Give a command the common options; it receives them as ``common``.

    Args:
        names: which of them; all that every command has where none is named.
        helps: name → help, where that of a command is another.
    """
    chosen = names or _EVERYWHERE
    options = [option for option in fields(Common)[1:] if option.name in chosen]

    def decorate(function: Callable[..., None]) -> Callable[..., None]:
        own = inspect.signature(function, eval_str=True)
        parameters = [p for p in own.parameters.values() if p.name != "common"]
        parameters += [
            inspect.Parameter(
                option.name,
                inspect.Parameter.KEYWORD_ONLY,
                default=option.default,
                annotation=_with_help(option.type, helps.get(option.name)),
            )
            for option in options
        ]

        @wraps(function)
        def command(**arguments: Any) -> None:
            given = {option.name: arguments.pop(option.name) for option in options}
            common = Common(function.__name__, **given)
            with common.shown():
                function(**arguments, common=common)

        command.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
        command.__annotations__ = {p.name: p.annotation for p in parameters}
        del command.__wrapped__
        return command

    return decorate


with_common = common_options()


def _with_help(annotation: Any, text: str | None) -> Any:
    """Return an annotated option with another help."""
    if text is None:
        return annotation
    kind, option = get_args(annotation)
    option = copy(option)
    option.help = text
    return Annotated[kind, option]
