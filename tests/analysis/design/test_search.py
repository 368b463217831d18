"""The search: Pareto fronts by definition, two ways through one space, and what lies between the grid points."""

import json
import math
import tomllib

import numpy as np
import pytest
from conftest import CONFIGS
from hypothesis import given, settings
from hypothesis import strategies as st

from afmcalc.analysis.design.design import design, refinement
from afmcalc.analysis.design.search import Survey, _culled, by_radius, by_tile, front, ranks, search, separable
from afmcalc.equations import synthesis
from afmcalc.laws import adjustment
from afmcalc.spec.requirements import make_requirements
from afmcalc.variants import VARIANTS

BASE = tomllib.loads((CONFIGS / "requirements.toml").read_text(encoding="utf-8"))


def need_of(**tables):
    """The example with tables changed, None: without the key."""
    data = json.loads(json.dumps(BASE))
    for name, value in tables.items():
        merged = {**data.get(name, {}), **value} if isinstance(value, dict) else value
        data[name] = {key: item for key, item in merged.items() if item is not None} if merged is not value else value
    return make_requirements(data)


def brute(points):
    """Indices by definition: nothing is at least as small everywhere and smaller somewhere, nor the same and earlier."""
    return [
        i for i, a in enumerate(points)
        if not any(all(x <= y for x, y in zip(b, a, strict=True)) and (b != a or j < i) for j, b in enumerate(points) if j != i)
    ]  # fmt: skip


@given(st.integers(1, 5), st.integers(0, 40), st.integers(1, 8), st.integers(0, 10_000))
def test_a_front_by_definition(objectives, size, levels, seed):
    """Whatever the way to it; and a unit in the last place decides nothing."""
    generator = np.random.default_rng(seed)
    points = generator.integers(1, levels + 1, (size, objectives)).astype(float)
    assert front(points).tolist() == brute(points.tolist())
    if size:
        ranked = np.stack([ranks(column) for column in points.T], axis=1)
        assert _culled(ranked).tolist() == brute(points.tolist())
    noisy = points * (1 + generator.integers(-2, 3, points.shape) * 2.0**-52)
    assert {tuple(row) for row in points[front(noisy)]} == {tuple(row) for row in points[front(points)]}
    distinct = generator.random((size, objectives))
    assert front(distinct).tolist() == brute(distinct.tolist())


def test_a_front_of_many_levels():
    points = np.random.default_rng(1).random((300, 3))
    assert front(points).tolist() == brute(points.tolist())


@st.composite
def wide(draw):
    """Requirements of which every bound holds up to one radius, or from one radius on; limits that bite now and then."""
    maybe = lambda low, high: draw(st.one_of(st.none(), st.floats(low, high)))  # noqa: E731
    some = lambda low, high, most=3: draw(st.lists(st.floats(low, high), min_size=1, max_size=most, unique=True))  # noqa: E731
    angle, both = draw(st.booleans()), draw(st.booleans())
    material = draw(st.sampled_from([None, "cork-dry", "woven-dry"]))
    return need_of(
        friction={"min": None, "mean": None, "max": None, "material": material} if material else {},
        variants=draw(st.lists(st.sampled_from(["conventional", "differentiated", "all-driving", "indirect"]), min_size=1, unique=True)),
        objectives=["closing_force", *draw(st.lists(st.sampled_from(["accuracy_factor", "ball_diameter", "travel", "control_deflection"]), unique=True))],
        wanted={"accuracy_factor": maybe(2, 8), "torque_max": maybe(300, 1500), "method": draw(st.sampled_from(["min-friction", "mean-friction"]))},
        search={
            "pairs": [4, 9], "driving_pairs": [1, 2], "closing_force": {"min": draw(st.floats(100, 1000)), "max": draw(st.floats(2000, 80000))},
            "mean_radius": None if both else some(0.03, 0.2, 9), "inner_radius": [0.02, *some(0.03, 0.1, 1)] if both else None,
            "outer_radius": [*some(0.04, 0.25, 9), 0.25] if both else None, "gain": None if angle else [*some(0.05, 2), 0.0],
            "wall_angle": some(0.1, 1.2) if angle else None, "ball_circle_radius": some(0.03, 0.1),
            "closing_stiffness": some(1e4, 5e5, 2), "control_stiffness": some(1e4, 5e5, 2),
        },
        fixed={"hub_diameter": 0.06, "key_friction": 0.02, "face_gap": 5e-4, "edge_clearance": 5e-4, "face_width": None if both else 0.02},
        limits={
            "surface_pressure": draw(st.floats(1e5, 3e6)), "outer_diameter": maybe(0.15, 0.5), "contact_force": maybe(500, 5000),
            "travel": maybe(1e-3, 0.1), "reduced_gain": maybe(2, 10), "gain_limit": draw(st.booleans()),
        },
    )  # fmt: skip


