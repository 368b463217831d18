"""Process that calculates for the page: it is started in advance, and killed when its answer is no longer wanted.

Each line of its standard input is a job, each line of its output reports progress or is an answer, as JSON.
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
from contextlib import aclosing, suppress
from typing import Any, TextIO

from ..errors import reason, unexpected
from ..messages import language, say, speaking, spoken
from ..progress import watched
from ..render.amounts import shown_in
from ..spec.parse import example_text
from .form import Base, State, refusal

_MEMORY = 8 << 30
"""Limit of the process's address space, bytes: an oversized job must not take the memory of other programs."""
_START = (
    "import sys; sys.path[:] = {path!r}; from afmcalc.web.worker import main; main({language!r}, {units!r}, {nice})"
)
_LONGEST = 64 << 20
"""Largest length of a line of an answer, bytes."""


class Worker:
    """One process, which takes one job at a time."""

    def __init__(self, units: str, limit: float, *, newest: bool) -> None:
        """Show quantities in ``units``; a job may take ``limit`` seconds.

        ``newest``: a newer job of a page ends its older jobs, and other processes take precedence over this one.
        """
        self._units, self._limit, self._newest = units, limit, newest
        self._turn, self._closed = 0, False
        self._latest = dict[str, int]()
        """Page → turn of its newest job."""
        self._busy: str | None = None
        """Page whose job is calculated."""
        self._lock = asyncio.Lock()
        self._process: Process | None = None
        self._warm: asyncio.Task[Process] | None = None

    def start(self) -> "asyncio.Task[Process]":
        """Task that starts the process, or that has started the running process; it is done when that is ready."""
        warm = self._warm
        if warm is None or (warm.done() and (warm.exception() or warm.result().returncode is not None)):
            self._warm = warm = asyncio.create_task(self._started())
            warm.add_done_callback(lambda task: task.cancelled() or task.exception())
        return warm

    async def _started(self) -> Process:
        code = _START.format(path=sys.path, language=spoken(), units=self._units, nice=10 * self._newest)
        # in its own session: Ctrl-C reaches only the server, which then kills the process
        process = self._process = await asyncio.create_subprocess_exec(
            sys.executable, "-c", code, stdin=PIPE, stdout=PIPE, limit=_LONGEST, start_new_session=True
        )
        assert process.stdout
        if not await process.stdout.readline():
            raise ChildProcessError(say("it ended at once"))
        return process

    def end(self, *, closed: bool = False) -> None:
        """Kill the process, whatever it does; start another process unless ``closed``."""
        self._closed = self._closed or closed
        if self._process is not None and self._process.returncode is None:
            self._process.kill()
        if self._warm is not None:
            self._warm.cancel()
        self._process = self._warm = None
        if not self._closed:
            self.start()

    async def ask(
        self, job: Any, gone: Callable[[], Awaitable[bool]], page: str = ""
    ) -> AsyncGenerator[dict[str, Any]]:
        """Yield the progress of a page's job, then the answer; nothing if the client is ``gone``.

        The process is killed at the time limit, or when the caller stops listening.
        """
        turn = self._turn = self._latest[page] = self._turn + 1
        if self._newest and self._busy == page:
            self.end()
        try:
            async with self._lock:
                if await gone():
                    return
                process = await asyncio.shield(self.start())
                if not self._newest or turn == self._latest.get(page):
                    self._busy = page
                    async with aclosing(self._lines(process, job)) as lines:
                        async for said in lines:
                            yield said
                            if "progress" not in said:
                                return
                if turn == self._latest.get(page):
                    yield refusal(say("the calculation ended without an answer: out of memory?"))
                else:
                    yield refusal(say("a newer change has taken the place of this one"))
        except TimeoutError:
            yield refusal(say("the calculation takes longer than {limit:g} s: it was ended", limit=self._limit))
        except OSError as error:
            yield refusal(say("the calculation could not be started: {why}", why=reason(error)))
        finally:
            if self._latest.get(page) == turn:
                del self._latest[page]

    async def _lines(self, process: Process, job: Any) -> AsyncGenerator[dict[str, Any]]:
        """Yield what the process writes about a job until it ends; a process that has not answered is killed."""
        answered, clock = False, asyncio.get_running_loop().time
        end = clock() + self._limit
        assert process.stdin
        assert process.stdout
        try:
            process.stdin.write(json.dumps(job).encode() + b"\n")
            while not answered:
                line = await asyncio.wait_for(process.stdout.readline(), end - clock())
                if not line.endswith(b"\n"):
                    return
                said = json.loads(line)
                answered = "progress" not in said
                yield said
        finally:
            self._busy = None
            if not answered and process is self._process:
                self.end()


def main(language_name: str, units: str, nice: int) -> None:
    """Answer the jobs on standard input until its end; ``nice`` lowers the priority of the process."""
    from .replies import answer

    with suppress(ImportError):  # the module exists only on POSIX
        from resource import RLIMIT_AS, setrlimit

        setrlimit(RLIMIT_AS, (_MEMORY, _MEMORY))
    if hasattr(os, "nice"):
        os.nice(nice)
    out = os.fdopen(os.dup(sys.stdout.fileno()), "w", encoding="utf-8")
    sys.stdout = sys.stderr  # what a library prints must not mix with the answers
    warnings.simplefilter("error", RuntimeWarning)
    logging.getLogger("matplotlib").setLevel(logging.ERROR)
    told = 0.0

    def advance(work: str, done: int, total: int) -> None:
        nonlocal told
        if time.monotonic() - told >= 0.1:
            told = time.monotonic()
            _write(out, {"progress": done / total if total else None, "text": work})

    with speaking(language(language_name)), shown_in(units), suppress(BrokenPipeError):  # if the server has ended
        answer(State(Base("", example_text("default"), None)), {"name": "live", "pinned": None, "options": {}})
        _write(out, {})  # tells the server that the process is ready
        for line in sys.stdin.buffer:
            job, began = json.loads(line), time.perf_counter()
            state, pinned = (each and State(Base(*each[0]), each[1]) for each in (job["state"], job["pinned"]))
            try:
                with watched(advance):
                    answered = answer(state, job | {"pinned": pinned})
            except Exception as error:
                answered = refusal(*unexpected(error)[1])
            _write(out, answered | {"ms": round(1e3 * (time.perf_counter() - began), 1)})


def _write(out: TextIO, said: Mapping[str, Any]) -> None:
    out.write(json.dumps(said) + "\n")
    out.flush()
