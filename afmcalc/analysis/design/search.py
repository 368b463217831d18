"""Search of the whole discrete space: how many candidates are feasible, what excludes the others, and the front."""

from collections import Counter, defaultdict
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from ...spec.requirements import Requirements
from ...variants import VARIANTS, Variant
from .candidates import Candidates, candidates, never_meet
from .limits import Constraint, constraints, curved, never_worse, objectives, unimodal
from .space import SAME, Axes, Mask, Numbers, Places, Tile, balls, forces, grids, joined, tiles

TILE = 524288
"""Candidates of a tile: with fewer, setting a tile up weighs more than what the cache saves."""
_ROWS = 32768
"""Rows of radii in a block."""
_MANY = 48
"""Mean radii from which looking them up is quicker than trying them."""
_WAITING = 65536
"""Candidates gathered before the front is taken again: it costs little more for many than for few."""
_SAMPLE = 64
"""Candidates on the front that the others are held against first."""
TOLERANCE = 1e-12
"""Rounding makes equal K_т differ by a few units in the last place; no two designs are that near by intent."""
_LEVELS = 2000
"""Levels of the further objectives beyond which rows are compared with each other instead."""


class Members(NamedTuple):
    """Candidates of one variant, one per element of each column, and a row of objectives each."""

    variant: Variant
    at: Axes
    values: Numbers


@dataclass
class Survey:
    """What a search found: counts, and the front among all it was shown, once settled one entry per variant."""

    candidates: int = 0
    feasible: int = 0
    excluded: Counter[str] = field(default_factory=Counter)
    members: list[Members] = field(default_factory=list)
    _room: int = _WAITING

    def add(self, need: Requirements, variant: Variant, at: Axes) -> None:
        """Take in feasible candidates of a block."""
        if not at.pairs.size:
            return
        self.members.append(Members(variant, at, objectives(candidates(need, variant, at))))
        self._room -= at.pairs.size
        if self._room < 0:
            self.settle()

    def settle(self) -> None:
        """Reduce all members to their common front, one entry per variant."""
        if not self.members:
            return
        values = np.concatenate([member.values.T for member in self.members], axis=1).T
        left = _unbeaten(values)
        keep = np.zeros(len(values), bool)
        keep[left[front(values[left])]] = True
        parts: dict[str, list[Members]] = defaultdict(list)
        masks = np.split(keep, np.cumsum([len(member.values) for member in self.members])[:-1])
        for (variant, at, rows), mask in zip(self.members, masks, strict=True):
            if mask.any():
                parts[variant.name].append(Members(variant, at.at(mask), rows[mask]))
        self.members = [
            Members(
                VARIANTS[name], joined(kept.at for kept in of_one), np.concatenate([kept.values for kept in of_one])
            )
            for name, of_one in parts.items()
        ]
        self._room = max(_WAITING, int(np.count_nonzero(keep)))


def search(need: Requirements, progress: Callable[[int], None] = lambda done: None) -> Survey:
    """Go through the whole space; ``progress`` is told how many candidates are behind."""
    survey = Survey()
    for variant in (VARIANTS[name] for name in dict.fromkeys(need.variants)):
        looked_up = separable(need, variant) and need.search.radii.size >= _MANY
        (by_radius if looked_up else by_tile)(need, variant, survey, progress)
    survey.settle()
    return survey


@np.errstate(all="ignore")
def by_tile(need: Requirements, variant: Variant, survey: Survey, progress: Callable[[int], None]) -> None:
    """Evaluate every candidate of a variant, a tile of the grid at a time."""
    listed = forces(need)
    for tile in (tile for laid in grids(need, variant) for tile in tiles(laid, TILE)):
        good, excluded = _judged(need, variant, tile)
        survey.candidates += listed * tile.size
        survey.feasible += int(np.count_nonzero(good))
        for name, count in excluded.items():
            survey.excluded[name] += listed * count
        survey.add(need, variant, tile.points(np.flatnonzero(_best(need, variant, good, tile))))
        progress(survey.candidates)


