"""The help: groups, examples one can copy from a narrow terminal, names; completion in real shells."""

import os
import pty
import re
import select
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


@pytest.mark.parametrize("width", [60, 80, 120])
@pytest.mark.parametrize("command", ["", *COMMANDS])
def test_examples_are_whole_on_any_terminal(command, width, afmcalc, monkeypatch):
    monkeypatch.setenv("COLUMNS", str(width))
    monkeypatch.setenv("TERMINAL_WIDTH", str(width))
    shown = afmcalc(*filter(None, [command]), "--help").out
    monkeypatch.setenv("COLUMNS", "200")
    whole = [
        line for line in sys.modules["inspect"].getdoc(_function(command)).split("\n") if line.startswith("afmcalc ")
    ]
    assert whole
    assert max(map(len, shown.split("\n"))) <= width
    joined = re.sub(r" \\\n +", " ", shown)
    for example in whole:
        assert example.partition("  ")[0] in joined
    assert "[[" not in shown
    assert "configs/" not in shown, "there is no such folder beside an installed program"
    assert "..." not in shown.replace("[SPEC]...", "").replace("[ARGS]...", "").replace("v2,...", "").replace(
        "S22-3, ...", ""
    ).replace("[...]", "")


NEEDS = dict.fromkeys(("heat", "simulate", "effects"), "drive") | {"layout": "envelope"}
NEEDS |= {"tolerance": "tolerance", "plot": "tolerance"}
"""What stands for clutch.toml in the examples of a command, where it takes more than the default one."""


@pytest.mark.parametrize("command", [each for each in COMMANDS if each != "serve"])
def test_every_example_of_a_help_runs(command, afmcalc, tmp_path, monkeypatch):
    there = {"drive": "drive", "requirements": "requirements", "a": "default", "b": "all-driving"}
    if command not in ("init", "design"):  # which write it
        there["clutch"] = NEEDS.get(command, "default")
    listed = "name,description,condition,friction_min,friction_max,source\nX,pad,dry,0.2,0.3,test\n"
    lines = [line.strip().partition("  ")[0] for line in _function(command).__doc__.splitlines()]
    for number, example in enumerate(line for line in lines if line.startswith("afmcalc ") and "pdf" not in line):
        folder = tmp_path / str(number)
        folder.mkdir()
        monkeypatch.chdir(folder)
        for name, config in there.items():
            shutil.copy(CONFIGS / f"{config}.toml", f"{name}.toml")
        (folder / "own.csv").write_text(listed, encoding="utf-8")
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
    lines = list(
        example_lines('afmcalc solve --for F nominal_torque="250 N*m" clutch.toml --json | afmcalc torque -', 40)
    )
    assert all(len(line) <= 40 for line in lines)
    assert any('"250 N*m"' in line for line in lines)
    assert subprocess.run(["bash", "-n", "-c", "\n".join(lines)], check=False).returncode == 0


@pytest.mark.parametrize(
    ("command", "listed"),
    [
        ("solve", ["parameter", "target"]),
        ("accuracy", ["swept"]),
        ("life", ["swept"]),
        ("plot", ["plot", "swept"]),
        ("explain", ["explained"]),
    ],
)
def test_the_help_lists_the_names_that_can_be_given(command, listed, afmcalc):
    shown = afmcalc(command, "--help").out
    for kind in listed:
        for name, _ in names_of(kind):
            assert re.search(rf"^  {re.escape(name)}(?: |$)", shown, re.MULTILINE), name


def home_of(shell, home):
    """A home in which completion is installed for a shell, the program on its path."""
    program = home / "bin" / "afmcalc"
    program.parent.mkdir()
    program.write_text(f'#!/bin/sh\nexec {sys.executable} -m afmcalc "$@"\n')
    program.chmod(0o755)
    (home / "my-clutch.toml").touch()
    subprocess.run(
        [shell, "-c", "afmcalc --install-completion; true"], env=environment(home), check=True, capture_output=True
    )
    with (home / ".zshrc").open("a") as file:
        file.write(
            f"PS1=; again() {{ BUFFER=; print -n '{_READY}' }}; zle -N again; bindkey '^G' again; zle -N zle-line-init again\n"
        )
    return home


