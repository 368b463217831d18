"""What each law makes of candidates: torques, forces and travel per N of closing force."""

from collections.abc import Iterator
from dataclasses import replace
from functools import cache, cached_property, reduce

import numpy as np

from ...engines.direct_law import DirectLaw
from ...engines.laws import IndirectLaw
from ...equations import synthesis, wall
from ...spec.contact import HARDENED_STEEL
from ...spec.requirements import Requirements
from ...variants import Variant
from .. import hertz
from .candidates import Candidates
from .space import SAME, Axes, Mask, Numbers, balls, given

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
    def torques(self) -> tuple[Numbers, Numbers]:
        """With unlike materials the path of both frictions may bend at their means."""
        low, high = super().torques
        if not self.need.friction.unlike:
            return low, high
        bend = np.asarray(self.law.torque_per_force(*(own.mean for own in self.need.friction.groups)))
        return np.minimum(low, bend), np.maximum(high, bend)

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
        return np.isfinite(self._next_ball(self.ball_reaching))

    @property
    def bears(self) -> Mask:
        """Whether a ball that fits bears its force, or none fits anyway."""
        return np.isfinite(self.ball_diameter) | ~self.ball_fits

    @cached_property
    def ball_reaching(self) -> Numbers:
        """Of the wall at the largest travel."""
        fixed, sine = self.need.fixed, np.sin(np.arctan(self.tangent_max))
        reach = 2 * self.travel / self.sleeves
        return np.asarray(2 * synthesis.ball_radius(reach, fixed.face_gap, fixed.edge_clearance, sine))

    @cached_property
    def ball_borne(self) -> Numbers:
        """Largest of what the stop, the largest travel and the flat seat ask for: between them less of it is used."""
        if self.need.contact is None:
            return np.zeros(1)
        bent = [2 * path * np.interp(share, *_bearing()[0], right=np.inf) for path, share in self._shares]
        seat = np.sqrt(self.ball_torque * self.most_per_ball / hertz.allowable_force(given(self.need.contact), 0.5))
        return np.maximum(np.maximum(*bent), seat)

    @property
    def _shares(self) -> Iterator[tuple[Numbers, Numbers]]:
        """Radius of the path at the stop and at the largest travel; root of the force over what such a ball bears."""
        for tangent in (self.tangent, self.tangent_max):
            cosine = 1 / np.sqrt(1 + tangent**2)
            path = wall.path_radius(self.steepening, cosine)
            force = synthesis.contact_force(self.ball_torque, self.need.fixed.balls, self.at.ball_circle_radius, cosine)
            yield path, np.sqrt(force / hertz.allowable_force(given(self.need.contact), path))

    @cached_property
    def ball_diameter(self) -> Numbers:
        """Next standard ball that bears its force, m; NaN where it undercuts the wall, or has no room."""
        found = self._next_ball(self.ball_needed)
        if self.need.contact is not None:
            # nearly as large as the path is bent, a ball bears less again
            for path, share in self._shares:
                found = np.where(found <= 2 * path * np.interp(-share, *_bearing()[1]), found, np.nan)
        return found

    def _next_ball(self, least: Numbers) -> Numbers:
        """Next standard ball, m; NaN where it undercuts the wall, or has no room."""
        listed = np.append(balls(self.need), np.nan)
        found = listed[np.searchsorted(listed[:-1], least * (1 - SAME))]
        undercut = 2 * wall.path_radius(self.steepening, self.cosine)
        room = (found < undercut) & (found < self.ball_room) & (self._mouth(found) < self.ball_pitch)
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


@cache
def _bearing() -> tuple[tuple[Numbers, Numbers], tuple[Numbers, Numbers]]:
    """Root of what balls bear on a path bent by 1, over a ball of radius 1 on a flat, and their radii.

    Up to the ball that bears most, then, negative, beyond it: both ascend, for interpolation (1e-9).
    """
    radii = np.linspace(0.0, 1.0, 8193)[1:-1]
    root = np.sqrt(hertz.allowable_force(HARDENED_STEEL, radii, 1.0) / hertz.allowable_force(HARDENED_STEEL, 1.0))
    top = int(np.argmax(root))
    return (np.append(0.0, root[: top + 1]), np.append(0.0, radii[: top + 1])), (-root[top:], radii[top:])


def candidates(need: Requirements, variant: Variant, at: Axes) -> Candidates:
    """Candidates of a variant."""
    if not variant.travels:
        return DirectCandidates(need, variant, at)
    return (IndirectCandidates if need.fixed.pocket is None else CurvedCandidates)(need, variant, at)
