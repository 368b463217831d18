"""Files that commands write, none that is read or exists; full disks, readers that leave, Ctrl-C: never a traceback."""

import contextlib
import difflib
import errno
import itertools
import json
import os
import re
import shlex
import signal
import stat
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor
from unittest.mock import Mock

import pytest
from conftest import CONFIGS, ROOT, slow
from sources import REFUSED, table

from afmcalc.cli.files import write
from afmcalc.errors import AfmcalcError
from afmcalc.spec import read_spec
from afmcalc.spec.edit import respecified, saved
from afmcalc.spec.write import value_as_written

SPEC, FILES = CONFIGS / "default.toml", table("files")


@pytest.mark.parametrize(
    ("name", "line"),
    [*FILES["one"][::4], *slow(*(tuple(each) for each in FILES["one"] if each not in FILES["one"][::4]))],
)
def test_a_file_that_exists_is_replaced_by_force_alone(name, line, undrawn, afmcalc, tmp_path):
    """This holds for a file with content and for an empty one."""
    target = tmp_path / name
    for content in (b'{"command": "torque", "mine": true}', b""):
        target.write_bytes(content)
        refused = afmcalc(*shlex.split(line), target)
        assert (refused.code, refused.out) == (2, "")
        assert refused.err.endswith(f"error: {target}: exists already; --force replaces it\n")
        assert target.read_bytes() == content
    assert afmcalc(*shlex.split(line), target, "-f").code == 0
    assert len(target.read_bytes()) > 100
    assert os.listdir(tmp_path) == [name]


@pytest.mark.parametrize(("line", "names"), FILES["two"])
def test_of_two_files_neither_is_lost(line, names, afmcalc, tmp_path, monkeypatch):
    """Neither is written if one exists, or if both are one file by name, by a link to nothing, or by a hard link."""
    monkeypatch.chdir(tmp_path)
    arguments, (first, second) = shlex.split(line), names

    def refused(said, *given):
        run = afmcalc(*given)
        assert (run.code, run.out, said in run.err) == (2, "", True)

    for name in (first, second):
        (tmp_path / name).write_text("mine")
        refused(f"error: {name}: exists already; --force replaces it\n", *arguments)
        assert os.listdir(tmp_path) == [name]
        assert (tmp_path / name).read_text() == "mine"
        (tmp_path / name).unlink()
    if second in arguments:
        refused("are one file: name two", *(first if each == second else each for each in arguments))
    os.symlink(first, second)
    refused("are one file: name two", *arguments)
    assert os.listdir(tmp_path) == [second]
    os.unlink(second)
    (tmp_path / first).write_text("mine")
    os.link(first, second)
    refused("are one file: name two", *arguments, "--force")
    assert (tmp_path / second).read_text() == "mine"


def test_of_many_threads_that_write_one_file_one_does(tmp_path):
    start = threading.Barrier(8)

    def rival(number):
        for at in range(10):
            start.wait()
            with contextlib.suppress(AfmcalcError):
                write(b"%d" % number, str(tmp_path / f"{at}"))
                yield at, b"%d" % number

    with ThreadPoolExecutor(8) as pool:
        written = [each for many in pool.map(lambda number: [*rival(number)], range(8)) for each in many]
    assert sorted(written) == [(at, (tmp_path / f"{at}").read_bytes()) for at in range(10)]


@pytest.mark.parametrize("line", FILES["read"])
def test_nothing_is_written_over_what_is_read(line, afmcalc, tmp_path, monkeypatch):
    """An input is not overwritten by any of its names (path, symbolic link, hard link), nor by a report."""
    command = line.partition(" ")[0]
    ending = {"plot": ".svg", "pocket": ".dxf"}.get(command, "")
    target, symbolic, hard = (tmp_path / f"{name}{ending}" for name in ("in", "symbolic", "hard"))
    before = SPEC.read_bytes()
    target.write_bytes(before)
    symbolic.symlink_to(target)
    os.link(target, hard)
    arguments = line.format(target).split()
    for path in (target, f"{tmp_path}/./in{ending}", symbolic, hard):
        run = afmcalc(*arguments, "-o", path, "--force")
        assert (run.code, run.out) == (2, ""), run.err
        assert "is read itself" in run.err
    assert target.read_bytes() == before


