"""The drive in time: what happens when the clutch trips, what it asks of the parts, and what an ordinary one does."""

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

import numpy as np

from ..drive.cases import Case, Outcome, case_of, outcome_of
from ..drive.integrator import CLOSE, CLOSE_CLUTCH, CLOSED, SPREAD, Event, Row, peak_time
from ..drive.pack_and_sleeve import Sleeve
from ..drive.train import Train, train_of
from ..engines import Clutch
from ..engines.checks import Beside, failures_of
from ..engines.parts import checks_of_springs
from ..equations import control_unit
from ..equations import drive as law
from ..equations.arrays import Floats, Values
from ..errors import CalculationError
from ..findings import Finding, Level, finding
from ..messages import measured, say, translate
from ..progress import counted
from ..result import Answer, AtEnds, OpenTriple, Result, Triple, described, quantity
from .clutch_findings import clutch_findings
from .drive_result import SimulatePoint, SimulateResult, SimulateSweep
from .neglected import with_pairs
from .pocket_wall import wall_of
from .registry import ANALYSES
from .sweep import Axis, replaced, series
from .synthesize import pocket
from .torque import Pair, friction_fields, outside_range, pairs_asked


def _end_symbols() -> tuple[str, str, str]:
    """Symbols of the smallest, the mean and the largest friction."""
    return "f_min", translate("f_cp", "symbol"), "f_max"


_NEAR = 1e-3
"""Relative difference below which a figure of the spec is what the simulation gives."""
_ROUNDING = 1e-9
_MOMENTS = 2000
"""Moments of a history, about."""


def remarks_of(clutch: Clutch, train: Train, outcomes: Sequence[Outcome], result: SimulateResult) -> Iterator[Finding]:
    """Return the remarks on an event, ``outcomes`` at f_min, mean friction and f_max, and on its ``result``."""
    yield _inertia(train, outcomes)
    taken = {"driven_inertia": train.driven_inertia, "hub_inertia": train.hub_inertia}
    for name, inertia in taken.items():
        if inertia and getattr(clutch.spec.drive, name) is None:
            yield finding("inertia-from-layout", "info", value=float(inertia), path=f"drive.{name}")
    # where the ordinary clutch of equal nominal torque is no like for like comparison
    load, carried = train.load, float(min(one.ordinary.pack.sliding for one in outcomes))
    if train.hub_inertia:
        inertia = train.driven_inertia + train.hub_inertia
        yield finding("ordinary-carries-hub", "info", value=inertia, path="drive.hub_inertia")
    if carried < load * (1 - _ROUNDING):
        yield finding("ordinary-slips-before-event", "info", value=carried, limit=load, path="adjustment.method")
    # does the clutch carry the load before the event, the motor drive it?
    for end, one in zip(_end_symbols(), outcomes, strict=True):
        if (carried := float(one.case.pack.breakaway)) < load * (1 - _ROUNDING):
            path = "drive.load_torque"
            yield finding("slips-before-event", "error", value=carried, limit=load, path=path, at=end)
    motor = float(train.engine.at(train.speed))
    if abs(motor - load) > _NEAR * max(load, motor):
        path = "drive.speed" if train.engine.slip is not None else "drive.motor_torque"
        yield finding("drive-not-in-balance", "info", value=motor, limit=load, path=path)
    yield from _endless(train, outcomes)
    if result.energy_residual > CLOSED:
        yield finding("energy-not-closed", "error", value=result.energy_residual, limit=CLOSED)
    yield from _accuracy(outcomes)
    # S22's open question, as a number: where between T_муф and T_п does this drive trip?
    last, unit = outcomes[-1], clutch.spec.control_unit
    if unit is not None and unit.release_lag and last.trip_position is not None:
        expected, path = last.case.pack.breakaway, "control_unit.release_lag"
        at, share, held = last.trip_torque, last.trip_position, last.potential
        yield finding("release-lag", "info", value=at, limit=expected, path=path, share=share, held=held)
    yield from _judder(clutch, train, outcomes)


