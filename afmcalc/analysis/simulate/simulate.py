"""The drive in time: what happens when the clutch trips, against an ordinary clutch of equal nominal torque."""

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from ...engines.protocol import Clutch
from ...errors import CalculationError
from ...findings import Finding, finding
from ...messages import say
from ...progress import counted
from ...recorders import unrecorded
from ...result import OpenTriple, Triple
from ...spec import Spec, resolved
from ..sweep.grid import Axis, replaced
from ..torque import Pair, friction_fields, outside_range, pairs_asked
from .bypass import bypass_peak
from .cases import Outcome, bracket_of, outcome_of
from .remarks import remarks_of
from .result import SimulatePoint, SimulateResult
from .strain import contact_forces, strains
from .sweep import swept
from .train import train_of

__all__ = ["SimulateResult", "simulate"]

_WIDE = 0.05
"""Width of the bracket κ … κ₊, relative to the value, beyond which it is said."""


@unrecorded()
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
        raise CalculationError(say("--friction 0: without friction there is no torque to simulate"))
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
