"""The life that a design is held against: with the peak that its own drive gives, where that is the larger."""

from typing import NamedTuple

from ...engines import build
from ...findings import Finding
from ...spec.edit import with_value
from ..answers import Answers
from ..life import LifeResult, life
from ..registry import ANALYSES
from ..simulate.result import SimulateResult


class Lasting(NamedTuple):
    """A life, and what its dynamic factor is from."""

    found: LifeResult
    said: list[Finding]
    simulated: bool
    """Whether the event loads the shaft more than the factor assumed."""


def lasting(answers: Answers, *, simulated: bool = True) -> Lasting:
    """Return the life of a clutch; the event, simulated, may load its unprotected side more than the factor assumed."""
    (found, said), clutch = answers.ask("life"), answers.clutch
    if not simulated or not ANALYSES["simulate"].applies(clutch):
        return Lasting(found, said, False)
    if "dynamic-factor-exceeded" not in {each.code for each in answers.ask("simulate")[1]}:
        return Lasting(found, said, False)
    factor = max(vars(answers.of(SimulateResult).dynamic_factor).values())
    loaded = build(with_value(clutch.spec, ("drive", "dynamic_factor"), factor))
    return Lasting(*life(loaded, found.model), True)
