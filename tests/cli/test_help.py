"""The help: groups, examples one can copy from a narrow terminal, names; completion in real shells."""

import os
import re
import shlex
import subprocess
import sys
from importlib import import_module

import pytest
from conftest import CONFIGS, ROOT, slow
from sources import READ, table

from afmcalc.cli import main
from afmcalc.cli.main import COMMANDS


def examples(command):
    """Command lines of a help, without their descriptions."""
    name = "list_" if command == "list" else command
    called = getattr(import_module(f"afmcalc.cli.{COMMANDS[command]}"), name) if command else main._afmcalc
    lines = (line.strip().partition("  ")[0] for line in called.__doc__.splitlines())
    return [line for line in lines if line.startswith("afmcalc ") and ": " not in line]


@pytest.mark.parametrize("command", COMMANDS)
def test_a_help_is_short_and_leaves_common_options_out(command, afmcalc, monkeypatch):
    """It has at most 45 lines of 100 columns, whole examples, every option of its own and no common one."""
    monkeypatch.setenv("COLUMNS", "100")
    shown = afmcalc(command, "--help").out
    assert shown == afmcalc("help", command).out
    assert len(shown.splitlines()) <= 45
    assert max(map(len, shown.splitlines())) <= 100
    assert examples(command)
    assert not [example for example in examples(command) if example not in shown]
    assert "  --json" not in shown
    assert shown.endswith("afmcalc help options\n")


def test_the_panels_hold_every_command_and_topics_the_rest(afmcalc):
    shown = afmcalc("--help").out
    assert set(COMMANDS) <= set(re.findall(r"^  (\S+)", shown, re.MULTILINE))
    assert [heading for heading in main.PANELS if f"\n{heading}:\n" not in shown] == []
    topics = {"options": "--set PATH=VALUE", "keys": "control_unit.gain", "quantities": "peak_torque"}
    for topic, named in topics.items():
        assert named in afmcalc("help", topic).out
    assert afmcalc("help").out == afmcalc("-help").out == shown
    assert afmcalc("-v").out == afmcalc("--version").out
    assert "Заменить" in afmcalc("help", "options", "--lang", "ru").out
    wrong = afmcalc("help", "keyz")
    assert (wrong.code, "did you mean 'keys'" in wrong.err) == (2, True)


def test_a_former_command_or_option_names_what_is_in_its_place(afmcalc):
    for name, now in main.FORMER.items():
        run = afmcalc(name, "example:default")
        assert (run.code, run.out, run.err) == (2, "", f"error: {name} is now: afmcalc {now}\n")
        assert now.split()[0] in COMMANDS
    for name, now in main.FORMER_OPTIONS.items():
        run = afmcalc("torque", name)
        assert (run.code, run.out) == (2, "")
        assert run.err.endswith(f"error: {name} is no option any more; instead: {now}\n")


NEEDS = dict.fromkeys(("simulate", "effects"), "drive") | {"layout": "envelope"}
NEEDS |= {"tolerance": "tolerance", "plot": "tolerance"}
"""Command → example spec used as clutch.toml, if the command needs more than the default example has."""
SLOW = (
    "plot", "tolerance", "solve", "springs", "design", "papers", "simulate", "report", "check", "effects",
    "compare", "explain", "pocket", "life", "accuracy",
)  # fmt: skip
OWN = [each for each in COMMANDS if each not in ("serve", "handbook")]
RUN = [*(each for each in OWN if each not in SLOW), *slow(*SLOW)]


@pytest.mark.parametrize("command", RUN)
def test_every_example_of_a_help_runs(command, searched_once, undrawn, afmcalc, tmp_path, monkeypatch):
    there = {"drive": "drive", "requirements": "requirements", "a": "default", "b": "all-driving"}
    if command not in ("init", "design"):  # these commands write clutch.toml themselves
        there["clutch"] = NEEDS.get(command, "default")
    for number, example in enumerate(line for line in examples(command) if "pdf" not in line):
        folder = tmp_path / str(number)
        folder.mkdir()
        monkeypatch.chdir(folder)
        for name, config in there.items():
            text = (CONFIGS / f"{config}.toml").read_text(encoding="utf-8")
            (folder / f"{name}.toml").write_text(text.replace("[drive.event]", '[drive.event]\nduration = "20 ms"'))
        out = ""
        for part in example.partition(" > ")[0].partition(" && ")[0].split(" | "):
            run = afmcalc(*shlex.split(part)[1:], stdin=out)
            assert run.code == 0, (part, run.err)
            out = run.out


def test_names_are_completed(afmcalc, monkeypatch):
    monkeypatch.setenv("_AFMCALC_COMPLETE", "complete_bash")
    for typed, names in READ["completed"]:
        monkeypatch.setenv("COMP_WORDS", typed)
        monkeypatch.setenv("COMP_CWORD", str(typed.count(" ")))
        assert set(afmcalc().out.split()) >= set(names), typed
        assert names or not afmcalc().out.strip(), typed


@pytest.mark.tool
def test_completion_in_a_shell(tmp_path):
    """Values of options are completed by the program, names of files by the shell."""
    program = tmp_path / "bin" / "afmcalc"
    program.parent.mkdir()
    program.write_text(f'#!/bin/sh\nexec {sys.executable} -m afmcalc "$@"\n')
    program.chmod(0o755)
    (tmp_path / "my-clutch.toml").touch()
    home = {**os.environ, "HOME": str(tmp_path), "PATH": f"{program.parent}:{os.environ['PATH']}"}
    home |= {"PYTHONPATH": str(ROOT), "TERM": "dumb"}
    options = {"env": home, "cwd": tmp_path, "capture_output": True, "text": True}
    subprocess.run(["bash", "-c", "afmcalc --install-completion; true"], check=True, **options)
    values, files = subprocess.run(
        ["bash", "-c", table("programs")["completed"]], check=True, **options
    ).stdout.splitlines()
    assert {"c1", "c2"} <= set(values.split())
    assert "my-clutch.toml" in files.split()
