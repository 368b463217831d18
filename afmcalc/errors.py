"""Errors meant for people: what is wrong, where, what was given, what is allowed."""

from typing import NamedTuple

from .messages import say


class AfmcalcError(Exception):
    """Anything the user can put right; ``exit_code`` is the code the command line ends with."""

    exit_code = 2


class FileError(AfmcalcError):
    """A file cannot be read or written."""

    exit_code = 3


def reason(error: OSError) -> str:
    """Why a file could not be read or written; where the working directory is gone, which one it was."""
    import os

    if isinstance(error, FileNotFoundError) and not os.path.isabs(str(error.filename or "")):
        try:
            os.getcwd()
        except FileNotFoundError:
            return say("the working directory {path} does not exist any more", path=os.environ.get("PWD", "."))
    return error.strerror or str(error)


class CalculationError(AfmcalcError, ValueError):
    """The input is well formed but the calculation asked for has no answer."""


class Problem(NamedTuple):
    """One thing wrong with a spec."""

    path: str
    """Dotted key path, e.g. ``friction.max``; empty for the spec as a whole."""
    given: str | None
    """The value given, as the user wrote it; None when a key is missing."""
    message: str
    """What is wrong and what is allowed."""

    def __str__(self) -> str:
        """One line: path, value, message."""
        where = self.path
        if self.given is not None:
            where = f"{where} = {self.given}" if where else self.given
        return f"{where}: {self.message}" if where else self.message


class SpecError(AfmcalcError, ValueError):
    """A spec is invalid; carries every problem found, not only the first."""

    def __init__(self, source: str, problems: list[Problem]) -> None:
        """Collect ``problems`` of the spec read from ``source``."""
        self.source = source
        self.problems = problems
        super().__init__("\n".join(f"{source}: {problem}" for problem in problems))
