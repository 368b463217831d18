"""Distributions against their moments; the statistics of a sample: quantiles of any width with honest errors."""

import math
from statistics import NormalDist

import numpy as np
import pytest
from conftest import CONFIGS
from hypothesis import given
from hypothesis import strategies as st

from afmcalc.analysis.tolerance.model import inputs_of
from afmcalc.analysis.tolerance.statistics import Grid, Ranked, Tally, merged, needed, ranked, ranked_values
from afmcalc.analysis.tolerance.study import study
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


@pytest.mark.parametrize("method", ["monte-carlo", "quasi-monte-carlo"])
@pytest.mark.parametrize("percent", [1, 50, 300, 1000])
def test_quantiles_of_a_lognormal_torque_of_any_width(percent, method):
    """T = z R f F: lognormal as its force, quantiles in closed form; within 3 stated errors, nothing negative."""
    base = read_spec(CONFIGS / "conventional.toml")
    fields = {"closing_spring.force": {"distribution": "lognormal", "spread": f"{percent} %"}}
    block = {"fields": fields, "method": method, "samples": 50_000, "sobol_base": 64, "quantiles": PROBABILITIES}
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


def test_error_bars_cover_what_they_say():
    """Of many samples, 95 of 100 intervals q ± 1.96 s hold the true quantile, however few the samples."""
    runs, samples = 400, 1000
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
    assert all(0.94 - 3 * error <= count / runs <= 0.97 + 3 * error for count in held.values()), held


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


@pytest.mark.parametrize(("method", "percent", "said"), [("monte-carlo", 300, True), ("quasi-monte-carlo", 5, False)])
def test_errors_that_a_heavy_tail_makes_too_small_are_said_to_be(method, percent, said):
    """Two errors of σ cover it in 95 % of samples of a narrow lognormal, in 57 % at 300 %."""
    fields = {"closing_spring.force": {"distribution": "lognormal", "spread": f"{percent} %"}}
    base, flagged = read_spec(CONFIGS / "conventional.toml"), []
    for seed in range(3):
        block = {"fields": fields, "method": method, "samples": 50_000, "sobol_base": 1024, "seed": seed}
        found = study(build(make_spec({**resolved(base), "tolerance": block})))
        flagged.append("heavy-tails" in {each.code for each in found.findings})
    assert flagged == [said] * 3


BASE = {
    "variant": "all-driving",
    "friction": {"min": 0.1, "mean": 0.2, "max": 0.4},
    "friction_group": {"pairs": 4, "mean_radius": 0.1},
    "closing_spring": {"force": 1000},
    "control_unit": {"gain": 0.5},
}
KINDS = ["normal", "uniform", "triangular", "lognormal"]


def only(path="closing_spring.force", **given):
    return inputs_of(make_spec({**BASE, "tolerance": {"fields": {path: given}}}))[0]


@given(st.sampled_from(KINDS), st.floats(0.01, 2), st.floats(0.001, 0.999))
def test_quantiles_undo_the_distribution(kind, spread, p):
    bounded = kind in ("uniform", "triangular")  # refused where they leave what a force may be
    each = only(distribution=kind, spread=1000 * (min(spread, 1.0) if bounded else spread))
    (x,) = each.quantiles(np.array([p]))
    below, above = each.mass
    assert (each.cdf(float(x)) - below) / (above - below) == pytest.approx(p, abs=1e-9)
    assert x >= 0


@pytest.mark.parametrize(
    ("given", "mean", "sigma"),
    [
        ({"distribution": "normal", "spread": "3 %"}, 1000, 30),
        ({"distribution": "lognormal", "spread": 300}, 1000, 300),
        ({"distribution": "uniform", "spread": 120}, 1000, 120 / math.sqrt(3)),
        ({"distribution": "uniform", "min": 900, "max": 1300}, 1100, 400 / math.sqrt(12)),
        ({"distribution": "triangular", "spread": "0.12 kN"}, 1000, 120 / math.sqrt(6)),
        # peak 1000 in 900…1300: (a + b + c)/3 and (a² + b² + c² − ab − ac − bc)/18
        ({"distribution": "triangular", "min": 900, "max": 1300}, 3200 / 3, math.sqrt(130000 / 18)),
    ],
)
def test_textbook_moments(given, mean, sigma):
    values = only(**given).quantiles((np.arange(100_000) + 0.5) / 100_000)
    assert values.mean() == pytest.approx(mean, rel=1e-5)
    assert values.std() == pytest.approx(sigma, rel=2e-4)


def test_friction_takes_the_range_of_the_spec():
    each = only("friction", distribution="triangular")
    assert (each.ends, each.center) == ((0.1, 0.4), 0.2)
