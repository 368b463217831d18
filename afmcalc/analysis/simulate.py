"""Simulation of the drive: the trip of the clutch, the loads on its parts, and a comparison with an ordinary clutch."""

import functools
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

import numpy as np

from ..drive.cases import Case, Outcome, case_of, outcome_of
from ..drive.integrator import CLOSE, CLOSE_CLUTCH, CLOSED, SPREAD, Event, peak_time
from ..drive.pack_and_sleeve import Sleeve
from ..drive.train import Train, train_of
from ..engines import Clutch
from ..engines.checks import Beside, failures_of
from ..engines.parts import checks_of_springs
from ..equations import control_unit
from ..equations import drive as law
from ..equations.arrays import Floats, Values
from ..errors import CalculationError
from ..findings import Finding, finding
from ..messages import measured, say, translate
from ..progress import counted
from ..result import Answer, Result, Triple, described, quantity
from .clutch_findings import carried_by_motor, clutch_findings, speed_findings
from .drive_result import SimulatePoint, SimulateResult, SimulateSweep, ends_of
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
"""Relative difference below which a number of the spec counts as equal to the simulated one."""
_ROUNDING = 1e-9
_AT_POINT = SimulatePoint.model_fields.keys()
_MOMENTS = 2000
"""Approximate number of moments in a history."""


def remarks_of(clutch: Clutch, train: Train, outcomes: Sequence[Outcome], result: SimulateResult) -> Iterator[Finding]:
    """Yield findings on an event: on its ``outcomes`` at f_min, mean friction and f_max, and on its ``result``."""
    yield _inertia(train, outcomes)
    yield from speed_findings(clutch.spec)
    taken = {"driven_inertia": train.driven_inertia, "hub_inertia": train.hub_inertia}
    for name, inertia in taken.items():
        if inertia and getattr(clutch.spec.drive, name) is None:
            yield finding("inertia-from-layout", "info", value=float(inertia), path=f"drive.{name}")
    # conditions in which the ordinary clutch of equal nominal torque is no like-for-like comparison
    load, carried = train.load, float(min(one.ordinary.pack.sliding for one in outcomes))
    if train.hub_inertia:
        inertia = train.driven_inertia + train.hub_inertia
        yield finding("ordinary-carries-hub", "info", value=inertia, path="drive.hub_inertia")
    if carried < load * (1 - _ROUNDING):
        yield finding("ordinary-slips-before-event", "info", value=carried, limit=load, path="adjustment.method")
    for end, one in zip(_end_symbols(), outcomes, strict=True):
        yield from _of_event(end, one)
    motor = float(train.engine.at(train.speed))
    if abs(motor - load) > _NEAR * max(load, motor):
        path = "drive.speed" if train.engine.slip is not None else "drive.motor_torque"
        yield finding("drive-not-in-balance", "info", value=motor, limit=load, path=path)
    if result.energy_residual > CLOSED:
        yield finding("energy-not-closed", "error", value=result.energy_residual, limit=CLOSED)
    # S22 leaves open where between slip torque T_муф and potential torque T_п a clutch trips: here as a number
    last, unit = outcomes[-1], clutch.spec.control_unit
    if unit is not None and unit.release_lag and last.trip_position is not None:
        expected, path = last.case.pack.breakaway, "control_unit.release_lag"
        at, share, held = last.event.trip_torque, last.trip_position, last.potential
        yield finding("release-lag", "info", value=at, limit=expected, path=path, share=share, held=held)
    yield from _judder(clutch, train, outcomes)


