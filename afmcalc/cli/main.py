"""Command line: commands in panels, language, exit codes; errors are printed as sentences, not as tracebacks."""

import inspect
import os
import sys
import warnings
from importlib import import_module
from typing import Annotated, Any, NoReturn

import typer
from typer import Argument, Option
from typer.core import TyperGroup

from .. import __version__
from ..errors import OPTION, AfmcalcError, chosen_language, reason, unexpected
from ..messages import deferred, did_you_mean, say, speaking, translate
from ..units import table
from .files import drop_output, prepare, tell
from .options import COMMON, Named, names_of, with_common

Context = Any
"""Context, formatter or error of the parser behind typer, which has no public types for them."""

PANELS = {
    "Everyday": table("init check = specs; torque = clutch; design = searches; report = documents; serve = serve"),
    "Questions": table("""\
accuracy adjust overload life = clutch; tolerance solve = searches; compare = clutch; explain = papers;
plot = documents"""),
    "Parts and drive": table("pocket springs layout simulate effects = hardware"),
    "Theory and lists": table("papers = papers; handbook = documents; list = papers; schema = specs"),
}
"""Heading in the help → command → module of this package that has the function of the command."""
COMMANDS = {name: module for panel in PANELS.values() for name, module in panel.items()}
_MODULES = COMMANDS | {"help": "main"}
FORMER = table("""\
synthesize = pocket; heat = simulate; equations = papers; reproduce = papers --claims;
materials = list materials; examples = list examples""")
"""Command of an earlier version → the command that replaces it."""
_TITLE = "organisation project drawing author checked norm_control approved date"
FORMER_OPTIONS = {
    **{f"--{name.replace('_', '-')}": f"--set report.{name}=TEXT" for name in _TITLE.split()},
    **{f"--{name}": f"--set catalogues.{name}=FILE" for name in ("materials", "discs", "balls")},
    "--excel": "--format csv --lang ru",
    "--pdf": "-o FILE.pdf",
    "--top": "design --all",
    "--variant": "init --from EXAMPLE, --set variant=NAME",
    "--yes": deferred("a progress bar, and Ctrl-C to stop"),
    "--symbols": deferred("the language of the report, --lang"),
}
"""Option of an earlier version → its replacement."""
LANG = "Language: en or ru; else by AFMCALC_LANG or the system."
FAULT = 70
"""Exit code if afmcalc itself is at fault (EX_SOFTWARE of sysexits.h)."""
INTERRUPTED = 130


def main(arguments: list[str] | None = None) -> NoReturn:
    """Run a command line, by default the command line of the process, and exit with its exit code."""
    prepare()
    given, lang = without_lang(sys.argv[1:] if arguments is None else arguments)
    try:
        speaks = chosen_language(lang, os.environ)
    except AfmcalcError as error:
        _complain(str(error))
        sys.exit(error.exit_code)
    with speaking(speaks):
        sys.exit(_run(given))


def _run(given: list[str]) -> int:
    """Run a command line and return its exit code."""
    # NumPy only warns of an overflow, for which Python's floats raise an error
    warnings.simplefilter("error", RuntimeWarning)
    try:
        given = _called(given)
        code = application(given)(given, prog_name="afmcalc", standalone_mode=False)
    except AfmcalcError as error:
        for line in str(error).split("\n"):
            _complain(line)
        return error.exit_code
    except (KeyboardInterrupt, typer.Abort):
        return INTERRUPTED
    except OSError as error:
        drop_output()
        named = error.filename or say("standard output")
        _complain(say("{named}: cannot be written: {why}", named=named, why=reason(error)))
        return 3
    except Exception as error:
        return _misused(error, given) if hasattr(error, "format_message") else _unexpected(error)
    return code if isinstance(code, int) else 0


def _called(given: list[str]) -> list[str]:
    """Arguments, ``help COMMAND`` replaced by ``COMMAND --help``; AfmcalcError for a former command or a file name."""
    match given:
        case ["help" | "-help"]:
            return ["--help"]
        case ["-v" | "-V" | "version"]:
            return ["--version"]
        case ["help", name] if name in COMMANDS:
            return [name, "--help"]
        case [name, *_] if name in FORMER:
            raise AfmcalcError("{name} is now: afmcalc {new}", name=name, new=FORMER[name])
        case [name, *_] if name.startswith("example:") or name.endswith((".toml", ".json")):
            raise AfmcalcError("{name} is no command; did you mean: afmcalc check {name}", name=name)
    return given


def application(arguments: list[str]) -> Any:
    """Parser of a command line, with its help in the user's language.

    Only the called command is imported and registered; all commands if none is called (help, a misspelt name).
    """
    called = arguments[0] if arguments and arguments[0] in _MODULES else None
    app = typer.Typer(
        name="afmcalc",
        cls=Program,
        no_args_is_help=True,
        add_completion=called is None,
        rich_markup_mode=None,
        pretty_exceptions_enable=False,
        context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    )
    app.callback()(_afmcalc)
    for name in [called] if called else _MODULES:
        module = import_module(f".{_MODULES[name]}", __package__)
        app.command(name)(with_common(getattr(module, f"{name}_" if name == "list" else name)))
    program: Any = typer.main.get_command(app)
    if called and not {"-h", "--help"} & {*arguments}:
        return program  # its help is not shown and therefore not translated
    foot = say("Options of every command (--set, --json, --lang, …): afmcalc help options")
    for name, command in [("", program), *program.commands.items()]:
        command.help = "\n\n".join(map(translate, paragraphs(command.help)))
        command.epilog = foot if name else None
        for parameter in command.params:
            parameter.help = translate(getattr(parameter, "help", None) or "")
            parameter.hidden = bool(name) and parameter.name in COMMON
    return program


