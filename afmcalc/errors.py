"""Errors for users: the fault, its place, the value given, the values allowed.

This module also checks that the modules of an extra and the texts of the user's language are installed.
"""

import re
from collections.abc import Mapping
from importlib.util import find_spec
from locale import getlocale
from typing import NamedTuple, TypeVar

from .messages import ENGLISH, FOLDER, LANGUAGES, Language, deferred, filled, language, say, translate

MOST_SHOWN = 20
"""Largest number of problems of a spec that are shown; further problems are only counted."""
LONGEST_LINE = 390
"""Largest length of a line of an error, characters; with its prefix the line stays below 400."""

BEYOND_NUMBERS = deferred("a result is not finite (beyond the range of numbers): check the magnitudes in the spec")

T = TypeVar("T")


def given(value: T | None) -> T:
    """The value itself, asserted not to be None; validation guarantees that it is given."""
    assert value is not None
    return value


class AfmcalcError(Exception):
    """Error that the user can correct; ``exit_code`` is the exit code of the command line."""

    exit_code = 2

    def __init__(self, template: str, /, **values: object) -> None:
        """Set the message: ``template`` filled with ``values``; without values, ``template`` is only translated."""
        super().__init__(filled(template, values) if values else translate(template))

    def __str__(self) -> str:
        """Message in the user's language; lines longer than ``LONGEST_LINE`` are cut."""
        lines = super().__str__().split("\n")
        return "\n".join(line if len(line) <= LONGEST_LINE else f"{line[: LONGEST_LINE - 1]}…" for line in lines)


class FileError(AfmcalcError):
    """Error of a file that cannot be read or written."""

    exit_code = 3


def reason(error: OSError) -> str:
    """Reason why a file could not be read or written, in the user's language."""
    return translate(error.strerror or str(error))


def unexpected(error: Exception) -> tuple[bool, list[str]]:
    """True for an overflow or a lack of memory, False for a fault of afmcalc; and the sentences to show."""
    if isinstance(error, MemoryError):
        return True, [say("not enough memory for what was asked")]
    # pydantic's error for a result that is not finite
    found: list[dict[str, str]] = getattr(error, "errors", list)()
    if isinstance(error, ArithmeticError | RuntimeWarning) or {each["type"] for each in found} == {"finite_number"}:
        return True, [translate(BEYOND_NUMBERS)]
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
"""Extra of the package, as pip names it → modules that it installs."""


def need(extra: str) -> None:
    """Check that the modules of an extra are installed, without importing them; AfmcalcError says how to install it."""
    if missing := [name for name in EXTRAS[extra] if find_spec(name) is None]:
        raise AfmcalcError(
            "this needs {missing}, not installed here: pip install 'afmcalc[{extra}]'",
            missing=say(" and ").join(missing),
            extra=extra,
        )


class CalculationError(AfmcalcError, ValueError):
    """Error of a calculation that has no answer although its input is valid."""


class Place(NamedTuple):
    """Line of the text of a spec; ``line`` counts from 1."""

    line: int
    text: str

    def shown(self) -> str:
        """Line with its number as an error shows it, cut at 100 characters."""
        cut = "".join(sign if sign.isprintable() else " " for sign in self.text[:100])
        return f"  {self.line} | {cut.rstrip()}"


class Problem(NamedTuple):
    """One fault of a spec."""

    path: str
    """Dotted path of the key, such as ``friction.max``; empty for the spec as a whole."""
    given: str | None
    """Value as the user wrote it; None if a key is missing."""
    message: str
    """Description of the fault, and the values allowed."""
    place: Place | None = None
    """Line of the text that has the value; None if unknown."""
    origin: str = ""
    """Source of the value, a file or a command-line option; if empty, the source of the spec."""

    @property
    def where(self) -> str:
        """Origin of the value, with its line if the line is known."""
        return f"{self.origin}:{self.place.line}" if self.place else self.origin

    def __str__(self) -> str:
        """Path, value and message in one line."""
        where = self.path
        if self.given is not None:
            where = f"{where} = {self.given}" if where else self.given
        return say("{where}: {message}", where=where, message=self.message) if where else self.message


class SpecError(AfmcalcError, ValueError):
    """Error of an invalid spec; it has all problems found, not only the first."""

    def __init__(self, source: str, problems: list[Problem], more: int = 0) -> None:
        """Collect ``problems`` of the spec read from ``source``; ``more``: number of further problems not listed."""
        self.more = more
        self.problems = [problem._replace(origin=problem.origin or source) for problem in problems]
        lines: list[str] = []
        for problem in self.problems[:MOST_SHOWN]:
            lines.append(say("{where}: {problem}", where=problem.where, problem=str(problem)))
            lines += [problem.place.shown()] if problem.place else []
        if hidden := len(self.problems[MOST_SHOWN:]) + more:
            lines.append(say("{source}: and {hidden:,} more", source=source, hidden=hidden))
        super().__init__("{problems}", problems="\n".join(lines))


OPTION, VARIABLE = "--lang", "AFMCALC_LANG"
_LOCALE = ("LC_ALL", "LC_MESSAGES", "LANG")


def chosen_language(lang: str, environment: Mapping[str, str]) -> Language:
    """Language of the option ``lang``, else of AFMCALC_LANG, else of the system, else English.

    That of the system is the variable LANGUAGE, unless the locale is C, else the locale.
    Raises AfmcalcError if the language is unknown, or its texts are missing.
    """
    by, asked = (OPTION, lang) if lang else (VARIABLE, environment.get(VARIABLE, ""))
    if asked and asked not in LANGUAGES:
        raise AfmcalcError("{by} {name:.40}: known are {languages}", by=by, name=asked, languages=LANGUAGES)
    locale = next(filter(None, map(environment.get, _LOCALE)), "")
    others = "" if re.match(r"(C|POSIX)\b", locale) else environment.get("LANGUAGE", "")
    wanted = f"{others}:{locale}".strip(":") or getlocale()[0] or ""  # on Windows getlocale says Russian_Russia
    known = (name for each in wanted.split(":") if (name := each[:2].lower()) in LANGUAGES)
    name = asked or next(known, ENGLISH.name)
    try:
        return language(name)
    except Exception as error:  # the file may be missing, empty or cut off
        raise AfmcalcError(
            "the texts of the language {name} cannot be read ({folder}: {file}): install afmcalc anew, "
            "or ask for --lang en",
            name=name, folder=FOLDER, file=f"{name}.mo",
        ) from error  # fmt: skip