def _inertia(train: Train, outcomes: Sequence[Outcome]) -> Finding:
    """Finding on the inertia behind the discs: it loads the shaft by its speed or, in a slow stop, by deceleration."""
    path, limit = "drive.driven_inertia", float(outcomes[-1].case.pack.sliding)
    behind, load = train.driven_inertia + train.hub_inertia, min(train.load, limit)
    swing = math.pi * math.sqrt(behind / train.stiffness)
    # slip begins when the tool, braked with ω_0/t_b, has twisted the shaft from the load torque up to the limit
    wound = math.sqrt(2 * (limit - load) * train.time / (train.stiffness * train.speed))
    if train.kind == "load" or train.time <= wound + swing:
        return finding("inertia-torque", "info", value=train.inertia_torque, limit=limit, path=path)
    beyond = law.stop_torque(behind, train.speed / train.time, limit, load)
    return finding("inertia-torque/slow", "info", value=float(beyond), limit=limit, path=path, swing=swing)


def _of_event(end: str, one: Outcome) -> Iterator[Finding]:
    """Yield findings on one event: what slips before it, a motor or a slip that does not stop, an inaccurate result."""
    event, train, sliding = one.event, one.case.train, float(one.case.pack.sliding)
    if (carried := float(one.case.pack.breakaway)) < train.load * (1 - _ROUNDING):
        yield finding("slips-before-event", "error", value=carried, limit=train.load, path="drive.load_torque", at=end)
    pulled, strongest = abs(event.last) if one.endless else event.pulled, float(train.engine.torque)
    if pulled and (one.endless or pulled <= strongest):
        carries = measured(pulled, "N*m", 5)
        if pulled < sliding * (1 - _NEAR):
            carries = say(
                "{pulled:.5g N·m}, as its key holds the sleeve; {sliding:.5g N·m} only as friction rises",
                pulled=pulled, sliding=sliding,
            )  # fmt: skip
        yield carried_by_motor(pulled, strongest, end, carries, event.heat if event.ended else 0.0, train.cut_off)
    if not event.stuck and not one.endless:
        path = "drive.event.duration"
        yield finding("slip-outlasts-duration", "warning", value=event.time, path=path, at=end)
    elif event.stuck and not event.settled:
        yield finding("event-not-settled", "warning", value=event.time, path="drive.event.duration", at=end)
    # results that differ too much from a run with twice the time step
    for error, limit in ((event.peak_error, CLOSE), (event.clutch_error, CLOSE_CLUTCH)):
        if error > limit:
            yield finding("peak-not-converged", "warning", value=error, limit=limit, at=end)
            break
    if event.ended and (error := max(event.time_error, event.heat_error)) > SPREAD:
        path = "control_unit" if isinstance(one.case.pack, Sleeve) else "drive.event"
        yield finding("ill-conditioned", "warning", value=error, limit=SPREAD, path=path, at=end)


def _judder(clutch: Clutch, train: Train, outcomes: Sequence[Outcome]) -> Iterator[Finding]:
    """Yield a finding if the damping is too small to keep slow slip steady, where friction falls most with speed."""
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


def _contact_force(clutch: Clutch, one: Outcome) -> float | None:
    """Largest contact force F_n on a ball in an event, N; None if number or circle of the balls is not known."""
    unit = clutch.spec.control_unit
    if unit is None or unit.balls is None or unit.ball_circle_radius is None or not clutch.gain:
        return None
    if clutch.spec.kind.travels and let_go(one.case) is None:
        return None  # a clutch with κ = 0 is simulated without balls
    return float(control_unit.contact_force(one.event.peak_wall, unit.balls, unit.ball_circle_radius, 1.0))


def let_go(case: Case) -> float | None:
    """Travel at which the closing spring becomes slack, m; None without a sleeve."""
    pack = case.pack
    return float(pack.closing_spring.deflection) if isinstance(pack, Sleeve) else None


def event_values(clutch: Clutch, result: SimulateResult) -> dict[str, Any]:
    """Return the loads of an event on the parts, the largest over the friction range, and the parts' limits."""
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
    """Largest of the values at f_min, mean friction and f_max, and the symbol of the friction at which it occurs."""
    return max(zip(vars(ends).values(), _end_symbols(), strict=True))


