"""Exact Pareto fronts with a relative tolerance: values nearer than it are the same value."""

from typing import Any

TOLERANCE = 1e-12
"""Rounding makes equal K_т differ by a few units in the last place; no two designs are that near by intent."""


def ranks(column: Any, tolerance: float = TOLERANCE) -> Any:
    """Rank of every value, equal for values that follow each other within the tolerance.

    On whole ranks dominance is exact and transitive, which it is not on numbers compared with a tolerance.
    """
    import numpy as np

    order = np.argsort(column, kind="stable")
    ordered = column[order]
    steps = np.diff(ordered) > tolerance * np.abs(ordered[1:])
    found = np.empty(column.size, np.int64)
    found[order] = np.concatenate([[0], np.cumsum(steps)])
    return found


def front(objectives: Any, tolerance: float = TOLERANCE) -> Any:
    """Indices of the nondominated rows, ascending; of rows that tie in every objective the first.

    Args:
        objectives: one row per candidate, one column per objective, all to be small.
        tolerance: relative distance within which values are the same.
    """
    import numpy as np

    if len(objectives) == 0:
        return np.empty(0, np.int64)
    ranked = np.stack([ranks(column, tolerance) for column in objectives.T], axis=1)
    # the two columns with most values are swept, the levels of the others gone through
    ranked = ranked[:, np.argsort(-ranked.max(axis=0), kind="stable")]
    if ranked.shape[1] == 1:
        return np.array([int(np.argmin(ranked[:, 0]))])
    levels, level = np.unique(ranked[:, 2:], axis=0, return_inverse=True)
    level = level.ravel()
    if len(levels) > 400:
        return _culled(ranked)
    kept = []
    for number, highest in enumerate(levels):
        own = np.flatnonzero(level == number)
        below = np.flatnonzero((levels <= highest).all(axis=1))
        others = np.flatnonzero(np.isin(level, below[below != number]))
        kept.append(_swept(ranked, own, others))
    return np.sort(np.concatenate(kept))


def _swept(ranked: Any, own: Any, others: Any) -> Any:
    """Rows of a level that no row of it or of a lower one dominates, by a sweep over the first column."""
    import numpy as np

    rows = np.concatenate([others, own])
    mine = np.concatenate([np.zeros(others.size, bool), np.ones(own.size, bool)])
    order = np.lexsort((rows, mine, ranked[rows, 1], ranked[rows, 0]))
    second = ranked[rows[order], 1]
    before = np.concatenate([[np.iinfo(np.int64).max], np.minimum.accumulate(second)[:-1]])
    return rows[order][(second < before) & mine[order]]


def _culled(ranked: Any) -> Any:
    """Rows that survive when each survivor in turn removes what it dominates or ties."""
    import numpy as np

    order = np.lexsort(ranked.T[::-1])
    left, kept = order, []
    while left.size:
        best = left[0]
        kept.append(best)
        left = left[(ranked[left] < ranked[best]).any(axis=1)]
    return np.sort(np.array(kept))
