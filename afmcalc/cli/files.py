"""Output: the standard streams, and files that are either whole or untouched; no file that exists is lost."""

import errno
import io
import os
import sys
from collections.abc import Iterable
from contextlib import suppress
from itertools import combinations

from ..errors import LONGEST_LINE, AfmcalcError, FileError, reason
from ..messages import is_unicode, printable, say

_FORMATS = {".json": "json", ".csv": "csv", ".md": "markdown", ".markdown": "markdown", ".txt": "table"}
_OTHERS = (".toml", ".html", ".htm", ".pdf", ".png", ".svg", ".docx", ".xlsx")
"""Endings of what is no result."""


def format_of(output: str | None, asked: str | None) -> str:
    """Return the format of a result: as asked, else as its file is named, else a table; refuse another ending."""
    ending = _ending(output)
    if ending in _OTHERS:
        raise AfmcalcError(
            "--output {output}: a result is written as .txt, .json, .csv or .md "
            "(afmcalc report writes HTML and PDF, afmcalc plot pictures)",
            output=output,
        )
    named = _FORMATS.get(ending)
    if named and asked not in (None, named):
        raise AfmcalcError(
            "--output {output} is the name of a file of format {named}, not {asked}",
            output=output,
            named=named,
            asked=asked,
        )
    return asked or named or "table"


def is_json_spec(output: str) -> bool:
    """Return whether a file that gets a spec is JSON, by its name, not TOML; refuse another ending."""
    ending = _ending(output)
    if ending in {*_FORMATS, *_OTHERS} - {".toml", ".json"}:
        raise AfmcalcError("--save {output}: it gets a spec: .toml or .json", output=output)
    return ending == ".json"


def is_pdf(output: str | None) -> bool:
    """True if a page goes to a PDF alone, by its name; refuse a name that says it is neither that nor HTML."""
    if _ending(output) in {*_FORMATS, *_OTHERS} - {".html", ".htm", ".pdf"}:
        raise AfmcalcError("--output {output}: this page is HTML or PDF; end it in .html or .pdf", output=output)
    return _ending(output) == ".pdf"


def picture_of(output: str | None, *kinds: str) -> str:
    """Return the kind of picture that goes to a file, by its name, SVG to standard output; refuse others than kinds."""
    if output in (None, "-"):
        return "svg"
    ending = _ending(output).removeprefix(".")
    if ending not in kinds:
        raise AfmcalcError(
            "--output {output}: end it in {kinds}", output=output, kinds=", ".join(f".{kind}" for kind in kinds)
        )
    return ending


def is_drawing(output: str | None) -> bool:
    """Return whether a file gets a drawing, by its name, and no result."""
    return _ending(output) in (".svg", ".dxf", ".pdf", ".png")


def _ending(path: str | None) -> str:
    return os.path.splitext(path or "")[1].lower()


def refuse(*paths: str | None, force: bool, inputs: Iterable[str | None] = ()) -> None:
    """Refuse to write over what is read, two outputs to one file, and without ``force`` over a file that exists."""
    written = [path for path in paths if path not in (None, "-") and (os.path.isfile(path) or not os.path.exists(path))]
    for path in written:
        if any(_is_same(path, source) for source in inputs):
            raise AfmcalcError("{path}: is read itself; write to another file", path=path)
    for path, other in combinations(written, 2):
        if _is_same(path, other):
            raise AfmcalcError("{path} and {other} are one file: name two", path=path, other=other)
    for path in written:
        if os.path.exists(path) and not force:
            raise _exists(path)


def _is_same(path: str, other: str | None) -> bool:
    """True if two names are of one file, that exists or would be written."""
    if other in (None, "-") or os.path.exists(path) != os.path.exists(other):
        return False
    return os.path.samefile(path, other) if os.path.exists(path) else os.path.realpath(path) == os.path.realpath(other)


def _exists(path: str) -> AfmcalcError:
    return AfmcalcError("{path}: exists already; --force replaces it", path=path)


def write(text: str, path: str | None, *, force: bool = False, utf8: bool = False) -> None:
    """Write text to a file, or to standard output, there as UTF-8 whatever the locale where asked."""
    if path is None or path == "-":
        put(text, utf8=utf8)
    else:
        write_file(path, text.encode("utf-8", "backslashreplace"), force=force)


def write_file(path: str, content: bytes, *, force: bool = False) -> None:
    """Write a file that is either whole or untouched; one that exists only with ``force``.

    Raises:
        AfmcalcError: the file exists.
        FileError: it cannot be written.
    """
    try:
        target = os.path.realpath(path)
        if os.path.exists(target) and not os.path.isfile(target):
            with open(path, "wb") as file:
                file.write(content)
            return
        created = _create(target)
        if not (created or force):
            raise _exists(path)
        _replace(target, content, created=created)
    except OSError as error:
        raise FileError("{path}: cannot be written: {why}", path=path, why=reason(error)) from None


def _create(target: str) -> bool:
    """Create an empty file, and return whether it was not there: of several programs at once one creates it."""
    if os.path.islink(target):
        # links that lead to each other: replacing one would hide the fault
        os.stat(target)
    try:
        open(target, "xb").close()
    except FileExistsError:
        return False
    return True


def _replace(target: str, content: bytes, *, created: bool) -> None:
    """Replace a file at once, by way of a temporary one beside it; one just created goes where that fails."""
    import tempfile

    temporary = ""
    try:
        handle, temporary = tempfile.mkstemp(dir=os.path.dirname(target), prefix=".afmcalc-")
        with os.fdopen(handle, "wb") as file:
            file.write(content)
        os.chmod(temporary, os.stat(target).st_mode & 0o777)
        os.replace(temporary, target)
    except BaseException:
        for path in (temporary, target if created else ""):
            with suppress(OSError):
                os.unlink(path)
        raise


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
    """Let no stream fail because it is closed, or lacks a letter."""
    sys.stdout = sys.stdout or _Closed()
    sys.stderr = sys.stderr or open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115
    for stream in (sys.stdout, sys.stderr):
        if reconfigure := getattr(stream, "reconfigure", None):
            reconfigure(errors="backslashreplace")


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
