"""Heat and wear of a trip: work, temperature, trips per hour, trips until the lining is worn off, and findings."""

import math
from collections.abc import Iterator, Mapping
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
from ..result import OpenTriple
from ..spec.catalogues import Material, friction_materials
from ..spec.models import Heat, Spec
from ..units import ZEROS
from .asking import Answers
from .clutch_findings import carried_by_motor, clutch_findings, speed_findings
from .drive_result import EnergySource, HeatResult, ends_of
from .registry import ANALYSES

_ENDS = {"min": "f_min", "mean": "f_cp", "max": "f_max"}


class Slip(NamedTuple):
    """Slip of a trip at one friction; time and energy are None if the slip does not end."""

    time: Values | None
    energy: Values | None
    course: Course
    apply: Apply
    """Function that applies a law at the friction of the slip, and notes it as a step."""


Trips = tuple[EnergySource, dict[str, Slip], list[Finding]]
"""Source of the heat of a trip, its slips at f_min, mean friction and f_max, and findings on the end of the slip."""


def remarks(clutch: Clutch, given: Heat, result: HeatResult) -> Iterator[Finding]:
    """Yield findings on the temperature of a trip, and on missing data."""
    # discs or their faces melt: an error whatever temperature is allowed
    melted = (given.ambient or 0.0) + max(_most(result.temperature_rise), _most(result.surface_temperature_rise))
    if melted >= IRON_MELTS:
        yield finding("discs-melt", "error", value=melted, limit=IRON_MELTS, path="heat.disc_mass")
    yield from failures_of(clutch.spec, known := heat_values(result), "heat")
    limits, lining = limits_of(clutch), _weakest(clutch)
    if lining is not None and result.face_temperature is None and known["hottest"] is not None:
        yield finding("faces-not-judged", "info", path="friction_group.inner_radius", name=lining[1].name)
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
    if not limits:
        hottest, path = _most(result.face_temperature or result.temperature), "friction.material"
        listed = (clutch.spec.lists.materials or friction_materials()).values()
        allowed = [(one.temperature_max + _FREEZING, one.name) for one in listed if one.temperature_max is not None]
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


def _weakest(clutch: Clutch) -> tuple[str, Material] | None:
    """Path and row of the friction material that the spec names with the lowest allowable temperature."""
    named = [(path, row) for path, row in clutch.spec.friction.linings.items() if row.temperature_min is not None]
    return min(named, key=lambda each: given(each[1].temperature_min), default=None)


def limits_of(clutch: Clutch) -> dict[str, float]:
    """Path → temperature limit, K: a required mean temperature of the discs, of the faces, the limit of a material."""
    required, lining = clutch.spec.requirements, _weakest(clutch)
    asked = {f"requirements.{key}": getattr(required, key, None) for key in ("temperature", "face_temperature")}
    limits = {path: most for path, most in asked.items() if most is not None}
    return limits if lining is None else limits | {lining[0]: given(lining[1].temperature_min) + _FREEZING}


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


HOUR = 3600.0


def heat(clutch: Clutch, answers: Answers | None = None) -> tuple[HeatResult, list[Finding]]:
    """Calculate heat and wear of a trip from the blocks [drive] (what drives the clutch) and [heat] (its discs).

    Raises SpecError if [drive] lacks keys from which the heat of a trip follows; CalculationError if the ambient
    temperature reaches a limit of the discs.
    """
    source, slips, ended = trips(clutch, answers)
    own, limits, group, area = discs_of(clutch.spec), limits_of(clutch), clutch.spec.friction_group, None
    if group.inner_radius is not None and group.outer_radius is not None:
        area = clutch.apply(law.friction_area, group.inner_radius, group.outer_radius, math.pi)
    for path, low in limits.items():
        if own.ambient is not None and own.ambient >= low:
            raise CalculationError(
                "heat: heat.ambient, {ambient:.4g °C}, is no cooler than the {limit:.4g °C} that {path} allows",
                ambient=own.ambient,
                limit=low,
                path=path,
            )
    # the mean temperature of the discs over many trips
    limit = next((low for path, low in limits.items() if path != "requirements.face_temperature"), None)
    figures = [_figures(clutch, own, area, None if own.ambient is None else limit, slip) for slip in slips.values()]
    # relative loss of force on the pack at rest by wear, as the spring that presses the pack extends
    setting, stiffness = dict[str, float](), following_stiffness(clutch)
    if stiffness is not None:
        rest = clutch["pack_force_at_rest"]
        setting["setting_loss_per_wear"] = clutch.apply(law.setting_loss_per_wear, stiffness, group.pairs, rest)
        if own.lining is not None:
            setting["setting_loss_worn"] = lost_by_wear(clutch, own.lining) / rest
    result = HeatResult(
        energy_source=source, temperature_limit=None if own.ambient is None else limit,
        **{name: ends_of(each[name] for each in figures) for name in figures[0]}, **setting,
    )  # fmt: skip
    # properties of the discs that are assumed
    wrote = clutch.spec.heat or Heat()
    if listed := [f"heat.{name}" for name in STEEL if getattr(wrote, name) is None]:
        ended.append(finding("discs-of-steel", "info", path=listed[0], listed=", ".join(listed), **STEEL))
    if wrote.disc_mass is None and own.disc_mass is not None:
        ended.append(finding("discs-from-layout", "info", value=own.disc_mass, path="heat.disc_mass"))
    return result, [*clutch_findings(clutch), *ended, *remarks(clutch, own, result)]


