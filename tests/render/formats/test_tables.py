"""Tables for people: one symbol for one thing, points below points, engineer's units, estimates to their error."""

import collections
import csv
import io
import itertools
import math
import re
from types import SimpleNamespace

import pytest
from conftest import CONFIGS
from hypothesis import given
from hypothesis import strategies as st

from afmcalc.analysis.registry import ANALYSES
from afmcalc.messages import ENGLISH, language, speaking, translate
from afmcalc.render.layout import TextTable, padded, told_apart
from afmcalc.render.units import display, estimate, significant
from afmcalc.render.verdict import SENTENCES
from afmcalc.result import Result, shown_as
from afmcalc.spec.keys import keys

TOLERANCE = [
    "tolerance",
    CONFIGS / "tolerance.toml",
    "--set",
    "tolerance.samples=4000",
    "--set",
    "tolerance.sobol_base=64",
]
ANGLE = ["--set", "control_unit.gain=", "--set", "control_unit.wall_angle=20 deg"]
ANGLE += ["--set", 'tolerance.fields={"control_unit.wall_angle" = {distribution="triangular", min="19 deg", max="22 deg"}, '
          '"closing_spring.force" = {distribution="normal", spread="5 %"}}']  # fmt: skip


def classes(kind=Result):
    for each in kind.__subclasses__():
        yield each
        yield from classes(each)


def test_a_symbol_has_one_unit_everywhere():
    for analysis in ANALYSES.values():
        assert analysis.result_class
    units = collections.defaultdict(set)
    for each in classes():
        for info in each.model_fields.values():
            if symbol := shown_as(info).symbol:
                units[symbol].add(shown_as(info).unit or None)
    for key in keys().values():
        if key.symbol:
            units[key.symbol].add(key.unit)
    # what stands for an error, or tells one part of a result from another, is no quantity
    shared = {symbol: found for symbol, found in units.items() if len(found - {None}) > 1}
    assert not shared
    assert len(units) > 90


RUNS = {
    "torque": [CONFIGS / "indirect.toml"], "accuracy": [CONFIGS / "indirect.toml"], "adjust": [CONFIGS / "default.toml"],
    "life": [CONFIGS / "default.toml"], "overload": [CONFIGS / "default.toml"], "solve": ["accuracy_factor=2"],
    "synthesize": [CONFIGS / "indirect.toml"], "tolerance": TOLERANCE[1:], "compare": [CONFIGS / "default.toml"],
    "simulate": [CONFIGS / "drive.toml", "--set", "drive.motor_inertia=0.2"],
}  # fmt: skip


@pytest.mark.parametrize("command", RUNS)
def test_no_symbol_stands_twice_in_a_table(command, afmcalc):
    run = afmcalc(command, *RUNS[command], "--format", "markdown")
    assert run.code == 0, run.err
    tables = [part for part in run.out.split("\n\n") if part.startswith("| Symbol |")]
    rows = [line.split("|")[1].strip() for table in tables for line in table.splitlines()[2:]]
    symbols = [symbol for symbol in rows if symbol]
    assert len(symbols) > 4
    assert not [symbol for symbol, count in collections.Counter(symbols).items() if count > 1]


NUMBERS = st.one_of(st.integers(-(10**6), 10**6), st.floats(-1e12, 1e12), st.floats(1e-9, 1.0))


@given(st.lists(NUMBERS, min_size=1, max_size=6), st.booleans())
def test_points_stand_below_points(values, none):
    cells = [significant(value) for value in values] + (["–"] if none else [])
    found = padded(TextTable("", ["x"], [[cell] for cell in cells], [True])).rows
    texts = [row[0] for row in found]
    assert len(set(map(len, texts))) == 1
    assert [text.strip() for text in texts] == cells
    points = {re.search(r"[\d–](?=\D|$)", text).end() for text in texts}
    assert len(points) == 1


@given(st.one_of(st.just(0.0), st.floats(1e-12, 1e15)), st.floats(1e-8, 0.3))
def test_an_estimate_says_what_is_known(value, share):
    error = share * (value or 1.0)
    text = estimate(value, error, "1")
    matched = re.fullmatch(r"\(?([\d.]+) ± ([\d.e+-]+?)\)?(e[+-]\d+)?", text)
    assert matched, text
    shown, wide, power = matched.groups()
    power = float("1" + (power or "e0"))
    assert math.isclose(float(wide) * power, error, rel_tol=0.051)
    assert abs(float(shown) * power - value) <= 0.051 * error * 10
    if value:
        assert len(shown.partition(".")[2]) == len(wide.partition(".")[2]), text
        digits = wide.replace(".", "").lstrip("0")
        assert len(digits.rstrip("0")) <= 2


