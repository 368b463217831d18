"""Шишкарёв 2019 (S19): the two adjustment methods and life; P1–P3."""

import math

import numpy as np
import pytest
from conftest import CONFIGS
from hypothesis import assume, given
from hypothesis import strategies as st
from strategies import direct_specs, indirect_specs

from afmcalc.analysis.adjust import adjust
from afmcalc.analysis.life import life
from afmcalc.engines import build
from afmcalc.equations import adjustment
from afmcalc.equations import life as fatigue
from afmcalc.spec import make_spec, read_spec, resolved


def with_margin(spec, margin):
    return make_spec({**resolved(spec), "adjustment": {"margin": margin}})


@given(direct_specs(("differentiated", "all-driving")), st.floats(1.0, 2.5))
def test_bands_by_formula_and_by_direct_comparison(spec, margin):
    """(7), (10), (11) and (12) against torques calculated from springs set by each method."""
    own = spec.friction.range
    assume(own.max > own.min * 1.001)
    clutch = build(with_margin(spec, margin))
    result, _ = adjust(clutch)
    at_min = build(make_spec({**resolved(clutch.spec), "closing_spring": {"force": result.min_friction.closing_force}}))
    at_mean = build(
        make_spec({**resolved(clutch.spec), "closing_spring": {"force": result.mean_friction.closing_force}})
    )
    assert at_min.torque(own.min) == pytest.approx(result.nominal_torque, rel=1e-12)
    assert at_mean.torque(own.mean) == pytest.approx(margin * result.nominal_torque, rel=1e-12)
    bands = [c.torque(own.max) - c.torque(own.min) for c in (at_min, at_mean)]
    assert [result.min_friction.scatter, result.mean_friction.scatter] == pytest.approx(bands, rel=1e-9)
    for c, band in zip((at_min, at_mean), bands, strict=True):
        formula = adjustment.scatter(
            c.closing_force, c.mean_radius, spec.friction_group.pairs, c.controlled_pairs, c.gain, own.min, own.max
        )
        assert formula == pytest.approx(band, rel=1e-9)
    assert result.scatter_ratio == pytest.approx(bands[1] / bands[0], rel=1e-9)
    assert result.scatter_ratio == pytest.approx(at_mean.torque(own.min) / result.nominal_torque, rel=1e-9)
    assert result.min_friction.accuracy_factor == result.mean_friction.accuracy_factor == clutch.accuracy_factor
    forces = result.min_friction.closing_force / (result.mean_friction.closing_force / margin)
    assert forces == pytest.approx(
        adjustment.force_ratio(*(c.torque(f) / c.closing_force for c, f in ((at_mean, own.mean), (at_min, own.min))))
    )
    if margin > 1 and clutch.gain > 1e-6 and abs(result.scatter_ratio - 1) > 1e-9:
        # no threshold where the method is narrower whatever the number of pairs
        assert (result.pairs_threshold is None) == (margin * own.min >= own.mean)
        threshold = -math.inf if result.pairs_threshold is None else result.pairs_threshold
        assert (result.narrower == "min-friction") == (spec.friction_group.pairs > threshold)
    if margin == 1:
        assert result.pairs_threshold is None
        assert result.narrower in ("mean-friction", "equal")


@given(direct_specs(), st.floats(1, 2))
def test_every_direct_variant_is_adjusted(spec, margin):
    result, _ = adjust(build(with_margin(spec, margin)))
    assert result.min_friction.accuracy_factor == pytest.approx(result.mean_friction.accuracy_factor)


@given(indirect_specs())
def test_methods_differ_on_indirect_clutches(spec):
    result, _ = adjust(build(spec))
    own = spec.friction.range
    for kept, method in ((result.min_friction, "min-friction"), (result.mean_friction, "mean-friction")):
        data = resolved(spec)
        data["closing_spring"]["force"] = kept.closing_force
        data["adjustment"]["method"] = method
        clutch = build(make_spec(data))
        assert kept.accuracy_factor == pytest.approx(clutch.accuracy_factor)
        assert kept.scatter == pytest.approx(clutch.torque(own.max) - clutch.torque(own.min), rel=1e-9, abs=1e-9)
    assert result.pairs_threshold is None


def test_p1_threshold():
    """(12) gives 8.197 with the printed C = 1.6; the printed 9.23 needs C = 1.4 (M7)."""
    assert adjustment.pairs_threshold(1, 1.6, 0.15, 0.33, 1.25) == pytest.approx(8.197, abs=5e-4)
    assert adjustment.pairs_threshold(1, 1.4, 0.15, 0.33, 1.25) == pytest.approx(9.225, abs=5e-4)


