"""The sampler against exact quantiles, error propagation and analytic Sobol indices; every error path."""

import math

import numpy as np
import pytest
from conftest import CONFIGS, S21, fewer, several
from hypothesis import given
from hypothesis import strategies as st
from strategies import direct_specs, indirect_specs

from afmcalc.analysis.tolerance.model import Model, inputs_of
from afmcalc.analysis.tolerance.statistics import CENTRAL
from afmcalc.analysis.tolerance.study import Plan, simulate, sobol_indices, study, tolerance
from afmcalc.engines import build
from afmcalc.spec import make_spec, read_spec, resolved

METHODS = ["monte-carlo", "quasi-monte-carlo"]


def with_tolerance(spec, fields, **settings_):
    return make_spec({**resolved(spec), "tolerance": {"fields": fields, **settings_}})


def run(spec, **options):
    return tolerance(build(spec), **options)[0]


FRICTIONS = [
    {"distribution": "triangular"},
    {"distribution": "uniform"},
    {"distribution": "normal", "spread": "10 %"},
    {"distribution": "lognormal", "spread": "30 %"},
]


SOURCES = [CONFIGS / f"{name}.toml" for name in ("default", "all-driving", "conventional", "indirect")] + [S21]


@pytest.mark.every(9)
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("friction", FRICTIONS, ids=lambda each: each["distribution"])
@pytest.mark.parametrize("source", SOURCES, ids=lambda each: each.stem)
def test_the_sampler_against_the_exact_answer(source, friction, method):
    base = read_spec(source)
    limit = float(build(base).torque(base.friction.range.mean * 1.1))
    settings_ = {"samples": 50_000, "seed": 3, "torque_limit": limit, "sobol_base": 64}
    exact = run(with_tolerance(base, {"friction": friction}, **settings_))
    sampled = run(with_tolerance(base, {"friction": friction}, method=method, **settings_))
    assert (exact.method, sampled.method) == ("exact", method)
    for field in (
        "mean", "standard_deviation", "accuracy_factor_robust", "probability_above_limit", "life_protected",
        "life_unprotected", "probability_below_machine",
    ):  # fmt: skip
        if (expected := getattr(exact, field)) is not None:
            error = getattr(sampled, field + "_standard_error")
            # 4.5 errors; the error itself is known to 13 % only, and quantiles lie on bins
            assert getattr(sampled, field) == pytest.approx(expected, abs=4.5 * error + 2e-4 * abs(expected)), field
    for row, expected_row in zip(sampled.quantiles, exact.quantiles, strict=True):
        slack = 4.5 * row.standard_error + 1e-3 * exact.standard_deviation
        assert row.torque == pytest.approx(expected_row.torque, abs=slack)


@given(
    st.one_of(direct_specs(("conventional", "differentiated", "all-driving")), indirect_specs()), st.floats(0.01, 0.99)
)
def test_quantiles_map_to_quantiles(spec, p):
    """T(f) is monotone, so P(T < T(q_f(p))) = p."""
    result = run(with_tolerance(spec, {"friction": {"distribution": "lognormal", "spread": "20 %"}}, quantiles=[p]))
    assert result.method == "exact"
    (each,) = inputs_of(with_tolerance(spec, {"friction": {"distribution": "lognormal", "spread": "20 %"}}))
    friction = float(each.quantiles(np.array([p]))[0])
    assert result.quantiles[0].torque == pytest.approx(build(spec).torque(friction), rel=1e-9)


