"""A grid cut into tiles whose axes broadcast, so that each piece of a law costs no more axes than it depends on."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from .space import Axes, Numbers, Places


class Tile(NamedTuple):
    """A part of a grid: every axis in a dimension of its own."""

    at: Axes
    shape: tuple[int, ...]
    order: tuple[int, ...]
    """Which axis lies along each dimension."""

    @property
    def size(self) -> int:
        """Number of grid points."""
        return int(np.prod(self.shape))

    def dimension(self, name: str) -> int:
        """Dimension along which a parameter varies."""
        return self.order.index(Axes._fields.index(name))

    def points(self, places: Places) -> Axes:
        """Columns of the points at flat places."""
        along = dict(zip(self.order, np.unravel_index(places, self.shape), strict=True))
        return Axes(*(axis.ravel()[along[k]] for k, axis in enumerate(self.at)))


def tiles(laid: Axes, most: int) -> Iterator[Tile]:
    """Cut a grid into tiles of at most so many points.

    Inner loops run along the longest axis; the next longest are cut, so that a tile has all of the short ones.
    """
    *short, longest = sorted(range(len(laid)), key=lambda k: laid[k].size)
    order = (*reversed(short), longest)
    for parts in _cut([laid[k] for k in order], most):
        spread = {k: _along(part, dimension) for dimension, (k, part) in enumerate(zip(order, parts, strict=True))}
        at = Axes(*(spread[k] for k in range(len(order))))
        yield Tile(at, tuple(part.size for part in parts), order)


def _cut(laid: list[Numbers], most: int) -> Iterator[list[Numbers]]:
    sizes = [axis.size for axis in laid]
    cut = 0
    while cut < len(laid) - 1 and np.prod(sizes[cut + 1 :]) > most:
        cut += 1
    step = max(1, most // int(np.prod(sizes[cut + 1 :])))
    for outer in np.ndindex(*sizes[:cut]):
        head = [axis[k : k + 1] for axis, k in zip(laid, outer, strict=False)]
        for start in range(0, sizes[cut], step):
            yield [*head, laid[cut][start : start + step], *laid[cut + 1 :]]


def _along(part: Numbers, dimension: int) -> Numbers:
    shape = [1] * len(Axes._fields)
    shape[dimension] = -1
    return part.reshape(shape)
