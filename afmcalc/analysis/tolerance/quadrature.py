"""Integrals over a distribution: a fine rule over its probability, and Gauss nodes of its own."""

from collections.abc import Sequence

import numpy as np

from .distributions import Array, Input

_EDGES = (0.0, 1e-12, 1e-9, 1e-7, 1e-5, 1e-4, 1e-3, 1e-2, 0.05, 0.15, 0.3, 0.5)
_PER_PANEL = 24
_NEGLIGIBLE = 1e-12
"""Probability of a part that is not worth nodes."""


def panels(kinks: Sequence[float]) -> tuple[Array, Array]:
    """Gauss–Legendre nodes of a probability, on panels that are finer towards the tails and end at kinks."""
    edges = np.array(sorted({*_EDGES, *(1 - edge for edge in _EDGES), *(k for k in kinks if 0 < k < 1)}))
    x, w = np.polynomial.legendre.leggauss(_PER_PANEL)
    half = np.diff(edges) / 2
    u = (edges[:-1] + half)[:, None] + half[:, None] * x
    return u.ravel(), (half[:, None] * w).ravel()


def gauss(each: Input, count: int, bend: float | None = None) -> tuple[Array, Array]:
    """Gauss nodes and weights of a distribution as truncated, exact for polynomials in its value (lognormal: its log).

    On both sides of a bend of what is integrated it is exact for polynomials of their own.

    Source: Golub, Welsch, Calculation of Gauss quadrature rules, Math. Comp. 23 (1969); the recurrence by Lanczos'
        method on a fine rule (Gautschi, Orthogonal Polynomials, 2004, section 2.2).

    Args:
        each: the distribution.
        count: number of nodes; as many on either side of a bend.
        bend: value at which what is integrated bends; None where it is smooth.

    Returns:
        Values and weights, the weights adding up to 1; a single node where nothing scatters.
    """
    share = 0.0 if bend is None else each.share_below(bend)
    u, weights = panels([*each.kinks, share])
    parts = [side for side in (u < share, u >= share) if weights[side].sum() > _NEGLIGIBLE]
    rules = [_of_part(each, u[side], weights[side], count) for side in parts]
    values, shares = (np.concatenate(columns) for columns in zip(*rules, strict=True))
    return values, shares / shares.sum()


def _of_part(each: Input, u: Array, weights: Array, count: int) -> tuple[Array, Array]:
    """Nodes and weights of a part of a distribution: some of its probabilities."""
    whole = weights.sum()
    x = each.quantiles(u)
    x = np.log(x) if each.kind == "lognormal" else x
    center = float((weights * x).sum() / whole)
    scale = float((weights * (x - center) ** 2).sum() / whole) ** 0.5
    if scale <= 1e-12 * abs(center):
        return each.quantiles(u[[u.size // 2]]), np.array([whole])
    nodes, shares = _rule((x - center) / scale, weights, count)
    values = center + scale * nodes
    return np.exp(values) if each.kind == "lognormal" else values, shares * whole


def _rule(x: Array, weights: Array, count: int) -> tuple[Array, Array]:
    """Gauss rule of a measure on points."""
    basis = np.zeros((count, x.size))
    basis[0] = np.sqrt(weights / weights.sum())
    diagonal, beside = np.zeros(count), np.zeros(count - 1)
    for k in range(count):
        following = x * basis[k]
        diagonal[k] = following @ basis[k]
        if k + 1 < count:
            # twice: rounding would otherwise let the vectors lose their right angles
            for _ in range(2):
                following -= basis[: k + 1].T @ (basis[: k + 1] @ following)
            beside[k] = np.linalg.norm(following)
            basis[k + 1] = following / beside[k]
    nodes, vectors = np.linalg.eigh(np.diag(diagonal) + np.diag(beside, 1) + np.diag(beside, -1))
    return nodes, vectors[0] ** 2
