"""The standard streams: their encoding, a reader that leaves, a stream that was closed."""

import errno
import io
import os
import sys
from contextlib import suppress

from ..errors import LONGEST_LINE
from ..messages import SPELLED, is_unicode, printable, say


class _Closed(io.TextIOBase):
    """Standard output that was closed: an error when something is written, and not before."""

    def __init__(self) -> None:
        # takes the place of the closed one: a file opened later would get its number
        self._place = open(os.devnull, "rb")  # noqa: SIM115

    def write(self, text: str) -> int:
        """Refuse."""
        raise OSError(errno.EBADF, say("it is closed"))

    def fileno(self) -> int:
        """Return the number of the place."""
        return self._place.fileno()


def prepare() -> None:
    """Let no stream fail because it is closed, or on a letter that its encoding lacks."""
    sys.stdout = sys.stdout or _Closed()
    sys.stderr = sys.stderr or open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115
    for stream in (sys.stdout, sys.stderr):
        if reconfigure := getattr(stream, "reconfigure", None):
            reconfigure(errors="backslashreplace" if is_unicode(stream) else SPELLED)


def put(text: str, *, utf8: bool = False) -> None:
    """Write text to standard output, where asked as UTF-8 whatever the locale; a reader that left wants no more."""
    try:
        if utf8 and not is_unicode(sys.stdout) and not sys.stdout.isatty():
            sys.stdout.flush()
            sys.stdout.buffer.write(text.encode())
        else:
            sys.stdout.write(text)
        sys.stdout.flush()
    except BrokenPipeError:
        drop_output()


def drop_output() -> None:
    """Keep the interpreter from trying once more, as it ends, to write what could not be written."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def tell(text: str) -> None:
    """Say something on standard error: lines of a text stay lines, are not endless, and do not act on the terminal."""
    with suppress(OSError):  # nobody listens
        for line in text.split("\n"):
            shown = printable(line)
            print(shown if len(shown) <= LONGEST_LINE else f"{shown[: LONGEST_LINE - 3]}...", file=sys.stderr)
