"""Entry point: sets the process up for a short life before anything heavy is imported, then runs the program."""

import os
import sys
from typing import NoReturn

from ..messages import say


def main(arguments: list[str] | None = None) -> NoReturn:
    """Run the program; errors for people go to standard error, never a traceback."""
    _tune()
    from ..errors import AfmcalcError
    from .main import application

    _prepare_streams()
    given = sys.argv[1:] if arguments is None else arguments
    try:
        application(given)(given, prog_name="afmcalc")
    except AfmcalcError as error:
        for line in str(error).splitlines():
            _complain(line)
        sys.exit(error.exit_code)
    except BrokenPipeError:
        _drop_output()
        sys.exit(0)
    except OSError as error:
        _drop_output()
        _complain(say("standard output: cannot be written: {why}", why=error.strerror or error))
        sys.exit(3)
    except MemoryError:
        _complain(say("not enough memory for what was asked"))
        sys.exit(2)
    except KeyboardInterrupt:
        sys.exit(130)
    except Exception as error:
        if not _is_beyond_numbers(error):
            raise
        _complain(say("a result is not finite (beyond the range of numbers): check the magnitudes in the spec"))
        sys.exit(2)
    sys.exit(0)


def _complain(text: str) -> None:
    """Say what is wrong; a line of a text that is shown belongs to what was said before."""
    print(text if text.startswith(" ") else say("error: {text}", text=text), file=sys.stderr)


def _is_beyond_numbers(error: Exception) -> bool:
    """Whether a calculation left the range of numbers, in its arithmetic or with its result."""
    from pydantic import ValidationError

    if isinstance(error, ValidationError):
        return all(detail["type"] == "finite_number" for detail in error.errors())
    return isinstance(error, OverflowError | ZeroDivisionError)


def _tune() -> None:
    """Save start-up time: what is imported stays, so the collector need not look at it, now or at the end."""
    import atexit
    import gc

    gc.set_threshold(100_000, 50, 50)
    atexit.register(gc.freeze)
    # pydantic would look through every installed distribution for plugins
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")


def _prepare_streams() -> None:
    """Print what the terminal's encoding lacks as escapes instead of failing on it; closed streams are empty ones."""
    if sys.stdin is None:
        sys.stdin = open(os.devnull, encoding="utf-8")  # noqa: SIM115
    if sys.stdout is None:
        sys.stdout = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115
    if sys.stderr is None:
        sys.stderr = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115
    for stream in (sys.stdout, sys.stderr):
        if reconfigure := getattr(stream, "reconfigure", None):
            reconfigure(errors="backslashreplace")


def _drop_output() -> None:
    """Keep the interpreter from complaining about the closed pipe as it ends."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
