"""solve for what check judges: closed forms by hand, and the answer of check itself to the last digit."""

import math

import numpy as np
import pytest
from conftest import CONFIGS

from afmcalc.analysis.check import check
from afmcalc.analysis.solve.search import looked
from afmcalc.analysis.solve.solve import NotAttainableError, solve
from afmcalc.engines import build
from afmcalc.spec import make_spec, read_spec
from afmcalc.spec.edit import respecified

BEYOND_95 = 1.6448536269514722
"""Standard normal quantile of 95 %."""
LIFE = [CONFIGS / "drive.toml", ["drive.dynamic_factor=2", "drive.event="]]


@pytest.mark.slow
def test_force_for_an_exceedance_of_an_ordinary_clutch():
    """T = z R F f of a normal f: P(T > L) = 5 % at F = L/(z R (f + 1.645 σ)), z 8, R 0.1 m, f 0.3 ± 0.03."""
    data = {
        "variant": "conventional",
        "friction": {"min": 0.2, "max": 0.4},
        "friction_group": {"pairs": 8, "mean_radius": 0.1},
        "closing_spring": {"force": 2000.0},
        "tolerance": {"torque_limit": 200.0, "fields": {"friction": {"distribution": "normal", "spread": 0.03}}},
    }
    clutch = build(make_spec(data))
    result, _, findings = solve(clutch, "F", "exceedance", 0.05)
    assert result.value == pytest.approx(200 / (8 * 0.1 * (0.3 + BEYOND_95 * 0.03)), rel=1e-4)
    assert "solve-looked" in [finding.code for finding in findings]


@pytest.mark.parametrize("cycles", [1e5, 2e6])
def test_force_for_a_life(cycles):
    """N = N_0 (τ_limb/τ_eq)^m of τ_eq = k_д (T_min + T_max)/2 W; T = 8 F R f/(1 + 7 C f) with z_1 = 1 of 8 pairs."""
    spec = read_spec(*LIFE)
    result, _, _ = solve(build(spec), "F", "cycles", cycles)
    per_force = sum(0.1 * 8 * f / (1 + 7 * 0.5 * f) for f in (0.1, 0.8)) / 2
    assert result.value == pytest.approx(400e6 * (1e7 / cycles) ** (1 / 6) * 15e-6 / 2 / per_force, rel=1e-6)


def test_a_life_without_end_is_no_number():
    """Above N_0 = 1e7 there is no life with a number: the best is at the endurance limit, and a smaller force has none."""
    with pytest.raises(NotAttainableError, match="it has no end at F = ") as refused:
        solve(build(read_spec(*LIFE)), "F", "cycles", 1e8)
    assert refused.value.best == pytest.approx(1e7, rel=1e-6)


@pytest.mark.slow
def test_contact_by_hertz_goes_with_the_cube_root_of_the_force():
    spec = read_spec("example:indirect", ["control_unit.ball_diameter=20 mm"])
    first, _, _ = solve(build(spec), "F", "contact_pressure", 1.5e9)
    second, _, _ = solve(build(spec), "F", "contact_pressure", 3e9)
    assert second.value == pytest.approx(8 * first.value, rel=1e-6)


@pytest.mark.slow
def test_what_check_says_of_the_clutch_found():
    target, wanted = "temperature", 296.0
    clutch = build(read_spec(CONFIGS / "drive.toml", ["drive.event=", "drive.motor=", "drive.cut_off=0.5 s"]))
    result, solved, _ = solve(clutch, "F", target, wanted)
    assert result.reached == pytest.approx(wanted, rel=1e-6)
    again = build(respecified(solved.spec, {f"requirements.{target}": wanted}))
    values = {row.requirement: row.value for row in check(again)[0].requirements}
    assert values[target] == result.reached


def test_what_is_passed_touched_or_jumped_over():
    at = np.linspace(0, 10, 26)
    waves = lambda x: 2 + np.sin(x)  # noqa: E731
    assert looked(waves, 2.5, at)[1] == pytest.approx(
        [math.pi * k + (-1) ** k * math.pi / 6 for k in range(4)], rel=1e-8
    )
    # an extreme between two values, beyond which there is nothing
    curve, none = looked(waves, 3.5, at)
    assert not none
    assert curve.value.max() == pytest.approx(3, abs=1e-6)
    assert len(looked(waves, 2.9999, at)[1]) >= 2
    jump = lambda x: np.where(x < math.e, 1.0, 2.0)  # noqa: E731
    curve, none = looked(jump, 1.5, at)
    assert not none
    assert np.abs(curve.at - math.e).min() < 1e-8
    # steps of a sample are none: within one in a thousand
    assert looked(lambda x: np.round(x, 3), 1.2344, at)[1] == pytest.approx([1.2345], abs=1e-6)
    assert looked(lambda x: np.round(x, 1), 1.25, at)[1] == []
    # what is not known, and what has no end
    unknown = lambda x: np.where(x < 3, math.nan, np.where(x > 7, math.inf, x))  # noqa: E731
    assert looked(unknown, 5.0, at)[1] == pytest.approx([5.0])
    assert looked(unknown, 8.0, at)[1] == []
