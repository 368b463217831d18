"""Heat and wear of a trip: work, temperature, trips per hour, trips until the lining is worn off, and findings."""

import math
from collections.abc import Callable, Iterator, Mapping
from itertools import pairwise
from typing import Any, NamedTuple

from ..drive.cases import case_of
from ..drive.train import without_event
from ..drive.warming import Course, Layer, course_of, warming
from ..engines import Clutch
from ..engines.checks import failures_of
from ..engines.parts import following_spring, following_stiffness, lost_by_wear
from ..engines.quantities import Apply, Quantities
from ..equations import heat as law
from ..equations import springs
from ..equations.arrays import Values
from ..errors import CalculationError, given
from ..findings import Finding, finding
from ..messages import measured, say, translate
from ..progress import counted
from ..result import OpenTriple, Triple
from ..spec.catalogues import Material, friction_materials
from ..spec.models import Heat, Spec
from ..units import ZEROS
from .asking import Answers
from .clutch_findings import carried_by_motor, clutch_findings, speed_findings
from .drive_result import EnergySource, HeatResult
from .registry import ANALYSES

_ENDS = {"min": "f_min", "mean": "f_cp", "max": "f_max"}


class Slip(NamedTuple):
    """Slip of a trip at one friction; time and energy are None if the slip does not end."""

    time: Values | None
    energy: Values | None
    course: Course
    apply: Apply
    """Function that applies a law at the friction of the slip, and notes it as a step."""


class Trips(NamedTuple):
    """The trip at f_min, mean friction and f_max, and the source of its heat."""

    source: EnergySource
    slips: Mapping[str, Slip]
    found: tuple[Finding, ...]
    """Findings on the end of the slip."""


def remarks(clutch: Clutch, given: Heat, result: HeatResult) -> Iterator[Finding]:
    """Yield findings on the temperature of a trip, and on missing data."""
    # discs or their faces melt: an error whatever temperature is allowed
    melted = (given.ambient or 0.0) + max(_most(result.temperature_rise), _most(result.surface_temperature_rise))
    if melted >= IRON_MELTS:
        yield finding("discs-melt", "error", value=melted, limit=IRON_MELTS, path="heat.disc_mass")
    yield from failures_of(clutch.spec, known := heat_values(result), "heat")
    lining = material_limit(clutch)
    if lining is not None and result.face_temperature is None and known["hottest"] is not None:
        yield finding("faces-not-judged", "info", path="friction_group.inner_radius", name=lining.name)
    if result.surface_temperature_rise is not None:
        # assumptions on which the temperature of the faces rests
        if given.lining_conductivity is None:
            yield finding("discs-take-all", "info", path="heat.lining_conductivity")
        elif given.lining is None:
            yield finding("lining-thick", "info", path="heat.lining")
        if given.disc_mass is None:
            yield finding("discs-thick", "info", path="heat.disc_mass")
    # the spring falls slack before the lining is worn off: a number of trips makes no sense
    if (wear := slack_before_worn(clutch, given)) is not None:
        yield finding("spring-slack-before-worn", "warning", value=wear, limit=given.lining, path="heat.lining")
    # keys of the spec that would give the missing results
    wanted = ("disc_mass", "ambient", "cooling", "wear", "lining")
    radii = [] if clutch.spec.friction_group.inner_radius is not None else ["inner_radius", "outer_radius"]
    missing = [f"friction_group.{key}" for key in radii]
    missing += [f"heat.{key}" for key in wanted if getattr(given, key) is None]
    if following_stiffness(clutch) is None:
        missing.append("closing_spring.stiffness")
    if missing:
        yield finding("heat-not-told", "info", listed=", ".join(missing))
    # without a limit, a temperature above that of the best material in the catalogue still gives a warning
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
    """Largest known value at f_min, mean friction and f_max; 0 if no value is known."""
    return 0.0 if ends is None else max((value for value in vars(ends).values() if value is not None), default=0.0)


def slack_before_worn(clutch: Clutch, own: Heat) -> float | None:
    """Wear of a pair at which the spring that presses the pack falls slack, m; None if the lining is worn off first."""
    spring = following_spring(clutch)
    if own.lining is None or (spring.disc is None and not spring.straight_stiffness):
        return None
    wear = float(spring.deflection) / clutch.spec.friction_group.pairs
    return wear if wear < own.lining * (1 - 1e-9) else None


_FREEZING = float(ZEROS["degC"])
IRON_MELTS = 1811.0
"""Melting point of iron, K (CRC Handbook of Chemistry and Physics); steel and cast iron melt below it."""


class Limit(NamedTuple):
    """Temperature limit of the discs, K: a requirement (low = high), or the range that a material allows."""

    low: float
    high: float
    path: str
    name: str | None
    """Name of the material; None if a requirement of the spec sets the limit."""


def material_limit(clutch: Clutch) -> Limit | None:
    """Allowable temperature of the faces: the lowest limit of the friction materials that the spec names."""
    linings = clutch.spec.friction.linings.items()
    allowing = [(path, material) for path, material in linings if material.temperature_min is not None]
    if not allowing:
        return None
    path, material = min(allowing, key=lambda each: _allowed(each[1])[0])
    return Limit(*_allowed(material), path, material.name)


