"""Fatigue by slips: a slip swings the load from T_low to T(f), and friction differs from slip to slip.

Over the friction range every friction is taken as equally likely (theory, section 4); the life is that of the mean
damage (Miner), and what stays below the endurance limit does none.
"""

from collections.abc import Callable, Sequence
from typing import TypeAlias

from ..arrays import Values
from ..engines.protocol import Clutch
from ..equations import life as law
from ..spec.models import Fatigue

Stress: TypeAlias = Callable[[Values], Values]
"""Damaging stress of a slip at a share of the way along the friction range, Pa; monotone in it."""

NODES = 32
"""Gauss–Legendre nodes of a smooth piece of the damage."""
_HALVINGS = 55


def along(clutch: Clutch, *, from_mean: bool = False) -> Callable[[Values], Values]:
    """Torque at a share (0…1) of the way from f_min, or from the mean, to f_max, N·m; f_1 and f_2 move together."""
    first, second = clutch.friction
    starts = (first.mean, second.mean) if from_mean else (first.min, second.min)

    def torque(share: Values) -> Values:
        at: Values = clutch.torque(
            *(start + share * (own.max - start) for start, own in zip(starts, (first, second), strict=True))
        )
        return at

    return torque


def kinks(clutch: Clutch, *, from_mean: bool = False) -> list[Values]:
    """Shares of the way at which the law changes: where the sleeve of an indirect clutch leaves its stop."""
    leaving = getattr(clutch, "friction_set", None)
    own = clutch.friction[0]
    start = own.mean if from_mean else own.min
    return [] if leaving is None or own.max == start else [(leaving - start) / (own.max - start)]


def cycles(part: Fatigue, stress: Stress, kinks: Sequence[Values] = ()) -> Values:
    """Slips to failure, 1/E[1/N]: NaN where no slip comes above the endurance limit.

    Args:
        part: the part, its S–N line.
        stress: damaging stress along the range.
        kinks: shares of the way at which it is not smooth.
    """
    import numpy as np

    limit, line = part.endurance_limit, (part.exponent, part.base_cycles)
    least, most = (np.asarray(stress(np.asarray(end))) for end in (0.0, 1.0))
    rising = most >= least
    begin, end = np.zeros(rising.shape), np.ones(rising.shape)
    low, high = begin, end
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        below = (stress(middle) > limit) == rising
        low, high = np.where(below, low, middle), np.where(below, middle, high)
    begin, end = np.where(rising, low, begin), np.where(rising, end, high)
    edges = [begin, *(np.clip(kink, begin, end) for kink in kinks), end]
    x, weights = np.polynomial.legendre.leggauss(NODES)
    damage = np.zeros(rising.shape)
    with np.errstate(all="ignore"):
        for left, right in zip(edges, edges[1:], strict=False):
            half = (right - left) / 2
            at = left + half * (1 + x.reshape(-1, *(1,) * half.ndim))
            rates = 1 / np.asarray(law.cycles(limit, stress(at), *line))
            damage = damage + half * np.tensordot(weights, np.broadcast_to(rates, at.shape), axes=1)
        above = np.maximum(least, most) > limit
        found: Values = np.where(above & (damage > 0), 1 / damage, np.nan)
    return found
