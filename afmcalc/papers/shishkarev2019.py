"""Шишкарёв 2019 (S19): curves of figure 2, and the claims P1–P4, P17 and P24–P26."""

from collections.abc import Callable, Iterable, Iterator
from typing import Any

import numpy as np

from ..equations import accuracy, adjustment, direct, life
from ..equations.arrays import Values
from .claims import Recomputed, near

_THRESHOLD: Any = adjustment.DIRECT_ONE_MATERIAL["pairs_threshold"]
_BAND: Any = adjustment.DIRECT_ONE_MATERIAL["scatter_of_one_material"]
_BANDS: Any = adjustment.DIRECT["scatter_ratio"]

LEAST, MEAN = 200.0, 600.0
"""T_min and T_cp, N·m."""
PAIRS, FIRST, SECOND = (12, 15, 19, 22), (500.0, 700.0, 900.0, 1100.0), (627.0, 811.0, 1008.0, 1223.0)
"""z, and ΔT of both settings, N·m."""


def cycles(band: Values, least: float = LEAST) -> Values:
    """N of (20) over the scatter band, with the data of fig. 2."""
    return life.cycles_of_band(400e6, 15e-6, least, band, 6, 1e7)


def forecast(band: Values) -> Values:
    """N of curve 2: the load swings from T_cp to T_max, so 2 T_min + ΔT becomes T_cp + T_min + ΔT."""
    return cycles(band + LEAST - MEAN, MEAN)


def figure_2() -> Iterator[tuple[Values, Values]]:
    """Life over the scatter band, formula (20)."""
    band = np.linspace(500, 1100, 121)
    yield band, cycles(band)
    yield band, forecast(band)
    for points in map(np.array, (FIRST, SECOND)):
        yield points, cycles(points)


_MIN, _MEAN, _GAIN, _MARGIN = 0.15, 0.33, 1.6, 1.25
_MAX = 1 / _GAIN
"""S19 never prints f_max; its C = 1/f_max with C = 1.6 gives 0.625."""


def _arm(friction: float, pairs: int) -> float:
    """g(f) of the clutch with one bypass pair."""
    return float(direct.torque(1.0, 1.0, 1, pairs - 1, _GAIN, friction, friction))


def p1() -> Recomputed:
    """Threshold of the number of pairs."""
    as_printed, mended = (float(_THRESHOLD(1, gain, _MIN, _MEAN, _MARGIN)) for gain in (_GAIN, 1.4))
    values = {"as_printed": as_printed, "mended": mended}
    return Recomputed(values, near(as_printed, 9.23, 0.01), near(mended, 9.23, 0.01), as_printed / 9.23 - 1)


def p2() -> Recomputed:
    """Fall of life over the band."""
    times = float(cycles(500) / cycles(1100))
    deviation = times / 21.54 - 1
    return Recomputed({"times": times}, abs(deviation) < 0.01, deviation=deviation)


def p3() -> Recomputed:
    """Curve 2 against curve 1."""
    torques = [(MEAN + LEAST + band) / (2 * LEAST + band) for band in (500, 1100)]
    lives = [float(cycles(band) / forecast(band)) for band in (500, 1100)]
    mended = near(torques[0], 1.44, 0.01) and near(torques[1], 1.3, 0.05)
    return Recomputed({"torques": torques, "lives": lives}, near(lives[0], 1.44, 0.01), mended, lives[1] / 1.3 - 1)


def p4() -> Recomputed:
    """Bands of both methods over the number of pairs."""
    printed = SECOND[0] / FIRST[0]
    ratios = [float(_BANDS(_MARGIN, _arm(_MIN, z), _arm(_MEAN, z))) for z in PAIRS]
    bands = [float(_BAND(1.0, 1.0, z, z - 1, _GAIN, _MIN, _MAX)) for z in PAIRS]
    grows = bool(np.all(np.diff(bands) > 0))
    as_printed = grows and near(ratios[0], printed, 0.001)
    return Recomputed({"bands": bands, "ratios": ratios}, as_printed, deviation=ratios[0] / printed - 1)


def p17() -> Recomputed:
    """The bands of P4 and T_cp, and the K_т that follows from them."""
    ceiling = LEAST * _MEAN / _MIN
    values = {
        "implied": [(LEAST + band) / LEAST for band in FIRST],
        "factors": [_arm(_MAX, z) / _arm(_MIN, z) for z in PAIRS],
        "most": _MAX / _MIN,
        "ceiling": ceiling,
    }
    return Recomputed(values, ceiling >= MEAN, deviation=ceiling / MEAN - 1)


def _ends(pairs: int, margin: float, setting: float) -> tuple[float, float]:
    """T_max and T_min of a clutch set for a nominal torque of 1 at a friction, with a margin."""
    force = adjustment.closing_force(1.0, margin, _arm(setting, pairs))
    return force * _arm(_MAX, pairs), force * _arm(_MIN, pairs)


def _ratios(of: Callable[[float, float], float], pairs: Iterable[int] = PAIRS) -> list[float]:
    """Ratios of ``of(T_max, T_min)``, second method over first."""
    return [of(*_ends(z, _MARGIN, _MEAN)) / of(*_ends(z, 1.0, _MIN)) for z in pairs]


def p24() -> Recomputed:
    """K_т does not depend on the method."""
    ratios = _ratios(accuracy.accuracy_factor)
    return Recomputed({"ratios": ratios}, all(near(ratio, 1, 1e-12) for ratio in ratios), deviation=ratios[0] - 1)


def p25() -> Recomputed:
    """The first method's band is the wider one on the unprotected side."""
    first, second = ([float(life.side_torque(1.5, band)) for band in bands] for bands in (FIRST, SECOND))
    wider = all(wide > narrow for wide, narrow in zip(first, second, strict=True))
    return Recomputed({"first": first, "second": second, "ratios": _ratios(accuracy.scatter)}, wider)


def p26() -> Recomputed:
    """The middle of the band is lower with the first method."""
    ratios, below = (_ratios(accuracy.mid_torque, pairs) for pairs in (PAIRS, (8,)))
    return Recomputed({"ratios": ratios, "pairs": PAIRS, "below": below}, min(ratios) > 1)
