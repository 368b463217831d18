"""What a design tells beside its front: counts, the knee, neighbours, what to give up, the same in every format."""

import csv
import io
import re
import tomllib
from pathlib import Path

import numpy as np
import pytest
import tomli_w
from conftest import CONFIGS

import afmcalc as api
from afmcalc.analysis.design import limits
from afmcalc.analysis.design.design import with_neighbours
from afmcalc.analysis.design.rows import in_words
from afmcalc.analysis.design.similar import requirements_like
from afmcalc.analysis.requirements import JUDGED
from afmcalc.engines import build
from afmcalc.messages import language, speaking, translate
from afmcalc.spec import read_spec

FILE = CONFIGS / "requirements.toml"
BASE = tomllib.loads(FILE.read_text(encoding="utf-8"))
FEW = ["--set", "search.pairs=[8, 10, 12]", "--set", "search.mean_radius=[0.1, 0.12]"]


@pytest.fixture(scope="module")
def example():
    return api.design(BASE)


def numbers_in(text):
    """Numbers of the rows of a front's table: its first column, from its heading to the next blank line."""
    rows = text.replace("| ", "").split("\nno. ")[1].split("\n\n")[0].splitlines()
    return [int(row.split()[0]) for row in rows[1:] if row.split()[0].isdecimal()]


def test_the_front_is_the_same_in_every_format(answered, example):
    assert numbers_in(answered("design", FILE).out) == [*range(1, 41)]
    assert [row.number for row in example.front] == list(range(1, example.on_front + 1))
    front = answered("design", FILE, *FEW, "--json").json["result"]["front"]
    rows = list(csv.DictReader(io.StringIO(answered("design", FILE, *FEW, "--format", "csv").out)))
    assert [(int(row["number"]), float(row["closing_force [N]"])) for row in rows] == [(row["number"], row["closing_force"]) for row in front]  # fmt: skip
    assert numbers_in(answered("design", FILE, *FEW, "--top", 3, "--format", "markdown").out) == [1, 2, 3]
    few = answered("design", FILE, *FEW, "--sort", "torque_max", "--top", 3, "--json").json["result"]["front"]
    assert few == sorted(front, key=lambda row: row["torque_max"])[:3]
    assert answered("design", FILE, *FEW, "--sort", "closing_forc").code == 2


def test_each_variant_is_counted_as_if_it_were_alone(example):
    assert [each.variant for each in example.of_variants] == BASE["variants"]
    for each in example.of_variants:
        alone = api.design(BASE | {"variants": [each.variant]})
        assert alone.of_variants is None
        assert (each.candidates, each.feasible) == (alone.candidates, alone.feasible)
        assert {name: count for name, count in each.excluded.items() if count} == alone.excluded
        assert each.on_front == sum(row.variant == each.variant for row in example.front)


@pytest.mark.parametrize("pairs", [6, 8, 16])
def test_the_knee_is_farthest_from_the_line_between_the_ends(pairs):
    """Das, 1999: of two objectives, each over its range, by the distance of points from a line."""
    data = BASE | {"objectives": ["closing_force", "accuracy_factor"], "search": BASE["search"] | {"pairs": pairs}}
    result = api.design(data)
    at = np.array([[row.closing_force, row.accuracy_factor] for row in result.front])
    at = (at - at.min(axis=0)) / np.ptp(at, axis=0)
    along, away = at[-1] - at[0], at - at[0]
    assert result.knee == int(np.argmin(along[0] * away[:, 1] - along[1] * away[:, 0])) + 1 not in (1, result.on_front)
    assert [row.number for row in result.front if row.mark == "knee"] == [result.knee]
    single = api.design(data | {"objectives": ["closing_force"]})
    assert (single.knee, single.on_front) == (None, 1)


def test_a_neighbour_is_the_nearest_that_is_better_in_something(example):
    """Distances one by one: each objective in parts of its range over the front."""
    values = {row.number: {name: row.objective(name) for name in example.objectives} for row in example.front}
    spans = {name: np.ptp([each[name] for each in values.values()]) for name in example.objectives}
    for here in list(values)[::29]:
        now, told = values[here], with_neighbours(example, here)
        away = {number: sum(((each[name] - now[name]) / spans[name]) ** 2 for name in spans) for number, each in values.items()}  # fmt: skip
        better = [[away[number] for number in values if values[number][name] < now[name] * (1 - 1e-9)] for name in spans]  # fmt: skip
        numbers = {trade.number for trade in told.neighbours}
        nearest = sorted({min(each) for each in better if each})
        assert sorted(away[number] for number in numbers) == pytest.approx(nearest)
        for trade in told.neighbours:
            there, was = values[trade.number][trade.objective], now[trade.objective]
            assert (trade.value, trade.instead_of, trade.change) == pytest.approx((there, was, there / was - 1))
            assert trade.verdict == ("gains" if there < was else "gives up")
        for number in numbers:  # nothing on a front is a gain alone
            assert {trade.verdict for trade in told.neighbours if trade.number == number} == {"gains", "gives up"}


