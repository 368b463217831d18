"""The sample's statistics: quantiles of any width with honest errors, histogram, Gauss nodes."""

import math
from statistics import NormalDist

import numpy as np
import pytest
from conftest import CONFIGS, several
from hypothesis import example, given
from hypothesis import strategies as st

from afmcalc.analysis.tolerance.model import Input, inputs_of
from afmcalc.analysis.tolerance.service import gauss
from afmcalc.analysis.tolerance.statistics import (
    BINS,
    Grid,
    Ranked,
    Tally,
    histogram,
    merged,
    needed,
    ranked,
    ranked_values,
)
from afmcalc.analysis.tolerance.study import Plan, study
from afmcalc.engines import build
from afmcalc.spec import make_spec, read_spec, resolved

PROBABILITIES = [0.001, 0.005, 0.05, 0.5, 0.95, 0.995, 0.999]
SCORES = [NormalDist().inv_cdf(p) for p in PROBABILITIES]


def tally_of(values, pilot=5000, parts=1):
    grid = Grid.of(values[:pilot])
    tallies = [Tally(grid, float(np.median(values[:pilot]))) for _ in range(parts)]
    for tally, part in zip(tallies, np.array_split(values, parts), strict=True):
        tally.add(part)
    return merged(tallies)


WIDTHS = [1, 5, 20, 50, 100, 150, 200, 300, 600, 1000]


@pytest.mark.every(3)
@pytest.mark.parametrize("method", ["monte-carlo", "quasi-monte-carlo"])
@pytest.mark.parametrize("percent", WIDTHS)
def test_quantiles_of_a_lognormal_torque_of_any_width(percent, method):
    """T = z R f F: lognormal as its force, quantiles in closed form; within 3 stated errors, nothing negative."""
    base = read_spec(CONFIGS / "conventional.toml")
    fields = {"closing_spring.force": {"distribution": "lognormal", "spread": f"{percent} %"}}
    block = {"fields": fields, "method": method, "samples": 200_000, "sobol_base": 64, "quantiles": PROBABILITIES}
    clutch = build(make_spec({**resolved(base), "tolerance": block}))
    found = study(clutch)
    torque = float(clutch.torque(base.friction.range.mean))
    variance = math.log1p((percent / 100) ** 2)
    for row, score in zip(found.result.quantiles, SCORES, strict=True):
        expected = torque * math.exp(score * math.sqrt(variance) - variance / 2)
        assert abs(row.torque - expected) < 3 * row.standard_error, row.probability
        assert 0 < row.standard_error < 0.2 * row.torque
    assert found.result.probability_below_machine >= 0
    assert min(found.histogram.edges) > 0


@given(st.integers(0, 1000), st.sampled_from(["normal", "exponential", "standard_cauchy", "lognormal"]),
       st.floats(1e-6, 1e6))  # fmt: skip
@example(0, "zeros", 1.0)
def test_streaming_quantiles_against_sorting(seed, kind, scale):
    """Heavy tails, zeros and negative numbers too: what has no bin is kept."""
    draws = np.zeros(3000) if kind == "zeros" else getattr(np.random.default_rng(seed), kind)(size=3000)
    values = scale * draws
    whole = ranked(tally_of(values, 100, parts=2))
    ordered = np.sort(values)
    for p in (0.01, 0.3, 0.5, 0.9, 0.999):
        rank, found = int(p * values.size), whole.quantile(p)
        width = whole.ulps * np.spacing(abs(found))
        # between neighbours in rank, give or take a bin
        assert ordered[max(rank - 2, 0)] - width <= found <= ordered[min(rank + 2, values.size - 1)] + width


@given(st.floats(1e-300, 1e300), st.floats(1, 1e9))
def test_bins_hold_what_they_number(low, ratio):
    """Each value lies between the edges of its bin, and the bins are as fine as their number allows."""
    values = np.geomspace(low, min(low * ratio, 1e307), 500)
    grid = Grid.of(values)
    index = grid.bins_of(values)
    assert index.max() < BINS
    edges = grid.edges
    place = index.astype(int)
    assert np.all((edges[place] <= values) & (values < edges[place + 1]))
    assert grid.shift == 0 or place[-1] - place[0] >= BINS // 8


@pytest.mark.every(4)
@pytest.mark.parametrize("samples", [4000, 1000, 2000, 16_000])
def test_error_bars_cover_what_they_say(samples):
    """Of many samples, 95 of 100 intervals q ± 1.96 s hold the true quantile, however few the samples."""
    runs = several(600, 1500)
    rng = np.random.Generator(np.random.SFC64(7))
    probabilities = [p for p in PROBABILITIES if needed(p) <= samples]
    truth = {p: math.exp(0.3 * NormalDist().inv_cdf(p)) for p in probabilities}
    held = dict.fromkeys(probabilities, 0)
    for _ in range(runs):
        whole = ranked(tally_of(rng.lognormal(0, 0.3, samples), samples))
        for p in probabilities:
            found = whole.estimate(p)
            held[p] += abs(found.value - truth[p]) <= 1.96 * found.standard_error
    assert 0.005 in held
    error = math.sqrt(0.95 * 0.05 / runs)
    for p, count in held.items():
        assert 0.94 - 3 * error <= count / runs <= 0.97 + 3 * error, (p, count / runs)


