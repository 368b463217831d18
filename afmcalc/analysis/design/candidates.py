"""Candidates of a design: the laws over arrays, asked piece by piece, each piece over no more axes than it needs."""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import numpy as np

from ...arrays import larger, smaller
from ...equations import adjustment, direct, geometry, synthesis
from ...spec.requirements import Requirements
from ...variants import Variant
from .room import never_meet
from .space import SAME, Axes, Mask, Numbers, balls


@dataclass(frozen=True)
class Candidates(ABC):
    """Candidates of a variant; the arrays of ``at`` broadcast, and so does every answer, in SI.

    The spring force is the least that gives the nominal torque, or the next of a catalogue: every law is
    proportional to it and nothing gets better with more of it.
    """

    need: Requirements
    variant: Variant
    at: Axes

    no_clutch: ClassVar[str]
    """Name under which candidates count that are no clutch, and under no other."""

    # per N of closing force, from the law
    @property
    @abstractmethod
    def at_set(self) -> Numbers:
        """Torque at the setting, m."""

    @property
    @abstractmethod
    def low(self) -> Numbers:
        """Torque at f_min, m."""

    @property
    @abstractmethod
    def high(self) -> Numbers:
        """Torque at f_max, m."""

    @property
    @abstractmethod
    def on_balls(self) -> Numbers:
        """Largest torque that passes the balls, m."""

    @property
    @abstractmethod
    def pack(self) -> Numbers:
        """Force that presses the pack at rest."""

    @property
    @abstractmethod
    def moved(self) -> Numbers:
        """Travel at f_max, m/N."""

    @property
    @abstractmethod
    def is_clutch(self) -> Mask:
        """Whether it can be built and adapts at all."""

    @cached_property
    def frictions(self) -> tuple[tuple[float, float], ...]:
        """(f_1, f_2) at the setting, at the smallest and at the largest friction."""
        first, second = self.need.friction.groups
        at_set = "mean" if self.need.wanted.method == "mean-friction" else "min"
        return tuple((getattr(first, name), getattr(second, name)) for name in (at_set, "min", "max"))

    @property
    def set_low(self) -> bool:
        """Whether the spring is set at f_min."""
        return self.frictions[0] == self.frictions[1]

    @cached_property
    def bypass_pairs(self) -> Numbers:
        """z_1."""
        driving = self.at.driving_pairs if self.variant.chooses_bypass else None
        return np.asarray(self.variant.bypass(self.at.pairs, driving), float)

    @cached_property
    def controlled_pairs(self) -> Numbers:
        """z_2."""
        return self.at.pairs - self.bypass_pairs

    @cached_property
    def gain(self) -> Numbers:
        """C."""
        found: Numbers
        if not self.variant.controlled:
            found = np.zeros(1)
        elif self.need.search.gain is not None:
            found = self.at.steering
        else:
            # r and α first: they are fewer than with R
            found = direct.gain(1.0, self.at.ball_circle_radius, self.tangent) * self.at.mean_radius
        return found

    @property
    def gain_limit(self) -> Numbers:
        """Largest C at which the law describes the whole slip; infinite where it always does."""
        limit, friction = self.variant.gain_limit, self.need.friction.groups[0].max
        if limit is None:
            return np.full(1, np.inf)
        return np.asarray(limit.gain(self.bypass_pairs, self.controlled_pairs, friction))

    @cached_property
    def tangent(self) -> Numbers:
        """tan α."""
        found: Numbers
        if self.need.search.gain is None:
            found = np.tan(self.at.steering)
        else:
            found = synthesis.tan_wall_angle(self.gain, self.at.ball_circle_radius, self.at.mean_radius)
        return found

    @cached_property
    def cosine(self) -> Numbers:
        """cos α."""
        found: Numbers = 1 / np.sqrt(1 + self.tangent * self.tangent)
        return found

    @cached_property
    def wanted_force(self) -> Numbers:
        """Closing force that gives the nominal torque, N."""
        found: Numbers = adjustment.closing_force(
            self.need.wanted.clutch_torque, self.need.wanted.in_spring, self.at_set
        )
        return found

    @cached_property
    def closing_force(self) -> Numbers:
        """F_п as set, N; where a catalogue has none the one wanted."""
        if self.need.search.closing_forces is None:
            return self.wanted_force
        listed = self.need.search.closing_forces.array()
        place = np.searchsorted(listed, self.wanted_force * (1 - SAME))
        return np.where(place < listed.size, listed[np.minimum(place, listed.size - 1)], self.wanted_force)

    @cached_property
    def pack_force(self) -> Numbers:
        """Force that presses the pack at rest, N."""
        return self.closing_force * self.pack

    @cached_property
    def nominal_torque(self) -> Numbers:
        """T_н, N·m."""
        found: Numbers = adjustment.nominal_torque(self.closing_force * self.at_set, self.need.wanted.in_spring)
        return found

    @cached_property
    def torque_max(self) -> Numbers:
        """Largest sustained torque, N·m."""
        return self.closing_force * larger(self.low, self.high)

    @cached_property
    def accuracy_factor(self) -> Numbers:
        """K_т."""
        found: Numbers = np.divide(larger(self.low, self.high), smaller(self.low, self.high))
        return found

    @cached_property
    def reduced_gain(self) -> Numbers:
        """Controlled pairs times gain."""
        found: Numbers = direct.reduced_gain(self.controlled_pairs, self.gain)
        return found

    @cached_property
    def face_width(self) -> Numbers:
        """Radial width of the friction faces, m; NaN where it is not known."""
        width = self.need.fixed.face_width
        return 2 * (self.at.mean_radius - self.at.inner_radius) if width is None else np.full(1, width)

    @cached_property
    def outer_diameter(self) -> Numbers:
        """Outer diameter of the friction faces, m; NaN where their width is not known."""
        return 2 * self.at.mean_radius + self.face_width

    @cached_property
    def surface_pressure(self) -> Numbers:
        """Mean surface pressure under the force at rest, Pa; NaN where the width of the faces is not known."""
        half = self.face_width / 2
        per_force = geometry.mean_pressure(1.0, self.at.mean_radius - half, self.at.mean_radius + half, np.pi)
        found: Numbers = self.pack_force * per_force
        return found

    @cached_property
    def force_per_ball(self) -> Numbers:
        """Normal force on one ball per torque, 1/m."""
        found: Numbers = synthesis.contact_force(1.0, self.need.fixed.balls, self.at.ball_circle_radius, self.cosine)
        return found

    @cached_property
    def ball_torque(self) -> Numbers:
        """Largest torque that passes the balls, N·m."""
        return self.closing_force * self.on_balls

    @cached_property
    def contact_force(self) -> Numbers:
        """Largest normal force on one ball, N."""
        return self.ball_torque * self.force_per_ball

    @property
    def most_per_ball(self) -> Numbers:
        """Largest force that any wall puts on a ball, per torque, 1/m."""
        return self.force_per_ball

    @cached_property
    def travel(self) -> Numbers:
        """Largest travel of the sleeve, m; 0 without one."""
        return self.closing_force * self.moved

    @cached_property
    def control_force(self) -> Numbers:
        """F_п2, N; NaN without a control spring."""
        return self.pack_force if self.variant.travels else np.full(1, np.nan)

    @cached_property
    def closing_deflection(self) -> Numbers:
        """F_п/c_1, m; NaN where the stiffness is not searched."""
        return self.closing_force / self.at.closing_stiffness

    @cached_property
    def control_deflection(self) -> Numbers:
        """F_п2/c_2, m: infinite for a constant force; NaN without a control spring."""
        return self.control_force / self.at.control_stiffness

    @cached_property
    def ball_pitch(self) -> Numbers:
        """Distance between neighbouring balls, m; of a single one the width to the other side of the axis."""
        sine = math.sin(math.pi / max(self.need.fixed.balls, 2))
        found: Numbers = synthesis.ball_pitch(self.at.ball_circle_radius, sine)
        return found

    @cached_property
    def largest_ball(self) -> Numbers:
        """Largest standard ball that has room beside its neighbour, and so has its pocket, m; 0 where none has."""
        listed, room = np.append(0.0, balls(self.need)), self.ball_pitch
        if self.variant.travels or not never_meet(self.need):
            # the mouth d/cos α − s tan α is to be narrower than the pitch
            room = np.minimum(room, (room + self.need.fixed.face_gap * self.tangent) * self.cosine)
        return listed[np.searchsorted(listed, room * (1 - SAME)) - 1]

    def travel_room(self, diameter: Numbers | float) -> Numbers:
        """Travel for which a ball is large enough, m: half of it goes off the clearance; no bound at gain 0."""
        fixed, sine = self.need.fixed, self.tangent * self.cosine
        left = synthesis.edge_clearance(diameter / 2, 0.0, fixed.face_gap, sine) - fixed.edge_clearance
        # gain 0 has no pockets to speak of
        return np.where(self.tangent > 0, 2 * left, np.inf)

    @property
    def ball_fits(self) -> Mask:
        """Whether a standard ball is large enough, and has room with its pocket."""
        return np.asarray(self.travel <= self.travel_room(self.largest_ball * (1 + SAME)))

    @property
    def gain_slope(self) -> Numbers:
        """C_1 of the pockets, 1/m."""
        return np.zeros(1)

    @cached_property
    def ball_needed(self) -> Numbers:
        """Diameter of the smallest ball that travel, gap and clearance allow, m; 0 at gain 0."""
        fixed, sine = self.need.fixed, self.tangent * self.cosine
        found = 2 * synthesis.ball_radius(self.travel, fixed.face_gap, fixed.edge_clearance, sine)
        return np.where(self.tangent > 0, found, 0.0)

    @cached_property
    def ball_diameter(self) -> Numbers:
        """Next standard ball, m; NaN at gain 0 and where there is none."""
        if not self.variant.controlled:
            return np.full(1, np.nan)
        listed = np.append(balls(self.need), np.nan)
        place = np.searchsorted(listed[:-1], self.ball_needed * (1 - SAME))
        found: Numbers = np.where(self.tangent > 0, listed[place], np.nan)
        return found
