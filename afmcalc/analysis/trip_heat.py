"""Heat and wear of a trip: work, temperature, trips per hour, trips until the lining is gone, and the findings."""

import math
from collections.abc import Callable, Iterator, Mapping
from itertools import pairwise
from typing import Any, NamedTuple

from ..drive.cases import case_of
from ..drive.warming import Course, Layer, course_of, warming
from ..engines import Clutch
from ..engines.checks import failures_of
from ..engines.parts import following_spring, following_stiffness, lost_by_wear
from ..engines.quantities import Apply, Quantities
from ..equations import heat as law
from ..equations.arrays import Values
from ..errors import CalculationError, Problem, SpecError, given
from ..findings import Finding, Level, finding
from ..messages import measured, say, translate
from ..progress import counted
from ..result import OpenTriple, Triple
from ..spec.catalogues import Material, friction_materials
from ..spec.models import Drive, Heat, missing_of
from ..units import ZEROS
from .asking import Answers
from .clutch_findings import clutch_findings
from .drive_result import EnergySource, HeatResult
from .registry import ANALYSES

_ENDS = {"min": "f_min", "mean": "f_cp", "max": "f_max"}


class Slip(NamedTuple):
    """Slip of a trip at one friction; a time and an energy of None: it does not end."""

    time: Values | None
    energy: Values | None
    course: Course
    apply: Apply
    """Applies a law at the friction of the slip, and notes it."""


class Trips(NamedTuple):
    """The trip at f_min, mean and f_max, and where its heat is from."""

    source: EnergySource
    slips: Mapping[str, Slip]
    found: tuple[Finding, ...]
    """Of the end of the slip."""


def remarks(clutch: Clutch, given: Heat, result: HeatResult) -> Iterator[Finding]:
    """Findings on the temperature of a trip, and on missing data."""
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
    if following_stiffness(clutch) is None:
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


def _most(ends: OpenTriple | None) -> float:
    """Largest of the values at f_min, mean and f_max that are known, else 0."""
    return 0.0 if ends is None else max((value for value in vars(ends).values() if value is not None), default=0.0)


def slack_before_worn(clutch: Clutch, own: Heat) -> float | None:
    """Wear of a pair at which the spring that follows the pack falls slack, m; None where the lining is gone before."""
    spring = following_spring(clutch)
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
    """Allowable temperature of the faces: the lowest of the materials named."""
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
    """Limit of the mean temperature of the discs over many trips: what is required, else what the material allows."""
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
    source, slips, ended = trips(clutch, answers)
    own, limit, group = clutch.spec.heat or Heat(), limit_of(clutch), clutch.spec.friction_group
    pairs, area = group.pairs, None
    if group.inner_radius is not None and group.outer_radius is not None:
        area = clutch.apply(law.friction_area, group.inner_radius, group.outer_radius, math.pi)
    for each in limits_of(clutch):
        if own.ambient is not None and own.ambient >= each.low:
            raise CalculationError(
                "heat: heat.ambient, {ambient:.4g °C}, is no cooler than the {limit:.4g °C} that {path} allows",
                ambient=own.ambient,
                limit=each.low,
                path=each.path,
            )
    faces, shares = _warmed(own, pairs, area, slips)
    ends = slips.values()
    work = power = worn_out = rises = None
    if area is not None:
        work = OpenTriple.of(slip.energy and slip.apply(law.specific_work, slip.energy, pairs, area) for slip in ends)
        power = Triple.of(slip.apply(law.power_density, slip.course.power.max(), pairs, area) for slip in ends)
        if own.wear is not None and own.lining is not None and slack_before_worn(clutch, own) is None:
            worn_out = _how_many(
                slips, lambda slip: slip.apply(law.trips_to_wear_out, pairs, area, own.lining, own.wear, slip.energy)
            )
    if own.disc_mass is not None and own.specific_heat is not None:
        rises = OpenTriple.of(slip.energy and _rise_of(own, slip) * shares[end] for end, slip in slips.items())
    result = HeatResult(
        energy_source=source,
        slip_time=OpenTriple.of(slip.time for slip in ends),
        energy=OpenTriple.of(slip.energy for slip in ends),
        specific_work=work,
        power_density=power,
        temperature_rise=rises,
        temperature=_temperatures(own, rises),
        surface_temperature_rise=faces,
        face_temperature=_temperatures(own, faces),
        temperature_limit=limit.low if limit and own.ambient is not None else None,
        **_numbers_of_trips(own, slips, limit),
        trips_to_wear_out=worn_out,
        **_setting(clutch, own),
    )
    return result, [*clutch_findings(clutch), *ended, *remarks(clutch, own, result)]