def _judged(need: Requirements, variant: Variant, tile: Tile) -> tuple[Mask, Counter[str]]:
    """Which candidates are feasible, and how many each constraint excludes."""
    at_points = candidates(need, variant, tile.axes)
    built = good = at_points.is_clutch
    masks: dict[str, Mask] = {}
    for bound in constraints(need, variant):
        masks[bound.name] = bound.holds(at_points) & masks.get(bound.name, built)
    for mask in sorted(masks.values(), key=lambda mask: mask.size):
        good = good & mask

    def count(mask: Mask) -> int:
        """How many of the tile a mask over some of its axes means."""
        return int(np.count_nonzero(mask)) * (tile.size // mask.size)

    excluded = Counter({name: count(built) - count(mask) for name, mask in masks.items()})
    excluded[at_points.no_clutch] = tile.size - count(built)
    return np.broadcast_to(good, tile.shape), excluded


def _best(need: Requirements, variant: Variant, good: Mask, tile: Tile) -> Mask:
    """Leave out feasible candidates whose neighbour is feasible and no worse in anything."""
    kept = good.copy()
    for name, way in never_worse(need, variant).items():
        place = tile.dimension(name)
        beaten, better = [slice(None)] * good.ndim, [slice(None)] * good.ndim
        beaten[place], better[place] = (slice(None, -1), slice(1, None))[::way]
        kept[tuple(beaten)] &= ~good[tuple(better)]
    return kept


def separable(need: Requirements, variant: Variant) -> bool:
    """Whether the bounds of a variant are one-sided along the radius; springs that exist are not."""
    if need.search.closing_force is None or need.springs or curved(need, variant):
        return False
    if need.search.gain is None:
        return unimodal(need) or not variant.controlled
    return not variant.travels and (not variant.controlled or never_meet(need))


@np.errstate(all="ignore")
def by_radius(need: Requirements, variant: Variant, survey: Survey, progress: Callable[[int], None]) -> None:
    """Go through every combination but the mean radius, and look up the radii it allows.

    Where the spring force is a range, at a given gain or at a given wall angle the largest feasible radius is best in
    everything but the ball; so a row of radii is a search by halves for each bound, and few candidates. Of 10⁸
    candidates: 0.13 s, with the ball an objective 0.6 s; tile by tile 0.8 and 5.6 s.
    """
    for laid in grids(need, variant):
        for tile in tiles(laid._replace(mean_radius=laid.mean_radius[-1:]), _ROWS):
            _Rows(need, variant, tile, laid.mean_radius).into(survey)
            survey.candidates += tile.size * laid.mean_radius.size
            progress(survey.candidates)


class _Rows:
    """Rows of candidates that differ in the mean radius alone: a tile of everything else."""

    def __init__(self, need: Requirements, variant: Variant, tile: Tile, radii: Numbers) -> None:
        self.need, self.variant, self.tile, self.radii = need, variant, tile, radii
        self.by_gain = need.search.gain is not None or not variant.controlled

    def into(self, survey: Survey) -> None:
        """Count, and hand on the best of every row."""
        size, at_largest = self.radii.size, candidates(self.need, self.variant, self.tile.axes)
        built = np.broadcast_to(at_largest.is_clutch, self.tile.shape)
        rows = int(np.count_nonzero(built))
        survey.excluded[at_largest.no_clutch] += size * (self.tile.size - rows)
        begin, end, good = np.zeros(self.tile.shape, np.int64), np.full(self.tile.shape, size), built
        grouped: dict[str, list[Constraint]] = defaultdict(list)
        for constraint in constraints(self.need, self.variant):
            grouped[constraint.name].append(constraint)
        for name, group in grouped.items():
            first, last, holds = self._span(group, at_largest)
            kept = np.where(holds & built, np.maximum(last - first, 0), 0)
            survey.excluded[name] += size * rows - int(kept.sum()) * (self.tile.size // kept.size)
            begin, end, good = np.maximum(begin, first), np.minimum(end, last), good & holds
        survey.feasible += int(np.maximum(end - begin, 0)[good].sum())
        for row, place in self._best(begin, np.where(good, end, 0)):
            survey.add(self.need, self.variant, self.tile.points(row)._replace(mean_radius=self.radii[place]))

    def _span(self, group: list[Constraint], at_largest: Candidates) -> tuple[Places, Places, Mask]:
        """First place, place after the last, and which rows hold what does not depend on the radius."""
        first, last, holds = np.zeros(1, np.int64), np.full(1, self.radii.size), np.ones(1, bool)
        for bound in group:
            way = bound.along_radius[0 if self.by_gain else 1]
            if way == 0:
                holds = holds & bound.holds(at_largest)
            elif way > 0:
                first = np.maximum(first, self._turn(bound.holds, before=False))
            else:
                last = np.minimum(last, self._turn(bound.holds, before=True))
        return first, last, holds

    def _turn(self, holds: Callable[[Candidates], Mask], *, before: bool) -> Places:
        """Number of radii, from the smallest on, at which a bound holds (``before``) or does not: by halves."""
        size = self.radii.size
        severest = self._at(self.radii[-1:] if before else self.radii[:1])
        if (there := holds(severest)).all():
            return np.full(1, size if before else 0)
        # what lies beyond the last radius turns out as the largest place there is
        reach = 1 << (size.bit_length() - 1)
        radii = np.append(self.radii, np.full(2 * reach - size, np.inf))
        place = np.zeros(there.shape, np.int64)
        while reach:
            radius = radii[place + (reach - 1)]
            same = (holds(self._at(radius)) == before) & (radius < np.inf)
            place += reach * same
            reach >>= 1
        return place

    def _at(self, radius: Numbers) -> Candidates:
        return candidates(self.need, self.variant, self.tile.axes._replace(mean_radius=radius))

    def _best(self, begin: Places, end: Places) -> list[tuple[Places, Places]]:
        """Rows and places of the largest radius; at a given gain one for every ball size that counts."""
        if not self.by_gain or not self.variant.controlled:
            row = np.flatnonzero(end > begin)
            return [(row, end.ravel()[row] - 1)]
        best, along, rows = [], self.tile.dimension("ball_circle_radius"), self.tile.size
        numbers = np.arange(1, rows + 1).reshape(self.tile.shape)
        for last in self._ends_by_ball(end):
            # a gain knows no ball circle: of a group the one that allows the largest radius, then of the largest circle
            both = np.where(last > begin, last * rows + numbers - 1, -1).max(axis=along)
            place, row = np.divmod(both[both >= 0], rows)
            best.append((row, place - 1))
            begin = np.maximum(begin, last)
        return best

    def _ends_by_ball(self, end: Places) -> list[Places]:
        """Place after the last radius that takes a ball, for every size: tan α = C r/R wants sin α ≥ (s + 2 y)/d."""
        if "ball_diameter" not in self.need.objectives:
            return [end]
        fixed, axes = self.need.fixed, self.tile.axes
        sine = (fixed.face_gap + 2 * fixed.edge_clearance) / (balls(self.need) * (1 + SAME))
        flat = np.where(sine < 1, sine / np.sqrt(np.maximum(1 - sine**2, 1e-300)), np.inf)
        reach = axes.steering * axes.ball_circle_radius
        ends = []
        for tangent in flat:
            largest = np.where(reach > 0, reach / tangent if tangent > 0 else np.inf, np.inf)
            ends.append(np.minimum(end, np.searchsorted(self.radii, largest * (1 + SAME), "right")))
        return ends


def _unbeaten(values: Numbers) -> Places:
    """Candidates that no sample of the front beats clearly: few, and found much quicker than the front itself.

    A search of 2·10⁶ indirect candidates by three objectives takes 0.6 s, without 5.2 s.
    """
    known = values[:: -(-len(values) // (4 * _SAMPLE))]
    known = known[front(known)]
    left, rest = np.arange(len(values)), np.ascontiguousarray(values.T)
    for best in known[:: -(-len(known) // _SAMPLE)]:
        no_better = np.logical_and.reduce([column >= one for column, one in zip(rest, best, strict=True)])
        if np.count_nonzero(no_better) > len(left) // 16:
            worse = [column > one * (1 + 1e-9) for column, one in zip(rest, best, strict=True)]
            kept = np.flatnonzero(~(no_better & np.logical_or.reduce(worse)))
            left, rest = left[kept], rest[:, kept]
    return left


def ranks(column: Numbers, tolerance: float = TOLERANCE) -> Places:
    """Rank of every value, equal for values that follow each other within the tolerance.

    On whole ranks dominance is exact and transitive, which it is not on numbers compared with a tolerance.
    """
    column = np.minimum(column, np.finfo(float).max)
    order = np.argsort(column, kind="stable")
    ordered = column[order]
    steps = np.diff(ordered) > tolerance * np.abs(ordered[1:])
    by_value = np.empty(column.size, np.int64)
    by_value[order] = np.concatenate([[0], np.cumsum(steps)])
    return by_value


def front(objectives: Numbers, tolerance: float = TOLERANCE) -> Places:
    """Indices of the rows of objectives, all to be small, that none dominates, ascending; of rows that tie the first.

    Values within the relative tolerance are the same. A search with a front of 6,800 rows by four objectives takes
    0.6 s; where each row culls the others 17 s.
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
    for highest, level in zip(levels, members, strict=True):
        below = [kept[k] for k in np.flatnonzero((levels[: len(kept)] <= highest).all(axis=1))]
        rows = np.concatenate([*below, level])
        kept.append(_swept(swept[rows], second[rows], rows, rows.size - level.size))
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
