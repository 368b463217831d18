"""Checks of a clutch: one list, evaluated with numbers by ``check`` and with arrays by ``design``.

for check in checks_of(spec):                                       # with the requirements of the spec
    value, limit = check.value_of(clutch), check.limit_of(clutch)   # of Quantities, or of Beside
    check.passes(value, limit)                                      # a bool, or an array of them
"""

import math
import re
import string
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import reduce
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Protocol, cast

from ..equations.arrays import is_array
from ..findings import FINDINGS, Finding, Level, finding
from ..messages import measured, translate
from ..spec.catalogues import balls
from ..spec.keys import keys
from ..units import ENGINEER, ZEROS

if TYPE_CHECKING:
    from ..spec.models import Spec

Part = Literal["simulate", "heat", "tolerance", "effects", "springs", "layout"]
"""Name of an analysis that gives checks values which are not quantities of the clutch."""
ROUNDING = 1e-9
"""Relative difference up to which a value counts as equal to its limit."""


class Known(Protocol):
    """Values by name: quantities of a clutch, or a dictionary."""

    def get(self, name: str, /) -> Any:
        """Return the value with this name; None if it is not known."""


class Beside(NamedTuple):
    """Values of one analysis (``part``), and the quantities of the clutch."""

    part: Mapping[str, Any]
    clutch: Known

    def get(self, name: str, /) -> Any:
        """Return the value with this name from the analysis, else the clutch's quantity of this name."""
        return self.part[name] if name in self.part else self.clutch.get(name)


class Check(NamedTuple):
    """Comparison of a value with its upper limit or, if ``least`` is true, with its lower limit."""

    code: str
    """Code of its finding, such as ``feedback-idle/key``."""
    name: str
    symbol: str
    unit: str
    value: str
    """Name of a quantity of the clutch, or of a value that the analysis ``needs`` gives."""
    limit: str | float
    """Name of the limiting quantity, or a number; ``checks_of`` replaces ``stated`` by a number of the spec."""
    least: bool = False
    strict: bool = False
    """True if a value on the limit fails."""
    level: Level = "error"
    path: str | None = None
    """Key of the spec to which the check belongs."""
    needs: Part | None = None
    """Analysis that gives the value; None if the value is a quantity of the clutch, which may be an array."""
    topic: str = "check"
    """Command that shows the check, besides ``check``."""
    when: tuple[str, ...] = ()
    """Names of the conditions in ``_WHEN`` under which the check applies; value and limit must be known as well."""

    @property
    def requirement(self) -> str | None:
        """Key of [requirements] that states the limit; None if the check judges no requirement."""
        return self.topic if self.code == "requirement-missed" else None

    def value_of(self, known: Known) -> Any:
        """Return the value, a number or an array; None if it is not known."""
        return _number(known.get(self.value))

    def limit_of(self, known: Known) -> Any:
        """Return the limit, a number or an array; None if it is not known."""
        return _number(known.get(self.limit)) if isinstance(self.limit, str) else self.limit

    def passes(self, value: Any, limit: Any) -> Any:
        """True if a value keeps within its limit, apart from rounding; False for NaN."""
        low, high = (limit, value) if self.least else (value, limit)
        return low < high * (1 - ROUNDING) if self.strict else low <= high * (1 + ROUNDING)

    def utilisation(self, value: float, limit: float, zero: float = 0.0) -> float:
        """Value over upper limit, or lower limit over value: 1 at the limit; temperatures count from ``zero``."""
        low, high = (limit, value) if self.least else (value, limit)
        return (low - zero) / (high - zero) if high > zero else math.inf


def _number(value: Any) -> Any:
    return None if isinstance(value, complex) or (not is_array(value) and value != value) else value


