"""Фокин, Гавриленко, Шишкарев 2011 (F11): the law, its slopes, fig. 2 (P13)."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from afmcalc.equations import accuracy, direct

RATIO = st.floats(0.2, 3.0)
FIGURE_2 = [(0.1, 0.6), (0.14, 0.7), (0.16, 0.7), (0.16, 0.8)]


@given(st.integers(1, 5), st.integers(1, 20), st.floats(0, 5), RATIO, RATIO, st.floats(0.05, 0.3), st.floats(0.3, 1.0))
def test_17_is_14_in_ratios(z1, z2, c, n, p, low, high):
    direct_form = accuracy.accuracy_factor(z1, z2, c, low, p * low, high, n * high)
    assert accuracy.accuracy_factor_by_ratios(z1, z2, c, n, p, low, high) == pytest.approx(direct_form, rel=1e-12)
    torques = [direct.torque(1.0, 1.0, z1, z2, c, f, r * f) for f, r in ((low, p), (high, n))]
    assert direct_form == pytest.approx(torques[1] / torques[0], rel=1e-12)


@given(st.integers(1, 5), st.integers(1, 20), st.floats(0, 5), RATIO, RATIO, st.floats(0.05, 0.3), st.floats(0.3, 1.0))
def test_18_and_22_are_the_slopes(z1, z2, c, n, p, low, high):
    """M2 and M3: the mended factors; the printed ones fail this for every z_1 but 1."""
    step = 1e-6

    def factor(n, p):
        return accuracy.accuracy_factor_by_ratios(z1, z2, c, n, p, low, high)

    scale = factor(n, p)
    in_n = (factor(n + step, p) - factor(n - step, p)) / (2 * step)
    in_p = (factor(n, p + step) - factor(n, p - step)) / (2 * step)
    assert accuracy.slope_in_ratio_max(z1, z2, c, n, p, low, high) == pytest.approx(
        in_n, abs=1e-7 * scale / step * 1e-2
    )
    assert accuracy.slope_in_ratio_min(z1, z2, c, n, p, low, high) == pytest.approx(
        in_p, abs=1e-7 * scale / step * 1e-2
    )


@pytest.mark.parametrize("p", [0.8, 1.0, 1.2])
def test_figure_2_curves_1_to_3_rise_and_4_is_level(p):
    """P13, with z_1 = 1 (M4): C = 1.25 is below, below, below and at 1/(z_1 f_1max)."""
    n = np.linspace(0.5, 1.5, 101)
    curves = [accuracy.accuracy_factor_by_ratios(1, 6, 1.25, n, p, low, high) for low, high in FIGURE_2]
    for rising in curves[:3]:
        assert np.all(np.diff(rising) > 0)
    assert np.ptp(curves[3]) < 1e-12
    with_two = [accuracy.accuracy_factor_by_ratios(2, 5, 1.25, n, p, low, high) for low, high in FIGURE_2]
    assert all(np.all(np.diff(curve) < 0) for curve in with_two)


def test_figure_2_lines_5_to_7():
    """P14: one material, C 1.25; F11 counts only the driven pairs in z = 6 ("z относится к ведомым парам")."""
    lines = [accuracy.accuracy_factor(1, 6, 1.25, low, low, high, high) for low, high in FIGURE_2[:3]]
    assert lines == pytest.approx([1.909, 1.640, 1.540], abs=5e-4)


def test_gain_limit_after_20():
    assert direct.gain_limit_differentiated(1, 0.8) == pytest.approx(1.25)
