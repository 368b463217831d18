"""What a second newcomer stumbled over, held."""

import pytest
from conftest import CONFIGS

M1 = ["--set", "F=1265.4", "--set", "adjustment.method=mean-friction", "--set", "drive.dynamic_factor=2",
      "--set", "fatigue.endurance_limit=40 MPa", "--set", "fatigue.polar_section_modulus=4 cm^3",
      "--set", "fatigue.ultimate_strength=150 MPa", "--set", "fatigue.mean_stress_sensitivity=0.1"]  # fmt: skip


def test_static_strength_is_held_against_the_spring_as_set(afmcalc):
    """T_max = 213.1 N·m, ×2/4 cm³ = 106.6 MPa < 150 MPa: no failure; at 100 MPa there is one."""
    assert afmcalc("check", *M1).code == 0
    life = afmcalc("life", *M1, "--json").json
    low, high = 2 * 74.9866 / 4e-6, 2 * 213.12 / 4e-6
    assert life["result"]["stress_unprotected"] == pytest.approx((low + high) / 2, rel=1e-4)
    weak = afmcalc("life", *M1, "--set", "fatigue.ultimate_strength=100 MPa", "--model", "goodman", "--json").json
    assert weak["result"]["stress_unprotected"] is None
    assert weak["result"]["unprotected"]["mean_friction"] == 0
    assert "static-strength-exceeded" in [finding["code"] for finding in weak["findings"]]


def test_a_life_without_limit_is_found_for_either_setting(afmcalc):
    codes = [f["message"] for f in afmcalc("life", *M1, "--json").json["findings"] if f["code"] == "life-not-limited"]
    assert any("mean-friction" in message for message in codes)


def test_sweeps_with_null_lives_are_drawn(afmcalc):
    for sweep in ("C=0.1,0.5,1", "z=4:12:9", "dT=10,100,400"):
        run = afmcalc("life", *M1, "--model", "amplitude", "--sweep", sweep)
        assert run.code == 0, run.err
        assert "Traceback" not in run.err
    assert "no limit" in afmcalc("life", "--model", "amplitude", "--set", "fatigue.mean_stress_sensitivity=0").out


@pytest.mark.parametrize("name", ["R", "f1", "d", "c1", "c2", "z", "F", "C"])
def test_default_sweeps_of_an_indirect_clutch_stay_where_it_can_be_built(name, afmcalc):
    for command in ("accuracy", "life"):
        run = afmcalc(command, CONFIGS / "indirect.toml", "--sweep", name, "--json")
        assert run.code == 0, run.err


def test_explain_shows_the_stop_the_corners_and_the_cycles(afmcalc):
    indirect = afmcalc(
        "explain", "torque", CONFIGS / "indirect.toml", "--set", "adjustment.method=mean-friction", "--json"
    )
    assert all(step["value"] >= 0 for step in indirect.json["result"]["steps"] if step["symbol"] == "x")
    corners = {step["at"] for step in afmcalc("explain", "accuracy", "--json").json["result"]["steps"]}
    assert {"f_1min, f_2max", "f_1max, f_2min"} <= corners
    life = afmcalc("explain", "life", "--json").json["result"]["steps"]
    assert [step for step in life if step["function"] == "life.cycles"]
    goodman = ["--model", "goodman", "--set", "fatigue.ultimate_strength=900 MPa"]
    assert "equivalent_stress_goodman" in afmcalc("explain", "life", *goodman, "--json").out
    assert afmcalc("explain", "torque", "--model", "goodman").code == 2
    stress = next(step for step in life if step["function"] == "life.shear_stress")
    assert "/((1.5·10^-5) m³)" in stress["substituted"] or "(1.5·10^-5)" in stress["substituted"]


def test_falling_torque_is_explained(afmcalc):
    falling = ["--set", "friction.driving.min=0.5", "--set", "friction.driven.min=0.1", "--set", "C=3"]
    steps = afmcalc("explain", "accuracy", CONFIGS / "unlike-materials.toml", *falling, "--json").json["result"][
        "steps"
    ]
    notes = [step["note"] for step in steps if step["note"]]
    assert any("the inverse, 1.1037" in note for note in notes)


def test_balls_that_do_not_fit_are_found(afmcalc):
    crowded = afmcalc("synthesize", "--set", "control_unit.balls=20", "--json").json
    (finding,) = [f for f in crowded["findings"] if f["code"] == "balls-overlap"]
    assert finding["value"] == pytest.approx(0.025)
    assert finding["limit"] == pytest.approx(0.01564, abs=1e-5)
    assert afmcalc("synthesize", CONFIGS / "indirect.toml", "--json").json["result"]["pocket_depth"] > 0


def test_findings_of_every_variant_compared_are_told(afmcalc):
    run = afmcalc("compare", CONFIGS / "indirect.toml", "--variants", "--json").json
    warned = {row["variant"] for row in run["result"]["clutches"] if row["warnings"]}
    told = {f["message"].partition(":")[0] for f in run["findings"] if f["level"] == "warning"}
    assert warned <= told
