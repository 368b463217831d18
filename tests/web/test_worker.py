"""The process that calculates: which jobs it answers, when it is ended, what memory and time it may take."""

import asyncio
import io
import json
import os
import resource
import signal
import sys
from contextlib import aclosing

import pytest
from pages import CONFIGS, finished, web
from serving import proc, until

pytestmark = web
LONG = """[search]
control_unit.gain = "0.1:1.2:1000"
friction_group.pairs = [4, 6, 8, 10]
friction_group.mean_radius = "60 mm:140 mm:400"
adjustment.nominal_torque = "200 N*m"
"""
"""A search that takes some ten seconds."""


class Process:
    """Stand-in for the process of a worker: records the jobs, and answers with given lines."""

    returncode = None

    def __init__(self):
        self.stdin, self.stdout, self.asked = self, asyncio.StreamReader(), []
        self.answer({})

    def write(self, line):
        self.asked.append(json.loads(line))

    def answer(self, said):
        self.stdout.feed_data(json.dumps(said).encode() + b"\n")

    def kill(self):
        self.returncode = -9
        self.stdout.feed_eof()


@pytest.fixture
def started(monkeypatch):
    """List of the stand-ins started so far."""
    processes = []

    async def start(*arguments, **options):
        assert options["start_new_session"]
        processes.append(Process())
        return processes[-1]

    monkeypatch.setattr(asyncio, "create_subprocess_exec", start)
    return processes


async def here():
    return False


def run(scene, *arguments, **options):
    """Run a coroutine that takes a worker."""
    from afmcalc.web.worker import Worker

    async def played():
        worker = Worker("si", options.get("limit", 1e9), newest=options.get("newest", False))
        worker.start()
        await asyncio.sleep(0.001)
        await scene(worker)
        worker.end(closed=True)
        await asyncio.sleep(0)

    finished(asyncio.wait_for(played(), 20))


async def asked(worker, job, gone=here, page=""):
    return [each async for each in worker.ask(job, gone, page)]


def test_a_job_is_told_of_and_answered(started):
    """Jobs are answered one after the other; nothing is calculated for a client that has left."""

    async def scene(worker):
        async def gone():
            return True

        for number in range(2):
            said = [{"progress": 0.5, "text": "on"}, {"progress": None, "text": ""}, {"html": number}]
            for each in said:
                started[0].answer(each)
            assert await asked(worker, {"job": number}) == said
            assert await asked(worker, {"job": "none"}, gone) == []
        assert [process.asked for process in started] == [[{"job": 0}, {"job": 1}]]

    run(scene)


def test_who_stops_listening_ends_the_process(started):
    """A new process replaces one that was calculating; after an answer the process stays."""

    async def scene(worker):
        for said in ({"progress": 0.1}, {"html": ""}):
            process = started[-1]
            process.answer(said)
            async with aclosing(worker.ask({}, here)) as answers:
                assert await anext(answers) == said
            await asyncio.sleep(0.001)
            assert (process.returncode, len(started)) == ((None, 2) if "html" in said else (-9, 2))

    run(scene)


@pytest.mark.parametrize(("limit", "said"), [(0, "longer than 0 s"), (1e9, "without an answer")])
def test_what_takes_too_long_or_dies_is_said_and_replaced(started, limit, said):
    async def scene(worker):
        job = asyncio.create_task(asked(worker, {}))
        await asyncio.sleep(0.001)
        if limit:
            started[0].kill()
        (told,) = await job
        assert said in told["problems"][0]
        await asyncio.sleep(0.001)
        assert [process.returncode for process in started] == [-9, None]

    run(scene, limit=limit)


def test_what_died_or_could_not_start_is_started_again(started, monkeypatch):
    """At the next job a process is started anew if it was killed while idle, could not start, or ended at once."""

    async def scene(worker):
        started[0].kill()
        job = asyncio.create_task(asked(worker, {}))
        await asyncio.sleep(0.001)
        started[1].answer({"html": 1})
        assert await job == [{"html": 1}]
        start = asyncio.create_subprocess_exec

        async def refused(*arguments, **options):
            raise OSError("no memory")

        async def ends(*arguments, **options):
            (process := await start(*arguments, **options)).stdout = asyncio.StreamReader()
            process.kill()
            return process

        worker.end()
        for how, why in ((refused, "no memory"), (refused, "no memory"), (ends, "it ended at once")):
            monkeypatch.setattr(asyncio, "create_subprocess_exec", how)
            assert f"could not be started: {why}" in str(await asked(worker, {}))
        monkeypatch.setattr(asyncio, "create_subprocess_exec", start)
        job = asyncio.create_task(asked(worker, {}))
        await asyncio.sleep(0.001)
        started[-1].answer({"html": 2})
        assert await job == [{"html": 2}]

    run(scene)


def test_one_page_does_not_end_the_work_of_another(started):
    async def scene(worker):
        tasks = []
        for number, page in enumerate("aba"):
            tasks.append(asyncio.create_task(asked(worker, number, page=page)))
            await asyncio.sleep(0.001)
        for number in (1, 2):
            started[-1].answer({"html": number})
            await asyncio.sleep(0.001)
        told = await asyncio.gather(*tasks)
        assert told[1:] == [[{"html": 1}], [{"html": 2}]]
        assert "newer change" in str(told[0])

    run(scene, newest=True)


