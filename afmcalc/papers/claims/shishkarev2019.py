"""S19: P1–P4 and P17; S19's share of P22."""

from ...equations import adjustment, direct, life
from . import Row, figures, near, verdict

_MIN, _MEAN, _GAIN, _MARGIN = 0.15, 0.33, 1.6, 1.25
_MAX = 1 / _GAIN
"""S19 never prints f_max; its C = 1/f_max with C = 1.6 gives 0.625."""
_PAIRS = (12, 15, 19, 22)
_BANDS_1, _BANDS_2 = (500, 700, 900, 1100), (627, 811, 1008, 1223)


def _arm(friction: float, pairs: int) -> float:
    """g(f) of the clutch with one bypass pair."""
    return float(direct.torque(1.0, 1.0, 1, pairs - 1, _GAIN, friction, friction))


def p1() -> Row:
    """Threshold of the number of pairs."""
    printed = 9.23
    as_printed, mended = (float(adjustment.pairs_threshold(1, gain, _MIN, _MEAN, _MARGIN)) for gain in (_GAIN, 1.4))
    return Row(
        id="P1",
        source="S19 (12)",
        inputs="β_н 1.25, C 1.6, f_min 0.15, f_cp 0.33",
        printed=f"z > {printed}",
        computed=f"z > {as_printed:.3f} (C 1.6), {mended:.3f} (C 1.4)",
        deviation=as_printed / printed - 1,
        verdict=verdict(near(as_printed, printed, 0.01), near(mended, printed, 0.01)),
        correction="M7",
        why="the printed number belongs to C = 1.4",
    )


def _cycles(band: float) -> float:
    return float(life.cycles_of_band(400e6, 15e-6, 200, band, 6, 1e7))


def p2() -> Row:
    """Fall of life over the band."""
    printed, computed = 21.54, _cycles(500) / _cycles(1100)
    return Row(
        id="P2",
        source="S19 fig. 2",
        inputs="τ_limb 400 MPa, W_p 15 cm³, T_min 200 N·m, m_τ 6, N_0 1e7; ΔT 500 → 1100 N·m",
        printed=f"N falls {printed} times",
        computed=f"{computed:.2f} times",
        deviation=computed / printed - 1,
        verdict=verdict(abs(computed / printed - 1) < 0.01),
        correction=None,
        why="within reading accuracy: 21.54 is 10^(4/3), four thirds of a decade on a logarithmic axis",
    )


def p3() -> Row:
    """Curve 2 against curve 1."""
    torques = [(600 + 200 + band) / (400 + band) for band in (500, 1100)]
    lives = [ratio**6 for ratio in torques]
    return Row(
        id="P3",
        source="S19 fig. 2, curve 2",
        inputs="as P2, load from T_cp = 600 N·m",
        printed="N falls 1.3…1.44 times",
        computed=f"mean torques {figures(torques)}; N falls {figures(lives, 2)} times",
        deviation=lives[1] / 1.3 - 1,
        verdict=verdict(near(lives[0], 1.44, 0.01), near(torques[0], 1.44, 0.01) and near(torques[1], 1.3, 0.05)),
        correction="M8",
        why="the printed ratio is that of the mean torques; N falls by its 6th power",
    )


def p4() -> Row:
    """Bands of both methods over the number of pairs."""
    printed = [second / first for first, second in zip(_BANDS_1, _BANDS_2, strict=True)]
    computed = [float(adjustment.scatter_ratio(_MARGIN, _arm(_MIN, z), _arm(_MEAN, z))) for z in _PAIRS]
    bands = [float(adjustment.scatter(1.0, 1.0, z, z - 1, _GAIN, _MIN, _MAX)) for z in _PAIRS]
    grows = all(later > earlier for earlier, later in zip(bands, bands[1:], strict=False))
    return Row(
        id="P4",
        source="S19 text",
        inputs="z 12, 15, 19, 22; f_min 0.15, f_cp 0.33, f_max 0.625 (not printed), C 1.6, β_н 1.25",
        printed=f"ΔT grows with z; ΔT_2/ΔT_1 {figures(printed)}",
        computed=f"ΔT_1/(F_п R) {figures(bands)}; ΔT_2/ΔT_1 {figures(computed)}",
        deviation=computed[0] / printed[0] - 1,
        verdict=verdict(grows and near(computed[0], printed[0], 0.001)),
        correction=None,
        why="at equal spring force the band falls with z and the ratio rises",
    )


def p17() -> Row:
    """K_т and T_cp implied by P4."""
    printed = [(200 + band) / 200 for band in (_BANDS_1[0], _BANDS_1[-1])]
    computed = [_arm(_MAX, z) / _arm(_MIN, z) for z in _PAIRS]
    ceiling = 200 * _MEAN / _MIN
    return Row(
        id="P17",
        source="S19 text",
        inputs="ΔT of P4, T_min 200 N·m, T_cp 600 N·m",
        printed=f"K_т = {printed[0]}…{printed[1]}, T_cp = 600 N·m",
        computed=f"K_т {figures(computed)}, never above {_MAX / _MIN:.3f}; T_cp at most {ceiling:.0f} N·m",
        deviation=computed[0] / printed[0] - 1,
        verdict=verdict(near(computed[0], printed[0], 0.05) and ceiling >= 600),
        correction=None,
        why="no clutch of the law has such bands; the ratio 1.254 of the bands exceeds β_н, its upper bound",
    )


CHECKS = (p1, p2, p3, p4, p17)
