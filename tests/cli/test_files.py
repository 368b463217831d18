"""Files that commands write: none that is read, none that people or other programs wrote, the format of its name."""

import os
import stat
import sys

import pytest
from conftest import CONFIGS

SPEC = CONFIGS / "default.toml"
WISHES = CONFIGS / "requirements.toml"
FEW = ["--set", "search.gain=[0.5, 0.7]", "--set", "search.pairs=8", "--set", "search.mean_radius=0.1"]

WRITERS = {
    "table": (["torque", SPEC], "x"),
    "text": (["torque", SPEC], "x.txt"),
    "json": (["torque", SPEC], "x.json"),
    "csv": (["torque", SPEC], "x.csv"),
    "markdown": (["torque", SPEC], "x.md"),
    "no spec": (["materials"], "x.json"),
    "schema": (["schema"], "x.json"),
    "svg": (["plot", "accuracy", SPEC], "x.svg"),
    "png": (["plot", "accuracy", SPEC], "x.png"),
    "pdf": (["plot", "accuracy", SPEC], "x.pdf"),
    "report": (["report", SPEC, "--set", "adjustment.margin=1"], "x.html"),
}
"""Commands whose file may be replaced by the same command."""

SPECS = {
    "init": (["init"], "x.toml"),
    "synthesize": (["synthesize", SPEC], "x.toml"),
    "synthesize json": (["synthesize", SPEC], "x.json"),
    "design": (["design", WISHES, "--pick", "1", *FEW], "x.toml"),
    "design json": (["design", WISHES, "--pick", "1", *FEW], "x.json"),
}
"""Commands whose file is a spec, which people edit."""


AGAIN = {"text", "png", "pdf", "synthesize json", "design json"}
"""Written and known again by the same code as another one here."""


@pytest.mark.parametrize(
    "case",
    [pytest.param(each, marks=pytest.mark.exhaustive if each in AGAIN else []) for each in (*WRITERS, *SPECS)],
)
def test_only_what_the_same_command_wrote_is_replaced(case, undrawn, afmcalc, tmp_path):
    arguments, name = (WRITERS | SPECS)[case]
    target = tmp_path / name
    assert afmcalc(*arguments, "-o", target).code == 0
    written = target.read_bytes()
    again = afmcalc(*arguments, "-o", target)
    assert again.code == (0 if case in WRITERS else 2)
    assert target.read_bytes() == written
    target.write_text("mine, about torque and afmcalc\n")
    refused = afmcalc(*arguments, "-o", target)
    assert (refused.code, refused.out) == (2, "")
    assert f"{target}: exists already" in refused.err
    assert "--force" in refused.err
    assert target.read_text() == "mine, about torque and afmcalc\n"
    assert afmcalc(*arguments, "-o", target, "--force").code == 0
    assert target.read_bytes() == written
    assert os.listdir(tmp_path) == [name]


def test_an_empty_file_is_nothing_to_lose(afmcalc, tmp_path):
    target = tmp_path / "new.toml"
    target.touch()
    assert afmcalc("init", target).code == 0


def test_another_command_or_format_is_another_kind(afmcalc, tmp_path):
    for name in ("x", "x.json", "x.csv", "x.md"):
        target = tmp_path / name
        assert afmcalc("torque", SPEC, "-o", target).code == 0
        written = target.read_bytes()
        assert afmcalc("accuracy", SPEC, "-o", target).code == 2
        assert afmcalc("plot", "torque", SPEC, "-o", target).code == 2
        assert target.read_bytes() == written


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
    run = afmcalc("torque", SPEC, "-o", target)
    assert run.code == 2
    assert "write-protected" in run.err
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
        (["report"], "x.pdf", "--pdf"),
        (["report"], "x.md", "is HTML"),
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
