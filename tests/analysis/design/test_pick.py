"""What is picked from a front: in round figures it passes a check, and its row is what the commands tell of the file."""

import tomllib

import numpy as np
import pytest
from conftest import CONFIGS

import afmcalc as api

FILE = CONFIGS / "requirements.toml"
BASE = tomllib.loads(FILE.read_text(encoding="utf-8"))
FEW = ["--set", "search.pairs=[8, 12]", "--set", "search.mean_radius=0.12"]


def changed(**tables):
    """The example with tables changed, None: without the key."""
    merged = {name: {**BASE.get(name, {}), **value} if isinstance(value, dict) and name != "friction" else value for name, value in tables.items()}  # fmt: skip
    return BASE | {name: {key: item for key, item in value.items() if item is not None} if isinstance(value, dict) else value for name, value in merged.items()}  # fmt: skip


@pytest.mark.parametrize("asked", ["knee", "03"])
def test_a_pick_is_asked_for_by_number_or_as_the_knee(asked, afmcalc, answered, tmp_path):
    front, target = answered("design", FILE, *FEW, "--json").json["result"], tmp_path / "picked.toml"
    number = front["knee"] if asked == "knee" else 3
    run = afmcalc("design", FILE, *FEW, "--pick", asked, "--json", "-o", target)
    (row,) = run.json["result"]["picked"]
    assert row["number"] == number
    assert row["pairs"] == run.json["spec"]["friction_group"]["pairs"] == front["front"][number - 1]["pairs"]
    assert run.json["result"]["front"] == front["front"]
    again = afmcalc("torque", target, "--json").json
    assert (again["spec"], again["result"]["closing_force"]) == (run.json["spec"], row["closing_force"])
    assert afmcalc("check", "-", stdin=run.out).code == 0


def test_a_number_that_is_none_is_refused(afmcalc):
    few = [*FEW, "--set", "search.gain=[0.4, 0.6]"]
    for wrong in ("0", "222", "²", "9" * 5000, "kne"):
        assert afmcalc("design", FILE, *few, "--pick", wrong).code == 2
    assert afmcalc("design", FILE, *few, "--pick", "knee", "--set", 'objectives=["closing_force"]').code == 2


def test_the_clutch_picked_is_shown_alone_with_what_a_check_says(afmcalc, answered, tmp_path):
    target = tmp_path / "picked.toml"
    alone = afmcalc("design", FILE, *FEW, "--pick", "knee", "--quiet", "--output", target)
    assert alone.err == ""
    assert "no.  variant" not in alone.out
    verdict = afmcalc("check", target, "--json").json
    assert answered("design", FILE, *FEW, "--pick", "knee", "--json").json["result"]["verdict"] == verdict["result"]
    assert not any(f"[{each['code']}" in alone.out for each in verdict["findings"])
    loud = answered("design", FILE, *FEW, "--pick", "knee").out
    assert all(f"[{each['code']}" in loud for each in verdict["findings"])
    assert all(f"{row['utilisation']:.5g}" in alone.out for row in verdict["result"]["requirements"])


@pytest.mark.parametrize("contact_force", [5000.0, None])
def test_no_ball_beyond_what_hardened_steel_bears(contact_force):
    """Johnson, Contact Mechanics, (4.24): p_0³ = 6 F E_c²/(π³ r²), 206 GPa and 0.3; a limit of the force instead knows no balls."""
    need = changed(objectives=["closing_force", "ball_diameter"], limits={"contact_force": contact_force})
    modulus, front = 206e9 / (2 * (1 - 0.3**2)), api.design(need).front
    most = max((24 * row.contact_force * modulus**2 / (np.pi**3 * row.ball_diameter**2)) ** (1 / 3) for row in front)
    assert most > 4.2e9 if contact_force else 0.9 * 4.2e9 < most <= 4.2e9 * (1 + 1e-9)


def test_a_friction_material_limits_the_pressure_at_the_inner_edge():
    """Cork: 55 kPa, the lower end of the printed range."""
    result = api.design(changed(objectives=["accuracy_factor", "closing_force"], friction={"material": "cork-dry"}))
    assert result.excluded["material_pressure"] > 0
    edge = [row.closing_force / (2 * np.pi * row.inner_radius * (row.outer_diameter / 2 - row.inner_radius)) for row in result.front]  # fmt: skip
    assert 0.9 * 55e3 < max(edge) <= 55e3 * (1 + 1e-9)


ANGLE = {"wall_angle": {"start": 0.1, "stop": 0.5, "count": 17}, "gain": None}


@pytest.mark.parametrize("steering", [{}, pytest.param(ANGLE, marks=pytest.mark.slow)])
def test_figures_that_a_drawing_bears(steering):
    """Three digits for what is cut, of a degree too, four for the force."""
    need, few = changed(objectives=["closing_force", "accuracy_factor"], search=steering), []
    for number in (1, 8, 15):
        answer = api.design(need, pick=number)
        spec = api.Clutch(answer.spec).spec
        unit, group = spec.control_unit, spec.friction_group
        cut = np.degrees(unit.wall_angle) if steering else unit.gain
        figures = cut, 1e3 * unit.ball_circle_radius, 1e3 * group.inner_radius, 1e3 * group.outer_radius
        assert answer.picked[0].closing_force == float(f"{answer.picked[0].closing_force:.4g}")
        few.append(all(value == pytest.approx(float(f"{value:.3g}"), rel=1e-10) for value in figures))
    assert sum(few) >= 2


@pytest.mark.slow
def test_springs_finds_the_springs_of_every_clutch_proposed():
    """Between the grid points too; with discs, whose force is no straight line, a check passes."""
    room = {"inner_diameter": 0.02, "outer_diameter": 0.08, "length": 0.08}
    need = changed(
        variants=["indirect"], objectives=["closing_force", "accuracy_factor", "travel"], springs="disc",
        wanted={"nominal_torque": 150, "accuracy_factor": None, "torque_max": None}, limits={"gain_limit": False, "surface_pressure": None},
        search={
            "pairs": [6, 8], "mean_radius": {"start": 0.08, "stop": 0.12, "count": 4}, "gain": {"start": 0.6, "stop": 2.0, "count": 4},
            "ball_circle_radius": [0.04, 0.05], "closing_stiffness": {"start": 1e5, "stop": 8e5, "count": 4},
            "control_stiffness": [0.0, 1e5, 3e5], "closing_force": {"min": 100, "max": 1e5},
        },
        fixed={"hub_diameter": 0.05, "key_friction": 0.01, "face_width": None, "closing_room": room,
               "control_room": {"inner_diameter": 0.05, "outer_diameter": 0.2}},
    )  # fmt: skip
    front = api.design(need).front
    assert len(front) > 3
    for number in range(1, len(front) + 1):
        answer = api.design(need, pick=number)
        (row,), clutch = answer.picked, api.Clutch(answer.spec)
        found = clutch.springs(kind="disc", top=1000)
        named = {f"{each.part}, {each.parallel}" for each in (*found.closing, *found.control)}
        assert {part.partition(" ×")[0] for part in (row.closing_part, row.control_part)} <= named
        assert clutch.check().passed
        assert clutch.accuracy().accuracy_factor == row.accuracy_factor_sprung
        assert 150 * (1 - 1e-12) <= clutch.torque().nominal_torque < 150.2
