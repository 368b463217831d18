"""Findings on heat and wear of a trip."""

from collections.abc import Iterator
from typing import NamedTuple

from ..drive.heat import HeatedSlips, motor_torque
from ..drive.result import HeatResult
from ..engines.protocol import Clutch
from ..equations import heat as law
from ..equations.calls import unnoted
from ..findings import Finding, Level, finding
from ..messages import measured
from ..result import OpenTriple
from ..spec.catalogues import Material, friction_materials
from ..spec.models import Heat
from ..units import ZEROS

_NAMES = {"min": "f_min", "mean": "f_cp", "max": "f_max"}


def remarks(clutch: Clutch, given: Heat, result: HeatResult, slips: HeatedSlips) -> Iterator[Finding]:
    """What a designer should know of the trip, its temperature, and what was not told."""
    yield from _end_findings(clutch, slips)
    # discs cannot be what they were, whatever is allowed: the discs, or their faces while they slip
    melted = (given.ambient or 0.0) + max(_most(result.temperature_rise), _most(result.surface_temperature_rise))
    if melted >= IRON_MELTS:
        yield finding("discs-melt", "error", value=melted, limit=IRON_MELTS, path="heat.disc_mass")
    yield from _temperature_findings(clutch, result)
    if result.surface_temperature_rise is not None:
        # what the temperature of the faces rests on
        if given.lining_conductivity is None:
            yield finding("discs-take-all", "info", path="heat.lining_conductivity")
        elif given.lining is None:
            yield finding("lining-thick", "info", path="heat.lining")
        if given.disc_mass is None:
            yield finding("discs-thick", "info", path="heat.disc_mass")
    # no number of trips wears a lining out that its spring does not press so long
    if (wear := slack_before_worn(clutch, given)) is not None:
        yield finding("spring-slack-before-worn", "warning", value=wear, limit=given.lining, path="heat.lining")
    # what was not told, and the key that would tell it
    wanted = ("disc_mass", "specific_heat", "ambient", "cooling", "wear", "lining", "conductivity", "density")
    radii = [] if clutch.spec.friction_group.inner_radius is not None else ["inner_radius", "outer_radius"]
    missing = [f"friction_group.{key}" for key in radii]
    missing += [f"heat.{key}" for key in wanted if getattr(given, key) is None]
    if clutch.following_stiffness is None:
        missing.append("closing_spring.stiffness")
    if missing:
        yield finding("heat-not-told", "info", listed=", ".join(missing))
    # without a limit it is judged all the same beyond what the best material of the catalogue bears
    if not limits_of(clutch):
        hottest, path = _most(result.face_temperature or result.temperature), "friction.material"
        listed = (clutch.spec.lists.materials or friction_materials()).values()
        allowed = [(_allowed(one)[1], one.name) for one in listed if one.temperature_max is not None]
        limit, name = max(allowed, default=(IRON_MELTS, ""))
        if limit < hottest < IRON_MELTS:
            yield finding("temperature-beyond-catalogue", "warning", value=hottest, limit=limit, path=path, name=name)
        else:
            yield finding("heat-not-judged", "info", path=path)


def _end_findings(clutch: Clutch, slips: HeatedSlips) -> Iterator[Finding]:
    """Say where the motor carries the slip torque."""
    off, path = clutch.spec.drive.cut_off, "drive.cut_off"
    carried = {end: trip for end, trip in slips.at.items() if trip.carried}
    if not carried:
        yield from slips.found
        return
    at = ", ".join(_NAMES[end] for end in carried)
    least, motor = float(min(trip.torque for trip in carried.values())), float(motor_torque(clutch))
    code = "motor-never-stops" if off is None else "motor-stops-at-cut-off"
    level: Level = "error" if off is None else "info"
    carries, heat = measured(least, "N*m", 5), max(float(trip.energy or 0.0) for trip in carried.values())
    yield finding(code, level, value=least, limit=motor, path=path, at=at, carries=carries, heat=heat, off=off)


def _temperature_findings(clutch: Clutch, result: HeatResult) -> Iterator[Finding]:
    """Hold the faces against what their material allows; the mean of the discs where no more is known."""
    judged = judged_temperature(clutch, result)
    if judged is None:
        return
    hottest, of_faces, limit = judged
    if hottest > limit.low:
        beyond = hottest > limit.high
        yield finding(
            "temperature-exceeded" if beyond else "temperature-in-range", "error" if beyond else "warning",
            value=hottest, limit=limit.high if beyond else limit.low, path=limit.path, name=limit.name, low=limit.low,
            high=limit.high,
        )  # fmt: skip
    if not of_faces:
        yield finding("faces-not-judged", "info", path="heat.conductivity", name=limit.name)


def _most(ends: OpenTriple | None) -> float:
    """Largest of the values at f_min, mean and f_max that are known, else 0."""
    return 0.0 if ends is None else max((value for value in vars(ends).values() if value is not None), default=0.0)


@unnoted()
def slack_before_worn(clutch: Clutch, own: Heat) -> float | None:
    """Wear of a pair at which the spring that follows the pack falls slack, m; None where the lining is gone before."""
    spring = clutch.following_spring
    if own.lining is None or (spring.disc is None and not spring.straight_stiffness):
        return None
    wear = float(spring.deflection) / clutch.spec.friction_group.pairs
    return wear if wear < own.lining * (1 - 1e-9) else None


_FREEZING = float(ZEROS["degC"])
IRON_MELTS = 1811.0
"""Melting point of iron, K (CRC Handbook of Chemistry and Physics); steel and cast iron melt below it."""


class Limit(NamedTuple):
    """Temperature that the discs are held against, K: what is required, or the range that a material allows."""

    low: float
    high: float
    path: str
    name: str | None
    """Of the material; None where it is the spec that requires."""


def material_limit(clutch: Clutch) -> Limit | None:
    """What the faces may reach: the lowest of what the materials named allow."""
    linings = clutch.spec.friction.linings.items()
    allowing = [(path, material) for path, material in linings if material.temperature_min is not None]
    if not allowing:
        return None
    path, material = min(allowing, key=lambda each: _allowed(each[1])[0])
    return Limit(*_allowed(material), path, material.name)


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


def judged_temperature(clutch: Clutch, result: HeatResult) -> tuple[float, bool, Limit] | None:
    """What a material has to bear of a trip, the largest over the friction range.

    Returns:
        The temperature, K; whether it is the faces', else the mean of the discs; and what the material allows.
    """
    limit, reached = material_limit(clutch), result.face_temperature or result.temperature
    if limit is None or reached is None or all(value is None for value in vars(reached).values()):
        return None
    return _most(reached), result.face_temperature is not None, limit


def share_of_rise(clutch: Clutch, temperature: float, limit: float) -> float:
    """Share that a temperature uses of the rise from the surroundings' to a limit."""
    heat = clutch.spec.heat
    assert heat is not None
    return float(law.share_of_rise(temperature, heat.ambient, limit))


def _allowed(material: Material) -> tuple[float, float]:
    """Range of temperatures that a material allows, K."""
    low, high = material.temperature_min, material.temperature_max
    assert low is not None
    assert high is not None
    return low + _FREEZING, high + _FREEZING
