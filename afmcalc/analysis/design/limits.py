"""What every candidate must hold, and what it is judged by: one list for every way through the space."""

from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import partial, reduce
from operator import and_
from typing import NamedTuple

import numpy as np

from ...engines.layout import PartName, length_of
from ...engines.springs import QUASI_STATIC
from ...equations import pack
from ...errors import given
from ...spec.models import Room
from ...spec.requirements import Requirements
from ...variants import Variant
from ..registry import SpringKind
from ..springs.candidates import held
from .candidates import Candidates
from .space import SAME, Mask, Numbers, curved

OVER, UNDER = 1 + SAME, 1 - SAME


class Constraint(NamedTuple):
    """One bound; several may share a name, by which those who miss any of them are counted."""

    name: str
    value: Callable[[Candidates], Numbers] | None
    """What is bounded, SI; None where there is nothing to bargain for."""
    limit: float
    unit: str
    along_radius: tuple[int, int]
    """As R grows, at a given gain and at a given wall angle: 1 it comes to hold, −1 it ceases to, 0 neither.

    Where the spring force is a range, the gain is searched and no sleeve travels; or the angle is, and ``unimodal``.
    """
    at_least: bool = False
    test: Callable[[Candidates], Mask] | None = None
    """Whether candidates hold it, where that is not the value beside the limit."""

    def holds(self, tried: Candidates) -> Mask:
        """Whether candidates hold it; on the limit they do."""
        if self.test is not None:
            return self.test(tried)
        values = given(self.value)(tried)
        return values >= self.limit * UNDER if self.at_least else values <= self.limit * OVER

    @property
    def sense(self) -> str:
        """How the limit bounds the value."""
        return "at least" if self.at_least else "at most"


def constraints(need: Requirements, variant: Variant) -> list[Constraint]:
    """Every bound that the requirements put on a variant."""
    unit = _of_the_control_unit(need, variant) if variant.controlled else ()
    space = _of_space(need, variant) if need.envelope else ()
    return [*_bounds(need, variant), *unit, *space, *(_of_springs(need, variant) if need.springs else ())]


def _bounds(need: Requirements, variant: Variant) -> Iterable[Constraint]:
    wanted, limits, span = need.wanted, need.limits, need.search.closing_force
    if span is None:
        largest = float(given(need.search.closing_forces).array()[-1])
        yield Constraint("closing_force", lambda c: c.wanted_force, largest, "N", (0, 0))
    else:
        yield Constraint("closing_force", lambda c: c.pack_force, span.max, "N", (1, 1))
        yield Constraint("closing_force", lambda c: c.pack_force, span.min, "N", (-1, -1), at_least=True)
    if (factor := wanted.accuracy_factor) is not None:
        yield Constraint("accuracy_factor", lambda c: c.accuracy_factor, factor, "1", (0, 1))
    if (lasting := wanted.accuracy_factor_hysteresis) is not None:
        yield Constraint("accuracy_factor_hysteresis", lambda c: c.accuracy_factor_hysteresis, lasting, "1", (0, 1))
    if (cycles := wanted.cycles) is not None:
        yield Constraint("cycles", lambda c: c.cycles, cycles, "1", (0, 0), at_least=True)
    if (left := wanted.torque_after_wear) is not None and (variant.travels or need.springs is None):
        yield Constraint("torque_after_wear", lambda c: c.torque_after_wear, left, "N*m", (0, 0), at_least=True)
    if (torque := wanted.torque_max) is not None:
        yield Constraint("torque_max", lambda c: c.torque_max, torque, "N*m", (0, 1))
    if need.shaft_torque < np.inf:
        yield Constraint("shaft_yield", lambda c: c.torque_max, need.shaft_torque, "N*m", (0, 1))
    if (width := need.fixed.face_width) is not None:
        yield Constraint(
            "face_width", lambda c: c.at.mean_radius, width / 2, "m", (1, 1), at_least=True,
            test=lambda c: c.at.mean_radius > width / 2,
        )  # fmt: skip
    if (pressure := limits.surface_pressure) is not None:
        yield Constraint("surface_pressure", lambda c: c.surface_pressure, pressure, "Pa", (1, 1))
    if width is not None or need.search.inner_radius is not None:
        for material in need.friction.linings.values():
            # the lower end of the printed range, which a check warns beyond
            if (pressure := material.pressure_min) is not None:
                yield Constraint("material_pressure", lambda c: c.peak_pressure, pressure, "Pa", (1, 1))
    if (diameter := limits.outer_diameter) is not None:
        yield Constraint("outer_diameter", lambda c: c.outer_diameter, diameter, "m", (-1, -1))