@fewer(2)
@given(direct_specs(("differentiated", "unlike", "all-driving")), st.sampled_from(METHODS))
def test_small_tolerances_propagate_linearly(spec, method):
    """σ_T² = Σ (∂T/∂p σ_p)², by central differences of the law."""
    friction = ["friction.driving", "friction.driven"] if spec.friction.unlike else ["friction"]
    paths = [*friction, "closing_spring.force", "friction_group.mean_radius", "control_unit.gain"]
    if spec.control_unit.gain < 0.05:
        return
    share = 1e-3
    fields = {path: {"distribution": "normal", "spread": f"{100 * share} %"} for path in paths}
    given_ = with_tolerance(spec, fields, method=method, samples=40_000, sobol_base=64)
    result = run(given_)
    model = Model(given_, inputs_of(given_))
    centers = [each.center for each in model.inputs]
    variance, middle = 0.0, model.torque(centers)
    for k, center in enumerate(centers):
        ends = [model.torque([*centers[:k], center * (1 + sign * share), *centers[k + 1 :]]) for sign in (1, -1)]
        variance += ((ends[0] - ends[1]) / 2) ** 2
    slack = 5 * result.standard_deviation_standard_error + 0.01 * math.sqrt(variance)
    assert result.standard_deviation == pytest.approx(math.sqrt(variance), abs=slack)
    assert result.mean == pytest.approx(middle, rel=1e-4)


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


@pytest.mark.every(2)
@pytest.mark.parametrize("method", METHODS[::-1])
def test_same_seed_same_digits_for_any_threads(method):
    spec = read_spec(CONFIGS / "tolerance.toml", [f"tolerance.method={method}", "tolerance.samples=100_000",
                                                  "tolerance.sobol_base=4096"])  # fmt: skip
    first = run(spec, threads=1)
    assert run(spec, threads=2) == run(spec, threads=3) == first
    other = spec.model_copy(update={"tolerance": spec.tolerance.model_copy(update={"seed": 2})})
    assert run(other).mean != first.mean


def test_standard_errors_are_those_of_repeated_runs():
    runs, low, high = several((8, 0.4, 2.5), (20, 0.6, 1.7))
    spec = read_spec(CONFIGS / "tolerance.toml", ["tolerance.samples=5_000", "tolerance.sobol_base=64"])
    repeated = [
        run(spec.model_copy(update={"tolerance": spec.tolerance.model_copy(update={"seed": seed})}))
        for seed in range(runs)
    ]
    for field in ("mean", "standard_deviation", "accuracy_factor_robust", "probability_above_limit", "life_protected"):
        seen = np.std([getattr(each, field) for each in repeated], ddof=1)
        said = np.mean([getattr(each, field + "_standard_error") for each in repeated])
        assert low < said / seen < high, field


@pytest.mark.every(3)
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("correlation", [-0.6, 0.0, 0.5, 1.0])
def test_correlation_of_the_two_frictions(correlation, method):
    """σ_T² = a² + b² + 2ρab for small spreads of f_1 and f_2; at ρ = 1 the exact answer too."""
    base = read_spec(CONFIGS / "unlike-materials.toml")
    fields = {f"friction.{g}": {"distribution": "normal", "spread": "1 %"} for g in ("driving", "driven")}
    settings_ = {"samples": 20_000, "sobol_base": 64, "friction_correlation": correlation}
    spec = with_tolerance(base, fields, method=method, **settings_)
    result = run(spec)
    f1, f2 = (r.mean for r in spec.friction.groups)
    clutch = build(base)
    a = (clutch.torque(f1 * 1.01, f2) - clutch.torque(f1 * 0.99, f2)) / 2
    b = (clutch.torque(f1, f2 * 1.01) - clutch.torque(f1, f2 * 0.99)) / 2
    expected = math.sqrt(a**2 + b**2 + 2 * correlation * a * b)
    slack = 5 * result.standard_deviation_standard_error + 2e-3 * expected
    assert result.standard_deviation == pytest.approx(expected, abs=slack)
    assert len(result.sobol) == (1 if correlation else 2)
    exact = run(with_tolerance(base, fields, **settings_))
    assert (exact.method == "exact") == (correlation == 1)


