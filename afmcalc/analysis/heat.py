"""Heat and wear of a trip: work, temperature, trips per hour, trips until the lining is gone, and the findings."""

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

from ..drive.cases import case_of
from ..drive.heat import (
    ENDS,
    Body,
    Course,
    HeatedSlip,
    HeatedSlips,
    course_of,
    largest_rise,
    most_in_disc,
    motor_torque,
    run_down,
)
from ..drive.result import EnergySource, HeatResult
from ..engines import Clutch
from ..engines.checks import failures_of
from ..engines.quantities import Quantities
from ..equations import heat as law
from ..equations.arrays import Values
from ..errors import CalculationError, Problem, SpecError, given
from ..findings import Finding, Level, finding
from ..messages import joined, measured, say, term
from ..progress import counted
from ..result import OpenTriple, Triple
from ..spec.catalogues import Material, friction_materials
from ..spec.models import Heat, missing_of
from ..units import ZEROS
from .answers import Answers
from .clutch_findings import clutch_findings
from .registry import ANALYSES

_NAMES = {"min": "f_min", "mean": term("f_cp", "symbol"), "max": "f_max"}


def remarks(clutch: Clutch, given: Heat, result: HeatResult, slips: HeatedSlips) -> Iterator[Finding]:
    """What a designer should know of the trip, its temperature, and what was not told."""
    yield from _end_findings(clutch, slips)
    # discs cannot be what they were, whatever is allowed: the discs, or their faces while they slip
    melted = (given.ambient or 0.0) + max(_most(result.temperature_rise), _most(result.surface_temperature_rise))
    if melted >= IRON_MELTS:
        yield finding("discs-melt", "error", value=melted, limit=IRON_MELTS, path="heat.disc_mass")
    yield from failures_of(clutch.spec, known := heat_values(result), "heat")
    lining = material_limit(clutch)
    if lining is not None and result.face_temperature is None and known["hottest"] is not None:
        yield finding("faces-not-judged", "info", path="heat.conductivity", name=lining.name)
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
    at = joined(_NAMES[end] for end in carried)
    least, motor = float(min(trip.torque for trip in carried.values())), float(motor_torque(clutch))
    code = "motor-never-stops" if off is None else "motor-stops-at-cut-off"
    level: Level = "error" if off is None else "info"
    carries, heat = measured(least, "N*m", 5), max(float(trip.energy or 0.0) for trip in carried.values())
    yield finding(code, level, value=least, limit=motor, path=path, at=at, carries=carries, heat=heat, off=off)


def _most(ends: OpenTriple | None) -> float:
    """Largest of the values at f_min, mean and f_max that are known, else 0."""
    return 0.0 if ends is None else max((value for value in vars(ends).values() if value is not None), default=0.0)


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


def heat_values(result: HeatResult) -> dict[str, Any]:
    """Return what is held against a limit: of a trip the most, of trips the fewest, over the friction range.

    ``open`` names what may be more, as a slip has not ended.
    """
    named = ("specific_work", "temperature", "face_temperature")
    ends = {name: [*vars(triple).values()] for name in named if (triple := getattr(result, name)) is not None}
    most = {name: max((value for value in values if value is not None), default=None) for name, values in ends.items()}
    known: dict[str, Any] = {**most, "hottest": most.get("face_temperature", most.get("temperature"))}
    known["open"] = {name for name, values in ends.items() if None in values}
    if result.trips_per_hour is not None:
        trips = [value for value in vars(result.trips_per_hour).values() if value is not None]
        known["trips_per_hour"] = min(trips, default=math.inf)  # a slip without heat allows any number
        known["open"] |= {"trips_per_hour"} if None in vars(result.energy).values() else set()
    return known


def _allowed(material: Material) -> tuple[float, float]:
    """Range of temperatures that a material allows, K."""
    return given(material.temperature_min) + _FREEZING, given(material.temperature_max) + _FREEZING


HOUR = 3600.0


