"""What the README shows is what the program prints."""

import re

from conftest import CONFIGS, ROOT

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


def test_python_example(tmp_path, monkeypatch, afmcalc):
    monkeypatch.chdir(tmp_path)
    afmcalc("init", "clutch.toml")
    (tmp_path / "requirements.toml").write_bytes((CONFIGS / "requirements.toml").read_bytes())
    (code,) = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    exec(code, {})
