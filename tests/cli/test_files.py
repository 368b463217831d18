"""Files that commands write: none that is read, none that exists unless --force is given, the format of its name."""

import os
import stat
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor

import pytest
from conftest import CONFIGS, ROOT

from afmcalc.cli.files import write_file
from afmcalc.errors import AfmcalcError
from afmcalc.spec import read_spec

SPEC = CONFIGS / "default.toml"
WISHES = CONFIGS / "requirements.toml"
SMALL = ["--set", "search.gain=[0.5, 0.7]", "--set", "search.pairs=8", "--set", "search.mean_radius=0.1"]

EVENT = [CONFIGS / "drive.toml", "--set", "drive.motor_inertia=0.2", "--set", "drive.event.duration=0.02"]

WRITERS = {
    "table": (["torque", SPEC, "-o"], "x"),
    "json": (["torque", SPEC, "-o"], "x.json"),
    "csv": (["torque", SPEC, "-o"], "x.csv"),
    "markdown": (["materials", "-o"], "x.md"),
    "schema": (["schema", "-o"], "package.json"),
    "svg": (["plot", "accuracy", SPEC, "-o"], "x.svg"),
    "png": (["plot", "accuracy", SPEC, "-o"], "x.png"),
    "paper": (["plot", "paper", "F11-2", "-o"], "x.svg"),
    "dxf": (["plot", "pocket", SPEC, "-o"], "x.dxf"),
    "report": (["report", SPEC, "--set", "adjustment.margin=1", "--date", "1", "-o"], "x.html"),
    "history": (["simulate", *EVENT, "--history"], "x.csv"),
    "event": (["simulate", *EVENT, "-o"], "x.toml"),
    "init": (["init"], "x.toml"),
    "synthesize": (["synthesize", SPEC, "-o"], "x.toml"),
    "spring": (["springs", SPEC, "--pick", "1", "-o"], "x.json"),
    "design": (["design", WISHES, "--pick", "1", *SMALL, "-o"], "x.toml"),
}
"""Every way to write a file."""

RESEMBLING = {
    "json": '{\n  "command": "torque",\n  "mine": true\n}\n',
    "schema": '{\n  "$schema": "https://json.schemastore.org/package",\n  "name": "mine"\n}\n',
    "table": "torque: what the customer said on the telephone\n",
    "csv": "nominal_torque [N*m],machine_torque [N*m]\n",
    "report": '<meta name="generator" content="afmcalc 0.2.0"> edited by hand\n',
    "svg": "<svg>afmcalc plot, with my notes</svg>\n",
}
"""Files that begin as what the command writes, and are the user's."""


@pytest.mark.every(2)
@pytest.mark.parametrize("case", WRITERS)
def test_a_file_that_exists_is_replaced_by_force_alone(case, undrawn, afmcalc, tmp_path):
    """Whatever wrote it: the same command, another program, or nobody yet (an empty file)."""
    arguments, name = WRITERS[case]
    target = tmp_path / name
    assert afmcalc(*arguments, target).code == 0
    written = target.read_bytes()
    for content in (written, RESEMBLING.get(case, "mine").encode(), b""):
        target.write_bytes(content)
        refused = afmcalc(*arguments, target)
        assert (refused.code, refused.out) == (2, "")
        assert refused.err.endswith(f"error: {target}: exists already; --force replaces it\n")
        assert target.read_bytes() == content
    assert afmcalc(*arguments, target, "-f").code == 0
    assert target.read_bytes() == written
    assert os.listdir(tmp_path) == [name]


PAIRS = {
    "simulate": (["simulate", *EVENT, "--output", "a.toml", "--history", "b.csv"], ["a.toml", "b.csv"]),
    "init": (["init", "a.toml", "--schema"], ["a.toml", "afmcalc.schema.json"]),
    "report": (["report", SPEC, "--pdf", "-o", "a.html"], ["a.html", "a.pdf"]),
}
"""Commands that write two files, and which."""


