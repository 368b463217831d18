"""Every command: its JSON and its table as stored, the other formats against these; and what holds for any output."""

import csv
import io
import math
import os
import re
from pathlib import Path

import pytest
from conftest import CONFIGS

import afmcalc as package
from afmcalc.render import FORMATS
from afmcalc.render.plot.chart import Chart, ChartAxis, Line
from afmcalc.render.plot.text import draw
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
    "equation": ["equations", "--id", "S21 (15)"],
    "misprints": ["equations", "--misprints"],
    "reproduce": ["reproduce", "--paper", "S21"],
    "materials": ["materials"],
    "check": ["check", CONFIGS / "default.toml", "--set", "C=2"],
}


@pytest.mark.parametrize("name", COMMANDS)
def test_every_format_of_a_command(name, afmcalc):
    """JSON and table as stored; Markdown has the cells of the table, CSV the numbers of the JSON."""
    table, printed, sheet, markdown = (
        afmcalc(*COMMANDS[name], "--format", format_) for format_ in ("table", "json", "csv", "markdown")
    )
    assert {run.code for run in (table, printed, sheet, markdown)} == {0}
    stored(f"{name}.txt", table.out)
    stored(f"{name}.json", printed.out.replace(f'"version": "{package.__version__}"', '"version": "X"'))
    assert set(printed.json) == {"command", "version", "spec", "result", "findings"}
    if printed.json["command"] == "explain":
        stored(f"{name}.md", markdown.out)  # steps, their formulas in LaTeX
    else:
        lines = [cells(line) for line in table.out.splitlines()]
        rows = [cells(line, "|") for line in markdown.out.splitlines() if re.match(r"\| (?!-+:? )", line)]
        assert rows
        assert [row for row in rows if row not in lines] == []
    header, *rows = csv.reader(io.StringIO(sheet.out))
    assert rows
    assert {len(row) for row in rows} == {len(header)}
    result, findings = printed.json["result"], printed.json["findings"]
    intervals = [text.split() for row in rows for text in row]  # mostly of one number
    written = {float(end) for ends in intervals if all(map(is_number, ends)) for end in ends}
    assert {number for number in written if number not in {*numbers(result), *numbers(findings)}} == set()
    lists = [part for part in result.values() if part and isinstance(part, list) and isinstance(part[0], dict)]
    assert {number for number in numbers(lists[:1] or result) if number not in written} == set()


def stored(name, text):
    path = Path(__file__).parent / "snapshots" / name
    if os.environ.get("AFMCALC_UPDATE"):
        path.write_text(text, encoding="utf-8")
    assert text == path.read_text(encoding="utf-8"), f"{name} differs; AFMCALC_UPDATE=1 writes it anew: read it"


def cells(line, rule=None):
    """Cells of a line of a table that are not empty; of Markdown between its rules, without what escapes a sign."""
    parts = re.split(r"(?<!\\)\|", line) if rule else re.split(r"\s{2,}", line)
    return [(re.sub(r"\\(.)", r"\1", part) if rule else part).strip() for part in parts if part.strip()]


def numbers(value):
    """Every number of a JSON value."""
    if isinstance(value, dict | list):
        for part in value.values() if isinstance(value, dict) else value:
            yield from numbers(part)
    elif isinstance(value, int | float) and not isinstance(value, bool):
        yield value


def is_number(text):
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


def opened(text):
    """Rows as a spreadsheet with decimal commas opens them."""
    rows = list(csv.reader(io.StringIO(text.removeprefix("\ufeff")), delimiter=";"))
    assert len({*map(len, rows)}) == 1
    return [[number_of(cell) for cell in row] for row in rows]


def number_of(cell):
    assert not re.fullmatch(r"-?\d+\.\d+(e.*)?", cell), cell  # there it would be a date, or a text
    return float(cell.replace(",", ".")) if re.fullmatch(r"-?\d+(,\d+)?(e[-+]\d+)?", cell) else cell


@pytest.mark.every(3)
@pytest.mark.parametrize("name", COMMANDS)
def test_excel_opens_the_figures_of_the_csv(name, afmcalc):
    plain, excel = (afmcalc(*COMMANDS[name], *asked) for asked in (["--format", "csv"], ["--excel"]))
    assert excel.out.startswith("\ufeff")
    assert excel.code == plain.code
    wanted = list(csv.reader(io.StringIO(plain.out)))
    for shown, row in zip(opened(excel.out), wanted, strict=True):
        for cell, given in zip(shown, row, strict=True):
            if isinstance(cell, float):
                assert cell == float(given)
            else:
                assert cell.replace(",", ".") == given.replace(",", ".")


def test_excel_gets_a_file_with_the_mark_in_any_language(afmcalc, tmp_path):
    file = tmp_path / "a.csv"
    assert afmcalc("torque", "--excel", "--lang", "ru", "-o", file).code == 0
    assert file.read_bytes() == b"\xef\xbb\xbf" + afmcalc("torque", "--excel").out.removeprefix("\ufeff").encode()


def test_excel_opens_the_history_of_an_event(afmcalc, tmp_path):
    for name, asked in (("plain.csv", "--quiet"), ("excel.csv", "--excel")):
        arguments = "--friction", 0.3, "--history", tmp_path / name, asked
        assert afmcalc("simulate", CONFIGS / "drive.toml", *arguments).code == 0
    plain, excel = ((tmp_path / name).read_text(encoding="utf-8") for name in ("plain.csv", "excel.csv"))
    heading, *rows = opened(excel)
    wanted = list(csv.DictReader(io.StringIO(plain)))
    assert len(rows) == len(wanted) > 10
    at = heading.index("torque_shaft [N*m]")
    assert [row[at] for row in rows] == [float(row["torque_shaft [N*m]"]) for row in wanted]


@pytest.mark.parametrize("asked", [["--json"], ["--format", "table"], ["-o", "a.md"]])
def test_excel_is_csv_and_nothing_else(asked, afmcalc):
    run = afmcalc("torque", "--excel", *asked)
    assert (run.code, run.out) == (2, "")


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
    for format_ in FORMATS:
        target = tmp_path / format_
        run = afmcalc("torque", "--format", format_, "--output", target)
        assert run.out == ""
        assert target.read_text(encoding="utf-8") == afmcalc("torque", "--format", format_).out


def test_significant_figures():
    assert [significant(x) for x in (0, 1, 118.518518, -0.000123456, 1e-12, 123456.7, 1e7, 99999.6)] == [
        "0", "1", "118.52", "-0.00012346", "1e-12", "123460", "1e+07", "100000",
    ]  # fmt: skip


@pytest.mark.parametrize("unicode", [True, False])
@pytest.mark.parametrize("ends", [(0.0, 4.0), (2.0, 2.0), (-1e308, 1e308), (1.2345678e-300, 2e-300)])
def test_a_curve_is_whole(unicode, ends):
    """Of a constant, and from end to end of the floating-point numbers."""
    chart = Chart(ChartAxis("", "x"), ChartAxis("", "y"), [Line("", [0, 1, 2, 3], [*ends, *ends], points=True)])
    lines = draw(chart, unicode=unicode, wide=40, high=8)
    assert (lines[0], lines[-1].strip(), len(lines)) == ("y", "x", 12)
    assert max(map(len, lines)) == 40
    assert sum(line.count("•" if unicode else "*") for line in lines) == 4
    assert unicode or all(line.isascii() for line in lines)