def environment(home):
    path = f"{home}/bin:{os.environ['PATH']}"
    return {
        **os.environ,
        "HOME": str(home),
        "PATH": path,
        "PYTHONPATH": str(ROOT),
        "TERM": "dumb",
        "XDG_CONFIG_HOME": f"{home}/.config",
    }


TYPED = {
    "afmcalc tor": {"torque"},
    "afmcalc accuracy --sw": {"--sweep"},
    "afmcalc solve --for c": {"c1", "c2"},
    "afmcalc torque my": {"my-clutch.toml"},
}
"""A command, an option, a value of one, a file: what a shell may get wrong."""
OF_BOTH = {typed: TYPED[typed] for typed in list(TYPED)[-2:]}
"""For shells that start the program more than once for each: a value, which the program gives, and a file, which the shell does."""


@pytest.mark.parametrize(
    ("typed", "wanted"),
    [
        ("afmcalc accuracy --sweep f_", {"f_min", "f_mean", "f_max"}),
        ("afmcalc solve accuracy_f", {"accuracy_factor="}),
        ("afmcalc plot pare", {"pareto"}),
        ("afmcalc explain accu", {"accuracy"}),
    ],
)
def test_names_are_completed(typed, wanted, afmcalc, monkeypatch):
    asked = {"_AFMCALC_COMPLETE": "complete_bash", "COMP_WORDS": typed, "COMP_CWORD": str(typed.count(" "))}
    for name, value in asked.items():
        monkeypatch.setenv(name, value)
    assert wanted <= set(afmcalc().out.split())


def needs(shell):
    return pytest.mark.skipif(not shutil.which(shell), reason=f"{shell} is not installed")


@needs("bash")
def test_completion_in_bash(tmp_path):
    home = home_of("bash", tmp_path)
    script = "source ~/.bashrc; for line; do COMP_WORDS=($line); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); COMPREPLY=()\n"
    script += "entry=$(complete -p afmcalc); name=${entry##*-F }; ${name% *} afmcalc\n"
    script += (
        '[[ $entry == *"-o default"* && ${#COMPREPLY[@]} = 0 ]] && COMPREPLY=($(compgen -f -- ${COMP_WORDS[-1]}))\n'
    )
    script += 'echo "${COMPREPLY[*]}"; done'
    run = subprocess.run(
        ["bash", "-c", script, "bash", *TYPED],
        env=environment(home),
        cwd=home,
        capture_output=True,
        text=True,
        check=True,
    )
    for line, wanted in zip(run.stdout.splitlines(), TYPED.values(), strict=True):
        assert wanted <= set(line.split())


@needs("fish")
@pytest.mark.exhaustive
def test_completion_in_fish(tmp_path):
    home = home_of("fish", tmp_path)
    script = "\n".join(f"echo (complete -C '{typed}' | string replace -r '\\t.*' '')" for typed in OF_BOTH)
    run = subprocess.run(
        ["fish", "-c", script], env=environment(home), cwd=home, capture_output=True, text=True, check=True
    )
    for line, wanted in zip(run.stdout.splitlines(), OF_BOTH.values(), strict=True):
        assert wanted <= set(line.split())


@needs("zsh")
@pytest.mark.exhaustive
def test_completion_in_zsh(tmp_path):
    """An interactive one, since completion is part of its line editor; each line is typed, completed and shown."""
    home = home_of("zsh", tmp_path)
    child, person = pty.fork()
    if not child:
        os.chdir(home)
        os.execvpe("zsh", ["zsh", "-i"], environment(home))
    try:
        _said(person, [_READY])
        os.write(person, b"afmcalc \t")  # the first time zsh only loads the function
        _said(person, ["\a"])
        for typed, wanted in OF_BOTH.items():
            os.write(person, b"\x07")
            _said(person, [_READY])
            os.write(person, f"{typed}\t".encode())
            shown = _said(person, wanted)
            assert all(name in shown for name in wanted), shown
    finally:
        os.write(person, b"\x07exit\n")
        os.close(person)
        os.waitpid(child, 0)


_READY = "ready> "
"""Shown by the line editor when it begins a line, and when ^G takes back what was typed."""


def _said(terminal, wanted):
    """What is shown until all that is wanted is, or nothing more comes."""
    shown = ""
    while not all(name in shown for name in wanted) and select.select([terminal], [], [], 20)[0]:
        shown += os.read(terminal, 65536).decode(errors="replace")
    return shown
