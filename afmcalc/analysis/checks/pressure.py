"""Surface pressure of the friction discs against what their material allows."""

import math
from typing import Any

from ...engines.protocol import Clutch
from ...equations import geometry
from ...findings import Finding
from ...spec.materials import Material, catalogue


def pressure_findings(clutch: Clutch) -> list[Finding]:
    """Hold the pressure of the clutch at rest against the allowable range of each material named.

    The pack is pressed most at rest, before a release force sets in: with F_п of a direct clutch, F_п2 of an indirect
    one, whose control spring presses through sleeve and stop. Needs the inner and outer radius; with uniform wear the
    peak at the inner edge is held against the allowable too.
    """
    group = clutch.spec.friction_group
    if group.inner_radius is None or group.outer_radius is None:
        return []
    ring = float(clutch.pack_force_at_rest), group.inner_radius, group.outer_radius, math.pi
    pressures = {"mean-pressure": geometry.mean_pressure(*ring)}
    if (group.radius_model or "uniform-wear") == "uniform-wear":
        pressures["peak-pressure"] = geometry.peak_pressure_uniform_wear(*ring)
    return [
        _finding(kind, pressure, material, path)
        for path, material in _materials(clutch.spec.friction)
        for kind, pressure in pressures.items()
    ]


def _materials(friction: Any) -> list[tuple[str, Material]]:
    """Materials of the spec that have an allowable pressure, with their key paths."""
    blocks = {"friction": friction, "friction.driving": friction.driving, "friction.driven": friction.driven}
    named = [(f"{path}.material", catalogue()[b.material]) for path, b in blocks.items() if b and b.material]
    return [(path, material) for path, material in named if material.pressure_max is not None]


def _finding(kind: str, pressure: float, material: Material, path: str) -> Finding:
    """Below the printed range of the allowable: fine; within: the designer's to judge; above: an error."""
    low, high = material.pressure_min, material.pressure_max
    assert low is not None
    assert high is not None
    where = "at the inner edge" if kind == "peak-pressure" else "in the mean"
    said = f"surface pressure {pressure / 1e3:.5g} kPa {where}, utilisation {pressure / low:.3g}"
    if pressure > high:
        message = f"{said}: above the allowable {low / 1e3:g}…{high / 1e3:g} kPa of {material.name}"
        return Finding("error", f"{kind}-exceeded", message, pressure, high, path)
    if pressure > low:
        message = (
            f"{said}: within the printed range of the allowable, {low / 1e3:g}…{high / 1e3:g} kPa of {material.name}"
        )
        return Finding("warning", f"{kind}-in-range", message, pressure, low, path)
    return Finding(
        "info", kind, f"{said}: below the allowable {low / 1e3:g} kPa of {material.name}", pressure, low, path
    )
