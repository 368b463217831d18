"""Exact Pareto fronts with a relative tolerance: values nearer than it are the same value."""

from typing import Any

TOLERANCE = 1e-12
"""Rounding makes equal K_т differ by a few units in the last place; no two designs are that near by intent."""

_LEVELS = 2000
"""Levels of the further objectives beyond which rows are compared with each other instead."""


def ranks(column: Any, tolerance: float = TOLERANCE) -> Any:
    """Rank of every value, equal for values that follow each other within the tolerance.

    On whole ranks dominance is exact and transitive, which it is not on numbers compared with a tolerance.
    """
    import numpy as np

    column = np.minimum(column, np.finfo(float).max)
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
    heights = ranked[:, 2:].max(axis=0) + 1
    if float(np.prod(heights.astype(float))) > 2.0**62:
        return _culled(ranked)
    # one whole number per level, in lexicographic order
    key = np.zeros(len(ranked), np.int64)
    for column, height in zip(ranked[:, 2:].T, heights, strict=True):
        key = key * height + column
    order = np.argsort(key, kind="stable")
    starts = np.flatnonzero(np.diff(key[order], prepend=-1))
    if starts.size > _LEVELS:
        return _culled(ranked)
    members = np.split(order, starts[1:])
    levels = ranked[order[starts], 2:]
    kept: list[Any] = []
    # in lexicographic order a level comes after all that are lower; what they kept decides for what they lost
    for highest, own in zip(levels, members, strict=True):
        below = [kept[k] for k in np.flatnonzero((levels[: len(kept)] <= highest).all(axis=1))]
        kept.append(_swept(ranked, own, np.concatenate(below) if below else own[:0]))
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
