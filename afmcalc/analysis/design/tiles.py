"""Every candidate of a space evaluated, a tile of the grid at a time.

The axes of a tile broadcast, so that each piece of a law is worked out over no more of them than it depends on.
"""

from collections import Counter
from collections.abc import Callable, Iterator

import numpy as np

from ...spec.requirements import Requirements
from .candidates import candidates
from .found import Found
from .kinds import Kind
from .limits import constraints, never_worse
from .space import Axes, Mask, Numbers, axes, forces

TILE = 65536
"""Candidates of a tile: its few arrays of full size stay in the cache."""


@np.errstate(all="ignore")
def by_tile(need: Requirements, kind: Kind, found: Found, progress: Callable[[int], None]) -> None:
    """Evaluate every candidate of a variant."""
    laid = axes(need, kind)
    # the longest axes last: inner loops run along them
    order = sorted(range(len(laid)), key=lambda k: laid[k].size)
    each = forces(need)
    for parts in _parts([laid[k] for k in order]):
        shape = tuple(part.size for part in parts)
        at = _spread(parts, order)
        size = int(np.prod(shape))
        good, excluded = _judged(need, kind, at, shape)
        found.candidates += each * size
        found.feasible += int(np.count_nonzero(good))
        for name, count in excluded.items():
            found.excluded[name] += each * count
        places = np.unravel_index(np.flatnonzero(_best(need, kind, good, order)), shape)
        chosen = dict(zip(order, (part[place] for part, place in zip(parts, places, strict=True)), strict=True))
        found.add(need, kind, Axes(*(chosen[k] for k in range(len(order)))))
        progress(found.candidates)


def _parts(laid: list[Numbers]) -> Iterator[list[Numbers]]:
    """Cut the leading axes so that no tile is larger than TILE."""
    sizes = [axis.size for axis in laid]
    cut = 0
    while cut < len(laid) - 1 and np.prod(sizes[cut + 1 :]) > TILE:
        cut += 1
    step = max(1, TILE // int(np.prod(sizes[cut + 1 :])))
    for outer in np.ndindex(*sizes[:cut]):
        head = [axis[k : k + 1] for axis, k in zip(laid, outer, strict=False)]
        for start in range(0, sizes[cut], step):
            yield [*head, laid[cut][start : start + step], *laid[cut + 1 :]]


def _spread(parts: list[Numbers], order: list[int]) -> Axes:
    """Give every axis a dimension of its own."""
    spread = {
        k: part.reshape([-1 if place == own else 1 for place in range(len(parts))])
        for own, (k, part) in enumerate(zip(order, parts, strict=True))
    }
    return Axes(*(spread[k] for k in range(len(order))))


def _judged(need: Requirements, kind: Kind, at: Axes, shape: tuple[int, ...]) -> tuple[Mask, Counter[str]]:
    """Which candidates are feasible, and how many each constraint excludes."""
    size = int(np.prod(shape))
    tile = candidates(need, kind, at)
    built = tile.is_clutch
    missed: dict[str, Mask] = {}
    good = built
    for name, holds, _ in constraints(need, kind):
        held = np.asarray(holds(tile))
        good = good & held
        missed[name] = missed[name] | ~held if name in missed else ~held
    excluded = Counter({name: _count(mask & built, size) for name, mask in missed.items()})
    excluded[kind.no_clutch] = size - _count(built, size)
    return np.broadcast_to(good, shape), excluded


def _count(mask: Mask, size: int) -> int:
    """How many of a tile a mask over some of its axes means."""
    return int(np.count_nonzero(mask)) * (size // mask.size)


def _best(need: Requirements, kind: Kind, good: Mask, order: list[int]) -> Mask:
    """Leave out feasible candidates whose neighbour is feasible and no worse in anything."""
    kept = good.copy()
    for name, way in never_worse(need, kind).items():
        place = order.index(Axes._fields.index(name))
        beaten, better = [slice(None)] * good.ndim, [slice(None)] * good.ndim
        beaten[place], better[place] = (slice(None, -1), slice(1, None))[::way]
        kept[tuple(beaten)] &= ~good[tuple(better)]
    return kept
