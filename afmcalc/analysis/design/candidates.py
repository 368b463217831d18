"""Candidates of a design: their laws over arrays, the constraints they must hold, the objectives they are judged by."""

import math
from collections.abc import Mapping
from functools import cache
from typing import Any, NamedTuple

from ...arrays import larger, smaller
from ...engines.laws import IndirectLaw
from ...equations import direct, geometry, synthesis
from ...spec.requirements import Choices, Requirements

SAME = 1e-12
"""Relative slack of every limit: a candidate on the limit holds it."""


class Axes(NamedTuple):
    """Values searched for one variant, in this order; an axis the variant does not have holds one NaN."""

    pairs: Any
    driving_pairs: Any
    gain: Any
    """Gain, or wall angle where the angle is searched."""
    closing_stiffness: Any
    control_stiffness: Any
    ball_circle_radius: Any
    mean_radius: Any


class State(NamedTuple):
    """Candidates evaluated, SI; arrays of one shape."""

    gain: Any
    closing_force: Any
    accuracy_factor: Any
    nominal_torque: Any
    torque_max: Any
    ball_diameter: Any
    travel: Any
    contact_force: Any
    surface_pressure: Any
    excluded: dict[str, Any]
    """Constraint → which candidates it excludes."""


def counts(need: Requirements, variant: str) -> list[int]:
    """Sizes of the axes of a variant, without laying them out; the number of catalogue forces last."""
    search = need.search
    controlled, springs = variant != "conventional", variant == "indirect"
    gain = search.gain or search.wall_angle
    forces = search.closing_forces
    return [
        search.pairs.size,
        search.driving_pairs.size if variant == "differentiated" else 1,
        _given(gain).size if controlled else 1,
        _given(search.closing_stiffness).size if springs else 1,
        _given(search.control_stiffness).size if springs else 1,
        _given(search.ball_circle_radius).size if controlled else 1,
        search.mean_radius.size,
        1 if forces is None else forces.size,
    ]


def _given(values: Choices | None) -> Choices:
    """Values that the rules of the requirements ask for."""
    assert values is not None
    return values


def axes(need: Requirements, variant: str) -> Axes:
    """Lay out the axes of a variant."""
    import numpy as np

    search, none = need.search, np.array([np.nan])
    controlled, springs = variant != "conventional", variant == "indirect"
    return Axes(
        pairs=search.pairs.array(),
        driving_pairs=search.driving_pairs.array() if variant == "differentiated" else none,
        gain=_given(search.gain or search.wall_angle).array() if controlled else none,
        closing_stiffness=_given(search.closing_stiffness).array() if springs else none,
        control_stiffness=_given(search.control_stiffness).array() if springs else none,
        ball_circle_radius=_given(search.ball_circle_radius).array() if controlled else none,
        mean_radius=search.mean_radius.array(),
    )


@cache
def _shipped() -> tuple[float, ...]:
    from ...spec.balls import diameters

    return tuple(diameters())


def balls(need: Requirements) -> Any:
    """Standard ball diameters to choose from, ascending, m."""
    import numpy as np

    given = need.search.ball_diameters
    return np.array(_shipped()) if given is None else given.array()


def groups(variant: str, pairs: Any, driving_pairs: Any) -> tuple[Any, Any]:
    """z_1 and z_2 of the one direct law."""
    if variant == "conventional":
        return pairs, 0.0 * pairs
    bypass = driving_pairs if variant == "differentiated" else 0.0 * pairs
    return bypass, pairs - bypass


def evaluate(need: Requirements, variant: str, at: Axes) -> State:
    """Evaluate candidates, one per element of the (equally long) arrays in ``at``."""
    import numpy as np

    with np.errstate(all="ignore"):
        return _evaluate(need, variant, at)


def _evaluate(need: Requirements, variant: str, at: Axes) -> State:
    import numpy as np

    radius, limits, fixed = at.mean_radius, need.limits, need.fixed
    gain, tangent = _gain(need, variant, at)
    bypass, controlled = groups(variant, at.pairs, at.driving_pairs)
    excluded: dict[str, Any] = {}
    law = _indirect_law if variant == "indirect" else _direct_law
    at_set, low, high, on_balls, travel = law(need, at, gain, bypass, controlled, excluded)
    margin = need.wanted.margin if need.wanted.method == "mean-friction" else 1.0
    force, missing = _force(need, need.wanted.nominal_torque * margin / at_set)
    excluded["closing_force"] = missing
    factor, torque_max = larger(low, high) / smaller(low, high), force * larger(low, high)
    _exceed(excluded, "accuracy_factor", factor, need.wanted.accuracy_factor)
    _exceed(excluded, "torque_max", torque_max, need.wanted.torque_max)
    if limits.gain_limit and variant in ("differentiated", "all-driving"):
        most = (
            direct.gain_limit_differentiated(bypass, need.friction.groups[0].max)
            if variant == "differentiated"
            else direct.gain_limit_all_driving(at.pairs)
        )
        excluded["gain_limit"] = gain > most * (1 + 1e-9)
    if variant != "conventional":
        _exceed(excluded, "reduced_gain", controlled * gain, limits.reduced_gain)
    pressure = np.full(radius.shape, np.nan)
    if fixed.face_width is not None:
        half = fixed.face_width / 2
        pressure = geometry.mean_pressure(force, radius - half, radius + half, math.pi)
        excluded["face_width"] = radius <= half
        _exceed(excluded, "surface_pressure", pressure, limits.surface_pressure)
    contact, ball, moved = np.full((3, *radius.shape), np.nan)
    if variant != "conventional":
        cosine = 1 / np.sqrt(1 + tangent**2)
        contact = synthesis.contact_force(force * on_balls, fixed.balls, at.ball_circle_radius, cosine)
        _exceed(excluded, "contact_force", contact, limits.contact_force)
        moved = force * travel
        radius_needed = synthesis.ball_radius(moved, fixed.face_gap, fixed.edge_clearance, tangent * cosine)
        listed = balls(need)
        place = np.searchsorted(listed, 2 * radius_needed * (1 - SAME))
        # a clutch of gain 0 has no pockets to speak of
        idle = tangent <= 0
        ball = np.where(idle, np.nan, listed[np.minimum(place, listed.size - 1)])
        excluded["standard_ball"] = (place >= listed.size) & ~idle
        _exceed(excluded, "travel", moved, limits.travel)
    return State(
        gain=np.broadcast_to(gain, radius.shape),
        closing_force=force,
        accuracy_factor=factor,
        nominal_torque=force * at_set / margin,
        torque_max=torque_max,
        ball_diameter=ball,
        travel=moved,
        contact_force=contact,
        surface_pressure=pressure,
        excluded={name: np.broadcast_to(mask, radius.shape) for name, mask in excluded.items()},
    )


