"""What is picked from a front: in round figures it passes a check, and its row is what the commands tell of the file."""

import json
import tomllib

import numpy as np
import pytest
from conftest import CONFIGS, several

from afmcalc.analysis.accuracy import accuracy
from afmcalc.analysis.check import check
from afmcalc.analysis.design.design import design
from afmcalc.analysis.design.pick import with_picked, with_verdict
from afmcalc.analysis.synthesize import synthesize
from afmcalc.analysis.torque import torque
from afmcalc.engines import build
from afmcalc.spec import make_spec, resolved
from afmcalc.spec.requirements import make_requirements
from afmcalc.spec.write import to_toml

BASE = tomllib.loads((CONFIGS / "requirements.toml").read_text(encoding="utf-8"))
VARIANTS = ["conventional", "differentiated", "all-driving", "indirect"]
OBJECTIVES = [
    "closing_force", "accuracy_factor", "pairs", "ball_diameter", "travel",
    "control_force", "closing_deflection", "control_deflection",
]  # fmt: skip
KINDS = ["direct", "indirect", "curved", "sprung", "sprung indirect", "unlike"]
ONLY_WARN = {
    "feedback-idle", "gain-above-limit", "reduced-gain-above-limit", "unusual",
    "below-nominal-torque", "returning-below-nominal",
}  # fmt: skip
"""What a file asks for itself: gain 0, a gain beyond its limit, a torque set at the mean."""


def grid(low, high, count):
    return {"start": float(low), "stop": float(high), "count": int(count)}


def random_requirements(rng):
    """A file of any variant, with ranges whose ends and grid points are no round figures."""
    kind, between = rng.choice(KINDS), lambda low, high: float(rng.uniform(low, high))
    some = lambda low, high: grid(between(low, 1.2 * low), between(0.8 * high, high), rng.integers(3, 9))  # noqa: E731
    maybe = lambda value: value if rng.random() < 0.5 else None  # noqa: E731
    variants = {"direct": [*rng.permutation(VARIANTS[:3])[: rng.integers(1, 4)]], "unlike": ["differentiated"], "sprung": ["all-driving"]}.get(kind, ["indirect"])  # fmt: skip
    sleeve, angle, both = variants == ["indirect"], rng.random() < 0.4, rng.random() < 0.4
    friction = {"material": str(rng.choice(["woven-dry", "moulded-dry", "cork-dry", "sintered-dry"]))} if rng.random() < 0.4 else {"min": 0.1, "mean": 0.3, "max": 0.8}  # fmt: skip
    if kind == "unlike":
        friction = {"driving": {"min": 0.1, "mean": 0.35, "max": 0.4}, "driven": {"material": "woven-dry"}}
    width = None if both or rng.random() < 0.3 else between(0.015, 0.04)
    method = str(rng.choice(["min-friction", "mean-friction"]))
    data = {
        "variants": [str(each) for each in variants],
        "objectives": [str(each) for each in rng.permutation(OBJECTIVES)[: rng.integers(1, 4)]],
        "friction": friction,
        "wanted": {
            "machine_torque" if rng.random() < 0.3 else "nominal_torque": between(50, 300), "method": method,
            "accuracy_factor": maybe(between(2, 6)), "margin": maybe(between(1, 1.4)), "torque_max": maybe(between(500, 1500)),
        },
        "search": {
            "pairs": [4, 8, 12],
            "driving_pairs": [1, 2] if "differentiated" in variants else None,
            "mean_radius": None if both else some(0.06, 0.15),
            "inner_radius": some(0.04, 0.07) if both else None,
            "outer_radius": some(0.08, 0.18) if both else None,
            "gain": None if angle else some(0.1, 2.5),
            "wall_angle": some(0.15, 1.1) if angle else None,
            "ball_circle_radius": some(0.03, 0.06),
            "closing_force": {"min": 100.0, "max": 1e5},
            "closing_stiffness": some(1e5, 9e5) if sleeve else None,
            "control_stiffness": some(5e4, 4e5) if sleeve else None,
        },
        "fixed": {"hub_diameter": 0.05, "key_friction": 0.02, "face_gap": 1e-3, "edge_clearance": 1e-3, "face_width": width},
        "limits": {
            "surface_pressure": between(3e5, 3e6) if both or width else None,
            "outer_diameter": maybe(between(0.2, 0.4)) if both or width else None,
            "contact_force": maybe(between(1500, 5000)) if rng.random() < 0.4 else None,
            "travel": maybe(between(5e-3, 0.03)) if sleeve else None,
            "reduced_gain": maybe(between(4, 12)),
            "gain_limit": bool(rng.random() < 0.8),
        },
    }  # fmt: skip
    if kind.startswith("sprung"):
        data["springs"] = "disc"
        data["fixed"]["closing_room"] = {"inner_diameter": 0.02, "outer_diameter": 0.12}
        if sleeve:
            data["fixed"]["control_room"] = {"inner_diameter": 0.05, "outer_diameter": 0.2}
    if kind == "curved":
        data["fixed"]["pocket"] = "constant-torque"
    return make_requirements(json.loads(json.dumps(without_none(data))))


def without_none(data):
    if not isinstance(data, dict):
        return data
    return {name: without_none(value) for name, value in data.items() if value is not None}