_TABLE = """\
gain-above-limit | feedback gain | C ≤ 1/(z_1 f_1max) | 1 | gain ≤ gain_limit | warning | control_unit.gain | | torque | breakaway
reduced-gain-above-limit | reduced gain | zC ≤ 5 | 1 | reduced_gain ≤ 5 | warning | control_unit.gain | | torque | recommended
feedback-idle | feedback gain | C > 0 | 1 | gain > 0 | warning | control_unit.gain | | torque | controlled
feedback-idle/key | gain against key friction | C > 2R f_1/d | 1 | gain > gain_threshold | warning | control_unit.gain | | torque |
accuracy-not-lasting | accuracy factor under a load that lasts | K_т,h ≤ [K_т] | 1 | accuracy_factor_hysteresis ≤ stated | warning | requirements.accuracy_factor | | check | lasting
below-nominal-torque | least torque in service | T_min ≥ T_н | N*m | torque_min ≥ nominal_torque | warning | adjustment.method | | torque |
returning-below-nominal | least torque, friction falling under load | T_ret ≥ T_н.маш | N*m | torque_returning_min ≥ machine_torque | warning | control_unit.key_friction | | torque | key
machine-not-driven | torque that the machine asks for | T_min ≥ T_маш | N*m | torque_min ≥ torque_asked_for | warning | machine.power | | torque |
slips-at-start | torque of a direct start | T_пуск ≤ T_min | N*m | starting_torque ≤ torque_min | info | machine.starting_torque_ratio | | torque | no-motor
slips-at-start | torque of a direct start | T_пуск ≤ T_min | N*m | starting_torque ≤ torque_min | info | drive.motor.breakdown_torque | | torque | motor
hub-too-large | hub within the discs | d ≤ 2r_i | m | hub_diameter ≤ disc_bore | error | control_unit.hub_diameter | | check | faces
hub-too-large | hub within the discs | d ≤ 2R_cp | m | hub_diameter ≤ mean_diameter | error | control_unit.hub_diameter | | check | no-faces
hub-too-large | hub within the balls | d ≤ 2r − d_ш | m | hub_diameter ≤ ball_bore | error | control_unit.hub_diameter | | check | pockets
shaft-yields | largest stress of the shaft, by von Mises | τ ≤ σ_т/√3 | Pa | stress_high_at_unprotected ≤ shear_yield_strength | error | shaft.yield_strength | | check | no-event
shaft-yields | largest stress of the shaft, by von Mises | τ ≤ σ_т/√3 | Pa | stress_high ≤ shear_yield_strength | error | shaft.yield_strength | | check | event
shaft-yields | largest stress of the shaft in the event, by von Mises | τ ≤ σ_т/√3 | Pa | event_stress ≤ shear_yield_strength | error | shaft.yield_strength | simulate | check | event
no-standard-ball | ball needed | 2 r_ш ≤ d_ш,max | m | ball_diameter_needed ≤ stated | error | | | pocket | pockets chosen
ball-too-small | ball diameter | d_ш ≥ 2 r_ш | m | ball_diameter ≥ ball_diameter_needed | error | control_unit.ball_diameter | | pocket | pockets given
wall-undercut | ball runs on the curved wall | r_ш < ρ_0 | m | ball_radius_chosen < undercut_radius | error | control_unit.gain_slope | | pocket | pockets
ball-reaches-axis | ball clear of the axis | r_ш ≤ r | m | ball_radius_chosen ≤ ball_circle_radius | error | control_unit.ball_circle_radius | | pocket | pockets single
balls-overlap | balls side by side | d_ш ≤ t_ш | m | ball_diameter ≤ ball_pitch | error | control_unit.balls | | pocket | pockets several
pockets-overlap | pockets side by side | b ≤ t_ш | m | pocket_width ≤ ball_pitch | error | control_unit.balls | | pocket | pockets several
depth-beyond-sleeve | pocket within the sleeve | h_c ≤ B | m | pocket_depth_cut ≤ sleeve_depth | error | control_unit.sleeve_depth | | pocket | pockets
contact-force-exceeded | contact force on one ball | F_n ≤ [F_n] | N | contact_force ≤ allowable_contact_force | error | control_unit.allowable_contact_force | | pocket | pockets
contact-force-exceeded/hertz | contact force on one ball, by Hertz | F_n ≤ [F_n]_H | N | contact_force ≤ contact_force_hertz | error | control_unit.contact | | pocket | pockets hertz
mean-pressure-in-range | surface pressure in the mean | p ≤ [p]_min | Pa | mean_pressure ≤ pressure_min | warning | | | check |
mean-pressure-exceeded | surface pressure in the mean | p ≤ [p]_max | Pa | mean_pressure ≤ pressure_max | error | | | check |
peak-pressure-in-range | surface pressure at the inner edge | p ≤ [p]_min | Pa | peak_pressure ≤ pressure_min | warning | | | check |
peak-pressure-exceeded | surface pressure at the inner edge | p ≤ [p]_max | Pa | peak_pressure ≤ pressure_max | error | | | check |
temperature-in-range | temperature of the faces, or of the discs | Θ ≤ [Θ]_min | K abs | hottest ≤ temperature_min | warning | | heat | heat |
temperature-exceeded | temperature of the faces, or of the discs | Θ ≤ [Θ]_max | K abs | hottest ≤ temperature_max | error | | heat | heat |
static-strength-exceeded | largest stress, protected side | τ_max < τ_u | Pa | stress_high < ultimate_strength | error | fatigue.ultimate_strength | | life |
static-strength-exceeded | largest stress, unprotected side | τ'_max < τ_u | Pa | stress_high_at_unprotected < ultimate_strength | error | fatigue.ultimate_strength | | life |
life-limited | damaging stress, protected side (beyond: limited life) | τ_eq ≤ τ_limb | Pa | damaging_stress ≤ endurance_limit | info | fatigue.endurance_limit | | life |
life-limited/unprotected | damaging stress, unprotected side (beyond: limited life) | τ'_eq ≤ τ_limb | Pa | damaging_stress_at_unprotected ≤ endurance_limit | info | fatigue.endurance_limit | | life |
housing-too-wide | housing in its space | D_h ≤ [D_h] | m | outer_diameter ≤ stated | error | envelope.outer_diameter | layout | layout |
clutch-too-long | length in its space | L ≤ [L] | m | length ≤ stated | error | envelope.length | layout | layout |
event-contact-force | contact force on one ball in the event | F_n ≤ [F_n] | N | contact_force ≤ contact_force_allowable | error | control_unit.balls | simulate | simulate | event
event-ball-leaves-pocket | travel in the event, the ball in its pocket | x_max ≤ [x] | m | travel_max ≤ travel_to_edge | error | | simulate | simulate | event
event-clearance | clearance of the ball in the event | y_x ≥ y | m | clearance ≥ edge_clearance | warning | control_unit.edge_clearance | simulate | simulate | event
event-spring-let-go | travel in the event, the closing spring pressing | x_max < x_0 | m | travel_max < travel_let_go | error | closing_spring | simulate | simulate | event
dynamic-factor-exceeded | dynamic factor of the event | T_peak/T ≤ k_д | 1 | dynamic_factor_of_event ≤ dynamic_factor | warning | drive.dynamic_factor | simulate | simulate | event assumed
"""  # noqa: E501
"""Rows that ``check_of`` reads, one for each check; the last column names conditions of ``_WHEN``."""

