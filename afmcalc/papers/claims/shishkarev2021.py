"""S21: P5–P8, figs 2 and 4. All of them are set at f_min, so the clutch below its setting does not enter."""

from collections.abc import Callable

import numpy as np

from ...messages import say
from ..figures.shishkarev2021 import ball_and_travel, base_factor, factor
from .found import Found, near, verdict

_RANGES = ((3.0, 12.0), (1.5, 19.0))
"""The range of C in fig. 2 is not printed; over each of these, and others, both printed averages come out."""


def _stiffer(gain: float) -> float:
    return float(factor(gain) / factor(gain, 40e3))


def _doubled(gain: float) -> float:
    return float(factor(gain) / factor(2 * gain))


def _average(function: Callable[[float], float], low: float, high: float) -> float:
    """Average over the gain by the midpoint rule."""
    count = 2000
    return sum(function(low + (high - low) * (i + 0.5) / count) for i in range(count)) / count


def p5() -> Found:
    """K_т falls when c_1 is doubled."""
    at = [_stiffer(gain) for gain in (1.0, 4.0)]
    averages = [_average(_stiffer, *gains) for gains in _RANGES]
    return _open(
        1.03,
        at,
        averages,
        say("{first:.3f} at C 1, {last:.3f} at C 4; {average}", first=at[0], last=at[1], average=_over(averages)),
    )


def p6() -> Found:
    """K_т falls when C is doubled."""
    at = [_doubled(gain) for gain in (1.0, 2.0)]
    averages = [_average(_doubled, low, high / 2) for low, high in _RANGES]
    computed = say(
        "{first:.3f} (C 1 → 2), {last:.3f} (2 → 4); {average} (C and 2C)",
        first=at[0],
        last=at[1],
        average=_over(averages),
    )
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
    return Found(
        say("C 1, 2, 4: base {base:.3f}; indirect {own:.3f}", base=base, own=own),
        verdict(all(first < second for first, second in zip(base, own, strict=True))),
    )


def p8() -> Found:
    """Ball radius falls, travel grows with the gain."""
    gains = np.linspace(0.6, 30.6, 30001)
    radii, travels = map(np.asarray, ball_and_travel(gains))
    top = int(np.argmax(radii))
    bottom = top + int(np.argmin(radii[top:]))
    grows, falls = bool(np.all(np.diff(travels) > 0)), bool(np.all(np.diff(radii[top : bottom + 1]) < 0))
    return Found(
        say(
            "x_max grows; r_ш rises to C = {top:.2f}, falls to C = {bottom:.1f}, then grows again",
            top=gains[top],
            bottom=gains[bottom],
        ),
        verdict(grows and top == 0 and bottom == len(radii) - 1, grows and falls),
    )


CHECKS = {"P5": p5, "P6": p6, "P7": p7, "P8": p8}