def test_neighbours_stand_beside_the_clutch(answered):
    asked = answered("design", FILE, *FEW, "--explain", "knee", "--json").json["result"]
    assert asked["explained"] == asked["knee"]
    shown = numbers_in(answered("design", FILE, *FEW, "--explain", "knee").out)
    assert set(shown) == {asked["knee"], *(trade["number"] for trade in asked["neighbours"])}
    assert answered("design", FILE, *FEW, "--explain", "2222").code == 2


def test_people_read_words_and_programs_names(example, answered):
    """Every constraint and objective has words, in both languages; what is searched is told in them."""
    bounds = set(re.findall(r'Constraint\(\s*"([a-z]\w+)"', Path(limits.__file__).read_text(encoding="utf-8")))
    bounds |= {"_".join(pair).replace(" ", "_") for pair in limits._IN_THE_WAY}
    assert set(example.excluded) <= bounds | {"pairs"}
    simulated = {name for name, how in JUDGED.items() if how.analysis in ("simulate", "heat", "tolerance", "life")}
    for name in bounds | simulated | {*limits.OBJECTIVES, "gain_threshold", "pairs", "springs"}:
        words = in_words(name)
        assert words != name, name
        with speaking(language("ru")):
            assert translate(words) != words, name
    for lang in ("en", "ru"):
        told = answered(
            "--lang",
            lang,
            "design",
            FILE,
            "--explain",
            "knee",
            "--misses",
            *FEW,
            "--set",
            "search.gain=[0.4, 0.6, 0.8]",
        ).out
        assert not re.search(r"\b[a-z]{3,}_[a-z]{3,}", re.sub(r"\b(wanted|limits|search)\.[\w.]+", "", told))


@pytest.mark.parametrize("format_", ["table", "markdown", "csv", "json"])
def test_that_there_is_no_candidate_is_said_once(format_, afmcalc, tmp_path):
    """To people: on standard error, with the exit code; as data: in the JSON. Nothing is written."""
    none = ["design", FILE, "--set", "wanted.accuracy_factor=1.01", "--set", "search.mean_radius=0.1"]
    run = afmcalc(*none, "--format", format_)
    assert (run.code, run.err.count("error: "), run.out.count("no-candidate")) == (2, 1, format_ == "json")
    assert afmcalc(*none, "--pick", 1, "-o", tmp_path / "x.toml").code == 2
    assert not list(tmp_path.iterdir())


def test_what_is_missed_together_is_given_up_together(afmcalc):
    def design(*given):
        run = afmcalc("design", FILE, *FEW, *(f"--set={each}" for each in given), "--json")
        return run.json["result"]

    names = ["accuracy_factor", "surface_pressure"]
    result = design("wanted.accuracy_factor=1.01", "limits.surface_pressure=1 kPa")
    rows = result["attainable"]
    assert (result["front"], result["excluded"]["accuracy_factor"]) == ([], result["candidates"])
    assert [(row["requirement"], row["together"]) for row in rows] == [(name, " + ".join(names)) for name in names]
    assert design(*(f"{row['key']}={row['relax_to']!r}" for row in rows))["feasible"] == rows[0]["feasible"] > 0


def test_a_space_too_short_is_told_with_the_length_it_needs():
    """Four plates of 8 mm and four discs of 3 mm."""
    space = {"disc_thickness": 0.003, "plate_thickness": 0.008, "housing_wall": 0.006, "bore": 0.03, "hub_diameter": 0.045, "length": 0.03}  # fmt: skip
    data = {"variants": ["conventional"], "search": BASE["search"] | {"pairs": 4}, "wanted": {"nominal_torque": 100}, "envelope": space}  # fmt: skip
    result = api.design(BASE | data)
    (missed,) = (row for row in result.attainable if row.requirement == "length")
    assert (missed.limit, missed.best, result.front) == (0.03, pytest.approx(0.044), [])


def test_a_quick_look_says_so_and_what_it_lets_through_is_not_written(afmcalc):
    """One conventional clutch; its trip is hotter by far."""
    one = {"variants": '["conventional"]', "search.pairs": 6, "search.mean_radius": 0.06, "springs": "", "fixed.closing_room": "",
           "wanted.peak_torque": "", "wanted.accuracy_factor": "", "wanted.torque_max": "", "wanted.temperature": "40.01 degC",
           "drive.event": "", "drive.driven_inertia": 0.01, "drive.motor": "", "drive.motor_torque": 70, "heat.conductivity": ""}  # fmt: skip
    command = ["design", CONFIGS / "conveyor.toml", *(f"--set={path}={value}" for path, value in one.items()), "--no-simulate"]  # fmt: skip
    run = afmcalc(*command, "--json").json
    assert run["result"]["front"]
    assert "front-not-simulated" in {each["code"] for each in run["findings"]}
    assert afmcalc(*command, "--pick", 1).code == 2


@pytest.mark.parametrize("name", ["default", "indirect", "unlike-materials", "envelope", "machine-clutch"])
def test_a_clutch_is_found_by_what_it_answers(name):
    clutch = build(read_spec(f"example:{name}"))
    need = tomllib.loads(tomli_w.dumps(requirements_like(clutch)))
    assert need["variants"] == [clutch.spec.variant]
    assert api.design(need, simulate=False).front
