"""Search of the whole discrete space: how many candidates are feasible, what excludes the others, and the front."""

from collections import Counter, defaultdict
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from ...errors import AfmcalcError
from ...spec.requirements import Requirements
from ...variants import VARIANTS, Variant
from .candidates import Candidates, candidates, never_meet
from .limits import Constraint, constraints, never_worse, objectives, unimodal
from .space import SAME, Axes, Mask, Numbers, Places, Tile, balls, curved, forces, grids, joined, linings, tiles

TILE = 524288
"""Candidates in a tile; in smaller tiles the set-up takes more time than the cache saves."""
_ROWS = 32768
"""Rows that are searched at once; a row has the candidates that differ in the mean radius only."""
_MANY = 48
"""Number of mean radii from which ``by_radius`` is faster than ``by_tile``."""
_WAITING = 65536
"""Candidates that are gathered before the front is calculated again; many take little more time than few."""
MOST_KEPT = 2_000_000
"""Feasible candidates that are kept at most: 0.3 GB."""
_LEVELS = 2000
"""Number of levels of the third and further objectives above which rows are compared one by one instead."""


class Members(NamedTuple):
    """Candidates of one variant, one per element of each column, and a row of objectives each."""

    variant: Variant
    at: Axes
    values: Numbers
    need: Requirements
    """The requirements, with the friction material that it has."""


@dataclass
class Survey:
    """Result of a search: counts, and the front of all candidates added; after ``settle`` one entry per variant."""

    candidates: int = 0
    feasible: int = 0
    excluded: Counter[str] = field(default_factory=Counter)
    members: list[Members] = field(default_factory=list)
    every: bool = False
    """Whether all feasible candidates are kept, for what is asked of them afterwards."""
    parts: dict[str, "Survey"] = field(default_factory=dict)
    """Counts of each variant."""
    _room: int = _WAITING

    def add(self, need: Requirements, variant: Variant, at: Axes) -> None:
        """Add feasible candidates of a variant."""
        if not at.pairs.size:
            return
        self.members.append(Members(variant, at, objectives(candidates(need, variant, at)), need))
        self._room -= at.pairs.size
        if self._room < 0:
            self.settle()

    def take(self, name: str, part: "Survey") -> None:
        """Add the survey of one variant."""
        self.parts[name] = part
        self.candidates += part.candidates
        self.feasible += part.feasible
        self.excluded += part.excluded
        self.members, part.members = self.members + part.members, []

    def settle(self) -> None:
        """Reduce all members to their common front, one entry per variant."""
        if self.every and self.feasible > MOST_KEPT:
            raise AfmcalcError(
                "{count:,} candidates meet what is told without a simulation; at most {most:,} are simulated: coarser "
                "ranges or tighter limits, please",
                count=self.feasible,
                most=MOST_KEPT,
            )
        if not self.members:
            return
        values = np.concatenate([member.values.T for member in self.members], axis=1).T
        keep = np.full(len(values), self.every)
        keep[slice(0) if self.every else front(values)] = True
        parts: dict[tuple[str, int], list[Members]] = defaultdict(list)
        masks = np.split(keep, np.cumsum([len(member.values) for member in self.members])[:-1])
        for (variant, at, rows, need), mask in zip(self.members, masks, strict=True):
            if mask.any():
                parts[variant.name, id(need)].append(Members(variant, at.at(mask), rows[mask], need))
        self.members = [
            of_one[0]._replace(
                at=joined(kept.at for kept in of_one), values=np.concatenate([kept.values for kept in of_one])
            )
            for of_one in parts.values()
        ]
        self._room = max(_WAITING, int(np.count_nonzero(keep)))


def search(need: Requirements, progress: Callable[[int], None] = lambda done: None, *, every: bool = False) -> Survey:
    """Search the whole space; ``progress`` receives the number of candidates searched so far.

    With ``every`` the survey keeps all feasible candidates, up to so many, not only those of the front.
    """
    survey = Survey(every=every)
    for variant in (VARIANTS[name] for name in dict.fromkeys(need.variants)):
        part = Survey(every=every)
        for each in linings(need):
            looked_up = separable(each, variant) and need.search.radii.size >= _MANY and not every
            go = by_radius if looked_up else by_tile
            go(each, variant, part, lambda done, behind=survey.candidates: progress(behind + done))  # type: ignore[misc]
        survey.take(variant.name, part)
    survey.settle()
    return survey


