"""Шишкарев 2022 (S22): accuracy of the all-driving clutch."""

import pytest
from conftest import CONFIGS

import afmcalc


def test_accuracy_of_the_all_driving_clutch():
    """K_т = f_max(1 + zCf_min)/(f_min(1 + zCf_max)) at zC = 5, f 0.1…0.8: 8·1.5/5 = 2.4."""
    clutch = afmcalc.load(CONFIGS / "all-driving.toml")
    assert clutch.accuracy_factor == pytest.approx(2.4, rel=1e-12)
    assert clutch.reduced_gain == pytest.approx(5.0)
    assert clutch.gain_limit == pytest.approx(1.25)
    assert clutch.findings() == []


def test_base_clutch_with_all_pairs_controlled():
    """P7's base value: z 8, C 1, f 0.1…0.8 gives 1.946."""
    from afmcalc.equations.accuracy import accuracy_factor

    assert accuracy_factor(0, 8, 1.0, 0.1, 0.1, 0.8, 0.8) == pytest.approx(1.946, abs=5e-4)