def _inertia(train: Train, outcomes: Sequence[Outcome]) -> Finding:
    """Finding on the inertia behind the discs: a sudden stop loads the shaft by speed, a slow one by deceleration."""
    path, limit = "drive.driven_inertia", float(outcomes[-1].case.pack.sliding)
    behind, load = train.driven_inertia + train.hub_inertia, min(train.load, limit)
    swing = math.pi * math.sqrt(behind / train.stiffness)
    # the slip begins as the tool, slowing down with ω_0/t_b, has wound the shaft up from the load
    wound = math.sqrt(2 * (limit - load) * train.time / (train.stiffness * train.speed))
    if train.kind == "load" or train.time <= wound + swing:
        return finding("inertia-torque", "info", value=train.inertia_torque, limit=limit, path=path)
    beyond = law.stop_torque(behind, train.speed / train.time, limit, load)
    return finding("inertia-torque/slow", "info", value=float(beyond), limit=limit, path=path, swing=swing)


def _endless(train: Train, outcomes: Sequence[Outcome]) -> Iterator[Finding]:
    """Does the motor stop, and does the slip end within the time that is simulated?"""
    strongest, path = float(train.engine.torque), "drive.cut_off"
    for end, one in zip(_end_symbols(), outcomes, strict=True):
        pulled = abs(one.event.last) if one.endless else one.event.pulled
        if not pulled or not (one.endless or pulled <= strongest):
            continue
        carries, sliding = measured(pulled, "N*m", 5), float(one.case.pack.sliding)
        if pulled < sliding * (1 - _NEAR):
            carries = say(
                "{pulled:.5g N·m}, as its key holds the sleeve; {sliding:.5g N·m} only as friction rises",
                pulled=pulled, sliding=sliding,
            )  # fmt: skip
        code = "motor-never-stops" if one.endless else "motor-stops-at-cut-off"
        level: Level = "error" if one.endless else "info"
        heat, off = one.energy or 0.0, train.cut_off
        yield finding(
            code, level, value=pulled, limit=strongest, path=path, at=end, carries=carries, heat=heat, off=off
        )
    for end, one in zip(_end_symbols(), outcomes, strict=True):
        path, lasted = "drive.event.duration", one.event.time
        if not one.event.stuck and not one.endless:
            yield finding("slip-outlasts-duration", "warning", value=lasted, path=path, at=end)
        elif one.event.stuck and not one.event.settled:
            yield finding("event-not-settled", "warning", value=lasted, path=path, at=end)


def _accuracy(outcomes: Sequence[Outcome]) -> Iterator[Finding]:
    """Say where twice the step gives other figures."""
    for end, one in zip(_end_symbols(), outcomes, strict=True):
        event = one.event
        for error, limit in ((event.peak_error, CLOSE), (event.clutch_error, CLOSE_CLUTCH)):
            if error > limit:
                yield finding("peak-not-converged", "warning", value=error, limit=limit, at=end)
                break
        if not one.ended:
            continue
        if event.slip_error > SPREAD:
            path = "control_unit" if isinstance(one.case.pack, Sleeve) else "drive.event"
            yield finding("ill-conditioned", "warning", value=event.slip_error, limit=SPREAD, path=path, at=end)


def _judder(clutch: Clutch, train: Train, outcomes: Sequence[Outcome]) -> Iterator[Finding]:
    """True if slow slip is steady (V6), where friction falls most with speed."""
    friction = clutch.spec.friction
    ratio, speed = friction.static_ratio or 1.0, friction.stribeck_speed
    if ratio == 1 or speed is None:
        return

    def needed(case: Case) -> float:
        return float(law.judder_damping(case.pack.growth, clutch.mean_radius, ratio, speed))

    least, ordinary = max((needed(one.case), needed(one.ordinary)) for one in outcomes)
    if train.damping <= least:
        path = "drive.damping_ratio"
        yield finding("judder", "info", value=least, limit=train.damping, path=path, ordinary=ordinary)


