"""Шишкарев 2022 (S22): overload of clutches with a torque margin; P9–P12, P21, M12–M14."""

import numpy as np
import pytest
from conftest import CONFIGS
from hypothesis import assume, given
from hypothesis import strategies as st
from strategies import direct_specs

from afmcalc.analysis.overload import overload
from afmcalc.engines import build
from afmcalc.equations import overload as law
from afmcalc.equations.accuracy import accuracy_factor
from afmcalc.spec import make_spec, read_spec, resolved


def factor(z, z1, gain, f, low=0.1, margin=1.25):
    return law.actuation_factor((z - z1) * gain * f, (z - z1) * gain * low, f, low, margin)


def test_p9_p10_fig_3():
    """A = 3 at zC = 5; the optimum is zC = 1/f_max = 1.25, not 1.6 where A = 1.225 (M13)."""
    assert factor(4, 0, 5 / 4, 0.8) == pytest.approx(3.0, rel=1e-12)
    assert factor(4, 0, 1.25 / 4, 0.8) == pytest.approx(1.0, rel=1e-12)
    assert factor(4, 0, 1.6 / 4, 0.8) == pytest.approx(1.225, abs=5e-4)
    result, _ = overload(build(read_spec(CONFIGS / "all-driving.toml")))
    assert result.accuracy_factor_actual / result.accuracy_factor_expected == pytest.approx(3.0, rel=1e-12)
    assert result.optimal_reduced_gain == pytest.approx(1.25)


def test_the_optimum_is_a_kink_at_a_equals_1(afmcalc):
    """The smallest actual K_т of the sweep lies at zC = 1.25 and is (f_max + f_min)/(2 f_min) = 4.5."""
    spec = CONFIGS / "all-driving.toml"
    sweep = afmcalc("overload", spec, "--sweep", "zC=0.5:6:441", "--json").json["result"]["sweep"][0]
    best = int(np.argmin(sweep["accuracy_factor_actual"]))
    assert sweep["parameter"] == "zC"
    assert sweep["values"][best] == pytest.approx(1.25, abs=1e-9)
    assert sweep["accuracy_factor_actual"][best] == pytest.approx(4.5)


def test_p11_published_exceeds_expected_from_one_over_zc():
    """zC = 5: T_ср > T_муф needs f > 1/(zC) = 0.2."""
    result, _ = overload(build(read_spec(CONFIGS / "all-driving.toml")))
    assert result.friction_interval == [0.1, pytest.approx(0.2)]
    assert factor(4, 0, 1.25, 0.2) == pytest.approx(1.0)
    assert factor(4, 0, 1.25, 0.21) > 1 > factor(4, 0, 1.25, 0.19)


def test_m14_p21_fig_4():
    """A = 1.225, 1.000, 0.419 for z_1 = 1, 2, 3 with (z − z_1)C = 1.6, 1.25, 1/2.4; T_ср(f_max)/T_н by P21."""
    reduced = {1: 1.6, 2: 1.25, 3: 1 / 2.4}
    found = {z1: factor(4, z1, value / (4 - z1), 0.8) for z1, value in reduced.items()}
    assert [found[z1] for z1 in (1, 2, 3)] == pytest.approx([1.225, 1.0, 0.419], abs=5e-4)


@given(direct_specs(("differentiated", "all-driving")), st.floats(1, 3), st.floats(0, 1))
def test_equilibrium_is_the_expected_torque_for_every_margin(spec, margin, share):
    """M12, M17: load until the pack slips, numerically: the release force follows the load."""
    clutch = build(make_spec({**resolved(spec), "adjustment": {"margin": margin}}))
    own = spec.friction.range
    f = own.min + share * (own.max - own.min)
    z, z1 = spec.friction_group.pairs, clutch.bypass_pairs
    nominal = clutch.torque(own.min) / margin

    def capacity(load: float) -> float:
        """What the pack can carry while it carries ``load``, shared z_1 : z_2."""
        released = load * (z - z1) / z * clutch.gain / clutch.mean_radius
        return z * f * clutch.mean_radius * (clutch.closing_force - released)

    # capacity falls linearly with load: bisect for load = capacity
    low, high = 0.0, z * f * clutch.mean_radius * clutch.closing_force
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if capacity(middle) > middle else (low, middle)
    assert low == pytest.approx(clutch.torque(f), rel=1e-9)
    result, _ = overload(clutch)
    for at in ("min", "mean", "max"):
        assert getattr(result.actuation_torque_equilibrium, at) == pytest.approx(
            clutch.torque(getattr(own, at)), rel=1e-9
        )
        assert getattr(result.potential_torque, at) == pytest.approx(
            z * getattr(own, at) * clutch.mean_radius
            * (clutch.closing_force - nominal * (z - z1) / z * clutch.gain / clutch.mean_radius),
            rel=1e-9,
        )  # fmt: skip
        published = getattr(result.expected_torque, at) * getattr(result.actuation_factor, at)
        assert getattr(result.actuation_torque_published, at) == pytest.approx(published, rel=1e-9, abs=1e-9)


