"""The outputs that the README shows are what the program prints."""

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tomllib
from itertools import groupby

import pytest
from conftest import ROOT
from sources import table

README = (ROOT / "README.md").read_text(encoding="utf-8")


@pytest.mark.slow
def test_the_worked_example(searched_once, afmcalc, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (example,) = re.findall(r"```console\n(.*?)```", README, re.DOTALL)
    for block in re.split(r"^\$ ", example, flags=re.MULTILINE)[1:]:
        command, _, printed = block.partition("\n")
        run = afmcalc(*command.split()[1:])
        assert run.code == 0
        assert (run.err + run.out).rstrip("\n") == printed.rstrip("\n")


def test_the_spec_and_every_command_are_there(afmcalc, tmp_path):
    from afmcalc.cli.main import COMMANDS

    spec, *_ = re.findall(r"```toml\n(.*?)```", README, re.DOTALL)
    assert afmcalc("torque", "-", stdin=spec).code == 0
    assert set(COMMANDS) <= set(re.findall(r"`afmcalc ([\w-]+)[ `]", README))


@pytest.mark.slow
def test_line_by_line_in_an_empty_folder(searched_once, undrawn, afmcalc, tmp_path, monkeypatch):
    """The first commands of the README in their order, then its Python, with only the installed package."""
    monkeypatch.chdir(tmp_path)
    lines = [line for block in re.findall(r"```sh\n(.*?)```", README, re.DOTALL) for line in block.splitlines()]
    ours = [line.split("&& ")[-1] for line in lines if re.match("(pip.*&& )?afmcalc ", line)]
    assert len(ours) > 5
    for line in ["afmcalc init clutch.toml", *ours]:  # what the example above them wrote
        words, piped = shlex.split(line, comments=True), ""
        for program, *arguments in (list(each) for bar, each in groupby(words, lambda word: word == "|") if not bar):
            assert program == "afmcalc", line
            run = afmcalc(*arguments, stdin=piped)
            assert (run.code, "rror" in run.err) == (0, False), (line, run.err)
            piped = run.out
    (code,) = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    exec(code, {})
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["optional-dependencies"]
    assert {name for names in re.findall(r"\[([a-z,]+)\]'", README) for name in names.split(",")} <= set(extras)


PIECES = table("pieces")
"""File → text that is added to it as the README says."""
BEFORE, LINES, ASKED = (PIECES["asked"][name] for name in ("before", "lines", "program"))
del PIECES["asked"]


@pytest.mark.tool
def test_what_is_added_as_the_page_says_is_there(tmp_path):
    """A variant, a material, a finding, rows and columns, an analysis, a formula with its proof."""
    recipes = README[README.index("To add") :]
    for file in PIECES:
        folder, _, name = file.rpartition("/")
        assert f"`{file}`" in recipes or f"`{folder}/`" in recipes or f"`{name}`" in recipes, file
    package = tmp_path / "afmcalc"
    shutil.copytree(ROOT / "afmcalc", package, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copytree(ROOT / "configs", package / "configs")
    for name, piece in PIECES.items():
        file = package / name
        text = file.read_text(encoding="utf-8") if file.exists() else ""
        at = text.index(BEFORE[name]) if name in BEFORE else len(text)
        file.write_text(text[:at] + (piece.lstrip("\n") if name in BEFORE else piece) + text[at:], encoding="utf-8")
    run = subprocess.run(
        [sys.executable, "-c", ASKED.format(home=str(tmp_path), arguments=LINES)],
        cwd=tmp_path, env={**os.environ, "PYTHONPATH": str(tmp_path)}, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert run.returncode == 0, run.stderr
    python, help_, usage, table, printed, schema, steps, torque, felt, _ = run.stdout.split("====\n")
    assert float(python) == pytest.approx(0.7)
    assert re.search(r"^  gap +Width of the friction range$", help_, re.MULTILINE)
    assert "afmcalc gap clutch.toml" in usage
    assert re.search(r"^Δf +width of the friction range +0\.7 +–$", table, re.MULTILINE)
    assert re.search(r"^ +f +f/Δf$", table, re.MULTILINE), table
    assert "info: the friction range is 0.7 wide [gap-told]" in table
    assert json.loads(printed)["result"]["ends"][1]["friction"] == 0.8
    assert json.loads(schema)["$defs"]["GapResult"]["required"] == ["gap", "ends"]
    assert "Δf = f_max - f_min" in steps
    assert "torque: Base clutch – two-driving" in torque
    assert json.loads(felt)["spec"]["friction"]["material"] == "felt"
    assert "Its width is 0.7." in (tmp_path / "r.html").read_text(encoding="utf-8")