def contact_forces(clutch: Clutch, outcomes: Sequence[Outcome]) -> list[float] | None:
    """Largest F_n of every event, N; None without balls whose number and circle are known."""
    unit = clutch.spec.control_unit
    if unit is None or unit.balls is None or unit.ball_circle_radius is None or not clutch.gain:
        return None
    if clutch.spec.kind.travels and let_go(outcomes[-1].case) is None:
        return None  # feedback that the key just holds is simulated without its balls
    count, radius = unit.balls, unit.ball_circle_radius
    return [float(control_unit.contact_force(each.event.peak_wall, count, radius, 1.0)) for each in outcomes]


def let_go(case: Case) -> float | None:
    """Travel at which the closing spring presses no more, m; None without a sleeve."""
    pack = case.pack
    return float(pack.farthest) if isinstance(pack, Sleeve) else None


def event_values(clutch: Clutch, result: SimulateResult) -> dict[str, Any]:
    """Return what an event asks of the parts, the largest over the friction range, and what they bear."""
    factor = result.largest_dynamic_factor
    assumed = clutch.spec.drive.dynamic_factor
    known: dict[str, Any] = {"peak_torque": result.judged_peak, "contact_force": None, "travel_max": None}
    known["dynamic_factor_of_event"] = assumed if assumed and assumed < factor <= assumed * (1 + _NEAR) else factor
    if "shear_yield_strength" in clutch:
        peak = max(float(clutch["torque_max"]), result.judged_peak)
        known["event_stress"] = clutch.at(torque_high=peak)["stress_high"]
    if result.contact_force is not None:
        known["contact_force"], known["at_contact"] = _largest(result.contact_force)
    if result.travel_max is not None:
        known["travel_max"], known["at_travel"] = _largest(result.travel_max)
        known["travel_let_go"] = let_go(case_of(clutch, *(friction.max for friction in clutch.spec.friction.groups)))
    if ANALYSES["pocket"].applies(clutch):
        unit, _ = pocket(clutch)
        known["contact_force_allowable"] = unit.contact_force_allowable
        wall = wall_of(clutch, unit.face_gap, unit.ball_diameter / 2)
        if result.travel_max is not None and unit.ball_diameter_standard is not None and wall.can_be_cut:
            known["travel_to_edge"], travel = wall.sleeves * wall.mouth, known["travel_max"]
            if travel <= known["travel_to_edge"]:
                known["clearance"] = wall.clearance(travel)
    return known


def _largest(ends: Triple) -> tuple[float, str]:
    """Largest of the values at f_min, mean and f_max, and where it is."""
    return max(zip(vars(ends).values(), _end_symbols(), strict=True))


def _springs(clutch: Clutch, travel: float) -> Iterator[Finding]:
    """Findings on the springs: rules they break where the sleeve swings, and keep where the law has it."""
    own, rules = clutch.spec, {}
    if not own.spring_parts or not own.kind.travels:
        return
    for path, each in checks_of_springs(clutch):
        rules[path, each.rule] = each.beyond > _ROUNDING
    for path, each in checks_of_springs(clutch, travel):
        if each.beyond > _ROUNDING and not rules.get((path, each.rule)):
            yield finding(
                "event-spring", each.rule.level, value=each.value, limit=each.limit, path=path, travel=travel,
                what=translate(each.rule.name),
            )  # fmt: skip


__all__ = ["SimulateResult", "simulate"]


