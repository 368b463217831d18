"""Formats of one answer agree, texts do nothing; tables for people: a symbol for a thing, points below points, nothing cut."""

import collections
import csv
import io
import json
import math
import os
import re
from pathlib import Path

import pytest
from conftest import CONFIGS, slow
from hypothesis import given
from hypothesis import strategies as st
from jsonschema import validate
from sources import READ

from afmcalc.analysis.compare import compare
from afmcalc.analysis.registry import ANALYSES
from afmcalc.engines import build
from afmcalc.findings import Finding
from afmcalc.messages import native, printable
from afmcalc.render import renderer
from afmcalc.render.amounts import display, estimate, significant
from afmcalc.render.document import document
from afmcalc.render.formats import FORMATS
from afmcalc.render.text_tables import TextTable, blocks, padded
from afmcalc.result import Output, Result, described, quantity, shown_as
from afmcalc.spec import read_spec
from afmcalc.spec.fields import Block
from afmcalc.spec.keys import keys

COMMANDS = {name: line.split() for name, line in READ["formats"].items()}
QUICK = ("torque", "accuracy-grid", "pocket", "check")
STORED = {name: COMMANDS[name] for name in QUICK} | {"check.ru": [*COMMANDS["check"], "--lang", "ru"]}
STORED |= {"torque.ru": ["torque", "example:indirect", "--lang", "ru"]}


@pytest.mark.parametrize("name", STORED)
def test_a_stored_table(name, answered):
    path = Path(__file__).parent / "snapshots" / f"{name}.txt"
    text = answered(*STORED[name]).out
    if os.environ.get("AFMCALC_UPDATE"):
        path.write_text(text, encoding="utf-8")
    assert text == path.read_text(encoding="utf-8"), f"{name} differs; AFMCALC_UPDATE=1 writes it anew: read it"


@pytest.mark.parametrize("name", [*QUICK, *slow(*(name for name in COMMANDS if name not in QUICK))])
def test_the_formats_of_an_answer_agree(name, answered):
    """JSON fits its schema; Markdown has the cells of the table, CSV the numbers of JSON, as does CSV for Excel."""
    runs = [answered(*COMMANDS[name], "--format", form) for form in ("table", "json", "csv", "markdown")]
    runs.append(answered(*COMMANDS[name], "--format", "csv", "--lang", "ru"))
    assert {run.code for run in runs} == {0}
    table, printed, sheet, markdown, excel = runs
    assert list(printed.json) == ["command", "version", "spec", "result", "findings"]
    if (command := printed.json["command"]) in ANALYSES:
        validate(printed.json, answered("schema", command).json)
    if command != "explain":  # Markdown of explain has formulas of its own
        lines = [cells(line) for line in table.out.splitlines()]
        rows = [cells(line, "|") for line in markdown.out.splitlines() if re.match(r"\| (?!-+:? )", line)]
        assert rows
        assert [row for row in rows if row not in lines] == []
    header, *rows = wanted = list(csv.reader(io.StringIO(sheet.out)))
    assert rows
    assert {len(row) for row in rows} == {len(header)}
    result, findings = printed.json["result"], printed.json["findings"]
    intervals = [text.split() for row in rows for text in row]  # mostly of one number
    written = {float(end) for ends in intervals if all(map(is_number, ends)) for end in ends}
    assert written <= {*numbers(result), *numbers(findings)}
    lists = [part for part in result.values() if part and isinstance(part, list) and isinstance(part[0], dict)]
    flat = [{name: part for name, part in row.items() if name != "checks"} for row in lists[0]] if lists else result
    assert {*numbers(flat)} <= written
    opened = opened_with_commas(excel.out)
    told = [[float(cell) for cell in row if is_number(cell)] for row in wanted]
    assert [[cell for cell in row if isinstance(cell, float)] for row in opened] == told


def cells(line, rule=None):
    """Cells of a table line that are not empty; for Markdown those between ``rule``, without escapes."""
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


