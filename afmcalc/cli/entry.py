"""Entry point: sets the process up for a short life before anything heavy is imported, then runs the program."""

import os
import sys
import warnings
from typing import NoReturn

from ..messages import speaking, term, told
from .speech import chosen, heard, without_lang
from .streams import drop_output, prepare, tell

FAULT = 70
"""Exit code where afmcalc itself is at fault (EX_SOFTWARE of sysexits.h)."""


def main(arguments: list[str] | None = None) -> NoReturn:
    """Run the program; errors for people go to standard error, never a traceback."""
    _tune()
    prepare()
    given = sys.argv[1:] if arguments is None else arguments
    from ..errors import AfmcalcError

    try:
        language = chosen(given, os.environ)
    except AfmcalcError as error:
        _complain(str(error))
        sys.exit(error.exit_code)
    with speaking(language):
        _end(without_lang(given))


def _end(given: list[str]) -> NoReturn:
    """Run a command line and end with its exit code."""
    try:
        sys.exit(_run(given))
    except OSError as error:
        drop_output()
        named = error.filename or told("standard output")
        _complain(told("{named}: cannot be written: {why}", named=named, why=term(error.strerror or str(error))))
        sys.exit(3)
    except MemoryError:
        _complain(told("not enough memory for what was asked"))
        sys.exit(2)
    except Exception as error:
        sys.exit(_unexpected(error))


def _run(given: list[str]) -> int:
    """Run a command line and return its exit code."""
    from ..errors import AfmcalcError
    from .main import application

    # arrays leave the range of numbers with a warning, where floats raise an error
    warnings.simplefilter("error", RuntimeWarning)
    try:
        code = application(given)(given, prog_name="afmcalc", standalone_mode=False)
    except AfmcalcError as error:
        for line in error.told().split("\n"):
            _complain(line)
        return error.exit_code
    except Exception as error:
        return _misused(error, given)
    return code if isinstance(code, int) else 0


def _misused(error: Exception, given: list[str]) -> int:
    """Say what the parser of the command line found wrong; raise anything else again."""
    said = getattr(error, "format_message", None)
    if said is None:
        raise error
    if not given:
        tell(said())  # the help, which is shown where nothing is asked
    else:
        context = getattr(error, "ctx", None)
        if context is not None:
            tell(context.get_usage())
            tell(told("Try '{path} --help' for help.", path=context.command_path))
        _complain(heard(said().rstrip(".")))
    return 2


def _complain(text: str) -> None:
    """Say what is wrong; a line of a text that is shown belongs to what was said before."""
    tell(text if text.startswith(" ") else told("error: {text}", text=text))


def _unexpected(error: Exception) -> int:
    """Say that a calculation left the range of numbers, or that afmcalc is at fault."""
    if _is_beyond_numbers(error):
        _complain(told("a result is not finite (beyond the range of numbers): check the magnitudes in the spec"))
        return 2
    import traceback

    from .. import __version__

    if os.environ.get("AFMCALC_TRACEBACK"):
        tell("".join(traceback.format_exception(error)))
    at = traceback.extract_tb(error.__traceback__)[-1]
    _complain(
        told(
            "this is a fault of afmcalc {version}, not of what it was given: {kind}: {why} ({file}, line {line})",
            version=__version__,
            kind=type(error).__name__,
            why=" ".join(str(error).split())[:200],
            file=os.path.basename(at.filename),
            line=at.lineno,
        )
    )
    _complain(
        told(
            "please report it: this line, the command line and the spec; AFMCALC_TRACEBACK=1 before the command shows "
            "where it comes from"
        )
    )
    return FAULT


def _is_beyond_numbers(error: Exception) -> bool:
    """Whether a calculation left the range of numbers, in its arithmetic or with its result."""
    from pydantic import ValidationError

    if isinstance(error, ValidationError):
        return all(detail["type"] == "finite_number" for detail in error.errors())
    return isinstance(error, ArithmeticError | RuntimeWarning)


def _tune() -> None:
    """Save start-up time: what is imported stays, so the collector need not look at it, now or at the end."""
    import atexit
    import gc

    gc.set_threshold(100_000, 50, 50)
    atexit.register(gc.freeze)
    # else pydantic looks through every installed distribution for plugins
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")
