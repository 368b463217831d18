"""What a clutch is to hold, each judged by the analysis that answers it."""

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any, Literal, NamedTuple

from ...engines.protocol import Clutch
from ...findings import Finding, finding
from ...messages import term, translate
from ...result import OpenTriple, Result, Sentence, Triple, quantity
from ...spec.paths import keys
from ..answers import Answers
from ..heat_findings import FREEZING, share_of_rise
from ..life import UNLIMITED
from ..registry import ANALYSES
from .pressure import ring_pressures

_HELD = 1 + 1e-9
"""What is beyond its limit by rounding holds it."""


class RequirementRow(Result):
    """One requirement, and whether the clutch holds it."""

    requirement: str = quantity("", None, "requirement")
    name: Sentence = quantity("", None, "quantity")
    symbol: str = quantity("", None, "symbol")
    value: float | None = quantity("", None, "value", unit_in="shown_unit")
    bound: Literal["at least", "at most"] = quantity("", None, "is to be")
    limit: float = quantity("", None, "limit", unit_in="shown_unit")
    unit: str = quantity("", None, "unit", is_unit=True, unit_in="shown_unit")
    utilisation: float | None = quantity("1", "η", "utilisation, 1 at the limit")
    passed: bool | None = quantity("", None, "passed")

    @property
    def shown_unit(self) -> str:
        """Unit of the key: a temperature is shown by another scale than a difference of two."""
        return _unit(self.requirement)

    def words(self, name: str) -> str | None:
        """Say that a life has no limit: it passes, and has no number."""
        return translate(UNLIMITED) if name == "value" and self.value is None and self.passed else None


class Judged(NamedTuple):
    """How a requirement is judged."""

    analysis: str
    """The analysis that answers it."""
    outcome: Callable[[Clutch, Any], float | None] | None = None
    """``(clutch, result)`` → what the clutch has, infinite where nothing limits it; None where that is not known."""
    least: bool = False
    """Whether it must reach the limit, instead of keeping below it."""
    needs: str = ""
    """What a spec lacks where there is no outcome; by default the analysis itself."""
    open: Callable[[Any], bool] = lambda found: False
    """``result`` → whether what the clutch has may be more."""


def _exceedance(clutch: Clutch, found: Any) -> float | None:
    required = clutch.spec.requirements
    assert required is not None
    asked: float | None = found.probability_above_limit
    return asked if found.torque_limit == required.torque_max else None


def _outer_diameter(clutch: Clutch, found: Any) -> float | None:
    outer = clutch.spec.friction_group.outer_radius
    return None if outer is None else 2 * outer


def _mean_pressure(clutch: Clutch, found: Any) -> float | None:
    return ring_pressures(clutch).get("mean")


def _most(found: Triple | OpenTriple | None) -> float | None:
    """The largest over the friction range that is known."""
    values = () if found is None else vars(found).values()
    return max((each for each in values if each is not None), default=None)


def _of_heat(name: str, needs: str) -> Judged:
    """Judge the largest of a trip; where a slip has not ended at some friction, it may be more."""
    return Judged(
        "heat",
        lambda clutch, found: _most(getattr(found, name)),
        needs=needs,
        open=lambda found: getattr(found, name) is not None and None in vars(getattr(found, name)).values(),
    )


def _cycles(clutch: Clutch, found: Any) -> float:
    """Life of the side that fails first; what the S-N line gives beyond its end is no number to sign."""
    lives = [side.as_set for side in (found.protected, found.unprotected) if "as-set" not in side.unlimited]
    return min((math.inf if life is None else life for life in lives), default=math.inf)


JUDGED: dict[str, Judged] = {
    "nominal_torque": Judged("torque", lambda clutch, found: found.nominal_torque, least=True),
    "machine_torque": Judged("torque", lambda clutch, found: found.machine_torque, least=True),
    "accuracy_factor": Judged("accuracy", lambda clutch, found: found.accuracy_factor),
    "accuracy_factor_hysteresis": Judged(
        "accuracy", lambda clutch, found: found.accuracy_factor_hysteresis or found.accuracy_factor
    ),
    "torque_max": Judged("torque", lambda clutch, found: found.torque_range.high),
    "outer_diameter": Judged("torque", _outer_diameter, needs="friction_group.outer_radius"),
    "surface_pressure": Judged("torque", _mean_pressure, needs="friction_group.inner_radius and outer_radius"),
    "travel": Judged("torque", lambda clutch, found: _most(found.travel), needs="a sleeve that travels (indirect)"),
    "reduced_gain": Judged("torque", lambda clutch, found: found.reduced_gain),
    "peak_torque": Judged("simulate", lambda clutch, found: found.judged_peak, needs="[drive] with an event"),
    "exceedance": Judged("tolerance", _exceedance, needs="[tolerance], its torque_limit absent or that torque_max"),
    "work": _of_heat("specific_work", "[drive], [heat] and both radii"),
    "temperature": _of_heat("temperature", "[drive] and [heat]"),
    "face_temperature": _of_heat("face_temperature", "[drive], [heat] with conductivity and density, and both radii"),
    "contact_pressure": Judged(
        "synthesize",
        lambda clutch, found: found.contact_pressure,
        needs="control_unit.balls and control_unit.ball_circle_radius",
    ),
    "cycles": Judged("life", _cycles, least=True, needs="[fatigue]"),
}
"""Key of [requirements] → how it is judged; its unit is that of the key. What has no outcome yet is not judged."""

