"""The sampler against exact quantiles, error propagation, Sobol indices; against clutches built one by one."""

import copy
import math

import numpy as np
import pytest
from conftest import CONFIGS
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.special import ndtr
from strategies import direct_specs

import afmcalc as api
from afmcalc.analysis.tolerance.model import Model, inputs_of
from afmcalc.analysis.tolerance.statistics import CENTRAL
from afmcalc.analysis.tolerance.study import Plan, sobol_indices, study, tolerance
from afmcalc.engines import build
from afmcalc.errors import CalculationError, SpecError
from afmcalc.spec import make_spec, read_spec, resolved
from afmcalc.spec.edit import put, value_at

FRICTIONS = {"triangular": {}, "uniform": {}, "normal": {"spread": "10 %"}, "lognormal": {"spread": "30 %"}}
METHODS = ["monte-carlo", "quasi-monte-carlo"]
SAMPLED = [
    ("default", "normal", METHODS[0]), ("indirect", "lognormal", METHODS[1]), ("conventional", "uniform", METHODS[0]),
    ("all-driving", "triangular", METHODS[1]),
]  # fmt: skip


def with_tolerance(spec, fields, **settings_):
    return make_spec({**resolved(spec), "tolerance": {"fields": fields, **settings_}})


def run(spec, **options):
    return tolerance(build(spec), **options)[0]


@pytest.mark.parametrize(("name", "distribution", "method"), SAMPLED)
def test_the_sampler_against_the_exact_answer(name, distribution, method):
    """Every figure and quantile within 4.5 of its stated errors, and the histogram on the exact one."""
    base = read_spec(CONFIGS / f"{name}.toml")
    limit = float(build(base).torque(base.friction.range.mean * 1.1))
    options = {"samples": 30_000, "seed": 3, "torque_limit": limit, "sobol_base": 64}
    fields = {"friction": {"distribution": distribution, **FRICTIONS[distribution]}}
    whole, part = (study(build(with_tolerance(base, fields, **options, **how))) for how in ({}, {"method": method}))
    exact, sampled = whole.result, part.result
    assert (exact.method, sampled.method) == ("exact", method)
    for field in ("mean", "standard_deviation", "accuracy_factor_robust", "probability_above_limit", "life_protected",
                  "life_unprotected", "probability_below_machine"):  # fmt: skip
        if (expected := getattr(exact, field)) is not None:
            error = getattr(sampled, field + "_standard_error")
            # the error itself is known to 13 % only, and quantiles lie on bins
            assert getattr(sampled, field) == pytest.approx(expected, abs=4.5 * error + 2e-4 * abs(expected)), field
    for row, expected_row in zip(sampled.quantiles, exact.quantiles, strict=True):
        slack = 4.5 * row.standard_error + 1e-3 * exact.standard_deviation
        assert row.torque == pytest.approx(expected_row.torque, abs=slack)
    # the sampled distribution function lies on the exact one, to the error of Kolmogorov's statistic
    assert sum(whole.histogram.probabilities) == pytest.approx(CENTRAL[1] - CENTRAL[0], abs=1e-9)
    cdf = CENTRAL[0] + np.concatenate([[0], np.cumsum(whole.histogram.probabilities)])
    edges = part.histogram.edges
    at_edges = np.interp(edges, whole.histogram.edges, cdf)
    own = at_edges[0] + np.concatenate([[0], np.cumsum(part.histogram.probabilities)])
    assert np.abs(own - at_edges).max() < 2.5 / 30_000**0.5 + 2e-3
    assert np.diff(edges) == pytest.approx(edges[1] - edges[0])


@pytest.mark.parametrize("quasi", [False, True])
def test_sobol_indices_of_a_product(quasi):
    """Without feedback and bypass T = F R z f: V_i = Π m²·v_i and the totals by Π(1 + v), v = (σ/m)²."""
    spec = read_spec(CONFIGS / "conventional.toml")
    shares = {"friction": 0.15, "closing_spring.force": 0.1, "friction_group.mean_radius": 0.05}
    fields = {path: {"distribution": "lognormal", "spread": f"{100 * s} %"} for path, s in shares.items()}
    given_ = with_tolerance(spec, fields)
    indices = sobol_indices(Model(given_, inputs_of(given_)), Plan(1 << 15, 2, quasi))
    whole = math.prod(1 + s**2 for s in shares.values()) - 1
    for index, share in zip(indices, shares.values(), strict=True):
        others = math.prod(1 + s**2 for s in shares.values() if s != share)
        assert index.first_order == pytest.approx(share**2 / whole, abs=5 * index.first_order_standard_error + 1e-4)
        assert index.total == pytest.approx(share**2 * others / whole, abs=5 * index.total_standard_error + 1e-4)
        assert index.first_order_standard_error < 0.02
    assert sum(index.first_order for index in indices) == pytest.approx(1, abs=0.05)