@pytest.mark.parametrize("newest", [True, False])
def test_a_newer_job_takes_the_place_of_others(started, newest):
    """With ``newest``, a job replaces the one calculated and the one that waits; else all are answered in turn."""

    async def scene(worker):
        tasks = [asyncio.create_task(asked(worker, 0))]
        await asyncio.sleep(0.001)
        tasks += [asyncio.create_task(asked(worker, number)) for number in (1, 2)]
        while newest and started[-1].asked[-1:] != [2]:
            await asyncio.sleep(0.001)
        for number in [2] if newest else range(3):
            started[-1].answer({"html": number})
        *others, last = await asyncio.gather(*tasks)
        assert last == [{"html": 2}]
        assert [process.asked for process in started if process.asked] == ([[0], [2]] if newest else [[0, 1, 2]])
        if newest:
            assert ["newer change" in told["problems"][0] for (told,) in others] == [True, True]
            assert [process.returncode for process in started] == [-9] * (len(started) - 1) + [None]
        else:
            assert others == [[{"html": 0}], [{"html": 1}]]

    run(scene, newest=newest)


@pytest.mark.filterwarnings("ignore::ResourceWarning")  # the output of the process is open until it ends
def test_the_process_itself(monkeypatch, tmp_path):
    """It limits its memory, reports that it is ready and its progress, and answers each job, also one that fails."""
    from afmcalc.web import worker

    limits, texts = [], (CONFIGS / "default.toml").read_text(encoding="utf-8")
    state = [["clutch", texts, "clutch.toml", [], ""], {"control_unit.gain": "0.7"}]
    few = "[search]\ncontrol_unit.gain = 0.5\nfriction_group.pairs = 8\n"
    job = {"name": "live", "state": state, "pinned": None, "options": {"requirements": few}, "first": 1}
    jobs = [job, job | {"pinned": state}, job | {"name": "design"}, job | {"name": "no such"}]
    monkeypatch.setattr(resource, "setrlimit", lambda of, ends: limits.append((of, *ends)))
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO("\n".join(map(json.dumps, jobs)).encode())))
    monkeypatch.setattr(os, "dup", lambda number: os.open(tmp_path / "out", os.O_CREAT | os.O_WRONLY))
    monkeypatch.setattr(sys, "stdout", sys.__stdout__)
    worker.main("ru", "si", 0)
    said = [json.loads(line) for line in (tmp_path / "out").read_text(encoding="utf-8").splitlines()]
    assert limits == [(resource.RLIMIT_AS, 8 << 30, 8 << 30)]
    assert said[0] == {}
    told = [each for each in said[1:] if "progress" in each]
    live, pinned, design, fault = (each for each in said[1:] if "progress" not in each)
    assert min(each["ms"] for each in (live, pinned, design, fault)) >= 0
    assert "control_unit.gain=0.7" in live["command"]
    assert (live["fragments"]["compare"] == "", pinned["fragments"]["compare"] == "") == (True, False)
    assert all(0 <= each["progress"] <= 1 for each in told)
    assert "html" in design or design["errors"]
    assert "KeyError" in str(fault["problems"])


# real processes


@pytest.fixture
def search(served):
    """Start a search; yield the lines of its answer."""
    assert served.live({})["fragments"]
    with served.streaming("design", requirements=LONG) as lines:
        assert "progress" in next(lines)
        yield lines


@proc
@pytest.mark.tool
def test_while_a_search_runs(served, search):
    """A change is answered at once; a job of another tab replaces the search, which then takes no more time."""
    before = served.family()
    assert served.live({"control_unit.gain": "0.7"})["fragments"]
    assert served.family() == before
    assert "html" in served.tab("accuracy", {})
    *_, last = search
    assert "html" not in last
    assert served.family() != before
    until(served.is_quiet)


@proc
@pytest.mark.tool
def test_whoever_goes_leaves_one_worker(served):
    """Leaving a search twice leaves one worker; workers that are killed from outside are replaced, too."""
    assert "html" in served.tab("accuracy", {})
    family = served.family()
    assert len(family) == 3
    for _ in range(2):
        with served.streaming("design", requirements=LONG) as lines:
            next(lines)
    until(lambda: len(served.family()) == 3 and served.is_quiet())
    for pid in served.family() - {served.process.pid}:
        os.kill(pid, signal.SIGKILL)
    served.live({})  # the answer may be that the worker was ended
    served.tab("accuracy", {})
    assert served.live({})["fragments"]
    assert "html" in served.tab("accuracy", {})


@proc
@pytest.mark.tool
@pytest.mark.parametrize(("number", "codes"), [("SIGINT", [130]), ("SIGTERM", [143, -15]), ("SIGKILL", [-9])])
def test_no_process_is_left(serve, number, codes):
    """The server ends during a search and a half request; Ctrl-C in a terminal reaches all of its processes."""
    served = serve()
    with served.connected() as connection, served.streaming("design", requirements=LONG) as lines:
        connection.sendall(f"POST {served.root}live HTTP/1.1\r\nHost: {served.host}\r\nContent-Le".encode())
        next(lines)
        (os.killpg if number == "SIGINT" else os.kill)(served.process.pid, getattr(signal, number))
        assert served.process.wait(10) in codes
    until(lambda: not served.family())
    assert "Traceback" not in served.said