_REQUIRED = """\
nominal_torque ≥ nominal_torque
machine_torque ≥ machine_torque
accuracy_factor ≤ accuracy_factor
accuracy_factor_hysteresis ≤ accuracy_factor_hysteresis
torque_max ≤ torque_max
trip_ratio.min ≥ trip_ratio_min
trip_ratio.max ≤ trip_ratio_max
outer_diameter ≤ outer_diameter
surface_pressure ≤ mean_pressure
closing_force ≤ pack_force_at_rest
travel ≤ travel_max
reduced_gain ≤ reduced_gain
contact_pressure ≤ contact_pressure
cycles ≥ cycles
torque_after_wear ≥ torque_after_wear effects
peak_torque ≤ peak_torque simulate
exceedance ≤ exceedance tolerance
work ≤ specific_work heat
temperature ≤ temperature heat
face_temperature ≤ face_temperature heat
trips_per_hour ≥ trips_per_hour heat
"""
"""Rows: key of [requirements], ≤ for an upper or ≥ for a lower limit, limited quantity, analysis that gives it."""


def check_of(row: str) -> Check:
    """Return the check that a table row describes: code, name, symbol, unit, comparison, level and further fields."""
    code, name, symbol, unit, held, level, path, needs, topic, when = map(str.strip, re.split(r" \|(?= |$)", row))
    value, sign, limit = held.split()
    return Check(
        code, name, symbol, unit, value, float(limit) if limit.isdigit() else limit, sign in "≥>", sign in "<>",
        cast(Level, level), path or None, cast(Part, needs) or None, topic, tuple(when.split()),
    )  # fmt: skip


