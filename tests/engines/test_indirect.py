"""The engine of indirect regulation; its torque, forces and travel are held in ``test_balance.py``."""

import numpy as np
import pytest
from conftest import S21
from hypothesis import assume, example, given
from hypothesis import strategies as st
from strategies import FRICTION, indirect_specs, p5

import afmcalc
from afmcalc.analysis.clutch_findings import clutch_findings
from afmcalc.engines import build
from afmcalc.engines.elasticity import elasticities
from afmcalc.errors import SpecError
from afmcalc.spec import read_spec
from afmcalc.spec.edit import with_nominal_torque, with_values


def slopes(clutch):
    """Elasticities of the accuracy factor."""
    return {path: each.slope for path, each in elasticities(clutch.quantities).items()}


def _smooth(clutch):
    """Whether K_т has a derivative: no jump off the stop near by, and no two torques about to change places."""
    own = clutch.friction[0]
    if "gain_slope" not in clutch.quantities:
        return True
    ends = [float(clutch.torque(own.min)), float(clutch.torque(own.max))]
    apart = abs(np.log(ends[1] / ends[0])) > 1e-4
    if clutch.spec.adjustment.method == "mean-friction":
        apart &= own.min * 1.0001 < own.mean < own.max * 0.9999  # K_т has a kink where the sleeve leaves at an end
    inside = own.min < clutch.friction_leaving < own.max
    apart &= not inside or abs(np.log(clutch.torque(clutch.friction_leaving) / ends[1])) > 1e-4
    return apart and clutch.gain_slope < 0.9 * clutch.jumping_slope


@given(st.one_of(indirect_specs(), indirect_specs(curved=True)), st.booleans())
@example(p5("control_spring.force=3920", "control_unit.gain_slope=8"), False)  # most torque where the sleeve leaves
def test_sensitivities_are_the_derivatives_of_the_accuracy(spec, by_torque):
    clutch = build(spec)
    assume(clutch.net_gain > 1e-2)
    assume(_smooth(clutch))
    assume(not any(each.kink for each in elasticities(clutch.quantities).values()))
    if by_torque:
        spec = with_nominal_torque(spec, clutch.nominal_torque)
        clutch = build(spec)
    step = 1e-6
    for path, elasticity in slopes(clutch).items():
        value = spec
        for part in path.split("."):
            value = getattr(value, part)
        if value == 0:
            assert elasticity == 0
            continue
        factors = [
            float(build(with_values(spec, {path: value * (1 + sign * step)})).accuracy_factor) for sign in (-1, 1)
        ]
        numeric = (np.log(factors[1]) - np.log(factors[0])) / (2 * step)
        assert elasticity == pytest.approx(numeric, abs=5e-5 * (1 + abs(numeric))), path


@pytest.mark.parametrize("method", ["min-friction", "mean-friction"])
def test_a_mean_that_is_not_given_moves_with_the_range(method):
    base = read_spec(S21, ["friction.mean=", f"adjustment.method={method}"])
    sensitivity = slopes(build(base))
    step = 1e-6
    for end in ("min", "max"):
        value = getattr(base.friction, end)
        factors = [
            build(with_values(base, {f"friction.{end}": value * (1 + sign * step)})).accuracy_factor for sign in (-1, 1)
        ]
        numeric = (np.log(factors[1]) - np.log(factors[0])) / (2 * step)
        assert sensitivity[f"friction.{end}"] == pytest.approx(numeric, abs=1e-6)


@given(st.one_of(indirect_specs(), indirect_specs(curved=True)), st.lists(FRICTION, min_size=1, max_size=12))
def test_arrays_and_floats_agree_bit_for_bit(spec, friction):
    clutch = build(spec)
    array = np.array(friction).reshape(-1, 1)
    for name in ("torque", "normal_force", "release_force", "travel", "torque_returning"):
        assert clutch.at(array)[name].ravel().tolist() == [clutch.at(f)[name] for f in friction]


def test_below_the_threshold_is_refused_with_the_threshold(afmcalc):
    run = afmcalc("torque", S21, "--set", "C=0.5")
    assert (run.code, run.out) == (2, "")
    assert "s21-fig2.toml: control_unit.gain = 0.5: must be at least 2 R f_1/d = 0.6" in run.err
    swept = afmcalc("accuracy", S21, "--sweep", "C=0.1:2:5")
    assert swept.code == 2
    assert "control_unit.gain" in swept.err
    assert "0.6" in swept.err
    with pytest.raises(SpecError, match=r"2 R f_1/d"):
        build(read_spec(S21, ["C=0.59"]))


def test_at_the_threshold_it_is_an_ordinary_clutch():
    clutch = build(read_spec(S21, ["control_unit.gain=0.6"]))
    assert clutch.accuracy_factor == pytest.approx(8.0)
    assert [finding.code for finding in clutch_findings(clutch.spec, clutch.quantities)] == ["feedback-idle"]
    assert clutch.at(0.8)["travel"] == pytest.approx(0, abs=1e-15)


def test_wall_angle_in_place_of_the_gain():
    given_gain = read_spec(S21)
    angled = read_spec(S21, ["control_unit.gain=", f"control_unit.wall_angle={float(np.arctan(0.5))!r}"])
    assert build(angled).torque(0.5) == pytest.approx(build(given_gain).torque(0.5))
    sensitivity = slopes(build(angled))
    assert sensitivity["friction_group.mean_radius"] == pytest.approx(
        slopes(build(given_gain))["control_unit.gain"] + slopes(build(given_gain))["friction_group.mean_radius"]
    )


def test_two_frictions_are_refused():
    clutch = afmcalc.load(S21)
    assert clutch.torque(0.3, 0.3) == clutch.torque(0.3)
    with pytest.raises(ValueError, match="one friction"):
        clutch.torque(0.3, 0.4)