def test_a_protected_file_is_replaced_by_force_alone(afmcalc, tmp_path):
    target = tmp_path / "x.json"
    target.write_text("mine")
    target.chmod(0o444)
    assert afmcalc("torque", SPEC, "-o", target).code == 2
    assert afmcalc("torque", SPEC, "-o", target, "--force").code == 0
    assert stat.S_IMODE(target.stat().st_mode) == 0o444


def test_what_cannot_be_written_leaves_nothing(afmcalc, tmp_path):
    (tmp_path / "loop").symlink_to("loop")
    for name, code in {"n" * 250: 0, "n" * 260: 3, "loop": 3, "no/such/folder": 3}.items():
        assert afmcalc("torque", SPEC, "-o", tmp_path / name).code == code
    assert sorted(os.listdir(tmp_path)) == ["loop", "n" * 250]
    assert (tmp_path / "loop").is_symlink()
    assert afmcalc("torque", SPEC, "-o", os.devnull).code == 0
    assert afmcalc("torque", tmp_path / "none.toml").code == 3


NAMED = {"json": "json", "CSV": "csv", "md": "markdown", "txt": "table", "dat": "table"}
CONTRADICTING = {
    "x.csv": [["torque", "--json"]], "x.json": [["torque", "--format", "table"], ["plot", "torque"]],
    "x.pdf": [["torque"]], "x.toml": [["torque"]], "x.md": [["report"]],
}  # fmt: skip


def test_the_name_says_the_format(afmcalc, answered, tmp_path):
    for ending, format_ in NAMED.items():
        target = tmp_path / f"x.{ending}"
        assert afmcalc("torque", SPEC, "-o", target).code == 0
        assert target.read_text(encoding="utf-8") == answered("torque", SPEC, "--format", format_).out
        target.unlink()
    for name, given in CONTRADICTING.items():
        for arguments in given:
            run = afmcalc(*arguments, "-o", tmp_path / name)
            assert (run.code, run.out) == (2, "")
            assert f"--output {tmp_path / name}" in run.err
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize(("line", "changed"), [
    ("solve accuracy_factor=1.9 {} --for C --save new.toml", {"gain"}),
    ("pocket {} --save new.toml", {"gain", "wall_angle", "ball_diameter"}),
    ("simulate {} --set drive.event.duration=0.005 --save new.toml", {"dynamic_factor", "duration"}),
])  # fmt: skip
def test_a_spec_that_is_saved_differs_in_the_changed_lines_alone(line, changed, afmcalc, tmp_path, monkeypatch):
    """Comments, order and units stay, and keys that were not given stay absent."""
    monkeypatch.chdir(tmp_path)
    old = (CONFIGS / "drive.toml").read_text(encoding="utf-8").replace("\n[drive]", "\n# bought elsewhere\n[drive]")
    (tmp_path / "old.toml").write_text(old, encoding="utf-8")
    assert afmcalc(*line.format("old.toml").split()).code == 0
    new = (tmp_path / "new.toml").read_text(encoding="utf-8")
    lines = [text for text in difflib.ndiff(old.splitlines(), new.splitlines()) if text[0] in "+-"]
    assert {text[2:].split(" ")[0] for text in lines} == changed


MADE = """\
variant = "differentiated"
[friction]
material = "moulded-dry" # ours
[friction_group]
pairs = 8
mean_radius = "100 mm"

[closing_spring]
force = "2 kN"

# balls
# and pockets
[control_unit]
gain = 0.5

"""


@pytest.mark.parametrize("newline", ["\n", "\r\n"])
@pytest.mark.parametrize(("changes", "lines"), [
    ({"closing_spring.room.length": 0.1}, "+ [closing_spring.room]|+ length = \"100 mm\"|+ "),
    ({"closing_spring.stiffness": 2e4}, "+ stiffness = \"20 N/mm\""),
    ({"friction.min": 0.2}, "- material = \"moulded-dry\" # ours|+ min = 0.2|+ max = 0.45"),
])  # fmt: skip
def test_what_is_put_into_a_file_stands_below_the_table_it_is_of(changes, lines, newline, tmp_path):
    (tmp_path / "old.toml").write_bytes(MADE.replace("\n", newline).encode())
    spec = read_spec(tmp_path / "old.toml")
    new = saved(spec, changes, respecified(spec, changes), tmp_path / "new.toml")
    assert new.count(newline) == new.count("\n")
    told = [text for text in difflib.ndiff(MADE.split("\n"), new.split(newline)) if text[0] in "+-"]
    assert told == lines.split("|")
    assert f"{newline}{newline}# balls{newline}# and pockets{newline}[control_unit]" in new


