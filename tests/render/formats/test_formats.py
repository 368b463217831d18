"""Every command in every format, as stored; and what holds for any output."""

import csv
import functools
import io
import os
from pathlib import Path

import pytest
from conftest import CONFIGS

import afmcalc as package
from afmcalc.proofs import prove
from afmcalc.render.plot.text import curve
from afmcalc.render.units import significant

COMMANDS = {
    "torque": ["torque", CONFIGS / "default.toml", "--friction", "0.2", "--friction", "0.9"],
    "torque-unlike": ["torque", CONFIGS / "unlike-materials.toml", "--friction", "0.2,0.3"],
    "accuracy": ["accuracy", CONFIGS / "default.toml"],
    "accuracy-sweep": ["accuracy", CONFIGS / "default.toml", "--sweep", "C=0:2:9"],
    "accuracy-grid": ["accuracy", CONFIGS / "all-driving.toml", "--sweep", "C=0.5,1", "--sweep", "z=2:6:3"],
    "torque-indirect": ["torque", CONFIGS / "indirect.toml", "--friction", "0.5"],
    "accuracy-indirect": ["accuracy", CONFIGS / "indirect.toml"],
    "adjust": ["adjust", CONFIGS / "default.toml"],
    "overload": ["overload", CONFIGS / "all-driving.toml"],
    "overload-sweep": ["overload", CONFIGS / "all-driving.toml", "--sweep", "zC=1:5:5"],
    "synthesize": ["synthesize", CONFIGS / "indirect.toml"],
    "life": ["life", CONFIGS / "default.toml"],
    "life-sweep": ["life", CONFIGS / "default.toml", "--sweep", "dT=100:300:3"],
    "compare": ["compare", CONFIGS / "default.toml", CONFIGS / "indirect.toml", CONFIGS / "all-driving.toml"],
    "compare-variants": ["compare", CONFIGS / "indirect.toml", "--variants"],
    "explain": ["explain", "synthesize", CONFIGS / "indirect.toml"],
    "equations": ["equations", "--paper", "F11"],
    "equation": ["equations", "--id", "S21 (15)", "--prove"],
    "misprints": ["equations", "--misprints"],
    "reproduce": ["reproduce", "--paper", "S21"],
    "materials": ["materials"],
    "check": ["check", CONFIGS / "default.toml", "--set", "C=2"],
}
ENDINGS = {"table": "txt", "json": "json", "csv": "csv", "markdown": "md"}


PROVED = functools.cache(prove)


@pytest.mark.parametrize("format_", ENDINGS)
@pytest.mark.parametrize("name", COMMANDS)
def test_snapshot(name, format_, afmcalc, monkeypatch):
    monkeypatch.setattr("afmcalc.proofs.prove", PROVED)  # once for every format
    run = afmcalc(*COMMANDS[name], "--format", format_)
    assert run.code == 0
    text = run.out.replace(f'"version": "{package.__version__}"', '"version": "X"')
    path = Path(__file__).parent / "snapshots" / f"{name}.{ENDINGS[format_]}"
    if os.environ.get("AFMCALC_UPDATE"):
        path.write_text(text, encoding="utf-8")
    assert text == path.read_text(encoding="utf-8"), f"{path.name} differs; AFMCALC_UPDATE=1 writes it anew: read it"
    if format_ == "json":
        assert set(run.json) == {"command", "version", "spec", "result", "findings"}
    if format_ == "csv":
        rows = list(csv.reader(io.StringIO(run.out)))
        assert len({len(row) for row in rows}) == 1
        assert len(rows) >= 2


def test_csv_has_full_precision_and_one_row_per_point(afmcalc):
    points = afmcalc("accuracy", "--sweep", "C=0:1:7", "--json").json["result"]["sweep"][0]
    rows = list(csv.reader(io.StringIO(afmcalc("accuracy", "--sweep", "C=0:1:7", "--format", "csv").out)))
    assert rows[0] == [
        "control_unit.gain [1]",
        "accuracy_factor [1]",
        "accuracy_factor_peak [1]",
        "nominal_torque [N*m]",
        "torque_max [N*m]",
    ]
    assert [float(row[0]) for row in rows[1:]] == points["values"]
    assert [float(row[1]) for row in rows[1:]] == points["accuracy_factor"]


def test_a_name_cannot_be_markup(afmcalc):
    run = afmcalc("torque", "--set", "name=<b>|x|*_`[bold]y[/]", "--format", "markdown")
    assert "## torque: \\<b\\>\\|x\\|\\*\\_\\`\\[bold\\]y\\[/\\]" in run.out
    assert "[bold]y[/]" in afmcalc("torque", "--set", "name=[bold]y[/]").out


def test_tables_are_not_cut_off_a_terminal(afmcalc, monkeypatch):
    name = "x" * 300
    wide = afmcalc("torque", "--set", f"name={name}").out
    assert name in wide
    assert "\x1b" not in wide
    monkeypatch.setenv("COLUMNS", "60")
    narrow = afmcalc("accuracy", "--sweep", "C")
    assert narrow.code == 0
    lines = narrow.out.splitlines()
    assert max(map(len, lines)) <= 60
    assert not any("…" in line for line in lines)


def test_output_file_is_what_would_be_printed(afmcalc, tmp_path):
    for format_ in ENDINGS:
        target = tmp_path / format_
        run = afmcalc("torque", "--format", format_, "--output", target)
        assert run.out == ""
        assert target.read_text(encoding="utf-8") == afmcalc("torque", "--format", format_).out


def test_significant_figures():
    assert [significant(x) for x in (0, 1, 118.518518, -0.000123456, 1e-12, 123456.7, 1e7, 99999.6)] == [
        "0", "1", "118.52", "-0.00012346", "1e-12", "123460", "1e+07", "100000",
    ]  # fmt: skip


@pytest.mark.parametrize("unicode", [True, False])
def test_curve(unicode):
    lines = curve([0, 1, 2, 3], [4, 3, 2, 1], "y against x", unicode=unicode)
    assert lines[0] == "y against x"
    assert sum(line.count("•" if unicode else "*") for line in lines) == 4
    assert lines[1].startswith("4 ")
    assert unicode or all(line.isascii() for line in lines)
    flat = curve([1, 1], [2, 2], "level", unicode=unicode)
    assert len(flat) == len(lines)
    assert len(curve([-1e308, 1e308], [0, 1], "huge", unicode=unicode)) == len(lines)
