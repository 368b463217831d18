"""solve: what it finds gives what was wanted; what it refuses has no answer."""

import math

import numpy as np
import pytest
from conftest import CONFIGS, S21, several
from hypothesis import assume, given
from hypothesis import strategies as st
from solve_scan import run
from strategies import direct_specs, indirect_specs

from afmcalc.analysis.solve.search import Domain, explore
from afmcalc.analysis.solve.solve import PARAMETERS, TARGETS, NotAttainableError, solve
from afmcalc.engines import build
from afmcalc.errors import AfmcalcError, CalculationError
from afmcalc.spec import read_spec
from afmcalc.spec.edit import respecified

TARGET_NAMES = ["accuracy_factor", "nominal_torque", "torque_max", "scatter"]


@given(direct_specs(("differentiated", "unlike", "all-driving")), st.sampled_from(TARGET_NAMES), st.floats(0.05, 0.95))
def test_gain_of_a_direct_clutch(spec, target, share):
    clutch = build(spec)
    goal = share * float(clutch.gain_limit)
    wanted = float(TARGETS[target].value(build(respecified(spec, {"control_unit.gain": goal}))))
    far = float(TARGETS[target].value(build(respecified(spec, {"control_unit.gain": 0.0}))))
    assume(abs(far / wanted - 1) > 1e-3 if wanted > 1e-6 else False)
    result, solved, _ = solve(clutch, "C", target, wanted)
    assert result.reached == pytest.approx(wanted, rel=1e-6)
    assert 0 <= result.value <= clutch.gain_limit * (1 + 1e-9)
    assert float(TARGETS[target].value(solved)) == result.reached
    if target == "nominal_torque":
        assert result.method == "closed-form"
        assert result.value == pytest.approx(goal, rel=1e-6, abs=1e-9)


@given(indirect_specs(("min-friction",)), st.sampled_from(["C", "z", "c1", "c2"]))
def test_an_indirect_clutch_gives_its_own_parameter_back(spec, name):
    clutch = build(spec)
    assume(clutch.control_stiffness > 100)
    wanted = float(clutch.accuracy_factor)
    own = clutch.friction[0]
    assume(1 + 1e-4 < wanted < own.max / own.min * (1 - 1e-4))
    assume(name != "c1" or wanted > 1.01)
    now = {"C": clutch.gain, "z": clutch.pairs, "c1": clutch.closing_stiffness, "c2": clutch.control_stiffness}[name]
    result, _, _ = solve(clutch, name, "accuracy_factor", wanted)
    assert result.method == "closed-form"
    assert (result.exact_value or result.value) == pytest.approx(now, rel=1e-5)


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
        # F_п1 (1 + 0.288 z) ≤ 2.5 kN
        ("z", None, "refused"),
        # κ = 1 − 0.4 R, so that R = (1 − 0.25/2.4)/0.4
        ("R", (1 - 0.25 / 2.4) / 0.4, "bracketed-root"),
    ],
)
def test_what_gives_a_control_spring_of_2_5_kn(name, value, method):
    clutch = build(read_spec("example:indirect"))
    if value is None:
        with pytest.raises(NotAttainableError, match="the best is 2576 N, reached at z = 1"):
            solve(clutch, name, "control_force", 2500.0)
        return
    result, solved, _ = solve(clutch, name, "control_force", 2500.0)
    assert (result.value, result.method) == (pytest.approx(value, rel=1e-9), method)
    assert solved.control_force == pytest.approx(2500.0, rel=1e-9)


@given(direct_specs(), st.sampled_from(["nominal_torque", "torque_max", "scatter"]), st.floats(0.1, 10))
def test_torque_is_proportional_to_the_force(spec, target, factor):
    clutch = build(spec)
    wanted = factor * float(TARGETS[target].value(clutch))
    assume(wanted > 1e-6)
    result, _, _ = solve(clutch, "F", target, wanted)
    assert result.value == pytest.approx(factor * clutch.closing_force, rel=1e-9)
    assert result.method == "closed-form"


@given(direct_specs(("differentiated", "all-driving")), st.floats(1.05, 6))
def test_whole_pairs_are_the_fewest_that_meet_it(spec, wanted):
    clutch = build(spec)
    try:
        result, _, _ = solve(clutch, "z", "accuracy_factor", wanted, beyond_limit=True)
    except CalculationError:
        return
    assert result.value == int(result.value)
    assert result.reached <= wanted * (1 + 1e-9)
    fewest = spec.bypass_pairs + 1 if spec.variant == "differentiated" else 1
    if result.value > fewest:
        fewer = build(respecified(spec, {"friction_group.pairs": result.value - 1}))
        assert fewer.accuracy_factor > wanted * (1 - 1e-8)