_MISSED = {
    "1": "requirement-missed/number",
    "N*m": "requirement-missed/torque",
    "m": "requirement-missed/length",
    "J/m^2": "requirement-missed/work",
    "Pa": "requirement-missed/pressure",
    "K": "requirement-missed/temperature",
}
"""SI unit → sentence that shows it."""


def simulates(name: str, clutch: Clutch) -> bool:
    """Whether an analysis simulates the event of a clutch, or samples it: that takes long."""
    if name == "tolerance":
        return clutch.spec.tolerance is not None
    return name in ("simulate", "heat") and clutch.spec.drive.event is not None


def requirement_rows(answers: Answers, *, simulated: bool = True) -> tuple[list[RequirementRow], list[Finding]]:
    """Hold a clutch against every requirement of its spec.

    Args:
        answers: what was asked of it.
        simulated: whether those are judged that a simulation answers.

    Returns:
        A row for each, in the order of the spec's keys, and a finding for each that is missed or not judged.
    """
    required = answers.clutch.spec.requirements
    given = {} if required is None else required.model_dump(exclude_none=True)
    rows, found = [], []
    for name, limit in given.items():
        if not simulated and simulates(JUDGED[name].analysis, answers.clutch):
            continue
        value, unknown = _outcome(JUDGED[name], answers)
        row = _row(answers.clutch, name, float(limit), value, unknown=unknown)
        rows.append(row)
        path = f"requirements.{name}"
        if row.passed is None:
            needs = term(JUDGED[name].needs or f"`{JUDGED[name].analysis}`")
            if unknown:
                needs = term("an end of the slip: drive.cut_off, or a longer drive.event.duration")
            own = finding("requirement-not-judged", "warning", limit=limit, path=path, name=term(row.name), needs=needs)
            found.append(own)
        elif not row.passed:
            code, bound = _MISSED[row.unit], term(row.bound)
            own = finding(
                code, "error", value=row.value, limit=limit, path=path, name=term(row.name), bound=bound,
                celsius=(row.value or 0.0) - FREEZING, allowed=limit - FREEZING,
            )  # fmt: skip
            found.append(own)
    return rows, [*found, *_under_load_that_lasts(answers, given)]


def _under_load_that_lasts(answers: Answers, given: Mapping[str, float]) -> Iterator[Finding]:
    """Warn where K_т holds its limit and K_т,h, of which nothing is asked, does not; K_т,h is never the smaller."""
    limit, name = given.get("accuracy_factor"), "accuracy_factor_hysteresis"
    factor, lasting_factor = float(answers.clutch.accuracy_factor), answers.clutch.accuracy_factor_hysteresis
    if limit is None or lasting_factor is None or name in given:
        return
    if factor <= limit * _HELD < lasting_factor:
        path = "requirements.accuracy_factor"
        yield finding(
            "accuracy-not-lasting", "warning", value=float(lasting_factor), limit=limit, path=path, factor=factor
        )


def _outcome(judged: Judged, answers: Answers) -> tuple[float | None, bool]:
    """What the clutch has, and whether it may be more."""
    analysis = ANALYSES.get(judged.analysis)
    if judged.outcome is None or analysis is None or not analysis.applies(answers.clutch):
        return None, False
    found = answers.ask(analysis.name)[0]
    return judged.outcome(answers.clutch, found), judged.open(found)


def _unit(name: str) -> str:
    return keys()[f"requirements.{name}"].unit or ""


def _row(clutch: Clutch, name: str, limit: float, value: float | None, *, unknown: bool) -> RequirementRow:
    key, least = keys()[f"requirements.{name}"], JUDGED[name].least
    over, under = (limit, value) if least else (value, limit)
    held = None if over is None or under is None else over <= under * _HELD
    used = over / under if over is not None and under else None
    if value is not None and _unit(name) == "K abs":
        used = share_of_rise(clutch, value, limit)
    return RequirementRow(
        requirement=name,
        name=key.description.partition(",")[0],
        symbol=key.symbol or "",
        value=None if value is None or math.isinf(value) else value,
        bound="at least" if least else "at most",
        limit=limit,
        unit=_unit(name).removesuffix(" abs"),
        utilisation=used,
        passed=None if held and unknown else held,
    )
