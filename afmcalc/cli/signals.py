"""Ctrl-C and its kin, at any moment: the program tidies up and ends with 128 + the number, without a traceback.

An exception thrown into whatever runs (an import, a destructor, the interpreter's end) may be lost, replaced or printed
there. So the handler itself ends the process, after what was registered with ``atexit``: temporary folders go, the
cursor comes back. Nothing else is in need of it: a file is written in one piece, under ``put_off``.
"""

# the builtin module: ``signal`` would import some more, for as long as Ctrl-C still printed a traceback
import _signal  # type: ignore[import-not-found]
import atexit
import os
import sys

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import NoReturn

_SIGNALS = [getattr(_signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(_signal, name)]
_waiting: list[int] = []
_held: list[bool] = []
unreported: list[str] = []
"""Files written of which nothing has been said yet."""


def watch() -> None:
    """Take charge of the signals that end a program, but of none that is ignored (``nohup``, a shell's background)."""
    for number in _SIGNALS:
        if _signal.getsignal(number) is not _signal.SIG_IGN:
            _signal.signal(number, _arrived)


class put_off:  # noqa: N801
    """Put signals off until the end of the block, which does not last."""

    def __enter__(self) -> None:
        """Begin."""
        _held.append(True)

    def __exit__(self, *error: object) -> None:
        """End the process now if a signal has come."""
        _held.pop()
        if _waiting and not _held:
            _end(_waiting[0])


def _arrived(number: int, frame: object) -> None:
    if _held:
        _waiting.append(number)
    else:
        _end(number)


def _end(number: int) -> None:
    for each in _SIGNALS:
        _signal.signal(each, _signal.SIG_IGN)
    for path in unreported:
        from ..messages import say, told

        print(told("note: {text}", text=say("wrote {output}", output=path)), file=sys.stderr)
    leave(128 + number)


def leave(code: int) -> "NoReturn":
    """End the process after what was registered with ``atexit``, without the interpreter's long farewell."""
    try:
        atexit._run_exitfuncs()
        sys.stdout.flush()
        sys.stderr.flush()
    finally:
        os._exit(code)
