"""In which language the command line speaks, and how it has the parser behind it speak it too."""

import re
import string
import sys
from collections.abc import Mapping
from typing import Any

from ..errors import AfmcalcError
from ..messages import ENGLISH, Language, Text, known, language, say, translate

OPTION = "--lang"
_LOCALE = ("LC_ALL", "LC_MESSAGES", "LANG")


def chosen(arguments: list[str], environment: Mapping[str, str]) -> Language:
    """The language asked for: by the option, else by AFMCALC_LANG, else by the locale, which asks for nothing more.

    Raises:
        AfmcalcError: there is no such language.
    """
    by_locale = re.split("[_.@]", next(filter(None, map(environment.get, _LOCALE)), ""))[0]
    asked = {OPTION: _option(arguments), "AFMCALC_LANG": environment.get("AFMCALC_LANG"), "": by_locale}
    by, name = next(((by, name) for by, name in asked.items() if name), ("", ENGLISH.name))
    if name == ENGLISH.name or (not by and name not in known()):
        return ENGLISH
    if name not in known():
        languages = ", ".join([ENGLISH.name, *known()])
        raise AfmcalcError(say("{by} {name:.40}: known are {languages}", by=by, name=name, languages=languages))
    return language(name)


def _option(arguments: list[str]) -> str | None:
    """Value of the last ``--lang`` before ``--``; an empty one where it has none."""
    asked = None
    for at, argument in enumerate(arguments):
        if argument == "--":
            break
        if argument == OPTION:
            asked = arguments[at + 1] if at + 1 < len(arguments) else "?"
        elif argument.startswith(f"{OPTION}="):
            asked = argument.partition("=")[2] or "?"
    return asked


def without_lang(arguments: list[str]) -> list[str]:
    """The arguments without the language: it may stand anywhere, and no command has to know it."""
    end = arguments.index("--") if "--" in arguments else len(arguments)
    given = arguments[:end]
    kept = [
        argument
        for before, argument in zip(["", *given], given, strict=False)
        if OPTION not in (before, argument) and not argument.startswith(f"{OPTION}=")
    ]
    return kept + arguments[end:]


LABELS = (
    "Usage: ",
    "Arguments",
    "Options",
    "Commands",
    "Show this message and exit.",
    "[default: {}]",
    "[required]",
    "[OPTIONS]",
    "[ARGS]",
    "<int range>",
    "<float range>",
    "TEXT",
)
"""What the parser itself says in a help."""

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
    "must be at least {least}",
)
"""What it says where a command line is wrong, as templates; of two that fit the first is meant."""


def heard(message: str) -> str:
    """Say a message of the parser in the language of the user."""
    for template in SAID:
        found = re.fullmatch(_pattern(template), message, re.DOTALL)
        if found:
            parts = {name: heard(part) if name == "message" else part for name, part in found.groupdict().items()}
            return translate(Text(template, parts))
    return translate(message)


def _pattern(template: str) -> str:
    """Regular expression of the texts that a template gives."""
    parts = string.Formatter().parse(template)
    return "".join(re.escape(text) + (f"(?P<{name}>.+)" if name else "") for text, name, _, _ in parts)


def paragraphs(text: str) -> list[str]:
    r"""The paragraphs of a help; one that begins with ``\b`` keeps its lines."""
    return [part if part.startswith("\b") else " ".join(part.split()) for part in text.split("\n\n")]


def translated(command: Any) -> Any:
    """Return a command, with all below it, whose help is in the language of the user."""
    from ..letters import fitting

    class Formatter(command.context_class.formatter_class):  # type: ignore[misc]
        def getvalue(self) -> str:
            # the parser takes a stream in ASCII for a mistake and writes UTF-8 there
            return fitting(super().getvalue(), getattr(sys.stdout, "encoding", None) or "utf-8")

        def write_usage(self, prog: str, args: str = "", prefix: str | None = None) -> None:
            super().write_usage(prog, _labels(args), translate(prefix or "Usage: "))

        def write_heading(self, heading: str) -> None:
            super().write_heading(translate(heading))

        def write_dl(self, rows: Any, *more: Any, **options: Any) -> None:
            super().write_dl([(_labels(first), _labels(translate(second))) for first, second in rows], *more, **options)

    class Context(command.context_class):  # type: ignore[misc]
        formatter_class = Formatter

    for each in (command, *getattr(command, "commands", {}).values()):
        each.context_class = Context
        each.help = "\n\n".join(map(translate, paragraphs(each.help or "")))
        for parameter in each.params:
            if parameter.help:
                parameter.help = translate(parameter.help)
    return command


def _labels(text: str) -> str:
    """Put what the parser adds to a help in the language of the user."""
    for label in LABELS[-6:]:
        text = text.replace(label, translate(label))
    return text.replace("[default: ", translate("[default: {}]").partition("{")[0])
