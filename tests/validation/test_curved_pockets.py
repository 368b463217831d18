"""Pockets whose wall steepens along the travel (theory, section 12), through every analysis that asks the law."""

import numpy as np
import pytest

from afmcalc.analysis.accuracy import accuracy
from afmcalc.analysis.adjust import adjust
from afmcalc.analysis.explain.explain import explain
from afmcalc.analysis.life import life
from afmcalc.analysis.solve.solve import solve
from afmcalc.analysis.tolerance.model import Model, inputs_of, with_setting
from afmcalc.analysis.tolerance.study import tolerance
from afmcalc.engines import build
from afmcalc.errors import SpecError
from afmcalc.spec import read_spec

BEST = 18.75
"""C_1* of P5's clutch: (20 + 10) N/mm/(8·0.1·2 kN)."""


def spec_of(*overrides):
    """The clutch of P5, C = 1, F_п1 = 2 kN, with other values of some keys."""
    base = {
        "variant": "indirect",
        "friction": {"min": 0.1, "mean": 0.3, "max": 0.8},
        "friction_group": {"pairs": 8, "mean_radius": "100 mm"},
        "closing_spring": {"force": "2 kN", "stiffness": "20 N/mm"},
        "control_spring": {"stiffness": "10 N/mm"},
        "control_unit": {"gain": 1.0, "ball_circle_radius": "50 mm", "hub_diameter": "50 mm", "key_friction": 0.15},
        "adjustment": {"margin": 1.25},
        "fatigue": {"endurance_limit": 400e6, "polar_section_modulus": 15e-6, "exponent": 6, "base_cycles": 1e7},
    }
    return read_spec(base, overrides)


def clutch(*overrides):
    return build(spec_of(*overrides))


def codes(findings):
    return {finding.code for finding in findings}


def test_the_torque_does_not_know_the_friction():
    held = clutch("control_unit.pocket=constant-torque")
    assert held.gain_slope == held.constant_torque_slope == pytest.approx(BEST, rel=1e-15)
    friction = np.linspace(0.1, 5, 1000)
    assert held.torque(friction) == pytest.approx(160, rel=1e-12)
    # back under load it is S/κ₊ of the same places: between T_н κ/κ₊ at the stop and T_н
    kappa, back = 0.4 + BEST * held.travel(0.8), 1.6 + BEST * held.travel(0.8)
    assert held.torque_returning(0.8 * kappa / back) == pytest.approx(160 * kappa / back, rel=1e-12)
    assert held.torque_returning(0.1 * 0.4 / 1.6) == pytest.approx(160 * 0.4 / 1.6, rel=1e-12)
    assert held.accuracy_factor_hysteresis == pytest.approx(160 / held.torque_returning(0.1))


@pytest.mark.parametrize(
    ("slope", "found"),
    [(BEST, set()), (20, {"torque-falls-with-travel"}), (22.7, {"torque-falls-with-travel"}), (22.8, {"torque-jumps"})],
)
def test_a_torque_that_falls_is_said(slope, found):
    """D(f_set) = (20 + 10 + 8·20·0.1·0.4) N/mm over 8·0.1·2 kN: 22.75 1/m."""
    told = codes(clutch(f"control_unit.gain_slope={slope}").findings())
    assert told & {"torque-falls-with-travel", "torque-jumps"} == found
    never = clutch(f"control_unit.gain_slope={slope}", "friction.mean=0.8", "adjustment.method=mean-friction")
    assert not codes(never.findings()) & {"torque-falls-with-travel", "torque-jumps"}, "it rests all the way"


def test_both_settings_hold_it_from_theirs_on():
    found, _ = adjust(clutch("control_unit.pocket=constant-torque"))
    assert (found.narrower, found.scatter_ratio) == ("min-friction", None)
    assert found.min_friction.scatter == pytest.approx(0, abs=1e-10)
    assert found.mean_friction.torque.mean == pytest.approx(found.mean_friction.torque.max) == pytest.approx(200)


def test_the_slope_from_a_wanted_accuracy():
    result, solved, findings = solve(
        clutch("control_unit.pocket=constant-torque"), "gain_slope", "accuracy_factor", 1.2
    )
    assert solved.accuracy_factor == pytest.approx(1.2)
    assert result.value < BEST
    assert {"solve-replaces", "solve-another-value"} <= codes(findings), "the pocket it had, and a slope beyond C_1*"