@settings(max_examples=2)
@given(direct_specs(("differentiated", "unlike", "all-driving")), st.sampled_from(METHODS))
def test_small_tolerances_propagate_linearly(spec, method):
    """σ_T² = Σ (∂T/∂p σ_p)², by central differences of the law."""
    assume(spec.control_unit.gain >= 0.05)
    friction = ["friction.driving", "friction.driven"] if spec.friction.unlike else ["friction"]
    share, paths = 1e-3, [*friction, "closing_spring.force", "friction_group.mean_radius", "control_unit.gain"]
    fields = {path: {"distribution": "normal", "spread": f"{100 * share} %"} for path in paths}
    own = with_tolerance(spec, fields, method=method, samples=40_000, sobol_base=64)
    result, model = run(own), Model(own, inputs_of(own))
    centers = [each.center for each in model.inputs]
    variance = 0.0
    for k, center in enumerate(centers):
        ends = [model.torque([*centers[:k], center * (1 + sign * share), *centers[k + 1 :]]) for sign in (1, -1)]
        variance += ((ends[0] - ends[1]) / 2) ** 2
    slack = 5 * result.standard_deviation_standard_error + 0.01 * math.sqrt(variance)
    assert result.standard_deviation == pytest.approx(math.sqrt(variance), abs=slack)
    assert result.mean == pytest.approx(model.torque(centers), rel=1e-4)


def test_same_seed_same_digits_for_any_threads():
    spec = read_spec(CONFIGS / "tolerance.toml", ["tolerance.samples=20_000", "tolerance.sobol_base=1024"])
    first, again = (study(build(spec), threads=number) for number in (1, 3))
    assert (first.result, first.histogram) == (again.result, again.histogram)
    other = spec.model_copy(update={"tolerance": spec.tolerance.model_copy(update={"seed": 2})})
    assert run(other).mean != first.result.mean


@pytest.mark.slow
def test_standard_errors_are_those_of_repeated_runs():
    spec = read_spec(CONFIGS / "tolerance.toml", ["tolerance.samples=5_000", "tolerance.sobol_base=64"])
    seeds = [spec.model_copy(update={"tolerance": spec.tolerance.model_copy(update={"seed": n})}) for n in range(12)]
    repeated = [run(each) for each in seeds]
    for field in ("mean", "standard_deviation", "accuracy_factor_robust", "probability_above_limit", "life_protected"):
        seen = np.std([getattr(each, field) for each in repeated], ddof=1)
        said = np.mean([getattr(each, field + "_standard_error") for each in repeated])
        assert 0.5 < said / seen < 2, field


@pytest.mark.parametrize(("correlation", "method"), [(-0.6, METHODS[0]), (1.0, METHODS[1])])
def test_correlation_of_the_two_frictions(correlation, method):
    """σ_T² = a² + b² + 2ρab for small spreads of f_1 and f_2; at ρ = 1 the exact answer too."""
    base = read_spec(CONFIGS / "unlike-materials.toml")
    fields = {f"friction.{g}": {"distribution": "normal", "spread": "1 %"} for g in ("driving", "driven")}
    options = {"samples": 20_000, "sobol_base": 64, "friction_correlation": correlation}
    result = run(with_tolerance(base, fields, method=method, **options))
    f1, f2 = (r.mean for r in base.friction.groups)
    clutch = build(base)
    a = (clutch.torque(f1 * 1.01, f2) - clutch.torque(f1 * 0.99, f2)) / 2
    b = (clutch.torque(f1, f2 * 1.01) - clutch.torque(f1, f2 * 0.99)) / 2
    expected = math.sqrt(a**2 + b**2 + 2 * correlation * a * b)
    slack = 5 * result.standard_deviation_standard_error + 2e-3 * expected
    assert result.standard_deviation == pytest.approx(expected, abs=slack)
    assert (run(with_tolerance(base, fields, **options)).method == "exact") == (correlation == 1)


