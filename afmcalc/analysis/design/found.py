"""What a search has found so far: counts, and the front among all it was shown."""

from collections import Counter
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from ...spec.requirements import Requirements
from ...variants import Variant
from .by_law import candidates
from .limits import objectives
from .pareto import front
from .space import Axes, Mask, Numbers

_MERGE = 200_000
"""Candidates kept before the front is taken again: bounds memory."""
_SAMPLE, _KEPT = 256, 24
"""Candidates of a block looked at first, and how many of their front the others are held against."""


class Members(NamedTuple):
    """Candidates of one variant on the front, one per element of each column, and a row of objectives each."""

    variant: Variant
    at: Axes
    values: Numbers


@dataclass
class Found:
    """Outcome of a search."""

    candidates: int = 0
    feasible: int = 0
    excluded: Counter[str] = field(default_factory=Counter)
    members: list[Members] = field(default_factory=list)
    _waiting: int = 0
    _sample: Numbers | None = None
    """A few rows of objectives spread over the front so far."""

    def add(self, need: Requirements, variant: Variant, at: Axes) -> None:
        """Take in feasible candidates of a block: their front first, the common front when many wait."""
        if not at.pairs.size:
            return
        values = objectives(candidates(need, variant, at))
        keep = np.flatnonzero(~self._beaten(values))
        keep = keep[front(values[keep])]
        self.members.append(Members(variant, Axes(*(column[keep] for column in at)), values[keep]))
        self._waiting += keep.size
        if self._waiting > _MERGE:
            self.settle()

    def _beaten(self, values: Numbers) -> Mask:
        """Candidates that a sample of the front beats clearly: most, and much quicker than by the front itself."""
        own = values[:: max(1, len(values) // _SAMPLE)]
        known = own if self._sample is None else np.concatenate([self._sample, own])
        known = known[front(known)]
        self._sample = known[:: max(1, len(known) // _KEPT)]
        beaten = np.zeros(len(values), bool)
        for best in self._sample:
            no_better = [column >= one for column, one in zip(values.T, best, strict=True)]
            worse = [column > one * (1 + 1e-9) for column, one in zip(values.T, best, strict=True)]
            beaten |= np.logical_and.reduce(no_better) & np.logical_or.reduce(worse)
        return beaten

    def settle(self) -> None:
        """Reduce all members to their common front, one entry per variant."""
        if not self.members:
            return
        values = np.concatenate([member.values for member in self.members])
        keep = np.zeros(len(values), bool)
        keep[front(values)] = True
        ends = np.cumsum([len(member.values) for member in self.members])
        masks = np.split(keep, ends[:-1])
        reduced = []
        for variant in dict.fromkeys(member.variant for member in self.members):
            own = [(each, mask) for each, mask in zip(self.members, masks, strict=True) if each.variant == variant]
            at = Axes(*(np.concatenate([each.at[k][mask] for each, mask in own]) for k in range(len(Axes._fields))))
            if at.pairs.size:
                reduced.append(Members(variant, at, np.concatenate([each.values[mask] for each, mask in own])))
        self.members, self._waiting = reduced, int(keep.sum())
