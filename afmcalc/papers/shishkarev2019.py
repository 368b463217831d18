"""Шишкарёв 2019 (S19): curves of figure 2, and the claims P1–P4, P17, P24–P26, P38–P40 and P49."""

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from ..equations import accuracy, adjustment, direct, life
from ..equations.arrays import Values
from .claims import Curves, Recomputed, judged, near

_THRESHOLD: Any = adjustment.DIRECT_ONE_MATERIAL["pairs_threshold"]
_BAND: Any = adjustment.DIRECT_ONE_MATERIAL["scatter_of_one_material"]
_BANDS: Any = adjustment.DIRECT["scatter_ratio"]

LEAST, MEAN = 200.0, 600.0
"""Smallest torque T_min, and torque at mean friction T_cp, N·m."""
PAIRS, FIRST, SECOND = (12, 15, 19, 22), (500.0, 700.0, 900.0, 1100.0), (627.0, 811.0, 1008.0, 1223.0)
"""Numbers of pairs z, and scatter bands ΔT with the first and with the second adjustment method, N·m."""
_MIN, _MEAN, _GAIN, _MARGIN = 0.15, 0.33, 1.6, 1.25
_MAX = 1 / _GAIN
"""S19 never prints f_max; its C = 1/f_max with C = 1.6 gives 0.625."""


def cycles(band: Values, least: float = LEAST) -> Any:
    """Life N over the scatter band, by (20) with the data of fig. 2."""
    return life.cycles_of_band(400e6, 15e-6, least, band, 6, 1e7)


def forecast(band: Values) -> Any:
    """Life N of curve 2: the load swings from T_cp to T_max, so that 2 T_min + ΔT becomes T_cp + T_min + ΔT."""
    return cycles(band + LEAST - MEAN, MEAN)


def figure_2() -> Curves:
    """Life over the scatter band, formula (20)."""
    band = np.linspace(500, 1100, 121)
    yield band, cycles(band)
    yield band, forecast(band)
    for points in map(np.array, (FIRST, SECOND)):
        yield points, cycles(points)


def _arm(friction: float, pairs: int) -> float:
    """Ratio g(f) of the torque to F_п R at a friction, for the clutch with one bypass pair."""
    return direct.torque(1.0, 1.0, 1, pairs - 1, _GAIN, friction, friction)


def p1() -> Recomputed:
    """Judge the printed number of pairs above which the first method's scatter band is narrower than the second's."""
    as_printed, mended = (_THRESHOLD(1, gain, _MIN, _MEAN, _MARGIN) for gain in (_GAIN, 1.4))
    values = {"as_printed": as_printed, "mended": mended}
    return judged(*(near(each, 9.23, 0.01) for each in values.values()), deviation=as_printed / 9.23 - 1, **values)


def p2() -> Recomputed:
    """Judge the printed ratio by which life falls over the scatter bands of fig. 2."""
    times = cycles(500) / cycles(1100)
    deviation = times / 21.54 - 1
    return judged(abs(deviation) < 0.01, deviation=deviation, times=times)


def p3() -> Recomputed:
    """Judge the printed ratio of the life of curve 1 to that of curve 2."""
    torques = [(MEAN + LEAST + band) / (2 * LEAST + band) for band in (500, 1100)]
    lives = [cycles(band) / forecast(band) for band in (500, 1100)]
    mended = near(torques[0], 1.44, 0.01) and near(torques[1], 1.3, 0.05)
    return judged(near(lives[0], 1.44, 0.01), mended, deviation=lives[1] / 1.3 - 1, torques=torques, lives=lives)


def p4() -> Recomputed:
    """Judge the printed scatter bands of both methods, and the claim that they grow with the number of pairs."""
    printed = SECOND[0] / FIRST[0]
    ratios = [_BANDS(_MARGIN, _arm(_MIN, z), _arm(_MEAN, z)) for z in PAIRS]
    bands = [_BAND(1.0, 1.0, z, z - 1, _GAIN, _MIN, np.linspace(_MIN, _MAX, 50)[1:]) for z in PAIRS]
    grows = np.all(np.diff(bands, axis=0) > 0, axis=0)
    as_printed = np.any(grows) and near(ratios[0], printed, 0.001)
    return judged(as_printed, deviation=ratios[0] / printed - 1, bands=[band[-1] for band in bands], ratios=ratios)


