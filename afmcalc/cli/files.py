"""Writing to standard output, or to a file that is either whole or untouched."""

import sys
from typing import Any

from ..errors import FileError
from ..messages import say


def write(text: str, path: str | None) -> None:
    """Write text to standard output, or to a file that is either whole or untouched."""
    if path is None or path == "-":
        sys.stdout.write(text)
        sys.stdout.flush()
        return
    write_file(path, text.encode("utf-8"))


def write_file(path: str, content: bytes) -> None:
    """Replace a file at once, by way of a temporary one beside it.

    Raises:
        FileError: it cannot be written.
    """
    import os
    import tempfile

    target = os.path.realpath(path)
    if os.path.exists(target) and not os.path.isfile(target):
        _write_through(path, content)
        return
    temporary = None
    try:
        handle, temporary = tempfile.mkstemp(dir=os.path.dirname(target), prefix=".afmcalc-")
        with os.fdopen(handle, "wb") as file:
            file.write(content)
        os.chmod(temporary, _mode(target))
        os.replace(temporary, target)
    except OSError as error:
        raise FileError(say("{path}: cannot be written: {why}", path=path, why=error.strerror or error)) from None
    except BaseException:
        if temporary:
            os.unlink(temporary)
        raise


def _write_through(path: str, content: bytes) -> None:
    """Write to what is no regular file (a device, a pipe)."""
    try:
        with open(path, "wb") as file:
            file.write(content)
    except OSError as error:
        raise FileError(say("{path}: cannot be written: {why}", path=path, why=error.strerror or error)) from None


def _mode(target: str) -> int:
    """Permissions for a written file: those it had, or those the umask leaves."""
    import os

    try:
        return os.stat(target).st_mode & 0o777
    except FileNotFoundError:
        mask = os.umask(0)
        os.umask(mask)
        return 0o666 & ~mask


def spec_text(data: dict[str, Any], path: str) -> str:
    """Plain data of a spec as JSON, where the name of its file says so, else as TOML."""
    if path.endswith(".json"):
        import json

        return json.dumps(data, indent=2, ensure_ascii=False) + "\n"
    from ..spec import to_toml

    return to_toml(data)