def simulate(
    clutch: Clutch, friction: Iterable[Pair] = (), sweeps: Sequence[Axis] = (), *, heated: bool = False
) -> tuple[SimulateResult, list[Finding]]:
    """Simulate the event of the [drive] block at f_min, mean friction and f_max, constant during the event.

    And at further pairs of frictions, (f, None) for all pairs alike or (f_1, f_2); of a sweep only the peaks are told.
    With ``heated`` the result has the heat of the trip.

    Raises:
        SpecError: the spec has no event.
    """
    train, points = train_of(clutch), pairs_asked(clutch, friction)
    ends = counted(say("simulating the event"), list(zip(*clutch.spec.friction.groups, strict=True)))
    outcomes = [outcome_of(clutch, *end) for end in ends]
    peaks = [one.event.peak for one in outcomes]
    # both step sizes, where the sleeve rattles against its stop; a slip that does not end gives heat without end
    rattles = any(one.rattles for one in outcomes)
    peaks_by_step = [(one.event.peak, one.event.other.peak) for one in outcomes if rattles]
    heats_by_step = [tuple(math.inf if heat is None else heat for heat in one.energies) for one in outcomes if rattles]
    (peak,) = bypass_peaks(clutch).tolist()
    bypass = None if math.isnan(peak) else peak
    sweep, rising = swept(clutch, sweeps)
    travels, unit = clutch.spec.kind.travels, clutch.spec.control_unit
    late = unit is not None and bool(unit.release_lag)
    result = SimulateResult(
        sliding_torque=_ends(Triple, [float(one.case.pack.sliding) for one in outcomes]),
        peak_torque=_ends(Triple, peaks),
        peak_torque_clutch=_ends(Triple, [one.event.peak_clutch for one in outcomes]),
        peak_torque_bypass=bypass,
        peak_error=_ends(Triple, [float(one.event.peak_error) for one in outcomes]),
        dynamic_factor=_ends(Triple, [one.dynamic_factor for one in outcomes]),
        peak_over_machine=_ends(Triple, [peak / train.load for peak in peaks]) if train.load else None,
        slip_time=_ends(OpenTriple, [one.slip_time for one in outcomes]),
        slip_energy=_ends(OpenTriple, [one.energy for one in outcomes]),
        peak_torque_low=_ends(Triple, map(min, peaks_by_step)),
        peak_torque_high=_ends(Triple, map(max, peaks_by_step)),
        slip_energy_low=_ends(OpenTriple, map(min, heats_by_step)),
        slip_energy_high=_ends(OpenTriple, map(max, heats_by_step)),
        key_energy=_ends(OpenTriple, [one.key_energy for one in outcomes] if _has_key(clutch) else ()),
        travel_max=_ends(Triple, [one.event.travel_max for one in outcomes]) if travels else None,
        contact_force=_ends(Triple, contact_forces(clutch, outcomes) or ()),
        peak_torque_conventional=_ends(Triple, [one.ordinary_peak for one in outcomes]),
        trip_torque=_ends(OpenTriple, [one.trip_torque for one in outcomes]) if late else None,
        trip_position=_ends(OpenTriple, [one.trip_position for one in outcomes]) if late else None,
        inertia_torque=train.inertia_torque,
        load_torque=train.load,
        energy_residual=max(one.event.residual for one in outcomes),
        points=[_point(clutch, *pair) for pair in counted(say("simulating the event"), points)] or None,
        sweep=sweep,
    )
    findings = [
        *clutch_findings(clutch),
        *failures_of(clutch.spec, Beside(event_values(clutch, result), clutch), "simulate"),
        *_springs(clutch, max(one.event.travel_max for one in outcomes)),
        *remarks_of(clutch, train, outcomes, result),
        *([] if bypass is None else [finding("bypass-peak", "warning", value=bypass, limit=max(peaks))]),
        *rising,
        *replaced(clutch.spec, sweeps),
        *(remark for pair in points for remark in outside_range(clutch, *pair)),
    ]
    if not heated:
        return result, findings
    heat, of_heat = ANALYSES["heat"].function(clutch)
    return result.model_copy(update={"heat": heat}), list(dict.fromkeys([*findings, *of_heat]))


