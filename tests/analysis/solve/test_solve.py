"""solve: what it finds gives what was wanted, what it refuses has no answer; closed forms by hand and a dense scan."""

import math

import numpy as np
import pytest
from conftest import CONFIGS, S21
from hypothesis import given, settings
from hypothesis import strategies as st
from solve_scan import run
from strategies import indirect_specs

from afmcalc.analysis.check import check
from afmcalc.analysis.solve.search import looked
from afmcalc.analysis.solve.solve import PARAMETERS, NotAttainableError, solve
from afmcalc.engines import build
from afmcalc.spec import make_spec, read_spec
from afmcalc.spec.edit import respecified

TARGET_NAMES = ["accuracy_factor", "nominal_torque", "torque_max", "scatter"]


@settings(max_examples=4)
@given(indirect_specs(curved=True), st.floats(1.0, 20.0))
def test_gain_that_a_control_spring_asks_for(spec, ratio):
    """S21 (5): C = 2 R f_1/d + (F_п2 − F_п1)/(z F_п1 f_set); the pocket's slope does not matter at the stop."""
    group, unit, own = spec.friction_group, spec.control_unit, spec.friction
    at_set = own.min if spec.adjustment.method == "min-friction" else own.mean
    force = spec.closing_spring.force
    result, solved, _ = solve(build(spec), "C", "control_force", ratio * force)
    threshold = 2 * group.mean_radius * unit.key_friction / unit.hub_diameter
    printed = threshold + (ratio * force - force) / (group.pairs * force * at_set)
    assert result.value == pytest.approx(printed, rel=1e-9, abs=1e-12)
    assert solved.control_force == pytest.approx(ratio * force, rel=1e-9)


@pytest.mark.parametrize(
    ("name", "value", "method"),
    [
        # example:indirect: F_п1 2 kN, z 8, f_set 0.3, R 0.1, κ = C − 0.04; F_п2 = F_п1 (1 + z f_set κ)
        ("C", 0.04 + 0.5 / (8 * 2 * 0.3), "closed-form"),
        ("F", 2500 / (1 + 8 * 0.3 * 0.96), "closed-form"),
        # κ = 1 − 0.4 R, so that R = (1 − 0.25/2.4)/0.4
        ("R", (1 - 0.25 / 2.4) / 0.4, "bracketed-root"),
    ],
)
def test_what_gives_a_control_spring_of_2_5_kn(name, value, method):
    clutch = build(read_spec("example:indirect"))
    result, solved, _ = solve(clutch, name, "control_force", 2500.0)
    assert (result.value, result.method) == (pytest.approx(value, rel=1e-9), method)
    assert solved.control_force == pytest.approx(2500.0, rel=1e-9)


def test_driving_pairs():
    """More bypass pairs regulate less; f 0.1…0.8, z 8, C 0.5: z_1 = 2 gives 3.06, 3 gives 3.33."""
    result, _, _ = solve(build(read_spec()), "z1", "accuracy_factor", 3.2)
    assert result.value == 2
    assert result.exact_value is None, "2.55 is beyond the gain limit, 1/(C f_max) = 2.5"
    beyond, _, _ = solve(build(read_spec()), "z1", "accuracy_factor", 3.2, beyond_limit=True)
    # z_2 = (8 − 3.2)/(0.5·0.8·2.2)
    assert beyond.exact_value == pytest.approx(8 - 4.8 / 0.88)
    assert beyond.value == 2


ALPHA = ["C=", f"alpha={math.atan(0.25)} rad"]
UNATTAINABLE = [
    ("C", "accuracy_factor", 1.5, None, [], 1.875, 1.25),  # the gain limit 1/(z_1 f_1max)
    ("C", "accuracy_factor", 9.0, None, [], 8.0, 0.0),
    ("C", "accuracy_factor", 1.0, S21, [], 1.0, None),
    # K_т at zC = 5 is m (1 + 5 f_min)/(1 + 5 f_max) = 8·1.5/5 for every z
    ("C", "accuracy_factor", 2.0, "example:all-driving", ["f_min=0.1", "f_max=0.8", "z=13"], 2.4, 5 / 13),
    ("z1", "accuracy_factor", 2.7, None, [], 8 * 1.35 / 3.8, 1),
    ("z", "nominal_torque", 1e6, None, [], 2000 * 0.1 / 0.5, None),
    # both torques go to F R/C as z grows; beyond 1e7 pairs their difference is only rounding
    ("z", "scatter", 1e-9, None, [], 0.0, None),
    # κ = 0 at R = C d/(2 f_1) = 1/6 m: T = z R f F
    ("R", "torque_max", 2200.0, S21, [], 8 * 0.8 * 2000 / 6, 1 / 6),
    # the gain follows R: C = R tan α/r = 1.25 at R = 0.05·1.25/0.25, T = F R z f/(1 + z_2 C f)
    ("R", "torque_max", 1000.0, None, ALPHA, 400.0, 0.25),
    # below F_п1 the sleeve would leave its stop without torque; at C = 2 R f_1/d = 2·0.1·0.15/0.05 F_п2 = F_п1
    ("C", "control_force", 1500.0, S21, [], 2000.0, 0.6),
    ("z", "control_force", 2500.0, "example:indirect", [], 2000 * 1.288, 1),  # F_п1 (1 + 0.288 z)
]
"""Parameter, target, wanted, spec, overrides; the best, and where it is (None: approached as the parameter grows)."""


