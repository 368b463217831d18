"""Search of the whole discrete space in cache-sized blocks: feasible candidates, the front among them, exclusions.

Where the spring force is a range and the gain is searched, two variables need no grid at all. Force: the least that
gives the nominal torque. Mean radius: every constraint of a direct clutch bounds it from one side, and within the
bounds the largest one that still takes the same ball is best; both bounds are looked up on the sorted axis.
"""

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from ...equations import direct
from ...spec.requirements import Requirements
from .candidates import SAME, Axes, axes, balls, counts, evaluate, feasible, friction_ends, groups, objectives
from .pareto import front

BLOCK = 16384
_MERGE = 200_000
"""Candidates kept before the front is taken again: bounds memory."""


@dataclass
class Found:
    """Outcome of a search; the members are one row per candidate on the front."""

    candidates: int = 0
    feasible: int = 0
    excluded: Counter[str] = field(default_factory=Counter)
    members: list[tuple[str, Any, Any]] = field(default_factory=list)
    """Variant, axes values (one row each), objectives."""
    _waiting: int = 0

    def add(self, need: Requirements, variant: str, rows: Any, values: Any) -> None:
        """Take in candidates of a block: their front first, the common front when many wait."""
        keep = front(values)
        if keep.size:
            self.members.append((variant, rows[keep], values[keep]))
            self._waiting += keep.size
            if self._waiting > _MERGE:
                self.settle()

    def settle(self) -> None:
        """Reduce all members to their common front."""
        import numpy as np

        if not self.members:
            return
        values = np.concatenate([member[2] for member in self.members])
        keep = np.zeros(len(values), bool)
        keep[front(values)] = True
        start, reduced = 0, []
        for variant, rows, own in self.members:
            mask = keep[start : start + len(own)]
            start += len(own)
            if mask.any():
                reduced.append((variant, rows[mask], own[mask]))
        self.members = reduced
        self._waiting = int(keep.sum())


def total(need: Requirements) -> int:
    """Number of candidates asked for."""
    from math import prod

    return sum(prod(counts(need, variant)) for variant in need.variants)


def search(need: Requirements, progress: Callable[[int], None] = lambda done: None) -> Found:
    """Go through the whole space; ``progress`` is told how many candidates are behind."""
    found = Found()
    for variant in dict.fromkeys(need.variants):
        separable = variant != "indirect" and need.search.closing_force is not None
        separable &= variant == "conventional" or need.search.gain is not None
        (_by_radius if separable else _flat)(need, variant, found, progress)
    found.settle()
    return found


def _flat(need: Requirements, variant: str, found: Found, progress: Callable[[int], None]) -> None:
    """Evaluate every candidate."""
    import numpy as np

    laid = axes(need, variant)
    shape = [axis.size for axis in laid]
    count = int(np.prod(shape))
    forces = counts(need, variant)[-1]
    for start in range(0, count, BLOCK):
        places = np.unravel_index(np.arange(start, min(start + BLOCK, count)), shape)
        at = Axes(*(axis[place] for axis, place in zip(laid, places, strict=True)))
        found.candidates += forces * at.pairs.size
        built = _built(variant, at.pairs, at.driving_pairs)
        found.excluded["pairs"] += forces * int((~built).sum())
        at = Axes(*(column[built] for column in at))
        state = evaluate(need, variant, at)
        good = feasible(state)
        found.feasible += int(good.sum())
        for name, mask in state.excluded.items():
            found.excluded[name] += forces * int(mask.sum())
        if good.any():
            rows = np.stack([column[good] for column in at], axis=1)
            found.add(need, variant, rows, objectives(need, state, at.pairs)[good])
        progress(found.candidates)


