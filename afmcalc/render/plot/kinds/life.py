"""Life against the scatter band, and where both settings put the clutch."""

from collections.abc import Sequence

from ....analysis.curves import LifeCurve
from ....analysis.life import LifeSweep
from ....messages import named, term, told, translate
from ..chart import Chart, ChartAxis, Guide, Line, Sheet, axis_of, describe, power

_SIDES = ("protected", "unprotected", "protected_forecast")
_METHODS = {
    "min-friction": term("protected side, set at f_min"),
    "mean-friction": term("protected side, set at mean f with margin"),
}


def sheet(curves: Sequence[LifeCurve]) -> Sheet:
    """Draw both sides of one clutch, or the protected side of several."""
    x = ChartAxis(translate("torque scatter band"), "ΔT", "N*m")
    y = axis_of(LifeSweep, "protected", log=True, quantity=translate("cycles to failure"))
    first, single = curves[0], len(curves) == 1
    if single:
        lines = [Line(describe(LifeSweep, side), first.series.values, getattr(first.series, side)) for side in _SIDES]
        lines += _settings(first)
        title = translate("Life against the scatter band")
        guides = [Guide(told("base cycles N_0 = {cycles}", cycles=power(first.base_cycles)), first.base_cycles)]
    else:
        lines = [
            Line(named(each.name) or translate(each.variant, "value"), each.series.values, each.series.protected)
            for each in curves
        ]
        title, guides = translate("Life of the protected side against the scatter band"), []
    beyond = translate(
        "Above N_0 the stress is below the endurance limit: life is not limited by fatigue, the line is extrapolated "
        "as the paper does."
        if first.model == "mean-stress"
        else "Where there is no line, fatigue sets no limit."
    )
    about = told("Model: {model}. T_min as the clutch has it, T_max = T_min + ΔT.", model=term(first.model))
    caption = f"{about} {beyond}"
    name = first.name or "" if single else ""
    return Sheet(title, [Chart(x, y, lines, guides=guides, named=not single)], caption, name=name)


def _settings(curve: LifeCurve) -> list[Line]:
    """The protected side with the spring set by either method."""
    return [
        Line(translate(_METHODS[each.method]), [each.scatter], [each.cycles], points=True)
        for each in curve.settings
        if each.cycles
    ]
