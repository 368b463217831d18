"""Requirements of a spec: which analysis judges each, and what a miss, or one that cannot be judged, amounts to."""

import math

import pytest
from conftest import CONFIGS

from afmcalc.analysis.asking import Answers
from afmcalc.engines import build
from afmcalc.errors import SpecError
from afmcalc.spec import make_spec, read_spec, resolved

# the base clutch by hand: T(f) = F R f (z_1 + z_2)/(1 + z_2 C f), F 2 kN, R 100 mm, z 8, z_1 1, C 0.5
TORQUE = {f: 2000 * 0.1 * 8 * f / (1 + 3.5 * f) for f in (0.1, 0.8)}
RADII = ["friction_group.mean_radius=", "friction_group.inner_radius=80 mm", "friction_group.outer_radius=120 mm"]
WEAK = "fatigue.endurance_limit=12 MPa"
# a motor of 10 kg·m² that a load of 50 N·m drives runs down from 20 rad/s; 0.5 mm of 8 pairs slacken 100 N/mm by 400 N
WARM = ["heat.disc_mass=6 kg", "heat.specific_heat=480 J/kg/K", "heat.ambient=20 degC", "heat.cooling=2.5 W/K",
        "heat.lining=0.5 mm", "closing_spring.stiffness=100 N/mm", "drive.speed=20", "drive.motor_inertia=10",
        "drive.motor_torque=50", "requirements.temperature=200 degC"]  # fmt: skip
HELD = {
    "nominal_torque": (TORQUE[0.1], "at least"),
    "machine_torque": (TORQUE[0.1] / 1.25, "at least"),
    "accuracy_factor": (TORQUE[0.8] / TORQUE[0.1], "at most"),
    "accuracy_factor_hysteresis": (TORQUE[0.8] / TORQUE[0.1], "at most"),  # a direct clutch has no hysteresis
    "torque_max": (TORQUE[0.8], "at most"),
    "outer_diameter": (0.24, "at most"),
    "surface_pressure": (2000 / (math.pi * (0.12**2 - 0.08**2)), "at most"),
    "reduced_gain": (7 * 0.5, "at most"),
    # Q = J ω²/2 · T/(T − M), most where the clutch is weakest
    "trips_per_hour": (3600 * 2.5 * 180 / (10 * 20**2 / 2 * TORQUE[0.1] / (TORQUE[0.1] - 50)), "at least"),
    "torque_after_wear": (TORQUE[0.1] * (2000 - 1e5 * 8 * 0.5e-3) / 2000, "at least"),
    # the mean-stress rule on the unprotected side, where the dynamic factor raises the load
    "cycles": (1e7 * (2 * 12e6 * 15e-6 / 1.4 / (TORQUE[0.1] + TORQUE[0.8])) ** 6, "at least"),
}
"""Key → what the base clutch has, and the side its limit is on."""


def rows_of(spec):
    result, findings = Answers(build(spec)).ask("check")
    return result.passed, {row.path.partition(".")[2]: row for row in result.requirements}, findings


@pytest.mark.parametrize("share", [0.999, 1.0, 1.001])
@pytest.mark.parametrize("name", HELD)
def test_a_requirement_is_held_up_to_its_limit(name, share):
    value, bound = HELD[name]
    limit = value * share
    passed, rows, findings = rows_of(read_spec(None, [*RADII, WEAK, *WARM, f"requirements.{name}={limit!r}"]))
    holds = share <= 1 if bound == "at least" else share >= 1
    row = rows[name]
    assert (row.value, row.limit, row.least, row.passed) == (pytest.approx(value), limit, bound == "at least", holds)
    assert row.utilisation == pytest.approx(share if bound == "at least" else 1 / share)
    missed = [each for each in findings if each.code == "requirement-missed"]
    assert passed == holds == (not missed)
    assert all((each.level, each.path) == ("error", f"requirements.{name}") for each in missed)


LASTING = """
variant = "indirect"
friction = {min = 0.12, mean = 0.2, max = 0.4}
friction_group = {pairs = 6, inner_radius = "65 mm", outer_radius = "95 mm"}
closing_spring = {force = "1.5 kN", stiffness = "150 N/mm"}
control_spring = {stiffness = "80 N/mm"}
control_unit = {wall_angle = "30 deg", ball_circle_radius = "45 mm", hub_diameter = "40 mm", key_friction = 0.1}
adjustment = {method = "mean-friction", margin = 1.3}
"""


