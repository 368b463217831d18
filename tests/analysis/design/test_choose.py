"""What helps to choose: what became of each variant, and the neighbours of a clutch on the front."""

import re
import tomllib
import warnings

import pytest
from conftest import CONFIGS
from sources import calls

from afmcalc.analysis.design.design import design, with_neighbours
from afmcalc.analysis.design.limits import _IN_THE_WAY, OBJECTIVES
from afmcalc.analysis.design.rows import in_words
from afmcalc.analysis.requirements import JUDGED
from afmcalc.messages import language, speaking, translate
from afmcalc.spec.requirements import make_requirements

BASE = tomllib.loads((CONFIGS / "requirements.toml").read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def example():
    return design(make_requirements(BASE))[0]


def test_each_variant_is_counted_as_if_it_were_alone(example):
    assert [each.variant for each in example.of_variants] == BASE["variants"]
    for each in example.of_variants:
        alone, _ = design(make_requirements(BASE | {"variants": [each.variant]}))
        assert alone.of_variants is None
        assert (each.candidates, each.feasible) == (alone.candidates, alone.feasible)
        assert {name: count for name, count in each.excluded.items() if count} == alone.excluded
        assert each.on_front == sum(row.variant == each.variant for row in example.front)


def test_a_neighbour_is_the_nearest_that_is_better_in_something(example):
    """Distances one by one: each objective in parts of its range over the front."""
    spans = {
        name: max(row.objective(name) for row in example.front) - min(row.objective(name) for row in example.front)
        for name in example.objectives
    }
    for here in example.front[::17]:

        def away(row, here=here):
            return sum(((row.objective(name) - here.objective(name)) / spans[name]) ** 2 for name in spans)

        told = with_neighbours(example, here.number)
        assert told.explained == here.number
        expected = set()
        for name in example.objectives:
            if better := [row for row in example.front if row.objective(name) < here.objective(name) * (1 - 1e-9)]:
                expected.add(min(map(away, better)))
        numbers = list(dict.fromkeys(trade.number for trade in told.neighbours))
        assert sorted(away(example.front[number - 1]) for number in numbers) == pytest.approx(sorted(expected))
        for trade in told.neighbours:
            there, now = (
                example.front[number - 1].objective(trade.objective) for number in (trade.number, here.number)
            )
            assert (trade.value, trade.instead_of, trade.change) == pytest.approx((there, now, there / now - 1))
            assert trade.verdict == ("gains" if there < now else "gives up")
        # nothing on a front is a gain alone
        for number in numbers:
            assert {trade.verdict for trade in told.neighbours if trade.number == number} == {"gains", "gives up"}


def test_neighbours_stand_beside_the_clutch(afmcalc):
    file = CONFIGS / "requirements.toml"
    told = afmcalc("design", file, "--explain", "knee")
    assert told.code == 0
    asked = afmcalc("design", file, "--explain", "knee", "--json").json["result"]
    assert asked["explained"] == asked["knee"]
    assert len(asked["front"]) == asked["on_front"]
    shown = {asked["knee"], *(trade["number"] for trade in asked["neighbours"])}
    rows = told.out.split("\nno. ")[1].split("\n\n")[0].splitlines()[1:]
    assert {int(row.split()[0]) for row in rows} == shown
    assert afmcalc("design", file, "--explain", "222").code == 2


def test_an_objective_that_is_infinite_in_all_says_nothing():
    """A constant force has no deflection: the front is that of the other objective, and no warning is printed."""
    search = {"closing_stiffness": 4e5, "control_stiffness": 0, "gain": [0.5, 1.0, 2.0], "pairs": 8}
    data = BASE | {
        "variants": ["indirect"], "objectives": ["control_deflection", "accuracy_factor", "closing_force"],
        "search": BASE["search"] | search, "fixed": BASE["fixed"] | {"hub_diameter": 0.05, "key_friction": 0.02},
        "wanted": {"nominal_torque": 200.0},
    }  # fmt: skip
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        result, _ = design(make_requirements(data))
        told = with_neighbours(result, 1)
    assert len(result.front) > 2
    assert {trade.objective for trade in told.neighbours} == {"accuracy_factor", "closing_force"}


def test_people_read_words_and_programs_names(example, afmcalc):
    """Every constraint and objective has words, in both languages; what is searched is told in them."""
    bounds = {node.args[0].value for _, node in calls("Constraint") if node.args and hasattr(node.args[0], "value")}
    bounds |= {"_".join(pair).replace(" ", "_") for pair in _IN_THE_WAY}
    answered = {name for name, how in JUDGED.items() if how.analysis in ("simulate", "heat", "tolerance", "life")}
    assert len(bounds) > 25
    for name in bounds | answered | {*OBJECTIVES, "gain_threshold", "pairs", "springs"}:
        words = in_words(name)
        assert words != name, name
        with speaking(language("ru")):
            assert translate(words) != words, name
    for lang in ("en", "ru"):
        run = afmcalc("--lang", lang, "design", CONFIGS / "machine.toml", "--explain", "knee", "--misses")
        told = re.sub(r"\b(wanted|limits|search|fixed|envelope)\.[\w.]+", "", run.out)
        assert not re.search(r"\b[a-z]{3,}_[a-z]{3,}", told)
    assert set(example.excluded) <= bounds | {"pairs"}
    assert example.objectives[0] == "closing_force"
