"""Setting and life (S19), overload (S22): against springs set by each method, slips one by one, loads that rise."""

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from strategies import direct_specs, indirect_specs

from afmcalc.analysis.adjust import adjust
from afmcalc.analysis.fatigue import life
from afmcalc.analysis.trip import overload
from afmcalc.engines import build
from afmcalc.spec import make_spec, read_spec, resolved

FRICTION = {"min": 0.1, "mean": 0.3, "max": 0.8}
DIRECT = direct_specs(("differentiated", "all-driving"))


def changed(spec, **blocks):
    return build(make_spec({**resolved(spec), **blocks}))


@given(DIRECT, st.floats(1.0, 2.5))
def test_bands_by_formula_and_by_direct_comparison(spec, margin):
    """(7), (10), (11) and (12) against torques calculated from springs set by each method."""
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
        # no threshold where the method is narrower whatever the number of pairs
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
"""Key of [fatigue], its value, and the damaging stress of amplitude and mean."""
FATIGUE = {"polar_section_modulus": 15e-6, "exponent": 6, "base_cycles": 1e7}


@pytest.mark.parametrize("model", ["amplitude", "goodman"])
@pytest.mark.parametrize("endurance", [1e6, 6e6])
@pytest.mark.parametrize("source", ["default", "indirect", "unlike-materials"])
def test_a_slip_at_a_time(model, endurance, source):
    """Each slip does its damage by its own swing, those below the endurance limit none."""
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
