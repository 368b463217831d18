"""Candidates of a design: each law over arrays, asked piece by piece, each piece over no more axes than it needs."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache, cached_property, reduce
from typing import Any

import numpy as np

from ...engines.layout import TOUCHES, PartName, SectionPart, Sizes, overlap, parts_of
from ...engines.quantities import Quantities
from ...engines.selection import as_set, laws_for
from ...equations import adjustment, control_unit, curved_wall, direct, pack, pressure
from ...equations.effects import force_lost_by_wear
from ...errors import given
from ...spec.models import bore_of
from ...spec.requirements import Requirements
from ...variants import Variant
from .. import hertz
from ..life import life_of
from .space import SAME, Axes, Mask, Numbers, Places, balls, curved

_gain: Any = pack.WALL_ANGLE_GIVEN["gain"]
_driven_torque: Any = direct.ALL_DRIVING["driven_torque"]
_peak_pressure: Any = pressure.UNIFORM_WEAR["peak_pressure"]
_NEWTON_STEPS = 12
"""To the mouth of a pocket: each doubles the digits."""
_MOST_CIRCLES = 10_000
"""Ball circles beyond which it is not asked beforehand whether pockets can meet at all."""


def candidates(need: Requirements, variant: Variant, at: Axes) -> "Candidates":
    """Candidates of a variant."""
    return (CurvedCandidates if curved(need, variant) else Candidates)(need, variant, at)


@dataclass(frozen=True)
class Candidates:
    """Candidates of a variant; the arrays of ``at`` broadcast, and so does every answer, in SI.

    The spring force is the least that gives the nominal torque, or the next of a catalogue: every law is
    proportional to it and nothing gets better with more of it. What ends in ``_per_force`` is per N of it.
    """

    need: Requirements
    variant: Variant
    at: Axes
    digits: int | None = None
    """Digits that the spring force is rounded up to; None: it is exact."""

    @cached_property
    def law(self) -> Quantities:
        """All candidates as one clutch, its closing force 1 N."""
        at, need, keys = self.at, self.need, set[str]()
        own = {
            "closing_force": 1.0, "mean_radius": at.mean_radius, "pairs": at.pairs, "bypass_pairs": self.bypass_pairs,
            "gain": self.gain,
        }  # fmt: skip
        groups = ("_driving", "_driven") if need.friction.unlike else ("",)
        for group, friction in zip(groups, need.friction.groups, strict=False):
            own |= {f"friction{group}_{end}": value for end, value in friction._asdict().items()}
        if need.friction.unlike:
            keys.add("friction_driving_min")
        if self.variant.travels:
            own |= {"closing_stiffness": at.closing_stiffness, "control_stiffness": at.control_stiffness}
            own |= {name: given(getattr(need.fixed, name)) for name in ("key_friction", "hub_diameter")}
            # the wall that holds the torque goes with 1/F_п, so that torques stay proportional
            keys |= {need.fixed.pocket} if need.fixed.pocket else set()
        return Quantities(laws_for(self.variant.name, need.wanted.method, frozenset(keys)), own)

    def _slipping(self, point: tuple[float, float], law: Quantities | None = None) -> Quantities:
        """Quantities at f_1 and f_2."""
        law = law or self.law
        if self.variant.travels:
            return law.at(friction=point[0])
        return law.at(friction_driving=point[0], friction_driven=point[1])

    @cached_property
    def torque_per_force(self) -> Numbers:
        """Torque at the setting, m."""
        return np.asarray(self.law["torque_per_force_at_setting"])

    @cached_property
    def torques_per_force(self) -> tuple[Numbers, Numbers]:
        """Smallest and largest torque, m: at the ends of the friction; of unlike materials also where both are mean."""
        at_set, *points = self.frictions
        if self.need.friction.unlike:
            first, second = self.need.friction.groups
            points.append((first.mean, second.mean))
        torques = [self.torque_per_force if point == at_set else self._slipping(point)["torque"] for point in points]
        return reduce(np.minimum, torques), reduce(np.maximum, torques)

    @property
    def no_clutch(self) -> str:
        """Name under which candidates count that are no clutch, and under no other."""
        return "gain_threshold" if self.variant.travels else "pairs"

    @cached_property
    def is_clutch(self) -> Mask:
        """Whether it can be built and adapts at all."""
        if self.variant.travels:
            return np.asarray(self.law["net_gain"] > 0)
        return self.controlled_pairs > 0 if self.variant.controlled else np.ones(1, bool)

    @cached_property
    def frictions(self) -> tuple[tuple[float, float], ...]:
        """(f_1, f_2) at the setting, at the smallest and at the largest friction."""
        first, second = self.need.friction.groups
        at_set = "mean" if self.need.wanted.method == "mean-friction" else "min"
        return tuple((getattr(first, name), getattr(second, name)) for name in (at_set, "min", "max"))

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
        if not self.variant.controlled:
            return np.zeros(1)
        if self.need.search.gain is not None:
            return self.at.steering
        # r and α first: they are fewer than with R
        return _gain(1.0, self.at.ball_circle_radius, self.tangent) * self.at.mean_radius

    @property
    def gain_limit(self) -> Numbers:
        """Largest C at which the law describes the whole slip; infinite where it always does."""
        limit, friction = self.variant.gain_limit, self.need.friction.groups[0].max
        if limit is None:
            return np.full(1, np.inf)
        return np.asarray(limit.gain(self.bypass_pairs, self.controlled_pairs, friction))

    @property
    def gain_slope(self) -> Numbers:
        """C_1 of the pockets, 1/m."""
        return self.law["gain_slope"] / self.closing_force if "gain_slope" in self.law else np.zeros(1)

    @cached_property
    def tangent(self) -> Numbers:
        """tan α."""
        if self.need.search.gain is None:
            return np.tan(self.at.steering)
        return pack.tan_wall_angle(self.gain, self.at.ball_circle_radius, self.at.mean_radius)

    @cached_property
    def cosine(self) -> Numbers:
        """cos α."""
        return 1 / np.sqrt(1 + self.tangent * self.tangent)

    @cached_property
    def wanted_force(self) -> Numbers:
        """Closing force that gives the nominal torque, N."""
        return adjustment.closing_force(self.need.clutch_torque, self.need.wanted.in_spring, self.torque_per_force)

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
        return self.closing_force * self.law["pack_force_at_rest"]

    @cached_property
    def nominal_torque(self) -> Numbers:
        """T_н, N·m."""
        return adjustment.nominal_torque(self.closing_force * self.torque_per_force, self.need.wanted.in_spring)

    @cached_property
    def torque_max(self) -> Numbers:
        """Largest sustained torque, N·m."""
        return self.closing_force * self.torques_per_force[1]

    @cached_property
    def accuracy_factor(self) -> Numbers:
        """K_т."""
        smallest, largest = self.torques_per_force
        return largest / smallest

    @cached_property
    def accuracy_factor_hysteresis(self) -> Numbers:
        """K_т,h; K_т of a direct clutch."""
        law, built = self.law, self.is_clutch
        if not self.variant.travels:
            return self.accuracy_factor
        if "gain_slope" in law:  # what is no clutch may have no number to compare
            gain = np.where(built, law["gain"], law["gain_threshold"] + 1)
            law = law.at(gain=gain, gain_slope=np.where(built, law["gain_slope"], 0.0))
        return np.asarray(law["accuracy_factor_hysteresis"])

    @cached_property
    def cycles(self) -> Numbers:
        """Life of the side that fails first, springs as set; infinite where fatigue sets it no limit.

        Where an event gives the dynamic factor, of the protected side alone: the other is known when it is simulated.
        """
        ends = (self.closing_force * each for each in self.torques_per_force)
        least, most = (np.where(np.isfinite(torque), torque, np.nan) for torque in ends)
        return life_of(self.need, least, most)

    @cached_property
    def torque_after_wear(self) -> Numbers:
        """Least torque in service with the lining worn off, N·m; 0 where that takes all of the force."""
        at, lining, rest = self.at, given(given(self.need.heat).lining), self.law["pack_force_at_rest"]
        spring = "control_force_made" if self.variant.travels else "closing_force"
        stiffness = at.control_stiffness if self.variant.travels else at.closing_stiffness
        loss = force_lost_by_wear(stiffness, at.pairs, lining) / self.closing_force
        worn, points = as_set(self.law, **{spring: rest - loss}), zip(*self.need.friction.groups, strict=True)
        torque = reduce(np.minimum, (self._slipping(point, worn)["torque"] for point in points))
        return np.where(loss < rest, self.closing_force * torque, 0.0)

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
        per_force = pressure.mean_pressure(1.0, self.at.mean_radius - half, self.at.mean_radius + half)
        return self.pack_force * per_force

    @cached_property
    def peak_pressure(self) -> Numbers:
        """Surface pressure at the inner edge, which a friction material is held to, Pa; NaN as the mean."""
        half, mean = self.face_width / 2, self.at.mean_radius
        return _peak_pressure(self.pack_force, mean - half, mean + half)

    @cached_property
    def force_per_ball(self) -> Numbers:
        """Normal force on one ball per torque, 1/m."""
        return control_unit.contact_force(1.0, self.need.fixed.balls, self.at.ball_circle_radius, self.cosine)

    @cached_property
    def ball_torque(self) -> Numbers:
        """Largest torque that passes the balls, N·m: it grows with f_2, whatever the gain; with a sleeve it is all."""
        if self.variant.travels:
            return self.torque_max
        pressed, driven = self._slipping(self.frictions[2])["normal_force"], self.frictions[2][1]
        return self.closing_force * _driven_torque(pressed, self.at.mean_radius, self.controlled_pairs, driven)

    @cached_property
    def contact_force(self) -> Numbers:
        """Largest normal force on one ball, N."""
        return self.ball_torque * self.force_per_ball

    @cached_property
    def travel(self) -> Numbers:
        """Largest travel of the sleeve, m; 0 without one."""
        return self.closing_force * self.law["travel_max"] if self.variant.travels else np.zeros(1)

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
        return control_unit.ball_pitch(self.at.ball_circle_radius, math.sin(math.pi / max(self.need.fixed.balls, 2)))

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
        return self._listed[self._places(mouths=self.variant.travels or not never_meet(self.need))]

    @cached_property
    def largest_bearing_ball(self) -> Numbers:
        """The same of a ball that is chosen for the force on it: its wall may be steeper than its travel asks for."""
        return self._listed[self._places(mouths=True)]

    @property
    def _listed(self) -> Numbers:
        return np.append(0.0, balls(self.need))

    def _places(self, *, mouths: bool) -> Places:
        """How many standard balls have room beside each other, and beside the hub of the sleeve."""
        room = self.ball_room
        if mouths:
            # the mouth d/cos α − s tan α is to be narrower than the pitch
            room = np.minimum(room, (self.ball_pitch + self.need.fixed.face_gap * self.tangent) * self.cosine)
        return np.searchsorted(balls(self.need), room * (1 - SAME))

    @property
    def bears(self) -> Mask:
        """Whether there is room for a standard ball that bears its force."""
        # of each listed ball first: they are fewer
        borne = np.asarray(hertz.allowable_force(given(self.need.bearing), self._listed / 2)) * (1 + SAME)
        allowed = borne[self._places(mouths=True)] / self.force_per_ball
        return self.ball_torque <= np.where(self.tangent > 0, allowed, np.inf)

    @cached_property
    def contact_pressure(self) -> Numbers:
        """Contact pressure of the largest ball that has room, Pa; 0 at gain 0."""
        pressure = hertz.pressure(given(self.need.bearing), self.contact_force, self.largest_bearing_ball / 2)
        return np.where(self.tangent > 0, pressure, 0.0)

    def travel_room(self, diameter: Numbers | float) -> Numbers:
        """Travel for which a ball is large enough, m: half of it goes off the clearance; no bound at gain 0."""
        fixed, sine = self.need.fixed, self.tangent * self.cosine
        left = control_unit.edge_clearance_standard(diameter / 2, 0.0, fixed.face_gap, sine) - fixed.edge_clearance
        # gain 0 has no pockets to speak of
        return np.where(self.tangent > 0, 2 * left, np.inf)

    @property
    def ball_fits(self) -> Mask:
        """Whether a standard ball is large enough, and has room with its pocket."""
        return self.travel <= self.travel_room(self.largest_ball * (1 + SAME))

    @cached_property
    def ball_reaching(self) -> Numbers:
        """Diameter of the smallest ball that travel, gap and clearance allow, m; 0 at gain 0."""
        fixed, sine = self.need.fixed, self.tangent * self.cosine
        radius = control_unit.ball_radius(self.travel, fixed.face_gap, fixed.edge_clearance, sine)
        return np.where(self.tangent > 0, 2 * radius, 0.0)

    @cached_property
    def ball_borne(self) -> Numbers:
        """Diameter of the smallest ball that bears its force on a flat wall, m; 0 at gain 0, where there are none."""
        if (contact := self.need.bearing) is None:
            return np.zeros(1)
        # what a ball bears goes with its diameter squared
        return np.where(self.tangent > 0, np.sqrt(self.contact_force / hertz.allowable_force(contact, 0.5)), 0.0)

    @cached_property
    def ball_needed(self) -> Numbers:
        """Diameter of the smallest ball that travel, gap, clearance and the force on it allow, m; 0 at gain 0."""
        return np.maximum(self.ball_reaching, self.ball_borne)

    @cached_property
    def ball_diameter(self) -> Numbers:
        """Next standard ball, m; NaN at gain 0 and where there is none."""
        if not self.variant.controlled:
            return np.full(1, np.nan)
        return np.where(self.tangent > 0, self._next_listed(self.ball_needed), np.nan)

    @cached_property
    def layout(self) -> list[SectionPart]:
        """Parts in half section, without the springs, which are chosen later."""
        at, fixed, room = self.at, self.need.fixed, given(self.need.envelope)
        ball, circle = np.nan_to_num(self.ball_diameter), np.nan_to_num(at.ball_circle_radius)
        half = self.face_width / 2
        return parts_of(
            Sizes(
                self.variant.travels, at.pairs, at.mean_radius - half, at.mean_radius + half, bore_of(self.need) / 2,
                given(self.need.hub_diameter) / 2, room.disc_thickness, room.plate_thickness, room.housing_wall,
                ball, fixed.balls, circle, fixed.face_gap, travel=self.travel,
            )
        )  # fmt: skip

    def overlap(self, pair: tuple[PartName, PartName]) -> Numbers:
        """By how much two parts are in each other's way, m: ≤ 0 where they are not, 0 where they touch."""
        first, second = (next(part for part in self.layout if part.name == name) for name in pair)
        missing = np.asarray(overlap(first, second))
        return np.where(np.abs(missing) <= TOUCHES, 0.0, missing)

    def _next_listed(self, least: Numbers) -> Numbers:
        """Next standard ball, m; NaN where there is none."""
        listed = np.append(balls(self.need), np.nan)
        return listed[np.searchsorted(listed[:-1], least * (1 - SAME))]