def test_too_few_samples_for_an_error_are_said(afmcalc):
    fields = 'tolerance={samples=1000, sobol_base=64, quantiles=[%s], fields={"closing_spring.force"={distribution="normal", spread="5 %%"}}}'
    for quantile, told in (("0.005", False), ("0.001", True)):
        run = afmcalc("tolerance", CONFIGS / "default.toml", "--set", fields % quantile, "--json").json
        assert ("few-samples" in [each["code"] for each in run["findings"]]) is told
    assert needed(0.001) == needed(0.999) == 3838  # 1.96² · 999
    assert ranked_values(np.arange(10.0)).estimate(0.5).value == 4.5


def test_the_resolution_is_part_of_the_error():
    """A sample of one value in one bin: known to the bin, not exactly."""
    coarse = Ranked(np.array([64.0, 128.0]), np.array([0.0, 1e9]), 10**9, 2.0**52)
    found = coarse.estimate(0.5)
    # the error of sampling is 64·√0.25/√n = 1e-3; that of a uniform number in the bin, of width 64, is 64/√12
    assert found.value == 96
    assert found.standard_error == pytest.approx(64 / math.sqrt(12), rel=1e-3)


@given(st.integers(1000, 10**7), st.booleans())
def test_sizes(samples, quasi):
    each = Plan(samples, 1, quasi).sizes
    assert sum(each) >= samples
    assert quasi or sum(each) == samples
    assert not quasi or all(size & (size - 1) == 0 for size in each)


def test_the_histogram_is_that_of_the_samples():
    rng = np.random.Generator(np.random.SFC64(1))
    values = rng.normal(100, 5, 50_000)
    whole = ranked(tally_of(values))
    found = histogram(whole.quantile, whole.below, whole.size)
    counted, _ = np.histogram(values, found.edges)
    # the ends of a bar lie within bins of up to some dozen samples
    assert np.array(found.probabilities) == pytest.approx(counted / values.size, abs=30 / values.size)
    assert np.sum(np.array(found.densities) * np.diff(found.edges)) == pytest.approx(sum(found.probabilities))


@pytest.mark.parametrize("kind", ["normal", "uniform", "triangular"])
@pytest.mark.parametrize("limits", [(-math.inf, math.inf), (0.7, 1.25)])
def test_gauss_nodes_are_exact_for_polynomials(kind, limits):
    """2n − 1 moments of the truncated distribution by n nodes, against its density integrated."""
    each = Input("x", "1", kind, 1.0, 0.3, (0.6, 1.6), limits)
    density = {
        "normal": lambda x: np.exp(-(((x - 1) / 0.3) ** 2) / 2),
        "uniform": lambda x: ((x >= 0.6) & (x <= 1.6)).astype(float),
        "triangular": lambda x: np.maximum(np.where(x < 1, (x - 0.6) / 0.4, (1.6 - x) / 0.6), 0),
    }[kind]
    ends = (-2.0, 1.0, 4.0) if kind == "normal" else (0.6, 1.0, 1.6)
    x, w = np.polynomial.legendre.leggauss(200)
    parts = [(max(a, limits[0]), min(b, limits[1])) for a, b in zip(ends, ends[1:], strict=False)]
    points = np.concatenate([a + (b - a) * (x + 1) / 2 for a, b in parts])
    shares = np.concatenate([(b - a) * w / 2 for a, b in parts]) * density(points)
    values, weights = gauss(each, 6)
    assert weights.sum() == pytest.approx(1, rel=1e-12)
    for power in range(12):
        expected = float((shares * (points - 1) ** power).sum() / shares.sum())
        assert float((weights * (values - 1) ** power).sum()) == pytest.approx(expected, rel=1e-6, abs=1e-12)


def test_gauss_nodes_of_a_lognormal_are_those_of_its_logarithm():
    """E[x^k] = exp(k μ + k² σ²/2)."""
    (each,) = inputs_of(
        make_spec({**resolved(read_spec(CONFIGS / "conventional.toml")),
                   "tolerance": {"fields": {"friction": {"distribution": "lognormal", "spread": "30 %"}}}})
    )  # fmt: skip
    values, weights = gauss(each, 16)
    mu, sigma = each.scores
    for power in (1, 2, 6):
        expected = math.exp(power * mu + (power * sigma) ** 2 / 2)
        assert float((weights * values**power).sum()) == pytest.approx(expected, rel=1e-7)
    still = Input("x", "1", "normal", 2.0, 0.0, (2.0, 2.0), (-math.inf, math.inf))
    assert [part.tolist() for part in gauss(still, 8)] == [[2.0], [1.0]]


@pytest.mark.parametrize("method", ["monte-carlo", "quasi-monte-carlo"])
@pytest.mark.parametrize(("percent", "said"), [(5, False), (300, True)])
def test_errors_that_a_heavy_tail_makes_too_small_are_said_to_be(method, percent, said):
    """Two errors of σ cover it in 95 % of samples of a narrow lognormal, in 57 % at 300 %."""
    fields = {"closing_spring.force": {"distribution": "lognormal", "spread": f"{percent} %"}}
    base, flagged = read_spec(CONFIGS / "conventional.toml"), []
    for seed in range(6):
        block = {"fields": fields, "method": method, "samples": 50_000, "sobol_base": 1024, "seed": seed}
        found = study(build(make_spec({**resolved(base), "tolerance": block})))
        flagged.append("heavy-tails" in {each.code for each in found.findings})
    assert flagged == [said] * 6