@settings(max_examples=10)
@given(wide())
def test_two_ways_through_one_space(need):
    """Looking the radii up gives what evaluating all of them gives, exclusions included."""
    found = []
    for way in (by_radius, by_tile):
        survey = Survey()
        for variant in (VARIANTS[name] for name in need.variants):
            if separable(need, variant):
                way(need, variant, survey, lambda done: None)
        survey.settle()
        rows = sorted(row for member in survey.members for row in member.values.tolist())
        found.append((survey.candidates, survey.feasible, +survey.excluded, rows))
    assert found[0][:3] == found[1][:3]
    assert np.array(found[0][3]) == pytest.approx(np.array(found[1][3]), rel=1e-12)


SPRINGS = {"closing_stiffness": [1e4, 2e5], "control_stiffness": {"start": 0, "stop": 1e5, "count": 3}}


@pytest.mark.parametrize("variant", ["conventional", "differentiated", "all-driving", "indirect"])
def test_no_point_of_a_finer_grid_beats_what_is_refined(variant):
    """Nor is any row worse than the grid point it comes from, or beaten by another of the front."""
    grids = {"mean_radius": ("60 mm", "140 mm"), "gain": (0.1, 2.5), "ball_circle_radius": ("30 mm", "60 mm")}

    def need(counts):
        ranges = {name: {"start": low, "stop": high, "count": count} for (name, (low, high)), count in zip(grids.items(), counts, strict=True)}  # fmt: skip
        return need_of(
            variants=[variant], objectives=["closing_force", "accuracy_factor"], search={**ranges, **SPRINGS, "pairs": 8, "driving_pairs": 1},
            wanted={"accuracy_factor": 9.0 if variant == "conventional" else 5.0, "torque_max": None}, limits={"contact_force": 3000, "outer_diameter": 0.27},
            fixed={"hub_diameter": 0.05, "key_friction": 0.05, "face_gap": 1e-3, "edge_clearance": 1e-3},
        )  # fmt: skip

    coarse, finer = need((4, 5, 2)), search(need((25, 33, 7)))
    values = lambda row: np.array([row.objective(name) for name in coarse.objectives])  # noqa: E731
    both, best = refinement(coarse, search(coarse)), np.array([values(row) for row in design(coarse)[0].front])
    points = np.concatenate([member.values for member in finer.members])
    for grid, fine in both:
        own = values(fine)
        assert (own <= values(grid) * (1 + 1e-9)).all()
        assert not ((points <= own * (1 + 1e-9)).all(axis=1) & (points < own * (1 - 1e-6)).any(axis=1)).any()
        assert (best <= own * (1 + 1e-8)).all(axis=1).any()
    assert all((best <= one * (1 + 1e-12)).all(axis=1).sum() == 1 for one in best)


