"""What the accuracy of the indirect clutch is sensitive to: elasticities from the derivatives of its law."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from ..arrays import Values
from ..equations import indirect, pocket
from ..spec.models import Spec
from . import geometry
from .laws import IndirectLaw
from .protocol import TorqueRange


class Part(float):
    """What of κ, or of F_п1, is proportional to a parameter: it knows the parameter's symbol, for who explains."""

    of: str

    def __new__(cls, value: Values, of: str) -> "Part":
        """A number, and what it is proportional to."""
        part = super().__new__(cls, float(value))
        part.of = of
        return part


@dataclass(frozen=True)
class _Torque:
    """Elasticities of one torque, but those in R and z themselves, which a quotient of two does not have."""

    friction: float
    """In the friction it is at."""
    end: str | None
    """End of the range that this friction is; None where the forces fix it."""
    in_feedback: Callable[[Part], float]
    """In a parameter to which a part of κ is proportional; of κ where the sleeve is."""
    travel: float = 0.0
    """Of the sleeve, m."""
    closing_stiffness: float = 0.0
    control_stiffness: float = 0.0
    closing_force: float = 0.0
    control_force: float = 0.0


def sensitivity(spec: Spec, law: IndirectLaw, closing_force: Values, extremes: TorqueRange) -> dict[str, float]:
    """Elasticities ∂ln K_т/∂ln p by spec path, the slope of a curved pocket as it is cut.

    K_т is the quotient of two torques, each where it is extreme: at an end of the range, where the sleeve leaves its
    stop, or between. What F_п2 follows from by S21 (14) it passes on, and F_п1 passes on what it follows from.
    """
    own = spec.friction.groups[0]

    def at(friction: Values, *ends: Literal["min", "max"]) -> _Torque:
        end = next((end for end in ends if getattr(own, end) == friction), None)
        if end is None and friction == law.leaving_friction(closing_force):
            return _leaving(law, closing_force)
        return _at(law, closing_force, friction, end)

    return _by_path(spec, law, at(extremes.at_high, "max", "min"), at(extremes.at_low, "min", "max"), closing_force)


def _by_path(spec: Spec, law: IndirectLaw, high: _Torque, low: _Torque, closing_force: Values) -> dict[str, float]:
    set_here = law.made_control_force is None
    in_control = high.control_force - low.control_force

    def passed_on(part: Part) -> float:
        """What F_п2 = F_п1 (1 + z f_set κ) passes on."""
        if not set_here:
            return 0.0
        own = indirect.seated_elasticity_in_feedback(law.pairs, law.friction_set, part, law.net_gain)
        return float(in_control * own)

    def in_feedback(of: str, part: Values, slope: Values = 0.0) -> float:
        """``part`` of κ at the stop, and what the slope adds where the sleeve is."""
        ends = (each.in_feedback(Part(part + slope * each.travel, of)) for each in (high, low))
        return float(next(ends) - next(ends)) + passed_on(Part(part, of))

    in_force = high.closing_force - low.closing_force + (in_control if set_here else 0.0)
    if set_here and law.straight:
        in_force = 0.0  # of a straight pocket every torque is proportional to it, whatever rounding says
    # with the spring set for a torque, F_п1 goes with 1/(z R f_set)
    follows = -in_force if spec.closing_spring.force is None else 0.0
    found = {"friction.min": 0.0, "friction.max": 0.0}
    for each, sign in ((high, 1.0), (low, -1.0)):
        geometry.spread(found, spec.friction, "friction", each.end, sign * each.friction)
    at_set = "mean" if spec.adjustment.method == "mean-friction" else "min"
    geometry.spread(found, spec.friction, "friction", at_set, passed_on(Part(law.net_gain, "f_set")) + follows)
    in_gain, in_key = in_feedback("C", law.gain), in_feedback("f_1", -law.gain_threshold)
    found |= {
        "friction_group.pairs": in_feedback("z", law.net_gain, law.gain_slope) + follows,
        **geometry.gain_elasticities(spec, in_gain, in_radius=in_key + follows),
        "control_unit.key_friction": in_key,
        "control_unit.hub_diameter": -in_key,
        "closing_spring.stiffness": high.closing_stiffness - low.closing_stiffness,
        "control_spring.stiffness": high.control_stiffness - low.control_stiffness,
        geometry.force_path(spec): in_force,
    }
    if not law.straight:
        found["control_unit.gain_slope"] = in_feedback("C_1", 0.0, law.gain_slope)
    if not set_here:
        found["control_spring.force"] = in_control
    return found


def _at(law: IndirectLaw, closing_force: Values, friction: Values, end: str | None) -> _Torque:
    """Elasticities of the torque at one end of the range, or where it does not change with friction."""
    # at the bend itself the range lies on one side: what f_min moves along is below it, what f_max does above
    leaving = law.leaving_friction(closing_force)
    if friction <= leaving if end == "min" else friction < leaving:

        def seated(part: Part) -> float:
            return -float(indirect.seated_elasticity_in_feedback(law.pairs, friction, part, law.net_gain))

        return _Torque(1 + seated(Part(law.net_gain, "f")), end, seated, control_force=1.0)
    tangent = law.tangent_stiffness(closing_force, friction, law.net_gain)
    pressed, travel = law.normal_force(closing_force, friction), law.travel(closing_force, friction)
    slope = pocket.slope_feedback(law.pairs, friction, law.gain_slope)
    c1, c2, control = law.closing_stiffness, law.control_stiffness, law.control_force(closing_force)

    def moving(part: Part) -> float:
        return float(pocket.force_elasticity_in_feedback(c1, law.pairs, friction, part, tangent))

    def in_closing(part: Part) -> float:
        return float(pocket.force_elasticity_in_closing_spring(part, c2, slope, tangent, pressed))

    return _Torque(
        friction=0.0 if end is None else 1 + moving(Part(law.steepened(travel).net_gain, "f")),
        end=end,
        in_feedback=moving,
        travel=float(travel),
        closing_stiffness=in_closing(Part(-c1 * travel, "c_1")),
        control_stiffness=float(pocket.force_elasticity_in_control_stiffness(c1, c2, travel, tangent, pressed)),
        closing_force=in_closing(Part(closing_force, "F_п1")),
        control_force=float(pocket.force_elasticity_in_control_force(c1, control, tangent, pressed)),
    )


def _leaving(law: IndirectLaw, closing_force: Values) -> _Torque:
    """Elasticities of T = z R f_L F_п1, where the sleeve leaves its stop."""
    control = law.control_force(closing_force)
    over = float(control / (control - closing_force))
    # as if at a friction of its own: F_п2 passes on what f_set would
    return _Torque(0.0, None, lambda part: -float(part / law.net_gain), closing_force=1 - over, control_force=over)
