"""Where nothing meets every requirement: the fewest that stand in the way, and what could be had of them instead."""

from collections.abc import Callable
from functools import reduce
from operator import and_

import numpy as np

from ...result import Result, quantity
from ...spec.requirements import Requirements
from ...variants import VARIANTS, Variant
from .by_law import candidates
from .grid import Tile, tiles
from .limits import Constraint, constraints
from .space import grids, total
from .tiles import SIZE

MOST = 30_000_000
"""Candidates that are looked through again; of a larger space every so many radii."""


class Attainable(Result):
    """The best of a requirement among clutches that miss nothing else, or only what is named together with it."""

    together: str | None = quantity("", None, "requirements given up together", optional=True)
    requirement: str = quantity("", None, "requirement given up")
    sense: str = quantity("", None, "is to be")
    limit: float = quantity("", None, "limit", unit_in="unit")
    best: float = quantity("", None, "best found", unit_in="unit")
    unit: str = quantity("", None, "unit", is_unit=True)


Best = dict[tuple[Constraint, ...], list[float]]
"""Bounds missed together → the best found of each."""


@np.errstate(all="ignore")
def attainable(need: Requirements, progress: Callable[[int, int], None] = lambda done, of: None) -> list[Attainable]:
    """Look among the candidates that miss the fewest requirements for the best there is of those, on the grid.

    Args:
        need: the requirements.
        progress: is told how many candidates are behind, of how many.

    Returns:
        A row for each requirement that is missed, alone or together with others.
    """
    count = total(need)
    step, done = -(-count // MOST), 0
    found: dict[tuple[str, ...], list[Attainable]] = {}
    fewest = 1 << 30
    for variant in (VARIANTS[name] for name in dict.fromkeys(need.variants)):
        for laid in grids(need, variant):
            few = laid._replace(mean_radius=np.unique(np.append(laid.mean_radius[::step], laid.mean_radius[-1])))
            for tile in tiles(few, SIZE):
                for missed, values in _of_tile(need, variant, tile, fewest).items():
                    if len(missed) < fewest:
                        fewest = len(missed)
                        found.clear()
                    _keep(found, missed, values)
                done += tile.size
                progress(done * step, count)
    return [row for rows in found.values() for row in rows]


def _of_tile(need: Requirements, variant: Variant, tile: Tile, most: int) -> Best:
    """What the candidates of a tile that miss the fewest bounds, at most so many, have of those."""
    own, held = candidates(need, variant, tile.at), constraints(need, variant)
    bounds = [each for each in held if each.value]
    built = reduce(and_, (each.holds(own) for each in held if not each.value), own.is_clutch)
    misses = [np.broadcast_to(~each.holds(own), tile.shape) for each in bounds]
    number = np.where(built, np.sum(misses, axis=0, dtype=np.int16), np.int16(len(bounds) + 1))
    fewest = int(number.min())
    if fewest > min(most, len(bounds)):
        return {}
    near = np.flatnonzero(number == fewest)
    missed = np.stack([mask.ravel()[near] for mask in misses], axis=1)
    found: Best = {}
    for row in np.unique(missed, axis=0):
        alike = near[(missed == row).all(axis=1)]
        chosen = tuple(bound for bound, out in zip(bounds, row, strict=True) if out)
        values = (
            np.broadcast_to(bound.value(own), tile.shape).ravel()[alike] for bound in chosen if bound.value is not None
        )
        found[chosen] = [
            float(each.max() if bound.at_least else each.min()) for bound, each in zip(chosen, values, strict=True)
        ]
    return found


def _keep(found: dict[tuple[str, ...], list[Attainable]], missed: tuple[Constraint, ...], values: list[float]) -> None:
    """Take in what is better than what was found before; what has no number is nothing to bargain for."""
    if not np.isfinite(values).all():
        return
    names = tuple(f"{bound.name} {_sense(bound)}" for bound in missed)
    rows = [
        Attainable(
            together=" + ".join(bound.name for bound in missed) if len(missed) > 1 else None,
            requirement=bound.name, sense=_sense(bound), limit=bound.limit, best=value, unit=bound.unit,
        )
        for bound, value in zip(missed, values, strict=True)
    ]  # fmt: skip
    before = found.get(names, rows)
    found[names] = [
        new if (new.best > old.best) == bound.at_least else old
        for bound, new, old in zip(missed, rows, before, strict=True)
    ]


def _sense(bound: Constraint) -> str:
    return "at least" if bound.at_least else "at most"
