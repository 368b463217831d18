"""Where a parameter may lie: what its key allows, where there is a clutch, and up to the gain limit."""

import math
from typing import NamedTuple

from ...engines import build
from ...engines.geometry import angle_given
from ...engines.protocol import Clutch
from ...errors import CalculationError, SpecError
from ...messages import say
from ...spec import Spec
from ...spec.edit import with_key
from ...spec.paths import ALIASES, keys
from ...variants import GainLimit

SAME = 1e-9
"""Relative tolerance within which a wanted value counts as reached."""


class Domain(NamedTuple):
    """Values a parameter may take."""

    low: float
    low_taken: bool
    """Whether the low end is itself a value, or one only approached."""
    high: float
    """Itself a value, unless infinite."""
    why: str
    """What ends it above."""


def domain_of(clutch: Clutch, name: str, *, beyond_limit: bool) -> Domain:
    """Return where the clutch can be built with another value of a parameter, its gain within the limit unless told.

    Raises:
        CalculationError: no value keeps the gain within its limit.
    """
    spec, path = clutch.spec, ALIASES[name]
    about = keys()[path].about
    assert about is not None
    low, low_taken = about.low or 0.0, about.gt is None
    ends = [(math.inf, "")]
    if name == "C":
        low = float(clutch.gain_threshold or 0.0)
    if name == "z":
        low = float(spec.least_pairs)
    if name == "z1":
        ends.append((float(spec.friction_group.pairs - 1), say("one driven pair at least")))
    if name == "R":
        ends.append((_threshold_radius(clutch), say("the feedback ends, C = 2 R f_1/d")))
    if spec.kind.gain_limit is not None and not beyond_limit:
        end = _gain_limit(clutch, spec.kind.gain_limit, name)
        if about.whole and math.isfinite(end):
            end = float(math.floor(end * (1 + SAME)))
        rule = spec.kind.gain_limit.rule
        if end < low:
            raise CalculationError(
                say(
                    "no value of {name} keeps C = {gain:.6g} within the gain limit {rule} "
                    "(--beyond-limit goes past it)",
                    name=name,
                    gain=float(clutch.gain),
                    rule=rule,
                )
            )
        ends.append((end, say("the gain limit {rule}", rule=rule)))
    high, why = min(ends, key=lambda end: end[0])
    return Domain(low, low_taken, high, why)


def _gain_limit(clutch: Clutch, limit: GainLimit, name: str) -> float:
    """Largest value of a parameter at which the gain is within its limit; infinite where it plays no part."""
    most, gain = float(clutch.gain_limit or math.inf), float(clutch.gain)
    if name == "C":
        return most
    if gain == 0:
        return math.inf
    if name == "R" and angle_given(clutch.spec):
        return float(clutch.mean_radius) * most / gain
    pairs = float(limit.most(gain, clutch.friction[0].max))
    if name == "z" and limit.reduced is not None:
        return float(clutch.bypass_pairs) + pairs
    if name == "z1" and limit.reduced is None:
        return pairs
    return math.inf


def _threshold_radius(clutch: Clutch) -> float:
    """Largest R that leaves a feedback: 2 R f_1/d grows with it to the gain; with a wall angle the gain grows too."""
    if not clutch.gain_threshold or angle_given(clutch.spec):
        return math.inf
    end = float(clutch.mean_radius * clutch.gain / clutch.gain_threshold)
    while not _builds(clutch.spec, end):
        end = math.nextafter(end, 0.0)
    return end


def _builds(spec: Spec, radius: float) -> bool:
    try:
        build(with_key(spec, "friction_group.mean_radius", radius))
    except SpecError:
        return False
    return True
