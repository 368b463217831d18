"""Continuous refinement of a front: from each grid point to the best between the points, no objective given up.

One variable is left to search. Let u = tan α/r: at a given u, with the spring force the least that gives the nominal
torque, every objective and every bound but those that cap R or r from above gains from a larger R (the pack force
per torque is a line in 1/R, C = u R), a larger r (u holds C, so only the balls see it) and a larger c_1. Torque
and travel are fractions linear in c_2, so its ends follow from three values of the law. What is left is a search
over u: 1.7 ms a row for three objectives, where SciPy's SLSQP takes 9 ms for one objective from one start, and one
start in seven ends elsewhere.
"""

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np

from ...errors import given
from ...spec.requirements import Choice, Requirements
from ...variants import Variant
from .. import hertz
from .candidates import Candidates, candidates
from .limits import feasible, objectives
from .space import SAME, Axes, Mask, Numbers, curved, joined, searched

FIRST, LATER, ROUNDS = 256, 32, 10
"""Choice of u tried at first, and between the neighbours of the best in each later round."""
ROWS = 256
"""Candidates refined at once."""
_INSIDE = 1 - 5e-13
"""What is solved for aims at the middle of the slack that limits have."""
_FREE = ("mean_radius", "steering", "ball_circle_radius", "closing_stiffness", "control_stiffness")


@np.errstate(all="ignore")
def refined(
    need: Requirements, variant: Variant, at: Axes, progress: Callable[[int], None] = lambda done: None,
    *, ball_first: bool = False,
) -> Axes:  # fmt: skip
    """Move candidates between the grid points of the parameters that were given as ranges.

    Each objective in turn is made as small as it goes without a rise of the others. Whole numbers and lists stay; so
    do a spring force from a catalogue and pockets with a curved wall, and then all the rest.

    Candidates of the same number come out, each no worse than its own in any objective; ``progress`` is told how many
    are behind. With ``ball_first`` the ball, which comes in sizes, is made smaller too, before all else.
    """
    count = at.pairs.size
    between = any(choice.between for name, choice in searched(need, variant).items() if name in _FREE)
    if need.search.closing_force is None or curved(need, variant) or not between:
        return at
    parts = []
    for start in range(0, count, ROWS):
        parts.append(_Rows(need, variant, at.at(slice(start, start + ROWS))).best(ball_first))
        progress(min(start + ROWS, count))
    return joined(parts) if parts else at


class _Span(NamedTuple):
    """Smallest and largest value of a parameter, per candidate."""

    low: Numbers
    high: Numbers

    def holds(self, value: Numbers) -> Mask:
        return (value >= self.low * (1 - SAME)) & (value <= self.high * (1 + SAME))

    def clip(self, value: Numbers) -> Numbers:
        return np.clip(value, self.low, self.high)