@np.errstate(all="ignore")
def by_tile(need: Requirements, variant: Variant, survey: Survey, progress: Callable[[int], None]) -> None:
    """Evaluate every candidate of a variant, a tile of the grid at a time."""
    spring_forces = forces(need)
    for tile in (tile for laid in grids(need, variant) for tile in tiles(laid, TILE)):
        at_points = candidates(need, variant, tile.axes)
        built = good = at_points.is_clutch
        masks: dict[str, Mask] = {}
        bounds = constraints(need, variant)
        for bound in (bound for bound in bounds if bound.value):
            masks[bound.name] = bound.holds(at_points) & masks.get(bound.name, built)
        for mask in sorted(masks.values(), key=lambda mask: mask.size):
            good = good & mask
        good, clutches = np.broadcast_to(good, tile.shape).copy(), tile.count(built)
        for bound in (bound for bound in bounds if not bound.value):
            # what costs most is asked of those that hold the others, and counted of these
            asked = np.flatnonzero(good)
            misses = asked[~bound.holds(candidates(need, variant, tile.points(asked)))]
            survey.excluded[bound.name] += spring_forces * misses.size
            good.ravel()[misses] = False
        survey.candidates += spring_forces * tile.size
        survey.feasible += tile.count(good)
        survey.excluded.update({name: spring_forces * (clutches - tile.count(mask)) for name, mask in masks.items()})
        survey.excluded[at_points.no_clutch] += spring_forces * (tile.size - clutches)
        kept = good if survey.every else _best(need, variant, good, tile)
        survey.add(need, variant, tile.points(np.flatnonzero(kept)))
        progress(survey.candidates)


def _best(need: Requirements, variant: Variant, good: Mask, tile: Tile) -> Mask:
    """Return the feasible candidates without those whose neighbour is feasible and no worse in any objective."""
    kept = good.copy()
    for name, way in never_worse(need, variant).items():
        place = tile.dimension(name)
        beaten, better = [slice(None)] * good.ndim, [slice(None)] * good.ndim
        beaten[place], better[place] = (slice(None, -1), slice(1, None))[::way]
        kept[tuple(beaten)] &= ~good[tuple(better)]
    return kept


def separable(need: Requirements, variant: Variant) -> bool:
    """Whether every bound holds up to one radius, or from one radius on; not for a catalogue, or parts in a space."""
    wanted = need.wanted.cycles, need.wanted.torque_after_wear
    if need.search.closing_force is None or curved(need, variant) or wanted != (None, None):
        return False
    if need.springs or need.envelope:
        return False
    if need.search.gain is None:
        return unimodal(need) or not variant.controlled
    return not variant.travels and (not variant.controlled or never_meet(need))


