"""Every requirement of a design against brute force: each candidate written by hand and given to a check, once."""

import functools
import itertools
import tomllib

import pytest
from conftest import CONFIGS

import afmcalc
from afmcalc.analysis.design.design import design
from afmcalc.spec.requirements import make_requirements

BASE = tomllib.loads((CONFIGS / "conveyor.toml").read_text(encoding="utf-8"))
BASE["drive"]["driven_inertia"] = 0.01
BLOCKS = {
    "drive": BASE["drive"],
    "heat": {**BASE["heat"], "disc_mass": 0.8, "lining": 1e-4},
    "fatigue": {"endurance_limit": 4e7, "polar_section_modulus": 3e-6, "exponent": 6, "base_cycles": 1e7},
    "tolerance": {
        "samples": 1000, "sobol_base": 64, "seed": 1,
        "fields": {"friction": {"distribution": "uniform"}, "closing_spring.force": {"distribution": "normal", "spread": 0.02}},
    },
}  # fmt: skip
FRICTION = {"min": 0.2, "mean": 0.3, "max": 0.5}
TORQUE, STIFFNESS, WIDTH = 112.5, 1e5, 0.025
SPACE = {
    "pairs": [4, 6], "driving_pairs": [1, 2], "mean_radius": [0.055, 0.065], "gain": [0.4, 1.1, 1.9], "ball_circle_radius": [0.035],
}  # fmt: skip
BALLS = [0.007, 0.009, 0.0111]
OBJECTIVES = ["closing_force", "accuracy_factor", "pairs", "ball_diameter"]
LEAST = {"trips_per_hour", "torque_after_wear", "cycles"}
"""Required at least; all others at most."""
WANTED = [
    "accuracy_factor", "accuracy_factor_hysteresis", "torque_max", "peak_torque", "work", "temperature", "face_temperature",
    "trips_per_hour", "contact_pressure", "torque_after_wear", "cycles", "exceedance",
]  # fmt: skip
LIMITS = ["surface_pressure", "outer_diameter"]
LOOSE = {
    "accuracy_factor": 90, "accuracy_factor_hysteresis": 90, "torque_max": 240, "peak_torque": 9e4, "work": 1e9, "temperature": 2000,
    "face_temperature": 2000, "trips_per_hour": 1e-3, "contact_pressure": 9e9, "torque_after_wear": 1, "cycles": 1e-3, "exceedance": 0.999,
    "surface_pressure": 9e7, "outer_diameter": 9,
}  # fmt: skip
"""Limits that every candidate holds, but for torque_max, beyond which a torque counts as exceeded: alone it is none."""


def candidates():
    """Variant and parameters; a variant without a control unit has neither gain nor ball."""
    for pairs, bypass, radius, gain, circle in itertools.product(*SPACE.values()):
        if (bypass, gain) == (1, SPACE["gain"][0]):
            yield "conventional", {"pairs": pairs, "mean_radius": radius}, {}
        for ball in BALLS:
            unit = {"gain": gain, "ball_circle_radius": circle, "ball_diameter": ball}
            if bypass == 1:
                yield "all-driving", {"pairs": pairs, "mean_radius": radius}, unit
            yield "differentiated", {"pairs": pairs, "driving_pairs": bypass, "mean_radius": radius}, unit


def errors(check):
    return {each.code for each in check.findings if each.level == "error"} - {"requirement-missed"}


@functools.cache
def checked():
    """What counts of each candidate that nothing is wrong with, and the value that a check has for each requirement."""
    good = []
    for variant, group, unit in candidates():
        radius = group.pop("mean_radius")
        control = {"balls": 6, "face_gap": 5e-4, "edge_clearance": 1e-3, **unit}
        bare = {
            "variant": variant,
            "friction": FRICTION,
            "friction_group": {**group, "inner_radius": radius - WIDTH / 2, "outer_radius": radius + WIDTH / 2},
            "closing_spring": {"stiffness": STIFFNESS},
            **({"control_unit": control} if unit else {}),
            "adjustment": {"method": "min-friction", "nominal_torque": TORQUE},
        }
        first = afmcalc.load(bare).check()  # before anything is simulated
        if errors(first) or any(row.verdict != "pass" for row in first.limits):
            continue
        clutch = afmcalc.load({**bare, **BLOCKS, "requirements": LOOSE})
        check = clutch.check()
        if not errors(check):
            values = {row.requirement: row.value for row in check.requirements}
            force = clutch.torque().closing_force
            good.append(((force, values["accuracy_factor"], group["pairs"], unit.get("ball_diameter", 0.0)), values))
    return good


def beyond(name, value, limit):
    return value is not None and (value < limit if name in LEAST else value > limit)


def middling(name, share):
    """A limit that about this share of the candidates hold, in the middle between two values that there are."""
    values = sorted((values[name] for _, values in checked() if values[name] is not None), reverse=name in LEAST)
    gaps = [
        place for place in range(len(values) - 1) if abs(values[place + 1] - values[place]) > 1e-6 * abs(values[place])
    ]
    place = min(gaps, key=lambda place: abs(place + 1 - share * len(values)))
    return (values[place] + values[place + 1]) / 2


def brute_front(limits):
    good = [
        rounded(counted)
        for counted, values in checked()
        if not any(beyond(name, values[name], limit) for name, limit in limits.items())
    ]
    return {
        one
        for one in good
        if not any(all(a <= b for a, b in zip(two, one, strict=True)) and two != one for two in good)
    }


def rounded(values):
    return tuple(float(f"{value:.8g}") for value in values)


def requirements(limits):
    needed = {"exceedance": "torque_max", "trips_per_hour": "temperature"}  # what both are counted by
    limits = limits | {needed[name]: LOOSE[needed[name]] for name in limits if name in needed}
    return {
        "variants": ["conventional", "differentiated", "all-driving"],
        "objectives": OBJECTIVES,
        "friction": FRICTION,
        "wanted": {"nominal_torque": TORQUE, **{name: limits[name] for name in limits if name in WANTED}},
        "search": {
            **SPACE,
            "ball_diameters": BALLS,
            "closing_force": {"min": 1, "max": 1e6},
            **({"closing_stiffness": STIFFNESS} if STIFFNESS else {}),
        },
        "fixed": {"balls": 6, "face_gap": 5e-4, "edge_clearance": 1e-3, "face_width": WIDTH},
        "limits": {name: limits[name] for name in limits if name in LIMITS},
        **{name: block for name, block in BLOCKS.items() if name != "tolerance" or "exceedance" in limits},
    }


def front(limits):
    found = design(make_requirements(requirements(limits)), simulate=True)[0].front
    return {rounded((row.closing_force, row.accuracy_factor, row.pairs, row.ball_diameter or 0.0)) for row in found}


@pytest.mark.parametrize("share", [0.2, 0.6])
@pytest.mark.parametrize("name", [*WANTED, *LIMITS])
def test_one_requirement(name, share):
    limit = middling(name, share)
    wanted = {name: limit}
    best = brute_front(wanted)
    assert best
    assert front(wanted) == best


@pytest.mark.parametrize("share", [0.75, 0.9])
def test_all_together(share):
    limits = {name: middling(name, share) for name in [*WANTED, *LIMITS]}
    limits |= {name: LOOSE[name] for name in ("torque_max", "temperature")}
    best = brute_front(limits)
    assert best
    assert front(limits) == best