def assert_kept(need, result, number):
    """The file passes a check, and each value of the row is that of the command which tells it."""
    chosen, spec = with_picked(need, result, number)
    (row,) = chosen.picked
    assert chosen.front == result.front
    clutch = build(make_spec(tomllib.loads(to_toml(resolved(spec)))))
    assert clutch.spec == spec
    verdict, findings = check(clutch)
    assert verdict.passed, [each.message for each in findings if each.level == "error"]
    warned = {each.code for each in findings if each.level == "warning"}
    if need.springs is None:
        assert warned <= ONLY_WARN, warned
    told = torque(clutch)[0]
    torques = [clutch.torque(*ends) for ends in zip(*clutch.friction, strict=True)]
    same = {
        "nominal_torque": told.nominal_torque, "closing_force": told.closing_force, "control_force": told.control_force,
        "accuracy_factor": accuracy(clutch)[0].accuracy_factor, "torque_max": max(torques), "gain": told.gain,
        "gain_slope": told.gain_slope, "pack_force_at_rest": told.pack_force_at_rest,
        "travel": told.travel and max(told.travel.min, told.travel.mean, told.travel.max),
        "outer_diameter": spec.friction_group.outer_radius and 2 * spec.friction_group.outer_radius,
    }  # fmt: skip
    if row.gain:
        made, _ = synthesize(clutch)
        same |= {"ball_diameter": made.ball_diameter_standard, "contact_force": made.contact_force}
        same |= {"ball_circle_radius": made.ball_circle_radius, "travel": made.travel_max if row.travel is not None else None}  # fmt: skip
        if row.wall_angle is not None:
            same["wall_angle"] = made.wall_angle
    judged = {each.requirement: each.value for each in verdict.requirements}
    same |= {name: judged[name] for name in ("nominal_torque", "machine_torque", "surface_pressure", "accuracy_factor", "torque_max", "travel", "outer_diameter") if name in judged}  # fmt: skip
    for name, value in same.items():
        mine = getattr(row, name)
        if mine is not None:
            assert mine == pytest.approx(value, rel=1e-12, abs=0), name
    exact = result.front[number - 1]
    assert row.objective(need.objectives[0]) <= exact.objective(need.objectives[0]) * 1.01 or need.springs


def test_what_is_picked_passes_and_is_what_the_file_says():
    fronts, count = 0, several(8, 40)
    for seed in range(count):
        need = random_requirements(np.random.default_rng(seed))
        result, _ = design(need)
        fronts += bool(result.front)
        for number in sorted({1, result.knee or 1, result.on_front} if result.front else ()):
            assert_kept(need, result, number)
    assert fronts > 0.6 * count


def changed(objectives, **tables):
    data = json.loads(json.dumps(BASE)) | {"objectives": objectives}
    for name, value in tables.items():
        data[name] = value if name == "friction" else data[name] | value
    return make_requirements(without_none(data))


def test_refined_rows_at_a_ball_size_can_be_picked():
    """26 of these 60 failed: 47.625 mm is smaller than 47.625 mm."""
    need = changed(["closing_force", "ball_diameter"], limits={"contact_force": 5000.0})
    result, _ = design(need)
    assert result.on_front >= 60
    for number in range(1, result.on_front + 1)[:: several(result.on_front // 8, 1)]:
        assert_kept(need, result, number)
        row = with_picked(need, result, number)[0].picked[0]
        assert row.ball_diameter <= result.front[number - 1].ball_diameter * 1.005
        # figures that a drawing bears
        assert all(len(f"{value:.6g}".strip("0.").replace(".", "")) <= 5 for value in (row.gain, row.closing_force))


def test_no_ball_beyond_what_hardened_steel_bears():
    """Johnson, Contact Mechanics, (4.24): p_0³ = 6 F E_c²/(π³ r²), 206 GPa and 0.3; the flat 5 kN knew no balls."""
    pressures = []
    for limits in ({"contact_force": 5000.0}, {"contact_force": None}):
        result, _ = design(changed(["closing_force", "ball_diameter"], limits=limits))
        modulus = 206e9 / (2 * (1 - 0.3**2))
        pressures.append(
            [
                (24 * row.contact_force * modulus**2 / (np.pi**3 * row.ball_diameter**2)) ** (1 / 3)
                for row in result.front
            ]
        )
    assert max(pressures[0]) > 4.2e9 >= max(pressures[1]) * (1 - 1e-9)


def test_a_friction_material_limits_the_pressure_at_the_inner_edge():
    """Cork: 55 kPa, the lower end of the printed range."""
    result, _ = design(changed(["accuracy_factor", "closing_force"], friction={"material": "cork-dry"}))
    assert result.excluded["material_pressure"] > 0
    edge = [row.closing_force / (2 * np.pi * row.inner_radius * (row.outer_diameter / 2 - row.inner_radius)) for row in result.front]  # fmt: skip
    assert 0.9 * 55e3 < max(edge) <= 55e3 * (1 + 1e-9)


@pytest.mark.parametrize("steering", ["gain", "wall_angle"])
def test_figures_that_a_drawing_bears(steering):
    """Three digits for what is cut, of a degree too; each objective within half a percent, no limit missed."""
    angle = {"wall_angle": grid(0.1, 0.5, 17), "gain": None} if steering == "wall_angle" else {}
    need = changed(["closing_force", "accuracy_factor"], search=angle)
    result, _ = design(need)
    few = 0
    for row in result.front[:: several(len(result.front) // 12, 1)]:
        told, spec = with_picked(need, result, row.number)
        (picked,) = told.picked
        verdict = with_verdict(told, spec)[0].verdict
        assert verdict.passed
        assert all(each.passed for each in verdict.requirements)
        for name in need.objectives:
            assert picked.objective(name) <= row.objective(name) * 1.005 * (1 + 1e-9)
        unit, group = spec.control_unit, spec.friction_group
        cut = unit.gain if steering == "gain" else np.degrees(unit.wall_angle)
        figures = cut, 1e3 * unit.ball_circle_radius, 1e3 * group.inner_radius, 1e3 * group.outer_radius
        assert picked.closing_force == float(f"{picked.closing_force:.4g}")
        few += all(value == pytest.approx(float(f"{value:.3g}"), rel=1e-10) for value in figures)
    assert few >= 10
