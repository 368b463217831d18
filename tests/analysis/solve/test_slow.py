"""solve for what check judges: closed forms by hand, and the answer of check itself to the last digit."""

import math

import numpy as np
import pytest
from conftest import CONFIGS

from afmcalc.analysis.check import check
from afmcalc.analysis.solve.search import Domain, looked, places
from afmcalc.analysis.solve.solve import NotAttainableError, parse_target, solve
from afmcalc.engines import build
from afmcalc.errors import AfmcalcError, CalculationError
from afmcalc.spec import make_spec, read_spec
from afmcalc.spec.edit import respecified

BEYOND_95 = 1.6448536269514722
"""Standard normal quantile of 95 %."""
LIFE = [CONFIGS / "drive.toml", ["drive.dynamic_factor=2", "drive.event="]]


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


def test_pairs_that_all_give_a_life_without_end():
    with pytest.raises(CalculationError, match="it has no end at any z looked at"):
        solve(build(read_spec(*LIFE)), "z", "cycles", 1e5)


def test_contact_by_hertz_goes_with_the_cube_root_of_the_force():
    spec = read_spec("example:indirect", ["control_unit.ball_diameter=20 mm"])
    first, _, _ = solve(build(spec), "F", "contact_pressure", 1.5e9)
    second, _, _ = solve(build(spec), "F", "contact_pressure", 3e9)
    assert second.value == pytest.approx(8 * first.value, rel=1e-6)


@pytest.mark.parametrize(
    ("target", "wanted", "changed"),
    [
        ("temperature", 296.0, ["drive.event=", "drive.motor=", "drive.cut_off=0.5 s"]),
        pytest.param("peak_torque", 450.0, [], marks=pytest.mark.exhaustive),
    ],
)
def test_what_check_says_of_the_clutch_found(target, wanted, changed):
    clutch = build(read_spec(CONFIGS / "drive.toml", changed))
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


def test_places_are_those_of_the_domain():
    even = places(Domain(0.0, low_taken=True, high=1.25, why=""), None, 6, 10, whole=False)
    assert even.tolist() == pytest.approx([0, 0.25, 0.5, 0.75, 1.0, 1.25])
    ratios = places(Domain(0.0, low_taken=False, high=math.inf, why=""), 2.0, 5, 100, whole=False)
    assert ratios.tolist() == pytest.approx([0.02, 0.2, 2, 20, 200])
    assert places(Domain(2.0, low_taken=True, high=math.inf, why=""), 8.0, 3, 10, whole=True).tolist() == [8, 80]


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["peak_torque=100"], "peak_torque cannot be solved for: it needs [drive] with an event"),
        (["exceedance=0.1"], "exceedance cannot be solved for: it needs [tolerance]"),
        (["--for", "F", "surface_pressure=1 kN"], "surface_pressure=1 kN: "),
    ],
)
def test_what_it_needs(arguments, says, afmcalc):
    run = afmcalc("solve", *arguments)
    assert (run.code, run.out) == (2, "")
    assert says in run.err


@pytest.mark.parametrize("target", ["temperature", "face_temperature"])
def test_a_temperature_without_a_unit_is_asked_after(target):
    with pytest.raises(AfmcalcError, match='in K, and must be at least 173.15: "150 degC"'):
        parse_target(f"{target}=150")
    assert parse_target(f"{target}=150 degC")[1] == pytest.approx(423.15)
