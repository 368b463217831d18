"""The help: commands in groups, examples that stay whole on a narrow terminal, the names that can be given.

What the parser of the command line says, here and where something is wrong, is put in the language of the user.
"""

import inspect
import re
import string
import sys
from collections.abc import Callable, Iterator, Sequence
from itertools import chain
from typing import Any, TypeAlias

from typer.core import TyperCommand, TyperGroup

from ..messages import Text, fitting, term, told, translate

Context: TypeAlias = Any
HelpFormatter: TypeAlias = Any
"""Classes of the parser behind typer; typer has no public name for them."""
Named: TypeAlias = list[tuple[str, str]]
"""Names that can be given, and what each is."""

SECTIONS = {"clutch": "Calculate", "design": "Design", "drive": "Drive and parts", "papers": "Papers"}
"""Module of a command → its group in the help; what is in no other has to do with files."""
FILES = "Files"
APART = {"check": "Calculate"}
"""Command → its group, where it is not that of its module."""

_WIDEST, _LONGEST = 24, 42
"""Columns left of the explanations; of what may stand there in a line of its own."""


def names_of(kind: str) -> Named:
    """Return the names that can be given where a command asks for one of a kind, and what each is."""
    from ..analysis.registry import ANALYSES, EXPLAINED, PLOTS

    match kind:
        case "plot":
            return [(name, translate(plot.about)) for name, plot in PLOTS.items()]
        case "explained":
            sections = {name: ANALYSES[name].section for name in EXPLAINED}
            return [(name, translate(section.title if section else "Checks")) for name, section in sections.items()]
        case "described":
            return [(name, "") for name in ANALYSES]
        case "figure":
            from ..papers import FIGURES

            return [(name, "") for name in FIGURES]
        case "target":
            from ..analysis.solve import is_quantity
            from ..equations.terms import TERMS
            from ..render.symbols import native

            terms = {name: own for name, own in TERMS.items() if is_quantity(name)}
            about = {name: f"{native(own.symbol)}, {translate(own.meaning)}" for name, own in terms.items()}
            return [*({**about, **dict(names_of("required"))}).items()]
    from ..spec.keys import ALIASES, keys

    if kind == "required":
        from ..render.symbols import native

        judged = ((path, key) for path, key in keys().items() if path.startswith("requirements."))
        return [
            (path.partition(".")[2], f"{native(key.symbol or '')}, {translate(key.description).partition(',')[0]}")
            for path, key in judged
        ]
    if kind == "path":
        return [(path, translate(key.description)) for path, key in keys().items()]
    symbols = {
        symbol: f"{path}, {translate(keys()[path].description).partition(';')[0]}" for symbol, path in ALIASES.items()
    }
    return [("zC", translate("reduced gain")), *symbols.items()] if kind == "swept" else [*symbols.items()]


def completing(kind: str, end: str = "") -> Callable[[str], Named]:
    """Return what a shell asks for the names of a kind that begin as what is typed; ``end`` is put behind each."""
    return lambda incomplete: [(name + end, about) for name, about in names_of(kind) if name.startswith(incomplete)]


_LISTED = {
    "solve": {
        term("KEY (or any number of the spec, by its path)"): "parameter",
        term("TARGET (or any quantity, by its name in JSON)"): "required",
    },
    "plot": {"WHAT": "plot"},
    "explain": {"COMMAND": "explained"},
}
"""Command → heading in its help → kind of names listed there, beside what can be swept."""


class _Help:
    """What the help of a command and that of the program have in common; a base before the class of typer."""

    def get_help(self, ctx: Context) -> str:
        """Return the help in letters of standard output: typer would write those that its encoding lacks."""
        shown: str = super().get_help(ctx)  # type: ignore[misc]
        return fitting(shown, getattr(sys.stdout, "encoding", None) or "utf-8")

    def format_usage(self, ctx: Context, formatter: HelpFormatter) -> None:
        """Write the usage: options, then every argument once."""
        pieces = [piece.strip("{}") for piece in self.collect_usage_pieces(ctx)]  # type: ignore[attr-defined]
        formatter.write_usage(ctx.command_path, _labelled(" ".join(pieces)), told("Usage: "))

    def format_help_text(self, ctx: Context, formatter: HelpFormatter) -> None:
        """Write what it does, and its examples, broken such that they can be copied."""
        for paragraph in map(translate, paragraphs(ctx.command.help)):
            mark, *lines = paragraph.split("\n")
            broken = chain(*(example_lines(line, formatter.width - 2) for line in lines))
            formatter.write_paragraph()
            with formatter.indentation():
                formatter.write_text("\n".join([mark, *broken]))


