"""What each law makes of candidates: torques, forces and travel per N of closing force."""

from dataclasses import replace
from functools import cached_property, reduce

import numpy as np

from ...engines.direct_law import DirectLaw
from ...engines.laws import IndirectLaw
from ...equations import synthesis, wall
from ...spec.requirements import Requirements
from ...variants import Variant
from .candidates import Candidates
from .space import SAME, Axes, Mask, Numbers, balls

_STEPS = 12
"""Newton's steps to the mouth of a pocket: each doubles the digits."""


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
    def low(self) -> Numbers:
        """Smallest torque, m."""
        return reduce(np.minimum, self._along)

    @cached_property
    def high(self) -> Numbers:
        """Largest torque, m."""
        return reduce(np.maximum, self._along)

    @cached_property
    def _along(self) -> list[Numbers]:
        """Torques where the extremes are: at the ends, of unlike materials also at the mean."""
        first, second = self.need.friction.groups
        means = [(first.mean, second.mean)] if self.need.friction.unlike else []
        return [np.asarray(self.law.torque_per_force(*point)) for point in (*self.frictions[1:], *means)]

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


class CurvedCandidates(IndirectCandidates):
    """Pockets whose curved wall holds the torque: C_1* goes with 1/F_п, so that torques stay proportional."""

    @cached_property
    def law(self) -> IndirectLaw:  # noqa: D102
        straight = super().law
        return replace(straight, gain_slope=straight.constant_torque_slope(1.0, self.frictions[2][0]))

    @cached_property
    def on_balls(self) -> Numbers:
        """It is held from the setting on."""
        return np.maximum(self.low, self.high)

    @cached_property
    def gain_slope(self) -> Numbers:  # noqa: D102
        return np.asarray(self.law.gain_slope / self.closing_force)

    @property
    def sleeves(self) -> int:
        """m, sleeves that the ball moves in."""
        return 2 if self.need.fixed.profiled == "both" else 1

    @cached_property
    def steepening(self) -> Numbers:
        """Y'', 1/m."""
        at = self.at
        return np.asarray(wall.path_steepening(self.gain_slope, at.ball_circle_radius, at.mean_radius, self.sleeves))

    @cached_property
    def tangent_max(self) -> Numbers:
        """tan α at the largest travel."""
        return np.asarray(wall.path_tangent(self.tangent, self.steepening, self.travel / self.sleeves))

    @cached_property
    def force_per_ball(self) -> Numbers:
        """Most at the largest travel: the torque is held and the wall is steepest."""
        cosine = 1 / np.sqrt(1 + self.tangent_max**2)
        return np.asarray(synthesis.contact_force(1.0, self.need.fixed.balls, self.at.ball_circle_radius, cosine))

    @property
    def most_per_ball(self) -> Numbers:
        """The seat in the other sleeve bears more than the curved wall."""
        if self.sleeves == 2:
            return self.force_per_ball
        most, own = np.arctan(self.tangent_max), np.arctan(self.tangent)
        return np.asarray(wall.seat_force(self.force_per_ball, np.sin(most + own), np.sin(own), np.cos(own)))

    @property
    def ball_fits(self) -> Mask:
        """Whether there is a ball that neither undercuts the wall nor has its pocket cut into the next."""
        return np.isfinite(self.ball_diameter)

    @cached_property
    def ball_diameter(self) -> Numbers:
        """Next standard ball, m; NaN where it undercuts the wall, or has no room."""
        fixed, listed = self.need.fixed, np.append(balls(self.need), np.nan)
        sine = np.sin(np.arctan(self.tangent_max))
        reach = 2 * self.travel / self.sleeves
        least = 2 * synthesis.ball_radius(reach, fixed.face_gap, fixed.edge_clearance, sine)
        found = listed[np.searchsorted(listed[:-1], least * (1 - SAME))]
        undercut = 2 * wall.path_radius(self.steepening, self.cosine)
        room = (found < undercut) & (found < self.ball_pitch) & (self._mouth(found) < self.ball_pitch)
        return np.where(room, found, np.nan)

    def _mouth(self, diameter: Numbers) -> Numbers:
        """Width of the pocket at the face, m: where the contact comes to it, by Newton's steps from beyond."""
        radius, gap = diameter / 2, self.need.fixed.face_gap
        depth = radius
        for _ in range(_STEPS):
            angle = np.arctan(wall.path_tangent(self.tangent, self.steepening, depth))
            left = wall.contact_depth(radius, np.sin(angle), depth, gap)
            depth = depth + left / (1 - radius * self.steepening * np.cos(angle) ** 3)
        around = wall.path(self.tangent, self.steepening, depth)
        return np.asarray(2 * wall.wall_around(around, radius, np.cos(angle)))


def candidates(need: Requirements, variant: Variant, at: Axes) -> Candidates:
    """Candidates of a variant."""
    if not variant.travels:
        return DirectCandidates(need, variant, at)
    return (IndirectCandidates if need.fixed.pocket is None else CurvedCandidates)(need, variant, at)
