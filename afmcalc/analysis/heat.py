"""Heat and wear of a trip: work, temperature, trips per hour, trips until the lining is gone."""

import math
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from ..arrays import Values
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
from ..engines.protocol import Clutch
from ..equations import heat as law
from ..equations.calls import derived, unnoted
from ..errors import CalculationError, Problem, SpecError
from ..findings import Finding
from ..messages import say
from ..progress import counted
from ..result import OpenTriple, Triple
from ..spec.models import Heat, missing_of
from .heat_findings import Limit, limit_of, limits_of, remarks, slack_before_worn
from .registry import ANALYSES

if TYPE_CHECKING:
    from .answers import Answers

HOUR = 3600.0


def heat(clutch: Clutch, answers: "Answers | None" = None) -> tuple[HeatResult, list[Finding]]:
    """Calculate heat and wear of a trip.

    Args:
        clutch: the clutch; its spec says what drives it ([drive]), and of its discs what is known ([heat]).
        answers: what was asked of it already.

    Returns:
        The result and its findings.

    Raises:
        SpecError: the [drive] block does not tell the heat of a trip.
        CalculationError: the surroundings are hotter than what the material allows.
    """
    slips = trips(clutch, answers)
    own, limit, group = clutch.spec.heat or Heat(), limit_of(clutch), clutch.spec.friction_group
    pairs, area = group.pairs, None
    if group.inner_radius is not None and group.outer_radius is not None:
        area = law.friction_area(group.inner_radius, group.outer_radius, math.pi)
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
        work = _each(found, lambda trip: law.specific_work(trip.energy, pairs, area))
        powers = {end: derived(found[end].course.largest, getattr(clutch.friction[1], end)) for end in ENDS}
        power = Triple(**{end: law.power_density(powers[end], pairs, area) for end in ENDS})
        if own.wear is not None and own.lining is not None and slack_before_worn(clutch, own) is None:
            worn_out = _how_many(
                found, lambda trip: law.trips_to_wear_out(pairs, area, own.lining, own.wear, trip.energy)
            )
    if own.disc_mass is not None and own.specific_heat is not None:
        rises = _each(found, lambda trip: _rise_of(own, trip) * (1 - trip.lining_share))
    result = HeatResult(
        energy_source=slips.source,
        slip_time=OpenTriple(**{end: found[end].time for end in ENDS}),
        energy=OpenTriple(**{end: found[end].energy for end in ENDS}),
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
    return result, [*clutch.findings(), *remarks(clutch, own, result, slips)]


def _each(found: Mapping[str, HeatedSlip], of: Callable[[HeatedSlip], Values]) -> OpenTriple:
    """Of every trip that ends."""
    return OpenTriple(**{end: None if found[end].energy is None else of(found[end]) for end in ENDS})


def _how_many(found: Mapping[str, HeatedSlip], of: Callable[[HeatedSlip], Values]) -> OpenTriple:
    """Of every trip that ends and gives heat: without it there may be any number."""
    return OpenTriple(**{end: of(found[end]) if found[end].energy else None for end in ENDS})


def _temperatures(own: Heat, rises: OpenTriple | None) -> OpenTriple | None:
    if rises is None or own.ambient is None:
        return None
    after = {end: getattr(rises, end) for end in ENDS}
    return OpenTriple(**{end: None if rise is None else own.ambient + rise for end, rise in after.items()})


def _shared(
    clutch: Clutch, own: Heat, slips: Mapping[str, HeatedSlip], area: float | None
) -> tuple[Mapping[str, HeatedSlip], OpenTriple | None]:
    """Share the heat of every slip among discs and lining: slips with the lining's share, rises of the faces.

    The faces are told where the disc is known; without a lining that is known the discs take all.
    """
    pairs = clutch.spec.friction_group.pairs
    with unnoted():  # no formula leads to it: the numbers of its solution are no steps
        if area is None or not (bodies := bodies_of(own, pairs, area)):
            return slips, None
        share = float(law.power_density(1.0, pairs, area))
        courses = {end: slip.course.times(share) for end, slip in slips.items() if slip.energy}
        found = dict(slips)
        for end, course in courses.items() if len(bodies) > 1 else ():
            found[end] = slips[end]._replace(lining_share=1 - most_in_disc(bodies, course) / course.heat[-1])
        rises = {end: largest_rise(bodies, course) for end, course in courses.items()}
    return found, OpenTriple(**{end: rises.get(end, slip.energy and 0.0) for end, slip in slips.items()})


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
            found, lambda trip: law.trips_without_cooling(limit.low, ambient, _rise_of(own, trip))
        )
    if own.cooling is not None:
        told["trips_per_hour"] = _how_many(
            found, lambda trip: HOUR * law.trips_per_time(own.cooling, limit.low, ambient, trip.energy)
        )
        if rises is not None:
            told["trips_per_hour_peak"] = _how_many(
                found,
                lambda trip: _rate(
                    own, law.share_of_rise(derived(ambient + _rise_of(own, trip), trip.energy), ambient, limit.low)
                ),
            )
    return dict(told)