class Command(_Help, TyperCommand):
    """A command whose help lists the names that can be given."""

    def format_options(self, ctx: Context, formatter: HelpFormatter) -> None:
        """Write arguments and options."""
        arguments: list[Any] = [item for item in self.params if item.param_type_name == "argument"]
        if arguments:
            with formatter.section(told("Arguments")):
                rows = [(argument.metavar, translate(argument.help or "")) for argument in arguments]
                formatter.write_dl(rows, col_max=_WIDEST)
        _write_options([item for item in self.get_params(ctx) if item not in arguments], ctx, formatter)

    def format_epilog(self, ctx: Context, formatter: HelpFormatter) -> None:
        """Write the names that can be given."""
        lists = dict(_LISTED.get(self.name or "", {}))
        if any(parameter.name == "sweep" for parameter in self.params):
            lists[told("NAME of --sweep (or any number of the spec, by its path)")] = "swept"
        for title, kind in lists.items():
            with formatter.section(translate(title)):
                formatter.write_dl(names_of(kind), col_max=_WIDEST)


class Program(_Help, TyperGroup):
    """The commands, in groups."""

    def format_options(self, ctx: Context, formatter: HelpFormatter) -> None:
        """Write the options, then the commands group by group, what each does in full."""
        _write_options(self.get_params(ctx), ctx, formatter)
        groups: dict[str, Named] = {title: [] for title in (*SECTIONS.values(), FILES)}
        for name, command in self.commands.items():
            home = str(getattr(command.callback, "__module__", "")).rpartition(".")[2]
            title = APART.get(name) or SECTIONS.get(home, FILES)
            groups[title].append((name, translate(paragraphs(command.help)[0]).rstrip(".")))
        for title, rows in groups.items():
            if rows:
                with formatter.section(translate(title)):
                    formatter.write_dl(rows)


LABELS = ("[default: ", "[required]", "[OPTIONS]", "[ARGS]", "<int range>", "<float range>", "TEXT")
"""What the parser adds to a help."""
OF_HELP = "Show this message and exit."
"""Its help for ``--help``."""


def _labelled(text: str) -> str:
    """Put what the parser adds to a help in the language of the user."""
    for label in LABELS:
        text = text.replace(label, translate(label))
    return text


def _write_options(options: Sequence[Any], ctx: Context, formatter: HelpFormatter) -> None:
    """Write options; choices that are many go where they can be folded."""
    rows = []
    for option in options:
        option.help = translate(option.help or "")
        name, about = map(_labelled, option.get_help_record(ctx))
        flag, _, choices = name.partition(" <")
        folded = f"{flag} NAME", f"{about}  [{choices.rstrip('>').replace('|', ' | ')}]"
        rows.append(folded if choices and len(name) > _LONGEST else (name, about))
    with formatter.section(told("Options")):
        formatter.write_dl(rows, col_max=_WIDEST)


def paragraphs(text: str | None) -> list[str]:
    r"""Return the paragraphs of a help; one that begins with ``\b`` keeps its lines."""
    parts = inspect.cleandoc(text or "").split("\n\n")
    return [part if part.startswith("\b") else " ".join(part.split()) for part in parts]


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


SAID = (
    "No such option: {name} Did you mean {near}?",
    "No such option: {name} (Possible options: {near})",
    "No such option: {name}",
    "No such command {name}. Did you mean {near}?",
    "No such command {name}",
    "Missing argument {name}",
    "Missing option {name}",
    "Missing command",
    "Got unexpected extra argument(s) ({arguments})",
    "Option {name} requires an argument",
    "Option {name} requires {count} arguments",
    "Option {name} does not take a value",
    "Invalid value for {name}: {message}",
    "Invalid value: {message}",
    "{value} is not one of {choices}",
)
"""What the parser says where a command line is wrong, as templates; of two that fit the first is meant."""
OURS = {
    "Input should be greater than or equal to {least}": "must be at least {least}",
    "Input should be less than or equal to {most}": "must be at most {most}",
    "Input should be a valid integer{why}": "must be a whole number",
    "Input should be a valid number{why}": "must be a number",
    "Value error, {message}": "{message}",
}
"""What it says otherwise than we do → our words."""


def heard(message: str) -> str:
    """Say a message of the parser in our words, in the language of the user."""
    for template in (*OURS, *SAID):
        if match := re.fullmatch(_pattern(template), message, re.DOTALL):
            parts = {name: heard(part) if name == "message" else part for name, part in match.groupdict().items()}
            return translate(Text(OURS.get(template, template), parts))
    return translate(message)


def _pattern(template: str) -> str:
    """Regular expression of the texts that a template gives."""
    parts = string.Formatter().parse(template)
    return "".join(re.escape(text) + (f"(?P<{name}>.+)" if name else "") for text, name, _, _ in parts)