def limits_of(clutch: Clutch) -> list[Limit]:
    """All temperature limits; a required mean temperature of the discs comes first."""
    required = clutch.spec.requirements
    given = {} if required is None else {key: getattr(required, key) for key in ("temperature", "face_temperature")}
    asked = [Limit(most, most, f"requirements.{key}", None) for key, most in given.items() if most is not None]
    material = material_limit(clutch)
    return [*asked, *([] if material is None else [material])]


def limit_of(clutch: Clutch) -> Limit | None:
    """Limit of the mean disc temperature over many trips: a requirement, else the limit of the material."""
    return next((each for each in limits_of(clutch) if each.path != "requirements.face_temperature"), None)


def heat_values(result: HeatResult) -> dict[str, Any]:
    """Return the values to check against limits: over the friction range, largest values and fewest trips per hour.

    ``open`` names the values that may be worse because a slip has not ended.
    """
    named = ("specific_work", "temperature", "face_temperature")
    ends = {name: [*vars(triple).values()] for name in named if (triple := getattr(result, name)) is not None}
    most = {name: max((value for value in values if value is not None), default=None) for name, values in ends.items()}
    known: dict[str, Any] = {**most, "hottest": most.get("face_temperature", most.get("temperature"))}
    known["open"] = {name for name, values in ends.items() if None in values}
    if result.trips_per_hour is not None:
        trips = [value for value in vars(result.trips_per_hour).values() if value is not None]
        known["trips_per_hour"] = min(trips, default=math.inf)  # slip without heat allows any number of trips
        known["open"] |= {"trips_per_hour"} if None in vars(result.energy).values() else set()
    return known


def _allowed(material: Material) -> tuple[float, float]:
    """Range of temperatures that a material allows, K."""
    return given(material.temperature_min) + _FREEZING, given(material.temperature_max) + _FREEZING


HOUR = 3600.0


def heat(clutch: Clutch, answers: Answers | None = None) -> tuple[HeatResult, list[Finding]]:
    """Calculate heat and wear of a trip from the blocks [drive] (what drives the clutch) and [heat] (its discs).

    Raises:
        SpecError: the [drive] block lacks keys from which the heat of a trip follows.
        CalculationError: the ambient temperature reaches a limit of the discs.
    """
    source, slips, ended = trips(clutch, answers)
    own, limit, group = discs_of(clutch.spec), limit_of(clutch), clutch.spec.friction_group
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
    if own.disc_mass is not None:
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
    return result, [*clutch_findings(clutch), *ended, *_taken(clutch.spec, own), *remarks(clutch, own, result)]


STEEL = {"density": 7850.0, "specific_heat": 480.0, "conductivity": 50.0}
"""Unalloyed steel: EN 1993-1-2 at 100 °C, 488 J/(kg·K) and 50.7 W/(m·K), rounded down to the safe side (warmer)."""


def discs_of(spec: Spec) -> Heat:
    """The [heat] block; by default its discs are of steel and have the mass of the discs in the layout."""
    own, room, group = spec.heat or Heat(), spec.envelope, spec.friction_group
    taken = {name: value for name, value in STEEL.items() if getattr(own, name) is None}
    if own.disc_mass is None and room is not None and room.disc_thickness > (own.lining or 0.0):
        length = group.pairs * (room.disc_thickness - (own.lining or 0.0))
        density, outer, inner = own.density or STEEL["density"], given(group.outer_radius), given(group.inner_radius)
        taken["disc_mass"] = float(springs.ring_mass(density, 2 * outer, 2 * inner, length, math.pi))
    return own.model_copy(update=taken)


def _taken(spec: Spec, own: Heat) -> Iterator[Finding]:
    """Yield findings on properties of the discs that are assumed."""
    wrote = spec.heat or Heat()
    listed = [f"heat.{name}" for name in STEEL if getattr(wrote, name) is None]
    if listed:
        yield finding("discs-of-steel", "info", path=listed[0], listed=", ".join(listed), **STEEL)
    if wrote.disc_mass is None and own.disc_mass is not None:
        yield finding("discs-from-layout", "info", value=own.disc_mass, path="heat.disc_mass")


def _how_many(slips: Mapping[str, Slip], of: Callable[[Slip], Values]) -> OpenTriple:
    """Number of trips at each friction whose slip ends and gives heat, else None; without heat it is unlimited."""
    return OpenTriple.of(of(slip) if slip.energy else None for slip in slips.values())


def _temperatures(own: Heat, rises: OpenTriple | None) -> OpenTriple | None:
    if rises is None or own.ambient is None:
        return None
    return OpenTriple.of(None if rise is None else own.ambient + rise for rise in vars(rises).values())


