"""What a clutch is to hold, each judged by the analysis that answers it."""

import math
from collections.abc import Callable, Collection, Iterator, Mapping
from typing import Any, Literal, NamedTuple

from ..engines import Clutch
from ..findings import Finding, finding
from ..messages import measured, term, translate
from ..result import OpenTriple, Result, Sentence, Triple, described, quantity
from ..spec.keys import keys
from ..units import ENGINEER
from .answers import Answers
from .heat import share_of_rise
from .life import UNLIMITED
from .limits import ring_pressures
from .registry import ANALYSES

_HELD = 1 + 1e-9
"""What is beyond its limit by rounding holds it."""


class RequirementRow(Result):
    """One requirement, and whether the clutch holds it."""

    requirement: str = described("requirement")
    name: Sentence = described("quantity")
    symbol: str = described("symbol")
    value: float | None = described("value", unit_in="shown_unit")
    bound: Literal["at least", "at most"] = described("is to be")
    limit: float = described("limit", unit_in="shown_unit")
    unit: str = described("unit", is_unit=True, unit_in="shown_unit")
    utilisation: float | None = quantity("1", "η", "utilisation, 1 at the limit")
    passed: bool | None = described("passed")

    @property
    def shown_unit(self) -> str:
        """Unit of the key: a temperature is shown by another scale than a difference of two."""
        return keys()[f"requirements.{self.requirement}"].unit or ""

    def words(self, name: str) -> str | None:
        """Say that a life has no limit: it passes, and has no number."""
        return translate(UNLIMITED) if name == "value" and self.value is None and self.passed else None


class Judged(NamedTuple):
    """How a requirement is judged."""

    analysis: str
    """The analysis that answers it."""
    outcome: Callable[[Clutch, Any], float | None]
    """``(clutch, result)`` → what the clutch has, infinite where nothing limits it; None where that is not known."""
    least: bool = False
    """Whether it must reach the limit, instead of keeping below it."""
    needs: str = ""
    """What a spec lacks where there is no outcome; by default the analysis itself."""
    open: Callable[[Any], bool] = lambda result: False
    """``result`` → whether what the clutch has may be more."""


def _exceedance(clutch: Clutch, result: Any) -> float | None:
    """Probability above the limit, if the limit asked of the sample is that of a requirement there is."""
    required = clutch.spec.requirements
    if required is not None and result.torque_limit != required.torque_max:
        return None
    return result.probability_above_limit


def _most(triple: Triple | OpenTriple | None) -> float | None:
    """The largest over the friction range that is known."""
    values = () if triple is None else vars(triple).values()
    return max((value for value in values if value is not None), default=None)


def _of_heat(name: str, needs: str) -> Judged:
    """Judge the largest of a trip; where a slip has not ended at some friction, it may be more."""

    def may_be_more(result: Any) -> bool:
        triple = getattr(result, name)
        return triple is not None and None in vars(triple).values()

    return Judged("heat", lambda clutch, result: _most(getattr(result, name)), needs=needs, open=may_be_more)


def _cycles(clutch: Clutch, result: Any) -> float:
    """Life of the side that fails first; what the S-N line gives beyond its end is no number to sign."""
    lives = [side.as_set for side in (result.protected, result.unprotected) if "as-set" not in side.unlimited]
    return min((math.inf if life is None else life for life in lives), default=math.inf)


def _trips(clutch: Clutch, result: Any) -> float | None:
    """Trips per hour at the friction that allows the fewest; a slip without heat allows any number."""
    told = result.trips_per_hour
    return told and min((trips for trips in vars(told).values() if trips is not None), default=math.inf)


def _torque_after_wear(clutch: Clutch, result: Any) -> float | None:
    from .effects import torque_after_wear

    return torque_after_wear(clutch, result)


JUDGED: dict[str, Judged] = {
    "nominal_torque": Judged("torque", lambda clutch, result: result.nominal_torque, least=True),
    "machine_torque": Judged("torque", lambda clutch, result: result.machine_torque, least=True),
    "accuracy_factor": Judged("accuracy", lambda clutch, result: result.accuracy_factor),
    "accuracy_factor_hysteresis": Judged(
        "accuracy", lambda clutch, result: result.accuracy_factor_hysteresis or result.accuracy_factor
    ),
    "torque_max": Judged("torque", lambda clutch, result: result.torque_range.high),
    "outer_diameter": Judged(
        "torque",
        lambda clutch, result: (outer := clutch.spec.friction_group.outer_radius) and 2 * outer,
        needs="friction_group.outer_radius",
    ),
    "surface_pressure": Judged(
        "torque",
        lambda clutch, result: ring_pressures(clutch).get("mean"),
        needs="friction_group.inner_radius and outer_radius",
    ),
    "travel": Judged("torque", lambda clutch, result: _most(result.travel), needs="a sleeve that travels (indirect)"),
    "reduced_gain": Judged("torque", lambda clutch, result: result.reduced_gain),
    "peak_torque": Judged("simulate", lambda clutch, result: result.judged_peak, needs="[drive] with an event"),
    "exceedance": Judged("tolerance", _exceedance, needs="[tolerance], its torque_limit absent or that torque_max"),
    "work": _of_heat("specific_work", "[drive], [heat] and both radii"),
    "temperature": _of_heat("temperature", "[drive] and [heat]"),
    "face_temperature": _of_heat("face_temperature", "[drive], [heat] with conductivity and density, and both radii"),
    "contact_pressure": Judged(
        "synthesize",
        lambda clutch, result: result.contact_pressure,
        needs="control_unit.balls and control_unit.ball_circle_radius",
    ),
    "trips_per_hour": Judged(
        "heat",
        _trips,
        least=True,
        open=lambda result: None in vars(result.energy).values(),
        needs="[drive], [heat] with cooling and ambient, and a limit: requirements.temperature or a material",
    ),
    "torque_after_wear": Judged(
        "effects",
        _torque_after_wear,
        least=True,
        needs="heat.lining and the stiffness of the spring",
    ),
    "cycles": Judged("life", _cycles, least=True, needs="[fatigue]"),
}
"""Key of [requirements] → how it is judged; its unit is that of the key."""


