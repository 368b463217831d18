"""Surface pressure of the friction discs against what their material allows."""

import math
from collections.abc import Mapping

from ...engines.protocol import Clutch
from ...equations import direct
from ...findings import Finding, Level, finding
from ...spec.materials import Material, catalogue


def pressure_findings(clutch: Clutch) -> list[Finding]:
    """Hold the pressure of the clutch at rest against the allowable range of each material named.

    The pack is pressed most at rest, before a release force sets in: with F_п of a direct clutch, F_п2 of an indirect
    one, whose control spring presses through sleeve and stop. Needs the inner and outer radius; with uniform wear the
    peak at the inner edge is held against the allowable too.
    """
    pressures = ring_pressures(clutch)
    return [
        _finding(kind, pressure, material, path)
        for path, material in ((path, catalogue()[name]) for path, name in clutch.spec.friction.materials.items())
        if material.pressure_max is not None
        for kind, pressure in pressures.items()
    ]


def ring_pressures(clutch: Clutch) -> dict[str, float]:
    """Return the pressure of a pack at rest in the ``mean`` and at its ``peak``, Pa; empty without both radii."""
    group = clutch.spec.friction_group
    if group.inner_radius is None or group.outer_radius is None:
        return {}
    ring = float(clutch.pack_force_at_rest), group.inner_radius, group.outer_radius, math.pi
    found = {"mean": float(direct.mean_pressure(*ring))}
    if (group.radius_model or "uniform-wear") == "uniform-wear":
        found["peak"] = float(direct.peak_pressure_uniform_wear(*ring))
    return found


def allowable(material: str) -> float | None:
    """Surface pressure that a material of the catalogue is held to, Pa; None where the catalogue has none.

    The lower end of the printed range: so the utilisation grows with the load.
    """
    return catalogue()[material].pressure_min


def _finding(kind: str, pressure: float, material: Material, path: str) -> Finding:
    """Below the printed range of the allowable: fine; within: the designer's to judge; above: an error."""
    low, high = allowable(material.name), material.pressure_max
    assert low is not None
    assert high is not None
    level: Level = "error" if pressure > high else "warning" if pressure > low else "info"
    return finding(
        _CODES[kind][level], level, value=pressure, limit=low, path=path, used=pressure / low, low=low, high=high,
        name=material.name,
    )  # fmt: skip


_CODES: Mapping[str, Mapping[Level, str]] = {
    "mean": {"info": "mean-pressure", "warning": "mean-pressure-in-range", "error": "mean-pressure-exceeded"},
    "peak": {"info": "peak-pressure", "warning": "peak-pressure-in-range", "error": "peak-pressure-exceeded"},
}
"""Where it is pressed so → how grave it is → code."""
