"""design with what has to be simulated or sampled, against a check of every candidate there is."""

import functools
import itertools
import json

import numpy as np
import pytest

from afmcalc.analysis.answers import Answers
from afmcalc.analysis.check import check
from afmcalc.analysis.design.design import design
from afmcalc.analysis.design.pick import with_picked
from afmcalc.engines import build
from afmcalc.errors import CalculationError
from afmcalc.spec import make_spec
from afmcalc.spec.requirements import make_requirements

FRICTION = {"min": 0.1, "mean": 0.2, "max": 0.3}
DRIVE = {
    "speed": 150.0, "motor_inertia": 0.02, "driven_inertia": 0.01, "shaft_stiffness": 8000.0, "load_torque": 20.0,
    "motor_torque": 20.0, "cut_off": 0.01, "event": {"kind": "stop", "stop_time": 0.01},
}  # fmt: skip
HEAT = {
    "disc_mass": 0.8, "specific_heat": 460.0, "conductivity": 40.0, "density": 7800.0, "ambient": 300.0, "cooling": 3.0,
    "lining_conductivity": 0.5, "lining_density": 2000.0, "lining_specific_heat": 1000.0, "lining": 1e-3,
}  # fmt: skip
TOLERANCE = {"fields": {"friction": {"distribution": "normal", "spread": 0.03}}}
UNIT = {"balls": 6, "face_gap": 2e-3, "edge_clearance": 2e-3}
HUB = {"hub_diameter": 0.04, "key_friction": 0.02}
SPACES = {
    "direct": (
        ["conventional", "differentiated", "all-driving"],
        {
            "pairs": [4, 6], "driving_pairs": [1], "inner_radius": [0.05], "outer_radius": [0.07, 0.11],
            "gain": [0.4, 1.0], "ball_circle_radius": [0.045],
        },
    ),
    "indirect": (
        ["indirect"],
        {
            "pairs": [4, 6], "inner_radius": [0.05], "outer_radius": [0.08, 0.11], "gain": [0.6, 1.2],
            "ball_circle_radius": [0.045], "closing_stiffness": [4e5, 8e5], "control_stiffness": [1e5],
        },
    ),
}  # fmt: skip
LOOSE = {
    "peak_torque": 1e5, "work": 1e9, "temperature": 800.0, "face_temperature": 2000.0, "trips_per_hour": 1e-3,
    "exceedance": 0.999,
}  # fmt: skip
OBJECTIVES = ["closing_force", "accuracy_factor", "pairs"]
TORQUE_MAX = 260.0


def needed(space, drive=DRIVE, **wanted):
    variants, search = SPACES[space]
    indirect = variants == ["indirect"]
    return {
        "variants": variants,
        "objectives": OBJECTIVES,
        "friction": FRICTION,
        "wanted": {
            "method": "mean-friction",
            "nominal_torque": 100.0,
            "torque_max": TORQUE_MAX,
            "temperature": LOOSE["temperature"],
            **wanted,
        },
        "search": {**search, "closing_force": {"min": 200.0, "max": 1e4}},
        "fixed": UNIT | (HUB if indirect else {}),
        "limits": {"gain_limit": False},
        "drive": drive | ({"hub_inertia": 0.004} if indirect else {}),
        "heat": HEAT,
        "tolerance": TOLERANCE,
    }


