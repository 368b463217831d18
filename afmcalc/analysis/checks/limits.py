"""Every limit a design is held against, passed or not, with its utilisation."""

import math
from collections.abc import Iterator
from typing import Literal, NamedTuple

from ...drive.result import HeatResult, SimulateResult
from ...engines.parts import demands_of
from ...engines.protocol import Clutch
from ...findings import Finding, Level, finding
from ...messages import say, term
from ...result import Result, Sentence, quantity
from ...spec.balls import diameters
from ...spec.edit import value_at
from ..answers import Answers
from ..fit import contact_limits
from ..heat_findings import judged_temperature, share_of_rise
from ..life import LifeResult
from ..registry import ANALYSES
from ..unit import SynthesisResult
from .pressure import pressure_findings

Grade = Literal["pass", "note", "warning", "fail"]
_GRADES: dict[str, Grade] = {"info": "note", "warning": "warning", "error": "fail"}


class Utilisation(Result):
    """One limit, and how much of it a design uses."""

    name: Sentence = quantity("", None, "check")
    symbol: Sentence = quantity("", None, "condition")
    value: float = quantity("", None, "value", unit_in="shown_unit")
    limit: float = quantity("", None, "limit", unit_in="shown_unit")
    unit: str = quantity("", None, "unit", is_unit=True, unit_in="shown_unit")
    utilisation: float = quantity("1", "η", "utilisation, 1 at the limit")
    verdict: Grade = quantity("", None, "verdict")

    @property
    def shown_unit(self) -> str:
        """Unit: what is held against a limit is a temperature, not a difference of two."""
        return "K abs" if self.unit == "K" else self.unit


class _Held(NamedTuple):
    """A value held against a limit: the largest allowed, or the ``least``."""

    code: str
    """Code of the finding that says how grave it is to be beyond."""
    name: str
    symbol: str
    unit: str
    value: float
    limit: float
    least: bool = False
    used: float | None = None
    """Utilisation, where it is not the ratio of both."""


def utilisations(answers: Answers, findings: list[Finding]) -> list[Utilisation]:
    """Hold a design against every limit that applies to it.

    Args:
        answers: what was asked of the clutch.
        findings: those of all its analyses; they decide how grave an exceeded limit is.

    Returns:
        The limits, each with its utilisation.
    """
    clutch = answers.clutch
    levels = {each.code: each.level for each in findings}
    synthesized, simulated, heated, lived = (
        ANALYSES[name].applies(clutch) for name in ("synthesize", "simulate", "heat", "life")
    )
    return [
        *(_used(each, levels) for each in _of_clutch(clutch)),
        *(_used(each, levels) for each in _of_hub(answers)),
        *(_used(each, levels) for each in (_of_synthesis(answers) if synthesized else ())),
        *(_used(each, levels) for each in (_of_event(answers) if simulated else ())),
        *_of_springs(clutch, _travel(answers.of(SimulateResult)) if simulated else 0.0),
        *map(_pressure, pressure_findings(clutch)),
        *(_used(each, levels) for each in (_of_heat(answers) if heated else ())),
        *(_used(each, levels) for each in (_of_life(answers.of(LifeResult)) if lived else ())),
    ]


def _used(held: _Held, levels: dict[str, Level]) -> Utilisation:
    code, name, symbol, unit, value, limit, least, used = held
    if used is None:
        used = limit / value if least else value / limit
    grade: Grade = _GRADES[levels.get(code, "info")] if used > 1 + 1e-9 else "pass"
    return Utilisation(name=name, symbol=symbol, unit=unit, value=value, limit=limit, utilisation=used, verdict=grade)


def _of_clutch(clutch: Clutch) -> Iterator[_Held]:
    gain, rule, limit = float(clutch.gain), clutch.spec.kind.gain_limit, clutch.gain_limit
    if rule is not None and limit is not None:
        value, bound = rule.stated(gain, clutch.reduced_gain, limit)
        yield _Held(rule.code, rule.quantity, rule.symbol, "1", float(value), float(bound))
    if clutch.gain_threshold:
        threshold = float(clutch.gain_threshold)
        yield _Held(
            "feedback-idle", term("gain against key friction"), "C ≥ 2R f_1/d", "1", gain, threshold, least=True
        )
    lowest, nominal = float(clutch.torque_min), float(clutch.nominal_torque)
    name = term("least torque in service")
    yield _Held("below-nominal-torque", name, "T_min ≥ T_н", "N*m", lowest, nominal, least=True)
    if (returned := clutch.torque_returning_min) is not None:
        name, machine = term("least torque, friction falling under load"), float(clutch.machine_torque)
        yield _Held("returning-below-nominal", name, "T_ret ≥ T_н.маш", "N*m", float(returned), machine, least=True)


def _of_hub(answers: Answers) -> Iterator[_Held]:
    """The hub is within the discs, and within the balls, whose sleeve it carries."""
    spec = answers.clutch.spec
    hub, inner = value_at(spec, "control_unit.hub_diameter"), spec.friction_group.inner_radius
    if hub is None:
        return
    room = 2 * (float(answers.clutch.mean_radius) if inner is None else inner)
    if ANALYSES["synthesize"].applies(answers.clutch):
        found = answers.of(SynthesisResult)
        room = min(room, 2 * found.ball_circle_radius - found.ball_diameter)
    if room > 0:  # else the balls reach the axis, which is said
        yield _Held("hub-too-large", term("hub within balls and discs"), "d ≤ 2r − d_ш, 2r_i", "m", hub, room)


def hub_findings(answers: Answers) -> list[Finding]:
    """Say that the hub is larger than balls and discs leave room for."""
    beyond = (each for each in _of_hub(answers) if each.value > each.limit * (1 + 1e-9))
    path = "control_unit.hub_diameter"
    return [finding(each.code, "error", value=each.value, limit=each.limit, path=path) for each in beyond]


