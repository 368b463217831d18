"""Life against the scatter band, and where both settings put the clutch."""

from collections.abc import Sequence

from ....analysis.curves import LifeCurve
from ....analysis.life import LifeSweep
from ..chart import Chart, ChartAxis, Guide, Line, Sheet, axis_of, describe, power

_SIDES = ("protected", "unprotected", "protected_forecast")
_METHODS = {"min-friction": "set at f_min", "mean-friction": "set at mean f with margin"}


def sheet(curves: Sequence[LifeCurve]) -> Sheet:
    """Draw both sides of one clutch, or the protected side of several."""
    x = ChartAxis("torque scatter band", "ΔT", "N*m")
    y = axis_of(LifeSweep, "protected", log=True, quantity="cycles to failure")
    first, single = curves[0], len(curves) == 1
    if single:
        lines = [Line(describe(LifeSweep, side), first.series.values, getattr(first.series, side)) for side in _SIDES]
        lines += _settings(first)
        title = "Life against the scatter band"
        guides = [Guide(f"base cycles N_0 = {power(first.base_cycles)}", first.base_cycles)]
    else:
        lines = [Line(each.name or each.variant, each.series.values, each.series.protected) for each in curves]
        title, guides = "Life of the protected side against the scatter band", []
    beyond = (
        "Above N_0 the stress is below the endurance limit: life is not limited by fatigue, the line is extrapolated "
        "as the paper does."
        if first.model == "mean-stress"
        else "Where there is no line, fatigue sets no limit."
    )
    caption = f"Model: {first.model}. T_min as the clutch has it, T_max = T_min + ΔT. {beyond}"
    name = first.name or "" if single else ""
    return Sheet(title, [Chart(x, y, lines, guides=guides, named=not single)], caption, name=name)


def _settings(curve: LifeCurve) -> list[Line]:
    """The protected side with the spring set by either method."""
    return [
        Line(f"protected side, {_METHODS[each.method]}", [each.scatter], [each.cycles], points=True)
        for each in curve.settings
        if each.cycles
    ]
