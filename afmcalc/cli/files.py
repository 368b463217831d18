"""Output: the standard streams, and files that are either whole or untouched; no file that exists is lost."""

import os
import sys
from collections.abc import Iterable
from contextlib import suppress
from itertools import combinations

from ..errors import LONGEST_LINE, AfmcalcError, FileError, reason
from ..messages import is_unicode, printable

_FORMATS = {".json": "json", ".csv": "csv", ".md": "markdown", ".markdown": "markdown", ".txt": "table"}
_OTHERS = (".toml", ".html", ".htm", ".pdf", ".png", ".svg", ".docx", ".xlsx")
"""Endings of what is no result."""


def format_of(output: str | None, asked: str | None) -> str:
    """Return the format of a result: as asked, else as its file is named, else a table; refuse another ending."""
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
            output=output,
            named=named,
            asked=asked,
        )
    return asked or named or "table"


def ending_of(option: str, path: str | None, *kinds: str, others: bool = False) -> str:
    """Return the ending of a file, one of ``kinds``; with ``others`` also one that names no other kind of file."""
    ending = _ending(path)
    if ending not in kinds and (not others or ending in {*_FORMATS, *_OTHERS}):
        raise AfmcalcError("{option} {path}: end it in {kinds}", option=option, path=path, kinds=kinds)
    return ending


def is_json_spec(path: str) -> bool:
    """Return whether a file that gets a spec is JSON, by its name, not TOML; refuse another ending."""
    return ending_of("--save", path, ".toml", ".json", others=True) == ".json"


def picture_of(output: str | None, *kinds: str) -> str:
    """Return the kind of picture that goes to a file, by its name, SVG to standard output; refuse others than kinds."""
    return "svg" if output in (None, "-") else ending_of("--output", output, *(f".{kind}" for kind in kinds))[1:]


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
        if os.path.islink(target):
            os.stat(target)  # links in a circle are an error
        if os.path.exists(target) and not os.path.isfile(target):  # a device
            with open(target, "wb") as file:
                file.write(content)
        else:
            _write_whole(target, content, force=force)
    except FileExistsError:
        raise _exists(path) from None
    except OSError as error:
        raise FileError("{path}: cannot be written: {why}", path=path, why=reason(error)) from None


def _write_whole(target: str, content: bytes, *, force: bool) -> None:
    """Write a file beside its place, then move it there at once."""
    from tempfile import TemporaryDirectory

    with TemporaryDirectory(dir=os.path.dirname(target), prefix=".afmcalc-") as folder:
        whole = os.path.join(folder, "whole")
        with open(whole, "wb") as file:
            file.write(content)
        if not force:
            open(target, "xb").close()  # of several programs at once one creates it
        try:
            if os.path.exists(target):
                os.chmod(whole, os.stat(target).st_mode & 0o777)
            os.replace(whole, target)
        except BaseException:
            if not force:
                os.unlink(target)
            raise


def prepare() -> None:
    """Let no stream fail because it is closed, or lacks a letter."""
    sys.stdout = sys.stdout or open(os.devnull, encoding="utf-8")  # noqa: SIM115  # to write to it is an error
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
