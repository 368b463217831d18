"""Full disks, readers that leave, closed streams, Ctrl-C, folders that are gone, browsers that fail: never a traceback."""

import contextlib
import errno
import itertools
import json
import os
import resource
import signal
import subprocess
import sys
import textwrap

import pytest
from conftest import CONFIGS, ROOT

from afmcalc.cli import signals
from afmcalc.errors import AfmcalcError
from afmcalc.render.report.sheets import print_pdf

SPEC = CONFIGS / "default.toml"
PROGRAM = f"{sys.executable} -m afmcalc"
ENVIRONMENT = {**os.environ, "PYTHONPATH": str(ROOT), "PYTHONWARNINGS": ""}


def shell(command, **environment):
    return subprocess.run(
        ["bash", "-c", command.replace("afmcalc ", f"{PROGRAM} ")],
        capture_output=True, text=True, env={**ENVIRONMENT, **environment}, check=False,
    )  # fmt: skip


WRITERS = {
    "x.json": ["torque", SPEC, "--format", "json"],
    "x.toml": ["init"],
    "y.toml": ["synthesize", SPEC],
    "x.svg": ["plot", "accuracy", SPEC],
}


@pytest.mark.every(2)
@pytest.mark.parametrize("name", WRITERS)
def test_a_full_disk_leaves_nothing_behind(name, afmcalc, tmp_path, monkeypatch):
    monkeypatch.setattr(sys, "dont_write_bytecode", True)  # Python keeps bytecode that it could not write whole
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, hard))
    try:
        run = afmcalc(*WRITERS[name], "-o", tmp_path / name)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert run.code == 3
    assert f"error: {tmp_path / name}: cannot be written: File too large" in run.err
    assert not os.listdir(tmp_path)


def test_a_full_device_is_said():
    run = shell(f"afmcalc torque {SPEC} >/dev/full")
    assert (run.returncode, run.stderr) == (3, "error: standard output: cannot be written: No space left on device\n")


LEFT = [
    "afmcalc --help | true",
    "afmcalc schema | true",
    f"afmcalc accuracy {SPEC} --sweep C=0:1:5000 --format csv | head -1 >/dev/null",
]


def test_a_reader_that_leaves_early_is_nothing_to_speak_of():
    each = "; ".join(f"({command}; echo ${{PIPESTATUS[0]}} >&3) & wait $!" for command in LEFT)
    run = shell(f"exec 3>&1; {each}")
    assert (run.stdout.split(), run.stderr) == (["0"] * len(LEFT), "")


def test_a_check_that_fails_does_so_whoever_reads():
    run = shell(f"afmcalc check {SPEC} --set fatigue= --strict --set C=2 | true; exit ${{PIPESTATUS[0]}}")
    assert run.returncode == 1


def test_closed_streams(tmp_path):
    target = tmp_path / "x.json"
    closed = shell(f"afmcalc torque {SPEC} >&-")
    assert (closed.returncode, closed.stderr) == (3, "error: standard output: cannot be written: it is closed\n")
    assert shell(f"afmcalc torque {SPEC} -o {target} >&-").returncode == 0
    assert target.read_text().startswith("{")
    for silent in ("2>&-", "2>/dev/full", "2> >(true)"):
        run = shell(f"afmcalc torque {silent}")
        assert (run.returncode, run.stdout[:6]) == (0, "torque")


def test_a_deleted_working_directory_is_named(tmp_path):
    run = shell(f"mkdir {tmp_path}/gone; cd {tmp_path}/gone; rmdir ../gone; afmcalc torque {SPEC} -o x.json")
    assert run.returncode == 3
    assert (
        run.stderr
        == f"error: x.json: cannot be written: the working directory {tmp_path}/gone does not exist any more\n"
    )


