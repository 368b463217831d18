"""Spaces in which every bound is one-sided along the mean radius: the radii that hold it are looked up, not tried.

Where the spring force is a range, at a given gain or at a given wall angle the largest feasible radius is best in
everything but the ball; so a row of radii is a search by halves for each bound, and few candidates.
"""

from collections.abc import Callable

import numpy as np

from ...spec.requirements import Requirements
from .candidates import SAME, Candidates, candidates
from .found import Found
from .kinds import Kind
from .limits import Constraint, constraints, unimodal
from .space import Axes, Mask, Numbers, Places, axes, balls

ROWS = 8192
"""Rows of radii in a block."""


def separable(need: Requirements, kind: Kind) -> bool:
    """Whether the bounds of a variant are one-sided along the radius."""
    if need.search.closing_force is None:
        return False
    if need.search.gain is None:
        return unimodal(need) or not kind.controlled
    return not kind.travels


@np.errstate(all="ignore")
def by_radius(need: Requirements, kind: Kind, found: Found, progress: Callable[[int], None]) -> None:
    """Go through every combination but the mean radius, and look up the radii it allows."""
    laid = axes(need, kind)
    radii, others = laid.mean_radius, laid[:-1]
    shape = tuple(axis.size for axis in others)
    count = int(np.prod(shape))
    # whole groups of ball-circle radii, the last axis: at a given gain only the best of a group goes on
    block = max(1, ROWS // shape[-1]) * shape[-1]
    for start in range(0, count, block):
        places = np.unravel_index(np.arange(start, min(start + block, count)), shape)
        columns = [axis[place] for axis, place in zip(others, places, strict=True)]
        rows = Axes(*[*columns, np.full(places[0].size, radii[-1])])
        found.candidates += radii.size * rows.pairs.size
        built = np.broadcast_to(candidates(need, kind, rows).is_clutch, rows.pairs.shape)
        found.excluded[kind.no_clutch] += radii.size * int(np.count_nonzero(~built))
        _Block(need, kind, Axes(*(column[built] for column in rows)), radii).into(found)
        progress(found.candidates)


class _Block:
    """Rows of candidates that differ in the mean radius alone."""

    def __init__(self, need: Requirements, kind: Kind, rows: Axes, radii: Numbers) -> None:
        self.need, self.kind, self.rows, self.radii = need, kind, rows, radii
        self.by_gain = need.search.gain is not None or not kind.controlled

    def into(self, found: Found) -> None:
        """Count, and hand on the best of every row."""
        size, count = self.radii.size, self.rows.pairs.size
        begin, end = np.zeros(count, np.int64), np.full(count, size)
        good = np.ones(count, bool)
        grouped: dict[str, list[Constraint]] = {}
        for constraint in constraints(self.need, self.kind):
            grouped.setdefault(constraint.name, []).append(constraint)
        for name, group in grouped.items():
            first, last, held = self._span(group)
            found.excluded[name] += size * count - int((np.maximum(last - first, 0) * held).sum())
            begin, end, good = np.maximum(begin, first), np.minimum(end, last), good & held
        found.feasible += int(np.maximum(end - begin, 0)[good].sum())
        for row, place in self._best(begin, np.where(good, end, 0)):
            chosen = Axes(*(column[row] for column in self.rows))._replace(mean_radius=self.radii[place])
            found.add(self.need, self.kind, chosen)

    def _span(self, group: list[Constraint]) -> tuple[Places, Places, Mask]:
        """First place, place after the last, and which rows hold what does not depend on the radius."""
        count = self.rows.pairs.size
        first, last = np.zeros(count, np.int64), np.full(count, self.radii.size)
        held = np.ones(count, bool)
        for _, holds, along in group:
            way = along[0 if self.by_gain else 1]
            if way == 0:
                held = held & holds(candidates(self.need, self.kind, self.rows))
            elif way > 0:
                first = np.maximum(first, self._turn(holds, before=False))
            else:
                last = np.minimum(last, self._turn(holds, before=True))
        return first, last, held

    def _turn(self, holds: Callable[[Candidates], Mask], *, before: bool) -> Places:
        """Number of radii, from the smallest on, at which a bound holds (``before``) or does not: by halves."""
        size = self.radii.size
        place = np.zeros(self.rows.pairs.size, np.int64)
        for power in range(size.bit_length() - 1, -1, -1):
            tried = place + (1 << power)
            at = self.rows._replace(mean_radius=self.radii[np.minimum(tried, size) - 1])
            same = holds(candidates(self.need, self.kind, at)) == before
            place = np.where(same & (tried <= size), tried, place)
        return place

    def _best(self, begin: Places, end: Places) -> list[tuple[Places, Places]]:
        """Rows and places of the largest radius; at a given gain one for every ball size that counts."""
        if not self.by_gain or not self.kind.controlled:
            row = np.flatnonzero(end > begin)
            return [(row, end[row] - 1)]
        found, circles = [], self.need.search.ball_circle_radius
        assert circles is not None
        for last in self._ends_by_ball(end):
            # a gain knows no ball circle: of a group the one that allows the largest radius
            place = np.where(last > begin, last - 1, -1).reshape(-1, circles.size)
            row = place.argmax(axis=1) + circles.size * np.arange(len(place))
            row = row[place.ravel()[row] >= 0]
            found.append((row, last[row] - 1))
            begin = np.maximum(begin, last)
        return found

    def _ends_by_ball(self, end: Places) -> list[Places]:
        """Place after the last radius that takes a ball, for every size: tan α = C r/R wants sin α ≥ (s + 2 y)/d."""
        if "ball_diameter" not in self.need.objectives:
            return [end]
        fixed, rows = self.need.fixed, self.rows
        sine = (fixed.face_gap + 2 * fixed.edge_clearance) / (balls(self.need) * (1 + SAME))
        flat = np.where(sine < 1, sine / np.sqrt(np.maximum(1 - sine**2, 1e-300)), np.inf)
        reach = rows.steering * rows.ball_circle_radius
        ends = []
        for tangent in flat:
            largest = np.where(reach > 0, reach / tangent if tangent > 0 else np.inf, np.inf)
            ends.append(np.minimum(end, np.searchsorted(self.radii, largest * (1 + SAME), "right")))
        return ends