def test_estimates_of_a_study_carry_their_errors(afmcalc):
    found = afmcalc(*TOLERANCE, "--json").json["result"]
    table = afmcalc(*TOLERANCE).out
    assert estimate(found["mean"], found["mean_standard_error"], "N*m") in table
    for row in found["quantiles"]:
        assert estimate(row["torque"], row["standard_error"], "N*m") in table
    assert "standard error" not in table


def test_units_are_the_engineers(afmcalc):
    table = afmcalc(*TOLERANCE, *ANGLE).out
    angle = next(line for line in table.splitlines() if line.startswith("control_unit.wall_angle"))
    assert angle.split() == ["control_unit.wall_angle", "triangular", "19", "20", "22", "1.5", "deg"]
    assert "closing_spring.force" in table
    solved = afmcalc("solve", "--for", "R", "torque_max=300").out
    assert re.search(r"value found +89\.062 +mm", solved)
    for text in (table, solved):
        assert not re.search(r"(?<![\w·])(rad|Pa|SI|m)\b", text)
    row = afmcalc("solve", "--for", "c1", "accuracy_factor=3.2", CONFIGS / "indirect.toml")
    assert row.code == 2 or "N/mm" in row.out


def test_csv_of_a_study_has_every_figure(afmcalc):
    found = afmcalc(*TOLERANCE, "--json").json["result"]

    def numbers(part):
        if isinstance(part, dict | list):
            yield from itertools.chain.from_iterable(map(numbers, part.values() if isinstance(part, dict) else part))
        elif isinstance(part, float):
            yield part

    rows = list(csv.DictReader(io.StringIO(afmcalc(*TOLERANCE, "--format", "csv").out)))
    told = {float(cell) for row in rows for name in ("of", "value", "standard_error") if _is_number(cell := row[name])}
    assert set(numbers(found)) <= told
    cells = {(row["quantity"], row["of"]): row for row in rows}
    assert len(cells) == len(rows)
    assert float(cells["mean", ""]["value"]) == found["mean"]
    assert float(cells["mean", ""]["standard_error"]) == found["mean_standard_error"]
    assert cells["quantiles.torque", "0.5"]["unit"] == "N*m"
    assert cells["inputs.spread", "fatigue.endurance_limit"]["unit"] == "Pa"
    assert float(cells["sobol.total", "friction"]["value"]) == found["sobol"][0]["total"]


def _is_number(text):
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


def test_variants_stand_side_by_side(afmcalc, monkeypatch):
    monkeypatch.setenv("COLUMNS", "100")
    run = afmcalc("compare", CONFIGS / "indirect.toml", "--variants")
    lines = run.out.splitlines()
    assert max(map(len, lines)) <= 100
    heads = [line.split() for line in lines if "conventional " in line]
    assert [head[-4:] for head in heads] == [["conventional", "differentiated", "all-driving", "indirect"]] * 2
    rows = afmcalc("compare", CONFIGS / "indirect.toml", "--variants", "--json").json["result"]["clutches"]
    shown = [line.split()[-4:] for line in lines if line.startswith("K_т  ")]
    assert shown == [[display(row["accuracy_factor"], "1") for row in part] for part in (rows[:4], rows[4:])]
    assert [title for title in lines if title.startswith("Clutches compared")][1].endswith(
        "kept equal: nominal torque)"
    )


def test_clutches_of_one_name_are_called_by_their_files(afmcalc, tmp_path):
    files = [tmp_path / "a.toml", tmp_path / "b.toml", CONFIGS / "indirect.toml"]
    for file, gain in zip(files, ("0.5", "0.7"), strict=False):
        file.write_text((CONFIGS / "default.toml").read_text().replace("gain = 0.5", f"gain = {gain}"))
    names = [row["name"] for row in afmcalc("compare", *files, "--json").json["result"]["clutches"]]
    assert names[:2] == [str(file) for file in files[:2]]
    assert names[2].startswith("Indirect clutch")
    head = next(line for line in afmcalc("compare", *files).out.splitlines() if line.startswith("Symbol"))
    assert head.index("a.toml") < head.index("b.toml") < head.index("Indirect clutch")