def test_expected_life_by_miner():
    """With only the endurance limit scattering, E[1/N] ∝ E[τ_limb^−m]: lognormal moments in closed form."""
    base = read_spec()
    share, m = 0.08, base.fatigue.exponent
    fields = {"fatigue.endurance_limit": {"distribution": "lognormal", "spread": f"{100 * share} %"}}
    result = run(with_tolerance(base, fields, samples=400_000, sobol_base=64))
    torque = build(base).torque(base.friction.range.mean)
    still = base.fatigue.base_cycles * (base.fatigue.endurance_limit * base.fatigue.polar_section_modulus / torque) ** m
    variance = math.log1p(share**2)
    expected = still / math.exp(m * variance / 2 + m**2 * variance / 2)
    assert result.life_protected == pytest.approx(expected, abs=4.5 * result.life_protected_standard_error)
    ratio = result.life_protected / result.life_unprotected
    assert ratio == pytest.approx(base.drive.dynamic_factor**m, rel=1e-9)
    assert result.standard_deviation == pytest.approx(0, abs=1e-9 * result.mean)


def test_without_a_block(afmcalc):
    missing = afmcalc("tolerance", "example:default")
    assert missing.code == 2
    assert "tolerance: required by tolerance" in missing.err
    assert afmcalc("tolerance", CONFIGS / "tolerance.toml", "--threads", "1").code == 0


def test_the_block_survives_a_pipe(afmcalc):
    first = afmcalc("torque", CONFIGS / "tolerance.toml", "--json")
    small = ["--set", "tolerance.samples=5000", "--set", "tolerance.sobol_base=64", "--json"]
    assert (
        afmcalc("tolerance", "-", *small, stdin=first.out).out
        == afmcalc("tolerance", CONFIGS / "tolerance.toml", *small).out
    )
    findings = [
        finding["code"] for finding in afmcalc("tolerance", CONFIGS / "tolerance.toml", *small).json["findings"]
    ]
    assert "miner" in findings


def test_simulate_counts():
    spec = read_spec(CONFIGS / "tolerance.toml")
    tallies = simulate(Model(spec, inputs_of(spec)), Plan(5000, 1), 0.0, 1e9)
    assert sum(each.above for each in tallies) == sum(each.below for each in tallies) == 5000


@pytest.mark.every(5)
@pytest.mark.parametrize("samples", [1000, 30_000, 200_000])
@pytest.mark.parametrize("friction", FRICTIONS, ids=lambda each: each["distribution"])
def test_the_histogram_of_a_sample_against_the_exact_one(friction, samples):
    base = read_spec(CONFIGS / "default.toml")
    options = {"samples": samples, "sobol_base": 64}
    exact = study(build(with_tolerance(base, {"friction": friction}, **options))).histogram
    found = study(build(with_tolerance(base, {"friction": friction}, method="monte-carlo", **options))).histogram
    assert sum(exact.probabilities) == pytest.approx(CENTRAL[1] - CENTRAL[0], abs=1e-9)
    assert CENTRAL[1] - CENTRAL[0] - 0.01 <= sum(found.probabilities) <= 1
    assert np.diff(found.edges) == pytest.approx(found.edges[1] - found.edges[0])
    assert 5 <= len(found.probabilities) <= 60
    # the sampled distribution function lies on the exact one, to the error of Kolmogorov's statistic
    exact_cdf = CENTRAL[0] + np.concatenate([[0], np.cumsum(exact.probabilities)])
    start = np.interp(found.edges[0], exact.edges, exact_cdf)
    own = start + np.concatenate([[0], np.cumsum(found.probabilities)])
    assert np.abs(own - np.interp(found.edges, exact.edges, exact_cdf)).max() < 2.5 / samples**0.5 + 2e-3


def test_no_histogram_where_nothing_scatters():
    spec = with_tolerance(
        read_spec(CONFIGS / "default.toml"),
        {"closing_spring.force": {"distribution": "normal", "spread": 0}},
        samples=1000,
    )
    assert study(build(spec)).histogram.edges == []


def test_the_histogram_is_the_same_in_any_number_of_threads():
    clutch = build(read_spec(CONFIGS / "tolerance.toml", ["tolerance.samples=20000", "tolerance.sobol_base=64"]))
    assert study(clutch, threads=1).histogram == study(clutch, threads=5).histogram
