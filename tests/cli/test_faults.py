"""Full disks, readers that leave, closed streams, Ctrl-C, folders that are gone: never a traceback."""

import contextlib
import errno
import itertools
import json
import os
import signal
import subprocess
import sys
import textwrap
from unittest.mock import Mock

import pytest
from conftest import CONFIGS, ROOT, slow

SPEC = CONFIGS / "default.toml"
PROGRAM = f"{sys.executable} -m afmcalc"
ENVIRONMENT = {**os.environ, "PYTHONPATH": str(ROOT), "PYTHONWARNINGS": ""}


def shell(line, folder):
    return subprocess.Popen(
        ["bash", "-c", line.replace("afmcalc ", f"{PROGRAM} ")],
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, env=ENVIRONMENT, cwd=folder,
    )  # fmt: skip


STREAMS = """
afmcalc torque {spec} >/dev/full
afmcalc --help | true
afmcalc accuracy {spec} --sweep C=0:1:5000 --format csv | head -1 >/dev/null
afmcalc check {spec} --set fatigue= --strict --set C=2 | true
afmcalc torque {spec} >&-
mkdir gone; cd gone; rmdir ../gone; afmcalc torque {spec} -o x.json
afmcalc torque {spec} -o y.json >&- 2>&-
"""
FULL = "error: standard output: cannot be written: No space left on device"
ENDS = [(3, FULL), (1, ""), (0, ""), (1, ""), (3, "error: standard output: cannot be written: not writable")]
ENDS += [(3, "error: x.json: cannot be written: No such file or directory"), (0, "")]


@pytest.mark.tool
def test_streams_that_are_full_closed_or_left(tmp_path):
    """Exit code, and what is said where anybody listens, of lines of a shell, all at once."""
    lines = [line.format(spec=SPEC) for line in STREAMS.strip().splitlines()]
    running = [shell(f"{line}; exit ${{PIPESTATUS[0]}}", tmp_path) for line in lines]
    ended = [(each.communicate()[1].strip(), each.returncode)[::-1] for each in running]
    assert ended == [(code, said.format(tmp_path)) for code, said in ENDS]
    assert json.loads((tmp_path / "y.json").read_text(encoding="utf-8"))["result"]


AIMED = """
    import os, signal, sys
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a background job would ignore it
    def strike(*ignored): signal.raise_signal(signal.SIGINT)
    {aim}
    sys.argv[0] = "afmcalc"
    from afmcalc.__main__ import program
    program()
"""
ON_IMPORT = """
    class Aim:
        def find_spec(self, name, path=None, target=None):
            if name == "{}": strike()
    sys.meta_path.insert(0, Aim())
"""
MOMENTS = {
    **{name: ON_IMPORT.format(name) for name in ("afmcalc.cli.main", "matplotlib")},
    "before a file is replaced": "replace = os.replace; os.replace = lambda *names: (strike(), replace(*names))",
}  # fmt: skip


@pytest.mark.tool
@pytest.mark.parametrize("moment", MOMENTS)
def test_ctrl_c_at_any_moment(moment, tmp_path):
    target = tmp_path / ("x.svg" if moment == "matplotlib" else "x.json")
    command = ["plot", "torque"] if target.suffix == ".svg" else ["torque"]
    code = textwrap.dedent(AIMED).format(aim=textwrap.dedent(MOMENTS[moment]))
    run = subprocess.run(
        [sys.executable, "-c", code, *command, str(SPEC), "-o", str(target)],
        capture_output=True, text=True, env=ENVIRONMENT, check=False,
    )  # fmt: skip
    assert (run.returncode, run.stderr, os.listdir(tmp_path)) == (130, "", [])


def test_a_fault_of_our_own_is_said_and_never_a_failed_check(afmcalc, monkeypatch):
    def broken(error):
        monkeypatch.setattr("afmcalc.analysis.check.check", Mock(side_effect=error))
        return afmcalc("check", SPEC)

    run = broken(MemoryError)
    assert (run.code, run.out, run.err) == (2, "", "error: not enough memory for what was asked\n")
    run = broken(KeyError("no\x1b[31m such thing"))
    assert (run.code, run.out) == (70, "")
    assert "KeyError: 'no\\x1b[31m such thing'" in run.err
    assert "Traceback" not in run.err
    monkeypatch.setenv("AFMCALC_TRACEBACK", "1")
    assert "Traceback" in afmcalc("check", SPEC).err


WRITE = {"x.toml": ["init", "--force"], "x.json": ["torque", SPEC, "--force", "-o"]}
FAULTS = {"full": 3, "no memory": 2, "Ctrl-C": 130}


def strike(fault):
    if fault == "full":
        raise OSError(errno.ENOSPC, "No space left on device")
    if fault == "no memory":
        raise MemoryError
    signal.raise_signal(signal.SIGINT)


_WRITES = ("mkstemp", "fdopen", "open", "write", "flush", "fsync", "chmod", "replace", "link", "unlink")


@contextlib.contextmanager
def struck(fault, at):
    """A fault as call number ``at`` of those that write begins, from cli/files.py. Counts these calls."""
    count = [0]

    def observe(frame, event, called):
        caller, name = (frame, called.__name__) if event == "c_call" else (frame.f_back, frame.f_code.co_name)
        if event not in ("c_call", "call") or name not in _WRITES:
            return
        if caller is None or not caller.f_code.co_filename.endswith("cli/files.py"):
            return
        count[0] += 1
        if count[0] == at:
            sys.setprofile(None)
            strike(fault)

    sys.setprofile(observe)
    try:
        yield count
    finally:
        sys.setprofile(None)


@pytest.mark.parametrize("old", [b"old", None])
@pytest.mark.parametrize("name", ["x.toml", *slow("x.json")])
@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_at_any_write(name, fault, old, afmcalc, tmp_path, monkeypatch):
    """At every call that writes: old (or nothing) or new, whole, and nothing beside it; the exit code says what it was."""
    target = tmp_path / name
    monkeypatch.setattr("afmcalc.cli.main.drop_output", lambda: None)  # of this process
    command = [*WRITE[name], target]
    assert afmcalc(*command).code == 0
    new = {each: (tmp_path / each).read_bytes() for each in os.listdir(tmp_path)}
    for at in itertools.count(1):
        for each in new:
            (tmp_path / each).write_bytes(old or b"")
            if not old:
                (tmp_path / each).unlink()
        with struck(fault, at) as count:
            run = afmcalc(*command)
        if count[0] < at:
            break
        assert run.code == FAULTS[fault], (at, run.err)
        assert "Traceback" not in run.err
        assert run.err.count("error: ") == (fault != "Ctrl-C"), run.err
        assert fault != "full" or "cannot be written: No space left" in run.err
        left = {each: (tmp_path / each).read_bytes() for each in os.listdir(tmp_path)}
        assert {name for name in new if old} <= left.keys() <= new.keys(), at
        assert all(content in (old, new[each]) for each, content in left.items()), at
    assert at > 3
