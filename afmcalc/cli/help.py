"""The help: commands in groups, examples that stay whole on a narrow terminal, the names that can be given."""

import inspect
import re
from collections.abc import Callable, Iterator, Sequence
from typing import Any, TypeAlias

from typer.core import TyperCommand, TyperGroup

from ..messages import say
from . import names

Context: TypeAlias = Any
HelpFormatter: TypeAlias = Any
"""Classes of the parser behind typer; typer has no public name for them."""

SECTIONS = {
    "clutch": "Calculate",
    "design": "Design",
    "drive": "Drive and parts",
    "parts": "Drive and parts",
    "papers": "Papers",
}
"""Module of a command → its group in the help; what is in no other has to do with files."""
FILES = "Files"
_APART = {"check": "Calculate"}
"""Command → its group, where it is not that of its module."""

_NAMES: dict[str, list[tuple[str, Callable[[], names.Named]]]] = {
    "solve": [("NAME", names.parameters), ("TARGET", names.targets)],
    "plot": [("WHAT", names.plots)],
    "explain": [("COMMAND", names.explained)],
}
"""Command → what its help lists beside what can be swept."""

_WIDEST, _LONGEST = 24, 42
"""Columns left of the explanations; of what may stand there in a line of its own."""


class Command(TyperCommand):
    """A command whose help keeps its examples whole and lists the names that can be given."""

    def collect_usage_pieces(self, ctx: Context) -> list[str]:
        """Return the usage: options, then every argument once."""
        return ["[OPTIONS]", *(_usage(each) for each in self.params if each.param_type_name == "argument")]

    def format_help_text(self, ctx: Context, formatter: HelpFormatter) -> None:
        """Write what the command does, and its examples."""
        _write_help(self.help, formatter)

    def format_options(self, ctx: Context, formatter: HelpFormatter) -> None:
        """Write arguments and options."""
        arguments: list[Any] = [each for each in self.params if each.param_type_name == "argument"]
        if arguments:
            with formatter.section(say("Arguments")):
                formatter.write_dl([(each.metavar, each.help or "") for each in arguments], col_max=_WIDEST)
        _write_options([each for each in self.get_params(ctx) if each not in arguments], ctx, formatter)

    def format_epilog(self, ctx: Context, formatter: HelpFormatter) -> None:
        """Write the names that can be given."""
        lists = _NAMES.get(self.name or "", [])
        if any(each.name == "sweep" for each in self.params):
            lists = [*lists, (say("NAME of --sweep (or any number of the spec, by its path)"), names.swept)]
        for title, listed in lists:
            with formatter.section(title):
                formatter.write_dl(list(listed()), col_max=_WIDEST)


class Program(TyperGroup):
    """The commands, in groups; what the parser of the command line finds wrong is said as everything else is."""

    def invoke(self, ctx: Context) -> Any:
        """Run the command that is called."""
        try:
            return super().invoke(ctx)
        except Exception as raised:
            error: Any = raised
            if hasattr(error, "format_message") and isinstance(error.message, str):
                error.message = _plainly(error.message)
            raise

    def format_help_text(self, ctx: Context, formatter: HelpFormatter) -> None:
        """Write what the program does, and examples."""
        _write_help(self.help, formatter)

    def format_options(self, ctx: Context, formatter: HelpFormatter) -> None:
        """Write the options, then the commands."""
        _write_options(self.get_params(ctx), ctx, formatter)
        self.format_commands(ctx, formatter)

    def format_commands(self, ctx: Context, formatter: HelpFormatter) -> None:
        """Write the commands group by group, what each does in full."""
        groups: dict[str, list[tuple[str, str]]] = {title: [] for title in (*SECTIONS.values(), FILES)}
        for name in self.list_commands(ctx):
            command = self.get_command(ctx, name)
            assert command is not None
            home = str(getattr(command.callback, "__module__", "")).rpartition(".")[2]
            about = inspect.cleandoc(command.help or "").partition("\n\n")[0].replace("\n", " ")
            groups[_APART.get(name) or SECTIONS.get(home, FILES)].append((name, about.rstrip(".")))
        for title, rows in groups.items():
            if rows:
                with formatter.section(title):
                    formatter.write_dl(rows)


def _write_options(options: Sequence[Any], ctx: Context, formatter: HelpFormatter) -> None:
    """Write options; choices that are many go where they can be folded."""
    rows = []
    for name, about in filter(None, (each.get_help_record(ctx) for each in options)):
        flag, _, choices = name.partition(" <")
        folded = f"{flag} NAME", f"{about}  [{choices.rstrip('>').replace('|', ' | ')}]"
        rows.append(folded if choices and len(name) > _LONGEST else (name, about))
    with formatter.section(say("Options")):
        formatter.write_dl(rows, col_max=_WIDEST)


def _usage(argument: Any) -> str:
    many = "..." if argument.nargs != 1 else ""
    return f"{argument.metavar}{many}" if argument.required else f"[{argument.metavar}]{many}"


def _write_help(text: str | None, formatter: HelpFormatter) -> None:
    """Write paragraphs, those that begin with ``\\b`` line by line."""
    for paragraph in inspect.cleandoc(text or "").split("\n\n"):
        formatter.write_paragraph()
        with formatter.indentation():
            if not paragraph.startswith("\b"):
                formatter.write_text(paragraph)
                continue
            indent = " " * formatter.current_indent
            for line in paragraph.split("\n")[1:]:
                for part in example_lines(line, formatter.width - len(indent)):
                    formatter.write(f"{indent}{part}\n")


_WORDS = re.compile(r"""(?:[^\s"']|"[^"]*"|'[^']*')+""")


def example_lines(line: str, width: int) -> Iterator[str]:
    r"""Break an example between its words, such that it can still be copied; what it is for goes to a line of its own.

    >>> print(*example_lines("afmcalc life clutch.toml --model amplitude", 30), sep="\n")
    afmcalc life clutch.toml \
        --model amplitude
    >>> print(*example_lines("afmcalc torque clutch.toml     torque and forces", 30), sep="\n")
    afmcalc torque clutch.toml
        torque and forces
    """
    if len(line) <= width:
        yield line
        return
    command, _, about = line.partition("  ")
    made = ""
    for word in _WORDS.findall(command):
        if made and len(made) + len(word) + 3 > width:
            yield f"{made} \\"
            made = "   "
        made += f" {word}" if made else word
    yield made
    if about:
        import textwrap

        yield from textwrap.wrap(about.strip(), width, initial_indent="    ", subsequent_indent="    ")


def _plainly(message: str) -> str:
    """Put a message of the checks behind the parser in our words."""
    if found := re.match(r"Input should be greater than or equal to (\S+)", message):
        return say("must be at least {least}", least=found[1])
    if message.startswith("Input should be a valid integer"):
        return say("must be a whole number")
    return message.removeprefix("Value error, ")
