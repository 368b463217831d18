"""The program: its commands, the language it speaks, and how it ends; errors are told, never a traceback."""

import os
import sys
import warnings
from importlib import import_module
from typing import Annotated, Any, NoReturn

import typer
from typer import Option

from .. import __version__
from ..analysis.registry import ANALYSES
from ..errors import OPTION, AfmcalcError, chosen_language, unexpected
from ..messages import speaking, term, told
from .help import Command, Program, heard
from .options import LANG
from .streams import drop_output, prepare, tell

COMMANDS = {
    **{name: analysis.group for name, analysis in ANALYSES.items()},
    "init": "specs",
    "plot": "plot",
    "report": "report",
    "handbook": "report",
    "serve": "serve",
    "schema": "specs",
}
"""Command → module of this package that holds the function of that name, in the order of the help."""
FAULT = 70
"""Exit code where afmcalc itself is at fault (EX_SOFTWARE of sysexits.h)."""


def main(arguments: list[str] | None = None) -> NoReturn:
    """Run a command line, that of the process where none is given, and end with its exit code."""
    prepare()
    given, lang = without_lang(sys.argv[1:] if arguments is None else arguments)
    try:
        speaks = chosen_language(lang, os.environ, lambda text: tell(told("note: {text}", text=text)))
    except AfmcalcError as error:
        _complain(str(error))
        sys.exit(error.exit_code)
    with speaking(speaks):
        sys.exit(_run(given))


def _run(given: list[str]) -> int:
    """Run a command line and return its exit code."""
    # arrays leave the range of numbers with a warning, where floats raise an error
    warnings.simplefilter("error", RuntimeWarning)
    try:
        code = application(given)(given, prog_name="afmcalc", standalone_mode=False)
    except AfmcalcError as error:
        for line in str(error).split("\n"):
            _complain(line)
        return error.exit_code
    except OSError as error:
        drop_output()
        named = error.filename or told("standard output")
        _complain(told("{named}: cannot be written: {why}", named=named, why=term(error.strerror or str(error))))
        return 3
    except Exception as error:
        return _misused(error, given) if hasattr(error, "format_message") else _unexpected(error)
    return code if isinstance(code, int) else 0


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
    return app


def _version(asked: bool) -> None:
    if asked:
        print(f"afmcalc {__version__}")
        raise typer.Exit


def _afmcalc(
    version: Annotated[bool, Option("--version", callback=_version, is_eager=True, help="Show the version.")] = False,
    lang: Annotated[str | None, Option(metavar="NAME", help=LANG)] = None,
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
    judges: other commands print an error-level finding and exit with 0. Papers: F11 is Fokin and others 2011; S19, S21,
    S22 Shishkarev 2019, 2021, 2022; M with a number is a misprint in them (afmcalc equations --misprints).
    """  # noqa: D301


def without_lang(arguments: list[str]) -> tuple[list[str], str]:
    """Return the arguments without the language, which may stand anywhere, and the last one asked for, if any."""
    kept, name = [], ""
    rest = iter(arguments)
    for argument in rest:
        if argument == "--":
            kept += [argument, *rest]
        elif argument == OPTION:
            name = next(rest, "?")
        elif argument.startswith(f"{OPTION}="):
            name = argument.partition("=")[2] or "?"
        else:
            kept.append(argument)
    return kept, name


def _complain(text: str) -> None:
    """Say what is wrong; a line of a text that is shown belongs to what was said before."""
    tell(text if text.startswith(" ") else told("error: {text}", text=text))


def _misused(error: Any, given: list[str]) -> int:
    """Say what the parser of the command line found wrong; show the help where nothing is asked."""
    if not given:
        tell(error.format_message())
        return 2
    if context := getattr(error, "ctx", None):
        tell(context.get_usage())
        tell(told("Try '{path} --help' for help.", path=context.command_path))
    _complain(heard(error.format_message().rstrip(".")))
    return 2


def _unexpected(error: Exception) -> int:
    """Say that a calculation or its result left the range of numbers, or that afmcalc is at fault."""
    beyond, lines = unexpected(error)
    if not beyond and os.environ.get("AFMCALC_TRACEBACK"):
        import traceback

        tell("".join(traceback.format_exception(error)))
    for line in lines:
        _complain(line)
    return 2 if beyond else FAULT
