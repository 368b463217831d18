"""A clutch with something of its law changed, its springs as they are set."""

from dataclasses import replace
from typing import TypeVar

from ...arrays import Values
from ...engines.laws import IndirectLaw
from ...engines.protocol import Clutch

C = TypeVar("C", bound=Clutch)


def held(clutch: C) -> C:
    """The clutch with its control spring, if it has one, as made: no change of the law sets it again."""
    if not isinstance(clutch.law, IndirectLaw):
        return clutch
    return replace(clutch, law=replace(clutch.law, made_control_force=clutch.control_force))


def weakened(clutch: C, loss: float) -> C:
    """The clutch with less force on its pack at rest, N."""
    own = held(clutch)
    if not isinstance(own.law, IndirectLaw):
        return replace(own, closing_force=own.closing_force - loss)
    assert own.law.made_control_force is not None
    return replace(own, law=replace(own.law, made_control_force=own.law.made_control_force - loss))


def with_gain(clutch: C, gain: float) -> C:
    """The clutch with another gain; where the key takes all of it, with as much as the key takes."""
    own = held(clutch)
    return replace(own, law=replace(own.law, gain=max(gain, float(clutch.gain_threshold or 0.0))))


def with_pairs(clutch: C, bypass: Values, controlled: Values) -> C:
    """The clutch with pairs that count in part."""
    own = held(clutch)
    if isinstance(own.law, IndirectLaw):
        return replace(own, law=replace(own.law, pairs=bypass + controlled))
    return replace(own, law=replace(own.law, bypass_pairs=bypass, controlled_pairs=controlled))
