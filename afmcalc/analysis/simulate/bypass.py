"""The event with the gain above its limit: the pairs that bypass the balls may hold before the balls take over."""

from dataclasses import replace

from ...engines.protocol import Clutch
from ...spec.edit import with_value
from ..effects.springs_held import with_pairs
from .cases import case_of
from .train import train_of


def bypass_peak(clutch: Clutch) -> float | None:
    """Return the peak torque in the shaft if the bypass pairs alone carry, at f_max where they carry most, N·m.

    By the law breakaway is at most what they carry with the spring not yet released (theory, section 3); that they
    go on carrying it in slip is the worst there may be. None where the slipping clutch carries more than they do.

    Raises:
        AfmcalcError: SciPy is missing.
    """
    first, second = (own.max for own in clutch.friction)
    if not clutch.breakaway_torque(first, second) > clutch.torque(first, second) * (1 + 1e-9):
        return None
    return case_of(bypass_alone(clutch), first, second).run().peak


def bypass_alone(clutch: Clutch) -> Clutch:
    """Return the clutch with its bypass pairs only; the load before the event stays that of the clutch as it is."""
    loaded = with_value(clutch.spec, ("drive", "load_torque"), train_of(clutch).load)
    return replace(with_pairs(clutch, clutch.bypass_pairs, 0.0), spec=loaded)
