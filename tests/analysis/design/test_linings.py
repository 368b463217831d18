"""Linings as a variable of the search, and a lining that is not known."""

import itertools
import tomllib

import pytest
from conftest import CONFIGS

from afmcalc.analysis.check import check
from afmcalc.analysis.design.design import attainable, design
from afmcalc.analysis.design.pick import with_picked
from afmcalc.engines import build
from afmcalc.spec import read_spec, to_toml
from afmcalc.spec.edit import resolved
from afmcalc.spec.requirements import make_requirements

BASE = {
    "variants": ["conventional", "differentiated", "all-driving"],
    "objectives": ["closing_force", "accuracy_factor", "pairs"],
    "wanted": {"nominal_torque": "200 N*m", "accuracy_factor": 2.2},
    "search": {
        "pairs": [4, 6, 8, 12],
        "mean_radius": {"start": "60 mm", "stop": "140 mm", "count": 9},
        "gain": [0.0, 0.3, 0.6, 0.9],
        "ball_circle_radius": ["40 mm", "50 mm"],
        "closing_force": {"min": "300 N", "max": "8 kN"},
    },
    "fixed": {"face_width": "30 mm"},
}
LININGS = ["moulded-dry", "чугун", "cork-dry"]


def need(**friction):
    return make_requirements({**BASE, "friction": friction})


def values(row):
    return [row.objective(name) for name in BASE["objectives"]]


def beaten(one, rows):
    """Whether another is no worse in anything, and better in something; numbers as alike as rounding makes them."""
    return any(
        all(a <= b * (1 + 1e-9) for a, b in zip(other, one, strict=True))
        and any(a < b * (1 - 1e-9) for a, b in zip(other, one, strict=True))
        for other in rows
    )


def test_the_front_of_several_linings_is_the_best_of_the_fronts_of_each():
    result, found = design(need(material=LININGS))
    alone = {name: design(need(material=name))[0] for name in LININGS}
    assert result.candidates == sum(each.candidates for each in alone.values())
    assert result.feasible == sum(each.feasible for each in alone.values())
    everything = {name: [values(row) for row in each.front] for name, each in alone.items()}
    every = [*itertools.chain(*everything.values())]
    wanted = sorted(
        (values(row), name) for name, each in alone.items() for row in each.front if not beaten(values(row), every)
    )
    got = sorted((values(row), row.material) for row in result.front)
    assert [name for _, name in got] == [name for _, name in wanted]
    for one, other in zip(got, wanted, strict=True):
        assert one[0] == pytest.approx(other[0], rel=1e-9)
    assert len({name for _, name in got}) > 1
    assert [each.code for each in found] == ["material"] * 3
    assert "чугун is read as metal-dry" in found[1].message


def test_what_excludes_and_what_could_be_had_tells_of_every_lining():
    tight = need(material=["moulded-dry", "чугун"])
    tight = tight.model_copy(update={"wanted": tight.wanted.model_copy(update={"accuracy_factor": 1.01})})
    (result, _), missed = design(tight), attainable(tight)
    assert not result.front
    alone = [tight.model_copy(update={"friction": need(material=name).friction}) for name in ("moulded-dry", "чугун")]

    def best(told):
        return min(row.best for row in told if row.requirement == "accuracy_factor" and not row.together)

    assert best(missed) == min(best(attainable(each)) for each in alone)
    assert result.excluded["accuracy_factor"] == sum(design(each)[0].excluded["accuracy_factor"] for each in alone)


def test_a_lining_that_is_not_known_is_the_range_of_all_under_the_least_pressure():
    unknown, found = design(need(material=["moulded-dry", "cork-dry"], unknown=True))
    assert {row.material for row in unknown.front} == {"moulded-dry, cork-dry"}
    assert [each.code for each in found] == ["material", "material", "lining-unknown"]
    given, _ = design(need(min=0.25, max=0.5))
    cork = 55e3

    def peak(row):
        inner, outer = row.mean_radius - 0.015, row.mean_radius + 0.015
        return row.closing_force / (2 * 3.141592653589793 * inner * (outer - inner))

    assert all(peak(row) <= cork * (1 + 1e-9) for row in unknown.front)
    assert any(peak(row) > cork for row in given.front)
    # what holds the pressure of cork is on both fronts, or beaten there by what does not
    held = [values(row) for row in given.front if peak(row) <= cork]
    both = [values(row) for row in unknown.front]
    for one in held:
        assert any(one == pytest.approx(other, rel=1e-9) for other in both)


