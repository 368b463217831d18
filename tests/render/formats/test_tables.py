"""Tables for people: one symbol for one thing, points below points, engineer's units, nothing cut."""

import collections
import csv
import io
import json
import math
import re

import pytest
from conftest import CONFIGS, slow
from hypothesis import given
from hypothesis import strategies as st

from afmcalc.analysis.registry import ANALYSES
from afmcalc.messages import native
from afmcalc.render.amounts import display, estimate, significant
from afmcalc.render.document import document
from afmcalc.render.text_tables import TextTable, blocks, padded
from afmcalc.result import Result, described, quantity, shown_as
from afmcalc.spec.fields import Block
from afmcalc.spec.keys import keys

from .test_formats import numbers

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
    """In a table for each of what is kept equal."""
    compare = "compare", CONFIGS / "indirect.toml", "--variants"
    rows = answered(*compare, "--json").json["result"]["clutches"]
    lines = answered(*compare).out.splitlines()
    titles = [line for line in lines if line.startswith("Clutches compared")]
    assert [title.endswith("kept equal: nominal torque)") for title in titles] == [False, True]
    shown = [line.split()[-5:-1] for line in lines if line.startswith("K_T  ")]
    assert shown == [[display(row["accuracy_factor"], "1") for row in part] for part in (rows[:4], rows[4:])]


@pytest.mark.parametrize("width", [40, 80, 120])
def test_columns_that_do_not_fit_stand_in_a_table_of_their_own(width, afmcalc, answered, monkeypatch):
    """Each with the number of its row; no word is lost or parted, and in a pipe nothing is folded."""
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
    """Symbol and unit of every field of a result, of every key of a spec and of requirements."""
    assert all(analysis.result_class for analysis in ANALYSES.values())  # imports them

    def classes(base):
        for each in base.__subclasses__():
            yield from (each, *classes(each)) if each.__module__.startswith("afmcalc") else ()

    for field in (field for each in (*classes(Result), *classes(Block)) for field in each.model_fields.values()):
        more = field.json_schema_extra if isinstance(field.json_schema_extra, dict) else {}  # of a spec
        yield shown_as(field).symbol or more.get("symbol"), shown_as(field).unit
    yield from ((key.symbol, key.unit) for key in keys().values())


def test_a_symbol_has_one_unit_and_a_spelling_of_its_own():
    """F_п, the spring's, and F_p, the release force, stand in one table; in ASCII and in Latin letters."""
    units = collections.defaultdict(set)
    for symbol, unit in symbols():
        units[symbol] |= {unit} if symbol and unit else set()
    known = set(filter(None, units))
    assert len(known) > 90
    assert [symbol for symbol in known if len(units[symbol]) > 1] == []
    latin = {native(symbol) for symbol in known}
    assert len(latin) == len(known)
    assert not [symbol for symbol in latin if re.search("[а-яА-Я]", symbol)]
