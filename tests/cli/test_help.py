"""The help: groups, examples one can copy from a narrow terminal, names; completion in real shells."""

import os
import re
import shlex
import shutil
import subprocess
import sys

import pytest
from conftest import CONFIGS, ROOT

from afmcalc.cli.help import FILES, SECTIONS, example_lines, names_of
from afmcalc.cli.main import COMMANDS


def test_commands_stand_in_groups_and_are_told_in_full(afmcalc):
    groups = dict(re.findall(r"^([A-Z][a-z ]+):\n((?:  .*\n)+)", afmcalc("--help").out, re.MULTILINE))
    listed = [
        name
        for title in (*dict.fromkeys(SECTIONS.values()), FILES)
        for name in re.findall(r"^  (\S+)", groups.get(title, ""), re.MULTILINE)
    ]
    assert sorted(listed) == sorted(COMMANDS)
    assert {"torque", "check"} <= set(re.findall(r"^  (\S+)", groups["Calculate"], re.MULTILINE))
    assert {"init", "plot", "report", "schema"} <= set(re.findall(r"^  (\S+)", groups["Files"], re.MULTILINE))
    assert "..." not in "".join(groups.values()), "nothing is cut"


def examples(command):
    """Command lines of a help, without what they are for."""
    lines = (line.strip().partition("  ")[0] for line in _function(command).__doc__.splitlines())
    return [line for line in lines if line.startswith("afmcalc ")]


CUT = re.compile(r"\.\.\.(?<!\[SPEC\]\.\.\.)(?<!\[ARGS\]\.\.\.)(?<!, \.\.\.)(?<!v2,\.\.\.)(?<!\[\.\.\.)")


@pytest.mark.parametrize("command", ["", *COMMANDS])
def test_examples_are_whole_on_any_terminal(command, afmcalc, monkeypatch):
    for width in (60, 120):
        monkeypatch.setenv("COLUMNS", str(width))
        monkeypatch.setenv("TERMINAL_WIDTH", str(width))
        shown = afmcalc(*filter(None, [command]), "--help").out
        assert max(map(len, shown.split("\n"))) <= width
        joined = re.sub(r" \\\n +", " ", shown)
        assert examples(command)
        assert not [example for example in examples(command) if example not in joined]
        assert not CUT.search(shown)
        assert "[[" not in shown
        assert "configs/" not in shown, "there is no such folder beside an installed program"


NEEDS = dict.fromkeys(("heat", "simulate", "effects"), "drive") | {"layout": "envelope"}
NEEDS |= {"tolerance": "tolerance", "plot": "tolerance"}
"""What stands for clutch.toml in the examples of a command, where it takes more than the default one."""
SLOW = ("plot", "tolerance", "solve", "springs", "design", "equations", "simulate", "report")
ELSEWHERE = ("serve", "handbook")


RUN = [
    pytest.param(each, marks=pytest.mark.slow) if each in SLOW else each for each in COMMANDS if each not in ELSEWHERE
]


@pytest.mark.parametrize("command", RUN)
def test_every_example_of_a_help_runs(command, undrawn, afmcalc, tmp_path, monkeypatch):
    there = {"drive": "drive", "requirements": "requirements", "a": "default", "b": "all-driving"}
    if command not in ("init", "design"):  # which write it
        there["clutch"] = NEEDS.get(command, "default")
    for number, example in enumerate(line for line in examples(command) if "pdf" not in line):
        folder = tmp_path / str(number)
        folder.mkdir()
        monkeypatch.chdir(folder)
        for name, config in there.items():
            text = (CONFIGS / f"{config}.toml").read_text(encoding="utf-8")
            (folder / f"{name}.toml").write_text(text.replace("[drive.event]", '[drive.event]\nduration = "20 ms"'))
        (folder / "own.csv").write_text(
            "name,description,condition,friction_min,friction_max,source\nX,pad,dry,0.2,0.3,test\n"
        )
        out = ""
        for part in example.partition(" > ")[0].partition(" && ")[0].split(" | "):
            run = afmcalc(*shlex.split(part)[1:], stdin=out)
            assert run.code == 0, (part, run.err)
            out = run.out


