"""What the README shows is what the program prints."""

import re
import shlex
import tomllib
from itertools import groupby

from conftest import ROOT

README = (ROOT / "README.md").read_text(encoding="utf-8")


def test_the_worked_example(afmcalc, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (example,) = re.findall(r"```console\n(.*?)```", README, re.DOTALL)
    for block in re.split(r"^\$ ", example, flags=re.MULTILINE)[1:]:
        command, _, printed = block.partition("\n")
        run = afmcalc(*command.split()[1:])
        assert run.code == 0
        assert run.err + run.out == printed.rstrip("\n") + "\n"


def test_the_spec_and_every_command_are_there(afmcalc, tmp_path):
    from afmcalc.cli.main import COMMANDS

    spec, *_ = re.findall(r"```toml\n(.*?)```", README, re.DOTALL)
    assert afmcalc("torque", "-", stdin=spec).code == 0
    for name in COMMANDS:
        assert f"`afmcalc {name} " in README or f"`afmcalc {name}`" in README, name


def test_line_by_line_in_an_empty_folder(undrawn, afmcalc, tmp_path, monkeypatch):
    """Every shell line in the order of the page, then the Python, with nothing but the installed package."""
    monkeypatch.chdir(tmp_path)
    lines = [line for block in re.findall(r"```sh\n(.*?)```", README, re.DOTALL) for line in block.splitlines()]
    ours = [line.split("&& ")[-1] for line in lines if "afmcalc" in line.split("#")[0] and "pytest" not in line]
    assert len(ours) > 10
    for line in ours:
        words, piped = shlex.split(line, comments=True), ""
        for program, *arguments in (list(each) for bar, each in groupby(words, lambda word: word == "|") if not bar):
            assert program == "afmcalc", line
            run = afmcalc(*arguments, stdin=piped)
            assert (run.code, "rror" in run.err) == (0, False), (line, run.err)
            piped = run.out
    (code,) = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    exec(code, {})
    extras = set(
        tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["optional-dependencies"]
    )
    assert set(re.findall(r"\[([a-z,]+)\]'", README)) <= extras


def test_the_pictures_are_those_that_are_drawn_today():
    pictures = re.findall(r"!\[[^]]+\]\(([^)]+)\)", README)
    assert len(pictures) == 2
    assert all((ROOT / picture).parent.name == "baseline" and (ROOT / picture).is_file() for picture in pictures)