def test_a_pipe_and_standard_output_are_written_as_they_are(afmcalc, tmp_path):
    """No file is moved into their place, so a file that a shell has opened for the output is not lost."""
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    with ThreadPoolExecutor() as reader:
        read = reader.submit(pipe.read_text, "utf-8")
        assert afmcalc("torque", "--json", "-o", str(pipe)).code == 0
        assert json.loads(read.result(10))["command"] == "torque"
    assert json.loads(afmcalc("torque", "--json", "-o", "/dev/stdout").out)["command"] == "torque"
    with (tmp_path / "log").open("a+", encoding="utf-8") as log:
        print("mine", file=log, flush=True)
        assert afmcalc("torque", "-o", f"/dev/fd/{log.fileno()}", "--force").code == 0
        log.seek(0)
        assert re.match("mine\n.*torque: ", log.read(), re.DOTALL)


@pytest.mark.parametrize("line", FILES["late"])
def test_what_is_refused_is_refused_before_anything_is_calculated(line, afmcalc, monkeypatch):
    for long in ("design._Judge.front", "dossier.dossier", "simulate.simulate", "tolerance_study.tolerance"):
        monkeypatch.setattr(f"afmcalc.analysis.{long}", Mock(side_effect=AssertionError))
    run = afmcalc(*shlex.split(line))
    assert (run.code in (2, 3), run.out) == (True, ""), run.err


def test_what_no_list_or_length_can_be_is_refused(afmcalc, tmp_path):
    """A cell too long for CSV is refused; a length too large for millimetres is written in metres."""
    (tmp_path / "own.csv").write_text(f"name,description,condition,source\na,{'x' * 140_000},dry,s\n", encoding="utf-8")
    assert "is no CSV" in afmcalc("torque", "--set", f"catalogues.materials={tmp_path}/own.csv").err
    assert value_as_written(1e306, "m") == "1e+306 m"


PROGRAM = f"{sys.executable} -m afmcalc"
ENVIRONMENT = {**os.environ, "PYTHONPATH": str(ROOT), "PYTHONWARNINGS": ""}


def shell(line, folder):
    return subprocess.Popen(
        ["bash", "-c", line.replace("afmcalc ", f"{PROGRAM} ")],
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, env=ENVIRONMENT, cwd=folder,
    )  # fmt: skip


@pytest.mark.tool
def test_streams_that_are_full_closed_or_left(tmp_path):
    """Exit codes and messages of command lines, which are run in a shell all at once."""
    lines, codes, said = zip(*REFUSED["streams"], strict=True)
    lines = [line.format(spec=SPEC) for line in lines]
    running = [shell(f"{line}; exit ${{PIPESTATUS[0]}}", tmp_path) for line in lines]
    ended = [(each.communicate()[1].strip(), each.returncode)[::-1] for each in running]
    assert ended == [*zip(codes, said, strict=True)]
    assert json.loads((tmp_path / "y.json").read_text(encoding="utf-8"))["result"]


PROGRAMS = table("programs")
MOMENTS = {
    **{name: PROGRAMS["on_import"].format(name) for name in ("afmcalc.cli.main", "matplotlib")},
    "before a file is put in its place": "link = os.link; os.link = lambda *names: (strike(), link(*names))",
}  # fmt: skip


@pytest.mark.tool
@pytest.mark.parametrize("moment", MOMENTS)
def test_ctrl_c_at_any_moment(moment, tmp_path):
    target = tmp_path / ("x.svg" if moment == "matplotlib" else "x.json")
    command = ["plot", "torque"] if target.suffix == ".svg" else ["torque"]
    code = PROGRAMS["aimed"].format(aim=MOMENTS[moment])
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
    """Raise a fault at call number ``at`` of the writing functions in cli/files.py; yield a counter of these calls."""
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
    """After a fault at any writing call there is the old file (or none) or the whole new one, and no other file."""
    target = tmp_path / name
    monkeypatch.setattr("afmcalc.cli.main.drop_output", lambda: None)  # the output of pytest must stay
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