def _warmed(
    own: Heat, pairs: int, area: float | None, slips: Mapping[str, Slip]
) -> tuple[OpenTriple | None, Mapping[str, float]]:
    """Largest temperature rises of the faces, and largest shares of the heat that are in the discs.

    The rises are None if the area of the faces is not known; without data of the lining the discs take all the heat.
    """
    faces: dict[str, Values | None] = {end: slip.energy and 0.0 for end, slip in slips.items()}
    shares = dict.fromkeys(slips, 1.0)
    if area is None:
        return None, shares
    layers = layers_of(own, pairs, area)
    for end, slip in slips.items():
        if slip.energy:
            warmed = warming(layers, pairs * area, slip.course)
            faces[end] = float(warmed.face.max())
            shares[end] = float(warmed.disc.max() / slip.course.heat[-1])
    return OpenTriple.of(faces.values()), shares


def layers_of(own: Heat, pairs: int, area: float) -> list[Layer]:
    """Layers that take heat: the disc, and the lining if its data are known."""
    conductivity, density, specific_heat = given(own.conductivity), given(own.density), given(own.specific_heat)
    depth = None if own.disc_mass is None else law.heated_depth(own.disc_mass, density, pairs, area)
    layers = [Layer(conductivity, density, specific_heat, depth)]
    if own.lining_conductivity and own.lining_density and own.lining_specific_heat:
        layers.append(Layer(own.lining_conductivity, own.lining_density, own.lining_specific_heat, own.lining))
    return layers


def _numbers_of_trips(own: Heat, slips: Mapping[str, Slip], limit: Limit | None) -> dict[str, OpenTriple]:
    """Numbers of trips that the limit allows: one after the other without cooling, and per hour."""
    numbers: dict[str, OpenTriple] = {}
    if limit is None or own.ambient is None:
        return numbers
    most, ambient, known = limit.low, own.ambient, own.disc_mass is not None
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
    """Temperature rise of the discs by all the heat: between trips the lining gives its heat back to the discs."""
    rise: Values = slip.apply(law.temperature_rise, slip.energy, own.disc_mass, own.specific_heat)
    return rise


def _rate(own: Heat, slip: Slip, limit: float, ambient: float) -> float:
    """Number of trips per hour at which each trip ends at the temperature limit; 0 if one trip exceeds it."""
    used = slip.apply(law.share_of_rise, ambient + _rise_of(own, slip), ambient, limit)
    if used >= 1:
        return 0.0
    logarithm = -math.log1p(-used)
    return HOUR / float(slip.apply(law.time_between_trips, own.disc_mass, own.specific_heat, own.cooling, logarithm))


def _setting(clutch: Clutch, own: Heat) -> dict[str, float]:
    """Relative loss of force on the pack at rest by wear, as the spring that presses the pack extends."""
    stiffness = following_stiffness(clutch)
    if stiffness is None:
        return {}
    rest = clutch["pack_force_at_rest"]
    loss = clutch.apply(law.setting_loss_per_wear, stiffness, clutch.spec.friction_group.pairs, rest)
    worn = {} if own.lining is None else {"setting_loss_worn": lost_by_wear(clutch, own.lining) / rest}
    return {"setting_loss_per_wear": loss, **worn}


def trips(clutch: Clutch, answers: Answers | None = None) -> Trips:
    """Heat and time of a trip at f_min, mean friction and f_max.

    An event in the [drive] block is simulated; without an event the tool is blocked and the motor side runs down.

    Raises:
        SpecError: the spec lacks data of the drive.
    """
    spec, drive = clutch.spec, clutch.spec.drive
    if ANALYSES["simulate"].applies(clutch):
        return _simulated(answers or Answers(clutch))
    if not spec.runs_down:
        raise without_event(spec)
    motor = drive.load_torque if drive.motor_torque is None else drive.motor_torque
    if motor is None:
        motor = clutch["running_torque"]
    ends = dict(_ends(clutch))
    slips = {end: run_down(spec, there["torque"], motor, there.apply) for end, there in ends.items()}
    found = (*speed_findings(spec),)
    if drive.motor_inertia is None:
        return Trips("constant-speed", slips, found)
    carried = {end: there["torque"] for end, there in ends.items() if there["torque"] <= motor}
    if carried:
        found += (_carried(drive.cut_off, carried, slips, motor),)
    return Trips("run-down", slips, found)


def run_down(spec: Spec, torque: Values, motor: Values, apply: Apply) -> Slip:
    """Slip with a blocked tool until the motor side stands; once switched off, only the clutch brakes it."""
    inertia, off, speed = spec.drive.motor_inertia, spec.drive.cut_off, spec.speed
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


def _carried(off: float | None, torques: Mapping[str, Values], slips: Mapping[str, Slip], motor: Values) -> Finding:
    """Finding that the motor carries the slip torque, with the frictions at which it does."""
    least, at = float(min(torques.values())), ", ".join(translate(_ENDS[end], "symbol") for end in torques)
    heat = max(float(slips[end].energy or 0.0) for end in torques)
    return carried_by_motor(least, float(motor), at, measured(least, "N*m", 5), heat, off)


def _ends(clutch: Clutch) -> Iterator[tuple[str, Quantities]]:
    """Names of f_min, mean friction and f_max, and the clutch at each."""
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