def test_refinement_reaches_the_closed_inverse():
    """All-driving, least force for K_т ≤ 2.9: C from the inverse, R at its end, F from the law."""
    need = need_of(
        variants=["all-driving"], objectives=["closing_force"], wanted={"accuracy_factor": 2.9, "torque_max": None},
        search={"pairs": [8], "gain": {"start": 0.0, "stop": 0.625, "count": 12}, "mean_radius": {"start": 0.1, "stop": 0.15, "count": 4},
                "ball_circle_radius": [0.06]},
        limits={"surface_pressure": None, "contact_force": None}, fixed={"face_gap": 0, "edge_clearance": 0},
    )  # fmt: skip
    ((grid, fine),) = refinement(need, search(need))
    gain = synthesis.gain_for_accuracy_factor(0, 8, 2.9, 0.1, 0.1, 0.8, 0.8)
    best = adjustment.closing_force(200, 1, 0.15 * 8 * 0.1 / (1 + 8 * gain * 0.1))
    assert grid.closing_force > best * 1.01, "the grid is beside the optimum"
    assert (fine.closing_force, fine.gain) == (pytest.approx(best, rel=1e-8), pytest.approx(gain, rel=1e-6))
    assert [row.closing_force for row in design(need)[0].front] == [fine.closing_force]


@pytest.mark.parametrize("steering", [{"gain": 2 * math.tan(math.radians(70))}, {"gain": None, "wall_angle": "70 deg"}])
def test_pockets_that_meet_between_balls_that_do_not(steering):
    """Walls of 70° open mouths of d/cos 70° − s tan 70° = 23.7 mm for a ball of 10 mm: 13 of them are 23.9 mm apart, 14 22.3."""
    for balls, feasible in ((13, 1), (14, 0)):
        need = need_of(
            variants=["all-driving"], objectives=["closing_force"], wanted={"accuracy_factor": None, "torque_max": None},
            search={"pairs": [8], "mean_radius": 0.1, "ball_circle_radius": [0.05], "ball_diameters": [0.01, 0.02],
                    "closing_force": {"min": 500, "max": 80000}, **steering},
            limits={"contact_force": 1e6, "surface_pressure": None, "reduced_gain": None, "gain_limit": False}, fixed={"balls": balls},
        )  # fmt: skip
        result, _ = design(need)
        assert (result.feasible, result.excluded.get("standard_ball", 0)) == (feasible, 1 - feasible)


SLEEVE = {"pairs": 8, "mean_radius": 0.12, "gain": 1.0, "ball_circle_radius": 0.05, "closing_stiffness": 4e5}


@pytest.mark.parametrize("variant", ["all-driving", "indirect"])
def test_a_ball_has_room_beside_the_hub(variant):
    """Of 30 mm on a circle of 100 mm: 70 mm."""
    space = {"disc_thickness": 0.003, "plate_thickness": 0.008, "housing_wall": 0.006, "bore": 0.03}
    for hub, feasible in ((0.0699, 1), (0.0701, 0)):
        own = (
            {"fixed": {"hub_diameter": hub, "key_friction": 0.01}}
            if variant == "indirect"
            else {"envelope": {**space, "hub_diameter": hub}}
        )
        need = need_of(
            variants=[variant], wanted={"accuracy_factor": None, "torque_max": None}, limits={"surface_pressure": None, "gain_limit": False},
            search={**SLEEVE, "control_stiffness": 2e5, "ball_diameters": [0.03], "closing_force": {"min": 1, "max": 1e6}}, **own,
        )  # fmt: skip
        assert design(need)[0].feasible == feasible


def test_a_constant_force_has_no_deflection_that_could_be_small():
    """It is best in K_т: both stay on the front."""
    need = need_of(
        variants=["indirect"], objectives=["control_deflection", "accuracy_factor"], wanted={"accuracy_factor": None, "torque_max": None},
        search={**SLEEVE, "control_stiffness": [0, 2e5], "closing_force": {"min": 1, "max": 1e6}}, limits={"surface_pressure": None},
        fixed={"hub_diameter": 0.05, "key_friction": 0.01},
    )  # fmt: skip
    stiff, constant = design(need)[0].front
    assert (stiff.control_stiffness, stiff.control_deflection) == (2e5, pytest.approx(stiff.control_force / 2e5))
    assert (constant.control_stiffness, constant.control_deflection) == (0, None)