def _figures(
    clutch: Clutch, own: Heat, area: float | None, limit: float | None, slip: Slip
) -> dict[str, Values | None]:
    """Name → result of a slip; None if the slip does not end, and for a number of trips if there is no heat.

    Without data of the lining the discs take all the heat; the temperature of the faces needs their ``area``.
    """
    (time, energy, course, apply), pairs, share = slip, clutch.spec.friction_group.pairs, 1.0
    ambient, mass, cooling = own.ambient, own.disc_mass, own.cooling
    found, rises = {"slip_time": time, "energy": energy}, dict[str, Values | None]()
    if area is not None:
        found["specific_work"] = energy and apply(law.specific_work, energy, pairs, area)
        found["power_density"] = apply(law.power_density, course.power.max(), pairs, area)
        rises["face_temperature"] = found["surface_temperature_rise"] = energy
        if energy:
            warmed = warming(layers_of(own, pairs, area), pairs * area, course)
            rises["face_temperature"] = found["surface_temperature_rise"] = float(warmed.face.max())
            share = float(warmed.disc.max() / course.heat[-1])
        if own.wear is not None and own.lining is not None and slack_before_worn(clutch, own) is None:
            worn = energy and apply(law.trips_to_wear_out, pairs, area, own.lining, own.wear, energy)
            found["trips_to_wear_out"] = worn or None
    rise = energy
    if mass is not None:
        # by all the heat: between trips the lining gives its heat back to the discs
        rise = energy and apply(law.temperature_rise, energy, mass, own.specific_heat)
        rises["temperature"] = found["temperature_rise"] = rise and rise * share
    if ambient is not None:
        found |= {name: None if each is None else ambient + each for name, each in rises.items()}
    if limit is None:
        return found
    if mass is not None:
        found["trips_without_cooling"] = apply(law.trips_without_cooling, limit, ambient, rise) if rise else None
    if cooling is not None:
        found["trips_per_hour"] = HOUR * apply(law.trips_per_time, cooling, limit, ambient, energy) if energy else None
    if cooling is not None and mass is not None:
        found["trips_per_hour_peak"] = None
        if rise:  # each trip ends at the temperature limit; 0 if one trip exceeds it
            used = apply(law.share_of_rise, given(ambient) + rise, ambient, limit)
            found["trips_per_hour_peak"] = 0.0
            if used < 1:
                between = apply(law.time_between_trips, mass, own.specific_heat, cooling, -math.log1p(-used))
                found["trips_per_hour_peak"] = HOUR / float(between)
    return found


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


def layers_of(own: Heat, pairs: int, area: float) -> list[Layer]:
    """Layers that take heat: the disc, and the lining if its data are known."""
    conductivity, density, specific_heat = given(own.conductivity), given(own.density), given(own.specific_heat)
    depth = None if own.disc_mass is None else law.heated_depth(own.disc_mass, density, pairs, area)
    layers = [Layer(conductivity, density, specific_heat, depth)]
    if own.lining_conductivity and own.lining_density and own.lining_specific_heat:
        layers.append(Layer(own.lining_conductivity, own.lining_density, own.lining_specific_heat, own.lining))
    return layers


def trips(clutch: Clutch, answers: Answers | None = None) -> Trips:
    """Heat and time of a trip: of the simulated event or, without an event, of a motor side that runs down.

    Raises SpecError if the spec lacks data of the drive.
    """
    spec, drive, ends = clutch.spec, clutch.spec.drive, {end: clutch.at(f"f_{end}") for end in _ENDS}
    if ANALYSES["simulate"].applies(clutch):
        return _simulated(answers or Answers(clutch), ends)
    if not spec.runs_down:
        raise without_event(spec)
    motor = drive.load_torque if drive.motor_torque is None else drive.motor_torque
    if motor is None:
        motor = clutch["running_torque"]
    slips = {end: run_down(spec, there["torque"], motor, there.apply) for end, there in ends.items()}
    found = [*speed_findings(spec)]
    if drive.motor_inertia is None:
        return "constant-speed", slips, found
    # the motor carries the slip torque
    if carried := {end: there["torque"] for end, there in ends.items() if there["torque"] <= motor}:
        least, at = float(min(carried.values())), ", ".join(translate(_ENDS[end], "symbol") for end in carried)
        heat = max(float(slips[end].energy or 0.0) for end in carried)
        found.append(carried_by_motor(least, float(motor), at, measured(least, "N*m", 5), heat, drive.cut_off))
    return "run-down", slips, found


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


def _simulated(answers: Answers, ends: Mapping[str, Quantities]) -> Trips:
    (found, said), slips = answers.ask("simulate"), {}
    for end, there in counted(say("simulating the event"), [*ends.items()]):
        rows = case_of(answers.quiet, *(getattr(own, end) for own in answers.clutch.spec.friction.groups)).run().rows
        moments = ((row.time, float(law.slip_power(row.torque_clutch, row.slip)), row.heat) for row in rows)
        time, energy = getattr(found.slip_time, end), getattr(found.slip_energy, end)
        slips[end] = Slip(time, energy, course_of(moments), there.apply)
    return "simulate", slips, [each for each in said if each.path in ("drive.cut_off", "drive.event.duration")]