S21 = {
    "variant": "indirect", "friction": {"min": 0.1, "mean": 0.3, "max": 0.8}, "friction_group": {"pairs": 8, "mean_radius": 0.1},
    "closing_spring": {"force": 2000, "stiffness": 20e3}, "control_spring": {"stiffness": 10e3},
    "control_unit": {"gain": 1.0, "hub_diameter": 0.05, "key_friction": 0.15},
}  # fmt: skip
"""S21 fig. 2 with a closing spring of 2 kN, the clutch of tests/data/s21-fig2.toml."""
FATIGUE = {"endurance_limit": 400e6, "polar_section_modulus": 15e-6, "exponent": 6, "base_cycles": 1e7}


def scattering(base, fields, **options):
    return make_spec({**copy.deepcopy(base), "tolerance": {"fields": fields, "sobol_base": 64, **options}})


CASES = {
    "indirect": (
        S21,
        {"control_unit.gain": ("normal", 0.05), "control_unit.key_friction": ("uniform", 0.05),
         "closing_spring.force": ("normal", 100.0), "closing_spring.stiffness": ("normal", 1e3),
         "friction_group.mean_radius": ("uniform", 1e-3), "friction": ("uniform", 0.25)},
    ),
    "indirect, set by its torque": (
        {**S21, "closing_spring": {"stiffness": 20e3}, "adjustment": {"nominal_torque": 160, "method": "mean-friction"}},
        {"control_unit.gain": ("uniform", 0.1), "friction_group.mean_radius": ("normal", 1e-3), "friction": ("normal", 0.05)},
    ),
    "differentiated, set by its torque": (
        {"variant": "differentiated", "friction": {"min": 0.1, "mean": 0.3, "max": 0.8},
         "friction_group": {"pairs": 8, "inner_radius": 0.08, "outer_radius": 0.12},
         "control_unit": {"wall_angle": 0.25, "ball_circle_radius": 0.05}, "adjustment": {"nominal_torque": 120}},
        {"control_unit.wall_angle": ("normal", 0.02), "friction_group.outer_radius": ("uniform", 2e-3),
         "friction": ("uniform", 0.05)},
    ),
}  # fmt: skip


def single_torques(base, fields, setting, count, seed):
    """Slip torques of clutches built one by one, and how many of them are none."""
    rng, nominal = np.random.default_rng(seed), api.build(base)
    torques, failed = [], 0
    for _ in range(count):
        data, friction = copy.deepcopy(base), 0.3
        if setting == "as-made":
            put(data, "closing_spring.force", float(nominal["closing_force"]))
            data["adjustment"] = {**data.get("adjustment", {})}
            put(data, "adjustment.nominal_torque", None)
            if base["variant"] == "indirect":
                put(data, "control_spring.force", float(nominal["control_force"]))
        for path, (kind, spread) in fields.items():
            drawn = rng.normal(0, spread) if kind == "normal" else rng.uniform(-spread, spread)
            if path == "friction":
                friction += drawn
            else:
                put(data, path, value_at(nominal.spec, path) + drawn)
        try:
            torques.append(float(api.build(data).torque(friction)))
        except SpecError:
            failed += 1
    return np.array(torques), failed


@pytest.mark.parametrize("name", CASES)
def test_against_single_clutches(name):
    (base, fields), count, setting = CASES[name], 500, "as-made" if name == "indirect" else "each-adjusted"
    torques, failed = single_torques(base, fields, setting, count, seed=11)
    given = {path: {"distribution": kind, "spread": spread} for path, (kind, spread) in fields.items()}
    found, _ = tolerance(build(scattering(base, given, samples=100_000, seed=5, setting=setting)))
    assert (found.probability_no_clutch or 0.0) == pytest.approx(failed / count, abs=4 / math.sqrt(count))
    deviation = torques.std(ddof=1)
    kurtosis = ((torques - torques.mean()) ** 4).mean() / deviation**4
    assert found.mean == pytest.approx(torques.mean(), abs=4.5 * deviation / math.sqrt(torques.size))
    slack = 4.5 * deviation * math.sqrt((kurtosis - 1) / 4 / torques.size)
    assert found.standard_deviation == pytest.approx(deviation, abs=slack)
    for row in found.quantiles[1:-1]:
        reach = 4.5 * math.sqrt(row.probability * (1 - row.probability) / torques.size)
        assert np.mean(torques < row.torque) == pytest.approx(row.probability, abs=reach)