def _has_key(clutch: Clutch) -> bool:
    """True if the sleeve slides on a key that rubs."""
    unit = clutch.spec.control_unit
    return clutch.spec.kind.travels and unit is not None and bool(unit.key_friction)


def _point(clutch: Clutch, friction: float, friction_driven: float | None) -> SimulatePoint:
    if not friction or friction_driven == 0:
        raise CalculationError("--friction 0: without friction there is no torque to simulate")
    outcome = outcome_of(clutch, friction, friction_driven)
    return SimulatePoint(
        **friction_fields(clutch, friction, friction_driven),
        sliding_torque=float(outcome.case.pack.sliding),
        peak_torque=outcome.event.peak,
        peak_torque_clutch=outcome.event.peak_clutch,
        dynamic_factor=outcome.dynamic_factor,
        slip_time=outcome.slip_time,
        slip_energy=outcome.energy,
        key_energy=outcome.key_energy if _has_key(clutch) else None,
        travel_max=outcome.event.travel_max if clutch.spec.kind.travels else None,
        peak_torque_conventional=outcome.ordinary_peak,
    )


def _ends(kind: type[AtEnds], values: Iterable[float | None]) -> Any:
    """Values at f_min, mean friction and f_max, one without end as None where there may be one; None of no values."""
    ends = [None if value == math.inf and kind is OpenTriple else value for value in values]
    return kind.of(ends) if ends else None


def swept(clutch: Clutch, sweeps: Sequence[Axis]) -> tuple[list[SimulateSweep] | None, list[Finding]]:
    """Peaks over swept keys, None without any; and a remark where some may yet rise."""
    asked: list[tuple[Clutch, tuple[Event, Floats]]] = []

    def of(point: Clutch) -> tuple[Event, Floats]:
        if not asked or asked[-1][0] is not point:
            asked.append((point, _peaks_at_ends(point)))
        return asked[-1][1]

    outputs: dict[str, Callable[[Clutch], Values]] = {
        "peak_torque_max": lambda point: of(point)[0].peak[2],
        "peak_torque_mean": lambda point: of(point)[0].peak[1],
        "peak_torque_min": lambda point: of(point)[0].peak[0],
        "dynamic_factor": lambda point: of(point)[0].peak[2] / of(point)[1][2],
        "inertia_torque": lambda point: train_of(point).inertia_torque,
    }
    if clutch.bypass_pairs and clutch.spec.kind.controlled:
        outputs["peak_torque_bypass"] = bypass_peaks
    rows = series(SimulateSweep, clutch.spec, sweeps, outputs, open_at=("peak_torque_bypass",))
    count = sum(int(np.count_nonzero(~event.passed)) for _, (event, _) in asked)
    return rows, [finding("sweep-not-settled", "warning", value=count, path="drive.cut_off")] if count else []


def _peaks_at_ends(clutch: Clutch) -> tuple[Event, Floats]:
    """Peaks and sliding torque at f_min, mean friction and f_max, a row each."""
    case = case_of(clutch, *at_ends(clutch))
    event = case.peaks()
    return event, np.broadcast_to(case.pack.sliding, event.peak.shape)


def at_ends(clutch: Clutch) -> tuple[Floats, Floats]:
    """f_1 and f_2 at f_min, mean friction and f_max, a row each."""
    first, second = (np.stack(np.broadcast_arrays(*friction)) for friction in clutch.spec.friction.groups)
    return first.reshape(3, -1), second.reshape(3, -1)


def dynamic_factors(clutch: Clutch) -> Floats:
    """Largest T_peak/T over f_min, mean friction and f_max, of every clutch of a sweep."""
    event, sliding = _peaks_at_ends(clutch)
    return np.fmax(np.max(event.peak / sliding, axis=0), bypass_peaks(clutch) / sliding[2])


