"""The drive in time: what happens when the clutch trips, against an ordinary clutch of equal nominal torque."""

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from ..arrays import Floats, Values
from ..drive.cases import Outcome, bracket_of, case_of, outcome_of, peak_time
from ..drive.peaks import Peaks, peaks_of
from ..drive.result import SimulatePoint, SimulateResult, SimulateSweep
from ..drive.train import train_of
from ..engines.protocol import Clutch
from ..equations.calls import unnoted
from ..errors import CalculationError
from ..findings import Finding, finding
from ..messages import say
from ..progress import counted
from ..result import Answer, OpenTriple, Result, Triple, described, quantity
from ..spec import Spec, resolved
from ..spec.edit import with_values
from ..spec.models import Range
from .effects import with_pairs
from .event import contact_forces, remarks_of, strains
from .sweep.grid import Axis, replaced, series
from .torque import Pair, friction_fields, outside_range, pairs_asked

__all__ = ["SimulateResult", "simulate"]

_WIDE = 0.05
"""Width of the bracket κ … κ₊, relative to the value, beyond which it is said."""


@unnoted()
def simulate(
    clutch: Clutch, friction: Iterable[Pair] = (), sweeps: Sequence[Axis] = ()
) -> tuple[SimulateResult, list[Finding]]:
    """Simulate the event of the [drive] block at f_min, mean friction and f_max, constant during the event.

    Args:
        clutch: a clutch with float parameters.
        friction: further frictions: pairs (f, None) for all pairs alike or (f_1, f_2).
        sweeps: axes of a sweep of the peaks.

    Raises:
        SpecError: the spec has no event.
        AfmcalcError: SciPy is missing.
    """
    train, points = train_of(clutch), pairs_asked(clutch, friction)
    ends = list(zip(*clutch.friction, strict=True))
    both = [(one := outcome_of(clutch, *end), bracket_of(one)) for end in counted(say("simulating the event"), ends)]
    found, brackets = [one for one, _ in both], [bracket for _, bracket in both if bracket]
    peaks = [each.trip.peak for each in found]
    bypass = bypass_peak(clutch)
    torques, heats = ([_ends(each) for each in rows] for rows in (_peaks(brackets), _heats(brackets)))
    sweep, rising = swept(clutch, sweeps)
    travels, unit = clutch.spec.kind.travels, clutch.spec.control_unit
    late = unit is not None and bool(unit.release_lag)
    forces = contact_forces(clutch, found)
    result = SimulateResult(
        sliding_torque=_triple([each.case.plant.sliding for each in found]),
        peak_torque=_triple(peaks),
        peak_torque_clutch=_triple([each.trip.peak_clutch for each in found]),
        peak_torque_bypass=bypass,
        dynamic_factor=_triple([each.dynamic_factor for each in found]),
        peak_over_machine=_triple([peak / train.load for peak in peaks]) if train.load else None,
        slip_time=_open([each.slip_time for each in found]),
        slip_energy=_open([each.energy for each in found]),
        peak_torque_low=_triple([low for low, _ in torques]) if torques else None,
        peak_torque_high=_triple([high for _, high in torques]) if torques else None,
        slip_energy_low=_open([_finite(low) for low, _ in heats]) if heats else None,
        slip_energy_high=_open([_finite(high) for _, high in heats]) if heats else None,
        travel_max=_triple([each.trip.travel_max for each in found]) if travels else None,
        contact_force=None if forces is None else _triple(forces),
        peak_torque_conventional=_triple([each.ordinary_peak for each in found]),
        trip_torque=_open([each.trip.trip_torque for each in found]) if late else None,
        trip_position=_open([each.trip_position for each in found]) if late else None,
        inertia_torque=train.inertia_torque,
        load_torque=train.load,
        energy_residual=max(each.trip.residual for each in found),
        points=[_point(clutch, *pair) for pair in counted(say("simulating the event"), points)] or None,
        sweep=sweep,
    )
    return result, [
        *clutch.findings(),
        *strains(clutch, found),
        *remarks_of(clutch, train, found, result),
        *_wide("peak", _peaks(brackets)),
        *_wide("heat", _heats(brackets)),
        *([] if bypass is None else [finding("bypass-peak", "warning", value=bypass, limit=max(peaks))]),
        *rising,
        *replaced(clutch.spec, sweeps),
        *(remark for pair in points for remark in outside_range(clutch, *pair)),
    ]


