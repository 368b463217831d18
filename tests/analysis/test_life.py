"""Setting and life (S19), overload (S22): springs set by each method, slips one by one, loads that rise; strength, one dynamic factor, sweeps."""

import math

import numpy as np
import pytest
from conftest import CONFIGS
from hypothesis import assume, given
from hypothesis import strategies as st
from strategies import direct_specs, indirect_specs

from afmcalc.analysis.adjust import adjust
from afmcalc.analysis.asking import Answers
from afmcalc.analysis.check import check
from afmcalc.analysis.fatigue import life, life_sweep
from afmcalc.analysis.simulate import simulate
from afmcalc.analysis.sweep import parse_axis
from afmcalc.analysis.trip import overload
from afmcalc.engines import build
from afmcalc.spec import make_spec, read_spec, resolved

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
    """Without a given factor, that of the event, 2.83: τ' 16.43 MPa; a given one is used, even if it is less."""
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
    """Steps give the peak within 0.1 %, hence a life, which has its 6th power, within 0.6 %."""
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


FRICTION = {"min": 0.1, "mean": 0.3, "max": 0.8}
DIRECT = direct_specs(("differentiated", "all-driving"))


def changed(spec, **blocks):
    return build(make_spec({**resolved(spec), **blocks}))


@given(DIRECT, st.floats(1.0, 2.5))
def test_bands_by_formula_and_by_direct_comparison(spec, margin):
    """S19 (7), (10), (11) and (12) against torques calculated from springs set by each method."""
    own = spec.friction.range
    assume(own.max > own.min * 1.001)
    clutch = changed(spec, adjustment={"margin": margin})
    result, _ = adjust(clutch)
    forces = [setting.closing_force for setting in (result.min_friction, result.mean_friction)]
    at_min, at_mean = (changed(clutch.spec, closing_spring={"force": force}) for force in forces)
    assert at_min.at(friction=own.min)["torque"] == pytest.approx(result.nominal_torque, rel=1e-12)
    assert at_mean.at(friction=own.mean)["torque"] == pytest.approx(margin * result.nominal_torque, rel=1e-12)
    bands = [each.at(friction=own.max)["torque"] - each.at(friction=own.min)["torque"] for each in (at_min, at_mean)]
    assert [result.min_friction.scatter, result.mean_friction.scatter] == pytest.approx(bands, rel=1e-9)
    assert result.scatter_ratio == pytest.approx(bands[1] / bands[0], rel=1e-9)
    lowest = at_mean.at(friction=own.min)["torque"]
    assert result.scatter_ratio == pytest.approx(lowest / result.nominal_torque, rel=1e-9)
    assert result.force_ratio == pytest.approx(forces[0] / forces[1] * margin)
    for one in (result.min_friction, result.mean_friction):
        assert one.accuracy_factor == pytest.approx(clutch.accuracy_factor, rel=1e-12)
    if margin > 1 and clutch.gain > 1e-6 and abs(result.scatter_ratio - 1) > 1e-9:
        # no threshold if the method has the narrower band whatever the number of pairs
        assert (result.pairs_threshold is None) == (margin * own.min >= own.mean)
        threshold = -math.inf if result.pairs_threshold is None else result.pairs_threshold
        assert (result.narrower == "min-friction") == (spec.friction_group.pairs > threshold)
    if margin == 1:
        assert result.pairs_threshold is None
        assert result.narrower in ("mean-friction", "equal")


@given(indirect_specs())
def test_methods_differ_on_indirect_clutches(spec):
    result, _ = adjust(build(spec))
    own = spec.friction.range
    for method in ("min-friction", "mean-friction"):
        kept, data = getattr(result, method.replace("-", "_")), resolved(spec)
        data["closing_spring"]["force"], data["adjustment"]["method"] = kept.closing_force, method
        clutch = build(make_spec(data))
        assert kept.accuracy_factor == pytest.approx(clutch.accuracy_factor)
        low, high = (clutch.at(friction=end)["torque"] for end in (own.min, own.max))
        assert kept.scatter == pytest.approx(high - low, rel=1e-9, abs=1e-9)
    assert (result.pairs_threshold, result.force_ratio) == (None, None)


@pytest.mark.parametrize(("margin", "held"), [(1.25, False), (2.5, True)])
def test_the_narrower_band_is_not_advised_without_what_it_costs(answered, margin, held):
    """ΔT_2/ΔT_1 is T_min2/T_н: T(f_min) = β_н T_н g(0.1)/g(0.3), 75 N·m, is below T_н = 118.5 and the machine's 94.8."""
    told = answered("adjust", "--set", f"adjustment.margin={margin}", "--json").json
    result, lowest = told["result"], margin * 118.519 * (0.1 / 1.35) / (0.3 / 2.05)
    assert result["nominal_torque"] == pytest.approx(118.519, rel=1e-4)
    assert result["machine_torque"] == pytest.approx(118.519 / margin, rel=1e-4)
    assert (result["narrower"] == "mean-friction") == (margin == 1.25)
    assert result["mean_friction"]["torque"]["min"] == pytest.approx(lowest, rel=1e-4)
    for method, holds in (("min_friction", True), ("mean_friction", held)):
        assert (result[method]["holds_nominal"], result[method]["holds_machine"]) == (holds, holds)
    found = [each for each in told["findings"] if each["code"] == "narrower-below-nominal"]
    assert [(each["level"], round(each["value"], 1)) for each in found] == ([] if held else [("info", 75.0)])


