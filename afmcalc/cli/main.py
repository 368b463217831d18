"""The afmcalc program: its commands and its help."""

from importlib import import_module
from typing import Annotated, Any

import typer

from .. import __version__
from ..analysis.registry import ANALYSES
from ..messages import ENGLISH, spoken
from .help import Command, Program
from .options import LANG

COMMANDS = {
    **{name: analysis.group for name, analysis in ANALYSES.items()},
    "init": "specs",
    "plot": "plot",
    "report": "report",
    "schema": "specs",
}
"""Command → module of this package that holds the function of that name, in the order of the help."""


def application(arguments: list[str]) -> Any:
    """Build the program for a command line.

    Only the command that is called is imported and registered; all of them when none is (help, a misspelt name).
    """
    called = arguments[0] if arguments and arguments[0] in COMMANDS else None
    app = typer.Typer(
        name="afmcalc",
        cls=Program,
        no_args_is_help=True,
        add_completion=called is None,
        rich_markup_mode=None,
        pretty_exceptions_enable=False,
        context_settings={"help_option_names": ["-h", "--help"]},
    )
    app.callback()(_afmcalc)
    for name in [called] if called else COMMANDS:
        module = import_module(f".{COMMANDS[name]}", __package__)
        app.command(name, cls=Command)(getattr(module, name))
    if spoken() == ENGLISH.name:
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
    afmcalc init clutch.toml    an annotated spec to start from
    afmcalc torque clutch.toml  torque and forces over the friction range
    afmcalc accuracy --sweep C  accuracy of the built-in clutch over the gain
    afmcalc torque a.toml --json | afmcalc accuracy -

    SPEC is a TOML or JSON file, - for standard input; without it one that ships is used, and a note says which.
    A file that exists is replaced only with --force (-f), whatever wrote it.
    Exit codes: 0 done, 1 a check failed, 2 bad usage or bad spec, 3 a file cannot be read or written. Only check
    judges: other commands print an error-level finding and exit with 0.
    """  # noqa: D301
