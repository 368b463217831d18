"""Findings on heat and wear of a trip."""

from typing import NamedTuple

from ..drive.heat import HeatedSlips, motor_torque
from ..drive.result import HeatResult
from ..engines.protocol import Clutch
from ..equations import heat as law
from ..equations.calls import unnoted
from ..findings import Finding, finding
from ..result import OpenTriple
from ..spec.catalogues import Material, friction_materials
from ..spec.models import Heat
from ..units import ZEROS

_NAMES = {"min": "f_min", "mean": "f_cp", "max": "f_max"}


def remarks(clutch: Clutch, own: Heat, result: HeatResult, slips: HeatedSlips) -> list[Finding]:
    """What a designer should know of the trip, its temperature, and what was not told."""
    return [
        *_end_findings(clutch, slips),
        *_melting(own, result),
        *_temperature_findings(clutch, result),
        *_surface_findings(own, result),
        *_slack(clutch, own),
        *_missing_findings(clutch, own),
        *([] if limits_of(clutch) else [_unjudged(result)]),
    ]


def _end_findings(clutch: Clutch, slips: HeatedSlips) -> list[Finding]:
    """Say where the motor carries the slip torque."""
    off = clutch.spec.drive.cut_off
    carried = {end: trip for end, trip in slips.at.items() if trip.carried}
    if not carried:
        return [*slips.found]
    at, path = ", ".join(_NAMES[end] for end in carried), "drive.cut_off"
    least, motor = float(min(trip.torque for trip in carried.values())), float(motor_torque(clutch))
    if off is None:
        return [finding("motor-never-stops", "error", value=least, limit=motor, path=path, at=at)]
    heat = max(float(trip.energy or 0.0) for trip in carried.values())
    return [
        finding("motor-stops-at-cut-off", "warning", value=least, limit=motor, path=path, at=at, heat=heat, off=off)
    ]


def _temperature_findings(clutch: Clutch, result: HeatResult) -> list[Finding]:
    """Hold the faces against what their material allows; the mean of the discs where no more is known."""
    judged = judged_temperature(clutch, result)
    if judged is None:
        return []
    hottest, of_faces, limit = judged
    said = [] if of_faces else [finding("faces-not-judged", "info", path="heat.conductivity", name=limit.name)]
    if hottest <= limit.low:
        return said
    beyond = hottest > limit.high
    return [
        finding(
            "temperature-exceeded" if beyond else "temperature-in-range", "error" if beyond else "warning",
            value=hottest, limit=limit.high if beyond else limit.low, path=limit.path, name=limit.name, low=limit.low,
            high=limit.high,
        ),
        *said,
    ]  # fmt: skip


def _melting(own: Heat, result: HeatResult) -> list[Finding]:
    """Say where discs cannot be what they were, whatever is allowed: the discs, or their faces while they slip."""
    hottest = (own.ambient or 0.0) + max(_most(result.temperature_rise), _most(result.surface_temperature_rise))
    if hottest < IRON_MELTS:
        return []
    return [finding("discs-melt", "error", value=hottest, limit=IRON_MELTS, path="heat.disc_mass")]


def _most(each: OpenTriple | None) -> float:
    return 0.0 if each is None else max((value for value in vars(each).values() if value is not None), default=0.0)


def _unjudged(result: HeatResult) -> Finding:
    """No limit is given: beyond what the best material of the catalogue bears it is judged all the same."""
    hottest, (limit, name) = _most(result.face_temperature or result.temperature), hottest_allowed()
    if not limit < hottest < IRON_MELTS:
        return finding("heat-not-judged", "info", path="friction.material")
    path = "friction.material"
    return finding("temperature-beyond-catalogue", "warning", value=hottest, limit=limit, path=path, name=name)


def _surface_findings(own: Heat, result: HeatResult) -> list[Finding]:
    """Say what the temperature of the faces rests on."""
    if result.surface_temperature_rise is None:
        return []
    said = []
    if own.lining_conductivity is None:
        said.append(finding("discs-take-all", "info", path="heat.lining_conductivity"))
    elif own.lining is None:
        said.append(finding("lining-thick", "info", path="heat.lining"))
    if own.disc_mass is None:
        said.append(finding("discs-thick", "info", path="heat.disc_mass"))
    return said


@unnoted()
def slack_before_worn(clutch: Clutch, own: Heat) -> float | None:
    """Wear of a pair at which the spring that follows the pack falls slack, m; None where the lining is gone before."""
    spring = clutch.following_spring
    if own.lining is None or (spring.disc is None and not spring.straight_stiffness):
        return None
    wear = float(spring.deflection) / clutch.spec.friction_group.pairs
    return wear if wear < own.lining * (1 - 1e-9) else None


def _slack(clutch: Clutch, own: Heat) -> list[Finding]:
    """No number of trips wears a lining out that its spring does not press so long."""
    wear, path = slack_before_worn(clutch, own), "heat.lining"
    return (
        []
        if wear is None
        else [finding("spring-slack-before-worn", "warning", value=wear, limit=own.lining, path=path)]
    )


def _missing_findings(clutch: Clutch, own: Heat) -> list[Finding]:
    """Say what was not told, and the key that would tell it."""
    group = clutch.spec.friction_group
    missing = [] if group.inner_radius is not None else ["friction_group.inner_radius", "friction_group.outer_radius"]
    wanted = ("disc_mass", "specific_heat", "ambient", "cooling", "wear", "lining", "conductivity", "density")
    missing += [f"heat.{key}" for key in wanted if getattr(own, key) is None]
    if clutch.following_stiffness is None:
        missing.append("closing_spring.stiffness")
    return [finding("heat-not-told", "info", listed=", ".join(missing))] if missing else []


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


class JudgedTemperature(NamedTuple):
    """The largest temperature of a trip that a material has to bear."""

    value: float
    """K."""
    of_faces: bool
    """Whether it is the faces'; else the mean of the discs, where that of the faces is not known."""
    limit: Limit


def material_limit(clutch: Clutch) -> Limit | None:
    """What the faces may reach: the lowest of what the materials named allow."""
    listed = [(path, friction_materials()[name]) for path, name in clutch.spec.friction.materials.items()]
    allowing = [(path, material) for path, material in listed if material.temperature_min is not None]
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
    listed = [material for material in friction_materials().values() if material.temperature_max is not None]
    return max((_allowed(material)[1], material.name) for material in listed)


def _allowed(material: Material) -> tuple[float, float]:
    """Range of temperatures that a material allows, K."""
    low, high = material.temperature_min, material.temperature_max
    assert low is not None
    assert high is not None
    return low + _FREEZING, high + _FREEZING
