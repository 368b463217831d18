"""Every limit a design is held against, passed or not, with its utilisation."""

import math
from collections.abc import Collection, Iterator
from typing import Literal, NamedTuple

from ..drive.result import HeatResult, SimulateResult
from ..engines import Clutch
from ..engines.parts import checks_of_spec
from ..engines.selection import Wired
from ..errors import given
from ..findings import Finding, Level, finding
from ..messages import say, term
from ..result import Result, Sentence, described, quantity
from ..spec.catalogues import Material
from ..spec.edit import value_at
from ..spec.lists import diameters
from .answers import Answers
from .clutch_findings import demands_on_springs
from .heat import judged_temperature, share_of_rise
from .layout import LayoutResult, space_limits
from .life import LifeResult
from .registry import ANALYSES
from .synthesize import SynthesisResult, contact_limits

Grade = Literal["pass", "note", "warning", "fail"]
_GRADES: dict[str, Grade] = {"info": "note", "warning": "warning", "error": "fail"}


class Utilisation(Result):
    """One limit, and how much of it a design uses."""

    name: Sentence = described("check")
    symbol: Sentence = described("condition")
    value: float = described("value", unit_in="shown_unit")
    limit: float = described("limit", unit_in="shown_unit")
    unit: str = described("unit", is_unit=True, unit_in="shown_unit")
    utilisation: float = quantity("1", "η", "utilisation, 1 at the limit")
    verdict: Grade = described("verdict")
    by_choice: bool = described("whether it holds by what was set or chosen so that it does", details=True)

    def words(self, name: str) -> str | None:
        """Say of a limit that is reached on purpose that it is: it does not limit the clutch."""
        return term("as chosen") if name == "verdict" and self.by_choice else None

    @property
    def shown_unit(self) -> str:
        """Unit: what is held against a limit is a temperature, not a difference of two."""
        return "K abs" if self.unit == "K" else self.unit


class _Limit(NamedTuple):
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
    level: Level | None = None
    """How grave it is to be beyond, where no finding says it."""
    by_choice: bool = False
    """Whether the spring is set, or the ball chosen, so that it holds: it limits nothing."""


def utilisations(answers: Answers, findings: list[Finding], without: Collection[str] = ()) -> list[Utilisation]:
    """Hold a design against every limit that applies to it; its findings decide how grave an exceeded limit is.

    What analyses answer that are in ``without`` is left out.
    """
    levels = {remark.code: remark.level for remark in findings}
    rows = []
    for code, name, symbol, unit, value, limit, least, used, level, by_choice in _limits(answers, without):
        share = used if used is not None else limit / value if least else value / limit
        grade: Grade = _GRADES[level or levels.get(code, "info")] if share > 1 + 1e-9 else "pass"
        row = Utilisation(
            name=name, symbol=symbol, unit=unit, value=value, limit=limit, utilisation=share, verdict=grade,
            by_choice=by_choice and grade == "pass",
        )  # fmt: skip
        rows.append(row)
    return rows


def _limits(answers: Answers, without: Collection[str]) -> Iterator[_Limit]:
    clutch = answers.clutch
    event, simulated = ANALYSES["simulate"].applies(clutch), "simulate" not in without
    yield from _of_clutch(clutch)
    yield from _of_hub(answers)
    yield from _of_shaft(answers, simulated=simulated)
    if ANALYSES["synthesize"].applies(clutch):
        yield from _of_synthesis(clutch, answers.of(SynthesisResult))
    if ANALYSES["layout"].applies(clutch):
        names = {"housing-too-wide": term("housing in its space"), "clutch-too-long": term("length in its space")}
        for code, path, value, limit in space_limits(clutch, answers.of(LayoutResult)):
            symbol = "D_h ≤ [D_h]" if path.endswith("diameter") else "L ≤ [L]"
            yield _Limit(code, names[code], symbol, "m", value, limit)
    if event and simulated:
        yield from _of_event(clutch, answers.of(SimulateResult))
    if simulated or not event:
        yield from _of_springs(clutch, _travel(answers.of(SimulateResult)) if event else 0.0)
    for remark in pressure_findings(clutch):
        inner, mean = term("surface pressure at the inner edge"), term("surface pressure in the mean")
        name = inner if remark.code.startswith("peak") else mean
        value, limit = given(remark.value), given(remark.limit)
        yield _Limit(remark.code, name, "p ≤ [p]", "Pa", value, limit, level=remark.level)
    if ANALYSES["heat"].applies(clutch) and "heat" not in without:
        yield from _of_heat(clutch, answers.of(HeatResult))
    if ANALYSES["life"].applies(clutch) and "life" not in without:
        lives = answers.of(LifeResult)
        protected = term("damaging stress, protected side (beyond: limited life)")
        unprotected = term("damaging stress, unprotected side (beyond: limited life)")
        sides = ((protected, "τ_eq", lives.stress_protected), (unprotected, "τ'_eq", lives.stress_unprotected))
        for name, symbol, stress in sides:
            if stress is not None:
                yield _Limit("life-limited", name, f"{symbol} ≤ τ_limb", "Pa", stress, lives.endurance_limit)