def _exceed(excluded: dict[str, Any], name: str, value: Any, limit: float | None) -> None:
    if limit is not None:
        excluded[name] = ~(value <= limit * (1 + SAME))


def _gain(need: Requirements, variant: str, at: Axes) -> tuple[Any, Any]:
    """C and tan α."""
    import numpy as np

    if variant == "conventional":
        return 0.0 * at.mean_radius, 0.0 * at.mean_radius
    if need.search.gain is not None:
        return at.gain, synthesis.tan_wall_angle(at.gain, at.ball_circle_radius, at.mean_radius)
    tangent = np.tan(at.gain)
    return direct.gain(at.mean_radius, at.ball_circle_radius, tangent), tangent


def _force(need: Requirements, wanted: Any) -> tuple[Any, Any]:
    """Spring force: exactly the one wanted within a range, or the next of a catalogue; and where there is none.

    Every law is proportional to F_п and nothing gets better with more of it, so the least force that gives the
    nominal torque stands for the whole interval.
    """
    import numpy as np

    span = need.search.closing_force
    if span is not None:
        return wanted, ~((wanted >= span.min * (1 - SAME)) & (wanted <= span.max * (1 + SAME)))
    listed = _given(need.search.closing_forces).array()
    place = np.searchsorted(listed, wanted * (1 - SAME))
    none = (place >= listed.size) | ~(wanted > 0)
    return np.where(none, wanted, listed[np.minimum(place, listed.size - 1)]), none


def friction_ends(need: Requirements) -> list[tuple[float, float]]:
    """(f_1, f_2) at the setting, at the smallest and at the largest friction."""
    first, second = need.friction.groups
    at = "mean" if need.wanted.method == "mean-friction" else "min"
    return [(getattr(first, name), getattr(second, name)) for name in (at, "min", "max")]


def _direct_law(
    need: Requirements, at: Axes, gain: Any, bypass: Any, controlled: Any, excluded: dict[str, Any]
) -> tuple[Any, Any, Any, Any, Any]:
    """Torque per force at the setting and at both ends, the largest on the balls, travel per force."""
    ends = friction_ends(need)
    at_set, low, high = (direct.torque(1.0, at.mean_radius, bypass, controlled, gain, *end) for end in ends)
    on_balls = [
        direct.group_torque(direct.normal_force(1.0, controlled, gain, end[1]), at.mean_radius, controlled, end[1])
        for end in ends[1:]
    ]
    return at_set, low, high, larger(*on_balls), 0.0


def _indirect_law(
    need: Requirements, at: Axes, gain: Any, bypass: Any, controlled: Any, excluded: dict[str, Any]
) -> tuple[Any, Any, Any, Any, Any]:
    (at_set, _), (low, _), (high, _) = friction_ends(need)
    fixed = need.fixed
    assert fixed.key_friction is not None
    assert fixed.hub_diameter is not None
    law = IndirectLaw(
        at.mean_radius, at.pairs, gain, at.closing_stiffness, at.control_stiffness, fixed.key_friction,
        fixed.hub_diameter, at_set,
    )  # fmt: skip
    excluded["gain_threshold"] = ~(law.net_gain > 0)
    torque_high = law.torque(1.0, high)
    return law.torque_per_force, law.torque(1.0, low), torque_high, torque_high, law.travel(1.0, high)


def objectives(need: Requirements, state: State, pairs: Any) -> Any:
    """One column per objective, all to be small; what a variant does not have costs nothing."""
    import numpy as np

    columns: Mapping[str, Any] = {**state._asdict(), "pairs": pairs}
    return np.stack([np.nan_to_num(np.asarray(columns[name], float)) for name in need.objectives], axis=1)


def feasible(state: State) -> Any:
    """Candidates that hold every constraint."""
    import numpy as np

    shape = state.closing_force.shape
    bad = np.logical_or.reduce([np.zeros(shape, bool), *state.excluded.values()])
    return ~bad & np.isfinite(state.closing_force) & np.isfinite(state.accuracy_factor)
