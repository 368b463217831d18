"""design against brute force through the engines, against the closed inverses, and its error paths."""

import contextlib
import csv
import io
import itertools
import json
import math
import os
import signal
import subprocess
import sys
import tomllib

import numpy as np
import pytest
from conftest import CONFIGS, ROOT, fewer
from hypothesis import assume, given
from hypothesis import strategies as st

from afmcalc.analysis.design.design import design, refinement, shown
from afmcalc.analysis.design.pick import with_picked
from afmcalc.analysis.design.search import Survey, by_radius, by_tile, front, separable
from afmcalc.analysis.design.search import search as searched
from afmcalc.analysis.overload import overload
from afmcalc.analysis.synthesize import synthesize
from afmcalc.engines import build
from afmcalc.equations import synthesis
from afmcalc.laws import adjustment
from afmcalc.spec import make_spec
from afmcalc.spec.edit import with_values
from afmcalc.spec.lists import diameters
from afmcalc.spec.requirements import make_requirements
from afmcalc.variants import VARIANTS

BASE = tomllib.loads((CONFIGS / "requirements.toml").read_text(encoding="utf-8"))
OBJECTIVES = [
    "closing_force", "accuracy_factor", "pairs", "ball_diameter", "travel",
    "control_force", "closing_deflection", "control_deflection",
]  # fmt: skip


def changed(**tables):
    data = json.loads(json.dumps(BASE))
    for name, value in tables.items():
        if isinstance(value, dict):
            merged = {**data.get(name, {}), **value}
            data[name] = {key: item for key, item in merged.items() if item is not None}
        else:
            data[name] = value
    return data


@st.composite
def requirements(draw, separable=False):
    """A small space of any variants, with limits that bite now and then."""
    maybe = lambda low, high: draw(st.one_of(st.none(), st.none(), st.floats(low, high)))  # noqa: E731
    some = lambda low, high, most=4: draw(st.lists(st.floats(low, high), min_size=1, max_size=most, unique=True))  # noqa: E731
    catalogue = draw(st.booleans()) and not separable
    angle = draw(st.booleans())
    both = draw(st.booleans())
    width = None if both else maybe(0.01, 0.08)
    material = draw(st.sampled_from([None, None, "cork-dry", "woven-dry"]))
    data = changed(
        friction={"min": None, "mean": None, "max": None, "material": material} if material else {},
        variants=draw(st.lists(st.sampled_from(["conventional", "differentiated", "all-driving", "indirect"]), min_size=1, unique=True)),
        objectives=draw(st.lists(st.sampled_from(OBJECTIVES), min_size=1, unique=True)),
        wanted={
            "accuracy_factor": maybe(1.5, 8),
            "torque_max": maybe(300, 1500),
            "method": draw(st.sampled_from(["min-friction", "mean-friction"])),
            "margin": draw(st.floats(1, 1.5)),
        },
        search={
            "pairs": draw(st.lists(st.integers(1, 14), min_size=1, max_size=3, unique=True)),
            "driving_pairs": draw(st.lists(st.integers(1, 3), min_size=1, max_size=2, unique=True)),
            "mean_radius": None if both else some(0.03, 0.2, 6),
            "inner_radius": [0.02, *some(0.03, 0.1, 1)] if both else None,
            "outer_radius": [*some(0.04, 0.25, 3), 0.25] if both else None,
            "gain": None if angle else [*some(0.05, 2), 0.0],
            "wall_angle": some(0.1, 1.2) if angle else None,
            "ball_circle_radius": some(0.03, 0.1, 2),
            "closing_force": None if catalogue else {"min": draw(st.floats(100, 1000)), "max": draw(st.floats(2000, 80000))},
            "closing_forces": some(500, 50000) if catalogue else None,
            "closing_stiffness": some(1e3, 1e5, 2),
            "control_stiffness": some(1e3, 1e5, 2),
        },
        fixed={"hub_diameter": 0.06, "key_friction": 0.02, "face_gap": 5e-4, "edge_clearance": 5e-4, "face_width": width},
        limits={
            "surface_pressure": draw(st.floats(1e5, 3e6)) if both or width else None,
            "outer_diameter": maybe(0.15, 0.5) if both or width else None,
            "contact_force": maybe(500, 5000),
            "travel": maybe(1e-3, 0.1),
            "reduced_gain": maybe(2, 10),
            "gain_limit": draw(st.booleans()),
        },
    )  # fmt: skip
    return make_requirements(data)