def _of_clutch(clutch: Wired) -> Iterator[_Limit]:
    own, rule = clutch.quantities, clutch.spec.kind.gain_limit
    gain, lowest, nominal = (float(own[name]) for name in ("gain", "torque_min", "nominal_torque"))
    if rule is not None:
        value, bound = rule.stated(gain, own["reduced_gain"], own["gain_limit"])
        yield _Limit(rule.code, rule.quantity, rule.symbol, "1", float(value), float(bound))
    travels = clutch.spec.kind.travels
    if travels and (least := float(own["gain_threshold"])):
        name = term("gain against key friction")
        yield _Limit("feedback-idle", name, "C ≥ 2R f_1/d", "1", gain, least, least=True)
    name = term("least torque in service")
    as_set = math.isclose(lowest, nominal)
    yield _Limit("below-nominal-torque", name, "T_min ≥ T_н", "N*m", lowest, nominal, least=True, by_choice=as_set)
    if travels:
        returned, machine = float(own["torque_returning_min"]), float(own["machine_torque"])
        name = term("least torque, friction falling under load")
        yield _Limit("returning-below-nominal", name, "T_ret ≥ T_н.маш", "N*m", returned, machine, least=True)
    if "torque_asked_for" in own:
        name, asked = term("torque that the machine asks for"), float(own["torque_asked_for"])
        yield _Limit("machine-not-driven", name, "T_min ≥ T_маш", "N*m", lowest, asked, least=True)
    if "starting_torque" in own:
        name, start = term("torque of a direct start"), float(own["starting_torque"])
        yield _Limit("slips-at-start", name, "T_пуск ≤ T_min", "N*m", start, lowest)


def _of_hub(answers: Answers) -> Iterator[_Limit]:
    """The hub is within the discs, and within the balls, whose sleeve it carries."""
    spec = answers.clutch.spec
    hub, inner = value_at(spec, "control_unit.hub_diameter"), spec.friction_group.inner_radius
    if hub is None:
        return
    room = 2 * (float(answers.clutch.quantities["mean_radius"]) if inner is None else inner)
    if ANALYSES["synthesize"].applies(answers.clutch):
        unit = answers.of(SynthesisResult)
        room = min(room, 2 * unit.ball_circle_radius - unit.ball_diameter)
    if room > 0:  # else the balls reach the axis, which is said
        yield _Limit("hub-too-large", term("hub within balls and discs"), "d ≤ 2r − d_ш, 2r_i", "m", hub, room)


def hub_findings(answers: Answers) -> list[Finding]:
    """Say that the hub is larger than balls and discs leave room for."""
    return [
        finding(hub.code, "error", value=hub.value, limit=hub.limit, path="control_unit.hub_diameter")
        for hub in _of_hub(answers)
        if hub.value > hub.limit * (1 + 1e-9)
    ]


def _of_shaft(answers: Answers, *, simulated: bool = True) -> Iterator[_Limit]:
    """The shaft does not yield at the peak torque of an event, or at the largest of the clutch times its factor."""
    clutch, own = answers.clutch, answers.clutch.quantities
    if "shear_yield_strength" not in own:
        return
    if not ANALYSES["simulate"].applies(clutch):
        own = own.at("unprotected")
    elif simulated:
        own = own.at(torque_high=max(float(own["torque_max"]), answers.of(SimulateResult).judged_peak))
    stress, limit = float(own["stress_high"]), float(own["shear_yield_strength"])
    name = term("largest stress of the shaft, by von Mises")
    yield _Limit("shaft-yields", name, "τ ≤ σ_т/√3", "Pa", stress, limit)


def shaft_findings(answers: Answers, *, simulated: bool = True) -> list[Finding]:
    """Say that the shaft yields; without ``simulated`` by the largest torque of the clutch alone where an event is."""
    own = answers.clutch.quantities
    return [
        finding(
            row.code, "error", value=row.value, limit=row.limit, path="shaft.yield_strength",
            torque=row.value * float(own["polar_section_modulus"]),
        )
        for row in _of_shaft(answers, simulated=simulated)
        if row.value > row.limit * (1 + 1e-9)
    ]  # fmt: skip