@functools.cache
def checked(space):
    """Objectives and what is required in service of every candidate that passes a check, by its own spec each."""
    variants, search = SPACES[space]
    found = []
    for variant in variants:
        controlled, indirect = variant != "conventional", variant == "indirect"
        axes = [search["pairs"], search["outer_radius"]]
        axes += [search["gain"] if controlled else [None]]
        axes += [search["closing_stiffness"] if indirect else [None]]
        for pairs, outer, gain, stiffness in itertools.product(*axes):
            need = needed(space)
            data = {
                "variant": variant,
                "friction": FRICTION,
                "friction_group": {"pairs": pairs, "inner_radius": 0.05, "outer_radius": outer},
                "adjustment": {"method": "mean-friction", "nominal_torque": 100.0},
                "closing_spring": {"stiffness": stiffness} if indirect else {},
                "requirements": {"nominal_torque": 100.0 * (1 - 1e-12), "torque_max": TORQUE_MAX, **LOOSE},
                **{block: need[block] for block in ("drive", "heat", "tolerance")},
            }
            if variant == "differentiated":
                data["friction_group"]["driving_pairs"] = 1
            if controlled:
                data["control_unit"] = {"gain": gain, "ball_circle_radius": 0.045, **UNIT, **(HUB if indirect else {})}
            if indirect:
                data["control_spring"] = {"stiffness": 1e5}
            clutch = build(make_spec(json.loads(json.dumps(data))))
            result, _ = check(clutch, answers=Answers(clutch, scattered_peaks=False))
            force = float(clutch.pack_force_at_rest)
            if result.passed and 200 <= force <= 1e4:
                values = {row.requirement: None if row.passed is None else row.value for row in result.requirements}
                found.append(([force, float(clutch.accuracy_factor), pairs], values))
    return found


def holds(values, name, limit):
    if values[name] is None:
        return False
    return values[name] >= limit * (1 - 1e-9) if name == "trips_per_hour" else values[name] <= limit * (1 + 1e-9)


def limit_of(space, name, share):
    """A limit that about a share of the candidates hold, between two of them."""
    if name == "exceedance":
        return 1e-8
    values = sorted({round(values[name], 9) for _, values in checked(space) if values[name] is not None})
    if name == "trips_per_hour":
        values.reverse()
    place = min(int(share * len(values)), len(values) - 2)
    return (values[place] + values[place + 1]) / 2


def brute(space, limits):
    rows = [row for row, values in checked(space) if all(holds(values, *item) for item in limits.items())]
    best = [
        row for row in rows
        if not any(all(np.less_equal(other, np.multiply(row, 1 - 1e-9) + 0)) or
                   (all(np.less_equal(other, np.multiply(row, 1 + 1e-9))) and any(np.less(other, np.multiply(row, 1 - 1e-9))))
                   for other in rows)
    ]  # fmt: skip
    return len(rows), np.unique(np.round(np.array(best).reshape(-1, 3), 6), axis=0)


CASES = [tuple(LOOSE), ("peak_torque",), ("work",), ("face_temperature",), ("exceedance",)]
"""Each alone is held to brute force by ``test_referee`` too, in another drive."""


@pytest.mark.every(5)
@pytest.mark.parametrize("names", CASES, ids="+".join)
def test_the_front_is_that_of_all_that_pass_a_check(names):
    space = "direct"
    limits = {name: limit_of(space, name, 0.5 if len(names) == 1 else 0.8) for name in names}
    limits["temperature"] = limits.get("temperature", LOOSE["temperature"])
    if "trips_per_hour" in names:  # which follow from the temperature that is required
        limits["temperature"] = LOOSE["temperature"]
    count, best = brute(space, limits)
    need = make_requirements(needed(space, **limits))
    result, _ = design(need)
    found = np.array([[row.objective(name) for name in OBJECTIVES] for row in result.front]).reshape(-1, 3)
    np.testing.assert_allclose(np.unique(np.round(found, 6), axis=0), best, rtol=1e-9)
    # counted as feasible: all that pass, and some that nobody asked
    assert result.feasible - result.unasked <= count <= result.feasible
    for row in result.front[:1]:
        spec = with_picked(need, result, row.number)[1]
        clutch = build(spec)
        judged, _ = check(clutch, answers=Answers(clutch, scattered_peaks=False))
        said = {asked.requirement: asked.value for asked in judged.requirements}
        for name in limits:
            assert holds(said, name, limits[name])


def test_a_quick_look_says_so_and_what_it_lets_through_is_not_written():
    data = needed("direct", peak_torque=1.0, torque_max=1e4) | {"variants": ["conventional"]}
    data["search"] = {key: data["search"][key] for key in ("inner_radius", "closing_force")} | {
        "pairs": 6,
        "outer_radius": 0.11,
    }
    need = make_requirements(data)
    result, findings = design(need, simulate=False)
    assert result.front
    assert "front-not-simulated" in {each.code for each in findings}
    with pytest.raises(CalculationError, match="--pick 1: a check fails it.*: peak torque"):
        with_picked(need, result, 1)