def _by_radius(need: Requirements, variant: str, found: Found, progress: Callable[[int], None]) -> None:
    """Evaluate every combination but the mean radius, and look up the radii it allows."""
    import numpy as np

    laid = axes(need, variant)
    radii = _Radii(need, laid.mean_radius, laid.ball_circle_radius.size)
    shape = [laid.pairs.size, laid.driving_pairs.size, laid.gain.size, laid.ball_circle_radius.size]
    count = int(np.prod(shape))
    # whole groups of ball-circle radii, the last axis: only the best of a group goes on
    block = max(1, BLOCK // shape[-1]) * shape[-1]
    for start in range(0, count, block):
        places = np.unravel_index(np.arange(start, min(start + block, count)), shape)
        pairs, driving, gain, circle = (
            axis[place]
            for axis, place in zip(
                (laid.pairs, laid.driving_pairs, laid.gain, laid.ball_circle_radius), places, strict=True
            )
        )
        found.candidates += laid.mean_radius.size * pairs.size
        built = _built(variant, pairs, driving)
        found.excluded["pairs"] += laid.mean_radius.size * int((~built).sum())
        pairs, driving, gain, circle = (column[built] for column in (pairs, driving, gain, circle))
        with np.errstate(all="ignore"):
            _radius_block(need, variant, found, radii, pairs, driving, gain, circle)
        progress(found.candidates)


def _built(variant: str, pairs: Any, driving_pairs: Any) -> Any:
    """Combinations that can be built at all: a differentiated clutch has a driven pair. Others break no other limit."""
    import numpy as np

    return driving_pairs < pairs if variant == "differentiated" else np.ones(pairs.shape, bool)


class _Radii:
    """The mean radii searched, ascending, with what each allows."""

    def __init__(self, need: Requirements, radii: Any, circles: int) -> None:
        import numpy as np

        span, width = need.search.closing_force, need.fixed.face_width
        assert span is not None
        self.values, self.span, self.circles = radii, span, circles
        self.first = int(np.searchsorted(radii, width / 2, "right")) if width is not None else 0
        """Radii below it do not exceed half the face width."""
        self.torque_by_pressure = None
        if width is not None and need.limits.surface_pressure is not None:
            self.torque_by_pressure = need.limits.surface_pressure * 2 * np.pi * width * radii**2

    def at_least(self, bound: Any) -> Any:
        """First place with R ≥ bound."""
        import numpy as np

        return np.searchsorted(self.values, bound * (1 - SAME))

    def at_most(self, bound: Any) -> Any:
        """Place after the last with R ≤ bound."""
        import numpy as np

        return np.searchsorted(self.values, bound * (1 + SAME), "right")


def _radius_block(
    need: Requirements, variant: str, found: Found, radii: _Radii, pairs: Any, driving: Any, gain: Any, circle: Any
) -> None:
    import numpy as np

    size, limits, wanted = radii.values.size, need.limits, need.wanted
    gain = np.zeros(pairs.shape) if variant == "conventional" else gain
    bypass, controlled = groups(variant, pairs, driving)
    ends = friction_ends(need)
    # torque per force and radius: R is a factor of the direct law
    at_set, low, high = (direct.torque(1.0, 1.0, bypass, controlled, gain, *end) for end in ends)
    margin = wanted.margin if wanted.method == "mean-friction" else 1.0
    lever = wanted.nominal_torque * margin / at_set
    top, bottom = np.maximum(low, high), np.minimum(low, high)
    factor, torque_max = top / bottom, lever * top

    rows: dict[str, Any] = {}
    if wanted.accuracy_factor is not None:
        rows["accuracy_factor"] = ~(factor <= wanted.accuracy_factor * (1 + SAME))
    if wanted.torque_max is not None:
        rows["torque_max"] = ~(torque_max <= wanted.torque_max * (1 + SAME))
    if limits.gain_limit and variant == "differentiated":
        rows["gain_limit"] = gain > direct.gain_limit_differentiated(bypass, need.friction.groups[0].max) * (1 + 1e-9)
    if limits.gain_limit and variant == "all-driving":
        rows["gain_limit"] = gain > direct.gain_limit_all_driving(pairs) * (1 + 1e-9)
    if limits.reduced_gain is not None and variant != "conventional":
        rows["reduced_gain"] = ~(controlled * gain <= limits.reduced_gain * (1 + SAME))

    begin, end = radii.at_least(lever / radii.span.max), radii.at_most(lever / radii.span.min)
    found.excluded["closing_force"] += int((size - np.maximum(end - begin, 0)).sum())
    if radii.first:
        found.excluded["face_width"] += radii.first * pairs.size
        begin = np.maximum(begin, radii.first)
    if radii.torque_by_pressure is not None:
        by_pressure = np.searchsorted(radii.torque_by_pressure, lever * (1 - SAME))
        found.excluded["surface_pressure"] += int(by_pressure.sum())
        begin = np.maximum(begin, by_pressure)
    steps = [end]
    if variant != "conventional":
        begin, steps = _balls(need, found, radii, ends, (controlled, gain, circle, lever), begin, end)
    bad = np.zeros(pairs.shape, bool)
    for name, mask in rows.items():
        found.excluded[name] += size * int(mask.sum())
        bad |= mask
    found.feasible += int(np.maximum(steps[-1] - begin, 0)[~bad].sum())
    before, parts, circles = begin, [], radii.circles
    for step in steps:
        # the largest mean radius is best among those that take one ball size, on whatever ball circle
        place = np.where(~bad & (step > before), step - 1, -1).reshape(-1, circles)
        some = place.argmax(axis=1) + circles * np.arange(len(place))
        some = some[place.ravel()[some] >= 0]
        parts.append((some, step[some] - 1))
        before = np.maximum(before, step)
    row, place = (np.concatenate(column) for column in zip(*parts, strict=True))
    if row.size:
        none = np.full(row.size, np.nan)
        at = Axes(pairs[row], driving[row], gain[row], none, none, circle[row], radii.values[place])
        values = objectives(need, evaluate(need, variant, at), at.pairs)
        found.add(need, variant, np.stack(at, axis=1), values)


def _balls(
    need: Requirements, found: Found, radii: _Radii, ends: Any, state: Any, begin: Any, end: Any
) -> tuple[Any, list[Any]]:
    """Bounds of the radius by contact force and by the standard balls (one end per ball size that matters)."""
    import numpy as np

    controlled, gain, circle, lever = state
    size, fixed = radii.values.size, need.fixed
    if need.limits.contact_force is not None:
        shares = [controlled * f2 / (1 + gain * controlled * f2) for _, f2 in ends[1:]]
        ratio = fixed.balls * circle * need.limits.contact_force * (1 + SAME) / (lever * np.maximum(*shares))
        # F_n = T_2/(n r cos α) ≤ [F_n] bounds tan α = C r/R from above
        steepest = np.sqrt(np.maximum(ratio**2 - 1, 0))
        least = np.where(ratio < 1, np.inf, np.where(gain > 0, gain * circle / steepest, 0.0))
        by_contact = radii.at_least(least)
        found.excluded["contact_force"] += int(by_contact.sum())
        begin = np.maximum(begin, by_contact)
    listed = balls(need)
    sine = (fixed.face_gap + 2 * fixed.edge_clearance) / (listed * (1 + SAME))
    tangent = np.where(sine < 1, sine / np.sqrt(np.maximum(1 - sine**2, 1e-300)), np.inf)
    chosen = tangent if "ball_diameter" in need.objectives else tangent[-1:]
    idle = gain <= 0
    steps = []
    for least_tangent in chosen:
        largest = np.where(idle, np.inf, gain * circle / least_tangent if least_tangent > 0 else np.inf)
        steps.append(np.minimum(end, radii.at_most(largest)))
        if least_tangent is chosen[-1] or least_tangent == chosen[-1]:
            found.excluded["standard_ball"] += int((size - radii.at_most(largest)).sum())
    return begin, steps
