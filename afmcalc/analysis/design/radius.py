"""Spaces in which every bound is one-sided along the mean radius: the radii that hold it are looked up, not tried.

Where the spring force is a range, at a given gain or at a given wall angle the largest feasible radius is best in
everything but the ball; so a row of radii is a search by halves for each bound, and few candidates.
"""

from collections.abc import Callable

import numpy as np

from ...spec.requirements import Requirements
from ...variants import Variant
from .by_law import candidates
from .candidates import Candidates
from .found import Found
from .grid import Tile, tiles
from .limits import Constraint, constraints, curved, unimodal
from .room import never_meet
from .space import SAME, Mask, Numbers, Places, balls, grids

ROWS = 32768
"""Rows of radii in a block."""


def separable(need: Requirements, variant: Variant) -> bool:
    """Whether the bounds of a variant are one-sided along the radius; springs that exist are not."""
    if need.search.closing_force is None or need.springs or curved(need, variant):
        return False
    if need.search.gain is None:
        return unimodal(need) or not variant.controlled
    return not variant.travels and (not variant.controlled or never_meet(need))


@np.errstate(all="ignore")
def by_radius(need: Requirements, variant: Variant, found: Found, progress: Callable[[int], None]) -> None:
    """Go through every combination but the mean radius, and look up the radii it allows."""
    for laid in grids(need, variant):
        for tile in tiles(laid._replace(mean_radius=laid.mean_radius[-1:]), ROWS):
            _Rows(need, variant, tile, laid.mean_radius).into(found)
            found.candidates += tile.size * laid.mean_radius.size
            progress(found.candidates)


class _Rows:
    """Rows of candidates that differ in the mean radius alone: a tile of everything else."""

    def __init__(self, need: Requirements, variant: Variant, tile: Tile, radii: Numbers) -> None:
        self.need, self.variant, self.tile, self.radii = need, variant, tile, radii
        self.by_gain = need.search.gain is not None or not variant.controlled

    def into(self, found: Found) -> None:
        """Count, and hand on the best of every row."""
        size, own = self.radii.size, candidates(self.need, self.variant, self.tile.at)
        built = np.broadcast_to(own.is_clutch, self.tile.shape)
        rows = int(np.count_nonzero(built))
        found.excluded[own.no_clutch] += size * (self.tile.size - rows)
        begin, end, good = np.zeros(self.tile.shape, np.int64), np.full(self.tile.shape, size), built
        grouped: dict[str, list[Constraint]] = {}
        for constraint in constraints(self.need, self.variant):
            grouped.setdefault(constraint.name, []).append(constraint)
        for name, group in grouped.items():
            first, last, held = self._span(group, own)
            kept = np.where(held & built, np.maximum(last - first, 0), 0)
            found.excluded[name] += size * rows - int(kept.sum()) * (self.tile.size // kept.size)
            begin, end, good = np.maximum(begin, first), np.minimum(end, last), good & held
        found.feasible += int(np.maximum(end - begin, 0)[good].sum())
        for row, place in self._best(begin, np.where(good, end, 0)):
            found.add(self.need, self.variant, self.tile.points(row)._replace(mean_radius=self.radii[place]))

    def _span(self, group: list[Constraint], own: Candidates) -> tuple[Places, Places, Mask]:
        """First place, place after the last, and which rows hold what does not depend on the radius."""
        first, last, held = np.zeros(1, np.int64), np.full(1, self.radii.size), np.ones(1, bool)
        for each in group:
            way = each.along_radius[0 if self.by_gain else 1]
            if way == 0:
                held = held & each.holds(own)
            elif way > 0:
                first = np.maximum(first, self._turn(each.holds, before=False))
            else:
                last = np.minimum(last, self._turn(each.holds, before=True))
        return first, last, held

    def _turn(self, holds: Callable[[Candidates], Mask], *, before: bool) -> Places:
        """Number of radii, from the smallest on, at which a bound holds (``before``) or does not: by halves."""
        size = self.radii.size
        severest = self._at(self.radii[-1:] if before else self.radii[:1])
        if (held := holds(severest)).all():
            return np.full(1, size if before else 0)
        # what lies beyond the last radius turns out as the largest place there is
        reach = 1 << (size.bit_length() - 1)
        radii = np.append(self.radii, np.full(2 * reach - size, np.inf))
        place = np.zeros(held.shape, np.int64)
        while reach:
            radius = radii[place + (reach - 1)]
            same = (holds(self._at(radius)) == before) & (radius < np.inf)
            place += reach * same
            reach >>= 1
        return place

    def _at(self, radius: Numbers) -> Candidates:
        return candidates(self.need, self.variant, self.tile.at._replace(mean_radius=radius))

    def _best(self, begin: Places, end: Places) -> list[tuple[Places, Places]]:
        """Rows and places of the largest radius; at a given gain one for every ball size that counts."""
        if not self.by_gain or not self.variant.controlled:
            row = np.flatnonzero(end > begin)
            return [(row, end.ravel()[row] - 1)]
        found, along, rows = [], self.tile.dimension("ball_circle_radius"), self.tile.size
        numbers = np.arange(1, rows + 1).reshape(self.tile.shape)
        for last in self._ends_by_ball(end):
            # a gain knows no ball circle: of a group the one that allows the largest radius, then of the largest circle
            both = np.where(last > begin, last * rows + numbers - 1, -1).max(axis=along)
            place, row = np.divmod(both[both >= 0], rows)
            found.append((row, place - 1))
            begin = np.maximum(begin, last)
        return found

    def _ends_by_ball(self, end: Places) -> list[Places]:
        """Place after the last radius that takes a ball, for every size: tan α = C r/R wants sin α ≥ (s + 2 y)/d."""
        if "ball_diameter" not in self.need.objectives:
            return [end]
        fixed, at = self.need.fixed, self.tile.at
        sine = (fixed.face_gap + 2 * fixed.edge_clearance) / (balls(self.need) * (1 + SAME))
        flat = np.where(sine < 1, sine / np.sqrt(np.maximum(1 - sine**2, 1e-300)), np.inf)
        reach = at.steering * at.ball_circle_radius
        ends = []
        for tangent in flat:
            largest = np.where(reach > 0, reach / tangent if tangent > 0 else np.inf, np.inf)
            ends.append(np.minimum(end, np.searchsorted(self.radii, largest * (1 + SAME), "right")))
        return ends