AIMED = """
    import atexit, os, signal, sys
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
    **{name: ON_IMPORT.format(name) for name in ("afmcalc.cli.main", "typer", "pydantic", "afmcalc.engines.selection", "numpy", "matplotlib")},
    "before a file is replaced": "replace = os.replace; os.replace = lambda *names: (strike(), replace(*names))",
    "after a file is replaced": "replace = os.replace; os.replace = lambda *names: (replace(*names), strike())",
    "while a destructor runs": f"{textwrap.dedent(ON_IMPORT).format('pydantic').replace('strike()', 'kept.clear()')}"
    "class Lost: __del__ = strike\nkept = [Lost()]",
    "at the end": "atexit.register(strike)",
}  # fmt: skip


@pytest.mark.every(2)
@pytest.mark.parametrize("moment", MOMENTS)
def test_ctrl_c_at_any_moment(moment, tmp_path):
    target = tmp_path / ("x.svg" if moment in ("numpy", "matplotlib") else "x.json")
    command = ["plot", "torque"] if target.suffix == ".svg" else ["torque"]
    code = textwrap.dedent(AIMED).format(aim=textwrap.dedent(MOMENTS[moment]))
    run = subprocess.run(
        [sys.executable, "-c", code, *command, str(SPEC), "-o", str(target)],
        capture_output=True, text=True, env=ENVIRONMENT, check=False,
    )  # fmt: skip
    assert run.returncode == (0 if moment == "at the end" else 130)
    written = moment in ("before a file is replaced", "after a file is replaced", "at the end")
    assert run.stderr == (f"note: wrote {target}\n" if written and run.returncode else "")
    assert os.listdir(tmp_path) == (["x.json"] if written else [])
    assert not written or json.loads(target.read_text())["result"]


BROWSERS = {
    "fails": 'printf "%%PDF-1.4 %%%%EOF" >"$file"; exit 1',
    "stops early": 'printf "%%PDF-1.4 ..." >"$file"',
    "prints something else": 'echo "<html>" >"$file"',
    "prints nothing": "true",
}


@pytest.mark.parametrize("case", BROWSERS)
def test_a_pdf_is_whole_or_none(case, tmp_path, undrawn, afmcalc, monkeypatch):
    browser = tmp_path / "browser"
    browser.write_text(
        f"#!/bin/bash\nfor each; do case $each in --print-to-pdf=*) file=${{each#*=}};; esac; done\n{BROWSERS[case]}\n"
    )
    browser.chmod(0o755)
    with pytest.raises(AfmcalcError, match="did not print a whole PDF"):
        print_pdf(str(browser), "<html></html>")
    monkeypatch.setenv("AFMCALC_BROWSER", str(browser))
    if case == "fails":
        run = afmcalc("report", SPEC, "--pdf", "-o", tmp_path / "x.html")
        assert run.code == 2
        assert os.listdir(tmp_path) == ["browser"]


def test_a_fault_of_our_own_is_said_and_never_a_failed_check(afmcalc, monkeypatch):
    def broken(*arguments, **options):
        raise KeyError("no\x1b[31m such thing")

    monkeypatch.setattr("afmcalc.analysis.check.check", broken)
    run = afmcalc("check", SPEC)
    assert (run.code, run.out) == (70, "")
    assert "fault of afmcalc" in run.err
    assert "please report it" in run.err
    assert "KeyError: 'no\\x1b[31m such thing'" in run.err
    assert "Traceback" not in run.err
    monkeypatch.setenv("AFMCALC_TRACEBACK", "1")
    assert "Traceback" in afmcalc("check", SPEC).err


WRITE = {
    "x.json": ["torque", SPEC, "--force", "-o"],
    "x.toml": ["init", "--force", "-o"],
    "y.toml": ["synthesize", SPEC, "--force", "-o"],
    "x.svg": ["plot", "torque", SPEC, "--force", "-o"],
}
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


@pytest.fixture
def signals_watched():
    before = {number: signal.getsignal(number) for number in signals._SIGNALS}
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a background job would ignore it
    hook = sys.unraisablehook
    signals.watch()
    yield
    sys.unraisablehook = hook
    for number, handler in before.items():
        signal.signal(number, handler)


@pytest.mark.every(5)
@pytest.mark.parametrize("name", WRITE)
@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_at_any_write(name, fault, afmcalc, tmp_path, signals_watched, monkeypatch):
    """At every call that writes: old or new, whole, and nothing beside it; the exit code says what it was."""
    target = tmp_path / name
    monkeypatch.setattr("afmcalc.cli.main.drop_output", lambda: None)  # of this process
    command = [*WRITE[name], target]
    assert afmcalc(*command).code == 0
    new = {each: (tmp_path / each).read_bytes() for each in os.listdir(tmp_path)}
    for at in itertools.count(1):
        for each in new:
            (tmp_path / each).write_bytes(b"old")
        signals.unreported.clear()
        with struck(fault, at) as count:
            run = afmcalc(*command)
        if count[0] < at:
            break
        assert run.code == FAULTS[fault], (at, run.err)
        assert "Traceback" not in run.err
        assert run.err.count("error: ") == (fault != "Ctrl-C"), run.err
        left = {each: (tmp_path / each).read_bytes() for each in os.listdir(tmp_path)}
        assert left.keys() == new.keys(), at
        assert all(content in (b"old", new[each]) for each, content in left.items()), at
    assert at > 3


def test_memory_that_does_not_suffice_is_said(afmcalc, monkeypatch):
    def greedy(*arguments, **options):
        raise MemoryError

    monkeypatch.setattr("afmcalc.analysis.torque.torque", greedy)
    run = afmcalc("torque", SPEC)
    assert (run.code, run.out, run.err) == (2, "", "error: not enough memory for what was asked\n")
