"""The front against brute force."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from afmcalc.analysis.design.search import _culled, front, ranks


def brute(points):
    """Indices by definition: nothing is at least as small everywhere and smaller somewhere, nor the same and earlier."""
    kept = []
    for i, a in enumerate(points):
        beaten = any(
            all(x <= y for x, y in zip(b, a, strict=True)) and (tuple(b) != tuple(a) or j < i)
            for j, b in enumerate(points)
            if j != i
        )
        if not beaten:
            kept.append(i)
    return kept


@given(st.integers(1, 5), st.integers(0, 40), st.integers(1, 8), st.integers(0, 10_000))
def test_against_brute_force(objectives, size, levels, seed):
    points = np.random.default_rng(seed).integers(1, levels + 1, (size, objectives)).astype(float)
    assert front(points).tolist() == brute(points.tolist())


@given(st.integers(1, 4), st.integers(1, 60), st.integers(0, 10_000))
def test_distinct_values_and_rounding(objectives, size, seed):
    """A unit in the last place decides nothing: the front keeps its objective vectors."""
    generator = np.random.default_rng(seed)
    points = generator.integers(1, 6, (size, objectives)) * 0.1
    noisy = points * (1 + generator.integers(-2, 3, points.shape) * 2.0**-52)
    assert {tuple(row) for row in points[front(noisy)]} == {tuple(row) for row in points[front(points)]}
    distinct = generator.random((size, objectives))
    assert front(distinct).tolist() == brute(distinct.tolist())


@given(st.integers(2, 5), st.integers(1, 60), st.integers(0, 10_000))
def test_many_levels_take_the_other_way_to_the_same_front(objectives, size, seed):
    points = np.random.default_rng(seed).integers(1, 5, (size, objectives)).astype(float)
    ranked = np.stack([ranks(column) for column in points.T], axis=1)
    assert _culled(ranked).tolist() == front(points).tolist()


def test_many_levels():
    points = np.random.default_rng(1).random((500, 3))
    assert front(points).tolist() == brute(points.tolist())


def test_nothing():
    assert front(np.empty((0, 3))).size == 0