def heat(clutch: Clutch, answers: Answers | None = None) -> tuple[HeatResult, list[Finding]]:
    """Calculate heat and wear of a trip, by what drives the clutch ([drive]) and what is known of its discs ([heat]).

    Raises:
        SpecError: the [drive] block does not tell the heat of a trip.
        CalculationError: the surroundings are hotter than what the material allows.
    """
    slips = trips(clutch, answers)
    own, limit, group = clutch.spec.heat or Heat(), limit_of(clutch), clutch.spec.friction_group
    pairs, area = group.pairs, None
    if group.inner_radius is not None and group.outer_radius is not None:
        area = clutch.quantities.apply(law.friction_area, group.inner_radius, group.outer_radius, math.pi)
    for each in limits_of(clutch):
        if own.ambient is not None and own.ambient >= each.low:
            raise CalculationError(
                "heat: heat.ambient, {ambient:.4g °C}, is no cooler than the {limit:.4g °C} that {path} allows",
                ambient=own.ambient,
                limit=each.low,
                path=each.path,
            )
    found, faces = _shared(clutch, own, slips.at, area)
    work = power = worn_out = rises = None
    if area is not None:
        work = _each(found, lambda trip: trip.apply(law.specific_work, trip.energy, pairs, area))
        power = Triple.of(trip.apply(law.power_density, trip.course.largest, pairs, area) for trip in found.values())
        if own.wear is not None and own.lining is not None and slack_before_worn(clutch, own) is None:
            worn_out = _how_many(
                found, lambda trip: trip.apply(law.trips_to_wear_out, pairs, area, own.lining, own.wear, trip.energy)
            )
    if own.disc_mass is not None and own.specific_heat is not None:
        rises = _each(found, lambda trip: _rise_of(own, trip) * (1 - trip.lining_share))
    result = HeatResult(
        energy_source=slips.source,
        slip_time=OpenTriple.of(trip.time for trip in found.values()),
        energy=OpenTriple.of(trip.energy for trip in found.values()),
        specific_work=work,
        power_density=power,
        temperature_rise=rises,
        temperature=_temperatures(own, rises),
        surface_temperature_rise=faces,
        face_temperature=_temperatures(own, faces),
        temperature_limit=limit.low if limit and own.ambient is not None else None,
        **_trips(own, found, limit, rises),
        trips_to_wear_out=worn_out,
        **_setting(clutch, own),
    )
    return result, [*clutch_findings(clutch.spec, clutch.quantities), *remarks(clutch, own, result, slips)]


def _each(found: Mapping[str, HeatedSlip], of: Callable[[HeatedSlip], Values]) -> OpenTriple:
    """Of every trip that ends."""
    return OpenTriple.of(None if trip.energy is None else of(trip) for trip in found.values())


def _how_many(found: Mapping[str, HeatedSlip], of: Callable[[HeatedSlip], Values]) -> OpenTriple:
    """Of every trip that ends and gives heat: without it there may be any number."""
    return OpenTriple.of(of(trip) if trip.energy else None for trip in found.values())


def _temperatures(own: Heat, rises: OpenTriple | None) -> OpenTriple | None:
    if rises is None or own.ambient is None:
        return None
    return OpenTriple.of(None if rise is None else own.ambient + rise for rise in vars(rises).values())


def _shared(
    clutch: Clutch, own: Heat, slips: Mapping[str, HeatedSlip], area: float | None
) -> tuple[Mapping[str, HeatedSlip], OpenTriple | None]:
    """Share the heat of every slip among discs and lining: slips with the lining's share, rises of the faces.

    The faces are told where the disc is known; without a lining that is known the discs take all.
    """
    pairs = clutch.spec.friction_group.pairs
    if area is None or not (bodies := bodies_of(own, pairs, area)):
        return slips, None
    share = float(law.power_density(1.0, pairs, area))
    courses = {end: slip.course.times(share) for end, slip in slips.items() if slip.energy}
    found = dict(slips)
    for end, course in courses.items() if len(bodies) > 1 else ():
        found[end] = slips[end]._replace(lining_share=1 - most_in_disc(bodies, course) / course.heat[-1])
    rises = {end: largest_rise(bodies, course) for end, course in courses.items()}
    return found, OpenTriple.of(rises.get(end, slip.energy and 0.0) for end, slip in slips.items())


def bodies_of(own: Heat, pairs: Values, area: Values | None) -> list[Body]:
    """Disc, and lining if it is known; none where a figure is wanting."""
    if own.conductivity is None or own.density is None or own.specific_heat is None or area is None:
        return []
    depth = None if own.disc_mass is None else law.heated_depth(own.disc_mass, own.density, pairs, area)
    bodies = [Body(own.conductivity, own.density, own.specific_heat, depth)]
    lining: tuple[Any, ...] = own.lining_conductivity, own.lining_density, own.lining_specific_heat
    return bodies if None in lining else [*bodies, Body(*[*lining, own.lining])]


