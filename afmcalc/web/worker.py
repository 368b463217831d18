"""A process that calculates for the page: kept warm, and ended where nobody waits for its answer any more."""

import asyncio
import json
import sys
from asyncio.subprocess import PIPE, Process
from collections.abc import AsyncGenerator, Awaitable, Callable
from typing import Any

from ..messages import spoken, told

_START = "import sys; sys.path[:] = {path!r}; from afmcalc.web.calculator import main; main({language!r}, {units!r})"
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
        if self._warm is None:
            self._warm = asyncio.create_task(self._started())
        return self._warm

    async def _started(self) -> Process:
        code = _START.format(path=sys.path, language=spoken(), units=self._units)
        # in a session of its own: Ctrl-C is for the server, which ends it
        process = self._process = await asyncio.create_subprocess_exec(
            sys.executable, "-c", code, stdin=PIPE, stdout=PIPE, limit=_LONGEST, start_new_session=True
        )
        assert process.stdout is not None
        await process.stdout.readline()
        return process

    def end(self) -> None:
        """End the process, whatever it is at."""
        if self._process is not None and self._process.returncode is None:
            self._process.kill()
        if self._warm is not None:
            self._warm.cancel()
        self._process = self._warm = None

    def close(self) -> None:
        """End the process for good."""
        self._closed = True
        self.end()

    async def ask(self, job: Any, gone: Callable[[], Awaitable[bool]]) -> AsyncGenerator[dict[str, Any]]:
        """Give what is told of a job, its answer last; nothing where whoever asked is ``gone``.

        The process is ended where it takes too long, or whoever listens stops.
        """
        self._turn += 1
        turn = self._turn
        if self._newest and self._busy:
            self.end()
        async with self._lock:
            if await gone():
                return
            try:
                process = await asyncio.shield(self.start())
            except OSError as error:
                self.end()
                yield problem(told("the process that calculates cannot be started: {why}", why=str(error)))
                return
            if self._newest and turn != self._turn:
                yield problem(_superseded())
                return
            self._busy, answered = True, False
            try:
                async for line in self._lines(process, job):
                    answered = "progress" not in line
                    yield line
                if not answered:
                    why = told("the calculation ended without an answer: out of memory?")
                    yield problem(_superseded() if turn != self._turn else why)
            except TimeoutError:
                yield problem(told("the calculation takes longer than {limit:g} s: it was ended", limit=self._limit))
            finally:
                self._busy = False
                if not answered:
                    self.end()
                    if not self._closed:
                        self.start()

    async def _lines(self, process: Process, job: Any) -> AsyncGenerator[dict[str, Any]]:
        """Give the job to the process, and give what it says, its answer last; less where it ends before that."""
        assert process.stdin is not None
        assert process.stdout is not None
        loop = asyncio.get_running_loop()
        end = loop.time() + self._limit
        process.stdin.write(json.dumps(job).encode() + b"\n")
        while line := await asyncio.wait_for(process.stdout.readline(), end - loop.time()):
            said = json.loads(line)
            yield said
            if "progress" not in said:
                return


def _superseded() -> str:
    return told("a newer change has taken the place of this one")


def problem(sentence: str) -> dict[str, Any]:
    """Return an answer that is a problem."""
    return {"errors": {}, "problems": [sentence]}
