"""What the accuracy of the indirect clutch is sensitive to: elasticities from the derivatives of D(f)."""

from typing import Any

from ..equations import indirect
from ..spec.models import Spec
from . import geometry
from .laws import IndirectLaw


def sensitivity(spec: Spec, law: IndirectLaw) -> dict[str, float]:
    """Elasticities ∂ln K_т/∂ln p by spec path, from ln K = ln f_max − ln f_min + ln D(f_set) − ln D(f_max)."""
    own, at_set = spec.friction.groups[0], law.friction_set

    def across(elasticity: Any) -> Any:
        return elasticity(at_set) - elasticity(own.max)

    def feedback(part: Any) -> Any:
        return lambda f: indirect.stiffness_elasticity_in_feedback(
            law.closing_stiffness, law.pairs, f, part, law.stiffness(f, law.net_gain)
        )

    in_gain, in_key = across(feedback(law.gain)), across(feedback(-law.gain_threshold))
    return {
        **_friction_sensitivity(spec, law, feedback(law.net_gain)),
        "friction_group.pairs": across(feedback(law.net_gain)),
        **geometry.gain_elasticities(spec, in_gain, in_radius=in_key),
        "control_unit.key_friction": in_key,
        "control_unit.hub_diameter": -in_key,
        "closing_spring.stiffness": across(
            lambda f: indirect.stiffness_elasticity_in_closing_stiffness(
                law.closing_stiffness, law.pairs, f, law.net_gain, law.stiffness(f, law.net_gain)
            )
        ),
        "control_spring.stiffness": across(
            lambda f: indirect.stiffness_elasticity_in_control_stiffness(
                law.control_stiffness, law.stiffness(f, law.net_gain)
            )
        ),
        **geometry.force_elasticity(spec),
    }


def _friction_sensitivity(spec: Spec, law: IndirectLaw, in_friction: Any) -> dict[str, float]:
    """Elasticities in the ends of the range; a mean that is not given moves with them."""
    own, block = spec.friction.groups[0], spec.friction
    found = {"friction.min": -1.0, "friction.max": 1.0 - in_friction(own.max)}
    at_set = in_friction(law.friction_set)
    if spec.adjustment.method == "min-friction":
        found["friction.min"] += at_set
    elif block.mean is not None:
        found["friction.mean"] = at_set
    else:
        found["friction.min"] += at_set * own.min / (2 * own.mean)
        found["friction.max"] += at_set * own.max / (2 * own.mean)
    return found
