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
    data = dict(BASE)
    for name, value in tables.items():
        merged = {**BASE.get(name, {}), **value} if isinstance(value, dict) and name != "friction" else value
        data[name] = (
            {key: item for key, item in merged.items() if item is not None} if isinstance(value, dict) else value
        )
    return data


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
    assert afmcalc("check", target, "--json").json["result"] == run.json["result"]["verdict"]
    for wrong in ("0", "222", "²", "9" * 5000, "kne"):
        assert afmcalc("design", FILE, *FEW, "--pick", wrong, "--set", "search.gain=[0.4, 0.6]").code == 2


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