def brute(need):
    """Objectives of every feasible candidate, one by one through the engines."""
    search, found = need.search, []
    arrays = {
        name: values.array()
        for name in ("pairs", "driving_pairs", "ball_circle_radius", "closing_stiffness", "control_stiffness")
        if (values := getattr(search, name)) is not None
    }  # fmt: skip
    steer = (search.gain or search.wall_angle).array()
    if search.mean_radius is not None:
        faces = [(radius, need.fixed.face_width) for radius in search.mean_radius.array()]
    else:
        both = itertools.product(search.inner_radius.array(), search.outer_radius.array())
        faces = [((inner + outer) / 2, outer - inner) for inner, outer in both if inner < outer]
    for variant in need.variants:
        axes = [arrays["pairs"], faces]
        axes.append(arrays["driving_pairs"] if variant == "differentiated" else [None])
        axes += [steer, arrays["ball_circle_radius"]] if variant != "conventional" else [[None], [None]]
        axes += [arrays[f"{s}_stiffness"] if variant == "indirect" else [None] for s in ("closing", "control")]
        for z, face, z1, turn, circle, c1, c2 in itertools.product(*axes):
            if (values := one(need, variant, z, face, z1, turn, circle, c1, c2)) is not None:
                found.append(values)
    return np.array(found).reshape(-1, len(need.objectives))


def ball_of(need, clutch, made):
    """The smallest standard ball that reaches, bears its force (Johnson, Contact Mechanics, (4.24)) and has room."""
    for size in (each for each in diameters() if each >= 2 * made.ball_radius * (1 - 1e-9)):
        # of hardened steel: 206 GPa, 0.3, 4200 MPa
        borne = math.pi**3 * 4.2e9**3 * (size / 2) ** 2 / (6 * (206e9 / (2 * (1 - 0.3**2))) ** 2)
        if need.limits.contact_force is not None or made.contact_force <= borne * (1 + 1e-9):
            _, findings = synthesize(build(with_values(clutch.spec, {"control_unit.ball_diameter": size})))
            room = {"balls-overlap", "pockets-overlap", "ball-reaches-axis"} & {each.code for each in findings}
            unit = clutch.spec.control_unit
            return None if room or (unit.hub_diameter or 0.0) > 2 * unit.ball_circle_radius - size else size
    return None


def one(need, variant, z, face, z1, turn, circle, c1, c2):
    """Objectives of one candidate, None where a requirement is missed."""
    radius, width = face
    wanted, limits, fixed, over = need.wanted, need.limits, need.fixed, 1 + 1e-9
    if z1 is not None and z1 >= z:
        return None
    data = {
        "variant": variant,
        "friction": need.friction.model_dump(exclude_none=True),
        "friction_group": {"pairs": int(z), "mean_radius": radius},
        "adjustment": {"method": wanted.method, "margin": wanted.margin, "nominal_torque": wanted.nominal_torque},
    }
    if z1 is not None:
        data["friction_group"]["driving_pairs"] = int(z1)
    if turn is not None:
        data["control_unit"] = {"ball_circle_radius": circle, "balls": fixed.balls, "face_gap": fixed.face_gap,
                                "edge_clearance": fixed.edge_clearance}  # fmt: skip
        data["control_unit"]["gain" if need.search.gain else "wall_angle"] = turn
    if variant == "indirect":
        data["control_unit"] |= {"hub_diameter": fixed.hub_diameter, "key_friction": fixed.key_friction}
        data |= {"closing_spring": {"stiffness": c1}, "control_spring": {"stiffness": c2}}
    try:
        clutch = build(make_spec(data))
    except ValueError:
        return None
    if variant == "indirect" and clutch.net_gain <= 0:
        return None
    force = clutch.closing_force
    pack = clutch.control_force if variant == "indirect" else force
    if need.search.closing_forces is not None:
        force = min((f for f in need.search.closing_forces.array() if f >= force / over), default=math.inf)
    elif not need.search.closing_force.min / over <= pack <= need.search.closing_force.max * over:
        return None
    if force == math.inf:
        return None
    del data["adjustment"]["nominal_torque"]
    clutch = build(make_spec({**data, "closing_spring": {**data.get("closing_spring", {}), "force": force}}))
    ball, travel = 0.0, 0.0
    control = clutch.control_force if variant == "indirect" else 0.0
    pack = control or force
    held = [
        wanted.accuracy_factor is None or clutch.accuracy_factor <= wanted.accuracy_factor * over,
        wanted.torque_max is None or clutch.torque_max <= wanted.torque_max * over,
        width is None or (radius > width / 2 and pack / (2 * math.pi * radius * width) <= limits.surface_pressure * over),
        limits.outer_diameter is None or 2 * radius + width <= limits.outer_diameter * over,
        limits.reduced_gain is None or clutch.reduced_gain <= limits.reduced_gain * over,
        not limits.gain_limit or clutch.gain <= clutch.quantities.get("gain_limit", math.inf) * over,
        variant != "indirect" or fixed.hub_diameter <= 2 * radius - (width or 0.0),
    ]  # fmt: skip
    if (material := need.friction.material) is not None and width is not None:
        allowed = {"cork-dry": 55e3, "woven-dry": 345e3}[material]
        held.append(pack / (2 * math.pi * (radius - width / 2) * width) <= allowed * over)
    if turn is not None and clutch.gain > 0:
        made, _ = synthesize(clutch)
        held.append(limits.contact_force is None or made.contact_force <= limits.contact_force * over)
        held.append(limits.travel is None or made.travel_max <= limits.travel * over)
        ball, travel = ball_of(need, clutch, made), made.travel_max
        held.append(ball is not None)
    if turn is not None and clutch.gain == 0 and limits.contact_force is not None:
        moment = clutch.at(need.friction.range.max).get("driven_torque", 0.0)
        held.append(moment / (fixed.balls * circle) <= limits.contact_force * over)
    if not all(held):
        return None
    whole = {
        "closing_force": pack,
        "accuracy_factor": clutch.accuracy_factor,
        "pairs": z,
        "ball_diameter": ball,
        "travel": travel,
        "control_force": control,
        "closing_deflection": force / c1 if c1 else 0.0,
        "control_deflection": (control / c2 if c2 else math.inf) if variant == "indirect" else 0.0,
    }
    return [whole[name] for name in need.objectives]


