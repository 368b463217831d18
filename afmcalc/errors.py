"""Errors meant for people: what is wrong, where, what was given, what is allowed.

What may be missing here is asked for too: the modules of an extra, the texts of the language of the user.
"""

import re
import sys
from collections.abc import Callable, Mapping
from importlib.util import find_spec
from typing import NamedTuple, TypeVar

from .messages import ENGLISH, FOLDER, LANGUAGES, Language, deferred, filled, language, say, translate

MOST_SHOWN = 20
"""Problems of a spec that are shown; of the others the number."""
LONGEST_LINE = 390
"""Characters of a line of an error; with what is put before it, below 400."""


BEYOND_NUMBERS = deferred("a result is not finite (beyond the range of numbers): check the magnitudes in the spec")


T = TypeVar("T")


def given(value: T | None) -> T:
    """Return a value, asserting that it is not None: validation guarantees it."""
    assert value is not None
    return value


class AfmcalcError(Exception):
    """Anything the user can put right; ``exit_code`` is the code the command line ends with."""

    exit_code = 2

    def __init__(self, template: str, /, **values: object) -> None:
        """Take a template and the values that fill it, or a sentence."""
        super().__init__(filled(template, values) if values else translate(template))

    def __str__(self) -> str:
        """The message in the language of the user, no line of it too long to read."""
        lines = super().__str__().split("\n")
        return "\n".join(line if len(line) <= LONGEST_LINE else f"{line[: LONGEST_LINE - 1]}…" for line in lines)


class FileError(AfmcalcError):
    """A file cannot be read or written."""

    exit_code = 3


def reason(error: OSError) -> str:
    """Why a file could not be read or written."""
    return translate(error.strerror or str(error))


def unexpected(error: Exception) -> tuple[bool, list[str]]:
    """Tell, in the language of the user, of an error that is none of ours.

    Returns:
        Whether what was asked is beyond the range of numbers, or of memory, else afmcalc is at fault; what to say.
    """
    from pydantic import ValidationError

    if isinstance(error, ValidationError):
        beyond = all(detail["type"] == "finite_number" for detail in error.errors())
    else:
        beyond = isinstance(error, ArithmeticError | RuntimeWarning)
    if beyond:
        return True, [translate(BEYOND_NUMBERS)]
    if isinstance(error, MemoryError):
        return True, [say("not enough memory for what was asked")]
    import os
    import traceback

    from . import __version__

    at = traceback.extract_tb(error.__traceback__)[-1]
    fault = say(
        "this is a fault of afmcalc {version}, not of what it was given: {kind}: {why} ({file}, line {line})",
        version=__version__, kind=type(error).__name__, why=" ".join(str(error).split())[:200],
        file=os.path.basename(at.filename), line=at.lineno,
    )  # fmt: skip
    report = say(
        "please report it: this line, the command line and the spec; AFMCALC_TRACEBACK=1 before the command shows "
        "where it comes from"
    )
    return False, [fault, report]


EXTRAS = {
    "plot": ("matplotlib",),
    "cad": ("ezdxf",),
    "report": ("matplotlib", "markdown_it"),
    "pdf": ("matplotlib", "markdown_it", "typst"),
    "web": ("starlette", "uvicorn", "jinja2", "matplotlib", "markdown_it"),
}
"""Optional dependencies, as pip knows them → modules they bring."""


def need(extra: str, *modules: str) -> None:
    """Make sure that the modules of an extra, or these of it, are installed, without importing them.

    Raises AfmcalcError: one is missing; it says how to get it.
    """
    missing = [name for name in modules or EXTRAS[extra] if find_spec(name) is None]
    if missing:
        raise AfmcalcError(
            "this needs {missing}, not installed here: pip install 'afmcalc[{extra}]'",
            missing=say(" and ").join(missing),
            extra=extra,
        )


class CalculationError(AfmcalcError, ValueError):
    """The input is well formed but the calculation asked for has no answer."""


_WIDTH = 100
"""Characters of a line of a text that are shown."""


class Place(NamedTuple):
    """A line of a text, counted from 1."""

    line: int
    text: str

    def shown(self) -> str:
        """Return the line as an error shows it, cut where it is too long."""
        cut = "".join(sign if sign.isprintable() else " " for sign in self.text[:_WIDTH])
        return f"  {self.line} | {cut.rstrip()}"