def p17() -> Recomputed:
    """Judge whether the printed mean torque T_cp fits T_min, and find the K_т that the scatter bands of P4 imply."""
    ceiling = LEAST * _MEAN / _MIN
    return judged(
        ceiling >= MEAN,
        deviation=ceiling / MEAN - 1,
        implied=[(LEAST + band) / LEAST for band in FIRST],
        factors=[_arm(_MAX, z) / _arm(_MIN, z) for z in PAIRS],
        most=_MAX / _MIN,
        ceiling=ceiling,
    )


def _ends(pairs: int, margin: float, setting: float) -> tuple[float, float]:
    """Largest and smallest torque of a clutch set at the friction ``setting`` for nominal torque 1 times margin."""
    force = adjustment.closing_force(1.0, margin, _arm(setting, pairs))
    return force * _arm(_MAX, pairs), force * _arm(_MIN, pairs)


def _ratios(of: Callable[[float, float], float], pairs: Iterable[int] = PAIRS) -> list[Any]:
    """Ratio of ``of(T_max, T_min)`` by the second method to its value by the first, for each number of pairs."""
    return [of(*_ends(z, _MARGIN, _MEAN)) / of(*_ends(z, 1.0, _MIN)) for z in pairs]


def p24() -> Recomputed:
    """Judge the claim that the accuracy factor K_т does not depend on the adjustment method."""
    ratios = _ratios(accuracy.accuracy_factor)
    return judged(all(near(ratio, 1, 1e-12) for ratio in ratios), deviation=ratios[0] - 1, ratios=ratios)


def p25() -> Recomputed:
    """Judge the claim that the first method's scatter band is wider than the second's on the unprotected side."""
    first, second = ([life.side_torque(1.5, band) for band in bands] for bands in (FIRST, SECOND))
    wider = all(wide > narrow for wide, narrow in zip(first, second, strict=True))
    return judged(wider, first=first, second=second, ratios=_ratios(accuracy.scatter))


def p26() -> Recomputed:
    """Judge the claim that the middle of the scatter band is lower with the first method."""
    return _where_narrower(accuracy.mid_torque)


def _where_narrower(of: Callable[[float, float], float]) -> Recomputed:
    """Judge the claim that a torque is lower with the first method, for more and for fewer pairs than by (12)."""
    ratios, below = (_ratios(of, pairs) for pairs in (PAIRS, (8,)))
    return judged(min(ratios + below) > 1, min(ratios) > 1, ratios=ratios, pairs=PAIRS, below=below)


def p38() -> Recomputed:
    """Judge the claim that the largest torque is lower with the first method."""
    return _where_narrower(max)


def p39() -> Recomputed:
    """Judge the claim that both sides have the same number of load cycles, since each trip loads both."""
    trips = 400 + 200 * np.sin(np.arange(1000.0))
    swings = np.diff([trips, life.side_torque(1.5, trips)])
    protected, unprotected = np.sum(np.diff(np.sign(swings)) < 0, axis=1)
    lives = cycles(500) / cycles(1.5 * 500, 1.5 * LEAST)
    return judged(protected == unprotected, protected=protected, unprotected=unprotected, lives=lives)


def p40() -> Recomputed:
    """Judge the claim that the least number of pairs is inversely proportional to the gain."""
    pairs = [_THRESHOLD(1, gain, _MIN, _MEAN, _MARGIN) for gain in (_GAIN, 2 * _GAIN)]
    own, controlled = pairs[0] / pairs[1], (pairs[0] - 1) / (pairs[1] - 1)
    values = {"pairs": pairs, "own": own, "controlled": controlled}
    return judged(near(own, 2, 1e-9), near(controlled, 2, 1e-9), deviation=own / 2 - 1, **values)


def p49() -> Recomputed:
    """Judge the claim that the life N falls as T_min grows, as T_max grows, and as both grow together."""
    highest = LEAST + 500
    raised = ((1.1 * LEAST, highest), (LEAST, 1.1 * highest), (1.1 * LEAST, 1.1 * highest))
    lives = [cycles(500) / cycles(high - low, low) for low, high in raised]
    return judged(min(lives) > 1, lives=lives)