@fewer(2)
@given(requirements())
def test_the_front_against_brute_force(need):
    everything = brute(need)
    found = searched(need)
    assert found.feasible == len(everything)
    mine = (
        np.concatenate([member.values for member in found.members])
        if found.members
        else np.empty((0, len(need.objectives)))
    )
    theirs = everything[front(everything)]
    order = [np.lexsort(np.round(each, 12).T[::-1]) for each in (mine, theirs)]
    assert mine[order[0]] == pytest.approx(theirs[order[1]], rel=1e-9, abs=1e-12)


@given(requirements(separable=True))
def test_two_ways_through_one_space(need):
    """Looking the radii up gives what evaluating all of them gives, exclusions included."""
    quick, slow = Survey(), Survey()
    variants = [variant for variant in (VARIANTS[name] for name in need.variants) if separable(need, variant)]
    assume(variants)
    for variant in variants:
        by_radius(need, variant, quick, lambda done: None)
        by_tile(need, variant, slow, lambda done: None)
    assert (quick.candidates, quick.feasible) == (slow.candidates, slow.feasible)
    assert +quick.excluded == +slow.excluded
    for found in (quick, slow):
        found.settle()
    one, other = (sorted(row for member in found.members for row in member.values.tolist()) for found in (quick, slow))
    assert np.array(one) == pytest.approx(np.array(other), rel=1e-12)


@fewer(2)
@given(requirements(), st.integers(0, 10**6))
def test_what_is_picked_holds_what_was_wanted(need, place):
    result, _ = design(need)
    assume(result.front)
    number = place % len(result.front) + 1
    row = result.front[number - 1]
    clutch = build(with_picked(need, result, number)[1])
    assert clutch.nominal_torque >= need.wanted.nominal_torque * (1 - 1e-9)
    assert clutch.accuracy_factor == pytest.approx(row.accuracy_factor, rel=5e-3)
    assert clutch.torque_max == pytest.approx(row.torque_max, rel=5e-3)
    if (most := need.limits.outer_diameter) is not None:
        assert 2 * clutch.spec.friction_group.outer_radius <= most * (1 + 1e-9)


@fewer(2)
@given(requirements(), st.integers(1, 5))
def test_the_front_is_one_and_numbered(need, top):
    """Nothing on it beats another, nothing on the grid beats it; a number is the same clutch however it is sorted."""
    result, _ = design(need)
    assert [row.number for row in result.front] == list(range(1, result.on_front + 1))
    values = np.array([[row.objective(name) for name in need.objectives] for row in result.front])
    worse = [(values <= one * (1 + 1e-12)).all(axis=1).sum() for one in values]
    assert all(count == 1 for count in worse), "itself alone"
    assert sorted(map(tuple, values)) == list(map(tuple, values))
    for before, after in refinement(need, searched(need)):
        for row in (before, after):
            own = np.array([row.objective(name) for name in need.objectives])
            assert (values <= own * (1 + 1e-8)).all(axis=1).any()
    for name in need.objectives:
        few = shown(result, name, top).front
        assert all(row == result.front[row.number - 1] for row in few)
        least = sorted(row.objective(name) for row in result.front)[:top]
        assert [row.objective(name) for row in few] == least


def test_the_knee_is_farthest_from_the_line_between_the_ends():
    """Das, 1999: of two objectives, each over its range, by the distance of points from a line."""
    two = changed(objectives=["closing_force", "accuracy_factor"], search={"pairs": 8})
    result, _ = design(make_requirements(two))
    at = np.array([[row.closing_force, row.accuracy_factor] for row in result.front])
    at = (at - at.min(axis=0)) / np.ptp(at, axis=0)
    first, last = at[0], at[-1]
    along = (last - first) / np.linalg.norm(last - first)
    away = at - first
    distance = along[0] * away[:, 1] - along[1] * away[:, 0]
    assert result.knee == int(np.argmin(distance)) + 1 not in (1, result.on_front)
    assert [row.number for row in result.front if row.mark == "knee"] == [result.knee]
    single, _ = design(make_requirements(two | {"objectives": ["closing_force"]}))
    assert (single.knee, single.on_front) == (None, 1)


