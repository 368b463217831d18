"""What runs, for how long, and that nothing is left."""

import json
import os
import signal
import socket
import time
from contextlib import ExitStack

import pytest
from serving import CONFIGS, command_line, proc, spec_in, until, web

pytestmark = [web, proc]
LONG = (CONFIGS / "conveyor.toml").read_text(encoding="utf-8")
"""Requirements whose search takes some ten seconds."""


@pytest.fixture
def running(serve, tmp_path):
    """A server, warm."""
    served = serve(spec_in(tmp_path).name)
    served.live({})
    served.tab("accuracy", {})
    return served


def is_quiet(served):
    return served.busy() < 0.05


def search(served, lines):
    """Wait until a design is being calculated."""
    assert "progress" in next(lines)
    until(lambda: served.busy(0.2) > 0.05)


def test_a_newer_change_ends_what_is_calculated(served):
    """Its process is another, the newer one is answered soon, then nothing is calculated any longer."""
    with served.streaming("design", {}, requirements=LONG) as lines:
        search(served, lines)
        before = set(served.family())
        begun = time.monotonic()
        last = served.tab("accuracy", {"control_unit.gain": "0.7"})[-1]
        assert "html" in last
        assert time.monotonic() - begun < 20
        rest = list(lines)
        assert "html" not in rest[-1] if rest else True
        assert time.monotonic() - begun < 20
    assert set(served.family()) != before
    until(lambda: is_quiet(served), 5)


@pytest.mark.exhaustive
def test_who_goes_away_is_not_calculated_for(running):
    with running.streaming("design", {}, requirements=LONG) as lines:
        search(running, lines)
    assert until(lambda: is_quiet(running), 6) < 6
    assert running.live({})["fragments"]


@pytest.mark.exhaustive
def test_a_change_is_answered_while_a_design_runs(running):
    with running.streaming("design", {}, requirements=LONG) as lines:
        next(lines)
        for number in range(5):
            begun = time.monotonic()
            assert running.live({"control_unit.gain": f"0.{number + 3}"})["fragments"]
            assert time.monotonic() - begun < 2


@pytest.mark.exhaustive
def test_many_newer_changes_leave_one_worker(running):
    before = len(running.family())
    for _ in range(20):
        with running.streaming("design", {}, requirements=LONG) as lines:
            next(lines)
    until(lambda: len(running.family()) <= before + 1, 10)
    until(lambda: is_quiet(running), 6)
    assert "html" in running.tab("accuracy", {})[-1]


@pytest.mark.parametrize("to", ["group", "server"])
@pytest.mark.parametrize("doing", ["a design", "nothing", "half a request"])
@pytest.mark.every(6)
def test_ctrl_c_ends_all_at_once(running, doing, to):
    """Within 2 s, with 130, no process left, no traceback."""
    family = running.family()
    assert family
    if doing == "a design":
        with running.streaming("design", {}, requirements=LONG) as lines:
            search(running, lines)
            _interrupted(running, to)
    elif doing == "half a request":
        with socket.create_connection(("127.0.0.1", running.port)) as connection:
            connection.sendall(f"POST {running.root}live HTTP/1.1\r\nHost: {running.host}\r\nContent-Le".encode())
            _interrupted(running, to)
    else:
        _interrupted(running, to)


def _interrupted(served, to):
    begun = time.monotonic()
    if to == "group":
        served.interrupt()
    else:
        os.kill(served.process.pid, signal.SIGINT)
    code = served.process.wait(5)
    until(lambda: not served.family(), 3)
    assert time.monotonic() - begun < 2
    assert code == 130
    time.sleep(0.05)
    assert "Traceback" not in served.said


@pytest.mark.exhaustive
def test_sigterm_ends_all(running):
    os.kill(running.process.pid, signal.SIGTERM)
    running.process.wait(5)
    until(lambda: not running.family(), 3)


@pytest.mark.exhaustive
@pytest.mark.parametrize("doing", ["a design", "nothing"])
def test_a_server_killed_leaves_no_worker(running, doing):
    """Not even one that calculates."""
    with ExitStack() as stack:
        if doing == "a design":
            search(running, stack.enter_context(running.streaming("design", {}, requirements=LONG)))
        os.kill(running.process.pid, signal.SIGKILL)
        running.process.wait(5)
        until(lambda: not running.family(), 5)