RULES = {
    "mean-stress": ("exponent", 6, lambda a, m: m),
    "amplitude": ("mean_stress_sensitivity", 0.1, lambda a, m: a + 0.1 * m),
    "goodman": ("ultimate_strength", 400e6, lambda a, m: a / (1 - m / 400e6)),
}
"""Rule → key of [fatigue] that it needs, value of the key, damaging stress from amplitude and mean stress."""
FATIGUE = {"polar_section_modulus": 15e-6, "exponent": 6, "base_cycles": 1e7}


@pytest.mark.parametrize("model", ["amplitude", "goodman"])
@pytest.mark.parametrize("endurance", [1e6, 6e6])
@pytest.mark.parametrize("source", ["default", "indirect", "unlike-materials"])
def test_a_slip_at_a_time(model, endurance, source):
    """Each slip does the damage of its own cycle; slips below the endurance limit do none."""
    key, value, equivalent = RULES[model]
    spec = read_spec(f"example:{source}", ["adjustment.method=mean-friction"])
    clutch = changed(spec, fatigue={**FATIGUE, key: value, "endurance_limit": endurance})
    result, _ = life(clutch, model)
    share = (np.arange(4_000) + 0.5) / 4_000
    high = clutch.at_friction(*(r.min + share * (r.max - r.min) for r in clutch.spec.friction.groups))["torque"] / 15e-6
    for side, factor in (("protected", 1.0), ("unprotected", clutch.spec.drive.dynamic_factor)):
        stress = equivalent(factor * high / 2, factor * high / 2)
        damage = np.where(stress > endurance, (stress / endurance) ** 6 / 1e7, 0).mean()
        found = getattr(result, side).mean_friction
        assert found is None if damage == 0 else found == pytest.approx(1 / damage, rel=1e-2), "of 256 slips"


@given(DIRECT, st.floats(1, 3), st.floats(0, 1))
def test_equilibrium_is_the_expected_torque_for_every_margin(spec, margin, share):
    """M12, M17: load until the pack slips: the release force follows the load, and the capacity falls linearly with it."""
    clutch = changed(spec, adjustment={"margin": margin})
    own, z, radius = spec.friction.range, spec.friction_group.pairs, clutch.mean_radius
    f, share_of_balls = own.min + share * (own.max - own.min), (z - clutch.bypass_pairs) / z

    def capacity(load, f):
        """The load that the pack can carry while it carries ``load``, shared z_1 : z_2."""
        return z * f * radius * (clutch.closing_force - load * share_of_balls * clutch.gain / radius)

    slope = capacity(0.0, f) - capacity(1.0, f)
    assert capacity(0.0, f) / (1 + slope) == pytest.approx(clutch.at(friction=f)["torque"], rel=1e-9)
    result, _ = overload(clutch)
    for at in ("min", "mean", "max"):
        end = getattr(own, at)
        torque = clutch.at(friction=end)["torque"]
        assert getattr(result.actuation_torque_equilibrium, at) == pytest.approx(torque, rel=1e-9)
        potential = capacity(clutch.at(friction=own.min)["torque"] / margin, end)
        assert getattr(result.potential_torque, at) == pytest.approx(potential, rel=1e-9)
        published = getattr(result.expected_torque, at) * getattr(result.actuation_factor, at)
        assert getattr(result.actuation_torque_published, at) == pytest.approx(published, rel=1e-9, abs=1e-9)


@given(DIRECT, st.floats(1, 3))
def test_17_is_where_published_is_below_expected(spec, margin):
    own = spec.friction.range
    clutch = changed(spec, adjustment={"margin": margin})
    assume(clutch.gain > 1e-3)
    assume(own.max > own.min * 1.01)
    f = np.linspace(own.min, own.max, 401)
    # A of S22 (15) mended: T_ср/T_муф with u = (z − z_1) C f_min, v = (z − z_1) C f
    u, v = (clutch.controlled_pairs * clutch.gain * friction for friction in (own.min, f))
    factor = (margin * v * (1 + u) + (1 - v * v) * own.min / f) / (margin * (1 + u))
    low, high = overload(clutch)[0].friction_interval or (np.inf, -np.inf)
    edge = np.isclose(f, low, rtol=1e-3) | np.isclose(f, high, rtol=1e-3)
    assert not np.any(((factor < 1 - 1e-9) != ((f > low) & (f < high))) & ~edge)