@given(requirements())
def test_what_could_be_had_instead(need):
    """With each limit relaxed as told more clutches meet all; short of the nearest miss of it there are no more."""
    result, findings = design(need, misses=True)
    assume(result.attainable)
    if not result.front and need.springs is None:
        assert findings[0].message.rpartition("give up ")[2]
    sets = {}
    for row in result.attainable:
        assert (row.best > row.limit) == (row.sense == "at most"), row
        sets.setdefault(row.together, []).append(row)
    single = None in sets
    assert single != any(rows for together, rows in sets.items() if together)
    for row in sets.get(None, []):
        tight, loose = (moved(need, row, row.best * (1 + way * sign(row))) for way in (-1e-6, 1e-9))
        if loose is not None:
            # what is as near as that already is within the slack of a limit
            if abs(row.best / row.limit - 1) > 1e-5:
                assert searched(tight).feasible == result.feasible
            assert searched(loose).feasible > result.feasible
            easier = searched(moved(need, row, row.relax_to))
            assert easier.feasible == row.feasible > result.feasible
            assert sign(row) * row.best <= sign(row) * row.relax_to <= sign(row) * row.best * (1 + sign(row) * 1e-3)
    for together, rows in sets.items():
        easier = need
        for row in rows if together else ():
            easier = easier and moved(easier, row, row.best * (1 + sign(row) * 1e-9))
        if together and easier:
            assert searched(easier).members


def sign(row):
    return 1 if row.sense == "at most" else -1


PLACES = {
    "accuracy_factor": "wanted", "torque_max": "wanted", "surface_pressure": "limits", "outer_diameter": "limits",
    "contact_force": "limits", "travel": "limits", "reduced_gain": "limits",
}  # fmt: skip


def moved(need, row, limit):
    """The requirements with a limit moved; None where it is none of the file's."""
    if row.requirement == "closing_force" and need.search.closing_force is not None:
        span = need.search.closing_force.model_copy(update={"max" if sign(row) > 0 else "min": limit})
        return need.model_copy(update={"search": need.search.model_copy(update={"closing_force": span})})
    if row.requirement not in PLACES:
        return None
    block = getattr(need, PLACES[row.requirement]).model_copy(update={row.requirement: limit})
    return need.model_copy(update={PLACES[row.requirement]: block})


@given(requirements())
def test_nothing_negative_leaves_the_search(need):
    result, _ = design(need)
    for row in result.front:
        values = row.model_dump(exclude_none=True, exclude={"variant", "mark", "material"})
        may_be_zero = {"gain", "wall_angle", "travel", "contact_force", "control_stiffness"}
        assert all(value > 0 or (value == 0 and name in may_be_zero) for name, value in values.items()), values
        assert row.accuracy_factor >= 1
        assert row.torque_max >= row.nominal_torque * (1 - 1e-9)


def test_a_margin_lies_between_clutch_and_machine():
    """Set at f_min the clutch is the margin stronger (S22); set at the mean the margin is in the spring (S19)."""
    for method, clutch_torque in (("min-friction", 250), ("mean-friction", 200)):
        wanted = {"nominal_torque": None, "machine_torque": 200, "margin": 1.25, "method": method, "torque_max": 700}
        need = make_requirements(changed(wanted=wanted))
        result, _ = design(need)
        assert len(result.front) > 5
        for row in result.front:
            assert row.nominal_torque == pytest.approx(clutch_torque)
            assert row.machine_torque == pytest.approx(200)
        made = build(with_picked(need, result, 3)[1])
        assert made.nominal_torque == pytest.approx(clutch_torque, rel=1e-3)
        if method == "min-friction":
            assert overload(made)[0].machine_torque == pytest.approx(200, rel=1e-3)
    alone, _ = design(make_requirements(changed(wanted={"nominal_torque": 250, "torque_max": 700})))
    assert {row.machine_torque for row in alone.front} == {None}


INDIRECT = {
    "variants": ["indirect"], "objectives": ["closing_force", "accuracy_factor"],
    "wanted": {"accuracy_factor": 4, "torque_max": 1000},
    "search": {"pairs": [8], "mean_radius": 0.1, "gain": [0.2, 0.4, 1.0, 2.0], "ball_circle_radius": 0.05,
               "closing_stiffness": 4e5, "control_stiffness": [0, 2e5], "ball_diameters": [0.03, 0.5]},
    "fixed": {"hub_diameter": 0.05, "key_friction": 0.1}, "limits": {"contact_force": None},
}  # fmt: skip