@given(direct_specs(("differentiated", "all-driving")), st.floats(1, 3))
def test_17_is_where_published_is_below_expected(spec, margin):
    clutch = build(make_spec({**resolved(spec), "adjustment": {"margin": margin}}))
    own = spec.friction.range
    assume(clutch.gain > 1e-3)
    assume(own.max > own.min * 1.01)
    result, _ = overload(clutch)
    f = np.linspace(own.min, own.max, 401)
    below = factor(spec.friction_group.pairs, clutch.bypass_pairs, clutch.gain, f, own.min, margin) < 1 - 1e-9
    low, high = result.friction_interval or (np.inf, -np.inf)
    inside = (f > low) & (f < high)
    edge = np.isclose(f, low, rtol=1e-3) | np.isclose(f, high, rtol=1e-3)
    assert not np.any((below != inside) & ~edge)


@given(st.floats(0, 10), st.floats(1, 3), st.floats(0.05, 0.5))
def test_d_is_a_perfect_square_and_the_two_roots_are_those_of_17(reduced, margin, low):
    u = reduced * low
    assert law.discriminant(margin, u) >= 0
    assume(reduced > 1e-2)
    ends = law.interval_low(low, margin, u), law.interval_high(reduced)
    for end in ends:
        assert law.actuation_factor(reduced * end, u, end, low, margin) == pytest.approx(1, rel=1e-9)


def test_m15_difference_of_22_and_8():
    z, z1, force, radius, f, low, gain, margin = 8, 3, 2000.0, 0.1, 0.5, 0.1, 0.4, 1.25
    potentials = [law.potential_torque(z, force, radius, f, margin, (z - bypass) * gain * low) for bypass in (0, z1)]
    assert law.potential_torque_gain_of_differentiated(z, z1, force, radius, f, low, gain, margin) == pytest.approx(
        potentials[1] - potentials[0]
    )


def test_variants_s22_does_not_treat_are_refused(afmcalc):
    for name in ("conventional", "unlike-materials", "indirect"):
        run = afmcalc("overload", CONFIGS / f"{name}.toml")
        assert run.code == 2
        assert "S22 treats" in run.err


def test_the_table_says_which_torque_to_trust(afmcalc):
    out = afmcalc("overload").out
    assert "trust the equilibrium torque" in out
    assert "M12" in out


def test_sweep_of_z1(afmcalc):
    sweep = afmcalc("overload", "--sweep", "z1", "--json").json["result"]["sweep"][0]
    assert sweep["values"] == [1, 2, 3, 4, 5, 6, 7]
    for z1, found in zip(sweep["values"], sweep["actuation_factor"], strict=True):
        assert found == pytest.approx(factor(8, z1, 0.5, 0.8))


def test_mean_friction_setting_says_what_the_margin_means(afmcalc):
    run = afmcalc("overload", "--set", "adjustment.method=mean-friction", "--json")
    assert "margin-role" in [finding["code"] for finding in run.json["findings"]]


def test_accuracy_of_the_all_driving_clutch():
    """K_т = f_max(1 + zCf_min)/(f_min(1 + zCf_max)) at zC = 5, f 0.1…0.8: 8·1.5/5 = 2.4."""
    clutch = build(read_spec(CONFIGS / "all-driving.toml"))
    assert clutch.accuracy_factor == pytest.approx(2.4, rel=1e-12)
    assert clutch.reduced_gain == pytest.approx(5.0)
    assert clutch.gain_limit == pytest.approx(1.25)
    assert clutch.findings() == []


def test_base_clutch_with_all_pairs_controlled():
    """P7's base value: z 8, C 1, f 0.1…0.8 gives 1.946."""
    assert accuracy_factor(0, 8, 1.0, 0.1, 0.1, 0.8, 0.8) == pytest.approx(1.946, abs=5e-4)


def test_the_best_reduced_gain_says_by_which_torque(afmcalc):
    """At equilibrium K_т falls with the gain for ever: (zC)_opt is by the published T_ср alone."""
    (row,) = [line for line in afmcalc("overload").out.splitlines() if line.startswith("(zC)_opt")]
    assert "by the published T_ср, 1/f_max; T_eq has no optimum" in row
    gains = (0.5, 1.25, 2.5)
    factors = [
        afmcalc("overload", CONFIGS / "all-driving.toml", "--set", f"C={gain}", "--json").json["result"]
        for gain in gains
    ]
    equilibrium = [each["accuracy_factor_equilibrium"] for each in factors]
    assert equilibrium == sorted(equilibrium, reverse=True)


def test_potential_torque_above_that_of_the_all_driving_clutch(afmcalc):
    """(22) less (8) as printed, z 8, z_1 1, C 0.5, β_н 1.25, F_п R = 200 N·m, f_min 0.1."""

    def potential(f, controlled):
        u = controlled * 0.5 * 0.1
        return 8 * 200 * f * (1.25 + 0.25 * u) / (1.25 * (1 + u))

    gain = afmcalc("overload", "--json").json["result"]["potential_torque_gain"]
    wanted = {end: potential(f, 7) - potential(f, 8) for end, f in (("min", 0.1), ("mean", 0.3), ("max", 0.8))}
    assert gain == pytest.approx(wanted)
    assert afmcalc("overload", "example:all-driving", "--json").json["result"]["potential_torque_gain"] is None