def test_p2_p3_life_falls_with_the_band():
    def cycles(scatter):
        return fatigue.cycles_of_band(400e6, 15e-6, 200, scatter, 6, 1e7)

    assert cycles(500) / cycles(1100) == pytest.approx((1500 / 900) ** 6)
    assert cycles(500) / cycles(1100) == pytest.approx(21.43, abs=5e-3)
    forecast = [(600 + 200 + band) / (400 + band) for band in (500, 1100)]
    assert forecast == pytest.approx([1.444, 1.267], abs=5e-4)


def test_fig_2_from_the_command_line(afmcalc):
    """``life --sweep dT``: T_min = 200 N·m, ΔT 500…1100; curve 1 falls 21.43 times."""
    spec = ["--set", "closing_spring.force=", "--set", "T_n=200"]
    sweep = afmcalc("life", *spec, "--sweep", "dT=500:1100:7", "--json").json["result"]["sweep"][0]
    assert sweep["protected"][0] / sweep["protected"][-1] == pytest.approx((1500 / 900) ** 6)
    assert sweep["protected"][0] == pytest.approx(1e7 * (2 * 400e6 * 15e-6 / 900) ** 6)
    factor = 1.4
    assert sweep["unprotected"] == pytest.approx([n / factor**6 for n in sweep["protected"]])


FATIGUE = {"endurance_limit": 20e6, "polar_section_modulus": 15e-6, "exponent": 6, "base_cycles": 1e7}


def rule(model):
    """Key of [fatigue], its value, and the damaging stress of amplitude and mean."""
    return {
        "mean-stress": ("exponent", 6, lambda a, m: m),
        "amplitude": ("mean_stress_sensitivity", 0.1, lambda a, m: a + 0.1 * m),
        "goodman": ("ultimate_strength", 400e6, lambda a, m: a / (1 - m / 400e6)),
    }[model]


def fatigued(model, endurance, **more):
    key, value, _ = rule(model)
    block = {**FATIGUE, key: value, "endurance_limit": endurance, **more}
    return make_spec({**resolved(read_spec()), "fatigue": block})


def test_the_papers_rule_takes_the_band_as_one_cycle():
    spec = fatigued("mean-stress", 1e6)
    result, _ = life(build(spec), "mean-stress")
    settings, _ = adjust(build(spec))
    for side, factor in (("protected", 1.0), ("unprotected", 1.4)):
        for method in ("min_friction", "mean_friction"):
            torque = getattr(settings, method).torque
            mean = factor * (torque.min + torque.max) / 2 / 15e-6
            assert getattr(getattr(result, side), method) == pytest.approx(1e7 * (1e6 / mean) ** 6, rel=1e-9)


@pytest.mark.parametrize("model", ["amplitude", "goodman"])
@pytest.mark.parametrize("endurance", [1e6, 6e6])
@pytest.mark.parametrize("source", ["default.toml", "indirect.toml", "unlike-materials.toml"])
def test_a_slip_at_a_time(model, endurance, source):
    """A slow walk through slips: each does its damage by its own swing, those below the endurance limit none."""
    key, value, equivalent = rule(model)
    block = {**FATIGUE, key: value, "endurance_limit": endurance}
    data = resolved(read_spec(CONFIGS / source, ["adjustment.method=mean-friction"]))
    clutch = build(make_spec({**data, "fatigue": block}))
    result, _ = life(clutch, model)
    own = clutch.friction
    for side, factor in (("protected", 1.0), ("unprotected", clutch.spec.drive.dynamic_factor)):
        damage, slips = 0.0, 256
        for number in range(slips):
            share = (number + 0.5) / slips
            high = factor * clutch.torque(*(r.min + share * (r.max - r.min) for r in own))
            stress = equivalent(high / 15e-6 / 2, high / 15e-6 / 2)
            if stress > endurance:
                damage += 1 / (1e7 * (endurance / stress) ** 6)
        found = getattr(result, side).mean_friction
        assert found is None if damage == 0 else found == pytest.approx(slips / damage, rel=1e-9)


@pytest.mark.parametrize(("factor", "times"), [(2.84, 7.7), (1.5, 113), (1.25, 588)])
def test_the_better_the_clutch_the_more_its_band_flatters(factor, times):
    """T_min … T_max as the swing of a slip to T_max overstates its life (ψ 0.1, m_τ 6)."""
    slip, band = (fatigue.equivalent_stress_sensitivity(low, factor, 0.1) for low in (0.0, 1.0))
    assert (slip / band) ** 6 == pytest.approx(times, rel=5e-3)


def test_life_without_limit_is_null_with_a_finding(afmcalc):
    run = afmcalc("life", "--model", "amplitude", "--set", "fatigue.mean_stress_sensitivity=0.1", "--json").json
    lives = dict.fromkeys(("as_set", "min_friction", "mean_friction"))
    both = ["as-set", "min-friction", "mean-friction"]
    assert run["result"]["protected"] == {**lives, "unlimited": both}
    assert "life-not-limited" in [finding["code"] for finding in run["findings"]]
    extrapolated = afmcalc("life", "--json").json
    assert extrapolated["result"]["protected"]["min_friction"] > 1e7
    assert "life-not-limited" in [finding["code"] for finding in extrapolated["findings"]]


