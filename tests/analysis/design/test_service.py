"""A design with requirements of service, against a check of every candidate that is written."""

import itertools

import numpy as np
import pytest

from afmcalc.analysis.answers import Answers
from afmcalc.analysis.design.candidates import candidates
from afmcalc.analysis.design.design import design
from afmcalc.analysis.design.limits import feasible, objectives
from afmcalc.analysis.design.pick import with_picked
from afmcalc.analysis.design.rows import as_spec, rows
from afmcalc.analysis.design.space import Axes, grids
from afmcalc.analysis.springs.springs import ranked
from afmcalc.engines import build
from afmcalc.errors import SpecError
from afmcalc.spec.edit import with_values
from afmcalc.spec.requirements import make_requirements
from afmcalc.variants import VARIANTS

SEARCH = {
    "pairs": [7],
    "inner_radius": [0.06, 0.08],
    "outer_radius": [0.1, 0.12],
    "gain": [0.0, 0.5, 0.9],
    "ball_circle_radius": [0.05, 0.07],
    "closing_force": {"min": 100.0, "max": 1e5},
    "closing_stiffness": [1e5, 3e5],
    "control_stiffness": [0.0, 5e4],
    "ball_diameters": [0.01, 0.0127, 0.015, 0.02, 0.0254, 0.03],
}
BLOCKS = {
    "fatigue": {"endurance_limit": 14e6, "polar_section_modulus": 15e-6, "exponent": 6, "base_cycles": 1e7,
                "ultimate_strength": 40e6},
    "heat": {"lining": 5e-4},
    "drive": {"dynamic_factor": 1.3},
}  # fmt: skip
NAMES = ["accuracy_factor_hysteresis", "cycles", "torque_after_wear", "contact_pressure"]
SERVICE = {
    "all-driving": dict(zip(NAMES, (2.7, 2.2e6, 66.0, 2e9), strict=True)),
    "indirect": dict(zip(NAMES, (3.5, 9e6, 66.0, 2e9), strict=True)),
    "constant-torque": dict(zip(NAMES, (2.05, 1e7, 66.0, 2.3e9), strict=True)),
}
FIXED = {"constant-torque": {"pocket": "constant-torque"}}


def wanted(variant, service, fixed=None, **given):
    control = {"hub_diameter": 0.05, "key_friction": 0.06} if variant == "indirect" else {}
    return {
        "variants": [variant],
        "objectives": ["closing_force", "accuracy_factor", "ball_diameter"],
        "friction": {"min": 0.1, "mean": 0.25, "max": 0.6},
        "wanted": {"nominal_torque": 150.0, "method": "mean-friction", **service},
        "search": SEARCH,
        "fixed": {**control, **(fixed or {})},
        "limits": {"gain_limit": False},
        **BLOCKS,
        **given,
    }


def every(need, variant):
    """Columns of every point of the grid."""
    parts = [itertools.product(*laid) for laid in grids(need, variant)]
    return Axes(*np.array(list(itertools.chain(*parts))).T)


def held(need, row):
    """The smallest ball, 0 of none, with which a check of the row as written finds no error; None where it finds some."""
    spec = as_spec(need, row)
    if not row.gain or need.wanted.contact_pressure is None:
        return (row.ball_diameter or 0.0) if good(spec) else None
    sizes = need.search.ball_diameters.listed
    return next((size for size in sizes if good(with_values(spec, {"control_unit.ball_diameter": size}))), None)


def good(spec):
    result, findings = Answers(build(spec)).ask("check")
    return all(row.passed for row in result.requirements) and not any(each.level == "error" for each in findings)


@pytest.mark.parametrize("name", [*NAMES, "all"])
@pytest.mark.parametrize("case", SERVICE)
def test_the_front_is_that_of_the_clutches_a_check_passes(case, name):
    service = SERVICE[case] if name == "all" else {name: SERVICE[case][name]}
    variant, fixed = "indirect" if case == "constant-torque" else case, FIXED.get(case)
    need, kind = make_requirements(wanted(variant, service, fixed)), VARIANTS[variant]
    # a direct clutch has a stiffness where what its wear leaves is asked for
    plain = make_requirements(
        wanted(variant, {"torque_after_wear": 1e-9} if "torque_after_wear" in service else {}, fixed)
    )
    with np.errstate(all="ignore"):
        at = every(need, kind)
        # the other limits are judged in the tests of the search without service
        others = feasible(candidates(plain, kind, at), np.ones(at.pairs.shape, bool))
        tried = candidates(need, kind, at.at(others))
        written = rows(tried)
        found = feasible(tried, np.ones(len(written), bool))
        values = objectives(tried)
    sizes = [held(need, row) for row in written]
    assert found.tolist() == [size is not None for size in sizes]
    assert [row.ball_diameter or 0.0 for row, good in zip(written, found, strict=True) if good] == [
        size for size in sizes if size is not None
    ]
    assert 0 < found.sum() < found.size + (case == "constant-torque" and name == "cycles")
    met = [tuple(float(f"{value:.9g}") for value in one) for one in values[found]]
    best = {one for one in met if not any(other != one and np.less_equal(other, one).all() for other in met)}
    result, _ = design(need)
    assert result.feasible == found.sum()
    assert sorted(row.objective("closing_force") for row in result.front) == pytest.approx(
        sorted(row[0] for row in best), rel=1e-8
    )


