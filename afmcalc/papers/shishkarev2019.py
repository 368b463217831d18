"""Шишкарёв 2019 (S19): figure 2, and the claims P1–P4, P17 and P24–P26."""

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from ..equations import accuracy, adjustment, direct, life
from ..equations.arrays import Values
from ..messages import say
from .claims import Found, PaperAxis, PaperFigure, curve, near, verdict

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


def figure_2() -> PaperFigure:
    """Life over the scatter band, formula (20)."""
    band = np.linspace(500, 1100, 121)
    # curve 2: the load swings from T_cp to T_max, so 2 T_min + ΔT becomes T_cp + T_min + ΔT
    forecast = cycles(band + LEAST - MEAN, MEAN)
    points = [np.array(values) for values in (FIRST, SECOND)]
    curves = [
        curve("a", "T_min…T_max, T_min = 200 N·m", band, cycles(band)),
        curve("2", "T_cp…T_max, T_cp = 600 N·m", band, forecast),
        curve("", "set at f_min, z = 12, 15, 19, 22", points[0], cycles(points[0]), points=True),
        curve("b", "set at mean f, z = 12, 15, 19, 22", points[1], cycles(points[1]), points=True),
    ]
    return PaperFigure(
        name="S19 fig. 2",
        title="life of the protected side against the scatter band",
        panels=[curves],
        x=PaperAxis("torque scatter band", "ΔT", "N*m"),
        y=[PaperAxis("cycles to failure", "N", log=True)],
        inputs="Formula (20), τ_limb = 400 MPa, W_p = 15 cm³, m_τ = 6, N_0 = 10⁷, printed ΔT of both settings.",
        corrections=[
            "M8: 1.27…1.44 is the ratio of mean torques, N of curve 2 is 4.1…9.1 times lower",
            "M22: stresses of 30…50 MPa against 400 MPa, life is not limited by fatigue",
            "M23: a wider band costs life here only by its mean; the amplitude is ignored",
            "M44: curve 1 of the text is a",
            "M45: N falls 21.43 times over ΔT = 500…1100 N·m, not from 0",
        ],
        assumed="T_min of b; a logarithmic scale (P2).",
    )


_MIN, _MEAN, _GAIN, _MARGIN = 0.15, 0.33, 1.6, 1.25
_MAX = 1 / _GAIN
"""S19 never prints f_max; its C = 1/f_max with C = 1.6 gives 0.625."""


def _arm(friction: float, pairs: int) -> float:
    """g(f) of the clutch with one bypass pair."""
    return float(direct.torque(1.0, 1.0, 1, pairs - 1, _GAIN, friction, friction))


def p1() -> Found:
    """Threshold of the number of pairs."""
    as_printed, mended = (float(_THRESHOLD(1, gain, _MIN, _MEAN, _MARGIN)) for gain in (_GAIN, 1.4))
    text = say("z > {as_printed:.3f} (C 1.6), {mended:.3f} (C 1.4)", as_printed=as_printed, mended=mended)
    return Found(text, verdict(near(as_printed, 9.23, 0.01), near(mended, 9.23, 0.01)), as_printed / 9.23 - 1)


def p2() -> Found:
    """Fall of life over the band."""
    computed = float(cycles(500) / cycles(1100))
    deviation = computed / 21.54 - 1
    return Found(say("{times:.2f} times", times=computed), verdict(abs(deviation) < 0.01), deviation)


def p3() -> Found:
    """Curve 2 against curve 1."""
    torques = [(MEAN + LEAST + band) / (2 * LEAST + band) for band in (500, 1100)]
    lives = [float(cycles(band) / cycles(band + LEAST - MEAN, MEAN)) for band in (500, 1100)]
    return Found(
        say("mean torques {torques:.3f}; N falls {lives:.2f} times", torques=torques, lives=lives),
        verdict(near(lives[0], 1.44, 0.01), near(torques[0], 1.44, 0.01) and near(torques[1], 1.3, 0.05)),
        lives[1] / 1.3 - 1,
    )


def p4() -> Found:
    """Bands of both methods over the number of pairs."""
    printed = SECOND[0] / FIRST[0]
    computed = [float(_BANDS(_MARGIN, _arm(_MIN, z), _arm(_MEAN, z))) for z in PAIRS]
    bands = [float(_BAND(1.0, 1.0, z, z - 1, _GAIN, _MIN, _MAX)) for z in PAIRS]
    grows = all(later > earlier for earlier, later in zip(bands, bands[1:], strict=False))
    text = say("ΔT_1/(F_п R) {bands:.3f}; ΔT_2/ΔT_1 {ratios:.3f}", bands=bands, ratios=computed)
    return Found(text, verdict(grows and near(computed[0], printed, 0.001)), computed[0] / printed - 1)


def p17() -> Found:
    """The bands of P4 and T_cp, and the K_т that follows from them."""
    computed = [_arm(_MAX, z) / _arm(_MIN, z) for z in PAIRS]
    ceiling = LEAST * _MEAN / _MIN
    text = say(
        "K_т {factors:.3f}, never above {most:.3f} (the bands: {implied:.1f}); T_cp at most {ceiling:.0f N·m}",
        implied=[(LEAST + band) / LEAST for band in FIRST], factors=computed, most=_MAX / _MIN, ceiling=ceiling,
    )  # fmt: skip
    return Found(text, verdict(ceiling >= MEAN), ceiling / MEAN - 1)


def _ends(pairs: int, margin: float, setting: float) -> tuple[float, float]:
    """T_min and T_max of a clutch set for a nominal torque of 1 at a friction, with a margin."""
    force = adjustment.closing_force(1.0, margin, _arm(setting, pairs))
    return force * _arm(_MIN, pairs), force * _arm(_MAX, pairs)


def _ratios(of: Callable[[float, float], float], pairs: Iterable[int] = PAIRS) -> list[float]:
    """Ratios of ``of(T_max, T_min)``, second method over first."""
    ends = [(_ends(z, _MARGIN, _MEAN), _ends(z, 1.0, _MIN)) for z in pairs]
    return [of(second[1], second[0]) / of(first[1], first[0]) for second, first in ends]


def p24() -> Found:
    """K_т does not depend on the method."""
    ratios = _ratios(accuracy.accuracy_factor)
    text = say("K_т2/K_т1 = {ratios:.3f}", ratios=ratios)
    return Found(text, verdict(all(near(ratio, 1, 1e-12) for ratio in ratios)), ratios[0] - 1)


def p25() -> Found:
    """The first method's band is the wider one on the unprotected side."""
    first, second = ([float(life.side_torque(1.5, band)) for band in bands] for bands in (FIRST, SECOND))
    text = say(
        "k_д = 1.5: k_д ΔT_1 = {first:.0f N·m}, k_д ΔT_2 = {second:.0f N·m} from the printed bands; by the formulas "
        "k_д ΔT_2/(k_д ΔT_1) = {ratios:.3f}",
        first=first,
        second=second,
        ratios=_ratios(accuracy.scatter),
    )
    return Found(text, verdict(all(wide > narrow for wide, narrow in zip(first, second, strict=True))))


def p26() -> Found:
    """The middle of the band is lower with the first method."""
    ratios, below = (_ratios(lambda high, low: (high + low) / 2, pairs) for pairs in (PAIRS, (8,)))
    text = say(
        "second over first {ratios:.3f} for z = {pairs}; {below:.3f} for z = 8", ratios=ratios, pairs=PAIRS, below=below
    )
    return Found(text, verdict(min(ratios) > 1))