def _requirement_of(row: str) -> Check:
    name, sign, value, *needs = row.split()
    path, part = f"requirements.{name}", cast(Part, needs[0]) if needs else None
    return Check("requirement-missed", "", "", "", value, "stated", sign == "≥", path=path, needs=part, topic=name)


CHECKS = (*map(check_of, _TABLE.splitlines()), *map(_requirement_of, _REQUIRED.splitlines()))
"""All checks except the checks of spring parts (``parts.RULES``)."""
REQUIRED = {check.requirement: check for check in CHECKS if check.requirement}
"""Key of [requirements] → its check; ``checks_of`` fills in name, symbol and unit of the key."""


def checks_of(spec: "Spec", topic: str = "") -> tuple[Check, ...]:
    """Return the checks of one topic, or of all topics, that apply to a spec; requirements first.

    The value or the limit of a check may still be unknown (None).
    """
    checks = (check for check in CHECKS if not topic or check.topic == topic)
    applying = (check for check in checks if all(_WHEN[condition](spec) for condition in check.when))
    stated = (each for check in applying for each in _stated(spec, check))
    return tuple(sorted(stated, key=lambda check: not check.requirement))


def _has_pockets(spec: Any) -> bool:
    unit = spec.control_unit
    if unit is None or unit.ball_circle_radius is None:
        return False
    steepness = unit.gain if unit.wall_angle is None else unit.wall_angle
    return is_array(steepness) or bool(steepness)


def _has_several_balls(spec: Any) -> bool:
    balls = spec.control_unit.balls
    return balls is not None and (is_array(balls) or balls > 1)


_WHEN: Mapping[str, Callable[[Any], Any]] = {
    "breakaway": lambda spec: spec.kind.gain_limit == "breakaway",
    "recommended": lambda spec: spec.kind.gain_limit == "recommended",
    "controlled": lambda spec: spec.kind.controlled and not spec.kind.travels,
    "key": lambda spec: spec.kind.travels and (is_array(friction := spec.control_unit.key_friction) or friction),
    "lasting": lambda spec: spec.kind.travels and spec.requirements and spec.requirements.accuracy_factor
    and not spec.requirements.accuracy_factor_hysteresis,
    "faces": lambda spec: spec.friction_group.inner_radius is not None,
    "no-faces": lambda spec: spec.friction_group.inner_radius is None, "pockets": _has_pockets,
    "several": _has_several_balls, "single": lambda spec: not _has_several_balls(spec),
    "chosen": lambda spec: spec.control_unit.ball_diameter is None,
    "given": lambda spec: spec.control_unit.ball_diameter is not None,
    "hertz": lambda spec: spec.control_unit.allowable_contact_force is None or spec.control_unit.contact is not None,
    "event": lambda spec: spec.drive.event is not None, "no-event": lambda spec: spec.drive.event is None,
    "motor": lambda spec: spec.drive.motor is not None, "no-motor": lambda spec: spec.drive.motor is None,
    "assumed": lambda spec: spec.drive.dynamic_factor is not None and spec.fatigue is not None,
}  # fmt: skip
"""Name of a condition of a check → function that tests a spec."""


def _stated(spec: "Spec", check: Check) -> Iterator[Check]:
    """Yield a check with its limit from spec or catalogue, once for each material; nothing if there is no limit."""
    limit = check.limit
    if check.requirement:
        yield from _required(spec, check, check.requirement)
    elif check.code == "no-standard-ball":
        yield check._replace(limit=max(spec.lists.balls or balls()))
    elif check.topic == "layout":
        room = getattr(spec.envelope, (check.path or "").rpartition(".")[2], None)
        yield from [] if room is None else [check._replace(limit=room)]
    elif limit in ("pressure_min", "pressure_max", "temperature_min", "temperature_max"):
        for path, lining in spec.friction.linings.items():
            allowed = getattr(lining, str(limit))
            if allowed is not None:
                zero = float(ZEROS["degC"]) if check.unit == "K abs" else 0.0
                yield check._replace(limit=allowed + zero, path=path)
    elif check.code == "accuracy-not-lasting":
        yield check._replace(limit=cast(Any, spec.requirements).accuracy_factor)
    else:
        yield after_event(spec, check)


