"""What the README shows is what the program prints."""

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
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


PIECES = {
    "analysis/gap.py": '''
from ..engines.protocol import Clutch
from ..findings import Finding
from ..result import Answer, quantity


class GapResult(Answer):
    """How far apart the ends of the friction range are."""

    gap: float = quantity("1", "Δf", "width of the friction range")


def gap(clutch: Clutch) -> tuple[GapResult, list[Finding]]:
    """Calculate the width of the friction range."""
    return GapResult(gap=round(clutch.friction[0].max - clutch.friction[0].min, 9)), clutch.findings()
''',
    "analysis/registry.py": """
        Analysis(
            "gap", "analysis.gap", "GapResult", "clutch",
            section=Section("Width of the friction", "The range of friction.", "Its width is {gap:.3g}."),
        ),
""",
    "cli/clutch.py": r'''

@with_common
def gap(spec: SpecArgument = None, *, common: Common) -> None:
    """Width of the friction range.

    \b
    afmcalc gap clutch.toml
    """  # noqa: D301
    common.calculate(common.clutch(spec))
''',
    "python.py": '''
    def gap(self) -> "GapResult":
        """Width of the friction range."""
        return self._ask("gap")

''',
}
"""What the page says that an analysis is made of, by file."""
BEFORE = {"analysis/registry.py": '        Analysis("compare"', "python.py": "    def heat("}
"""What a piece is put before, where that is not the end of its file."""

ASKED = """
import afmcalc
from afmcalc.cli.main import main
assert afmcalc.__file__.startswith({home!r}), afmcalc.__file__
print(afmcalc.load().gap().to_dict())
for arguments in {arguments!r}:
    print("====")
    try:
        main(arguments)
    except SystemExit as ended:
        assert not ended.code, arguments
"""


def test_an_analysis_is_added_as_the_page_says(tmp_path):
    (recipe,) = re.findall(r"^- an analysis: (.*?);$", README, re.MULTILINE | re.DOTALL)
    assert re.findall(r"`([\w./]+)`", recipe) == ["analysis/", "registry.py", "cli/", "python.py"]
    package = tmp_path / "afmcalc"
    shutil.copytree(ROOT / "afmcalc", package, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copytree(ROOT / "configs", package / "configs")
    for name, piece in PIECES.items():
        file = package / name
        text = file.read_text(encoding="utf-8") if file.exists() else ""
        at = text.index(BEFORE[name]) if name in BEFORE else len(text)
        file.write_text(text[:at] + (piece.lstrip("\n") if name in BEFORE else piece) + text[at:], encoding="utf-8")
    asked = [["--help"], ["gap", "--help"], ["gap"], ["gap", "--json"], ["schema", "gap"], ["report", "-o", "r.html"]]
    run = subprocess.run(
        [sys.executable, "-c", ASKED.format(home=str(tmp_path), arguments=asked)],
        cwd=tmp_path, env={**os.environ, "PYTHONPATH": str(tmp_path)}, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert run.returncode == 0, run.stderr
    python, help_, own, table, printed, schema, _ = run.stdout.split("====\n")
    assert python == "{'gap': 0.7}\n"
    assert re.search(r"^  gap +Width of the friction range$", help_, re.MULTILINE)
    assert "afmcalc gap clutch.toml" in own
    assert re.search(r"^Δf +width of the friction range +0\.7 +–$", table, re.MULTILINE)
    assert json.loads(printed)["result"] == {"gap": 0.7}
    assert json.loads(schema)["$defs"]["GapResult"]["required"] == ["gap"]
    assert "Its width is 0.7." in (tmp_path / "r.html").read_text(encoding="utf-8")