def largest_peaks(clutch: Clutch) -> Floats:
    """Peak torque in the shaft where the clutch carries most, the bypass pairs with it, of every clutch, N·m."""
    frictions = at_ends(clutch)
    torque, *ends = np.broadcast_arrays(clutch.at_friction(*frictions)["torque"], *frictions)
    largest = (np.take_along_axis(each, torque.argmax(axis=0)[None], axis=0)[0] for each in ends)
    return np.fmax(case_of(clutch, *largest).peaks().peak, bypass_peaks(clutch))


def bypass_peaks(clutch: Clutch) -> Floats:
    """Return the peaks in the shaft if the bypass pairs alone carry, at f_max where they carry most, N·m.

    By the law breakaway is at most what they carry with the spring not yet released (handbook, chapter 3); that they
    go on carrying it in slip is the worst there may be. NaN where the slipping clutch carries more than they do.
    """
    first, second = (part.max for part in clutch.spec.friction.groups)
    there = clutch.at_friction(first, second)
    more = np.atleast_1d(there["breakaway_torque"] > there["torque"] * (1 + 1e-9))
    if not more.any():
        return np.full(more.shape, np.nan)
    # the load before the event stays that of the clutch as it is
    alone = with_pairs(clutch, clutch["bypass_pairs"], 0.0, running_torque=train_of(clutch).load)
    return np.where(more, case_of(alone, first, second).peaks().peak, np.nan)


class MomentRow(Result):
    """One moment of an event at one friction."""

    friction: float | None = quantity("1", "f", "coefficient of friction of all pairs", optional=True)
    friction_driving: float | None = quantity("1", "f_1", "friction of the driving pairs", optional=True)
    friction_driven: float | None = quantity("1", "f_2", "friction of the driven pairs", optional=True)
    time: float = quantity("s", None, "time")
    torque_shaft: float = quantity("N*m", "T_s", "torque in the shaft")
    torque_clutch: float = quantity("N*m", "T_c", "torque of the clutch")
    speed_motor: float = quantity("rad/s", "ω_1", "speed of the motor side")
    speed_driven: float = quantity("rad/s", "ω_2", "speed of the driven half")
    speed_tool: float = quantity("rad/s", "ω_3", "speed of the tool")
    travel: float | None = quantity("m", "x", "travel of the sleeve", optional=True)


class HistoryResult(Answer):
    """The events at every friction asked for, one after the other."""

    moments: list[MomentRow] = described("moments")


def history(clutch: Clutch, friction: Iterable[Pair] = (), *, short: bool = False) -> HistoryResult:
    """Simulate events at pairs of friction, else at f_min, mean and f_max, and keep their course.

    With ``short`` only until the peak has passed.

    Raises:
        SpecError: the spec has no event.
    """
    unlike = clutch.spec.friction.unlike
    ends = [(first, second if unlike else None) for first, second in zip(*clutch.spec.friction.groups, strict=True)]
    rows = []
    for pair in counted(say("simulating the event"), pairs_asked(clutch, friction) or ends):
        case = case_of(clutch, *pair)
        moments = case.history().rows
        if short:
            window = float(peak_time(case.train, case.pack.sliding))
            moments = tuple(moment for moment in moments if moment.time <= window)
        own, travels = friction_fields(clutch, *pair), clutch.spec.kind.travels
        for moment in _thinned(moments):
            fields = {name: value for name, value in moment._asdict().items() if name in MomentRow.model_fields}
            rows.append(MomentRow(**own, **fields | {"travel": moment.travel if travels else None}))
    return HistoryResult(moments=rows)


def _thinned(rows: Sequence[Row]) -> Iterator[Row]:
    """Some thousand moments: the first, the last, that of the peak, those where slip begins or ends, and others."""
    peak, every = max(rows, key=lambda row: abs(row.torque_shaft)), -(-len(rows) // _MOMENTS)
    for number, row in enumerate(rows):
        turned = bool(row.slip) != bool(rows[number - 1].slip)
        if row is peak or turned or number % every == 0 or number == len(rows) - 1:
            yield row
