"""The sampler against exact quantiles, error propagation and analytic Sobol indices."""

import math

import numpy as np
import pytest
from conftest import CONFIGS
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from strategies import direct_specs, indirect_specs

from afmcalc.analysis.tolerance.model import Model, inputs_of
from afmcalc.analysis.tolerance.statistics import CENTRAL
from afmcalc.analysis.tolerance.study import Plan, sobol_indices, study, tolerance
from afmcalc.engines import build
from afmcalc.spec import make_spec, read_spec, resolved

FRICTIONS = {
    "triangular": {}, "uniform": {}, "normal": {"spread": "10 %"}, "lognormal": {"spread": "30 %"},
}  # fmt: skip
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


@settings(max_examples=4)
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
