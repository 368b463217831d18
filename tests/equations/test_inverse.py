"""Every inverse undoes its law exactly: rational numbers in, the very same rational numbers out."""

from fractions import Fraction

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from afmcalc.equations import accuracy, direct, indirect, synthesis

# plain arithmetic runs on fractions: an identity of rational functions that holds on a grid of them holds everywhere
RATIO = st.fractions(min_value=Fraction(1, 50), max_value=2, max_denominator=50)
POSITIVE = st.fractions(min_value=Fraction(1, 20), max_value=100, max_denominator=20)
PAIRS = st.integers(1, 30).map(Fraction)


@given(st.integers(0, 5).map(Fraction), PAIRS, RATIO, RATIO, RATIO, RATIO, RATIO)
def test_gain_for_accuracy_factor(z1, z2, gain, f1, f2, more1, more2):
    ends = f1, f2, f1 + more1, f2 + more2
    factor = accuracy.accuracy_factor(z1, z2, gain, *ends)
    ordinary = accuracy.accuracy_factor(z1, z2, Fraction(0), *ends)
    assume(factor * ends[3] != ordinary * f2)
    assert synthesis.gain_for_accuracy_factor(z1, z2, factor, *ends) == gain


@given(st.integers(0, 5).map(Fraction), PAIRS, RATIO, RATIO, RATIO, POSITIVE, POSITIVE)
def test_from_torque(z1, z2, gain, f1, f2, force, radius):
    torque = direct.torque(force, radius, z1, z2, gain, f1, f2)
    assert synthesis.gain_for_torque(torque, force, radius, z1, z2, f1, f2) == gain
    assert synthesis.mean_radius_for_torque(torque, force, z1, z2, gain, f1, f2) == radius
    assume(gain * torque != force * radius)
    assert synthesis.controlled_pairs_for_torque(torque, force, radius, z1, gain, f1, f2) == z2


@given(st.integers(0, 5).map(Fraction), PAIRS, RATIO, RATIO, RATIO)
def test_controlled_pairs_for_accuracy_factor(z1, z2, gain, low, more):
    factor = accuracy.accuracy_factor(z1, z2, gain, low, low, low + more, low + more)
    assert synthesis.controlled_pairs_for_accuracy_factor(gain, factor, low, low + more) == z2


@given(PAIRS, RATIO, RATIO, RATIO, RATIO, POSITIVE, POSITIVE)
def test_indirect(z, net, low, to_set, to_max, c1, c2):
    at_set, high = low + to_set, low + to_set + to_max
    factor = indirect.accuracy_factor(low, at_set, high, c1, c2, z, net)
    linear = synthesis.net_loop_gain_linear(low, at_set, high, c1, c2, factor)
    constant = synthesis.net_loop_gain_constant(low, high, c1, c2, factor)
    # the root is a float
    loop = synthesis.net_loop_gain_for_accuracy_factor(low, at_set, high, c1, factor, linear, constant)
    assert synthesis.net_gain_for_accuracy_factor(loop, z) == pytest.approx(float(net))
    assert synthesis.pairs_for_accuracy_factor_indirect(loop, net) == pytest.approx(float(z))
    assert synthesis.stiffness_ratio_for_accuracy_factor(low, at_set, high, z, net, factor) == c2 / c1


@given(PAIRS, RATIO, RATIO, RATIO, POSITIVE, POSITIVE)
def test_the_limit_of_the_indirect_clutch(z, low, to_set, to_max, c1, c2):
    """Above 1 for every gain, and as near as one likes for a large one, wherever it is set."""
    at_set, high = low + to_set, low + to_set + to_max
    errors = [indirect.accuracy_factor(low, at_set, high, c1, c2, z, Fraction(10) ** power) - 1 for power in (6, 9)]
    assert 0 < errors[1] < errors[0] / 500


def test_the_best_accuracy_at_a_limit_of_the_gain():
    """All-driving at zC = 5, f 0.1…0.8: 8·1.5/5 (S22's limit); base clutch at C = 1.25: (8·1 + 7)/8."""
    ends = 0.1, 0.1, 0.8, 0.8
    assert accuracy.accuracy_factor(0, 4, direct.gain_limit_all_driving(4), *ends) == pytest.approx(2.4)
    assert accuracy.accuracy_factor(1, 7, direct.gain_limit_differentiated(1, 0.8), *ends) == pytest.approx(1.875)