def test_life_asks_for_what_it_needs(afmcalc):
    for arguments, says in (
        (["--set", "fatigue="], "fatigue: required by life"),
        (["--model", "amplitude"], "fatigue.mean_stress_sensitivity: required by the model 'amplitude'"),
        (["--model", "goodman"], "fatigue.ultimate_strength: required by the model 'goodman'"),
        (["--sweep", "dT=-5,3"], "not negative"),
        (["--sweep", "dT", "--sweep", "C"], "swept alone"),
    ):
        run = afmcalc("life", *arguments)
        assert run.code == 2
        assert says in run.err


def test_static_failure_is_an_error(afmcalc):
    weak = ["--set", "fatigue.ultimate_strength=30 MPa", "--set", "fatigue.endurance_limit=1 MPa"]
    run = afmcalc("life", "--model", "goodman", *weak, "--json")
    assert "static-strength-exceeded" in [finding["code"] for finding in run.json["findings"]]
    assert afmcalc("check", *weak).code == 1
    for model in (["--model", "amplitude", "--set", "fatigue.mean_stress_sensitivity=0.1"], []):
        broken = afmcalc("life", *model, *weak, "--set", "fatigue.ultimate_strength=15 MPa", "--json").json
        assert broken["result"]["unprotected"] == {"as_set": 0, "min_friction": 0, "mean_friction": 0, "unlimited": []}
        assert "static-strength-exceeded" in [finding["code"] for finding in broken["findings"]]


def test_life_over_the_gain_is_the_single_calculations(afmcalc):
    sweep = afmcalc("life", "--sweep", "C=0.2:1:3", "--json").json["result"]["sweep"][0]
    for gain, cycles in zip(sweep["values"], sweep["protected"], strict=True):
        single = afmcalc("life", "--set", f"C={gain!r}", "--json").json["result"]
        assert single["protected"]["min_friction"] == pytest.approx(cycles, rel=1e-12)


def test_adjust_without_scatter_divides_nothing_by_zero():
    spec = read_spec(CONFIGS / "default.toml", ["friction.min=0.3", "friction.max=0.3", "beta=1"])
    result, _ = adjust(build(spec))
    assert result.scatter_ratio is None
    assert result.narrower == "equal"
    assert np.isfinite(result.mean_friction.closing_force)


@pytest.mark.parametrize(("margin", "machine", "held"), [(1.25, 94.815, False), (2.5, 47.407, True)])
def test_the_narrower_band_is_not_advised_without_what_it_costs(afmcalc, margin, machine, held):
    """ΔT_2/ΔT_1 is T_min2/T_н: T(f_min) = β_н T_н g(0.1)/g(0.3), 75 N·m, is below T_н = 118.5 and the machine's 94.8."""
    told = afmcalc("adjust", "--set", f"adjustment.margin={margin}", "--json").json
    result, lowest = told["result"], margin * 118.519 * (0.1 / 1.35) / (0.3 / 2.05)
    assert (result["nominal_torque"], result["machine_torque"]) == pytest.approx((118.519, machine), rel=1e-4)
    assert (result["narrower"] == "mean-friction") == (margin == 1.25)
    assert result["mean_friction"]["torque"]["min"] == pytest.approx(lowest, rel=1e-4)
    for method, holds in (("min_friction", True), ("mean_friction", held)):
        assert (result[method]["holds_nominal"], result[method]["holds_machine"]) == (holds, holds)
    found = [each for each in told["findings"] if each["code"] == "narrower-below-nominal"]
    assert [(each["level"], round(each["value"], 1)) for each in found] == ([] if held else [("info", 75.0)])
    if not held:
        (said,) = found
        assert "94.815" in said["message"]
        page = afmcalc("report", "-o", "-").out
        assert "where that torque must be carried" in page


def test_a_threshold_below_any_clutch_is_none(afmcalc):
    result = afmcalc("adjust", "--set", "adjustment.margin=5", "--json").json["result"]
    assert result["pairs_threshold"] is None
    assert result["narrower"] == "min-friction"


def test_force_of_both_methods(afmcalc):
    """S19 (7) as printed, z 8, C 0.5, f_min 0.1, f_cp 0.3; there is none of an indirect clutch."""
    result = afmcalc("adjust", "--json").json["result"]
    assert result["force_ratio"] == pytest.approx(0.3 * (1 + 7 * 0.5 * 0.1) / (0.1 * (1 + 7 * 0.5 * 0.3)))
    forces = [result[method]["closing_force"] for method in ("min_friction", "mean_friction")]
    assert forces[0] / forces[1] * result["margin"] == pytest.approx(result["force_ratio"])
    assert afmcalc("adjust", "example:indirect", "--json").json["result"]["force_ratio"] is None