class _Rows:
    """Candidates to refine, as columns; the values of u tried lie along the second axis."""

    def __init__(self, need: Requirements, variant: Variant, at: Axes) -> None:
        self.need, self.variant, self.candidates = need, variant, partial(candidates, need, variant)
        self.at = Axes(*(column[:, None] for column in at))
        choices = searched(need, variant)
        self.spans = {name: self._span(name, choices.get(name)) for name in _FREE}
        self.limit = objectives(self.candidates(self.at)) * (1 + SAME)
        self.by_gain = need.search.gain is not None

    def _span(self, name: str, choice: Choice | None) -> _Span:
        """Values that the search, and of the mean radii the outer diameter, allow."""
        column = getattr(self.at, name)
        if choice is None or not choice.between or (self.need.envelope and name == "ball_circle_radius"):
            return _Span(column, column)  # where it is to fit into a space, the largest ball circle is not the best
        low, high = np.full(column.shape, choice.start), np.full(column.shape, choice.stop)
        if name == "mean_radius":
            inner, outermost = self.at.inner_radius, self.need.faces_diameter / 2
            if self.need.search.mean_radius is None:
                radii = choice.array()
                low = (inner + radii[np.minimum(np.searchsorted(radii, inner, "right"), radii.size - 1)]) / 2
                high = (inner + min(choice.stop, outermost)) / 2
            else:
                high = np.minimum(high, outermost - (self.need.fixed.face_width or 0.0) / 2)
        return _Span(low, np.maximum(low, high))

    def best(self, ball_first: bool) -> Axes:
        """Make one objective after the other as small as it goes."""
        best = self.at
        for name in [*["ball_diameter"] * ball_first, *self.need.objectives]:
            if name not in ("pairs", "ball_diameter") or (ball_first and best is self.at):
                best = self._least(name, best)
                self.limit = np.minimum(self.limit, objectives(self.candidates(best)) * (1 + SAME))
        return Axes(*(column[:, 0] for column in best))

    def _least(self, goal: str, best: Axes) -> Axes:
        steering, radius, circle = (self.spans[name] for name in ("steering", "mean_radius", "ball_circle_radius"))
        low = self._steep(steering.low, radius.high, circle.high)
        high = self._steep(steering.high, radius.low, circle.low)
        reached = self._score(goal, best)[:, 0]
        steep = self._steep(best.steering, best.mean_radius, best.ball_circle_radius)
        for turn in range(ROUNDS):
            parts = np.linspace(0.0, 1.0, FIRST if turn == 0 else LATER)
            tried = np.concatenate([low + (high - low) * parts, steep], axis=1)
            at = self._placed(goal, tried)
            score = self._score(goal, at)
            choice = score.argmin(axis=1)
            row = np.arange(len(choice))
            better = score[row, choice] < reached
            reached = np.where(better, score[row, choice], reached)
            best = Axes(
                *(
                    np.where(better[:, None], np.broadcast_to(new, score.shape)[row, choice][:, None], old)
                    for new, old in zip(at, best, strict=True)
                )
            )
            steep = np.where(better[:, None], tried[row, choice][:, None], steep)
            low = np.where(tried < steep, tried, low).max(axis=1, keepdims=True)
            high = np.where(tried > steep, tried, high).min(axis=1, keepdims=True)
        return best

    def _score(self, goal: str, at: Axes) -> Numbers:
        """The objective (of a ball what it needs) where a candidate is feasible and gives nothing up, else infinite."""
        shape = np.broadcast_shapes(*(column.shape for column in at))
        tried = self.candidates(Axes(*(np.broadcast_to(column, shape) for column in at)))
        values = objectives(tried)
        good = feasible(tried, np.asarray((values <= self.limit).all(axis=-1)))
        aim = tried.ball_needed if goal == "ball_diameter" else values[..., self.need.objectives.index(goal)]
        return np.where(good, aim, np.inf)

    def _steep(self, steering: Numbers, radius: Numbers, circle: Numbers) -> Numbers:
        """u = tan α/r = C/R."""
        if not self.variant.controlled:
            return np.zeros_like(radius)
        return steering / radius if self.by_gain else np.tan(steering) / circle

    def _steering(self, steep: Numbers, radius: Numbers, circle: Numbers) -> Numbers:
        """Gain, or wall angle where the angle is searched."""
        return steep * radius if self.by_gain else np.arctan(steep * circle)

    def _placed(self, goal: str, steep: Numbers) -> Axes:
        """The best candidate at every u, NaN where a range does not reach there."""
        spans = self.spans
        steering, circle_span = spans["steering"], spans["ball_circle_radius"]
        radius, circle = spans["mean_radius"].high, circle_span.high
        if self.variant.controlled:
            radius = np.minimum(radius, np.where(steep > 0, self._largest_gain() / steep, np.inf))
            if not self.by_gain:
                circle = np.minimum(circle, np.where(steep > 0, np.tan(steering.high) / steep, np.inf))
        radius = np.minimum(radius, self._radius_of_least_force(steep))
        steer = self._steering(steep, radius, circle)
        within = spans["mean_radius"].holds(radius)
        if self.variant.controlled:
            within = within & steering.holds(steer) & circle_span.holds(circle)
        at = Axes(
            pairs=self.at.pairs,
            driving_pairs=self.at.driving_pairs,
            steering=steering.clip(steer),
            closing_stiffness=spans["closing_stiffness"].high,
            control_stiffness=self.at.control_stiffness,
            ball_circle_radius=circle_span.clip(circle),
            mean_radius=np.where(within, spans["mean_radius"].clip(radius), np.nan),
            inner_radius=self.at.inner_radius,
        )
        return self._sprung(goal, at) if self.variant.travels else at

    def _largest_gain(self) -> Numbers:
        """Largest C that its range, the limit of the variant and the one on z C allow."""
        rows, limits = self.candidates(self.at), self.need.limits
        highest = self.spans["steering"].high if self.by_gain else np.full(self.at.pairs.shape, np.inf)
        if limits.gain_limit:
            highest = np.minimum(highest, rows.gain_limit)
        if limits.reduced_gain is not None:
            highest = np.minimum(highest, limits.reduced_gain / rows.controlled_pairs)
        return highest

    def _radius_of_least_force(self, steep: Numbers) -> Numbers:
        """Largest R at which the pack force is not below its range: at a given u it is a line in 1/R."""
        span = given(self.need.search.closing_force)
        at_one, at_two = (
            self.candidates(self.at._replace(
                steering=self._steering(steep, radius, one), ball_circle_radius=one, mean_radius=radius
            )).pack_force
            for one in (np.ones(1),)
            for radius in (one, 2 * one)
        )  # fmt: skip
        slope, rest = 2 * (at_one - at_two), 2 * at_two - at_one
        return np.where(rest < span.min, slope / (span.min - rest) * _INSIDE, np.inf)

    def _sprung(self, goal: str, at: Axes) -> Axes:
        """Choose c_2: as small as travel, ball and deflection allow, or as large as torque, K_т and balls do."""
        span = self.spans["control_stiffness"]
        if (span.low == span.high).all():
            return at
        none = self.candidates(at._replace(control_stiffness=np.zeros(1)))
        some = self.candidates(at._replace(control_stiffness=at.closing_stiffness))
        # travel = x_0/(1 + m c_2), torque = (T_0 + T_∞ m c_2)/(1 + m c_2)
        per = (none.travel / some.travel - 1) / at.closing_stiffness
        if goal in ("travel", "control_deflection", "ball_diameter"):
            allowed, share = self._torque_allowed(none), per * at.closing_stiffness
            ordinary = (some.torque_max * (1 + share) - none.torque_max) / share
            most = (allowed - none.torque_max) / (per * (ordinary - allowed))
            chosen = np.where(ordinary > allowed, most, np.inf)
            if goal == "ball_diameter":
                chosen = np.minimum(chosen, self._of_least_ball(none, ordinary) / per)
        else:
            ball = np.minimum(self._most("ball_diameter"), none.largest_ball)
            most = np.minimum(self.need.limits.travel or np.inf, self._most("travel"))
            least = (none.travel / (np.minimum(most, none.travel_room(ball)) * _INSIDE) - 1) / per
            chosen = np.maximum(least, none.control_force / self._most("control_deflection") / _INSIDE)
        return at._replace(control_stiffness=span.clip(np.nan_to_num(chosen, nan=0.0)))

    def _of_least_ball(self, none: Candidates, ordinary: Numbers) -> Numbers:
        """m c_2 at which travel and force ask for the same ball: with more the force asks for a larger one.

        With t = 1/(1 + m c_2) the first is a line in t, and the square of the second another.
        """
        at_rest = none.ball_reaching - (growth := none.travel / (none.tangent * none.cosine))
        bears = np.inf if self.need.bearing is None else hertz.allowable_force(self.need.bearing, 0.5)
        slack, full = (none.force_per_ball / bears * each for each in (ordinary - none.torque_max, ordinary))
        half = growth * at_rest + slack / 2
        share = (np.sqrt(half**2 + growth**2 * (full - at_rest**2)) - half) / growth**2
        return np.where(share > 0, 1 / share - 1, np.inf)

    def _most(self, name: str) -> Numbers:
        """Largest value of an objective that gives nothing up; infinite where it is none."""
        aims = self.need.objectives
        return self.limit[..., aims.index(name)] if name in aims else np.full(self.at.pairs.shape, np.inf)

    def _torque_allowed(self, tried: Candidates) -> Numbers:
        wanted, limits = self.need.wanted, self.need.limits
        factor = np.minimum(self._most("accuracy_factor"), wanted.accuracy_factor or np.inf)
        most = min(wanted.torque_max or np.inf, self.need.shaft_torque)
        allowed = np.minimum(factor * tried.closing_force * tried.torques_per_force[0], most)
        contact = np.full(1, limits.contact_force or np.inf)
        if self.need.bearing is not None:
            ball = np.minimum(self._most("ball_diameter"), tried.largest_bearing_ball)
            contact = np.minimum(contact, hertz.allowable_force(self.need.bearing, ball / 2))
        return np.minimum(allowed, contact / tried.force_per_ball) * _INSIDE