def _of_synthesis(answers: Answers) -> Iterator[_Held]:
    found = answers.of(SynthesisResult)
    diameter, needed = found.ball_diameter, 2 * found.ball_radius
    if found.ball_diameter_standard is None:
        largest = max(diameters())
        yield _Held("no-standard-ball", term("ball needed"), say("2 r_ш ≤ largest of the list"), "m", needed, largest)
    else:
        yield _Held("ball-too-small", term("ball diameter"), "d_ш ≥ 2 r_ш", "m", diameter, needed, least=True)
    if found.undercut_radius is not None:
        limit = found.undercut_radius
        yield _Held("wall-undercut", term("ball runs on the curved wall"), "r_ш < ρ_0", "m", diameter / 2, limit)
    if found.ball_pitch is None:
        yield _Held(
            "ball-reaches-axis", term("ball clear of the axis"), "r_ш ≤ r", "m", diameter / 2, found.ball_circle_radius
        )
    else:
        yield _Held("balls-overlap", term("balls side by side"), "d_ш ≤ t_ш", "m", diameter, found.ball_pitch)
        yield _Held(
            "pockets-overlap", term("pockets side by side"), "b ≤ t_ш", "m", found.pocket_width, found.ball_pitch
        )
    if (sleeve := value_at(answers.clutch.spec, "control_unit.sleeve_depth")) is not None:
        depth = found.pocket_depth_cut
        yield _Held("depth-beyond-sleeve", term("pocket within the sleeve"), "h_c ≤ B", "m", depth, sleeve)
    for force, allowable, by_hertz in contact_limits(answers.clutch, found):
        name = term("contact force on one ball, by Hertz") if by_hertz else term("contact force on one ball")
        code = "contact-force-exceeded" if force > allowable else ""  # one limit may hold where the other does not
        yield _Held(code, name, "F_n ≤ [F_n]", "N", force, allowable)
    if found.seat_force is not None and found.seat_utilisation:
        force, allowable = found.seat_force, found.seat_force / found.seat_utilisation
        yield _Held("seat-force-exceeded", term("force of a seat on one ball"), "F_s ≤ [F_n]", "N", force, allowable)


def _travel(found: SimulateResult) -> float:
    """Largest travel of the sleeve in an event, m; 0 without one."""
    return 0.0 if found.travel_max is None else max(vars(found.travel_max).values())


def _of_event(answers: Answers) -> Iterator[_Held]:
    """What an event asks of balls and pockets."""
    from ..event import strength_of

    found, own = answers.of(SimulateResult), strength_of(answers.clutch)
    if found.contact_force is not None and own.contact_force is not None:
        force, name = max(vars(found.contact_force).values()), term("contact force on one ball in the event")
        yield _Held("event-contact-force", name, "F_n ≤ [F_n]", "N", force, own.contact_force)
    if own.travel is not None:
        name = term("travel in the event, the ball in its pocket")
        yield _Held("event-ball-leaves-pocket", name, "x_max ≤ [x]", "m", _travel(found), own.travel)


def _of_springs(clutch: Clutch, travel: float) -> Iterator[Utilisation]:
    """What the springs named are to hold, each judged on its own, where the sleeve travels so far in an event."""
    if not clutch.spec.spring_parts:
        return
    for path, (rule, value, limit, _), used in (
        (path, each, each.utilisation) for path, each in demands_of(clutch.spec, clutch.wishes(travel))
    ):
        if math.isfinite(used):
            spring = term("closing spring") if path.startswith("closing") else term("control spring")
            yield Utilisation(
                name=say("{spring}: {what}", spring=spring, what=term(rule.what)),
                symbol=rule.symbol, unit=rule.unit, value=value, limit=limit, utilisation=used,
                verdict=_GRADES[rule.level] if used > 1 + 1e-9 else "pass",
            )  # fmt: skip


def _of_heat(answers: Answers) -> Iterator[_Held]:
    """What the friction material has to bear of a trip."""
    judged = judged_temperature(answers.clutch, answers.of(HeatResult))
    if judged is None:
        return
    name, symbol = term("mean temperature of the discs"), "Θ ≤ [Θ]"
    if judged.of_faces:
        name, symbol = term("temperature of the faces"), "Θ_s ≤ [Θ]"
    value, low = judged.value, judged.limit.low
    code = "temperature-exceeded" if value > judged.limit.high else "temperature-in-range"
    yield _Held(code, name, symbol, "K", value, low, used=share_of_rise(answers.clutch, value, low))


def _of_life(found: LifeResult) -> Iterator[_Held]:
    protected = term("damaging stress, protected side (beyond: limited life)")
    unprotected = term("damaging stress, unprotected side (beyond: limited life)")
    sides = ((protected, "τ_eq", found.stress_protected), (unprotected, "τ'_eq", found.stress_unprotected))
    for name, symbol, stress in sides:
        if stress is not None:
            yield _Held("life-limited", name, f"{symbol} ≤ τ_limb", "Pa", stress, found.endurance_limit)


def _pressure(told: Finding) -> Utilisation:
    assert told.value is not None
    assert told.limit is not None
    inner, mean = term("surface pressure at the inner edge"), term("surface pressure in the mean")
    grade: Grade = "pass" if told.level == "info" else _GRADES[told.level]
    return Utilisation(
        name=inner if told.code.startswith("peak") else mean,
        symbol="p ≤ [p]", unit="Pa", value=told.value, limit=told.limit,
        utilisation=told.value / told.limit, verdict=grade,
    )  # fmt: skip
