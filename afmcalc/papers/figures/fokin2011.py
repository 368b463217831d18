"""Figure of Фокин and others 2011 (F11)."""

import numpy as np

from ...arrays import Values
from ...equations.accuracy import accuracy_factor, accuracy_factor_by_ratios
from .interface import PaperFigure, axis, curve

RANGES = ((0.10, 0.6), (0.14, 0.7), (0.16, 0.7), (0.16, 0.8))
"""f_1min and f_1max of curves 1–4."""
CONTROLLED, GAIN = 6, 1.25


def factor(n: Values, p: Values, low: Values, high: Values, bypass: int = 1) -> Values:
    """K_т of curves 1–4."""
    found: Values = accuracy_factor_by_ratios(bypass, CONTROLLED, GAIN, n, p, low, high)
    return found


def line(low: float, high: float) -> float:
    """K_т of lines 5–7: one material; F11 counts only the driven pairs in z."""
    return float(accuracy_factor(0, CONTROLLED, GAIN, low, low, high, high))


def figure_2() -> PaperFigure:
    """K_т over n = f_2max/f_1max, formula (17); lines 5–7 one material."""
    n = np.linspace(0.5, 1.5, 101)
    curves = []
    for number, (low, high) in enumerate(RANGES, start=1):
        curves.append(curve(str(number), f"f_1 = {low:.2f}…{high:.1f}", n, factor(n, 1.0, low, high)))
    for number, (low, high) in enumerate(RANGES[:3], start=5):
        curves.append(curve(str(number), f"one material, f = {low:.2f}…{high:.1f}", n, line(low, high)))
    return PaperFigure(
        name="F11 fig. 2",
        title="accuracy factor against the ratio of the largest frictions",
        panels=[curves],
        x=axis("ratio f_2max/f_1max", "n"),
        y=[axis("accuracy factor", "K_т")],
        inputs="Formula (17), z_2 = 6, C = 1.25; lines 5–7: z = 6, all pairs controlled.",
        corrections=[
            "M4: z_1 = 1, printed 2, with which all four curves fall (z_1 = 2 with C = 0.625 mends it too)",
            "M5: K_т grows with n while C < 1/(z_1 f_1max), so n > 1 lowers the accuracy",
        ],
        assumed="p = f_2min/f_1min = 1 and n = 0.5…1.5.",
    )