def with_dynamic_factor(spec: Spec, result: SimulateResult) -> dict[str, Any]:
    """Return the spec with the largest dynamic factor found, for the life of the unprotected side."""
    data = resolved(spec)
    data["drive"]["dynamic_factor"] = result.largest_dynamic_factor
    return data


def _point(clutch: Clutch, friction: float, friction_driven: float | None) -> SimulatePoint:
    if not friction or friction_driven == 0:
        raise CalculationError("--friction 0: without friction there is no torque to simulate")
    found = outcome_of(clutch, friction, friction_driven)
    return SimulatePoint(
        **friction_fields(clutch, friction, friction_driven),
        sliding_torque=found.case.plant.sliding,
        peak_torque=found.trip.peak,
        peak_torque_clutch=found.trip.peak_clutch,
        dynamic_factor=found.dynamic_factor,
        slip_time=found.slip_time,
        slip_energy=found.energy,
        travel_max=found.trip.travel_max if clutch.spec.kind.travels else None,
        peak_torque_conventional=found.ordinary_peak,
    )


def _peaks(brackets: Sequence[Sequence[Outcome]]) -> list[list[float]]:
    """Peak torques with the key's play, along κ, along κ₊, at every friction."""
    return [[each.trip.peak for each in row] for row in brackets]


def _heats(brackets: Sequence[Sequence[Outcome]]) -> list[list[float]]:
    """Heat in the pack likewise; infinite where the slip does not end."""
    return [[math.inf if each.energy is None else each.energy for each in row] for row in brackets]


def _ends(values: Sequence[float]) -> tuple[float, float]:
    return min(values), max(values)


def _finite(value: float) -> float | None:
    return None if math.isinf(value) else value


def _wide(what: str, rows: Sequence[Sequence[float]]) -> Iterator[Finding]:
    """Say where the answer hangs on how the key holds the sleeve at its stop: vibration dithers a key."""
    for at, (value, *others) in zip(("f_min", "f_cp", "f_max"), rows, strict=False):
        low, high = _ends([value, *others])
        if high - low > _WIDE * value or math.isinf(high) > math.isinf(low):
            path, most = "control_unit.key_friction", _finite(high)
            if most is None:
                yield finding("stop-bracket/open", "warning", value=low, path=path, at=at)
            elif what == "heat":
                yield finding("stop-bracket/heat", "warning", value=low, limit=most, path=path, at=at)
            else:
                yield finding("stop-bracket/peak", "warning", value=low, limit=most, path=path, at=at)


def _triple(values: Sequence[float]) -> Triple:
    return Triple(min=values[0], mean=values[1], max=values[2])


def _open(values: Sequence[float | None]) -> OpenTriple:
    return OpenTriple(min=values[0], mean=values[1], max=values[2])


def swept(clutch: Clutch, sweeps: Sequence[Axis]) -> tuple[list[SimulateSweep] | None, list[Finding]]:
    """Peaks over swept keys, None without any; and a remark where some may yet rise."""
    found = _Found()
    outputs: dict[str, Callable[[Clutch], Values]] = {
        "peak_torque_max": lambda own: found.of(own).shaft[2],
        "peak_torque_mean": lambda own: found.of(own).shaft[1],
        "peak_torque_min": lambda own: found.of(own).shaft[0],
        "peak_torque_clutch": lambda own: found.of(own).clutch[2],
        "dynamic_factor": lambda own: found.of(own).shaft[2] / found.of(own).sliding[2],
        "inertia_torque": lambda own: train_of(own).inertia_torque,
    }
    if clutch.bypass_pairs and clutch.spec.kind.controlled:
        outputs["peak_torque_bypass"] = bypass_peaks
    told = series(SimulateSweep, clutch, sweeps, outputs, open_at=("peak_torque_bypass",))
    path, count = "drive.cut_off", found.rising
    return told, [finding("sweep-not-settled", "warning", value=count, path=path)] if count else []


