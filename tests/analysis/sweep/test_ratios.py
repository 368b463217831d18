"""Slopes of K_т in F11's ratios n and p of unlike materials, held against (17) written out here."""

import pytest

from afmcalc.analysis.accuracy import accuracy
from afmcalc.engines import build
from afmcalc.spec import read_spec
from afmcalc.spec.edit import respecified

UNLIKE = "example:unlike-materials"
F_1MIN, N, P, M = 0.1, 1.0, 1.2, 6.0
"""Of the example; z_1 1, z_2 6, C 1.25."""


def factor(n=N, p=P, m=M, z1=1, z2=6, gain=1.25):
    """F11 (17) as printed."""
    return m * (z1 + z2 * n) * (1 + z2 * gain * p * F_1MIN) / ((z1 + z2 * p) * (1 + z2 * gain * n * m * F_1MIN))


@pytest.fixture(scope="module")
def clutch():
    return build(read_spec(UNLIKE))


def test_slopes(clutch):
    """F11 (18), (22) as mended, at z_2 C f_1max = 4.5, and by differences of (17)."""
    result, _ = accuracy(clutch)
    assert result.slope_in_ratio_max == pytest.approx(6 * 6 * 1.9 * 0.25 / (8.2 * 5.5**2), rel=1e-12)
    assert result.slope_in_ratio_min == pytest.approx(6 * 6 * 7 * (0.125 - 1) / (8.2**2 * 5.5), rel=1e-12)
    step = 1e-6
    assert result.slope_in_ratio_max == pytest.approx((factor(n=1 + step) - factor(n=1 - step)) / (2 * step), rel=1e-6)
    assert result.slope_in_ratio_min == pytest.approx(
        (factor(p=1.2 + step) - factor(p=1.2 - step)) / (2 * step), rel=1e-6
    )


def test_no_slopes_where_the_largest_torque_is_not_at_the_largest_friction(clutch):
    """C 3, f_1 0.5…0.6, f_2 0.1…0.6: (14) gives 0.906, K_т is 1.104."""
    falling = {"control_unit.gain": 3.0, "friction.driving.min": 0.5, "friction.driven.min": 0.1}
    result, _ = accuracy(build(respecified(clutch.spec, falling)))
    assert result.accuracy_factor == pytest.approx(1.104, abs=5e-4)
    assert result.slope_in_ratio_max is None
    assert result.slope_in_ratio_min is None
