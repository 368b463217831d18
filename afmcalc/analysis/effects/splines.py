"""Friction of the discs in their splines: what presses the pack does not reach its end."""

from collections.abc import Callable

from ...engines.protocol import Clutch
from ...equations import effects as law
from ...errors import CalculationError
from ...messages import say
from .springs_held import with_pairs

Shares = Callable[[float, int], float]
"""``(friction of a pair, number of the disc)`` → share of its normal force that the disc's spline can hold."""

_HALVINGS = 100
_MOST_PAIRS = 1000


def closing(clutch: Clutch, shares: Shares) -> Callable[[float, float], float]:
    """Torque when the pack closed under torque: every disc was held on its way from the spring."""

    def ratio(near: float, far: float) -> float:
        return float(law.next_force_closing(1.0, near, far))

    def torque(driving: float, driven: float) -> float:
        forces = _chain(clutch, shares, ratio, driving, driven)
        return float(_counted(clutch, forces).torque(driving, driven))

    return torque


def opening(clutch: Clutch, shares: Shares) -> Callable[[float, float], float]:
    """Torque when the pack closed at rest and the balls unload it: every disc is held on its way back."""
    most = float(clutch.pack_force_at_rest)

    def ratio(near: float, far: float) -> float:
        return float(law.next_force_opening(1.0, near, far))

    def torque(driving: float, driven: float) -> float:
        chain = _chain(clutch, shares, ratio, driving, driven)

        def counted(first: float) -> Clutch:
            """Pairs counted by their forces over that of the first; none has more than the pack was closed with."""
            return _counted(clutch, [min(each, most / first) for each in chain])

        low, high = 0.0, most
        for _ in range(_HALVINGS):
            middle = (low + high) / 2
            if middle in (low, high):
                break
            if counted(middle).normal_force(driving, driven) > middle:
                low = middle
            else:
                high = middle
        return float(counted(high).torque(driving, driven))

    return torque


def _chain(
    clutch: Clutch, shares: Shares, ratio: Callable[[float, float], float], driving: float, driven: float
) -> list[float]:
    """Forces on the pairs over that of the first, from the spring on: the controlled pairs, then the others."""
    bypass, pairs = int(clutch.bypass_pairs), clutch.spec.friction_group.pairs
    if pairs > _MOST_PAIRS:
        raise CalculationError(
            say("effects: splines are followed disc by disc, at most {most:,} pairs", most=_MOST_PAIRS)
        )
    frictions = [driven] * (pairs - bypass) + [driving] * bypass
    forces = [1.0]
    for disc, (near, far) in enumerate(zip(frictions, frictions[1:], strict=False)):
        forces.append(forces[-1] * ratio(shares(near, disc), shares(far, disc)))
    return forces


def _counted(clutch: Clutch, forces: list[float]) -> Clutch:
    """The clutch whose pairs count by their forces."""
    controlled = len(forces) - int(clutch.bypass_pairs)
    return with_pairs(clutch, sum(forces[controlled:]), sum(forces[:controlled]))
