"""Life: static strength first, a life without limit, springs as made, one dynamic factor, sweeps with null lives."""

import math

import pytest
from conftest import CONFIGS

from afmcalc.analysis.asking import Answers
from afmcalc.analysis.check import check
from afmcalc.analysis.fatigue import life, life_sweep
from afmcalc.analysis.simulate import simulate
from afmcalc.analysis.sweep import parse_axis
from afmcalc.engines import build
from afmcalc.spec import read_spec

CONVEYOR = CONFIGS.parent / "tests" / "data" / "two-dynamic-factors.toml"
"""A press whose drive gives 2.83 times the sliding torque, with a dynamic factor of 1 given."""

WEAK_SHAFT = ["--set", "F=1265.4", "--set", "adjustment.method=mean-friction", "--set", "drive.dynamic_factor=2",
      "--set", "fatigue.endurance_limit=40 MPa", "--set", "fatigue.polar_section_modulus=4 cm^3",
      "--set", "fatigue.ultimate_strength=150 MPa", "--set", "fatigue.mean_stress_sensitivity=0.1"]  # fmt: skip


def test_static_strength_is_held_against_the_spring_as_set(afmcalc):
    """T_max = 213.1 N·m, ×2/4 cm³ = 106.6 MPa < 150 MPa: no failure; at 100 MPa there is one."""
    assert afmcalc("check", *WEAK_SHAFT).code == 0
    life = afmcalc("life", *WEAK_SHAFT, "--json").json
    low, high = 2 * 74.9866 / 4e-6, 2 * 213.12 / 4e-6
    assert life["result"]["stress_unprotected"] == pytest.approx((low + high) / 2, rel=1e-4)
    weaker = ["--set", "fatigue.ultimate_strength=100 MPa", "--model", "goodman"]
    weak = afmcalc("life", *WEAK_SHAFT, *weaker, "--json").json
    assert weak["result"]["stress_unprotected"] is None
    assert weak["result"]["unprotected"]["mean_friction"] == 0
    assert "static-strength-exceeded" in [finding["code"] for finding in weak["findings"]]


AS_MADE = ["fatigue.endurance_limit=150e6", "fatigue.polar_section_modulus=1.8e-6", "drive.dynamic_factor=1",
           "adjustment.method=min-friction", "control_spring.force=5500", "requirements.cycles=9e5"]  # fmt: skip


def test_springs_as_made_last_as_they_are():
    """S19 (20) with T at the stop z R f F_п2/(1 + z κ f), off it S21 (11); set at f_min T_н is the same 248.87 N·m."""
    clutch = build(read_spec(CONFIGS / "indirect.toml", AS_MADE))
    net, first, second, closing = 1 - 2 * 0.1 * 0.01 / 0.05, 400e3, 200e3, 2000.0
    low = 8 * 0.1 * 0.1 * 5500 / (1 + 8 * net * 0.1)
    made, stiffness = closing * second + 5500 * first, first + second + 8 * first * 0.8 * net
    slips = 1e7 * (2 * 150e6 * 1.8e-6 / (low + 8 * 0.1 * 0.8 * made / stiffness)) ** 6
    answers = Answers(clutch)
    result, _ = check(clutch, answers=answers)
    found, said = answers.ask("life")
    assert found.protected.as_set == found.unprotected.as_set == pytest.approx(slips, rel=1e-12)
    assert round(slips) == 996_413
    stress = 150e6 * (1e7 / slips) ** (1 / 6)
    assert [each.value for each in said if each.code == "life-limited"] == pytest.approx([stress] * 2)
    assert sum("996,413 slips" in each.message for each in said) == 2
    (row,) = result.requirements
    assert (row.value, row.passed, result.passed) == (found.protected.as_set, True, True)
    assert found.protected.min_friction == pytest.approx(707_877, abs=1)
    axis = parse_axis("fatigue.exponent=6,7", clutch.spec)
    (sweep,) = life(clutch, sweeps=[axis])[0].sweep
    assert sweep.protected[0] == sweep.unprotected[0] == pytest.approx(found.protected.as_set, rel=1e-12)


