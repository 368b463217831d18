"""Files that commands write: none that is read, none that exists unless --force is given, the format of its name."""

import os
import stat
import sys
import threading
from concurrent.futures import ThreadPoolExecutor

import pytest
from conftest import CONFIGS

from afmcalc.cli.files import write_file
from afmcalc.errors import AfmcalcError
from afmcalc.spec import read_spec

SPEC = CONFIGS / "default.toml"
EVENT = [CONFIGS / "drive.toml", "--set", "drive.motor_inertia=0.2", "--set", "drive.event.duration=0.005"]
SMALL = ["--set", "search.gain=[0.5, 0.7]", "--set", "search.pairs=8", "--set", "search.mean_radius=0.1"]
WRITERS = {
    "x": ["torque", SPEC, "-o"],
    "x.json": ["torque", SPEC, "-o"],
    "x.md": ["materials", "-o"],
    "x.svg": ["plot", "accuracy", SPEC, "-o"],
    "x.dxf": ["plot", "pocket", SPEC, "-o"],
    "x.html": ["report", SPEC, "--set", "adjustment.margin=1", "--date", "1", "-o"],
    "history.csv": ["simulate", *EVENT, "--history"],
    "event.toml": ["simulate", *EVENT, "-o"],
    "init.toml": ["init"],
    "spring.json": ["springs", SPEC, "--pick", "1", "-o"],
    "design.toml": ["design", CONFIGS / "requirements.toml", "--pick", "1", *SMALL, "-o"],
    "schema.json": ["schema", "-o"],
}
"""Every way to write a file."""


@pytest.mark.parametrize("name", WRITERS)
def test_a_file_that_exists_is_replaced_by_force_alone(name, undrawn, afmcalc, tmp_path):
    """Whatever wrote it: the same command, another program, or nobody yet (an empty file)."""
    target = tmp_path / name
    for content in (b'{"command": "torque", "mine": true}', b""):
        target.write_bytes(content)
        refused = afmcalc(*WRITERS[name], target)
        assert (refused.code, refused.out) == (2, "")
        assert refused.err.endswith(f"error: {target}: exists already; --force replaces it\n")
        assert target.read_bytes() == content
    assert afmcalc(*WRITERS[name], target, "-f").code == 0
    assert len(target.read_bytes()) > 100
    assert os.listdir(tmp_path) == [name]


PAIRS = {
    "simulate": (["simulate", *EVENT, "--output", "a.toml", "--history", "b.csv"], ["a.toml", "b.csv"]),
    "init": (["init", "a.toml", "--schema"], ["a.toml", "afmcalc.schema.json"]),
    "report": (["report", SPEC, "--pdf", "-o", "a.html"], ["a.html", "a.pdf"]),
}
"""Commands that write two files, and which."""


@pytest.mark.parametrize("case", PAIRS)
def test_of_two_files_neither_is_lost(case, afmcalc, tmp_path, monkeypatch):
    """None is written where one exists; nor where they are one, by name, by a link to nothing, or a hard link."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("AFMCALC_BROWSER", sys.executable)
    arguments, (first, second) = PAIRS[case]

    def refused(said, *given):
        run = afmcalc(*given)
        assert (run.code, run.out) == (2, "")
        assert said in run.err

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
    for number in range(10):
        target, start = tmp_path / f"{number}", threading.Barrier(8)

        def write(content, target=target, start=start):
            start.wait()
            try:
                write_file(str(target), content)
            except AfmcalcError:
                return None
            return content

        with ThreadPoolExecutor(8) as pool:
            (written,) = filter(None, pool.map(write, [bytes([at]) * 9 for at in range(1, 9)]))
        assert target.read_bytes() == written
    assert len(os.listdir(tmp_path)) == 10


def test_a_file_that_appears_meanwhile_is_kept(afmcalc, tmp_path, monkeypatch):
    """Between the first look and the writing somebody else writes it."""
    target = tmp_path / "x.json"
    monkeypatch.setattr(
        "afmcalc.cli.options.Common.read", lambda *given: (target.write_text("mine"), read_spec(SPEC))[1]
    )
    run = afmcalc("torque", SPEC, "-o", target)
    assert (run.code, run.err) == (2, f"error: {target}: exists already; --force replaces it\n")
    assert target.read_text() == "mine"


READERS = {
    "torque": ["{}"],
    "explain": ["torque", "{}"],
    "compare": [SPEC, "{}"],
    "solve": ["accuracy_factor=2", "{}"],
    "plot": ["torque", SPEC, "{}"],
    "synthesize": [SPEC, "--balls", "{}"],
    "report": ["{}"],
}


@pytest.mark.parametrize("command", READERS)
def test_nothing_is_written_over_what_is_read(command, afmcalc, tmp_path):
    """By none of its names; nor is a report printed over it."""
    ending = {"plot": ".svg", "synthesize": ".toml"}.get(command, "")
    target, symbolic, hard = (tmp_path / f"{name}{ending}" for name in ("in", "symbolic", "hard"))
    before = b"diameters = [20]\n" if command == "synthesize" else SPEC.read_bytes()
    target.write_bytes(before)
    symbolic.symlink_to(target)
    os.link(target, hard)
    arguments = [command, *(str(each).format(target) for each in READERS[command])]
    for path in (target, f"{tmp_path}/./in{ending}", symbolic, hard):
        run = afmcalc(*arguments, "-o", path, "--force")
        assert (run.code, run.out) == (2, ""), run.err
        assert "is read itself" in run.err
    assert target.read_bytes() == before


def test_a_report_is_not_printed_over_its_spec(afmcalc, tmp_path, monkeypatch):
    monkeypatch.setenv("AFMCALC_BROWSER", sys.executable)
    spec = tmp_path / "x.pdf"
    spec.write_bytes(SPEC.read_bytes())
    assert afmcalc("report", spec, "-o", tmp_path / "x.html", "--pdf", "--force").code == 2
    assert spec.read_bytes() == SPEC.read_bytes()
    assert os.listdir(tmp_path) == ["x.pdf"]


def test_a_protected_file_is_replaced_by_force_alone(afmcalc, tmp_path):
    target = tmp_path / "x.json"
    target.write_text("mine")
    target.chmod(0o444)
    assert afmcalc("torque", SPEC, "-o", target).code == 2
    assert afmcalc("torque", SPEC, "-o", target, "--force").code == 0
    assert stat.S_IMODE(target.stat().st_mode) == 0o444


def test_what_cannot_be_written_leaves_nothing(afmcalc, tmp_path):
    (tmp_path / "loop").symlink_to("loop")
    for name, code in {"n" * 250: 0, "n" * 260: 3, "loop": 3}.items():
        assert afmcalc("torque", SPEC, "-o", tmp_path / name).code == code
    assert sorted(os.listdir(tmp_path)) == ["loop", "n" * 250]
    assert (tmp_path / "loop").is_symlink()
    assert afmcalc("torque", SPEC, "-o", os.devnull).code == 0


NAMED = {"json": "json", "CSV": "csv", "md": "markdown", "txt": "table", "dat": "table"}
CONTRADICTING = {
    "x.csv": [["torque", "--json"], ["synthesize"]],
    "x.json": [["torque", "--format", "table"], ["plot", "torque"]],
    "x.pdf": [["torque"]],
    "x.toml": [["torque"]],
    "x.md": [["report"], ["design", "example:requirements", "--pick", "1"]],
}


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