def opened_with_commas(text):
    """Rows as a spreadsheet with decimal commas opens them; it might take a number with a point for a date."""
    assert text.startswith("\ufeff")
    rows = list(csv.reader(io.StringIO(text[1:]), delimiter=";"))
    assert not [cell for row in rows for cell in row if re.fullmatch(r"-?\d+\.\d+(e.*)?", cell)]
    comma = re.compile(r"-?\d+(,\d+)?(e[-+]\d+)?")
    return [[float(cell.replace(",", ".")) if comma.fullmatch(cell) else cell for cell in row] for row in rows]


SPEC = CONFIGS / "default.toml"
ACTS = "a\x1b[31m\x07\x9b2J\x7f\u202eb\u2066\ufeff\x00\r\n\udcff\U000e0041"
ACTING = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069\ufeff\ud800-\udfff]")


def test_what_is_printable_stays():
    for text in ("T_н = 5 kN·m, ΔT ≤ 2 °C", "Müller 漢字 😀", "", "a\u00a0b\u2009c"):
        assert printable(text) == text
    shown = printable(ACTS)
    assert shown.isascii()
    assert shown.isprintable()


@pytest.mark.parametrize("name", FORMATS)
@pytest.mark.parametrize("terminal", [False, True])
def test_no_format_lets_a_text_act(name, terminal):
    result, _ = compare([build(read_spec(SPEC))])
    result = result.model_copy(update={"clutches": [result.clutches[0].model_copy(update={"name": ACTS})]})
    output = Output("compare", "1", {"name": ACTS, "variant": ACTS}, result, [Finding("info", "x", ACTS, path=ACTS)])
    text = renderer(name)(output, terminal)
    if terminal:
        text = re.sub("\x1b\\[[\\d;]*m", "", text)  # colours of our own
        assert "[31m" in text
    assert not ACTING.search(text)


def test_arguments_and_keys_are_shown_escaped(afmcalc):
    for arguments in (
        ["torque", f"{ACTS}.toml"], ["torque", f"--{ACTS}"], [ACTS], ["torque", "--set", f"{ACTS}=1"],
        ["accuracy", "--sweep", ACTS], ["solve", f"{ACTS}=1"], ["plot", "paper", ACTS], ["schema", ACTS],
    ):  # fmt: skip
        run = afmcalc(*arguments)
        assert run.code in (2, 3)
        assert not ACTING.search(run.err)
        assert "a\\" in run.err


def test_no_cell_of_csv_is_a_formula(answered):
    for name in ("=1+1", "+x", "-x", "@SUM(A1)"):
        run = answered("compare", SPEC, "--set", f'name="{name}"', "--format", "csv")
        ((shown, *numbers),) = list(csv.reader(io.StringIO(run.out)))[1:]
        assert shown == f"'{name}"
        assert float(numbers[1]) == 2000


def test_a_name_is_no_markup(answered):
    run = answered("torque", "--set", "name=<b>|x|*_`[bold]y[/]", "--format", "markdown")
    assert "## torque: \\<b\\>\\|x\\|\\*\\_\\`\\[bold\\]y\\[/\\]" in run.out
    assert "[bold]y[/]" in answered("torque", "--set", "name=[bold]y[/]").out


SMALL = ["--set", "tolerance.samples=2000", "--set", "tolerance.sobol_base=64"]
STUDY = ["tolerance", CONFIGS / "tolerance.toml", *SMALL]
FRONT = ["design", CONFIGS / "requirements.toml", "--set", "search.friction_group.pairs=[8, 10]"]
FRONT += ["--set", "search.control_unit.gain=[0.4, 0.5, 0.6]"]


class Row(Result):
    name: str = described("name")
    width: float = quantity("m", "w", "width", detail=True)


class Rows(Result):
    rows: list[Row] = described("rows")


def test_a_table_of_more_than_three_rows_leaves_its_details_out():
    for count in (1, 3, 4):
        (table,) = blocks(document(Rows(rows=[Row(name=f"n{number}", width=number) for number in range(count)])))
        assert ("w, mm" in table.header, len(table.rows)) == (count <= 3, count)


def test_significant_figures():
    assert [significant(x) for x in (0, 1, 118.518518, -0.000123456, 1e-12, 123456.7, 1e7, 99999.6)] == [
        "0", "1", "118.52", "-0.00012346", "1e-12", "123460", "1e+07", "100000",
    ]  # fmt: skip


NUMBERS = st.one_of(st.integers(-(10**6), 10**6), st.floats(-1e12, 1e12), st.floats(1e-9, 1.0))