@pytest.mark.parametrize(("name", "target", "wanted", "spec", "overrides", "best", "at"), UNATTAINABLE)
def test_the_best_of_what_cannot_be_had(name, target, wanted, spec, overrides, best, at):
    with pytest.raises(NotAttainableError) as refused:
        solve(build(read_spec(spec, overrides)), name, target, wanted)
    assert refused.value.best == pytest.approx(best, rel=1e-6, abs=1e-6)
    assert (refused.value.at is None) if at is None else (refused.value.at == pytest.approx(at, rel=1e-6))


def test_a_gain_that_is_given_does_not_bound_the_radius():
    """T = F R z f/(1 + z_2 C f), z_2 C = 3.5, whatever R."""
    result, _, _ = solve(build(read_spec()), "R", "torque_max", 1000.0)
    assert result.value == pytest.approx(1000 * (1 + 3.5 * 0.8) / (2000 * 8 * 0.8))


@pytest.mark.parametrize("wanted", [1.0, 9.0])
def test_the_best_at_a_kink_between_two_samples(wanted):
    """(z_1 f_max + z_2 f_min)/(z f_min) at C = 1.25; 8 at 0."""
    with pytest.raises(NotAttainableError) as refused:
        solve(build(read_spec()), "C", "accuracy_factor_peak", wanted, beyond_limit=True)
    assert (refused.value.best, refused.value.at) == pytest.approx((1.875, 1.25) if wanted == 1 else (8, 0))


@pytest.mark.parametrize(
    "arguments",
    [
        "--for F accuracy_factor=2", "--for c1 accuracy_factor=2", "--for c2 accuracy_factor=2", "--for x accuracy_factor=2",
        f"--for R reduced_gain=8 {S21}", f"--for c2 control_force=3kN {S21}", "--for z1 accuracy_factor=2 --set C=2",
        "acuracy_factor=2", "accuracy_factor", "nominal_torque=2J", "nominal_torque=-2", "travel_max=1mm",
        "control_force=1kN", "accuracy_factor=nan", "exceedance=0.1", "temperature=150",
    ],
)  # fmt: skip
def test_what_cannot_be_asked(arguments, afmcalc):
    run = afmcalc("solve", *arguments.split())
    assert (run.code, run.out) == (2, "")


def test_a_force_replaces_the_torque_it_was_set_for(afmcalc):
    run = afmcalc("solve", "--for", "F", "nominal_torque=250", "--set", "F=", "--set", "T_n=100", "--json").json
    assert "nominal_torque" not in run["spec"]["adjustment"]
    assert "solve-replaces" in [finding["code"] for finding in run["findings"]]
    # F = T (1 + 3.5·0.1)/(0.1·8·0.1)
    assert run["result"]["value"] == pytest.approx(250 * 1.35 / 0.08)


@pytest.mark.parametrize("wanted", [1.9, 2.75, 8.0])
def test_a_second_value_is_named(wanted):
    """Peaks: K_т falls up to C = 1.25, then is z_1 f_max (1 + z_2 C f_min)/(z f_min) = 1 + 0.7 C, up to 8 at C = 10."""
    spec = read_spec()
    result, _, findings = solve(build(spec), "C", "accuracy_factor_peak", wanted, beyond_limit=True)
    within, _, none = solve(build(spec), "C", "accuracy_factor_peak", wanted)
    assert result.value == within.value < 1.25
    (told,) = [finding for finding in findings if finding.code == "solve-another-value"]
    assert told.value == pytest.approx((wanted - 1) / 0.7, rel=1e-12)
    assert "solve-another-value" not in [finding.code for finding in none]


@pytest.mark.parametrize("count", [4, pytest.param(20, marks=pytest.mark.slow)])
@pytest.mark.parametrize("name", PARAMETERS)
def test_against_a_scan(name, count):
    """What is solved is, what is refused has no answer, the best is one (1,000 each: python tests/solve_scan.py 1000)."""
    seen = run(name, count)
    assert seen["solved"] > 0.3 * count, seen


def test_a_plateau_is_no_answer(afmcalc):
    """Above C_1* the largest torque is T_н whatever c_1: every c_1 below 1240 N/mm gives 160 N·m, none is the answer."""
    pocket = ["--set", "control_unit.pocket=", "--set", "control_unit.gain_slope=900"]
    refused = afmcalc("solve", "--for", "c1", "torque_max=160", CONFIGS / "constant-torque.toml", *pocket)
    assert refused.code == 2
    assert "torque_max = 160 N·m is given by a whole range of c1, not by one value" in refused.err
    rising = afmcalc("solve", "--for", "c1", "torque_max=170", CONFIGS / "constant-torque.toml", *pocket, "--json")
    assert rising.json["result"]["reached"] == pytest.approx(170)


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


def test_what_check_says_of_the_clutch_found():
    result, solved, _ = solve(build(read_spec(*LIFE)), "F", "cycles", 1e5)
    again = build(respecified(solved.spec, {"requirements.cycles": 1e5, "requirements.temperature": None}))
    values = {row.requirement: row.value for row in check(again)[0].requirements}
    assert values["cycles"] == result.reached


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
