"""What the accuracy of a clutch is sensitive to: elasticities by spec path, from the derivatives of its law."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, TypeAlias

from ..equations import accuracy, indirect, pocket
from ..equations.arrays import Values
from ..spec.models import FrictionRange, Spec
from .parameters import force_path

if TYPE_CHECKING:
    from .indirect import IndirectClutch
    from .protocol import Clutch

Elasticities: TypeAlias = dict[str, float]


def sensitivity(clutch: "Clutch") -> Elasticities:
    """Elasticities ∂ln K_т/∂ln p by spec path, the slope of a curved pocket as it is cut.

    K_т is the quotient of two torques, each where it is extreme: at an end of the range, at the mean of unlike
    materials, where a sleeve leaves its stop, or between.
    """
    return _of_direct(clutch) if clutch.sleeve is None else _of_indirect(clutch.sleeve)


def _of_direct(clutch: "Clutch") -> Elasticities:
    (_, *low), (_, *high) = clutch.extreme_torques()
    z1, z2, friction = float(clutch.bypass_pairs), float(clutch.controlled_pairs), clutch.spec.friction
    paths = ("friction.driving", "friction.driven") if friction.unlike else ("friction", "friction")
    found = {f"{path}.{end}": 0.0 for end in ("min", "max") for path in paths}
    in_pairs = in_driving_pairs = in_gain = 0.0
    for sign, (first, second), ends in ((-1, low, ("min", "max", "mean")), (1, high, ("max", "min", "mean"))):
        pack = clutch.bypass_pairs, clutch.controlled_pairs
        driving = accuracy.torque_elasticity_in_friction_driving(*pack, first, second)
        driven = accuracy.torque_elasticity_in_friction_driven(*pack, clutch.gain, first, second)
        blocks = ((friction.driving or friction, first, driving), (friction.driven or friction, second, driven))
        for path, (block, at, slope) in zip(paths, blocks, strict=True):
            end = next(end for end in ends if getattr(block.range, end) == at)
            _spread(found, block, path, end, sign * slope)
        in_gain += sign * accuracy.torque_elasticity_in_gain(clutch.controlled_pairs, clutch.gain, second)
        # z with z_1 kept, z_1 with z kept; the elasticities in z_1 and z_2 equal those in f_1 and f_2
        in_pairs += sign * (driven if not z1 else driving if not z2 else (z1 + z2) / z2 * driven)
        in_driving_pairs += sign * (driving - z1 / z2 * driven if z1 and z2 else 0.0)
    found["friction_group.pairs"] = in_pairs
    if clutch.spec.kind.chooses_bypass:
        found["friction_group.driving_pairs"] = in_driving_pairs
    return found | _behind_gain(clutch.spec, in_gain) | {force_path(clutch.spec): 0.0}


@dataclass(frozen=True)
class _Torque:
    """Elasticities of one torque, but those in R and z themselves, which a quotient of two does not have."""

    friction: float
    """In the friction it is at."""
    end: str | None
    """End of the range that this friction is; None where the forces fix it."""
    in_feedback: Callable[[float], float]
    """In a parameter to which a part of κ is proportional; of κ where the sleeve is."""
    travel: float = 0.0
    """Of the sleeve, m."""
    closing_stiffness: float = 0.0
    control_stiffness: float = 0.0
    closing_force: float = 0.0
    control_force: float = 0.0


def _of_indirect(clutch: "IndirectClutch") -> Elasticities:
    """What F_п2 follows from by S21 (14) it passes on, and F_п1 passes on what it follows from."""
    spec, extremes = clutch.spec, clutch.torque_range
    high, low = _torque(clutch, extremes.at_high, "max", "min"), _torque(clutch, extremes.at_low, "min", "max")
    set_here = clutch.made_control_force is None
    in_control = high.control_force - low.control_force

    def passed_on(part: float) -> float:
        """What F_п2 = F_п1 (1 + z f_set κ) passes on."""
        if not set_here:
            return 0.0
        seated = indirect.seated_elasticity_in_feedback(clutch.pairs, clutch.friction_set, part, clutch.net_gain)
        return float(in_control * seated)

    def in_feedback(symbol: str, part: Values, slope: Values = 0.0) -> float:
        """``part`` of κ at the stop, and what the slope adds where the sleeve is."""
        ends = (torque.in_feedback(float(part + slope * torque.travel)) for torque in (high, low))
        return float(next(ends) - next(ends)) + passed_on(float(part))

    in_force = high.closing_force - low.closing_force + (in_control if set_here else 0.0)
    if set_here and clutch.straight:
        in_force = 0.0  # of a straight pocket every torque is proportional to it, whatever rounding says
    # with the spring set for a torque, F_п1 goes with 1/(z R f_set)
    follows = -in_force if spec.closing_spring.force is None else 0.0
    found = {"friction.min": 0.0, "friction.max": 0.0}
    for torque, sign in ((high, 1.0), (low, -1.0)):
        _spread(found, spec.friction, "friction", torque.end, sign * torque.friction)
    at_set = "mean" if spec.adjustment.method == "mean-friction" else "min"
    _spread(found, spec.friction, "friction", at_set, passed_on(float(clutch.net_gain)) + follows)
    in_gain, in_key = in_feedback("C", clutch.gain), in_feedback("f_1", -clutch.gain_threshold)
    found |= {
        "friction_group.pairs": in_feedback("z", clutch.net_gain, clutch.gain_slope) + follows,
        **_behind_gain(spec, in_gain, in_radius=in_key + follows),
        "control_unit.key_friction": in_key,
        "control_unit.hub_diameter": -in_key,
        "closing_spring.stiffness": high.closing_stiffness - low.closing_stiffness,
        "control_spring.stiffness": high.control_stiffness - low.control_stiffness,
        force_path(spec): in_force,
    }
    if not clutch.straight:
        found["control_unit.gain_slope"] = in_feedback("C_1", 0.0, clutch.gain_slope)
    if not set_here:
        found["control_spring.force"] = in_control
    return found


def _torque(clutch: "IndirectClutch", friction: Values, *ends: Literal["min", "max"]) -> _Torque:
    """Elasticities of the torque at one end of the range, where the sleeve leaves its stop, or between."""
    leaving, pairs, net = clutch.leaving_friction, clutch.pairs, clutch.net_gain
    end = next((end for end in ends if getattr(clutch.friction[0], end) == friction), None)
    control = clutch.control_force
    if end is None and friction == leaving:
        # T = z R f_L F_п1, as if at a friction of its own: F_п2 passes on what f_set would
        over = float(control / (control - clutch.closing_force))
        return _Torque(0.0, None, lambda part: -float(part / net), closing_force=1 - over, control_force=over)
    # at the bend itself the range lies on one side: what f_min moves along is below it, what f_max does above
    if friction <= leaving if end == "min" else friction < leaving:

        def seated(part: float) -> float:
            return -float(indirect.seated_elasticity_in_feedback(pairs, friction, part, net))

        return _Torque(1 + seated(float(net)), end, seated, control_force=1.0)
    tangent = clutch.tangent_stiffness(friction, net)
    pressed, travel = clutch.normal_force(friction), clutch.travel(friction)
    slope = pocket.slope_feedback(pairs, friction, clutch.gain_slope)
    c1, c2 = clutch.closing_stiffness, clutch.control_stiffness

    def moving(part: float) -> float:
        return float(pocket.force_elasticity_in_feedback(c1, pairs, friction, part, tangent))

    def in_closing(part: float) -> float:
        return float(pocket.force_elasticity_in_closing_spring(part, c2, slope, tangent, pressed))

    return _Torque(
        friction=0.0 if end is None else 1 + moving(float(clutch.steepened(travel).net_gain)),
        end=end,
        in_feedback=moving,
        travel=float(travel),
        closing_stiffness=in_closing(float(-c1 * travel)),
        control_stiffness=float(pocket.force_elasticity_in_control_stiffness(c1, c2, travel, tangent, pressed)),
        closing_force=in_closing(float(clutch.closing_force)),
        control_force=float(pocket.force_elasticity_in_control_force(c1, control, tangent, pressed)),
    )


def _behind_gain(spec: Spec, in_gain: float, in_radius: float = 0.0) -> Elasticities:
    """Elasticities by the spec keys behind C, from the one in C (chain rule; C ∝ R tan α/r) and in R at fixed C."""
    unit = spec.control_unit
    if unit is None:
        return _behind_radius(spec, in_radius)
    if unit.wall_angle is None:
        return {"control_unit.gain": in_gain, **_behind_radius(spec, in_radius)}
    # d ln tan α/d ln α = 2α/sin 2α, 1 at α = 0
    in_angle = 2 * unit.wall_angle / math.sin(2 * unit.wall_angle) if unit.wall_angle else 1.0
    return {
        "control_unit.wall_angle": in_gain * in_angle,
        "control_unit.ball_circle_radius": -in_gain,
        **_behind_radius(spec, in_gain + in_radius),
    }


def _behind_radius(spec: Spec, in_radius: float) -> Elasticities:
    """Elasticities by the radii a spec gives; R is homogeneous of degree 1 in the two, so theirs add up to R's."""
    group = spec.friction_group
    inner, outer = group.inner_radius, group.outer_radius
    if inner is None or outer is None:
        return {"friction_group.mean_radius": in_radius}
    if group.radius_model == "uniform-pressure":
        share = 2 * inner**2 / (outer**2 - inner**2) - 3 * inner**3 / (outer**3 - inner**3)
    else:
        share = inner / (inner + outer)
    return {
        "friction_group.inner_radius": in_radius * share,
        "friction_group.outer_radius": in_radius * (1 - share),
    }


def _spread(found: Elasticities, given: FrictionRange, path: str, end: str | None, elasticity: float) -> None:
    """Add an elasticity in one friction to the keys it follows; a mean that is not given moves with both ends."""
    if end is None or elasticity == 0:
        return
    shares = {end: 1.0}
    if end == "mean" and given.mean is None:
        own = given.range
        shares = {"min": own.min / (2 * own.mean), "max": own.max / (2 * own.mean)}
    for key, share in shares.items():
        found[f"{path}.{key}"] = found.get(f"{path}.{key}", 0.0) + share * elasticity
