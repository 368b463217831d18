"""A process that calculates for the page: kept warm, and ended where nobody waits for its answer any more.

It takes a job with each line of its standard input, and answers with lines of JSON.
"""

import asyncio
import json
import logging
import os
import sys
import time
import warnings
from asyncio.subprocess import PIPE, Process
from collections.abc import AsyncGenerator, Awaitable, Callable, Mapping
from contextlib import suppress
from typing import Any, TextIO

from ..errors import unexpected
from ..messages import language, say, speaking, spoken
from ..progress import Bar
from ..render.amounts import shown_in
from ..spec.parse import example_text

_MEMORY = 8 << 30
"""Bytes of addresses that the process may have, so that what is asked by mistake does not take those of others."""
_START = "import sys; sys.path[:] = {path!r}; from afmcalc.web.worker import main; main({language!r}, {units!r})"
_LONGEST = 64 << 20
"""Bytes that a line of an answer may have."""


class Worker:
    """One process, which takes one job at a time."""

    def __init__(self, units: str, limit: float, *, newest: bool) -> None:
        """Show quantities in ``units``; a job may take ``limit`` seconds; ``newest``: a newer job ends all others."""
        self._units, self._limit, self._newest = units, limit, newest
        self._turn, self._busy, self._closed = 0, False, False
        self._lock = asyncio.Lock()
        self._process: Process | None = None
        self._warm: asyncio.Task[Process] | None = None

    def start(self) -> "asyncio.Task[Process]":
        """Start the process where there is none; it is there once it is warm."""
        self._warm = self._warm or asyncio.create_task(self._started())
        return self._warm

    async def _started(self) -> Process:
        code = _START.format(path=sys.path, language=spoken(), units=self._units)
        # in a session of its own: Ctrl-C is for the server, which ends it
        process = self._process = await asyncio.create_subprocess_exec(
            sys.executable, "-c", code, stdin=PIPE, stdout=PIPE, limit=_LONGEST, start_new_session=True
        )
        assert process.stdout
        await process.stdout.readline()
        return process

    def end(self, *, closed: bool = False) -> None:
        """End the process, whatever it is at; another is started unless it is ``closed`` for good."""
        self._closed = self._closed or closed
        if self._process is not None and self._process.returncode is None:
            self._process.kill()
        if self._warm is not None:
            self._warm.cancel()
        self._process = self._warm = None
        if not self._closed:
            self.start()

    async def ask(self, job: Any, gone: Callable[[], Awaitable[bool]]) -> AsyncGenerator[dict[str, Any]]:
        """Give what is told of a job, its answer last; nothing where whoever asked is ``gone``.

        The process is ended where it takes too long, or whoever listens stops.
        """
        turn = self._turn = self._turn + 1
        superseded = say("a newer change has taken the place of this one")
        if self._newest and self._busy:
            self.end()
        async with self._lock:
            if await gone():
                return
            process = await asyncio.shield(self.start())
            if self._newest and turn != self._turn:
                yield _problem(superseded)
                return
            self._busy, answered, clock = True, False, asyncio.get_running_loop().time
            end, why = clock() + self._limit, say("the calculation ended without an answer: out of memory?")
            assert process.stdin
            assert process.stdout
            try:
                process.stdin.write(json.dumps(job).encode() + b"\n")
                while not answered and (line := await asyncio.wait_for(process.stdout.readline(), end - clock())):
                    said = json.loads(line)
                    answered = "progress" not in said
                    yield said
            except TimeoutError:
                why = say("the calculation takes longer than {limit:g} s: it was ended", limit=self._limit)
            finally:
                self._busy = False
                if not answered and process is self._process:
                    self.end()
            if not answered:
                yield _problem(why if turn == self._turn else superseded)


def _problem(sentence: str) -> dict[str, Any]:
    return {"errors": {}, "problems": [sentence]}


class _Progress(Bar):
    """Progress of a calculation, written not too often."""

    out: TextIO
    last = 0.0

    def advance(self, work: str, done: int, total: int) -> None:
        """Write it."""
        if time.monotonic() - self.last >= 0.1:
            self.last = time.monotonic()
            _write(self.out, {"progress": done / total if total else None, "text": work})


def main(language_name: str, units: str) -> None:
    """Answer until the input ends."""
    from .form import Base, State
    from .replies import answer

    with suppress(ImportError):  # of POSIX
        from resource import RLIMIT_AS, setrlimit

        setrlimit(RLIMIT_AS, (_MEMORY, _MEMORY))
    out = os.fdopen(os.dup(sys.stdout.fileno()), "w", encoding="utf-8")
    sys.stdout = sys.stderr  # what a library prints is no answer
    warnings.simplefilter("error", RuntimeWarning)
    logging.getLogger("matplotlib").setLevel(logging.ERROR)
    with (
        speaking(language(language_name)),
        shown_in(units),
        suppress(BrokenPipeError),
    ):  # whoever has gone wants no answer
        answer(State(Base("", example_text("default"), None)), {"name": "live", "pinned": None})
        _write(out, {})  # warm
        for line in sys.stdin.buffer:
            job, began = json.loads(line), time.perf_counter()
            state, pinned = (each and State(Base(*each[0]), each[1]) for each in (job["state"], job["pinned"]))
            progress = _Progress()
            progress.out = out
            with progress:
                try:
                    answered = answer(state, job | {"pinned": pinned})
                except Exception as error:
                    answered = {"errors": {}, "problems": unexpected(error)[1]}
            _write(out, answered | {"ms": round(1e3 * (time.perf_counter() - began), 1)})


def _write(out: TextIO, said: Mapping[str, Any]) -> None:
    out.write(json.dumps(said) + "\n")
    out.flush()