def paragraphs(text: str | None) -> list[str]:
    r"""Paragraphs of a help text; a paragraph that begins with ``\b`` keeps its line breaks."""
    parts = inspect.cleandoc(text or "").split("\n\n")
    return [part if part.startswith("\b") else " ".join(part.split()) for part in parts]


class Program(TyperGroup):
    """Group of the commands, listed in panels."""

    def format_commands(self, ctx: Context, formatter: Context) -> None:
        """Write the commands panel by panel, each with the first clause of its help."""
        for title, panel in PANELS.items():
            rows = [
                (name, (self.commands[name].help or "").split("\n\n")[0].partition(";")[0].rstrip("."))
                for name in panel
            ]
            with formatter.section(translate(title)):
                formatter.write_dl(rows)


def _version(asked: bool) -> None:
    if asked:
        print(f"afmcalc {__version__}")
        raise typer.Exit


def _afmcalc(
    version: Annotated[bool, Option("--version", callback=_version, is_eager=True, help="Show the version.")] = False,
) -> None:
    """Design calculator for adaptive friction clutches (torque limiters with feedback).

    \b
    afmcalc init clutch.toml    from the motor's plate to a clutch: a file to fill in
    afmcalc torque clutch.toml  torque and forces over the friction range
    afmcalc torque a.toml --json | afmcalc accuracy -

    SPEC is a TOML or JSON file, - for standard input, or example:NAME; without it an example is calculated.
    afmcalc help options|keys|quantities|plots: options of every command, and names that can be given.
    Exit codes: 0 done, 1 a check failed, 2 wrong input or no answer, 3 a file cannot be read or written.
    """


TOPICS = {"options": [], "keys": ["swept", "path"], "quantities": ["target"], "plots": ["plot"]}
"""Topic of the help → kinds of names that it lists; the options are listed by themselves."""


def help(
    topic: Annotated[
        str,
        Argument(
            metavar="TOPIC",
            autocompletion=lambda incomplete: [each for each in TOPICS if each.startswith(incomplete)],
            help="options, keys, quantities, plots; or a command.",
        ),
    ],
) -> None:
    """Options of every command, and names that can be given: keys of a spec, quantities, plots.

    \b
    afmcalc help options
    afmcalc help quantities
    """
    if topic not in TOPICS:
        hint = did_you_mean(topic, [*TOPICS, *COMMANDS])
        raise AfmcalcError("no help on {topic!r:.80}{hint}; topics: {topics}", topic=topic, hint=hint, topics=[*TOPICS])
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    from ..render.formats.table import columns

    grid = Table.grid(padding=(0, 2))
    for name, about in [row for kind in TOPICS[topic] for row in names_of(kind)] or _common_options():
        grid.add_row(Text(name, no_wrap=True), Text(about))
    Console(width=columns(terminal=True), height=1, highlight=False).print(grid)


def _common_options() -> Named:
    """Common options of the commands, each with its help."""
    options = [each for each in application(["torque", "--help"]).commands["torque"].params if each.name in COMMON]
    rows = [(f"{', '.join(each.opts)} {each.metavar or ''}", each.help) for each in options]
    return [*rows, ("--lang NAME", translate(LANG))]


def without_lang(arguments: list[str]) -> tuple[list[str], str]:
    """Arguments without ``--lang``, which may stand anywhere, and the last value of ``--lang``, empty if not given."""
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
    """Print an error; an indented line is printed without "error:", because it continues the line before."""
    tell(text if text.startswith(" ") else say("error: {text}", text=text))


def _misused(error: Any, given: list[str]) -> int:
    """Print the parser's error in ``given``, or the help if nothing is given; return the exit code."""
    if not given:
        tell(error.format_message())
        return 2
    if context := getattr(error, "ctx", None):
        tell(context.get_usage())
        tell(say("Try '{path} --help' for help.", path=context.command_path))
    message = " ".join(error.format_message().split())  # the parser puts choices on separate lines
    message = message.rstrip(".").replace("Value error, ", "")  # pydantic adds this prefix
    if new := FORMER_OPTIONS.get(getattr(error, "option_name", "")):
        message = say("{name} is no option any more; instead: {new}", name=error.option_name, new=translate(new))
    _complain(message)
    return 2


def _unexpected(error: Exception) -> int:
    """Print that a number or memory overflowed, or that afmcalc is at fault; return the exit code."""
    beyond, lines = unexpected(error)
    if not beyond and os.environ.get("AFMCALC_TRACEBACK"):
        import traceback

        tell("".join(traceback.format_exception(error)))
    for line in lines:
        _complain(line)
    return 2 if beyond else FAULT