class CurvedCandidates(Candidates):
    """Candidates with pockets whose curved wall holds the torque."""

    @cached_property
    def steepening(self) -> Numbers:
        """Y'', 1/m."""
        return curved_wall.path_steepening(self.gain_slope, self.at.ball_circle_radius, self.at.mean_radius)

    @cached_property
    def tangent_max(self) -> Numbers:
        """tan α at the largest travel."""
        return curved_wall.tan_wall_angle_at_ball(self.tangent, self.steepening, self.travel)

    @cached_property
    def force_per_ball(self) -> Numbers:
        """Most at the largest travel: the torque is held and the wall is steepest."""
        cosine = 1 / np.sqrt(1 + self.tangent_max**2)
        return control_unit.contact_force(1.0, self.need.fixed.balls, self.at.ball_circle_radius, cosine)

    @property
    def ball_fits(self) -> Mask:
        """Whether there is a ball that neither undercuts the wall nor has its pocket cut into the next."""
        return np.isfinite(self._next_fitting(self.ball_reaching))

    @property
    def bears(self) -> Mask:
        """Whether a ball that fits bears its force, or none fits anyway."""
        return np.isfinite(self.ball_diameter) | ~self.ball_fits

    @cached_property
    def ball_reaching(self) -> Numbers:
        """Of the wall at the largest travel."""
        fixed, sine = self.need.fixed, np.sin(np.arctan(self.tangent_max))
        return 2 * control_unit.ball_radius(2 * self.travel, fixed.face_gap, fixed.edge_clearance, sine)

    @cached_property
    def ball_borne(self) -> Numbers:
        """Larger of what the stop and the largest travel ask for: between them less of it is used."""
        if self.need.bearing is None:
            return np.zeros(1)
        return np.maximum(*(2 * path * _bearing(share)[0] for path, share in self._shares))

    @property
    def _shares(self) -> Iterator[tuple[Numbers, Numbers]]:
        """Radius of the path at the stop and at the largest travel; root of the force over what such a ball bears."""
        for tangent in (self.tangent, self.tangent_max):
            cosine = 1 / np.sqrt(1 + tangent**2)
            path = curved_wall.undercut_radius(self.steepening, cosine)
            force = control_unit.contact_force(
                self.ball_torque, self.need.fixed.balls, self.at.ball_circle_radius, cosine
            )
            yield path, np.sqrt(force / hertz.allowable_force(given(self.need.bearing), path))

    @cached_property
    def ball_diameter(self) -> Numbers:
        """Next standard ball, m; NaN where it undercuts the wall, or has no room."""
        diameter = self._next_fitting(self.ball_needed)
        if self.need.bearing is not None:
            # nearly as large as the path is bent, a ball bears less again
            for path, share in self._shares:
                diameter = np.where(diameter <= 2 * path * _bearing(share)[1], diameter, np.nan)
        return diameter

    def _next_fitting(self, least: Numbers) -> Numbers:
        """Next standard ball, m; NaN where it undercuts the wall, or has no room."""
        diameter = self._next_listed(least)
        undercut = 2 * curved_wall.undercut_radius(self.steepening, self.cosine)
        room = (diameter < undercut) & (diameter < self.ball_room) & (self._mouth(diameter) < self.ball_pitch)
        return np.where(room, diameter, np.nan)

    def _mouth(self, diameter: Numbers) -> Numbers:
        """Width of the pocket at the face, m: where the contact comes to it, by Newton's steps from beyond."""
        radius, gap = diameter / 2, self.need.fixed.face_gap
        depth = radius
        for _ in range(_NEWTON_STEPS):
            angle = np.arctan(curved_wall.tan_wall_angle_at_ball(self.tangent, self.steepening, depth))
            left = -curved_wall.wall_axial(depth, radius, angle) - gap / 2
            depth = depth + left / (1 - radius * self.steepening * np.cos(angle) ** 3)
        around = curved_wall.path_around(self.tangent, self.steepening, depth)
        return 2 * curved_wall.wall_around(around, radius, angle)


