"""Distributions of what scatters: against their own moments and quantiles."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from afmcalc.analysis.tolerance.model import inputs_of
from afmcalc.spec import make_spec

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