@pytest.mark.parametrize("width", [40, 60, 80, 100, 200])
def test_records_that_do_not_fit_are_columns(width, afmcalc, monkeypatch):
    monkeypatch.setenv("COLUMNS", str(width))
    few = ["--set", "search.pairs=[8, 10]", "--set", "search.gain=[0.4, 0.5, 0.6]"]
    run = afmcalc("design", CONFIGS / "requirements.toml", *few)
    lines = run.out.splitlines()
    assert max(map(len, lines)) <= width
    rows = [line for line in lines if line.startswith("K_т ")]
    data = afmcalc("design", CONFIGS / "requirements.toml", *few, "--json").json["result"]["front"]
    if width < 200:
        shown = [cell for row in rows for cell in re.findall(r" (\d+\.\d+)", row)]
        assert shown == [display(row["accuracy_factor"], "1") for row in data]
    else:
        assert not rows


NARROW = {
    "check": ["indirect"], "torque": ["indirect", "--details"], "adjust": ["default"], "overload": ["default"],
    "heat": ["drive"], "life": ["default"], "compare": ["indirect", "--variants"], "layout": ["envelope"],
}  # fmt: skip


@pytest.mark.parametrize("command", NARROW)
def test_a_narrow_table_has_every_number_whole(command, afmcalc, monkeypatch):
    name, *options = NARROW[command]

    def numbers(width):
        monkeypatch.setenv("COLUMNS", str(width))
        out = afmcalc(command, CONFIGS / f"{name}.toml", *options).out
        assert max(map(len, out.splitlines())) <= width
        return collections.Counter(re.findall(r"\d+\.\d+", out))

    assert numbers(60) == numbers(80) == numbers(300)


def test_a_narrow_check_is_a_table(afmcalc, monkeypatch):
    """Each limit once, its text above its numbers; the heading once."""
    monkeypatch.setenv("COLUMNS", "60")
    lines = afmcalc("check", CONFIGS / "indirect.toml").out.splitlines()
    start = lines.index("check · condition")
    assert lines[start + 1].split() == ["value", "limit", "unit", "η", "verdict"]
    assert lines[start + 2] == "gain against key friction · C ≥ 2R f_1/d"
    assert lines[start + 3].split() == ["1", "0.04", "–", "0.04", "pass"]
    assert len(lines) < 70


def test_a_step_says_its_setting_only_where_another_differs():
    step = SimpleNamespace(function="f", symbol="T", setting="min-friction", side=None)
    other = SimpleNamespace(function="f", symbol="T", setting="mean-friction", side=None)
    assert told_apart(step, [step, step]) == []
    assert told_apart(step, [step, other]) == ["set at f_min"]
    assert told_apart(step, [step, SimpleNamespace(**vars(other) | {"symbol": "K"})]) == []


CLUTCHES = [path.stem for path in sorted(CONFIGS.glob("*.toml")) if "\nvariant = " in path.read_text(encoding="utf-8")]


@pytest.mark.every(6)
@pytest.mark.parametrize("name", CLUTCHES)
def test_check_begins_with_its_verdict_and_compare_tells_a_finding_once(name, afmcalc, monkeypatch):
    for lang in ("en", "ru"):
        monkeypatch.setenv("COLUMNS", "400")
        with speaking(language(lang) if lang == "ru" else ENGLISH):
            sentences = tuple(translate(sentence) for sentence in SENTENCES.values())
        run = afmcalc("--lang", lang, "check", f"example:{name}")
        assert run.out.splitlines()[1].startswith(sentences)
        if lang == "ru":
            assert "T_peak" not in run.out
    monkeypatch.delenv("COLUMNS")
    told = afmcalc("compare", f"example:{name}", f"example:{name}", "example:indirect").out.splitlines()
    codes = [re.search(r"\[[^]]*\]$", line) for line in told if re.match(r"(info|warning|error): ", line)]
    messages = [
        line.partition(": ")[2].partition(": ")[2] for line in told if re.match(r"(info|warning|error): ", line)
    ]
    assert all(codes)
    assert len(set(messages)) == len(messages)


@pytest.mark.parametrize("width", [60, 80, 100])
@pytest.mark.parametrize("lang", ["en", "ru"])
def test_a_key_is_never_broken(lang, width, afmcalc, monkeypatch):
    monkeypatch.setenv("COLUMNS", str(width))
    run = afmcalc("--lang", lang, *TOLERANCE)
    scattering = ("closing_spring.force", "friction_group.mean_radius", "control_unit.gain", "fatigue.endurance_limit")
    assert all(run.out.count(key) == 2 for key in scattering)
    assert max(map(len, run.out.splitlines())) <= width
