"""What the accuracy of the indirect clutch is sensitive to: elasticities from the derivatives of its law."""

from typing import Any

from ..arrays import Values
from ..equations import indirect
from ..spec.models import Spec
from . import geometry
from .laws import IndirectLaw


def sensitivity(spec: Spec, law: IndirectLaw, closing_force: Values) -> dict[str, float]:
    """Elasticities ∂ln K_т/∂ln p by spec path.

    With the sleeve leaving its stop at f_L: ln K = ln f_max − ln f_min + ln D(f_L) − ln D(f_max) + ln(1 + zκf_min)
    − ln(1 + zκf_L). Set by S21 (14), f_L is the friction of the setting; with both forces as made, 1 + zκf_L is their
    ratio; and where the sleeve never rests or never moves, f_L is f_min or f_max.
    """
    own = spec.friction.groups[0]
    leaving, follows = _leaving(spec, law, closing_force)

    def moving(part: Values, f: Values) -> Any:
        stiffness = law.stiffness(f, law.net_gain)
        return indirect.stiffness_elasticity_in_feedback(law.closing_stiffness, law.pairs, f, part, stiffness)

    def seated(part: Values, f: Values) -> Any:
        return indirect.seated_elasticity_in_feedback(law.pairs, f, part, law.net_gain)

    def at_leaving(part: Values) -> Any:
        return 0.0 if follows is None else moving(part, leaving) - seated(part, leaving)

    def in_feedback(part: Values) -> Any:
        return seated(part, own.min) + at_leaving(part) - moving(part, own.max)

    def in_closing_stiffness(f: Values) -> Any:
        return indirect.stiffness_elasticity_in_closing_stiffness(
            law.closing_stiffness, law.pairs, f, law.net_gain, law.stiffness(f, law.net_gain)
        )

    def in_control_stiffness(f: Values) -> Any:
        return indirect.stiffness_elasticity_in_control_stiffness(law.control_stiffness, law.stiffness(f, law.net_gain))

    found = {
        "friction.min": seated(law.net_gain, own.min) - 1.0,
        "friction.max": 1.0 - moving(law.net_gain, own.max),
    }
    for end, share in _shares(spec, follows).items():
        found[f"friction.{end}"] = found.get(f"friction.{end}", 0.0) + share * at_leaving(law.net_gain)
    in_gain, in_key = in_feedback(law.gain), in_feedback(-law.gain_threshold)
    found |= {
        "friction_group.pairs": in_feedback(law.net_gain),
        **geometry.gain_elasticities(spec, in_gain, in_radius=in_key),
        "control_unit.key_friction": in_key,
        "control_unit.hub_diameter": -in_key,
        "closing_spring.stiffness": in_closing_stiffness(leaving) - in_closing_stiffness(own.max),
        "control_spring.stiffness": in_control_stiffness(leaving) - in_control_stiffness(own.max),
        **geometry.force_elasticity(spec),
    }
    if law.made_control_force is not None:
        in_forces = in_control_stiffness(leaving) if follows is None else 0.0
        found |= {"closing_spring.force": in_forces, "control_spring.force": -in_forces}
    return found


def _leaving(spec: Spec, law: IndirectLaw, closing_force: Values) -> tuple[Any, str | None]:
    """Friction at which the sleeve leaves its stop, and the friction it follows; None where the forces alone fix it."""
    own = spec.friction.groups[0]
    if law.made_control_force is None:
        return law.friction_set, "mean" if spec.adjustment.method == "mean-friction" else "min"
    over, loop = law.made_control_force / closing_force - 1, law.pairs * law.net_gain
    if over <= loop * own.min:
        return own.min, "min"
    return (own.max, "max") if over >= loop * own.max else (over / loop, None)


def _shares(spec: Spec, follows: str | None) -> dict[str, float]:
    """How a friction moves with the keys of the range, relative; a mean that is not given moves with both ends."""
    own = spec.friction.groups[0]
    if follows == "mean" and spec.friction.mean is None:
        return {"min": own.min / (2 * own.mean), "max": own.max / (2 * own.mean)}
    return {} if follows is None else {follows: 1.0}