def _springs(clutch: Clutch, travel: float) -> Iterator[Finding]:
    """Findings on limits that a spring exceeds at the travel of the event, though not at that of the torque law."""
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
    """Simulate the event of the [drive] block at f_min, mean friction and f_max, each constant during the event.

    ``friction`` has further values, (f, None) for all friction pairs alike or (f_1, f_2); a sweep returns only peaks.
    With ``heated`` the result includes the heat of the trip. Raises SpecError if the spec has no event.
    """
    train, points, rows = train_of(clutch), pairs_asked(clutch, friction), list[SimulatePoint]()
    for pair in counted(say("simulating the event"), points):
        if not all(pair):
            raise CalculationError("--friction 0: without friction there is no torque to simulate")
        own = {name: value for name, value in _figures(clutch, outcome_of(clutch, *pair)).items() if name in _AT_POINT}
        rows.append(SimulatePoint(**own | friction_fields(clutch, *pair)))
    ends = counted(say("simulating the event"), list(zip(*clutch.spec.friction.groups, strict=True)))
    outcomes = [outcome_of(clutch, *end) for end in ends]
    figures, events = [_figures(clutch, one) for one in outcomes], [one.event for one in outcomes]
    # heat and time of a slip depend on the time step if the sleeve rattles against its stop
    if any(event.travel_max for event in events):
        for own, event in zip(figures, events, strict=True):
            own["slip_time_spread"] = event.time_error if event.ended else None
            own["slip_energy_spread"] = event.heat_error if event.ended else None
    (peak,) = bypass_peaks(clutch).tolist()
    bypass = None if math.isnan(peak) else peak
    sweep, rising = swept(clutch, sweeps)
    result = SimulateResult(
        **{name: ends_of(own[name] for own in figures) for name in figures[0]},
        peak_torque_bypass=bypass,
        inertia_torque=train.inertia_torque,
        load_torque=train.load,
        energy_residual=max(event.residual for event in events),
        points=rows or None,
        sweep=sweep,
    )
    findings = [
        *clutch_findings(clutch),
        *failures_of(clutch.spec, Beside(event_values(clutch, result), clutch), "simulate"),
        *_springs(clutch, max(event.travel_max for event in events)),
        *remarks_of(clutch, train, outcomes, result),
        *(
            []
            if bypass is None
            else [finding("bypass-peak", "warning", value=bypass, limit=max(event.peak for event in events))]
        ),
        *rising,
        *replaced(clutch.spec, sweeps),
        *(remark for pair in points for remark in outside_range(clutch, *pair)),
    ]
    if not heated:
        return result, findings
    heat, of_heat = ANALYSES["heat"].function(clutch)
    return result.model_copy(update={"heat": heat}), list(dict.fromkeys([*findings, *of_heat]))


def _figures(clutch: Clutch, outcome: Outcome) -> dict[str, float | None]:
    """Name → result of an event at one friction; results of a slip that does not end are None."""
    event, unit, load = outcome.event, clutch.spec.control_unit, outcome.case.train.load
    figures = {
        "sliding_torque": float(outcome.case.pack.sliding),
        "peak_torque": event.peak,
        "peak_torque_clutch": event.peak_clutch,
        "peak_error": event.peak_error,
        "dynamic_factor": float(event.peak / outcome.case.pack.sliding),
        "slip_time": event.slip_time if event.ended else None,
        "slip_energy": event.heat if event.ended else None,
        "peak_torque_conventional": outcome.ordinary_peak,
    }
    if load:
        figures["peak_over_machine"] = event.peak / load
    if clutch.spec.kind.travels:
        figures["travel_max"] = event.travel_max
        if unit is not None and unit.key_friction:
            figures["key_energy"] = event.key_heat if event.ended else None
    if unit is not None and unit.release_lag:
        figures |= {"trip_torque": event.trip_torque or None, "trip_position": outcome.trip_position}
    force = _contact_force(clutch, outcome)
    return figures if force is None else figures | {"contact_force": force}


