"""Life: static strength comes first, a life without limit is said, null lives are drawn."""

import pytest

WEAK_SHAFT = ["--set", "F=1265.4", "--set", "adjustment.method=mean-friction", "--set", "drive.dynamic_factor=2",
      "--set", "fatigue.endurance_limit=40 MPa", "--set", "fatigue.polar_section_modulus=4 cm^3",
      "--set", "fatigue.ultimate_strength=150 MPa", "--set", "fatigue.mean_stress_sensitivity=0.1"]  # fmt: skip


def test_static_strength_is_held_against_the_spring_as_set(afmcalc):
    """T_max = 213.1 N·m, ×2/4 cm³ = 106.6 MPa < 150 MPa: no failure; at 100 MPa there is one."""
    assert afmcalc("check", *WEAK_SHAFT).code == 0
    life = afmcalc("life", *WEAK_SHAFT, "--json").json
    low, high = 2 * 74.9866 / 4e-6, 2 * 213.12 / 4e-6
    assert life["result"]["stress_unprotected"] == pytest.approx((low + high) / 2, rel=1e-4)
    weak = afmcalc(
        "life", *WEAK_SHAFT, "--set", "fatigue.ultimate_strength=100 MPa", "--model", "goodman", "--json"
    ).json
    assert weak["result"]["stress_unprotected"] is None
    assert weak["result"]["unprotected"]["mean_friction"] == 0
    assert "static-strength-exceeded" in [finding["code"] for finding in weak["findings"]]


def test_a_life_without_limit_is_found_for_either_setting(afmcalc):
    codes = [
        f["message"] for f in afmcalc("life", *WEAK_SHAFT, "--json").json["findings"] if f["code"] == "life-not-limited"
    ]
    assert any("mean-friction" in message for message in codes)


@pytest.mark.parametrize(("limit", "sides"), [(400, []), (16, ["unprotected"]), (12, ["protected", "unprotected"])])
@pytest.mark.parametrize("model", ["mean-stress", "goodman"])
def test_a_limited_life_is_said_side_by_side(limit, sides, model, afmcalc):
    """The base clutch bears 15.2 MPa in the mean, 21.3 MPa on the unprotected side."""
    sets = [f"fatigue.endurance_limit={limit} MPa", "drive.dynamic_factor=1.4", "fatigue.ultimate_strength=900 MPa"]
    asked = [part for each in sets for part in ("--set", each)]
    life = afmcalc("life", *asked, "--model", model, "--json").json
    found = [each for each in life["findings"] if each["code"] == "life-limited"]
    stressed = [side for side in ("protected", "unprotected") if life["result"][f"stress_{side}"] > limit * 1e6]
    assert [each["message"].partition(" ")[0] for each in found] == stressed
    lives = [life["result"][side]["min_friction"] for side in stressed]
    assert [each["value"] for each in found] == pytest.approx(lives)
    assert {each["level"] for each in found} <= {"info"}
    if model == "mean-stress":
        assert stressed == sides
        checked = afmcalc("check", *asked, "--strict", "--json")
        assert checked.code == 0
        assert found == [each for each in checked.json["findings"] if each["code"] == "life-limited"]
        rows = [each for each in checked.json["result"]["limits"] if "limited life" in each["name"]]
        assert [each["verdict"] for each in rows] == ["note" if each["utilisation"] > 1 else "pass" for each in rows]


def test_sweeps_with_null_lives_are_drawn(afmcalc):
    for sweep in ("C=0.1,0.5,1", "z=4:12:9", "dT=10,100,400"):
        run = afmcalc("life", *WEAK_SHAFT, "--model", "amplitude", "--sweep", sweep)
        assert run.code == 0, run.err
    assert "unlimited  –" in afmcalc("life", "--model", "amplitude", "--set", "fatigue.mean_stress_sensitivity=0").out


def test_an_unlimited_life_is_called_so_wherever_it_is_asked_for(afmcalc):
    found = afmcalc("life", "--json").json["result"]
    assert found["protected"]["unlimited"] == ["min-friction", "mean-friction"]
    assert found["protected"]["min_friction"] > found["base_cycles"]
    heavy = afmcalc("life", "--set", "fatigue.endurance_limit=12 MPa", "--json").json["result"]
    assert (heavy["protected"]["unlimited"], heavy["unprotected"]["unlimited"]) == (["mean-friction"], [])
    assert heavy["protected"]["min_friction"] < heavy["base_cycles"] < heavy["protected"]["mean_friction"]
    table = afmcalc("life", "--set", "fatigue.endurance_limit=12 MPa").out
    assert f"unlimited ({heavy['protected']['mean_friction']:.5g})" in table
    (line,) = (each for each in afmcalc("check", "--set", "requirements.cycles=1e6").out.splitlines() if "N_ц" in each)
    assert line.split()[-6:] == ["unlimited", "at", "least", "1000000", "–", "0", "yes"][-6:]
    (line,) = (
        each
        for each in afmcalc(
            "check", "--set", "requirements.cycles=1e6", "--set", "fatigue.endurance_limit=12 MPa"
        ).out.splitlines()
        if "N_ц" in each
    )
    assert line.split()[-7:-5] == ["324280", "at"]