def _function(command):
    from importlib import import_module

    from afmcalc.cli import main

    return getattr(import_module(f"afmcalc.cli.{COMMANDS[command]}"), command) if command else main._afmcalc


def test_words_in_quotes_stay_together():
    line = 'afmcalc solve --for F nominal_torque="250 N*m" clutch.toml --json | afmcalc torque -'
    lines = list(example_lines(line, 40))
    assert all(len(each) <= 40 for each in lines)
    assert shlex.split("\n".join(lines).replace("\\\n", "")) == shlex.split(line)


LISTED = {"solve": ["parameter", "target"], "accuracy": ["swept"], "plot": ["plot", "swept"], "explain": ["explained"]}


def test_the_help_lists_the_names_that_can_be_given(afmcalc):
    for command, kinds in LISTED.items():
        shown = afmcalc(command, "--help").out
        for name, _ in (each for kind in kinds for each in names_of(kind)):
            assert re.search(rf"^  {re.escape(name)}(?: |$)", shown, re.MULTILINE), (command, name)


COMPLETED = {
    "afmcalc tor": {"torque"},
    "afmcalc accuracy --sw": {"--sweep"},
    "afmcalc accuracy --sweep f_": {"f_min", "f_mean", "f_max"},
    "afmcalc solve accuracy_f": {"accuracy_factor="},
    "afmcalc solve --for c": {"c1", "c2"},
    "afmcalc plot pare": {"pareto"},
    "afmcalc explain accu": {"accuracy"},
}


@pytest.mark.parametrize("typed", COMPLETED)
def test_names_are_completed(typed, afmcalc, monkeypatch):
    asked = {"_AFMCALC_COMPLETE": "complete_bash", "COMP_WORDS": typed, "COMP_CWORD": str(typed.count(" "))}
    for name, value in asked.items():
        monkeypatch.setenv(name, value)
    assert COMPLETED[typed] <= set(afmcalc().out.split())


SCRIPTS = {
    "bash": """source ~/.bashrc; entry=$(complete -p afmcalc); name=${entry##*-F }; name=${name% *}
        tried() { COMP_WORDS=($1); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); COMPREPLY=(); $name afmcalc
        [[ $entry == *"-o default"* && ${#COMPREPLY[@]} = 0 ]] && COMPREPLY=($(compgen -f -- ${COMP_WORDS[-1]}))
        echo "${COMPREPLY[*]}"; }""",
    "fish": """function tried; echo (complete -C "$argv[1]" | string replace -r '\\t.*' ''); end""",
}
SHELLS = [
    pytest.param(each, marks=pytest.mark.skipif(not shutil.which(each), reason=f"{each} is not installed"))
    for each in SCRIPTS
]


@pytest.mark.tool
@pytest.mark.parametrize("shell", SHELLS)
def test_completion_in_a_shell(shell, tmp_path):
    """A value of an option, which the program gives, and a file, which the shell does."""
    program = tmp_path / "bin" / "afmcalc"
    program.parent.mkdir()
    program.write_text(f'#!/bin/sh\nexec {sys.executable} -m afmcalc "$@"\n')
    program.chmod(0o755)
    (tmp_path / "my-clutch.toml").touch()
    home = {"HOME": str(tmp_path), "PATH": f"{program.parent}:{os.environ['PATH']}", "PYTHONPATH": str(ROOT)}
    home |= {"TERM": "dumb", "XDG_CONFIG_HOME": f"{tmp_path}/.config"}

    def ran(script):
        command = [shell, "-c", script]
        return subprocess.run(
            command, env={**os.environ, **home}, cwd=tmp_path, capture_output=True, text=True, check=True
        )

    ran("afmcalc --install-completion; true")
    shown = ran(f"{SCRIPTS[shell]}\ntried 'afmcalc solve --for c'\ntried 'afmcalc torque my'").stdout.splitlines()
    assert {"c1", "c2"} <= set(shown[0].split())
    assert "my-clutch.toml" in shown[1].split()