def test_driving_pairs():
    """More bypass pairs regulate less; f 0.1…0.8, z 8, C 0.5: z_1 = 2 gives 3.06, 3 gives 3.33."""
    result, _, _ = solve(build(read_spec()), "z1", "accuracy_factor", 3.2)
    assert result.value == 2
    assert result.exact_value is None, "2.55 is beyond the gain limit, 1/(C f_max) = 2.5"
    beyond, _, _ = solve(build(read_spec()), "z1", "accuracy_factor", 3.2, beyond_limit=True)
    # z_2 = (8 − 3.2)/(0.5·0.8·2.2)
    assert beyond.exact_value == pytest.approx(8 - 4.8 / 0.88)
    assert beyond.value == 2


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["--for", "C", "accuracy_factor=1.5"], "the best is 1.875, reached at C = 1.25 (the gain limit 1/(z_1 f_1max))"),
        (["--for", "C", "accuracy_factor=2", CONFIGS / "all-driving.toml", "--set", "f_min=0.1", "--set", "f_max=0.8"],
         "the best is 2.4, reached at C = "),
        (["--for", "C", "accuracy_factor=1", S21], "the best is 1, approached as C grows"),
        (["--for", "C", "accuracy_factor=9"], "the best is 8, reached at C = 0"),
        (["--for", "z1", "accuracy_factor=2.7"], "the best is 2.84211, reached at z1 = 1"),
        (["--for", "z", "nominal_torque=1000000"], "the best is 400 N·m, approached as z grows"),
        # both torques go to F R/C as z grows; beyond 1e7 pairs their difference is only rounding
        (["--for", "z", "scatter=1e-9"], "the best is 0 N·m, approached as z grows"),
        (["--for", "F", "accuracy_factor=2"], "does not depend on F"),
        # a kink between two samples, (z_1 f_max + z_2 f_min)/(z f_min)
        (["--for", "C", "accuracy_factor_peak=1", "--beyond-limit"], "the best is 1.875, reached at C = 1.25\n"),
        (["--for", "C", "accuracy_factor_peak=9", "--beyond-limit"], "the best is 8, reached at C = 0\n"),
        # κ = 0 at R = C d/(2 f_1) = 1/6 m: T = z R f F = 8·0.8·2000/6
        (["--for", "R", "torque_max=2200", S21],
         "the best is 2133.33 N·m, reached at R = 0.166667 m (the feedback ends, C = 2 R f_1/d)"),
        (["--for", "R", "reduced_gain=8", S21],
         "reduced_gain does not depend on R here: it is 8 for every value"),
        # the gain follows R: C = R tan α/r = 1.25 at R = 0.05·1.25/0.25, T = F R z f/(1 + z_2 C f)
        (["--for", "R", "torque_max=1000", "--set", "C=", "--set", f"alpha={math.atan(0.25)} rad"],
         "the best is 400 N·m, reached at R = 0.25 m (the gain limit 1/(z_1 f_1max))"),
        (["--for", "z1", "accuracy_factor=2", "--set", "C=2"], "no value of z1 keeps C = 2 within the gain limit"),
        (["--for", "c1", "accuracy_factor=2"], "accuracy_factor does not depend on c1 here"),
        (["--for", "c2", "accuracy_factor=2"], "only for indirect"),
        (["--for", "x", "accuracy_factor=2"], "one of C (control_unit.gain), F (closing_spring.force)"),
        (["acuracy_factor=2"], "did you mean 'accuracy_factor'?"),
        (["accuracy_factor"], "write accuracy_factor=VALUE"),
        (["nominal_torque=2 J"], "nominal_torque=2 J: "),
        (["nominal_torque=-2"], "greater than 0"),
        (["travel_max=1 mm"], "travel_max is only of an indirect clutch"),
        (["F_п2=1 kN"], "control_force is only of an indirect clutch"),
        # below F_п1 the sleeve would leave its stop without torque; at C = 2 R f_1/d = 2·0.1·0.15/0.05 F_п2 = F_п1
        (["--for", "C", "control_force=1.5 kN", S21], "the best is 2000 N, reached at C = 0.6"),
        (["--for", "c2", "control_force=3 kN", S21], "control_force does not depend on c2 here"),
        (["accuracy_factor=nan"], "must be finite"),
    ],
)  # fmt: skip
def test_what_has_no_answer(arguments, says, afmcalc):
    run = afmcalc("solve", *arguments)
    assert (run.code, run.out) == (2, "")
    assert says in run.err


def test_json_pipes_into_torque(afmcalc):
    solved = afmcalc("solve", "--for", "R", "torque_max=300 N*m", CONFIGS / "all-driving.toml", "--json")
    torque = afmcalc("torque", "-", "--json", stdin=solved.out).json["result"]
    assert torque["torque"]["max"] == pytest.approx(300)
    assert solved.json["result"]["value"] == solved.json["spec"]["friction_group"]["mean_radius"]