def _how_many(slips: Mapping[str, Slip], of: Callable[[Slip], Values]) -> OpenTriple:
    """Of every slip that ends and gives heat: without it there may be any number."""
    return OpenTriple.of(of(slip) if slip.energy else None for slip in slips.values())


def _temperatures(own: Heat, rises: OpenTriple | None) -> OpenTriple | None:
    if rises is None or own.ambient is None:
        return None
    return OpenTriple.of(None if rise is None else own.ambient + rise for rise in vars(rises).values())


def _warmed(
    own: Heat, pairs: int, area: float | None, slips: Mapping[str, Slip]
) -> tuple[OpenTriple | None, Mapping[str, float]]:
    """Largest rises of the faces where the disc is known, and largest shares of the heat that are in the discs.

    Without a lining that is known the discs take all.
    """
    faces: dict[str, Values | None] = {end: slip.energy and 0.0 for end, slip in slips.items()}
    shares = dict.fromkeys(slips, 1.0)
    if area is None or not (layers := layers_of(own, pairs, area)):
        return None, shares
    for end, slip in slips.items():
        if slip.energy:
            warmed = warming(layers, pairs * area, slip.course)
            faces[end] = float(warmed.face.max())
            shares[end] = float(warmed.disc.max() / slip.course.heat[-1])
    return OpenTriple.of(faces.values()), shares


def layers_of(own: Heat, pairs: int, area: float) -> list[Layer]:
    """Disc, and lining if it is known; none where a figure is wanting."""
    if own.conductivity is None or own.density is None or own.specific_heat is None:
        return []
    depth = None if own.disc_mass is None else law.heated_depth(own.disc_mass, own.density, pairs, area)
    layers = [Layer(own.conductivity, own.density, own.specific_heat, depth)]
    if own.lining_conductivity and own.lining_density and own.lining_specific_heat:
        layers.append(Layer(own.lining_conductivity, own.lining_density, own.lining_specific_heat, own.lining))
    return layers


def _numbers_of_trips(own: Heat, slips: Mapping[str, Slip], limit: Limit | None) -> dict[str, OpenTriple]:
    """How many trips the limit allows, one upon the other and per hour."""
    numbers: dict[str, OpenTriple] = {}
    if limit is None or own.ambient is None:
        return numbers
    most, ambient, known = limit.low, own.ambient, own.disc_mass is not None and own.specific_heat is not None
    if known:
        numbers["trips_without_cooling"] = _how_many(
            slips, lambda slip: slip.apply(law.trips_without_cooling, most, ambient, _rise_of(own, slip))
        )
    if own.cooling is not None:
        numbers["trips_per_hour"] = _how_many(
            slips, lambda slip: HOUR * slip.apply(law.trips_per_time, own.cooling, most, ambient, slip.energy)
        )
    if own.cooling is not None and known:
        numbers["trips_per_hour_peak"] = _how_many(slips, lambda slip: _rate(own, slip, most, ambient))
    return numbers


def _rise_of(own: Heat, slip: Slip) -> Values:
    """Rise of the discs with all the heat: between trips the lining gives back what it took."""
    rise: Values = slip.apply(law.temperature_rise, slip.energy, own.disc_mass, own.specific_heat)
    return rise


def _rate(own: Heat, slip: Slip, limit: float, ambient: float) -> float:
    """Trips per hour that each end at the limit."""
    used = slip.apply(law.share_of_rise, ambient + _rise_of(own, slip), ambient, limit)
    if used >= 1:
        return 0.0
    logarithm = -math.log1p(-used)
    return HOUR / float(slip.apply(law.time_between_trips, own.disc_mass, own.specific_heat, own.cooling, logarithm))


