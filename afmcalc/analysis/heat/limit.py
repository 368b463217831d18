"""Temperature that the discs are held against."""

from typing import NamedTuple

from ...engines.protocol import Clutch
from ...spec.materials import Material, catalogue

FREEZING = 273.15
"""0 °C, K."""
IRON_MELTS = 1811.0
"""Melting point of iron, K (CRC Handbook of Chemistry and Physics); steel and cast iron melt below it."""


class Limit(NamedTuple):
    """Temperature that the discs are held against, K: what is required, or the range that a material allows."""

    low: float
    high: float
    path: str
    name: str | None
    """Of the material; None where it is the spec that requires."""


def limit_of(clutch: Clutch) -> Limit | None:
    """What the spec requires, else the lowest of what the materials named allow."""
    required = clutch.spec.requirements
    if required is not None and required.temperature is not None:
        return Limit(required.temperature, required.temperature, "requirements.temperature", None)
    listed = [(path, catalogue()[name]) for path, name in clutch.spec.friction.materials.items()]
    allowing = [(path, material) for path, material in listed if material.temperature_min is not None]
    if not allowing:
        return None
    path, material = min(allowing, key=lambda each: _celsius(each[1])[0])
    low, high = (each + FREEZING for each in _celsius(material))
    return Limit(low, high, path, material.name)


def hottest_allowed() -> tuple[float, str]:
    """Highest temperature that a material of the catalogue allows, K, and its name."""
    listed = [material for material in catalogue().values() if material.temperature_max is not None]
    return max((_celsius(material)[1] + FREEZING, material.name) for material in listed)


def _celsius(material: Material) -> tuple[float, float]:
    low, high = material.temperature_min, material.temperature_max
    assert low is not None
    assert high is not None
    return low, high