def test_life_where_the_torque_jumps():
    """The mean damage over the friction, by brute force, within 1 % by 256 frictions: T rises to f_set, jumps, falls."""
    steep = clutch(
        "control_unit.gain_slope=30", "adjustment.method=mean-friction", "closing_spring.force=75 kN",
        "closing_spring.stiffness=1500 N/mm", "control_spring.stiffness=750 N/mm", "fatigue.ultimate_strength=5 GPa",
    )  # fmt: skip
    assert "torque-jumps" in codes(steep.findings())
    torque = steep.torque(np.linspace(0.1, 0.8, 400_001))
    assert torque.max() == pytest.approx(float(steep.torque_max), rel=1e-5)
    part = steep.spec.fatigue
    high = torque / part.polar_section_modulus / 2
    stress = high / (1 - high / part.ultimate_strength)
    above = stress > part.endurance_limit
    assert 0.2 < above.mean() < 0.8
    damage = np.where(above, (stress / part.endurance_limit) ** part.exponent / part.base_cycles, 0.0).mean()
    by_method = life(steep, "goodman")[0]
    own = steep.spec.adjustment.method.replace("-", "_")
    assert getattr(by_method.protected, own) == pytest.approx(1 / damage, rel=1e-2)


@pytest.mark.parametrize("setting", ["as-made", "each-adjusted"])
def test_a_pocket_is_cut_once(setting):
    """What scatters meets the pocket of the nominal clutch; the slope itself may scatter about it."""
    fields = {
        "friction": {"distribution": "uniform"},
        "closing_spring.stiffness": {"distribution": "uniform", "spread": "10 %"},
        "control_unit.gain_slope": {"distribution": "normal", "spread": "2 %"},
    }
    spec = spec_of("control_unit.pocket=constant-torque")
    data = {**spec.model_dump(exclude_none=True), "tolerance": {"setting": setting, "samples": 20000, "fields": fields}}
    nominal = build(data)
    made = with_setting(nominal, nominal.spec.tolerance)
    inputs = inputs_of(made)
    assert {each.path: each.center for each in inputs}["control_unit.gain_slope"] == pytest.approx(BEST)
    sample = Model(made, inputs).clutch([0.5, np.array([18e3, 22e3]), BEST])
    assert sample.gain_slope == BEST
    assert sample.torque(0.5) != pytest.approx(160, rel=1e-3)
    found, _ = tolerance(nominal)
    assert 1.01 < found.accuracy_factor_robust < 1.5


def test_only_friction_scatters():
    spec = spec_of("control_unit.pocket=constant-torque")
    data = {**spec.model_dump(exclude_none=True), "tolerance": {"fields": {"friction": {"distribution": "uniform"}}}}
    found, _ = tolerance(build(data))
    assert found.method == "exact"
    assert found.accuracy_factor_robust == pytest.approx(1, rel=1e-12)


def test_what_no_wall_does():
    with pytest.raises(SpecError, match="no wall holds the torque"):
        clutch("control_unit.pocket=constant-torque", "control_spring.force=1.9 kN")
    with pytest.raises(SpecError, match="give the slope, or the pocket"):
        clutch("control_unit.pocket=constant-torque", "control_unit.gain_slope=3")


def test_the_steps_of_a_curved_pocket():
    result, _ = explain("accuracy", clutch("control_unit.pocket=constant-torque").spec)
    shown = {step.function: step for step in result.steps}
    assert shown["pocket.constant_torque_slope"].substituted.startswith("(20000 N/m + 10000 N/m)")
    assert {"pocket.tangent_stiffness_squared", "pocket.sleeve_stiffness", "pocket.travel"} <= set(shown)
    straight, _ = explain("torque", clutch().spec)
    assert not any(step.function.startswith("pocket.") for step in straight.steps), "a straight wall is S21's own law"


def test_where_pockets_hold_the_torque_an_elasticity_is_one_side_s():
    """K_т = 1 there, and more on either side of C_1*."""
    slopes = [0.99 * BEST, BEST, 1.01 * BEST]
    told = {slope: accuracy(build(spec_of(f"control_unit.gain_slope={slope}"))) for slope in slopes}
    factors = [told[slope][0].accuracy_factor for slope in slopes]
    assert factors[1] == pytest.approx(1)
    assert min(factors[0], factors[2]) > 1.0005
    said = [[each.limit for each in told[slope][1] if each.code == "elasticity-one-sided"] for slope in slopes]
    assert said == [[], [pytest.approx(BEST)], []]