def test_an_indirect_clutch_is_judged_by_what_its_pack_bears():
    """F_п1 = 200/(8·0.1·0.1) = 2500 N; κ = C − 0.4, F_п2 = F_п1 (1 + 0.8 κ)."""
    result, _ = design(make_requirements(changed(**INDIRECT)))
    # C 0.2 has κ < 0, C 0.4 has κ = 0: counted as such and as nothing else
    assert result.excluded["gain_threshold"] == 4
    assert sum(result.excluded.values()) + result.feasible == result.candidates == 8
    assert [row.gain for row in result.front] == [1.0, 2.0]
    for row in result.front:
        pack = 2500 * (1 + 0.8 * (row.gain - 0.4))
        assert row.closing_force == pytest.approx(2500)
        assert row.control_force == row.pack_force_at_rest == pytest.approx(pack)
        assert row.closing_deflection == pytest.approx(2500 / 4e5)
        assert row.surface_pressure == pytest.approx(pack / (2 * math.pi * 0.1 * 0.03))
        # c_2 = 0 is best in K_т: a constant force, whose deflection is not defined
        assert (row.control_stiffness, row.control_deflection) == (0, None)
    stiff, _ = design(
        make_requirements(changed(**INDIRECT) | {"objectives": ["control_deflection", "accuracy_factor"]})
    )
    assert stiff.front[0].control_deflection == pytest.approx(2500 * 1.48 / 2e5)
    narrow = changed(**INDIRECT)
    narrow["search"]["closing_force"] = {"min": 500, "max": 5000}
    assert [row.gain for row in design(make_requirements(narrow))[0].front] == [1.0]


def test_pockets_that_meet_between_balls_that_do_not():
    """Walls of 70° open mouths of d/cos 70° − s tan 70° = 23.7 mm for a ball of 10 mm: 13 of them are 23.9 mm apart, 14 22.3."""
    steep = {
        "variants": ["all-driving"], "objectives": ["closing_force"], "wanted": {"accuracy_factor": None, "torque_max": None},
        "search": {"pairs": [8], "mean_radius": 0.1, "gain": 2 * math.tan(math.radians(70)), "ball_circle_radius": [0.05],
                   "ball_diameters": [0.01, 0.02], "closing_force": {"min": 500, "max": 80000}},
        "limits": {"contact_force": 1e6, "surface_pressure": None, "reduced_gain": None, "gain_limit": False},
    }  # fmt: skip
    for gain in (True, False):
        for count, feasible in ((13, 1), (14, 0)):
            need = changed(**steep, fixed={"balls": count})
            if not gain:
                need["search"]["wall_angle"] = "70 deg"
                del need["search"]["gain"]
            result, _ = design(make_requirements(need))
            assert (result.feasible, result.excluded.get("standard_ball", 0)) == (feasible, 1 - feasible)


def test_balls_that_have_no_room_are_not_proposed():
    """Every clutch of the example's front can be assembled."""
    need = make_requirements(BASE)
    result, _ = design(need)
    for number in range(1, result.on_front + 1, 7):
        _, found = synthesize(build(with_picked(need, result, number)[1]))
        assert not [each for each in found if each.level == "error"]


def test_refinement_reaches_the_closed_inverse():
    """All-driving, least force for K_т ≤ 2.9: C from the inverse, R at its end, F from the law."""
    need = make_requirements(
        changed(
            variants=["all-driving"], objectives=["closing_force"], wanted={"accuracy_factor": 2.9, "torque_max": None},
            search={"pairs": [8], "gain": {"start": 0.0, "stop": 0.625, "count": 12},
                    "mean_radius": {"start": 0.1, "stop": 0.15, "count": 4}, "ball_circle_radius": [0.06]},
            limits={"surface_pressure": None, "contact_force": None}, fixed={"face_gap": 0, "edge_clearance": 0},
        )
    )  # fmt: skip
    ((grid, fine),) = refinement(need, searched(need))
    gain = synthesis.gain_for_accuracy_factor(0, 8, 2.9, 0.1, 0.1, 0.8, 0.8)
    best = adjustment.closing_force(200, 1, 0.15 * 8 * 0.1 / (1 + 8 * gain * 0.1))
    assert grid.closing_force > best * 1.01, "the grid is beside the optimum"
    assert fine.closing_force == pytest.approx(best, rel=1e-8)
    assert fine.gain == pytest.approx(gain, rel=1e-6)
    assert [row.closing_force for row in design(need)[0].front] == [fine.closing_force]


@pytest.mark.parametrize("faces", ["both radii", "face width"])
def test_the_front_reaches_the_outer_diameter(faces):
    """Least force at a given gain: the largest radius that 330 mm allow, between the grid points."""
    grid_ = {"start": 0.08, "stop": 0.2, "count": 5}
    both = {"mean_radius": None, "inner_radius": [0.05, 0.07], "outer_radius": grid_}
    data = changed(
        variants=["all-driving"], objectives=["closing_force"], wanted={"accuracy_factor": None, "torque_max": None},
        search={"pairs": [8], "gain": 0.5, "ball_circle_radius": 0.05} | (both if faces == "both radii" else {"mean_radius": grid_}),
        fixed={"face_width": None if faces == "both radii" else 0.04},
        limits={"surface_pressure": None, "contact_force": None, "outer_diameter": 0.33},
    )  # fmt: skip
    need = make_requirements(data)
    result, _ = design(need)
    (row,) = result.front
    radius = (0.165 + 0.07) / 2 if faces == "both radii" else 0.165 - 0.02
    assert row.outer_diameter == pytest.approx(0.33)
    assert row.mean_radius == pytest.approx(radius)
    assert row.closing_force == pytest.approx(200 / (radius * 8 * 0.1 / (1 + 8 * 0.5 * 0.1)))
    spec = with_picked(need, result, 1)[1]
    assert spec.friction_group.outer_radius == pytest.approx(0.165)
    assert spec.requirements.outer_diameter == 0.33
    assert 200 <= build(spec).nominal_torque < 200.1


