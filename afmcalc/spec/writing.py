"""From spec to data and text."""

from typing import Any

from .models import Spec


def resolved(spec: Spec) -> dict[str, Any]:
    """Return the spec as plain data, SI, with defaults filled in.

    Reading it again gives the same clutch, with the same keys free: what follows from other keys (the mean of the
    friction range, the range of a material, the spring force from a nominal torque) is not filled in, so that it
    still follows when one of them is overridden.
    """
    data = spec.model_dump(exclude_none=True)
    group = data["friction_group"]
    if spec.kind.chooses_bypass:
        group.setdefault("driving_pairs", spec.bypass_pairs)
    if "inner_radius" in group:
        group.setdefault("radius_model", "uniform-wear")
    return data


def to_toml(data: dict[str, Any]) -> str:
    """Write plain spec data as TOML."""
    import tomli_w

    return tomli_w.dumps(data)