@pytest.mark.parametrize("case", ["all-driving", "indirect"])
def test_between_the_grid_points_and_in_round_figures_a_check_passes(case):
    ranges = {
        "gain": {"start": 0.3, "stop": 0.9, "count": 4},
        "outer_radius": {"start": 0.1, "stop": 0.12, "count": 3},
    }
    need = make_requirements(wanted(case, SERVICE[case], search={**SEARCH, **ranges}))
    result, _ = design(need)
    for number in {1, result.on_front // 2 + 1, result.on_front}:
        assert good(with_picked(need, result, number)[1])
    exact = as_spec(need, result.front[0])
    told = {row.requirement: row.value for row in Answers(build(exact)).ask("check")[0].requirements}
    for name in NAMES[:3]:
        value = getattr(result.front[0], name)
        assert value == told[name] or value == pytest.approx(told[name], rel=1e-9)


@pytest.mark.parametrize(
    ("without", "says"),
    [
        ({"fatigue": None}, "fatigue = null: required beside wanted.cycles"),
        ({"heat": {"ambient": 293.15}}, "heat.lining: required beside wanted.torque_after_wear"),
        (
            {"wanted": {"nominal_torque": 150, "trips_per_hour": 5}, "heat": {"ambient": 293.15, "cooling": 2.5}},
            "wanted.temperature: required beside wanted.trips_per_hour, or a material",
        ),
        ({"search": {**SEARCH, "closing_stiffness": None}}, "closing_stiffness = null: required beside wanted.torque"),
    ],
)
def test_what_a_requirement_is_judged_by_is_asked_for(without, says):
    with pytest.raises(SpecError, match=says):
        make_requirements(wanted("all-driving", SERVICE["all-driving"], **without))


ROOMS = {
    "all-driving": {"closing_room": {"inner_diameter": 0.03, "outer_diameter": 0.09, "length": 0.04}},
    "indirect": {
        "closing_room": {"inner_diameter": 0.02, "outer_diameter": 0.08, "length": 0.08},
        "control_room": {"inner_diameter": 0.05, "outer_diameter": 0.2, "length": 0.3},
    },
}


@pytest.mark.parametrize(
    ("variant", "kind"), [(variant, kind) for variant in ROOMS for kind in ("coil", "any")] + [("all-driving", "disc")]
)
def test_springs_of_a_kind_are_those_that_springs_finds(variant, kind):
    """With a lining that is worn, for which the spring that follows the pack has to lengthen."""
    service = {"torque_after_wear": 66.0} if variant == "all-driving" else {}
    search = {**SEARCH, "closing_stiffness": [4e5, 6e6], "control_stiffness": [1e5], "outer_radius": [0.12]}
    data = wanted(variant, service, ROOMS[variant], springs=kind, search=search, heat={"lining": 2e-4})
    need, law = make_requirements(data), VARIANTS[variant]
    plain = make_requirements({**data, "springs": None, "fixed": wanted(variant, {})["fixed"]})
    with np.errstate(all="ignore"):
        at = every(need, law)
        others = feasible(candidates(plain, law, at), np.ones(at.pairs.shape, bool))
        if service:  # of the springs found, not of the softest that is searched
            others = np.ones(at.pairs.shape, bool)
        tried = candidates(need, law, at.at(others))
        written = rows(tried)
        found = feasible(tried, np.ones(len(written), bool))
    there = []
    for row in written:
        clutch = build(as_spec(need, row))
        options = {demand.name: ranked(demand, kind) for demand in clutch.spring_demands()}
        if service:
            left = 66.0 / clutch.torque_min
            options["closing"] = [one for one in options["closing"] if one.force_least >= left * one.force]
        there.append(all(options.values()))
    assert found.tolist() == there
    assert 0 < found.sum() < found.size
    result, findings = design(need)
    assert result.feasible == found.sum()
    kinds = {"coil" in row.closing_part for row in result.front}
    assert kinds == {"disc": {False}, "coil": {True}}.get(kind, kinds)
    assert good(with_picked(need, result, 1)[1])
