"""Figure of Шишкарёв 2019 (S19)."""

import numpy as np

from ...arrays import Values
from ...equations.life import cycles_of_band
from .interface import PaperFigure, axis, curve

LEAST, MEAN = 200.0, 600.0
"""T_min and T_cp, N·m."""
PAIRS, FIRST, SECOND = (12, 15, 19, 22), (500.0, 700.0, 900.0, 1100.0), (627.0, 811.0, 1008.0, 1223.0)

"""z, and ΔT of both settings, N·m."""


def cycles(band: Values, least: float = LEAST) -> Values:
    """N of (20) over the scatter band, with the data of fig. 2."""
    found: Values = cycles_of_band(400e6, 15e-6, least, band, 6, 1e7)
    return found


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
        x=axis("torque scatter band", "ΔT", "N*m"),
        y=[axis("cycles to failure", "N", log=True)],
        inputs="Formula (20), τ_limb = 400 MPa, W_p = 15 cm³, m_τ = 6, N_0 = 10⁷, printed ΔT of both settings.",
        corrections=[
            "M8: 1.27…1.44 is the ratio of mean torques, N of curve 2 is 4.1…9.1 times lower",
            "M22: stresses of 30…50 MPa against 400 MPa, life is not limited by fatigue",
            "M23: a wider band costs life here only by its mean; the amplitude is ignored",
            "M25: by equal K_т T_min of b would be 251…222 N·m; drawn is 200",
            "M44: curve 1 of the text is a",
            "M45: N falls 21.43 times over ΔT = 500…1100 N·m, not from 0",
        ],
        assumed="T_min of b; a logarithmic scale (P2).",
    )