def _setting(clutch: Clutch, own: Heat) -> dict[str, float]:
    """Force on the pack that its wear costs: what presses it at rest follows it."""
    stiffness = following_stiffness(clutch)
    if stiffness is None:
        return {}
    rest = clutch["pack_force_at_rest"]
    loss = clutch.apply(law.setting_loss_per_wear, stiffness, clutch.spec.friction_group.pairs, rest)
    worn = {} if own.lining is None else {"setting_loss_worn": lost_by_wear(clutch, own.lining) / rest}
    return {"setting_loss_per_wear": loss, **worn}


def trips(clutch: Clutch, answers: Answers | None = None) -> Trips:
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
        raise SpecError(clutch.spec.label, [Problem(f"drive.{key}", None, needed) for key in missing])
    motor = drive.load_torque if drive.motor_torque is None else drive.motor_torque
    if motor is None:
        motor = clutch["running_torque"]
    ends = dict(_ends(clutch))
    slips = {end: run_down(drive, there["torque"], motor, there.apply) for end, there in ends.items()}
    if drive.motor_inertia is None:
        return Trips("constant-speed", slips, ())
    carried = {end: there["torque"] for end, there in ends.items() if there["torque"] <= motor}
    return Trips("run-down", slips, tuple(_carried(drive, carried, slips, motor)) if carried else ())


def run_down(drive: Drive, torque: Values, motor: Values, apply: Apply) -> Slip:
    """V1 until the motor side stands or is switched off; switched off it runs down against the clutch alone."""
    assert drive.speed is not None
    inertia, off, speed = drive.motor_inertia, drive.cut_off, drive.speed
    moments: list[tuple[Values, Values]] = [(0.0, speed)]
    if inertia is None or torque <= motor:
        moments += [] if off is None else [(off, speed)]
    elif off is None or law.run_down_time(inertia, speed, torque, motor) <= off:
        moments.append((apply(law.run_down_time, inertia, speed, torque, motor), 0.0))
    else:
        moments.append((off, apply(law.speed_after, speed, inertia, torque, motor, off)))
    time, last = moments[-1]
    if inertia is not None and time and last:
        moments.append((time + apply(law.run_down_time, inertia, last, torque, 0.0), 0.0))
    course, energy = [(0.0, float(law.slip_power(torque, speed)), 0.0)], 0.0
    for (before, first), (time, last) in pairwise(moments):
        energy = energy + apply(law.slip_energy, torque, first, last, time - before)
        course.append((float(time), float(law.slip_power(torque, last)), float(energy)))
    ended = len(moments) > 1
    return Slip(time if ended else None, energy if ended else None, course_of(course), apply)


def _carried(
    drive: Drive, torques: Mapping[str, Values], slips: Mapping[str, Slip], motor: Values
) -> Iterator[Finding]:
    """Say where the motor carries the slip torque."""
    off, least = drive.cut_off, float(min(torques.values()))
    code = "motor-never-stops" if off is None else "motor-stops-at-cut-off"
    level: Level = "error" if off is None else "info"
    at, heat = (
        ", ".join(translate(_ENDS[end], "symbol") for end in torques),
        max(float(slips[end].energy or 0.0) for end in torques),
    )
    carries = measured(least, "N*m", 5)
    path, motor = "drive.cut_off", float(motor)
    yield finding(code, level, value=least, limit=motor, path=path, at=at, carries=carries, heat=heat, off=off)


def _ends(clutch: Clutch) -> Iterator[tuple[str, Quantities]]:
    """Ends of the range of friction, and the clutch there."""
    return ((end, clutch.at(f"f_{end}")) for end in _ENDS)


def _simulated(answers: Answers) -> Trips:
    (found, said), slips = answers.ask("simulate"), {}
    for end, there in counted(say("simulating the event"), [*_ends(answers.clutch)]):
        time, energy = getattr(found.slip_time, end), getattr(found.slip_energy, end)
        rows = case_of(answers.quiet, *(getattr(own, end) for own in answers.clutch.spec.friction.groups)).run().rows
        moments = ((row.time, float(law.slip_power(row.torque_clutch, row.slip)), row.heat) for row in rows)
        slips[end] = Slip(time, energy, course_of(moments), there.apply)
    ended = tuple(each for each in said if each.path in ("drive.cut_off", "drive.event.duration"))
    return Trips("simulate", slips, ended)