@pytest.mark.parametrize("case", PAIRS)
def test_of_two_files_none_is_written_where_one_exists(case, afmcalc, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("AFMCALC_BROWSER", sys.executable)
    arguments, names = PAIRS[case]
    for name in names:
        (tmp_path / name).write_text("mine")
        run = afmcalc(*arguments)
        assert (run.code, run.out) == (2, "")
        assert run.err.endswith(f"error: {name}: exists already; --force replaces it\n")
        assert os.listdir(tmp_path) == [name]
        assert (tmp_path / name).read_text() == "mine"
        (tmp_path / name).unlink()


@pytest.mark.parametrize("case", PAIRS)
def test_two_outputs_are_not_one_file(case, afmcalc, tmp_path, monkeypatch):
    """Neither by one name, nor by a link to what is not yet there, nor by a hard link that ``--force`` would replace."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("AFMCALC_BROWSER", sys.executable)
    arguments, (first, second) = PAIRS[case]

    def refused(*given):
        run = afmcalc(*given)
        assert (run.code, run.out) == (2, "")
        assert "are one file: name two" in run.err

    if case in ("simulate", "plot"):
        refused(*(first if each == second else each for each in arguments))
    os.symlink(first, second)
    refused(*arguments)
    assert os.listdir(tmp_path) == [second]
    os.unlink(second)
    (tmp_path / first).write_text("mine")
    os.link(first, second)
    refused(*arguments, "--force")
    assert (tmp_path / second).read_text() == "mine"


def test_of_many_threads_that_write_one_file_one_does(tmp_path):
    for number in range(30):
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
    assert len(os.listdir(tmp_path)) == 30


@pytest.mark.exhaustive
def test_of_many_programs_that_write_one_file_one_does(tmp_path):
    """Eight programs at once: one creates the file, the others say that it exists."""
    target = tmp_path / "clutch.toml"
    variants = ["indirect", "conventional"] * 4
    running = [
        subprocess.Popen(
            [sys.executable, "-m", "afmcalc", "init", str(target), "--variant", variant],
            stderr=subprocess.PIPE, text=True, env={**os.environ, "PYTHONPATH": str(ROOT)},
        )
        for variant in variants
    ]  # fmt: skip
    said = [each.communicate()[1] for each in running]
    codes = [each.returncode for each in running]
    assert sorted(codes) == [0] + [2] * 7
    winner = variants[codes.index(0)]
    assert f'variant = "{winner}"' in target.read_text(encoding="utf-8")
    assert said.count(f"error: {target}: exists already; --force replaces it\n") == 7
    assert os.listdir(tmp_path) == [target.name]


def test_a_file_that_appears_meanwhile_is_kept(afmcalc, tmp_path, monkeypatch):
    """Between the first look and the writing somebody else writes it."""
    target = tmp_path / "x.json"
    monkeypatch.setattr(
        "afmcalc.cli.options.Common.read", lambda *given: (target.write_text("mine"), read_spec(SPEC))[1]
    )
    run = afmcalc("torque", SPEC, "-o", target)
    assert (run.code, run.err) == (2, f"error: {target}: exists already; --force replaces it\n")
    assert target.read_text() == "mine"


def links(folder, target):
    """Other names of a file."""
    (folder / "symbolic").symlink_to(target)
    os.link(target, folder / "hard")
    return [target, f"{folder}/./{target.name}", folder / "symbolic", folder / "hard"]


READERS = {
    "torque": ["torque", "{}"],
    "explain": ["explain", "torque", "{}"],
    "compare": ["compare", "{}", SPEC],
    "compare, second": ["compare", SPEC, "{}"],
    "solve": ["solve", "accuracy_factor=2", "{}"],
    "plot": ["plot", "torque", SPEC, "{}"],
    "synthesize": ["synthesize", SPEC, "--balls", "{}"],
    "report": ["report", "{}"],
    "check": ["check", "{}"],
}


@pytest.mark.parametrize("case", READERS)
def test_nothing_is_written_over_what_is_read(case, afmcalc, tmp_path):
    name = {"plot": "in.svg", "synthesize": "in.toml"}.get(case, "in")
    target = tmp_path / name
    target.write_bytes(b"diameters = [20]\n" if case == "synthesize" else SPEC.read_bytes())
    before = target.read_bytes()
    for path in links(tmp_path, target):
        output = path if case != "plot" or str(path).endswith("svg") else target
        run = afmcalc(*(str(each).format(path) for each in READERS[case]), "-o", output, "--force")
        assert (run.code, run.out) == (2, ""), run.err
        assert "is read itself" in run.err
    assert target.read_bytes() == before


def test_a_report_is_not_printed_over_its_spec(afmcalc, tmp_path, monkeypatch):
    monkeypatch.setenv("AFMCALC_BROWSER", sys.executable)
    spec = tmp_path / "x.pdf"
    spec.write_bytes(SPEC.read_bytes())
    run = afmcalc("report", spec, "-o", tmp_path / "x.html", "--pdf", "--force")
    assert run.code == 2
    assert spec.read_bytes() == SPEC.read_bytes()
    assert not (tmp_path / "x.html").exists()


def test_a_protected_file_is_replaced_by_force_alone(afmcalc, tmp_path):
    target = tmp_path / "x.json"
    assert afmcalc("torque", SPEC, "-o", target).code == 0
    target.chmod(0o444)
    assert afmcalc("torque", SPEC, "-o", target).code == 2
    assert afmcalc("torque", SPEC, "-o", target, "--force").code == 0
    assert stat.S_IMODE(target.stat().st_mode) == 0o444


@pytest.mark.parametrize("name", ["loop", "n" * 250, "n" * 260])
def test_what_cannot_be_written_leaves_nothing(name, afmcalc, tmp_path):
    (tmp_path / "loop").symlink_to("loop")
    run = afmcalc("torque", SPEC, "-o", tmp_path / name)
    assert run.code == (0 if len(name) == 250 else 3)
    assert [left for left in os.listdir(tmp_path) if left.startswith(".")] == []
    assert (tmp_path / "loop").is_symlink()


def test_a_device_is_written_to(afmcalc):
    assert afmcalc("torque", SPEC, "-o", os.devnull).code == 0


@pytest.mark.parametrize(
    ("ending", "format_"), [("json", "json"), ("CSV", "csv"), ("md", "markdown"), ("txt", "table"), ("dat", "table")]
)
def test_the_name_says_the_format(ending, format_, afmcalc, tmp_path):
    target = tmp_path / f"x.{ending}"
    assert afmcalc("torque", SPEC, "-o", target).code == 0
    assert target.read_text(encoding="utf-8") == afmcalc("torque", SPEC, "--format", format_).out


@pytest.mark.parametrize(
    ("arguments", "name", "said"),
    [
        (["torque", "--json"], "x.csv", "format csv, not json"),
        (["torque", "--format", "table"], "x.json", "format json, not table"),
        (["torque"], "x.pdf", "report writes"),
        (["torque"], "x.toml", ".json"),
        (["report"], "x.md", "is HTML or PDF"),
        (["synthesize"], "x.csv", ".toml or .json"),
        (["design", WISHES, "--pick", "1"], "x.md", ".toml or .json"),
        (["plot", "torque"], "x.json", ".svg"),
    ],
)
def test_a_name_that_contradicts_is_refused(arguments, name, said, afmcalc, tmp_path):
    run = afmcalc(*arguments, "-o", tmp_path / name)
    assert (run.code, run.out) == (2, "")
    assert said in run.err
    assert not any(tmp_path.iterdir())