class Label(str):
    """Name of a text in messages."""

    def origin(self, path: str) -> str:
        """Origin of the value at a dotted path: the text, or an option of the command line."""
        return self

    def place(self, path: str) -> Place | None:
        """Line of the key at a dotted path; None where the text is not known."""
        return None


class Problem(NamedTuple):
    """One thing wrong with a spec."""

    path: str
    """Dotted key path, e.g. ``friction.max``; empty for the spec as a whole."""
    given: str | None
    """The value given, as the user wrote it; None when a key is missing."""
    message: str
    """The fault, and what is allowed."""
    place: Place | None = None
    """Line of the text it was read from, as far as that is known."""

    def __str__(self) -> str:
        """One line: path, value, message."""
        where = self.path
        if self.given is not None:
            where = f"{where} = {self.given}" if where else self.given
        return say("{where}: {message}", where=where, message=self.message) if where else self.message


class SpecError(AfmcalcError, ValueError):
    """A spec is invalid; carries every problem found, not only the first."""

    def __init__(self, source: str, problems: list[Problem], more: int = 0) -> None:
        """Collect ``problems`` of the spec read from ``source``; ``more`` are there that nobody looked into."""
        self.source, self.more = source if isinstance(source, Label) else Label(source), more
        self.problems = [
            problem._replace(place=problem.place or self.source.place(problem.path)) for problem in problems
        ]
        lines: list[str] = []
        for problem in self.problems[:MOST_SHOWN]:
            lines.append(say("{where}: {problem}", where=self.where(problem), problem=str(problem)))
            lines += [problem.place.shown()] if problem.place else []
        if hidden := len(self.problems[MOST_SHOWN:]) + more:
            lines.append(say("{source}: and {hidden:,} more", source=self.source, hidden=hidden))
        super().__init__("{problems}", problems="\n".join(lines))

    def where(self, problem: Problem) -> str:
        """Origin of the value, with its line, as far as that is known."""
        origin = self.source.origin(problem.path)
        return f"{origin}:{problem.place.line}" if problem.place else origin


OPTION, VARIABLE = "--lang", "AFMCALC_LANG"
_LOCALE = ("LC_ALL", "LC_MESSAGES", "LANG")


def chosen_language(
    lang: str,
    environment: Mapping[str, str],
    note: Callable[[str], object] = lambda text: None,
) -> Language:
    """Return the language of the option, else of AFMCALC_LANG, else of the system: English where that is not known.

    Args:
        lang: language asked for by the option, if any.
        environment: variables of the process.
        note: is told that the language of the system is not spoken, as its texts are missing.

    Raises:
        AfmcalcError: what is asked for is unknown, or its texts are missing.
    """
    by, asked = (OPTION, lang) if lang else (VARIABLE, environment.get(VARIABLE, ""))
    if asked and asked not in LANGUAGES:
        raise AfmcalcError("{by} {name:.40}: known are {languages}", by=by, name=asked, languages=LANGUAGES)
    name = asked or _system_language(environment)
    try:
        return language(name)
    except Exception as error:  # whatever is wrong with the file
        missing = AfmcalcError(
            "the texts of the language {name} cannot be read ({folder}: {file}): install afmcalc anew, "
            "or ask for --lang en",
            name=name, folder=FOLDER, file=f"{name}.mo",
        )  # fmt: skip
        if asked:
            raise missing from error
        note(str(missing))
        return ENGLISH


def _system_language(environment: Mapping[str, str]) -> str:
    """Return the language of the system: LANGUAGE, a list, is asked first, but not where the locale is plain C."""
    locale = next(filter(None, map(environment.get, _LOCALE)), "")
    others = [] if re.match(r"(C|POSIX)\b", locale) else environment.get("LANGUAGE", "").split(":")
    wanted = [name for name in (*others, locale) if name] or [_windows_locale()]
    return next((known for name in wanted if (known := re.split("[_.@]", name)[0]) in LANGUAGES), ENGLISH.name)


def _windows_locale() -> str:
    """Return the language of the texts of Windows; nothing of another system, whose environment tells it."""
    if sys.platform != "win32":
        return ""
    import ctypes
    from locale import windows_locale

    return windows_locale.get(ctypes.windll.kernel32.GetUserDefaultUILanguage(), "")