def test_a_forecast_loads_from_the_mean_friction():
    """S19: N_0 (2 τ_limb W/(T_cp + T_max))^m of T = 1600 f/(1 + 3.5 f)."""
    found, _ = life(build(read_spec(None, ["fatigue.endurance_limit=12e6"])))
    mean, high = (1600 * f / (1 + 3.5 * f) for f in (0.3, 0.8))
    assert found.protected_forecast.as_set == pytest.approx(1e7 * (2 * 12e6 * 15e-6 / (mean + high)) ** 6, rel=1e-9)


@pytest.mark.slow
def test_one_dynamic_factor_wherever_a_life_is_told(afmcalc):
    """Without a factor that of the event, 2.83: τ' 16.43 MPa; with one it wins, and is said to be the smaller."""
    short = "drive.event.duration=0.05"  # past its peak
    sets = ["drive.dynamic_factor=", "tolerance.samples=1000", "tolerance.sobol_base=64", short]
    clutch = build(read_spec(CONVEYOR, sets))
    factor, answers = max(vars(simulate(clutch)[0].dynamic_factor).values()), Answers(clutch)
    assert factor == pytest.approx(2.83, abs=5e-3)
    found, said = life(clutch)
    assert found.dynamic_factor == factor
    assert (found.stress_protected, found.stress_unprotected) == pytest.approx((5.811e6, 16.43e6), rel=3e-4)
    assert found.unprotected.as_set == pytest.approx(found.protected.as_set / factor**6, rel=1e-12)
    result, findings = check(clutch, answers=answers)
    stresses = [row.value for row in result.checks if row.name.startswith("damaging stress")]
    assert stresses == [found.stress_protected, found.stress_unprotected]
    assert found == answers.ask("life")[0]
    assert "dynamic-factor-exceeded" not in {each.code for each in (*said, *findings)}
    scattered = answers.ask("tolerance")[0]
    assert scattered.life_protected / scattered.life_unprotected == pytest.approx(factor**6, rel=1e-9)

    given = afmcalc("life", CONVEYOR, "--set", short, "--json").json
    assert (given["result"]["dynamic_factor"], given["result"]["stress_unprotected"]) == (1, found.stress_protected)
    (warned,) = (each for each in given["findings"] if each["code"] == "dynamic-factor-exceeded")
    assert (warned["level"], warned["value"], warned["limit"]) == ("warning", factor, 1)
    assert warned in afmcalc("check", CONVEYOR, "--set", short, "--json").json["findings"]


@pytest.mark.slow
@pytest.mark.parametrize("sweep", ["C=1", "drive.shaft_stiffness=2e3", "friction_group.pairs=3"])
def test_a_sweep_simulates_the_event_of_every_point(sweep):
    """Stepped, within 0.1 % of the peak: 0.6 % of a life by its 6th power."""
    free = ["drive.dynamic_factor="]
    clutch, own = (build(read_spec(CONVEYOR, changes)) for changes in (free, [*free, sweep]))
    (found,) = life_sweep(clutch, "mean-stress", [parse_axis(sweep, clutch.spec)], math.nan)
    assert found.unprotected[0] == pytest.approx(life(own)[0].unprotected.as_set, rel=6e-3)


KEYS = {"endurance_limit=3e6": "mean-stress", "polar_section_modulus=9e-6": "mean-stress", "exponent=5": "amplitude",
        "base_cycles=1e6": "goodman"}  # fmt: skip


@pytest.mark.parametrize(("sweep", "model"), KEYS.items())
def test_every_key_of_the_part_is_swept_as_it_is_set(sweep, model):
    base = ["fatigue.ultimate_strength=900e6", "fatigue.mean_stress_sensitivity=0.1", "fatigue.endurance_limit=4e6"]
    clutch, own = (build(read_spec(None, changes)) for changes in (base, [*base, f"fatigue.{sweep}"]))
    axis = parse_axis(f"fatigue.{sweep},{sweep.partition('=')[2]}", clutch.spec)
    (found,), (single, _) = life_sweep(clutch, model, [axis], math.nan), life(own, model)
    assert found.protected == pytest.approx([single.protected.as_set] * 2, rel=1e-12)
    assert found.unprotected == pytest.approx([single.unprotected.as_set] * 2, rel=1e-12)
