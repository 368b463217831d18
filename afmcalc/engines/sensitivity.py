"""What the accuracy of the indirect clutch is sensitive to: elasticities from the derivatives of D(f)."""

from typing import TYPE_CHECKING, Any

from ..equations import indirect
from . import geometry

if TYPE_CHECKING:
    from .indirect import IndirectClutch


def sensitivity(clutch: "IndirectClutch") -> dict[str, float]:
    """Elasticities ∂ln K_т/∂ln p by spec path, from ln K = ln f_max − ln f_min + ln D(f_set) − ln D(f_max)."""
    own, key = clutch.friction[0], indirect.gain_threshold(clutch.mean_radius, clutch.key_friction, clutch.hub_diameter)
    at_set, at_max = clutch.friction_set, own.max

    def across(elasticity: Any) -> Any:
        return elasticity(at_set) - elasticity(at_max)

    def feedback(part: Any) -> Any:
        return lambda f: indirect.stiffness_elasticity_in_feedback(
            clutch.closing_stiffness, clutch.pairs, f, part, clutch.stiffness(f, clutch.net_gain)
        )

    in_gain, in_key = across(feedback(clutch.gain)), across(feedback(-key))
    return {
        **_friction_sensitivity(clutch, feedback(clutch.net_gain)),
        "friction_group.pairs": across(feedback(clutch.net_gain)),
        **geometry.gain_elasticities(clutch.spec, in_gain, in_radius=in_key),
        "control_unit.key_friction": in_key,
        "control_unit.hub_diameter": -in_key,
        "closing_spring.stiffness": across(
            lambda f: indirect.stiffness_elasticity_in_closing_stiffness(
                clutch.closing_stiffness, clutch.pairs, f, clutch.net_gain, clutch.stiffness(f, clutch.net_gain)
            )
        ),
        "control_spring.stiffness": across(
            lambda f: indirect.stiffness_elasticity_in_control_stiffness(
                clutch.control_stiffness, clutch.stiffness(f, clutch.net_gain)
            )
        ),
        **geometry.force_elasticity(clutch.spec),
    }


def _friction_sensitivity(clutch: "IndirectClutch", in_friction: Any) -> dict[str, float]:
    """Elasticities in the ends of the range; a mean that is not given moves with them."""
    own, block = clutch.friction[0], clutch.spec.friction
    found = {"friction.min": -1.0, "friction.max": 1.0 - in_friction(own.max)}
    at_set = in_friction(clutch.friction_set)
    if clutch.spec.adjustment.method == "min-friction":
        found["friction.min"] += at_set
    elif block.mean is not None:
        found["friction.mean"] = at_set
    else:
        found["friction.min"] += at_set * own.min / (2 * own.mean)
        found["friction.max"] += at_set * own.max / (2 * own.mean)
    return found