@pytest.mark.exhaustive
def test_a_worker_killed_is_replaced(running):
    others = [pid for pid in running.family() if pid != running.process.pid]
    assert others
    for pid in others:
        os.kill(pid, signal.SIGKILL)
    time.sleep(0.2)
    running.post("live", {"base": 0, "fields": {}, "pinned": None})  # may say that it was ended
    assert running.live({})["fragments"]
    running.tab("accuracy", {})
    assert "html" in running.tab("accuracy", {})[-1]


GREEDY = {
    "points": ("accuracy", {}, {"sweep": "C=0:1:2000000000"}),
    "samples": ("tolerance", {"tolerance.samples": "100000000000"}, {}),
    "duration": ("drive", {"drive.event.duration": "1e9 s"}, {}),
    "balls": ("accuracy", {"control_unit.balls": "1000000000"}, {}),
    "pairs": ("explanation", {"friction_group.pairs": "1000000000000"}, {}),
    "axes": ("design", {}, {"requirements": "[wanted]\nnominal_torque='100 N*m'\n[search]\n" + "x=" + "[" * 5000}),
}


@pytest.mark.exhaustive
@pytest.mark.parametrize(("name", "fields", "options"), GREEDY.values(), ids=list(GREEDY))
def test_what_asks_for_too_much_is_refused(served, name, fields, options):
    """Memory and time of the machine are not the page's to take."""
    before = served.memory()
    with served.streaming(name, fields, **options) as lines:
        begun, answers = time.monotonic(), []
        for answer in lines:
            answers.append(answer)
            assert served.memory() - before < 1 << 30
            if time.monotonic() - begun > 20:
                break
    assert answers
    assert served.live({})["fragments"]


@pytest.mark.exhaustive
def test_the_line_of_the_start(serve, tmp_path):
    served = serve(spec_in(tmp_path).name)
    assert served.said.rstrip().endswith("/")
    assert served.get().status == 200


@pytest.mark.exhaustive
def test_a_port_of_ones_own(tmp_path, serve):
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        run = command_line("serve", spec_in(tmp_path), "--no-browser", "--port", port)
    assert run.returncode in (2, 3)
    assert run.stderr.startswith("error: ")
    assert str(port) in run.stderr
    assert "Traceback" not in run.stderr
    for wrong in ("-1", "65536", "x"):
        run = command_line("serve", tmp_path / "clutch.toml", "--no-browser", "--port", wrong)
        assert run.returncode == 2, wrong
        assert "Traceback" not in run.stderr


@pytest.mark.exhaustive
def test_a_spec_that_is_wrong_or_not_there(tmp_path):
    (tmp_path / "wrong.toml").write_text('variant = "differentiated"\n', encoding="utf-8")
    run = command_line("serve", "gone.toml", "--no-browser", folder=tmp_path)
    assert run.returncode == 3
    assert "gone.toml" in run.stderr
    run = command_line("serve", "wrong.toml", "--no-browser", folder=tmp_path)
    assert run.returncode == 2
    assert "friction" in run.stderr


@pytest.mark.exhaustive
def test_the_options_of_the_command_line_are_taken(serve, tmp_path):
    """What is set there is part of the clutch, of the page and of the command."""
    served = serve(spec_in(tmp_path).name, "--set", "control_unit.gain=0.9", "--lang", "ru", "--units", "si")
    page = served.get().body.decode()
    assert 'lang="ru"' in page
    answer = served.live({"closing_spring.force": "3 kN"})
    assert "control_unit.gain=0.9" in answer["command"]
    expected = json.loads(
        command_line(
            "torque",
            tmp_path / "clutch.toml",
            "--set",
            "control_unit.gain=0.9",
            "--set",
            "closing_spring.force=3 kN",
            "--json",
        ).stdout
    )
    from serving import cells

    assert float(cells(answer["fragments"]["numbers"])["accuracy_factor"]) == expected["result"]["accuracy_factor"]