def test_the_example_runs_as_it_is(afmcalc, tmp_path):
    run = afmcalc("design", CONFIGS / "requirements.toml", "--json")
    assert run.code == 0, run.err
    front_ = run.json["result"]["front"]
    assert len(front_) == run.json["result"]["on_front"]
    assert len(front_) > 10
    assert all(row["accuracy_factor"] <= 3 and row["torque_max"] <= 500 for row in front_)
    target = tmp_path / "picked.toml"
    chosen = afmcalc("design", CONFIGS / "requirements.toml", "--pick", 7, "--output", target, "--json")
    assert chosen.json["spec"]["friction_group"]["pairs"] == front_[6]["pairs"]
    again = afmcalc("torque", target, "--json").json
    assert again["spec"] == chosen.json["spec"]
    torque, (row,) = again["result"], chosen.json["result"]["picked"]
    assert chosen.json["result"]["front"] == front_
    assert 200 <= row["nominal_torque"] == torque["nominal_torque"] < 200.2
    assert row["closing_force"] == torque["closing_force"] == pytest.approx(front_[6]["closing_force"], rel=5e-3)
    assert afmcalc("check", target).code == 0
    assert afmcalc("check", "-", stdin=chosen.out).code == 0
    assert afmcalc("design", CONFIGS / "requirements.toml", "--format", "markdown").code == 0
    listed = afmcalc("design", CONFIGS / "requirements.toml", "--format", "csv")
    assert listed.code == 0
    rows = list(csv.DictReader(io.StringIO(listed.out)))
    assert [(int(row["number"]), float(row["closing_force [N]"])) for row in rows] == [
        (row["number"], row["closing_force"]) for row in front_
    ]
    few = afmcalc("design", CONFIGS / "requirements.toml", "--sort", "accuracy_factor", "--top", 3, "--json").json
    best = sorted(front_, key=lambda row: row["accuracy_factor"])[:3]
    assert [row["number"] for row in few["result"]["front"]] == [row["number"] for row in best]
    table = afmcalc("design", CONFIGS / "requirements.toml")
    assert table.code == 0
    assert f"40 of {len(front_)} shown" in table.err
    assert numbers_in(table.out) == [*range(1, 41)]
    # what is the same in all stands above the table, and is no column of it
    above, _, below = table.out.partition("the same in all: ")[2].partition("\n")
    assert "R_cp = 140 mm; " in above
    assert {row["mean_radius"] for row in front_[:40]} == {0.14}
    assert "R_cp" not in below.splitlines()[0].split()
    markdown = afmcalc("design", CONFIGS / "requirements.toml", "--top", 31, "--format", "markdown").out
    assert numbers_in(markdown) == [*range(1, 32)]
    by_torque = afmcalc("design", CONFIGS / "requirements.toml", "--sort", "torque_max", "--top", 2, "--json").json
    assert [row["torque_max"] for row in by_torque["result"]["front"]] == sorted(row["torque_max"] for row in front_)[
        :2
    ]
    assert afmcalc("design", CONFIGS / "requirements.toml", "--sort", "closing_forc").code == 2
    assert afmcalc("design", CONFIGS / "requirements.toml", "--pick", 10**6).code == 2


def test_the_clutch_picked_is_shown_alone_with_what_a_check_says(afmcalc, tmp_path):
    file, target = CONFIGS / "requirements.toml", tmp_path / "picked.toml"
    alone = afmcalc("design", file, "--pick", "knee", "--quiet", "--output", target)
    assert alone.err == ""
    assert "no.  variant" not in alone.out
    asked = afmcalc("design", file, "--pick", "knee", "--json").json["result"]
    assert [row["number"] for row in asked["picked"]] == [asked["knee"]]
    assert len(asked["front"]) == asked["on_front"]
    said = afmcalc("check", target, "--json").json
    checked = said["result"]
    assert target.read_text(encoding="utf-8").startswith(f"# Number {asked['knee']} of the front")
    assert asked["verdict"] == checked
    assert [f"[{each['code']}" in alone.out for each in said["findings"]] == [False] * checked["notes"]  # quiet
    loud = afmcalc("design", file, "--pick", "knee").out
    assert all(f"[{each['code']}" in loud for each in said["findings"])
    assert checked["passed"]
    for row in checked["requirements"]:
        assert f"{row['utilisation']:.5g}" in alone.out
    single = ["--set", 'objectives=["closing_force"]', "--pick", "knee"]
    assert "none" in afmcalc("design", file, *single).err
    for wrong in ("0", "222", "²", "9" * 5000, "kne"):
        assert afmcalc("design", file, "--pick", wrong).code == 2