def swept(clutch: Clutch, sweeps: Sequence[Axis]) -> tuple[list[SimulateSweep] | None, list[Finding]]:
    """Peaks over swept keys, None without axes; and a finding if some peaks may still rise."""
    asked: list[Event] = []

    @functools.lru_cache(maxsize=1)
    def of(point: Clutch) -> tuple[Event, Floats]:
        found = _peaks_at_ends(point)
        asked.append(found[0])
        return found

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
    count = sum(int(np.count_nonzero(~event.passed)) for event in asked)
    return rows, [finding("sweep-not-settled", "warning", value=count, path="drive.cut_off")] if count else []


def _peaks_at_ends(clutch: Clutch) -> tuple[Event, Floats]:
    """Peaks and sliding torque, each with three rows: at f_min, mean friction and f_max."""
    case = case_of(clutch, *at_ends(clutch))
    event = case.peaks()
    return event, np.broadcast_to(case.pack.sliding, event.peak.shape)


def at_ends(clutch: Clutch) -> tuple[Floats, Floats]:
    """Frictions f_1 and f_2, each with three rows: minimum, mean and maximum."""
    first, second = (np.stack(np.broadcast_arrays(*friction)) for friction in clutch.spec.friction.groups)
    return first.reshape(3, -1), second.reshape(3, -1)


def dynamic_factors(clutch: Clutch) -> Floats:
    """Largest ratio T_peak/T over f_min, mean friction and f_max, for every clutch of a sweep."""
    event, sliding = _peaks_at_ends(clutch)
    return np.fmax(np.max(event.peak / sliding, axis=0), bypass_peaks(clutch) / sliding[2])


def largest_peaks(clutch: Clutch) -> Floats:
    """Peak shaft torque at the friction with the largest slip torque, or of bypass pairs alone, if larger, N·m."""
    frictions = at_ends(clutch)
    torque, *ends = np.broadcast_arrays(clutch.at_friction(*frictions)["torque"], *frictions)
    largest = (np.take_along_axis(each, torque.argmax(axis=0)[None], axis=0)[0] for each in ends)
    return np.fmax(case_of(clutch, *largest).peaks().peak, bypass_peaks(clutch))


def bypass_peaks(clutch: Clutch) -> Floats:
    """Return the peak torques in the shaft if the bypass pairs alone carry, at f_max where they carry most, N·m.

    By the law the breakaway torque is at most what the bypass pairs carry under the full spring force (handbook,
    chapter 3); the worst case is that they still carry it in slip. NaN if the slipping clutch carries more.
    """
    first, second = (part.max for part in clutch.spec.friction.groups)
    there = clutch.at_friction(first, second)
    more = np.atleast_1d(there["breakaway_torque"] > there["torque"] * (1 + 1e-9))
    if not more.any():
        return np.full(more.shape, np.nan)
    # the load before the event stays the load of the whole clutch
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
    """Return the course of events at pairs of frictions or, without pairs, at f_min, mean friction and f_max.

    With ``short`` the course ends when the peak has passed. Raises SpecError if the spec has no event.
    """
    rows, ends = [], list(zip(*clutch.spec.friction.groups, strict=True))
    for pair in counted(say("simulating the event"), pairs_asked(clutch, friction) or ends):
        case = case_of(clutch, *pair)
        moments = case.run(full=True).rows
        if short:
            window = float(peak_time(case.train, case.pack.sliding))
            moments = tuple(moment for moment in moments if moment.time <= window)
        own, travels = friction_fields(clutch, *pair), clutch.spec.kind.travels
        # first, last, peak, beginnings and ends of slip, and others at equal intervals
        peak, every = max(moments, key=lambda row: abs(row.torque_shaft)), -(-len(moments) // _MOMENTS)
        for number, moment in enumerate(moments):
            turned = bool(moment.slip) != bool(moments[number - 1].slip)
            if moment is peak or turned or number % every == 0 or number == len(moments) - 1:
                fields = {name: value for name, value in moment._asdict().items() if name in MomentRow.model_fields}
                rows.append(MomentRow(**own, **fields | {"travel": moment.travel if travels else None}))
    return HistoryResult(moments=rows)
