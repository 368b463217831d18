"""Output: standard streams, and files written whole or not at all; only ``--force`` replaces existing files."""

import os
import sys
from collections.abc import Iterable
from contextlib import suppress
from errno import EISDIR
from io import TextIOWrapper
from itertools import combinations

from ..errors import LONGEST_LINE, AfmcalcError, FileError, reason
from ..messages import is_unicode, printable

_FORMATS = {".json": "json", ".csv": "csv", ".md": "markdown", ".markdown": "markdown", ".txt": "table"}
_OTHERS = (".toml", ".html", ".htm", ".pdf", ".png", ".svg", ".docx", ".xlsx")
"""Extensions of files that hold no result."""


def format_of(output: str | None, asked: str | None) -> str:
    """Format of a result: ``asked``, else by the extension of its file, else table; other extensions are an error."""
    ending = _ending(output)
    if ending in _OTHERS:
        raise AfmcalcError(
            "--output {output}: a result is written as .txt, .json, .csv or .md "
            "(--save writes a spec, afmcalc report HTML and PDF, afmcalc plot pictures)",
            output=output,
        )
    named = _FORMATS.get(ending)
    if named and asked not in (None, named):
        raise AfmcalcError(
            "--output {output} is the name of a file of format {named}, not {asked}",
            output=output, named=named, asked=asked,
        )  # fmt: skip
    return asked or named or "table"


def ending_of(option: str, path: str | None, *kinds: str, others: bool = False) -> str:
    """Extension of a file: one of ``kinds``, with ``others`` also an unknown one; any other raises AfmcalcError."""
    ending = _ending(path)
    if ending not in kinds and (not others or ending in {*_FORMATS, *_OTHERS}):
        raise AfmcalcError("{option} {path}: end it in {kinds}", option=option, path=path, kinds=kinds)
    return ending


def picture_of(output: str | None, *kinds: str) -> str:
    """Kind of picture, one of ``kinds``, by the extension of its file; SVG for standard output."""
    return "svg" if output in (None, "-") else ending_of("--output", output, *(f".{kind}" for kind in kinds))[1:]


def is_drawing(output: str | None) -> bool:
    """True if the extension of a file belongs to a drawing, not to a result."""
    return _ending(output) in (".svg", ".dxf", ".pdf", ".png")


def _ending(path: str | None) -> str:
    return os.path.splitext(path or "")[1].lower()


_STANDARD_OUTPUT = (None, "-", "/dev/stdout", "/dev/fd/1")


def refuse(*paths: str | None, force: bool, inputs: Iterable[str | None] = ()) -> None:
    """Raise an error if an output path has no folder, is an input, is used twice or, without ``force``, exists."""
    named = [path for path in paths if path and path not in _STANDARD_OUTPUT and not _is_open(path)]
    for path in named:
        try:
            os.stat(os.path.dirname(os.path.realpath(path)))
            if os.path.isdir(path):
                raise IsADirectoryError(EISDIR, os.strerror(EISDIR))
        except OSError as error:
            raise _unwritable(path, error) from None
        if any(_is_same(path, source) for source in inputs):
            raise AfmcalcError("{path}: is read itself; write to another file", path=path)
    for path, other in combinations(named, 2):
        if _is_same(path, other):
            raise AfmcalcError("{path} and {other} are one file: name two", path=path, other=other)
    for path in named:
        if os.path.exists(path) and not force:
            raise _exists(path)


def _is_open(path: str) -> bool:
    """True for a device, a pipe, or a file named by its descriptor: these are written to, not replaced."""
    exists = os.path.exists(path) and not os.path.isdir(path)
    return exists and (path.startswith(("/dev/", "/proc/")) or not os.path.isfile(path))


def _is_same(path: str, other: str | None) -> bool:
    """True if two paths name the same file, existing or not."""
    if other is None or other == "-":
        return False
    with suppress(OSError):
        return os.path.samefile(path, other)
    return os.path.realpath(path) == os.path.realpath(other)


def _exists(path: str) -> AfmcalcError:
    return AfmcalcError("{path}: exists already; --force replaces it", path=path)


def _unwritable(path: str, error: OSError) -> FileError:
    return FileError("{path}: cannot be written: {why}", path=path, why=reason(error))


def write(content: str | bytes, path: str | None, *, force: bool = False, utf8: bool = False) -> None:
    """Write to standard output, or to a file whole or not at all, an existing one only with ``force``.

    With ``utf8`` text on standard output is in UTF-8 whatever the locale. Errors as of ``refuse``.
    """
    if path is None or path in _STANDARD_OUTPUT:
        _print(content, utf8=utf8)
        return
    content = content.encode("utf-8", "backslashreplace") if isinstance(content, str) else content
    try:
        target = os.path.realpath(path)
        if os.path.islink(target):
            os.stat(target)  # raises an error for links that form a circle
        if _is_open(path):
            with open(path, "ab") as file:
                file.write(content)
        else:
            _write_whole(target, content, force=force)
    except FileExistsError:
        raise _exists(path) from None
    except BrokenPipeError:
        pass  # its reader has had enough, as of standard output
    except OSError as error:
        raise _unwritable(path, error) from None


def _write_whole(target: str, content: bytes, *, force: bool) -> None:
    """Write to a temporary file in the same folder, then move it into place in one step."""
    from tempfile import TemporaryDirectory

    with TemporaryDirectory(dir=os.path.dirname(target), prefix=".afmcalc-") as folder:
        whole = os.path.join(folder, "whole")
        with open(whole, "wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        if force:
            if os.path.exists(target):
                os.chmod(whole, os.stat(target).st_mode & 0o777)
            os.replace(whole, target)
            return
        try:
            os.link(whole, target)  # fails if another program has created the file meanwhile
        except FileExistsError:
            raise
        except OSError:  # a file system without hard links
            open(target, "xb").close()
            os.replace(whole, target)


def prepare() -> None:
    """Prepare the standard streams: those that are closed are replaced, characters outside their encoding escaped."""
    sys.stdout = sys.stdout or open(os.devnull, encoding="utf-8")  # noqa: SIM115  # a write raises an error
    sys.stderr = sys.stderr or open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")


def _print(content: str | bytes, *, utf8: bool) -> None:
    """Write to standard output; a closed pipe is no error."""
    try:
        if isinstance(content, str) and utf8 and not is_unicode(sys.stdout) and not sys.stdout.isatty():
            content = content.encode()
        if isinstance(content, bytes):
            sys.stdout.flush()
            sys.stdout.buffer.write(content)
        else:
            sys.stdout.write(content)
        sys.stdout.flush()
    except BrokenPipeError:
        drop_output()


def drop_output() -> None:
    """Redirect standard output to the null device, so that the interpreter does not flush it again at exit."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def tell(text: str) -> None:
    """Print a text on standard error: long lines are cut, control characters escaped."""
    with suppress(OSError):  # standard error may be closed
        for line in text.split("\n"):
            shown = printable(line)
            print(shown if len(shown) <= LONGEST_LINE else f"{shown[: LONGEST_LINE - 3]}...", file=sys.stderr)
