"""The afmcalc program: its commands and its help."""

import re
from importlib import import_module
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from .. import __version__
from ..analysis.registry import ANALYSES
from ..language import ENGLISH
from ..messages import say, spoken
from .options import LANG

COMMANDS = {
    **{name: analysis.group for name, analysis in ANALYSES.items()},
    "init": "specs",
    "plot": "plot",
    "report": "report",
    "schema": "specs",
}
"""Command → module of this package that holds the function of that name, in the order of the help."""


class _Program(TyperGroup):
    """The commands; what the parser of the command line finds wrong is said as everything else is."""

    def invoke(self, ctx: Any) -> Any:
        """Run the command that is called."""
        try:
            return super().invoke(ctx)
        except Exception as raised:
            error: Any = raised
            if hasattr(error, "format_message") and isinstance(error.message, str):
                error.message = _plainly(error.message)
            raise


def _plainly(message: str) -> str:
    """Put a message of the checks behind the parser in our words."""
    if found := re.match(r"Input should be greater than or equal to (\S+)", message):
        return say("must be at least {least}", least=found[1])
    if message.startswith("Input should be a valid integer"):
        return say("must be a whole number")
    return message.removeprefix("Value error, ")


def application(arguments: list[str]) -> Any:
    """Build the program for a command line.

    Only the command that is called is imported and registered; all of them when none is (help, a misspelt name).
    """
    app = typer.Typer(
        name="afmcalc",
        cls=_Program,
        no_args_is_help=True,
        add_completion=False,
        rich_markup_mode=None,
        pretty_exceptions_enable=False,
        context_settings={"help_option_names": ["-h", "--help"]},
    )
    app.callback()(_afmcalc)
    called = arguments[0] if arguments and arguments[0] in COMMANDS else None
    for name in [called] if called else COMMANDS:
        module = import_module(f".{COMMANDS[name]}", __package__)
        app.command(name)(getattr(module, name))
    if spoken() == ENGLISH:
        return app
    from .speech import translated

    return translated(typer.main.get_command(app))


def _version(asked: bool) -> None:
    if asked:
        print(f"afmcalc {__version__}")
        raise typer.Exit


def _afmcalc(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Show the version.")
    ] = False,
    lang: Annotated[str | None, typer.Option("--lang", metavar="NAME", help=LANG)] = None,
) -> None:
    """Design calculator for adaptive friction clutches (torque limiters with feedback).

    \b
    afmcalc torque clutch.toml           torque and forces over the friction range
    afmcalc accuracy --sweep C           accuracy of the built-in clutch over the gain
    afmcalc init clutch.toml             an annotated spec to start from
    afmcalc torque a.toml --json | afmcalc accuracy -

    SPEC is a TOML or JSON file, - for standard input; without it the built-in base clutch is used.
    Exit codes: 0 done, 1 a check failed, 2 bad usage or bad spec, 3 a file cannot be read or written.
    """  # noqa: D301
