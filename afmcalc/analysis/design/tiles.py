"""Every candidate of a space evaluated, a tile of the grid at a time."""

from collections import Counter
from collections.abc import Callable

import numpy as np

from ...spec.requirements import Requirements
from ...variants import Variant
from .by_law import candidates
from .found import Found
from .grid import Tile, tiles
from .limits import constraints, never_worse
from .space import Mask, forces, grids

SIZE = 524288
"""Candidates of a tile: with fewer, setting a tile up weighs more than what the cache saves."""


@np.errstate(all="ignore")
def by_tile(need: Requirements, variant: Variant, found: Found, progress: Callable[[int], None]) -> None:
    """Evaluate every candidate of a variant."""
    each = forces(need)
    for tile in (tile for laid in grids(need, variant) for tile in tiles(laid, SIZE)):
        good, excluded = _judged(need, variant, tile)
        found.candidates += each * tile.size
        found.feasible += int(np.count_nonzero(good))
        for name, count in excluded.items():
            found.excluded[name] += each * count
        found.add(need, variant, tile.points(np.flatnonzero(_best(need, variant, good, tile))))
        progress(found.candidates)


def _judged(need: Requirements, variant: Variant, tile: Tile) -> tuple[Mask, Counter[str]]:
    """Which candidates are feasible, and how many each constraint excludes."""
    own = candidates(need, variant, tile.at)
    built = good = own.is_clutch
    held: dict[str, Mask] = {}
    for each in constraints(need, variant):
        held[each.name] = each.holds(own) & held.get(each.name, built)
    for mask in sorted(held.values(), key=lambda mask: mask.size):
        good = good & mask
    count = _count(built, tile.size)
    excluded = Counter({name: count - _count(mask, tile.size) for name, mask in held.items()})
    excluded[own.no_clutch] = tile.size - count
    return np.broadcast_to(good, tile.shape), excluded


def _count(mask: Mask, size: int) -> int:
    """How many of a tile a mask over some of its axes means."""
    return int(np.count_nonzero(mask)) * (size // mask.size)


def _best(need: Requirements, variant: Variant, good: Mask, tile: Tile) -> Mask:
    """Leave out feasible candidates whose neighbour is feasible and no worse in anything."""
    kept = good.copy()
    for name, way in never_worse(need, variant).items():
        place = tile.dimension(name)
        beaten, better = [slice(None)] * good.ndim, [slice(None)] * good.ndim
        beaten[place], better[place] = (slice(None, -1), slice(1, None))[::way]
        kept[tuple(beaten)] &= ~good[tuple(better)]
    return kept