def numbers_in(text):
    """Numbers of the rows of a front's table: its first column, from its heading to the next blank line."""
    rows = text.replace("| ", "").split("\nno. ")[1].split("\n\n")[0].splitlines()
    return [int(row.split()[0]) for row in rows[1:] if row.split()[0].isdecimal()]


@pytest.mark.parametrize("format_", ["table", "markdown", "csv", "json"])
def test_that_there_is_no_candidate_is_said_once(format_, afmcalc):
    """To people: on standard error, with the exit code; as data: in the JSON."""
    run = afmcalc("design", CONFIGS / "requirements.toml", *ALONE, "--format", format_)
    assert run.code == 2
    assert run.err.count("meets every requirement") == 1
    assert run.out.count("meets every requirement") == (format_ == "json")
    assert (run.json["findings"][0]["code"] if format_ == "json" else "no-candidate") == "no-candidate"


ALONE = ["--set", "wanted.accuracy_factor=1.01", "--set", "search.gain=0.5", "--set", "search.pairs=8"]
ALONE += ["--set", "search.mean_radius=0.1"]


def test_an_empty_result_says_why(afmcalc, tmp_path):
    target = tmp_path / "x.toml"
    run = afmcalc("design", CONFIGS / "requirements.toml", "--set", "wanted.accuracy_factor=1.01", "--pick", "1",
                  "--json", "-o", target)  # fmt: skip
    assert run.code == 2
    assert not target.exists()
    shown = afmcalc("design", CONFIGS / "requirements.toml", "--set", "wanted.accuracy_factor=1.01", "--json")
    assert shown.code == 2
    assert shown.json["result"]["front"] == []
    assert shown.json["result"]["excluded"]["accuracy_factor"] == shown.json["result"]["candidates"] == 132020
    assert "none of 132,020 candidates meets every requirement; excluded by: accuracy factor (132,020), " in shown.err
    (row,) = shown.json["result"]["attainable"]
    assert (row["requirement"], row["sense"], row["limit"], row["together"]) == (
        "accuracy_factor",
        "at most",
        1.01,
        None,
    )
    assert f"give up: accuracy factor (at most 1.01; there is {row['relax_to']:.5g})" in shown.err
    narrow = ["--set", "wanted.accuracy_factor=1.01", "--set", "limits.surface_pressure=1 kPa"]
    rows = afmcalc("design", CONFIGS / "requirements.toml", *narrow, "--json").json["result"]["attainable"]
    assert {row["together"] for row in rows} == {"accuracy_factor + surface_pressure"}
    assert [row["requirement"] for row in rows] == ["accuracy_factor", "surface_pressure"]


