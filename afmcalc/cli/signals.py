"""Ctrl-C and the like: the program tidies up and ends with 128 + the number of the signal, without a traceback.

The handler raises ``SystemExit``: the blocks that are left take away the bar, temporary files and the browser. The
parser of the command line turns ``KeyboardInterrupt`` into an error of its own, so that one is not for us.
"""

import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager

_SIGNALS = [getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)]
_AGAIN = 0.01
"""Seconds until a signal is sent again that came where no exception can leave."""
_waiting: list[int] = []
_blocks: list[bool] = []
unreported: list[str] = []
"""Files written of which nothing has been said yet."""


def watch() -> None:
    """Take charge of the signals that end a program, but of none that is ignored (``nohup``, a shell's background)."""
    sys.unraisablehook = _unraisable
    for number in _SIGNALS:
        if signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, _arrived)


def ignore() -> None:
    """Ignore the signals from here on: the work is done and the exit code known."""
    for number in _SIGNALS:
        signal.signal(number, signal.SIG_IGN)


@contextmanager
def put_off() -> Iterator[None]:
    """Put signals off until the end of the block, which does not last; end the program then if one has come."""
    _blocks.append(True)
    try:
        yield
    finally:
        _blocks.pop()
        if _waiting and not _blocks:
            _end(_waiting.pop())


def _arrived(number: int, frame: object) -> None:
    if _blocks:
        _waiting.append(number)
    else:
        _end(number)


def _end(number: int) -> None:
    while unreported:
        from ..messages import say, told

        print(told("note: {text}", text=say("wrote {output}", output=unreported.pop(0))), file=sys.stderr)
    sys.exit(128 + number)


def _unraisable(lost: "sys.UnraisableHookArgs") -> None:
    """Send a signal again that came in a destructor, which no exception can leave; print what else is lost there."""
    if isinstance(lost.exc_value, SystemExit) and isinstance(lost.exc_value.code, int):
        from threading import Timer

        Timer(_AGAIN, signal.raise_signal, [lost.exc_value.code - 128]).start()
    else:
        sys.__unraisablehook__(lost)