def test_a_force_replaces_the_torque_it_was_set_for(afmcalc):
    run = afmcalc("solve", "--for", "F", "nominal_torque=250", "--set", "F=", "--set", "T_n=100", "--json").json
    assert "nominal_torque" not in run["spec"]["adjustment"]
    assert "solve-replaces" in [finding["code"] for finding in run["findings"]]
    # F = T (1 + 3.5·0.1)/(0.1·8·0.1)
    assert run["result"]["value"] == pytest.approx(250 * 1.35 / 0.08)


def test_radius_with_a_wall_angle_has_no_closed_form():
    spec = read_spec(None, ["C=", "alpha=14 deg"])
    result, _, _ = solve(build(spec), "R", "nominal_torque", 120.0)
    assert result.method == "bracketed-root"
    assert result.reached == pytest.approx(120, rel=1e-9)


@pytest.mark.parametrize("pairs", [3, 6, 12, 13])
def test_the_limit_itself_is_the_best(pairs, afmcalc):
    """K_т at zC = 5 is m (1 + 5 f_min)/(1 + 5 f_max) = 8·1.5/5 for every z."""
    run = afmcalc("solve", "accuracy_factor=1.01", CONFIGS / "all-driving.toml", "--set", f"z={pairs}")
    assert f"the best is 2.4, reached at C = {5 / pairs:.6g} (the gain limit zC = 5)" in run.err
    with pytest.raises(NotAttainableError) as refused:
        solve(build(read_spec(CONFIGS / "all-driving.toml", [f"z={pairs}"])), "C", "accuracy_factor", 1.01)
    assert refused.value.best == pytest.approx(2.4, rel=1e-12)
    assert refused.value.at == 5 / pairs


def test_the_radius_ends_where_the_feedback_does():
    """R 0.1664 gives 2117 N·m, R = C d/(2 f_1) = 1/6 m is the end."""
    spec = read_spec(S21)
    result, _, _ = solve(build(spec), "R", "torque_max", 2110.0)
    assert 0.166 < result.value < 0.1664
    # S21 (11) with κ = 1 − 6 R, z = 8, f_max = 0.8, c_1 = 2 c_2, F_п2 = F (1 + z κ f_min)
    net, radius = 1 - 6 * result.value, result.value
    assert pytest.approx(8 * radius * 0.8 * 2000 * (1 + 2 * (1 + 0.8 * net)) / (3 + 2 * 6.4 * net)) == 2110


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


def test_an_extreme_is_touched():
    """The kink itself, 1.875 at C = 1.25, is one value, not two."""
    result, _, findings = solve(build(read_spec()), "C", "accuracy_factor_peak", 1.875, beyond_limit=True)
    assert result.value == pytest.approx(1.25, rel=1e-9)
    assert "solve-another-value" not in [finding.code for finding in findings]


@pytest.mark.parametrize("name", PARAMETERS)
def test_against_a_scan(name):
    """What is solved is, what is refused has no answer, the best is one (1,000 each: python tests/solve_scan.py 1000)."""
    count = several(15, 100)
    seen = run(name, count)
    assert seen["solved"] > 0.3 * count, seen


def test_beyond_the_limit_on_request():
    result, _, findings = solve(build(read_spec()), "C", "accuracy_factor", 1.5, beyond_limit=True)
    assert result.value > 1.25
    assert "gain-above-limit" in [finding.code for finding in findings]


def test_errors_from_python():
    with pytest.raises(AfmcalcError, match="cannot be solved for"):
        solve(build(read_spec()), "q", "accuracy_factor", 2.0)


def test_rounding_makes_no_extremes():
    """A plateau that is level to the eleventh digit, of a balance solved by iteration: the one extreme is looked for."""
    calls = []

    def noisy(at):
        calls.append(at)
        return 2 + np.exp(-((np.log(at) - 1) ** 2)) + 1e-11 * np.sin(1e5 * np.log(at))

    curve = explore(noisy, 4.0, Domain(1e-12, low_taken=True, high=math.inf, why=""))
    assert max(curve.value) == pytest.approx(3)
    assert curve.at[np.argmax(curve.value)] == pytest.approx(math.e, rel=1e-4)
    assert len(calls) < 30


def test_a_plateau_is_no_answer(afmcalc):
    """Above C_1* the largest torque is T_н whatever c_1: every c_1 below 1240 N/mm gives 160 N·m, none is the answer."""
    pocket = ["--set", "control_unit.pocket=", "--set", "control_unit.gain_slope=900"]
    refused = afmcalc("solve", "--for", "c1", "torque_max=160", CONFIGS / "constant-torque.toml", *pocket)
    assert refused.code == 2
    assert "torque_max = 160 N·m is given by a whole range of c1, not by one value" in refused.err
    rising = afmcalc("solve", "--for", "c1", "torque_max=170", CONFIGS / "constant-torque.toml", *pocket, "--json")
    assert rising.json["result"]["reached"] == pytest.approx(170)