@pytest.mark.parametrize(
    ("tables", "says"),
    [
        ({"search": {"mean_radius": {"start": 0.2, "stop": 0.1, "count": 5}}}, "the range is inverted"),
        ({"search": {"closing_force": {"min": 5, "max": 1}}}, "must not be below min"),
        ({"search": {"mean_radius": {"start": 0.1, "stop": 0.2}}}, "needs count, or a step"),
        ({"search": {"mean_radius": {"start": 0.1, "stop": 0.2, "cuont": 3}}}, "unknown key 'cuont'"),
        ({"search": {"mean_radius": []}}, "empty list"),
        ({"search": {"mean_radius": "1 N"}}, "is a force, not a length"),
        ({"search": {"mean_radius": -1}}, "must be greater than 0"),
        ({"search": {"pairs": [2.5]}}, "must be a whole number"),
        ({"search": {"pairs": True}}, "must be a whole number"),
        ({"search": {"gain": [0.5, -0.1]}}, "search.gain = [0.5, -0.1]: must be at least 0"),
        ({"search": {"gain": None, "wall_angle": {"start": 5, "stop": 40, "count": 8}}}, "must be less than 90 deg"),
        ({"search": {"gain": None, "wall_angle": [5, 10]}}, "wall_angle = [5, 10]: must be less than 90 deg"),
        ({"search": {"gain": None, "wall_angle": 5}}, 'and must be less than pi/2: write "5 deg"'),
        ({"search": {"gain": None, "wall_angle": "-1 deg"}}, "must be at least 0"),
        ({"search": {"gain": None, "wall_angle": math.pi / 2}}, "must be less than 90 deg"),
        ({"search": {"ball_circle_radius": 0}}, "must be greater than 0"),
        ({"search": {"closing_stiffness": 0}}, "must be greater than 0"),
        ({"search": {"control_stiffness": -1}}, "must be at least 0"),
        ({"search": {"closing_force": None, "closing_forces": [0]}}, "must be greater than 0"),
        ({"search": {"mean_radius": {"start": 0.1, "stop": 0.2, "step": 1e-300}}}, "at most 1,000,000 here"),
        ({"search": {"pairs": {"start": 2, "stop": 10_000_000}}}, "9,999,999 values; at most 1,000,000 here"),
        ({"search": {"ball_diameters": {"start": 1e-3, "stop": 1, "count": 10_000_000}}}, "10,000,000 values; at most 10,000 here"),
        ({"search": {"mean_radius": [0.1] * 10_001}}, "10,001 values; at most 10,000 here"),
        ({"search": {"pairs": 0}}, "must be at least 1"),
        ({"search": {"gain": None}}, "give gain or wall_angle"),
        ({"search": {"closing_force": None}}, "a catalogue"),
        ({"search": {"ball_circle_radius": None}}, "required with a control unit"),
        ({"search": {"radius": 1}}, "unknown key"),
        ({"variants": ["indirect"]}, "required for variant 'indirect'"),
        ({"variants": ["direct"]}, "must be one of"),
        ({"variants": []}, "must not be empty"),
        ({"limits": {"gain_limit": "off"}}, "must be true or false"),
        ({"objectives": ["mass"]}, "must be one of"),
        ({"friction": {"min": None, "max": None, "mean": None}}, "a material, or both groups"),
        ({"fixed": {"face_width": None}}, "required beside limits.surface_pressure"),
        ({"fixed": {"face_width": None}, "limits": {"surface_pressure": None, "outer_diameter": 0.2}}, "beside limits.outer_diameter"),
        ({"search": {"mean_radius": None}}, "give mean_radius, or inner_radius and outer_radius"),
        ({"search": {"outer_radius": 0.2}}, "give mean_radius, or inner_radius and outer_radius"),
        ({"search": {"mean_radius": None, "inner_radius": 0.1}}, "give mean_radius, or inner_radius and outer_radius"),
        ({"search": {"mean_radius": None, "inner_radius": 0.1, "outer_radius": 0.2}}, 'fixed.face_width = "30 mm": follows from'),
        ({"search": {"mean_radius": None, "inner_radius": 0.2, "outer_radius": [0.1, 0.2]}, "fixed": {"face_width": None}}, "must reach beyond"),
        ({"wanted": {"nominal_torque": None}}, "wanted.nominal_torque: required"),
        ({"wanted": {"machine_torque": 100}}, "nominal_torque of the clutch or machine_torque, one of them"),
    ],
)  # fmt: skip
def test_requirements_that_are_refused(tables, says, afmcalc):
    run = afmcalc("design", "-", stdin=json.dumps(changed(**tables)))
    assert (run.code, run.out) == (2, "")
    assert says in run.err


def test_too_many_are_refused_before_any_work(afmcalc, monkeypatch):
    monkeypatch.setattr("afmcalc.analysis.design.design.search", None)
    wide = {"mean_radius": {"start": 0.1, "stop": 0.2, "count": 1_000_000}, "pairs": 8, "ball_circle_radius": 0.05,
            "gain": {"start": 0, "stop": 1, "count": 1_000_000}}  # fmt: skip
    text = json.dumps(changed(variants=["all-driving"], search=wide))
    run = afmcalc("design", "-", stdin=text)
    assert run.code == 2
    assert "asks for 1,000,000,000,000 candidates" in run.err


def test_ctrl_c_leaves_no_file(tmp_path):
    source, target = tmp_path / "wide.json", tmp_path / "out.toml"
    grid = lambda start, stop, count: {"start": start, "stop": stop, "count": count}  # noqa: E731
    springs = {"closing_stiffness": grid(1e4, 2e5, 20), "control_stiffness": grid(1e4, 2e5, 20)}
    wide = {"mean_radius": grid(0.06, 0.14, 1000), "gain": grid(0.1, 3, 1000), **springs}
    source.write_text(json.dumps(changed(variants=["indirect"], search=wide, fixed=INDIRECT["fixed"])))
    code = "from afmcalc import progress; progress.PATIENCE = 0; from afmcalc.__main__ import program; program()"
    command = [sys.executable, "-c", code, "design", str(source), "--pick", "1", "-o", str(target), "--yes"]
    person, terminal = os.openpty()
    # started from a background job it would ignore the signal from the outset
    heeding = {"preexec_fn": lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)}
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=terminal, **heeding) as process:
        os.close(terminal)
        shown = b""
        while b"searching" not in shown:  # the bar: the work is under way
            shown += os.read(person, 1024)
        process.send_signal(signal.SIGINT)
        with contextlib.suppress(OSError):  # the terminal ends with the process
            while part := os.read(person, 1024):
                shown += part
    os.close(person)
    assert process.returncode == 130
    assert b"Traceback" not in shown
    assert sorted(path.name for path in tmp_path.iterdir()) == ["wide.json"]