def dynamic_factors(clutch: Clutch) -> Floats:
    """Largest T_peak/T over f_min, mean friction and f_max, of every clutch of a sweep."""
    first, second = map(_rows, clutch.friction)
    found = peaks_of(clutch, first, second)
    slipping = np.max(found.shaft / found.sliding, axis=0)
    return np.fmax(slipping, bypass_peaks(clutch) / found.sliding[2])


def bypass_peaks(clutch: Clutch) -> Floats:
    """Peaks in the shaft if the bypass pairs alone carry, as of ``bypass_peak``; NaN where they carry less, N·m."""
    first, second = (own.max for own in clutch.friction)
    sliding, breakaway = clutch.torque(first, second), clutch.breakaway_torque(first, second)
    more = np.atleast_1d(breakaway > sliding * (1 + 1e-9))
    if not more.any():
        return np.full(more.shape, np.nan)
    return np.where(more, peaks_of(bypass_alone(clutch), first, second).shaft, np.nan)


class _Found:
    """The peaks of the clutch that was asked last, each clutch calculated once."""

    def __init__(self) -> None:
        self._clutch: Clutch | None = None
        self._peaks: Peaks | None = None
        self.rising = 0
        """Drives whose peak may yet rise."""

    def of(self, clutch: Clutch) -> Peaks:
        """Peaks at f_min, mean friction and f_max, a row each."""
        if clutch is not self._clutch or self._peaks is None:
            first, second = (_rows(friction) for friction in clutch.friction)
            self._clutch, self._peaks = clutch, peaks_of(clutch, first, second)
            self.rising += int(np.count_nonzero(~self._peaks.passed))
        return self._peaks


def _rows(friction: Range) -> Floats:
    """The three frictions as rows, (3, 1) or (3, n)."""
    stacked: Floats = np.stack(np.broadcast_arrays(*friction))
    return stacked if stacked.ndim > 1 else stacked[:, np.newaxis]


def bypass_peak(clutch: Clutch) -> float | None:
    """Return the peak torque in the shaft if the bypass pairs alone carry, at f_max where they carry most, N·m.

    By the law breakaway is at most what they carry with the spring not yet released (theory, section 3); that they
    go on carrying it in slip is the worst there may be. None where the slipping clutch carries more than they do.

    Raises:
        AfmcalcError: SciPy is missing.
    """
    first, second = (own.max for own in clutch.friction)
    if not clutch.breakaway_torque(first, second) > clutch.torque(first, second) * (1 + 1e-9):
        return None
    return case_of(bypass_alone(clutch), first, second).run().peak


def bypass_alone(clutch: Clutch) -> Clutch:
    """Return the clutch with its bypass pairs only; the load before the event stays that of the clutch as it is."""
    loaded = with_values(clutch.spec, {"drive.load_torque": train_of(clutch).load})
    return replace(with_pairs(clutch, clutch.bypass_pairs, 0.0), spec=loaded)


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
    """Simulate events and keep their course.

    Args:
        clutch: a clutch with float parameters and an event.
        friction: pairs (f, None) or (f_1, f_2); none for f_min, mean friction and f_max.
        short: only until the peak has passed.

    Raises:
        SpecError: the spec has no event.
        AfmcalcError: SciPy is missing.
    """
    unlike = clutch.spec.friction.unlike
    ends = [(first, second if unlike else None) for first, second in zip(*clutch.friction, strict=True)]
    rows = []
    for pair in counted(say("simulating the event"), pairs_asked(clutch, friction) or ends):
        case = case_of(clutch, *pair)
        if short:
            window = float(peak_time(case.plant.train, case.plant.sliding))
            case = case._replace(horizon=min(case.horizon, window))
        own = friction_fields(clutch, *pair)
        for moment in case.run(recorded=True).history:
            given = moment._asdict()
            if not clutch.spec.kind.travels:
                del given["travel"]
            rows.append(MomentRow(**own, **given))
    return HistoryResult(moments=rows)
