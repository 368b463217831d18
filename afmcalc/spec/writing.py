"""From spec to data and text."""

from typing import Any

from .models import Spec


def resolved(spec: Spec) -> dict[str, Any]:
    """Return the spec as plain data, SI, with defaults filled in and materials looked up.

    Reading it again gives the same clutch. What a calculation derives (the spring force from a nominal
    torque, the gain from a wall angle) is not filled in: it stays derived when a key is overridden.
    """
    data = spec.model_dump(exclude_none=True)
    friction = data["friction"]
    if spec.friction.unlike:
        for group, values in zip(("driving", "driven"), spec.friction.groups, strict=True):
            friction[group] = values._asdict() | friction[group]
    else:
        data["friction"] = spec.friction.range._asdict() | friction
    group = data["friction_group"]
    if spec.variant == "differentiated":
        group.setdefault("driving_pairs", spec.bypass_pairs)
    if "inner_radius" in group:
        group.setdefault("radius_model", "uniform-wear")
    return data


def to_toml(data: dict[str, Any]) -> str:
    """Write plain spec data as TOML."""
    import tomli_w

    return tomli_w.dumps(data)
