"""Tables for people: one symbol for one thing, points below points, engineer's units, nothing cut."""

import collections
import csv
import io
import math
import re
from types import SimpleNamespace

import pytest
from conftest import CONFIGS
from hypothesis import given
from hypothesis import strategies as st

from afmcalc.analysis.registry import ANALYSES
from afmcalc.messages import language, speaking, translate
from afmcalc.render.document import document
from afmcalc.render.layout import TextTable, blocks, padded, told_apart
from afmcalc.render.units import display, estimate, significant
from afmcalc.render.verdict import SENTENCES
from afmcalc.result import Result, described, quantity, shown_as
from afmcalc.spec.keys import keys

ANGLE = (
    'tolerance.fields={"control_unit.wall_angle" = {distribution="triangular", min="19 deg", max="22 deg"}, '
    '"closing_spring.force" = {distribution="normal", spread="5 %"}}'
)
SMALL = ["--set", "tolerance.samples=2000", "--set", "tolerance.sobol_base=64"]
STUDY = ["tolerance", CONFIGS / "tolerance.toml", *SMALL]
ANGLED = [*STUDY, "--set", "control_unit.gain=", "--set", "control_unit.wall_angle=20 deg", "--set", ANGLE]
FRONT = ["design", CONFIGS / "requirements.toml", "--set", "search.pairs=[8, 10]"]
FRONT += ["--set", "search.gain=[0.4, 0.5, 0.6]"]


def classes(kind=Result):
    for each in kind.__subclasses__():
        yield each
        yield from classes(each)


def test_a_symbol_has_one_unit_everywhere():
    assert all(analysis.result_class for analysis in ANALYSES.values())  # imports them
    units = collections.defaultdict(set)
    own = (each for each in classes() if each.__module__.startswith("afmcalc"))
    for info in (info for each in own for info in each.model_fields.values()):
        units[shown_as(info).symbol].add(shown_as(info).unit or None)
    for key in keys().values():
        units[key.symbol].add(key.unit)
    # what stands for an error, or tells one part of a result from another, is no quantity
    assert not {symbol: found for symbol, found in units.items() if symbol and len(found - {None}) > 1}
    assert len(units) > 90


RUNS = {
    "accuracy": [CONFIGS / "indirect.toml"], "adjust": [CONFIGS / "default.toml"], "life": [CONFIGS / "default.toml"],
    "overload": [CONFIGS / "default.toml"], "synthesize": [CONFIGS / "indirect.toml"], "tolerance": STUDY[1:],
}  # fmt: skip


@pytest.mark.parametrize("command", RUNS)
def test_no_symbol_stands_twice_in_a_table(command, answered):
    run = answered(command, *RUNS[command], "--format", "markdown")
    tables = [part for part in run.out.split("\n\n") if part.startswith("| Symbol |")]
    symbols = [line.split("|")[1].strip() for table in tables for line in table.splitlines()[2:]]
    assert len(symbols) > 4
    assert not [symbol for symbol, count in collections.Counter(symbols).items() if symbol and count > 1]


class Row(Result):
    name: str = described("name")
    width: float = quantity("m", "w", "width", detail=True)


class Rows(Result):
    rows: list[Row] = described("rows")


@pytest.mark.parametrize("count", [1, 3, 4])
def test_a_table_of_more_than_three_rows_leaves_its_details_out(count):
    (table,) = blocks(document(Rows(rows=[Row(name=f"n{number}", width=number) for number in range(count)])))
    assert ("w, mm" in table.header) == (count <= 3)
    assert len(table.rows) == count


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
    """Its error to two digits, the value to the same place."""
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
    assert all(estimate(row["torque"], row["standard_error"], "N*m") in table for row in found["quantiles"])
    rows = list(csv.DictReader(io.StringIO(answered(*STUDY, "--format", "csv").out)))
    cells = {(row["quantity"], row["of"]): row for row in rows}
    assert len(cells) == len(rows)
    assert float(cells["mean", ""]["value"]) == found["mean"]
    assert float(cells["mean", ""]["standard_error"]) == found["mean_standard_error"]
    assert cells["quantiles.torque", "0.5"]["unit"] == "N*m"
    assert cells["inputs.spread", "fatigue.endurance_limit"]["unit"] == "Pa"
    assert float(cells["sobol.total", "friction"]["value"]) == found["sobol"][0]["total"]