def _of_synthesis(clutch: Wired, unit: SynthesisResult) -> Iterator[_Limit]:
    diameter, needed, pitch = unit.ball_diameter, 2 * unit.ball_radius, unit.ball_pitch
    if unit.ball_diameter_standard is None:
        largest = max(clutch.spec.lists.balls or diameters())
        yield _Limit("no-standard-ball", term("ball needed"), say("2 r_ш ≤ largest of the list"), "m", needed, largest)
    else:
        name, chosen = term("ball diameter"), given(clutch.spec.control_unit).ball_diameter is None
        yield _Limit("ball-too-small", name, "d_ш ≥ 2 r_ш", "m", diameter, needed, least=True, by_choice=chosen)
    if (limit := unit.undercut_radius) is not None:
        yield _Limit("wall-undercut", term("ball runs on the curved wall"), "r_ш < ρ_0", "m", diameter / 2, limit)
    if pitch is None:
        name, circle = term("ball clear of the axis"), unit.ball_circle_radius
        yield _Limit("ball-reaches-axis", name, "r_ш ≤ r", "m", diameter / 2, circle)
    else:
        yield _Limit("balls-overlap", term("balls side by side"), "d_ш ≤ t_ш", "m", diameter, pitch)
        yield _Limit("pockets-overlap", term("pockets side by side"), "b ≤ t_ш", "m", unit.pocket_width, pitch)
    if (sleeve := value_at(clutch.spec, "control_unit.sleeve_depth")) is not None:
        depth = unit.pocket_depth_cut
        yield _Limit("depth-beyond-sleeve", term("pocket within the sleeve"), "h_c ≤ B", "m", depth, sleeve)
    for force, allowable, by_hertz in contact_limits(clutch.spec, unit):
        name = term("contact force on one ball, by Hertz") if by_hertz else term("contact force on one ball")
        code = "contact-force-exceeded" if force > allowable else ""  # one limit may hold where the other does not
        yield _Limit(code, name, "F_n ≤ [F_n]", "N", force, allowable)


def _travel(event: SimulateResult) -> float:
    """Largest travel of the sleeve in an event, m; 0 without one."""
    return 0.0 if event.travel_max is None else max(vars(event.travel_max).values())


def _of_event(clutch: Clutch, event: SimulateResult) -> Iterator[_Limit]:
    """What an event asks of balls and pockets."""
    from .simulate import strength_of

    strength = strength_of(clutch)
    if event.contact_force is not None and strength.contact_force is not None:
        force, name = max(vars(event.contact_force).values()), term("contact force on one ball in the event")
        yield _Limit("event-contact-force", name, "F_n ≤ [F_n]", "N", force, strength.contact_force)
    if strength.travel is not None:
        name = term("travel in the event, the ball in its pocket")
        yield _Limit("event-ball-leaves-pocket", name, "x_max ≤ [x]", "m", _travel(event), strength.travel)


def _of_springs(clutch: Wired, travel: float) -> Iterator[_Limit]:
    """What the springs named are to hold, each judged on its own, where the sleeve travels so far in an event."""
    if not clutch.spec.spring_parts:
        return
    own = clutch.quantities
    for path, demand in checks_of_spec(clutch.spec, demands_on_springs(clutch.spec, own, travel), own.apply):
        rule, used = demand.rule, demand.utilisation
        if math.isfinite(used):
            spring = term("closing spring") if path.startswith("closing") else term("control spring")
            name = say("{spring}: {what}", spring=spring, what=term(rule.what))
            yield _Limit(
                rule.code, name, rule.symbol, rule.unit, demand.value, demand.limit, used=used, level=rule.level
            )


def _of_heat(clutch: Clutch, heat: HeatResult) -> Iterator[_Limit]:
    """What the friction material has to bear of a trip."""
    judged = judged_temperature(clutch, heat)
    if judged is None:
        return
    value, of_faces, limit = judged
    name, symbol = term("mean temperature of the discs"), "Θ ≤ [Θ]"
    if of_faces:
        name, symbol = term("temperature of the faces"), "Θ_s ≤ [Θ]"
    code, used = "temperature-exceeded", share_of_rise(clutch, value, limit.low)
    yield _Limit(code if value > limit.high else "temperature-in-range", name, symbol, "K", value, limit.low, used=used)


def pressure_findings(clutch: Wired) -> list[Finding]:
    """Hold the pressure of the clutch at rest against the allowable range of each material named.

    The pack is pressed most at rest, before a release force sets in: with F_п of a direct clutch, F_п2 of an indirect
    one, whose control spring presses through sleeve and stop. Needs the inner and outer radius; with uniform wear the
    peak at the inner edge is held against the allowable too.
    """
    return [
        _pressure_finding(kind, pressure, material, path)
        for path, material in clutch.spec.friction.linings.items()
        if material.pressure_max is not None
        for kind, pressure in ring_pressures(clutch).items()
    ]


def ring_pressures(clutch: Wired) -> dict[str, float]:
    """Return the pressure of a pack at rest in the ``mean`` and at its ``peak``, Pa; empty without both radii."""
    own = clutch.quantities
    return {kind: float(own[name]) for kind in ("mean", "peak") if (name := f"{kind}_pressure") in own}


_PRESSURE_CODES = {
    "mean": ("mean-pressure", "mean-pressure-in-range", "mean-pressure-exceeded"),
    "peak": ("peak-pressure", "peak-pressure-in-range", "peak-pressure-exceeded"),
}


def _pressure_finding(kind: str, pressure: float, material: Material, path: str) -> Finding:
    """Below the printed range of the allowable: fine; within: the designer's to judge; above: an error."""
    low, high = given(material.pressure_min), given(material.pressure_max)
    grave = (pressure > low) + (pressure > high)
    levels: tuple[Level, ...] = ("info", "warning", "error")
    return finding(
        _PRESSURE_CODES[kind][grave], levels[grave], value=pressure, limit=low, path=path, used=pressure / low,
        low=low, high=high, name=material.name,
    )  # fmt: skip