@given(st.lists(NUMBERS, min_size=1, max_size=6), st.booleans(), st.sampled_from(["x", "a heading that is wide"]))
def test_points_stand_below_points(values, none, heading):
    cells = [significant(value) for value in values] + (["–"] if none else [])
    table = padded(TextTable("", [heading], [[cell] for cell in cells], [True]))
    texts = [row[0] for row in table.rows]
    assert len(set(map(len, (table.header[0], *texts)))) == 1
    assert [text.strip() for text in texts] == cells
    assert len({re.search(r"[\d–](?=\D|$)", text).end() for text in texts}) == 1


@given(st.one_of(st.just(0.0), st.floats(1e-12, 1e15)), st.floats(1e-8, 0.3))
def test_an_estimate_says_what_is_known(value, share):
    """The error has two digits, and the value ends at the same place."""
    error = share * (value or 1.0)
    text = estimate(value, error, "1")
    shown, wide, power = re.fullmatch(r"\(?([\d.]+) ± ([\d.e+-]+?)\)?(e[+-]\d+)?", text).groups()
    power = float("1" + (power or "e0"))
    assert math.isclose(float(wide) * power, error, rel_tol=0.051)
    assert abs(float(shown) * power - value) <= 0.051 * error * 10
    if value:
        assert len(shown.partition(".")[2]) == len(wide.partition(".")[2]), text
        digits = wide.replace(".", "").lstrip("0")
        assert len(digits) == 2 if "." in wide else len(digits.rstrip("0")) <= 2


def test_estimates_of_a_study_carry_their_errors(answered):
    found = answered(*STUDY, "--json").json["result"]
    table = answered(*STUDY).out
    assert estimate(found["mean"], found["mean_standard_error"], "N*m") in table
    assert all(estimate(row["torque"], row["torque_standard_error"], "N*m") in table for row in found["quantiles"])
    rows = list(csv.DictReader(io.StringIO(answered(*STUDY, "--format", "csv").out)))
    cells = {(row["quantity"], row["of"]): row for row in rows}
    assert len(cells) == len(rows)
    assert float(cells["mean", ""]["value"]) == found["mean"]
    assert float(cells["mean", ""]["standard_error"]) == found["mean_standard_error"]
    assert cells["quantiles.torque", "0.5"]["unit"] == "N*m"
    assert cells["inputs.spread", "fatigue.endurance_limit"]["unit"] == "Pa"
    assert float(cells["sobol.total", "friction"]["value"]) == found["sobol"][0]["total"]


def test_variants_stand_side_by_side(answered):
    """What is kept equal stands above the numbers of the variants."""
    compare = "compare", CONFIGS / "indirect.toml", "--variants"
    rows = answered(*compare, "--json").json["result"]["clutches"]
    lines = answered(*compare).out.splitlines()
    (kept,) = (line for line in lines if line.split()[:2] == ["kept", "equal"])
    assert kept.split()[2:] == ["spring", "force"] * 4 + ["nominal", "torque"] * 4
    (shown,) = (line.split()[-9:-1] for line in lines if line.startswith("K_T  "))
    assert shown == [display(row["accuracy_factor"], "1") for row in rows]


@pytest.mark.parametrize("width", [40, 80, 120])
def test_columns_that_do_not_fit_stand_in_a_table_of_their_own(width, afmcalc, answered, monkeypatch):
    """Each row there has its number; no word is lost or broken, and in a pipe nothing is folded."""
    data = answered(*FRONT, "--json").json["result"]["front"]
    monkeypatch.setenv("COLUMNS", str(width))
    narrow = afmcalc(*FRONT).out
    lines = narrow.splitlines()
    assert max(map(len, lines)) <= width
    assert not re.search("[─━│┃\x1b]", narrow)
    heads = [number for number, line in enumerate(lines) if line.startswith("no. ")]
    assert len(heads) == {40: 3, 80: 2, 120: 1}[width]
    for head in heads:
        assert [int(line.split()[0]) for line in lines[head + 1 : head + 1 + len(data)]] == [
            row["number"] for row in data
        ]
    (head,) = (head for head in heads if "K_T" in lines[head])
    shown = [line.split() for line in lines[head + 1 : head + 1 + len(data)]]
    factors = [display(row["accuracy_factor"], "1") for row in data]
    assert [factor in row for factor, row in zip(factors, shown, strict=True)] == [True] * len(data)
    assert set(answered(*FRONT).out.split()) == set(narrow.split())


