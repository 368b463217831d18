"""Шишкарев 2021 (S21), indirect regulation: figures 2 and 4, and the claims P5–P8 and P27–P30.

All are set at f_min, so the clutch below its setting does not enter.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..equations import accuracy, control_unit, indirect, pack
from ..equations.arrays import Values
from ..messages import say
from .claims import Found, PaperAxis, PaperFigure, curve, near, verdict

_FACTOR: Any = indirect.STRAIGHT["accuracy_factor_as_set"]

_PAIRS, _RADIUS, _HUB, _KEY = 8, 0.1, 0.05, 0.15
_LOW, _HIGH = 0.1, 0.8
_CLOSING, _CONTROL = (20e3, 30e3, 40e3), 10e3
_INPUTS = "f = 0.1…0.8, z = 8, R_cp = 100 mm, d = 50 mm, f_1 = 0.15, c_2 = 10 N/mm"
_BALL_CIRCLE, _FORCE, _GAP = 0.05, 1000.0, 0.002


def factor(gain: Values, stiffness: float = _CLOSING[0]) -> Values:
    """K_т of curves 1–3, (15) mended."""
    net = indirect.net_gain(gain, indirect.gain_threshold(_RADIUS, _KEY, _HUB))
    moving = (indirect.sleeve_stiffness(stiffness, _CONTROL, _PAIRS, friction, net) for friction in (_LOW, _HIGH))
    return _FACTOR(_LOW, _HIGH, *moving, _PAIRS, net, _LOW)


def base_factor(gain: Values) -> Values:
    """K_т of curve 5, the base clutch with all pairs controlled."""
    return accuracy.accuracy_factor_of_path(0, _PAIRS, gain, _LOW, _LOW, _HIGH, _HIGH)


def _sine(gain: Values) -> Values:
    """Sine of the wall angle (24)."""
    return np.sin(np.arctan(pack.tan_wall_angle(gain, _BALL_CIRCLE, _RADIUS)))


def ball_and_travel(gain: Values, force: float = _FORCE) -> tuple[Values, Values]:
    """Radius of the ball (23) and largest travel (16), fig. 4."""
    net = indirect.net_gain(gain, indirect.gain_threshold(_RADIUS, _KEY, _HUB))
    stiffness = indirect.sleeve_stiffness(_CLOSING[0], _CONTROL, _PAIRS, _HIGH, net)
    travel = indirect.travel_as_set(_PAIRS, force, _HIGH, _LOW, net, stiffness)
    return control_unit.ball_radius(travel, _GAP, _GAP, _sine(gain)), travel


def _gains(stop: float) -> NDArray[np.float64]:
    """Gains from the threshold of the feedback on."""
    return np.linspace(indirect.gain_threshold(_RADIUS, _KEY, _HUB), stop, 241)


def figure_2() -> PaperFigure:
    """K_т of the indirect clutch over its gain, formula (15), with K_п and the base clutch."""
    gain = _gains(12.0)
    curves = [
        curve(str(number), f"K_т, c_1 = {stiffness / 1e3:g} N/mm", gain, factor(gain, stiffness))
        for number, stiffness in enumerate(_CLOSING, start=1)
    ]
    curves += [
        curve("4", "K_п, nominal torque ratio", gain, indirect.nominal_torque_ratio(_PAIRS, gain, _LOW, 1.0, 1.0)),
        curve("5", "K_т of the base clutch", gain, base_factor(gain)),
    ]
    return PaperFigure(
        name="S21 fig. 2",
        title="accuracy and nominal torque of the indirect clutch against the gain",
        panels=[curves],
        x=PaperAxis("feedback gain", "C"),
        y=[PaperAxis("accuracy factor K_т, torque ratio", "K_п")],
        inputs=f"Formula (15), {_INPUTS}.",
        corrections=[
            "M9: (15) with 2 z R c_1 f f_1 divided by d",
            "M26: at equal gain the indirect clutch is less accurate than the base clutch (curve 5)",
            "M27: K_п compares at equal F_п1; at equal force on the pack (F_п2 at rest) it is 1.364, not 1.8, at C = 1",
            "M38: curve 5 has all z pairs controlled; with one bypass pair it is 2.061, not 1.946, at C = 1",
        ],
        assumed="range of C from the threshold 2 R f_1/d = 0.6 to 12 (both printed averages, 1.03 and 1.18, fit 3…12).",
    )


def figure_4() -> PaperFigure:
    """Ball radius (23) and travel (16) over the gain."""
    gain = _gains(24.0)
    radius, travel = ball_and_travel(gain)
    return PaperFigure(
        name="S21 fig. 4",
        title="ball radius and largest travel against the gain",
        panels=[[curve("1", "r_ш, ball radius (23)", gain, radius), curve("2", "x_max, travel (16)", gain, travel)]],
        x=PaperAxis("feedback gain", "C"),
        y=[PaperAxis("ball radius r_ш, travel", "x_max", "m")],
        inputs=f"Formulas (16), (23), {_INPUTS}, c_1 = 20 N/mm.",
        corrections=[
            "M28: the data are those of curve 1 of fig. 2, printed fig. 3",
            "P8: r_ш first rises, falls from C ≈ 1, and rises again from C ≈ 18; it does not simply fall",
        ],
        assumed="F_п1 = 1 kN, r = 50 mm, s = y = 2 mm, range of C.",
    )


_RANGES = ((3.0, 12.0), (1.5, 19.0))
"""The range of C in fig. 2 is not printed; over each of these, and others, both printed averages come out."""


def _stiffer(gain: Values) -> Values:
    return factor(gain) / factor(gain, 40e3)


def _doubled(gain: Values) -> Values:
    return factor(gain) / factor(2 * gain)


def _average(function: Callable[[Values], Values], low: float, high: float) -> float:
    """Average over the gain by the midpoint rule."""
    return float(np.mean(function(np.linspace(low, high, 4001)[1::2])))


def p5() -> Found:
    """K_т falls when c_1 is doubled."""
    at = [float(_stiffer(gain)) for gain in (1.0, 4.0)]
    averages = [_average(_stiffer, *gains) for gains in _RANGES]
    return _open(
        1.03, at, averages,
        say("{first:.3f} at C 1, {last:.3f} at C 4; {average}", first=at[0], last=at[1], average=_over(averages)),
    )  # fmt: skip


def p6() -> Found:
    """K_т falls when C is doubled."""
    at = [float(_doubled(gain)) for gain in (1.0, 2.0)]
    averages = [_average(_doubled, low, high / 2) for low, high in _RANGES]
    computed = say(
        "{first:.3f} (C 1 → 2), {last:.3f} (2 → 4); {average} (C and 2C)",
        first=at[0], last=at[1], average=_over(averages),
    )  # fmt: skip
    return _open(1.18, at, averages, computed)


def _over(averages: list[float]) -> str:
    ranges = [say("{low:g}…{high:g}", low=low, high=high) for low, high in _RANGES]
    return say("on average {averages:.3f} over C {ranges}", averages=averages, ranges=ranges)


def _open(printed: float, at: list[float], averages: list[float], computed: str) -> Found:
    """Judge an average over an axis that is not printed: undecided where some ranges give it and others do not."""
    possible = all(near(average, printed, 0.005) for average in averages)
    as_printed = all(near(value, printed, 0.005) for value in at)
    return Found(computed, "undecided" if possible and not as_printed else verdict(as_printed), at[0] / printed - 1)


def p7() -> Found:
    """The base clutch is more accurate."""
    gains = (1.0, 2.0, 4.0)
    base, own = ([float(of(gain)) for gain in gains] for of in (base_factor, factor))
    text = say("C 1, 2, 4: base {base:.3f}; indirect {own:.3f}", base=base, own=own)
    return Found(text, verdict(all(first < second for first, second in zip(base, own, strict=True))))


def p8() -> Found:
    """Ball radius falls, travel grows with the gain."""
    forces = (100.0, 1000.0, 5000.0)
    curves = [tuple(map(np.asarray, ball_and_travel(_WIDE, force))) for force in forces]
    turns = [_turns(radii) for radii, _ in curves]
    grows = all(np.all(np.diff(travels) > 0) for _, travels in curves)
    falls = all(
        np.all(np.diff(radii[top : bottom + 1]) < 0) for (radii, _), (top, bottom) in zip(curves, turns, strict=True)
    )
    text = say(
        "x_max grows; r_ш rises to C = {tops:.2f}, falls to C = {bottoms:.1f}, then grows again, "
        "for F_п1 = {forces:.1f kN}",
        tops=[_WIDE[top] for top, _ in turns],
        bottoms=[_WIDE[bottom] for _, bottom in turns],
        forces=forces,
    )
    return Found(text, verdict(grows and falls and turns == [(0, len(_WIDE) - 1)] * 3, grows and falls))


_WIDE = np.linspace(0.6, 60.6, 60001)
"""Gains of p8, p28 and p29, from the threshold on."""


def _turns(values: NDArray[np.float64]) -> tuple[int, int]:
    """Where a curve has its maximum, and after that its minimum."""
    top = int(np.argmax(values))
    return top, top + int(np.argmin(values[top:]))


def _torque(gain: Values, friction: float) -> Values:
    """T of (11) with the control spring set by (14)."""
    net = indirect.net_gain(gain, indirect.gain_threshold(_RADIUS, _KEY, _HUB))
    control = indirect.control_force_set(_FORCE, _PAIRS, net, _LOW)
    stiffness = indirect.sleeve_stiffness(_CLOSING[0], _CONTROL, _PAIRS, friction, net)
    normal = indirect.normal_force_moving(_FORCE, _CLOSING[0], control, _CONTROL, stiffness)
    return indirect.torque(normal, _RADIUS, _PAIRS, friction)


def p27() -> Found:
    """The gain raises the accuracy and leaves the nominal torque; the closing spring does less."""
    gains, shown = _gains(60.0)[1:], (1.0, 4.0, 12.0)
    rises = np.all(np.diff(factor(gains)) < 0) and np.ptp(_torque(gains, _LOW)) < 1e-9
    text = say(
        "C 1, 4, 12: K_т {factors:.3f}, T_н {torques:.1f N·m}; doubling C divides K_т by {doubled:.3f}, "
        "doubling c_1 by {stiffer:.3f}",
        factors=[float(factor(gain)) for gain in shown],
        torques=[float(_torque(gain, _LOW)) for gain in shown],
        doubled=[float(_doubled(gain)) for gain in shown],
        stiffer=[float(_stiffer(gain)) for gain in shown],
    )
    return Found(text, verdict(bool(rises and np.all(_doubled(gains) > _stiffer(gains)))))


def p28() -> Found:
    """Pockets get shallower with the gain, since the sine of the wall angle grows faster than the travel."""
    radii, travels = map(np.asarray, ball_and_travel(_WIDE))
    sines = np.asarray(_sine(_WIDE))
    depths = control_unit.pocket_depth(radii, sines, _GAP)
    (top, bottom), (deepest, shallowest) = _turns(radii), _turns(depths)
    # growth of sin α less that of the sum x_max + s + 2y which (23) divides by it
    faster = np.diff(np.log(sines)) > np.diff(np.log(travels + 3 * _GAP))
    text = say(
        "h_1 falls from C = {deepest:.2f} to {shallowest:.1f}; sin α grows faster than x_max + s + 2y from {top:.2f} "
        "to {bottom:.1f}; release force at f_max {forces:.2f kN} at C 1, 4, 12",
        deepest=_WIDE[deepest],
        shallowest=_WIDE[shallowest],
        top=_WIDE[top],
        bottom=_WIDE[bottom],
        forces=[float(indirect.release_force(_torque(gain, _HIGH), gain, _RADIUS)) for gain in (1.0, 4.0, 12.0)],
    )
    inside = bool(np.all(faster[top:bottom]) and np.all(np.diff(depths[top : bottom + 1]) < 0))
    return Found(text, verdict(bool(np.all(faster) and np.all(np.diff(depths) < 0)), inside))


def p29() -> Found:
    """The nominal torque sets no limit to the gain, and the accuracy rises with it."""
    cosine = 1 / np.sqrt(1 + pack.tan_wall_angle(_WIDE, _BALL_CIRCLE, _RADIUS) ** 2)
    contact = np.asarray(control_unit.contact_force(_torque(_WIDE, _HIGH), 1, _BALL_CIRCLE, cosine))
    least = int(np.argmin(contact))
    text = say(
        "T_н {torque:.1f N·m} for every C; K_т {factors:.3f} at C 1, 10, 60; n F_n is least at C = {least:.2f}, "
        "{force:.2f kN}, and {last:.2f kN} at C = 60",
        torque=_torque(1.0, _LOW),
        factors=[float(factor(gain)) for gain in (1.0, 10.0, 60.0)],
        least=_WIDE[least],
        force=contact[least],
        last=float(np.interp(60, _WIDE, contact)),
    )
    return Found(text, verdict(bool(np.ptp(_torque(_WIDE, _LOW)) < 1e-9 and np.all(np.diff(factor(_WIDE)) < 0))))


def p30() -> Found:
    """The stiffness of the closing spring is a second means to set the accuracy."""
    factors = [float(factor(1.0, stiffness)) for stiffness in _CLOSING]
    text = say(
        "K_т at C 1 with c_1 = {stiffnesses:.0f N/mm}: {factors:.3f}; base clutch {base:.3f} with each",
        stiffnesses=_CLOSING, factors=factors, base=base_factor(1.0),
    )  # fmt: skip
    return Found(text, verdict(factors[0] > factors[1] > factors[2]))
