"""Pockets whose wall steepens along the travel (theory, section 12), through every analysis that asks the law."""

import numpy as np
import pytest
from conftest import slow
from strategies import p5

from afmcalc.analysis.accuracy_factor import accuracy
from afmcalc.analysis.clutch_findings import clutch_findings
from afmcalc.analysis.fatigue import life
from afmcalc.analysis.tolerance_study import tolerance, with_setting
from afmcalc.engines import build
from afmcalc.spec import read_spec
from afmcalc.spec.edit import with_values

BEST = 18.75
"""C_1* of P5's clutch: (20 + 10) N/mm/(8·0.1·2 kN)."""
HELD = "control_unit.pocket=constant-torque"


def clutch(*overrides, **blocks):
    return build(p5(*overrides, **blocks))


def told(own):
    return codes(clutch_findings(own))


def codes(findings):
    return {finding.code for finding in findings}


@pytest.mark.parametrize(
    ("slope", "found"),
    [(BEST, set()), (20, {"torque-falls-with-travel"}), (22.7, {"torque-falls-with-travel"}), (22.8, {"torque-jumps"})],
)
def test_a_torque_that_falls_is_said(slope, found):
    """D(f_set) = (20 + 10 + 8·20·0.1·0.4) N/mm over 8·0.1·2 kN: 22.75 1/m."""
    given = f"control_unit.gain_slope={slope}"
    assert told(clutch(given)) & {"torque-falls-with-travel", "torque-jumps"} == found
    never = clutch(given, "friction.mean=0.8", "adjustment.method=mean-friction")
    assert not told(never) & {"torque-falls-with-travel", "torque-jumps"}, "it rests all the way"


def test_life_where_the_torque_jumps():
    """The mean damage over the friction, by brute force: T rises to f_set, jumps down, and falls."""
    steep = clutch(
        "control_unit.gain_slope=30", "adjustment.method=mean-friction", "closing_spring.force=75 kN",
        "closing_spring.stiffness=1500 N/mm", "control_spring.stiffness=750 N/mm", "fatigue.ultimate_strength=5 GPa",
    )  # fmt: skip
    assert "torque-jumps" in told(steep)
    torque, part = steep.at(friction=np.linspace(0.1, 0.8, 400_001))["torque"], steep.spec.fatigue
    assert torque.max() == pytest.approx(float(steep.torque_max), rel=1e-5)
    high = torque / part.polar_section_modulus / 2
    stress = high / (1 - high / part.ultimate_strength)
    above = stress > part.endurance_limit
    assert 0.2 < above.mean() < 0.8
    damage = np.where(above, (stress / part.endurance_limit) ** part.exponent / part.base_cycles, 0.0).mean()
    assert life(steep, "goodman")[0].protected.mean_friction == pytest.approx(1 / damage, rel=1e-2), "256 slips"


@pytest.mark.parametrize("setting", ["each-adjusted", *slow("as-made")])
def test_a_pocket_is_cut_once(setting):
    """Values that scatter meet the pocket of the nominal clutch; the slope itself may scatter about it."""
    fields = {
        "friction": {"distribution": "uniform"},
        "closing_spring.stiffness": {"distribution": "uniform", "spread": "10 %"},
        "control_unit.gain_slope": {"distribution": "normal", "spread": "2 %"},
    }
    nominal = clutch(HELD, tolerance={"setting": setting, "samples": 5000, "sobol_base": 64, "fields": fields})
    made = with_setting(nominal, nominal.spec.tolerance)
    sample = build(with_values(made, {"closing_spring.stiffness": np.array([18e3, 22e3])}))
    assert sample.gain_slope == pytest.approx(BEST)
    assert sample.at(friction=0.5)["torque"] != pytest.approx(160, rel=1e-3)
    found, _ = tolerance(nominal)
    assert {row.path: row.center for row in found.inputs}["control_unit.gain_slope"] == pytest.approx(BEST)
    assert 1.01 < found.accuracy_factor_robust < 1.5
    alone, _ = tolerance(
        clutch(HELD, tolerance={"samples": 5000, "sobol_base": 64, "fields": {"friction": {"distribution": "uniform"}}})
    )
    assert (alone.accuracy_factor_robust, alone.histogram) == (pytest.approx(1, rel=1e-12), [])


def test_where_pockets_hold_the_torque_an_elasticity_is_one_side_s():
    """K_т = 1 there, and more on either side of C_1*."""
    told = [accuracy(clutch(f"control_unit.gain_slope={share * BEST}")) for share in (0.99, 1, 1.01)]
    factors = [each.accuracy_factor for each, _ in told]
    assert factors[1] == pytest.approx(1)
    assert min(factors[0], factors[2]) > 1.0005
    said = [[each.limit for each in findings if each.code == "elasticity-one-sided"] for _, findings in told]
    assert said == [[], [pytest.approx(BEST)], []]


def test_a_kink_of_any_key_is_told():
    """The sleeve leaves its stop just at f_min: below it the stop still bears a part of the control spring."""
    made = build(read_spec("example:indirect", ["control_spring.force=6608", "friction.min=0.3"]))
    (told,) = [each for each in accuracy(made)[1] if each.code.startswith("elasticity-one-sided")]
    assert (told.code, told.path) == ("elasticity-one-sided", "friction.min")
    assert "control_spring.force" in told.message
