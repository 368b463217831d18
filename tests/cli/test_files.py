"""Files that commands write: none that is read, none that exists unless --force is given, the format of its name."""

import contextlib
import difflib
import os
import shlex
import stat
import threading
import tomllib
from concurrent.futures import ThreadPoolExecutor

import pytest
from conftest import CONFIGS, slow
from sources import DATA

from afmcalc.cli.files import write_file
from afmcalc.errors import AfmcalcError

SPEC = CONFIGS / "default.toml"


FILES = tomllib.loads((DATA / "files.toml").read_text(encoding="utf-8"))


@pytest.mark.parametrize(
    ("name", "line"),
    [*FILES["one"][::4], *slow(*(tuple(each) for each in FILES["one"] if each not in FILES["one"][::4]))],
)
def test_a_file_that_exists_is_replaced_by_force_alone(name, line, undrawn, afmcalc, tmp_path):
    """Whatever wrote it: the same command, another program, or nobody yet (an empty file)."""
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
    """None is written where one exists; nor where they are one, by name, by a link to nothing, or a hard link."""
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

    def write(number):
        for at in range(10):
            start.wait()
            with contextlib.suppress(AfmcalcError):
                write_file(str(tmp_path / f"{at}"), b"%d" % number)
                yield at, b"%d" % number

    with ThreadPoolExecutor(8) as pool:
        written = [each for many in pool.map(lambda number: [*write(number)], range(8)) for each in many]
    assert sorted(written) == [(at, (tmp_path / f"{at}").read_bytes()) for at in range(10)]


@pytest.mark.parametrize("line", FILES["read"])
def test_nothing_is_written_over_what_is_read(line, afmcalc, tmp_path, monkeypatch):
    """By none of its names; nor is a report printed over it."""
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
    if command == "report":
        target.rename(tmp_path / "x.pdf")
        assert afmcalc("report", tmp_path / "x.pdf", "-o", tmp_path / "x.html", "--pdf", "--force").code == 2
        assert (tmp_path / "x.pdf").read_bytes() == before


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
    """Comments, order, units and what was not given stay."""
    monkeypatch.chdir(tmp_path)
    old = (CONFIGS / "drive.toml").read_text(encoding="utf-8").replace("\n[drive]", "\n# bought elsewhere\n[drive]")
    (tmp_path / "old.toml").write_text(old, encoding="utf-8")
    assert afmcalc(*line.format("old.toml").split()).code == 0
    new = (tmp_path / "new.toml").read_text(encoding="utf-8")
    lines = [text for text in difflib.ndiff(old.splitlines(), new.splitlines()) if text[0] in "+-"]
    assert {text[2:].split(" ")[0] for text in lines} == changed
