"""The process that calculates: whom it answers, when it is ended, what it may take."""

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
    """Stands for the process of a worker: what it is asked, and the lines that it is made to answer."""

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
    """The processes that are started, as they are."""
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
    """Play a scene with a worker."""
    from afmcalc.web.worker import Worker

    async def played():
        worker = Worker("si", options.get("limit", 1e9), newest=options.get("newest", False))
        worker.start()
        await asyncio.sleep(0.001)
        await scene(worker)
        worker.end(closed=True)
        await asyncio.sleep(0)

    finished(asyncio.wait_for(played(), 20))


async def asked(worker, job, gone=here):
    return [each async for each in worker.ask(job, gone)]


def test_a_job_is_told_of_and_answered(started):
    """One after the other; nothing is calculated for whom has gone."""

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
    """Another takes its place; after an answer there is nothing to end."""

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
        if limit:
            started[0].kill()
        (told,) = await asked(worker, {})
        assert said in told["problems"][0]
        await asyncio.sleep(0.001)
        assert [process.returncode for process in started] == [-9, None]

    run(scene, limit=limit)


@pytest.mark.parametrize("newest", [True, False])
def test_a_newer_job_takes_the_place_of_others(started, newest):
    """Of the one that is calculated and of one that waits; or all are answered, one after the other."""

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


@pytest.mark.filterwarnings("ignore::ResourceWarning")  # its output is open until it ends
def test_the_process_itself(monkeypatch, tmp_path):
    """It limits its memory, says that it is warm, tells of a job and answers it, also where that is at fault."""
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
    worker.main("ru", "si")
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


# real ones


@pytest.fixture
def search(served):
    """A search under way, and the lines that come of it."""
    assert served.live({})["fragments"]
    with served.streaming("design", requirements=LONG) as lines:
        assert "progress" in next(lines)
        yield lines


@proc
@pytest.mark.tool
def test_while_a_search_runs(served, search):
    """A change is answered, another tab takes its place, and nothing is calculated any longer."""
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
    """Twice; what is killed from outside is replaced, too."""
    assert "html" in served.tab("accuracy", {})
    family = served.family()
    assert len(family) == 3
    for _ in range(2):
        with served.streaming("design", requirements=LONG) as lines:
            next(lines)
    until(lambda: len(served.family()) == 3 and served.is_quiet())
    for pid in served.family() - {served.process.pid}:
        os.kill(pid, signal.SIGKILL)
    served.live({})  # may say that it was ended
    served.tab("accuracy", {})
    assert served.live({})["fragments"]
    assert "html" in served.tab("accuracy", {})


@proc
@pytest.mark.tool
@pytest.mark.parametrize(("number", "codes"), [("SIGINT", [130]), ("SIGTERM", [143, -15]), ("SIGKILL", [-9])])
def test_no_process_is_left(serve, number, codes):
    """While a search runs and half a request has come; Ctrl-C in a terminal is for all of its processes."""
    served = serve()
    with served.connected() as connection, served.streaming("design", requirements=LONG) as lines:
        connection.sendall(f"POST {served.root}live HTTP/1.1\r\nHost: {served.host}\r\nContent-Le".encode())
        next(lines)
        (os.killpg if number == "SIGINT" else os.kill)(served.process.pid, getattr(signal, number))
        assert served.process.wait(10) in codes
    until(lambda: not served.family())
    assert "Traceback" not in served.said