def _of_the_control_unit(need: Requirements, variant: Variant) -> Iterable[Constraint]:
    limits = need.limits
    if limits.gain_limit and variant.gain_limit is not None:
        yield Constraint(
            "gain_limit", lambda c: c.gain / c.gain_limit, 1.0, "1", (0, -1),
            test=lambda c: c.gain <= c.gain_limit * (1 + 1e-9),
        )  # fmt: skip
    if (reduced := limits.reduced_gain) is not None:
        yield Constraint("reduced_gain", lambda c: pack.reduced_gain(c.controlled_pairs, c.gain), reduced, "1", (0, -1))
    if (force := limits.contact_force) is not None:
        yield Constraint(
            "contact_force", lambda c: c.ball_torque * c.force_per_ball, force, "N", (1, 1),
            test=lambda c: c.ball_torque <= force * OVER / c.force_per_ball,
        )  # fmt: skip
    if need.bearing is not None:
        straight = None if curved(need, variant) else lambda c: c.contact_pressure
        most = need.bearing.allowable_pressure
        yield Constraint("contact_pressure", straight, most, "Pa", (1, 1), test=lambda c: c.bears)
    # what a ball lacks in size: the largest that is listed or has room may differ from candidate to candidate
    yield Constraint(
        "standard_ball", lambda c: c.ball_reaching - c.largest_ball, 0.0, "m", (-1, int(variant.travels)),
        test=lambda c: c.ball_fits,
    )  # fmt: skip
    if variant.travels:
        hub = given(need.fixed.hub_diameter)
        yield Constraint(
            "hub_diameter", lambda c: 2 * c.at.mean_radius - np.nan_to_num(c.face_width), hub, "m", (1, 1),
            at_least=True,
        )  # fmt: skip
        if (travel := limits.travel) is not None:
            yield Constraint("travel", lambda c: c.travel, travel, "m", (0, 1))


_IN_THE_WAY: tuple[tuple[PartName, PartName], ...] = (
    ("hub", "pack"), ("hub", "balls"), ("pack", "balls"),
    ("pressure disc", "balls"), ("housing", "balls"), ("housing", "stop ring"),
)  # fmt: skip
"""Parts that may be in each other's way before springs are chosen: of any clutch, with balls, with a sleeve.

All others have room without the springs, or follow.
"""


def _of_space(need: Requirements, variant: Variant) -> Iterable[Constraint]:
    """The clutch has room in its housing, and its parts beside each other."""
    room = given(need.envelope)
    if (widest := room.outer_diameter) is not None:
        yield Constraint("housing_diameter", lambda c: c.outer_diameter + 2 * room.housing_wall, widest, "m", (0, 0))
    if (longest := room.length) is not None:
        yield Constraint("length", lambda c: np.asarray(length_of(c.layout)), longest, "m", (0, 0))
    for pair in _IN_THE_WAY[: 6 if variant.travels else 3 if variant.controlled else 1]:
        yield Constraint("_".join(pair).replace(" ", "_"), partial(Candidates.overlap, pair=pair), 0.0, "m", (0, 0))


