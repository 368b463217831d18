"""Findings on heat and wear of a trip."""

from collections.abc import Mapping

from ...engines.protocol import Clutch
from ...findings import Finding, finding
from ...spec.heat import Heat
from .limit import FREEZING, Limit
from .result import HeatResult
from .trip import Trip


def remarks(
    clutch: Clutch, own: Heat, result: HeatResult, found: Mapping[str, Trip], limit: Limit | None
) -> list[Finding]:
    """What a designer should know of the trip, its temperature, and what was not told."""
    return [
        *_end_findings(clutch, found),
        *_temperature_findings(result, limit),
        *_surface_findings(own, result),
        *_missing_findings(clutch, own, limit),
    ]


def _end_findings(clutch: Clutch, found: Mapping[str, Trip]) -> list[Finding]:
    """Say where the motor carries the slip torque."""
    drive = clutch.spec.drive
    carried = [trip.torque for trip in found.values() if trip.carried]
    if not carried or drive.motor_inertia is None:
        return []
    least = float(min(carried))
    return [
        finding("slip-without-end", "error", value=least, path="drive.cut_off")
        if drive.cut_off is None
        else finding(
            "slip-until-cut-off", "warning", value=float(min(carried)), limit=drive.cut_off, path="drive.cut_off"
        )
    ]


def _temperature_findings(result: HeatResult, limit: Limit | None) -> list[Finding]:
    if result.temperature is None or limit is None:
        return []
    after = [each for each in vars(result.temperature).values() if each is not None]
    hottest = max(after, default=0.0)
    if hottest <= limit.low:
        return []
    beyond = hottest > limit.high
    said = {"celsius": hottest - FREEZING, "low": limit.low - FREEZING, "high": limit.high - FREEZING}
    return [
        finding(
            "temperature-exceeded" if beyond else "temperature-in-range", "error" if beyond else "warning",
            value=hottest, limit=limit.high if beyond else limit.low, path=limit.path, name=limit.name, **said,
        )
    ]  # fmt: skip


def _surface_findings(own: Heat, result: HeatResult) -> list[Finding]:
    """Say what the temperature of the faces rests on."""
    if result.surface_temperature_rise is None:
        return []
    said = []
    if own.lining_conductivity is None:
        said.append(finding("discs-take-all", "info", path="heat.lining_conductivity"))
    if own.disc_mass is None:
        said.append(finding("discs-thick", "info", path="heat.disc_mass"))
    return said


def _missing_findings(clutch: Clutch, own: Heat, limit: Limit | None) -> list[Finding]:
    """Say what was not told, and the key that would tell it."""
    group = clutch.spec.friction_group
    missing = [] if group.inner_radius is not None else ["friction_group.inner_radius", "friction_group.outer_radius"]
    wanted = ("disc_mass", "specific_heat", "ambient", "cooling", "wear", "lining", "conductivity", "density")
    missing += [f"heat.{key}" for key in wanted if getattr(own, key) is None]
    if clutch.following_stiffness is None:
        missing.append("closing_spring.stiffness")
    said = [finding("heat-not-told", "info", listed=", ".join(missing))] if missing else []
    return said if limit is not None else [*said, finding("heat-not-judged", "info", path="friction.material")]
