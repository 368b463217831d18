"""What each law makes of candidates: torques, forces and travel per N of closing force."""

from functools import cached_property

import numpy as np

from ...engines.laws import DirectLaw, IndirectLaw
from ...spec.requirements import Requirements
from ...variants import Variant
from .candidates import Candidates
from .space import Axes, Mask, Numbers


class DirectCandidates(Candidates):
    """The release force acts on the pack itself."""

    no_clutch = "pairs"

    @cached_property
    def law(self) -> DirectLaw:
        """The law of all candidates."""
        return DirectLaw(self.at.mean_radius, self.bypass_pairs, self.controlled_pairs, self.gain)

    @cached_property
    def at_set(self) -> Numbers:  # noqa: D102
        return np.asarray(self.law.torque_per_force(*self.frictions[0]))

    @cached_property
    def low(self) -> Numbers:  # noqa: D102
        return self.at_set if self.set_low else np.asarray(self.law.torque_per_force(*self.frictions[1]))

    @cached_property
    def high(self) -> Numbers:  # noqa: D102
        return np.asarray(self.law.torque_per_force(*self.frictions[2]))

    @cached_property
    def on_balls(self) -> Numbers:
        """It grows with f_2, whatever the gain."""
        return np.asarray(self.law.ball_torque(1.0, self.frictions[2][1]))

    @cached_property
    def pack(self) -> Numbers:  # noqa: D102
        return np.ones(1)

    @cached_property
    def moved(self) -> Numbers:  # noqa: D102
        return np.zeros(1)

    @cached_property
    def is_clutch(self) -> Mask:  # noqa: D102
        return np.asarray(self.controlled_pairs > 0) if self.variant.controlled else np.ones(1, bool)


class IndirectCandidates(Candidates):
    """The release force moves a sleeve between two springs."""

    no_clutch = "gain_threshold"

    @cached_property
    def law(self) -> IndirectLaw:
        """The law of all candidates."""
        fixed, at = self.need.fixed, self.at
        assert fixed.key_friction is not None
        assert fixed.hub_diameter is not None
        return IndirectLaw(
            at.mean_radius, at.pairs, self.gain, at.closing_stiffness, at.control_stiffness,
            fixed.key_friction, fixed.hub_diameter, self.frictions[0][0],
        )  # fmt: skip

    @cached_property
    def at_set(self) -> Numbers:  # noqa: D102
        return np.asarray(self.law.torque_per_force)

    @cached_property
    def low(self) -> Numbers:  # noqa: D102
        return self.at_set if self.set_low else np.asarray(self.law.torque(1.0, self.frictions[1][0]))

    @cached_property
    def high(self) -> Numbers:  # noqa: D102
        return np.asarray(self.law.torque(1.0, self.frictions[2][0]))

    @cached_property
    def on_balls(self) -> Numbers:
        """All torque passes the balls, and it rises with friction."""
        return self.high

    @cached_property
    def pack(self) -> Numbers:  # noqa: D102
        return np.asarray(self.law.control_force(1.0))

    @cached_property
    def moved(self) -> Numbers:  # noqa: D102
        return np.asarray(self.law.travel(1.0, self.frictions[2][0]))

    @cached_property
    def is_clutch(self) -> Mask:  # noqa: D102
        return np.asarray(self.law.net_gain > 0)


def candidates(need: Requirements, variant: Variant, at: Axes) -> Candidates:
    """Candidates of a variant."""
    return (IndirectCandidates if variant.travels else DirectCandidates)(need, variant, at)