def _of_springs(need: Requirements, variant: Variant) -> Iterable[Constraint]:
    """There are springs of the kind wanted that give force and stiffness, and bear travel and wear."""
    closing, control = need.fixed.closing_room or Room(), need.fixed.control_room or Room()
    kind: SpringKind = need.springs or "any"
    listed = need.lists.discs
    lining, cycles, left = (need.heat and need.heat.lining) or 0.0, need.wanted.cycles, need.wanted.torque_after_wear
    moves = cycles is None or cycles > QUASI_STATIC

    def slackens(c: Candidates) -> Mask:
        stroke = c.travel if moves else None
        return held(kind, listed, closing, c.closing_force, c.at.closing_stiffness, relaxes=c.travel, stroke=stroke)

    def presses(c: Candidates) -> Mask:
        return held(
            kind, listed, control, c.control_force, c.at.control_stiffness, relaxes=c.at.pairs * lining,
            compresses=c.travel, stroke=c.travel if moves else None,
        )  # fmt: skip

    def follows(c: Candidates) -> Mask:
        keeps = (left or 0.0) / (c.closing_force * c.torques_per_force[0])
        return held(kind, listed, closing, c.closing_force, relaxes=c.at.pairs * lining, keeps=keeps)

    if variant.travels:
        yield Constraint("closing_spring", None, 0.0, "", (0, 0), test=slackens)
        yield Constraint("control_spring", None, 0.0, "", (0, 0), test=presses)
    else:
        yield Constraint("closing_spring", None, 0.0, "", (0, 0), test=follows)


OBJECTIVES: dict[str, Callable[[Candidates], Numbers]] = {
    "closing_force": lambda c: c.pack_force,
    "accuracy_factor": lambda c: c.accuracy_factor,
    "pairs": lambda c: c.at.pairs,
    "ball_diameter": lambda c: np.nan_to_num(c.ball_diameter),
    "travel": lambda c: c.travel,
    "control_force": lambda c: np.nan_to_num(c.control_force),
    "closing_deflection": lambda c: np.nan_to_num(c.closing_deflection, posinf=np.inf),
    "control_deflection": lambda c: np.nan_to_num(c.control_deflection, posinf=np.inf),
}
"""What is to be small; what a variant does not have costs nothing."""


@np.errstate(all="ignore")
def objectives(tried: Candidates) -> Numbers:
    """One row per candidate, one column per objective."""
    columns = [OBJECTIVES[name](tried) for name in tried.need.objectives]
    # columns of their own in memory, rows to look at
    return np.moveaxis(np.stack(np.broadcast_arrays(*columns, tried.at.pairs)[:-1]), 0, -1)


def feasible(tried: Candidates, among: Mask) -> Mask:
    """Those of some candidates that hold every constraint; what costs most is asked of those that hold the others."""
    bounds = constraints(tried.need, tried.variant)
    good = reduce(and_, (bound.holds(tried) for bound in bounds if bound.value), among & tried.is_clutch)
    if good.any():
        few = replace(tried, at=tried.at.at(good))
        costly = (bound.holds(few) for bound in bounds if not bound.value)
        good[good] = reduce(and_, costly, np.ones(few.at.pairs.shape, bool))
    return good


def unimodal(need: Requirements) -> bool:
    """Whether K_т falls as the gain grows, all the way: beyond its limit unlike materials may turn T(f) round."""
    return need.limits.gain_limit or not need.friction.unlike


def never_worse(need: Requirements, variant: Variant) -> dict[str, int]:
    """Axes along which a feasible candidate never beats its larger (1) or its smaller (−1) neighbour, if that is too.

    Of 2·10⁶ indirect candidates by three objectives: 0.6 s, without 1.8 s.
    """
    angle, aims = need.search.gain is None, set(need.objectives)
    ways: dict[str, int] = {}
    if curved(need, variant):
        # a stiffer spring, a larger radius may want a wall that cannot be cut
        return ways
    if variant.controlled and not angle:
        # a gain knows no ball circle: but for the balls all are alike
        ways["ball_circle_radius"] = 1 if "ball_diameter" in aims else -1
    span = need.search.closing_force is not None
    by_gain = span and not variant.travels and "ball_diameter" not in aims
    # a given force loads the balls the more the larger R is: one that is chosen for that has to grow
    borne = need.bearing is not None and "ball_diameter" in aims
    by_angle = unimodal(need) and (span or not (variant.travels or borne))
    if by_angle if angle and variant.controlled else by_gain:
        ways["mean_radius"] = 1
    if variant.travels:
        ways["closing_stiffness"] = 1
        if not aims & {"ball_diameter", "travel", "control_deflection"}:
            ways["control_stiffness"] = -1
        elif not aims & {"accuracy_factor", "ball_diameter"}:
            ways["control_stiffness"] = 1
    return ways
