"""The process that calculates: a job for each line of its standard input, answered by lines of JSON."""

import json
import logging
import os
import sys
import time
import warnings
from collections.abc import Mapping
from contextlib import suppress
from typing import Any, TextIO

from ..errors import unexpected
from ..messages import ENGLISH, language, speaking, translate
from ..progress import Bar
from ..render.units import shown_in
from ..spec.parse import example_text
from .base import Base
from .live import Ask
from .tabs import answer

_MEMORY = 8 << 30
"""Bytes of addresses that the process may have, so that what is asked by mistake does not take those of others."""
_EACH = 0.1
"""Seconds between two words of how far it is."""


class _Progress(Bar):
    """Writes how far a calculation is."""

    def __init__(self, out: TextIO) -> None:
        super().__init__(quiet=True, agreed=True)
        self._out = out

    def advance(self, work: str, done: int, total: int) -> None:
        """Write it, not too often."""
        now = time.monotonic()
        if now - self._shown >= _EACH:
            self._shown = now
            _write(self._out, {"progress": done / total if total else None, "text": translate(work)})

    def pulse(self) -> None:
        """Say nothing: what goes on is being waited for."""


def main(language_name: str, units: str) -> None:
    """Answer until the input ends."""
    with suppress(ImportError):  # of POSIX
        from resource import RLIMIT_AS, setrlimit

        setrlimit(RLIMIT_AS, (_MEMORY, _MEMORY))
    out = os.fdopen(os.dup(sys.stdout.fileno()), "w", encoding="utf-8")
    sys.stdout = sys.stderr  # what a library prints is no answer
    warnings.simplefilter("error", RuntimeWarning)
    logging.getLogger("matplotlib").setLevel(logging.ERROR)
    speaks = ENGLISH if language_name == ENGLISH.name else language(language_name)
    with speaking(speaks), shown_in(units), suppress(BrokenPipeError):  # whoever has gone wants no answer
        answer(Ask("live", Base("", example_text("default"), None), {}))
        _write(out, {})
        for line in sys.stdin.buffer:
            _write(out, _answered(json.loads(line), out))


def _answered(job: Mapping[str, Any], out: TextIO) -> dict[str, Any]:
    base, fields, pinned = Base.of(job["base"]), job["fields"], job["pinned"]
    pinned = pinned and (Base.of(pinned[0]), pinned[1])
    with _Progress(out):
        try:
            began = time.perf_counter()
            asked = answer(Ask(job["name"], base, fields, pinned, job["options"], job["first"]))
            return asked | {"ms": round(1e3 * (time.perf_counter() - began), 1)}
        except Exception as error:
            return {"errors": {}, "problems": unexpected(error)[1]}


def _write(out: TextIO, said: Mapping[str, Any]) -> None:
    out.write(json.dumps(said) + "\n")
    out.flush()