@pytest.mark.parametrize("unknown", [False, True])
def test_a_pick_keeps_its_lining_and_the_list_it_is_from(unknown, tmp_path):
    text = (
        "name,description,condition,friction_min,friction_max,pressure_min_MPa,pressure_max_MPa,source,also\n"
        "F1,resin,dry,0.3,0.4,1,2,works,\nF2,felt,dry,0.2,0.3,0.5,0.8,works,войлок\n"
    )
    (tmp_path / "own.csv").write_text(text, encoding="utf-8")
    friction = {"material": ["F1", "войлок"], **({"unknown": True} if unknown else {})}
    wanted = make_requirements({**BASE, "friction": friction, "catalogues": {"materials": str(tmp_path / "own.csv")}})
    result, _ = design(wanted)
    for row in result.front[:: max(1, len(result.front) // 3)]:
        _, spec = with_picked(wanted, result, row.number)
        assert spec.friction.range[::2] == (
            (0.2, 0.4) if unknown else {"F1": (0.3, 0.4), "войлок": (0.2, 0.3)}[row.material]
        )
        (tmp_path / "picked.toml").write_text(to_toml(resolved(spec)), encoding="utf-8")
        again = read_spec(tmp_path / "picked.toml")
        assert again == spec
        assert again.lists.materials["F2"].source == "works"
        assert check(build(again))[0].passed


def test_unlike_linings_are_tried_in_pairs():
    base = {**BASE, "variants": ["differentiated"], "wanted": {"nominal_torque": "200 N*m"}}
    groups = {"driving": {"material": ["чугун", "wood-dry"]}, "driven": {"material": ["moulded-dry", "cork-dry"]}}
    result, _ = design(make_requirements({**base, "friction": groups}))
    pairs = itertools.product(groups["driving"]["material"], groups["driven"]["material"])
    parts = []
    for driving, driven in pairs:
        each = {"driving": {"material": driving}, "driven": {"material": driven}}
        parts.append(design(make_requirements({**base, "friction": each}))[0])
    assert result.candidates == sum(part.candidates for part in parts)
    every = [values(row) for part in parts for row in part.front]
    assert len(result.front) == sum(not beaten(one, every) for one in every)
    assert {(row.driving_material, row.driven_material) for row in result.front} <= {
        (row.driving_material, row.driven_material) for part in parts for row in part.front
    }


def test_the_example_takes_a_list():
    """Moulded has the larger f_min at the same f_max and pressure: less force, and a narrower band."""
    data = tomllib.loads((CONFIGS / "requirements.toml").read_text(encoding="utf-8"))
    data["friction"] = {"material": ["moulded-dry", "sintered-dry"]}
    assert {row.material for row in design(make_requirements(data))[0].front} == {"moulded-dry"}


def test_springs_are_chosen_from_a_list_of_ones_own(tmp_path):
    """DIN EN 16983 has no size bored 50 mm that is less than 100 mm wide."""
    rows = "name,outer_diameter_mm,inner_diameter_mm,thickness_mm,free_height_mm,source\nX 80,80,51,2.25,4.0,works\n"
    (tmp_path / "discs.csv").write_text(rows, encoding="utf-8")
    room = {"inner_diameter": "50 mm", "outer_diameter": "90 mm", "length": "80 mm"}
    data = {
        **BASE,
        "friction": {"material": "moulded-dry"},
        "springs": "disc",
        "fixed": {**BASE["fixed"], "closing_room": room},
    }
    shipped, _ = design(make_requirements(data))
    own, _ = design(make_requirements({**data, "catalogues": {"discs": str(tmp_path / "discs.csv")}}))
    assert {row.closing_part.partition(",")[0] for row in own.front} == {"X 80 (works)"}
    assert shipped.feasible == 0 < own.feasible
    _, spec = with_picked(make_requirements({**data, "catalogues": {"discs": str(tmp_path / "discs.csv")}}), own, 1)
    assert (spec.closing_spring.disc.outer_diameter, spec.catalogues.discs) == (0.08, str(tmp_path / "discs.csv"))
