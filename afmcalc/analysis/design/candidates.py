"""Candidates of a design: the laws over arrays, asked piece by piece, each piece over no more axes than it needs."""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import numpy as np

from ...equations import adjustment, direct, geometry, synthesis
from ...spec.requirements import Requirements
from ...variants import Variant
from .. import hertz
from .room import never_meet
from .space import SAME, Axes, Mask, Numbers, Places, balls, given


@dataclass(frozen=True)
class Candidates(ABC):
    """Candidates of a variant; the arrays of ``at`` broadcast, and so does every answer, in SI.

    The spring force is the least that gives the nominal torque, or the next of a catalogue: every law is
    proportional to it and nothing gets better with more of it.
    """

    need: Requirements
    variant: Variant
    at: Axes
    digits: int | None = None
    """Digits that the spring force is rounded up to; None: it is exact."""

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

    @cached_property
    def torques(self) -> tuple[Numbers, Numbers]:
        """Smallest and largest torque, m: the law rises or falls all the way."""
        return np.minimum(self.low, self.high), np.maximum(self.low, self.high)

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
            return self.wanted_force if self.digits is None else rounded(self.wanted_force, self.digits, up=True)
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
        return self.closing_force * self.torques[1]

    @cached_property
    def accuracy_factor(self) -> Numbers:
        """K_т."""
        smallest, largest = self.torques
        return np.asarray(largest / smallest)

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
    def peak_pressure(self) -> Numbers:
        """Surface pressure at the inner edge, which a friction material is held to, Pa; NaN as the mean."""
        half = self.face_width / 2
        found: Numbers = geometry.peak_pressure_uniform_wear(
            self.pack_force, self.at.mean_radius - half, self.at.mean_radius + half, np.pi
        )
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
    def ball_room(self) -> Numbers:
        """Diameter that a ball has room for beside its neighbour, and beside the hub of the sleeve, m."""
        if not self.variant.travels:
            return self.ball_pitch
        beside = 2 * self.at.ball_circle_radius - given(self.need.fixed.hub_diameter) * (1 - SAME)
        return np.minimum(self.ball_pitch, np.maximum(beside, 0.0))

    @cached_property
    def largest_ball(self) -> Numbers:
        """Largest standard ball that has room beside its neighbour, and so has its pocket, m; 0 where none has."""
        return np.append(0.0, balls(self.need))[self._places(mouths=self.variant.travels or not never_meet(self.need))]

    @cached_property
    def largest_bearing_ball(self) -> Numbers:
        """The same of a ball that is chosen for the force on it: its wall may be steeper than its travel asks for."""
        return np.append(0.0, balls(self.need))[self._places(mouths=True)]

    def _places(self, *, mouths: bool) -> Places:
        """How many standard balls have room beside each other, and beside the hub of the sleeve."""
        pitch, room = self.ball_pitch, self.ball_room
        if mouths:
            # the mouth d/cos α − s tan α is to be narrower than the pitch
            room = np.minimum(room, (pitch + self.need.fixed.face_gap * self.tangent) * self.cosine)
        return np.searchsorted(balls(self.need), room * (1 - SAME))

    @cached_property
    def ball_borne(self) -> Numbers:
        """Diameter of the smallest ball that bears its force on a flat wall, m; 0 at gain 0, where there are none."""
        if (contact := self.need.contact) is None:
            return np.zeros(1)
        # what a ball bears goes with its diameter squared
        return np.where(self.tangent > 0, np.sqrt(self.contact_force / hertz.allowable_force(contact, 0.5)), 0.0)

    @cached_property
    def contact_pressure(self) -> Numbers:
        """Contact pressure of the largest ball that has room, Pa; 0 at gain 0."""
        contact = given(self.need.contact)
        found = hertz.pressure(contact, self.contact_force, self.largest_bearing_ball / 2)
        return np.where(self.tangent > 0, found, 0.0)

    @property
    def bears(self) -> Mask:
        """Whether there is room for a standard ball that bears its force."""
        contact, listed = given(self.need.contact), np.append(0.0, balls(self.need))
        borne = np.asarray(hertz.allowable_force(contact, listed / 2)) * (1 + SAME)
        allowed = borne[self._places(mouths=True)] / self.most_per_ball
        return np.asarray(self.ball_torque <= np.where(self.tangent > 0, allowed, np.inf))

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
        """Diameter of the smallest ball that travel, gap, clearance and the force on it allow, m; 0 at gain 0."""
        return np.maximum(self.ball_reaching, self.ball_borne)

    @cached_property
    def ball_reaching(self) -> Numbers:
        """The same of travel, gap and clearance alone."""
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


def rounded(values: Numbers, digits: int, *, up: bool) -> Numbers:
    """Round up or down to so many significant digits; what is as round already stays."""
    size = 10.0 ** (digits - 1 - np.floor(np.log10(np.abs(values))))
    scaled = values * size
    whole = np.rint(scaled)
    near = np.where(np.abs(scaled - whole) <= 1e-12 * np.abs(whole), whole, np.ceil(scaled) if up else np.floor(scaled))
    found: Numbers = np.where(values == 0, 0.0, near / size)
    return found