@pytest.mark.parametrize(("method", "setting"), [("monte-carlo", "as-made"), ("quasi-monte-carlo", "each-adjusted")])
@pytest.mark.slow
def test_what_is_no_clutch_is_counted(method, setting):
    """C uniform on 0.45…1.55 against 2 R f_1/d = 0.6: P(κ ≤ 0) = 0.15/1.1, and torques as of C in 0.6…1.55."""
    options = {"samples": 8_000, "method": method, "setting": setting}
    whole = {"control_unit.gain": {"distribution": "uniform", "spread": 0.55}}
    some = {"control_unit.gain": {"distribution": "uniform", "min": 0.6, "max": 1.55}}
    base = S21 | ({"fatigue": FATIGUE} if setting == "as-made" else {})
    found, findings = tolerance(build(scattering(base, whole, **options)))
    error = found.probability_no_clutch_standard_error
    assert found.probability_no_clutch == pytest.approx(0.15 / 1.1, abs=4.5 * error)
    assert error < 6e-3
    assert [each.value for each in findings if each.code == "no-clutch"] == [found.probability_no_clutch]
    rest, _ = tolerance(build(scattering(base, some, **options)))
    assert found.samples == rest.samples
    for field in ("mean", "standard_deviation", *(["life_protected"] if setting == "as-made" else [])):
        slack = 4.5 * math.hypot(found.estimate(field).standard_error, rest.estimate(field).standard_error)
        assert getattr(found, field) == pytest.approx(getattr(rest, field), abs=slack), field


def test_no_clutch_at_all_is_an_error():
    fields = {"control_unit.gain": {"distribution": "uniform", "min": 0.1, "max": 0.5}}
    with pytest.raises(CalculationError, match="hardly a sample is a clutch"):
        tolerance(build(scattering(S21, fields, samples=1000)))


def test_lives_over_the_clutches_in_closed_form():
    """T ∝ F, so ln N is normal where F is lognormal; friction only adds a factor common to all."""
    base = {**resolved(read_spec(CONFIGS / "conventional.toml")), "fatigue": FATIGUE, "drive": {"dynamic_factor": 1.4}}
    share = 0.1
    fields = {"closing_spring.force": {"distribution": "lognormal", "spread": f"{100 * share} %"},
              "friction": {"distribution": "uniform", "min": 0.2, "max": 0.4}}  # fmt: skip
    found, _ = tolerance(build(scattering(base, fields, samples=200_000)))
    m, variance = 6, math.log1p(share**2)
    # mean of f^6 over 0.2…0.4 against the torque at f = 1
    mean_power = (0.4**7 - 0.2**7) / (7 * 0.2)
    torque = float(build(make_spec(base)).torque(1.0)) * math.exp(-variance / 2)
    median = 1e7 * (400e6 * 15e-6 / torque) ** m / mean_power
    for row, score in zip(found.life_quantiles, (-2.3263478740408408, -1.2815515655446004, 0.0), strict=True):
        expected = median * math.exp(m * score * math.sqrt(variance))
        assert row.protected == pytest.approx(expected, abs=4 * row.protected_standard_error)
        assert row.protected_standard_error < 0.03 * expected
        assert row.protected / row.unprotected == pytest.approx(1.4**6, rel=1e-9)
    harmonic = median * math.exp(-(m**2) * variance / 2)
    assert found.life_protected == pytest.approx(harmonic, abs=4.5 * found.life_protected_standard_error)


def test_one_clutch_has_one_life():
    """Only friction scatters: every quantile is the life of the one clutch; correlated frictions too."""
    base = {**resolved(read_spec(CONFIGS / "unlike-materials.toml")), "fatigue": FATIGUE}
    base["control_unit"] = {"gain": 0.05}  # else the balls even out what friction does
    fields = {f"friction.{group}": {"distribution": "uniform", "spread": "20 %"} for group in ("driving", "driven")}
    for correlation in (1, 0.6):
        options = {"samples": 20_000, "friction_correlation": correlation}
        found, _ = tolerance(build(scattering(base, fields, **options)))
        lives = {row.protected for row in found.life_quantiles}
        assert max(lives) == pytest.approx(min(lives), rel=1e-9)
        assert found.life_protected == pytest.approx(max(lives), rel=1e-9)
        # the same by brute force over the two frictions' scores
        rng = np.random.default_rng(2)
        z = rng.standard_normal((2, 100_000))
        scores = z[0], correlation * z[0] + math.sqrt(1 - correlation**2) * z[1]
        clutch = build(make_spec(base))
        share = map(ndtr, scores)
        f = [r.mean * (0.8 + 0.4 * u) for r, u in zip(clutch.friction, share, strict=True)]
        damage = (clutch.torque(*f) / (400e6 * 15e-6)) ** 6 / 1e7
        error = damage.std() / math.sqrt(damage.size) / damage.mean()
        assert found.life_protected * damage.mean() == pytest.approx(1, abs=4.5 * error)
