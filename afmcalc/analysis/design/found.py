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
from .space import Axes, Numbers, Places

_WAITING = 65536
"""Candidates gathered before the front is taken again: it costs little more for many than for few."""
_SAMPLE = 64
"""Candidates on the front that the others are held against first."""


class Members(NamedTuple):
    """Candidates of one variant, one per element of each column, and a row of objectives each."""

    variant: Variant
    at: Axes
    values: Numbers


@dataclass
class Found:
    """Outcome of a search; once settled, the members are the front, one entry per variant."""

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
        masks = np.split(keep, np.cumsum([len(member.values) for member in self.members])[:-1])
        reduced = []
        for variant in dict.fromkeys(member.variant for member in self.members):
            own = [(each, mask) for each, mask in zip(self.members, masks, strict=True) if each.variant == variant]
            at = Axes(*(np.concatenate([each.at[k][mask] for each, mask in own]) for k in range(len(Axes._fields))))
            if at.pairs.size:
                reduced.append(Members(variant, at, np.concatenate([each.values[mask] for each, mask in own])))
        self.members, self._room = reduced, max(_WAITING, int(np.count_nonzero(keep)))


def _unbeaten(values: Numbers) -> Places:
    """Candidates that no sample of the front beats clearly: few, and found much quicker than the front itself."""
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
