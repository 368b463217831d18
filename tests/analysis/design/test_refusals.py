"""Requirements that are refused: each by the key to put right, before anything is searched."""

import json
import tomllib

import pytest
from conftest import CONFIGS

from afmcalc import SpecError
from afmcalc.spec.requirements import make_requirements

BASE = tomllib.loads((CONFIGS / "requirements.toml").read_text(encoding="utf-8"))
CONVEYOR = tomllib.loads((CONFIGS / "conveyor.toml").read_text(encoding="utf-8"))
FATIGUE = {"endurance_limit": 1e8, "exponent": 6, "base_cycles": 1e7, "polar_section_modulus": 1e-5}
SLEEVE = {
    "variants": ["indirect"], "search.closing_stiffness": 4e5, "search.control_stiffness": 1e5, "fixed.hub_diameter": 0.05,
    "fixed.key_friction": 0.02,
}  # fmt: skip
BOTH = {"search.mean_radius": None, "search.inner_radius": 0.1, "search.outer_radius": 0.2}
SPACE = {"disc_thickness": 0.003, "plate_thickness": 0.008, "housing_wall": 0.006}

VALUES = {
    "search.mean_radius": [
        {"start": 0.2, "stop": 0.1, "count": 5}, {"start": 0.1, "stop": 0.2}, {"start": 0.1, "stop": 0.2, "cuont": 3},
        {"start": 0.1, "stop": 0.2, "step": 1e-300}, [], "1 N", -1, [0.1] * 10_001, None,
    ],
    "search.pairs": [[2.5], True, 0, {"start": 2, "stop": 10_000_000}],
    "search.ball_diameters": [{"start": 1e-3, "stop": 1, "count": 10_000_000}],
    "search.gain": [[0.5, -0.1], None],
    "search.ball_circle_radius": [0, None],
    "search.closing_stiffness": [0],
    "search.control_stiffness": [-1],
    "search.closing_force": [None],
    "search.radius": [1],
    "fixed.face_width": [None],
    "fixed.closing_room": [{"inner_diameter": 0.02, "outer_diameter": 0.1}],
    "fixed.pocket": ["constant-torque"],
    "limits.gain_limit": ["off"],
    "limits.outer_diameter": [-1],
    "variants": [[]],
    "friction.material": ["unobtainium", ["moulded-dry", "moulded-dry"]],
    "wanted.nominal_torque": [None],
    "wanted.accuracy_factor": [0.5],
}  # fmt: skip
"""Key → values of it that are refused there."""
OTHERS = [
    ("search.mean_radius", {"search.outer_radius": 0.2}),
    ("search.mean_radius", {"search.mean_radius": None, "search.inner_radius": 0.1}),
    ("search.outer_radius", BOTH | {"search.inner_radius": 0.2, "fixed.face_width": None}),
    ("fixed.face_width", BOTH),
    ("fixed.face_width", {"fixed.face_width": None, "limits.surface_pressure": None, "limits.outer_diameter": 0.2}),
    ("search.wall_angle", {"search.gain": None, "search.wall_angle": [5, 10]}),
    ("search.wall_angle", {"search.gain": None, "search.wall_angle": "-1 deg"}),
    ("search.closing_force.max", {"search.closing_force": {"min": 5, "max": 1}}),
    ("search.closing_forces", {"search.closing_force": None, "search.closing_forces": [0]}),
    ("search.closing_stiffness", {"variants": ["indirect"]}),
    ("variants.0", {"variants": ["direct"]}),
    ("objectives.0", {"objectives": ["mass"]}),
    ("friction.min", {"friction": {}}),
    ("friction.driving", {"friction": {"driving": {"material": "moulded-dry"}, "driven": {"material": "cork-dry"}}}),
    ("wanted.nominal_torque", {"wanted.machine_torque": 100}),
    ("wanted.temperature", {"wanted.trips_per_hour": 5, "heat": {"ambient": 293, "cooling": 2}, "drive": CONVEYOR["drive"]}),
    ("fatigue", {"wanted.cycles": 1e5}),
    ("heat.lining", {"wanted.torque_after_wear": 90, "heat": {"ambient": 293.15}}),
    ("search.closing_stiffness", {"wanted.torque_after_wear": 90, "heat": {"lining": 1e-4}}),
    ("drive.event", {"wanted.peak_torque": 500}),
    ("tolerance", {"wanted.exceedance": 0.1}),
    ("fixed.closing_room", {"springs": "disc"}),
    ("fixed.profiled", SLEEVE | {"fixed.profiled": "one"}),
    ("springs", SLEEVE | {"fixed.pocket": "constant-torque", "springs": "disc"}),
    ("envelope.hub_diameter", {"envelope": SPACE}),
]  # fmt: skip
OF_A_MACHINE = [
    ("machine.speed", {"machine.speed": None}),
    ("wanted.machine_torque", {"wanted.machine_torque": 90}),
    ("envelope.outer_diameter", {"envelope.outer_diameter": "30 mm"}),
    ("envelope.bore", {"envelope.bore": "30 mm"}),
    ("shaft.diameter", {"shaft.diameter": 0}),
    ("fatigue.polar_section_modulus", {"fatigue": FATIGUE}),
]  # fmt: skip


def changed(base, keys):
    """Requirements with keys changed, None: without."""
    data = json.loads(json.dumps(base))
    for path, value in keys.items():
        *blocks, name = path.split(".")
        place = data
        for block in blocks:
            place = place.setdefault(block, {})
        place.pop(name, None)
        if value is not None:
            place[name] = value
    return data


def test_requirements_are_refused_at_their_key():
    single = [(path, {path: value}) for path, values in VALUES.items() for value in values]
    wrong = []
    for base, (path, keys) in [(BASE, case) for case in [*single, *OTHERS]] + [(CONVEYOR, case) for case in OF_A_MACHINE]:  # fmt: skip
        try:
            make_requirements(changed(base, keys))
        except SpecError as refused:
            if path in {problem.path for problem in refused.problems}:
                continue
        wrong.append((path, keys))
    assert not wrong


@pytest.mark.parametrize("keys", [{"search.gain": None}, dict.fromkeys(["search.mean_radius", "search.gain"], {"start": 0.1, "stop": 0.2, "count": 1_000_000})])  # fmt: skip
def test_a_refusal_is_a_sentence_and_writes_nothing(keys, afmcalc, tmp_path, monkeypatch):
    """Too many candidates too, before any work."""
    monkeypatch.setattr("afmcalc.analysis.design.design.search", None)
    run = afmcalc("design", "-", "--pick", 1, "-o", tmp_path / "x.toml", stdin=json.dumps(changed(BASE, keys)))
    assert (run.code, run.out, run.err.count("error: ")) == (2, "", 1)
    assert not list(tmp_path.iterdir())