@np.errstate(all="ignore")
def by_radius(need: Requirements, variant: Variant, survey: Survey, progress: Callable[[int], None]) -> None:
    """Evaluate a variant: for every combination of the other parameters, find the range of mean radii by bisection.

    Where the spring force is a range, at a given gain or at a given wall angle the largest feasible radius is best in
    every objective but the ball. So a row takes one bisection per bound, and leaves few candidates. A search of 10⁸
    candidates takes 0.13 s, with the ball an objective 0.6 s; tile by tile 0.8 and 5.6 s.
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
        self.at_largest = candidates(need, variant, tile.axes)
        self.by_gain = need.search.gain is not None or not variant.controlled

    def into(self, survey: Survey) -> None:
        """Count the candidates, and add the best of every row to a survey."""
        size, at_largest = self.radii.size, self.at_largest
        built = np.broadcast_to(at_largest.is_clutch, self.tile.shape)
        rows = int(np.count_nonzero(built))
        survey.excluded[at_largest.no_clutch] += size * (self.tile.size - rows)
        begin, end, good = np.zeros(self.tile.shape, np.int64), np.full(self.tile.shape, size), built
        grouped: dict[str, list[Constraint]] = defaultdict(list)
        for constraint in constraints(self.need, self.variant):
            grouped[constraint.name].append(constraint)
        for name, group in grouped.items():
            first, last, holds = self._span(group)
            kept = np.where(holds & built, np.maximum(last - first, 0), 0)
            survey.excluded[name] += size * rows - int(kept.sum()) * (self.tile.size // kept.size)
            begin, end, good = np.maximum(begin, first), np.minimum(end, last), good & holds
        survey.feasible += int(np.maximum(end - begin, 0)[good].sum())
        for row, place in self._best(begin, np.where(good, end, 0)):
            survey.add(self.need, self.variant, self.tile.points(row)._replace(mean_radius=self.radii[place]))

    def _span(self, group: list[Constraint]) -> tuple[Places, Places, Mask]:
        """Return first place, place after the last, and which rows meet the bounds that do not depend on the radius."""
        first, last, holds = np.zeros(1, np.int64), np.full(1, self.radii.size), np.ones(1, bool)
        for bound in group:
            way = bound.along_radius[0 if self.by_gain else 1]
            if way == 0:
                holds = holds & bound.holds(self.at_largest)
            elif way > 0:
                first = np.maximum(first, self._turn(bound.holds, before=False))
            else:
                last = np.minimum(last, self._turn(bound.holds, before=True))
        return first, last, holds

    def _turn(self, holds: Callable[[Candidates], Mask], *, before: bool) -> Places:
        """Number of radii, from the smallest on, at which a bound holds (``before``) or does not."""
        size = self.radii.size
        severest = self._at(self.radii[-1:] if before else self.radii[:1])
        if (there := holds(severest)).all():
            return np.full(1, size if before else 0)
        # bisection; the infinite radii fill up a power of two, and never count
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
        return replace(self.at_largest, at=self.tile.axes._replace(mean_radius=radius))

    def _best(self, begin: Places, end: Places) -> list[tuple[Places, Places]]:
        """Rows and places of the largest radius; at a given gain for every ball size that changes an objective."""
        if not self.by_gain or not self.variant.controlled:
            row = np.flatnonzero(end > begin)
            return [(row, end.ravel()[row] - 1)]
        best, along, rows = [], self.tile.dimension("ball_circle_radius"), self.tile.size
        numbers = np.arange(1, rows + 1).reshape(self.tile.shape)
        for last in self._ends_by_ball(end):
            # a given gain does not depend on the ball circle: take the largest radius, then the largest ball circle
            both = np.where(last > begin, last * rows + numbers - 1, -1).max(axis=along)
            place, row = np.divmod(both[both >= 0], rows)
            best.append((row, place - 1))
            begin = np.maximum(begin, last)
        return best

    def _ends_by_ball(self, end: Places) -> list[Places]:
        """Place after the last radius that fits a ball, for every size: sin α ≥ (s + 2 y)/d with tan α = C r/R."""
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


def ranks(column: Numbers, tolerance: float = SAME) -> Places:
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


def front(objectives: Numbers, tolerance: float = SAME) -> Places:
    """Indices, ascending, of the rows that no other row dominates (small is good); of equal rows only the first.

    Values within the relative tolerance are the same. A search with a front of 6,800 rows by four objectives takes
    0.6 s; with ``_culled`` alone 2 s.
    """
    if len(objectives) == 0:
        return np.empty(0, np.int64)
    # sweep over the two columns with most values; equal values in the others, here at least one, make a level
    columns = (*objectives.T, *np.zeros((max(3 - objectives.shape[1], 0), len(objectives))))
    ranked = np.stack([ranks(column, tolerance) for column in columns], axis=1)
    ranked = ranked[:, np.argsort(-ranked.max(axis=0), kind="stable")]
    order = np.lexsort(ranked.T[:1:-1])
    first, second, *_ = ordered = np.ascontiguousarray(ranked[order].T)
    both = first * order.size + second
    starts = np.flatnonzero(np.append(True, np.diff(ordered[2:]).any(axis=0)))
    if starts.size > _LEVELS:
        return _culled(ranked)
    levels, kept = ordered[2:, starts].T, list[Places]()
    # all lower levels come first; a level is compared with the rows that these kept
    for level, begin, end in zip(levels, starts, np.append(starts[1:], order.size), strict=True):
        below = [kept[k] for k in np.flatnonzero((levels[: len(kept)] <= level).all(axis=1))]
        rows = np.concatenate([*below, np.arange(begin, end)])
        rows = rows[np.argsort(both[rows], kind="stable")]
        least = np.minimum.accumulate(second[rows])
        kept.append(rows[np.append(True, least[1:] < least[:-1]) & (rows >= begin)])
    return np.sort(order[np.concatenate(kept)])


def _culled(ranked: Places) -> Places:
    """Rows that survive when each survivor in turn removes what it dominates or ties, by the least sum of ranks."""
    remaining, kept = np.argsort(ranked.sum(axis=1), kind="stable"), []
    columns = list(ranked[remaining].T)
    while remaining.size:
        kept.append(remaining[0])
        better = np.logical_or.reduce([column < column[0] for column in columns])
        remaining, columns = remaining[better], [column[better] for column in columns]
    return np.sort(np.array(kept))