def _trips(
    own: Heat, found: Mapping[str, HeatedSlip], limit: Limit | None, rises: OpenTriple | None
) -> dict[str, OpenTriple | None]:
    """How many trips the limit allows, one upon the other and per hour."""
    if limit is None or own.ambient is None:
        return {}
    ambient, told = own.ambient, {}
    if rises is not None:
        told["trips_without_cooling"] = _how_many(
            found, lambda trip: trip.apply(law.trips_without_cooling, limit.low, ambient, _rise_of(own, trip))
        )
    if own.cooling is not None:
        told["trips_per_hour"] = _how_many(
            found, lambda trip: HOUR * trip.apply(law.trips_per_time, own.cooling, limit.low, ambient, trip.energy)
        )
        if rises is not None:
            told["trips_per_hour_peak"] = _how_many(
                found,
                lambda trip: _rate(
                    own, trip, trip.apply(law.share_of_rise, ambient + _rise_of(own, trip), ambient, limit.low)
                ),
            )
    return dict(told)


def _rise_of(own: Heat, trip: HeatedSlip) -> Values:
    """Rise of the discs with all the heat: between trips the lining gives back what it took."""
    return trip.apply(law.temperature_rise, trip.energy, own.disc_mass, own.specific_heat)


def _rate(own: Heat, trip: HeatedSlip, used: Values) -> float:
    """Trips per hour, each of which uses a share of the room up to the limit."""
    if used >= 1:
        return 0.0
    logarithm = -math.log1p(-used)
    return HOUR / float(trip.apply(law.time_between_trips, own.disc_mass, own.specific_heat, own.cooling, logarithm))


def _setting(clutch: Clutch, own: Heat) -> dict[str, float]:
    """Force on the pack that its wear costs: what presses it at rest follows it."""
    stiffness = clutch.following_stiffness
    if stiffness is None:
        return {}
    rest = clutch.quantities["pack_force_at_rest"]
    loss = clutch.quantities.apply(law.setting_loss_per_wear, stiffness, clutch.spec.friction_group.pairs, rest)
    worn = {} if own.lining is None else {"setting_loss_worn": clutch.lost_by_wear(own.lining) / rest}
    return {"setting_loss_per_wear": loss, **worn}


def trips(clutch: Clutch, answers: Answers | None = None) -> HeatedSlips:
    """Heat and time of a trip at f_min, mean and f_max.

    An event of the [drive] block is simulated; without one the tool is blocked (V1).

    Raises:
        SpecError: the [drive] block says too little.
    """
    drive = clutch.spec.drive
    if ANALYSES["simulate"].applies(clutch):
        return _simulated(answers or Answers(clutch))
    if missing := missing_of(drive):
        needed = say("required by heat (or give drive.event)")
        if drive.motor is not None:
            needed = say("required by heat beside drive.motor: the slip of a motor with a curve is simulated")
        problems = [Problem(f"drive.{key}", None, needed) for key in missing]
        raise SpecError(clutch.spec.label, problems)
    assert drive.speed is not None
    source: EnergySource = "constant-speed" if drive.motor_inertia is None else "run-down"
    motor = motor_torque(clutch)
    return HeatedSlips(
        source,
        {end: run_down(drive, at["torque"], motor, at.apply)._replace(apply=at.apply) for end, at in _ends(clutch)},
    )


def _ends(clutch: Clutch) -> Iterator[tuple[str, Quantities]]:
    """Ends of the range of friction, and the clutch there."""
    return ((end, clutch.quantities.at(f"f_{end}")) for end in ENDS)


def _simulated(answers: Answers) -> HeatedSlips:
    (found, said), clutch, at = answers.ask("simulate"), answers.clutch, {}
    told = found.sliding_torque, found.slip_time, found.slip_energy
    for end, there in counted(say("simulating the event"), [*_ends(clutch)]):
        torque, time, energy = (getattr(each, end) for each in told)
        at[end] = HeatedSlip(torque, time, energy, _course(answers.quiet, end), apply=there.apply)
    ends = tuple(each for each in said if each.path in ("drive.cut_off", "drive.event.duration"))
    return HeatedSlips("simulate", at, ends)


def _course(clutch: Clutch, end: str) -> Course:
    rows = case_of(clutch, *(getattr(own, end) for own in clutch.friction)).run().rows
    return course_of((row.time, float(law.slip_power(row.torque_clutch, row.slip)), row.heat) for row in rows)
