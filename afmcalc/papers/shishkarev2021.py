"""Шишкарев 2021 (S21), indirect regulation: curves of figures 2 and 4, and the claims P5–P8, P27–P30, P41 and P42.

All clutches are set at f_min, so friction is never below the friction at the setting.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..equations import accuracy, control_unit, indirect, pack
from ..equations.arrays import Values
from .claims import Curves, Recomputed, judged, near

_FACTOR: Any = indirect.STRAIGHT["accuracy_factor_as_set"]

_PAIRS, _RADIUS, _HUB, _KEY = 8, 0.1, 0.05, 0.15
_LOW, _HIGH = 0.1, 0.8
_CLOSING, _CONTROL = (20e3, 30e3, 40e3), 10e3
_BALL_CIRCLE, _FORCE, _GAP = 0.05, 1000.0, 0.002
_THRESHOLD = indirect.gain_threshold(_RADIUS, _KEY, _HUB)
"""Gain above which there is feedback."""
_RANGES = ((3.0, 12.0), (1.5, 19.0))
"""Two of the ranges of the gain C over which both printed averages result; fig. 2 prints no range."""
_WIDE = np.linspace(0.6, 60.6, 60001)
"""Gains for p8, p28 and p29, from the threshold of feedback on."""


def _stiffness(gain: Values, friction: float, closing: float = _CLOSING[0]) -> Any:
    """Stiffness D(f) against which the sleeve moves, as in (10)."""
    net = indirect.net_gain(gain, _THRESHOLD)
    return indirect.sleeve_stiffness(closing, _CONTROL, _PAIRS, friction, net)


def factor(gain: Values, stiffness: float = _CLOSING[0]) -> Any:
    """Accuracy factor K_т of curves 1–3, by (15) with its misprint corrected."""
    moving = (_stiffness(gain, friction, stiffness) for friction in (_LOW, _HIGH))
    return _FACTOR(_LOW, _HIGH, *moving, _PAIRS, indirect.net_gain(gain, _THRESHOLD), _LOW)


def base_factor(gain: Values) -> Any:
    """Accuracy factor K_т of curve 5: the base clutch, all of whose pairs are controlled."""
    return accuracy.accuracy_factor_of_path(0, _PAIRS, gain, _LOW, _LOW, _HIGH, _HIGH)


def _sine(gain: Values) -> Any:
    """Sine of the wall angle (24)."""
    return np.sin(np.arctan(pack.tan_wall_angle(gain, _BALL_CIRCLE, _RADIUS)))


def ball_and_travel(gain: Values, force: float = _FORCE) -> tuple[Values, Values]:
    """Radius of the ball (23) and largest travel (16), fig. 4."""
    net = indirect.net_gain(gain, _THRESHOLD)
    travel = indirect.travel_as_set(_PAIRS, force, _HIGH, _LOW, net, _stiffness(gain, _HIGH))
    return control_unit.ball_radius(travel, 0.0, _GAP, _GAP, _sine(gain)), travel


def _gains(stop: float) -> NDArray[np.float64]:
    """Gains from the threshold of feedback to ``stop``."""
    return np.linspace(_THRESHOLD, stop, 241)


def figure_2() -> Curves:
    """Curves over the gain: K_т of the indirect clutch by (15), ratio K_п of nominal torques, K_т of base clutch."""
    gain = _gains(12.0)
    for stiffness in _CLOSING:
        yield gain, factor(gain, stiffness)
    yield gain, indirect.nominal_torque_ratio(_PAIRS, gain, _LOW, 1.0, 1.0)
    yield gain, base_factor(gain)


def figure_4() -> Curves:
    """Ball radius (23) and travel (16) over the gain."""
    gain = _gains(24.0)
    for curve in ball_and_travel(gain):
        yield gain, curve


def _stiffer(gain: Values) -> Any:
    return factor(gain) / factor(gain, 40e3)


def _doubled(gain: Values) -> Any:
    return factor(gain) / factor(2 * gain)


def _on_average(printed: float, of: Callable[[Values], Values], gains: tuple[float, float], up_to: float) -> Recomputed:
    """Judge a printed average over a range that is not printed; it holds as printed if both ``gains`` give it.

    The claim is undecided if each range in ``_RANGES``, taken up to the share ``up_to`` of its end, gives the average.
    """
    first, last = (of(gain) for gain in gains)
    averages = [np.mean(of(np.linspace(low, up_to * high, 4001)[1::2])) for low, high in _RANGES]
    possible = all(near(average, printed, 0.005) for average in averages)
    as_printed = near(first, printed, 0.005) and near(last, printed, 0.005)
    values = {"first": first, "last": last, "averages": averages}
    return judged(as_printed, deviation=first / printed - 1, undecided=possible, **values)


def p5() -> Recomputed:
    """Judge the claim that K_т falls by a factor of 1.03 on average if the stiffness c_1 is doubled."""
    return _on_average(1.03, _stiffer, (1.0, 4.0), 1.0)


def p6() -> Recomputed:
    """Judge the claim that K_т falls by a factor of 1.18 on average if the gain C is doubled."""
    return _on_average(1.18, _doubled, (1.0, 2.0), 0.5)


def p7() -> Recomputed:
    """Judge the claim that the base clutch is more accurate than the indirect clutch."""
    base, own = ([of(gain) for gain in (1.0, 2.0, 4.0)] for of in (base_factor, factor))
    return judged(all(first < second for first, second in zip(base, own, strict=True)), base=base, own=own)


def p8() -> Recomputed:
    """Judge the claim that the ball radius falls and the travel grows with the gain."""
    forces = (100.0, 1000.0, 5000.0)
    curves = [tuple(map(np.asarray, ball_and_travel(_WIDE, force))) for force in forces]
    turns = [_turns(radii) for radii, _ in curves]
    holds = all(
        np.all(np.diff(travels) > 0) and np.all(np.diff(radii[top : bottom + 1]) < 0)
        for (radii, travels), (top, bottom) in zip(curves, turns, strict=True)
    )
    tops, bottoms = ([_WIDE[place] for place in places] for places in zip(*turns, strict=True))
    return judged(holds and turns == [(0, len(_WIDE) - 1)] * 3, holds, tops=tops, bottoms=bottoms, forces=forces)


def _turns(values: NDArray[np.float64]) -> tuple[int, int]:
    """Indices of the maximum of a curve, and of the minimum after this maximum."""
    top = int(np.argmax(values))
    return top, top + int(np.argmin(values[top:]))


def _torque(gain: Values, friction: float) -> Any:
    """Torque T by (11), with the control spring set by (14)."""
    control = indirect.control_force_set(_FORCE, _PAIRS, indirect.net_gain(gain, _THRESHOLD), _LOW)
    normal = indirect.normal_force_moving(_FORCE, _CLOSING[0], control, _CONTROL, _stiffness(gain, friction))
    return indirect.torque(normal, _RADIUS, _PAIRS, friction)


def p27() -> Recomputed:
    """Judge the claim that a larger gain keeps T_н and raises accuracy more than a stiffer closing spring does."""
    gains, shown = _gains(60.0)[1:], (1.0, 4.0, 12.0)
    rises = np.all(np.diff(factor(gains)) < 0) and np.ptp(_torque(gains, _LOW)) < 1e-9
    return judged(
        rises and np.all(_doubled(gains) > _stiffer(gains)),
        factors=[factor(gain) for gain in shown],
        torques=[_torque(gain, _LOW) for gain in shown],
        doubled=[_doubled(gain) for gain in shown],
        stiffer=[_stiffer(gain) for gain in shown],
    )


def p28() -> Recomputed:
    """Judge the claim that pockets get shallower with the gain, since sin α grows faster than the travel."""
    radii, travels = map(np.asarray, ball_and_travel(_WIDE))
    sines = _sine(_WIDE)
    depths = control_unit.pocket_depth(radii, sines, _GAP)
    (top, bottom), (deepest, shallowest) = _turns(radii), _turns(depths)
    # by (23) the sum x_max + s + 2y is divided by sin α, which must therefore grow faster than the sum
    faster = np.diff(np.log(sines)) > np.diff(np.log(travels + 3 * _GAP))
    places = {"deepest": deepest, "shallowest": shallowest, "top": top, "bottom": bottom}
    forces = [indirect.release_force(_torque(gain, _HIGH), gain, _RADIUS) for gain in (1.0, 4.0, 12.0)]
    inside = np.all(faster[top:bottom]) and np.all(np.diff(depths[top : bottom + 1]) < 0)
    everywhere = np.all(faster) and np.all(np.diff(depths) < 0)
    return judged(everywhere, inside, **{name: _WIDE[at] for name, at in places.items()}, forces=forces)


def p29() -> Recomputed:
    """Judge the claim that the nominal torque does not limit the gain, and that accuracy rises with the gain."""
    cosine = 1 / np.sqrt(1 + pack.tan_wall_angle(_WIDE, _BALL_CIRCLE, _RADIUS) ** 2)
    contact = control_unit.contact_force(_torque(_WIDE, _HIGH), 1, _BALL_CIRCLE, cosine)
    least = int(np.argmin(contact))
    return judged(
        np.ptp(_torque(_WIDE, _LOW)) < 1e-9 and np.all(np.diff(factor(_WIDE)) < 0),
        torque=_torque(1.0, _LOW),
        factors=[factor(gain) for gain in (1.0, 10.0, 60.0)],
        least=_WIDE[least],
        force=contact[least],
        last=np.interp(60, _WIDE, contact),
    )


def p30() -> Recomputed:
    """Judge the claim that the stiffness of the closing spring is a second means to set the accuracy."""
    factors = [factor(1.0, stiffness) for stiffness in _CLOSING]
    return judged(factors[0] > factors[1] > factors[2], stiffnesses=_CLOSING, factors=factors, base=base_factor(1.0))


def p41() -> Recomputed:
    """Judge the claim that the indirect clutch has more capacity and more accuracy than the base clutch."""
    capacity = [indirect.nominal_torque_ratio(pairs, 1.0, _LOW, 1.0, 1.0) for pairs in (_PAIRS, _PAIRS - 1)]
    own, base, without = factor(1.0), base_factor(1.0), base_factor(0.0)
    more = min(capacity) > 1
    return judged(more and own < base, more and own < without, capacity=capacity, own=own, base=base, without=without)


def p42() -> Recomputed:
    """Judge the claim that the feather key takes a part of the energy that the springs spend on the sleeve."""
    gains = np.array([1.0, 4.0, 12.0, *_gains(60.0)[1:]])
    losses = 1 - indirect.net_gain(gains, _THRESHOLD) / indirect.net_gain_returning(gains, _THRESHOLD)
    return judged(np.all((losses > 0) & (losses < 1)), losses=losses[:3])
