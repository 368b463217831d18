"""The standard streams, such that what is at their other end breaks nothing."""

import errno
import io
import os
import sys
from typing import Any

from ..errors import LONGEST_LINE
from ..messages import SPELLED, is_unicode, printable, say


class _Pipe(io.FileIO):
    """A pipe whose reader may leave: what it does not want is dropped, and the work goes on to its exit code."""

    dropped: type[OSError] = BrokenPipeError

    def write(self, data: Any) -> int:
        """Write, or drop."""
        try:
            return super().write(data)
        except self.dropped:
            return memoryview(data).nbytes


class _Remarks(_Pipe):
    """Standard error: where a remark cannot be written there is nobody to tell."""

    dropped = OSError


class _Closed(io.TextIOBase):
    """Standard output that was closed: that is said when something is to be written, and not before."""

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
    """Set the streams up: closed ones, left ones, and those whose encoding lacks what is printed."""
    if sys.stdin is None:
        sys.stdin = open(os.devnull, encoding="utf-8")  # noqa: SIM115
    sys.stdout = _Closed() if sys.stdout is None else _guarded(sys.stdout, _Pipe)
    if sys.stderr is None:
        sys.stderr = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115
    sys.stderr = _guarded(sys.stderr, _Remarks)


def _guarded(stream: Any, raw: type[io.FileIO]) -> Any:
    """Put the guard below a stream of this process; a terminal stays as it is, and so does what a test put there."""
    if stream in (sys.__stdout__, sys.__stderr__) and not stream.isatty():
        stream = io.TextIOWrapper(
            io.BufferedWriter(raw(stream.fileno(), "wb", closefd=False)),
            encoding=stream.encoding,
            line_buffering=stream.line_buffering,
        )
    if reconfigure := getattr(stream, "reconfigure", None):
        reconfigure(errors="backslashreplace" if is_unicode(stream) else SPELLED)
    return stream


def drop_output() -> None:
    """Keep the interpreter from trying once more, as it ends, to write what could not be written."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def tell(text: str) -> None:
    """Say something on standard error: lines of a text stay lines, are not endless, and do not act on the terminal."""
    for line in text.split("\n"):
        shown = printable(line)
        print(shown if len(shown) <= LONGEST_LINE else f"{shown[: LONGEST_LINE - 3]}...", file=sys.stderr)