def simulates(name: str, clutch: Clutch) -> bool:
    """Whether an analysis simulates the event of a clutch, or samples it: that takes long."""
    return name in simulating(clutch)


def simulating(clutch: Clutch) -> set[str]:
    """Return the analyses that simulate the event of a clutch, or sample it; a life only takes the event's factor."""
    of_event = {"simulate", "heat"} if clutch.spec.drive.event is not None else set()
    return of_event | ({"tolerance"} if clutch.spec.tolerance is not None else set())


def requirement_rows(answers: Answers, *, without: Collection[str] = ()) -> tuple[list[RequirementRow], list[Finding]]:
    """Return a row for every requirement of the spec, and a finding for each that is missed or not judged.

    What analyses answer that are in ``without`` is left out.
    """
    clutch = answers.clutch
    required = clutch.spec.requirements
    given = {} if required is None else required.model_dump(exclude_none=True)
    machine = clutch.spec.machine
    given |= {} if machine is None else {"machine_torque": float(clutch.quantities["torque_asked_for"])}
    rows, findings = [], []
    for name, limit in given.items():
        judged, path = JUDGED[name], f"requirements.{name}"
        if machine is not None and name == "machine_torque":
            path = "machine.power"
        if judged.analysis in without:
            continue
        value, unknown = None, False
        if ANALYSES[judged.analysis].applies(clutch):
            result = answers.ask(judged.analysis)[0]
            value, unknown = judged.outcome(clutch, result), judged.open(result)
        row = _row(clutch, name, float(limit), value, unknown=unknown)
        rows.append(row)
        if row.passed is None:
            needs = term(judged.needs or f"`{judged.analysis}`")
            if unknown:
                needs = term("an end of the slip: drive.cut_off, or a longer drive.event.duration")
            findings.append(
                finding("requirement-not-judged", "warning", limit=limit, path=path, name=term(row.name), needs=needs)
            )
        elif not row.passed:
            unit = ENGINEER.get(row.shown_unit, row.shown_unit)
            reached, wanted = (measured(number or 0.0, unit, 5) for number in (row.value, limit))
            missed = finding(
                "requirement-missed", "error", value=row.value, limit=limit, path=path, name=term(row.name),
                bound=term(row.bound), shown=reached, required=wanted,
            )  # fmt: skip
            findings.append(missed)
    return rows, [*findings, *_as_friction_falls(answers, given)]


def _as_friction_falls(answers: Answers, given: Mapping[str, float]) -> Iterator[Finding]:
    """Warn where K_т holds its limit and K_т,h, of which nothing is asked, does not; K_т,h is never the smaller."""
    limit, name = given.get("accuracy_factor"), "accuracy_factor_hysteresis"
    own = answers.clutch.quantities
    if limit is None or name not in own or name in given:
        return
    factor, returning = float(own["accuracy_factor"]), own[name]
    if factor <= limit * _HELD < returning:
        path = "requirements.accuracy_factor"
        yield finding("accuracy-not-lasting", "warning", value=float(returning), limit=limit, path=path, factor=factor)


def _row(clutch: Clutch, name: str, limit: float, value: float | None, *, unknown: bool) -> RequirementRow:
    key, least = keys()[f"requirements.{name}"], JUDGED[name].least
    over, under = (limit, value) if least else (value, limit)
    passed = None if over is None or under is None else over <= under * _HELD
    used = over / under if over is not None and under else None
    if value is not None and key.unit == "K abs":
        used = share_of_rise(clutch, value, limit)
    return RequirementRow(
        requirement=name,
        name=key.description.partition(",")[0],
        symbol=key.symbol or "",
        value=None if value is None or math.isinf(value) else value,
        bound="at least" if least else "at most",
        limit=limit,
        unit=(key.unit or "").removesuffix(" abs"),
        utilisation=used,
        passed=None if passed and unknown else passed,
    )
