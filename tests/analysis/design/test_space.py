"""A design within a space, against a check of every candidate that is written."""

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
from afmcalc.engines import build
from afmcalc.errors import SpecError
from afmcalc.spec.requirements import make_requirements
from afmcalc.variants import VARIANTS

SPACE = {"disc_thickness": 0.003, "plate_thickness": 0.008, "housing_wall": 0.006, "bore": 0.03}
LIMITS = {"collisions": {}, "outer_diameter": {"outer_diameter": 0.24}, "length": {"length": 0.067}}
LIMITS["all"] = LIMITS["outer_diameter"] | LIMITS["length"]
SEARCH = {
    "pairs": [4, 7, 12],
    "mean_radius": [0.07, 0.085, 0.1, 0.11],
    "gain": [0.0, 0.4, 0.8, 1.2],
    "ball_circle_radius": [0.03, 0.04, 0.05, 0.06, 0.075],
    "closing_force": {"min": 100.0, "max": 1e5},
    "closing_stiffness": [1e5, 4e5],
    "control_stiffness": [5e4],
}
HUB = {"hub_diameter": 0.045, "key_friction": 0.01}


def wanted(variants, limits, **given):
    sleeve = "indirect" in variants
    return {
        "variants": variants,
        "objectives": ["closing_force", "accuracy_factor", "ball_diameter"],
        "friction": {"min": 0.1, "mean": 0.25, "max": 0.6},
        "wanted": {"nominal_torque": 150.0},
        "search": SEARCH,
        "fixed": {"face_width": 0.03, "face_gap": 0.001, "edge_clearance": 0.001, **(HUB if sleeve else {})},
        "envelope": {**SPACE, **LIMITS[limits], **({} if sleeve else {"hub_diameter": 0.045})},
        **given,
    }


def passes(spec):
    findings = Answers(build(spec)).ask("check")[1]
    return not any(each.level == "error" for each in findings)


@pytest.mark.parametrize("limits", LIMITS)
@pytest.mark.parametrize("variant", ["conventional", "differentiated", "indirect"])
def test_the_front_is_that_of_the_clutches_a_check_passes(variant, limits):
    data, kind = wanted([variant], limits), VARIANTS[variant]
    need, free = make_requirements(data), make_requirements({**data, "envelope": None})
    with np.errstate(all="ignore"):
        at = Axes(*np.array(list(itertools.chain(*(itertools.product(*laid) for laid in grids(need, kind))))).T)
        others = feasible(candidates(free, kind, at), np.ones(at.pairs.shape, bool))
        tried = candidates(need, kind, at.at(others))
        written = rows(tried)
        found = feasible(tried, np.ones(len(written), bool))
        values = objectives(tried)
    assert found.tolist() == [passes(as_spec(need, row)) for row in written]
    fitting = limits == "collisions" and variant == "conventional"
    assert 0 < found.sum() < found.size + fitting
    met = {tuple(float(f"{value:.9g}") for value in one) for one in values[found]}
    best = {one for one in met if not any(other != one and np.less_equal(other, one).all() for other in met)}
    result, _ = design(need)
    assert result.feasible == found.sum()
    front = [[row.objective(name) for name in need.objectives] for row in result.front]
    assert sorted(front) == pytest.approx(np.array(sorted(best)), rel=1e-8)


def test_between_the_grid_points_and_in_round_figures_it_fits():
    """Refined radii end at the wall of the housing, and no written clutch is beyond its space."""
    ranges = {"mean_radius": {"start": 0.07, "stop": 0.11, "count": 5}, "gain": {"start": 0.3, "stop": 1.2, "count": 4}}
    need = make_requirements(wanted(["differentiated", "indirect"], "all", search={**SEARCH, **ranges}))
    result, _ = design(need)
    assert max(row.outer_diameter for row in result.front) == pytest.approx(0.24 - 2 * 0.006)
    for number in {1, result.on_front // 2 + 1, result.on_front}:
        assert passes(with_picked(need, result, number)[1])


def test_what_is_missing_is_told():
    """A space too short by so much, as the nearest miss of a requirement."""
    result, _ = design(make_requirements(wanted(["conventional"], "all", envelope={
        **SPACE, "hub_diameter": 0.045, "length": 0.03})))  # fmt: skip
    (missed,) = (row for row in result.attainable if row.requirement == "length")
    assert (missed.limit, missed.best) == pytest.approx((0.03, 0.044))  # four plates and four discs
    assert result.front == []


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"envelope": SPACE}, "envelope.hub_diameter: required beside envelope"),
        ({"fixed": {"face_width": 0.03, **HUB}}, "envelope.hub_diameter = 0.045: excludes fixed.hub_diameter"),
        ({"fixed": {}}, "fixed.face_width: required beside envelope"),
    ],
)
def test_what_a_space_asks_for(given, says):
    with pytest.raises(SpecError, match=says):
        make_requirements(wanted(["differentiated"], "all", **given))
