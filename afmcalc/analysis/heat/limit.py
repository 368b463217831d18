"""Temperatures that discs and faces are held against, and how much of them is used."""

from typing import NamedTuple

from ...engines.protocol import Clutch
from ...equations import heat as law
from ...spec.materials import Material, catalogue
from .result import HeatResult

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


class JudgedTemperature(NamedTuple):
    """The largest temperature of a trip that a material has to bear."""

    value: float
    """K."""
    of_faces: bool
    """Whether it is the faces'; else the mean of the discs, where that of the faces is not known."""
    limit: Limit


def material_limit(clutch: Clutch) -> Limit | None:
    """What the faces may reach: the lowest of what the materials named allow."""
    listed = [(path, catalogue()[name]) for path, name in clutch.spec.friction.materials.items()]
    allowing = [(path, material) for path, material in listed if material.temperature_min is not None]
    if not allowing:
        return None
    path, material = min(allowing, key=lambda each: _celsius(each[1])[0])
    low, high = (each + FREEZING for each in _celsius(material))
    return Limit(low, high, path, material.name)


def limits_of(clutch: Clutch) -> list[Limit]:
    """Every limit of a temperature, that of the mean of the discs first."""
    required = clutch.spec.requirements
    given = {} if required is None else {key: getattr(required, key) for key in ("temperature", "face_temperature")}
    asked = [Limit(most, most, f"requirements.{key}", None) for key, most in given.items() if most is not None]
    material = material_limit(clutch)
    return [*asked, *([] if material is None else [material])]


def limit_of(clutch: Clutch) -> Limit | None:
    """What the mean of the discs is held against over many trips: what is required, else what the material allows."""
    return next((each for each in limits_of(clutch) if each.path != "requirements.face_temperature"), None)


def judged_temperature(clutch: Clutch, found: HeatResult) -> JudgedTemperature | None:
    """What a material has to bear of a trip, the largest over the friction range."""
    limit = material_limit(clutch)
    told = found.face_temperature or found.temperature
    reached = [] if told is None else [each for each in vars(told).values() if each is not None]
    if limit is None or not reached:
        return None
    return JudgedTemperature(max(reached), found.face_temperature is not None, limit)


def share_of_rise(clutch: Clutch, temperature: float, limit: float) -> float:
    """Share that a temperature uses of the rise from the surroundings' to a limit."""
    heat = clutch.spec.heat
    assert heat is not None
    return float(law.share_of_rise(temperature, heat.ambient, limit))


def hottest_allowed() -> tuple[float, str]:
    """Highest temperature that a material of the catalogue allows, K, and its name."""
    listed = [material for material in catalogue().values() if material.temperature_max is not None]
    return max((_celsius(material)[1] + FREEZING, material.name) for material in listed)


def _celsius(material: Material) -> tuple[float, float]:
    low, high = material.temperature_min, material.temperature_max
    assert low is not None
    assert high is not None
    return low, high