def _bearing(share: Numbers) -> tuple[Numbers, Numbers]:
    """Least and largest radius of a ball that bears a force on a path bent by 1; infinite and NaN where none does.

    ``share``: root of the force over what a ball of radius 1 bears on a flat, R_e: 2 r² − (2 + share) r + 2 share = 0.
    """
    half = 2 + share
    with np.errstate(invalid="ignore"):
        root = np.sqrt(half * half - 16 * share)
    return np.where(np.isnan(root), np.inf, 4 * share / (half + root)), (half + root) / 4


@cache
@np.errstate(all="ignore")
def never_meet(need: Requirements) -> bool:
    """Whether nowhere in the space pockets meet whose balls do not: a mouth is widest where the wall is flattest.

    Of direct clutches only: where a sleeve travels, a ball stands for many wall angles.
    """
    circles = given(need.search.ball_circle_radius)
    if circles.size > _MOST_CIRCLES or need.fixed.balls < 2:
        return need.fixed.balls < 2
    fixed, listed = need.fixed, balls(need)
    circle = circles.array()[:, None]
    if need.search.gain is None:
        steepest = math.tan(given(need.search.wall_angle).array()[-1])
    else:
        # no mean radius is smaller
        outer = need.search.radii.array()[0]
        inner = outer if need.search.inner_radius is None else need.search.inner_radius.array()[0]
        steepest = given(need.search.gain).array()[-1] * circle / ((max(inner, outer) + inner) / 2)
    pitch = control_unit.ball_pitch(circle, math.sin(math.pi / fixed.balls))
    needed = fixed.face_gap + 2 * fixed.edge_clearance
    # a ball is the next standard one down to where the one before it would do
    sine = np.minimum(needed / np.concatenate([[SAME], listed[:-1]]), 1 - SAME)
    tangent = np.minimum(sine / np.sqrt(1 - sine**2), steepest)
    depth = control_unit.pocket_depth(listed / 2, tangent / np.sqrt(1 + tangent * tangent), fixed.face_gap)
    mouth = control_unit.pocket_width(depth, tangent)
    return not ((listed < pitch) & (listed >= needed) & (mouth >= pitch * (1 - SAME))).any()


def rounded(values: Numbers, digits: int, *, up: bool) -> Numbers:
    """Round up or down to so many significant digits; what is as round already stays."""
    size = 10.0 ** (digits - 1 - np.floor(np.log10(np.abs(values))))
    scaled = values * size
    whole = np.rint(scaled)
    near = np.where(np.abs(scaled - whole) <= 1e-12 * np.abs(whole), whole, np.ceil(scaled) if up else np.floor(scaled))
    return np.where(values == 0, 0.0, near / size)