def _rise_of(own: Heat, trip: HeatedSlip) -> Values:
    """Rise of the discs with all the heat: between trips the lining gives back what it took."""
    return law.temperature_rise(trip.energy, own.disc_mass, own.specific_heat)


def _rate(own: Heat, used: Values) -> float:
    """Trips per hour, each of which uses a share of the room up to the limit."""
    if used >= 1:
        return 0.0
    logarithm = derived(-math.log1p(-used), used)
    return HOUR / float(law.time_between_trips(own.disc_mass, own.specific_heat, own.cooling, logarithm))


def _setting(clutch: Clutch, own: Heat) -> dict[str, float]:
    """Force on the pack that its wear costs: what presses it at rest follows it."""
    stiffness = clutch.following_stiffness
    if stiffness is None:
        return {}
    loss = law.setting_loss_per_wear(stiffness, clutch.spec.friction_group.pairs, clutch.pack_force_at_rest)
    rest = clutch.pack_force_at_rest
    worn = {} if own.lining is None else {"setting_loss_worn": clutch.lost_by_wear(own.lining) / rest}
    return {"setting_loss_per_wear": loss, **worn}


def trips(clutch: Clutch, answers: "Answers | None" = None) -> HeatedSlips:
    """Heat and time of a trip at f_min, mean and f_max.

    An event of the [drive] block is simulated; without one the tool is blocked (V1).

    Args:
        clutch: the clutch; the [drive] block of its spec says what drives it.
        answers: what was asked of it already.

    Raises:
        SpecError: the [drive] block says too little.
        AfmcalcError: there is an event, and SciPy is missing: another way would give other digits.
    """
    drive = clutch.spec.drive
    if ANALYSES["simulate"].applies(clutch):
        return _simulated(clutch, answers)
    if missing := missing_of(drive):
        needed = say("required by heat (or give drive.event)")
        if drive.motor is not None:
            needed = say("required by heat beside drive.motor: the slip of a motor with a curve is simulated")
        problems = [Problem(f"drive.{key}", None, needed) for key in missing]
        raise SpecError(clutch.spec.label, problems)
    assert drive.speed is not None
    source: EnergySource = "constant-speed" if drive.motor_inertia is None else "run-down"
    motor = motor_torque(clutch)
    return HeatedSlips(source, {end: _of(clutch, end, run_down(drive, _torque(clutch, end), motor)) for end in ENDS})


def _simulated(clutch: Clutch, answers: "Answers | None") -> HeatedSlips:
    from .simulate import simulate

    found, said = simulate(clutch) if answers is None else answers.ask("simulate")
    told = found.sliding_torque, found.slip_time, found.slip_energy
    at = {}
    for end in counted(say("simulating the event"), ENDS):
        torque, time, energy = (getattr(each, end) for each in told)
        at[end] = _of(clutch, end, HeatedSlip(torque, time, energy, _course(clutch, end)))
    ends = tuple(each for each in said if each.path in ("drive.cut_off", "drive.event.duration"))
    return HeatedSlips("simulate", at, ends)


@unnoted()
def _course(clutch: Clutch, end: str) -> Course:
    course = case_of(clutch, *(getattr(own, end) for own in clutch.friction)).run().course
    return course_of((each.time, float(law.slip_power(each.torque, each.slip)), each.heat) for each in course)


def _of(clutch: Clutch, end: str, slip: HeatedSlip) -> HeatedSlip:
    """The slip, and for an explanation the friction that its heat is for."""
    return slip if slip.energy is None else slip._replace(energy=derived(slip.energy, getattr(clutch.friction[1], end)))


def _torque(clutch: Clutch, end: str) -> Values:
    return clutch.torque(*(getattr(own, end) for own in clutch.friction))
