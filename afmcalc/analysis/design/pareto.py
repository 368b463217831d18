"""Exact Pareto fronts with a relative tolerance: values nearer than it are the same value."""

import numpy as np

from .space import Numbers, Places

TOLERANCE = 1e-12
"""Rounding makes equal K_т differ by a few units in the last place; no two designs are that near by intent."""

_LEVELS = 2000
"""Levels of the further objectives beyond which rows are compared with each other instead."""


def ranks(column: Numbers, tolerance: float = TOLERANCE) -> Places:
    """Rank of every value, equal for values that follow each other within the tolerance.

    On whole ranks dominance is exact and transitive, which it is not on numbers compared with a tolerance.
    """
    column = np.minimum(column, np.finfo(float).max)
    order = np.argsort(column, kind="stable")
    ordered = column[order]
    steps = np.diff(ordered) > tolerance * np.abs(ordered[1:])
    found = np.empty(column.size, np.int64)
    found[order] = np.concatenate([[0], np.cumsum(steps)])
    return found


def front(objectives: Numbers, tolerance: float = TOLERANCE) -> Places:
    """Indices of the nondominated rows, ascending; of rows that tie in every objective the first.

    Args:
        objectives: one row per candidate, one column per objective, all to be small.
        tolerance: relative distance within which values are the same.
    """
    if len(objectives) == 0:
        return np.empty(0, np.int64)
    ranked = np.stack([ranks(column, tolerance) for column in objectives.T], axis=1)
    # the two columns with most values are swept, the levels of the others gone through
    ranked = ranked[:, np.argsort(-ranked.max(axis=0), kind="stable")]
    if ranked.shape[1] == 1:
        return np.array([int(np.argmin(ranked[:, 0]))])
    heights = ranked.max(axis=0) + 1
    if float(np.prod(heights[2:].astype(float))) > 2.0**62:
        return _culled(ranked)
    # one whole number per level, in lexicographic order
    order = np.argsort(key := _number(ranked[:, 2:], heights[2:]), kind="stable")
    starts = np.flatnonzero(np.diff(key[order], prepend=-1))
    if starts.size > _LEVELS:
        return _culled(ranked)
    swept, second = _number(ranked[:, :2], heights[:2]), np.ascontiguousarray(ranked[:, 1])
    members = np.split(order, starts[1:])
    levels = ranked[order[starts], 2:]
    kept: list[Places] = []
    # in lexicographic order a level comes after all that are lower; what they kept decides for what they lost
    for highest, own in zip(levels, members, strict=True):
        below = [kept[k] for k in np.flatnonzero((levels[: len(kept)] <= highest).all(axis=1))]
        rows = np.concatenate([*below, own])
        kept.append(_swept(swept[rows], second[rows], rows, rows.size - own.size))
    return np.sort(np.concatenate(kept))


def _number(ranked: Places, heights: Places) -> Places:
    """Several ranks as one whole number in the same order."""
    key = np.zeros(len(ranked), np.int64)
    for column, height in zip(ranked.T, heights, strict=True):
        key = key * height + column
    return key


def _swept(both: Places, second: Places, rows: Places, others: int) -> Places:
    """Rows of a level, behind so many others, that neither those nor its own dominate: a sweep over one column."""
    order = np.argsort(both, kind="stable")
    ordered = second[order]
    before = np.concatenate([[np.iinfo(np.int64).max], np.minimum.accumulate(ordered)[:-1]])
    return rows[order[(ordered < before) & (order >= others)]]


def _culled(ranked: Places) -> Places:
    """Rows that survive when each survivor in turn removes what it dominates or ties."""
    order = np.lexsort(ranked.T[::-1])
    left, kept = order, []
    while left.size:
        best = left[0]
        kept.append(best)
        left = left[(ranked[left] < ranked[best]).any(axis=1)]
    return np.sort(np.array(kept))