def _required(spec: "Spec", check: Check, name: str) -> Iterator[Check]:
    """Yield the check of a requirement if the spec states it; with [machine], machine_torque is always required."""
    asked: Any = spec.requirements
    limit, path = reduce(lambda block, key: getattr(block, key, None), name.split("."), asked), check.path
    if name == "machine_torque" and spec.machine is not None:
        limit, path = "torque_asked_for", "machine.power"
    if limit is None:
        return
    key, value = keys()[f"requirements.{name}"], check.value
    if not spec.kind.travels:  # a direct clutch has no travel and no hysteresis
        value = {"travel_max": "sleeve", "accuracy_factor_hysteresis": "accuracy_factor"}.get(value, value)
    if value == "contact_pressure" and not _has_pockets(spec):
        value = "pockets"
    name, unit = key.description.partition(",")[0], key.unit or "1"
    symbol = f"{key.symbol} {'≥' if check.least else '≤'} [{key.symbol}]"
    check = check._replace(name=name, symbol=symbol, unit=unit, value=value, limit=limit, path=path)
    yield after_event(spec, check)


def after_event(spec: "Spec", check: Check) -> Check:
    """Return the check; it needs ``simulate`` if its value depends on the dynamic factor of the event."""
    return check._replace(needs="simulate") if takes_factor_of_event(spec, check.value) else check


def takes_factor_of_event(spec: "Spec", quantity: str) -> bool:
    """True if a quantity depends on the dynamic factor and the spec takes the dynamic factor from its event."""
    open_factor = spec.drive.event is not None and spec.drive.dynamic_factor is None
    return open_factor and ("unprotected" in quantity or quantity.startswith("cycles"))


def failures(spec: "Spec", known: Known, checks: Iterable[Check]) -> list[Finding]:
    """Return a finding for each failed check; beyond the upper limit of a material its lower limit is not mentioned."""
    found = [
        _failure(spec, check, known, value, limit)
        for check in checks
        if (value := check.value_of(known)) is not None
        and (limit := check.limit_of(known)) is not None
        and not check.passes(value, limit)
    ]
    beyond = {(each.code.replace("-exceeded", "-in-range"), each.path) for each in found if "-exceeded" in each.code}
    return [each for each in found if (each.code, each.path) not in beyond]


def failures_of(spec: "Spec", known: Known, topic: str) -> list[Finding]:
    """Return a finding for each failed check that the command ``topic`` shows."""
    return failures(spec, known, checks_of(spec, topic))


def _failure(spec: "Spec", check: Check, known: Known, value: Any, limit: Any) -> Finding:
    """Return the finding of a failed check; its message may contain any quantity, the check and the material."""
    lining = spec.friction.linings.get(check.path or "")
    shown, required = apart(value, limit, check.unit)
    words = {"name": translate(check.name), "shown": shown, "required": required, "lining": lining and lining.name}
    words["bound"] = translate("at least") if check.least else translate("at most")
    fields = {field for _, field, _, _ in string.Formatter().parse(FINDINGS[check.code]) if field}
    named = {field: words[field] if field in words else known.get(field) for field in fields - _ALWAYS}
    return finding(check.code, check.level, value=value, limit=limit, path=check.path, **named)


_ALWAYS = {"value", "limit", "path"}


def apart(value: float, limit: float, unit: str) -> tuple[str, str]:
    """Return a value and its limit as text, with enough digits (five or more) to differ."""
    for digits in range(5, 16):
        shown, required = (measured(number, ENGINEER.get(unit, unit), digits) for number in (value, limit))
        if shown != required:
            break
    return shown, required