def set_to(*changes):
    return [part for change in changes for part in ("--set", change)]


def test_accuracy_under_a_load_that_lasts(afmcalc, tmp_path):
    (path := tmp_path / "lasting.toml").write_text(LASTING)

    def checked(*changes):
        found = afmcalc("check", path, *set_to(*changes), "--json").json
        told = [each for each in found["findings"] if each["code"] == "accuracy-not-lasting"]
        return {
            row["path"].partition(".")[2]: (row["passed"], row["value"])
            for row in found["result"]["checks"]
            if row["code"] == "requirement-missed"
        }, told

    rising, lasting = "requirements.accuracy_factor", "requirements.accuracy_factor_hysteresis"
    rows, (one,) = checked(f"{rising}=2.5")
    assert rows["accuracy_factor"] == (True, pytest.approx(2.08, abs=5e-3))
    assert (one["level"], one["limit"], one["value"]) == ("warning", 2.5, pytest.approx(2.81, abs=5e-3))
    rows, told = checked(f"{rising}=2.5", f"{lasting}=2.7")
    assert (rows["accuracy_factor_hysteresis"][0], told) == (False, [])
    assert not checked(f"{rising}=2.9")[1], "within both"


UNKNOWN = {"outer_diameter": 0.2, "surface_pressure": 1e6, "travel": 0.01, "exceedance": 0.01, "cycles": 1e6,
           "trips_per_hour": 5, "torque_after_wear": 90}  # fmt: skip


def test_what_cannot_be_judged_is_no_pass(afmcalc):
    wanted = set_to(*(f"requirements.{name}={limit}" for name, limit in UNKNOWN.items()))
    spec = [*wanted, *set_to("requirements.torque_max=400", "fatigue=")]
    run = afmcalc("check", *spec, "--json")
    rows = {
        row["path"].partition(".")[2]: row
        for row in run.json["result"]["checks"]
        if row["code"] == "requirement-missed"
    }
    assert {tuple(rows[name][key] for key in ("value", "utilisation", "passed")) for name in UNKNOWN} == {(None,) * 3}
    told = [(each["level"], each["path"]) for each in run.json["findings"] if each["code"] == "requirement-not-judged"]
    assert sorted(told) == sorted(("warning", f"requirements.{name}") for name in UNKNOWN)
    assert (run.code, afmcalc("check", *spec, "--strict").code) == (0, 1)


def test_a_lining_that_takes_all_the_force_leaves_no_torque():
    _, rows, _ = rows_of(read_spec(None, [*WARM, "heat.lining=3 mm", "requirements.torque_after_wear=1"]))
    row = rows["torque_after_wear"]
    assert (row.value, row.utilisation, row.passed) == (0, None, False)


def test_life_without_a_limit_is_held():
    """Amplitude and Goodman give no number below the endurance limit: the requirement is held, with no value."""
    spec = read_spec(None, ["requirements.cycles=1e30", "fatigue.mean_stress_sensitivity=0.1"])
    result, _ = Answers(build(spec), model="amplitude").ask("check")
    (row,) = result.requirements
    assert (row.value, row.utilisation, row.passed) == (None, 0, True)


def test_exceedance_is_of_the_torque_required():
    """P(T > 300 N·m) of friction that is uniform over 0.1…0.8, by the friction at which T is that."""
    beyond, blocks = (
        300 / (1600 - 3.5 * 300),
        {"fields": {"friction": {"distribution": "uniform"}}, "samples": 50_000, "sobol_base": 64},
    )
    data = resolved(read_spec(CONFIGS / "default.toml"))
    data |= {"tolerance": blocks, "requirements": {"torque_max": 300.0, "exceedance": 0.5}}
    assert rows_of(make_spec(data))[1]["exceedance"].value == pytest.approx(
        (0.8 - beyond) / 0.7, abs=0.008
    )  # 4 errors of so many samples
    data["tolerance"] = {**blocks, "torque_limit": 250.0}
    assert rows_of(make_spec(data))[1]["exceedance"].passed is None
    del data["requirements"]["torque_max"]
    with pytest.raises(SpecError, match=r"requirements\.torque_max.*required beside exceedance"):
        make_spec(data)
