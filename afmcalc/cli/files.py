"""Writing to standard output, or to a file that is either whole or untouched; nothing of the user's is lost."""

import os
import sys
from collections.abc import Iterable
from contextlib import suppress
from typing import NamedTuple

from ..errors import AfmcalcError, FileError, reason
from ..messages import say, term
from .signals import put_off, unreported
from .streams import is_unicode


class Kind(NamedTuple):
    """What is written to a file, and how one that was written as the same is known again."""

    name: str
    starts: tuple[bytes, ...] = ()
    holds: bytes = b""

    def wrote(self, content: bytes) -> bool:
        """Whether a file is of this kind, written by afmcalc; of what people edit none is."""
        return content.startswith(self.starts) if self.starts else bool(self.holds) and self.holds in content


SPEC = Kind(say("spec"))
REPORT = Kind(say("report"), holds=b'<meta name="generator" content="afmcalc ')
REPORT_PDF = Kind(say("report as PDF"), holds=b"\n%afmcalc report\n")
PLOT = Kind(say("plot"), holds=b"afmcalc plot")
SCHEMA = Kind(say("schema"), (b'{\n  "$schema": ',))

_ENDINGS = {".json": "json", ".csv": "csv", ".md": "markdown", ".markdown": "markdown", ".txt": "table"}
_NO_RESULT = (".toml", ".html", ".htm", ".pdf", ".png", ".svg", ".docx", ".xlsx")


def ending_of(path: str) -> str:
    """Ending of a file's name, in small letters.

    >>> ending_of("a.b/Report.HTML"), ending_of("a.b/report")
    ('.html', '')
    """
    return os.path.splitext(path)[1].lower()


def format_of(output: str | None, asked: str | None) -> str:
    """Format in which a result goes to a file: the one asked for, else the one its name ends in, else a table.

    Raises:
        AfmcalcError: the name ends in another one.
    """
    ending = ending_of(output or "")
    if ending in _NO_RESULT:
        raise AfmcalcError(
            say(
                "--output {output}: a result is written as .txt, .json, .csv or .md "
                "(afmcalc report writes HTML and PDF, afmcalc plot pictures)",
                output=output,
            )
        )
    named = _ENDINGS.get(ending)
    if named and asked not in (None, named):
        raise AfmcalcError(
            say("--output {output} is the name of a file of format {named}, not {asked}",
                output=output, named=named, asked=asked)
        )  # fmt: skip
    return asked or named or "table"


def format_of_spec(output: str) -> str:
    """Format in which a spec goes to a file, by its name: TOML where that says nothing.

    Raises:
        AfmcalcError: the name ends in something else.
    """
    ending = ending_of(output)
    if ending != ".toml" and ending in (*_ENDINGS, *_NO_RESULT) and ending != ".json":
        raise AfmcalcError(say("--output {output}: it gets a spec: .toml or .json", output=output))
    return "json" if ending == ".json" else "toml"


def html_only(output: str | None) -> None:
    """Refuse a name that says a report is something else.

    Raises:
        AfmcalcError: it does.
    """
    stem, ending = os.path.splitext(output or "")
    if ending.lower() in {*_ENDINGS, *_NO_RESULT} - {".html", ".htm"}:
        raise AfmcalcError(
            say("--output {output}: a report is HTML; --output {stem}.html --pdf writes {stem}.pdf beside it",
                output=output, stem=stem)
        )  # fmt: skip


def result_kind(command: str, format_: str, text: str = "") -> Kind:
    """The output of a command in a format; of CSV, which carries no mark, the header line of ``text`` tells."""
    starts = {
        "table": (f"{command}: ", f"{command}\n"),
        "markdown": (f"## {command}: ", f"## {command}\n"),
        "json": (f'{{\n  "command": "{command}",',),
        "csv": (text.partition("\n")[0] + "\n",) if text else ("",),
    }[format_]
    return Kind(
        say("{format} of {command}", format=format_, command=command), tuple(start.encode() for start in starts)
    )


def refuse(path: str | None, kind: Kind, *, force: bool, inputs: Iterable[str | None] = ()) -> None:
    """Refuse to write over what is read, and without ``force`` over what was not written as the same kind.

    Raises:
        AfmcalcError: it would be lost.
    """
    if path in (None, "-") or not os.path.isfile(path):
        return
    for source in inputs:
        if source not in (None, "-") and os.path.exists(source) and os.path.samefile(source, path):
            raise AfmcalcError(say("{path}: is read itself; write to another file", path=path))
    if force or not os.path.getsize(path):
        return
    if not os.stat(path).st_mode & 0o222:
        raise AfmcalcError(say("{path}: is write-protected; --force replaces it", path=path))
    try:
        with open(path, "rb") as file:
            known = kind.wrote(file.read())
    except OSError:
        known = False
    if not known:
        raise AfmcalcError(
            say("{path}: exists already, and not as a {kind} that afmcalc wrote; --force replaces it",
                path=path, kind=term(kind.name))
            if kind is not SPEC
            else say("{path}: exists already, and may have been edited; --force replaces it", path=path)
        )  # fmt: skip


def write(text: str, path: str | None, kind: Kind, *, force: bool = False) -> None:
    """Write text to standard output, or to a file that is either whole or untouched."""
    if path is None or path == "-":
        if kind is SPEC and not is_unicode(sys.stdout) and not sys.stdout.isatty():
            # a spec is read as UTF-8, whatever the locale of the one who writes it
            sys.stdout.flush()
            sys.stdout.buffer.write(text.encode())
        else:
            sys.stdout.write(text)
        sys.stdout.flush()
        return
    write_file(path, text.encode("utf-8", "backslashreplace"), kind, force=force)


def write_file(path: str, content: bytes, kind: Kind, *, force: bool = False) -> None:
    """Replace a file at once, by way of a temporary one beside it.

    Raises:
        AfmcalcError: a file is there that was not written as the same kind.
        FileError: it cannot be written.
    """
    refuse(path, kind, force=force)
    try:
        target = os.path.realpath(path)
        if os.path.exists(target) and not os.path.isfile(target):
            with open(path, "wb") as file:
                file.write(content)
            return
        with put_off():
            _replace(target, content)
            unreported.append(path)
    except OSError as error:
        raise FileError(say("{path}: cannot be written: {why}", path=path, why=reason(error))) from None


def _replace(target: str, content: bytes) -> None:
    import tempfile

    if os.path.islink(target):
        # links that lead to each other: replacing one would hide the fault
        os.stat(target)
    handle, temporary = tempfile.mkstemp(dir=os.path.dirname(target), prefix=".afmcalc-")
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(content)
        os.chmod(temporary, _mode(target))
        os.replace(temporary, target)
    except BaseException:
        with suppress(OSError):
            os.unlink(temporary)
        raise


def _mode(target: str) -> int:
    """Permissions for a written file: those it had, or those the umask leaves."""
    try:
        return os.stat(target).st_mode & 0o777
    except FileNotFoundError:
        mask = os.umask(0)
        os.umask(mask)
        return 0o666 & ~mask
