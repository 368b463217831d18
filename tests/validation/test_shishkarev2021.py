"""Шишкарев 2021 (S21): indirect regulation, P5–P8, the synthesis formulas."""

import math

import numpy as np
import pytest
from conftest import S21
from hypothesis import given
from hypothesis import strategies as st

from afmcalc.analysis.synthesize import synthesize
from afmcalc.engines import build
from afmcalc.equations import synthesis
from afmcalc.spec import read_spec


def accuracy(**changes):
    overrides = [f"{key}={value}" for key, value in changes.items()]
    return build(read_spec(S21, overrides)).accuracy_factor


def test_p5_doubling_the_closing_stiffness():
    assert accuracy(C=1) / accuracy(C=1, c1=40e3) == pytest.approx(1.088, abs=5e-4)
    assert accuracy(C=4) / accuracy(C=4, c1=40e3) == pytest.approx(1.052, abs=5e-4)


def test_p6_doubling_the_gain():
    assert accuracy(C=1) / accuracy(C=2) == pytest.approx(1.790, abs=5e-4)
    assert accuracy(C=2) / accuracy(C=4) == pytest.approx(1.381, abs=5e-4)


def test_p7_the_base_clutch_is_more_accurate():
    assert accuracy(C=1) == pytest.approx(3.586, abs=5e-4)
    assert accuracy(C=1, **{"adjustment.method": "mean-friction"}) == pytest.approx(3.265, abs=5e-4)


def test_p8_ball_and_travel_over_the_gain():
    """x_max grows throughout; r_ш rises just above the threshold, then falls."""
    radii, travels = [], []
    for gain in np.linspace(0.62, 4, 40):
        result, _ = synthesize(build(read_spec(S21, [f"C={float(gain)!r}"])))
        radii.append(result.ball_radius)
        travels.append(result.travel_max)
    assert np.all(np.diff(travels) > 0)
    peak = int(np.argmax(radii))
    assert 0 < peak < 10
    assert np.all(np.diff(radii[peak:]) < 0)


@given(st.floats(0.05, 1.4), st.floats(0, 0.2), st.floats(0, 0.01), st.floats(0, 0.01))
def test_20_equals_22(angle, travel, gap, clearance):
    sine, cosine = math.sin(angle), math.cos(angle)
    radius = synthesis.ball_radius(travel, gap, clearance, sine)
    assert synthesis.pocket_depth(radius, sine, gap) == pytest.approx(
        synthesis.pocket_depth_from_travel(radius, sine, cosine, travel, clearance), rel=1e-9, abs=1e-12
    )
    assert synthesis.edge_clearance(radius, travel, gap, sine) == pytest.approx(clearance, abs=1e-12)