NARROW = {
    "check": [CONFIGS / "indirect.toml"], "torque": [CONFIGS / "indirect.toml", "--details"],
    "overload": [CONFIGS / "default.toml"], "compare": [CONFIGS / "indirect.toml", "--variants"],
    "layout": [CONFIGS / "envelope.toml"], "tolerance": STUDY[1:],
}  # fmt: skip


@pytest.mark.parametrize("command", ["check", "compare", *slow("torque", "overload", "layout", "tolerance")])
def test_a_narrow_table_has_every_number_and_key_whole(command, afmcalc, monkeypatch):
    def whole(width):
        monkeypatch.setenv("COLUMNS", str(width))
        out = afmcalc(command, *NARROW[command]).out
        assert max(map(len, out.splitlines())) <= width
        assert "…\n" not in out
        return collections.Counter(re.findall(r"\d+\.\d+|\b[a-z_]+\.[a-z_]*[a-z]\b", out))

    narrow, wide = whole(60), whole(300)
    assert narrow >= wide, "what tells the rows stands in each part of a table"
    assert set(narrow) == set(wide)


ASKED = {
    "torque": "indirect", "pocket": "indirect", "accuracy": "unlike-materials", "adjust": "all-driving",
    "life": "default",
}  # fmt: skip


@pytest.mark.parametrize("command", ASKED)
def test_every_number_shown_in_si_is_one_of_the_result(command, answered):
    path = CONFIGS / f"{ASKED[command]}.toml"
    known = list(numbers(answered(command, path, "--json").json["result"]))
    table = answered(command, path, "--units", "si").out.partition("\nwarning:")[0].partition("\ninfo:")[0]
    words = [cell for line in table.splitlines()[3:] for cell in re.split(r"\s{2,}", line)]
    shown = [float(word) for word in words if re.fullmatch(r"-?[\d.]+(e[+-]\d+)?", word)]
    assert len(shown) >= 4
    assert all(any(abs(each - value) <= 1e-4 * abs(value) for value in known) for each in shown)
    # a ball is ordered by its millimetres
    assert not re.search(r"\b(kN|mm|MPa|deg|N/mm)\b", re.sub(r"ball \S+ mm, ISO", "", table))
    assert answered(command, path).out == answered(command, path, "--units", "engineer").out


def test_json_for_an_ascii_stream_says_the_same(answered):
    arguments = "torque", CONFIGS / "default.toml", "--json", "--set", 'name="Муфта 😀 ½"'
    whole, spelled = answered(*arguments), answered(*arguments, encoding="ascii")
    assert spelled.out.isascii()
    assert json.loads(spelled.out) == json.loads(whole.out)


def symbols():
    """Yield symbol and unit of every field of a result, and of every key of a spec."""
    assert all(analysis.result_class for analysis in ANALYSES.values())  # imports them

    def classes(base):
        for each in base.__subclasses__():
            yield from (each, *classes(each)) if each.__module__.startswith("afmcalc") else ()

    for field in (field for each in (*classes(Result), *classes(Block)) for field in each.model_fields.values()):
        more = field.json_schema_extra if isinstance(field.json_schema_extra, dict) else {}  # of a spec
        yield shown_as(field).symbol or more.get("symbol"), shown_as(field).unit
    yield from ((key.symbol, key.unit) for key in keys().values())


def test_a_symbol_has_one_unit_and_a_spelling_of_its_own():
    """F_п, of the spring, and F_p, the release force, stand in one table and must differ also in Latin letters."""
    units = collections.defaultdict(set)
    for symbol, unit in symbols():
        units[symbol] |= {unit} if symbol and unit else set()
    known = set(filter(None, units))
    assert len(known) > 90
    assert [symbol for symbol in known if len(units[symbol]) > 1] == []
    latin = {native(symbol) for symbol in known}
    assert len(latin) == len(known)
    assert not [symbol for symbol in latin if re.search("[а-яА-Я]", symbol)]