def test_units_are_the_engineers(answered):
    table = answered(*ANGLED).out
    angle = next(line for line in table.splitlines() if line.startswith("control_unit.wall_angle"))
    assert angle.split() == ["control_unit.wall_angle", "triangular", "19", "20", "22", "1.5", "deg"]
    solved = answered("solve", "--for", "R", "torque_max=300").out
    assert re.search(r"value found +89\.062 +mm", solved)
    assert not re.search(r"(?<![\w·])(rad|Pa|SI|m)\b", table + solved)


def test_variants_stand_side_by_side(answered):
    """In a table for each of what is kept equal."""
    compare = "compare", CONFIGS / "indirect.toml", "--variants"
    rows = answered(*compare, "--json").json["result"]["clutches"]
    lines = answered(*compare).out.splitlines()
    titles = [line for line in lines if line.startswith("Clutches compared")]
    assert [title.endswith("kept equal: nominal torque)") for title in titles] == [False, True]
    shown = [line.split()[-5:-1] for line in lines if line.startswith("K_т  ")]
    assert shown == [[display(row["accuracy_factor"], "1") for row in part] for part in (rows[:4], rows[4:])]


@pytest.mark.parametrize("width", [40, 80, 200])
def test_records_that_do_not_fit_are_columns(width, afmcalc, answered, monkeypatch):
    data = answered(*FRONT, "--json").json["result"]["front"]
    monkeypatch.setenv("COLUMNS", str(width))
    lines = afmcalc(*FRONT).out.splitlines()
    assert max(map(len, lines)) <= width
    shown = [cell for row in lines if row.startswith("K_т ") for cell in re.findall(r" (\d+\.\d+)", row)]
    assert shown == ([display(row["accuracy_factor"], "1") for row in data] if width < 200 else [])


NARROW = {
    "check": [CONFIGS / "indirect.toml"], "torque": [CONFIGS / "indirect.toml", "--details"],
    "overload": [CONFIGS / "default.toml"], "compare": [CONFIGS / "indirect.toml", "--variants"],
    "layout": [CONFIGS / "envelope.toml"], "tolerance": STUDY[1:],
}  # fmt: skip


@pytest.mark.parametrize("command", NARROW)
def test_a_narrow_table_has_every_number_and_key_whole(command, afmcalc, monkeypatch):
    def whole(width):
        monkeypatch.setenv("COLUMNS", str(width))
        out = afmcalc(command, *NARROW[command]).out
        assert max(map(len, out.splitlines())) <= width
        assert "…\n" not in out
        return collections.Counter(re.findall(r"\d+\.\d+|\b[a-z_]+\.[a-z_]*[a-z]\b", out))

    assert whole(60) == whole(300)


def test_a_name_is_not_cut_off_a_terminal(answered):
    wide = answered("torque", "--set", f"name={'x' * 300}").out
    assert "x" * 300 in wide
    assert "\x1b" not in wide


def test_a_step_says_its_setting_only_where_another_differs():
    step = SimpleNamespace(function="f", symbol="T", setting="min-friction", side=None)
    other = SimpleNamespace(function="f", symbol="T", setting="mean-friction", side=None)
    assert told_apart(step, [step, step]) == []
    assert told_apart(step, [step, other]) == ["set at f_min"]
    assert told_apart(step, [step, SimpleNamespace(**vars(other) | {"symbol": "K"})]) == []


@pytest.mark.parametrize("name", ["default", "shishkarev2021"])
def test_check_begins_with_its_verdict_and_compare_tells_a_finding_once(name, answered):
    with speaking(language("ru")):
        sentences = tuple(translate(sentence) for sentence in SENTENCES.values())
    assert answered("check", f"example:{name}").out.splitlines()[1].startswith(tuple(SENTENCES.values()))
    assert answered("--lang", "ru", "check", f"example:{name}").out.splitlines()[1].startswith(sentences)
    run = answered("compare", f"example:{name}", f"example:{name}", "example:indirect")
    told = [line for line in run.out.splitlines() if re.match(r"(info|warning|error): ", line)]
    messages = [line.partition(": ")[2].partition(": ")[2] for line in told]
    assert len(set(messages)) == len(messages) > 0
